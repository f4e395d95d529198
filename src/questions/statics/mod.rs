//! Static questions of grasp planning, from geometry and friction alone: which loads can be balanced by some contact forces inside the friction
//! cones?
//!
//! Springs and commands do not matter here. With [force closure](crate::ask::Statics::force_closure) some contact forces balance any load. The
//! [measure of Ferrari and Canny](crate::ask::Statics::ferrari_canny) is the magnitude up to which contact forces balance loads of every direction
//! within a [`Budget`] of normal forces. [Limit analysis](crate::ask::Statics::load_limit) finds the largest multiple of a given load. Whether given
//! fingers, with their springs and commands, balance a load is answered by [`Grasp::solve`](crate::ask::Grasp::solve) and
//! [`Grasp::onset`](crate::ask::Grasp::onset).
//!
//! The pull of a vacuum does not depend on the contact forces: it is added to every load. Closure is about loads of any magnitude. If some loads
//! could not be balanced without the vacuum, the question is therefore an error.
//!
//! | file | idea |
//! |---|---|
//! | `closure` | force and form closure, with forces or a motion as the proof |
//! | `budget` | bounds of the normal forces, and the scale that compares moments with forces |
//! | `wrench_set` | the wrenches within a budget, by their support points |
//! | `ferrari_canny` | the radius of the largest ball about the origin in that set |
//! | `balance` | a motion which proves that no forces balance a load |
//! | `load_limit` | the largest multiple of a load that forces within a budget balance |

mod balance;
mod budget;
mod closure;
mod face;
mod ferrari_canny;
mod load_limit;
mod wrench_set;

pub use budget::{Budget, WrenchScale};
pub use closure::Closure;
pub use ferrari_canny::WrenchBall;
pub use load_limit::LoadLimit;
