//! Links of bodies with each other or with the ground.

use alloc::sync::Arc;

use nalgebra::SVector;

use crate::prelude::*;
use crate::words::LinkKind;

/// A link between two bodies, or between a body and the ground: a hinge, a slide, a rigid joint, a spring, a cable.
///
/// A link is modelled by contacts that never open, a cable by one contact that only pulls. Questions and methods stay the same, and answers count
/// all contacts of a link as one contact. A link neither slips nor breaks, and is as compliant as its [stiffness](Self::stiffness).
///
/// | link | free motion | carries |
/// |---|---|---|
/// | [`hinge`](Link::hinge) in the plane, `ball` in space | rotation | forces |
/// | `hinge` in space | rotation about its axis | forces, moments across the axis |
/// | `slide` | translation along its direction | forces across it, moments |
/// | `rigid` | none | forces, moments |
/// | [`spring`](Self::spring) | all except change of its length | a pull or a push along it |
/// | [`cable`](Self::cable) | all except extension | a pull along it, until it goes slack |
///
/// ```
/// use grasp_lcp::planar::{Bodies, Body, Contact, Link, Wrench};
///
/// // A lever on a hinge is pressed down 0.3 m from the hinge. Its nose presses at 0.1 m on a plate, which is pulled; μ = 0.4 on both faces.
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
/// // Friction at the nose acts 10 mm below the pin and reduces the normal force N there: N 0.1 = 50 · 0.3 - 0.4 N 0.01.
/// let verdict = clamp.hold(Wrench::force_at([200.0, 0.0], [0.1, 0.005]))?;
/// let nose = 15.0 / 0.104;
/// assert!((200.0 * verdict.lost.expect("pulled out").factor - 2.0 * 0.4 * nose).abs() < 1e-9);
/// # Ok::<(), grasp_lcp::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
#[must_use]
pub struct Link<const C: usize> {
    pub(crate) name: Option<Arc<str>>,
    pub(crate) geometry: LinkGeometry<C>,
    pub(crate) on: Option<Arc<str>>,
    pub(crate) against: Option<Arc<str>>,
    pub(crate) stiffness: Option<f64>,
    pub(crate) pretension: f64,
    /// Pull of a cable or spring in the equilibrium under the constant loads alone, after all springs have deflected, N. This pull replaces the
    /// pretension; `None` if a pretension is given.
    pub(crate) tension: Option<f64>,
    pub(crate) slack: f64,
}

/// Kind of a link, with the points, directions and lengths that define it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum LinkGeometry<const C: usize> {
    /// A hinge. In space `bearings` holds its axis, a vector of any length, and the distance between its two bearings, m. In the plane `bearings` is
    /// `None`.
    Hinge {
        point: SVector<f64, C>,
        bearings: Option<(SVector<f64, C>, f64)>,
    },
    Ball {
        point: SVector<f64, C>,
    },
    /// A slide along a direction of any length; `length` is the distance between its bearings, m.
    Slide {
        point: SVector<f64, C>,
        direction: SVector<f64, C>,
        length: f64,
    },
    /// A rigid joint; `size` is the diameter of the circle or sphere on which its points lie, m.
    Rigid {
        point: SVector<f64, C>,
        size: f64,
    },
    /// A spring from a point of the first body to a point of the other body, or of the ground, m.
    Spring {
        from: SVector<f64, C>,
        to: SVector<f64, C>,
    },
    Cable {
        from: SVector<f64, C>,
        to: SVector<f64, C>,
    },
}

impl<const C: usize> LinkGeometry<C> {
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
    /// A hinge of the plane at this point, m.
    pub fn hinge(point: impl Into<[f64; 2]>) -> Self {
        Self::at(LinkGeometry::Hinge { point: SVector::from(point.into()), bearings: None })
    }
}

impl Link<3> {
    /// A hinge about an axis through this point, m. Its two bearings are `length` apart, m, with this point in the middle. The bearings share the
    /// load, and thus carry moments across the axis.
    pub fn hinge(point: impl Into<[f64; 3]>, axis: impl Into<[f64; 3]>, length: f64) -> Self {
        let bearings = Some((SVector::from(axis.into()), length));
        Self::at(LinkGeometry::Hinge { point: SVector::from(point.into()), bearings })
    }

    /// A ball joint at this point, m.
    pub fn ball(point: impl Into<[f64; 3]>) -> Self {
        Self::at(LinkGeometry::Ball { point: SVector::from(point.into()) })
    }
}

impl<const C: usize> Link<C> {
    /// Default [stiffness](Self::stiffness) of a link, N/m: high compared with most fingers and objects.
    pub const STIFF: f64 = 1e9;

    pub(crate) fn at(geometry: LinkGeometry<C>) -> Self {
        let (name, on, against, stiffness, tension) = (None, None, None, None, None);
        Self { name, geometry, on, against, stiffness, pretension: 0.0, tension, slack: 0.0 }
    }

    /// A slide: relative motion of the bodies is only possible along this direction. The bearings of the slide are `length` apart, m, with this point
    /// in the middle.
    pub fn slide(point: impl Into<[f64; C]>, direction: impl Into<[f64; C]>, length: f64) -> Self {
        let (point, direction) = (SVector::from(point.into()), SVector::from(direction.into()));
        Self::at(LinkGeometry::Slide { point, direction, length })
    }

    /// A rigid joint of diameter `size`, m, centred at this point, such as a weld or a bolted flange.
    pub fn rigid(point: impl Into<[f64; C]>, size: f64) -> Self {
        Self::at(LinkGeometry::Rigid { point: SVector::from(point.into()), size })
    }

    /// A spring of this stiffness, N/m, from a point of the first body to a point of the second, or of the ground, m.
    pub fn spring(from: impl Into<[f64; C]>, to: impl Into<[f64; C]>, stiffness: f64) -> Self {
        let (from, to) = (SVector::from(from.into()), SVector::from(to.into()));
        Self::at(LinkGeometry::Spring { from, to }).stiffness(stiffness)
    }

    /// A cable or rope from a point of the first body to a point of the second, or of the ground, m. A cable only pulls, along the line between the
    /// two points. In this first-order model the line does not turn with the bodies.
    ///
    /// ```
    /// use grasp_lcp::planar::{Grasp, Link, Wrench};
    ///
    /// // A lamp of 30 N hangs from two ropes at 45°, which meet in one point.
    /// let rope = |x: f64, name: &str| Link::cable([0.0, 0.0], [x, 1.0]).name(name).contacts();
    /// let lamp = Grasp::new([rope(-1.0, "left")?, rope(1.0, "right")?].concat())?;
    /// let hangs = lamp.solve(Wrench::force([0.0, -30.0]))?;
    /// let told = hangs.to_string();
    /// assert!(told.contains("left pulls with 21.2132 N"), "{told}");
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    pub fn cable(from: impl Into<[f64; C]>, to: impl Into<[f64; C]>) -> Self {
        Self::at(LinkGeometry::Cable { from: SVector::from(from.into()), to: SVector::from(to.into()) })
    }

    setters! {
        /// Sets the name for messages and tables; the default is the kind of the link.
        pub fn name(mut self, name: impl Into<String>) { self.name = Some(name.into().into()); }

        /// Sets the two bodies that the link joins. A spring or a cable starts at the first and ends at the second.
        pub fn between(mut self, one: impl Into<String>, other: impl Into<String>) {
            (self.on, self.against) = (Some(one.into().into()), Some(other.into().into()));
        }

        /// Sets the body that the link joins to the ground.
        pub fn to_ground(mut self, body: impl Into<String>) {
            (self.on, self.against) = (Some(body.into().into()), None);
        }

        /// Sets the total stiffness of all contacts that model the link, along each direction that the link blocks, N/m; [`Self::STIFF`] by default.
        pub fn stiffness(mut self, stiffness: f64) { self.stiffness = Some(stiffness); }

        /// Sets the pull of a cable or a spring before anything moves, N; a spring with a negative value pushes. Once all springs have deflected, the
        /// pull is smaller; [`Self::tension`] sets the smaller value instead.
        pub fn pretension(mut self, force: f64) { (self.pretension, self.tension) = (force, None); }

        /// Sets the pull of an installed cable or spring, N, in place of a pretension. This pull is the force under the constant loads on bodies
        /// alone, after all other springs have deflected. The grasp computes the pretension that leads to it, or refuses the link if nothing resists
        /// such a pull.
        ///
        /// ```
        /// use grasp_lcp::planar::{Bodies, Body, Contact, Link, Wrench};
        ///
        /// // A belt over a crate is tightened until it pulls the crate onto the floor with 100 N; the floor is as compliant as the belt.
        /// let crated = Bodies::new([Body::new("crate")])
        ///     .contacts([Contact::new([0.0, 0.0], [0.0, 1.0]).series_stiffness(1e4, 1e4).friction(0.5).on("crate")])
        ///     .links([Link::cable([0.0, 1.0], [0.0, 0.0]).stiffness(1e4).tension(100.0).to_ground("crate")])
        ///     .grasp()?;
        /// let state = crated.solve(Wrench::ZERO)?;
        /// assert!((state.equilibrium().expect("lies").contacts[0].normal_force() - 100.0).abs() < 1e-9);
        /// # Ok::<(), grasp_lcp::Error>(())
        /// ```
        pub fn tension(mut self, force: f64) { (self.tension, self.pretension) = (Some(force), force); }

        /// Sets the length of a cable in excess of the distance between its ends, m.
        pub fn slack(mut self, length: f64) { self.slack = length; }
    }

    /// The name that the user gave or, without one, the kind of the link with its number.
    pub(crate) fn called(&self, number: usize) -> String {
        self.name.as_deref().map_or_else(|| format!("{} {number}", self.kind().name()), str::to_owned)
    }

    /// The kind of the link.
    #[must_use]
    pub fn kind(&self) -> LinkKind {
        self.geometry.kind()
    }
}
