//! How the steps of a leg go: how long the next one is, and how fast the object has moved.

use core::f64::consts::FRAC_PI_2;

use super::speeds::Speeds;
use crate::load_path::trajectory::Trajectory;
use crate::numerics::{Size, Vector};

/// The first step of a leg, as a part of it.
const FIRST_STEP: f64 = 1.0 / 16.0;

/// The steps of a leg so far.
#[derive(Debug, Clone)]
pub(super) struct StepPace<D: Size> {
    /// The motion of the object for one unit of the fraction, from the last step.
    pub(super) rate: Option<Vector<D>>,
    /// How fast the object has moved.
    pub(super) speeds: Speeds,
    /// By how much a force has changed in the last step, over what springs that stick would feel of it.
    pub(super) changed: f64,
    /// The part of the leg that the next step tries.
    pub(super) step: f64,
    /// The most that a step may be: a load that comes round looks as if it had stayed.
    pub(super) longest: f64,
    /// Whether the last step was refused: the next one is no longer than the one that was made in its place.
    pub(super) refused: bool,
    /// Steps tried.
    pub(super) tried: usize,
}

impl<D: Size> StepPace<D> {
    /// That of a leg that begins.
    pub(super) fn along<X>(course: &Trajectory<X>) -> Self {
        let longest = if let Trajectory::Turn { angle, .. } = course { FRAC_PI_2 / angle.abs() } else { 1.0 };
        let speeds = Speeds::default();
        Self { rate: None, speeds, changed: 1.0, step: FIRST_STEP, longest, refused: false, tried: 0 }
    }

    /// That of the next leg, in the same memory.
    pub(super) fn set_out<X>(&mut self, course: &Trajectory<X>) {
        self.speeds.forget();
        *self = Self { speeds: core::mem::take(&mut self.speeds), ..Self::along(course) };
    }
}
