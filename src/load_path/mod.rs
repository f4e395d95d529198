//! What happens as the load grows: the onset of sliding, found directly, and the first step beyond it.

mod beyond;
mod edge;
mod energy;
mod event;
mod leg;
mod loss;
mod margin;
mod node;
mod nothing_holds;
mod onset;
mod path;
mod questions;
mod ramp;
mod segment;
mod sensitivity;
mod stretch;
mod transition;
mod walk;

pub use beyond::{Beyond, Continuation};
pub use energy::Energy;
pub use event::{Change, Event, Loss, PathEnd};
pub use leg::Leg;
pub use onset::{Departure, Leaving, Onset, OnsetEvent};
pub use path::LoadPath;
pub use questions::{Reserve, RollingRange};
pub use ramp::Ramp;
pub use sensitivity::{Derivative, OnsetGradient, Parameter, Response};
