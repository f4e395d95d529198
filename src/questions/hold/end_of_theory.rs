//! The place on a load path from which on the theory of small motions no longer applies: some motion is too large, or the grasp buckles.

use super::left_out::{forces_in, is_open_in};
use crate::equilibrium::TooFar;
use crate::grasp::{Engine, Wrench};
use crate::load_path::{EndOfSmallMotions, LoadPath, PathEnd};
use crate::numerics::tolerances::NEGLIGIBLE;

/// A leg of the path, from 0, and the fraction of it that is done.
type Place = (usize, f64);

impl Engine {
    /// The place from which on the theory no longer applies, if it comes before a loss of equilibrium. `load` is the load at a place. Whether the grasp
    /// buckles is asked only if it [may](Self::may_buckle) under the whole load.
    pub(super) fn end_of_theory(
        &self,
        path: &LoadPath<'_, 3>,
        load: &dyn Fn(Place) -> Wrench<3>,
    ) -> Option<EndOfSmallMotions> {
        let far = end_before_loss(path);
        let end = far.map_or(path.place(), |far| (far.leg, far.fraction));
        let buckles = |place: &Place| {
            let state = path.state_at(place.0, place.1);
            state.is_some_and(|state| self.buckles(&forces_in(&state), &is_open_in(&state), &load(*place)))
        };
        let buckling = if self.may_buckle(&load((0, 1.0))) { buckling(end, &buckles) } else { None };
        buckling.filter(|at| (at.leg, at.fraction) < end).or_else(|| far.cloned())
    }
}

/// The place, to nine digits, from which on the grasp `buckles`. It is asked at rest, under the whole load and at the place `end`. `None` if the
/// grasp buckles at none of these.
fn buckling(end: Place, buckles: &dyn Fn(&Place) -> bool) -> Option<EndOfSmallMotions> {
    let mut places = vec![(0, 0.0), (0, 1.0), end];
    places.retain(|place| *place <= end);
    places.dedup();
    let first = places.iter().position(buckles)?;
    let (leg, mut to) = places[first];
    let mut from = if first == 0 { to } else { 0.0 };
    while to - from > NEGLIGIBLE * to {
        let middle = 0.5 * (from + to);
        *(if buckles(&(leg, middle)) { &mut to } else { &mut from }) = middle;
    }
    Some(EndOfSmallMotions { leg, fraction: from, what: TooFar::Buckles })
}

/// The end of small motions, if it comes before the loss of equilibrium by more than rounding, or if there is no loss; else `None`.
fn end_before_loss<'p>(path: &'p LoadPath<'_, 3>) -> Option<&'p EndOfSmallMotions> {
    let loss = path.end().and_then(PathEnd::loss);
    let before = |far: &&EndOfSmallMotions| {
        loss.is_none_or(|loss| (far.leg, far.fraction) < (loss.leg, loss.fraction * (1.0 - NEGLIGIBLE)))
    };
    path.end_of_small_motions().filter(before)
}
