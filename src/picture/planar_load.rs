//! A planar load as it is drawn: a force on its line of action, or in the middle with a moment.

use nalgebra::Vector2;

use crate::planar::Wrench;

/// Parts of the size of the object: a line of action that passes its middle at a larger distance is
/// beside it.
const BESIDE: f64 = 0.5;
/// A force of a smaller part of the moment over the size of the object is the rounding of none.
const ROUNDING: f64 = 1e-12;

/// N, N m, m.
pub(super) struct PlanarLoad {
    pub(super) at: Vector2<f64>,
    pub(super) force: Vector2<f64>,
    /// About the point at which the force is drawn.
    pub(super) moment: f64,
}

impl PlanarLoad {
    /// For an object of a size (m) with this middle.
    pub(super) fn new(load: &Wrench, middle: Vector2<f64>, size: f64) -> Self {
        let load = load.components();
        let (force, about_origin) = (Vector2::new(load[0], load[1]), load[2]);
        let moment = about_origin - middle.perp(&force);
        if force.norm() * size <= ROUNDING * moment.abs() {
            return Self { at: middle, force: Vector2::zeros(), moment };
        }
        // From the middle to the nearest point of the line of action.
        let away = Vector2::new(force.y, -force.x) * (moment / force.norm_squared());
        if away.norm() <= BESIDE * size {
            Self { at: middle + away, force, moment: 0.0 }
        } else {
            Self { at: middle, force, moment }
        }
    }

    /// Of the force against x, rad; zero where there is none.
    pub(super) fn angle(&self) -> f64 {
        self.force.y.atan2(self.force.x)
    }
}
