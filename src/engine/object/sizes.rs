//! Sizes of a scene that scale the rounding of forces and displacements.

use crate::numerics::IntoList;
use nalgebra::SVector;

use super::newton::Imbalance;
use super::problem::Problem;
use super::solution::PieceState;
use super::tolerances::NO_FORCE;
use crate::contact::SpringState;
use crate::grasp::Site;
use crate::numerics::Vector;
use crate::prelude::*;

/// The least force that a spring of the scene could have from displacements of these sizes, contact by contact.
pub(crate) fn least_spring_force(sites: &[Site], spans: impl Iterator<Item = f64>) -> f64 {
    sites.iter().zip(spans).map(|(site, span)| site.springs.softest() * span).fold(f64::INFINITY, f64::min)
}

/// Size of the largest force of a scene.
pub(crate) fn largest_force(
    sites: &[Site],
    offsets: &[SVector<f64, 3>],
    twist: &Vector,
    load: f64,
    forces: impl Iterator<Item = f64>,
) -> f64 {
    let largest = forces.fold(load, f64::max);
    // The least force is at most the first one, which mostly shows that it is too small to matter.
    let least_of = |count: usize| {
        let norm = twist.norm();
        let spans = sites.iter().zip(offsets).map(|(site, a)| site.span_moved(a, norm));
        NO_FORCE * least_spring_force(&sites[..count], spans)
    };
    if least_of(1) <= largest { largest } else { largest.max(least_of(sites.len())) }
}

impl Problem<'_> {
    /// Size of the largest force of the scene with these forces and this twist.
    pub(crate) fn largest_force(&self, forces: &[SVector<f64, 3>], twist: &Vector) -> f64 {
        let sizes = forces.iter().map(nalgebra::Matrix::norm);
        largest_force(self.sites, &self.offsets, twist, self.wrench.norm(), sizes)
    }

    /// The size that scales the rounding of each force, for a state with these offsets under a load of this size.
    pub(crate) fn force_sizes(&self, offsets: &[SVector<f64, 3>], load: f64, state: &PieceState) -> Vec<f64> {
        let norms = state.forces.iter().map(nalgebra::Matrix::norm);
        let largest = largest_force(self.sites, offsets, &state.twist, load, norms);
        let norm = state.twist.norm();
        let spans = self.sites.iter().zip(offsets).map(|(site, offset)| site.span_moved(offset, norm));
        let sites = self.locals().zip(&state.forces).zip(spans);
        sites.map(|((local, force), span)| local.force_size(force, span, largest)).list()
    }

    /// Size of the displacements at a contact.
    #[inline]
    pub(crate) fn span(&self, contact: usize, twist: &Vector) -> f64 {
        self.sites[contact].span(&self.offsets[contact], twist)
    }

    /// Stretch, force and sizes of a contact, for its conditions.
    pub(crate) fn at<'s>(
        &self,
        contact: usize,
        force: &'s SVector<f64, 3>,
        twist: &Vector,
        largest: f64,
    ) -> SpringState<'s> {
        self.at_moved((contact, force), twist, twist.norm(), largest)
    }

    /// [`Self::at`] of a twist with a known norm, for loops over many contacts.
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

    /// `|Σ G_i F_i + W|` and `Σ |F_i|`.
    pub(crate) fn imbalance(&self, forces: &[SVector<f64, 3>]) -> (f64, f64) {
        let Imbalance { left, size } = Imbalance::of(self.sites, forces, &self.wrench, 0.0);
        (left.norm(), size)
    }
}
