//! The paper's quadratic program compared with complementarity.

mod agreement;
mod first_line;
mod fixed_points;
mod onset;
