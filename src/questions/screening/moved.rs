//! Displacements of the object at its contacts while every contact sticks, computed from contact forces and compliances.
//!
//! The springs give the displacement of the object at each contact, `u = a - C F`. Here a is the command (the displacement that the finger would make
//! if there were no object), C the compliance and F the force. Displacements at both ends of a line e between contacts differ by `ω × e`, from which
//! the rotation ω follows.

use super::block::{Block, Commanded, MOST_SCREENED, entries};
use super::finger::{Force, world};
use super::forces::AnyForces;
use super::lanes::{Packed, cross, dot};
use super::springs::Cause;
use super::triangle::{self, Triangle, others};
use crate::numerics::{Each, Vectors};

/// A small motion of the object: displacements at its contacts, m, and its rotation, rad.
#[derive(Debug, Clone, Copy)]
pub(super) struct ObjectMotion<const C: usize, X: Packed> {
    /// Displacement of the object at each contact, along the coordinate axes, m.
    pub(super) at: [[X; C]; MOST_SCREENED],
    /// Rotation about the coordinate axes, rad; in the plane the first entry alone.
    pub(super) turn: [X; 3],
}

impl<const C: usize, X: Packed> ObjectMotion<C, X> {
    /// No motion: all displacements and the rotation zero.
    pub(super) fn none() -> Self {
        Self { at: [[X::all(0.0); C]; MOST_SCREENED], turn: [X::all(0.0); 3] }
    }
}

impl<const C: usize, X: Packed> ObjectMotion<C, X> {
    /// Computes the motion of an object held by two contacts in the plane, from the contact forces under these commands and this load.
    #[inline(never)]
    pub(super) fn of_a_pair<V: Vectors>(
        &mut self,
        v: V,
        block: &Block<'_, C, X>,
        cause: &Cause<'_, C, X>,
        forces: &AnyForces<C, X>,
    ) {
        v.run(
            #[inline(always)]
            || {
                let points = block.points();
                for i in 0..2 {
                    self.at[i] = off_the_spring(block, &cause.commands, i, &forces.of[i]);
                }
                let [x, y] = [0, 1].each(|axis| points[axis][1] - points[axis][0]);
                let [u, v] = [0, 1].each(|axis| self.at[1][axis] - self.at[0][axis]);
                self.turn[0] = (x * v - y * u) / (x * x + y * y);
            },
        );
    }

    /// Computes the motion of an object held by three contacts in space. Two edges e₁ and e₂ of the triangle of contacts have the normal vector
    /// `m = e₁ × e₂`. The displacements at the ends of these edges differ by d₁ and d₂. The rotation is
    /// `ω = (m·d₂ e₁ - m·d₁ e₂ + ½ (e₂·d₁ - e₁·d₂) m) / |m|²`.
    #[inline(never)]
    pub(super) fn of_a_triangle<V: Vectors>(
        &mut self,
        v: V,
        triangle: &Triangle<C, X>,
        block: &Block<'_, C, X>,
        cause: &Cause<'_, C, X>,
        forces: &AnyForces<C, X>,
    ) {
        v.run(
            #[inline(always)]
            || {
                for i in 0..triangle::N {
                    self.at[i] = off_the_spring(block, &cause.commands, i, &forces.of[i]);
                }
                let along = |k: usize| {
                    let [tail, head] = others(k);
                    let mut along = self.at[head];
                    for axis in 0..C {
                        along[axis] -= self.at[tail][axis];
                    }
                    along
                };
                let (m, [e_1, e_2]) = (&triangle.across, [&triangle.edge[1], &triangle.edge[2]]);
                let [d_1, d_2] = [along(1), along(2)];
                let twice = dot(e_2, &d_1) - dot(e_1, &d_2);
                let (x, y, z) = (dot(m, &d_2), dot(m, &d_1), X::all(0.5) * twice);
                for axis in 0..C {
                    self.turn[axis] =
                        triangle.one_over_square * ((x * e_1[axis] - y * e_2[axis]) + z * m[axis]);
                }
            },
        );
    }
}

/// The displacement `a - C F` of the object at a contact with the command a, the compliance C and the force F, along the coordinate axes.
#[inline(always)]
fn off_the_spring<const C: usize, X: Packed>(
    block: &Block<'_, C, X>,
    commands: &Commanded<'_, C, X>,
    i: usize,
    force: &Force<C, X>,
) -> [X; C] {
    let [c_n, c_t] = entries(&block.springs(), i);
    let mut left = *force;
    left.normal = commands.pressed[i] - c_n * force.normal;
    for axis in 0..C {
        left.tangential[axis] = commands.sheared[axis][i] - c_t * force.tangential[axis];
    }
    world(&entries(&block.normals(), i), &left)
}

/// The derivatives of the work `u·F` that a contact force F does along a motion of the object, with displacement u at the contact and rotation ω. The
/// derivative with respect to the contact point is `ω × F`. The derivative with respect to a rotation of the contact frame is `u × F`, returned as
/// `(u × F) × n` for a change of the normal n.
#[inline(always)]
pub(super) fn worked<const C: usize, X: Packed>([turn, at, force, normal]: [&[X; C]; 4]) -> ([X; C], [X; C]) {
    if const { C == 2 } {
        let (mut moved, mut tilted) = (*force, *normal);
        moved[0] = -(turn[0] * force[1]);
        moved[1] = turn[0] * force[0];
        let moment = at[0] * force[1] - at[1] * force[0];
        tilted[0] = -(moment * normal[1]);
        tilted[1] = moment * normal[0];
        return (moved, tilted);
    }
    (cross(turn, force), cross(&cross(at, force), normal))
}
