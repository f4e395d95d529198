//! One contact of each of several grasps, one grasp in each lane of a vector. The file has the springs of the contact, and converts its force and
//! displacement to coordinate axes.

use super::lanes::{Packed, dot};

/// One contact of each of several grasps, one in each lane of a vector: unit normal, normal and tangential stiffness, and arm.
#[derive(Debug, Clone, Copy)]
pub(super) struct LaneFinger<const C: usize, X: Packed> {
    pub(super) normal: [X; C],
    pub(super) springs: [X; 2],
    /// The vector from the centroid of the contacts to the contact, m.
    pub(super) arm: [X; C],
}

/// The force of a contact, N, or the stretch of its springs, m. `tangential` is in space a vector in coordinate axes; in the plane its first entry is
/// the component along (n_y, -n_x).
#[derive(Debug, Clone, Copy)]
pub(super) struct Force<const C: usize, X: Packed> {
    pub(super) normal: X,
    pub(super) tangential: [X; C],
    /// Bound of the rounding error of the force, N.
    pub(super) rounding: X,
}

impl<const C: usize, X: Packed> Force<C, X> {
    /// A zero force, without rounding error.
    #[inline(always)]
    pub(super) fn none() -> Self {
        Self { normal: X::all(0.0), tangential: [X::all(0.0); C], rounding: X::all(0.0) }
    }
}

/// The moment `arm × f` of the force f at this arm; in the plane its only component is the first entry.
#[inline(always)]
pub(super) fn moment<const C: usize, X: Packed>(arm: &[X; C], f: &[X; C]) -> [X; 3] {
    let zero = X::all(0.0);
    if const { C == 2 } {
        [arm[0] * f[1] - arm[1] * f[0], zero, zero]
    } else {
        [
            arm[1] * f[2 % C] - arm[2 % C] * f[1],
            arm[2 % C] * f[0] - arm[0] * f[2 % C],
            arm[0] * f[1] - arm[1] * f[0],
        ]
    }
}

/// The displacement, in coordinate axes, of the point at `arm` from the centroid under the motion q of the object (translation, then rotation).
#[inline(always)]
pub(super) fn displacement<const C: usize, X: Packed>(arm: &[X; C], q: &[X; 6]) -> [X; C] {
    let mut u = *arm;
    if const { C == 2 } {
        u[0] = q[0] - q[2] * arm[1];
        u[1] = q[1] + q[2] * arm[0];
    } else {
        for axis in 0..C {
            let (next, last) = ((axis + 1) % C, (axis + 2) % C);
            u[axis] = q[axis] + (q[C + next] * arm[last] - q[C + last] * arm[next]);
        }
    }
    u
}

/// A force, or a displacement, in coordinate axes, from its components along and across the normal n.
#[inline(always)]
pub(super) fn world<const C: usize, X: Packed>(n: &[X; C], force: &Force<C, X>) -> [X; C] {
    let mut world = force.tangential;
    if const { C == 2 } {
        world = [X::all(0.0); C];
        world[0] = n[1] * force.tangential[0];
        world[1] = -(n[0] * force.tangential[0]);
    }
    for axis in 0..C {
        world[axis] += n[axis] * force.normal;
    }
    world
}

/// The force of a contact whose springs are stretched by the vector `s`, m, in coordinate axes.
#[inline(always)]
pub(super) fn stretched<const C: usize, X: Packed>(finger: &LaneFinger<C, X>, s: &[X; C]) -> Force<C, X> {
    let [normal, tangential] = finger.springs;
    let n = &finger.normal;
    let along = dot(n, s);
    let mut across = [X::all(0.0); C];
    if const { C == 2 } {
        across[0] = tangential * (n[1] * s[0] - n[0] * s[1]);
    } else {
        for axis in 0..C {
            across[axis] = tangential * (s[axis] - n[axis] * along);
        }
    }
    Force { normal: normal * along, tangential: across, rounding: X::all(0.0) }
}
