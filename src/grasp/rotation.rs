//! Moments and rotations written once for the plane and for space.
//!
//! A rotation turns a plane (i, j): the plane has one, (x, y); space has three, (y, z), (z, x), (x,
//! y), which are the rotations about x, y and z. With r the arm, f a force and θ the rotations,
//!
//! ```text
//! moment_k       = r_i f_j - r_j f_i
//! displacement_i = -θ_k r_j,   displacement_j = θ_k r_i
//! ```
//!
//! so that `d = c + c(c-1)/2`: 3 degrees of freedom in the plane (c = 2), 6 in space (c = 3).

use nalgebra::{SMatrix, SVector};

use crate::numerics::{DoubleDouble, Map, Size, Vector};

/// Refuses other dimensions at compile time.
pub(crate) const fn assert_plane_or_space<const C: usize>() {
    assert!(
        C == 2 || C == 3,
        "a contact has 2 axes in the plane and 3 in space: \
         take the names in `grasp_lcp::planar` or `grasp_lcp::spatial`"
    );
}

/// Number of coordinates of the object: its translations and rotations. Those of joints come behind them.
pub(crate) const fn of_the_object<const C: usize>() -> usize {
    C + planes::<C>().len()
}

/// A vector over all coordinates, with zeros behind the object's.
pub(crate) fn object_alone<const C: usize>(v: &Vector) -> Vector {
    let mut alone = v.clone();
    alone.iter_mut().skip(of_the_object::<C>()).for_each(|x| *x = 0.0);
    alone
}

/// The planes of rotation of a space with `C` axes.
pub(crate) const fn planes<const C: usize>() -> &'static [(usize, usize)] {
    match C {
        2 => &[(0, 1)],
        3 => &[(1, 2), (2, 0), (0, 1)],
        _ => &[],
    }
}

/// Wrench (force, moment about the origin of `arm`) of the force `f` at the end of `arm`.
pub(crate) fn wrench_of<const C: usize>(arm: &SVector<f64, C>, f: &SVector<f64, C>) -> Vector {
    let mut w = Vector::zeros();
    for a in 0..C {
        w[a] = f[a];
    }
    for (k, &(i, j)) in planes::<C>().iter().enumerate() {
        w[C + k] = arm[i] * f[j] - arm[j] * f[i];
    }
    w
}

/// Displacement, to first order, of the point at the end of `arm` under the twist (translation,
/// rotation).
pub(crate) fn displacement_of<const C: usize>(arm: &SVector<f64, C>, twist: &Vector) -> SVector<f64, C> {
    let mut u = SVector::zeros();
    for a in 0..C {
        u[a] = twist[a];
    }
    for (k, &(i, j)) in planes::<C>().iter().enumerate() {
        u[i] -= twist[C + k] * arm[j];
        u[j] += twist[C + k] * arm[i];
    }
    u
}

/// A wrench about `p`, converted to the origin.
pub(crate) fn moved_wrench<const C: usize>(p: &SVector<f64, C>, w: &Vector) -> Vector {
    let moments = wrench_of::<C>(p, &SVector::from_fn(|a, _| w[a]));
    let mut moved = w.clone();
    for k in C..of_the_object::<C>() {
        moved[k] = w[k] + moments[k];
    }
    moved
}

/// A twist of the object's point at `p`, converted to the point at the origin.
pub(crate) fn moved_twist<const C: usize>(p: &SVector<f64, C>, q: &Vector) -> Vector {
    let translation = displacement_of::<C>(&-p, q);
    let mut moved = q.clone();
    for k in 0..C {
        moved[k] = translation[k];
    }
    moved
}

/// The grasp map of one contact, `d x c`: the columns are the wrenches of unit forces along the
/// axes of its frame.
pub(crate) fn grasp_map<const C: usize>(
    size: Size,
    arm: &SVector<f64, C>,
    frame: &SMatrix<f64, C, C>,
) -> Map<C> {
    let mut map = Map::zeros(size);
    for a in 0..C {
        map.set_column(a, &wrench_of::<C>(arm, &frame.column(a).into_owned()));
    }
    map
}

/// The grasp map about `origin` in the unit `length`, and its rounding: the exact map of this point and this frame less the first, rounded.
pub(super) fn grasp_map_in_twice<const C: usize>(
    size: Size,
    point: &SVector<f64, C>,
    origin: &SVector<f64, C>,
    length: f64,
    frame: &SMatrix<f64, C, C>,
) -> (Map<C>, Map<C>) {
    let arm = (point - origin) / length;
    let map = grasp_map(size, &arm, frame);
    let arm_rest = SVector::<f64, C>::from_fn(|a, _| {
        let mut exact = DoubleDouble::new(point[a]);
        exact.add(-origin[a]);
        exact.add_product(-arm[a], length);
        exact.value() / length
    });
    let mut rest = Map::zeros(size);
    for (k, &(i, j)) in planes::<C>().iter().enumerate() {
        for a in 0..C {
            let mut moment = DoubleDouble::new(-map[(C + k, a)]);
            moment.add_product(arm[i], frame[(j, a)]);
            moment.add_product(-arm[j], frame[(i, a)]);
            moment.add(arm_rest[i] * frame[(j, a)]);
            moment.add(-arm_rest[j] * frame[(i, a)]);
            rest[(C + k, a)] = moment.value();
        }
    }
    (map, rest)
}
