//! The engine of a grasp: its validated contacts, and the data from which equilibria are computed. A command is a prescribed displacement of a
//! finger.

use nalgebra::{SMatrix, SVector};

use super::bodies::{PlacedBodies, refuse_sides};
use super::cached_value::CachedValue;
use super::contact::Contact;
use super::hand::{Drive, HandPart, Linkage};
use super::site::Site;
use super::vacuum::Vacuum;
use super::whole_contact::WholeContacts;
use super::wrench::Wrench;
use crate::contact::State;
use crate::error::{Error, LARGEST};
use crate::numerics::{IntoList, Size, Space, chosen, moved, summed};
use crate::prelude::*;

/// A grasp with validated contacts. The coordinates of the grasp are the 3 or 6 coordinates of the object, then the coordinates of joints and of
/// other bodies.
#[derive(Debug, Clone)]
pub(crate) struct Engine {
    pub(super) space: Space,
    size: Size,
    pub(super) contacts: Vec<Contact<3>>,
    pub(super) sites: Vec<Site>,
    /// The contact points in `contacts`, grouped to contacts as users count them: all points of a soft fingertip are one contact.
    wholes: WholeContacts,
    /// Centroid of the contact points on the object (the loaded body, if there are several), m. The engine refers moments and rotations to this
    /// point, so that a distant origin of the caller causes no cancellation.
    pub(super) origin: SVector<f64, 3>,
    /// Root mean square distance of the object's contact points from their centroid, m; 1 for a single point. The engine divides moment arms by this
    /// length, so that rotations and translations have comparable magnitudes for any unit of the caller.
    pub(super) length: f64,
    /// The joints, tendons and bodies behind the contacts; `None` for a single object held by contacts that no joint moves.
    pub(super) linkage: Option<Box<Linkage>>,
    /// Total pull of all vacuums on the object, which acts in addition to the caller's loads; `None` without a vacuum.
    pub(super) vacuum: Option<Box<Vacuum>>,
    /// Factors of the stiffness matrix of the elastic trial, in which all contacts stick; computed on first use.
    trial: CachedValue,
    /// Contact states of a similar grasp in equilibrium under its base load, which acts before the asked load grows. In a grasp of many coordinates
    /// the search for an equilibrium begins near these states. Empty if no such states are known.
    pub(crate) near: Vec<State>,
}

impl Engine {
    /// Validates the contacts of a single object that are moved by no joints, and makes their grasp.
    pub(crate) fn new(contacts: Vec<Contact<3>>) -> Result<Self, Error> {
        refuse_sides(&contacts)?;
        let space = space_of(&contacts);
        Self::of(space, Size::of(space.of_the_object()), contacts, &|_| true)
    }

    /// A grasp whose contacts may be moved by joints and by bodies other than the object. `size` is the number of all coordinates of object, joints
    /// and other bodies.
    pub(super) fn by_hand(size: Size, contacts: Vec<Contact<3>>, linkage: Linkage) -> Result<Self, Error> {
        let on_object =
            |i: usize| linkage.bodies.as_ref().map_or(1.0, |bodies| bodies.sign(i, bodies.object));
        let mut grasp = Self::of(space_of(&contacts), size, contacts, &|i| on_object(i) != 0.0)?;
        for (i, (site, motions)) in grasp.sites.iter_mut().zip(&linkage.motions).enumerate() {
            site.move_with(grasp.space, motions, &linkage.lengths, on_object(i));
        }
        linkage.drives.iter().map(|drive| drive.site(grasp.space, size)).append_to(&mut grasp.sites);
        grasp.linkage = Some(Box::new(linkage));
        grasp.vacuum = Vacuum::of(grasp.space, &grasp.contacts, &grasp.sites);
        Ok(grasp)
    }

    /// A copy of this grasp with other contact data at the same contact points. `times` gives two factors for the joint or tendon with index k. The
    /// first multiplies its stiffness, the second its command and its constant torque or tension.
    pub(crate) fn with_data(
        &self,
        contacts: Vec<Contact<3>>,
        times: &dyn Fn(usize) -> [f64; 2],
    ) -> Result<Self, Error> {
        match &self.linkage {
            None => Self::of(self.space, self.size, contacts, &|_| true),
            Some(linkage) => {
                let mut linkage = linkage.stiffened(&|k| times(k)[0]);
                linkage.squeeze(&|k| times(k)[1]);
                linkage.replace_pressing_forces(self.space, &self.contacts, &contacts);
                Self::by_hand(self.size, contacts, linkage)
            }
        }
    }

    /// A copy of this grasp with other loads on its bodies.
    pub(super) fn with_bodies(&self, bodies: PlacedBodies) -> Self {
        let mut grasp = self.clone();
        if let Some(linkage) = &mut grasp.linkage {
            linkage.bodies = Some(Box::new(bodies));
        }
        grasp
    }

    /// Whether contacts may carry forces without a load from the caller. Causes are a command or an overlap that presses, a constant force or torque,
    /// a vacuum, or a constant load on a body.
    pub(crate) fn presses(&self) -> bool {
        let by_force =
            self.linkage().is_some_and(|linkage| linkage.held_forces.iter().any(|force| *force != 0.0));
        let by_load =
            self.bodies().is_some_and(|bodies| bodies.loads.iter().any(|load| *load != Wrench::ZERO));
        by_force || by_load || self.vacuum().is_some() || self.offsets().iter().any(|offset| offset[0] > 0.0)
    }

    /// End points of the rigid links of the hand, m, in the initial posture; only pictures use them.
    pub(crate) fn links(&self) -> &[[SVector<f64, 3>; 2]] {
        self.linkage().map_or(&[], |linkage| &linkage.bones)
    }

    /// A point on the axis of each revolute joint of the hand, m, in the initial posture; `None` for other joints. Only pictures use them.
    pub(crate) fn joint_centres(&self) -> &[Option<SVector<f64, 3>>] {
        self.linkage().map_or(&[], |linkage| &linkage.centres)
    }

    /// A grasp with the given contacts. `is_meant(i)` is true if contact i belongs to the object, not only to other bodies. The centroid of the
    /// contacts of the object is the origin of the engine's coordinates.
    fn of(
        space: Space,
        size: Size,
        contacts: Vec<Contact<3>>,
        is_meant: &dyn Fn(usize) -> bool,
    ) -> Result<Self, Error> {
        if contacts.is_empty() {
            return Err(Error::EmptyGrasp);
        }
        for (index, contact) in contacts.iter().enumerate() {
            contact.check(index)?;
        }
        let contacts: Vec<_> = moved(contacts, &Contact::resolved);
        let meant = chosen(contacts.len(), &|i| is_meant(*i));
        let count = meant.len().max(1) as f64;
        let mut origin = SVector::zeros();
        for i in &meant {
            origin += contacts[*i].point / count;
        }
        let spread = summed(&meant, &|i| (contacts[*i].point - origin).norm_squared() / count).sqrt();
        // If the contacts lie in a single point, they have no extent, and the unit of length is 1 m.
        let length = if spread * LARGEST > 1.0 { spread } else { 1.0 };
        let mut sites = Vec::with_capacity(contacts.len());
        for (index, contact) in contacts.iter().enumerate() {
            sites.push(Site::new(space, size, (contact, index), (&origin, length))?);
        }
        let (vacuum, trial) = (Vacuum::of(space, &contacts, &sites), CachedValue::default());
        let wholes = WholeContacts::of(&contacts);
        let (linkage, near) = (None, Vec::new());
        Ok(Self { space, size, contacts, sites, wholes, origin, length, linkage, vacuum, trial, near })
    }

    #[inline]
    pub(crate) fn space(&self) -> Space {
        self.space
    }

    /// Number of coordinates of the grasp: of the object, joints and other bodies.
    #[inline]
    pub(crate) fn size(&self) -> Size {
        self.size
    }

    /// Number of contact points; each point of a soft fingertip or of a link counts.
    pub(crate) fn len(&self) -> usize {
        self.contacts.len()
    }

    /// All contact points, with their commands in the contact frames; the points of a soft fingertip or of a link one by one.
    pub(crate) fn contacts(&self) -> &[Contact<3>] {
        &self.contacts
    }

    /// The contacts as users count them: a soft fingertip or a link counts as one contact with several points.
    pub(crate) fn wholes(&self) -> &WholeContacts {
        &self.wholes
    }

    /// Contact frame of one contact point: its columns are the normal, the first tangent and, in space, the second tangent.
    pub(crate) fn frame(&self, contact: usize) -> &SMatrix<f64, 3, 3> {
        &self.sites[contact].frame
    }

    /// A copy of this grasp in which contact i has the static coefficient `friction(i, μ)` in place of μ. Kinetic coefficients scale in proportion.
    pub(crate) fn with_friction(&self, friction: &dyn Fn(usize, f64) -> f64) -> Result<Self, Error> {
        let mut contacts = self.contacts.clone();
        for (i, contact) in contacts.iter_mut().enumerate() {
            contact.set_friction(friction(i, contact.friction));
        }
        self.with_data(contacts, &|_| [1.0; 2])
    }

    /// A copy of this grasp with kinetic friction in place of static friction.
    pub(crate) fn with_friction_of_sliding(&self) -> Result<Self, Error> {
        let mut contacts = self.contacts.clone();
        for contact in &mut contacts {
            contact.friction = contact.kinetic.take().unwrap_or(contact.friction);
        }
        self.with_data(contacts, &|_| [1.0; 2])
    }

    /// Name of a joint or tendon in pictures and messages: the user's name, or else its kind and number.
    pub(crate) fn label_of(&self, part: HandPart) -> String {
        self.linkage.as_ref().map_or_else(String::new, |linkage| linkage.label(part).text())
    }

    /// Returns an error for a grasp of a hand or of several bodies. Called by computations that accept only contacts on a single object; `question`
    /// names the computation in the message.
    pub(crate) fn refuse_hands(&self, question: &'static str) -> Result<(), Error> {
        if self.linkage.is_some() { Err(Error::NotForHands { question }) } else { Ok(()) }
    }

    /// Returns an error if a contact has kinetic friction. Called by computations that use static friction for sliding contacts, too; `question`
    /// names the computation in the message.
    pub(crate) fn refuse_kinetic(&self, question: &'static str) -> Result<(), Error> {
        match self.weaker_once_they_slide().next() {
            Some(i) => Err(Error::KineticFriction { question, contact: self.contacts[i].label(i) }),
            None => Ok(()),
        }
    }

    /// Indices of the contacts whose kinetic friction is lower than their static friction.
    pub(crate) fn weaker_once_they_slide(&self) -> impl Iterator<Item = usize> {
        (0..self.len()).filter(|&i| self.sites()[i].kinetic.is_some())
    }

    /// Returns an error if the grasp has joints. Called by computations that allow several bodies only without joints and drives; `question` names
    /// the computation in the message.
    ///
    /// # Errors
    /// [`Error::NotForHands`] for a hand, [`Error::NotForJoints`] for several bodies that a hand holds or a given force presses.
    pub(crate) fn refuse_joints(&self, question: &'static str) -> Result<(), Error> {
        match &self.linkage {
            Some(linkage) if linkage.bodies.is_none() => Err(Error::NotForHands { question }),
            Some(linkage) if !linkage.drives.is_empty() || !linkage.joints.is_empty() => {
                Err(Error::NotForJoints { question })
            }
            _ => Ok(()),
        }
    }

    /// The drives of one joint or tendon, with their indices in the list of all contacts and drives. A drive is the spring of a joint or tendon, with
    /// its force limit; a joint or tendon that yields at a constant force has two. `actuator` is the index of the joint or tendon, from 0, joints
    /// first.
    pub(crate) fn drives_of(&self, actuator: usize) -> impl Iterator<Item = (usize, &Drive)> {
        let first = self.len();
        self.linkage()
            .into_iter()
            .flat_map(move |linkage| linkage.of_actuator(actuator))
            .map(move |(k, offset)| (first + k, offset))
    }

    /// The joints, tendons and bodies behind the contacts; `None` for a single object held by contacts that no joint moves.
    pub(crate) fn linkage(&self) -> Option<&Linkage> {
        self.linkage.as_deref()
    }

    /// Storage for the factors of the stiffness matrix of the elastic trial, in which all contacts stick.
    pub(crate) fn remembered_trial(&self) -> &CachedValue {
        &self.trial
    }

    pub(crate) fn sites(&self) -> &[Site] {
        &self.sites
    }
}

/// Whether a grasp with these contacts is in the plane or in space.
pub(super) fn space_of(contacts: &[Contact<3>]) -> Space {
    contacts.first().map_or(Space::Spatial, |contact| contact.space)
}
