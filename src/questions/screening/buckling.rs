//! A bound that shows that a sticking grasp does not buckle, for several grasps, one in each lane of a vector. Contact forces and the load reduce the
//! stiffness against rotation, because their points of action turn with the object.
//!
//! Let contact i be at least as stiff as k_i in every direction, and let r_i be its arm from the centroid of the contacts weighted by k_i. The
//! springs resist rotations about this centroid with at least the stiffness `J = Σ k_i (|r_i|² 1 - r_i r_iᵀ)`. Forces F at arms r, of contacts and
//! loads, add the geometric stiffness `M = Σ (F·r) 1 - ½ (F rᵀ + r Fᵀ)`. In the plane both are numbers, `Σ k_i |r_i|²` and `Σ F·r`. The grasp does
//! not buckle while all eigenvalues of J⁻¹ M are above -1. The trace `tr (J⁻¹ M)²` is the sum of their squares, so all are above -1 if the trace is
//! below 1.
//!
//! The arms of forces hardly change while the rotation θ is small. Let F be the largest elastic force, ρ the largest arm and k the stiffness of the
//! stiffest spring. The elastic work exceeds F²/k and θ²/tr J⁻¹, and with them the mean `|F| θ / √(k tr J⁻¹)`. A change of arms, at most `½ θ² 2ρ`, thus
//! does at most the part `θ ρ √(k tr J⁻¹)` of the elastic work.

use super::block::{Block, count, entries};
use super::factors::LaneFactors;
use super::finger::{Force, world};
use super::lanes::{Packed, dot};
use super::method::Method;
use crate::numerics::Vectors;

/// A lower bound J of the stiffness against rotation.
pub(super) struct RotationalStiffness<const C: usize, X: Packed> {
    /// The centroid of the contacts, weighted with their stiffnesses, m.
    centre: [X; C],
    factors: LaneFactors<3, X>,
    /// The number `ρ √(k tr J⁻¹)` of the head of this file.
    pub(super) leverage: X,
}

/// A load with its points of action.
pub(super) struct LoadAtPoints<const C: usize, X: Packed> {
    /// The resultant force, N; zero if the points of action are not known, so that the load then adds no stiffness.
    pub(super) force: [X; C],
    /// For components a and b, the sum of `F_a r_b` over the forces F of the load, with their points of action r, N m; zero if the points are not
    /// known.
    pub(super) moments: [[X; C]; C],
}

impl<const C: usize, X: Packed> RotationalStiffness<C, X> {
    /// The lower bound J for the contacts of a block. The block stores compliances for [`Method::Edges`], stiffnesses for [`Method::Motions`].
    #[inline(never)]
    pub(super) fn of<V: Vectors>(v: V, block: &Block<'_, C, X>, method: Method) -> Self {
        let zero = X::all(0.0);
        let mut stiffness = Self { centre: [zero; C], factors: LaneFactors::none(), leverage: zero };
        v.run(
            #[inline(always)]
            || stiffness.compute(block, method),
        );
        stiffness
    }

    #[inline(always)]
    fn compute(&mut self, block: &Block<'_, C, X>, method: Method) {
        // The least and the largest stiffness of a contact.
        let bounds = |i: usize| {
            let [normal, tangential] = entries(&block.springs(), i);
            let (least, largest) = (normal.min(tangential), normal.max(tangential));
            match method {
                Method::Edges => [X::all(1.0) / largest, X::all(1.0) / least],
                Method::Motions => [least, largest],
            }
        };
        let least = |i: usize| bounds(i)[0];
        let mut stiffness = X::all(0.0);
        for i in 0..count(block.contacts) {
            let (k, point) = (least(i), entries(&block.points(), i));
            stiffness += k;
            for axis in 0..C {
                self.centre[axis] += k * point[axis];
            }
        }
        for axis in 0..C {
            self.centre[axis] = self.centre[axis] / stiffness;
        }
        let [mut stiffest, mut farthest, mut compliance] = [X::all(0.0); 3];
        for i in 0..count(block.contacts) {
            let arm = self.arm(block, i);
            stiffest = stiffest.max(bounds(i)[1]);
            farthest = farthest.max(dot(&arm, &arm));
            let mut pull = arm;
            for axis in 0..C {
                pull[axis] = least(i) * arm[axis];
            }
            add(&mut self.factors.entries, &pull, &arm);
        }
        self.factors.factorize(rotations(C), false);
        for k in 0..rotations(C) {
            let mut unit = [X::all(0.0); 3];
            unit[k] = X::all(1.0);
            compliance += self.factors.solve(rotations(C), &unit)[k];
        }
        self.leverage = (farthest * stiffest * compliance).sqrt();
    }

    #[inline(always)]
    fn arm(&self, block: &Block<'_, C, X>, i: usize) -> [X; C] {
        let mut arm = entries(&block.points(), i);
        for axis in 0..C {
            arm[axis] -= self.centre[axis];
        }
        arm
    }

    /// The square root of `tr (J⁻¹ M)²`, with the matrices J and M at the top of the file. It is no smaller than the fraction of the stiffness
    /// against rotation that these contact forces and this load take away, or add, in any rotation. NaN if some rotation is not resisted, and if no
    /// contact carries a force, so that the object lies loose.
    #[inline(never)]
    pub(super) fn taken<V: Vectors>(
        &self,
        v: V,
        block: &Block<'_, C, X>,
        forces: &[Force<C, X>],
        load: &LoadAtPoints<C, X>,
    ) -> X {
        let mut taken = X::all(f64::NAN);
        v.run(
            #[inline(always)]
            || taken = self.part_taken(block, forces, load),
        );
        taken
    }

    #[inline(always)]
    fn part_taken(&self, block: &Block<'_, C, X>, forces: &[Force<C, X>], load: &LoadAtPoints<C, X>) -> X {
        let (zero, nan) = (X::all(0.0), X::all(f64::NAN));
        let mut geometric = [[zero; 3]; 3];
        let mut squares = zero;
        for (i, force) in forces.iter().enumerate().take(count(block.contacts)) {
            let force = world(&entries(&block.normals(), i), force);
            squares += dot(&force, &force);
            add(&mut geometric, &force, &self.arm(block, i));
        }
        let mut moved = load.moments;
        for a in 0..C {
            for b in 0..C {
                moved[a][b] -= load.force[a] * self.centre[b];
            }
        }
        add_moments(&mut geometric, &moved);
        let rows = rotations(C);
        // Columns of J⁻¹ M. Only entries of M on and below the diagonal are stored.
        let mut columns = [[zero; 3]; 3];
        for k in 0..rows {
            let mut column = [zero; 3];
            for row in 0..rows {
                column[row] = if row < k { geometric[k][row] } else { geometric[row][k] };
            }
            columns[k] = self.factors.solve(rows, &column);
        }
        let mut trace = zero;
        for a in 0..rows {
            for b in 0..rows {
                trace += columns[a][b] * columns[b][a];
            }
        }
        let taken = squares.above(zero, trace.abs().sqrt(), nan);
        self.factors.free.above(zero, nan, taken)
    }
}

/// Number of rotations: one in the plane, three in space.
const fn rotations(axes: usize) -> usize {
    2 * axes - 3
}

/// Adds the stiffness against rotation of a force with the lever arm `arm` to the matrix `stiffness`. Only entries on and below the diagonal change.
#[inline(always)]
fn add<const C: usize, X: Packed>(stiffness: &mut [[X; 3]; 3], force: &[X; C], arm: &[X; C]) {
    let mut moments = [*arm; C];
    for a in 0..C {
        for b in 0..C {
            moments[a][b] = force[a] * arm[b];
        }
    }
    add_moments(stiffness, &moments);
}

/// Adds the matrix `(tr V) 1 - ½ (V + Vᵀ)` to `stiffness`; in the plane tr V alone. V is the sum of `F rᵀ` over forces F with lever arms r
/// (`moments`).
#[inline(always)]
fn add_moments<const C: usize, X: Packed>(stiffness: &mut [[X; 3]; 3], moments: &[[X; C]; C]) {
    let mut trace = moments[0][0];
    for axis in 1..C {
        trace += moments[axis][axis];
    }
    if const { C == 2 } {
        stiffness[0][0] += trace;
        return;
    }
    for row in 0..C {
        stiffness[row][row] += trace - moments[row][row];
        for column in 0..row {
            stiffness[row][column] -= X::all(0.5) * (moments[row][column] + moments[column][row]);
        }
    }
}
