//! What page and still have in common: places in the coordinates of the grasp, and the scales that
//! turn newtons into metres.

use nalgebra::{Vector3, Vector6};

use super::frame::Frame;
use super::spatial_page::SpatialPage;
use super::text::short;
use crate::picture::error::{Drawn, PictureError};
use crate::spatial::{Contact, ContactState, Equilibrium, Twist};

/// Parts of the size of the picture that the largest force, moment and displacement take in the
/// picture.
const LARGEST_FORCE: f64 = 0.4;
const LARGEST_MOMENT: f64 = 0.3;
const LARGEST_DISPLACEMENT: f64 = 0.15;
/// What is left of the moment of a load about its line of action is rounding up to this part of the
/// moments that cancel in it. Without it every load would be drawn with an arrow of a moment, in
/// whichever direction rounding points.
const ROUNDING: f64 = 1e-12;
/// A motion whose rotation moves the grasp by less than this part of its translation is drawn as a
/// translation: its axis lies a billion spans away, where rounding decides on its direction.
const TURNS: f64 = 1e-9;
/// Lengths in parts of the span: a finger behind its contact, the arrow of a slip, half of the axis
/// of a free motion.
pub(super) const FINGER: f64 = 0.12;
pub(super) const SLIP: f64 = 0.09;
pub(super) const AXIS: f64 = 0.75;
/// How much longer a cone is than the arrow of the normal force in it.
pub(super) const CONE: f64 = 1.15;
/// More contacts are not named in the picture.
pub(super) const MANY: usize = 12;

pub(super) struct Drawing<'p> {
    pub(super) page: &'p SpatialPage,
    pub(super) centre: Vector3<f64>,
    /// Largest extent of the contacts and the outline along an axis, m.
    pub(super) span: f64,
    /// The span, or the distance of the farthest load where that is larger, m.
    pub(super) size: f64,
    /// m per N, m per N m, and how many times displacements are magnified.
    pub(super) force: f64,
    pub(super) moment: f64,
    pub(super) displacement: f64,
}

/// The largest force, moment and displacement among answers: N, N m, m.
#[derive(Default)]
struct Largest {
    force: f64,
    moment: f64,
    displacement: f64,
}

/// A load as a force on its line of action, at the point next to the middle of the grasp, and the
/// moment that is left.
pub(super) struct Load {
    pub(super) at: Vector3<f64>,
    pub(super) force: Vector3<f64>,
    pub(super) moment: Vector3<f64>,
}

/// Axis of a motion: of its rotation, or, where it has none, the direction in which it moves.
pub(super) struct Axis {
    pub(super) at: Vector3<f64>,
    pub(super) along: Vector3<f64>,
    pub(super) turns: bool,
}

impl<'p> Drawing<'p> {
    pub(super) fn new(page: &'p SpatialPage) -> Result<Self, PictureError> {
        for Frame { label, shown } in &page.frames {
            if let Ok(state) = shown {
                check(page, label, state)?;
            }
        }
        let corners =
            page.outlines.iter().chain(&page.fixtures).flatten().map(|corner| Vector3::from(*corner));
        let (mut low, mut high) = (Vector3::repeat(f64::INFINITY), Vector3::repeat(f64::NEG_INFINITY));
        for point in page.grasp.contacts().iter().map(Contact::point).chain(corners) {
            if !point.iter().all(|x| x.is_finite()) {
                return Err(PictureError("a corner of an outline is not finite".into()));
            }
            (low, high) = (low.inf(&point), high.sup(&point));
        }
        // A single contact has no size of its own.
        let span = if high == low { 1.0 } else { (high - low).amax() };
        let mut drawing = Self {
            page,
            centre: (low + high) / 2.0,
            span,
            size: span,
            force: 0.0,
            moment: 0.0,
            displacement: 0.0,
        };
        let states = || page.frames.iter().filter_map(Frame::state);
        // Arrows are to be seen beside a load that acts far away.
        let away = |state: &Equilibrium| (drawing.load(state).at - drawing.centre).norm();
        let size = states().map(away).fold(span, f64::max);
        let largest = drawing.largest(states());
        let part = |of: f64, largest: f64| if largest > 0.0 { of * size / largest } else { 0.0 };
        drawing.size = size;
        drawing.force = part(LARGEST_FORCE, largest.force);
        drawing.moment = part(LARGEST_MOMENT, largest.moment);
        drawing.displacement = part(LARGEST_DISPLACEMENT, largest.displacement);
        let Largest { force, moment, displacement } = largest;
        let scales = [drawing.force, drawing.moment, drawing.displacement, size, force, moment, displacement];
        if !scales.iter().chain(drawing.centre.iter()).all(|x| x.is_finite()) {
            return Err(PictureError(
                "a length, force or moment is too large or too small to be drawn".into(),
            ));
        }
        Ok(drawing)
    }

    fn largest<'s>(&self, states: impl IntoIterator<Item = &'s Equilibrium>) -> Largest {
        let mut most = Largest::default();
        for state in states {
            let load = self.load(state);
            most.force = most.force.max(load.force.norm());
            most.moment = most.moment.max(load.moment.norm());
            for contact in &state.contacts {
                most.force = most.force.max(contact.force_world.norm());
                most.displacement = most.displacement.max(contact.body_core.norm());
            }
        }
        most
    }

    /// The scales in words, for a picture of these answers.
    pub(super) fn scales<'s>(&self, states: impl IntoIterator<Item = &'s Equilibrium>) -> Vec<String> {
        let largest = self.largest(states);
        let mut sentences = vec![format!("The grasp is {} m across.", short(self.span))];
        for (what, largest, unit) in [("force", largest.force, "N"), ("moment", largest.moment, "N m")] {
            if largest > 0.0 {
                sentences.push(format!("The longest arrow of a {what} is {} {unit}.", short(largest)));
            }
        }
        if largest.displacement > 0.0 {
            let factor = short(self.displacement);
            sentences.push(format!("Displacements are drawn {factor} times as large."));
        }
        sentences
    }

    pub(super) fn load(&self, state: &Equilibrium) -> Load {
        let (force, moment) = halves(state.load.as_vector());
        let about_centre = moment - self.centre.cross(&force);
        let size = force.norm();
        if size == 0.0 {
            return Load { at: self.centre, force, moment };
        }
        let along = force / size;
        let left = along * along.dot(&about_centre);
        let rounding = ROUNDING * (size * (self.span + self.centre.norm()) + moment.norm());
        let left = if left.norm() <= rounding { Vector3::zeros() } else { left };
        Load { at: self.centre + along.cross(&(about_centre / size)), force, moment: left }
    }

    pub(super) fn axis(&self, motion: &Twist) -> Axis {
        let (moves, turns) = halves(motion.as_vector());
        let at_centre = moves + turns.cross(&self.centre);
        if turns.norm() * self.span > TURNS * at_centre.norm() {
            let at = self.centre + turns.cross(&at_centre) / turns.norm_squared();
            Axis { at, along: turns.normalize(), turns: true }
        } else {
            Axis { at: self.centre, along: at_centre.normalize(), turns: false }
        }
    }
}

/// Whether an answer is one of this grasp, and its numbers are such as can be drawn.
fn check(page: &SpatialPage, label: &str, state: &Equilibrium) -> Drawn {
    let (given, expected) = (state.contacts.len(), page.grasp.len());
    if given != expected {
        return Err(PictureError(format!("\"{label}\" has {given} contacts, the grasp has {expected}")));
    }
    let whole = state.free_motions.iter().chain([&state.twist]).map(Twist::as_vector);
    let whole = whole.chain([state.load.as_vector()]).flat_map(|v| v.iter().copied());
    let of_contacts = state.contacts.iter().flat_map(|answer| {
        let slides = match answer.state {
            ContactState::Sliding { direction } => direction,
            _ => Vector3::zeros(),
        };
        let [u, f] = [answer.body_core, answer.force_world];
        [answer.normal_force(), u.x, u.y, u.z, f.x, f.y, f.z, slides.x, slides.y, slides.z]
    });
    match whole.chain(of_contacts).find(|x| !x.is_finite()) {
        Some(x) => Err(PictureError(format!("\"{label}\" has {x} among its numbers"))),
        None => Ok(()),
    }
}

fn halves(v: &Vector6<f64>) -> (Vector3<f64>, Vector3<f64>) {
    (Vector3::new(v[0], v[1], v[2]), Vector3::new(v[3], v[4], v[5]))
}
