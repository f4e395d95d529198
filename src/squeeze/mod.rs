//! How much squeeze suffices, which direction is weakest, and the least onset within bounds of the data: found directly, not by sampling.
//!
//! While everything sticks, forces are linear in the load and in the commands. A contact asks of its force that `a·F >= 0` for each facet of
//! its cone. The round cone has a facet `a = (μ, -cos φ, -sin φ)` at every angle φ. So the worst of all forces of size r through a point
//! is known for each facet,
//!
//! ```text
//! F(x) = F⁰ + A x,   |x| <= r:        min a·F = a·F⁰ - r |Aᵀa|
//! ```
//!
//! and as φ goes round, `a·F⁰` and the square of `|Aᵀa|` are trigonometric polynomials. Where the difference is negative is found without a
//! root lost (`numerics/on_a_circle`). Each condition that is broken is linear in the squeeze: it says how much is needed at least. The
//! next squeeze is that, until none is broken. What is needed at least and what suffices then are one number, up to rounding.
//!
//! | file | idea |
//! |---|---|
//! | `loads` | the loads that a grasp is to hold |
//! | `parts` | what is broken under them at some squeeze |
//! | `sticking` | forces of every contact while everything sticks |
//! | `least_squeeze` | the least factor of the commands |
//! | `weakest_direction` | the least force, of all directions, at which something slides |
//! | `bounds` | how far commands and loads may be off |
//! | `least_onset` | the least onset of sliding over all of them |

mod bounds;
mod least_onset;
mod least_squeeze;
mod loads;
mod parts;
mod sticking;
mod weakest_direction;

pub use bounds::Bounds;
pub use least_onset::LeastOnset;
pub use least_squeeze::LeastSqueeze;
pub use loads::Loads;
pub use weakest_direction::WeakestDirection;
