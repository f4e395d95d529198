//! The questions that grasp planners ask first, of geometry and friction alone: which loads *could* contact forces balance?
//!
//! Nothing here knows of springs or of how much the fingers press. [Force closure](crate::ask::Statics::force_closure) says that some contact
//! forces balance any load whatever. The [measure of Ferrari and Canny](crate::ask::Statics::ferrari_canny) says how large a load of the worst direction they
//! balance within a [`Budget`] of normal forces; [limit analysis](crate::ask::Statics::load_limit) how far a given one can grow. Whether these fingers,
//! squeezed this much, do so is for [`Grasp::solve`](crate::ask::Grasp::solve) and [`Grasp::onset`](crate::ask::Grasp::onset) to say.
//!
//! The force of a vacuum is there whatever contacts do: it counts as part of every load. Closure, which asks for loads of any size, is refused where it
//! rests on one.
//!
//! | file | idea |
//! |---|---|
//! | `closure` | force and form closure, with forces or a motion as the proof |
//! | `budget` | what bounds the normal forces, and how moments are measured |
//! | `wrench_set` | the wrenches within a budget, by their farthest points |
//! | `ferrari_canny` | the largest ball in that set |
//! | `load_limit` | how far a load stays in it |

mod budget;
mod closure;
mod ferrari_canny;
mod load_limit;
mod wrench_set;

pub use budget::{Budget, WrenchScale};
pub use closure::Closure;
pub use ferrari_canny::WrenchBall;
pub use load_limit::LoadLimit;
