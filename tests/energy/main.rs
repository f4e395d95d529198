//! The quadratic program of the paper beside complementarity, and stability.

mod agreement;
mod first_line;
mod fixed_points;
mod onset;
mod stability;
