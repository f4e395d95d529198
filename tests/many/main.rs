//! Many questions at once.

mod robust_onset;
mod screening;
mod screening_exact;
mod sweep;
mod thread_count;
