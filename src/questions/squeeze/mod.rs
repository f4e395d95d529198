//! The least sufficient squeeze, the weakest direction, and the least onset within bounds of the data: computed directly, not by sampling.
//!
//! While all contacts stick, forces are linear in the load and in the commands. The condition of a contact is `a·F >= 0` for each facet of
//! its cone. The round cone has a facet `a = (μ, -cos φ, -sin φ)` at every angle φ. So the worst of all forces of size r through a point
//! is known for each facet,
//!
//! ```text
//! F(x) = F⁰ + A x,   |x| <= r:        min a·F = a·F⁰ - r |Aᵀa|
//! ```
//!
//! and as functions of φ, `a·F⁰` and the square of `|Aᵀa|` are trigonometric polynomials. Angles with a negative difference are found without losing
//! a root (`numerics/on_a_circle`). Each broken condition is linear in the squeeze and gives a lower bound of the sufficient squeeze. The next trial
//! is this bound, until no condition is broken. The bound is then also sufficient, up to rounding.
//!
//! | file | idea |
//! |---|---|
//! | `loads` | the loads that a grasp must hold |
//! | `parts` | the conditions that are broken under these loads at a given squeeze |
//! | `least_squeeze` | the least factor of the commands |
//! | `weakest_direction` | the least force, of all directions, at which a contact slides |
//! | `farthest_direction` | the least force, of all directions, at which a motion is no longer small |
//! | `bounds` | bounds of the errors of commands and loads |
//! | `least_onset` | the least onset of sliding within these bounds |

mod bounds;
mod face;
mod farthest_direction;
mod least_onset;
mod least_squeeze;
mod loads;
mod parts;
mod weakest_direction;

pub use bounds::Bounds;
pub use least_onset::LeastOnset;
pub use least_squeeze::LeastSqueeze;
pub(crate) use loads::LoadFields;
pub use loads::Loads;
pub use weakest_direction::WeakestDirection;
