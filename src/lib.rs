//! Does the grasp hold?
#![forbid(unsafe_code)]
#![warn(missing_docs)]

pub mod equilibrium;
mod error;
pub mod formulation;
pub mod grasp;
pub mod lcp;
pub mod load_path;
#[cfg(feature = "plot")]
pub mod picture;
pub mod planar;
pub mod spatial;
pub mod sweep;

pub use equilibrium::Settings;
pub use error::{ContactLabel, Error, Field};
pub use formulation::{Fit, PolygonCone};
