//! The geometry of a spatial grasp for both its HTML page and its still picture (SVG). It has points in the coordinates of the grasp, and the scales
//! of forces, moments and displacements. A fixture is something that does not move, such as a table.

use crate::numerics::{IntoList, mapped};
use nalgebra::{Vector3, Vector6};

use super::content::Page;
use super::frame::Frame;
use super::solid::bodies;
use crate::grasp::ContactPoints;
use crate::numerics::tolerances::{NEGLIGIBLE, SOLVED_ROUNDING};
use crate::picture::error::PictureError;
use crate::picture::force_scale::metres_per_newton;
use crate::picture::round_numbers::round_down;
use crate::picture::words::short;
use crate::spatial::{Contact, ContactState, Equilibrium, Twist, Wrench};

pub(super) struct Drawing<'p> {
    pub(super) page: &'p Page,
    pub(super) tips: &'p [ContactPoints],
    /// Corners of each convex part of the object that is drawn as a solid, m.
    pub(super) bodies: Vec<Vec<[f64; 3]>>,
    pub(super) centre: Vector3<f64>,
    /// Largest extent of contact points, outlines and fixtures along an axis, m; 1 m for a single point.
    pub(super) span: f64,
    /// The size of the area that is drawn, m: the span, or the distance from the centre of the grasp to the farthest load if this is larger.
    pub(super) size: f64,
    /// Length of an arrow per unit of its force, m/N.
    pub(super) force: f64,
    /// Length of an arrow per unit of its moment, m/(N m).
    pub(super) moment: f64,
    /// Magnification of displacements; 0 if they are not drawn.
    pub(super) displacement: f64,
    /// The largest displacement, m, if displacements are too large to be drawn, i.e. if their magnification is below 1.
    undrawn: Option<f64>,
}

/// The largest force, moment and displacement of all answers: N, N m, m.
#[derive(Default)]
struct LargestValues {
    force: f64,
    moment: f64,
    displacement: f64,
}

/// The arrows of a load. The force is drawn on its line of action, at the point nearest to the centre of the grasp, with the moment about this line.
/// If the line is farther from the centre than 1.5 times the span, the force is drawn at the centre, with the moment about the centre.
pub(super) struct LoadArrow {
    pub(super) at: Vector3<f64>,
    pub(super) force: Vector3<f64>,
    pub(super) moment: Vector3<f64>,
    /// Whether the force is drawn at the centre of the grasp instead of on its line of action.
    pub(super) is_moved: bool,
}

/// Axis of a motion of the object: the axis of a rotation (`turns` is true), or the direction of a pure translation.
pub(super) struct Axis {
    pub(super) at: Vector3<f64>,
    pub(super) along: Vector3<f64>,
    pub(super) turns: bool,
}

impl<'p> Drawing<'p> {
    pub(super) fn new(page: &'p Page) -> Result<Self, PictureError> {
        for frame in &page.frames {
            if let Some(state) = frame.state() {
                check(page, &frame.label, state)?;
            }
            let mut numbers: Vec<f64> = Vec::new();
            if let Some(load) = &frame.load {
                numbers.extend(load.components());
            }
            if let Some(motion) = &frame.leaving {
                numbers.extend(motion.object.components());
            }
            if let Some(x) = numbers.iter().find(|x| !x.is_finite()) {
                return Err(PictureError(format!("\"{}\" has {x} among its numbers", frame.label)));
            }
        }
        let mut points: Vec<Vector3<f64>> = mapped(page.grasp.contacts(), &Contact::point);
        for corners in page.outlines.iter().map(|line| &line.corners).chain(&page.fixtures) {
            points.extend(mapped(corners, &|corner| Vector3::from(*corner)));
        }
        let (mut low, mut high) = (Vector3::repeat(f64::INFINITY), Vector3::repeat(f64::NEG_INFINITY));
        for point in points {
            if !point.iter().all(|x| x.is_finite()) {
                return Err(PictureError("a corner of an outline is not finite".into()));
            }
            (low, high) = (low.inf(&point), high.sup(&point));
        }
        // A single contact has no extent; 1 m is used as its size.
        let span = if high == low { 1.0 } else { (high - low).amax() };
        let mut drawing = Self {
            page,
            tips: page.grasp.engine.wholes(),
            bodies: bodies(&page.outlines),
            centre: (low + high) / 2.0,
            span,
            size: span,
            force: 0.0,
            moment: 0.0,
            displacement: 0.0,
            undrawn: None,
        };
        let states = || page.frames.iter().filter_map(Frame::state);
        let loads = || page.frames.iter().filter_map(Frame::load).map(|load| drawing.load(load));
        // If a load acts farther from the centre than the span of the grasp, the picture shows an area as large as this distance. The lengths of
        // arrows are proportional to this size, too, so that arrows remain visible.
        let away = |load: LoadArrow| (load.at - drawing.centre).norm();
        let size = loads().map(away).fold(span, f64::max);
        let mut largest = drawing.largest(states());
        for load in loads() {
            largest.force = largest.force.max(load.force.norm());
            largest.moment = largest.moment.max(load.moment.norm());
        }
        let part = |of: f64, largest: f64| if largest > 0.0 { of * size / largest } else { 0.0 };
        drawing.size = size;
        drawing.force = drawing.force_scale(states(), largest.force);
        drawing.moment = part(0.3, largest.moment);
        drawing.displacement = part(0.2, largest.displacement);
        if drawing.displacement > 0.0 && drawing.displacement.is_finite() {
            drawing.displacement = round_down(drawing.displacement);
            if drawing.displacement < 1.0 {
                (drawing.displacement, drawing.undrawn) = (0.0, Some(largest.displacement));
            }
        }
        let LargestValues { force, moment, displacement } = largest;
        let scales = [drawing.force, drawing.moment, drawing.displacement, size, force, moment, displacement];
        if !scales.iter().chain(drawing.centre.iter()).all(|x| x.is_finite()) {
            return Err(PictureError(
                "a length, force or moment is too large or too small to be drawn".into(),
            ));
        }
        Ok(drawing)
    }

    fn largest<'s>(&self, states: impl IntoIterator<Item = &'s Equilibrium>) -> LargestValues {
        let mut most = LargestValues::default();
        for state in states {
            for tip in self.tips {
                let resultant = tip.resultant(self.page.grasp.contacts(), state);
                most.force = most.force.max(resultant.force.norm());
                most.displacement = most.displacement.max(resultant.displacement.norm());
            }
            for line in &self.page.outlines {
                let away = line
                    .corners
                    .iter()
                    .map(|corner| displacement_at(state, line.body, &Vector3::from(*corner)).norm());
                most.displacement = away.fold(most.displacement, f64::max);
            }
        }
        most
    }

    /// Scale of forces of all answers, m/N: the smallest of the scales of the single answers.
    fn force_scale<'s>(&self, states: impl Iterator<Item = &'s Equilibrium>, largest: f64) -> f64 {
        let grasp = &self.page.grasp;
        let frames: Vec<_> = grasp.frames().list();
        let scale = |state: &Equilibrium| {
            let push = |tip: &ContactPoints| {
                let pushed = tip.resultant(grasp.contacts(), state).normal_force;
                (tip.middle(grasp.contacts()), frames[tip.range.start].column(0).into_owned(), pushed)
            };
            let pushes: Vec<_> = mapped(self.tips, &push);
            metres_per_newton(&pushes, self.size, largest)
        };
        // Without an equilibrium the load is the only force.
        states.map(scale).reduce(f64::min).unwrap_or_else(|| metres_per_newton(&[], self.size, largest))
    }

    /// Sentences about the size of the grasp and the magnification of displacements, written beside the picture.
    pub(super) fn scales(&self) -> Vec<String> {
        let mut sentences = vec![format!("The grasp is {} m across.", short(self.span))];
        if self.displacement > 0.0 {
            let factor = short(self.displacement);
            let size = if factor == "1" {
                "as large as they are".into()
            } else {
                format!("{factor} times as large")
            };
            sentences.push(format!("Displacements are drawn {size}."));
        } else if let Some(size) = self.undrawn {
            let size = short(size);
            sentences.push(format!("Displacements of up to {size} m are too large beside it to be drawn."));
        }
        sentences
    }

    pub(super) fn load(&self, load: &Wrench) -> LoadArrow {
        let (force, moment) = halves(&load.to_vector());
        let about_centre = moment - self.centre.cross(&force);
        let size = force.norm();
        let in_the_middle = |is_moved| LoadArrow { at: self.centre, force, moment: about_centre, is_moved };
        if size == 0.0 {
            return LoadArrow { moment, ..in_the_middle(false) };
        }
        let along = force / size;
        let away = along.cross(&(about_centre / size));
        // A line of action may be farther away than 1.5 times the span. If the picture contained it, the grasp would be a dot. The force is then
        // drawn in the middle of the grasp.
        if away.norm() > 1.5 * self.span {
            return in_the_middle(true);
        }
        let left = along * along.dot(&about_centre);
        let rounding = SOLVED_ROUNDING * (size * (self.span + self.centre.norm()) + moment.norm());
        let left = if left.norm() <= rounding { Vector3::zeros() } else { left };
        LoadArrow { at: self.centre + away, force, moment: left, is_moved: false }
    }

    pub(super) fn axis(&self, motion: &Twist) -> Axis {
        let (moves, turns) = halves(&motion.to_vector());
        let at_centre = moves + turns.cross(&self.centre);
        if turns.norm() * self.span > NEGLIGIBLE * at_centre.norm() {
            let at = self.centre + turns.cross(&at_centre) / turns.norm_squared();
            Axis { at, along: turns.normalize(), turns: true }
        } else {
            Axis { at: self.centre, along: at_centre.normalize(), turns: false }
        }
    }
}

/// The twist of the object, or of one of several bodies, in an answer.
pub(super) fn twist_of(state: &Equilibrium, body: usize) -> &Twist {
    state.bodies.get(body).map_or(&state.twist, |motion| &motion.twist)
}

/// The displacement of a point of a body, to first order.
pub(super) fn displacement_at(state: &Equilibrium, body: usize, point: &Vector3<f64>) -> Vector3<f64> {
    let (moves, turns) = halves(&twist_of(state, body).to_vector());
    moves + turns.cross(point)
}

/// Checks that an answer belongs to this grasp, and that its numbers are finite.
fn check(page: &Page, label: &str, state: &Equilibrium) -> Result<(), PictureError> {
    let (given, expected) = (state.contacts.len(), page.grasp.len());
    if given != expected {
        return Err(PictureError(format!("\"{label}\" has {given} contacts, the grasp has {expected}")));
    }
    let mut numbers: Vec<f64> = Vec::new();
    for motion in &state.free_motions {
        numbers.extend(motion.object.components());
    }
    for motion in &state.bodies {
        numbers.extend(motion.twist.components());
    }
    numbers.extend(state.twist.components());
    numbers.extend(state.load.components());
    for answer in &state.contacts {
        numbers.push(answer.normal_force());
        numbers.extend(answer.body_core.as_slice());
        numbers.extend(answer.force_world.as_slice());
        if let ContactState::Sliding { direction } = &answer.state {
            numbers.extend(direction.as_slice());
        }
    }
    match numbers.iter().find(|x| !x.is_finite()) {
        Some(x) => Err(PictureError(format!("\"{label}\" has {x} among its numbers"))),
        None => Ok(()),
    }
}

pub(super) fn halves(v: &Vector6<f64>) -> (Vector3<f64>, Vector3<f64>) {
    (Vector3::new(v[0], v[1], v[2]), Vector3::new(v[3], v[4], v[5]))
}
