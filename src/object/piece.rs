//! With every contact in a known state the law is linear: one `d x d` system gives twist and forces.
//!
//! A contact in a known state is a few springs, each stretched along one direction and pushing along another:
//! `F_i = Σ_r left_r (right_r · v_i)` with `v_i = a_i - G_iᵀq`.
//!
//! With x_r = right_r · v the rows of A = right Gᵀ, B = left Gᵀ and α = right·a give `x = α - A q`, `Bᵀx = -W`: an
//! oblique projection (an orthogonal one when nothing slides). Both factors are orthogonalised. What a solution leaves of its
//! equations is evaluated in twice the working precision and solved for again:
//!
//! ```text
//! e_r = right_r · (a_i - G_iᵀ q) - x_r,      ρ = Σ G_i left_r x_r + W
//! ```

use std::ops::Range;

use nalgebra::{SMatrix, SVector};

use super::free_motions::{NO_WORK, worked_on};
use super::load::Load;
use super::precise::{PreciseBalance, PreciseTwist};
use super::problem::Problem;
use crate::contact::{Spring, State};
use crate::grasp::Site;
use crate::numerics::{CompletePivoting, DoubleDouble, Orthogonal, orthonormalise_against, without};

/// A correction by less than this part of the largest force is the last: what it leaves is this part of itself.
pub(super) const NEARLY: f64 = 1e-8;
/// Corrections at most: where a force is zero exactly each leaves 1e-16 of what was there before.
pub(super) const MOST_CORRECTIONS: usize = 4;

/// One linear piece of the contact law: a state for every contact.
#[derive(Debug, Clone)]
pub(crate) struct Piece<const D: usize, const C: usize> {
    pub(super) springs: Vec<Spring<C>>,
    /// Where the springs of each contact begin; at the end their number.
    first: Vec<usize>,
    pub(super) right: Orthogonal<D>,
    /// Differs from `right` only when something slides.
    left: Option<(Orthogonal<D>, CompletePivoting<D>)>,
    /// Orthonormal motions that stretch no spring of this piece.
    free: Vec<SVector<f64, D>>,
    /// Orthonormal motions that no left factor sees: a load doing work on one is not balanced in this piece.
    unbalanced: Vec<SVector<f64, D>>,
}

/// Forces and a twist of one linear piece.
#[derive(Debug, Clone)]
pub(crate) struct PieceState<const D: usize, const C: usize> {
    /// F_i in the contact frames.
    pub(crate) forces: Vec<SVector<f64, C>>,
    /// The twist of least norm, in inside coordinates.
    pub(crate) twist: SVector<f64, D>,
}

/// Why a piece has no solution under a load.
#[derive(Debug, Clone)]
pub(crate) struct Unbalanced<const D: usize> {
    /// The unit motion on which the load works and no contact of this piece resists; `None` when the springs do
    /// resist it but friction lets them not push that way.
    pub(crate) motion: Option<SVector<f64, D>>,
}

impl<const D: usize, const C: usize> Piece<D, C> {
    pub(crate) fn new(problem: &Problem<D, C>, states: &[State<C>]) -> Self {
        Self::of_springs(problem.sites, |contact, springs| {
            problem.local(contact).for_each_spring(&states[contact], |spring| springs.push(spring));
        })
    }

    /// The piece in which every contact has the springs, at most C, that `add` adds to the list for it.
    pub(crate) fn of_springs(sites: &[Site<D, C>], add: impl Fn(usize, &mut Vec<Spring<C>>)) -> Self {
        let mut springs = Vec::with_capacity(C * sites.len());
        let mut first = Vec::with_capacity(sites.len() + 1);
        first.push(0);
        for contact in 0..sites.len() {
            add(contact, &mut springs);
            first.push(springs.len());
        }
        let rows = |side: fn(&Spring<C>) -> &SVector<f64, C>| {
            let mut rows = Vec::with_capacity(springs.len());
            for (site, range) in sites.iter().zip(first.windows(2)) {
                rows.extend(springs[range[0]..range[1]].iter().map(|spring| site.map * side(spring)));
            }
            rows
        };
        let right = Orthogonal::new(rows(|s| &s.right));
        let free = right.null_space();
        if springs.iter().all(|spring| spring.left == spring.right) {
            return Self { springs, first, right, left: None, unbalanced: free.clone(), free };
        }
        let left = Orthogonal::new(rows(|s| &s.left));
        let unbalanced = left.null_space();
        let mut coupling = SMatrix::<f64, D, D>::zeros();
        for i in 0..springs.len() {
            coupling += left.row(i) * right.row(i).transpose();
        }
        let coupling = CompletePivoting::new(coupling, left.rank(), right.rank());
        Self { springs, first, right, left: Some((left, coupling)), free, unbalanced }
    }

    /// The factors of K^{1/2}Gᵀ, row by row the springs of the contacts in order.
    pub(crate) fn factor(&self) -> &Orthogonal<D> {
        &self.right
    }

    /// The rows of Q of a contact whose springs stand along the axes of its frame: a column for each axis,
    /// zero along axes without a spring.
    pub(crate) fn seen(&self, contact: usize) -> SMatrix<f64, D, C> {
        let mut seen = SMatrix::<f64, D, C>::zeros();
        for spring in self.first[contact]..self.first[contact + 1] {
            seen.set_column(self.springs[spring].right.iamax(), self.right.row(spring));
        }
        seen
    }

    /// The least motion with these coordinates R q.
    pub(crate) fn motion(&self, coordinates: &SVector<f64, D>) -> SVector<f64, D> {
        without(self.right.preimage(coordinates), &self.free)
    }

    /// Motions that stretch no spring of this piece: the twist is known up to them, the forces do not feel them.
    pub(crate) fn free_motions(&self) -> &[SVector<f64, D>] {
        &self.free
    }

    /// Motions along which this piece stays in equilibrium while its forces change: its solution is a whole line.
    pub(crate) fn neutral_motions(&self) -> Vec<SVector<f64, D>> {
        let Some((_, coupling)) = &self.left else { return Vec::new() };
        let mut motions: Vec<SVector<f64, D>> = Vec::new();
        for c in coupling.kernel() {
            let mut v = self.right.preimage(&c);
            let found: Vec<_> = self.free.iter().chain(&motions).copied().collect();
            orthonormalise_against(&mut v, &found);
            motions.push(v);
        }
        motions
    }

    /// A virtual motion to which nothing here responds, and on which drives and load work the most: `Σ G_i C_iᵀG_iᵀ y = 0` with the
    /// tangents C_i of this piece.
    pub(crate) fn unanswered(
        &self,
        drives: &[SVector<f64, C>],
        load: &SVector<f64, D>,
    ) -> Option<SVector<f64, D>> {
        let worked = |basis: &[SVector<f64, D>], work: &SVector<f64, D>| {
            let part = basis.iter().fold(SVector::zeros(), |sum: SVector<f64, D>, v| sum + v * v.dot(work));
            (part.norm() > 0.0).then_some(part)
        };
        if let Some(motion) = worked(&self.unbalanced, load) {
            return Some(motion);
        }
        let (left, coupling) = self.left.as_ref()?;
        let mut kernel: Vec<SVector<f64, D>> = Vec::new();
        for mut z in coupling.left_kernel() {
            orthonormalise_against(&mut z, &kernel);
            kernel.push(z);
        }
        let pushed = left.coordinates(&self.stretched(|contact| drives[contact]));
        Some(left.preimage(&worked(&kernel, &(pushed + left.load_coordinates(load)))?))
    }

    /// How much relative rounding errors grow in this piece, at least 1.
    pub(crate) fn growth(&self) -> f64 {
        self.left.as_ref().map_or(1.0, |(_, coupling)| coupling.growth())
    }

    /// Forces and the twist of least norm under these drives and this load. The sites are those the piece was made of.
    pub(crate) fn solve(
        &self,
        sites: &[Site<D, C>],
        drives: &[SVector<f64, C>],
        load: impl Into<Load<D>>,
    ) -> Result<PieceState<D, C>, Unbalanced<D>> {
        let load = load.into();
        if let Some(motion) = worked_on(&self.unbalanced, &load.wrench) {
            return Err(Unbalanced { motion: Some(motion) });
        }
        let balance = self.left.as_ref().map_or(&self.right, |(left, _)| left);
        let mut x = self.stretched(|contact| drives[contact]);
        let pulled = balance.load_coordinates(&load.wrench);
        let pushed = balance.coordinates(&x);
        let step = match &self.left {
            None => pushed + pulled,
            Some((_, coupling)) => {
                let (step, unreached) = coupling.solve(&(pushed + pulled));
                // Near a solution the sum is a difference, known up to the rounding of its terms.
                let known = NO_WORK * pushed.amax().max(pulled.amax());
                if unreached > known && unreached > known * coupling.growth() {
                    return Err(Unbalanced { motion: None });
                }
                step
            }
        };
        self.right.subtract(&mut x, &step);
        let mut twist = PreciseTwist::new(self.right.preimage(&step));
        // Again for what is left of the equations.
        let mut change = vec![0.0; x.len()];
        for _ in 0..MOST_CORRECTIONS {
            let rest = self.excess(sites, (drives, &load), (&x, &twist), &mut change);
            twist.add(&self.respond(&mut change, &rest));
            let (mut largest, mut changed) = (0.0_f64, 0.0_f64);
            for ((x, change), spring) in x.iter_mut().zip(&change).zip(&self.springs) {
                *x += change;
                let push = spring.left.amax();
                largest = largest.max(push * x.abs());
                changed = changed.max(push * change.abs());
            }
            if changed <= NEARLY * largest {
                break;
            }
        }
        let twist = without(twist.value(), &self.free);
        Ok(PieceState { forces: self.forces(&x, drives.len()), twist })
    }

    /// Forces and the twist of least norm where everything sticks and every motion is resisted, without the steps in twice the precision:
    /// the projection is applied twice, which leaves a few roundings of the largest force.
    pub(crate) fn solve_roughly(
        &self,
        drives: &[SVector<f64, C>],
        wrench: &SVector<f64, D>,
    ) -> PieceState<D, C> {
        let mut x = self.stretched(|contact| drives[contact]);
        let load = self.right.load_coordinates(wrench);
        let mut travelled = SVector::zeros();
        for _ in 0..2 {
            let step = self.right.coordinates(&x) + load;
            self.right.subtract(&mut x, &step);
            travelled += step;
        }
        PieceState { forces: self.forces(&x, drives.len()), twist: self.right.preimage(&travelled) }
    }

    /// `x - Q_A (Q_BᵀQ_A)⁻¹ (Q_Bᵀx + R_B⁻ᵀW)` in place of x, and the twist that goes with it.
    pub(super) fn respond(&self, x: &mut [f64], wrench: &SVector<f64, D>) -> SVector<f64, D> {
        let balance = self.left.as_ref().map_or(&self.right, |(left, _)| left);
        let excess = balance.coordinates(x) + balance.load_coordinates(wrench);
        let step = self.left.as_ref().map_or(excess, |(_, coupling)| coupling.solve(&excess).0);
        self.right.subtract(x, &step);
        self.right.preimage(&step)
    }

    /// Forces of these stretches of the contacts under this load, as far as this piece balances it.
    pub(crate) fn forces_of(
        &self,
        stretches: &[SVector<f64, C>],
        load: &SVector<f64, D>,
    ) -> Vec<SVector<f64, C>> {
        let mut x = self.stretched(|contact| stretches[contact]);
        self.respond(&mut x, load);
        self.forces(&x, stretches.len())
    }

    /// Change of the forces along a motion of the object with everything else at rest.
    pub(crate) fn forces_along(
        &self,
        problem: &Problem<D, C>,
        motion: &SVector<f64, D>,
    ) -> Vec<SVector<f64, C>> {
        let x = self.stretched(|contact| -problem.sites[contact].map.tr_mul(motion));
        self.forces(&x, problem.len())
    }

    /// Whether the load works on no motion that nothing here balances.
    pub(crate) fn resists(&self, wrench: &SVector<f64, D>) -> bool {
        worked_on(&self.unbalanced, wrench).is_none()
    }

    /// The springs of every contact that has any, with the places of these springs in the whole list.
    pub(super) fn of_each_contact(&self) -> impl Iterator<Item = (usize, &[Spring<C>], Range<usize>)> {
        self.first.windows(2).enumerate().filter(|(_, range)| range[0] < range[1]).map(|(contact, range)| {
            let range = range[0]..range[1];
            (contact, &self.springs[range.clone()], range)
        })
    }

    /// x for these stretches of the contacts.
    fn stretched(&self, stretch: impl Fn(usize) -> SVector<f64, C>) -> Vec<f64> {
        let mut x = Vec::with_capacity(self.springs.len());
        for (contact, springs, _) in self.of_each_contact() {
            let stretch = stretch(contact);
            x.extend(springs.iter().map(|spring| spring.right.dot(&stretch)));
        }
        x
    }

    fn forces(&self, x: &[f64], contacts: usize) -> Vec<SVector<f64, C>> {
        let mut forces = vec![SVector::zeros(); contacts];
        for (contact, springs, range) in self.of_each_contact() {
            for (spring, x) in springs.iter().zip(&x[range]) {
                forces[contact] += spring.left * *x;
            }
        }
        forces
    }

    /// Writes e, spring by spring, and returns ρ.
    fn excess(
        &self,
        sites: &[Site<D, C>],
        (drives, load): (&[SVector<f64, C>], &Load<D>),
        (x, twist): (&[f64], &PreciseTwist<D>),
        e: &mut [f64],
    ) -> SVector<f64, D> {
        let mut balance = PreciseBalance::new(load);
        for (contact, springs, range) in self.of_each_contact() {
            let (site, x) = (&sites[contact], &x[range.clone()]);
            // A contact has at most C springs.
            let mut left = [DoubleDouble::default(); C];
            for (left, x) in left.iter_mut().zip(x) {
                left.add(-x);
            }
            for a in 0..C {
                // Springs along the axes are the most, and have one component each.
                if springs.iter().any(|spring| spring.right[a] != 0.0) {
                    let v = twist.stretch(site, a, drives[contact][a]);
                    for (left, spring) in left.iter_mut().zip(springs).filter(|(_, s)| s.right[a] != 0.0) {
                        left.add_product_of_twice((spring.right[a], spring.right_rest[a]), v);
                    }
                }
                let mut force = DoubleDouble::default();
                for (spring, &x) in springs.iter().zip(x).filter(|(s, _)| s.left[a] != 0.0) {
                    force.add_product_of_twice((spring.left[a], spring.left_rest[a]), DoubleDouble::new(x));
                }
                if force.high != 0.0 {
                    balance.add(site, a, force);
                }
            }
            for (e, left) in e[range].iter_mut().zip(left) {
                *e = left.value();
            }
        }
        balance.value()
    }
}

/// The smallest forces (least squares, contact frames) of the contacts that carry any which balance a load:
/// `F = -G⁺W` over the axes that resist.
pub(crate) fn least_forces<const D: usize, const C: usize>(
    sites: &[Site<D, C>],
    carries: &[bool],
    wrench: &SVector<f64, D>,
) -> Vec<SVector<f64, C>> {
    let axes: Vec<(usize, usize)> = (0..sites.len())
        .filter(|&i| carries[i])
        .flat_map(|i| (0..sites[i].springs.axes()).map(move |a| (i, a)))
        .collect();
    let shares =
        least_combination(axes.iter().map(|&(i, a)| sites[i].map.column(a).into_owned()).collect(), wrench);
    let mut forces = vec![SVector::<f64, C>::zeros(); sites.len()];
    for (&(i, a), share) in axes.iter().zip(shares) {
        forces[i][a] = -share;
    }
    forces
}

/// The smallest coefficients (least squares) with which these vectors add up to a target that they span.
pub(crate) fn least_combination<const D: usize>(
    vectors: Vec<SVector<f64, D>>,
    target: &SVector<f64, D>,
) -> Vec<f64> {
    let count = vectors.len();
    let factor = Orthogonal::new(vectors);
    let coordinates = factor.load_coordinates(target);
    (0..count).map(|i| factor.row(i).dot(&coordinates)).collect()
}
