//! Contacts with a constant force. Each such contact has a slide along its normal: a joint without a spring, on which the force acts.

use nalgebra::SMatrix;

use super::draft::{Assembly, Columns};
use super::finger::Finger;
use super::joint::Joint;
use crate::error::Error;
use crate::grasp::contact::Contact;
use crate::numerics::counted;

/// The beginning of the name of the slide of a contact that is held by a force; the name of the contact follows.
pub(crate) const SLIDE_OF: &str = "slide of ";

impl<const C: usize> Finger<C> {
    /// Number of slides of the finger's contacts; the points of a soft fingertip share one slide.
    pub(super) fn slides(&self) -> usize {
        counted(&self.contacts, &|carried| begins_a_slide(&carried.contact))
    }
}

fn begins_a_slide<const C: usize>(contact: &Contact<C>) -> bool {
    contact.force.is_some() && contact.begins_a_whole()
}

impl Assembly {
    /// Motion of a contact with its slide, a prismatic joint without a spring, if the contact has a constant force. The constant force is added to
    /// the force on the slide.
    pub(super) fn on_slide(
        &mut self,
        finger: &Finger<3>,
        (contact, index): (&Contact<3>, usize),
        frame: &SMatrix<f64, 3, 3>,
    ) -> Result<Columns, Error> {
        let Some(force) = contact.force else { return Ok(Columns::new()) };
        let what = || format!("contact {}", contact.label(index));
        if !finger.joints.is_empty() || finger.compliance.is_some() {
            let allowed =
                "left out on a finger with joints or a compliance: there a torque of a joint presses";
            return Self::fault(what(), "force", force, allowed);
        }
        let along = contact.commanded()[0];
        if along != 0.0 {
            let allowed = "zero along the normal where a force holds the contact";
            return Self::fault(what(), "command", along, allowed);
        }
        let along: [f64; 3] = frame.column(0).into_owned().into();
        if begins_a_slide(contact) {
            let whole = counted(&self.contacts, &Contact::begins_a_whole);
            let name = contact.whole_name().unwrap_or_else(|| format!("contact {whole}").into());
            self.joints.push(Joint::prismatic(along).name(format!("{SLIDE_OF}{name}")));
        }
        let slide = self.joints.len() - 1;
        self.joints[slide].torque += force;
        Ok(vec![(slide, along.into())])
    }
}
