//! Conversions of the types of finger placement between the engine and the caller. Vectors of the engine have three components even in the plane.
//! Vectors of the caller have `C` components: 2 in the plane, 3 in space.

use super::answer::{ActiveConstraint, Improved, Placed, SearchEnd};
use super::goal::ImproveGoal;
use super::question::Improve;
use super::surface::Surface;
use crate::grasp::{Face, face_of_struct, same_on_both_sides};

face_of_struct! {
    Improve { base, load, loads, any_force, at, at_most, goal, starts, steps, seed, turn, surfaces, most }
    Improved { goal, before, after, too_far, at_their_limit, force, contacts, in_the_way, search, residual, starts, steps }
    Placed { contact, surface, point, normal, tangent, command, moved, pressed_with, normal_force }
}

same_on_both_sides! { ImproveGoal, ActiveConstraint, SearchEnd, u64 }

impl<const C: usize> Face for Surface<C> {
    type Inside = Surface<3>;
    const SAME: bool = C == 3;

    fn widen(&self) -> Surface<3> {
        Surface(self.0.clone())
    }

    fn narrow(inside: Surface<3>) -> Self {
        Self(inside.0)
    }
}
