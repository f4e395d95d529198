//! One contact: how it gives way, how it rubs, what it does. It knows nothing of the scene.
//!
//! [`LocalLaw`] is the value that every engine asks. Only [`Compliance`] sees stiffnesses, only [`Coulomb`] sees μ.
//!
//! | file | idea |
//! |---|---|
//! | `compliance` | springs along the axes of the contact frame |
//! | `coulomb` | the cone `\|F_t\| <= μ F_n` and its facets |
//! | `polygon` | the polygonal cone in place of the round one |
//! | `state`, `slide` | what the contact does, with all that belongs to it |
//! | `law` | which of its conditions count: at rest, in rates, on an edge |
//! | `answer` | stretch → state and force |
//! | `kinetic` | the smaller cone of a contact that slides, and what it answers as it begins to |
//! | `springs` | in a known state: left and right factors |
//! | `straight_stretch` | its force after a stretch that went straight, with the slip that turned on the way |
//! | `relaxing_slide` | which way it slides in the end |
//! | `tangent` | how its force changes with its stretch |
//! | `conditions` | what a state must satisfy, with sizes |
//! | `hull` | where only part of its state is known: all that its law allows |
//! | `most_work` | what a contact can do against a virtual motion |
//! | `resistance` | what it can do against a motion, whatever it has slipped |
//! | `edges` | what a sticking contact asks of its force |
//! | `exits` | how far a straight line stays in a state |
//! | `turning_exits` | how far a load can turn before it leaves a state |
//! | `active_set` | what it stands on at an event, and the law of its rates |
//! | `tolerances` | what counts as zero |

mod active_set;
mod answer;
mod compliance;
mod conditions;
mod coulomb;
mod edges;
mod exits;
mod hull;
mod kinetic;
mod law;
mod most_work;
mod polygon;
mod relaxing_slide;
mod resistance;
mod slide;
mod springs;
mod state;
mod straight_stretch;
mod tangent;
mod tangential;
mod tolerances;
mod turning_exits;

pub use polygon::{Fit, PolygonCone};

pub(crate) use active_set::ActiveSet;
pub(crate) use answer::ContactResponse;
pub(crate) use compliance::Compliance;
pub(crate) use conditions::At;
pub(crate) use coulomb::Coulomb;
pub(crate) use edges::Edges;
pub(crate) use exits::{Exit, GapLine, Line};
#[cfg(test)]
pub(crate) use hull::Sector;
pub(crate) use hull::{HullRay, Label};
pub(crate) use law::{Law, LocalLaw};
pub(crate) use polygon::Polygon;
pub(crate) use resistance::Resistance;
pub(crate) use slide::Slide;
pub(crate) use springs::Spring;
pub(crate) use state::{Mode, PolygonState, State};
pub(crate) use tangent::Tangent;
pub(crate) use tangential::{cross, tangential, tangential_norm};
pub(crate) use tolerances::{SMALLEST, WEIGHTLESS, ZERO_SLACK};
pub(crate) use turning_exits::{TurningExit, Wave};
