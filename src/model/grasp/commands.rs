//! Commands of a finger, as a position or as a force, and the clearance between finger and object.

use nalgebra::{SMatrix, SVector};

use super::contact::Contact;
use crate::numerics::{by_axis, dot};

/// The axes along which a command, the commanded displacement of a finger, is given.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum CommandAxes {
    /// Axes of the contact frame, the normal first.
    Frame,
    /// Axes of the coordinate system in which the contact is given.
    World,
}

impl<const C: usize> Contact<C> {
    /// Commanded displacement u_f of the finger's core in the **contact frame**, m: (normal, tangential…). The core is the finger without the
    /// deformation at its contact. A positive normal component pushes into the object; a positive tangential component drags the object along the
    /// tangent. See [`Self::command_world`] for a command along the coordinate axes.
    #[doc(alias = "commanded displacement", alias = "reference displacement")]
    pub fn command(mut self, u_f: impl Into<[f64; C]>) -> Self {
        self.command = SVector::from(u_f.into());
        self.command_axes = CommandAxes::Frame;
        self
    }

    /// Commanded displacement u_f of the finger's core along the **coordinate axes**, m. The core is the finger without the deformation at its
    /// contact. The command is converted to the contact frame when the grasp is made, so normal and tangent may be set later.
    ///
    /// ```
    /// use grasp_lcp::planar::{Contact, Grasp};
    ///
    /// // A finger pushes up, n = (0, 1), t = (1, 0). To the right is along t, upwards along n.
    /// let finger = Contact::new([0.0, 0.0], [0.0, 2.0]).series_stiffness(1.0, 1.0).command_world([0.001, 0.002]);
    /// assert_eq!(finger.commanded().as_slice(), [0.002, 0.001]);
    /// assert_eq!(Grasp::new([finger])?.contacts()[0].commanded().as_slice(), [0.002, 0.001]);
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    pub fn command_world(mut self, u_f: impl Into<[f64; C]>) -> Self {
        self.command = SVector::from(u_f.into());
        self.command_axes = CommandAxes::World;
        self
    }

    setters! {
        /// Sets the commanded normal force, N, zero or positive. The finger is commanded to the **position** at which it presses with this force on
        /// an object that does not move. The force replaces the normal component of the command by `clearance + force / k_n`, with the normal series
        /// stiffness k_n. The tangential components stay. When the object moves, the force changes. Fingers with unequal forces therefore push the
        /// object until their forces balance.
        ///
        /// On a finger [with joints](crate::grasp::Finger) the joints are commanded too, so that the finger exerts no tangential force. The joint
        /// commands are `K⁻¹Jᵀ` times the force vector, with the joint stiffness matrix K and the Jacobian J of the contact.
        ///
        /// ```
        /// use grasp_lcp::planar::{Contact, Grasp, Wrench};
        ///
        /// // Two fingers that each press with 8 N; μ = 0.5. One finger starts 2 mm away from the object.
        /// let finger = |x: f64| Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1000.0, 800.0).friction(0.5).pressed_with(8.0);
        /// let grasp = Grasp::new([finger(-1.0), finger(1.0).clearance(0.002)])?;
        /// let onset = grasp.onset(Wrench::force([0.0, -1.0]))?;
        /// assert!((onset.factor().expect("slides") - 8.0).abs() < 1e-13);
        /// assert!((grasp.contacts()[1].commanded()[0] - 0.010).abs() < 1e-16);
        /// # Ok::<(), grasp_lcp::Error>(())
        /// ```
        #[doc(alias = "grip force", alias = "preload", alias = "squeeze")]
        pub fn pressed_with(mut self, force: f64) { (self.press, self.force) = (Some(force), None); }

        /// Sets a **constant** normal force, N, zero or positive, as exerted by an air cylinder, a weight on a lever or a motor at constant current.
        /// Along the normal the finger follows the object instead of holding a position. Along the tangents its springs act as usual. The force
        /// replaces [`Self::pressed_with`] and the normal component of the command.
        ///
        /// The grasp gets one more joint, a slide along the normal on which the finger follows the object. All points of a soft fingertip move on one
        /// common slide, so that their springs share the force. The joint is named "slide of" and the name of the contact, and comes after all other
        /// joints. Questions that refuse hands therefore refuse such a grasp.
        ///
        /// ```
        /// use grasp_lcp::planar::{Contact, Grasp, Wrench};
        ///
        /// // One pad presses with 8 N against a pad that stands still. A load along the normal leaves the 8 N unchanged; the other pad carries it.
        /// let pad = |x: f64| Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1e3, 1e3).friction(0.5);
        /// let grasp = Grasp::new([pad(-1.0).force(8.0), pad(1.0)])?;
        /// let outcome = grasp.solve(Wrench::force([3.0, 0.0]))?;
        /// let held = outcome.equilibrium().expect("holds");
        /// assert!((held.contacts[0].normal_force() - 8.0).abs() < 1e-13);
        /// assert!((held.contacts[1].normal_force() - 11.0).abs() < 1e-13);
        /// # Ok::<(), grasp_lcp::Error>(())
        /// ```
        #[doc(alias = "clamp")]
        #[doc(alias = "force control")]
        pub fn force(mut self, force: f64) { (self.force, self.press) = (Some(force), None); }

        /// Sets the clearance between finger and object before anything moves, m (default 0).
        ///
        /// The finger must travel this far along the inward normal n before it touches: `F_n = k_n (command - clearance - n·u_c)`. Here k_n is the
        /// normal series stiffness and u_c the displacement of the object at the contact. A negative clearance is an initial overlap, the depth that
        /// collision libraries report. The contact then presses with k_n times the overlap before anything moves.
        ///
        /// ```
        /// use grasp_lcp::planar::{Contact, Grasp, Wrench};
        ///
        /// // A finger meets a post that is bonded to a rigid wall; two springs of 1000 N/m in series.
        /// let finger = Contact::new([0.0, 0.0], [1.0, 0.0]).body_stiffness(1000.0, 1000.0).finger_stiffness(1000.0, 1000.0);
        /// let post = Contact::new([1.0, 0.0], [-1.0, 0.0]).series_stiffness(1e12, 1e12).bonded();
        /// let force = |finger: Contact| {
        ///     let outcome = Grasp::new([finger, post.clone()])?.solve(Wrench::ZERO)?;
        ///     Ok::<_, grasp_lcp::Error>(outcome.equilibrium().expect("holds").contacts[0].normal_force())
        /// };
        /// // The finger is commanded 10 mm forward and meets the post after 2 mm: 8 mm · 500 N/m.
        /// assert!((force(finger.clone().command([0.010, 0.0]).clearance(0.002))? - 4.0).abs() < 1e-8);
        /// // Without a command the finger overlaps the post by 3 mm: 3 mm · 500 N/m.
        /// assert!((force(finger.clearance(-0.003))? - 1.5).abs() < 1e-8);
        /// # Ok::<(), grasp_lcp::Error>(())
        /// ```
        pub fn clearance(mut self, gap0: f64) { self.clearance = gap0; }
    }

    /// Commanded displacement of the finger's core, the finger without the deformation at its contact, in the contact frame, m. Its components are
    /// NaN if the command is along the coordinate axes and the contact has no valid frame; [`Grasp::new`](crate::ask::Grasp::new) refuses such a
    /// contact.
    #[must_use]
    pub fn commanded(&self) -> SVector<f64, C> {
        let mut command = match self.command_axes {
            CommandAxes::Frame => self.command,
            CommandAxes::World => {
                let along = |frame: SMatrix<f64, C, C>| {
                    by_axis(|axis| dot(frame.column(axis).as_slice(), self.command.as_slice()))
                };
                self.frame(0).map_or_else(|_| SVector::repeat(f64::NAN), along)
            }
        };
        if let Some(force) = self.press {
            command[0] = self.clearance + force / self.stiffness.series()[0];
        }
        command
    }

    /// The command along the coordinate axes, if it was given by [`Self::command_world`].
    #[inline]
    pub(crate) fn commanded_in_world(&self) -> Option<&SVector<f64, C>> {
        (self.command_axes == CommandAxes::World).then_some(&self.command)
    }

    /// This contact with the command given in the contact frame, and with the force of [`Self::pressed_with`] converted to a command.
    pub(super) fn resolved(mut self) -> Self {
        (self.command, self.command_axes, self.press) = (self.commanded(), CommandAxes::Frame, None);
        self
    }

    /// Multiplies by `factor` everything by which this contact presses without a load: its command, constant force and vacuum, and the force
    /// prescribed for the equilibrium under constant loads alone.
    pub(crate) fn squeeze(&mut self, factor: f64) {
        self.command *= factor;
        self.force = self.force.map(|force| force * factor);
        self.suction *= factor;
        self.at_rest = self.at_rest.map(|tension| tension * factor);
    }
}
