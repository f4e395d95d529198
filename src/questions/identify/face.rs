//! Conversions of the question [`Identify`] between the engine and the caller. Vectors of the engine have three components even in the plane. Vectors
//! of the caller have `C` components: 2 in the plane, 3 in space.

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
