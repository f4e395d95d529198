//! Rounding scales of forces, N, and of displacements, m. The rounding scale of a value is the number to which its rounding error is proportional. As
//! a rule it is the largest of the terms from which the value is computed. Code names call it `size` or, for the terms of a stretch, `span`.

use crate::numerics::{self, IntoList, Reals, Vector};
use nalgebra::SVector;

use super::newton::Imbalance;
use super::problem::Problem;
use super::solution::ForcesAndTwist;
use super::tolerances::NO_FORCE;
use crate::contact::SpringState;
use crate::grasp::Site;
use crate::prelude::*;

/// The least force, N, that the displacements of a contact could cause in its softest spring. For each contact this force is the stiffness of its
/// softest spring times its entry of `spans`, m, an upper bound of its displacements. Returns the minimum over the contacts. A computed force far
/// below it is a rounding error, left where larger spring forces cancel.
pub(crate) fn least_spring_force(sites: &[Site], spans: impl Iterator<Item = f64>) -> f64 {
    sites.iter().zip(spans).map(|(site, span)| site.springs.softest() * span).least()
}

/// The largest of the norm `load` of the load and the norms `forces` of contact forces, N, but at least [`NO_FORCE`] (1e-25) times
/// [`least_spring_force`]. If all exact forces are zero, the computed norms are rounding errors, and only the lower bound is a rounding scale.
pub(crate) fn largest_force(
    sites: &[Site],
    offsets: &[SVector<f64, 3>],
    twist: &Vector,
    load: f64,
    forces: impl Iterator<Item = f64>,
) -> f64 {
    let largest = forces.fold(load, f64::max);
    // The least spring force of all contacts is at most that of the first contact. If the spring force of the first contact is below the largest
    // force, the other contacts need not be evaluated.
    let least_of = |count: usize| {
        let norm = twist.norm();
        let spans = sites.iter().zip(offsets).map(|(site, a)| site.span_moved(a, norm));
        NO_FORCE * least_spring_force(&sites[..count], spans)
    };
    if least_of(1) <= largest { largest } else { largest.max(least_of(sites.len())) }
}

impl Problem<'_> {
    /// The largest of the norms of the load of this problem and of the contact forces `forces`, N, with the lower bound of [`largest_force`].
    pub(crate) fn largest_force(&self, forces: &[SVector<f64, 3>], twist: &Vector) -> f64 {
        let sizes = forces.iter().map(nalgebra::Matrix::norm);
        largest_force(self.sites, &self.offsets, twist, self.wrench.norm(), sizes)
    }

    /// For each contact the rounding scale of its force in the solution `state`, N. `offsets` are the spring offsets of the contacts, m, and `load`
    /// is the norm of the load, N.
    pub(crate) fn force_sizes(
        &self,
        offsets: &[SVector<f64, 3>],
        load: f64,
        state: &ForcesAndTwist,
    ) -> Vec<f64> {
        let norms = state.forces.iter().map(nalgebra::Matrix::norm);
        let largest = largest_force(self.sites, offsets, &state.twist, load, norms);
        let norm = state.twist.norm();
        let spans = self.sites.iter().zip(offsets).map(|(site, offset)| site.span_moved(offset, norm));
        let sites = self.locals().zip(&state.forces).zip(spans);
        sites.map(|((local, force), span)| local.force_size(force, span, largest)).list()
    }

    /// The rounding scale of a twist, m: the norm of the twist, plus the stretch of the stiffest spring under the force `largest`, N. The norm alone
    /// is not enough: if opposite commands cancel, the exact twist is zero, but the computed twist still has a rounding error.
    pub(crate) fn size_of_motion(&self, twist: &Vector, largest: f64) -> f64 {
        twist.norm() + self.least_stretch(largest)
    }

    /// Stretch of the stiffest spring under the force `largest`, m: a lower bound of the rounding scale of displacements. Forces have rounding errors
    /// of about ε times `largest`, with the machine precision ε. Even in the stiffest spring such an error causes a displacement of ε times this
    /// stretch.
    pub(crate) fn least_stretch(&self, largest: f64) -> f64 {
        largest / numerics::largest(self.sites, &|site| site.springs.stiffest())
    }

    /// The rounding scale of the stretch `a_i - G_iᵀq` of a contact, m: an upper bound of both terms. a_i is its offset (command minus clearance and
    /// slip), G_i its grasp map, and q the twist.
    #[inline]
    pub(crate) fn span(&self, contact: usize, twist: &Vector) -> f64 {
        self.sites[contact].span(&self.offsets[contact], twist)
    }

    /// Stretch and force of a contact, each with its rounding scale; `largest` is the largest force of the grasp, N. The inequalities that the
    /// contact's state must satisfy are evaluated from these values.
    pub(crate) fn at<'s>(
        &self,
        contact: usize,
        force: &'s SVector<f64, 3>,
        twist: &Vector,
        largest: f64,
    ) -> SpringState<'s> {
        self.at_moved((contact, force), twist, self.size_of_motion(twist, largest), largest)
    }

    /// Stretch and force of a contact, each with its rounding scale. `norm` is the rounding scale of the twist, m ([`Self::size_of_motion`]), which
    /// the caller computes once for all contacts. `largest` is the largest force of the grasp, N.
    #[inline]
    pub(crate) fn at_moved<'s>(
        &self,
        (contact, force): (usize, &'s SVector<f64, 3>),
        twist: &Vector,
        norm: f64,
        largest: f64,
    ) -> SpringState<'s> {
        let span = self.sites[contact].span_moved(&self.offsets[contact], norm);
        SpringState { stretch: self.stretch(contact, twist), force, span, largest }
    }

    /// The norm of the imbalance `Σ G_i F_i + W` of the contact forces F_i with grasp maps G_i and the load W. Also the sum of the norms |F_i|,
    /// without the norm of the load.
    pub(crate) fn imbalance(&self, forces: &[SVector<f64, 3>]) -> (f64, f64) {
        let Imbalance { left, size } = Imbalance::of(self.sites, forces, &self.wrench, 0.0);
        (left.norm(), size)
    }
}
