//! The trial of an amount (such as a squeeze) under a force of any direction. While everything sticks the result has a closed form; otherwise many
//! directions are tried one by one. The carried part of the load is the load factor up to which the load is held; below 1 the load is lost. The
//! weakest direction is the one in which the smallest part is carried; a jump is a sudden motion of the object under constant load. An amount is
//! sufficient if the grasp meets the demand with it.

use super::loading::{Loading, force_at};
use super::question::Demand;
use super::spread_directions::{
    CLOSE, DirectionTrial, directions, everywhere, first_step, in_between, is_within, neighbours, spread_out,
    tangents, unit,
};
use super::trial::{RefutingLoads, Trial, Trials};
use crate::error::Error;
use crate::grasp::Wrench;
use crate::hold::{PathFacts, Verdict};
use crate::load_path::Ramp;
use crate::numerics::{Each, chosen, dot, mapped, numbered, picked, sort_by_number};
use crate::prelude::*;
use crate::squeeze::WeakestDirection;
use crate::sweep::map_in_order;

impl Loading {
    /// The result of the trial under a constant load and an added force of given magnitude through a point, for the weakest direction of the force.
    pub(super) fn any_force(
        &self,
        load: Wrench<3>,
        (size, point): (f64, [f64; 3]),
        demand: Demand,
        refuting: &RefutingLoads,
    ) -> Result<Trials, Error> {
        let (verdict, path) = self.put_on_up_to(&Ramp::load(self.base, load), None)?;
        let base = self.base + load;
        let along = |d: [f64; 3]| Ramp::load(base, force_at(d.each(|x| x * size), point));
        match self.while_all_stick(&verdict, &base, (size, point), (demand, refuting))? {
            Some(trial) if demand == Demand::Sticks => return Ok(Trials::only(demand, trial)),
            Some(trial) if trial.carried().is_some() => {
                return Ok(Trials::only(demand, self.unless_it_buckles(trial, &along)?));
            }
            _ => {}
        }
        let alone = self.judged((&verdict, 1.0 - path.farthest), Demand::Held);
        self.in_every_direction(
            Trials { at_rest: path.at_rest, ..Trials::only(Demand::Held, alone) },
            &along,
            refuting,
        )
    }

    /// Checks whether forces along the coordinate axes, in both senses, buckle the grasp; `along` returns the load for a direction of the force.
    /// Returns the worst of these results and `held`, the result of the equilibrium with everything sticking, which does not show buckling. The
    /// geometric stiffness is linear in the force. Therefore a force between the axes is safe, too, if it is a weighted mean of safe forces along
    /// them. A force of full magnitude between the axes is larger than such a mean, and is not checked.
    fn unless_it_buckles(&self, mut held: Trial, along: Along<'_>) -> Result<Trial, Error> {
        let axes = self.grasp.space().axes();
        for k in 0..2 * axes {
            let mut direction = [0.0; 3];
            direction[k % axes] = if k < axes { 1.0 } else { -1.0 };
            let ramp = along(direction);
            if held.is_sufficient() && self.grasp.engine.may_buckle(&ramp.load_at(1.0)) {
                held = held.or_worse(self.one_direction(&ramp, None)?.0);
            }
        }
        Ok(held)
    }

    /// The result of the trial if the linear equilibrium with everything sticking decides it, without a load path for each direction. A force of any
    /// direction is added to the constant load `base`; `verdict` is the verdict on `base` alone. `None` if a contact slides and the demand allows
    /// sliding.
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
                // A negative part would mean that not even the load at rest is carried; the search for the greatest load would then end at once.
                Trial::Insufficient { says, carried, .. } => Trial::insufficient(says, carried.min(0.0)),
                other => other,
            }));
        }
        let weakest = self.grasp.weakest_direction(base, point)?;
        // The direction in which the least force makes a contact slide is stored in `refuting`. If directions are tried one by one later, this
        // direction is tried first.
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
            WeakestDirection::GivesWay { motion } => {
                Trial::nothing(format!("nothing resists {}", self.words.direction_of(&motion)))
            }
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

    /// The result under a force of the magnitude `size` at `point`, while everything sticks. The force has the direction in which it causes the
    /// largest motions relative to the limits of small motions.
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

    /// The worst result over directions of a force; `worst` has the result without the force. First, directions are tried in which the force was not
    /// held with other amounts. A quick trial (without the enumeration of contact states) tries only these directions, if there are any. Then follow
    /// evenly spread directions, in space at least 0.4 rad apart, and all neighbours of those in which less than [`CLOSE`] (1.1) times the load is
    /// carried. Finally the weakest direction is sought between all directions that were tried.
    fn in_every_direction(
        &self,
        mut worst: Trials,
        along: Along<'_>,
        refuting: &RefutingLoads,
    ) -> Result<Trials, Error> {
        let known = refuting.directions.borrow().clone();
        let is_confined = self.grasp.settings().is_quick && !known.is_empty();
        let all = if is_confined { Vec::new() } else { directions(self.grasp.space()) };
        let (mut held, mut found) = (worst.held.take().unwrap_or_else(Trial::always), vec![None; all.len()]);
        let (mut weakest, mut before) = (None, Vec::new());
        // The first direction is tried alone. The multiple of the load carried in it limits how far the load is followed in the other directions.
        let (first, others) = known.split_at(known.len().min(1));
        for some in [first, others] {
            for (direction, (trial, path)) in some.iter().zip(self.some_directions(some, along, &held)?) {
                before.push((*direction, trial.carried().unwrap_or(0.0)));
                (held, worst.at_rest) = (held.or_worse(trial), path.at_rest);
            }
        }
        for round in 0..2 {
            // A few spread directions are enough at first if loads are followed up to [`CLOSE`] times the load. It is then known near which of them a
            // weaker direction may lie. Otherwise all directions are tried.
            let next = match round {
                0 if self.followed >= CLOSE => spread_out(&all, self.grasp.space()),
                0 => numbered(all.len(), &|k| k),
                _ => in_between(&all, &found),
            };
            for some in next.chunks(AT_ONCE) {
                if let Trial::Insufficient { .. } = held {
                    break;
                }
                let ways: Vec<_> = mapped(some, &|k| all[*k]);
                for (k, (trial, path)) in some.iter().zip(self.some_directions(&ways, along, &held)?) {
                    if trial.carried() < held.carried() {
                        weakest = Some((all[*k], trial.clone()));
                    }
                    found[*k] =
                        Some(DirectionTrial { part: trial.carried().unwrap_or(0.0), jumps: path.jumps });
                    (held, worst.at_rest) = (held.or_worse(trial), path.at_rest);
                }
            }
        }
        match weakest {
            // The force is not held in this direction. The weakest direction near it is sought, because trials of other amounts begin with the
            // weakest direction found.
            Some((direction, trial)) if !trial.is_sufficient() => {
                let (direction, trial) =
                    self.weakest_near((direction, first_step(self.grasp.space())), along, trial)?;
                refuting.add(direction);
                held = held.or_worse(trial);
            }
            _ if held.is_sufficient() && !is_confined => {
                held = self.between_directions((&all, &found), &before, along, held, refuting)?;
            }
            _ => {}
        }
        Ok(Trials { held: Some(held), ..worst })
    }

    /// The results for some directions, computed in parallel. The list is in the order of the directions and ends with the first direction in which
    /// the force is not carried. `held` is the worst result so far.
    fn some_directions(
        &self,
        some: &[[f64; 3]],
        along: Along<'_>,
        held: &Trial,
    ) -> Result<Vec<(Trial, PathFacts)>, Error> {
        if let Trial::Insufficient { .. } = held {
            return Ok(Vec::new());
        }
        let least = held.carried();
        let mut results = map_in_order(some, |direction| self.one_direction(&along(*direction), least))
            .into_iter()
            .collect::<Result<Vec<_>, _>>()?;
        let is_lost = |(trial, _): &(Trial, PathFacts)| matches!(trial, Trial::Insufficient { .. });
        if let Some(first) = results.iter().position(is_lost) {
            results.truncate(first + 1);
        }
        Ok(results)
    }

    /// The worst result for directions between evenly spread directions, if the whole load is carried in each of the latter. The weakest direction is
    /// sought near each evenly spread direction in which a smaller part of the load is carried than in its neighbours. `before` has directions that
    /// were weakest with other amounts, and the parts carried in them. The search starts from such a direction on two conditions. No larger part is
    /// carried in it than in the evenly spread direction. The angle between the two is at most 1.25 times the first step, which is half the angle
    /// between evenly spread directions. The carried part of the load jumps where the number of jumps on the load path changes. If this number
    /// differs between two neighbours, the direction between them at which the number changes is sought, too.
    fn between_directions(
        &self,
        (all, tried): (&[[f64; 3]], &[Option<DirectionTrial>]),
        before: &[([f64; 3], f64)],
        along: Along<'_>,
        mut held: Trial,
        refuting: &RefutingLoads,
    ) -> Result<Trial, Error> {
        let (space, found) = (self.grasp.space(), everywhere(all, tried));
        let neighbours = neighbours(all, space);
        let is_least = |k: &usize| {
            tried[*k].is_some() && neighbours[*k].iter().all(|other| found[*k].part <= found[*other].part)
        };
        let mut minima: Vec<usize> = chosen(all.len(), &is_least);
        sort_by_number(&mut minima, &|k| found[*k].part);
        let mut starts: Vec<([f64; 3], f64, f64)> = Vec::new();
        for k in minima.into_iter().take(MOST_MINIMA) {
            let step = first_step(space);
            // The direction that was weakest with another amount is nearer to the weakest direction than an evenly spread one is.
            let near = before
                .iter()
                .find(|(way, part)| is_within(1.25 * step, way, &all[k]) && *part <= found[k].part);
            let start =
                near.map_or((all[k], found[k].part, step), |(way, part)| (*way, *part, step * A_LITTLE));
            if !starts.iter().any(|(way, ..)| *way == start.0) {
                starts.push(start);
            }
        }
        for (rank, (start, part, step)) in starts.into_iter().enumerate() {
            if held.is_sufficient() {
                let (direction, weakest) = self.weakest_near((start, step), along, Trial::carries(part))?;
                if rank == 0 || !weakest.is_sufficient() {
                    refuting.add(direction);
                }
                held = held.or_worse(weakest);
            }
        }
        let mut edges = Vec::new();
        for (one, near) in neighbours.iter().enumerate() {
            let is_beyond = |other: &usize| one < *other && found[one].jumps != found[*other].jumps;
            edges.extend(picked(near, &|other| is_beyond(other).then_some([one, *other])));
        }
        let least = |[one, other]: &[usize; 2]| found[*one].part.min(found[*other].part);
        sort_by_number(&mut edges, &least);
        for [one, other] in edges.into_iter().take(MOST_EDGES) {
            let (mut ends, jumps) = ([all[one], all[other]], found[one].jumps);
            let mut parts = [found[one].part, found[other].part];
            loop {
                // The carried part of the load jumps between the two directions in `ends`. On either side of the jump it is nearly linear in the
                // angle, so that a small error of the direction changes it little. The smaller last step is needed only if the carried part is so
                // near 1, the whole load, that this change decides whether the load is held.
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

    /// The result for one direction, and data of its load path: the number of jumps, the largest motion relative to its limit, and the equilibrium at
    /// rest. The path is followed only up to `least`, the multiple of the load that is carried in another direction, because only the weakest
    /// direction matters.
    fn one_direction(&self, ramp: &Ramp<3>, least: Option<f64>) -> Result<(Trial, PathFacts), Error> {
        let least = least.map(|carried| carried.max(CLOSE));
        let (verdict, path) = self.put_on_up_to(ramp, least)?;
        let trial = self.judged((&verdict, 1.0 - path.farthest), Demand::Held);
        Ok((self.said_of(1, &ramp.direction, trial), path))
    }

    /// Searches near `direction` for the direction in which the smallest part of the load is carried, and returns it with its trial. `weakest` is the
    /// trial of `direction`. The search moves to a neighbouring direction with a smaller carried part; if there is none, the step (rad) is halved.
    /// The search ends once the whole load is carried in all directions between the neighbours. This conclusion assumes that the forces carried in
    /// all directions form a convex set, which is not proved where contacts slide.
    fn weakest_near(
        &self,
        (mut direction, mut step): ([f64; 3], f64),
        along: Along<'_>,
        mut weakest: Trial,
    ) -> Result<([f64; 3], Trial), Error> {
        let space = self.grasp.space();
        for _ in 0..50 {
            // If even in the weakest direction so far more than [`CLOSE`] times the load is carried, the whole load is carried in its neighbours,
            // too, and the search ends.
            if step < LAST_STEP || weakest.carried().is_none_or(|carried| carried > CLOSE) {
                break;
            }
            let mut beside = Vec::new();
            for across in tangents(direction, space) {
                let at = |step: f64| unit([0, 1, 2].each(|a| direction[a] + step * across[a]));
                beside.extend([at(step), at(-step)]);
            }
            let (before, mut best) = (weakest.clone(), None);
            let trials = map_in_order(&beside, |d| self.one_direction(&along(*d), before.carried()));
            for (d, tried) in beside.into_iter().zip(trials) {
                let (trial, _) = tried?;
                let is_known = trial.carried().is_some() || weakest.is_sufficient();
                if is_known && trial.carried() < weakest.carried() {
                    (best, weakest) = (Some(d), weakest.or_worse(trial));
                }
            }
            match best {
                Some(better) => direction = better,
                // If the carried forces form a convex set, the whole load is carried in all directions between the neighbours, which lie at the angle
                // `step` on either side.
                None if weakest.carried().is_some_and(|part| part * (2.0 * step).cos() > 1.0) => break,
                None => step *= 0.5,
            }
        }
        Ok((direction, weakest))
    }
}

/// Returns the growing load (a force at a point, in addition to a constant load) whose force has the direction of the given unit vector.
type Along<'a> = &'a (dyn Fn([f64; 3]) -> Ramp<3> + Sync);

/// Number of directions that are tried at once, in parallel. All trials of one group follow the load up to the part carried in the weakest direction
/// before the group. In a larger group more trials are in vain if one of them finds a direction in which the load is lost; in a smaller one cores are
/// idle.
const AT_ONCE: usize = 8;

/// The search for the weakest direction may start from a direction that was weakest with another amount. Its first step is then this fraction of the
/// first step from an evenly spread direction. With a smaller fraction the search takes more steps to follow the weakest direction from amount to
/// amount; with a larger one the search halves the step more often.
const A_LITTLE: f64 = 0.125;

/// The search for the weakest direction ends once its step is below this angle, rad. If the carried forces form a convex set, the carried part
/// between two directions this far apart is smaller than in both of them by less than the fraction 1e-6.
const LAST_STEP: f64 = 1e-3;

/// At a jump of the carried part of the load this angle, rad, replaces [`LAST_STEP`] if at most about 1 % more than the whole load is carried. With a
/// larger angle directions in which the load is lost stay unseen within this angle.
const LAST_STEP_AT_A_JUMP: f64 = 1e-8;

/// The weakest direction is sought near directions in which a smaller part of the load is carried than in their neighbours. This is the upper limit
/// of their number. With fewer, the weakest direction is missed if nearly the same part is carried in two directions.
const MOST_MINIMA: usize = 3;

/// At most this many pairs of neighbouring directions with different numbers of jumps are searched, the weakest pairs first. If fewer, narrow cones
/// of directions in which the load is lost stay unseen. Each pair takes up to nine verdicts, or up to 25 if the last step is [`LAST_STEP_AT_A_JUMP`].
const MOST_EDGES: usize = 12;
