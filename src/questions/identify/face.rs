//! Conversion of the identification question between the engine's three components and the `C` components of callers.

use super::question::{Identify, KnownSum, Others};
use super::slip::{Slip, SlipKind};
use super::unknown::Unknown;
use crate::grasp::{face_of_struct, same_on_both_sides};

face_of_struct! {
    Identify { unknowns, slips, layouts, known, outliers, iterations, others }
    Others { grasps }
    Slip { kind, load, turn, base, squeeze, layout, scatter, group }
}

same_on_both_sides! { KnownSum, SlipKind, Unknown }
