//! The trial of one amount (of squeeze, friction, load, arm or angle): the grasp with this amount set, and the verdicts on its loads. The carried
//! part of a load is the load factor up to which the demand is met: that the object is held, or that nothing slides. At rest means under the loads
//! that act before the loads of the question. An amount is sufficient if the demand is met with it under every load; the bound is the least or
//! greatest sufficient amount. A ramp is a load that grows in proportion to a load factor, in addition to the load at rest. At first slip the first
//! contact ceases to stick. Motions are small within the limits up to which the linear theory is trusted.

use alloc::sync::Arc;
use core::fmt;

use super::checked_need::{CheckedNeed, SafetyDeviations, Sought};
use super::question::Demand;
use super::tolerances::MOST_LOADS;
use super::trial::{NOT_AT_REST, RefutingLoads, Trial, Trials};
use crate::ask::Grasp;
use crate::contact::State;
use crate::equilibrium::{Proof, Settings, TooFar};
use crate::error::Error;
use crate::grasp::Wrench;
use crate::hold::{Holding, LossVerb, PathFacts, Verdict, VerdictScope};
use crate::load_path::{Leg, Onset, PathEnd, Ramp, Turn};
use crate::numerics::{IntoList, mapped};
use crate::prelude::*;
use crate::squeeze::Loads;
use crate::words::Words;

/// A grasp with a trial amount set, and the loads that it has to bear, with a common factor.
pub(super) struct Loading {
    pub(super) grasp: Grasp<3>,
    pub(super) loads: Loads<3>,
    /// The load at rest, which acts before the other loads. The factor `times` does not apply to it.
    pub(super) base: Wrench<3>,
    /// Factor by which the loads are multiplied.
    pub(super) times: f64,
    pub(super) words: Words,
    /// Load paths are followed up to this multiple of the load.
    pub(super) followed: f64,
    /// How far a trial follows load paths, and which fields of a verdict it computes.
    pub(super) extent: VerdictScope,
    /// Whether the amount with which nothing slides is sought only in addition to the amount that holds the object. The load factor of first slip
    /// then suffices as the reason why an amount is insufficient.
    is_beside: bool,
    /// If a link cannot have its tension at rest, the reason in a sentence. The amount is then insufficient.
    refused: Option<String>,
}

impl Loading {
    /// The grasp and the loads with `amount` of the sought quantity. Friction and squeeze are reduced and loads enlarged by `safety`.
    pub(super) fn of(
        grasp: &Grasp<3>,
        need: &CheckedNeed,
        amount: f64,
        safety: SafetyDeviations,
    ) -> Result<Self, Error> {
        let (friction, squeeze) = (1.0 - safety.lower[0], 1.0 - safety.lower[1]);
        let (mut times, mut base, mut loads) = (safety.load, need.base, need.loads.clone());
        let squeeze = if need.sought == Sought::Squeeze { squeeze * amount } else { squeeze };
        let mut grasp = if squeeze == 1.0 { grasp.clone() } else { grasp.not_installed_squeezed(squeeze)? };
        match &need.sought {
            Sought::Squeeze => {}
            Sought::Overlaps => grasp = grasp.with_overlaps(amount * (1.0 - safety.lower[1]))?,
            Sought::Friction { contacts } => {
                let is_meant =
                    |i: usize, mu: f64| contacts.as_ref().map_or(mu > 0.0, |those| those.contains(&i));
                grasp =
                    grasp.not_installed_with_friction(&|i, mu| if is_meant(i, mu) { amount } else { mu })?;
            }
            Sought::Load => times *= amount,
            Sought::Arm { at, per_metre } => loads = (*at + *per_metre * amount).into(),
            Sought::Angle { turn } => loads = Loads::Turn(turn.up_to(amount)),
            Sought::Force { of: Some(part) } => grasp = grasp.scaled(part, amount)?.1,
            Sought::Force { of: None } => base = base * amount,
        }
        let grasp = if friction == 1.0 {
            grasp
        } else {
            grasp.not_installed_with_friction(&|_, mu| friction * mu)?
        };
        let (grasp, refused) = match grasp.clone().installed_again() {
            Err(Error::Link { name, value, .. }) => {
                let tension = need.words.number(value);
                (grasp, Some(format!("DOES NOT HOLD even at rest the tension of {name}, {tension} N")))
            }
            installed => (installed?, None),
        };
        // If the grasp holds the load with this amount, the load grows further, up to this multiple. From the multiple at the loss the search
        // estimates how far the amount is from the bound of the sufficient amounts. A larger limit makes load paths longer; only for a squeeze does
        // it improve the estimates.
        let followed = match need.sought {
            Sought::Load => MOST_LOADS / amount.max(1.0),
            Sought::Squeeze => 32.0,
            _ => 2.0,
        };
        let grasp = grasp.with(&grasp.settings().with_most_load(followed.max(1.0)));
        let (words, is_beside) = (need.words, need.demand == Demand::Held);
        let extent = VerdictScope::Measured;
        Ok(Self { grasp, loads, base, times, words, followed, extent, is_beside, refused })
    }

    /// The loads that contact forces must balance if the amount is to be sufficient: the load at rest, and its sum with each load. A force of any
    /// direction is taken along both senses of each axis, a turning load at nine angles.
    pub(super) fn to_balance(&self) -> Vec<Wrench<3>> {
        let mut list = vec![self.base];
        match &self.loads {
            Loads::Each(loads) => list.extend(mapped(loads, &|load| self.base + *load * self.times)),
            Loads::AnyForce { base, size, point } => {
                for k in 0..2 * self.grasp.space().axes() {
                    let mut force = [0.0; 3];
                    force[k / 2] = if k.is_multiple_of(2) { size * self.times } else { -size * self.times };
                    list.push(self.base + *base * self.times + force_at(force, *point));
                }
            }
            Loads::Turn(turn) => {
                let turn = self.multiplied_turn(turn);
                // Each of these angles gives a load that may exclude amounts, because contact forces cannot balance it. With fewer angles fewer
                // amounts would be excluded.
                let parts = 8_u32;
                list =
                    (0..=parts).map(|k| turn.load_at(turn.angle() * f64::from(k) / f64::from(parts))).list();
            }
        }
        list
    }

    /// This loading with load paths that end once the whole load acts.
    pub(super) fn short(mut self) -> Self {
        self.followed = 1.0;
        self.grasp = self.grasp.with(&self.grasp.settings().with_most_load(1.0));
        self
    }

    /// This loading with trials that skip the enumeration of contact states at rest. Searches for an equilibrium at rest begin near the contact
    /// states `near`.
    pub(super) fn quick(mut self, near: Vec<State>) -> Self {
        self.extent = VerdictScope::Decided;
        self.grasp = self.grasp.with(&Settings { is_quick: true, ..*self.grasp.settings() });
        if !near.is_empty() {
            Arc::make_mut(&mut self.grasp.engine).near = near;
        }
        self
    }

    /// Determines whether the grasp meets the demand with this amount. The load or directions with which earlier amounts were insufficient, stored in
    /// `refuting`, are applied first. A load that is not carried, or else the load carried least, is stored in `refuting`.
    pub(super) fn put_on(&self, demand: Demand, refuting: &RefutingLoads) -> Result<Trials, Error> {
        if let Some(refused) = &self.refused {
            return Ok(Trials::only(demand, Trial::insufficient(refused, NOT_AT_REST)));
        }
        if demand.repeats() {
            return Ok(Trials::only(demand, self.again_and_again(demand)?));
        }
        let (besides, times) = (self.base, self.times);
        Ok(match &self.loads {
            Loads::Each(loads) => {
                let ramps: Vec<_> = mapped(loads, &|load| Ramp::load(besides, *load * times));
                self.all(&ramps, demand, refuting)?
            }
            Loads::AnyForce { base, size, point } => {
                self.any_force(*base * times, (*size * times, *point), demand, refuting)?
            }
            Loads::Turn(turn) => Trials::only(demand, self.turn(&self.multiplied_turn(turn), demand)?),
        })
    }

    /// The turning load with its constant, cosine and sine parts multiplied by `times`, plus the load at rest.
    pub(super) fn multiplied_turn(&self, turn: &Turn<3>) -> Turn<3> {
        let ([constant, cosine, sine], times) = (turn.parts(), self.times);
        Turn::new(self.base + constant * times, cosine * times, sine * times).up_to(turn.angle())
    }

    /// The worst result over the loads of all these ramps (loads that each grow in proportion to a load factor). The loop over the ramps ends at the
    /// first load that is not carried.
    fn all(&self, ramps: &[Ramp<3>], demand: Demand, refuting: &RefutingLoads) -> Result<Trials, Error> {
        let (mut held, mut sticks, mut kinds, mut jumps) = (Trial::always(), Trial::always(), None, false);
        let mut is_unbalanced = false;
        let (mut weakest, mut least) = (refuting.first.get(), f64::INFINITY);
        for k in 0..ramps.len() {
            let which = (refuting.first.get() + k) % ramps.len();
            if demand == Demand::Sticks {
                let ramp = &ramps[which];
                let slip = self.said_of(which, &ramp.direction, self.first_slip(ramp)?);
                // A negative `part` means that the grasp does not hold at rest. It then has no first slip, and the reason is taken from the verdict
                // below.
                let is_enough = self.is_beside && slip.carried().is_some_and(|part| part >= 0.0);
                let is_told = self.grasp.settings().is_quick || is_enough;
                if let (Trial::Insufficient { .. }, true) = (&slip, is_told) {
                    refuting.first.set(which);
                    return Ok(Trials::only(demand, sticks.or_worse(slip)));
                }
                if self.grasp.settings().is_quick {
                    sticks = sticks.or_worse(slip);
                    continue;
                }
            }
            let (verdict, path) = self.put_on_up_to(&ramps[which], held.carried())?;
            (kinds, jumps) = (path.at_rest, jumps || path.jumps > 0);
            is_unbalanced = is_unbalanced || is_proved_by_a_motion(&verdict.holding);
            let of_this = |trial| self.said_of(which, &ramps[which].direction, trial);
            held = held.or_worse(of_this(self.judged((&verdict, 1.0 - path.farthest), Demand::Held)));
            let at_rest = self.grasp.sticking_margin(&verdict.base).unwrap_or(f64::INFINITY);
            sticks = sticks.or_worse(of_this(self.judged((&verdict, at_rest), Demand::Sticks)));
            if let Some(carried) = held.carried().filter(|carried| *carried < least) {
                (weakest, least) = (which, carried);
            }
            let wanted = if demand == Demand::Sticks { &sticks } else { &held };
            if let Trial::Insufficient { .. } = wanted {
                refuting.first.set(which);
                // The remaining loads are not tried. If this load is not held, it is known that not all loads are held. If it is held, but a contact
                // slides under it, it is not known whether the remaining loads are held: `held` is `None` unless none remain.
                let held = (!held.is_sufficient() || k + 1 == ramps.len()).then_some(held);
                return Ok(Trials { held, sticks: Some(sticks), at_rest: kinds, is_unbalanced, jumps });
            }
        }
        let is_held = !(self.grasp.settings().is_quick && demand == Demand::Sticks);
        refuting.first.set(weakest);
        Ok(Trials {
            held: is_held.then_some(held),
            sticks: Some(sticks),
            at_rest: kinds,
            is_unbalanced,
            jumps,
        })
    }

    /// The least fraction [`Verdict::left_out`] of the springs' resistance under these loads; `None` if none is below zero, and for a force of any
    /// direction.
    pub(super) fn left_out(&self) -> Result<Option<f64>, Error> {
        let loads = match &self.loads {
            Loads::Each(loads) => loads.clone(),
            Loads::Turn(turn) => vec![turn.load_at(turn.angle())],
            Loads::AnyForce { .. } => Vec::new(),
        };
        let (mut least, grasp) = (0.0_f64, self.grasp.with(&self.grasp.settings().with_most_load(1.0)));
        for load in loads {
            let verdict = grasp.hold(Ramp::load(self.base, load * self.times))?;
            least = least.min(verdict.left_out.unwrap_or(0.0));
        }
        Ok((least < 0.0).then_some(least))
    }

    /// The verdict on a ramp, and data of its load path: the number of jumps, the largest motion relative to its limit, and the equilibrium at rest.
    /// The path is followed only up to `least`, the multiple up to which another load is carried, because only the load carried least matters.
    pub(super) fn put_on_up_to(
        &self,
        ramp: &Ramp<3>,
        least: Option<f64>,
    ) -> Result<(Verdict<3>, PathFacts), Error> {
        let most = least.unwrap_or(self.followed).clamp(1.0, self.followed);
        self.grasp.with(&self.grasp.settings().with_most_load(most)).hold_to_an_extent(ramp, self.extent)
    }

    /// The trial of whether everything sticks while the load grows along this ramp. The load factor of first slip decides it, so no verdict is
    /// computed.
    fn first_slip(&self, ramp: &Ramp<3>) -> Result<Trial, Error> {
        let onset = self.grasp.onset(ramp)?;
        let factor = match &onset {
            Onset::At(event) => event.factor,
            Onset::GivesWay { factor, .. } => *factor,
            Onset::Never => f64::INFINITY,
            Onset::AlreadySliding(_) => 0.0,
            Onset::NoBase(_) => NOT_AT_REST,
            Onset::Undecided(undecided) => return Ok(Trial::Unknown(self.said(undecided))),
        };
        let other = self.grasp.sticking_margin(&ramp.base).unwrap_or(f64::INFINITY);
        Ok(if factor > 1.0 {
            Trial::Sufficient { carried: factor, other }
        } else {
            let first = self.grasp.engine.first_slip(&onset, &[], None);
            let says = first.map_or_else(|| self.said(&onset), |first| self.said(&first));
            Trial::Insufficient { says, carried: factor, other, is_too_far: false }
        })
    }

    pub(super) fn said(&self, what: &dyn fmt::Display) -> String {
        let digits = self.words.precision();
        format!("{what:.digits$}")
    }

    /// If the question has several loads, adds to the sentence of a trial the number of the load and the load itself. For a force of any direction it
    /// adds the direction.
    pub(super) fn said_of(&self, which: usize, load: &Wrench<3>, mut trial: Trial) -> Trial {
        let Trial::Insufficient { says, .. } = &mut trial else { return trial };
        match &self.loads {
            Loads::Each(list) if list.len() > 1 => {
                *says = format!("under load {}, {}: {says}", which + 1, self.words.load(load));
            }
            Loads::AnyForce { .. } if which > 0 => {
                let along = self.words.along(&load.force_part().normalize());
                *says = format!("under a force along {along}: {says}");
            }
            _ => {}
        }
        trial
    }

    /// The result of a trial, from its verdict. `other` is a second measure of the distance from the bound: positive if the amount is sufficient,
    /// zero at the bound. For [`Demand::Held`] it is 1 less the largest ratio of a motion to its limit of small motions. For [`Demand::Sticks`] it is
    /// the margin of sticking at rest, as a fraction of the largest contact force.
    pub(super) fn judged(&self, (verdict, other): (&Verdict<3>, f64), demand: Demand) -> Trial {
        let sufficient = match demand {
            Demand::Sticks => verdict.sticks(),
            _ => verdict.holds(),
        };
        match sufficient {
            Some(true) => {
                let lost = verdict.lost.as_ref().map(|lost| lost.factor);
                // If the path ended before its limit without a loss, the amount carries at least the load that was reached.
                let held = lost.or((verdict.held_to < self.followed).then_some(verdict.held_to));
                let slides = verdict.first_slip.as_ref().map(|first| first.factor);
                let carried = if demand == Demand::Sticks { slides.or(held) } else { held };
                let carried = carried.map_or(f64::INFINITY, |carried| carried.max(1.0));
                Trial::Sufficient { carried, other }
            }
            Some(false) => {
                let (says, part) = match (&verdict.first_slip, verdict.holds()) {
                    (Some(first), Some(true)) => (self.said(first), first.factor),
                    _ => (self.said(verdict), verdict.held_to),
                };
                let first_slip = verdict.first_slip.as_ref().map_or(part, |first| first.factor);
                let carried = match &verdict.holding {
                    Holding::NoRest { .. } => NOT_AT_REST,
                    // The load at rest is lost at a fraction of its size. The carried part is then negative, but above `NOT_AT_REST`, the value for a
                    // proof that no equilibrium at rest exists.
                    Holding::LostAtRest { at_rest } => {
                        (at_rest.factor - 1.0).clamp(NOT_AT_REST + f64::EPSILON, -f64::EPSILON)
                    }
                    _ if demand == Demand::Sticks => part.min(first_slip),
                    _ => part,
                };
                let lost = verdict.lost.as_ref().filter(|lost| !lost.is_gross_slip);
                let is_too_far = lost.and_then(|lost| lost.too_far.as_ref()).is_some_and(TooFar::is_motion);
                Trial::Insufficient { says, carried, other, is_too_far }
            }
            None => Trial::Unknown(self.said(verdict)),
        }
    }

    fn turn(&self, turn: &Turn<3>, demand: Demand) -> Result<Trial, Error> {
        let engine = &self.grasp.engine;
        let ends_at = |angle: f64, verb: &dyn fmt::Display, why: &dyn fmt::Display| {
            let says = format!("{verb} at {}: {}", self.words.angle(angle), self.said(why));
            Trial::insufficient(says, angle / turn.angle())
        };
        if demand == Demand::Sticks {
            let onset = self.grasp.onset_of_turn(turn)?.onset;
            let first =
                engine.first_slip(&onset, &[], None).map_or_else(String::new, |first| self.said(&first));
            return Ok(match &onset {
                Onset::Never => Trial::always(),
                Onset::Undecided(undecided) => Trial::Unknown(self.said(undecided)),
                Onset::At(event) => {
                    let says = format!("{first} at {}", self.words.angle(event.factor));
                    Trial::insufficient(says, event.factor / turn.angle())
                }
                Onset::GivesWay { factor, reason } => ends_at(*factor, &"GIVES WAY", reason),
                Onset::AlreadySliding(_) => Trial::nothing(format!("{first} before it turns")),
                Onset::NoBase(none) => Trial::insufficient(self.said(none), NOT_AT_REST),
            });
        }
        // The path begins at angle zero, with the load acting in full. If the grasp does not hold this load as it grows from zero, no angle is
        // reached.
        let put_on = self.grasp.hold(turn.load_at(0.0))?;
        if put_on.holds() == Some(false) {
            return Ok(Trial::nothing(self.said(&put_on)));
        }
        let mut path = self.grasp.follow(turn.load_at(0.0), &[Leg::turn(turn)])?;
        path.run_while_small();
        if let Some(end) = path.end_of_theory() {
            let reason = end.what.reason(self.words);
            let why: &dyn fmt::Display = if end.what.is_motion() { &end.what } else { &reason };
            return Ok(ends_at(end.fraction * turn.angle(), &LossVerb::from(&end.what), why));
        }
        Ok(match path.end() {
            Some(PathEnd::Completed) => Trial::always(),
            Some(PathEnd::Lost(loss)) => {
                let lost = engine.lost(loss.fraction, loss, path.state());
                ends_at(loss.fraction * turn.angle(), &lost.verb(self.words), &lost)
            }
            Some(end @ PathEnd::NoStart(_)) => Trial::insufficient(self.said(end), NOT_AT_REST),
            Some(end @ PathEnd::Undecided { .. }) => Trial::Unknown(self.said(end)),
            None => Trial::Unknown("the path has no end".to_owned()),
        })
    }
}

/// Whether a motion proves that no forces of the contacts balance the load at rest.
fn is_proved_by_a_motion(holding: &Holding<3>) -> bool {
    let Holding::NoRest { none, .. } = holding else { return false };
    matches!(none.proof, Proof::SeparatingMotion { .. } | Proof::FreeMotion { .. })
}

/// The wrench of a force (N) at a point (m), with its moment about the origin.
pub(super) fn force_at(force: [f64; 3], point: [f64; 3]) -> Wrench<3> {
    Wrench::force_through(&point.into(), &force.into())
}
