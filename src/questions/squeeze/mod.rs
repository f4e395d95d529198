//! Two questions about grasps that only stick. The least squeeze is the least factor on commands and vacuums with which all contacts stick. The
//! weakest direction is that of the least force that makes a contact slide or open. Both are computed without sampling.
//!
//! While all contacts stick, the contact forces are affine in the load and in the commands (displacements that the fingers would make if there were
//! no object). Let F be the force of a contact (normal component first), and a the coefficients of a facet of its friction cone. The contact sticks
//! if `a·F >= 0` for each facet. The round cone has a facet `a = (μ, -cos φ, -sin φ)` at every angle φ. Among the forces x of magnitude at most r
//! through a point, the one that lowers `a·F` most is then known for each facet,
//!
//! ```text
//! F(x) = F⁰ + A x,   |x| <= r:        min a·F = a·F⁰ - r |Aᵀa|
//! ```
//!
//! with F⁰ the force of the contact without x, and A the map from x to the change of F. As functions of φ, `a·F⁰` and the square of `|Aᵀa|` are
//! trigonometric polynomials. Angles at which `a·F⁰ - r |Aᵀa|` is negative are found without losing a root (`numerics/on_a_circle`). Each condition
//! `a·F >= 0` is affine in the factor on commands and vacuums, so a condition that fails gives a lower bound of the factor that is needed. This bound
//! is tried next, until no condition fails. The last bound is the least factor with which all contacts stick, up to rounding.
//!
//! | file | idea |
//! |---|---|
//! | `loads` | the loads that a grasp must hold |
//! | `parts` | the condition `a·F >= 0` that is broken most under these loads at a given factor on commands and vacuums |
//! | `least_squeeze` | the least factor on commands and vacuums with which all contacts stick |
//! | `weakest_direction` | the least force, over all directions, at which a contact ceases to stick |
//! | `farthest_direction` | the least force, over all directions, that moves the object beyond small motions while all contacts stick |

mod face;
mod farthest_direction;
mod least_squeeze;
mod loads;
mod parts;
mod weakest_direction;

pub use least_squeeze::LeastSqueeze;
pub(crate) use loads::LoadFields;
pub use loads::Loads;
pub use weakest_direction::WeakestDirection;
