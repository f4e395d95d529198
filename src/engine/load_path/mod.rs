//! The onset (the load factor at which the first contact ceases to stick), found directly, the situation just beyond it, and whole load programs,
//! along which the slips of contacts accumulate.
//!
//! **Onset** ([`Grasp::onset`](crate::ask::Grasp::onset)). While everything sticks, contact forces are affine in the load factor τ of a [`Ramp`]. The
//! onset is the least τ >= 0 at which a sticking condition is met with equality. Two linear solves give the forces F⁰ under the base load and their
//! rate F¹, and so the onset without stepping:
//!
//! ```text
//! F(τ) = F⁰ + τ F¹        μ F_n(τ) = |F_t(τ)|   (linear in the plane, quadratic on the round cone)   or   F_n(τ) = 0
//! ```
//!
//! **A load that turns** ([`Grasp::onset_of_turn`](crate::ask::Grasp::onset_of_turn), [`Leg::turn`]). An example is the weight in the frame of an
//! object that is tilted. While contacts keep their states, forces and slips are harmonics of the load's angle θ. The margin of a contact is then a
//! trigonometric polynomial, whose extrema bracket its first zero.
//!
//! ```text
//! W(θ) = W₀ + W_c cos θ + W_s sin θ        F(θ) = F₀ + F_c cos θ + F_s sin θ
//! ```
//!
//! **Beyond.** At an event (a change of contact states) the rates of forces and motion solve a complementarity problem for the contacts on the
//! boundary of their cones. A gap grows only if the normal force stays zero, and a contact slips only if the friction margin `μ F_n - |F_t|` stays
//! zero. In this problem a contact inside its cone is treated as bonded, and an open contact as absent. A solution gives the contact states and rates
//! with which the equilibrium continues ([`Continuation`]); without a solution the equilibrium ends ([`Loss`]). Whether another equilibrium exists
//! just beyond ([`Beyond`]) is a separate question: if no other equilibrium exists, the end is a limit load, otherwise a snap. At a snap a load path
//! moves the object in an artificial model in which viscous dampers act at the contacts. The path then continues from the equilibrium in which the
//! object comes to rest.
//!
//! **Load programs** ([`Grasp::follow`](crate::ask::Grasp::follow)). The path leads from event to event, and slips accumulate: `F_t = K_t (a_t -
//! t·u_c - s)`. Here K_t is the tangential stiffness, a_t the tangential command, t·u_c the object's tangential displacement at the contact, and s
//! the accumulated slip. On polygonal cones and in the plane every piece is straight, or turns with the load. On the round cone the direction of
//! sliding turns along the way, `ds = γ F_t` with γ >= 0 and `|F_t| = μ F_n` at all times. Slips are then integrated with an estimate of the error.
//!
//! A [`Path`] stores the load program, the present place in it, and the end; the type of its items (events or steps) is a type parameter. The parts
//! of a path have these names in all files of this module:
//!
//! | word | meaning |
//! |---|---|
//! | leg ([`Leg`]) | a part of the load program, along which load and commands change linearly to given values, or the load turns |
//! | fraction of the leg | the part of the leg that is done, from 0 to 1; it measures progress along a leg, as the load factor does along a ramp |
//! | place | a point of the path, given by the index of a leg and the fraction of this leg that is done |
//! | segment | the loads and commands along one leg (or ramp, or turn) in the engine's coordinates, with the slips so far |
//! | piece | a part of a leg on which all contacts keep their states; its stored form is a `StoredPiece` |
//! | arc | a piece on which contacts slide on the round cone, so that directions of sliding turn |
//! | step | a numerical step: on a [`LoadPath`] a part of an arc, stored as a piece of its own; on a [`SteppedPath`] a part of a leg |
//! | node | the place between two pieces: an [`Event`], or the start of a leg |
//! | follower | the part of a path that advances; it stores its place on the present leg, while a `ProgramRun` stores the whole program |
//!
//! | path | advances by | reports | takes acceptable time for |
//! |---|---|---|---|
//! | [`LoadPath`] | whole pieces, which are stored | every event, energies, equilibria anywhere | some hundreds of contacts |
//! | [`SteppedPath`] | steps of exact slips, on the round cone | the steps | 10⁵ contacts |
//!
//! **Sensitivities** ([`Sensitivity::of`](crate::ask::Sensitivity::of), [`OnsetMargins`]). In known contact states the law of contact i is linear,
//! `F_i = K_i (a_i - G_iᵀq)`. Here K_i depends on stiffness, friction and state, a_i is the offset of the contact's springs, G_i the grasp map and q
//! the twist. If a datum p (such as a stiffness or friction coefficient) changes a little, one more solve gives the change of forces and twist:
//!
//! ```text
//! dF_i = K_i (da_i - G_iᵀdq) + (∂K_i/∂p) (a_i - G_iᵀq) dp,      Σ G_i dF_i + dW = 0
//! ```
//!
//! Positions and normals change the grasp maps and add the terms `-K_i dG_iᵀq` and `dG_i F_i`.

mod arc;
mod arclength;
mod beyond;
mod body_loads;
mod closing_gap;
mod contacts_and_drives;
mod crossing;
mod cycles;
mod display;
mod drive_change;
mod end_of_path;
mod end_of_theory;
mod energy;
mod event;
mod face;
mod falling_friction;
mod first_exits;
mod first_to_leave;
mod flow;
mod follower;
mod following;
mod held_torques;
mod in_slips;
mod jump;
mod jump_leg;
mod leg;
mod node;
mod onset;
mod onset_margins;
mod onset_questions;
mod onset_workspace;
mod pace;
mod path;
mod path_state;
mod path_stiffness;
mod piecewise_follower;
mod program;
mod program_run;
mod ramp;
mod relaxation;
mod rigid_motion;
mod segment;
mod sensitivity;
mod slip_rates;
mod slip_steps;
mod small_motions;
mod snapping_over;
mod stepped;
mod sticking_path;
mod stopped;
mod stored_piece;
mod straight;
mod tolerances;
mod trajectory;
mod transition;
mod turn;
mod turn_questions;
mod turning;
mod turning_load;
mod turning_state;
mod unresisted_twist;
mod watched_condition;
mod whole_change;
mod within_a_step;
#[cfg(feature = "serde")]
mod written_leg;

pub use crate::equilibrium::Parameter;
pub use beyond::{Beyond, Continuation};
pub(crate) use cycles::{CycleRecord, CycleState, Cycles};
pub use drive_change::{DriveChange, PartChange};
pub use energy::LegEnergy;
pub use event::{Change, ContactChange, Event, Loss, LossKind, PathEnd};
pub(crate) use in_slips::{InSlips, SlipEnd};
pub use jump::{Jump, JumpSlip};
pub use leg::Leg;
pub use onset::{DepartingContact, Departure, Onset, OnsetEvent};
pub use onset_margins::{DepartingPart, OnsetMargins};
pub(crate) use path::path_outside;
pub use path::{LoadPath, Path, SteppedPath};
pub use ramp::Ramp;
pub use sensitivity::Derivative;
pub use small_motions::EndOfSmallMotions;
pub use stepped::Step;
#[cfg(feature = "serde")]
pub(crate) use stepped::check_leg_error;
pub use turn::{EdgeOf, EdgeTouch, Turn};
pub use turn_questions::TurnOnset;
#[cfg(feature = "serde")]
pub(crate) use whole_change::whole_changes;
pub use whole_change::{PadChange, WholeChange};
