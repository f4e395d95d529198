//! Links of bodies with each other and with the ground.

use alloc::sync::Arc;

use nalgebra::SVector;

use crate::prelude::*;
use crate::words::LinkKind;

/// A link between two bodies, or between a body and the ground: a hinge, a slide, a rigid joint, a spring, a cable.
///
/// It is modelled by contacts that never open, a cable by one contact that only pulls; questions and methods stay the same, and answers report the
/// link as one part. It neither slips nor breaks. It is as compliant as its [stiffness](Self::stiffness) says.
///
/// | link | leaves free | carries |
/// |---|---|---|
/// | [`hinge`](Link::hinge) in the plane, `ball` in space | turning | forces |
/// | `hinge` in space | turning about its axis | forces, moments across the axis |
/// | `slide` | moving along its direction | forces across it, moments |
/// | `rigid` | nothing | forces, moments |
/// | [`spring`](Self::spring) | all but its length | a pull or a push along it |
/// | [`cable`](Self::cable) | all but its length | a pull along it, until it goes slack |
///
/// ```
/// use grasp_lcp::planar::{Bodies, Body, Contact, Link, Wrench};
///
/// // A lever on a hinge is pressed down at 0.3 m, and presses with its nose at 0.1 m on a plate, which is pulled: μ = 0.4 above and below.
/// let clamp = Bodies::new([
///     Body::new("plate"),
///     Body::new("lever").load(Wrench::force_at([0.0, -50.0], [0.3, 0.02])),
/// ])
/// .links([Link::hinge([0.0, 0.02]).name("pin").to_ground("lever")])
/// .contacts([
///     Contact::new([0.1, 0.0], [0.0, 1.0]).series_stiffness(1e6, 1e6).friction(0.4).on("plate").name("bed"),
///     Contact::new([0.1, 0.01], [0.0, -1.0]).series_stiffness(1e6, 1e6).friction(0.4).on("plate").against("lever").name("nose"),
/// ])
/// .grasp()?;
/// // The pull lifts the nose by its friction, which acts 10 mm below the pin: N 0.1 = 50 · 0.3 - 0.4 N 0.01.
/// let verdict = clamp.hold(Wrench::force_at([200.0, 0.0], [0.1, 0.005]))?;
/// let nose = 15.0 / 0.104;
/// assert!((200.0 * verdict.lost.expect("pulled out").factor - 2.0 * 0.4 * nose).abs() < 1e-9);
/// # Ok::<(), grasp_lcp::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Link<const C: usize> {
    pub(crate) name: Option<Arc<str>>,
    pub(crate) place: LinkPlace<C>,
    pub(crate) on: Option<Arc<str>>,
    pub(crate) against: Option<Arc<str>>,
    pub(crate) stiffness: Option<f64>,
    pub(crate) pretension: f64,
    /// What it pulls with at rest once it is installed, in place of the pretension.
    pub(crate) tension: Option<f64>,
    pub(crate) slack: f64,
}

/// Place of a link, and the motion that it leaves free.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum LinkPlace<const C: usize> {
    /// In space an axis of any length, and the distance between its two bearings, m.
    Hinge {
        point: SVector<f64, C>,
        bearings: Option<(SVector<f64, C>, f64)>,
    },
    Ball {
        point: SVector<f64, C>,
    },
    /// A direction of any length, and the distance between its bearings, m.
    Slide {
        point: SVector<f64, C>,
        direction: SVector<f64, C>,
        length: f64,
    },
    /// Diameter of the circle or sphere of the points that carry moments, m.
    Rigid {
        point: SVector<f64, C>,
        size: f64,
    },
    /// From a point of the first body to a point of the other body, or of the ground.
    Spring {
        from: SVector<f64, C>,
        to: SVector<f64, C>,
    },
    Cable {
        from: SVector<f64, C>,
        to: SVector<f64, C>,
    },
}

impl<const C: usize> LinkPlace<C> {
    pub(crate) fn kind(&self) -> LinkKind {
        match self {
            Self::Hinge { .. } => LinkKind::Hinge,
            Self::Ball { .. } => LinkKind::Ball,
            Self::Slide { .. } => LinkKind::Slide,
            Self::Rigid { .. } => LinkKind::Rigid,
            Self::Spring { .. } => LinkKind::Spring,
            Self::Cable { .. } => LinkKind::Cable,
        }
    }
}

impl Link<2> {
    /// A hinge at this point, m.
    pub fn hinge(point: impl Into<[f64; 2]>) -> Self {
        Self::at(LinkPlace::Hinge { point: SVector::from(point.into()), bearings: None })
    }
}

impl Link<3> {
    /// A hinge about an axis through this point, m, with two bearings at the distance `length`, m, on both sides of it. They share the load, and so
    /// carry moments across the axis.
    pub fn hinge(point: impl Into<[f64; 3]>, axis: impl Into<[f64; 3]>, length: f64) -> Self {
        let bearings = Some((SVector::from(axis.into()), length));
        Self::at(LinkPlace::Hinge { point: SVector::from(point.into()), bearings })
    }

    /// A ball joint at this point, m.
    pub fn ball(point: impl Into<[f64; 3]>) -> Self {
        Self::at(LinkPlace::Ball { point: SVector::from(point.into()) })
    }
}

impl<const C: usize> Link<C> {
    /// Default [stiffness](Self::stiffness) of a link, N/m: stiff compared with most fingers and objects.
    pub const STIFF: f64 = 1e9;

    pub(crate) fn at(place: LinkPlace<C>) -> Self {
        let (name, on, against, stiffness, tension) = (None, None, None, None, None);
        Self { name, place, on, against, stiffness, pretension: 0.0, tension, slack: 0.0 }
    }

    /// A slide: the bodies move relative to each other along this direction alone. Its bearings are `length` apart, m, on both sides of this point.
    pub fn slide(point: impl Into<[f64; C]>, direction: impl Into<[f64; C]>, length: f64) -> Self {
        let (point, direction) = (SVector::from(point.into()), SVector::from(direction.into()));
        Self::at(LinkPlace::Slide { point, direction, length })
    }

    /// A rigid joint: a weld or a screwed flange of diameter `size`, m, about this point.
    pub fn rigid(point: impl Into<[f64; C]>, size: f64) -> Self {
        Self::at(LinkPlace::Rigid { point: SVector::from(point.into()), size })
    }

    /// A spring of this stiffness, N/m, from a point of the first body to a point of the second, or of the ground, m.
    pub fn spring(from: impl Into<[f64; C]>, to: impl Into<[f64; C]>, stiffness: f64) -> Self {
        let (from, to) = (SVector::from(from.into()), SVector::from(to.into()));
        Self::at(LinkPlace::Spring { from, to }).stiffness(stiffness)
    }

    /// A cable or rope from a point of the first body to a point of the second, or of the ground, m. It only pulls, along the line between both
    /// points. To first order, like everything here, this line does not turn with the bodies.
    ///
    /// ```
    /// use grasp_lcp::planar::{Grasp, Link, Wrench};
    ///
    /// // A lamp of 30 N on two ropes under 45°; they meet in one point.
    /// let rope = |x: f64, name: &str| Link::cable([0.0, 0.0], [x, 1.0]).name(name).contacts();
    /// let lamp = Grasp::new([rope(-1.0, "left")?, rope(1.0, "right")?].concat())?;
    /// let hangs = lamp.solve(Wrench::force([0.0, -30.0]))?;
    /// let told = hangs.to_string();
    /// assert!(told.contains("left pulls with 21.2132 N"), "{told}");
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    pub fn cable(from: impl Into<[f64; C]>, to: impl Into<[f64; C]>) -> Self {
        Self::at(LinkPlace::Cable { from: SVector::from(from.into()), to: SVector::from(to.into()) })
    }

    /// A name for messages and tables; without one a link is named after its kind.
    #[must_use]
    pub fn name(mut self, name: impl Into<String>) -> Self {
        self.name = Some(name.into().into());
        self
    }

    /// The two bodies that the link joins. A spring or a cable begins at the first and ends at the second.
    #[must_use]
    pub fn between(mut self, one: impl Into<String>, other: impl Into<String>) -> Self {
        (self.on, self.against) = (Some(one.into().into()), Some(other.into().into()));
        self
    }

    /// The body that the link joins to the ground.
    #[must_use]
    pub fn to_ground(mut self, body: impl Into<String>) -> Self {
        (self.on, self.against) = (Some(body.into().into()), None);
        self
    }

    /// Stiffness of all its points together along each direction that it blocks, N/m; [`Self::STIFF`] by default.
    #[must_use]
    pub fn stiffness(mut self, stiffness: f64) -> Self {
        self.stiffness = Some(stiffness);
        self
    }

    /// Pull of a cable or a spring before anything moves, N; below zero a spring pushes. At rest the pull is smaller, since the bodies give way; see
    /// [`Self::tension`].
    #[must_use]
    pub fn pretension(mut self, force: f64) -> Self {
        (self.pretension, self.tension) = (force, None);
        self
    }

    /// What a cable or a spring pulls with once it is installed, N, in place of a pretension: at rest, under what always acts on bodies and without other
    /// load, when all else has given way. The grasp that it becomes part of finds the pretension for it, or refuses it where nothing holds against such a pull.
    ///
    /// ```
    /// use grasp_lcp::planar::{Bodies, Body, Contact, Link, Wrench};
    ///
    /// // A belt is tightened over a crate until it pulls it onto the floor with 100 N; the floor gives way as much as the belt.
    /// let crated = Bodies::new([Body::new("crate")])
    ///     .contacts([Contact::new([0.0, 0.0], [0.0, 1.0]).series_stiffness(1e4, 1e4).friction(0.5).on("crate")])
    ///     .links([Link::cable([0.0, 1.0], [0.0, 0.0]).stiffness(1e4).tension(100.0).to_ground("crate")])
    ///     .grasp()?;
    /// let state = crated.solve(Wrench::ZERO)?;
    /// assert!((state.equilibrium().expect("lies").contacts[0].normal_force() - 100.0).abs() < 1e-9);
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    #[must_use]
    pub fn tension(mut self, force: f64) -> Self {
        (self.tension, self.pretension) = (Some(force), force);
        self
    }

    /// Length of a cable in excess of the distance between its ends, m.
    #[must_use]
    pub fn slack(mut self, length: f64) -> Self {
        self.slack = length;
        self
    }

    /// Its name, or its kind and its number.
    pub(crate) fn called(&self, number: usize) -> String {
        self.name.as_deref().map_or_else(|| format!("{} {number}", self.kind().name()), str::to_owned)
    }

    /// The kind of the link.
    #[must_use]
    pub fn kind(&self) -> LinkKind {
        self.place.kind()
    }
}
