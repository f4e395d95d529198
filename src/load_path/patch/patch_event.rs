//! An event of one contact.

use crate::grasp::Wrench;
use crate::load_path::event::Change;

/// A contact changes its state.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct PatchEvent<const C: usize> {
    /// The leg, from 0.
    pub leg: usize,
    /// Fraction of the leg already followed, from 0 to 1, exact up to rounding. Rounding grows where a stiff contact slides and soft ones take over
    /// its force.
    pub fraction: f64,
    /// The load there.
    pub load: Wrench<C>,
    /// The contact, from 0. Simultaneous changes follow one another at the same fraction, in the order of contact numbers.
    pub contact: usize,
    /// Its behaviour from here on.
    pub change: Change<C>,
}
