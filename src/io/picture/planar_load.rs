//! The arrows of a planar load. Its force is drawn on the line of action, or at the centre of the object with the moment about the centre.

use super::axes::EqualScales;
use super::labels::Labels;
use super::layout::MARKS;
use super::painting::{Painting, flat};
use super::palette::{BLACK, GREY};
use super::sheet::{PaperPoint, Sheet};
use super::words::short;
use crate::grasp::Wrench;
use crate::numerics::Each;
use crate::numerics::tolerances::SOLVED_ROUNDING;
use nalgebra::Vector2;

/// A planar load in the form in which it is drawn: force in N, moment in N m, point of action in m.
pub(super) struct PlanarLoad {
    pub(super) at: Vector2<f64>,
    pub(super) force: Vector2<f64>,
    /// Moment about the point `at`, N m.
    pub(super) moment: f64,
}

impl PlanarLoad {
    /// The load on an object of the size `size` (m) with this centre. The force acts at the point of its line that is nearest to the centre. If this
    /// point is farther away than half the size, the force acts at the centre.
    pub(super) fn new(load: &Wrench<3>, middle: Vector2<f64>, size: f64) -> Self {
        let (force, about_origin) = (load.force_part().xy(), load.moment()[2]);
        let moment = about_origin - middle.perp(&force);
        if force.norm() * size <= SOLVED_ROUNDING * moment.abs() {
            return Self { at: middle, force: Vector2::zeros(), moment };
        }
        // The vector from the middle to the nearest point of the line of action.
        let away = Vector2::new(force.y, -force.x) * (moment / force.norm_squared());
        // A line of action within half the object's size from its centre is taken to pass through the object or close by.
        if away.norm() <= 0.5 * size {
            Self { at: middle + away, force, moment: 0.0 }
        } else {
            Self { at: middle, force, moment }
        }
    }

    /// Angle of the force, rad, counterclockwise from the x axis; zero without force.
    pub(super) fn angle(&self) -> f64 {
        self.force.y.atan2(self.force.x)
    }
}

/// A load on paper, with the ends of its arrow in pixels.
pub(super) struct LoadOnPaper<'l> {
    load: &'l PlanarLoad,
    from: PaperPoint,
    tip: PaperPoint,
    /// True if the arrow has the scale of the other forces. If such an arrow is too short to be visible, it is lengthened, and this is false.
    is_to_scale: bool,
}

impl<'l> LoadOnPaper<'l> {
    /// Converts `load` to pixels on these axes. `scale` is the length of an arrow per unit of force, m/N.
    pub(super) fn new(load: &'l PlanarLoad, axes: &EqualScales, scale: f64) -> Self {
        let (from, to) = (axes.place(load.at), axes.place(load.at + load.force * scale));
        let long = (to.0 - from.0).hypot(to.1 - from.1);
        let is_to_scale = load.force == Vector2::zeros() || long >= MARKS.shortest_load;
        let (sin, cos) = load.angle().sin_cos();
        let tip = if is_to_scale {
            to
        } else {
            (from.0 + MARKS.shortest_load * cos, from.1 - MARKS.shortest_load * sin)
        };
        Self { load, from, tip, is_to_scale }
    }

    pub(super) fn paint(&self, axes: &EqualScales, painting: &mut Painting) {
        let PlanarLoad { at, force, moment } = *self.load;
        let acts = force != Vector2::zeros();
        if acts {
            painting.arrow([self.from, self.tip].each(flat), BLACK, 3.0, 1);
        }
        if moment == 0.0 && acts {
            // The force is scaled first, because the square of a tiny force may be zero.
            painting.dashes(axes.line_ends(at, (force / force.amax()).normalize()), GREY, 1.0);
        }
        if moment != 0.0 {
            // The arc of the moment's arrow is open on the side to which the force points.
            painting.arc(self.from, MARKS.moment_arc, self.load.angle(), moment < 0.0, BLACK, 2.0);
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
            // The label is written on the closed side of the arc.
            let ((x, y), (sin, cos)) = (self.from, self.load.angle().sin_cos());
            let words = format!("moment {} N m", short(moment));
            labels.write(paper, (x - MARKS.moment_arc * cos, y + MARKS.moment_arc * sin), &[&words], size);
        }
    }
}
