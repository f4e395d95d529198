//! A node of the load path: what stands where, and how it goes on from there.

use nalgebra::SVector;

use super::beyond::just_beyond;
use super::event::{Change, Loss, PathEnd};
use super::margin::ROUNDING;
use super::segment::{Here, Segment, Standing};
use crate::equilibrium::{
    ContactState, Effort, Found, Rung, Settings, Settled, Verdict, combinations, search,
    separates_from_here_on, settle, try_states,
};
use crate::formulation::{Law, Piece, Problem, State};
use crate::grasp::{Hold, Wrench};

/// With at most this many combinations of states among the contacts on an edge, all are tried to see whether the path
/// goes on in more than one way.
const FEW_COMBINATIONS: f64 = 256.0;

/// Where the path stands, contact by contact.
pub(super) struct Node<const D: usize, const C: usize> {
    pub(super) states: Vec<State>,
    /// Directions of the sliding contacts, coordinate axes.
    directions: Vec<Option<SVector<f64, C>>>,
    /// Facets without margin: those on which a contact slides, and others it stands on.
    standing: Vec<Vec<usize>>,
    /// Closed without force, or open without a gap: only the rates tell what comes.
    at_apex: Vec<bool>,
    /// Infinite friction holds a tangential force: it cannot vanish with the normal force but has to be let go of.
    holds: Vec<bool>,
    twist: SVector<f64, D>,
}

/// How the path goes on from a node.
pub(super) struct Onward<const D: usize, const C: usize> {
    pub(super) here: Here<D, C>,
    pub(super) changes: Vec<(usize, Change<C>)>,
    pub(super) other_continuations: Option<usize>,
}

impl<const D: usize, const C: usize> Node<D, C> {
    pub(super) fn new(states: Vec<State>, twist: SVector<f64, D>) -> Self {
        let n = states.len();
        Self {
            states,
            directions: vec![None; n],
            standing: vec![Vec::new(); n],
            at_apex: vec![false; n],
            holds: vec![false; n],
            twist,
        }
    }

    /// At the start of the path, finds what stands on an edge: the state comes from a one-shot solution, which does not
    /// say.
    pub(super) fn stand_at_start(&mut self, segment: &mut Segment<'_, D, C>) {
        let Ok(here) = segment.look(&self.states, 0.0, Some(&self.twist)) else { return };
        for (i, line) in here.lines.iter().enumerate() {
            let site = &segment.grasp.sites()[i];
            if self.states[i] == State::Open {
                let [gap, _, span, _] = here.gaps[i];
                self.at_apex[i] = gap <= ROUNDING * span;
                continue;
            }
            if site.hold == Hold::Bonded {
                continue;
            }
            self.at_apex[i] = line.force.norm() <= ROUNDING * line.force_size;
            if matches!(self.states[i], State::Sliding { .. }) {
                // What slipped from rest to here is memory from now on.
                let stretch = segment.problem.drives[i] - site.map.tr_mul(&here.twist);
                for axis in 1..C {
                    let slip = stretch[axis] - line.force[axis] / site.k[axis];
                    segment.problem.slips[i][axis] += slip;
                    segment.problem.drives[i][axis] -= slip;
                }
            }
            for (j, h) in segment.problem.normals(i).iter().enumerate() {
                let size = line.force_size * (site.mu + h.norm());
                if site.mu * line.force[0] - h.dot(&line.force) <= ROUNDING * size {
                    self.standing[i].push(j);
                }
            }
        }
    }

    /// What was reached together with the end of a leg.
    pub(super) fn stand(&mut self, segment: &Segment<D, C>, reached: &Standing<C>) {
        for (i, exits) in reached {
            for exit in exits {
                match segment.problem.normals(*i).iter().position(|h| *h == exit.facet) {
                    Some(facet) if self.states[*i] != State::Open => {
                        if !self.standing[*i].contains(&facet) {
                            self.standing[*i].push(facet);
                        }
                    }
                    // The normal force itself vanishes, or the gap.
                    _ => self.at_apex[*i] = true,
                }
            }
            if self.standing[*i].len() >= C {
                self.at_apex[*i] = true;
            }
            self.standing[*i].sort_unstable();
        }
    }

    /// Moves to the end of a straight piece: the slip of what slid becomes memory.
    pub(super) fn arrive(
        &mut self,
        segment: &mut Segment<'_, D, C>,
        here: &Here<D, C>,
        factor: f64,
        step: f64,
    ) {
        self.twist = here.twist + here.twist_rate * step;
        let drives = segment.drives(factor);
        for (i, site) in segment.grasp.sites().iter().enumerate() {
            let force = here.lines[i].force + here.lines[i].rate * step;
            if here.lines[i].force.norm() > 0.0 && force.norm() <= 1e-12 * here.lines[i].force_size {
                self.at_apex[i] = self.states[i] != State::Open;
            }
            let friction = force.iter().skip(1).fold(0.0, |h: f64, f| h.hypot(*f));
            self.holds[i] = site.mu.is_infinite() && friction > 1e-12 * here.lines[i].force_size;
            if matches!(self.states[i], State::Sliding { .. }) {
                let stretch = drives[i] - site.map.tr_mul(&self.twist);
                for axis in 1..C {
                    let slip = stretch[axis] - force[axis] / site.k[axis];
                    segment.problem.slips[i][axis] += slip;
                    segment.problem.drives[i][axis] -= slip;
                }
            }
        }
    }

    /// Decides the states of everything that stands on an edge, from the rates.
    pub(super) fn go_on(
        &mut self,
        segment: &mut Segment<'_, D, C>,
        leg: usize,
        factor: f64,
        load: [Wrench<D>; 2],
        arrived: &Standing<C>,
        settings: &Settings,
    ) -> Result<Onward<D, C>, PathEnd<D, C>> {
        self.stand(segment, arrived);
        let rates = segment.rates(self.laws(segment));
        // At the apex there is no telling: every state is as good a guess.
        let guess = if rates.laws.iter().any(|law| matches!(law, Law::Cone { .. })) {
            Verdict::Unbalanced
        } else {
            try_states(&rates, self.guess(&rates))
        };
        let (settled, effort) = match guess {
            Verdict::Holds(found) => (Settled::Found(found, Rung::LoadPath), Effort::default()),
            _ => settle(&rates, settings),
        };
        let stands = |i: &usize| matches!(rates.laws[*i], Law::Edge(_) | Law::Cone { .. });
        let loss = |motion: Option<SVector<f64, D>>| Loss {
            leg,
            fraction: factor,
            load: load[0] + (load[1] - load[0]) * factor,
            contacts: (0..self.states.len()).filter(stands).collect(),
            motion: motion.map(|v| segment.grasp.outside(&v)),
        };
        let Settled::Found(found, _) = settled else {
            if let Settled::FreeMotion(v) = settled {
                return Err(PathEnd::GivesWay { leg, fraction: factor, motion: segment.grasp.outside(&v) });
            }
            let motion = leaving_motion(&rates, &self.guess(&rates));
            let problem = segment.problem_at(factor);
            if motion.is_some_and(|v| separates_from_here_on(&problem, &v, &rates.wrench)) {
                return Err(PathEnd::LimitLoad(loss(motion)));
            }
            let beyond =
                just_beyond(segment.grasp, &problem, &rates, settled, &effort, settings, segment.cone);
            return Err(PathEnd::from_beyond(&beyond, loss(motion)));
        };
        // Infinite friction keeps its tangential force until the normal force is gone, and then loses it all at once.
        let lets_go =
            |i: usize| self.holds[i] && self.states[i] != State::Open && found.states[i] == State::Open;
        if (0..self.states.len()).any(lets_go) {
            return Err(PathEnd::Snap(loss(
                Some(found.twist).filter(|v| v.norm() > 0.0).map(|v| v.normalize()),
            )));
        }
        let other_continuations = (combinations(&rates) <= FEW_COMBINATIONS).then(|| others(&rates, &found));
        let changes = self.take_over(segment, factor, &rates, &found);
        let here = segment
            .look(&self.states, factor, Some(&self.twist))
            .map_err(|_| PathEnd::Undecided { leg, fraction: factor })?;
        self.leave_edges(segment, &here);
        Ok(Onward { here, changes, other_continuations })
    }

    /// What each contact may do next.
    fn laws(&self, segment: &Segment<D, C>) -> Vec<Law<C>> {
        (0..self.states.len())
            .map(|i| {
                let whole = &segment.problem.laws[i];
                let closed = self.states[i] != State::Open;
                let has_edges = segment.problem.may_open(i) || !segment.problem.normals(i).is_empty();
                if *whole == Law::Bonded || !has_edges {
                    Law::Bonded
                } else if self.at_apex[i] {
                    whole.clone()
                } else if !closed {
                    Law::Absent
                } else if self.standing[i].is_empty() {
                    Law::Bonded
                } else {
                    let normals = segment.problem.normals(i);
                    Law::Edge(self.standing[i].iter().map(|&j| normals[j]).collect())
                }
            })
            .collect()
    }

    /// What slides goes on sliding and what has reached an edge slides along it: the common case, one solve. What is at
    /// the apex of its cone opens.
    fn guess(&self, rates: &Problem<D, C>) -> Vec<State> {
        (0..self.states.len())
            .map(|i| match &rates.laws[i] {
                Law::Edge(normals) => {
                    State::Sliding { first: 0, second: (C == 3 && normals.len() == 2).then_some(1) }
                }
                Law::Cone { gap: true } => State::Open,
                _ => rates.unjumped(i),
            })
            .collect()
    }

    /// Takes the states of the rates over and says what changed.
    fn take_over(
        &mut self,
        segment: &mut Segment<'_, D, C>,
        factor: f64,
        rates: &Problem<D, C>,
        found: &Found<D, C>,
    ) -> Vec<(usize, Change<C>)> {
        let mut changes = Vec::new();
        for i in 0..self.states.len() {
            let next = self.in_the_whole_law(segment, i, rates, found.states[i]);
            let answer = segment.grasp.contact_answer(rates, found, segment.cone, i);
            let direction = match answer.state {
                ContactState::Sliding { direction } => Some(direction),
                _ => None,
            };
            let (was, is) = (self.states[i], next);
            let change = match (was, is, direction) {
                (State::Open, State::Rolling, _) => Some(Change::Closes),
                (State::Open, State::Sliding { .. }, Some(direction)) => {
                    Some(Change::ClosesSliding { direction })
                }
                (State::Rolling, State::Sliding { .. }, Some(direction)) => {
                    Some(Change::Slides { direction })
                }
                (State::Sliding { .. }, State::Rolling, _) => Some(Change::Sticks),
                (State::Rolling | State::Sliding { .. }, State::Open, _) => Some(Change::Opens),
                (State::Sliding { .. }, State::Sliding { .. }, Some(direction)) if was != is => {
                    let before = self.directions[i].unwrap_or(direction);
                    Some(if C == 2 || before.dot(&direction) < -0.5 {
                        Change::Reverses { direction }
                    } else {
                        Change::Turns { direction }
                    })
                }
                _ => None,
            };
            if was == State::Open && is != State::Open {
                segment.close(i, factor, &self.twist);
            }
            self.states[i] = next;
            self.directions[i] = direction;
            changes.extend(change.map(|change| (i, change)));
        }
        changes
    }

    /// A state in rates, where facets count among those the contact stands on, in terms of the whole law.
    fn in_the_whole_law(
        &self,
        segment: &Segment<D, C>,
        i: usize,
        rates: &Problem<D, C>,
        state: State,
    ) -> State {
        match (&rates.laws[i], state) {
            (Law::Edge(_), State::Sliding { first, second }) => {
                let facets: Vec<_> = [Some(first), second].into_iter().flatten().collect();
                segment
                    .problem
                    .slipping_state(i, &facets.iter().map(|&k| self.standing[i][k]).collect::<Vec<_>>())
            }
            _ => state,
        }
    }

    /// Forgets the edges that contacts now move away from.
    fn leave_edges(&mut self, segment: &Segment<D, C>, here: &Here<D, C>) {
        for i in 0..self.states.len() {
            let (line, site) = (&here.lines[i], &segment.grasp.sites()[i]);
            if self.states[i] == State::Open {
                let [_, rate, _, span_rate] = here.gaps[i];
                self.at_apex[i] &= rate <= ROUNDING * span_rate;
                self.standing[i].clear();
                continue;
            }
            let normals = segment.problem.normals(i);
            if self.at_apex[i] {
                self.at_apex[i] = line.rate[0].abs() <= ROUNDING * line.rate_size;
                self.standing[i] = (0..normals.len()).collect();
            }
            let slides_on = |j: usize| match self.states[i] {
                State::Sliding { first, second } => j == first || second == Some(j),
                _ => false,
            };
            self.standing[i].retain(|&j| {
                let h = &normals[j];
                let rate = site.mu * line.rate[0] - h.dot(&line.rate);
                slides_on(j) || rate <= ROUNDING * line.rate_size * (site.mu + h.norm())
            });
        }
    }
}

/// How many other solutions the rates have: other forces, or other motions than one along what is free anyway.
fn others<const D: usize, const C: usize>(rates: &Problem<D, C>, found: &Found<D, C>) -> usize {
    let size = found.forces.iter().map(nalgebra::Matrix::norm).fold(rates.wrench.norm(), f64::max);
    let mut distinct: Vec<Found<D, C>> = vec![found.clone()];
    for other in search(rates, false).found {
        let same = |known: &Found<D, C>| {
            let mut apart = known.twist - other.twist;
            for v in known.free_motions.iter().chain(&other.free_motions) {
                apart -= v * v.dot(&apart);
            }
            let travel = known.twist.norm().max(other.twist.norm());
            apart.norm() <= 1e-9 * travel
                && known.forces.iter().zip(&other.forces).all(|(x, y)| (x - y).norm() <= 1e-9 * size)
        };
        if !distinct.iter().any(same) {
            distinct.push(other);
        }
    }
    distinct.len() - 1
}

/// The unit motion with which the object leaves when everything that stands on an edge slides: a motion that nothing resists
/// then, on which the load works; or else the motion of the rates in these states, which would balance the load if only the
/// slips were not against friction: taken the other way, they are along it.
fn leaving_motion<const D: usize, const C: usize>(
    rates: &Problem<D, C>,
    states: &[State],
) -> Option<SVector<f64, D>> {
    let piece = Piece::new(rates, states);
    let solved = match piece.solve(&rates.drives, &rates.wrench) {
        Err(unbalanced) => {
            // Where friction is exhausted, no spring resists, but the friction forces feel the motion.
            let free = piece.free_motions().iter();
            let along = free.fold(SVector::zeros(), |sum, v| sum + v * v.dot(&rates.wrench));
            let size = along.norm();
            return unbalanced.motion.or_else(|| (size > 0.0).then(|| along / size));
        }
        Ok(solved) => solved,
    };
    let mut along_friction = 0.0;
    for (i, state) in states.iter().enumerate() {
        if let State::Sliding { first, second } = *state {
            let site = &rates.sites[i];
            let stretch = rates.drives[i] - site.map.tr_mul(&solved.twist);
            let normals = rates.normals(i);
            let outward = normals[first] + second.map_or_else(SVector::zeros, |second| normals[second]);
            along_friction += (1..C)
                .map(|axis| outward[axis] * (stretch[axis] - solved.forces[i][axis] / site.k[axis]))
                .sum::<f64>();
        }
    }
    let size = solved.twist.norm();
    (size > 0.0).then(|| solved.twist * (1.0_f64.copysign(along_friction) / size))
}
