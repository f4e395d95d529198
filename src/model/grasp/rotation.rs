//! Moments and rotations, in one form for the plane and for space.
//!
//! A rotation k takes place in a coordinate plane (i, j). A planar grasp has only the plane (x, y). In space (y, z), (z, x) and (x, y) are the planes
//! of the rotations about x, y and z. For the arm r from the reference point, a force f and the rotations θ,
//!
//! ```text
//! moment_k       = r_i f_j - r_j f_i
//! displacement_i = -θ_k r_j,   displacement_j = θ_k r_i
//! ```
//!
//! With c axes an object has `d = c + c(c-1)/2` degrees of freedom: 3 in the plane (c = 2), 6 in space (c = 3).
//!
//! Planar grasps, too, have vectors of three components. The last component is zero, and so is the third axis of their contact frames.

use nalgebra::{SMatrix, SVector};

use crate::numerics::{DoubleDouble, Map, Size, Space, Vector, by_axis};

/// Stops the compilation unless the number of axes `C` is 2 or 3.
pub(crate) const fn assert_plane_or_space<const C: usize>() {
    assert!(
        C == 2 || C == 3,
        "a contact has 2 axes in the plane and 3 in space: \
         take the names in `grasp_lcp::planar` or `grasp_lcp::spatial`"
    );
}

impl Space {
    /// A copy of `v` in which all coordinates except the object's are zero.
    pub(crate) fn object_alone(self, v: &Vector) -> Vector {
        let mut alone = v.clone();
        alone.iter_mut().skip(self.of_the_object()).for_each(|x| *x = 0.0);
        alone
    }

    /// Wrench of the force `f` that acts at the end of `arm`: the force, then its moment about the start of `arm`.
    pub(crate) fn wrench_of<const C: usize>(self, arm: &SVector<f64, C>, f: &SVector<f64, C>) -> Vector {
        let (axes, mut w) = (self.axes(), Vector::zeros());
        for a in 0..axes {
            w[a] = f[a];
        }
        for (k, &(i, j)) in self.planes().iter().enumerate() {
            w[axes + k] = arm[i] * f[j] - arm[j] * f[i];
        }
        w
    }

    /// Displacement, to first order, of the point at the end of `arm` under a twist (translation, rotation).
    pub(crate) fn displacement_of<const C: usize>(
        self,
        arm: &SVector<f64, C>,
        twist: &Vector,
    ) -> SVector<f64, C> {
        let (axes, mut u) = (self.axes(), SVector::zeros());
        for a in 0..axes {
            u[a] = twist[a];
        }
        for (k, &(i, j)) in self.planes().iter().enumerate() {
            u[i] -= twist[axes + k] * arm[j];
            u[j] += twist[axes + k] * arm[i];
        }
        u
    }

    /// Converts a wrench with moments about `p` to moments about the origin.
    pub(crate) fn moved_wrench<const C: usize>(self, p: &SVector<f64, C>, w: &Vector) -> Vector {
        let moments = self.wrench_of::<C>(p, &self.linear_part(w));
        let mut moved = w.clone();
        for k in self.axes()..self.of_the_object() {
            moved[k] = w[k] + moments[k];
        }
        moved
    }

    /// Converts a twist with the translation of the point at `p` to a twist with the translation of the origin.
    pub(crate) fn moved_twist<const C: usize>(self, p: &SVector<f64, C>, q: &Vector) -> Vector {
        let translation = self.displacement_of::<C>(&-p, q);
        let mut moved = q.clone();
        for k in 0..self.axes() {
            moved[k] = translation[k];
        }
        moved
    }

    /// The force of a wrench, or the translation of a twist.
    pub(crate) fn linear_part<const C: usize>(self, v: &Vector) -> SVector<f64, C> {
        let mut part = SVector::zeros();
        for a in 0..self.axes() {
            part[a] = v[a];
        }
        part
    }

    /// The grasp map of one contact: its columns are the wrenches of unit forces at the end of `arm` along the axes of the contact frame.
    pub(crate) fn grasp_map(self, size: Size, arm: &SVector<f64, 3>, frame: &SMatrix<f64, 3, 3>) -> Map {
        let mut map = Map::zeros(size);
        for a in 0..self.axes() {
            map.set_column(a, &self.wrench_of(arm, &frame.column(a).into_owned()));
        }
        map
    }

    /// The rounded grasp map, and its rounding error: the exact map for `point` and `frame` minus the rounded map. Moments are about `origin`, with
    /// arms in units of `length`.
    pub(super) fn grasp_map_in_twice(
        self,
        size: Size,
        point: &SVector<f64, 3>,
        origin: &SVector<f64, 3>,
        length: f64,
        frame: &SMatrix<f64, 3, 3>,
    ) -> (Map, Map) {
        let axes = self.axes();
        let arm = (point - origin) / length;
        let map = self.grasp_map(size, &arm, frame);
        let arm_rest = by_axis::<3>(|a| {
            let mut exact = DoubleDouble::new(point[a]);
            exact.add(-origin[a]);
            exact.add_product(-arm[a], length);
            exact.value() / length
        });
        let mut rest = Map::zeros(size);
        for (k, &(i, j)) in self.planes().iter().enumerate() {
            for a in 0..axes {
                let mut moment = DoubleDouble::new(-map[(axes + k, a)]);
                moment.add_product(arm[i], frame[(j, a)]);
                moment.add_product(-arm[j], frame[(i, a)]);
                moment.add(arm_rest[i] * frame[(j, a)]);
                moment.add(-arm_rest[j] * frame[(i, a)]);
                rest[(axes + k, a)] = moment.value();
            }
        }
        (map, rest)
    }
}

/// Number of coordinates of the object in a space of `C` axes.
pub(crate) const fn of_the_object<const C: usize>() -> usize {
    Space::of::<C>().of_the_object()
}

/// A vector with these components along the first `axes` axes; the others are zero.
pub(crate) fn of_axes<const C: usize>(axes: usize, component: impl Fn(usize) -> f64) -> SVector<f64, C> {
    by_axis(|a| if a < axes { component(a) } else { 0.0 })
}
