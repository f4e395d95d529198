//! What happens to one contact on the way.

use crate::grasp::Wrench;
use crate::load_path::event::Change;

/// A contact changes its state.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct PatchEvent<const C: usize> {
    /// The leg, from 0.
    pub leg: usize,
    /// How much of the leg has been gone, from 0 to 1, exact up to rounding. That grows where a
    /// stiff contact slides and soft ones hold what it has held.
    pub fraction: f64,
    /// The load there.
    pub load: Wrench<C>,
    /// The contact, from 0. What changes together follows one after the other at the same fraction,
    /// by the numbers of the contacts.
    pub contact: usize,
    /// What it does from here on.
    pub change: Change<C>,
}
