//! Copies of a grasp with other data – commands, torques, friction, squeeze – and the same settings. A command is the displacement that a finger
//! would make if there were no object. The squeeze is everything by which contacts press at rest without a load.

use crate::numerics::IntoList;
use alloc::sync::Arc;

use nalgebra::SVector;

use super::grasp::Grasp;
use crate::equilibrium::Equilibrium;
use crate::error::Error;
use crate::grasp::{Contact, Engine, Face, PressOfPart, Wrench, all_inside, inside};
use crate::prelude::*;

impl<const C: usize> Grasp<C> {
    /// A grasp with the engine `engine` (checked contacts, hand and bodies) and with the settings of this grasp. If `engine` is an error, this error
    /// is returned.
    pub(super) fn changed(&self, engine: Result<Engine, Error>) -> Result<Self, Error> {
        Ok(Self::of(engine?).with(&self.settings))
    }

    /// This grasp with the loads on single bodies that acted at `equilibrium`; a load program may have changed some of them.
    pub(super) fn of_equilibrium(&self, equilibrium: &Equilibrium<C>) -> Self {
        let loads = &equilibrium.body_loads;
        let changed =
            (!loads.is_empty()).then(|| self.changed(self.engine.with_body_loads(&all_inside(loads))));
        // The loads give an error only for a body that this grasp does not have. The equilibrium then belongs to another grasp, and a copy of this
        // grasp is returned.
        changed.and_then(Result::ok).unwrap_or_else(|| self.clone())
    }

    /// This grasp with other finger commands u_f, one for each contact in its contact frame (m): arrays, or vectors.
    ///
    /// ```
    /// use grasp_lcp::planar::{Contact, Grasp, Wrench};
    ///
    /// // Two fingers that each press with 1000 N/m · 0.01 m = 10 N; μ = 0.5.
    /// let finger = |x: f64| Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1000.0, 800.0).friction(0.5).command([0.01, 0.0]);
    /// let grasp = Grasp::new([finger(-1.0), finger(1.0)])?;
    ///
    /// let squeezed = grasp.with_commands([[0.03, 0.0]; 2])?;
    /// let outcome = squeezed.solve(Wrench::ZERO)?;
    /// assert!((outcome.equilibrium().expect("holds").contacts[0].normal_force() - 30.0).abs() < 1e-13);
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Size`] unless there is one command for each contact, [`Error::Contact`] if one is not finite.
    pub fn with_commands(
        &self,
        commands: impl IntoIterator<Item = impl Into<[f64; C]>>,
    ) -> Result<Self, Error> {
        let commands: Vec<_> = commands.into_iter().map(|u| SVector::from(u.into()).into_inside()).list();
        self.changed(self.engine.with_commands(&commands))
    }

    /// This grasp with other commands of the joints and then of the tendons of its hand, rad and m.
    ///
    /// ```
    /// use grasp_lcp::planar::hand::{Finger, Hand, Joint};
    /// use grasp_lcp::planar::{Wrench};
    /// use grasp_lcp::planar::Contact;
    ///
    /// let jaw = |x: f64| {
    ///     Finger::new([Joint::prismatic([-x, 0.0]).stiffness(1e3)])
    ///         .contact(Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1e9, 1e9).friction(0.5))
    /// };
    /// let grasp = Hand::new([jaw(-1.0), jaw(1.0)]).grasp()?.with_joint_commands(&[0.01, 0.01])?;
    /// let outcome = grasp.solve(Wrench::ZERO)?;
    /// assert!((outcome.equilibrium().expect("holds").contacts[0].normal_force() - 10.0).abs() < 1e-4);
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::JointCommands`] unless there is one command for each joint and each tendon, [`Error::Hand`] if one is not finite.
    pub fn with_joint_commands(&self, commands: &[f64]) -> Result<Self, Error> {
        self.changed(self.engine.with_joint_commands(commands))
    }

    /// This grasp with external torques on the joints of its hand, N m or N, positive along their displacements. They act
    /// in addition to the load on the object.
    ///
    /// ```
    /// use grasp_lcp::planar::hand::{Finger, Hand, Joint};
    /// use grasp_lcp::planar::{Contact, Wrench};
    ///
    /// // Two jaws on springs of 1000 N/m, pressed by 5 N each from outside.
    /// let jaw = |x: f64| {
    ///     Finger::new([Joint::prismatic([-x, 0.0]).stiffness(1e3)])
    ///         .contact(Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1e9, 1e9).friction(0.5).clearance(-1e-12))
    /// };
    /// let grasp = Hand::new([jaw(-1.0), jaw(1.0)]).grasp()?.with_joint_torques(&[5.0, 5.0])?;
    /// let outcome = grasp.solve(Wrench::ZERO)?;
    /// assert!((outcome.equilibrium().expect("holds").contacts[0].normal_force() - 5.0).abs() < 1e-4);
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::JointCommands`] unless there is one torque for each joint, [`Error::Hand`] if one is not finite.
    pub fn with_joint_torques(&self, torques: &[f64]) -> Result<Self, Error> {
        self.changed(self.engine.with_joint_torques(torques))
    }

    /// This grasp with loads on other bodies that grow in proportion to `load`. A method that applies τ times `load` to the object then also applies
    /// τ times each of `others` to its body. Every load given to a method, base loads included, is replaced by its component along `load`, a multiple
    /// of `load`. Constant loads are given with the bodies instead ([`Body::load`](crate::grasp::Body::load)).
    ///
    /// ```
    /// use grasp_lcp::planar::{Bodies, Body, Contact, Link, Wrench};
    ///
    /// // Pliers whose pin hangs in a stand, and a rod between their jaws, 10 mm from the pin. A hand presses the handles together at 100 mm.
    /// let jaw = |side: f64, lever: &str| {
    ///     Contact::new([0.01, 0.002 * side], [0.0, -side]).series_stiffness(1e6, 1e6).friction(0.2).on("rod").against(lever)
    /// };
    /// let pliers = Bodies::new([Body::new("rod"), Body::new("upper jaw"), Body::new("lower jaw")])
    ///     .contacts([jaw(1.0, "upper jaw"), jaw(-1.0, "lower jaw")])
    ///     .links([Link::hinge([0.0, 0.0]).between("upper jaw", "lower jaw"), Link::hinge([0.0, 0.0]).to_ground("lower jaw")])
    ///     .loaded("upper jaw")
    ///     .grasp()?;
    /// let press = |newtons: f64| Wrench::force_at([0.0, newtons], [-0.1, 0.0]);
    /// let pressed = pliers.growing_together(&press(1.0), [("lower jaw", press(-1.0))])?;
    /// let state = pressed.solve(&press(10.0))?;
    /// let rod = &state.equilibrium().expect("holds").contacts[0];
    /// assert!((rod.normal_force() - 10.0 * 0.1 / 0.01).abs() < 1e-9);
    /// // One hand alone turns all of it about the pin.
    /// assert!(pliers.solve(&press(10.0))?.equilibrium().is_none());
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Body`] for an unknown body, [`Error::NothingChanges`] if `load` is zero, [`Error::Wrench`] if a component is not finite.
    pub fn growing_together<N: Into<String>>(
        &self,
        load: &Wrench<C>,
        others: impl IntoIterator<Item = (N, Wrench<C>)>,
    ) -> Result<Self, Error> {
        let named = others.into_iter().map(|(name, load)| (Arc::from(name.into()), load.into_inside()));
        self.changed(self.engine.growing_together(&inside(load), &named.list()))
    }

    /// This grasp with other coefficients of friction. `friction` gets the index of a contact and its present coefficient, and returns the new
    /// coefficient. Coefficients of [kinetic friction](crate::grasp::Contact::kinetic) change in proportion.
    ///
    /// ```
    /// use grasp_lcp::planar::{Contact, Grasp};
    ///
    /// let jaw = |x: f64| Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1e3, 8e2).friction(0.5).pressed_with(10.0);
    /// let oily = Grasp::new([jaw(-1.0), jaw(1.0)])?.with_friction(|_, dry| 0.2 * dry)?;
    /// assert!(oily.contacts().iter().all(|contact| contact.friction_coefficient() == 0.1));
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Contact`] if a coefficient is out of range. [`Error::Link`] if the grasp can no longer hold a [tension](crate::grasp::Link::tension).
    pub fn with_friction(&self, friction: impl Fn(usize, f64) -> f64) -> Result<Self, Error> {
        self.not_installed_with_friction(&friction)?.installed_again()
    }

    /// This grasp with other coefficients of friction, returned by `friction` for the index of a contact and its present coefficient. The commands of
    /// links (such as cables) are not yet adjusted to their given tensions.
    pub(crate) fn not_installed_with_friction(
        &self,
        friction: &dyn Fn(usize, f64) -> f64,
    ) -> Result<Self, Error> {
        self.changed(self.engine.with_friction(friction))
    }

    /// This grasp with other contacts, as many as before, and the same joints. Links (such as cables) keep their commands. [`Self::installed_again`]
    /// gives them their tensions again.
    pub(crate) fn with_contacts(&self, contacts: Vec<Contact<C>>) -> Result<Self, Error> {
        self.changed(self.engine.with_data(contacts.into_inside(), &|_| [1.0; 2]))
    }

    /// The force that the part with this name (a body, contact, cable or joint) exerts, and this grasp with that force multiplied by `factor`. The
    /// commands of links (such as cables) are not yet adjusted to their given tensions.
    pub(crate) fn scaled(&self, part: &str, factor: f64) -> Result<(PressOfPart, Self), Error> {
        let (pressing, engine) = self.engine.scaled(part, factor)?;
        Ok((pressing, self.changed(Ok(engine))?))
    }

    /// This grasp with the overlaps of its contacts (clearances below zero) multiplied by `factor`.
    pub(crate) fn with_overlaps(&self, factor: f64) -> Result<Self, Error> {
        self.changed(self.engine.with_overlaps(factor))
    }

    /// This grasp with its squeeze multiplied by `factor`. The commands of links (such as cables) are not yet adjusted to their given tensions.
    pub(crate) fn not_installed_squeezed(&self, factor: f64) -> Result<Self, Error> {
        self.changed(self.engine.squeezed(factor))
    }

    /// This grasp with new commands of its links, so that each link with a given tension has that tension without load. It is called after a change
    /// of the grasp. If no link has a given tension, nothing changes.
    pub(crate) fn installed_again(self) -> Result<Self, Error> {
        let settings = self.settings;
        Ok(Self::of(Arc::unwrap_or_clone(self.engine).installed()?).with(&settings))
    }

    /// This grasp with its squeeze (everything by which contacts press at rest without a load) multiplied by `factor`. The squeeze consists of
    /// commands of contacts, joints and tendons, constant torques of joints and constant tensions of tendons. Given normal forces of contacts,
    /// vacuums, and the tensions that [links](crate::grasp::Link::tension) have without load belong to it, too.
    ///
    /// # Errors
    /// [`Error::Argument`] unless the factor is finite and at most 1e50. [`Error::Link`] if the grasp cannot hold such a tension of a link.
    #[doc(alias = "grip force")]
    pub fn squeezed(&self, factor: f64) -> Result<Self, Error> {
        self.not_installed_squeezed(factor)?.installed_again()
    }
}
