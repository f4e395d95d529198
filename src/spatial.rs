//! Grasps in space: 6 degrees of freedom, 3 axes a contact. Lengths in m, forces in N, moments in N m, right-handed.
//!
//! The contact frame is (n, t₁, t₂) with n into the object and `t₂ = n × t₁`.

pub use crate::grasp::{Pressure, SuctionCup};

/// A point contact in space; see [`crate::grasp::Contact`].
pub type Contact = crate::grasp::Contact<3>;
/// A ring, disc or rectangle of point contacts that models one fingertip; see [`crate::grasp::SoftFingertip`].
pub type SoftFingertip = crate::grasp::SoftFingertip<3>;
/// A spatial grasp; see [`crate::ask::Grasp`].
pub type Grasp = crate::ask::Grasp<3>;
/// Force (x, y, z) and moment (x, y, z); see [`crate::grasp::Wrench`].
pub type Wrench = crate::grasp::Wrench<3>;
/// Translation (x, y, z) and rotation (x, y, z); see [`crate::grasp::Twist`].
pub type Twist = crate::grasp::Twist<3>;
/// A body that an arm carries, and its load; see [`crate::grasp::Payload`].
pub type Payload = crate::grasp::Payload<3>;
/// Motion of the arm at an instant; see [`crate::grasp::ArmMotion`].
pub type ArmMotion = crate::grasp::ArmMotion<3>;
/// One body of several; see [`crate::grasp::Body`].
pub type Body = crate::grasp::Body<3>;
/// Several bodies; see [`crate::grasp::Bodies`].
pub type Bodies = crate::grasp::Bodies<3>;
/// A link between bodies, or to the ground; see [`crate::grasp::Link`].
pub type Link = crate::grasp::Link<3>;
/// The verdict on a load that is applied from rest; see [`crate::hold::Verdict`].
pub type Verdict = crate::hold::Verdict<3>;
/// A question for the needed amount of a quantity, with its loads; see [`crate::need::Need`].
pub type Need = crate::need::Need<3>;
/// The answer to a question for an equilibrium; see [`crate::equilibrium::Outcome`].
pub type Outcome = crate::equilibrium::Outcome<3>;
/// An equilibrium; see [`crate::equilibrium::Equilibrium`].
pub type Equilibrium = crate::equilibrium::Equilibrium<3>;
/// No equilibrium exists, with the proof; see [`crate::equilibrium::NoEquilibrium`].
pub type NoEquilibrium = crate::equilibrium::NoEquilibrium<3>;
/// A proof that no equilibrium exists; see [`crate::equilibrium::Proof`].
pub type Proof = crate::equilibrium::Proof<3>;
/// One contact of an equilibrium; see [`crate::equilibrium::ContactAnswer`].
pub type ContactAnswer = crate::equilibrium::ContactAnswer<3>;
/// State of a contact; see [`crate::equilibrium::ContactState`].
pub type ContactState = crate::equilibrium::ContactState<3>;
/// One load on three friction cones; see [`crate::equilibrium::Bracket`].
pub type Bracket = crate::equilibrium::Bracket<3>;
/// Equilibrating and interaction forces; see [`crate::equilibrium::Decomposition`].
pub type Decomposition = crate::equilibrium::Decomposition<3>;
/// A load and commands that change in proportion; see [`crate::load_path::Ramp`].
pub type Ramp = crate::load_path::Ramp<3>;
/// Whether contact forces could balance any load; see [`crate::statics::Closure`].
pub type Closure = crate::statics::Closure<3>;
/// The loads that a grasp is to hold; see [`crate::squeeze::Loads`].
pub type Loads = crate::squeeze::Loads<3>;
/// The least squeeze for these loads; see [`crate::squeeze::LeastSqueeze`].
pub type LeastSqueeze = crate::squeeze::LeastSqueeze<3>;
/// The direction in which the least force slides; see [`crate::squeeze::WeakestDirection`].
pub type WeakestDirection = crate::squeeze::WeakestDirection<3>;
/// Bounds on the errors of commands and loads; see [`crate::squeeze::Bounds`].
pub type Bounds = crate::squeeze::Bounds<3>;
/// The least onset of sliding within bounds; see [`crate::squeeze::LeastOnset`].
pub type LeastOnset = crate::squeeze::LeastOnset<3>;
/// A load that turns; see [`crate::load_path::Turn`].
pub type Turn = crate::load_path::Turn<3>;
/// The angle at which the first contact stops sticking while a load turns; see [`crate::load_path::TurnOnset`].
pub type TurnOnset = crate::load_path::TurnOnset<3>;
/// The factor at which the first contact stops sticking; see [`crate::load_path::Onset`].
pub type Onset = crate::load_path::Onset<3>;
/// Memory for one onset after another; see [`crate::ask::OnsetWorkspace`].
pub type OnsetWorkspace = crate::ask::OnsetWorkspace<3>;
/// The event at which the first contact stops sticking; see [`crate::load_path::OnsetEvent`].
pub type OnsetEvent = crate::load_path::OnsetEvent<3>;
/// A contact that stops sticking; see [`crate::load_path::Leaving`].
pub type Leaving = crate::load_path::Leaving<3>;
/// How a contact stops sticking; see [`crate::load_path::Departure`].
pub type Departure = crate::load_path::Departure<3>;
/// The behaviour just beyond the onset; see [`crate::load_path::Beyond`].
pub type Beyond = crate::load_path::Beyond<3>;
/// The continuation of an equilibrium past an event; see [`crate::load_path::Continuation`].
pub type Continuation = crate::load_path::Continuation<3>;
/// One leg of a load program; see [`crate::load_path::Leg`].
pub type Leg = crate::load_path::Leg<3>;
/// An event on a load path; see [`crate::load_path::Event`].
pub type Event = crate::load_path::Event<3>;
/// A contact whose state changes at an event; see [`crate::load_path::ContactChange`].
pub type ContactChange = crate::load_path::ContactChange<3>;
/// The change of a contact's state at an event; see [`crate::load_path::Change`].
pub type Change = crate::load_path::Change<3>;
/// A jump on a load path at constant load; see [`crate::load_path::Jump`].
pub type Jump = crate::load_path::Jump<3>;
/// The end of a load path; see [`crate::load_path::PathEnd`].
pub type PathEnd = crate::load_path::PathEnd<3>;
/// A load program being followed; see [`crate::load_path::LoadPath`].
pub type LoadPath<'g> = crate::load_path::LoadPath<'g, 3>;
/// A few contacts prepared for screening; see [`crate::screening::Fingers`].
pub type Fingers<const N: usize> = crate::screening::Fingers<3, N>;
/// Many grasps prepared for screening; see [`crate::screening::Batch`].
pub type Batch<const N: usize> = crate::screening::Batch<3, N>;
/// A load for screening; see [`crate::screening::Pull`].
pub type Pull = crate::screening::Pull<3>;
/// A load for screening that turns; see [`crate::screening::TurningPull`].
pub type TurningPull = crate::screening::TurningPull<3>;
/// Loads for screening that fingers are to hold; see [`crate::screening::LoadCases`].
pub type LoadCases = crate::screening::LoadCases<3>;
/// A load program being followed in steps; see [`crate::load_path::SteppedPath`].
pub type SteppedPath<'g> = crate::load_path::SteppedPath<'g, 3>;
/// A step of such a path; see [`crate::load_path::Step`].
pub type Step = crate::load_path::Step<3>;

/// Names for hands with joints in space: [`Hand::grasp`](crate::grasp::Hand::grasp) makes a [`Grasp`] like any other.
pub mod hand {
    pub use crate::equilibrium::{DriveState, JointAnswer, TendonAnswer};
    pub use crate::grasp::{HandPart, JointKind, Limit, PartLabel, Tendon};
    pub use crate::load_path::{DriveChange, PartChange};

    /// A joint; see [`crate::grasp::Joint`].
    pub type Joint = crate::grasp::Joint<3>;
    /// A finger; see [`crate::grasp::Finger`].
    pub type Finger = crate::grasp::Finger<3>;
    /// A hand; see [`crate::grasp::Hand`].
    pub type Hand = crate::grasp::Hand<3>;
}
