//! Conversion of the question between the engine, whose vectors have three components in the plane, too, and callers, with `C` components.

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
