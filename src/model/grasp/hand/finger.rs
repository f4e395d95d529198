//! A finger: a serial chain of joints, and the contacts that they move.

use crate::numerics::IntoList;
use nalgebra::DMatrix;

use super::joint::Joint;
use crate::grasp::contact::Contact;
use crate::prelude::*;

/// How a contact moves with the joints of its finger.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum ContactMover {
    /// The contact is on the link behind this number of joints, counted from the palm, and only these joints of the finger move it.
    Link(usize),
    /// This Jacobian gives the displacement of the contact along the axes x, y and z per unit displacement of each joint of the finger.
    World(DMatrix<f64>),
}

/// A contact, and how the joints of its finger move it.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct FingerContact<const C: usize> {
    pub(super) contact: Contact<C>,
    pub(super) by: ContactMover,
}

/// A finger: joints from the palm outwards, and contacts on its links. Each contact has its own springs, of finger pad and object. The commanded
/// displacement of a contact is added to its displacement by the joints.
///
/// ```
/// use grasp_lcp::planar::hand::{Finger, Hand, Joint};
/// use grasp_lcp::planar::{Wrench};
/// use grasp_lcp::planar::Contact;
///
/// // Two jaws on prismatic joints of 1000 N/m, closed by 10 mm each; pads of 1e5 N/m, μ = 0.5.
/// let jaw = |x: f64| {
///     Finger::new([Joint::prismatic([-x, 0.0]).stiffness(1000.0).command(0.01)])
///         .contact(Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1e5, 1e5).friction(0.5))
/// };
/// let grasp = Hand::new([jaw(-1.0), jaw(1.0)]).grasp()?; // three coordinates of the object, two joints
/// let outcome = grasp.solve(Wrench::ZERO)?;
/// let squeezed = outcome.equilibrium().expect("holds");
/// assert!((squeezed.joints[0].torque - 10.0 / 1.01).abs() < 1e-12); // the pads take a hundredth
/// # Ok::<(), grasp_lcp::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
#[must_use]
pub struct Finger<const C: usize> {
    pub(super) joints: Vec<Joint<C>>,
    /// Stiffness matrix that couples the joints, N m/rad, in addition to their own springs; `None` without coupling.
    pub(crate) coupling: Option<DMatrix<f64>>,
    /// Compliance matrix of the finger, m/N: displacements along the axes of all contact frames per unit force along these axes. It acts in series
    /// with joints and pads.
    pub(crate) compliance: Option<DMatrix<f64>>,
    pub(super) contacts: Vec<FingerContact<C>>,
}

impl<const C: usize> Finger<C> {
    /// A finger with these joints, from the palm outwards.
    pub fn new(joints: impl IntoIterator<Item = Joint<C>>) -> Self {
        Self { joints: joints.into_iter().list(), coupling: None, compliance: None, contacts: Vec::new() }
    }

    /// A finger without joints: one contact with its springs.
    pub fn fixed(contact: Contact<C>) -> Self {
        Self::new([]).contact(contact)
    }

    /// A finger given by the compliance matrix of its contacts, m/N, symmetric and positive definite. The matrix gives the displacements of all
    /// contact points per unit force at each contact. Use it for a finger, a hand or a structure of known compliance. Rows and columns are ordered
    /// contact by contact, along the axes of the contact frames, the normal first. The contacts' own springs act in series with this compliance.
    ///
    /// ```
    /// use grasp_lcp::nalgebra::DMatrix;
    /// use grasp_lcp::planar::hand::{Finger, Hand};
    /// use grasp_lcp::planar::{Wrench};
    /// use grasp_lcp::planar::Contact;
    ///
    /// // A pinch by two fingers with the compliance C = [[2, 1], [1, 2]] mm/N: a normal force also displaces the contact along the tangent.
    /// let finger = |x: f64| {
    ///     let contact = Contact::new([x, 0.0], [-x, 0.0]).tangent([0.0, -1.0]).friction(0.4).command([0.02, 0.0]);
    ///     Finger::compliant([contact], DMatrix::from_row_slice(2, 2, &[2e-3, 1e-3, 1e-3, 2e-3]))
    /// };
    /// let hand = Hand::new([finger(-1.0), finger(1.0)]);
    /// let coordinates = hand.coordinates();
    /// assert_eq!(coordinates, 7);
    /// let grasp = hand.grasp()?;
    /// let outcome = grasp.solve(Wrench::ZERO)?;
    /// // No tangential forces act, so the normal force is 20 mm / (2 mm/N).
    /// assert!((outcome.equilibrium().expect("holds").contacts[0].normal_force() - 10.0).abs() < 1e-12);
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    pub fn compliant(contacts: impl IntoIterator<Item = Contact<C>>, compliance: DMatrix<f64>) -> Self {
        let finger = contacts.into_iter().fold(Self::new([]), Self::contact);
        Self { compliance: Some(compliance), ..finger }
    }

    /// Adds a stiffness matrix K of the joints, N m/rad, symmetric and positive semidefinite. It represents gears and tendons that couple the joints,
    /// and acts in addition to the joints' own springs. Its torques are `K (θ - φ)`, with the commanded displacements θ and the actual displacements
    /// φ of the joints.
    pub fn coupled(mut self, stiffness: DMatrix<f64>) -> Self {
        self.coupling = Some(stiffness);
        self
    }

    /// Adds a contact on the last link, which all joints move.
    pub fn contact(self, contact: Contact<C>) -> Self {
        let all = self.joints.len();
        self.contact_on(all, contact)
    }

    /// Adds a contact on another link. Only the first `joints` joints move this link; with 0 the contact is on the palm.
    pub fn contact_on(mut self, joints: usize, contact: Contact<C>) -> Self {
        self.contacts.push(FingerContact { contact, by: ContactMover::Link(joints) });
        self
    }

    /// Adds a contact with a given Jacobian, with `C` rows and one column per joint. A column is the velocity of the contact point along the
    /// coordinate axes, per unit velocity of the joint.
    pub fn contact_moved_by(mut self, jacobian: DMatrix<f64>, contact: Contact<C>) -> Self {
        self.contacts.push(FingerContact { contact, by: ContactMover::World(jacobian) });
        self
    }
}
