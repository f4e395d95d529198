//! Pictures of links between bodies in the plane. A hinge is drawn as a circle, a slide (linear guide) as two rails, a rigid joint as a bar. A cable
//! is drawn as a thin line, a spring as a zigzag.

use crate::numerics::Each;
use nalgebra::Vector2;

use super::axes::EqualScales;
use super::painting::{Painting, flat};
use super::palette::GREY;
use crate::grasp::{Contact, ContactPoints};
use crate::words::LinkKind;

/// A link with the positions of its ends.
pub(super) struct PlanarLink {
    kind: LinkKind,
    /// Both ends of the link, m; for a hinge the two ends coincide.
    pub(super) ends: [Vector2<f64>; 2],
}

impl PlanarLink {
    /// The link that a contact represents; `None` for an ordinary contact.
    pub(super) fn of(contact: &ContactPoints, contacts: &[Contact<3>]) -> Option<Self> {
        let ends = contact.ends_of_link(contacts)?.each(|end| end.xy());
        Some(Self { kind: contact.label.link?, ends })
    }

    pub(super) fn paint(&self, axes: &EqualScales, painting: &mut Painting) {
        let [from, to] = self.ends.each(|end| flat(axes.place(end)));
        let along = to - from;
        let side = match along.norm() {
            long if long > 0.0 => flat((-along.y / long, along.x / long)),
            _ => along,
        };
        let mut line = |ends, width| painting.line(ends, GREY, width);
        match self.kind {
            LinkKind::Cable => line([from, to], 1.5),
            LinkKind::Rigid => line([from, to], 6.0),
            LinkKind::Slide => {
                for x in [-4.0, 4.0] {
                    line([from + side * x, to + side * x], 2.0);
                }
            }
            LinkKind::Spring => {
                let turns = 12;
                let at = |k: usize| {
                    let swing = if k == 0 || k == turns { 0.0 } else { [6.0, -6.0][k % 2] };
                    from + along * (k as f64 / turns as f64) + side * swing
                };
                (0..turns).for_each(|k| line([at(k), at(k + 1)], 1.5));
            }
            _ => painting.dot(from, 7.0, GREY, true),
        }
    }
}
