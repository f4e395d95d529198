//! One entry of a list of contacts: a point contact, a soft fingertip or a suction cup. A soft fingertip is a contact that is spread over a patch of
//! points. A pad is the surface of a finger that closes on the grasped part.

use nalgebra::DMatrix;

use super::cup::Cup;
use super::patch::FingertipPatch;
use crate::error::Error;
use crate::grasp::{Contact, SoftFingertip};
use crate::improve::Surface;

/// A contact of a scene: one point, or the patch of a soft fingertip around it.
///
/// ```
/// use grasp_lcp::planar::Contact;
/// use grasp_lcp::scene::{Fingertip, Setup, FingertipPatch};
///
/// let jaw = |side: f64| Contact::new([side, 0.0], [-side, 0.0]).series_stiffness(1e3, 8e2).friction(0.5);
/// let (hard, soft) = (Fingertip::from(jaw(-1.0)), Fingertip::from(jaw(1.0)).soft(FingertipPatch::Pair { width: 0.01 }));
/// // The pair shares the stiffness of its contact.
/// let grasp = Setup::<2>::new([hard, soft]).grasp()?;
/// assert_eq!(grasp.len(), 3);
/// # Ok::<(), grasp_lcp::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
#[must_use]
pub struct Fingertip<const C: usize> {
    /// The contact.
    pub contact: Contact<C>,
    /// The patch over which the contact is spread; `None` for a point.
    pub soft: Option<FingertipPatch>,
    /// The suction cup, instead of a soft fingertip.
    pub cup: Option<Cup>,
    /// The pad that closes on the part of the scene (the mesh of the object), in place of a given point and normal.
    #[cfg(feature = "mesh")]
    pub touches: Option<super::part::PadTouch>,
    /// The curve or surface along which the contact may move in the search for better finger places, [`improve`](crate::improve).
    pub surface: Option<Surface<C>>,
    /// Whether no stiffness was given; the default then takes its place, see [`Setup::stiffness_left_out`](super::Setup::stiffness_left_out).
    pub no_stiffness: bool,
    /// A comment for the reader of the file.
    pub comment: Option<String>,
    /// The joints of the finger that move the contact.
    pub moved_by: MovedBy,
}

/// The joints that move a contact of a [finger](super::FingerSetup). A contact without a finger ignores this choice.
#[derive(Debug, Clone, PartialEq, Default)]
#[non_exhaustive]
pub enum MovedBy {
    /// All joints of the finger: the contact is on the last link.
    #[default]
    LastLink,
    /// The first n joints of the finger, counted from the palm, for the number n given here; written as `"moved_by": {"link": 1}`.
    Link(usize),
    /// All joints of the finger, by a Jacobian: the motion of the contact along the coordinate axes per unit of each joint. Written as
    /// `"moved_by": {"jacobian": [[…], …]}`, one row for each axis. In space three more rows may follow, the angular velocities of the contact's
    /// link.
    Jacobian(DMatrix<f64>),
}

impl<const C: usize> From<Contact<C>> for Fingertip<C> {
    fn from(contact: Contact<C>) -> Self {
        Self {
            contact,
            soft: None,
            cup: None,
            #[cfg(feature = "mesh")]
            touches: None,
            surface: None,
            no_stiffness: false,
            comment: None,
            moved_by: MovedBy::LastLink,
        }
    }
}

impl<const C: usize> Fingertip<C> {
    /// This contact spread over a patch: a ring, a disc or a rectangle in space, a pair or a pad in the plane. For a patch of the plane in space, or
    /// the reverse, [`Setup::grasp`](super::Setup::grasp) returns an error.
    pub fn soft(self, tip: FingertipPatch) -> Self {
        Self { soft: Some(tip), ..self }
    }

    /// This contact with the lip and the vacuum of a suction cup, in space. The cup replaces the contact's own suction.
    pub fn with_cup(self, cup: Cup) -> Self {
        Self { cup: Some(cup), soft: None, ..self }
    }

    setters! {
        /// This contact with a curve or surface along which it may move in the search for better finger places, [`improve`](crate::improve).
        pub fn along(mut self, surface: Surface<C>) { self.surface = Some(surface); }

        /// Sets the joints that move this contact of a finger, for a contact on another link than the last, or moved by a given Jacobian.
        pub fn moved_by(mut self, moved_by: MovedBy) { self.moved_by = moved_by; }
    }
}

impl Fingertip<3> {
    /// The point contacts of the patch, or the contact itself. `index` is the index of the contact in the scene, for messages.
    ///
    /// # Errors
    /// [`Error::Contact`] with `index`, or [`Error::Fingertip`].
    pub(super) fn points(&self, index: usize) -> Result<Vec<Contact<3>>, Error> {
        #[cfg(feature = "mesh")]
        if let Some(touches) = &self.touches {
            return touches.points(index, &self.contact);
        }
        let Some((patch, suction)) = self.patch()? else { return Ok(vec![self.contact.clone()]) };
        self.contact.check(index)?;
        self.contact.frame(index)?;
        patch.contacts_inside(&self.contact.clone().suction(suction))
    }

    /// The patch of points over which the contact is spread, and the force of its vacuum, N; `None` for a point contact. Refuses a planar patch in
    /// space, and a spatial patch in the plane.
    pub(super) fn patch(&self) -> Result<Option<(SoftFingertip<3>, f64)>, Error> {
        let space = self.contact.space;
        if let Some(cup) = &self.cup {
            let cup = cup.made(space)?;
            return Ok(Some((cup.lip().clone(), cup.force())));
        }
        let Some(soft) = &self.soft else { return Ok(None) };
        Ok(Some((soft.spread_inside(space)?, self.contact.suction)))
    }

    /// Whether the contact is spread over a patch.
    pub(super) fn is_spread(&self) -> bool {
        #[cfg(feature = "mesh")]
        if self.touches.is_some() {
            return true;
        }
        self.soft.is_some() || self.cup.is_some()
    }

    /// Number of point contacts of the patch; 1 for a point.
    pub(super) fn count(&self) -> Result<usize, Error> {
        #[cfg(feature = "mesh")]
        if self.touches.is_some() {
            return self.points(0).map(|points| points.len());
        }
        self.patch().map(|patch| patch.map_or(1, |(patch, _)| patch.points().len()))
    }
}
