//! Conversions of verdicts between the engine and the caller. Vectors of the engine have three components even in the plane. Vectors of the caller
//! have `C` components: 2 in the plane, 3 in space.

use super::caught_jump::CaughtJump;
use super::verdict::{FirstSlip, Holding, Lost, NoEquilibriumNear, Verdict};
use super::way_out::{BodyWay, WayOut};
use crate::grasp::{face_of_enum, face_of_struct, same_on_both_sides};

same_on_both_sides! { CaughtJump, FirstSlip, NoEquilibriumNear }

face_of_struct! {
    Verdict { base, load, holding, first_slip, caught, held_to, everything_slides, left_out, swing, lost, state }
    Lost {
        factor, kind, way_out, too_far, slide, is_gross_slip, falls_at_once, then_takes, drives, motion, state, nothing_near,
    }
    BodyWay { body, way }
}

face_of_enum! {
    Holding {
        Sticks {},
        Slides { contacts: contacts },
        TurnsOver { motion: motion },
        Loose {},
        Lost {},
        NoRest { none: none, at_rest: at_rest },
        LostAtRest { at_rest: at_rest },
        Undecided { doubt: doubt },
    }
    WayOut {
        LiftsOff { direction: direction },
        SlidesOut { direction: direction },
        TipsOver { about: about, opens: opens },
        TurnsAbout { about: about },
        Turns { centre: centre, axis: axis, advance: advance },
        Apart { bodies: bodies },
        LetsGo { cups: cups },
        NotKnown {},
    }
}
