//! One contact: its compliance, friction and states, independent of the scene.
//!
//! Every solver uses [`LocalLaw`]. Only [`Compliance`] reads stiffnesses, only [`Coulomb`] reads μ.
//!
//! | file | idea |
//! |---|---|
//! | `compliance` | springs along the axes of the contact frame |
//! | `coulomb` | the cone `\|F_t\| <= μ F_n` and its facets |
//! | `polygon` | the polygonal cone in place of the round one |
//! | `state`, `slide` | the states of a contact, with their data |
//! | `law` | the conditions that apply: at rest, in rates, on an edge |
//! | `answer` | stretch → state and force |
//! | `kinetic` | the smaller cone of a sliding contact, and the drop of its force as it begins to slide |
//! | `springs` | the springs of a contact in a known state: left and right factors |
//! | `straight_stretch` | the force after a straight stretch, with the slip turning on the way |
//! | `relaxing_slide` | the direction of the slip at the end of a straight stretch |
//! | `tangent` | the derivative of force by stretch |
//! | `conditions` | the conditions of a state, with sizes |
//! | `hull` | everything the law allows where only part of the state is known |
//! | `most_work` | the most work of a contact along a virtual motion |
//! | `resistance` | the most power of a contact against a motion, whatever it has slipped |
//! | `edges` | the conditions on the force of a sticking contact, and those that sets of forces come nearest to |
//! | `exits` | the distance along a straight line to the end of a state |
//! | `turning_exits` | the angle of a turning load to the end of a state |
//! | `active_set` | the edges reached at an event, and the law of the rates |
//! | `tolerances` | limits below which a quantity counts as zero |

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
pub(crate) use conditions::SpringState;
pub(crate) use coulomb::Coulomb;
pub(crate) use edges::{Edges, is_broken, round_rows, rubs};
pub(crate) use exits::{Exit, GapLine, Line};
#[cfg(test)]
pub(crate) use hull::Sector;
pub(crate) use hull::{HullRay, Label};
pub(crate) use law::{Law, LocalLaw};
pub(crate) use polygon::Polygon;
pub(crate) use resistance::Resistance;
pub(crate) use slide::Slide;
pub(crate) use springs::Spring;
pub(crate) use state::{Mode, State};
pub(crate) use tangent::Tangent;
pub(crate) use tangential::{cross, tangential, tangential_norm};
pub(crate) use tolerances::{MOST_SLACK, SMALLEST, WEIGHTLESS, ZERO_SLACK};
pub(crate) use turning_exits::{TurningExit, Wave};
