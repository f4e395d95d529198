//! Many questions at once: batches, sweeps, samples and screening.

mod amount_batch;
mod point_batch;
mod reserve;
mod samples;
mod screened_scenes;
mod screening;
mod screening_exact;
mod screening_exact_space;
mod screening_gradients;
mod screening_gradients_exact;
mod screening_squeeze;
mod screening_watch;
mod sweep;
mod thread_count;
mod verdict_batch;
