//! Conversion of a twist, a motion to first order, to a finite rigid motion and back.
//!
//! The conversion is the exponential map: the object moves along a screw of constant pitch for one unit of time, and its velocity is the twist. Let
//! R(θ) be the rotation by the rotation vector θ. With the translation u of the origin, its component u∥ along θ and its component u⊥ across θ,
//!
//! ```text
//! rotation     R(θ)
//! translation  R(θ/2) (s u⊥ + u∥),      s = sin(|θ|/2) / (|θ|/2)   (chord over arc)
//! ```
//!
//! Any other rigid motion that agrees with the twist to first order differs from the exponential map to second order, which first-order answers do
//! not determine. The exponential map does not depend on the frame: a pure rotation about a pivot remains a pure rotation about this pivot for every
//! choice of the origin.
//!
//! Nothing in the library calls these functions. Since they are marked `inline`, only a program that calls them compiles them and nalgebra's
//! quaternions.

use nalgebra::{
    ComplexField, Isometry2, Isometry3, Quaternion, SVector, UnitComplex, UnitQuaternion, Vector3,
};

use super::wrench::Twist;

impl Twist<2> {
    /// The rigid motion of this twist, by the exponential map. The twist has the translation u of the origin and the rotation θ. The object turns by
    /// θ, and its origin moves by `s R(θ/2) u`. Here R(θ/2) is the rotation by half the angle, and `s = sin(|θ|/2) / (|θ|/2)` the ratio of chord to
    /// arc. Other rigid motions that agree with the twist to first order differ from the exponential map only to second order. The exponential map
    /// turns the object about a single pivot, which does not depend on the choice of the origin.
    ///
    /// ```
    /// use grasp_lcp::{nalgebra::Point2, planar::Twist};
    ///
    /// // A quarter turn about the pivot (1, 2).
    /// let angle = std::f64::consts::FRAC_PI_2;
    /// let motion = Twist::new([2.0 * angle, -angle], angle).exp();
    /// assert!((motion * Point2::new(1.0, 2.0) - Point2::new(1.0, 2.0)).norm() < 1e-15);
    /// assert!((motion * Point2::new(2.0, 2.0) - Point2::new(1.0, 3.0)).norm() < 1e-15);
    /// ```
    #[doc(alias = "isometry")]
    #[must_use]
    #[inline]
    pub fn exp(&self) -> Isometry2<f64> {
        let half = 0.5 * self.rotation();
        let translation = UnitComplex::new(half) * SVector::from(self.translation()) * half.sinc();
        Isometry2::new(translation, self.rotation())
    }

    /// The twist of a rigid motion, with a rotation from -π to π: the inverse of [`Self::exp`].
    ///
    /// ```
    /// use grasp_lcp::{nalgebra::Isometry2, planar::Twist};
    ///
    /// let twist = Twist::new([0.3, -0.1], 0.5);
    /// let back = Twist::log(&twist.exp());
    /// assert!((back - twist).to_vector().norm() < 1e-15);
    /// assert_eq!(Twist::log(&Isometry2::translation(2.0, 1.0)), Twist::new([2.0, 1.0], 0.0));
    /// ```
    #[inline]
    pub fn log(motion: &Isometry2<f64>) -> Self {
        let half = 0.5 * motion.rotation.angle();
        let translation = UnitComplex::new(-half) * motion.translation.vector / half.sinc();
        Self::new(translation, motion.rotation.angle())
    }
}

impl Twist<3> {
    /// The rigid motion of this twist, by the exponential map. The twist has the rotation vector θ and the translation u of the origin, with the
    /// component u∥ along θ and u⊥ across. The object turns by |θ| about θ, and its origin moves by `R(θ/2) (s u⊥ + u∥)`. Here R(θ/2) is the rotation
    /// by θ/2, and `s = sin(|θ|/2) / (|θ|/2)` the ratio of chord to arc. Other rigid motions that agree with the twist to first order differ from the
    /// exponential map only to second order. The exponential map is a screw motion about a single line, which does not depend on the choice of the
    /// origin.
    ///
    /// ```
    /// use grasp_lcp::{nalgebra::Point3, spatial::Twist};
    /// use std::f64::consts::PI;
    ///
    /// // Half a turn about the line x = 1, y = 0 along z, and 0.3 m along it.
    /// let motion = Twist::new([0.0, -PI, 0.3], [0.0, 0.0, PI]).exp();
    /// assert!((motion * Point3::new(3.0, 0.0, 0.0) - Point3::new(-1.0, 0.0, 0.3)).norm() < 1e-15);
    /// ```
    #[doc(alias = "isometry")]
    #[must_use]
    #[inline]
    pub fn exp(&self) -> Isometry3<f64> {
        let rotation = Vector3::from(self.rotation());
        let translation = Vector3::from(self.translation());
        let along = along(&rotation, &translation);
        let chord = along + (translation - along) * (0.5 * rotation.norm()).sinc();
        // The rotation by half the angle about the same axis. Its quaternion contains half of its own angle, i.e. a quarter of the whole.
        let quarter = 0.5 * rotation / 2.0;
        let angle = quarter.norm();
        let half = if quarter.norm_squared() <= f64::EPSILON * f64::EPSILON {
            UnitQuaternion::identity()
        } else {
            UnitQuaternion::new_unchecked(Quaternion::from_parts(
                angle.cos(),
                quarter * (angle.sin() / angle),
            ))
        };
        Isometry3::from_parts((half * chord).into(), half * half)
    }

    /// The twist of a rigid motion, with a rotation of at most π: the inverse of [`Self::exp`].
    ///
    /// ```
    /// use grasp_lcp::{nalgebra::{Isometry3, Vector3}, spatial::Twist};
    ///
    /// // From one pose of an object to the next: a quarter turn about z through the origin, lifted by 0.2 m.
    /// let quarter = std::f64::consts::FRAC_PI_2;
    /// let motion = Isometry3::new(Vector3::new(0.0, 0.0, 0.2), Vector3::z() * quarter);
    /// let twist = Twist::log(&motion);
    /// assert!((twist - Twist::new([0.0, 0.0, 0.2], [0.0, 0.0, quarter])).to_vector().norm() < 1e-15);
    /// ```
    #[inline]
    pub fn log(motion: &Isometry3<f64>) -> Self {
        let rotation = motion.rotation.scaled_axis();
        let chord = UnitQuaternion::from_scaled_axis(-0.5 * rotation) * motion.translation.vector;
        let along = along(&rotation, &chord);
        Self::new(along + (chord - along) / (0.5 * rotation.norm()).sinc(), rotation)
    }
}

/// The component of `v` along `axis`, as a vector; zero if `axis` is zero.
#[inline]
fn along(axis: &Vector3<f64>, v: &Vector3<f64>) -> Vector3<f64> {
    axis.try_normalize(0.0).map_or_else(Vector3::zeros, |axis| axis * axis.dot(v))
}
