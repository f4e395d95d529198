//! The linear conditions that a case of [`super::sectors`] implies, and whether they contradict equilibrium.

use nalgebra::{DMatrix, DVector, SVector};

use crate::contact::LocalLaw;
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

/// The conditions `row·y >= right` and `row·y = right` on y = (twist in its unit, forces of their own).
pub(super) struct Conditions<const D: usize, const C: usize> {
    columns: usize,
    twist_unit: f64,
    inequalities: Vec<(Vec<f64>, f64)>,
    equalities: Vec<(Vec<f64>, f64)>,
    /// Force of each contact as an affine function of y, axis by axis.
    forces: Vec<Vec<Affine>>,
}

/// `row·y + constant`.
#[derive(Debug, Clone)]
struct Affine {
    row: Vec<f64>,
    constant: f64,
}

impl Affine {
    fn zero(columns: usize) -> Self {
        Self { row: vec![0.0; columns], constant: 0.0 }
    }

    fn plus(mut self, factor: f64, other: &Self) -> Self {
        self.row.iter_mut().zip(&other.row).for_each(|(x, y)| *x += factor * y);
        self.constant += factor * other.constant;
        self
    }

    fn times(&self, factor: f64) -> Self {
        Self::zero(self.row.len()).plus(factor, self)
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
        for (i, label) in labels.iter().enumerate() {
            c.add_contact(problem, i, label, &tangents[i], &mut next);
        }
        for d in 0..D {
            let mut sum = Affine { constant: problem.wrench[d], ..Affine::zero(columns) };
            for (site, force) in problem.sites.iter().zip(&c.forces) {
                for (a, f) in force.iter().enumerate() {
                    sum = sum.plus(site.map[(d, a)], f);
                }
            }
            c.equalities.push((sum.row, -sum.constant));
        }
        c
    }

    fn at_least_zero(&mut self, value: Affine) {
        self.inequalities.push((value.row, -value.constant));
    }

    /// The conditions of contact i; `next` is the first column that no contact has taken.
    fn add_contact(
        &mut self,
        problem: &Problem<D, C>,
        i: usize,
        label: &Label,
        tangents: &[f64],
        next: &mut usize,
    ) {
        let local = problem.local(i);
        let spring = self.full_forces(problem, i);
        let columns = self.columns;
        let mut own = || {
            let mut x = Affine::zero(columns);
            x.row[*next] = 1.0;
            *next += 1;
            x
        };
        let force: Vec<Affine> = match *label {
            Label::Open => vec![Affine::zero(columns); C],
            Label::Rolling => spring[..local.springs.axes()].to_vec(),
            Label::Undecided => (0..local.springs.axes()).map(|_| own()).collect(),
            Label::Sector(from, to) => {
                let weights = [own(), own()];
                self.add_sector(&local, &spring, [from, to], weights)
            }
        };
        if *label == Label::Open {
            self.at_least_zero(spring[0].times(-1.0));
        } else if !local.is_bonded() {
            self.add_closed(&local, &spring[0], &force, label, tangents);
        }
        self.forces.push(force);
    }

    /// K v, the forces of springs that are stretched by the whole of v.
    fn full_forces(&self, problem: &Problem<D, C>, i: usize) -> [Affine; C] {
        let site = &problem.sites[i];
        let force = site.springs.force(&problem.drives[i]);
        std::array::from_fn(|a| {
            let mut f = Affine { constant: force[a], ..Affine::zero(self.columns) };
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
        let implied = [
            along(1.0, 1.0).plus(-1.0, &limit),
            limit.clone().plus(-1.0, &toward(from)),
            limit.plus(-1.0, &toward(to)),
            left_of(from),
            left_of(to).times(-1.0),
            alpha,
            beta,
        ];
        implied.into_iter().for_each(|value| self.at_least_zero(value));
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
            if local.may_open() {
                self.at_least_zero(slack);
            } else {
                self.equalities.push((slack.row, -slack.constant));
            }
        }
        if local.may_open() || !local.cone().is_frictionless() {
            self.at_least_zero(force[0].clone());
        }
        if local.may_slide() && !matches!(label, Label::Sector(..)) {
            let limit = force[0].times(local.cone().limit(1.0));
            for angle in tangents {
                let value = limit.clone().plus(-angle.cos(), &force[1]).plus(-angle.sin(), &force[2]);
                self.at_least_zero(value);
            }
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
        let sizes: Vec<f64> = rows
            .iter()
            .map(|(row, _)| row.iter().map(|x| x * x).sum::<f64>().sqrt().max(f64::MIN_POSITIVE))
            .collect();
        let matrix = DMatrix::from_fn(m, self.columns, |i, j| rows[i].0[j] / sizes[i]);
        let right = DVector::from_fn(m, |i, _| rows[i].1 / sizes[i]);
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
        let forces = self.forces.iter().map(|force| {
            let value = |f: &Affine| f.row.iter().zip(y.iter()).map(|(a, b)| a * b).sum::<f64>() + f.constant;
            SVector::from_fn(|a, _| force.get(a).map_or(0.0, value))
        });
        Some(PieceState { forces: forces.collect(), twist: SVector::from_fn(|d, _| y[d] * self.twist_unit) })
    }
}
