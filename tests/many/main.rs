//! Many questions at once.

mod screening;
mod screening_exact;
mod sweep;
mod thread_count;
