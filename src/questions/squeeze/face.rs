//! Conversions of the types of the least squeeze and the weakest direction between the engine and the caller. Vectors of the engine have three
//! components even in the plane. Vectors of the caller have `C` components: 2 in the plane, 3 in space.

use super::least_squeeze::LeastSqueeze;
use super::loads::Loads;
use super::weakest_direction::WeakestDirection;
use crate::grasp::face_of_enum;

face_of_enum! {
    LeastSqueeze {
        Factor { factor: factor, binding: binding },
        NoFactor { contact: contact, load: load, factor: factor },
        GivesWay { motion: motion },
        Undecided {},
    }
    Loads { Each { 0: loads }, AnyForce { base: base, size: size, point: point }, Turn { 0: turn } }
    WeakestDirection {
        Force { size: size, direction: direction, load: load, leaver: leaver },
        Never {},
        GivesWay { motion: motion },
        NotSticking {},
        Undecided {},
    }
}
