//! Conversion of planar setups, questions and answers between vectors of two and three components. Inside the crate the vectors of a scene have three
//! components; in the plane the third is zero.

use super::answer::Answer;
use super::body::BodySetup;
use super::compared::CompareAnswer;
use super::cup::Cup;
use super::finger::FingerSetup;
use super::fingertip::{Fingertip, MovedBy};
use super::link::LinkSetup;
use super::onset::{Angle, Factor, OnsetAnswer, OnsetAt, TurnAnswer};
#[cfg(feature = "mesh")]
use super::part::{PadTouch, PartSetup};
use super::patch::FingertipPatch;
use super::path::{BalancedEnergy, PathAnswer, PathOutcome};
use super::question::Question;
#[cfg(feature = "urdf")]
use super::robot::{MotorLimits, RobotSetup};
use super::sentence_answers::{
    HoldAnswer, IdentifyAnswer, ImproveAnswer, NeedAnswer, ShakeAnswer, ShakedownAnswer,
};
use super::setup::Setup;
use super::solved::SolveAnswer;
use crate::equilibrium::Settings;
use crate::grasp::{face_of_enum, face_of_struct, same_on_both_sides};
use crate::load_path::EndOfSmallMotions;

same_on_both_sides! {
    Angle, BalancedEnergy, Cup, EndOfSmallMotions, Factor, IdentifyAnswer, MovedBy, NeedAnswer, Settings, FingertipPatch,
}
#[cfg(feature = "mesh")]
same_on_both_sides! { PartSetup, PadTouch }
#[cfg(feature = "urdf")]
same_on_both_sides! { MotorLimits }
#[cfg(feature = "urdf")]
face_of_struct! {
    RobotSetup { urdf, at, turned_deg, joints, commanded, stiffness, effort, contacts }
}

face_of_struct! {
    Setup {
        space, contacts, fingers, tendons, bodies, links, gravity, loaded, shared_by_mass, outline, #[cfg(feature = "mesh")] part, #[cfg(feature = "urdf")] robot, questions, settings,
    }
    Fingertip {
        contact, soft, cup, #[cfg(feature = "mesh")] touches, surface, no_stiffness, comment, moved_by,
    }
    FingerSetup { comment, joints, stiffness_matrix, compliance, contacts }
    BodySetup { name, comment, mass, centre_of_mass, load, outline }
    LinkSetup { link, comment }
    HoldAnswer { says, verdict }
    ImproveAnswer { says, improved }
    SolveAnswer { outcome, from_rest }
    CompareAnswer { says, agrees_up_to, comparison }
    OnsetAt<At> { at, load, leaving, drives, beyond, state }
    TurnAnswer { onset, touches, left_out }
    PathAnswer { end, events, steps, small_motions_end, left_out, energies, step_error }
    ShakeAnswer { says, shaken }
    ShakedownAnswer { says, rests, found }
}

face_of_enum! {
    Question {
        Hold { base: base, load: load, together_with: together_with },
        Need { 0: need },
        Improve { 0: improve },
        Solve { load: load, together_with: together_with },
        Compare { base: base, load: load },
        Onset {
            base: base, direction: direction, command_change: commands, joint_change: joints, together_with: together_with,
        },
        OnsetOfTurn { 0: turn },
        Follow { start: start, legs: legs, in_steps: step },
        Shake { base: base, loads: loads, legs: legs },
        Shakedown { base: base, loads: loads },
        Identify { 0: identify },
    }
    Answer {
        Hold { 0: answer },
        Need { 0: answer },
        Improve { 0: answer },
        Solve { 0: answer },
        Compare { 0: answer },
        Onset { 0: answer },
        OnsetOfTurn { 0: answer },
        Follow { 0: answer },
        Shake { 0: answer },
        Shakedown { 0: answer },
        Identify { 0: answer },
    }
    OnsetAnswer<At> {
        At { 0: onset },
        Never {},
        AlreadySliding { state: state },
        NoBase { 0: reason },
        GivesWay { at: at, reason: reason },
        Undecided { 0: doubt },
    }
    PathOutcome {
        Completed { state: state },
        Lost { loss: loss, beyond: beyond, state: state },
        NoStart { start: start },
        Undecided { leg: leg, fraction: fraction, doubt: doubt },
    }
}
