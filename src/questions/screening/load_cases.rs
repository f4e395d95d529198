//! A list of loads. All contacts of a grasp must stick under each load, one load at a time. Screening finds the least common factor on the commands
//! with which all contacts stick. A command is the displacement that a finger would make if there were no object.

use super::answer_slots::AnswerSlots;
use super::lanes::Packed;
use super::least_factor::LeastFactor;
use super::question::{PreparedBlock, ScreeningQuestion, WorkingForces};
use super::screened_squeeze::ScreenedSqueeze;
use crate::error::Error;
use crate::grasp::Wrench;
use crate::numerics::Vectors;
use crate::prelude::*;

/// A list of at least one load for screening. All contacts must stick under each of these loads, one at a time.
#[derive(Debug, Clone, PartialEq)]
pub struct LoadCases<const C: usize> {
    pub(super) loads: Vec<Wrench<C>>,
}

impl<const C: usize> LoadCases<C> {
    /// The list of these loads on the object: forces in N, moments in N m about the origin of the coordinates of each grasp.
    ///
    /// # Errors
    /// [`Error::Argument`] if the list is empty, [`Error::Wrench`] if a component of a load is not finite or larger than 1e50.
    pub fn new(loads: &[Wrench<C>]) -> Result<Self, Error> {
        if loads.is_empty() {
            return Err(Error::Argument { what: "number of loads", value: 0.0, allowed: "at least 1" });
        }
        loads.iter().try_for_each(|load| load.check("load"))?;
        Ok(Self { loads: loads.to_vec() })
    }
}

impl<const C: usize> ScreeningQuestion<C> for LoadCases<C> {
    type Answer = ScreenedSqueeze;
    const UNKNOWN: ScreenedSqueeze = ScreenedSqueeze::UNKNOWN;

    #[inline(always)]
    fn ask<V: Vectors, X: Packed>(
        &self,
        prepared: &PreparedBlock<'_, V, C, X>,
        [commands, overlaps, others]: WorkingForces<'_, C, X>,
        slots: &mut AnswerSlots<'_, ScreenedSqueeze, X>,
    ) {
        prepared.apart([commands, overlaps]);
        let mut enough = LeastFactor::new();
        for (number, load) in self.loads.iter().enumerate() {
            prepared.under(load, others);
            others.add_to(prepared.block.contacts, overlaps, 1.0);
            enough.under(prepared.vectors, number, prepared.block.friction(), [&*commands, &*others]);
        }
        let (code, binding) = enough.least();
        slots.each(X::each(|lane| ScreenedSqueeze { code: code.lane(lane), binding: binding.lane(lane) }));
    }
}
