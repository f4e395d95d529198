//! Wrenches and twists: loads on the object, and its small motions.

use std::ops::{Add, Mul, Neg, Sub};

use nalgebra::{ArrayStorage, Matrix, SVector};

use super::rotation::{displacement_of, of_the_object, wrench_of};
use crate::error::{Error, is_moderate};

/// A load on the object: forces first, then moments about the origin of the coordinates, `d`
/// components.
///
/// A load acts **on the object** from outside, weight for instance; the contact forces F balance
/// it, `Σ G_i F_i + W = 0`. Forces are in N and moments in N m, or in whatever consistent units the
/// contacts use. Positive moments turn from x to y in the plane and follow the right-hand rule in
/// space. Of a grasp by a [hand](crate::grasp::Hand) what acts on its joints follows, joint by joint: N m about a revolute
/// one, N along a prismatic one.
///
/// ```
/// use grasp_lcp::nalgebra::{Isometry2, Vector2};
/// use grasp_lcp::planar::Wrench;
///
/// // 2 N down at (3, 1): m = x f_y - y f_x about the origin, none about the point itself.
/// let weight = Wrench::force_at([0.0, -2.0], [3.0, 1.0]);
/// assert_eq!(weight.moment(), -6.0);
/// assert_eq!(weight.about([3.0, 1.0]), Wrench::force([0.0, -2.0]));
///
/// // The same load where the frame in which it was given lies at (10, 0).
/// let pose = Isometry2::new(Vector2::new(10.0, 0.0), 0.0);
/// assert_eq!(weight.transformed(&pose), Wrench::force_at([0.0, -2.0], [13.0, 1.0]));
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Wrench<const D: usize, const C: usize>(SVector<f64, D>);

/// A small motion of the object: translation of the origin of the coordinates, then rotation, `d`
/// components.
///
/// To first order the body moves at a point r by `translation + rotation × r`, equation 4.1 of the
/// paper without its quadratic term; see [`Twist::displacement_at`]. Translations are in m,
/// rotations in rad. Rotations turn from x to y in the plane and follow the right-hand rule in
/// space. Of a grasp by a [hand](crate::grasp::Hand) the displacements of its joints follow, rad or m.
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
/// let work = |load: Wrench, turn: Twist| load.as_vector().dot(turn.as_vector());
/// let pose = Isometry3::new(Vector3::new(0.5, -0.2, 0.1), Vector3::new(0.3, 0.4, 0.0));
/// assert!((work(load, turn) - 3.0 * 0.01).abs() < 1e-16);
/// assert!((work(load.about([1.0, 0.0, 0.0]), turn.about([1.0, 0.0, 0.0])) - 0.03).abs() < 1e-16);
/// assert!((work(load.transformed(&pose), turn.transformed(&pose)) - 0.03).abs() < 1e-16);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Twist<const D: usize, const C: usize>(SVector<f64, D>);

macro_rules! vector_like {
    ($name:ident) => {
        impl<const D: usize, const C: usize> $name<D, C> {
            /// All components zero.
            pub const ZERO: Self = Self(Matrix::from_array_storage(ArrayStorage([[0.0; D]])));

            /// From its `d` components: linear ones first, then angular ones; (x, y, xy) in the
            /// plane, (x, y, z, x, y, z) in space; behind a hand those of joints follow.
            #[must_use]
            pub fn from_vector(components: impl Into<[f64; D]>) -> Self {
                Self(SVector::from(components.into()))
            }

            /// Its `d` components: linear ones first, then angular ones.
            #[must_use]
            pub fn as_vector(&self) -> &SVector<f64, D> {
                &self.0
            }

            /// Its first components; zero beyond those that there are.
            #[cfg(any(feature = "plot", feature = "serde"))]
            pub(crate) fn resized<const N: usize>(&self) -> $name<N, C> {
                $name(SVector::from_fn(|k, _| self.0.get(k).copied().unwrap_or(0.0)))
            }
        }

        vector_like!($name, Add, add, +);
        vector_like!($name, Sub, sub, -);

        impl<const D: usize, const C: usize> Neg for $name<D, C> {
            type Output = Self;
            fn neg(self) -> Self {
                Self(-self.0)
            }
        }

        impl<const D: usize, const C: usize> Mul<f64> for $name<D, C> {
            type Output = Self;
            fn mul(self, factor: f64) -> Self {
                Self(self.0 * factor)
            }
        }

        impl<const D: usize, const C: usize> Mul<$name<D, C>> for f64 {
            type Output = $name<D, C>;
            fn mul(self, other: $name<D, C>) -> $name<D, C> {
                $name(other.0 * self)
            }
        }
    };
    ($name:ident, $operator:ident, $operate:ident, $symbol:tt) => {
        impl<const D: usize, const C: usize> $operator for $name<D, C> {
            type Output = Self;
            fn $operate(self, other: Self) -> Self {
                Self(self.0 $symbol other.0)
            }
        }
    };
}

vector_like!(Wrench);
vector_like!(Twist);

impl<const D: usize, const C: usize> Wrench<D, C> {
    /// Refuses components that are not finite or too large; `what` names the wrench in the message.
    pub(crate) fn check(&self, what: &'static str) -> Result<(), Error> {
        match self.0.iter().position(|x| !is_moderate(*x)) {
            Some(component) => Err(Error::Wrench { what, component, value: self.0[component] }),
            None => Ok(()),
        }
    }
}

impl<const D: usize, const C: usize> Wrench<D, C> {
    /// This load with torques from outside on the first joints of a hand, N m or N, in the place of those it had.
    ///
    /// ```
    /// use grasp_lcp::planar::hand::Wrench;
    ///
    /// let load = Wrench::<5>::force([0.0, -1.0]).on_joints([0.2, -0.1]);
    /// assert_eq!(load.joints(), [0.2, -0.1]);
    /// ```
    #[must_use]
    pub fn on_joints(mut self, torques: impl IntoIterator<Item = f64>) -> Self {
        for (component, torque) in self.0.iter_mut().skip(of_the_object::<C>()).zip(torques) {
            *component = torque;
        }
        self
    }

    /// Torques on joints from outside, N m or N, along their displacements; zeros behind the last joint.
    #[must_use]
    pub fn joints(&self) -> &[f64] {
        &self.0.as_slice()[of_the_object::<C>()..]
    }
}

impl<const D: usize, const C: usize> Twist<D, C> {
    /// Displacements of joints that go with this motion, rad or m, and what else moves in a hand behind the last of them.
    #[must_use]
    pub fn joints(&self) -> &[f64] {
        &self.0.as_slice()[of_the_object::<C>()..]
    }
}

impl<const D: usize> Wrench<D, 2> {
    /// A force (x, y) through the origin, N, and a moment about it, from x to y, N m.
    #[must_use]
    pub fn new(force: impl Into<[f64; 2]>, moment: f64) -> Self {
        let [x, y] = force.into();
        Self(leading([x, y, moment]))
    }

    /// A force through the origin, N, no moment.
    #[must_use]
    pub fn force(force: impl Into<[f64; 2]>) -> Self {
        Self::new(force, 0.0)
    }

    /// A force through `point`: its moment about the origin is `x f_y - y f_x`.
    ///
    /// ```
    /// use grasp_lcp::planar::Wrench;
    ///
    /// let weight = Wrench::force_at([0.0, -2.0], [3.0, 1.0]);
    /// assert_eq!((weight.resultant(), weight.moment()), ([0.0, -2.0], -6.0));
    /// ```
    #[must_use]
    pub fn force_at(force: impl Into<[f64; 2]>, point: impl Into<[f64; 2]>) -> Self {
        Self(wrench_of::<D, 2>(&point.into().into(), &force.into().into()))
    }

    /// The sum of its forces, N.
    #[must_use]
    pub fn resultant(&self) -> [f64; 2] {
        [self.0[0], self.0[1]]
    }

    /// Its moment about the origin, from x to y, N m.
    #[must_use]
    pub fn moment(&self) -> f64 {
        self.0[2]
    }
}

impl<const D: usize> Wrench<D, 3> {
    /// A force (x, y, z) through the origin, N, and a moment (x, y, z) about it, N m.
    #[must_use]
    pub fn new(force: impl Into<[f64; 3]>, moment: impl Into<[f64; 3]>) -> Self {
        let (f, m) = (force.into(), moment.into());
        Self(leading([f[0], f[1], f[2], m[0], m[1], m[2]]))
    }

    /// A force through the origin, N, no moment.
    #[must_use]
    pub fn force(force: impl Into<[f64; 3]>) -> Self {
        Self::new(force, [0.0; 3])
    }

    /// A force through `point`: its moment about the origin is `point × force`.
    ///
    /// ```
    /// use grasp_lcp::spatial::Wrench;
    ///
    /// let weight = Wrench::force_at([0.0, 0.0, -2.0], [3.0, 1.0, 0.0]);
    /// assert_eq!((weight.resultant(), weight.moment()), ([0.0, 0.0, -2.0], [-2.0, 6.0, 0.0]));
    /// ```
    #[must_use]
    pub fn force_at(force: impl Into<[f64; 3]>, point: impl Into<[f64; 3]>) -> Self {
        Self(wrench_of::<D, 3>(&point.into().into(), &force.into().into()))
    }

    /// The sum of its forces, N.
    #[must_use]
    pub fn resultant(&self) -> [f64; 3] {
        [self.0[0], self.0[1], self.0[2]]
    }

    /// Its moment about the origin, N m.
    #[must_use]
    pub fn moment(&self) -> [f64; 3] {
        [self.0[3], self.0[4], self.0[5]]
    }
}

impl<const D: usize> Twist<D, 2> {
    /// A translation (x, y) of the object's point at the origin, m, and a rotation from x towards
    /// y, rad.
    #[must_use]
    pub fn new(translation: impl Into<[f64; 2]>, rotation: f64) -> Self {
        let [x, y] = translation.into();
        Self(leading([x, y, rotation]))
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

    /// Displacement of the object's point `point`, m, to first order: `(dx - θ y, dy + θ x)`.
    ///
    /// ```
    /// use grasp_lcp::planar::Twist;
    ///
    /// let turn = Twist::new([0.0, 0.0], 0.01);
    /// assert_eq!(turn.displacement_at([3.0, 1.0]), [-0.01, 0.03]);
    /// ```
    #[must_use]
    pub fn displacement_at(&self, point: impl Into<[f64; 2]>) -> [f64; 2] {
        displacement_of::<D, 2>(&point.into().into(), &self.0).into()
    }
}

impl<const D: usize> Twist<D, 3> {
    /// A translation of the object's point at the origin, m, and a rotation vector, rad.
    #[must_use]
    pub fn new(translation: impl Into<[f64; 3]>, rotation: impl Into<[f64; 3]>) -> Self {
        let (u, w) = (translation.into(), rotation.into());
        Self(leading([u[0], u[1], u[2], w[0], w[1], w[2]]))
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
        displacement_of::<D, 3>(&point.into().into(), &self.0).into()
    }
}

/// These components first, zeros behind them.
fn leading<const N: usize, const D: usize>(components: [f64; N]) -> SVector<f64, D> {
    SVector::from_fn(|k, _| if k < N { components[k] } else { 0.0 })
}
