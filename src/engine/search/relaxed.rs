//! Equilibrium with the law of each contact relaxed: stretch and force of the contact may be any point of the convex hull of the law, a polyhedral
//! cone. The relaxation is made in a case of branch and bound. A case restricts each contact, for example to being closed, or to friction directions
//! between two angles.
//!
//! Equilibrium is written in energy units, in which the stretches v and contact forces F are `e = K^{1/2}v` and `f = K^{-1/2}F`, with the stiffnesses
//! K. With the grasp maps G, P is the orthogonal projector on the span of `K^{1/2}Gᵀ`. The forces of the elastic trial, in which everything sticks,
//! are f⁰. Balance of forces and compatibility of stretches are
//!
//! ```text
//! P f = P f⁰,   (1 - P) e = (1 - P) f⁰        ⟺        e + P (f - e) = f⁰
//! ```
//!
//! one equation, without the twist, in as many unknowns as there are stretches. In the relaxed law (e, f) may be any sum of generators of the hulls
//! with coefficients s >= 0. Either such a sum solves the equation, or the distance of f⁰ from the values `e + P (f - e)` of all such sums is
//! positive. In that case let y be the difference between f⁰ and the nearest value. It satisfies
//!
//! ```text
//! y·f⁰ = |y|² > 0,      y·(e + P (f - e)) <= δ    for every generator (e, f)
//! ```
//!
//! Here δ, nearly zero, is the largest of the products on the left of the second relation. The vector y contradicts every equilibrium whose
//! coefficients s have a sum below `|y|²/δ`. This is so for every y on the way to the nearest value, too, with a larger δ.

use nalgebra::SVector;

use super::tolerances::OUT_OF_REACH;
use crate::contact::HullRay;
use crate::numerics::tolerances::{NEGLIGIBLE, SOLVED_ROUNDING};
use crate::numerics::{IntoList, NearestPoint, Reals, Vector, add_times, by_axis, mapped, numbered, summed};
use crate::object::{ForcesAndTwist, LinearProblem, Problem};
use crate::prelude::*;
use crate::proofs::{ESCAPE, LEAST_WORK};

/// A generator of the convex hull of a contact law: the index of its contact, and its index among the generators of that contact.
pub(super) type GeneratorIndex = (usize, usize);

/// The equation `e + P (f - e) = f⁰` with the projector P, which expresses balance of forces f and compatibility of stretches e.
pub(super) struct BalanceEquation {
    /// The projector P of the equation, column by column.
    projector: Vec<f64>,
    /// The forces f⁰ of the elastic trial in energy units, scaled to length one.
    target: Vec<f64>,
    /// The norm of f⁰ (forces of the elastic trial in energy units) before it was scaled to one. Its unit is the square root of an energy, √J.
    unit: f64,
    /// The square roots of stiffness, K^{1/2}, of each contact.
    roots: Vec<SVector<f64, 3>>,
}

/// The result of relaxing every contact's law to its convex hull in one case of branch and bound, which restricts the contact states.
pub(super) enum Relaxed {
    /// The case is not contradicted. The fields are stretches (m) and forces (N) of the contacts that solve the relaxed equations, or come nearest to
    /// a solution. If the relaxation does not determine stretches and forces, these are one choice of many.
    Met(Vec<SVector<f64, 3>>, Vec<SVector<f64, 3>>),
    /// The case has no equilibrium, except perhaps an equilibrium that rounding hides. In energy units the stretches and forces of such an
    /// equilibrium exceed those of the elastic trial by at least the factor `escape`.
    Contradicted { escape: f64 },
}

impl BalanceEquation {
    /// Sets up the equation for a problem, given the solution `state` of its elastic trial `trial`, in which every contact sticks. `None` if the
    /// elastic trial carries no force.
    pub(super) fn new(problem: &Problem, trial: &LinearProblem, state: &ForcesAndTwist) -> Option<Self> {
        let size = 3 * problem.len();
        let roots: Vec<_> = mapped(problem.sites, &|site| site.springs.root());
        let energy = |(root, force): (&SVector<f64, 3>, &SVector<f64, 3>)| {
            by_axis::<3>(|a| if root[a] > 0.0 { force[a] / root[a] } else { 0.0 })
        };
        let mut target: Vec<f64> = Vec::with_capacity(size);
        for pair in roots.iter().zip(&state.forces) {
            target.extend_from_slice(energy(pair).as_slice());
        }
        let unit = summed(&target, &|x| x * x).sqrt();
        if !(unit > 0.0 && unit.is_finite()) {
            return None;
        }
        for x in &mut target {
            *x /= unit;
        }
        let maps: Vec<_> = numbered(problem.len(), &|contact| trial.factor_rows(contact));
        let mut projector = Vec::with_capacity(size * size);
        for columns in &maps {
            for a in 0..3 {
                let column = columns.column(a);
                for rows in &maps {
                    projector.extend_from_slice(rows.tr_mul(&column).as_slice());
                }
            }
        }
        Some(Self { projector, target, unit, roots })
    }

    /// The start of the search for the nearest point of the cone: its apex, without any generator.
    pub(super) fn start(&self) -> NearestPoint<GeneratorIndex> {
        NearestPoint::new(&self.target)
    }

    /// Writes `e + P (f - e)` into `column`, with the projector P and the stretch e and force f of the generator `ray` of a contact.
    fn column(&self, contact: usize, ray: &HullRay, column: &mut Vec<f64>) {
        let size = self.target.len();
        column.clear();
        column.resize(size, 0.0);
        for a in 0..3 {
            let (row, jump) = (3 * contact + a, ray.force[a] - ray.stretch[a]);
            if jump != 0.0 {
                add_times(column, &self.projector[size * row..][..size], jump);
            }
            column[row] += ray.stretch[a];
        }
    }

    /// Writes the projection `P y` of the vector `y` into `projected`, with the projector P of the equation.
    fn projected(&self, y: &[f64], projected: &mut Vec<f64>) {
        let size = y.len();
        projected.clear();
        projected.resize(size, 0.0);
        for (column, y) in self.projector.chunks_exact(size).zip(y) {
            add_times(projected, column, *y);
        }
    }

    /// For each generator, with stretch e and force f, the scalar product of the vector `y` with `e + P (f - e)`. P is the projector of the equation,
    /// and `projected` is P y.
    fn works_of_generators<'r>(
        y: &'r [f64],
        projected: &'r [f64],
        hulls: &'r [impl AsRef<[HullRay]>],
    ) -> impl Iterator<Item = (GeneratorIndex, f64)> + 'r {
        hulls.iter().enumerate().flat_map(move |(contact, hull)| {
            let on_force = SVector::<f64, 3>::from_column_slice(&projected[3 * contact..][..3]);
            let on_stretch = SVector::<f64, 3>::from_column_slice(&y[3 * contact..][..3]) - on_force;
            hull.as_ref()
                .iter()
                .enumerate()
                .map(move |(k, ray)| ((contact, k), on_stretch.dot(&ray.stretch) + on_force.dot(&ray.force)))
        })
    }

    /// The generators of `hulls`, one convex hull for each contact, span a cone. Moves `nearest` to the point of this cone nearest to the target f⁰
    /// (forces of the elastic trial). Returns [`Relaxed::Contradicted`] if the distance of this point from f⁰ proves that the case has no
    /// equilibrium, otherwise the stretches and forces at this point.
    pub(super) fn relax(
        &self,
        hulls: &[impl AsRef<[HullRay]>],
        nearest: &mut NearestPoint<GeneratorIndex>,
    ) -> Relaxed {
        let (mut column, mut projected) = (Vec::new(), Vec::new());
        nearest.move_to_closest(&self.target);
        // The generators that have been added since the distance last decreased. They are not added again before the distance decreases, so that the
        // loop cannot cycle.
        let mut tried: Vec<GeneratorIndex> = Vec::new();
        let mut least = f64::INFINITY;
        // Limit of the number of generators that are added: forty for each row of the balance equation. If it is reached, the case counts as not
        // contradicted.
        for _ in 0..40 * self.target.len() {
            let distance = nearest.distance();
            // If the distance from the target f⁰ (scaled to length one) is below 1e-11, it may be rounding, and the case is not contradicted.
            if distance < 1e-11 || !distance.is_finite() {
                break;
            }
            // A decrease of the distance from the target by less than the fraction `NEGLIGIBLE` counts as no decrease.
            if distance < least * (1.0 - NEGLIGIBLE) {
                least = distance;
                tried.clear();
            }
            self.projected(nearest.residual(), &mut projected);
            // The work of a generator is its scalar product with the residual (target minus nearest point). A generator is added only if its work
            // exceeds the fraction `SOLVED_ROUNDING` of the norm of the residual; smaller work is rounding.
            let (mut best, mut most) = (None, SOLVED_ROUNDING * distance);
            let mut hardest = LEAST_WORK * distance;
            for (tag, work) in Self::works_of_generators(nearest.residual(), &projected, hulls) {
                hardest = hardest.max(work);
                if work > most && !tried.contains(&tag) && !nearest.has(tag) {
                    (best, most) = (Some(tag), work);
                }
            }
            // A contradiction is proved only if the distance of the nearest point from the target, which has length one, is clearly larger than
            // rounding, here 1e-10. While generators can still be added, equilibria must be out of reach.
            let (escape, proves) = (distance * distance / hardest, distance >= 1e-10);
            if proves && escape >= if best.is_some() { OUT_OF_REACH } else { ESCAPE } {
                return Relaxed::Contradicted { escape };
            }
            let Some(tag) = best else { break };
            tried.push(tag);
            let ray = &hulls[tag.0].as_ref()[tag.1];
            self.column(tag.0, ray, &mut column);
            if nearest.add_generator(tag, &column, &self.target) {
                nearest.move_to_closest(&self.target);
            }
        }
        // The case is not clearly contradicted. The caller then divides it into smaller cases. This is safe, since only contradicted cases are
        // excluded from the search.
        self.sum(hulls, nearest)
    }

    fn sum(&self, hulls: &[impl AsRef<[HullRay]>], nearest: &NearestPoint<GeneratorIndex>) -> Relaxed {
        let mut stretches = vec![SVector::zeros(); hulls.len()];
        let mut forces = stretches.clone();
        for ((contact, ray), coefficient) in nearest.coefficients() {
            let ray = &hulls[contact].as_ref()[ray];
            stretches[contact] += ray.stretch * (coefficient * self.unit);
            forces[contact] += ray.force * (coefficient * self.unit);
        }
        for ((stretch, force), root) in stretches.iter_mut().zip(&mut forces).zip(&self.roots) {
            force.component_mul_assign(root);
            for a in 0..3 {
                stretch[a] = if root[a] > 0.0 { stretch[a] / root[a] } else { 0.0 };
            }
        }
        Relaxed::Met(stretches, forces)
    }

    /// The proof that no equilibrium has the contact states of a case: a virtual motion, and virtual contact forces that balance one another. They
    /// follow from the difference between the target f⁰ (forces of the elastic trial) and the nearest point of the case's cone.
    pub(super) fn contradiction(
        &self,
        trial: &LinearProblem,
        nearest: &NearestPoint<GeneratorIndex>,
    ) -> (Vector, Vec<SVector<f64, 3>>) {
        let y = nearest.residual();
        let mut projected = Vec::new();
        self.projected(y, &mut projected);
        let part =
            |list: &[f64], contact: usize| SVector::<f64, 3>::from_column_slice(&list[3 * contact..][..3]);
        let maps = self.roots.iter().enumerate().map(|(contact, root)| {
            let on_force = part(&projected, contact);
            by_axis(|a| if root[a] > 0.0 { on_force[a] / root[a] } else { 0.0 })
        });
        let motion = trial.solve_roughly(&maps.list(), &Vector::zeros()).twist;
        let on_stretch = |contact| part(y, contact) - part(&projected, contact);
        let forces = self.roots.iter().enumerate().map(|(i, root)| on_stretch(i).component_mul(root));
        (motion, forces.list())
    }

    /// The norm of the difference of two forces at a contact, divided by the norm of all contact forces of the elastic trial. Both are in energy
    /// units.
    pub(super) fn part(&self, contact: usize, difference: &SVector<f64, 3>) -> f64 {
        let root = &self.roots[contact];
        let square: f64 = (0..3)
            .filter(|&a| root[a] > 0.0)
            .map(|a| (difference[a] / root[a]) * (difference[a] / root[a]))
            .added();
        square.sqrt() / self.unit
    }
}
