//! One contact: where it touches, how it gives way, how it rubs, how its finger is commanded.

use alloc::sync::Arc;

use nalgebra::SVector;

use super::commands::Axes;
use super::stiffness::Stiffness;
use crate::error::ContactLabel;
use crate::prelude::*;
use crate::words::LinkKind;

/// How the contact is held together.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "snake_case"))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub enum Hold {
    /// Pushes, never pulls, and may open: `0 <= gap ⟂ F_n >= 0`.
    #[default]
    Unilateral,
    /// The contact never opens: gap = 0. With zero friction the normal spring acts both ways: a
    /// guide that lets the object slip along itself. With infinite friction, too, the normal spring
    /// acts both ways, and the object never slips. With friction in between `|F_t| <= μ F_n` holds
    /// as usual: where a pull would be needed there is no equilibrium.
    KeptClosed,
    /// Glued: normal and tangential springs act both ways and without limit. Gap and slip are zero,
    /// friction does not count.
    Bonded,
}

/// A point contact with Coulomb friction between the object and an elastic finger.
///
/// Built step by step; what is not said has the default given with each method. Checked when the
/// [`Grasp`](crate::ask::Grasp) is made. `C` is the number of axes: 2 in the plane, 3 in space.
///
/// The contact frame is (n, t) in the plane with `t = (n_y, -n_x)`, and (n, t₁, t₂) in space with
/// `t₂ = n × t₁`. Stiffnesses, commands and forces are along its axes, the normal first.
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
/// // The object is glued to a wall. The finger's force on it is that of the springs, k (command - displacement).
/// let glue = |y: f64| Contact::new([0.03, y], [-1.0, 0.0]).series_stiffness(1e9, 1e9).bonded();
/// let outcome = Grasp::new([left, glue(-0.01), glue(0.01)])?.solve(&Wrench::ZERO)?;
/// let carried = &outcome.equilibrium().expect("within friction").contacts[0];
/// assert!((carried.force[0] - 2.0).abs() < 1e-5 && (carried.force_world[0] - 2.0).abs() < 1e-5);
/// assert!((carried.force[1] - 2.0 / 3.0).abs() < 1e-5 && (carried.force_world[1] + 2.0 / 3.0).abs() < 1e-5);
/// # Ok::<(), grasp_lcp::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Contact<const C: usize> {
    pub(crate) name: Option<Arc<str>>,
    pub(crate) point: SVector<f64, C>,
    pub(crate) normal: SVector<f64, C>,
    pub(crate) tangent: Option<SVector<f64, C>>,
    pub(crate) stiffness: Stiffness<C>,
    pub(crate) friction: f64,
    /// The coefficient while it slides, if that is another one.
    pub(crate) kinetic: Option<f64>,
    pub(crate) command: SVector<f64, C>,
    /// The axes of `command`; those of the contact frame once the contact is part of a grasp.
    pub(crate) command_axes: Axes,
    /// Force that the command stands for, in place of its normal part; resolved once the contact is part of a grasp.
    pub(crate) press: Option<f64>,
    /// What it presses with at rest, whatever gives way: its command is found for it as soon as it is part of a grasp.
    pub(crate) at_rest: Option<f64>,
    /// Force along the normal that stays whatever the object does.
    pub(crate) force: Option<f64>,
    /// Force with which a vacuum pulls the object onto the contact, whatever it does, N.
    pub(crate) suction: f64,
    pub(crate) clearance: f64,
    pub(crate) hold: Hold,
    /// Which point of a soft fingertip it is, from 0.
    pub(crate) point_of_pad: Option<usize>,
    /// Of several bodies the one that the normal points into.
    pub(crate) on: Option<Arc<str>>,
    /// Of several bodies the one on the other side.
    pub(crate) against: Option<Arc<str>>,
    /// The kind of link that it is a point of, if it is no contact that is touched.
    pub(crate) link: Option<LinkKind>,
}

impl<const C: usize> Contact<C> {
    /// A contact at `point` (m) whose `normal` points **into the object**, the way the finger
    /// pushes. The normal need not have length one. Friction 0, command 0 and clearance 0 until
    /// said otherwise; a stiffness must be given.
    pub fn new(point: impl Into<[f64; C]>, normal: impl Into<[f64; C]>) -> Self {
        Self {
            name: None,
            point: SVector::from(point.into()),
            normal: SVector::from(normal.into()),
            tangent: None,
            stiffness: Stiffness::default(),
            friction: 0.0,
            kinetic: None,
            command: SVector::zeros(),
            command_axes: Axes::Frame,
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

    /// Of [several bodies](super::Bodies) the one that the normal points into, and that forces and displacements of the contact are told of.
    #[must_use]
    pub fn on(mut self, body: impl Into<String>) -> Self {
        self.on = Some(body.into().into());
        self
    }

    /// Of [several bodies](super::Bodies) the one on the other side, in place of the ground or a finger. The body stiffness of a contact is that of the body
    /// that it is [on](Self::on), the finger stiffness that of this one.
    #[must_use]
    pub fn against(mut self, body: impl Into<String>) -> Self {
        self.against = Some(body.into().into());
        self
    }

    /// A vacuum that pulls the object onto the contact with this force, N, from 0: against the normal, whatever object and finger do.
    /// What presses is the lip, with this force less what pulls at the object. See [`SuctionCup`](super::SuctionCup), whose lip is a ring.
    #[must_use]
    pub fn suction(mut self, force: f64) -> Self {
        self.suction = force;
        self
    }

    /// A name for messages and tables.
    #[must_use]
    pub fn name(mut self, name: impl Into<String>) -> Self {
        self.name = Some(name.into().into());
        self
    }

    /// Direction of the first tangent; its part along the normal is dropped. In the plane it only
    /// chooses between the two signs of t. Without it: `(n_y, -n_x)` in the plane, and in space the
    /// projection of the coordinate axis that is farthest from the normal.
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
    #[must_use]
    pub fn tangent(mut self, tangent: impl Into<[f64; C]>) -> Self {
        self.tangent = Some(SVector::from(tangent.into()));
        self
    }

    /// Coefficient of friction μ >= 0. With 0 (the default) the contact has no tangential spring at
    /// all, whatever tangential stiffness was given; with `f64::INFINITY` it never slides while it
    /// is closed. A [bonded](Self::bonded) contact has its tangential springs whatever μ is.
    #[must_use]
    pub fn friction(mut self, mu: f64) -> Self {
        self.friction = mu;
        self
    }

    /// Coefficient of friction while the contact slides, from a millionth of [that at rest](Self::friction) up to all of it. As soon as the contact begins
    /// to slide its friction falls to that, at one load: other contacts catch the object, or it is lost. Once it is at rest again it has friction of rest.
    ///
    /// The answer is the **overdamped** one: the object comes to rest where forces balance again, without overshoot. One that is not damped shoots over, up
    /// to twice as far, and may be lost where this one is caught. See the [guide](crate::guide::kinetic_friction).
    ///
    /// [`follow`](crate::ask::Grasp::follow), [`hold`](crate::ask::Grasp::hold), [`shake`](crate::ask::Grasp::shake) and needs that are to
    /// [hold](crate::need::Need::to_hold) or to [rest](crate::need::Need::to_rest) count with it. The first slip does not depend on it. [`solve`](crate::ask::Grasp::solve),
    /// [`follow_patch`](crate::ask::Grasp::follow_patch) and [`follow_in_steps`](crate::ask::Grasp::follow_in_steps) refuse what they would have to tell of
    /// a contact that slides. All other questions are about contacts at rest.
    ///
    /// ```
    /// use grasp_lcp::planar::{Contact, Grasp, Wrench};
    ///
    /// // Two feet that press with 10 N share a pull. The stiff one begins to slide at 7.5 N and keeps 4 N; the other one catches 3.5 N.
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
    #[must_use]
    pub fn kinetic(mut self, mu: f64) -> Self {
        self.kinetic = Some(mu);
        self
    }

    /// The contact never opens; see [`Hold::KeptClosed`].
    ///
    /// ```
    /// use grasp_lcp::planar::{Contact, Grasp, Wrench};
    ///
    /// // A carriage on a rail that goes around its wheels: pulled up by 3 N it is held down.
    /// let wheel = |x: f64, mu: f64| Contact::new([x, 0.0], [0.0, 1.0]).series_stiffness(1e3, 1e3).friction(mu).kept_closed();
    /// let pull = Wrench::force([0.0, 3.0]);
    /// let outcome = Grasp::new([wheel(-1.0, 0.0), wheel(1.0, 0.0)])?.solve(&pull)?;
    /// let held = outcome.equilibrium().expect("the rail holds");
    /// assert!((held.contacts[0].normal_force() + 1.5).abs() < 1e-14);
    ///
    /// // With finite friction a normal force must push: |F_t| <= μ F_n.
    /// assert!(Grasp::new([wheel(-1.0, 0.2), wheel(1.0, 0.2)])?.solve(&pull)?.equilibrium().is_none());
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    #[must_use]
    pub fn kept_closed(mut self) -> Self {
        self.hold = Hold::KeptClosed;
        self
    }

    /// The contact is glued; see [`Hold::Bonded`].
    #[must_use]
    pub fn bonded(mut self) -> Self {
        self.hold = Hold::Bonded;
        self
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

    /// Coefficient of friction while the contact slides; that at rest unless another one [was given](Self::kinetic).
    #[must_use]
    pub fn kinetic_coefficient(&self) -> f64 {
        self.kinetic.unwrap_or(self.friction)
    }

    /// With this coefficient of friction at rest, and that of sliding in proportion.
    pub(crate) fn set_friction(&mut self, mu: f64) {
        let proportion = mu / self.friction;
        self.kinetic = self
            .kinetic
            .map(|kinetic| kinetic * proportion)
            .filter(|kinetic| kinetic.is_finite() && *kinetic > 0.0);
        self.friction = mu;
    }

    /// Number of axes along which the contact has a spring: 1 without friction, else `C`.
    pub(crate) fn springs(&self) -> usize {
        if self.friction == 0.0 && self.hold != Hold::Bonded { 1 } else { C }
    }

    /// How tables and pictures call the contact: its name, or "contact" and `index`, its place in
    /// the list.
    #[must_use]
    pub fn label_text(&self, index: usize) -> String {
        self.label(index).text()
    }

    /// How messages speak of it: "contact 1 (thumb)", of a link "hinge "pin"".
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
