//! One contact on its way along a leg, in energy coordinates, with the conditions of its law.
//!
//! A contact in a fixed state responds to the motion y of the object by
//!
//! ```text
//! x = P u,     u = x⁰ + τ x⁰' - m - Q y
//! ```
//!
//! x⁰ + τ x⁰' is the elastic trial state on the way along a leg, m the slip so far, and P the projection of the state: the identity for a sticking
//! contact, zero for an open one; for a sliding one it projects onto its facet or its corner of the cone.

use nalgebra::{SMatrix, SVector};

use super::active_set::{Bound, FacetsReached};
use crate::contact::{Mode, PolygonState, WEIGHTLESS, ZERO_SLACK};
use crate::numerics::Vector;
use crate::object::{EnergyContact, Facet, Point, Slipping, Sums, normal};

/// A contact on its way. With a hundred thousand contacts memory access dominates an event: each contact fills two cache lines of its own in the
/// plane and four in space.
#[derive(Debug, Clone)]
#[repr(align(64))]
pub(super) struct MovingContact<const C: usize> {
    pub(super) fixed: EnergyContact<C>,
    /// x⁰ at the beginning of the leg.
    pub(super) trial: SVector<f64, C>,
    /// x⁰', from the beginning to the end of the leg.
    pub(super) rate: SVector<f64, C>,
    /// m, without a normal component.
    pub(super) memory: SVector<f64, C>,
    /// |Q|.
    width: f64,
    pub(super) state: PolygonState,
    /// Queue entries with another number are outdated.
    pub(super) stamp: u32,
    /// Whether the contact is queued for its bounds.
    pub(super) waits: bool,
}

/// Sum of the sizes of the entries.
pub(super) fn size<const C: usize>(felt: &SVector<f64, C>) -> f64 {
    felt.lp_norm(1)
}

/// The row of a facet seen through a state: `row·x` as a function of u.
fn through<const C: usize>(
    state: PolygonState,
    facets: &[Facet<C>],
    row: &SVector<f64, C>,
) -> SVector<f64, C> {
    match state {
        Mode::Sticking => *row,
        Mode::Facet(j) => {
            let own = &facets[usize::from(j)];
            row - own.row * own.column().dot(row)
        }
        Mode::Open | Mode::Corner(_) => SVector::zeros(),
    }
}

/// The facets on which a sliding contact slips.
fn slipping<const C: usize>(state: PolygonState, facets: &[Facet<C>]) -> Slipping<C> {
    Slipping::new(state.own_facets(facets.len()).map(|facet| facet.map(|j| &facets[j])))
}

/// Visits the slips `f·u >= 0` of a state, at least one if it slides.
pub(super) fn for_each_slip<const C: usize>(
    state: PolygonState,
    facets: &[Facet<C>],
    mut visit: impl FnMut(&SVector<f64, C>),
) {
    if state.slides() {
        let slipping = slipping(state, facets);
        (0..slipping.count).for_each(|a| visit(&-slipping.slip(a)));
    }
}

impl<const C: usize> MovingContact<C> {
    /// A contact that sticks.
    pub(super) fn new(fixed: EnergyContact<C>) -> Self {
        let (zero, width) = (SVector::zeros(), fixed.seen.norm());
        let [trial, rate, memory] = [zero; 3];
        Self { fixed, trial, rate, memory, width, state: Mode::Sticking, stamp: 0, waits: false }
    }

    /// u.
    pub(super) fn stretch(&self, y: &Vector, tau: f64) -> SVector<f64, C> {
        self.trial + self.rate * tau - self.memory - &self.fixed.seen * y
    }

    /// u' for a rate of y.
    pub(super) fn stretch_rate(&self, y_rate: &Vector) -> SVector<f64, C> {
        self.rate - &self.fixed.seen * y_rate
    }

    /// Change of u along a direction of the path.
    pub(super) fn change_along(&self, e: &Point, pace: f64) -> SVector<f64, C> {
        self.rate * (e.s / pace) - &self.fixed.seen * &e.y
    }

    /// Size of the terms that u is the sum of.
    pub(super) fn level(&self, stretch: &SVector<f64, C>, travel: f64) -> f64 {
        self.trial.amax() + self.rate.amax() + self.memory.amax() + stretch.amax() + self.width * travel
    }

    /// Size of the terms that u' is the sum of.
    pub(super) fn rate_level(&self, travel_rate: f64) -> f64 {
        self.rate.amax() + self.width * travel_rate
    }

    /// An upper bound of the gradient of `f·u` in y and the time along the leg, in a unit of
    /// `1/pace`.
    pub(super) fn steepest(&self, felt: &SVector<f64, C>, pace: f64) -> f64 {
        felt.norm() * self.width + felt.dot(&self.rate).abs() / pace
    }

    /// P; `None` if it is the identity.
    pub(super) fn hold(&self, facets: &[Facet<C>]) -> Option<SMatrix<f64, C, C>> {
        match self.state {
            Mode::Sticking => None,
            Mode::Open => Some(SMatrix::zeros()),
            sliding => Some(slipping(sliding, facets).hold()),
        }
    }

    /// x for a stretch u.
    pub(super) fn force(&self, stretch: &SVector<f64, C>, facets: &[Facet<C>]) -> SVector<f64, C> {
        self.hold(facets).map_or(*stretch, |hold| hold * stretch)
    }

    /// Adds the terms of the contact to T, b and b', multiplied by `weight`.
    pub(super) fn add_to(&self, sums: &mut Sums<2>, facets: &[Facet<C>], weight: f64) {
        let hold = self.hold(facets);
        let pushed = match &hold {
            None => [-self.memory, SVector::zeros()],
            Some(hold) => [hold * (self.trial - self.memory) - self.trial, hold * self.rate - self.rate],
        };
        sums.add(&self.fixed.seen, hold.as_ref(), Some(pushed), weight);
    }

    /// Adds the slip up to here to memory: u becomes x, and u of an open contact keeps its gap.
    pub(super) fn remember(&mut self, stretch: &SVector<f64, C>, facets: &[Facet<C>]) {
        let x = self.force(stretch, facets);
        for axis in 1..C {
            self.memory[axis] += stretch[axis] - x[axis];
        }
    }

    /// Visits the conditions `f·u >= 0` that bound the way of a contact in its state.
    pub(super) fn for_each_bound(&self, facets: &[Facet<C>], mut visit: impl FnMut(Bound, &SVector<f64, C>)) {
        let state = self.state;
        match state {
            Mode::Open => visit(Bound::Apex, &-normal::<C>()),
            Mode::Sticking => {
                for (j, facet) in (0..).zip(facets) {
                    visit(Bound::Facet(j), &facet.row);
                }
                if facets.is_empty() && self.fixed.gap {
                    visit(Bound::Apex, &normal());
                }
            }
            // The facets on both sides of the one on which the contact slides: all meet at the apex.
            Mode::Facet(j) if C == 3 => {
                for k in [self.facet_after(j), self.facet_before(j)] {
                    let felt = through(state, facets, &facets[usize::from(k)].row);
                    visit(Bound::Facet(k), &felt);
                }
            }
            Mode::Facet(_) | Mode::Corner(_) => visit(Bound::Apex, &normal()),
        }
    }

    fn facet_after(&self, j: u16) -> u16 {
        if j + 1 < self.fixed.facet_count { j + 1 } else { 0 }
    }

    fn facet_before(&self, j: u16) -> u16 {
        if j > 0 { j - 1 } else { self.fixed.facet_count - 1 }
    }

    /// The active set of the contact at the present place of the path.
    pub(super) fn stand(
        &self,
        contact: u32,
        stretch: &SVector<f64, C>,
        level: f64,
        facets: &[Facet<C>],
    ) -> FacetsReached<C> {
        let mut stand = FacetsReached::nowhere(contact, self.state, self.memory);
        if facets.is_empty() && !self.fixed.gap {
            return stand;
        }
        let state = self.state;
        match state {
            Mode::Facet(j) => stand.reach(Bound::Facet(j)),
            Mode::Corner(j) => {
                stand.reach(Bound::Facet(j));
                stand.reach(Bound::Facet(self.facet_after(j)));
            }
            Mode::Open | Mode::Sticking => {}
        }
        self.for_each_bound(facets, |bound, felt| {
            if felt.dot(stretch) <= ZERO_SLACK * size(felt) * level {
                stand.reach(bound);
            }
        });
        if !self.state.is_open() && self.force(stretch, facets).norm() <= WEIGHTLESS * level {
            stand.apex = true;
        }
        stand
    }

    /// Margin of the rates u' within the law of rates in a state, at the condition that they violate most, relative to u'. A contact on no edge has
    /// no conditions, one on facets has those of the facets, and one at the apex its whole law.
    pub(super) fn margin(
        &self,
        stand: &FacetsReached<C>,
        state: PolygonState,
        stretch_rate: &SVector<f64, C>,
        facets: &[Facet<C>],
    ) -> f64 {
        let mut least = f64::INFINITY;
        let mut note = |felt: &SVector<f64, C>| least = least.min(felt.dot(stretch_rate) / felt.amax());
        for_each_slip(state, facets, &mut note);
        if stand.apex && self.fixed.gap {
            note(&if state.is_open() { -normal::<C>() } else { normal() });
        }
        let mut note_facet = |j: u16| {
            if Mode::Facet(j) != state {
                let felt = through(state, facets, &facets[usize::from(j)].row);
                if felt.amax() > 0.0 {
                    note(&felt);
                }
            }
        };
        if stand.apex {
            (0..self.fixed.facet_count).for_each(&mut note_facet);
            // Without a gap row the cone itself requires a growing normal force.
            if !facets.is_empty() && self.state.slides() && !self.fixed.gap {
                note(&normal());
            }
        } else {
            stand.facets().iter().copied().for_each(&mut note_facet);
        }
        least
    }

    /// The state in which the law of rates responds to u': the first that violates no condition, or the one that violates them least.
    pub(super) fn answer(
        &self,
        stand: &FacetsReached<C>,
        stretch_rate: &SVector<f64, C>,
        facets: &[Facet<C>],
    ) -> PolygonState {
        let mut best = (Mode::Sticking, f64::NEG_INFINITY);
        let mut consider = |state: PolygonState| {
            if best.1 < 0.0 {
                let margin = self.margin(stand, state, stretch_rate, facets);
                if margin > best.1 {
                    best = (state, margin);
                }
            }
        };
        consider(Mode::Sticking);
        if stand.apex {
            let all = 0..self.fixed.facet_count;
            if self.fixed.gap {
                consider(Mode::Open);
            }
            all.clone().map(Mode::Facet).for_each(&mut consider);
            all.filter(|_| C == 3).map(Mode::Corner).for_each(&mut consider);
        } else {
            stand.facets().iter().copied().map(Mode::Facet).for_each(&mut consider);
            if let Some(corner) = self.corner_of(stand) {
                consider(corner);
            }
        }
        best.0
    }

    /// The corner between the two facets of the active set.
    fn corner_of(&self, stand: &FacetsReached<C>) -> Option<PolygonState> {
        let [a, b] = *stand.facets() else { return None };
        if self.facet_after(a) == b {
            Some(Mode::Corner(a))
        } else {
            (self.facet_after(b) == a).then_some(Mode::Corner(b))
        }
    }

    /// The usual continuation: a contact on an edge slides along it, one without force opens, one without a gap sticks.
    pub(super) fn guess(&self, stand: &FacetsReached<C>) -> PolygonState {
        match *stand.facets() {
            _ if stand.apex && self.state.is_open() => Mode::Sticking,
            _ if stand.apex && self.fixed.gap => Mode::Open,
            [j] if !stand.apex => Mode::Facet(j),
            [_, _] if !stand.apex => self.corner_of(stand).unwrap_or(self.state),
            _ => self.state,
        }
    }
}
