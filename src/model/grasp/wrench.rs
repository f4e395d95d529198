//! Wrenches (loads on the object) and twists (its small motions).

use crate::numerics::{Space, Vector};
use core::fmt;
use core::ops::{Add, Mul, Neg, Sub};

use nalgebra::{ArrayStorage, Matrix, SVector};

use super::points_of_action::PointsOfAction;
use super::rotation::of_the_object;
use crate::error::{Error, is_moderate};

/// A load on the object: forces first, then moments about the origin of the coordinates. It has 3 components in the plane and 6 in space.
///
/// A load W acts **on the object** from outside, as weight does. The contact forces F_i balance it, `Σ G_i F_i + W = 0`, where the grasp map G_i
/// turns F_i into its force and moment on the object. Forces are in N and moments in N m, or in any consistent units of the contacts. Positive
/// moments turn from x to y in the plane and follow the right-hand rule in space. External torques on the joints of a [hand](crate::grasp::Hand) are
/// given [separately](crate::ask::Grasp::with_joint_torques).
///
/// ```
/// use grasp_lcp::nalgebra::{Isometry2, Vector2};
/// use grasp_lcp::planar::Wrench;
///
/// // 2 N down at (3, 1): the moment is x f_y - y f_x about the origin, and zero about the point itself.
/// let weight = Wrench::force_at([0.0, -2.0], [3.0, 1.0]);
/// assert_eq!(weight.moment(), -6.0);
/// assert_eq!(weight.about([3.0, 1.0]), Wrench::force([0.0, -2.0]));
///
/// // The same load where the frame in which it was given lies at (10, 0).
/// let pose = Isometry2::new(Vector2::new(10.0, 0.0), 0.0);
/// assert_eq!(weight.transformed(&pose), Wrench::force_at([0.0, -2.0], [13.0, 1.0]));
/// ```
///
/// A load made by [`force_at`](Self::force_at), a force at the origin, and sums and multiples of such loads, keep their points of action. Where
/// nothing resists a rotation, these points decide whether the load turns the object over. Two wrenches are equal if their components are equal.
#[derive(Clone, Copy)]
#[must_use]
pub struct Wrench<const C: usize>(pub(super) SVector<f64, 6>, pub(super) PointsOfAction);

/// A small motion of the object: translation of the origin of the coordinates, then rotation. It has 3 components in the plane and 6 in space.
///
/// To first order the point r of the body moves by `translation + rotation × r`; see [`Twist::displacement_at`]. This is equation 4.1 of the paper on
/// which the crate is based (`paper-notes.md`), without its quadratic term. Translations are in m, rotations in rad. Rotations turn from x to y in
/// the plane and follow the right-hand rule in space.
///
/// ```
/// use grasp_lcp::nalgebra::{Isometry3, Vector3};
/// use grasp_lcp::spatial::{Twist, Wrench};
///
/// // A turn about the line through (1, 0, 0) along z: that point stays where it is.
/// let turn = Twist::new([0.0, -0.01, 0.0], [0.0, 0.0, 0.01]);
/// assert_eq!(turn.about([1.0, 0.0, 0.0]), Twist::new([0.0; 3], [0.0, 0.0, 0.01]));
///
/// // The work f·u + m·θ of a load depends neither on the reference point nor on the frame.
/// let load = Wrench::force_at([0.0, 3.0, 1.0], [2.0, 0.0, 0.0]);
/// let work = |load: Wrench, turn: Twist| load.to_vector().dot(&turn.to_vector());
/// let pose = Isometry3::new(Vector3::new(0.5, -0.2, 0.1), Vector3::new(0.3, 0.4, 0.0));
/// assert!((work(load, turn) - 3.0 * 0.01).abs() < 1e-16);
/// assert!((work(load.about([1.0, 0.0, 0.0]), turn.about([1.0, 0.0, 0.0])) - 0.03).abs() < 1e-16);
/// assert!((work(load.transformed(&pose), turn.transformed(&pose)) - 0.03).abs() < 1e-16);
/// ```
#[derive(Clone, Copy, PartialEq)]
#[must_use]
pub struct Twist<const C: usize>(SVector<f64, 6>);

macro_rules! vector_like {
    ($name:ident) => {
        impl<const C: usize> $name<C> {
            /// The components, linear before angular. In the plane: along x, along y, and from x to y. In space: along x, y and z, then about x, y
            /// and z.
            #[must_use]
            pub fn components(&self) -> &[f64] {
                &self.0.as_slice()[..of_the_object::<C>()]
            }

            /// A vector with these components, in the order of [`Self::components`]. Missing components are zero, surplus components are ignored.
            pub fn from_components(components: &[f64]) -> Self {
                let mut all = SVector::<f64, 6>::zeros();
                let count = components.len().min(of_the_object::<C>());
                all.as_mut_slice()[..count].copy_from_slice(&components[..count]);
                Self::of_all(all)
            }

            /// The object's components, taken from a vector of all coordinates of the grasp: of the object, of joints and of other bodies.
            pub(crate) fn among(space: Space, coordinates: &Vector) -> Self {
                let mut all = SVector::<f64, 6>::zeros();
                for (k, &place) in space.components::<C>().iter().enumerate() {
                    all[place] = coordinates[k];
                }
                Self::of_all(all)
            }

            /// This vector in the engine's coordinates: its components first, zeros for joints and other bodies.
            pub(crate) fn coordinates(&self, space: Space) -> Vector {
                let mut coordinates = Vector::zeros();
                for (k, &place) in space.components::<C>().iter().enumerate() {
                    coordinates[k] = self.0[place];
                }
                coordinates
            }
        }

        impl<const C: usize> From<&Self> for $name<C> {
            fn from(given: &Self) -> Self {
                *given
            }
        }

        impl<const C: usize> fmt::Debug for $name<C> {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.debug_tuple(stringify!($name)).field(&self.components()).finish()
            }
        }

        vector_like!($name, 2, 3);
        vector_like!($name, 3, 6);
        impl<const C: usize> Sub for $name<C> {
            type Output = Self;
            fn sub(self, other: Self) -> Self {
                self + -other
            }
        }

        impl<const C: usize> Neg for $name<C> {
            type Output = Self;
            fn neg(self) -> Self {
                self * -1.0
            }
        }

        impl<const C: usize> Mul<$name<C>> for f64 {
            type Output = $name<C>;
            fn mul(self, other: $name<C>) -> $name<C> {
                other * self
            }
        }
    };
    ($name:ident, $axes:literal, $size:literal) => {
        impl $name<$axes> {
            /// A vector with these components, linear before angular.
            pub fn from_vector(components: impl Into<[f64; $size]>) -> Self {
                Self::from_components(&components.into())
            }

            /// The components as a vector, linear before angular.
            #[must_use]
            pub fn to_vector(&self) -> SVector<f64, $size> {
                self.coordinates(Space::of::<$axes>()).to_svector()
            }
        }
    };
}

vector_like!(Wrench);
vector_like!(Twist);

const NOTHING: SVector<f64, 6> = Matrix::from_array_storage(ArrayStorage([[0.0; 6]]));

impl<const C: usize> Twist<C> {
    /// The vector whose components are all zero.
    pub const ZERO: Self = Self(NOTHING);

    fn of_all(all: SVector<f64, 6>) -> Self {
        Self(all)
    }
}

impl<const C: usize> Add for Twist<C> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self(self.0 + other.0)
    }
}

impl<const C: usize> Mul<f64> for Twist<C> {
    type Output = Self;
    fn mul(self, factor: f64) -> Self {
        Self(self.0 * factor)
    }
}

impl<const C: usize> Wrench<C> {
    /// The vector whose components are all zero.
    pub const ZERO: Self = Self(NOTHING, PointsOfAction::NO_FORCE);

    fn of_all(all: SVector<f64, 6>) -> Self {
        // A force without a moment about the origin acts at the origin, where the sum `Σ F rᵀ` is zero as without a force. Of any other force only
        // the line of action is known.
        let is_zero = |part: &[f64]| part.iter().all(|component| *component == 0.0);
        let (force, moment) = all.as_slice().split_at(C);
        let is_known = is_zero(force) || is_zero(moment);
        Self(all, if is_known { PointsOfAction::NO_FORCE } else { PointsOfAction::UNKNOWN })
    }

    /// The wrench of a force, N, that acts at a point, m.
    pub(crate) fn force_through(point: &SVector<f64, C>, force: &SVector<f64, C>) -> Self {
        let space = Space::of::<C>();
        Self::among(space, &space.wrench_of(point, force)).acting_at(PointsOfAction::of(force, point))
    }

    /// The force of the wrench, N.
    pub(crate) fn force_part(&self) -> SVector<f64, C> {
        SVector::from_column_slice(&self.0.as_slice()[..C])
    }

    /// Returns an error for components that are not finite, or larger than 1e50 in magnitude; `what` names the wrench in the message.
    pub(crate) fn check(&self, what: &'static str) -> Result<(), Error> {
        self.check_in(Space::of::<C>(), what)
    }

    /// Returns an error for components that are not finite, or larger than 1e50 in magnitude, in the plane or in space; `what` names the wrench in
    /// the message.
    pub(crate) fn check_in(&self, space: Space, what: &'static str) -> Result<(), Error> {
        for (component, &place) in space.components::<C>().iter().enumerate() {
            let value = self.0[place];
            if !is_moderate(value) {
                return Err(Error::Wrench { what, component, value });
            }
        }
        Ok(())
    }
}

impl Wrench<2> {
    /// A force (x, y) through the origin, N, and a moment about it, from x to y, N m. If the moment is not zero, the point at which the force acts is
    /// not known, only its line of action. [Buckling](crate::equilibrium::TooFar::Buckles) depends on this point; [`Self::force_at`] keeps it.
    pub fn new(force: impl Into<[f64; 2]>, moment: f64) -> Self {
        let [x, y] = force.into();
        Self::from_vector([x, y, moment])
    }

    /// A force at the origin, N.
    pub fn force(force: impl Into<[f64; 2]>) -> Self {
        Self::new(force, 0.0)
    }

    /// A force at `point` (x, y), m, whose moment about the origin is `x f_y - y f_x`.
    ///
    /// ```
    /// use grasp_lcp::planar::Wrench;
    ///
    /// let weight = Wrench::force_at([0.0, -2.0], [3.0, 1.0]);
    /// assert_eq!((weight.resultant(), weight.moment()), ([0.0, -2.0], -6.0));
    /// ```
    pub fn force_at(force: impl Into<[f64; 2]>, point: impl Into<[f64; 2]>) -> Self {
        Self::force_through(&point.into().into(), &force.into().into())
    }

    /// The resultant force, N.
    #[must_use]
    pub fn resultant(&self) -> [f64; 2] {
        [self.0[0], self.0[1]]
    }

    /// The moment about the origin, from x to y, N m.
    #[must_use]
    pub fn moment(&self) -> f64 {
        self.0[2]
    }
}

impl Wrench<3> {
    /// A force (x, y, z) through the origin, N, and a moment (x, y, z) about it, N m. If the moment is not zero, the point at which the force acts is
    /// not known, only its line of action. [Buckling](crate::equilibrium::TooFar::Buckles) depends on this point; [`Self::force_at`] keeps it.
    pub fn new(force: impl Into<[f64; 3]>, moment: impl Into<[f64; 3]>) -> Self {
        let (f, m) = (force.into(), moment.into());
        Self::from_vector([f[0], f[1], f[2], m[0], m[1], m[2]])
    }

    /// A force at the origin, N.
    pub fn force(force: impl Into<[f64; 3]>) -> Self {
        Self::new(force, [0.0; 3])
    }

    /// A force at `point`, whose moment about the origin is `point × force`.
    ///
    /// ```
    /// use grasp_lcp::spatial::Wrench;
    ///
    /// let weight = Wrench::force_at([0.0, 0.0, -2.0], [3.0, 1.0, 0.0]);
    /// assert_eq!((weight.resultant(), weight.moment()), ([0.0, 0.0, -2.0], [-2.0, 6.0, 0.0]));
    /// ```
    pub fn force_at(force: impl Into<[f64; 3]>, point: impl Into<[f64; 3]>) -> Self {
        Self::force_through(&point.into().into(), &force.into().into())
    }

    /// The resultant force, N.
    #[must_use]
    pub fn resultant(&self) -> [f64; 3] {
        [self.0[0], self.0[1], self.0[2]]
    }

    /// The moment about the origin, N m.
    #[must_use]
    pub fn moment(&self) -> [f64; 3] {
        [self.0[3], self.0[4], self.0[5]]
    }
}

impl<const C: usize> Twist<C> {
    /// Displacement of the object's point at `point`, m, to first order.
    pub(crate) fn moves(&self, point: &SVector<f64, C>) -> SVector<f64, C> {
        let space = Space::of::<C>();
        space.displacement_of(point, &self.coordinates(space))
    }
}

impl Twist<2> {
    /// A translation (x, y) of the object's point at the origin, m, and a rotation from x towards
    /// y, rad.
    pub fn new(translation: impl Into<[f64; 2]>, rotation: f64) -> Self {
        let [x, y] = translation.into();
        Self::from_vector([x, y, rotation])
    }

    /// Translation of the object's point at the origin, m.
    #[must_use]
    pub fn translation(&self) -> [f64; 2] {
        [self.0[0], self.0[1]]
    }

    /// Rotation from x towards y, rad.
    #[must_use]
    pub fn rotation(&self) -> f64 {
        self.0[2]
    }

    /// Displacement of the object's point `point`, (x, y), m, to first order: `(dx - θ y, dy + θ x)`, with the translation (dx, dy) and the rotation
    /// θ.
    ///
    /// ```
    /// use grasp_lcp::planar::Twist;
    ///
    /// let turn = Twist::new([0.0, 0.0], 0.01);
    /// assert_eq!(turn.displacement_at([3.0, 1.0]), [-0.01, 0.03]);
    /// ```
    #[must_use]
    pub fn displacement_at(&self, point: impl Into<[f64; 2]>) -> [f64; 2] {
        self.moves(&point.into().into()).into()
    }
}

impl Twist<3> {
    /// A translation of the object's point at the origin, m, and a rotation vector, rad.
    pub fn new(translation: impl Into<[f64; 3]>, rotation: impl Into<[f64; 3]>) -> Self {
        let (u, w) = (translation.into(), rotation.into());
        Self::from_vector([u[0], u[1], u[2], w[0], w[1], w[2]])
    }

    /// Translation of the object's point at the origin, m.
    #[must_use]
    pub fn translation(&self) -> [f64; 3] {
        [self.0[0], self.0[1], self.0[2]]
    }

    /// Rotation vector, rad.
    #[must_use]
    pub fn rotation(&self) -> [f64; 3] {
        [self.0[3], self.0[4], self.0[5]]
    }

    /// Displacement of the object's point `point`, m, to first order: `translation + rotation ×
    /// point`.
    ///
    /// ```
    /// use grasp_lcp::spatial::Twist;
    ///
    /// let turn_about_z = Twist::new([0.0; 3], [0.0, 0.0, 0.01]);
    /// assert_eq!(turn_about_z.displacement_at([3.0, 1.0, 5.0]), [-0.01, 0.03, 0.0]);
    /// ```
    #[must_use]
    pub fn displacement_at(&self, point: impl Into<[f64; 3]>) -> [f64; 3] {
        self.moves(&point.into().into()).into()
    }
}
