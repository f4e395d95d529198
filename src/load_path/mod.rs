//! What happens as the load grows: the onset of sliding, found directly, and the first step beyond it.

mod beyond;
mod margin;
mod onset;
mod ramp;
mod walk;

pub use beyond::{Beyond, Continuation};
pub use onset::{Departure, Leaving, Onset, OnsetEvent};
pub use ramp::Ramp;
