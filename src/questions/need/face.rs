//! Converts the question between the form of the engine, whose vectors have three components even in the plane, and the form of the caller, whose
//! vectors have `C` components: 2 in the plane, 3 in space.

use super::answer::Quantity;
use super::question::{Demand, Need};
use crate::grasp::{face_of_struct, same_on_both_sides};
use crate::words::Words;

face_of_struct! {
    Need {
        quantity, demand, base, load, loads, any_force, at, turn, per_metre, contact, contacts, of, together_with, safety, friction_less,
        squeeze_less, scan, words,
    }
}

same_on_both_sides! { Demand, Quantity, Words }
