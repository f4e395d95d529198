//! The quadratic program of the paper, laws of friction, stability.

mod agreement;
mod associated_friction;
mod first_line;
mod fixed_points;
mod onset;
mod stability;
