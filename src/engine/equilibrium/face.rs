//! Conversion of equilibria between the engine, whose vectors always have three components, and callers in the plane or in space.

use super::accuracy::Accuracy;
use super::answer::{Equilibrium, LocalAnswer, Outcome, Undecided, WorkDone};
use super::cone::Cone;
use super::contact_answer::{ContactAnswer, ContactState};
use super::decomposition::Decomposition;
use super::hand_answer::{JointAnswer, TendonAnswer};
use super::no_equilibrium::{NoEquilibrium, Proof};
use super::pad_answer::PadAnswer;
use super::residuals::Residuals;
use super::too_far::TooFar;
use crate::grasp::{face_of_enum, face_of_struct, same_on_both_sides};
use crate::search::{Doubt, FoundBy};

same_on_both_sides! {
    Accuracy, Cone, Doubt, JointAnswer, LocalAnswer, Residuals, FoundBy, TendonAnswer, TooFar, Undecided, WorkDone,
}

face_of_struct! {
    Equilibrium {
        load, twist, bodies, body_loads, too_far, contacts, pads, joints, tendons, open_cups, residuals, accuracy, cone, rule, stored_energy,
        free_motions, neutral_motions, change_from_polygon, work, local,
    }
    ContactAnswer {
        contact, state, force, force_world, gap, slip, margin, distinct, body_core, body_surface, finger_surface,
    }
    Decomposition { equilibrating, interaction }
    NoEquilibrium { proof }
    PadAnswer { contact, first, points, sliding, open, wrench, margin }
}

face_of_enum! {
    Outcome { Equilibrium { 0: found }, NoEquilibrium { 0: none }, Undecided { 0: doubt } }
    ContactState { Separated {}, Sticking {}, Sliding { direction: direction }, Frictionless {} }
    Proof {
        FreeMotion { motion: motion, work: work },
        SeparatingMotion { motion: motion, work: work },
        EveryStateTried { combinations: combinations },
        EveryCaseContradicted { cases: cases, escape: escape },
    }
}
