//! A body carried by an arm, and the load that it exerts while the arm accelerates and turns.

use nalgebra::{Matrix3, Vector3};

use super::face::Face;
use super::points_of_action::PointsOfAction;
use super::wrench::Wrench;
use crate::error::{Error, MODERATE, is_moderate};
use crate::numerics::{Space, by_axis};

/// Standard gravity, rounded, m/s².
const GRAVITY: f64 = 9.81;

/// A body with a mass that is carried by an arm. [`Self::load`] is the load that the body exerts on the grasp which holds it.
///
/// The body has the mass m, the centre of mass c and the moment of inertia I about c. The arm's point p has the acceleration a; the arm turns about p
/// with the angular velocity ω and the angular acceleration α. With gravity g and the acceleration a_c of the centre of mass, the load is the weight
/// less the inertial force:
///
/// ```text
/// a_c = a + α × r + ω × (ω × r),  r = c - p        force m (g - a_c) at c,  moment -(I α + ω × I ω)
/// ```
///
/// Axes and reference point of the moments are the axes and the origin of the grasp at that instant.
///
/// ```
/// use grasp_lcp::planar::{ArmMotion, Payload, Wrench};
///
/// // 0.5 kg, half a metre out on an arm that turns at 2 rad/s: 0.5 kg · (2 rad/s)² · 0.5 m outwards, beside the weight.
/// let body = Payload::new(0.5, [0.5, 0.0]);
/// let steady = ArmMotion::turning([0.0, 0.0], 2.0, 0.0);
/// assert_eq!(body.load(&steady)?, Wrench::force_at([1.0, -0.5 * 9.81], [0.5, 0.0]));
///
/// // While the arm speeds up, the body's own inertia counts: m L²/12 about its middle for a bar of length L = 0.2 m.
/// let speeding = ArmMotion::turning([0.0, 0.0], 0.0, 3.0);
/// let refused = body.load(&speeding).unwrap_err();
/// assert!(refused.to_string().starts_with("payload: inertia is missing"), "{refused}");
/// let bar = body.inertia(0.5 * 0.2 * 0.2 / 12.0).load(&speeding)?;
/// assert!((bar.about([0.5, 0.0]).moment() + 0.5 * 0.2 * 0.2 / 12.0 * 3.0).abs() < 1e-15);
/// # Ok::<(), grasp_lcp::Error>(())
/// ```
#[doc(alias = "mass")]
#[doc(alias = "inertia")]
#[derive(Debug, Clone, Copy, PartialEq)]
#[must_use]
pub struct Payload<const C: usize> {
    mass: f64,
    centre: Vector3<f64>,
    /// Inertia matrix about the centre of mass, kg m²; the plane uses only its last diagonal entry.
    inertia: Option<Matrix3<f64>>,
}

/// What determines the load of a body that an arm carries, at one instant: gravity, the acceleration of one point of the arm, and the angular
/// velocity and angular acceleration of the arm.
#[derive(Debug, Clone, Copy, PartialEq)]
#[must_use]
pub struct ArmMotion<const C: usize> {
    gravity: Vector3<f64>,
    acceleration: Vector3<f64>,
    about: Vector3<f64>,
    angular_velocity: Vector3<f64>,
    angular_acceleration: Vector3<f64>,
}

fn of_space<const C: usize>(v: [f64; C]) -> Vector3<f64> {
    by_axis(|a| v.get(a).copied().unwrap_or(0.0))
}

impl<const C: usize> Payload<C> {
    /// A body of this mass, kg, with its centre of mass at `centre`, m.
    pub fn new(mass: f64, centre: impl Into<[f64; C]>) -> Self {
        Self { mass, centre: of_space(centre.into()), inertia: None }
    }

    /// Load of the body on its grasp during this motion of the arm.
    ///
    /// # Errors
    /// [`Error::Argument`] unless the mass is from 0 to 1e50, and for a motion or an inertia that is not finite or too large.
    /// [`Error::Question`] if the moment of inertia is missing but needed: for an angular acceleration, and in space for any rotation.
    /// [`Error::Wrench`] for a load that overflows.
    pub fn load(&self, arm: &ArmMotion<C>) -> Result<Wrench<C>, Error> {
        let Self { mass, centre, inertia } = *self;
        let ArmMotion { gravity, acceleration, about, angular_velocity, angular_acceleration } = *arm;
        let arm = ArmMotion { gravity, acceleration, about, angular_velocity, angular_acceleration };
        Payload { mass, centre, inertia }.load_in(Space::of::<C>(), &arm).map(Wrench::from_inside)
    }
}

impl Payload<3> {
    /// Load of the body on its grasp during this motion of the arm, in the plane or in space; vectors have three components.
    pub(crate) fn load_in(&self, space: Space, arm: &ArmMotion<3>) -> Result<Wrench<3>, Error> {
        arm.check()?;
        if !(self.mass >= 0.0 && is_moderate(self.mass)) {
            return Err(Error::Argument {
                what: "mass of the payload",
                value: self.mass,
                allowed: "from 0 to 1e50",
            });
        }
        if let Some(value) =
            self.inertia.and_then(|inertia| inertia.as_slice().iter().find(|x| !is_moderate(**x)).copied())
        {
            return Err(Error::Argument { what: "inertia of the payload", value, allowed: MODERATE });
        }
        let ArmMotion { gravity, acceleration, about, angular_velocity: omega, angular_acceleration: alpha } =
            arm;
        let arm_length = self.centre - about;
        let centre_accelerates =
            acceleration + alpha.cross(&arm_length) + omega.cross(&omega.cross(&arm_length));
        let force = (gravity - centre_accelerates) * self.mass;
        let spin = match self.inertia {
            Some(inertia) => inertia * alpha + omega.cross(&(inertia * omega)),
            // Rotation in the plane has a fixed axis and therefore no gyroscopic moment.
            None if *alpha == Vector3::zeros() && (space == Space::Planar || *omega == Vector3::zeros()) => {
                Vector3::zeros()
            }
            None => {
                let fault = "is missing, must be given where the arm turns: about the centre of mass, kg m², zero for a body that is small beside its arm";
                return Err(Error::Question { question: "payload", field: "inertia", fault });
            }
        };
        let moment = self.centre.cross(&force) - spin;
        let all = Wrench::<3>::from_components(&[force.as_slice(), moment.as_slice()].concat());
        let points = PointsOfAction::of(&force, &self.centre);
        let load = Wrench::among(space, &all.coordinates(space)).acting_at(points);
        load.check_in(space, "load of the payload").map(|()| load)
    }
}

impl<const C: usize> Payload<C> {
    /// Sets the principal moments of inertia, kg m², about axes through the centre of mass along x, y and z. These axes must be principal axes.
    /// The plane uses only the last moment.
    pub fn of_inertia(mut self, axes: [f64; 3]) -> Self {
        self.inertia = Some(Matrix3::from_diagonal(&axes.into()));
        self
    }
}

impl Payload<2> {
    /// Sets the moment of inertia about the centre of mass, kg m².
    pub fn inertia(self, inertia: f64) -> Self {
        self.of_inertia([0.0, 0.0, inertia])
    }
}

impl Payload<3> {
    /// Sets the principal moments of inertia, kg m², about axes through the centre of mass along the coordinate axes, which must be principal
    /// axes.
    pub fn inertia(self, axes: impl Into<[f64; 3]>) -> Self {
        self.of_inertia(axes.into())
    }

    /// Sets the inertia matrix about the centre of mass, kg m², row by row.
    pub fn inertia_matrix(mut self, rows: impl Into<[[f64; 3]; 3]>) -> Self {
        self.inertia = Some(Matrix3::from(rows.into()).transpose());
        self
    }
}

impl<const C: usize> Default for ArmMotion<C> {
    fn default() -> Self {
        Self::still()
    }
}

impl<const C: usize> ArmMotion<C> {
    /// An arm that stands still. Gravity is 9.81 m/s² down the last axis.
    pub fn still() -> Self {
        Self::still_in(Space::of::<C>())
    }

    /// An arm that stands still, in the plane or in space. Gravity is 9.81 m/s² down the last axis.
    pub(crate) fn still_in(space: Space) -> Self {
        let zeros = Vector3::zeros();
        let mut gravity = zeros;
        gravity[space.axes() - 1] = -GRAVITY;
        Self {
            gravity,
            acceleration: zeros,
            about: zeros,
            angular_velocity: zeros,
            angular_acceleration: zeros,
        }
    }

    setters! {
        /// Sets the vector of gravity, m/s²; the default is 9.81 m/s² down the last axis.
        pub fn gravity(mut self, gravity: impl Into<[f64; C]>) { self.gravity = of_space(gravity.into()); }

        /// Sets the acceleration of the arm, m/s². If the arm turns, it is the acceleration of the point about which the arm turns.
        pub fn accelerated(mut self, acceleration: impl Into<[f64; C]>) {
            self.acceleration = of_space(acceleration.into());
        }
    }

    /// Adds a rotation about a point, m. Angular velocity, rad/s, and angular acceleration, rad/s², have three components; the plane uses only
    /// the last.
    pub fn and_turning(
        mut self,
        about: impl Into<[f64; C]>,
        velocity: [f64; 3],
        acceleration: [f64; 3],
    ) -> Self {
        let turns = |axes: [f64; 3]| if C == 2 { Vector3::new(0.0, 0.0, axes[2]) } else { axes.into() };
        self.about = of_space(about.into());
        (self.angular_velocity, self.angular_acceleration) = (turns(velocity), turns(acceleration));
        self
    }

    /// Returns an error for numbers that are not finite or too large.
    fn check(&self) -> Result<(), Error> {
        let all = [
            ("gravity", &self.gravity),
            ("acceleration of the arm", &self.acceleration),
            ("point that the arm turns about", &self.about),
            ("angular velocity of the arm", &self.angular_velocity),
            ("angular acceleration of the arm", &self.angular_acceleration),
        ];
        for (what, vector) in all {
            if let Some(value) = vector.iter().copied().find(|x| !is_moderate(*x)) {
                return Err(Error::Argument { what, value, allowed: MODERATE });
            }
        }
        Ok(())
    }
}

impl ArmMotion<2> {
    /// An arm that turns about a point, m, with an angular velocity, rad/s, and an angular acceleration, rad/s², positive from x to y.
    pub fn turning(about: impl Into<[f64; 2]>, velocity: f64, acceleration: f64) -> Self {
        Self::still().and_turning(about, [0.0, 0.0, velocity], [0.0, 0.0, acceleration])
    }
}

impl ArmMotion<3> {
    /// An arm that turns about a point, m, with an angular velocity, rad/s, and an angular acceleration, rad/s². Both are vectors along the axis
    /// of rotation, by the right-hand rule.
    pub fn turning(
        about: impl Into<[f64; 3]>,
        velocity: impl Into<[f64; 3]>,
        acceleration: impl Into<[f64; 3]>,
    ) -> Self {
        Self::still().and_turning(about, velocity.into(), acceleration.into())
    }
}
