//! The data of the step control that pass from step to step along a leg: the length of the next step, and the speeds of the object ([`Speeds`]).

use core::f64::consts::FRAC_PI_2;

use super::speeds::Speeds;
use crate::load_path::trajectory::Trajectory;
use crate::numerics::Vector;

/// The data of the step control of a path followed in steps, on its present leg (section of the load program).
#[derive(Debug, Clone)]
pub(super) struct StepPace {
    /// Change of the twist in the last step, divided by the fraction of the leg that it covered. `None` before the first step of a leg.
    pub(super) rate: Option<Vector>,
    /// Speeds of the object, each more than twice the speed before, with the fractions of the leg at which they occurred. They show whether the
    /// speed grows without bound.
    pub(super) speeds: Speeds,
    /// Largest change of a contact force in the last step, divided by the largest change that the object's motion would cause if all contacts
    /// stuck.
    pub(super) changed: f64,
    /// Proposed length of the next step, as a fraction of the leg; it is not yet limited to the longest step.
    pub(super) step: f64,
    /// Longest step, as a fraction of the leg: the whole leg, or a quarter revolution of a load that turns. If a step covered a full revolution, the
    /// load would seem unchanged.
    pub(super) longest: f64,
    /// True if the last step was refused. The step length then does not grow after the next step.
    pub(super) refused: bool,
    /// Number of steps tried on the leg so far, refused ones included.
    pub(super) tried: usize,
}

impl StepPace {
    /// The step control at the beginning of a leg whose load follows `trajectory`.
    pub(super) fn along<X>(trajectory: &Trajectory<X>) -> Self {
        let longest =
            if let Trajectory::Turn { angle, .. } = trajectory { FRAC_PI_2 / angle.abs() } else { 1.0 };
        let speeds = Speeds::default();
        // The first step of a leg is a sixteenth of the leg; step control changes later lengths.
        Self { rate: None, speeds, changed: 1.0, step: 1.0 / 16.0, longest, refused: false, tried: 0 }
    }

    /// Restarts the step control on the next leg, whose load follows `trajectory`, in the same storage.
    pub(super) fn start_leg<X>(&mut self, trajectory: &Trajectory<X>) {
        self.speeds.clear();
        *self = Self { speeds: core::mem::take(&mut self.speeds), ..Self::along(trajectory) };
    }
}
