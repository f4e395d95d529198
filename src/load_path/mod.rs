//! What happens as the load grows: the onset of sliding, found directly, and the first step beyond it; whole load programs, with slip memory,
//! for a few contacts ([`LoadPath`]) or thousands ([`PatchPath`]).

mod arc;
mod beyond;
mod edge;
mod energy;
mod event;
mod extrapolation;
mod leg;
mod loss;
mod margin;
mod node;
mod nothing_holds;
mod onset;
mod pace;
mod patch;
mod path;
mod questions;
mod ramp;
mod segment;
mod sensitivity;
mod standing;
mod straight;
mod stretch;
mod transition;
mod turning;
mod walk;
mod watch;

pub use beyond::{Beyond, Continuation};
pub use energy::Energy;
pub use event::{Change, Event, Loss, PathEnd};
pub use leg::Leg;
pub(crate) use margin::ROUNDING;
pub use onset::{Departure, Leaving, Onset, OnsetEvent};
pub use patch::{PatchEvent, PatchPath};
pub use path::LoadPath;
pub use questions::{Reserve, RollingRange};
pub use ramp::Ramp;
pub use sensitivity::{Derivative, OnsetGradient, Parameter, Response};
