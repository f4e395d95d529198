//! Questions to grasp-lcp from a program without std. The library then uses functions of `libm`. It is compiled for this machine, and for a processor
//! without an operating system. With the feature `std` the same questions go to the library with std.
#![no_std]

extern crate alloc;

mod asked;
mod scenes;

pub use asked::{Asked, ask};
