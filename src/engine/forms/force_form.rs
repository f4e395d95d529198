//! The force form of a grasp: a linear complementarity problem (LCP) whose unknowns are contact forces, magnitudes of slips and the twist q of the
//! object. The compliances of the springs are on the diagonal of its matrix.
//!
//! The unknowns of an LCP are not negative, so the twist is split into a positive and a negative part. A spring that both pushes and pulls needs no
//! complementary pair: its force is linear in q. Such springs are those of bonded contacts, of contacts kept closed, and along tangents with infinite
//! friction. A bonded contact neither opens nor slides; a contact kept closed may slide. A drive, the spring of a joint or tendon of a hand, is
//! treated like a contact. The offset a of a spring is commanded displacement minus clearance.

use nalgebra::{DMatrix, DVector, SVector};

use super::rows::{Form, Row};
use crate::contact::{LocalLaw, Mode, State};
use crate::lcp::{Basis, Lcp};
use crate::numerics::{IntoList, Map, Reals, Square, Vector};
use crate::object::Problem;
use crate::prelude::*;

/// The force form of a problem. `None` if a number overflows. `None` also if, in a rate problem (for derivatives along a load path), a contact is on
/// the boundary of its cone (`edge` in code names). With such a contact the matrix is not copositive.
pub(crate) fn force_form(problem: &Problem) -> Option<Form> {
    if problem.locals().any(|local| local.is_on_an_edge()) {
        return None;
    }
    let mut b = Builder::new(problem);
    for contact in 0..problem.len() {
        b.add_rows(contact);
    }
    let forces = b.rows.len();
    let size = problem.size().count();
    let n = forces + 2 * size;
    let unit = twist_units(problem);
    let mut m = DMatrix::zeros(n, n);
    let mut q = DVector::zeros(n);
    for contact in 0..problem.len() {
        b.fill(contact, &mut m, &mut q, &unit);
    }
    for axis in 0..size {
        for (half, sign) in [(0, 1.0), (1, -1.0)] {
            let row = forces + 2 * axis + half;
            q[row] = -sign * b.load[axis] * unit[axis];
            for other in 0..size {
                let h = sign * b.stiffness[(axis, other)] * unit[axis] * unit[other];
                m[(row, forces + 2 * other)] = h;
                m[(row, forces + 2 * other + 1)] = -h;
            }
            b.rows.push(Row::Balance { axis, positive: half == 0 });
            b.z_unit.push(unit[axis]);
            b.w_unit.push(1.0 / unit[axis]);
        }
    }
    Some(Form { lcp: Lcp::new(m, q).ok()?, rows: b.rows, z_unit: b.z_unit, w_unit: b.w_unit })
}

/// The state of each contact and drive that a complementary basis of the force form describes.
pub(crate) fn force_states(problem: &Problem, form: &Form, basis: &Basis) -> Vec<State> {
    let n = problem.len();
    let (mut pressed, mut slips) = (vec![true; n], vec![false; n]);
    let mut corners: Vec<Vec<u16>> = vec![Vec::new(); n];
    for (i, row) in form.rows.iter().enumerate() {
        match *row {
            Row::NormalForce { contact } => pressed[contact] = basis.contains(i),
            Row::SlipSize { contact } => slips[contact] = basis.contains(i),
            Row::TangentialForce { contact, corner } if basis.contains(i) => {
                corners[contact].extend(u16::try_from(corner));
            }
            _ => {}
        }
    }
    let state = |(contact, local): (usize, LocalLaw<'_>)| {
        let facets = local.facets().len();
        match *corners[contact] {
            _ if !pressed[contact] => Mode::Open,
            _ if !slips[contact] => local.trial_state(),
            // In the plane each of the two facets has one corner, with the same index. In space two facets meet at a corner. A contact whose force is
            // at one corner slides there. A contact whose force is between two neighbouring corners slides on the facet between them.
            [corner] if local.is_planar() => Mode::Facet(corner),
            _ if local.is_planar() => Mode::Open,
            [corner] => Mode::Corner(corner),
            [a, b] if b == a + 1 => Mode::Facet(b),
            [a, b] if a == 0 && usize::from(b) + 1 == facets => Mode::Facet(a),
            _ => Mode::Open,
        }
    };
    problem.locals().enumerate().map(state).list()
}

/// For each component of the twist, the unit by which it is scaled: a motion by one unit stores a spring energy of about 1 J. The unit is 1 if no
/// spring resists the component.
fn twist_units(problem: &Problem) -> Vector {
    let mut sums = Vector::all_zero(problem.size());
    for site in problem.sites {
        let springs = site.springs.force(&SVector::repeat(1.0));
        let squares = Map::from_fn(site.coordinates(), |k, a| site.map[(k, a)] * site.map[(k, a)]);
        sums += &squares * springs;
    }
    sums.map(|sum| if sum > 0.0 { 1.0 / sum.sqrt() } else { 1.0 })
}

struct Builder<'p, 'g> {
    problem: &'p Problem<'g>,
    rows: Vec<Row>,
    z_unit: Vec<f64>,
    w_unit: Vec<f64>,
    /// For each contact, the index of its first complementary pair, from 0: its first row and first column in the matrix of the problem.
    first: Vec<usize>,
    /// Stiffness `Σ G k Gᵀ` of the springs that both push and pull, with their stiffnesses k and the grasp maps G of their contacts.
    stiffness: Square,
    /// `W + Σ G k a`: the load W plus the forces of the springs that both push and pull, with stiffnesses k and offsets a, at zero twist.
    load: Vector,
}

impl<'p, 'g> Builder<'p, 'g> {
    fn new(problem: &'p Problem<'g>) -> Self {
        Self {
            problem,
            rows: Vec::new(),
            z_unit: Vec::new(),
            w_unit: Vec::new(),
            first: Vec::new(),
            stiffness: Square::zeros(problem.size()),
            load: problem.wrench.clone(),
        }
    }

    fn add_rows(&mut self, contact: usize) {
        self.first.push(self.rows.len());
        let mut push = |row, z, w| {
            self.rows.push(row);
            self.z_unit.push(z);
            self.w_unit.push(w);
        };
        let local = self.problem.local(contact);
        if local.may_open() {
            let root = local.springs.root_along(0);
            push(Row::NormalForce { contact }, root, 1.0 / root);
        }
        let facets = local.facets().len();
        if facets > 0 {
            let root = local.springs.root_along(1);
            for corner in 0..facets {
                push(Row::TangentialForce { contact, corner }, root, 1.0 / root);
            }
            push(Row::SlipSize { contact }, 1.0 / root, root);
        }
    }

    fn fill(&mut self, contact: usize, m: &mut DMatrix<f64>, q: &mut DVector<f64>, unit: &Vector) {
        let problem = self.problem;
        let local = problem.local(contact);
        if local.is_absent() {
            return;
        }
        let (site, a) = (&problem.sites[contact], &problem.offsets[contact]);
        let twist_columns = self.rows.len();
        let mut next = self.first[contact];
        let presses = local.may_open().then(|| {
            let row = next;
            next += 1;
            row
        });
        let facets = local.facets().len();
        // Adds the coefficients of the term `v·q` to a row of the matrix, for the twist q. The unknowns are the positive and the negative part
        // of each scaled component of q. If `skew` is true, the negative transpose is also added to the rows of the equilibrium equations.
        let couple = |m: &mut DMatrix<f64>, row: usize, v: Vector, skew: bool| {
            for (axis, entry) in v.component_mul(unit).iter().enumerate() {
                let column = twist_columns + 2 * axis;
                m[(row, column)] += entry;
                m[(row, column + 1)] -= entry;
                if skew {
                    m[(column, row)] -= entry;
                    m[(column + 1, row)] += entry;
                }
            }
        };
        let root_n = local.springs.root_along(0);
        if let Some(row) = presses {
            m[(row, row)] = 1.0;
            q[row] = -root_n * a[0];
            couple(m, row, site.map.column(0) * root_n, true);
        } else {
            self.both_ways(contact, 0);
        }
        if facets == 0 {
            for axis in 1..local.springs.axes() {
                self.both_ways(contact, axis);
            }
            return;
        }
        let root_t = local.springs.root_along(1);
        let size_row = next + facets;
        let corners = &local.polygon.corners;
        for (j, d) in corners.iter().enumerate() {
            let row = next + j;
            q[row] = -root_t * d.dot(a);
            m[(row, size_row)] = 1.0;
            m[(size_row, row)] = -1.0;
            for (l, other) in corners.iter().enumerate() {
                let bent = (1..local.springs.axes())
                    .map(|axis| d[axis] * other[axis] * local.springs.ratio(1, axis));
                m[(row, next + l)] = bent.added();
            }
            couple(m, row, &site.map * d * root_t, true);
        }
        let cone = local.cone();
        if let Some(row) = presses {
            m[(size_row, row)] = cone.limit(root_n) / root_t;
        } else {
            let limit = cone.limit(local.springs.force_along(0, 1.0)) / root_t;
            q[size_row] = limit * a[0];
            couple(m, size_row, site.map.column(0) * -limit, false);
        }
    }

    /// Adds to `stiffness` and `load` a spring of contact i along this axis that both pushes and pulls. Its force is F = k (a - G_iᵀq) with
    /// stiffness k, offset a, grasp map G_i and twist q.
    fn both_ways(&mut self, contact: usize, axis: usize) {
        let site = &self.problem.sites[contact];
        let g = site.map.column(axis);
        self.load += &g * site.springs.force_along(axis, self.problem.offsets[contact][axis]);
        let pushed = &g * site.springs.force_along(axis, 1.0);
        self.stiffness.add_product(&pushed, &g);
    }
}
