//! Conversions of the types of minimum energy between the engine and the caller. Vectors of the engine have three components even in the plane.
//! Vectors of the caller have `C` components: 2 in the plane, 3 in space.

use super::agreement::Agreement;
use super::comparison::{Comparison, ComparisonVerdict, Difference};
use super::minimum::{Binding, Inside, MinimumContact, MinimumEnergy, MinimumOutcome};
use crate::grasp::{face_of_enum, face_of_struct, same_on_both_sides};

same_on_both_sides! {
    Binding, ComparisonVerdict, Difference, Inside,
}

face_of_struct! {
    Comparison { equilibrium, minimum, difference, verdict }
    MinimumEnergy {
        load, twist, contacts, binding, imbalance, stored_energy, potential_energy, free_motions, pivots, balanced, inside,
    }
    MinimumContact { force, force_world, body_core, gap }
}

face_of_enum! {
    Agreement {
        UpTo { factor: factor, binding: binding },
        Always {},
        Never { 0: minimum },
        Unbounded {},
        Unsolved {},
    }
    MinimumOutcome {
        Minimum { 0: minimum },
        NoMinimum {},
        Unbounded { motion: motion, work: work },
        Unsolved {},
    }
}
