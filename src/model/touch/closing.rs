//! A pad that moves along its closing direction until it touches a part (the mesh of an object to be held). A command is a prescribed displacement of
//! a finger.

use nalgebra::Vector3;

use super::pad::{Pad, PadPoint};
use super::part::Part;
use super::rays::{FLUSH, PadHits, RayHit};
use super::touched::{Touched, advance_under};
use crate::error::{Error, Field};
use crate::grasp::Contact;
use crate::numerics::{Reals, mapped, summed};

/// A pad with a position and a closing direction.
///
/// A contact gives all data except the shape of the pad. The contact's point is the centre of the pad before the pad closes, in front of the part, m;
/// its normal is the closing direction. The contact also gives name, friction, stiffness and commanded normal force or command. The stiffness of the
/// pad's [layer](Pad::of_layer), if it has one, replaces the finger stiffness.
#[derive(Debug, Clone, PartialEq)]
pub struct Touch {
    pad: Pad,
    contact: Contact<3>,
}

/// A point of the pad, and the point at which it meets the part.
struct PadPointHit<'p> {
    point: &'p PadPoint,
    hit: RayHit,
    /// Travel along the closing direction until the point touches, m.
    travel: f64,
}

impl Touch {
    /// A pad with the position, closing direction, name, friction, stiffness and command of a contact.
    #[must_use]
    pub fn new(pad: Pad, contact: Contact<3>) -> Self {
        Self { pad, contact }
    }

    /// The contacts at which the pad touches the part, as points of one fingertip. The commanded normal force (`pressed_with`) and commands apply to
    /// the pad as a whole. A clearance given for the contact, m, is added to the gap of every point along the closing direction.
    ///
    /// # Errors
    /// [`Error::Misses`] if no point of the pad meets the part, or if some points start inside the part. [`Error::Contact`] with index 0 for data out
    /// of range, and for a constant force on a part that is not flat and normal to the closing direction.
    pub fn on(&self, part: &Part) -> Result<Touched, Error> {
        self.on_for_contact(0, part)
    }

    /// The contacts at which the pad touches the part, as points of one fingertip. Errors name the contact by `index`.
    pub(crate) fn on_for_contact(&self, index: usize, part: &Part) -> Result<Touched, Error> {
        let mut contact = self.contact.clone();
        if let Some([normal, tangential]) = self.pad.stiffness() {
            contact = contact.finger_stiffness(normal, tangential);
        }
        contact.check(index)?;
        let frame = contact.frame(index)?;
        let PadHits { hits, foremost } = part.hits_of_pad(&self.pad, &frame, &contact.point);
        let pad_point_hits = self.pad_point_hits(index, hits)?;
        let missing = 1.0 - summed(&pad_point_hits, &|meeting| meeting.point.share);
        let near = FLUSH * part.size;
        let gap = |travel: f64| {
            let behind = travel - foremost;
            contact.clearance + if behind <= near { 0.0 } else { behind }
        };
        let (closing, first_tangent) = (frame.column(0).into_owned(), frame.column(1).into_owned());
        // If a face is normal to the closing direction up to rounding, its normal is set to this direction.
        let straightened =
            |normal: &Vector3<f64>| if (normal - closing).norm() <= FLUSH { closing } else { *normal };
        let mut points = Vec::with_capacity(pad_point_hits.len());
        for (i, meeting) in pad_point_hits.iter().enumerate() {
            let normal = straightened(&meeting.hit.normal);
            if contact.force.is_some() && (normal != closing || gap(meeting.travel) != contact.clearance) {
                let (field, value) = (Field::Force, contact.force.unwrap_or(0.0));
                let allowed = "left out where a pad meets the part at several depths or at an angle: say with what it is pressed";
                return Err(Error::Contact { contact: contact.label(index), field, value, allowed });
            }
            // If a fraction `missing` of the pad does not meet the mesh, the points that touch carry the whole force.
            let of_force = meeting.point.share / (1.0 - missing);
            points.push(Contact {
                name: contact.name.as_ref().map(|name| format!("{name} {i}").into()),
                point: contact.point
                    + frame * (meeting.point.offset + Vector3::new(meeting.travel, 0.0, 0.0)),
                normal,
                tangent: Some(first_tangent),
                stiffness: contact.stiffness.scaled(meeting.point.share),
                force: contact.force.map(|force| force * of_force),
                press: None,
                suction: contact.suction * of_force,
                clearance: gap(meeting.travel) * normal.dot(&closing),
                point_of_pad: Some(i),
                ..contact.clone()
            });
        }
        let gaps: Vec<f64> = mapped(&pad_point_hits, &|meeting| gap(meeting.travel));
        let commanded = frame * Contact { press: None, ..contact.clone() }.commanded();
        let advance = match contact.press {
            None => commanded.dot(&closing),
            Some(force) => advance_under(force, &points, &gaps, &closing)?,
        };
        let along = commanded + closing * (advance - commanded.dot(&closing));
        let touching = gaps.iter().copied().least() + near;
        let mut steepest = 0.0_f64;
        for ((point, meeting), gap) in points.iter_mut().zip(&pad_point_hits).zip(&gaps) {
            // Until a point touches, its motion along the surface does not stretch its tangential springs. This motion is subtracted from the command
            // of the point.
            let slope = closing - point.normal * point.normal.dot(&closing);
            *point = point.clone().command_world(along - slope * advance.min(*gap).max(0.0));
            if *gap < advance.max(touching) {
                steepest = steepest.max((frame * meeting.point.facing).angle(&point.normal));
            }
        }
        Ok(Touched { contacts: points, missing: if missing <= FLUSH { 0.0 } else { missing }, steepest })
    }

    /// The points of the pad that meet the part, each with the hit of its ray and its travel. Returns an error if no point meets the part, or if a
    /// point starts inside the part.
    fn pad_point_hits(&self, index: usize, hits: Vec<Option<RayHit>>) -> Result<Vec<PadPointHit<'_>>, Error> {
        let misses = |fault: &'static str| Err(Error::Misses { contact: self.contact.label(index), fault });
        let mut pad_point_hits = Vec::new();
        for (point, hit) in self.pad.points.iter().zip(hits) {
            let Some(hit) = hit else { continue };
            if hit.leaves {
                return misses("begins inside the part, must begin in front of it");
            }
            pad_point_hits.push(PadPointHit { point, hit, travel: hit.depth - point.offset[0] });
        }
        if pad_point_hits.is_empty() {
            return misses(
                "misses the part: no point of it lies ahead of the pad along the closing direction",
            );
        }
        Ok(pad_point_hits)
    }
}
