//! Hands with joints: what joints change, how they are described, and what theory guarantees.
//!
//! Consider a finger with joint displacements φ, Jacobian `J` of its contact (m/rad) and joint stiffness `K_θ` (N m/rad: gears, tendons, the gain of
//! the position controller). At the contact it gives way by its **compliance** `C = J K_θ⁻¹ Jᵀ` (m/N). The off-diagonal part c_nt couples
//! displacements that springs along the axes of the contact would separate: pushing a tilted finger also shifts its tip sideways. A load along the
//! object then raises the normal force of one finger and lowers that of the other. This changes the load at which a contact slides.
//!
//! ```
//! use grasp_lcp::planar::Contact;
//! use grasp_lcp::planar::hand::{Finger, Hand, Joint};
//! use grasp_lcp::planar::{Grasp, Wrench};
//!
//! // Two fingers of three joints (0.8, 0.8 and 0.5 N m/rad) squeeze an object with 4.5 N each; μ = 0.4.
//! let finger = |x: f64| {
//!     let joints = [([1.5 * x, -1.0], 0.8), ([2.0 * x, 0.75], 0.8), ([x, 1.5], 0.5)];
//!     let pad = Contact::new([0.25 * x, 0.0], [-x, 0.0]).series_stiffness(1e4, 1e4).friction(0.4).pressed_with(4.5);
//!     Finger::new(joints.map(|(point, stiffness)| Joint::revolute(point).stiffness(stiffness))).contact(pad)
//! };
//! let grasp: Grasp = Hand::new([finger(-1.0), finger(1.0)]).grasp()?; // 3 coordinates of the object, 6 joints
//! let onset = |side: f64| grasp.onset(Wrench::force([0.0, side])).map(|onset| onset.factor());
//! let (down, up) = (onset(-1.0)?.expect("sticks"), onset(1.0)?.expect("sticks"));
//! // Springs along the axes of the contacts would say 2 μ N = 3.6 N both ways.
//! assert!((down - 3.146).abs() < 1e-3 && (up - 4.207).abs() < 1e-3);
//! # Ok::<(), grasp_lcp::Error>(())
//! ```
//!
//! # Describing a hand
//!
//! | part of the hand | description |
//! |---|---|
//! | joints that turn or slide | [`Joint::revolute`](crate::grasp::Joint), [`Joint::prismatic`](crate::grasp::Joint::prismatic) from the palm outwards, contacts on [links](crate::grasp::Finger::contact_on) |
//! | a Jacobian from elsewhere | [`Joint::given`](crate::grasp::Joint::given) and [`Finger::contact_moved_by`](crate::grasp::Finger::contact_moved_by) |
//! | gears that couple joints | [`Finger::coupled`](crate::grasp::Finger::coupled), any symmetric positive semidefinite matrix |
//! | a tendon, a whiffletree, a differential | [`Tendon`](crate::grasp::Tendon) over joints of any fingers, with a spring or with a given tension |
//! | two jaws on one actuator | one joint without a spring for each jaw and a tendon over both; or one joint that moves both contacts |
//! | a motor that stalls | [`Limit::Saturates`](crate::Limit::Saturates): the torque stays at its bound and follows its spring back |
//! | a clutch, friction in a gear | [`Limit::Slips`](crate::Limit::Slips): the slipped angle remains |
//! | a finger held by force | [`Contact::force`](crate::grasp::Contact::force), [`Joint::torque`](crate::grasp::Joint::torque) |
//! | a squeeze in newtons | [`Contact::pressed_with`](crate::grasp::Contact::pressed_with) |
//! | a compliance matrix, measured or from finite elements | [`Finger::compliant`](crate::grasp::Finger::compliant) over one contact, a finger, or all |
//!
//! [`Hand::grasp`](crate::grasp::Hand::grasp) makes a [`Grasp`](crate::ask::Grasp), with any number of joints. It answers the same questions as any
//! other grasp. Loads act on the object; [torques on joints](crate::ask::Grasp::with_joint_torques) from outside are zero unless given. Answers
//! contain [joints](crate::equilibrium::Equilibrium::joints) and [tendons](crate::equilibrium::Equilibrium::tendons) in addition to contacts; events,
//! first slip among them, contain the [drives](crate::load_path::Event::drives) (springs of joints and tendons) that reach their force limit or go
//! slack.
//!
//! # Guarantees of theory, and their limits
//!
//! Let C be the compliance of all contacts together, pads included (symmetric, positive definite):
//!
//! * **While everything sticks the forces are unique**: they minimise `½ FᵀC F - aᵀF` under balance, a strictly convex program (section 4 of
//!   "Position Control for Multifingered Robot Hand", here with joints).
//! * **One contact on a body at rest** has one answer for every command if μ |c_nt| < c_nn, and up to three otherwise: the condition of Klarbring,
//!   *Examples of non-uniqueness and non-existence of solutions to quasistatic contact problems with friction*, Ingenieur-Archiv 60 (1990).
//! * **On a body that is free to move this condition does not suffice**: two fingers that each satisfy it can still have several equilibria together.
//! * **The force form** (the complementarity problem whose unknowns are contact forces) **stays copositive** for every positive semidefinite
//!   compliance, `zᵀMz = FᵀCF + Σ μ λ F_n >= 0`. Guarantees of Lemke's method without joints therefore hold with joints: Cottle,
//!   Pang and Stone, *The Linear Complementarity Problem*, theorem 4.4.12.
//! * **A symmetric pinch** with the normal force N on both sides slides at `2 μ N / (1 ∓ μ |c_nt|/c_nn)`. From μ |c_nt| >= c_nn on, the side that
//!   tightens itself never slides.
//! * **Loads that are held need not include zero**: a squeeze alone can slide, and a weight can stop it.
//!
//! # Limitations
//!
//! Displacements are small: J is the Jacobian of the posture in which contacts were given. Under load the joint stiffness has a geometric part,
//! `∂Jᵀ/∂φ F`, which matters if torque times angle approaches the elastic energy. Add it with [`Finger::coupled`](crate::grasp::Finger::coupled) if
//! it is known and the sum is positive semidefinite. [Screening](crate::screening) and [`Grasp::follow_in_steps`](crate::ask::Grasp::follow_in_steps)
//! do not support joints.
