//! Optimal finger placement: positions of contacts on given curves or surfaces, and normal forces that their commands may cause, within limits. The
//! search maximises the load factor of first slip: the multiple of the load at which the first contact ceases to stick. Another goal is the largest
//! reserve: the least margin of a contact force to the boundary of its friction cone.
//!
//! An [`Improve`] states the loads, the contacts that may move along a [`Surface`], and how hard they may press. The place of a contact is its
//! position on its curve or surface. A command is the displacement that a finger would make if there were no object. The commanded normal force of a
//! contact is that which its command causes with the object held in place. [`Grasp::improve`](crate::ask::Grasp::improve) returns an [`Improved`]:
//! places, commanded normal forces, the value of the [`ImproveGoal`] before and after, and the active sticking conditions and limits of forces,
//! commands and places.
//!
//! While every contact sticks, the force of a contact is `F = F⁰ + τ F¹` at the load factor τ. F⁰ is its value under the base load, which acts before
//! the load grows, and F¹ its change due to the load. A contact sticks while `a·F >= 0` for the coefficients a of each facet of its friction cone.
//! Each of these sticking conditions, of each contact and load, is first broken at its own load factor τ_k. The load factor of first slip is the
//! least of these factors, a piecewise smooth function of the variables x, i.e. of places and commanded normal forces:
//!
//! ```text
//! τ(x) = min_k τ_k(x),      dτ_k = -a·(dF⁰ + τ dF¹) / a·F¹
//! ```
//!
//! The reserve under the loads is the least of the margins `a·F⁰ + a·F¹`. Factors and margins have exact derivatives
//! ([`Sensitivity::of`](crate::ask::Sensitivity::of)). Each step maximises the least of the linearised values within a trust region, a box, less a
//! quadratic term with the curvature learnt from earlier steps. The step is accepted if the true value grows. The multipliers of the step are the
//! certificate of an optimum:
//!
//! ```text
//! Σ λ_k ∇τ_k + Σ ν_b ∇b = 0,      λ, ν >= 0,      Σ λ_k = 1
//! ```
//!
//! Here k runs over active sticking conditions, b over active limits: to first order no change of the variables improves the value.
//! [`Improved::residual`] is the largest component of the left side of the first equation or, if larger, the residual of complementarity. Surfaces
//! are curved, so that there are usually several such optima. The search starts from the given grasp and from the best of many random ones.
//!
//! A contact may touch without force in the given grasp. Under a load that does not push the object against this contact, the search takes the
//! contact as open. So does [`Grasp::onset`](crate::ask::Grasp::onset).
//!
//! | file | idea |
//! |---|---|
//! | `surface`, `spline` | curves and surfaces that contacts may move along |
//! | `surface_location`, `places` | a place on a surface: its normal, tangent directions, curvature, and distances to the edges of the surface |
//! | `question`, `goal` | the user's question, and the value that is maximised |
//! | `loaded` | the loads of the question, and the load factor of first slip of a grasp under them |
//! | `design_point` | the variables (places and commanded normal forces), their values, and the grasp with these values |
//! | `by_source` | contact forces while every contact sticks, apart for base load, variable commands and each load, and their derivatives |
//! | `events` | the load factor or margin of each sticking condition, and its derivative |
//! | `step` | the quadratic program of one step, and its multipliers |
//! | `curvature` | the Hessian learnt from earlier steps |
//! | `ascent`, `over_edges` | from one start to a local optimum, within one segment or triangle of each surface and across its edges |
//! | `improved` | all starts, and the best of them |
//! | `answer`, `words` | the answer, and its sentence |
//! | `face` | conversion between three components and those of callers |

mod answer;
mod ascent;
mod by_source;
mod curvature;
mod design_point;
mod events;
mod face;
mod goal;
mod improved;
mod loaded;
mod over_edges;
mod places;
mod question;
mod spline;
mod step;
mod surface;
mod surface_location;
mod tolerances;
mod words;

pub use answer::{ActiveConstraint, ActiveConstraintKind, Improved, Placed, SearchEnd};
pub use goal::ImproveGoal;
pub use question::Improve;
#[cfg(feature = "serde")]
pub(crate) use surface::Shape;
pub use surface::Surface;
