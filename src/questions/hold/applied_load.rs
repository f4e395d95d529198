//! The verdict on a load. The load path leads from the base load (load factor 0) to the whole load (factor 1). It is followed further, to the load
//! factor `Settings::most_load` or to the loss of equilibrium. The base load acts before the load grows; at rest means under it. At first slip the
//! first contact ceases to stick, or the first drive yields. Motions are small within the limits of rotation, slip and opening up to which the linear
//! theory is trusted. A drive is the spring of a joint or tendon of a hand, with its force limit. A jump is a motion under constant load to another
//! equilibrium. A command is the displacement that a finger would make if there were no object.

use core::mem::{Discriminant, discriminant};

use nalgebra::SVector;

use crate::contact::{Polygon, State};
use crate::equilibrium::{ContactAnswer, ContactState, Equilibrium, Outcome, Proof};
use crate::error::{Error, is_moderate};
use crate::grasp::{Coordinates, Engine, Wrench};
use crate::load_path::{Event, Leg, LoadPath, Loss, PathEnd, Ramp};
use crate::object::Load;
use crate::proofs::nothing_near;
use crate::search::{Doubt, SearchOutcome, Settings};

use super::caught_jump::CaughtJump;
use super::first_slip::{begins_to_slide, rest_that_slips};
use super::verdict::{FirstSlip, Holding, Lost, NoEquilibriumNear, Verdict};
use super::way_out::WayOut;
use crate::numerics::tolerances::NEGLIGIBLE;
use crate::numerics::{IntoList, add_times, largest, mapped};
use crate::prelude::*;

/// How far [`Engine::hold_with`] follows the load path, and which fields of the verdict it computes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum VerdictScope {
    /// All fields of the [`Verdict`]. The path is followed to `Settings::most_load`, to the loss of equilibrium or to the end of small motions.
    Whole,
    /// All fields of the [`Verdict`]. If motions cease to be small before the whole load is reached, the path is followed further, to the whole load
    /// or the loss. [`PathFacts::farthest`] is then the largest ratio of a motion to its limit up to there.
    Measured,
    /// The path is followed as for `Measured`: to the whole load or the loss, even if motions cease to be small before. Three things are not
    /// computed: the proof that no equilibrium exists near the loss, the data that only sentences need, and the fraction of the base load at which
    /// equilibrium is lost. That fraction needs a second path, on which the base load grows from zero.
    Decided,
    /// Only the fields that a [`super::ShortVerdict`] needs: no equilibria, no proofs and no data for sentences. The path is followed to
    /// `Settings::most_load`, to the loss of equilibrium or to the end of small motions.
    Brief,
}

/// Facts about the load path that [`Engine::hold_with`] returns in addition to the [`Verdict`].
#[derive(Debug, Default)]
pub(crate) struct PathFacts {
    /// The largest ratio of a rotation, slip or opening to its limit in [small motions](crate::Settings::small_motions), up to the whole load or the
    /// end of the path. For [`VerdictScope::Brief`] the path may reach beyond the whole load.
    pub(crate) farthest: f64,
    /// The equilibrium under the base load. `None` if no such equilibrium was found, and for [`VerdictScope::Brief`].
    pub(crate) at_rest: Option<AtRest>,
    /// Number of jumps, i.e. motions under constant load, while the load is put on: a contact catches the object, or friction falls to its kinetic
    /// value. It is 0 for [`VerdictScope::Brief`].
    pub(crate) jumps: usize,
}

/// The equilibrium under the base load, from which the growing load is put on.
#[derive(Debug, Clone)]
pub(crate) struct AtRest {
    pub(crate) contacts: Vec<RestingContact>,
    /// The contact states (open, sticking, sliding) and drive states in this equilibrium, if a search found them; otherwise empty.
    pub(crate) states: Vec<State>,
}

/// The state of a contact in the equilibrium under the base load, and its distances from the end of this state.
#[derive(Debug, Clone, Copy)]
pub(crate) struct RestingContact {
    /// Whether the contact is open, sticks, slides or has no friction.
    pub(crate) kind: Discriminant<ContactState<3>>,
    /// Two quantities that are positive in this state; one of them is zero where the state ends. Open: the gap. Sticking: normal force and friction
    /// margin. Sliding: normal force and slip. Frictionless: normal force. If there is no second quantity, the second number is infinity.
    pub(crate) margins: [f64; 2],
}

impl RestingContact {
    fn of(contact: &ContactAnswer<3>) -> Self {
        let force = contact.normal_force();
        let margins = match contact.state {
            ContactState::Separated => [contact.gap, f64::INFINITY],
            ContactState::Sticking => [force, contact.margin],
            ContactState::Sliding { .. } => [force, contact.slip.norm()],
            ContactState::Frictionless => [force, f64::INFINITY],
        };
        Self { kind: discriminant(&contact.state), margins }
    }
}

impl Engine {
    pub(crate) fn hold(&self, ramp: &Ramp<3>, settings: &Settings) -> Result<Verdict<3>, Error> {
        Ok(self.hold_with(ramp, settings, VerdictScope::Whole)?.0)
    }

    pub(crate) fn hold_with(
        &self,
        ramp: &Ramp<3>,
        settings: &Settings,
        extent: VerdictScope,
    ) -> Result<(Verdict<3>, PathFacts), Error> {
        if !(settings.most_load > 0.0 && is_moderate(settings.most_load)) {
            let (what, allowed) = ("most_load of the settings", "more than 0 and at most 1e50");
            return Err(Error::Argument { what, value: settings.most_load, allowed });
        }
        let brief = if extent == VerdictScope::Brief { self.held_in_slips(ramp, settings) } else { None };
        brief.map_or_else(|| self.held_on_a_path(ramp, settings, extent), Ok)
    }

    fn held_on_a_path(
        &self,
        ramp: &Ramp<3>,
        settings: &Settings,
        extent: VerdictScope,
    ) -> Result<(Verdict<3>, PathFacts), Error> {
        // The search for first slip and the load path share the equilibrium under the base load. With many bodies, finding this equilibrium takes
        // most of the time.
        let (onset, rest) = self.onset_from_rest(ramp, settings)?;
        let states = match &rest {
            Some((SearchOutcome::Found(found, _), _)) => found.states.clone(),
            _ => Vec::new(),
        };
        let mut path = self.follow_from_rest((&ramp.base, rest), &[Leg::along(ramp)], settings)?;
        let events = path.run_while_small();
        let is_on = matches!(path.end(), Some(PathEnd::Completed)) && path.end_of_small_motions().is_none();
        let state = is_on.then(|| path.state()).flatten();
        if matches!(extent, VerdictScope::Measured | VerdictScope::Decided)
            && path.end_of_small_motions().is_some()
        {
            path.run();
        }
        let mut farthest = path.farthest();
        let mut largest_factor = 1.0;
        if is_on && settings.most_load > 1.0 {
            largest_factor = settings.most_load;
            path.continue_with(&[Leg::along(&ramp.times(largest_factor - 1.0))])?;
            path.run_while_small();
        }
        farthest = if extent == VerdictScope::Brief { path.farthest() } else { farthest };
        let reached = |(leg, fraction): (usize, f64)| {
            if leg == 0 { fraction } else { 1.0 + fraction * (largest_factor - 1.0) }
        };
        let too_far = self.end_of_theory(&path, ramp);
        let end = too_far.as_ref().map_or(path.place(), |far| (far.leg, far.fraction));
        // If the object turns over under the whole load, too, the verdict says along which motion, with the forces there.
        let turns_over = state.as_ref().and_then(|state| self.driven_on(state, &ramp.load_at(1.0)));
        let unstable = too_far.as_ref().is_some_and(|far| far.what.is_unstable());
        let state = state.filter(|_| too_far.is_none() || end.0 > 0 || turns_over.is_some());
        let held_to = reached(end);
        // If first slip causes a jump whose motion is not small, small motions end at the load factor of first slip. If the computed load factor of
        // first slip exceeds that of the end of small motions by rounding only, first slip still counts.
        let is_small = |first: &FirstSlip| too_far.is_none() || first.factor <= held_to * (1.0 + NEGLIGIBLE);
        let start = rest_that_slips(&onset, &path);
        let first_slip = self.first_slip(&onset, &events, start.as_ref()).filter(is_small);
        let while_on = state.is_some().then(|| path.everything_slides_from((1, 0.0))).flatten();
        let everything_slides = while_on.or_else(|| path.everything_slides_from(end)).map(reached);
        let holding = match &state {
            Some(state) => match turns_over {
                Some(motion) => Holding::TurnsOver { motion },
                None => self.holding(state, &events, first_slip.as_ref()),
            },
            None if too_far.is_some() => Holding::Lost,
            None => self.holding_of_end(&path, &ramp.base, settings, extent),
        };
        let went_too_far = too_far.as_ref().map(|far| {
            let state = path.state_at(far.leg, far.fraction);
            self.gone_too_far(held_to, &far.what, state, everything_slides)
        });
        let lost = path.end().and_then(PathEnd::loss).filter(|_| too_far.is_none()).map(|loss| {
            let mut lost = self.lost(held_to, loss, path.state());
            if matches!(extent, VerdictScope::Brief | VerdictScope::Decided) {
                return lost;
            }
            let at_first =
                first_slip.as_ref().is_some_and(|first| held_to <= first.factor * (1.0 + NEGLIGIBLE));
            if self.weaker_once_they_slide().next().is_some() {
                lost.falls_at_once = at_first;
                let then = self.carried_while_it_slides(ramp, settings);
                lost.then_takes = then.filter(|then| *then < held_to * (1.0 - NEGLIGIBLE));
            }
            // The proof that no equilibrium exists near the loss assumes that the vacuum of every suction cup lasts. It is therefore not tried if, at
            // the loss, a cup lets go because its lip is open all around.
            if matches!(holding, Holding::Lost) && !matches!(lost.way_out, WayOut::LetsGo { .. }) {
                lost.nothing_near = self.nothing_near(&lost, loss, ramp, settings);
            }
            lost
        });
        let mut verdict = Verdict {
            base: ramp.base,
            load: ramp.direction,
            holding,
            first_slip,
            caught: Vec::new(),
            held_to,
            everything_slides,
            left_out: None,
            swing: None,
            lost: went_too_far.or(lost),
            state: None,
        };
        if extent == VerdictScope::Brief {
            verdict.lost.iter_mut().for_each(|lost| lost.state = None);
            return Ok((verdict, PathFacts { farthest, ..Default::default() }));
        }
        let rest = path.state_at(0, 0.0);
        let contacts = rest.as_ref().map(|rest| mapped(&rest.contacts, &RestingContact::of));
        let at_rest = contacts.map(|contacts| AtRest { contacts, states });
        let jumps = events.iter().filter(|event| event.jump.is_some()).count();
        let of_the_path = PathFacts { farthest, at_rest, jumps };
        if extent == VerdictScope::Decided {
            return Ok((verdict, of_the_path));
        }
        let there = state.as_ref().or_else(|| verdict.lost.as_ref()?.state.as_deref());
        let moved = rest.filter(|_| ramp.command_change.is_none() && ramp.joint_change.is_none());
        let left_out = there.and_then(|there| self.left_out_between(moved.as_ref(), there));
        // A grasp that buckles before the whole load acts is not also reported as near to buckling.
        verdict.left_out = left_out.filter(|_| state.is_some() || !unstable);
        self.let_swing(&mut verdict, ramp, settings);
        verdict.caught = CaughtJump::among(self.wholes(), &events);
        verdict.state = state.map(Box::new);
        Ok((verdict, of_the_path))
    }

    /// The conclusion [`Holding`] if the path ended before it reached the whole load. There are three cases: equilibrium was lost, no equilibrium was
    /// found at the start, or the path could not be continued.
    fn holding_of_end(
        &self,
        path: &LoadPath<'_, 3>,
        base: &Wrench<3>,
        settings: &Settings,
        extent: VerdictScope,
    ) -> Holding<3> {
        let inaccurate = Holding::Undecided { doubt: Doubt::Inaccurate };
        let or_at_rest = |otherwise: Holding<3>| {
            // It takes up to a thousand times as long to follow the base load from zero as to follow the load on top of it. The scope `Decided`
            // therefore leaves it out.
            if extent == VerdictScope::Decided {
                return otherwise;
            }
            self.lost_at_rest(base, settings).map_or(otherwise, |at_rest| Holding::LostAtRest { at_rest })
        };
        match path.end() {
            // If no equilibrium is known at the loss, the path was lost at its start, under the base load alone: contacts slide there, their friction
            // falls to the kinetic value, and the object finds no other equilibrium. The grasp then does not hold the base load.
            Some(PathEnd::Lost(_)) if path.state().is_none() => or_at_rest(Holding::Lost),
            Some(PathEnd::Lost(_)) => Holding::Lost,
            Some(PathEnd::NoStart(start)) => match &**start {
                Outcome::NoEquilibrium(none) => {
                    let names_no_motion = matches!(
                        none.proof,
                        Proof::EveryStateTried { .. } | Proof::EveryCaseContradicted { .. }
                    );
                    let needs_loss_at_rest = names_no_motion && matches!(extent, VerdictScope::Whole);
                    let at_rest = needs_loss_at_rest.then(|| self.lost_at_rest(base, settings)).flatten();
                    Holding::NoRest { none: none.clone(), at_rest }
                }
                Outcome::Undecided(undecided) => or_at_rest(Holding::Undecided { doubt: undecided.doubt }),
                Outcome::Equilibrium(_) => inaccurate,
            },
            Some(PathEnd::Undecided { doubt, .. }) => Holding::Undecided { doubt: *doubt },
            Some(PathEnd::Completed) | None => inaccurate,
        }
    }

    /// The loss of equilibrium on a separate path. On it the base load and the commands grow together from zero. `None` if this path reaches both in
    /// full.
    fn lost_at_rest(&self, base: &Wrench<3>, settings: &Settings) -> Option<Box<Lost<3>>> {
        let growing = self.growing_from_nothing(base);
        let direction = if growing.is_some() { Wrench::from_components(&[1.0]) } else { *base };
        let commands: Vec<_> = mapped(self.contacts(), &|contact| contact.command);
        let none = vec![SVector::zeros(); self.len()];
        let grasp = growing.as_ref().unwrap_or(self).with_commands(&none).ok()?;
        let leg = Leg::along(&Ramp::load(Wrench::ZERO, direction).with_commands(commands));
        let mut path = grasp.follow(&Wrench::ZERO, &[leg], settings).ok()?;
        path.run();
        let loss = path.end().and_then(PathEnd::loss)?;
        let lost = grasp.lost(path.place().1, loss, path.state());
        // The equilibrium at this loss carries only a fraction of the base load. It is left out of the answer, whose equilibria carry the load of the
        // verdict.
        Some(Box::new(Lost { state: None, ..lost }))
    }

    /// The conclusion [`Holding`] if the whole load is held: [`Holding::Loose`], [`Holding::Sticks`] or [`Holding::Slides`]. A contact has slid if it
    /// slides under the whole load, slipped in a jump, or began to slide at an event of the path. The slip stored in the equilibrium is no sign of
    /// sliding: a contact that was open has a slip, too.
    fn holding(
        &self,
        state: &Equilibrium<3>,
        events: &[Event<3>],
        first_slip: Option<&FirstSlip>,
    ) -> Holding<3> {
        let jumps = || events.iter().filter_map(|event| event.jump.as_deref());
        let slips = jumps().map(|jump| mapped(&jump.slips, &|slip| slip.contact.index)).list().concat();
        let has_slid = |i: usize| {
            matches!(state.contacts[i].state, ContactState::Sliding { .. })
                || slips.contains(&i)
                || events.iter().any(|event| begins_to_slide(event, i))
        };
        // Zero force at every contact means that the object lies loose, unless a vacuum acts, which may hold the object.
        if self.vacuum().is_none() && state.contacts.iter().all(|contact| contact.force.norm() == 0.0) {
            return Holding::Loose;
        }
        let parts = self.wholes().with(&has_slid);
        if parts.is_empty() && jumps().count() == 0 && first_slip.is_none_or(|first| first.factor > 1.0) {
            Holding::Sticks
        } else {
            Holding::Slides { contacts: parts }
        }
    }

    /// A proof that no equilibrium under the whole load exists near the loss. `None` if the equilibrium at the loss is not known, if the load is not
    /// finite or beyond 1e50, and if no proof is found.
    fn nothing_near(
        &self,
        lost: &Lost<3>,
        loss: &Loss<3>,
        ramp: &Ramp<3>,
        settings: &Settings,
    ) -> Option<NoEquilibriumNear> {
        let state = lost.state.as_ref()?;
        let load = self.load_alone(&ramp.load_at(1.0), "load").ok()?;
        let mut offsets = self.offsets();
        add_times(&mut offsets, &ramp.offset_changes(self).ok()?, 1.0);
        let polygon = Polygon::shared(self.space(), &settings.cone);
        let problem = self.problem(polygon, settings.is_round(self.space()), offsets, &Load::from(&load));
        let at = state.local.twist.to();
        // Any virtual motion may give the proof. Two are tried: the motion with which the object leaves at the loss, which usually gives the proof,
        // and the direction of the load. The proof that covers the larger neighbourhood of the loss is returned.
        let virtually = [loss.virtual_motion().map(Coordinates::to), Some(load)];
        let radii = virtually.into_iter().flatten().filter_map(|v| nothing_near(&problem, &at, &v));
        let radius = radii.max_by(f64::total_cmp)?;
        let lengths = self.bodies().map_or_else(Vec::new, |bodies| self.rotation_lengths(bodies));
        let longest = self.length().max(largest(&lengths, &|length| *length));
        Some(NoEquilibriumNear { translation: radius, rotation: radius / longest })
    }
}
