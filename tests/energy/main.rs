//! The paper's quadratic program compared with complementarity, and stability of equilibria.

mod agreement;
mod first_line;
mod fixed_points;
mod onset;
mod stability;
