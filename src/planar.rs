//! Grasps in the plane: 3 degrees of freedom, 2 axes per contact. Lengths in m, forces in N, moments in N m, positive from x to y.
//!
//! The contact frame is (n, t) with n into the object and `t = (n_y, -n_x)`. Two rays bound the planar friction cone, which is not approximated by a
//! polygon.

pub use crate::grasp::Pressure;

/// Declares the short names of [`planar`](crate::planar) or [`spatial`](crate::spatial) for contacts with this number of axes.
macro_rules! names {
    ($axes:literal) => {
        /// A point contact; see [`crate::grasp::Contact`].
        pub type Contact = crate::grasp::Contact<$axes>;
        /// Point contacts that model one finger pad: a row of points in the plane; a ring, disc or rectangle in space; see
        /// [`crate::grasp::SoftFingertip`].
        pub type SoftFingertip = crate::grasp::SoftFingertip<$axes>;
        /// A grasp; see [`crate::ask::Grasp`].
        pub type Grasp = crate::ask::Grasp<$axes>;
        /// Many grasps with any number of contact points, for which screening computes the loads at first slip; see [`crate::screening::PointBatch`].
        pub type PointBatch = crate::screening::PointBatch<$axes>;
        /// Force and moment; in the plane the moment is one number, positive from x to y; see [`crate::grasp::Wrench`].
        pub type Wrench = crate::grasp::Wrench<$axes>;
        /// Translation and rotation; in the plane the rotation is one number, positive from x to y; see [`crate::grasp::Twist`].
        pub type Twist = crate::grasp::Twist<$axes>;
        /// A body that an arm carries, and its load; see [`crate::grasp::Payload`].
        pub type Payload = crate::grasp::Payload<$axes>;
        /// Gravity, and the acceleration and rotation at an instant of the arm that carries the body; see [`crate::grasp::ArmMotion`].
        pub type ArmMotion = crate::grasp::ArmMotion<$axes>;
        /// One body of several; see [`crate::grasp::Body`].
        pub type Body = crate::grasp::Body<$axes>;
        /// Several bodies; see [`crate::grasp::Bodies`].
        pub type Bodies = crate::grasp::Bodies<$axes>;
        /// A link between bodies, or to the ground; see [`crate::grasp::Link`].
        pub type Link = crate::grasp::Link<$axes>;
        /// Whether a grasp holds a load that grows from zero in addition to a base load; see [`crate::hold::Verdict`].
        pub type Verdict = crate::hold::Verdict<$axes>;
        /// A question for the least squeeze or friction, or the largest load, arm or angle, with which the grasp holds the loads of the question; see
        /// [`crate::need::Need`].
        pub type Need = crate::need::Need<$axes>;
        /// The answer to a question for an equilibrium; see [`crate::equilibrium::Outcome`].
        pub type Outcome = crate::equilibrium::Outcome<$axes>;
        /// An equilibrium; see [`crate::equilibrium::Equilibrium`].
        pub type Equilibrium = crate::equilibrium::Equilibrium<$axes>;
        /// The answer that no equilibrium exists, with its proof; see [`crate::equilibrium::NoEquilibrium`].
        pub type NoEquilibrium = crate::equilibrium::NoEquilibrium<$axes>;
        /// A proof that no equilibrium exists; see [`crate::equilibrium::Proof`].
        pub type Proof = crate::equilibrium::Proof<$axes>;
        /// The answer for one contact of an equilibrium; see [`crate::equilibrium::ContactAnswer`].
        pub type ContactAnswer = crate::equilibrium::ContactAnswer<$axes>;
        /// State of a contact; see [`crate::equilibrium::ContactState`].
        pub type ContactState = crate::equilibrium::ContactState<$axes>;
        /// Contact forces as the sum of equilibrating and interaction forces; see [`crate::equilibrium::Decomposition`].
        pub type Decomposition = crate::equilibrium::Decomposition<$axes>;
        /// A load and commands that change in proportion to a load factor; see [`crate::load_path::Ramp`].
        pub type Ramp = crate::load_path::Ramp<$axes>;
        /// Whether contact forces could balance any load; see [`crate::statics::Closure`].
        pub type Closure = crate::statics::Closure<$axes>;
        /// The set of loads, one at a time, under which all contacts must stick; see [`crate::squeeze::Loads`].
        pub type Loads = crate::squeeze::Loads<$axes>;
        /// The least squeeze with which a grasp holds a set of loads; see [`crate::squeeze::LeastSqueeze`].
        pub type LeastSqueeze = crate::squeeze::LeastSqueeze<$axes>;
        /// The direction in which the least force causes sliding; see [`crate::squeeze::WeakestDirection`].
        pub type WeakestDirection = crate::squeeze::WeakestDirection<$axes>;
        /// A load that turns; see [`crate::load_path::Turn`].
        pub type Turn = crate::load_path::Turn<$axes>;
        /// The angle at which the first contact stops sticking while a load turns; see [`crate::load_path::TurnOnset`].
        pub type TurnOnset = crate::load_path::TurnOnset<$axes>;
        /// The onset, i.e. the load factor at which the first contact stops sticking; see [`crate::load_path::Onset`].
        pub type Onset = crate::load_path::Onset<$axes>;
        /// Scratch buffers for a sequence of questions for the load at first slip; see [`crate::ask::OnsetWorkspace`].
        pub type OnsetWorkspace = crate::ask::OnsetWorkspace<$axes>;
        /// The event at which the first contact stops sticking; see [`crate::load_path::OnsetEvent`].
        pub type OnsetEvent = crate::load_path::OnsetEvent<$axes>;
        /// A contact that stops sticking; see [`crate::load_path::DepartingContact`].
        pub type DepartingContact = crate::load_path::DepartingContact<$axes>;
        /// How a contact stops sticking; see [`crate::load_path::Departure`].
        pub type Departure = crate::load_path::Departure<$axes>;
        /// The behaviour just beyond first slip or beyond the end of a load path: whether an equilibrium exists there; see
        /// [`crate::load_path::Beyond`].
        pub type Beyond = crate::load_path::Beyond<$axes>;
        /// The continuation of an equilibrium beyond an event, i.e. a change of contact states; see [`crate::load_path::Continuation`].
        pub type Continuation = crate::load_path::Continuation<$axes>;
        /// One leg of a load program, a section along which load and commands of fingers change linearly, or the load turns; see [`crate::load_path::Leg`].
        pub type Leg = crate::load_path::Leg<$axes>;
        /// An event on a load path: a change of contact states, or a joint or tendon that reaches its force limit; see [`crate::load_path::Event`].
        pub type Event = crate::load_path::Event<$axes>;
        /// A contact whose state changes at an event; see [`crate::load_path::ContactChange`].
        pub type ContactChange = crate::load_path::ContactChange<$axes>;
        /// The change of a contact's state at an event; see [`crate::load_path::Change`].
        pub type Change = crate::load_path::Change<$axes>;
        /// A sudden change of equilibrium at constant load on a load path; see [`crate::load_path::Jump`].
        pub type Jump = crate::load_path::Jump<$axes>;
        /// The end of a load path; see [`crate::load_path::PathEnd`].
        pub type PathEnd = crate::load_path::PathEnd<$axes>;
        /// A load program followed from event to event; see [`crate::load_path::LoadPath`].
        pub type LoadPath<'g> = crate::load_path::LoadPath<'g, $axes>;
        /// The contacts of one grasp, for which screening computes the load at first slip; see [`crate::screening::Fingers`].
        pub type Fingers<const N: usize> = crate::screening::Fingers<$axes, N>;
        /// Many grasps of `N` contacts each, for which screening computes the loads at first slip; see [`crate::screening::Batch`].
        pub type Batch<const N: usize> = crate::screening::Batch<$axes, N>;
        /// A growing load for which screening computes the load factor at first slip; see [`crate::screening::Pull`].
        pub type Pull = crate::screening::Pull<$axes>;
        /// Loads for which screening computes the least squeeze with which a grasp holds each of them; see [`crate::screening::LoadCases`].
        pub type LoadCases = crate::screening::LoadCases<$axes>;
        /// A load program followed in load steps; see [`crate::load_path::SteppedPath`].
        pub type SteppedPath<'g> = crate::load_path::SteppedPath<'g, $axes>;
        /// One load step of a stepped path; see [`crate::load_path::Step`].
        pub type Step = crate::load_path::Step<$axes>;

        /// Hands with joints: [`Hand::grasp`](crate::grasp::Hand::grasp) makes a [`Grasp`] like any other.
        pub mod hand {
            pub use crate::equilibrium::{DriveState, JointAnswer, TendonAnswer};
            pub use crate::grasp::{HandPart, JointKind, Limit, PartLabel, Tendon};
            pub use crate::load_path::{DriveChange, PartChange};

            /// A joint; see [`crate::grasp::Joint`].
            pub type Joint = crate::grasp::Joint<$axes>;
            /// A finger; see [`crate::grasp::Finger`].
            pub type Finger = crate::grasp::Finger<$axes>;
            /// A hand; see [`crate::grasp::Hand`].
            pub type Hand = crate::grasp::Hand<$axes>;
        }
    };
}
pub(crate) use names;

names!(2);
