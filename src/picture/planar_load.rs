//! A planar load as it is drawn: a force on its line of action, or in the middle with a moment.

use nalgebra::Vector2;
use plotters::style::colors::BLACK;

use super::axes::EqualScales;
use super::labels::Labels;
use super::painting::{Painting, flat};
use super::palette::GREY;
use super::sheet::{Place, Sheet};
use super::words::short;
use crate::planar::Wrench;

/// Parts of the size of the object: a line of action that passes its middle at a larger distance is
/// beside it.
const BESIDE: f64 = 0.5;
/// A force of a smaller part of the moment over the size of the object is the rounding of none.
const ROUNDING: f64 = 1e-12;

/// Radius of the arc of a moment, pixels.
const ARC: f64 = 30.0;
/// A shorter arrow of a force would hardly be seen, pixels.
const SHORTEST: f64 = 18.0;

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

/// A load as it is drawn.
pub(super) struct LoadOnPaper<'l> {
    load: &'l PlanarLoad,
    from: Place,
    tip: Place,
    /// The arrow is as long as forces of its size are.
    is_to_scale: bool,
}

impl<'l> LoadOnPaper<'l> {
    /// On these axes, with so many metres for a newton.
    pub(super) fn new(load: &'l PlanarLoad, axes: &EqualScales, scale: f64) -> Self {
        let (from, to) = (axes.place(load.at), axes.place(load.at + load.force * scale));
        let long = (to.0 - from.0).hypot(to.1 - from.1);
        let is_to_scale = load.force == Vector2::zeros() || long >= SHORTEST;
        let (sin, cos) = load.angle().sin_cos();
        let tip = if is_to_scale { to } else { (from.0 + SHORTEST * cos, from.1 - SHORTEST * sin) };
        Self { load, from, tip, is_to_scale }
    }

    pub(super) fn paint(&self, axes: &EqualScales, painting: &mut Painting) {
        let PlanarLoad { at, force, moment } = *self.load;
        let acts = force != Vector2::zeros();
        if acts {
            painting.arrow([self.from, self.tip].map(flat), BLACK, 3.0, 1);
        }
        if moment == 0.0 && acts {
            // As long as it is: a square of a tiny force may be zero.
            painting.dashes(axes.across(at, (force / force.amax()).normalize()), GREY, 1.0);
        }
        if moment != 0.0 {
            // Open where the force leaves.
            painting.arc(self.from, ARC, self.load.angle(), moment < 0.0, BLACK, 2.0);
            painting.dot(flat(self.from), 3.0, BLACK, false);
        }
    }

    pub(super) fn write(&self, paper: &mut Sheet, labels: &mut Labels, size: f64) {
        let PlanarLoad { force, moment, .. } = *self.load;
        if force != Vector2::zeros() {
            let scale = if self.is_to_scale { "" } else { ", not to scale" };
            labels.write(paper, self.tip, &[&format!("load {} N{scale}", short(force.norm()))], size);
        }
        if moment != 0.0 {
            // Beside the arc, where it is closed.
            let ((x, y), (sin, cos)) = (self.from, self.load.angle().sin_cos());
            let words = format!("moment {} N m", short(moment));
            labels.write(paper, (x - ARC * cos, y + ARC * sin), &[&words], size);
        }
    }
}
