//! Moments and rotations written once for the plane and for space.
//!
//! A rotation turns a plane (i, j): the plane has one, (x, y); space has three, (y, z), (z, x), (x, y), which are the
//! rotations about x, y and z. With r the arm, f a force and θ the rotations,
//!
//! ```text
//! moment_k       = r_i f_j - r_j f_i
//! displacement_i = -θ_k r_j,   displacement_j = θ_k r_i
//! ```
//!
//! so that `d = c + c(c-1)/2`: 3 degrees of freedom in the plane (c = 2), 6 in space (c = 3).

use nalgebra::{SMatrix, SVector};

/// The planes of rotation of a space with `C` axes.
pub(crate) const fn planes<const C: usize>() -> &'static [(usize, usize)] {
    match C {
        2 => &[(0, 1)],
        3 => &[(1, 2), (2, 0), (0, 1)],
        _ => &[],
    }
}

/// Wrench (force, moment about the origin of `arm`) of the force `f` at the end of `arm`.
pub(crate) fn wrench_of<const D: usize, const C: usize>(
    arm: &SVector<f64, C>,
    f: &SVector<f64, C>,
) -> SVector<f64, D> {
    let mut w = SVector::zeros();
    for a in 0..C {
        w[a] = f[a];
    }
    for (k, &(i, j)) in planes::<C>().iter().enumerate() {
        w[C + k] = arm[i] * f[j] - arm[j] * f[i];
    }
    w
}

/// Displacement, to first order, of the point at the end of `arm` under the twist (translation, rotation).
pub(crate) fn displacement_of<const D: usize, const C: usize>(
    arm: &SVector<f64, C>,
    twist: &SVector<f64, D>,
) -> SVector<f64, C> {
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

/// The grasp map of one contact, `d x c`: the columns are the wrenches of unit forces along the axes of its frame.
pub(crate) fn grasp_map<const D: usize, const C: usize>(
    arm: &SVector<f64, C>,
    frame: &SMatrix<f64, C, C>,
) -> SMatrix<f64, D, C> {
    let mut map: SMatrix<f64, D, C> = SMatrix::zeros();
    for a in 0..C {
        map.set_column(a, &wrench_of::<D, C>(arm, &frame.column(a).into_owned()));
    }
    map
}
