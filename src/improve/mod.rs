//! Where should the fingers be? Positions on given curves or surfaces and squeezes within force limits, such that the first slip comes as late as possible,
//! or most friction is left.
//!
//! An [`Improve`] says for which loads, which contacts may move along which [`Surface`], and how hard they may press;
//! [`Improve::answered_by`] a grasp answers with an [`Improved`]: places, squeezes, what the [`ImproveGoal`] counts before and after, and what
//! stands in the way of more.
//!
//! While everything sticks, forces are linear in the load and in the squeeze, `F = F⁰ + τ F¹`. Each condition `a·F >= 0` of each contact and load
//! has a factor τ of its own at which it is broken. The first slip is the least of them, piecewise smooth in places and squeezes x:
//!
//! ```text
//! τ(x) = min_k τ_k(x),      dτ_k = -a·(dF⁰ + τ dF¹) / a·F¹
//! ```
//!
//! What is left of it under the load, in the same way, is the least of `a·F⁰ + a·F¹`. Both come
//! with exact derivatives ([`Sensitivity::of`](crate::ask::Sensitivity::of)). Each step maximises the least of them, linearised, within a box, less a
//! curvature that the steps before have shown; it is taken if the true one grows. Its multipliers are the certificate:
//!
//! ```text
//! Σ λ_k ∇τ_k + Σ ν_b ∇b = 0,      λ, ν >= 0,      Σ λ_k = 1
//! ```
//!
//! over events that come first, and bounds that are met: to first order no other place and squeeze nearby is better. What is left of it is told.
//! Surfaces bend, so there are several such optima as a rule: the search begins at the grasp given and at the best of many scattered ones.
//!
//! | file | idea |
//! |---|---|
//! | `surface`, `spline` | curves and surfaces that contacts may move along |
//! | `spot`, `places` | a place on one of them: its normal, directions to go, how it bends, how far it goes |
//! | `question`, `goal` | what is asked, and what is to be as large as possible |
//! | `loaded` | its loads, and what they do to the grasp itself |
//! | `placing` | a choice of places and squeezes, and the grasp that it makes |
//! | `sticking` | forces while everything sticks, and their derivatives |
//! | `events` | when each condition is broken, and how that changes |
//! | `step` | the program of one step, and its multipliers |
//! | `curvature` | what steps have shown of how events bend |
//! | `ascent`, `over_edges` | from one start to where it ends, on the parts of surfaces that it is on, and from part to part |
//! | `improved` | all starts, and the best of them |
//! | `answer`, `words` | the answer, and its sentence |

mod answer;
mod ascent;
mod curvature;
mod events;
mod goal;
mod improved;
mod loaded;
mod over_edges;
mod places;
mod placing;
mod question;
mod spline;
mod spot;
mod step;
mod sticking;
mod surface;
mod words;

pub use answer::{Binds, Improved, InTheWay, Placed, SearchEnd};
pub use goal::ImproveGoal;
pub use question::Improve;
#[cfg(feature = "serde")]
pub(crate) use surface::Shape;
pub use surface::Surface;
