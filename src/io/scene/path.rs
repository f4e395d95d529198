//! Answers to `follow`: the events along the load path of a load program. A leg is a section of the program. An event is a change of contact states
//! at one point of the path, or a joint or tendon that reaches its force limit there.

use serde::{Deserialize, Serialize};

use super::labels::SceneNames;
use crate::equilibrium::{Doubt, Equilibrium, Outcome};
use crate::load_path::{
    Beyond, EndOfSmallMotions, Event, Jump, LegEnergy, LoadPath, Loss, PathEnd, Step, SteppedPath,
};
use crate::numerics::{mapped, moved};
use crate::serial::AsComputed;

/// A load path that was followed to its end; see [`LoadPath`], and [`SteppedPath`] for a path that was followed in steps.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct PathAnswer<const C: usize> {
    /// The end of the path.
    #[serde(flatten)]
    pub end: PathOutcome<C>,
    /// The events on the path, in order; empty for a path in steps, which does not locate events.
    pub events: Vec<Event<C>>,
    /// The steps, in order, if the path was followed in steps; otherwise empty.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub steps: Vec<Step<C>>,
    /// The point of the path where motions cease to be small or the grasp buckles, if they do. Beyond this point the answer, which assumes the
    /// undeformed geometry of the grasp, is inaccurate.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub small_motions_end: Option<EndOfSmallMotions>,
    /// The least fraction of the springs' resistance that geometric stiffness adds or takes away on the way; see
    /// [`Verdict::left_out`](crate::hold::Verdict::left_out).
    #[serde(default, skip_serializing_if = "Option::is_none", with = "AsComputed::<Option<f64>>")]
    pub left_out: Option<f64>,
    /// The energies of each leg (section) of the load program that the path has reached; empty for a path in steps.
    pub energies: Vec<BalancedEnergy>,
    /// Sum of the estimated errors of the steps along pieces of the path on which slip directions turn. Each error is relative in the sense of
    /// [`Settings::step_error`](crate::Settings::step_error). The sum is 0 if slip directions never turn. For a path in steps, see
    /// [`SteppedPath::step_error`].
    #[serde(with = "AsComputed::<f64>")]
    pub step_error: f64,
}

/// The end of a load path, with the equilibrium at this end; see [`PathEnd`].
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(tag = "outcome", rename_all = "snake_case")]
#[non_exhaustive]
pub enum PathOutcome<const C: usize> {
    /// All legs (sections) of the load program were followed to their end.
    Completed {
        /// The equilibrium at the end. It is left out if rounding errors are too large for it, or if no leg was given.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        state: Option<Box<Equilibrium<C>>>,
    },
    /// The equilibrium is lost: it cannot be continued under the load program.
    Lost {
        /// The point of the path at which equilibrium is lost, and the reason.
        #[serde(flatten)]
        loss: Loss<C>,
        /// Whether another equilibrium exists just beyond the loss.
        beyond: Beyond<C>,
        /// The equilibrium at the loss; left out if rounding errors are too large for it.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        state: Option<Box<Equilibrium<C>>>,
    },
    /// At the start of the path no equilibrium exists, or none was found.
    NoStart {
        /// The outcome at the start: no equilibrium, or undecided.
        start: Box<Outcome<C>>,
    },
    /// The path could not be followed further. The path is valid up to this leg and this fraction of the leg.
    Undecided {
        /// The leg of the load program up to which the path was followed, counted from 0.
        leg: usize,
        /// Fraction of the leg that was followed.
        #[serde(with = "AsComputed::<f64>")]
        fraction: f64,
        /// The reason why the path is undecided.
        doubt: Doubt,
    },
}

/// The energies of one leg of a load program, and the error of their balance.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct BalancedEnergy {
    /// The energies, J. The field `turnover`, the sum of the magnitudes of all contributions, is zero here, since `residual` is already divided by
    /// this sum.
    #[serde(flatten)]
    pub energy: LegEnergy,
    /// The error of the energy balance, divided by the sum of the magnitudes of all contributions; zero in exact arithmetic.
    #[serde(with = "AsComputed::<f64>")]
    pub residual: f64,
}

impl SceneNames<'_> {
    /// The answer for a path that was followed to its end, with the events along the path.
    pub(super) fn path(&self, path: &LoadPath<'_, 3>, events: Vec<Event<3>>) -> PathAnswer<3> {
        let balanced = |energy: &LegEnergy| BalancedEnergy {
            energy: LegEnergy { turnover: 0.0, ..*energy },
            residual: energy.residual(),
        };
        PathAnswer {
            end: self.end(path.end(), path.state(), path.beyond()),
            events: moved(events, &|event| self.event(event)),
            steps: Vec::new(),
            small_motions_end: path.end_of_theory(),
            left_out: path.left_out(),
            energies: mapped(path.energies(), &balanced),
            step_error: path.step_error(),
        }
    }

    /// The answer for a path that was followed to its end in steps.
    pub(super) fn path_in_steps(&self, path: &SteppedPath<'_, 3>, steps: Vec<Step<3>>) -> PathAnswer<3> {
        // Motions are not compared with their limits at each step, but in the equilibrium at the end.
        let too_far = path.state().and_then(|state| state.too_far).zip(steps.last());
        let end_of =
            |(what, last): (_, &Step<3>)| EndOfSmallMotions { leg: last.leg, fraction: last.fraction, what };
        let small_motions_end = too_far.map(end_of);
        PathAnswer {
            end: self.end(path.end(), path.state(), path.beyond()),
            events: Vec::new(),
            steps,
            small_motions_end,
            left_out: path.left_out(),
            energies: Vec::new(),
            step_error: path.step_error(),
        }
    }

    fn end(
        &self,
        end: Option<&PathEnd<3>>,
        state: Option<Equilibrium<3>>,
        beyond: Option<Beyond<3>>,
    ) -> PathOutcome<3> {
        let state = state.map(|state| Box::new(self.equilibrium(state)));
        match end {
            Some(PathEnd::Completed) => PathOutcome::Completed { state },
            Some(PathEnd::Lost(loss)) => {
                let mut loss = Loss { against: None, leaves: None, ..loss.as_ref().clone() };
                loss.contacts.iter_mut().for_each(|contact| self.name(contact));
                loss.jumped.iter_mut().for_each(|slip| self.name(&mut slip.contact));
                let unknown = Beyond::Undecided { doubt: Doubt::OnTheBoundary };
                PathOutcome::Lost { loss, beyond: beyond.unwrap_or(unknown), state }
            }
            Some(PathEnd::NoStart(outcome)) => {
                PathOutcome::NoStart { start: Box::new(self.outcome(outcome.as_ref().clone())) }
            }
            Some(PathEnd::Undecided { leg, fraction, doubt }) => {
                PathOutcome::Undecided { leg: *leg, fraction: *fraction, doubt: *doubt }
            }
            None => PathOutcome::Undecided { leg: 0, fraction: 0.0, doubt: Doubt::OutOfSteps },
        }
    }

    fn event(&self, mut event: Event<3>) -> Event<3> {
        event.changes.iter_mut().for_each(|change| self.name(&mut change.contact));
        let jump = event.jump.map(|mut jump| {
            jump.changes.iter_mut().for_each(|change| self.name(&mut change.contact));
            jump.slips.iter_mut().for_each(|slip| self.name(&mut slip.contact));
            jump.reaches.iter_mut().for_each(|contact| self.name(contact));
            Box::new(Jump { state: self.equilibrium(jump.state), ..*jump })
        });
        Event { state: self.equilibrium(event.state), jump, ..event }
    }
}
