//! Ascent from one starting grasp to a local optimum of places and commanded normal forces. A place is the position of a contact on its curve or
//! surface. The commanded normal force of a contact is that which its command causes with the object held in place. A design point is one choice of
//! all of these. The goal is the value that the search maximises: the load factor of first slip, or the reserve. The reserve is the least margin of a
//! contact force to the boundary of its friction cone, N. The base load acts before the loads of the question grow. An idle contact is open or
//! touches without force under the base load, and stays so until a load pushes it.

use nalgebra::DVector;

use super::answer::SearchEnd;
use super::by_source::{LOADS, REST, SQUEEZE, StickingForces};
use super::curvature::Curvature;
use super::design_point::{DesignKind, DesignPoint, DesignSpace};
use super::events::{Constraint, ConstraintKind, SlipEvent, events};
use super::goal::ImproveGoal;
use super::loaded::LoadSet;
use super::step::{StepProgram, TrialStep};
use super::tolerances::{ARRIVED_AT_TOP, OPTIMAL, ROUNDED_GAIN};
use crate::ask::Grasp;
use crate::contact::ActiveSet;
use crate::equilibrium::ContactState;
use crate::error::Error;
use crate::numerics::tolerances::{NEGLIGIBLE, SOLVED_ROUNDING};
use crate::numerics::{Reals, all_some, keep, least, mapped, numbered};
use crate::prelude::*;

/// A [`DesignPoint`] with which all contacts stick under the base load and the commands, except idle ones, which touch without force. Its contact
/// forces are stored apart for the base load with fixed commands, the variable commands, and each load.
#[derive(Debug)]
pub(super) struct EvaluatedDesign {
    pub(super) design_point: DesignPoint,
    /// The contact forces, computed once or several times. In the first part all idle contacts (touching without force) are open. A load that closes
    /// some idle contacts needs a further part, in which these are closed.
    pub(super) parts: Vec<StickingForces>,
    /// Value of the goal: the least load factor of first slip, or the least reserve (margin of a contact force to the boundary of its friction cone),
    /// N.
    pub(super) value: f64,
    /// The scale by which gains of the value are divided. If the goal is first slip, it is the value itself; for a reserve it is the greatest contact
    /// force under the base load, N.
    pub(super) scale: f64,
}

/// The end of an ascent from one starting grasp: the last design, and why the ascent stopped.
pub(super) struct Ascent {
    pub(super) design: EvaluatedDesign,
    pub(super) search: SearchEnd,
    /// Number of steps tried so far, including the steps of earlier ascents from the same starting grasp.
    pub(super) steps: usize,
    /// The last step, whose multipliers show which conditions and limits prevent a larger value; `None` if no step was computed.
    pub(super) last: Option<LastStep>,
}

/// A step of the search. The sticking conditions under loads (`events`) and the limits (`bounds`) were constraints of its quadratic program, which
/// has a multiplier for each.
pub(super) struct LastStep {
    pub(super) step: TrialStep,
    pub(super) events: Vec<SlipEvent>,
    pub(super) bounds: Vec<Constraint>,
    /// For each edge of a surface, segment or triangle that bounds the step, the index of the contact on this edge. In the list of multipliers of the
    /// step, those of these edges follow those of the limits `bounds`.
    pub(super) rooms: Vec<usize>,
}

/// The data that all ascents of a search share: the variables (places and commanded normal forces), the loads and the given grasp.
pub(super) struct AscentProblem<'q> {
    pub(super) design_space: &'q DesignSpace<'q>,
    pub(super) loaded: &'q LoadSet,
    pub(super) grasp: &'q Grasp<3>,
}

impl AscentProblem<'_> {
    /// For each contact the greatest allowed normal force, N; `None` if its command may not change.
    fn greatest_presses(&self) -> Vec<Option<f64>> {
        let mut most = vec![None; self.design_space.contacts.len()];
        for variable in &self.design_space.variables {
            if let DesignKind::Press { most: force } = variable.what {
                most[variable.contact] = Some(force);
            }
        }
        most
    }

    /// The [`EvaluatedDesign`] of a design point. If a contact's normal force under the base load exceeds its limit, all variable normal forces of
    /// commands are reduced by a common factor. `None` if a force exceeds its limit even without these commands, or some contact does not stick under
    /// the base load.
    pub(super) fn evaluate(&self, mut design_point: DesignPoint) -> Result<Option<EvaluatedDesign>, Error> {
        let most = self.greatest_presses();
        let Some(mut sticking) = self.forces(&design_point, &design_point.idle)? else { return Ok(None) };
        let mut part = 1.0_f64;
        for (i, most) in most.iter().enumerate() {
            let (rest, squeeze) = (sticking.by(REST, i)[0], sticking.by(SQUEEZE, i)[0]);
            if let Some(most) = most
                && rest + squeeze > *most
            {
                part = part.min((most - rest) / squeeze);
            }
        }
        if part < 0.0 || part.is_nan() {
            return Ok(None);
        }
        if part < 1.0 {
            design_point.presses.iter_mut().flatten().for_each(|press| *press *= part);
            let Some(again) = self.forces(&design_point, &design_point.idle)? else { return Ok(None) };
            sticking = again;
        }
        self.evaluate_sticking(design_point, sticking, &most)
    }

    /// The contact forces of a design point, with the contacts in `open` left open; `None` if nothing resists a load.
    fn forces(&self, design_point: &DesignPoint, open: &[bool]) -> Result<Option<StickingForces>, Error> {
        let LoadSet { base, loads, .. } = self.loaded;
        StickingForces::of(self.design_space, design_point, open, (base, loads))
    }

    /// Value of the goal for the given grasp with its own commands; `None` if a contact slides under the base load or, for a reserve, under a load.
    pub(super) fn before(&self, given: &DesignPoint) -> Result<Option<f64>, Error> {
        if self.loaded.goal == ImproveGoal::FirstSlip {
            let first = self.loaded.first_slip(self.grasp)?.filter(|factor| *factor > 0.0);
            return if first.is_some() { Ok(first) } else { self.slips_at_once() };
        }
        let n = self.design_space.contacts.len();
        let (spots, presses) = (vec![None; n], vec![None; n]);
        let design_point = DesignPoint { spots, presses, ..given.clone() };
        let sticking = self.forces(&design_point, &design_point.idle)?;
        let design = sticking
            .map(|sticking| self.evaluate_sticking(design_point, sticking, &vec![None; n]))
            .transpose()?;
        Ok(design.flatten().map(|design| design.value).filter(|reserve| *reserve >= 0.0))
    }

    /// The [`EvaluatedDesign`] of a design point with known contact forces; `None` if some contact does not stick under the base load or the normal
    /// force of a contact exceeds the limit in `most`.
    fn evaluate_sticking(
        &self,
        design_point: DesignPoint,
        sticking: StickingForces,
        most: &[Option<f64>],
    ) -> Result<Option<EvaluatedDesign>, Error> {
        let (mut known, bounds) = events(self.loaded, most, core::slice::from_ref(&sticking), &[]);
        let size = (0..most.len()).map(|i| sticking.at_rest(i).norm()).most();
        if bounds.iter().any(|bound| bound.left < -SOLVED_ROUNDING * size) {
            return Ok(None);
        }
        let first = match self.loaded.goal {
            ImproveGoal::FirstSlip => {
                let factor = self.loaded.first_slip(&sticking.grasp)?.filter(|factor| *factor > 0.0);
                let Some(factor) = factor else { return Ok(None) };
                factor
            }
            ImproveGoal::Reserve => 1.0,
        };
        let Some(parts) = self.parts(&design_point, sticking, first, SOLVED_ROUNDING * size)? else {
            return Ok(None);
        };
        if parts.len() > 1 {
            known = events(self.loaded, most, &parts, &[]).0;
        }
        let (value, scale) = match self.loaded.goal {
            ImproveGoal::FirstSlip => {
                // A contact without force under the base load breaks its sticking conditions at load factor 0. Its load factor says nothing about the
                // load that the grasp can bear, so such a design is refused, unless the contact is idle.
                let is_weightless = |event: &SlipEvent| {
                    let force = parts[0].at_rest(event.condition.contact);
                    event.value <= NEGLIGIBLE * first && ActiveSet::is_weightless(&force, size)
                };
                if known.iter().any(is_weightless) {
                    return Ok(None);
                }
                (first, first)
            }
            // A negative reserve means that a contact slides under a load. Such a design is kept, because the gradient of its reserve leads to better
            // positions of the contacts.
            ImproveGoal::Reserve => {
                let least = least(&known, &|event| event.value);
                (least, if size > 0.0 { size } else { self.design_space.unit_of_force() })
            }
        };
        Ok(Some(EvaluatedDesign { design_point, parts, value, scale }))
    }

    /// The contact forces in one or several sets. The first set leaves all idle contacts open. A load closes an idle contact if it presses it by more
    /// than `rounded`, N, at the load factor `first`; such a load needs a further set with these contacts closed. `None` if nothing resists a load.
    fn parts(
        &self,
        design_point: &DesignPoint,
        mut sticking: StickingForces,
        first: f64,
        rounded: f64,
    ) -> Result<Option<Vec<StickingForces>>, Error> {
        let mut further: Vec<StickingForces> = Vec::new();
        for load in sticking.judged.clone() {
            let closes = |i: usize| {
                let closing = sticking.closing_at_rest(i) + first * sticking.by(LOADS + load, i)[0];
                sticking.is_open(i) && closing > rounded
            };
            let open = numbered(design_point.idle.len(), &|i| design_point.idle[i] && !closes(i));
            if open == design_point.idle {
                continue;
            }
            keep(&mut sticking.judged, &|judged| *judged != load);
            if let Some(known) = further.iter_mut().find(|known| known.open == open) {
                known.judged.push(load);
                continue;
            }
            let Some(mut part) = self.forces(design_point, &open)? else { return Ok(None) };
            part.judged = vec![load];
            further.push(part);
        }
        further.insert(0, sticking);
        Ok(Some(further))
    }

    /// For each contact whether it is idle: it is open or touches without force under the base load, and at least one load does not close it. No
    /// contact is idle if the question has a force of any direction, since some direction pushes the object against each contact.
    pub(super) fn idle(&self, given: &DesignPoint) -> Result<Vec<bool>, Error> {
        let none = vec![false; given.idle.len()];
        if self.loaded.any.is_some() {
            return Ok(none);
        }
        let outcome = self.grasp.solve(self.loaded.base)?;
        let Some(equilibrium) = outcome.equilibrium() else { return Ok(none) };
        let idle = mapped(&equilibrium.contacts, &|contact| contact.state == ContactState::Separated);
        if !idle.contains(&true) {
            return Ok(none);
        }
        let Some(design) = self.evaluate(given.with_idle(&idle))? else { return Ok(idle) };
        let is_left_open =
            |i: usize| design.parts.iter().any(|part| part.is_open(i) && !part.judged.is_empty());
        Ok(numbered(idle.len(), &is_left_open))
    }

    /// Returns zero as the load factor of first slip if the given grasp holds the base load without sliding, but a contact touches without force.
    /// Such a contact slides under an arbitrarily small load. `None` if a contact slides or has a gap under the base load, or if no contact touches
    /// without force.
    fn slips_at_once(&self) -> Result<Option<f64>, Error> {
        let outcome = self.grasp.solve(self.loaded.base)?;
        let Some(equilibrium) = outcome.equilibrium() else { return Ok(None) };
        let mut touches_without_force = false;
        for contact in &equilibrium.contacts {
            match contact.state {
                ContactState::Separated if contact.gap <= NEGLIGIBLE * self.grasp.engine.length() => {
                    touches_without_force = true;
                }
                ContactState::Separated | ContactState::Sliding { .. } => return Ok(None),
                _ => {}
            }
        }
        Ok(touches_without_force.then_some(0.0))
    }

    /// Ascent from `design` to a local optimum. Each contact stays on the part of its surface where it starts, such as one triangle of a mesh.
    /// `steps` is the number of steps tried before from the same start; the steps of this ascent are added to it.
    pub(super) fn ascend(&self, mut design: EvaluatedDesign, mut steps: usize) -> Result<Ascent, Error> {
        let n = self.design_space.variables.len();
        // Half widths of the trust region (a box), relative to the unit of each variable: the grasp's size for places, the greatest force for
        // commanded normal forces.
        let [first_radius, largest_radius, least_radius] = [0.1, 1.0, 1e-11];
        let (mut radius, mut curvature) = (first_radius, Curvature::flat(n));
        let ended = |design, search, steps, last| Ok(Ascent { design, search, steps, last });
        let mut before: Option<LastStep> = None;
        loop {
            if design.value.is_infinite() {
                return ended(design, SearchEnd::NothingSlides, steps, None);
            }
            let by_part =
                design.parts.iter().map(|part| part.derivatives(self.design_space, &design.design_point));
            let Some(derivatives) = all_some(by_part) else {
                return ended(design, SearchEnd::Unbalanced, steps, None);
            };
            let (events, bounds) = events(self.loaded, &self.greatest_presses(), &design.parts, &derivatives);
            if let Some(old) = before.take() {
                let decrease = gradient_decrease(
                    &old,
                    (&events, &bounds),
                    design.scale,
                    self.design_space.unit_of_force(),
                );
                curvature.learn(&old.step.d, &decrease);
            }
            let (program, rooms) = self.program(&design, &events, &bounds);
            loop {
                let Some(step) = program.step(radius, &curvature.0) else {
                    return ended(design, SearchEnd::Stalled, steps, None);
                };
                let arrived =
                    step.residual <= ARRIVED_AT_TOP || step.gain <= ROUNDED_GAIN || radius < least_radius;
                if arrived || steps >= self.design_space.question.steps() {
                    // The curvature (a Hessian estimated from earlier steps) may be wrong at this design point. Then no step gains, although a
                    // direction of ascent exists. Before the ascent ends without an optimum, the curvature is reset and steps are tried again.
                    if arrived && step.residual > OPTIMAL && curvature.0.amax() > 0.0 {
                        (curvature, radius) = (Curvature::flat(n), first_radius.min(radius * 1e3));
                        continue;
                    }
                    // With several `parts`, a load closes an idle contact. Its friction force is computed as if it had stuck from the start, although
                    // it moves freely until it closes. So the multipliers prove no optimum.
                    if arrived && design.parts.len() > 1 {
                        return ended(design, SearchEnd::Stalled, steps, None);
                    }
                    let search = match step.residual {
                        residual if residual <= OPTIMAL => SearchEnd::Optimum,
                        _ if arrived => SearchEnd::Stalled,
                        _ => SearchEnd::OutOfSteps,
                    };
                    return ended(design, search, steps, Some(LastStep { step, events, bounds, rooms }));
                }
                steps += 1;
                let trial =
                    self.evaluate(self.design_space.stepped(&design.design_point, step.d.as_slice()))?;
                let gain = trial.as_ref().map_or(-1.0, |trial| (trial.value - design.value) / design.scale);
                let gain_ratio = gain / step.gain;
                // The trust region doubles if the gain exceeds three quarters of the predicted gain and the step reaches the boundary of the region.
                // It shrinks if the gain is below a quarter of the predicted gain.
                if gain_ratio > 0.75 && step.d.amax() >= 0.99 * radius {
                    radius = (2.0 * radius).min(largest_radius);
                } else if gain_ratio < 0.25 {
                    radius = 0.25 * radius.min(step.d.amax());
                }
                if let Some(trial) = trial.filter(|_| gain_ratio >= 1e-4) {
                    before = Some(LastStep { step, events, bounds, rooms });
                    design = trial;
                    break;
                }
            }
        }
    }

    /// Returns the quadratic program of a step, and a list of indices of contacts. The last constraints of the program keep contacts on their
    /// surface, segment or triangle. For each of these constraints, the list has the index of its contact.
    fn program(
        &self,
        design: &EvaluatedDesign,
        events: &[SlipEvent],
        bounds: &[Constraint],
    ) -> (StepProgram, Vec<usize>) {
        let variables = &self.design_space.variables;
        let force = self.design_space.unit_of_force();
        let mut rows: Vec<_> = mapped(bounds, &|bound| (&bound.gradient / force, bound.left / force));
        let (mut rooms, mut reach) = (Vec::new(), vec![[f64::NEG_INFINITY, f64::INFINITY]; variables.len()]);
        for (i, location) in design.design_point.spots.iter().enumerate() {
            let Some(location) = location else { continue };
            for (row, room) in &location.rooms {
                let unit = variables.iter().find(|v| v.contact == i).map_or(1.0, |v| v.unit);
                let mut of = DVector::zeros(variables.len());
                for (j, variable) in variables.iter().enumerate() {
                    if let DesignKind::Along(axis) = variable.what
                        && variable.contact == i
                    {
                        of[j] = -row[axis];
                    }
                }
                rows.push((of, room / unit));
                rooms.push(i);
            }
        }
        for (j, variable) in variables.iter().enumerate() {
            if let DesignKind::Press { most } = variable.what {
                let press = design.design_point.presses[variable.contact];
                reach[j] =
                    press.map_or([0.0; 2], |press| [-press / variable.unit, (most - press) / variable.unit]);
            }
        }
        let program = StepProgram {
            factors: mapped(events, &|event| 1.0 + (event.value - design.value) / design.scale),
            gradients: mapped(events, &|event| &event.gradient / design.scale),
            bounds: rows,
            reach,
        };
        (program, rooms)
    }
}

/// The gradient of the Lagrangian before the last step minus the gradient after this step. Both are with respect to the variables (places and
/// commanded normal forces), with the multipliers of the last step. The Lagrangian includes sticking conditions under loads and limits of normal
/// forces, but not sticking under the base load.
fn gradient_decrease(
    old: &LastStep,
    (events, bounds): (&[SlipEvent], &[Constraint]),
    scale: f64,
    force: f64,
) -> DVector<f64> {
    let step = &old.step;
    let mut decrease = DVector::zeros(step.d.len());
    for (event, share) in old.events.iter().zip(&step.events).filter(|(_, share)| **share > 0.0) {
        // Several entries of `events` may have the same sticking condition. The one whose value is nearest is taken as the same entry after the step.
        let same = events.iter().filter(|other| other.condition == event.condition);
        let apart = |other: &&SlipEvent| (other.value - event.value).abs();
        if let Some(same) = same.min_by(|a, b| apart(a).total_cmp(&apart(b))) {
            decrease += (&event.gradient - &same.gradient) * (share / scale);
        }
    }
    let is_force = |bound: &&Constraint| bound.kind == ConstraintKind::Force;
    let known = old.bounds.iter().zip(&step.bounds).filter(|(bound, _)| is_force(bound));
    for ((bound, multiplier), new) in known.zip(bounds.iter().filter(is_force)) {
        decrease += (&bound.gradient - &new.gradient) * (multiplier / force);
    }
    decrease
}
