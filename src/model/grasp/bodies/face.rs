//! Conversion of links between the vectors of two components that users of the plane give, and the vectors of three components in the engine.

use super::link::{Link, LinkGeometry};
use crate::grasp::{face_of_enum, face_of_struct};

face_of_struct! {
    Link { name, geometry, on, against, stiffness, pretension, tension, slack }
}

face_of_enum! {
    LinkGeometry {
        Hinge { point: point, bearings: bearings },
        Ball { point: point },
        Slide { point: point, direction: direction, length: length },
        Rigid { point: point, size: size },
        Spring { from: from, to: to },
        Cable { from: from, to: to },
    }
}
