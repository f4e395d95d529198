//! Does the grasp hold?
#![forbid(unsafe_code)]
#![warn(missing_docs)]

pub mod lcp;
