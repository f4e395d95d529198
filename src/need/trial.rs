//! What becomes of one amount of what is sought.

use core::cell::Cell;
use core::f64::consts::{PI, TAU};
use core::fmt;

use super::question::{Demand, Need, Sought};
use crate::ask::Grasp;
use crate::equilibrium::Equilibrium;
use crate::error::Error;
use crate::grasp::Wrench;
use crate::hold::{Holding, Verdict};
use crate::load_path::{Leg, Onset, PathEnd, Ramp, Turn};
use crate::prelude::*;
use crate::squeeze::{Loads, WeakestDirection};
use crate::words::Words;

/// Forces of any direction are put on in so many of them where the object may slide: to tell a loss there is no closed form.
const DIRECTIONS_IN_THE_PLANE: usize = 72;
const DIRECTIONS_IN_SPACE: usize = 200;
/// A force in some direction presses an open contact on, and no closed form compares directions then.
const OPEN: &str = "a contact is open or at its edge before the force acts, and directions are compared only where all of them press";
/// What is carried where what acts at rest has no equilibrium at all.
pub(super) const NOT_AT_REST: f64 = -1.0;

/// What becomes of an amount.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Trial {
    Does,
    DoesNot {
        /// A sentence that says what happens.
        says: String,
        /// The part of the load that is carried until then, below 0 where not even what acts at rest is.
        carried: f64,
    },
    /// A sentence that says why it is not known.
    Unknown(String),
}

impl Trial {
    /// What happens, when nothing of the load is carried.
    fn nothing(says: impl Into<String>) -> Self {
        Self::DoesNot { says: says.into(), carried: 0.0 }
    }

    /// How much of the load is carried: 1 where all of it is.
    pub(super) fn carried(&self) -> f64 {
        match self {
            Self::Does => 1.0,
            Self::DoesNot { carried, .. } => *carried,
            Self::Unknown(_) => NOT_AT_REST,
        }
    }
}

/// Tries an amount, friction and squeeze being less by these parts.
pub(super) fn try_amount<const C: usize>(
    grasp: &Grasp<C>,
    need: &Need<C>,
    amount: f64,
    less: [f64; 2],
) -> Result<Trial, Error> {
    Loading::of(grasp, need, amount, less)?.put_on(need.demand)
}

/// Whether an amount that does turns the object [too far](crate::equilibrium::Equilibrium::is_beyond_small_motions) for that to say much.
pub(super) fn is_far<const C: usize>(grasp: &Grasp<C>, need: &Need<C>, amount: f64) -> Result<bool, Error> {
    let loading = Loading::of(grasp, need, amount, [0.0; 2])?;
    loading.put_on(need.demand)?;
    Ok(loading.far.get())
}

/// Loads that are put on a grasp, so many times as large.
pub(super) struct Loading<const C: usize> {
    pub(super) grasp: Grasp<C>,
    pub(super) loads: Loads<C>,
    /// What acts besides, not so many times as large.
    pub(super) base: Wrench<C>,
    pub(super) times: f64,
    words: Words,
    /// Set where the object turns too far on the way.
    far: Cell<bool>,
}

impl<const C: usize> Loading<C> {
    /// The grasp and its loads with an amount of what is sought, friction and squeeze being less by these parts.
    pub(super) fn of(grasp: &Grasp<C>, need: &Need<C>, amount: f64, less: [f64; 2]) -> Result<Self, Error> {
        let [friction, squeeze] = less.map(|part| 1.0 - part);
        let changed = |squeezed: f64, mu: &dyn Fn(usize, f64) -> f64| {
            let grasp = if squeezed == 1.0 { grasp.clone() } else { grasp.squeezed(squeezed)? };
            let grasp = grasp.with_friction(|i, given| friction * mu(i, given))?;
            Ok::<_, Error>(grasp.with(&grasp.settings().with_most_load(1.0)))
        };
        let given = |_: usize, mu: f64| mu;
        let (grasp, loads, times) = match &need.sought {
            Sought::Squeeze { loads } => (changed(squeeze * amount, &given)?, loads.clone(), 1.0),
            Sought::Friction { loads, contacts } => {
                let is_meant =
                    |i: usize, mu: f64| contacts.as_ref().map_or(mu > 0.0, |those| those.contains(&i));
                let with = |i: usize, mu: f64| if is_meant(i, mu) { amount } else { mu };
                (changed(squeeze, &with)?, loads.clone(), 1.0)
            }
            Sought::Load { loads } => (changed(squeeze, &given)?, loads.clone(), amount),
            Sought::Arm { at, per_metre } => {
                (changed(squeeze, &given)?, Loads::from(*at + *per_metre * amount), 1.0)
            }
            Sought::Angle { turn } => (changed(squeeze, &given)?, Loads::Turn(turn.up_to(amount)), 1.0),
        };
        Ok(Self { grasp, loads, base: need.base, times, words: need.words, far: Cell::new(false) })
    }

    fn put_on(&self, demand: Demand) -> Result<Trial, Error> {
        if demand.repeats() {
            return self.again_and_again(demand);
        }
        let (besides, times) = (self.base, self.times);
        match &self.loads {
            Loads::Each(loads) => {
                let ramps = loads.iter().map(|load| Ramp::load(besides, *load * times));
                self.all(ramps, demand)
            }
            Loads::AnyForce { base, size, point } => {
                let trial = self.any_force(*base * times, *size * times, *point)?;
                match (demand, trial) {
                    (Demand::Held, Trial::DoesNot { .. } | Trial::Unknown(_)) => {
                        let forces = directions::<C>().into_iter().map(|d| {
                            let force = force_at(d.map(|x| x * *size * times), *point);
                            Ramp::load(besides + *base * times, force)
                        });
                        self.all(forces, demand)
                    }
                    (_, trial) => Ok(trial),
                }
            }
            Loads::Turn(turn) => self.turn(&self.so_many(turn), demand),
        }
    }

    /// A turn of loads so many times as large, beside what acts anyway.
    pub(super) fn so_many(&self, turn: &Turn<C>) -> Turn<C> {
        let [constant, cosine, sine] = turn.parts().map(|part| part * self.times);
        Turn::new(self.base + constant, cosine, sine).up_to(turn.angle())
    }

    fn all(&self, ramps: impl Iterator<Item = Ramp<C>>, demand: Demand) -> Result<Trial, Error> {
        let mut unknown = None;
        for ramp in ramps {
            let verdict = self.grasp.hold(ramp)?;
            self.watch(verdict.state.as_deref());
            match self.judged(&verdict, demand) {
                Trial::Does => {}
                trial @ Trial::DoesNot { .. } => return Ok(trial),
                Trial::Unknown(why) => unknown = Some(why),
            }
        }
        Ok(unknown.map_or(Trial::Does, Trial::Unknown))
    }

    pub(super) fn watch(&self, state: Option<&Equilibrium<C>>) {
        self.far.set(self.far.get() || state.is_some_and(Equilibrium::is_beyond_small_motions));
    }

    /// Whether everything sticks under a force of any direction.
    fn any_force(&self, load: Wrench<C>, size: f64, point: [f64; C]) -> Result<Trial, Error> {
        let base = &(self.base + load);
        Ok(match self.grasp.weakest_direction(base, point)? {
            WeakestDirection::Never => Trial::Does,
            WeakestDirection::Force { size: most, .. } if most >= size => Trial::Does,
            WeakestDirection::Force { load, size: most, .. } => {
                let first = self.grasp.hold(Ramp::load(*base, load - *base))?;
                self.watch(first.state.as_deref());
                let who = first.first_slip.map_or_else(|| "it slides".to_owned(), |first| self.said(&first));
                Trial::DoesNot { says: format!("{who} under a force of one direction"), carried: most / size }
            }
            WeakestDirection::GivesWay { .. } => Trial::nothing("nothing resists a force of one direction"),
            WeakestDirection::NotSticking => {
                // Put on, what is not held is told by its path; at rest it would be searched for.
                let put_on = self.grasp.hold(Ramp::load(self.base, load))?;
                match self.judged(&put_on, Demand::Sticks) {
                    Trial::DoesNot { says, carried } => Trial::DoesNot { says, carried: carried - 1.0 },
                    Trial::Does => Trial::Unknown(OPEN.to_owned()),
                    unknown @ Trial::Unknown(_) => unknown,
                }
            }
            WeakestDirection::Undecided => {
                Trial::Unknown("rounding keeps the weakest direction from being told".to_owned())
            }
        })
    }

    pub(super) fn said(&self, what: &impl fmt::Display) -> String {
        let digits = self.words.digits();
        format!("{what:.digits$}")
    }

    fn judged(&self, verdict: &Verdict<C>, demand: Demand) -> Trial {
        let does = match demand {
            Demand::Sticks => verdict.sticks(),
            _ => verdict.holds(),
        };
        match does {
            Some(true) => Trial::Does,
            Some(false) => {
                let (says, part) = match (&verdict.first_slip, verdict.holds()) {
                    (Some(first), Some(true)) => (self.said(first), first.factor),
                    _ => (self.said(verdict), verdict.held_to),
                };
                let first_slip = verdict.first_slip.as_ref().map_or(part, |first| first.factor);
                let carried = match &verdict.holding {
                    Holding::NoRest(_) => NOT_AT_REST,
                    Holding::LostAtRest { at_rest } => at_rest.factor - 1.0,
                    _ if demand == Demand::Sticks => part.min(first_slip),
                    _ => part,
                };
                Trial::DoesNot { says, carried }
            }
            None => Trial::Unknown(self.said(verdict)),
        }
    }

    fn turn(&self, turn: &Turn<C>, demand: Demand) -> Result<Trial, Error> {
        let degrees = |angle: f64| self.words.angle(angle);
        let part_of_it = |says: String, angle: f64| Trial::DoesNot { says, carried: angle / turn.angle() };
        if demand == Demand::Sticks {
            return Ok(match self.grasp.onset_of_turn(turn)?.onset {
                Onset::Never => Trial::Does,
                Onset::Undecided(undecided) => Trial::Unknown(self.said(&undecided)),
                Onset::At(event) => {
                    part_of_it(format!("something slides at {}", degrees(event.factor)), event.factor)
                }
                Onset::GivesWay { factor, .. } => {
                    part_of_it(format!("it gives way at {}", degrees(factor)), factor)
                }
                Onset::AlreadySliding(_) => Trial::nothing("something slides before it turns"),
                Onset::NoBase(none) => Trial::DoesNot { says: self.said(&none), carried: NOT_AT_REST },
            });
        }
        let mut path = self.grasp.follow(&turn.load_at(0.0), &[Leg::turn(turn)])?;
        path.run();
        self.watch(path.state().as_ref());
        Ok(match path.end() {
            Some(PathEnd::Completed) => Trial::Does,
            Some(PathEnd::Lost(loss)) => {
                let angle = loss.fraction * turn.angle();
                part_of_it(format!("it is lost at {}", degrees(angle)), angle)
            }
            Some(end @ PathEnd::NoStart(_)) => Trial::DoesNot { says: self.said(end), carried: NOT_AT_REST },
            Some(end @ PathEnd::Undecided { .. }) => Trial::Unknown(self.said(end)),
            None => Trial::Unknown("the path has no end".to_owned()),
        })
    }
}

/// A force at a point, with its moment about the origin.
pub(super) fn force_at<const C: usize>(force: [f64; C], point: [f64; C]) -> Wrench<C> {
    let wrench = crate::grasp::wrench_of::<crate::numerics::Fixed<6>, C>(&point.into(), &force.into());
    Wrench::among(&wrench)
}

/// Unit vectors all around, evenly: on a circle, or on a spiral over the sphere.
fn directions<const C: usize>() -> Vec<[f64; C]> {
    let count = if C == 2 { DIRECTIONS_IN_THE_PLANE } else { DIRECTIONS_IN_SPACE };
    let golden = PI * (3.0 - 5.0_f64.sqrt());
    let direction = |k: usize| {
        let z = 1.0 - (2 * k + 1) as f64 / count as f64;
        let (radius, angle) = if C == 2 { (1.0, TAU / count as f64) } else { ((1.0 - z * z).sqrt(), golden) };
        let (sin, cos) = (angle * k as f64).sin_cos();
        core::array::from_fn(|a| [radius * cos, radius * sin, z][a])
    };
    (0..count).map(direction).collect()
}
