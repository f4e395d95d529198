//! The linear conditions that a case of [`super::sectors`] implies, and whether they contradict equilibrium.

use nalgebra::{DMatrix, DVector, SVector};

use crate::contact::LocalLaw;
use crate::grasp::Site;
use crate::lcp::{self, Lcp, Outcome};
use crate::object::{PieceState, Problem};

/// Conditions that can be met but for this part of their terms are not contradicted clearly.
const CLEAR: f64 = 1e-9;
/// Part of the squared residual that a slack of one may take away from the contradiction.
const NEGLIGIBLE: f64 = 1e-3;
/// A column of the conditions below this part of the largest adds no direction: rounding.
const DEPENDENT: f64 = 1e-12;
/// Covering vectors tried where the least-squares problem, singular by nature, leads the first path astray.
const RETRIES: usize = 3;

/// What is known of a contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Label {
    Undecided,
    Open,
    Rolling,
    /// Sliding in a direction from the first angle to the second.
    Sector(f64, f64),
}

/// Linear conditions on y = (twist in its unit, forces of their own).
pub(super) struct Conditions<const D: usize, const C: usize> {
    columns: usize,
    twist_unit: f64,
    /// Not negative.
    inequalities: Vec<Affine>,
    /// Zero.
    equalities: Vec<Affine>,
    /// Force of each contact as an affine function of y, axis by axis.
    forces: Vec<Vec<Affine>>,
}

/// `row·y + constant`.
#[derive(Debug, Clone)]
struct Affine {
    row: DVector<f64>,
    constant: f64,
}

impl Affine {
    fn constant(columns: usize, constant: f64) -> Self {
        Self { row: DVector::zeros(columns), constant }
    }

    fn plus(mut self, factor: f64, other: &Self) -> Self {
        self.row.axpy(factor, &other.row, 1.0);
        self.constant += factor * other.constant;
        self
    }

    fn times(&self, factor: f64) -> Self {
        Self { row: &self.row * factor, constant: self.constant * factor }
    }
}

impl<const D: usize, const C: usize> Conditions<D, C> {
    pub(super) fn new(problem: &Problem<D, C>, labels: &[Label], tangents: &[Vec<f64>]) -> Self {
        let own = |(local, label): (LocalLaw<'_, C>, &Label)| match label {
            Label::Undecided => local.springs.axes(),
            Label::Sector(..) => 2,
            _ => 0,
        };
        let columns = D + problem.locals().zip(labels).map(own).sum::<usize>();
        // The motion that stretches a spring of the scene by a force of one.
        let stiffest = problem.sites.iter().map(|site| site.springs.stiffest()).fold(0.0, f64::max);
        let mut c = Self {
            columns,
            twist_unit: 1.0 / stiffest,
            inequalities: Vec::new(),
            equalities: Vec::new(),
            forces: Vec::new(),
        };
        let mut next = D;
        let tangents = labels.iter().zip(tangents);
        let contacts = problem.locals().zip(problem.sites).zip(&problem.drives).zip(tangents);
        for (((local, site), drive), (label, tangents)) in contacts {
            let spring = c.spring_forces(site, drive);
            c.add_contact(&local, &spring, label, tangents, &mut next);
        }
        for d in 0..D {
            let mut sum = Affine::constant(columns, problem.wrench[d]);
            for (site, force) in problem.sites.iter().zip(&c.forces) {
                for (a, f) in force.iter().enumerate() {
                    sum = sum.plus(site.map[(d, a)], f);
                }
            }
            c.equalities.push(sum);
        }
        c
    }

    /// The conditions of a contact; `next` is the first column that no contact has taken.
    fn add_contact(
        &mut self,
        local: &LocalLaw<'_, C>,
        spring: &[Affine; C],
        label: &Label,
        tangents: &[f64],
        next: &mut usize,
    ) {
        let columns = self.columns;
        let mut own = || {
            let mut x = Affine::constant(columns, 0.0);
            x.row[*next] = 1.0;
            *next += 1;
            x
        };
        let force: Vec<Affine> = match *label {
            Label::Open => vec![Affine::constant(columns, 0.0); C],
            Label::Rolling => spring[..local.springs.axes()].to_vec(),
            Label::Undecided => (0..local.springs.axes()).map(|_| own()).collect(),
            Label::Sector(from, to) => {
                let weights = [own(), own()];
                self.add_sector(local, spring, [from, to], weights)
            }
        };
        if *label == Label::Open {
            self.inequalities.push(spring[0].times(-1.0));
        } else if !local.is_bonded() {
            self.add_closed(local, &spring[0], &force, label, tangents);
        }
        self.forces.push(force);
    }

    /// K v, the forces of springs that are stretched by the whole of v.
    fn spring_forces(&self, site: &Site<D, C>, drive: &SVector<f64, C>) -> [Affine; C] {
        std::array::from_fn(|a| {
            let mut f = Affine::constant(self.columns, site.springs.force_along(a, drive[a]));
            for d in 0..D {
                f.row[d] = -site.springs.force_along(a, site.map[(d, a)]) * self.twist_unit;
            }
            f
        })
    }

    /// The conditions of a contact that slides in a sector, and its forces `F_t = α d₁ + β d₂`.
    fn add_sector(
        &mut self,
        local: &LocalLaw<'_, C>,
        spring: &[Affine; C],
        [from, to]: [f64; 2],
        [alpha, beta]: [Affine; 2],
    ) -> Vec<Affine> {
        let along = |u: f64, v: f64| alpha.times(u).plus(v, &beta);
        let friction = [along(from.cos(), to.cos()), along(from.sin(), to.sin())];
        let limit = spring[0].times(local.cone().limit(1.0));
        let toward = |angle: f64| friction[0].times(angle.cos()).plus(angle.sin(), &friction[1]);
        // The slip in units of force: K_t v - F_t, each axis divided by its stiffness over the stiffer one.
        let [_, stiffest] = local.springs.tangential_range();
        let slip = [1, 2].map(|a| {
            spring[a].clone().plus(-1.0, &friction[a - 1]).times(local.springs.give_along(a, stiffest))
        });
        let left_of = |angle: f64| slip[1].times(angle.cos()).plus(-angle.sin(), &slip[0]);
        self.inequalities.extend([
            along(1.0, 1.0).plus(-1.0, &limit),
            limit.clone().plus(-1.0, &toward(from)),
            limit.plus(-1.0, &toward(to)),
            left_of(from),
            left_of(to).times(-1.0),
            alpha,
            beta,
        ]);
        let mut forces = vec![spring[0].clone()];
        forces.extend(friction);
        forces
    }

    /// The conditions of a contact that is closed, or not decided.
    fn add_closed(
        &mut self,
        local: &LocalLaw<'_, C>,
        normal_spring: &Affine,
        force: &[Affine],
        label: &Label,
        tangents: &[f64],
    ) {
        if *label == Label::Undecided {
            let slack = force[0].clone().plus(-1.0, normal_spring);
            if local.may_open() { &mut self.inequalities } else { &mut self.equalities }.push(slack);
        }
        if local.may_open() || !local.cone().is_frictionless() {
            self.inequalities.push(force[0].clone());
        }
        if local.may_slide() && !matches!(label, Label::Sector(..)) {
            let limit = force[0].times(local.cone().limit(1.0));
            let inside = |angle: &f64| {
                let (sin, cos) = (angle.sin(), angle.cos());
                limit.clone().plus(-cos, &force[1]).plus(-sin, &force[2])
            };
            self.inequalities.extend(tangents.iter().map(inside));
        }
    }

    /// Twist and forces of the least-squares problem
    ///
    /// ```text
    /// min |A y - b - s|² + |E y - e|²,  s >= 0      ⟺      0 <= s ⟂ P s + P (b, e) >= 0,   P the projector across (A, E)
    /// ```
    ///
    /// unless its residual r = P (b + s, e) is clearly not zero: r is then a combination of the rows that contradicts itself.
    pub(super) fn meet(&self) -> Option<PieceState<D, C>> {
        let rows: Vec<_> = self.inequalities.iter().chain(&self.equalities).collect();
        let (m, n) = (rows.len(), self.inequalities.len());
        let sizes: Vec<f64> = rows.iter().map(|value| value.row.norm().max(f64::MIN_POSITIVE)).collect();
        let matrix = DMatrix::from_fn(m, self.columns, |i, j| rows[i].row[j] / sizes[i]);
        let right = DVector::from_fn(m, |i, _| -rows[i].constant / sizes[i]);
        let unit = right.norm();
        let right = if unit > 0.0 { right / unit } else { right };
        let qr = matrix.col_piv_qr();
        let (q, r) = (qr.q(), qr.r());
        let rank = (0..r.nrows().min(r.ncols()))
            .take_while(|&k| r[(k, k)].abs() > DEPENDENT * r[(0, 0)].abs())
            .count();
        let q = q.columns(0, rank).into_owned();
        let across = |v: &DVector<f64>| v - &q * q.tr_mul(v);
        let start = across(&right);
        // A condition that some y meets without disturbing the others costs nothing: its row of P is rounding of zero.
        let costs: Vec<usize> = (0..n).filter(|&i| 1.0 - q.row(i).norm_squared() > DEPENDENT).collect();
        let projector = DMatrix::from_fn(costs.len(), costs.len(), |i, j| {
            f64::from(u8::from(i == j)) - q.row(costs[i]).dot(&q.row(costs[j]))
        });
        let lcp = Lcp::new(projector, DVector::from_fn(costs.len(), |i, _| start[costs[i]]));
        let mut slack = DVector::zeros(n);
        let settings = lcp::Settings { retries: RETRIES, enumerate_up_to: 0, ..lcp::Settings::default() };
        // Without an answer, or where a number overflows, nothing is contradicted: the start is as good a guess as any.
        if let Ok(Outcome::Solved(solution)) = lcp.map(|lcp| lcp.solve_with(&settings)) {
            costs.iter().zip(&solution.z).for_each(|(&i, s)| slack[i] = *s);
        }
        let mut target = right;
        for i in 0..n {
            target[i] += slack[i];
        }
        let residual = across(&target);
        // What meets the conditions may need slacks as large as the data: r must not work against them by as much as it gains.
        let negligible = NEGLIGIBLE * residual.norm_squared();
        let contradicts = residual.rows(0, n).iter().all(|x| *x >= -negligible);
        if contradicts && residual.norm() > CLEAR {
            return None;
        }
        let mut y = DVector::zeros(self.columns);
        let solved = r
            .view((0, 0), (rank, rank))
            .solve_upper_triangular(&q.tr_mul(&target))
            .unwrap_or_else(|| DVector::zeros(rank));
        y.rows_mut(0, rank).copy_from(&solved);
        qr.p().inv_permute_rows(&mut y);
        y *= unit;
        let forces = self
            .forces
            .iter()
            .map(|force| SVector::from_fn(|a, _| force.get(a).map_or(0.0, |f| f.row.dot(&y) + f.constant)));
        Some(PieceState { forces: forces.collect(), twist: SVector::from_fn(|d, _| y[d] * self.twist_unit) })
    }
}
