//! One question for many loads, ramps, turns or grasps.

use super::caught::each_answered;
use crate::equilibrium::{Outcome, Settings};
use crate::error::Error;
use crate::grasp::{Engine, Wrench};
use crate::load_path::{Onset, Ramp, Turn, TurnOnset};
use crate::prelude::*;

impl Engine {
    /// [`Grasp::solve_each`](crate::ask::Grasp::solve_each).
    pub(crate) fn solve_each(
        &self,
        loads: &[Wrench<3>],
        settings: &Settings,
    ) -> Vec<Result<Outcome<3>, Error>> {
        each_answered(loads, &|load| self.solve(load, settings))
    }

    /// [`Grasp::onset_each`](crate::ask::Grasp::onset_each).
    pub(crate) fn onset_each(&self, ramps: &[Ramp<3>], settings: &Settings) -> Vec<Result<Onset<3>, Error>> {
        each_answered(ramps, &|ramp| self.onset(ramp, settings))
    }

    /// [`Grasp::onset_of_turn_each`](crate::ask::Grasp::onset_of_turn_each).
    pub(crate) fn onset_of_turn_each(
        &self,
        turns: &[Turn<3>],
        settings: &Settings,
    ) -> Vec<Result<TurnOnset<3>, Error>> {
        each_answered(turns, &|turn| self.onset_of_turn(turn, settings))
    }
}
