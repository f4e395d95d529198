//! What a page draws, as JSON: places and arrows in the coordinates of the grasp, and the scales that turn newtons into metres.

use nalgebra::{Vector3, Vector6};

use super::text::{json_number, json_row, json_string, short};
use super::{Frame, Shown, SpatialPage};
use crate::picture::{PictureError, word};
use crate::spatial::{Contact, ContactState, Equilibrium, Twist};

/// Parts of the size of the picture that the largest force, moment and displacement take in the picture.
const LARGEST_FORCE: f64 = 0.4;
const LARGEST_MOMENT: f64 = 0.3;
const LARGEST_DISPLACEMENT: f64 = 0.15;
/// A steeper cone is drawn like this one.
const STEEPEST: f64 = 1e3;

pub(super) struct Drawing<'p> {
    page: &'p SpatialPage,
    centre: Vector3<f64>,
    /// Largest extent of the contacts and the outline along an axis, m.
    span: f64,
    /// The same, or the distance of the load where that is larger, m.
    size: f64,
    /// m per N, m per N m, and how many times displacements are magnified.
    force: f64,
    moment: f64,
    displacement: f64,
}

impl<'p> Drawing<'p> {
    pub(super) fn new(page: &'p SpatialPage) -> Result<Self, PictureError> {
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
        let (mut force, mut moment, mut displacement) = (0.0_f64, 0.0_f64, 0.0_f64);
        // Arrows are to be seen beside a load that acts far away.
        let mut size = span;
        for state in page.frames.iter().filter_map(Frame::state) {
            let load = drawing.load(state);
            (force, moment) = (force.max(load.force.norm()), moment.max(load.moment.norm()));
            size = size.max((load.at - drawing.centre).norm());
            for contact in &state.contacts {
                force = force.max(contact.force_world.norm());
                displacement = displacement.max(contact.body_core.norm());
            }
        }
        let part = |of: f64, largest: f64| if largest > 0.0 { of * size / largest } else { 0.0 };
        drawing.size = size;
        drawing.force = part(LARGEST_FORCE, force);
        drawing.moment = part(LARGEST_MOMENT, moment);
        drawing.displacement = part(LARGEST_DISPLACEMENT, displacement);
        Ok(drawing)
    }

    /// The scales in words.
    pub(super) fn scales(&self) -> String {
        let mut sentences = vec![format!("The grasp is {} m across.", short(self.span))];
        for (what, largest, unit, scale) in
            [("force", LARGEST_FORCE, "N", self.force), ("moment", LARGEST_MOMENT, "N m", self.moment)]
        {
            if scale > 0.0 {
                let size = short(largest * self.size / scale);
                sentences.push(format!("The longest arrow of a {what} is {size} {unit}."));
            }
        }
        if self.displacement > 0.0 {
            let factor = short(self.displacement);
            sentences.push(format!("Displacements are drawn {factor} times as large."));
        }
        sentences.join(" ")
    }

    pub(super) fn json(&self) -> Result<String, PictureError> {
        let page = self.page;
        let lines = |lines: &[Vec<[f64; 3]>]| list(lines, |corners| list(corners, |corner| json_row(corner)));
        let (outlines, fixtures) = (lines(&page.outlines)?, lines(&page.fixtures)?);
        let contacts = list(page.grasp.contacts().iter().zip(page.grasp.frames()).enumerate(), {
            |(i, (contact, frame))| {
                Ok(format!(
                    "{{\"name\":{},\"point\":{},\"normal\":{},\"tangents\":[{},{}],\"mu\":{}}}",
                    json_string(&contact.label_text(i)),
                    json_row(contact.point().as_slice())?,
                    json_row(frame.column(0).as_slice())?,
                    json_row(frame.column(1).as_slice())?,
                    json_row(frame.column(2).as_slice())?,
                    json_number(contact.friction_coefficient().min(STEEPEST))?
                ))
            }
        })?;
        let frames = list(&page.frames, |frame| self.frame(frame))?;
        Ok(format!(
            "{{\"centre\":{},\"span\":{},\"force\":{},\"moment\":{},\"displacement\":{},\n\"outlines\":{outlines},\n\"fixtures\":{fixtures},\n\"contacts\":{contacts},\n\"frames\":{frames}}}",
            json_row(self.centre.as_slice())?,
            json_number(self.span)?,
            json_number(self.force)?,
            json_number(self.moment)?,
            json_number(self.displacement)?,
        ))
    }

    fn frame(&self, frame: &Frame) -> Result<String, PictureError> {
        let Some(state) = frame.state() else { return Ok("null".to_owned()) };
        let contacts = list(&state.contacts, |answer| {
            let slides = match answer.state {
                ContactState::Sliding { direction } => json_row(direction.as_slice())?,
                _ => "null".to_owned(),
            };
            Ok(format!(
                "{{\"state\":\"{}\",\"force\":{},\"normal_force\":{},\"displacement\":{},\"slides\":{slides}}}",
                word(answer).replace(' ', "-"),
                json_row(answer.force_world.as_slice())?,
                json_number(answer.normal_force())?,
                json_row(answer.body_core.as_slice())?,
            ))
        })?;
        let free = list(&state.free_motions, |motion| self.axis(motion))?;
        let load = self.load(state);
        Ok(format!(
            "{{\"twist\":{},\"load\":{{\"at\":{},\"force\":{},\"moment\":{}}},\n\"contacts\":{contacts},\"free\":{free}}}",
            json_row(state.twist.as_vector().as_slice())?,
            json_row(load.at.as_slice())?,
            json_row(load.force.as_slice())?,
            json_row(load.moment.as_slice())?,
        ))
    }

    /// The load as a force on its line of action, at the point next to the middle of the grasp, and the moment that is left.
    fn load(&self, state: &Equilibrium) -> Load {
        let (force, moment) = halves(state.load.as_vector());
        let about_centre = moment - self.centre.cross(&force);
        let size = force.norm();
        if size == 0.0 {
            return Load { at: self.centre, force, moment };
        }
        let along = force / size;
        let left = along * along.dot(&about_centre);
        let rounding = 1e-12 * (size * (self.span + self.centre.norm()) + moment.norm());
        let left = if left.norm() <= rounding { Vector3::zeros() } else { left };
        Load { at: self.centre + along.cross(&(about_centre / size)), force, moment: left }
    }

    /// Axis of a motion: of its rotation, or, where it has none, the direction in which it moves.
    fn axis(&self, motion: &Twist) -> Result<String, PictureError> {
        let (moves, turns) = halves(motion.as_vector());
        let at_centre = moves + turns.cross(&self.centre);
        let rotates = turns.norm() * self.span > 1e-9 * at_centre.norm();
        let (at, along) = if rotates {
            (self.centre + turns.cross(&at_centre) / turns.norm_squared(), turns.normalize())
        } else {
            (self.centre, at_centre.normalize())
        };
        let (at, along) = (json_row(at.as_slice())?, json_row(along.as_slice())?);
        Ok(format!("{{\"at\":{at},\"along\":{along},\"turns\":{rotates}}}"))
    }
}

struct Load {
    at: Vector3<f64>,
    force: Vector3<f64>,
    moment: Vector3<f64>,
}

impl Frame {
    fn state(&self) -> Option<&Equilibrium> {
        match &self.shown {
            Shown::State(state) => Some(state),
            Shown::Nothing(_) => None,
        }
    }
}

fn halves(v: &Vector6<f64>) -> (Vector3<f64>, Vector3<f64>) {
    (Vector3::new(v[0], v[1], v[2]), Vector3::new(v[3], v[4], v[5]))
}

fn list<T>(
    items: impl IntoIterator<Item = T>,
    write: impl Fn(T) -> Result<String, PictureError>,
) -> Result<String, PictureError> {
    let items: Vec<_> = items.into_iter().map(write).collect::<Result<_, _>>()?;
    Ok(format!("[{}]", items.join(",")))
}
