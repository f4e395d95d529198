//! One contact: its compliance, friction and states, independent of the grasp to which it belongs.
//!
//! Every solver uses [`LocalLaw`]. Stiffnesses are used only through [`Compliance`], friction coefficients only through [`Coulomb`].
//!
//! | file | idea |
//! |---|---|
//! | `compliance` | springs along the axes of the contact frame |
//! | `coulomb` | the cone `\|F_t\| <= μ F_n` and its facets |
//! | `polygon` | the polygonal cone in place of the round cone |
//! | `state`, `slide` | the states of a contact; a slide on the round cone with its direction and slip |
//! | `law` | the conditions that apply in an equilibrium and to the rates of force and stretch |
//! | `answer` | stretch → state and force |
//! | `kinetic` | the smaller cone of a sliding contact, and the loss of friction as it begins to slide |
//! | `springs` | the springs of a contact in a known state: the directions along which they are stretched and push |
//! | `straight_stretch` | the force after a stretch that grows along a straight line, while the slip direction turns |
//! | `relaxing_slide` | the slip direction after a straight stretch with unequal tangential springs |
//! | `tangent` | the tangent stiffness: derivative of the force with respect to the stretch |
//! | `conditions` | the inequalities of a state, with the magnitudes to which their rounding errors are proportional |
//! | `hull` | convex hull of all stretches and forces that the law allows if only part of the state is known |
//! | `most_work` | upper bound of a contact's work along a virtual motion |
//! | `resistance` | upper bound of a contact's power against a motion, for any previous slip |
//! | `edges` | the boundary of the friction cone as linear conditions on the force, and which of them a set of forces violates most |
//! | `exits` | the step along a straight line of forces at which a contact leaves its state |
//! | `turning_exits` | the angle of a turning load at which a contact leaves its state |
//! | `active_set` | the facets of the friction cone on which the force lies as the state changes, and the law of the rates just after the change |
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

pub use polygon::{PolygonCone, PolygonFit};

pub(crate) use active_set::ActiveSet;
pub(crate) use answer::ContactResponse;
pub(crate) use compliance::Compliance;
pub(crate) use conditions::SpringState;
pub(crate) use coulomb::Coulomb;
pub(crate) use edges::{Edges, involves_friction, is_broken, round_rows};
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
pub(crate) use tangential::{tangential, tangential_norm};
pub(crate) use tolerances::{MOST_SLACK, SMALLEST, WEIGHTLESS, ZERO_SLACK};
pub(crate) use turning_exits::{TurningExit, Wave};
