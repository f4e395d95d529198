//! Grasps in the plane: 3 degrees of freedom, 2 axes a contact. Lengths in m, forces in N, moments from x to y in N m.
//!
//! The contact frame is (n, t) with n into the object and `t = (n_y, -n_x)`. Nothing is approximated: the planar
//! friction cone is a polygonal one.

pub use crate::grasp::Pressure;

/// A point contact in the plane; see [`crate::grasp::Contact`].
pub type Contact = crate::grasp::Contact<2>;
/// A row of point contacts that models one finger pad; see [`crate::grasp::SoftFingertip`].
pub type SoftFingertip = crate::grasp::SoftFingertip<2>;
/// A planar grasp; see [`crate::ask::Grasp`].
pub type Grasp = crate::ask::Grasp<2>;
/// Force (x, y) and moment; see [`crate::grasp::Wrench`].
pub type Wrench = crate::grasp::Wrench<2>;
/// Translation (x, y) and rotation; see [`crate::grasp::Twist`].
pub type Twist = crate::grasp::Twist<2>;
/// A body that an arm carries, and its load; see [`crate::grasp::Payload`].
pub type Payload = crate::grasp::Payload<2>;
/// Motion of the arm at an instant; see [`crate::grasp::ArmMotion`].
pub type ArmMotion = crate::grasp::ArmMotion<2>;
/// One body of several; see [`crate::grasp::Body`].
pub type Body = crate::grasp::Body<2>;
/// Several bodies; see [`crate::grasp::Bodies`].
pub type Bodies = crate::grasp::Bodies<2>;
/// A link between bodies, or to the ground; see [`crate::grasp::Link`].
pub type Link = crate::grasp::Link<2>;
/// The verdict on a load that is applied from rest; see [`crate::hold::Verdict`].
pub type Verdict = crate::hold::Verdict<2>;
/// A question for the needed amount of a quantity, with its loads; see [`crate::need::Need`].
pub type Need = crate::need::Need<2>;
/// The answer to a question for an equilibrium; see [`crate::equilibrium::Outcome`].
pub type Outcome = crate::equilibrium::Outcome<2>;
/// An equilibrium; see [`crate::equilibrium::Equilibrium`].
pub type Equilibrium = crate::equilibrium::Equilibrium<2>;
/// No equilibrium exists, with the proof; see [`crate::equilibrium::NoEquilibrium`].
pub type NoEquilibrium = crate::equilibrium::NoEquilibrium<2>;
/// A proof that no equilibrium exists; see [`crate::equilibrium::Proof`].
pub type Proof = crate::equilibrium::Proof<2>;
/// One contact of an equilibrium; see [`crate::equilibrium::ContactAnswer`].
pub type ContactAnswer = crate::equilibrium::ContactAnswer<2>;
/// State of a contact; see [`crate::equilibrium::ContactState`].
pub type ContactState = crate::equilibrium::ContactState<2>;
/// Equilibrating and interaction forces; see [`crate::equilibrium::Decomposition`].
pub type Decomposition = crate::equilibrium::Decomposition<2>;
/// A load and commands that change in proportion; see [`crate::load_path::Ramp`].
pub type Ramp = crate::load_path::Ramp<2>;
/// Whether contact forces could balance any load; see [`crate::statics::Closure`].
pub type Closure = crate::statics::Closure<2>;
/// The loads that a grasp is to hold; see [`crate::squeeze::Loads`].
pub type Loads = crate::squeeze::Loads<2>;
/// The least squeeze for these loads; see [`crate::squeeze::LeastSqueeze`].
pub type LeastSqueeze = crate::squeeze::LeastSqueeze<2>;
/// The direction in which the least force slides; see [`crate::squeeze::WeakestDirection`].
pub type WeakestDirection = crate::squeeze::WeakestDirection<2>;
/// Bounds on the errors of commands and loads; see [`crate::squeeze::Bounds`].
pub type Bounds = crate::squeeze::Bounds<2>;
/// The least onset of sliding within bounds; see [`crate::squeeze::LeastOnset`].
pub type LeastOnset = crate::squeeze::LeastOnset<2>;
/// A load that turns; see [`crate::load_path::Turn`].
pub type Turn = crate::load_path::Turn<2>;
/// The angle at which the first contact stops sticking while a load turns; see [`crate::load_path::TurnOnset`].
pub type TurnOnset = crate::load_path::TurnOnset<2>;
/// The factor at which the first contact stops sticking; see [`crate::load_path::Onset`].
pub type Onset = crate::load_path::Onset<2>;
/// Memory for one onset after another; see [`crate::ask::OnsetWorkspace`].
pub type OnsetWorkspace = crate::ask::OnsetWorkspace<2>;
/// The event at which the first contact stops sticking; see [`crate::load_path::OnsetEvent`].
pub type OnsetEvent = crate::load_path::OnsetEvent<2>;
/// A contact that stops sticking; see [`crate::load_path::Leaving`].
pub type Leaving = crate::load_path::Leaving<2>;
/// How a contact stops sticking; see [`crate::load_path::Departure`].
pub type Departure = crate::load_path::Departure<2>;
/// The behaviour just beyond the onset; see [`crate::load_path::Beyond`].
pub type Beyond = crate::load_path::Beyond<2>;
/// The continuation of an equilibrium past an event; see [`crate::load_path::Continuation`].
pub type Continuation = crate::load_path::Continuation<2>;
/// One leg of a load program; see [`crate::load_path::Leg`].
pub type Leg = crate::load_path::Leg<2>;
/// An event on a load path; see [`crate::load_path::Event`].
pub type Event = crate::load_path::Event<2>;
/// A contact whose state changes at an event; see [`crate::load_path::ContactChange`].
pub type ContactChange = crate::load_path::ContactChange<2>;
/// The change of a contact's state at an event; see [`crate::load_path::Change`].
pub type Change = crate::load_path::Change<2>;
/// A jump on a load path at constant load; see [`crate::load_path::Jump`].
pub type Jump = crate::load_path::Jump<2>;
/// The end of a load path; see [`crate::load_path::PathEnd`].
pub type PathEnd = crate::load_path::PathEnd<2>;
/// A load program being followed; see [`crate::load_path::LoadPath`].
pub type LoadPath<'g> = crate::load_path::LoadPath<'g, 2>;
/// A few contacts prepared for screening; see [`crate::screening::Fingers`].
pub type Fingers<const N: usize> = crate::screening::Fingers<2, N>;
/// Many grasps prepared for screening; see [`crate::screening::Batch`].
pub type Batch<const N: usize> = crate::screening::Batch<2, N>;
/// A load for screening; see [`crate::screening::Pull`].
pub type Pull = crate::screening::Pull<2>;
/// A load for screening that turns; see [`crate::screening::TurningPull`].
pub type TurningPull = crate::screening::TurningPull<2>;
/// Loads for screening that fingers are to hold; see [`crate::screening::LoadCases`].
pub type LoadCases = crate::screening::LoadCases<2>;
/// A load program being followed in steps; see [`crate::load_path::SteppedPath`].
pub type SteppedPath<'g> = crate::load_path::SteppedPath<'g, 2>;
/// A step of such a path; see [`crate::load_path::Step`].
pub type Step = crate::load_path::Step<2>;

/// Names for hands with joints in the plane: [`Hand::grasp`](crate::grasp::Hand::grasp) makes a [`Grasp`] like any other.
pub mod hand {
    pub use crate::equilibrium::{DriveState, JointAnswer, TendonAnswer};
    pub use crate::grasp::{HandPart, JointKind, Limit, PartLabel, Tendon};
    pub use crate::load_path::{DriveChange, PartChange};

    /// A joint; see [`crate::grasp::Joint`].
    pub type Joint = crate::grasp::Joint<2>;
    /// A finger; see [`crate::grasp::Finger`].
    pub type Finger = crate::grasp::Finger<2>;
    /// A hand; see [`crate::grasp::Hand`].
    pub type Hand = crate::grasp::Hand<2>;
}
