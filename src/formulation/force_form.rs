//! The force form (see [`super`]): forces as unknowns, compliances on the diagonal, the twist free.
//!
//! The twist is split into a positive and a negative part. A spring that acts both ways (bonded, kept closed, infinite
//! friction) needs no row: its force is linear in q.

use nalgebra::{DMatrix, DVector, SVector};

use super::problem::{Law, Problem, State};
use super::rows::{Form, Row};
use crate::lcp::{Basis, Lcp};

/// The force form, or `None` for rates with contacts on an edge (they have no copositive force form) and when a
/// number overflows.
pub(crate) fn force_form<const D: usize, const C: usize>(problem: &Problem<D, C>) -> Option<Form> {
    if problem.laws.iter().any(|law| matches!(law, Law::Edge(_))) {
        return None;
    }
    let mut b = Builder::new(problem);
    for contact in 0..problem.len() {
        b.add_rows(contact);
    }
    let forces = b.rows.len();
    let n = forces + 2 * D;
    let unit = twist_units(problem);
    let mut m = DMatrix::zeros(n, n);
    let mut q = DVector::zeros(n);
    for contact in 0..problem.len() {
        b.fill(contact, &mut m, &mut q, &unit);
    }
    for axis in 0..D {
        for (half, sign) in [(0, 1.0), (1, -1.0)] {
            let row = forces + 2 * axis + half;
            q[row] = -sign * b.load[axis] * unit[axis];
            for other in 0..D {
                let h = sign * b.stiffness[axis][other] * unit[axis] * unit[other];
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

/// The contact states of a complementary basis.
pub(crate) fn force_states<const D: usize, const C: usize>(
    problem: &Problem<D, C>,
    form: &Form,
    basis: &Basis,
) -> Vec<State> {
    let n = problem.len();
    let (mut pressed, mut slips) = (vec![true; n], vec![false; n]);
    let mut corners: Vec<Vec<usize>> = vec![Vec::new(); n];
    for (i, row) in form.rows.iter().enumerate() {
        match *row {
            Row::NormalForce { contact } => pressed[contact] = basis.contains(i),
            Row::SlipSize { contact } => slips[contact] = basis.contains(i),
            Row::TangentialForce { contact, corner } if basis.contains(i) => corners[contact].push(corner),
            _ => {}
        }
    }
    (0..n)
        .map(|contact| {
            let facets = problem.normals(contact).len();
            match *corners[contact] {
                _ if !pressed[contact] => State::Open,
                _ if !slips[contact] => problem.unjumped(contact),
                // A corner is where two facets meet; on a facet the force stands between two corners.
                [corner] if C == 3 => State::Sliding { first: corner, second: Some((corner + 1) % facets) },
                [corner] => State::Sliding { first: corner, second: None },
                [a, b] if C == 3 && b == a + 1 => State::Sliding { first: b, second: None },
                [a, b] if C == 3 && a == 0 && b + 1 == facets => State::Sliding { first: a, second: None },
                _ => State::Open,
            }
        })
        .collect()
}

/// Twist components in the unit that makes the stretched springs of a unit twist of order one.
fn twist_units<const D: usize, const C: usize>(problem: &Problem<D, C>) -> [f64; D] {
    let mut sums = [0.0; D];
    for site in problem.sites {
        for axis in 0..site.axes {
            for d in 0..D {
                sums[d] += site.k[axis] * site.map[(d, axis)].powi(2);
            }
        }
    }
    sums.map(|sum| if sum > 0.0 { 1.0 / sum.sqrt() } else { 1.0 })
}

struct Builder<'p, 'g, const D: usize, const C: usize> {
    problem: &'p Problem<'g, D, C>,
    rows: Vec<Row>,
    z_unit: Vec<f64>,
    w_unit: Vec<f64>,
    /// First row of each contact.
    first: Vec<usize>,
    /// Σ G k Gᵀ of the springs that act both ways, and the load with their drives.
    stiffness: [[f64; D]; D],
    load: SVector<f64, D>,
}

impl<'p, 'g, const D: usize, const C: usize> Builder<'p, 'g, D, C> {
    fn new(problem: &'p Problem<'g, D, C>) -> Self {
        Self {
            problem,
            rows: Vec::new(),
            z_unit: Vec::new(),
            w_unit: Vec::new(),
            first: Vec::new(),
            stiffness: [[0.0; D]; D],
            load: problem.wrench,
        }
    }

    fn add_rows(&mut self, contact: usize) {
        self.first.push(self.rows.len());
        let mut push = |row, z, w| {
            self.rows.push(row);
            self.z_unit.push(z);
            self.w_unit.push(w);
        };
        let site = &self.problem.sites[contact];
        if self.problem.may_open(contact) {
            push(Row::NormalForce { contact }, site.k[0].sqrt(), 1.0 / site.k[0].sqrt());
        }
        let facets = self.problem.normals(contact).len();
        if facets > 0 {
            let root = site.k[1].sqrt();
            for corner in 0..facets {
                push(Row::TangentialForce { contact, corner }, root, 1.0 / root);
            }
            push(Row::SlipSize { contact }, 1.0 / root, root);
        }
    }

    fn fill(&mut self, contact: usize, m: &mut DMatrix<f64>, q: &mut DVector<f64>, unit: &[f64; D]) {
        let problem = self.problem;
        if problem.laws[contact] == Law::Absent {
            return;
        }
        let (site, a) = (&problem.sites[contact], &problem.drives[contact]);
        let twist_columns = self.rows.len();
        let mut next = self.first[contact];
        let presses = problem.may_open(contact).then(|| {
            let row = next;
            next += 1;
            row
        });
        let facets = problem.normals(contact).len();
        // A wrench v multiplying the (split, scaled) twist in one row, and its negative in the balance rows.
        let couple = |m: &mut DMatrix<f64>, row: usize, v: SVector<f64, D>, skew: bool| {
            for axis in 0..D {
                let entry = v[axis] * unit[axis];
                let column = twist_columns + 2 * axis;
                m[(row, column)] += entry;
                m[(row, column + 1)] -= entry;
                if skew {
                    m[(column, row)] -= entry;
                    m[(column + 1, row)] += entry;
                }
            }
        };
        let root_n = site.k[0].sqrt();
        if let Some(row) = presses {
            m[(row, row)] = 1.0;
            q[row] = -root_n * a[0];
            couple(m, row, site.map.column(0) * root_n, true);
        } else {
            self.both_ways(contact, 0);
        }
        if facets == 0 {
            for axis in 1..site.axes {
                self.both_ways(contact, axis);
            }
            return;
        }
        let root_t = site.k[1].sqrt();
        let size_row = next + facets;
        let corners = &problem.polygon(contact).corners;
        for (j, d) in corners.iter().enumerate() {
            let row = next + j;
            q[row] = -root_t * d.dot(a);
            m[(row, size_row)] = 1.0;
            m[(size_row, row)] = -1.0;
            for (l, other) in corners.iter().enumerate() {
                let bent: f64 = (1..C).map(|axis| d[axis] * other[axis] / site.k[axis]).sum();
                m[(row, next + l)] = site.k[1] * bent;
            }
            couple(m, row, site.map * d * root_t, true);
        }
        let mu = problem.mu(contact);
        if let Some(row) = presses {
            m[(size_row, row)] = mu * root_n / root_t;
        } else {
            q[size_row] = mu * site.k[0] * a[0] / root_t;
            couple(m, size_row, site.map.column(0) * (-mu * site.k[0] / root_t), false);
        }
    }

    /// A spring that acts both ways: F = k (a - G_iᵀq) along this axis.
    fn both_ways(&mut self, contact: usize, axis: usize) {
        let site = &self.problem.sites[contact];
        let g = site.map.column(axis);
        self.load += g * (site.k[axis] * self.problem.drives[contact][axis]);
        for i in 0..D {
            for j in 0..D {
                self.stiffness[i][j] += site.k[axis] * g[i] * g[j];
            }
        }
    }
}
