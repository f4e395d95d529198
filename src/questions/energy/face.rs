//! Answers of the paper's programs and of other laws at the door.

use super::agreement::Agreement;
use super::associated::{AssociatedContact, AssociatedOutcome, AssociatedState};
use super::comparison::{Comparison, ComparisonVerdict, Difference};
use super::minimum::{Binding, Inside, MinimumContact, MinimumEnergy, MinimumOutcome};
use super::printed::{Equality, Inequality, PrintedQp};
use super::program::QuadraticProgram;
use super::reduced::{ReducedQp, ReducedRow};
use super::second_order::{SecondOrder, SecondOrderOutcome};
use super::stability::{Stability, StabilityVerdict};
use super::three_laws::ThreeLaws;
use crate::grasp::{face_of_enum, face_of_struct, same_on_both_sides};

same_on_both_sides! {
    Binding, ComparisonVerdict, Difference, Equality, Inequality, Inside, QuadraticProgram, ReducedRow, StabilityVerdict,
}

face_of_struct! {
    AssociatedState { load, twist, contacts, stored_energy }
    AssociatedContact { force, gap, slip }
    Comparison { equilibrium, minimum, difference, verdict }
    MinimumEnergy {
        load, twist, contacts, binding, imbalance, stored_energy, potential_energy, free_motions, pivots, balanced, inside,
    }
    MinimumContact { force, force_world, body_core, gap }
    ReducedQp { program, gaps, rows, constant }
    PrintedQp { program, equalities, inequalities, constant, contacts, space }
    SecondOrder {
        first_order, twist, forces, states, dropped_displacement, force_left_out, displacement_left_out, iterations, stability,
    }
    Stability { elastic, geometric, least_curvature, most_curvature, softest, verdict }
    ThreeLaws { comparison, associated, labels }
}

face_of_enum! {
    Agreement {
        UpTo { factor: factor, binding: binding },
        Always {},
        Never { 0: minimum },
        Unbounded {},
        Unsolved {},
    }
    AssociatedOutcome { Rest { 0: state }, NoBalance {}, Unsolved {} }
    MinimumOutcome {
        Minimum { 0: minimum },
        NoMinimum {},
        Unbounded { motion: motion, work: work },
        Unsolved {},
    }
    SecondOrderOutcome {
        Equilibrium { 0: found },
        NoFirstOrder { 0: outcome },
        NotSettled { iterations: iterations, change: change },
        GivesWay { iterations: iterations },
    }
}
