//! The question: contacts, soft fingertips, stiffness, friction, wrench and twist, grasp.
//!
//! Written once for the plane and for space: `D` is the number of degrees of freedom of the object and `C` the number
//! of axes of a contact, 3 and 2 in the plane, 6 and 3 in space. Use the names in [`crate::planar`] and
//! [`crate::spatial`].
//!
//! # Vectors of other libraries
//!
//! Points and vectors are taken as whatever turns into an array of f64: arrays and tuples; vectors, points and translations of
//! nalgebra; the `DVec2` and `DVec3` of any version of glam, and so of parry, rapier and bevy; mint's. Answers are nalgebra's
//! vectors ([`crate::nalgebra`]) or arrays, and both turn back: `DVec3::from_array(contact.force_world.into())`. Single precision is
//! widened by its owner (`Vec3::as_dvec3`) and narrowed again (`DVec3::as_vec3`); nothing here computes in it.
//!
//! Poses are nalgebra's: [`Contact::transformed`], [`Wrench::transformed`] and [`Twist::transformed`] bring the coordinates of a link
//! or of the object to those of the grasp, `about` moves the reference point, and [`Twist::exp`](crate::spatial::Twist::exp) is the
//! rigid motion of an object's twist. Poses of glam, parry and rapier convert with `glamx` and its feature `nalgebra`:
//! `DPose3::from(twist.exp())`, `Isometry3::from(pose)`. The package `collision-contacts` in the repository
//! takes contacts from parry and shows all of it.

mod contact;
mod fingertip;
mod frames;
mod pressure;
mod rigid_motion;
mod rotation;
mod stiffness;
mod wrench;

use nalgebra::{SMatrix, SVector};

pub use contact::{Contact, Hold};
pub use fingertip::SoftFingertip;
pub use pressure::Pressure;
pub(crate) use rotation::{displacement_of, grasp_map, wrench_of};
use rotation::{grasp_map_in_twice, planes};
pub(crate) use stiffness::Stiffness;
pub use wrench::{Twist, Wrench};

use crate::error::{Error, Field, LARGEST, MODERATE, is_moderate};
use crate::numerics::DoubleDouble;

/// An object held by elastic fingers: a checked list of contacts.
///
/// The reference point of wrenches and twists is the origin of the coordinates in which the contact points are given.
#[derive(Debug, Clone)]
pub struct Grasp<const D: usize, const C: usize> {
    contacts: Vec<Contact<C>>,
    sites: Vec<Site<D, C>>,
    /// Centroid of the contact points: inside, moments and rotations are taken about it, so that a far away
    /// reference point costs no digits.
    origin: SVector<f64, C>,
    /// Root mean square distance of the contact points from their centroid: inside, the unit of length of arms, so
    /// that rotations and translations have comparable size whatever the user's unit.
    length: f64,
}

/// What the arithmetic needs of one contact, in inside coordinates.
#[derive(Debug, Clone)]
pub(crate) struct Site<const D: usize, const C: usize> {
    /// Grasp map G_i.
    pub(crate) map: SMatrix<f64, D, C>,
    /// What rounding took from G_i, given the points and the frame.
    pub(crate) map_rest: SMatrix<f64, D, C>,
    /// Contact frame, columns n, t….
    pub(crate) frame: SMatrix<f64, C, C>,
    /// Series stiffness; zero along the tangents of a frictionless contact, which has no spring there.
    pub(crate) k: SVector<f64, C>,
    pub(crate) mu: f64,
    pub(crate) hold: Hold,
    /// Number of axes with a spring: 1 without friction, else `C`.
    pub(crate) axes: usize,
}

impl<const D: usize, const C: usize> Grasp<D, C> {
    /// Checks the contacts and lays out their frames.
    ///
    /// ```
    /// use grasp_lcp::planar::{Contact, Grasp};
    /// use grasp_lcp::{Error, Field};
    ///
    /// let contact = |mu| Contact::new([0.0, 0.0], [1.0, 0.0]).series_stiffness(1.0, 1.0).friction(mu);
    /// assert_eq!(Grasp::new([contact(0.3), contact(0.5)])?.len(), 2);
    ///
    /// let refused = Grasp::new([contact(0.3), contact(-0.5).name("thumb")]).unwrap_err();
    /// assert!(matches!(refused, Error::Contact { field: Field::Friction, value: -0.5, .. }));
    /// assert_eq!(refused.to_string(), "contact 1 (thumb): friction coefficient is -0.5, must be from 0 to 1e50, or infinite");
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::EmptyGrasp`], or [`Error::Contact`] naming the first contact, field and value that is out of range.
    pub fn new(contacts: impl IntoIterator<Item = Contact<C>>) -> Result<Self, Error> {
        const { assert!(D == C + C * (C - 1) / 2 && (C == 2 || C == 3)) };
        let contacts: Vec<_> = contacts.into_iter().collect();
        if contacts.is_empty() {
            return Err(Error::EmptyGrasp);
        }
        for (index, contact) in contacts.iter().enumerate() {
            contact.check(index)?;
        }
        let count = contacts.len() as f64;
        let origin = contacts.iter().fold(SVector::zeros(), |sum, c| sum + c.point / count);
        let spread = contacts.iter().map(|c| (c.point - origin).norm_squared() / count).sum::<f64>().sqrt();
        // A single point has no size of its own; then any unit of length does.
        let length = if spread * LARGEST > 1.0 { spread } else { 1.0 };
        let sites = contacts
            .iter()
            .enumerate()
            .map(|(index, contact)| {
                let frame = contact.frame(index)?;
                let frictionless = contact.friction == 0.0 && contact.hold != Hold::Bonded;
                let axes = if frictionless { 1 } else { C };
                let series = contact.stiffness.series();
                let (map, map_rest) = grasp_map_in_twice(&contact.point, &origin, length, &frame);
                Ok(Site {
                    map,
                    map_rest,
                    frame,
                    k: SVector::from_fn(|a, _| if a < axes { series[a] } else { 0.0 }),
                    mu: contact.friction,
                    hold: contact.hold,
                    axes,
                })
            })
            .collect::<Result<_, Error>>()?;
        Ok(Self { contacts, sites, origin, length })
    }

    /// Number of contacts, at least 1.
    #[must_use]
    #[expect(clippy::len_without_is_empty, reason = "a grasp is never empty")]
    pub fn len(&self) -> usize {
        self.contacts.len()
    }

    /// The contacts as they were given.
    #[must_use]
    pub fn contacts(&self) -> &[Contact<C>] {
        &self.contacts
    }

    /// The contact frames, orthonormal columns n, t (and t₂): `frame * force` is along the coordinate axes. In space each is a
    /// rotation, [`Rotation3::from_matrix_unchecked`](nalgebra::Rotation3::from_matrix_unchecked) takes it; in the plane it is a
    /// reflection, since `t = (n_y, -n_x)` lies clockwise of n.
    ///
    /// ```
    /// use grasp_lcp::nalgebra::{Rotation3, Vector3};
    /// use grasp_lcp::spatial::{Contact, Grasp};
    ///
    /// let grasp = Grasp::new([Contact::new([0.0; 3], [0.0, 0.0, -2.0]).series_stiffness(1.0, 1.0)])?;
    /// for frame in grasp.frames() {
    ///     assert_eq!(frame.column(0), -Vector3::z());
    ///     assert_eq!(Rotation3::from_matrix_unchecked(*frame).matrix().determinant(), 1.0);
    /// }
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    #[must_use]
    pub fn frames(&self) -> impl ExactSizeIterator<Item = &SMatrix<f64, C, C>> {
        self.sites.iter().map(|site| &site.frame)
    }

    /// The same grasp with other finger commands u_f, one a contact, each in its contact frame (m).
    ///
    /// ```
    /// use grasp_lcp::planar::{Contact, Grasp, Wrench};
    ///
    /// // Two fingers that each press with 1000 N/m · 0.01 m = 10 N; μ = 0.5.
    /// let finger = |x: f64| Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1000.0, 800.0).friction(0.5).command([0.01, 0.0]);
    /// let grasp = Grasp::new([finger(-1.0), finger(1.0)])?;
    ///
    /// let squeezed = grasp.with_commands(&[[0.03, 0.0].into(), [0.03, 0.0].into()])?;
    /// let outcome = squeezed.solve(&Wrench::ZERO)?;
    /// assert!((outcome.equilibrium().expect("holds").contacts[0].normal_force() - 30.0).abs() < 1e-13);
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Size`] if there are more or fewer than contacts, [`Error::Contact`] if one is not finite.
    pub fn with_commands(mut self, commands: &[SVector<f64, C>]) -> Result<Self, Error> {
        self.check_commands(commands, "commands", Field::Command)?;
        for (contact, command) in self.contacts.iter_mut().zip(commands) {
            contact.command = *command;
        }
        Ok(self)
    }

    pub(crate) fn check_commands(
        &self,
        commands: &[SVector<f64, C>],
        what: &'static str,
        field: Field,
    ) -> Result<(), Error> {
        if commands.len() != self.len() {
            return Err(Error::Size { what, given: commands.len(), expected: self.len() });
        }
        for (index, (contact, command)) in self.contacts.iter().zip(commands).enumerate() {
            if let Some(&value) = command.iter().find(|x| !is_moderate(**x)) {
                return Err(Error::Contact {
                    contact: contact.label(index),
                    field,
                    value,
                    allowed: MODERATE,
                });
            }
        }
        Ok(())
    }

    pub(crate) fn sites(&self) -> &[Site<D, C>] {
        &self.sites
    }

    /// a_i: commanded displacements in the contact frames, the normal part less the clearance.
    pub(crate) fn drives(&self) -> Vec<SVector<f64, C>> {
        self.each_drive().collect()
    }

    pub(crate) fn each_drive(&self) -> impl Iterator<Item = SVector<f64, C>> {
        self.contacts.iter().map(|contact| {
            let mut a = contact.command;
            a[0] -= contact.clearance;
            a
        })
    }

    /// A checked wrench, moved to the centroid and to the inside unit of length.
    pub(crate) fn inside(&self, wrench: &Wrench<D>, what: &'static str) -> Result<SVector<f64, D>, Error> {
        let w = wrench.as_vector();
        if let Some(component) = w.iter().position(|x| !is_moderate(*x)) {
            return Err(Error::Wrench { what, component, value: w[component] });
        }
        Ok(self.inside_unchecked(wrench))
    }

    /// The same for a wrench that was checked before.
    pub(crate) fn inside_unchecked(&self, wrench: &Wrench<D>) -> SVector<f64, D> {
        let w = wrench.as_vector();
        let force = SVector::<f64, C>::from_fn(|a, _| w[a]);
        let carried = wrench_of::<D, C>(&self.origin, &force);
        SVector::from_fn(|k, _| if k < C { w[k] } else { (w[k] - carried[k]) / self.length })
    }

    /// What rounding takes from a wrench moved inside.
    pub(crate) fn inside_rest(&self, wrench: &Wrench<D>) -> SVector<f64, D> {
        let (w, inside) = (wrench.as_vector(), self.inside_unchecked(wrench));
        let mut rest = SVector::zeros();
        for (k, &(i, j)) in planes::<C>().iter().enumerate() {
            let mut moment = DoubleDouble::new(w[C + k]);
            moment.add_product(-self.origin[i], w[j]);
            moment.add_product(self.origin[j], w[i]);
            moment.add_product(-inside[C + k], self.length);
            rest[C + k] = moment.value() / self.length;
        }
        rest
    }

    /// Root mean square distance of the contact points from their centroid.
    pub(crate) fn length(&self) -> f64 {
        self.length
    }

    /// A wrench as the user sees it, from inside coordinates.
    pub(crate) fn wrench_outside(&self, w: &SVector<f64, D>) -> Wrench<D> {
        let force = SVector::<f64, C>::from_fn(|a, _| w[a]);
        let carried = wrench_of::<D, C>(&self.origin, &force);
        Wrench::from_vector(SVector::from_fn(
            |k, _| if k < C { w[k] } else { w[k] * self.length + carried[k] },
        ))
    }

    /// A twist in inside coordinates: about the centroid, rotations times the inside unit of length.
    pub(crate) fn inside_twist(&self, twist: &Twist<D>) -> SVector<f64, D> {
        let moved = displacement_of::<D, C>(&self.origin, twist.as_vector());
        SVector::from_fn(|k, _| if k < C { moved[k] } else { twist.as_vector()[k] * self.length })
    }

    /// A twist as the user sees it, from inside coordinates.
    pub(crate) fn outside(&self, q: &SVector<f64, D>) -> Twist<D> {
        let mut twist = SVector::from_fn(|k, _| if k < C { q[k] } else { q[k] / self.length });
        let moved = displacement_of::<D, C>(&-self.origin, &twist);
        for a in 0..C {
            twist[a] = moved[a];
        }
        Twist::from_vector(twist)
    }
}
