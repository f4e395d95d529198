//! The questions that grasp planners ask first, of geometry and friction alone: which loads *could* contact forces balance?
//!
//! Nothing here knows of springs or of how much the fingers press. [Force closure](crate::grasp::Grasp::force_closure) says that some contact
//! forces balance any load whatever. Whether these fingers, squeezed this much, do so is for [`Grasp::solve`](crate::grasp::Grasp::solve) and
//! [`Grasp::onset`](crate::grasp::Grasp::onset) to say.

mod closure;

pub use closure::Closure;
