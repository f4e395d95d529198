//! Contact forces while every contact sticks, computed from the motion of the object. This is the method for two contacts in space, and for three or
//! more contacts, unless forces along the lines between contacts are the unknowns ([`Method::Edges`](super::method::Method::Edges)). A lane is the
//! place of one grasp in a SIMD vector, whose numbers are computed side by side.
//!
//! First the commands (displacements that the fingers would make if there were no object) stretch the springs with the object held in place. Then the
//! object is released and moves by `q = T⁻¹ w`, with the stiffness matrix T. The wrench w is the sum of the load and of the spring forces on the
//! object before this motion. If stiffnesses differ much, T loses the contribution of the soft contacts. The resulting forces then do not balance the
//! load. The residual becomes w, and the motion is computed again. Forces that satisfy both the balance and the spring law are right, however
//! inaccurate T is.

use super::balance::RigidBody;
use super::block::{Block, Commanded, Layout, MOST_SCREENED, entries};
use super::finger::{Force, displacement, stretched};
use super::forces::AnyForces;
use super::lanes::Packed;
use super::moved::ObjectMotion;
use super::springs::Cause;
use super::tolerances::{IMPROVABLE, ON_THE_EDGE, WORKS_ON_FREE_MOTION};
use crate::contact::ZERO_SLACK;
use crate::numerics::Vectors;

impl<const C: usize, X: Packed> RigidBody<C, X> {
    #[inline(never)]
    pub(super) fn prepare<V: Vectors>(&mut self, v: V, block: &Block<'_, C, X>) {
        v.run(
            #[inline(always)]
            || self.ready(block),
        );
    }

    /// Computes the contact forces while every contact sticks. With `commands`, commands and the load act together, and the moment of `load` is given
    /// about the centroid of the contacts. With `None` the load acts alone, and its moment is given about the origin of the coordinates.
    #[inline(never)]
    pub(super) fn sticking<V: Vectors>(
        &self,
        v: V,
        block: &Block<'_, C, X>,
        commands: Option<&Commanded<'_, C, X>>,
        load: &[X; 6],
        forces: &mut AnyForces<C, X>,
    ) {
        v.run(
            #[inline(always)]
            || stretch(self, block, commands, load, forces),
        );
    }

    #[inline(never)]
    pub(super) fn moved<V: Vectors>(
        &self,
        v: V,
        block: &Block<'_, C, X>,
        cause: &Cause<'_, C, X>,
        moved: &mut ObjectMotion<C, X>,
    ) {
        v.run(
            #[inline(always)]
            || move_object(self, block, cause, moved),
        );
    }
}

#[inline(always)]
fn stretch<const C: usize, X: Packed>(
    body: &RigidBody<C, X>,
    block: &Block<'_, C, X>,
    commands: Option<&Commanded<'_, C, X>>,
    load: &[X; 6],
    forces: &mut AnyForces<C, X>,
) {
    let load = if commands.is_none() { body.carried(load) } else { *load };
    let (moved, part) = let_go(body, block, commands, &load, &mut forces.of);
    bound_rounding(body, block, commands, &load, &moved, forces);
    forces.motion = moved;
    forces.unbalanced = part;
    forces.free = part.above(X::all(WORKS_ON_FREE_MOTION), body.free(), X::all(0.0));
}

/// Computes the equilibrium with all contacts sticking, under commands and a load whose moment is about the centroid of the contacts. Writes the
/// contact forces; returns the motion of the object, and how much of the load stays unbalanced, relative to the forces.
#[inline(always)]
fn let_go<const C: usize, X: Packed>(
    body: &RigidBody<C, X>,
    block: &Block<'_, C, X>,
    commands: Option<&Commanded<'_, C, X>>,
    load: &[X; 6],
    contacts: &mut [Force<C, X>],
) -> ([X; 6], X) {
    let zero = X::all(0.0);
    let contacts = &mut contacts[..block.contacts];
    for (i, force) in contacts.iter_mut().enumerate() {
        *force = Force::none();
        if let Some(commands) = commands {
            let [normal, tangential] = entries(&block.springs(), i);
            force.normal = normal * commands.pressed[i];
            for axis in 0..C {
                force.tangential[axis] = tangential * commands.sheared[axis][i];
            }
        }
    }
    let (mut left, mut part) =
        if commands.is_some() { body.unbalanced(block, contacts, load) } else { (*load, zero) };
    let mut moved = [zero; 6];
    // One refinement (a repetition for the residual) is enough unless stiffnesses differ very much. If forces are still unbalanced after three
    // refinements, the answer for this grasp is undecided.
    let most_times = 3;
    for time in 0..=most_times {
        let q = body.motion(&left);
        for k in 0..Layout::<C>::COORDINATES {
            moved[k] += q[k];
        }
        for (i, force) in contacts.iter_mut().enumerate() {
            let finger = body.finger(block, i);
            let u = displacement(&finger.arm, &q);
            let less = stretched(&finger, &u);
            force.normal -= less.normal;
            for axis in 0..C {
                force.tangential[axis] -= less.tangential[axis];
            }
        }
        (left, part) = body.unbalanced(block, contacts, load);
        let improvable = part.above(X::all(IMPROVABLE), X::all(1.0), zero);
        if time == most_times || improvable.is_all(0.0) {
            break;
        }
        // Refinement goes on until no lane can be improved. For grasps whose relative imbalance of forces is at most `IMPROVABLE` already, the
        // residual is set to zero. Thus the number of refinements that grasps in other lanes need does not change their answers.
        for entry in &mut left {
            *entry = improvable.above(zero, *entry, zero);
        }
    }
    (moved, part)
}

/// Writes the displacements of the object at its contacts, and its rotation, in the equilibrium under commands and load. NaN if some motion stretches
/// no spring, since the position is then not determined.
#[inline(always)]
fn move_object<const C: usize, X: Packed>(
    body: &RigidBody<C, X>,
    block: &Block<'_, C, X>,
    cause: &Cause<'_, C, X>,
    moved: &mut ObjectMotion<C, X>,
) {
    let mut forces = [Force::none(); MOST_SCREENED];
    let load = body.carried(&cause.load);
    let (mut motion, _) = let_go(body, block, Some(&cause.commands), &load, &mut forces);
    for entry in &mut motion {
        *entry = body.free().above(X::all(0.0), X::all(f64::NAN), *entry);
    }
    for (i, at) in moved.at.iter_mut().enumerate().take(block.contacts) {
        *at = displacement(&body.finger(block, i).arm, &motion);
    }
    let coordinates = Layout::<C>::COORDINATES;
    moved.turn[..coordinates - C].copy_from_slice(&motion[C..coordinates]);
}

/// Bounds the rounding error of each contact force by a fraction of the sum of two terms. The first term is the force itself. The second term is the
/// force that the contact's spring would exert if it were stretched by the command and the whole motion of the object. Errors of displacements cause
/// forces that balance each other, which takes at least two contacts. The second term is therefore limited to the sum of the load, all contact forces
/// and the second largest spring force.
#[inline(always)]
fn bound_rounding<const C: usize, X: Packed>(
    body: &RigidBody<C, X>,
    block: &Block<'_, C, X>,
    commands: Option<&Commanded<'_, C, X>>,
    load: &[X; 6],
    moved: &[X; 6],
    forces: &mut AnyForces<C, X>,
) {
    let zero = X::all(0.0);
    let (mut shift, mut turn, mut largest) = (zero, zero, zero);
    for k in 0..Layout::<C>::COORDINATES {
        if k < C {
            shift += moved[k].abs();
            largest += load[k].abs();
        } else {
            turn += moved[k].abs();
        }
    }
    let span = shift + turn * body.reach;
    let (mut most, mut second) = (zero, zero);
    for (i, force) in forces.of.iter_mut().enumerate().take(block.contacts) {
        let [normal, tangential] = entries(&block.springs(), i);
        let mut stretched = normal.max(tangential) * span;
        let mut size = force.normal.abs();
        if let Some(commands) = commands {
            stretched += normal * commands.pressed[i].abs();
        }
        for axis in 0..C {
            if let Some(commands) = commands {
                stretched += tangential * commands.sheared[axis][i].abs();
            }
            size += force.tangential[axis].abs();
        }
        largest += size;
        second = second.max(stretched.min(most));
        most = most.max(stretched);
        force.rounding = stretched;
    }
    largest += second;
    let rounding = X::all(if commands.is_some() { ON_THE_EDGE } else { ZERO_SLACK });
    for force in forces.of.iter_mut().take(block.contacts) {
        let mut size = force.normal.abs();
        for axis in 0..C {
            size += force.tangential[axis].abs();
        }
        force.rounding = rounding * (size + largest.min(force.rounding));
    }
}
