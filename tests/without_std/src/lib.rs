//! What a program without std asks of grasp-lcp. The library is compiled for it with functions from `libm`, for this machine and for a processor that has no
//! system; with the feature `std` the same questions go to the library as everybody else has it.
#![no_std]

extern crate alloc;

mod asked;
mod scenes;

pub use asked::{Asked, ask};
