//! A contact: its point, compliance and friction, and the command of its finger. A command is a prescribed displacement of a finger.

use alloc::sync::Arc;

use nalgebra::SVector;

use super::commands::CommandAxes;
use super::stiffness::Stiffness;
use crate::error::ContactLabel;
use crate::numerics::Space;
use crate::prelude::*;
use crate::words::LinkKind;

/// Whether a contact can open, and whether it can slip.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "snake_case"))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub enum Hold {
    /// The contact pushes, never pulls, and may open: `0 <= gap ⟂ F_n >= 0`.
    #[default]
    Unilateral,
    /// The contact never opens: gap = 0. With zero or infinite friction the normal spring both pushes and pulls. Without friction this is a guide
    /// along which the object slips freely; with infinite friction the object never slips. With a finite positive friction coefficient `|F_t| <= μ
    /// F_n` holds as usual, so that no equilibrium exists under a load that needs a pull.
    KeptClosed,
    /// The surfaces are glued: normal and tangential springs push and pull without limit. Gap and slip are zero, and friction has no effect.
    Bonded,
}

/// A point contact with Coulomb friction between the object and an elastic finger.
///
/// A contact is built step by step; the documentation of each method gives its default. [`Grasp`](crate::ask::Grasp) validates its contacts when it
/// is made. `C` is the number of axes: 2 in the plane, 3 in space.
///
/// The contact frame is (n, t) in the plane with `t = (n_y, -n_x)`, and (n, t₁, t₂) in space with `t₂ = n × t₁`. Components of stiffnesses,
/// commands and forces refer to its axes, the normal first.
///
/// ```
/// use grasp_lcp::planar::{Contact, Grasp, Wrench};
///
/// // A finger on the left side of an object pushes to the right: n = (1, 0), t = (0, -1).
/// let left = Contact::new([-0.03, 0.0], [1.0, 0.0])
///     .name("left")
///     .body_stiffness(3e3, 2e3)       // N/m, normal and tangential
///     .finger_stiffness(1.5e3, 1e3)
///     .friction(0.5)
///     .command([0.002, 0.001]);       // m: pushes in, and drags downwards
/// assert_eq!(left.series_stiffness_of_axes().as_slice(), [1e3, 2e3 / 3.0]);
///
/// // The object is glued to a wall and hardly moves. The finger's force on it is the spring force, k · command along each axis.
/// let glue = |y: f64| Contact::new([0.03, y], [-1.0, 0.0]).series_stiffness(1e9, 1e9).bonded();
/// let outcome = Grasp::new([left, glue(-0.01), glue(0.01)])?.solve(Wrench::ZERO)?;
/// let carried = &outcome.equilibrium().expect("within friction").contacts[0];
/// assert!((carried.force[0] - 2.0).abs() < 1e-5 && (carried.force_world[0] - 2.0).abs() < 1e-5);
/// assert!((carried.force[1] - 2.0 / 3.0).abs() < 1e-5 && (carried.force_world[1] + 2.0 / 3.0).abs() < 1e-5);
/// # Ok::<(), grasp_lcp::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
#[must_use]
pub struct Contact<const C: usize> {
    /// Plane or space. Internally, vectors of contacts in the plane have three components, too, the third of which is zero.
    pub(crate) space: Space,
    pub(crate) name: Option<Arc<str>>,
    pub(crate) point: SVector<f64, C>,
    pub(crate) normal: SVector<f64, C>,
    pub(crate) tangent: Option<SVector<f64, C>>,
    pub(crate) stiffness: Stiffness<C>,
    pub(crate) friction: f64,
    /// Coefficient of kinetic friction, if it differs from `friction`.
    pub(crate) kinetic: Option<f64>,
    pub(crate) command: SVector<f64, C>,
    /// Axes of `command`; they are the axes of the contact frame once the contact is part of a grasp.
    pub(crate) command_axes: CommandAxes,
    /// Commanded normal force, N, which replaces the normal component of the command. It is converted to a command once the contact is part of a
    /// grasp.
    pub(crate) press: Option<f64>,
    /// Prescribed normal force in the equilibrium under the constant loads alone, after all springs have deflected, N. When the grasp is made, the
    /// command that leads to this force is computed.
    pub(crate) at_rest: Option<f64>,
    /// Constant normal force that is independent of the object's motion, N; `None` if no such force is given.
    pub(crate) force: Option<f64>,
    /// Constant force with which a vacuum pulls the object onto the contact, N.
    pub(crate) suction: f64,
    pub(crate) clearance: f64,
    pub(crate) hold: Hold,
    /// Number, from 0, of this contact point among the points of its soft fingertip, or of its link between bodies; `None` for a contact of a single
    /// point.
    pub(crate) point_of_pad: Option<usize>,
    /// Name of the body into which the normal of the contact points, if the grasp has several bodies.
    pub(crate) on: Option<Arc<str>>,
    /// Name of the body on the other side of the contact, if the grasp has several bodies.
    pub(crate) against: Option<Arc<str>>,
    /// Kind of the link between bodies (hinge, cable, …) to which this point belongs; `None` for an ordinary contact.
    pub(crate) link: Option<LinkKind>,
}

impl<const C: usize> Contact<C> {
    /// A contact at `point` (m) whose `normal` points **into the object**, the way the finger pushes. The normal need not have length one. Friction,
    /// command and clearance are 0 by default; a stiffness must be given.
    pub fn new(point: impl Into<[f64; C]>, normal: impl Into<[f64; C]>) -> Self {
        Self {
            space: Space::of::<C>(),
            name: None,
            point: SVector::from(point.into()),
            normal: SVector::from(normal.into()),
            tangent: None,
            stiffness: Stiffness::default(),
            friction: 0.0,
            kinetic: None,
            command: SVector::zeros(),
            command_axes: CommandAxes::Frame,
            press: None,
            at_rest: None,
            force: None,
            suction: 0.0,
            clearance: 0.0,
            hold: Hold::Unilateral,
            point_of_pad: None,
            on: None,
            against: None,
            link: None,
        }
    }

    setters! {
        /// Names the body into which the normal of the contact points, one of [several bodies](super::Bodies). Forces and displacements of the
        /// contact refer to it.
        pub fn on(mut self, body: impl Into<String>) { self.on = Some(body.into().into()); }

        /// Names the body on the other side of the contact, one of [several bodies](super::Bodies), in place of the ground or a finger. The body
        /// stiffness of the contact then belongs to the body named by [`on`](Self::on), its finger stiffness to the body named here.
        pub fn against(mut self, body: impl Into<String>) { self.against = Some(body.into().into()); }

        /// Sets a vacuum that pulls the object onto the contact, against the normal, with a constant force, N, zero or positive. The rim of the
        /// suction cup presses with this force, less the part of the load that pulls the object off. A [`SuctionCup`](super::SuctionCup) consists of
        /// a ring of such contact points, its rim or lip.
        pub fn suction(mut self, force: f64) { self.suction = force; }

        /// Sets the name for messages and tables.
        pub fn name(mut self, name: impl Into<String>) { self.name = Some(name.into().into()); }

        /// Sets the direction of the first tangent; its component along the normal is removed. In the plane the argument only selects the sign of t.
        /// The default is `(n_y, -n_x)` in the plane. In space it is the projection of the coordinate axis that makes the largest angle with the
        /// normal.
        ///
        /// ```
        /// use grasp_lcp::nalgebra::Vector3;
        /// use grasp_lcp::spatial::{Contact, Grasp};
        ///
        /// // Pressing down, t₁ along y: t₂ = n × t₁ = -z × y = x.
        /// let foot = Contact::new([0.0; 3], [0.0, 0.0, -1.0]).series_stiffness(1.0, 1.0).tangent([0.0, 2.0, -5.0]);
        /// let grasp = Grasp::new([foot])?;
        /// let frame = grasp.frames().next().expect("one contact");
        /// assert!((frame.column(1) - Vector3::y()).norm() < 1e-15 && (frame.column(2) - Vector3::x()).norm() < 1e-15);
        /// # Ok::<(), grasp_lcp::Error>(())
        /// ```
        pub fn tangent(mut self, tangent: impl Into<[f64; C]>) {
            self.tangent = Some(SVector::from(tangent.into()));
        }

        /// Sets the coefficient of friction, μ >= 0. With 0 (the default) the contact has no tangential spring, even if a tangential stiffness is
        /// given. With `f64::INFINITY` the contact never slides while it is closed. A [bonded](Self::bonded) contact has its tangential springs for
        /// every μ.
        pub fn friction(mut self, mu: f64) { self.friction = mu; }

        /// Sets the coefficient of kinetic friction, from a millionth of the [static coefficient](Self::friction) up to the static coefficient
        /// itself. When the contact begins to slide, its friction drops to this value at constant load. Other contacts then carry the difference, or
        /// no equilibrium exists and the object is lost. A contact that has stopped sliding has static friction again.
        ///
        /// Answers are **overdamped**: the object moves without overshoot to where forces balance again. An undamped object overshoots up to twice as
        /// far, and may be lost although the overdamped object is held. See the [guide](crate::guide::kinetic_friction).
        ///
        /// [`follow`](crate::ask::Grasp::follow), [`hold`](crate::ask::Grasp::hold), [`shake`](crate::ask::Grasp::shake) and the needs
        /// [`to_hold`](crate::need::Need::to_hold) and [`to_rest`](crate::need::Need::to_rest) take kinetic friction into account. First slip, the
        /// event at which the first contact ceases to stick, does not depend on kinetic friction. [`solve`](crate::ask::Grasp::solve) refuses an
        /// equilibrium in which a contact with kinetic friction slides. [`follow_in_steps`](crate::ask::Grasp::follow_in_steps) refuses grasps with
        /// kinetic friction. All other questions of a grasp concern contacts that do not slide.
        ///
        /// ```
        /// use grasp_lcp::planar::{Contact, Grasp, Wrench};
        ///
        /// // Two feet that press with 10 N share a pull. At 7.5 N the stiff foot begins to slide and then carries 4 N, the other foot 3.5 N.
        /// let foot = |x: f64, k: f64| {
        ///     Contact::new([x, 0.0], [0.0, 1.0]).series_stiffness(1e3, k).friction(0.5).kinetic(0.4).pressed_with(10.0)
        /// };
        /// let guide = Contact::new([0.0, 0.0], [0.0, 1.0]).series_stiffness(1e9, 1e9).kept_closed();
        /// let grasp = Grasp::new([foot(-0.1, 1e3), foot(0.1, 5e2), guide])?;
        /// let verdict = grasp.hold(Wrench::force([8.0, 0.0]))?;
        /// assert_eq!(verdict.holds(), Some(true));
        /// # Ok::<(), grasp_lcp::Error>(())
        /// ```
        #[doc(alias = "kinetic friction")]
        #[doc(alias = "dynamic friction")]
        pub fn kinetic(mut self, mu: f64) { self.kinetic = Some(mu); }

        /// Keeps the contact closed, so that it never opens ([`Hold::KeptClosed`]).
        ///
        /// ```
        /// use grasp_lcp::planar::{Contact, Grasp, Wrench};
        ///
        /// // A carriage whose wheels are enclosed by a rail. It is pulled up by 3 N, and the rail holds it down.
        /// let wheel = |x: f64, mu: f64| Contact::new([x, 0.0], [0.0, 1.0]).series_stiffness(1e3, 1e3).friction(mu).kept_closed();
        /// let pull = Wrench::force([0.0, 3.0]);
        /// let outcome = Grasp::new([wheel(-1.0, 0.0), wheel(1.0, 0.0)])?.solve(&pull)?;
        /// let held = outcome.equilibrium().expect("the rail holds");
        /// assert!((held.contacts[0].normal_force() + 1.5).abs() < 1e-14);
        ///
        /// // With finite friction the normal force must push, since |F_t| <= μ F_n. There is no equilibrium.
        /// assert!(Grasp::new([wheel(-1.0, 0.2), wheel(1.0, 0.2)])?.solve(&pull)?.equilibrium().is_none());
        /// # Ok::<(), grasp_lcp::Error>(())
        /// ```
        pub fn kept_closed(mut self) { self.hold = Hold::KeptClosed; }

        /// Glues the surfaces at the contact, so that it neither opens nor slips ([`Hold::Bonded`]).
        pub fn bonded(mut self) { self.hold = Hold::Bonded; }
    }

    /// The contact point, m.
    #[must_use]
    pub fn point(&self) -> SVector<f64, C> {
        self.point
    }

    /// Coefficient of friction μ.
    #[must_use]
    pub fn friction_coefficient(&self) -> f64 {
        self.friction
    }

    /// Coefficient of kinetic friction; equal to the static coefficient unless a kinetic coefficient [was given](Self::kinetic).
    #[must_use]
    pub fn kinetic_coefficient(&self) -> f64 {
        self.kinetic.unwrap_or(self.friction)
    }

    /// Sets the coefficient of static friction and scales the coefficient of kinetic friction in proportion. If the kinetic coefficient becomes zero
    /// or infinite, it is removed.
    pub(crate) fn set_friction(&mut self, mu: f64) {
        let proportion = mu / self.friction;
        self.kinetic = self
            .kinetic
            .map(|kinetic| kinetic * proportion)
            .filter(|kinetic| kinetic.is_finite() && *kinetic > 0.0);
        self.friction = mu;
    }

    /// Number of axes along which the contact has a spring: 1 (the normal) for μ = 0 unless the contact is bonded, otherwise all axes.
    pub(crate) fn springs(&self) -> usize {
        if self.friction == 0.0 && self.hold != Hold::Bonded { 1 } else { self.space.axes() }
    }

    /// Name of the contact in tables and pictures: the name that the user gave, or "contact" and `index`, its position from 0 in the list of
    /// contacts.
    #[must_use]
    pub fn label_text(&self, index: usize) -> String {
        self.label(index).text()
    }

    /// Name in messages: "contact 1 (thumb)" for a contact, "hinge "pin"" for a link.
    pub(crate) fn said_in_full(&self, index: usize) -> String {
        match (self.link, self.whole_name()) {
            (Some(kind), Some(name)) => format!("{} {name:?}", kind.name()),
            _ => format!("contact {}", self.label(index)),
        }
    }

    pub(crate) fn label(&self, index: usize) -> ContactLabel {
        ContactLabel { index, point: None, name: self.name.clone(), link: self.link }
    }
}
