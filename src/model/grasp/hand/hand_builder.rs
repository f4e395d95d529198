//! A hand: fingers, and tendons over their joints.

use super::finger::Finger;
use super::joint::Limit;
use super::tendon::Tendon;
use crate::numerics::{IntoList, Space};
use crate::prelude::*;

/// Fingers and tendons that hold an object; [`Hand::grasp`] makes the grasp.
///
/// Contacts and joints are numbered finger by finger; tendons come after all joints. A hand without joints is a list of contacts.
///
/// ```
/// use grasp_lcp::planar::hand::{Finger, Hand, Joint, Tendon};
/// use grasp_lcp::planar::{Wrench};
/// use grasp_lcp::planar::Contact;
///
/// // A gripper with a differential: one motor pulls 20 N on two jaws that slide freely.
/// let jaw = |x: f64| {
///     Finger::new([Joint::prismatic([-x, 0.0])])
///         .contact(Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1e4, 1e4).friction(0.5))
/// };
/// let hand = Hand::new([jaw(-1.0), jaw(1.0)]).tendon(Tendon::new([0.5, 0.5]).tension(20.0));
/// // Nothing determines the position of the object between the jaws, but the forces are determined.
/// let outcome = hand.grasp()?.solve(Wrench::ZERO)?;
/// let held = outcome.equilibrium().expect("holds");
/// assert!((held.contacts[0].normal_force() - 10.0).abs() < 1e-13);
/// assert_eq!(held.free_motions.len(), 1);
/// # Ok::<(), grasp_lcp::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Default)]
#[must_use]
pub struct Hand<const C: usize> {
    pub(super) fingers: Vec<Finger<C>>,
    pub(super) tendons: Vec<Tendon>,
}

impl<const C: usize> Hand<C> {
    /// A hand of these fingers.
    pub fn new(fingers: impl IntoIterator<Item = Finger<C>>) -> Self {
        Self { fingers: fingers.into_iter().list(), tendons: Vec::new() }
    }

    setters! {
        /// Adds a finger.
        pub fn finger(mut self, finger: Finger<C>) { self.fingers.push(finger); }

        /// Adds a tendon over the joints of all fingers.
        pub fn tendon(mut self, tendon: Tendon) { self.tendons.push(tendon); }
    }

    /// Upper limit of the number of coordinates of a grasp by this hand. The object has 3 or 6 coordinates, and each joint has one. Each joint or
    /// tendon with a [`Limit::Saturates`] has one more. A finger with a compliance matrix adds one for each axis of each of its contacts. A contact
    /// with a constant force has a slide, which counts as a joint.
    #[must_use]
    pub fn coordinates(&self) -> usize {
        self.coordinates_in(Space::of::<C>())
    }

    /// Whether the contacts of this hand are in the plane or in space.
    pub(crate) fn space(&self) -> Space {
        for finger in &self.fingers {
            if let Some(carried) = finger.contacts.first() {
                return carried.contact.space;
            }
        }
        Space::of::<C>()
    }

    /// Upper limit of the number of coordinates of a grasp by this hand, of object and hand together, in the plane or in space.
    pub(super) fn coordinates_in(&self, space: Space) -> usize {
        let saturates = |limit: Option<Limit>| usize::from(matches!(limit, Some(Limit::Saturates(_))));
        let mut all = space.of_the_object() + self.joints();
        for finger in &self.fingers {
            for joint in &finger.joints {
                all += saturates(joint.limit);
            }
            if finger.compliance.is_some() {
                all += space.axes() * finger.contacts.len();
            }
        }
        for tendon in &self.tendons {
            all += saturates(tendon.limit);
        }
        all
    }

    /// Number of joints. The slides of contacts with a [constant force](crate::grasp::Contact::force) are included, after all other joints.
    #[must_use]
    pub fn joints(&self) -> usize {
        self.fingers.iter().map(|finger| finger.joints.len() + finger.slides()).sum()
    }
}
