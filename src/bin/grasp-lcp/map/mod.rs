//! The command `map`. A force acts at one point and in one direction after the other. For each direction the map has the force at first slip and the
//! force at the end of the load path. The weakest direction is that of the least force at first slip.
//!
//! First slip and the weakest direction are computed directly. The map also has a smaller force, which allows for uncertain friction, stiffness and
//! clamping force. Under this smaller force, these data may deviate by a given number of standard deviations before a contact slides. In each
//! direction the load path is followed from one change of contact states to the next, with the accumulated slips of all contacts. It ends at the load
//! at which equilibrium is lost. The answer distinguishes limit loads, beyond which no equilibrium exists, from snaps, beyond which the grasp may or
//! may not reach another equilibrium.

mod ask;
mod data_deviations;
mod limit;
mod plane;
mod rows;
mod space;
mod watch;
mod written;

use grasp_lcp::scene::Scene;

use crate::arguments::Numbers;
use crate::failure::Failure;
use crate::files::Pictures;
use crate::loads::OptionVectors;
pub(crate) use data_deviations::DataDeviations;
pub(crate) use watch::MapProgress;

/// Prints a table and draws the maps of a scene, for a force at a point. The constant load (base load or load at the start) of the scene's questions
/// acts in addition. If `pictures` is `None`, prints the map as JSON.
pub(crate) fn map(
    scene: &Scene,
    at: Option<&Numbers>,
    asked: (&DataDeviations, MapProgress),
    pictures: Option<&Pictures>,
) -> Result<(), Failure> {
    let at = OptionVectors::of(&scene.setup).point(at)?;
    match scene.planar() {
        Some(setup) => plane::map(&setup, [at[0], at[1]], asked, pictures),
        None => space::map(&scene.setup, at, asked, pictures),
    }
}
