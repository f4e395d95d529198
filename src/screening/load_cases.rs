//! The loads that a grasp is to hold, one at a time.

use super::least_factor::LeastFactor;
use super::question::{Scenes, ScreeningQuestion};
use super::screened_squeeze::ScreenedSqueeze;
use crate::error::Error;
use crate::grasp::Wrench;

/// Loads on a grasp in screening, each of which it is to hold: one at a time, at least one.
#[derive(Debug, Clone, PartialEq)]
pub struct LoadCases<const C: usize> {
    pub(super) loads: Vec<Wrench<C>>,
}

impl<const C: usize> LoadCases<C> {
    /// The loads on the object: forces in N, moments in N m. Moments are about the origin of the coordinates of each grasp.
    ///
    /// # Errors
    /// [`Error::Argument`] if there are none, [`Error::Wrench`] if a component of one is not finite or
    /// larger than 1e50.
    pub fn new(loads: &[Wrench<C>]) -> Result<Self, Error> {
        if loads.is_empty() {
            return Err(Error::Argument { what: "number of loads", value: 0.0, allowed: "at least 1" });
        }
        loads.iter().try_for_each(|load| load.check("load"))?;
        Ok(Self { loads: loads.to_vec() })
    }
}

impl<const D: usize, const C: usize> ScreeningQuestion<D, C> for LoadCases<C> {
    type Answer = ScreenedSqueeze;
    const UNKNOWN: ScreenedSqueeze = ScreenedSqueeze::UNKNOWN;

    #[inline(always)]
    fn ask<const N: usize, const L: usize>(&self, scenes: Scenes<'_, D, C, N, L>) -> [ScreenedSqueeze; L] {
        let [commands, overlaps] = scenes.apart();
        let mut enough = LeastFactor::new();
        for (number, load) in self.loads.iter().enumerate() {
            let others = overlaps.with(&scenes.under(load), 1.0);
            enough.under(number, &scenes.block.friction, [&commands, &others]);
        }
        let (code, binding) = enough.least();
        let mut answers = [ScreenedSqueeze::UNKNOWN; L];
        for lane in 0..L {
            answers[lane] = ScreenedSqueeze { code: code.0[lane], binding: binding.0[lane] };
        }
        answers
    }
}
