//! Conversions of the answers to static questions (force closure, the ball of loads that can be balanced, limit loads) between the engine and the
//! caller. Vectors of the engine have three components even in the plane. Vectors of the caller have `C` components: 2 in the plane, 3 in space.

use super::budget::WrenchScale;
use super::closure::Closure;
use super::ferrari_canny::WrenchBall;
use super::load_limit::LoadLimit;
use crate::grasp::{face_of_enum, face_of_struct};

face_of_struct! {
    WrenchScale { about, length }
    WrenchBall { at_least, at_most, weakest }
}

face_of_enum! {
    Closure { Closed { internal: internal }, Open { motion: motion, bodies: bodies }, Boundary {} }
    LoadLimit {
        Factor { at_least: at_least, at_most: at_most, forces: forces, motion: motion },
        NoBase { motion: motion },
        Undecided {},
    }
}
