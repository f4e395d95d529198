//! The point on a load path from which on the theory of small motions no longer applies: some motion is too large, a suction cup leaks, the grasp
//! buckles, or the object turns over. A leg is a section of the load program; at rest means in the equilibrium from which the path starts.

use super::event::{Event, PathEnd};
use super::following::AnyPath;
use super::path::LoadPath;
use super::small_motions::EndOfSmallMotions;
use crate::equilibrium::TooFar;
use crate::grasp::Wrench;
use crate::numerics::IntoList;
use crate::numerics::tolerances::NEGLIGIBLE;
use crate::prelude::*;

impl<const C: usize> LoadPath<'_, C> {
    /// The point, on the part of the path followed so far, from which on the answers say little about the object. There a motion is no longer small,
    /// a suction cup leaks ([`Self::end_of_small_motions`]), the grasp [buckles](TooFar::Buckles), or the object [turns over](TooFar::TurnsOver).
    /// The last two are checked at rest, at the end of each leg and of the path, and just before contacts slide, wherever the points of action of
    /// the load are known. So are motions that finite rotations make larger than small ones. The point at which they begin is then found to nine digits.
    #[must_use]
    pub fn end_of_theory(&self) -> Option<EndOfSmallMotions> {
        self.end_of_theory_before(self.end_of_small_motions())
    }

    /// [`Self::end_of_theory`], with the point `far` at which motions cease to be small.
    pub(crate) fn end_of_theory_before(&self, far: Option<&EndOfSmallMotions>) -> Option<EndOfSmallMotions> {
        end_of_theory(&*self.0, far)
    }
}

/// The point of the path from which on the theory of small motions no longer applies: the point `far` at which motions cease to be small, or an earlier
/// point. There the grasp buckles, the object turns over, or finite rotations carry a motion beyond its limit.
pub(super) fn end_of_theory<const C: usize>(
    path: &dyn AnyPath<C, Event<C>>,
    far: Option<&EndOfSmallMotions>,
) -> Option<EndOfSmallMotions> {
    let end = far.map_or(path.place(), |far| (far.leg, far.fraction));
    // At the point `far` itself the motion is at its limit without finite rotations, too.
    let until = if far.is_some() { (end.0, end.1 * (1.0 - NEGLIGIBLE)) } else { end };
    let before = end_by_turning_forces(path, until).filter(|at| far.is_none() || (at.leg, at.fraction) < end);
    before.or_else(|| far.cloned())
}

/// The places of a path up to the place `end` at which it is asked whether the grasp buckles or the object turns over: rest and the ends of legs. Along a
/// load that turns they lie in between, too. Others lie just before something slides: finite rotations are followed only while nothing slides.
pub(super) fn places<const C: usize, T>(path: &dyn AnyPath<C, T>, end: (usize, f64)) -> Vec<(usize, f64)> {
    let load = |leg: usize, fraction: f64| path.state_at(leg, fraction).map(|state| state.load);
    let turns = |leg: usize, to: f64| {
        let loads = (load(leg, 0.0), load(leg, 0.5 * to), load(leg, to));
        let (Some(first), Some(middle), Some(last)) = loads else { return false };
        let off = middle * 2.0 - first - last;
        let size = |load: &Wrench<C>| load.components().iter().map(|x| x.abs()).sum::<f64>();
        size(&off) > NEGLIGIBLE * (size(&first) + size(&middle))
    };
    let mut places = vec![(0, 0.0)];
    for leg in 0..=end.0 {
        let to = if leg == end.0 { end.1 } else { 1.0 };
        let parts = if turns(leg, to) { PARTS_OF_A_TURN } else { 1 };
        (1..=parts).map(|k| (leg, to * f64::from(k) / f64::from(parts))).append_to(&mut places);
    }
    for (leg, fraction) in path.sticks_until() {
        let last = (leg, fraction * (1.0 - NEGLIGIBLE));
        if fraction < 1.0 && last < end {
            places.insert(places.partition_point(|place| *place < last), last);
        }
    }
    places.dedup();
    places
}

/// The point of the path, to nine digits, from which on the grasp buckles, the object turns over, or finite rotations make a motion too large. All are
/// checked at the [`places`] of the path, wherever the points of action of the load are known. Up to `end` the motions of small rotations are within
/// their limits.
fn end_by_turning_forces<const C: usize>(
    path: &dyn AnyPath<C, Event<C>>,
    end: (usize, f64),
) -> Option<EndOfSmallMotions> {
    let places = places(path, end);
    let ends_theory = |place: &(usize, f64)| {
        let too_far = path.state_at(place.0, place.1).and_then(|state| state.too_far);
        too_far.filter(|what| !matches!(what, TooFar::Leaks { .. }))
    };
    let (first, mut what) =
        places.iter().enumerate().find_map(|(first, place)| Some((first, ends_theory(place)?)))?;
    let (leg, mut to) = places[first];
    let mut from = match first.checked_sub(1).map(|before| places[before]) {
        None => to,
        Some((before, fraction)) if before == leg => fraction,
        Some(_) => 0.0,
    };
    while to - from > NEGLIGIBLE * to && to > NEGLIGIBLE {
        let middle = 0.5 * (from + to);
        match ends_theory(&(leg, middle)) {
            Some(why) => (to, what) = (middle, why),
            None => from = middle,
        }
    }
    // At a loss of equilibrium contacts without a force no longer resist some motion. The loss says more than that the object turns over there.
    let loss = path.end().and_then(PathEnd::loss).filter(|loss| what == TooFar::TurnsOver && loss.leg == leg);
    let is_loss = loss.is_some_and(|loss| from >= loss.fraction * (1.0 - AT_THE_LOSS));
    (!is_loss).then_some(EndOfSmallMotions { leg, fraction: from, what })
}

/// An object that begins to turn over within this part of the load before a loss of equilibrium is lost there. If smaller, rounding of contact forces
/// that vanish at the loss is taken for turning over; if larger, the end of the path is a little less safe than it says.
const AT_THE_LOSS: f64 = 1e-6;

/// Number of parts into which a leg with a turning load is divided; buckling is checked at the end of each part. With fewer parts, a range of angles
/// in which the grasp buckles could be missed; with more parts, answers about turning loads take longer.
const PARTS_OF_A_TURN: u32 = 36;
