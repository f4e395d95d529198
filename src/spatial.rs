//! Grasps in space: 6 degrees of freedom, 3 axes a contact. Lengths in m, forces in N, moments in N m, right-handed.
//!
//! The contact frame is (n, t₁, t₂) with n into the object and `t₂ = n × t₁`.

pub use crate::grasp::Pressure;

/// A point contact in space; see [`crate::grasp::Contact`].
pub type Contact = crate::grasp::Contact<3>;
/// A ring or disc of point contacts that stands for one fingertip; see [`crate::grasp::SoftFingertip`].
pub type SoftFingertip = crate::grasp::SoftFingertip<3>;
/// A spatial grasp; see [`crate::grasp::Grasp`].
pub type Grasp = crate::grasp::Grasp<6, 3>;
/// Force (x, y, z) and moment (x, y, z); see [`crate::grasp::Wrench`].
pub type Wrench = crate::grasp::Wrench<6>;
/// Translation (x, y, z) and rotation (x, y, z); see [`crate::grasp::Twist`].
pub type Twist = crate::grasp::Twist<6>;
/// How a question for an equilibrium ends; see [`crate::equilibrium::Outcome`].
pub type Outcome = crate::equilibrium::Outcome<6, 3>;
/// An equilibrium; see [`crate::equilibrium::Equilibrium`].
pub type Equilibrium = crate::equilibrium::Equilibrium<6, 3>;
/// No equilibrium, and why; see [`crate::equilibrium::NoEquilibrium`].
pub type NoEquilibrium = crate::equilibrium::NoEquilibrium<6>;
/// How it is known that none exists; see [`crate::equilibrium::Proof`].
pub type Proof = crate::equilibrium::Proof<6>;
/// One contact of an equilibrium; see [`crate::equilibrium::ContactAnswer`].
pub type ContactAnswer = crate::equilibrium::ContactAnswer<3>;
/// What a contact does; see [`crate::equilibrium::ContactState`].
pub type ContactState = crate::equilibrium::ContactState<3>;
/// One load on three friction cones; see [`crate::equilibrium::Bracket`].
pub type Bracket = crate::equilibrium::Bracket<6, 3>;
/// Equilibrating and interaction forces; see [`crate::equilibrium::Decomposition`].
pub type Decomposition = crate::equilibrium::Decomposition<3>;
/// A load and commands that change in proportion; see [`crate::load_path::Ramp`].
pub type Ramp = crate::load_path::Ramp<6, 3>;
/// When the first contact leaves rolling; see [`crate::load_path::Onset`].
pub type Onset = crate::load_path::Onset<6, 3>;
/// The first contact leaves rolling; see [`crate::load_path::OnsetEvent`].
pub type OnsetEvent = crate::load_path::OnsetEvent<6, 3>;
/// A contact that leaves rolling; see [`crate::load_path::Leaving`].
pub type Leaving = crate::load_path::Leaving<3>;
/// How a contact leaves rolling; see [`crate::load_path::Departure`].
pub type Departure = crate::load_path::Departure<3>;
/// What comes after the onset; see [`crate::load_path::Beyond`].
pub type Beyond = crate::load_path::Beyond<6, 3>;
/// How an equilibrium goes on past an event; see [`crate::load_path::Continuation`].
pub type Continuation = crate::load_path::Continuation<6, 3>;
/// One leg of a load program; see [`crate::load_path::Leg`].
pub type Leg = crate::load_path::Leg<6, 3>;
/// Something changes on a load path; see [`crate::load_path::Event`].
pub type Event = crate::load_path::Event<6, 3>;
/// What a contact does from an event on; see [`crate::load_path::Change`].
pub type Change = crate::load_path::Change<3>;
/// How a load path ends; see [`crate::load_path::PathEnd`].
pub type PathEnd = crate::load_path::PathEnd<6, 3>;
/// A load program being followed; see [`crate::load_path::LoadPath`].
pub type LoadPath<'g> = crate::load_path::LoadPath<'g, 6, 3>;
/// A few contacts made ready for screening; see [`crate::screening::Fingers`].
pub type Fingers<const N: usize> = crate::screening::Fingers<6, 3, N>;
/// Many of them; see [`crate::screening::Batch`].
pub type Batch<const N: usize> = crate::screening::Batch<6, 3, N>;
/// The load on them; see [`crate::screening::Pull`].
pub type Pull = crate::screening::Pull<6>;
/// A load program being followed for many contacts; see [`crate::load_path::PatchPath`].
pub type PatchPath<'g> = crate::load_path::PatchPath<'g, 6, 3>;
/// One contact changes on it; see [`crate::load_path::PatchEvent`].
pub type PatchEvent = crate::load_path::PatchEvent<6, 3>;
