//! Bounds of what turning forces do to a sticking grasp, for several grasps, one in each lane of a vector. Contact forces and the load reduce the
//! stiffness against rotation, because their points of action turn with the object.
//!
//! Let contact i be at least as stiff as k_i in every direction, and let r_i be its arm from the centroid of the contacts weighted by k_i. The
//! springs resist rotations about this centroid with at least the stiffness `J = Σ k_i (|r_i|² 1 - r_i r_iᵀ)`. Forces F at arms r, of contacts and
//! loads, add the geometric stiffness `M = Σ (F·r) 1 - ½ (F rᵀ + r Fᵀ)`. In the plane both are numbers, `Σ k_i |r_i|²` and `Σ F·r`. The grasp does
//! not buckle while all eigenvalues of J⁻¹ M are above -1. The trace `tr (J⁻¹ M)²` is the sum of their squares, so all are above -1 if the trace is
//! below 1.
//!
//! The geometric stiffness enlarges a rotation θ by at most `√(tr J⁻¹ · Mθ·J⁻¹Mθ) / (1 - t)`, with the square root t of that trace.
//!
//! Beyond the first order the arm r of a force changes by at most `½ |θ|² |r|`. The force `K_i u_i` by which contact i resists its displacement u_i
//! does at most the work `½ |θ|² |r_i| |K_i u_i|` along this change. All springs together do the elastic work `Σ u·K u`.

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
    /// The trace of J⁻¹, rad/(N m).
    compliance: X,
}

/// Upper bounds of what the geometric stiffness and the change of arms do to an equilibrium in which every contact sticks.
#[derive(Clone, Copy)]
pub(super) struct RotationBounds<X: Packed> {
    /// The fraction of the stiffness against rotation that contact forces and load take away, or add, in any rotation. NaN if some rotation is not
    /// resisted, and if no contact carries a force, so that the object lies loose.
    pub(super) taken: X,
    /// The rotation after the geometric stiffness has enlarged it, rad; without meaning unless `taken` is below 1.
    pub(super) grown: X,
    /// The work that a contact does along the change of its arm, as a part of the elastic work.
    pub(super) arms: X,
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
    /// The lower bound J for the contacts of a block.
    #[inline(never)]
    pub(super) fn of<V: Vectors>(v: V, block: &Block<'_, C, X>, method: Method) -> Self {
        let zero = X::all(0.0);
        let mut stiffness = Self { centre: [zero; C], factors: LaneFactors::none(), compliance: zero };
        v.run(
            #[inline(always)]
            || stiffness.compute(block, method),
        );
        stiffness
    }

    #[inline(always)]
    fn compute(&mut self, block: &Block<'_, C, X>, method: Method) {
        let least = |i: usize| {
            let [normal, tangential] = stiffnesses(block, method, i);
            normal.min(tangential)
        };
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
        for i in 0..count(block.contacts) {
            let arm = self.arm(block, i);
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
            self.compliance += self.factors.solve(rotations(C), &unit)[k];
        }
    }

    #[inline(always)]
    fn arm(&self, block: &Block<'_, C, X>, i: usize) -> [X; C] {
        let mut arm = entries(&block.points(), i);
        for axis in 0..C {
            arm[axis] -= self.centre[axis];
        }
        arm
    }

    /// The bounds for these contact forces and this load, which turn the object by `turn`, rad.
    #[inline(never)]
    pub(super) fn bounds<V: Vectors>(
        &self,
        v: V,
        (block, method): (&Block<'_, C, X>, Method),
        (forces, load): (&[Force<C, X>], &LoadAtPoints<C, X>),
        turn: &[X; 3],
    ) -> RotationBounds<X> {
        let mut bounds = RotationBounds { taken: X::all(0.0), grown: X::all(0.0), arms: X::all(0.0) };
        v.run(
            #[inline(always)]
            || {
                [bounds.taken, bounds.grown] = self.of_geometric_stiffness(block, (forces, load), turn);
                bounds.arms = self.work_of_arms((block, method), forces, turn);
            },
        );
        bounds
    }

    /// The bound `t = √tr (J⁻¹ M)²` of the fraction taken, and that of the enlarged rotation, `|θ| + √(tr J⁻¹ · Mθ·J⁻¹Mθ) / (1 - t)`.
    #[inline(always)]
    fn of_geometric_stiffness(
        &self,
        block: &Block<'_, C, X>,
        (forces, load): (&[Force<C, X>], &LoadAtPoints<C, X>),
        turn: &[X; 3],
    ) -> [X; 2] {
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
        let mut turned = [zero; 3];
        for k in 0..rows {
            let mut column = [zero; 3];
            for row in 0..rows {
                column[row] = if row < k { geometric[k][row] } else { geometric[row][k] };
                turned[row] += column[row] * turn[k];
            }
            columns[k] = self.factors.solve(rows, &column);
        }
        let growth = (self.compliance * dot(&turned, &self.factors.solve(rows, &turned))).abs().sqrt();
        let mut trace = zero;
        for a in 0..rows {
            for b in 0..rows {
                trace += columns[a][b] * columns[b][a];
            }
        }
        let taken = squares.above(zero, trace.abs().sqrt(), nan);
        let grown = dot(turn, turn).sqrt() + growth / (X::all(1.0) - taken);
        [self.factors.free.above(zero, nan, taken), grown]
    }

    /// The largest work of a contact along the change of its arm, as a part of the elastic work; zero without elastic work.
    #[inline(always)]
    fn work_of_arms(
        &self,
        (block, method): (&Block<'_, C, X>, Method),
        forces: &[Force<C, X>],
        turn: &[X; 3],
    ) -> X {
        let commands = block.commands();
        let [mut elastic, mut strongest, mut farthest, zero] = [X::all(0.0); 4];
        for (i, force) in forces.iter().enumerate().take(count(block.contacts)) {
            let [normal, tangential] = stiffnesses(block, method, i);
            let along = commands.pressed[i] - force.normal / normal;
            let mut squares = zero;
            for axis in 0..C {
                let across = commands.sheared[axis][i] - force.tangential[axis] / tangential;
                squares += across * across;
            }
            let (along, across) = (normal * along * along, tangential * squares);
            elastic += along + across;
            let arm = self.arm(block, i);
            strongest = strongest.max(normal * along + tangential * across);
            farthest = farthest.max(dot(&arm, &arm));
        }
        // Arms are about the centroid of the contacts. They are at most twice the largest distance of a contact from `centre`.
        let part = dot(turn, turn) * (strongest * farthest).sqrt() / elastic;
        elastic.above(zero, part, zero) + zero * elastic
    }
}

/// The normal and the tangential stiffness of a contact, N/m. A block stores compliances for [`Method::Edges`], stiffnesses for [`Method::Motions`].
#[inline(always)]
fn stiffnesses<const C: usize, X: Packed>(block: &Block<'_, C, X>, method: Method, i: usize) -> [X; 2] {
    let [normal, tangential] = entries(&block.springs(), i);
    match method {
        Method::Edges => [X::all(1.0) / normal, X::all(1.0) / tangential],
        Method::Motions => [normal, tangential],
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
