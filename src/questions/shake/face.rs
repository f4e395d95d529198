//! Conversions of the types of repeated loads between the engine and the caller. Vectors of the engine have three components even in the plane.
//! Vectors of the caller have `C` components: 2 in the plane, 3 in space.

use super::shakedown::{BindingContact, Shakedown};
use super::verdict::{Repeats, Shaken};
use crate::grasp::{face_of_enum, face_of_struct, same_on_both_sides};

same_on_both_sides! { BindingContact }

face_of_struct! {
    Shakedown { factor, slips, binding, slips_change_normal_forces, friction_falls, around_the_round_cone, too_far }
    Shaken { base, repeats, every, cycles, followed, change, ratio, opens, leaks, jumps, yields, moved, too_far, left_out, state }
}

face_of_enum! {
    Repeats {
        Rests { after: after, slid: slid },
        DiesOut { slid: slid },
        Alternates { slides: slides, way: way, dissipated: dissipated, jumps: jumps },
        Walks { by: by, slides: slides, dissipated: dissipated },
        Lost { cycle: cycle, leg: leg, load: load, lost: lost },
        NoRest { rest: rest },
        Undecided { doubt: doubt },
    }
}
