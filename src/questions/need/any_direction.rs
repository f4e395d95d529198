//! The trial of an amount (such as a squeeze) under a force of any direction. It has a closed form while everything sticks; otherwise many directions
//! are tried one by one. The carried part of the load is the load factor up to which the load is held; below 1 the load is lost.

use core::f64::consts::{PI, TAU};

use super::loading::{Loading, force_at};
use super::question::Demand;
use super::trial::{RefutingLoads, Trial, Trials};
use crate::error::Error;
use crate::grasp::Wrench;
use crate::hold::{PathFacts, Verdict};
use crate::load_path::Ramp;
use crate::numerics::{Each, IntoList, Space, chosen, dot, numbered};
use crate::prelude::*;
use crate::squeeze::WeakestDirection;

impl Loading {
    /// The result of the trial under `load` and an added force of this size through a point, for the weakest direction of the force.
    pub(super) fn any_force(
        &self,
        load: Wrench<3>,
        (size, point): (f64, [f64; 3]),
        demand: Demand,
        refuting: &RefutingLoads,
    ) -> Result<Trials, Error> {
        let (verdict, path) = self.put_on_up_to(&Ramp::load(self.base, load), None)?;
        let base = self.base + load;
        match self.while_all_stick(&verdict, &base, (size, point), (demand, refuting))? {
            Some(trial) if demand == Demand::Sticks || trial.carried().is_some() => {
                return Ok(Trials::only(demand, trial));
            }
            _ => {}
        }
        let alone = self.judged((&verdict, 1.0 - path.farthest), Demand::Held);
        let along = |d: [f64; 3]| Ramp::load(base, force_at(d.each(|x| x * size), point));
        self.in_every_direction(
            Trials { at_rest: path.at_rest, ..Trials::only(Demand::Held, alone) },
            &along,
            refuting,
        )
    }

    /// The result of the trial as far as it can be computed while everything sticks, without a path for each direction. A force of any direction is
    /// added to the constant load `base`, on which `verdict` is given. `None` if something slides and the demand allows sliding.
    fn while_all_stick(
        &self,
        verdict: &Verdict<3>,
        base: &Wrench<3>,
        (size, point): (f64, [f64; 3]),
        (demand, refuting): (Demand, &RefutingLoads),
    ) -> Result<Option<Trial>, Error> {
        let at_rest = self.judged((verdict, f64::INFINITY), Demand::Sticks);
        if !at_rest.is_sufficient() {
            return Ok((demand == Demand::Sticks).then_some(match at_rest {
                Trial::Insufficient { says, carried, .. } => Trial::insufficient(says, carried - 1.0),
                other => other,
            }));
        }
        let weakest = self.grasp.weakest_direction(base, point)?;
        // If directions are tried one by one, the direction in which the least force makes a contact slide is tried first.
        if let WeakestDirection::Force { direction, .. } = &weakest
            && refuting.directions.borrow().is_empty()
        {
            refuting.add(*direction);
        }
        Ok(Some(match weakest {
            WeakestDirection::Never => self.farthest(base, size, point)?,
            WeakestDirection::Force { size: most, .. } if most >= size => {
                self.farthest(base, size, point)?.or_worse(Trial::carries(most / size))
            }
            // Even if contacts slide, the object may be held, unless its motions are too large already while all contacts stick.
            WeakestDirection::Force { .. } if demand != Demand::Sticks => {
                let trial = self.farthest(base, size, point)?;
                return Ok((!trial.is_sufficient()).then_some(trial));
            }
            WeakestDirection::GivesWay { .. } if demand != Demand::Sticks => return Ok(None),
            WeakestDirection::Force { load, size: most, .. } => {
                let first = self.grasp.hold(Ramp::load(*base, load - *base))?;
                let who = first.first_slip.map_or_else(|| "it slides".to_owned(), |first| self.said(&first));
                let along = self.words.along(&(load - *base).force_part().normalize());
                Trial::insufficient(format!("{who} under a force along {along}"), most / size)
            }
            WeakestDirection::GivesWay { .. } => Trial::nothing("nothing resists a force of one direction"),
            // A contact that is open before the force acts may be closed by the force. In that case no closed form compares directions.
            WeakestDirection::NotSticking => Trial::Unknown(
                "a contact is open or at its edge before the force acts, and directions are compared only where all of \
                 them press"
                    .to_owned(),
            ),
            WeakestDirection::Undecided => {
                Trial::Unknown("rounding keeps the weakest direction from being told".to_owned())
            }
        }))
    }

    /// The result for the direction in which motions are largest while everything sticks.
    fn farthest(&self, base: &Wrench<3>, size: f64, point: [f64; 3]) -> Result<Trial, Error> {
        let Some((most, direction)) = self.grasp.farthest_direction(base, point)? else {
            return Ok(Trial::always());
        };
        if most >= size {
            return Ok(Trial::carries(most / size));
        }
        let ramp = Ramp::load(*base, force_at(direction.each(|x| x * size), point));
        Ok(self.one_direction(&ramp, None)?.0)
    }

    /// The worst result over directions of a force. First come directions in which the force was not carried with other amounts, then evenly spread
    /// directions, and last directions between these. `worst` has the result without the force. Quick trials are confined to directions that refuted
    /// other amounts, if there are any.
    fn in_every_direction(
        &self,
        mut worst: Trials,
        along: &dyn Fn([f64; 3]) -> Ramp<3>,
        refuting: &RefutingLoads,
    ) -> Result<Trials, Error> {
        let known = refuting.directions.borrow().clone();
        let is_confined = self.grasp.settings().is_quick && !known.is_empty();
        let all = if is_confined { Vec::new() } else { directions(self.grasp.space()) };
        let (mut held, mut found) = (worst.held.take().unwrap_or_else(Trial::always), Vec::new());
        let mut weakest = None;
        for (k, direction) in known.iter().chain(&all).enumerate() {
            if let Trial::Insufficient { .. } = held {
                break;
            }
            let (trial, path) = self.one_direction(&along(*direction), held.carried())?;
            if k >= known.len() {
                if trial.carried() < held.carried() {
                    weakest = Some((*direction, trial.clone()));
                }
                found.push(DirectionTrial { part: trial.carried().unwrap_or(0.0), jumps: path.jumps });
            }
            (held, worst.at_rest) = (held.or_worse(trial), path.at_rest);
        }
        match weakest {
            // The weakest direction near a direction in which the force is not held is tried first from then on.
            Some((direction, trial)) if !trial.is_sufficient() => {
                let (direction, trial) = self.weakest_near(direction, along, trial)?;
                refuting.add(direction);
                held = held.or_worse(trial);
            }
            _ if held.is_sufficient() && !is_confined => {
                held = self.between_directions((&all, &found), along, held, refuting)?;
            }
            _ => {}
        }
        Ok(Trials { held: Some(held), ..worst })
    }

    /// The worst result between evenly spread directions, in all of which the load is carried. Near each direction in which a smaller part is carried
    /// than in its neighbours the weakest direction is sought. Neighbours may have different numbers of jumps on their load paths. The direction
    /// between them at which this number changes is then sought, because the carried part of the load jumps at this direction as well.
    fn between_directions(
        &self,
        (all, found): (&[[f64; 3]], &[DirectionTrial]),
        along: &dyn Fn([f64; 3]) -> Ramp<3>,
        mut held: Trial,
        refuting: &RefutingLoads,
    ) -> Result<Trial, Error> {
        let neighbours = neighbours(all, self.grasp.space());
        let is_least = |k: &usize| neighbours[*k].iter().all(|other| found[*k].part <= found[*other].part);
        let mut minima: Vec<usize> = (0..all.len()).filter(is_least).list();
        minima.sort_by(|a, b| found[*a].part.total_cmp(&found[*b].part));
        for (rank, k) in minima.into_iter().take(MOST_MINIMA).enumerate() {
            if held.is_sufficient() {
                let (direction, weakest) = self.weakest_near(all[k], along, Trial::carries(found[k].part))?;
                if rank == 0 || !weakest.is_sufficient() {
                    refuting.add(direction);
                }
                held = held.or_worse(weakest);
            }
        }
        let is_edge = |[one, other]: &[usize; 2]| one < other && found[*one].jumps != found[*other].jumps;
        let pairs =
            neighbours.iter().enumerate().flat_map(|(one, near)| near.iter().map(move |other| [one, *other]));
        let mut edges: Vec<[usize; 2]> = pairs.filter(is_edge).list();
        let least = |[one, other]: &[usize; 2]| found[*one].part.min(found[*other].part);
        edges.sort_by(|a, b| least(a).total_cmp(&least(b)));
        for [one, other] in edges.into_iter().take(MOST_EDGES) {
            let (mut ends, jumps) = ([all[one], all[other]], found[one].jumps);
            let mut parts = [found[one].part, found[other].part];
            loop {
                // The carried part has a different limit on each side of the jump. Towards each limit it is linear in the angle. Therefore the
                // smaller last step is needed only if the part is near 1.
                let is_near = parts[0].min(parts[1]) < 1.0 + 10.0 * LAST_STEP;
                let last = if is_near { LAST_STEP_AT_A_JUMP } else { LAST_STEP };
                let apart = [0, 1, 2].map(|axis| ends[0][axis] - ends[1][axis]);
                if !held.is_sufficient() || dot(&apart, &apart) <= last * last {
                    break;
                }
                let middle = unit([0, 1, 2].map(|axis| ends[0][axis] + ends[1][axis]));
                let (trial, path) = self.one_direction(&along(middle), held.carried())?;
                let end = usize::from(path.jumps != jumps);
                (ends[end], parts[end]) = (middle, trial.carried().unwrap_or(0.0));
                if !trial.is_sufficient() {
                    refuting.add(middle);
                }
                held = held.or_worse(trial);
            }
        }
        Ok(held)
    }

    /// The result for one direction, with facts about its load path. The path is followed only up to `least`, the multiple of the load that is
    /// carried in another direction, because only the weakest direction matters.
    fn one_direction(&self, ramp: &Ramp<3>, least: Option<f64>) -> Result<(Trial, PathFacts), Error> {
        let least = least.map(|carried| carried.max(CLOSE));
        let (verdict, path) = self.put_on_up_to(ramp, least)?;
        let trial = self.judged((&verdict, 1.0 - path.farthest), Demand::Held);
        Ok((self.said_of(1, &ramp.direction, trial), path))
    }

    /// The weakest direction near `direction`, whose trial is `weakest`, with its trial. The search moves to a neighbouring direction in which a
    /// smaller part of the load is carried. Its step is halved where no neighbour carries less.
    fn weakest_near(
        &self,
        mut direction: [f64; 3],
        along: &dyn Fn([f64; 3]) -> Ramp<3>,
        mut weakest: Trial,
    ) -> Result<([f64; 3], Trial), Error> {
        let space = self.grasp.space();
        // The first step is half of the angle between neighbouring evenly spread directions, rad.
        let mut step = if space == Space::Planar { 0.5 * TAU / 72.0 } else { 0.125 };
        for _ in 0..50 {
            // If far more than the load is carried in the weakest direction, the same is true of its neighbours, and the search ends.
            if step < LAST_STEP || weakest.carried().is_none_or(|carried| carried > CLOSE) {
                break;
            }
            let mut best = None;
            for across in tangents(direction, space) {
                for sign in [1.0, -1.0] {
                    let d = unit([0, 1, 2].map(|a| direction[a] + sign * step * across[a]));
                    let (trial, _) = self.one_direction(&along(d), weakest.carried())?;
                    let is_known = trial.carried().is_some() || weakest.is_sufficient();
                    if is_known && trial.carried() < weakest.carried() {
                        (best, weakest) = (Some(d), weakest.or_worse(trial));
                    }
                }
            }
            match best {
                Some(better) => direction = better,
                None => step *= 0.5,
            }
        }
        Ok((direction, weakest))
    }
}

/// The result for one direction of a force: the carried part of the load (0 if the verdict is undecided), and the number of jumps, which are motions
/// under constant load while the load is applied.
#[derive(Debug, Clone, Copy)]
struct DirectionTrial {
    part: f64,
    jumps: usize,
}

/// No weaker direction is sought near a direction in which more than this multiple of the load is carried. If smaller, a weakest direction between
/// evenly spread directions is missed; if larger, load paths are followed farther.
const CLOSE: f64 = 1.1;

/// Directions closer to each other than this angle, rad, are not tried. The carried parts of the load within this angle differ by less than 1e-6,
/// unless they jump.
const LAST_STEP: f64 = 1e-3;

/// The smaller value of [`LAST_STEP`] at a jump of the carried part, rad. It is used if less than 1 % more than the load is carried. If larger,
/// directions in which the load is lost stay unseen within this angle.
const LAST_STEP_AT_A_JUMP: f64 = 1e-8;

/// The weakest direction is sought near directions in which a smaller part of the load is carried than in their neighbours. This is the upper limit
/// of their number. With fewer, the weakest direction is missed if nearly the same part is carried in two directions.
const MOST_MINIMA: usize = 3;

/// At most this many pairs of neighbouring directions with different numbers of jumps are searched, the weakest pairs first. If fewer, narrow cones
/// of directions in which the load is lost stay unseen. Each pair takes five to seven verdicts.
const MOST_EDGES: usize = 12;

/// For each of the evenly spread directions the indices of its neighbours: two on a circle, about six on the sphere.
fn neighbours(all: &[[f64; 3]], space: Space) -> Vec<Vec<usize>> {
    let count = all.len();
    // On a sphere each of 200 directions has an area of (0.25 rad)².
    let is_near = |one: usize, other: usize| match space {
        Space::Planar => (one + 1) % count == other || (other + 1) % count == one,
        Space::Spatial => one != other && dot(&all[one], &all[other]) > 0.32_f64.cos(),
    };
    numbered(count, &|one| chosen(count, &|other| is_near(one, *other)))
}

fn unit(vector: [f64; 3]) -> [f64; 3] {
    let length = dot(&vector, &vector).sqrt();
    vector.each(|x| x / length)
}

/// Unit vectors at right angles to a direction: one in the plane, two in space.
fn tangents([x, y, z]: [f64; 3], space: Space) -> Vec<[f64; 3]> {
    if space == Space::Planar {
        return vec![[-y, x, 0.0]];
    }
    let first = unit(if x.abs() > y.abs() { [-z, 0.0, x] } else { [0.0, z, -y] });
    let [a, b, c] = first;
    vec![first, [y * c - z * b, z * a - x * c, x * b - y * a]]
}

/// Evenly spread unit vectors: on the unit circle in the plane, on a golden spiral over the unit sphere in space.
fn directions(space: Space) -> Vec<[f64; 3]> {
    // No formula gives the load at the loss as a function of the direction, so directions are sampled. With fewer directions the weakest direction
    // could be missed.
    let count = if space == Space::Planar { 72 } else { 200 };
    let golden = PI * (3.0 - 5.0_f64.sqrt());
    let direction = |k: usize| {
        let z = 1.0 - (2 * k + 1) as f64 / count as f64;
        let (radius, angle, z) = match space {
            Space::Planar => (1.0, TAU / count as f64, 0.0),
            Space::Spatial => ((1.0 - z * z).sqrt(), golden, z),
        };
        let (sin, cos) = (angle * k as f64).sin_cos();
        [radius * cos, radius * sin, z]
    };
    numbered(count, &direction)
}
