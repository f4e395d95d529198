//! Conversion of the question of identification between the engine, whose vectors have three components in the plane, too, and callers, with `C`
//! components.

use super::question::{Identify, KnownSum, OtherLayouts};
use super::slip::{Slip, SlipKind};
use super::unknown::Unknown;
use crate::grasp::{face_of_struct, same_on_both_sides};

face_of_struct! {
    Identify { unknowns, slips, layouts, known, outliers, iterations, others }
    OtherLayouts { grasps }
    Slip { kind, load, turn, base, squeeze, layout, scatter, group }
}

same_on_both_sides! { KnownSum, SlipKind, Unknown }
