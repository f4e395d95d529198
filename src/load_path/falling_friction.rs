//! Where friction falls as contacts begin to slide, the path jumps at one load: what they have lost goes over to the others.
//!
//! A contact that leaves its cone of rest has, with the same springs as far stretched, the force F' of its cone of sliding in place of F. What is missing for
//! balance is held up at first, and then let go along a leg of its own, at the same load and with the same commands:
//!
//! ```text
//! Σ G_i F_i + W + (1 - τ) Σ G_j (F_j - F_j') = 0,      τ from 0 to 1
//! ```
//!
//! Such a leg is followed as any other one. Who leaves its cone of rest on it joins: what it loses is held up besides, and the leg begins anew from there.
//! Either its end is reached, or equilibrium is lost on it with all that a loss tells. What is let go stands for the damping of a motion that does not shoot
//! over.

use nalgebra::SVector;

use super::beyond::Beyond;
use super::energy::LegEnergy;
use super::event::{Change, ContactChange, Event, Loss, PathEnd};
use super::journey::Journey;
use super::jump::{Jump, JumpSlip};
use super::node::Node;
use super::pieces::Pieces;
use super::trajectory::Trajectory;
use crate::contact::{ActiveSet, Mode, tangential_norm};
use crate::equilibrium::ACCURATE;
use crate::numerics::{Size, Vector};
use crate::object::Problem;
use crate::search::{Doubt, Found, Settings, Settled, settle};

/// One contact slides, sticks and slides again within a jump so often at most: each time it loses energy, and more often rounding goes in circles.
const MOST_OFTEN: usize = 16;

/// A jump on its way.
struct Fall<'g, D: Size, const C: usize> {
    /// Along the leg on which what is missing is let go.
    leg: Pieces<'g, D, C>,
    /// Slips before.
    slips: Vec<SVector<f64, C>>,
    /// Which sites slide in it.
    slid: Vec<bool>,
    changes: Vec<(usize, Change<C>)>,
}

impl<'g, D: Size, const C: usize> Fall<'g, D, C> {
    /// To the end of the leg, who leaves its cone on the way joining.
    fn go(&mut self, goal: &Vector<D>, journey: &Journey<'g, D, C>) -> Result<(), PathEnd<C>> {
        let mut left = MOST_OFTEN * self.slips.len();
        loop {
            let leg = &mut self.leg;
            if !std::mem::take(&mut leg.at_node) {
                let done = if leg.node.turns() {
                    leg.advance_along_arc(journey)
                } else {
                    leg.advance_straight(journey)
                };
                if done? {
                    return Ok(());
                }
                continue;
            }
            let onward = leg.node.go_on(&mut leg.segment, journey, leg.factor)?;
            leg.here = Some(onward.here);
            leg.pace = leg.pace.at_node();
            leg.friction_of_rest();
            let begin = leg.begin_to_slide(&onward.changes);
            self.note(&onward.changes);
            if !begin.is_empty() {
                left = left.checked_sub(1).ok_or_else(|| journey.undecided(0.0, Doubt::OnTheBoundary))?;
                self.leg = self.leg.let_go(goal, &begin, journey)?;
            }
        }
    }

    fn note(&mut self, changes: &[(usize, Change<C>)]) {
        self.changes.extend(changes);
        self.slid.iter_mut().zip(&self.leg.node.states).for_each(|(slid, state)| *slid |= state.slides());
    }

    /// How far contacts have slipped so far.
    fn slips(&self, journey: &Journey<'g, D, C>) -> Vec<JumpSlip<C>> {
        let contacts = journey.grasp.contacts().iter().enumerate().filter(|(i, _)| self.slid[*i]);
        let slip = |i: usize| self.leg.segment.problem.slips[i] - self.slips[i];
        contacts.map(|(i, contact)| JumpSlip { contact: contact.label(i), slip: slip(i) }).collect()
    }
}

impl<'g, D: Size, const C: usize> Pieces<'g, D, C> {
    /// From rest on every contact has a cone of its own, if some are weaker once they slide. Those that slide already do with less.
    pub(super) fn with_falling_friction(mut self, journey: &Journey<'g, D, C>) -> Result<Self, PathEnd<C>> {
        if journey.grasp.weaker_once_they_slide().next().is_some() {
            self.segment.problem.cones = journey.grasp.sites().iter().map(|site| site.friction).collect();
            let slide = |i: &usize| self.node.states[*i].slides();
            let changes: Vec<_> = journey.grasp.weaker_once_they_slide().filter(slide).collect();
            let changes = changes
                .into_iter()
                .filter_map(|i| Some((i, Change::Slides { direction: self.node.directions[i]? })));
            let changes: Vec<_> = changes.collect();
            let begin = self.begin_to_slide(&changes);
            let before = self.present_state(journey);
            if let Some(jump) = self.jump(journey, &begin)?
                && let Some(state) = before
            {
                let (changes, drives) = journey.grasp.contacts_and_drives(changes);
                self.first = Some(Box::new(Event {
                    leg: 0,
                    fraction: 0.0,
                    load: journey.program.load_at(0.0),
                    changes,
                    drives,
                    free_motions: Vec::new(),
                    other_continuations: None,
                    state,
                    jump: Some(Box::new(jump)),
                }));
            }
        }
        Ok(self)
    }

    /// Whether the friction of some contacts falls as they begin to slide.
    pub(super) fn friction_falls(&self) -> bool {
        !self.segment.problem.cones.is_empty()
    }

    /// What does not slide has its friction of rest, and is inside that cone.
    pub(super) fn friction_of_rest(&mut self) {
        let problem = &mut self.segment.problem;
        for (i, cone) in problem.cones.iter_mut().enumerate() {
            let rest = problem.sites[i].friction;
            if *cone != rest && !self.node.states[i].slides() {
                *cone = rest;
                if !self.node.stands[i].apex {
                    self.node.stands[i] = ActiveSet::NOWHERE;
                }
            }
        }
    }

    /// On a leg along which nothing changes, time passes: what slid comes to rest.
    pub(super) fn pause(&mut self) -> Vec<(usize, Change<C>)> {
        let segment = &self.segment;
        let is_still = matches!(&segment.course, Trajectory::Straight { rate, .. } if rate.norm() == 0.0)
            && segment.change.iter().all(|change| change.norm() == 0.0);
        let slides = |i: &usize| {
            self.node.states[*i].slides() && segment.problem.cone(*i) != segment.problem.sites[*i].friction
        };
        let rest: Vec<_> =
            if is_still { (0..segment.problem.len()).filter(slides).collect() } else { Vec::new() };
        for &i in &rest {
            (self.node.states[i], self.node.directions[i]) = (Mode::Sticking, None);
        }
        self.friction_of_rest();
        rest.into_iter().map(|i| (i, Change::Sticks)).collect()
    }

    /// The friction that contacts have after these changes, and the jump that comes of it if some begin to slide.
    pub(super) fn friction_after(
        &mut self,
        journey: &Journey<'g, D, C>,
        changes: &[(usize, Change<C>)],
    ) -> Result<Option<Box<Jump<C>>>, PathEnd<C>> {
        self.friction_of_rest();
        let begin = self.begin_to_slide(changes);
        // With other friction it goes on otherwise.
        self.at_node |= !begin.is_empty();
        Ok(self.jump(journey, &begin)?.map(Box::new))
    }

    /// Those that begin to slide with less friction than at rest.
    pub(super) fn begin_to_slide(&self, changes: &[(usize, Change<C>)]) -> Vec<usize> {
        let problem = &self.segment.problem;
        let falls = |(i, change): &(usize, Change<C>)| {
            let begins = matches!(change, Change::Slides { .. } | Change::ClosesSliding { .. });
            let site = &problem.sites[*i];
            (begins && site.kinetic.is_some() && problem.cone(*i) == site.friction).then_some(*i)
        };
        changes.iter().filter_map(falls).collect()
    }

    /// The leg along which what is missing is let go, these having begun to slide here. At its end the load is `goal`.
    fn let_go(
        &self,
        goal: &Vector<D>,
        begin: &[usize],
        journey: &Journey<'g, D, C>,
    ) -> Result<Self, PathEnd<C>> {
        let mut segment = self.segment.at_rest(self.factor);
        let (mut states, mut forces) = (self.node.states.clone(), self.node.at.forces.clone());
        let mut from = segment.course.at(0.0);
        let problem = &mut segment.problem;
        for &i in begin {
            problem.cones[i] = problem.sites[i].kinetic.unwrap_or(problem.cones[i]);
            let stretch = problem.stretch(i, &self.node.at.twist);
            if let Some(answer) = problem.local(i).relaxed(&stretch) {
                from += &problem.sites[i].map * (forces[i] - answer.force);
                (states[i], forces[i]) = (answer.state, answer.force);
            }
        }
        // What sets out on a round cone right here has no direction yet that others could take over.
        let has_none = |i: usize| states[i].slide().is_some() && tangential_norm(&forces[i]) == 0.0;
        if (0..states.len()).any(has_none) {
            return Err(journey.undecided(0.0, Doubt::OnTheBoundary));
        }
        problem.wrench.clone_from(&from);
        let rate = goal - &from;
        segment.course = Trajectory::Straight { from, rate };
        let slide_on: Vec<_> =
            (0..states.len()).filter(|i| states[*i].slides() && !begin.contains(i)).collect();
        let mut node = Node::at_start(&mut segment, Found::new(states, forces, self.node.at.twist.clone()));
        node.holds.clone_from(&self.node.holds);
        for i in slide_on {
            if node.stands[i].is_nowhere() {
                node.stands[i] = self.node.stands[i].clone();
            }
        }
        segment.largest = self.segment.largest;
        let mut leg = Self { at_node: true, ..Self::standing(segment, node) };
        leg.pace.steps = self.pace.steps + 1;
        Ok(leg)
    }

    /// Goes over to where the object comes to rest when the friction of these falls. `None` where they have none to lose.
    pub(super) fn jump(
        &mut self,
        journey: &Journey<'g, D, C>,
        begin: &[usize],
    ) -> Result<Option<Jump<C>>, PathEnd<C>> {
        if begin.is_empty() {
            return Ok(None);
        }
        // Where contacts that slide together stick and slip in turn there are ever more jumps, the less friction falls.
        if self.pace.steps >= journey.settings.most_steps {
            return Err(journey.undecided(self.factor, Doubt::OutOfSteps));
        }
        let goal = self.segment.course.at(self.factor);
        let end_here = |end| match end {
            PathEnd::Undecided { doubt, .. } => journey.undecided(self.factor, doubt),
            end => end,
        };
        let leg = self.let_go(&goal, begin, journey).map_err(end_here)?;
        if leg.segment.course.rate_at(0.0).norm() == 0.0 {
            self.segment.problem.cones = leg.segment.problem.cones;
            return Ok(None);
        }
        let (slips, slid) = (self.segment.problem.slips.clone(), vec![false; self.node.states.len()]);
        let mut fall = Fall { leg, slips, slid, changes: Vec::new() };
        fall.note(&[]);
        if let Err(end) = fall.go(&goal, journey) {
            let PathEnd::Lost(loss) = end else { return Err(end_here(end)) };
            let (fraction, load) = (self.factor, journey.program.load_at(self.factor));
            let loss = Loss { fraction, load, jumped: fall.slips(journey), ..*loss };
            self.fallen = Some(fall.leg.segment.problem_at(1.0));
            return Err(PathEnd::Lost(Box::new(loss)));
        }
        let slips = fall.slips(journey);
        let before = std::mem::replace(&mut self.node, fall.leg.node).at;
        let problem = &mut self.segment.problem;
        let relaxed = fall.leg.segment.problem;
        for (i, slip) in relaxed.slips.iter().enumerate() {
            problem.drives[i] -= slip - problem.slips[i];
        }
        (problem.slips, problem.cones) = (relaxed.slips, relaxed.cones);
        self.segment.largest = self.segment.largest.max(fall.leg.segment.largest);
        self.step_error += fall.leg.step_error;
        self.pace.steps = fall.leg.pace.steps;
        let energy = self.energy_of(&goal, &before.forces, &before.twist);
        if let Some(leg) = self.energy.last_mut() {
            leg.add_part(&energy);
        }
        self.here = None;
        let inaccurate = || journey.undecided(self.factor, Doubt::Inaccurate);
        let stands = self.standing_here(journey).ok_or_else(inaccurate)?;
        let state = self.state_on(&stands, self.factor).filter(|state| state.residuals.worst() <= ACCURATE);
        let state = state.ok_or_else(inaccurate)?;
        self.here = Some(stands.here.clone());
        self.behind.push(stands);
        let (changes, _): (Vec<ContactChange<C>>, _) = journey.grasp.contacts_and_drives(fall.changes);
        Ok(Some(Jump { changes, slips, energy_lost: energy.dissipated, state }))
    }

    /// Of a jump from these forces and this twist: what springs do not take up is lost.
    fn energy_of(&self, load: &Vector<D>, forces: &[SVector<f64, C>], twist: &Vector<D>) -> LegEnergy {
        let works = load.component_mul(&(&self.node.at.twist - twist));
        let mut energy =
            LegEnergy { load_work: works.sum(), turnover: works.map(f64::abs).sum(), ..LegEnergy::default() };
        energy.store(self.segment.grasp.sites(), forces, &self.node.at.forces);
        energy.dissipated = energy.load_work - energy.stored;
        energy
    }
}

/// Whether there is an equilibrium at the load of a jump that was not caught, with the friction that is left.
pub(super) fn beyond_a_jump<D: Size, const C: usize>(
    fallen: &Problem<'_, D, C>,
    settings: &Settings,
) -> Beyond<C> {
    match settle(fallen, settings).0 {
        Settled::Found(..) => Beyond::Snap,
        Settled::Undecided(doubt) => Beyond::Undecided { doubt },
        _ => Beyond::LimitLoad,
    }
}
