//! How much is held in every direction: onset of sliding and what the load path holds, with the weakest direction.
//!
//! The onset is found directly, and so is the weakest direction. Beside the onset stands what is left of it with standard deviations in reserve,
//! where friction, stiffness and squeeze are not known exactly. The limit is where the load path in that direction is lost, followed from event to event with slip
//! memory. How it is lost is told: a limit load has no equilibrium beyond; at a snap there are others, to which a grasp may or may not come.

mod ask;
mod limit;
mod plane;
mod rows;
mod space;
mod unsure;
mod watch;
mod written;

use grasp_lcp::scene::{Scene, Space};

use crate::arguments::Numbers;
use crate::failure::Failure;
use crate::files::Pictures;
use crate::loads::point;
pub(crate) use unsure::Unsure;
pub(crate) use watch::Watch;

/// Prints a table and draws the maps of a scene, for a force at a point. It comes on top of the base load of the first onset that the scene asks for.
/// Without a place for pictures all that is known is printed for machines.
pub(crate) fn map(
    scene: &Scene,
    at: Option<&Numbers>,
    asked: (&Unsure, Watch),
    pictures: Option<&Pictures<'_>>,
) -> Result<(), Failure> {
    match &scene.space {
        Space::Planar(setup) => plane::map(setup, point(at)?, asked, pictures),
        Space::Spatial(setup) => space::map(setup, point(at)?, asked, pictures),
    }
}
