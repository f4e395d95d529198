//! Many questions at once.

#[path = "../common/mod.rs"]
mod common;

mod screening;
mod screening_exact;
mod sweep;
mod thread_count;
