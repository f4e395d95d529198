//! Three to five contacts, and a pair in space: the forces while every contact sticks.
//!
//! The springs are stretched by the commands, the object held in place; then the object lets go,
//! and moves by `q = T⁻¹ w` with the wrench w that was not balanced. Where stiffnesses differ much
//! T loses what the soft contacts add, but the balance of forces shows it: what they leave of the
//! load is solved for again. Forces that obey both the balance and the springs are right, however
//! little T is known.

use super::balance::RigidBody;
use super::block::{Block, Commanded};
use super::finger::{Force, displacement, stretched};
use super::forces::{Forces, ON_THE_EDGE};
use super::lanes::Packed;
use super::method::Method;
use super::moved::ObjectMotion;
use super::springs::{Cause, StickingSprings};
use crate::contact::ZERO_SLACK as ROUNDING;
use crate::numerics::Vectors;

/// Forces that leave more than this part of the load unbalanced are improved. Rounding alone leaves
/// some 1e-15; with a larger bound forces would lose digits to a soft contact beside a stiff one,
/// with a smaller one they would be improved in vain.
const IMPROVED: f64 = 1e-14;
/// Times that they are improved at most. One is enough unless stiffnesses differ very much; forces
/// that three do not balance are called unclear.
const TIMES: usize = 3;
/// If motions are free and more than this part of the load stays unbalanced, it works on them. A
/// load that does not work on them leaves rounding alone; with a larger bound a load that drives
/// the object away weakly would be called unclear.
const GIVES_WAY: f64 = 1e-6;

impl<const D: usize, const C: usize, const M: usize, X: Packed> StickingSprings<C, M, X>
    for RigidBody<D, C, M, X>
{
    const METHOD: Method = Method::Motions;
    const CONTACTS: Option<usize> = None;

    fn none() -> Self {
        RigidBody::none()
    }

    #[inline(never)]
    fn prepare<V: Vectors>(&mut self, v: V, block: &Block<'_, C, X>) {
        v.run(
            #[inline(always)]
            || self.ready(block),
        );
    }

    #[inline(always)]
    fn load<V: Vectors>(&self, v: V, _: &Block<'_, C, X>, load: &[f64], forces: &mut Forces<C, M, X>) {
        sticking(v, self, None, load, forces);
    }

    #[inline(always)]
    fn squeeze<V: Vectors>(
        &self,
        v: V,
        block: &Block<'_, C, X>,
        others: Option<&Commanded<'_, C, X>>,
        forces: &mut Forces<C, M, X>,
    ) {
        let commands = others.copied().unwrap_or_else(|| block.commands());
        sticking(v, self, Some(&commands), &[0.0; 6], forces);
    }

    #[inline(never)]
    fn moved<V: Vectors>(
        &self,
        v: V,
        _: &Block<'_, C, X>,
        cause: &Cause<'_, C, X>,
        _: &Forces<C, M, X>,
        moved: &mut ObjectMotion<C, M, X>,
    ) {
        v.run(
            #[inline(always)]
            || move_object(self, cause, moved),
        );
    }
}

/// Forces that the commands of the fingers alone bring about, or a load alone, the fingers at rest.
#[inline(never)]
fn sticking<V: Vectors, const D: usize, const C: usize, const M: usize, X: Packed>(
    v: V,
    body: &RigidBody<D, C, M, X>,
    commands: Option<&Commanded<'_, C, X>>,
    load: &[f64],
    forces: &mut Forces<C, M, X>,
) {
    v.run(
        #[inline(always)]
        || stretch(body, commands, load, forces),
    );
}

#[inline(always)]
fn stretch<const D: usize, const C: usize, const M: usize, X: Packed>(
    body: &RigidBody<D, C, M, X>,
    commands: Option<&Commanded<'_, C, X>>,
    load: &[f64],
    forces: &mut Forces<C, M, X>,
) {
    let zero = X::all(0.0);
    let fingers = body.fingers();
    let mut lanes = [zero; D];
    for k in 0..D {
        lanes[k] = X::all(load[k]);
    }
    let load = if commands.is_none() { body.carried(&lanes) } else { lanes };
    let Settled { contacts, moved, part } = let_go(body, commands, &load);
    forces.of[..fingers.len()].copy_from_slice(&contacts[..fingers.len()]);
    bound_rounding(body, commands, &load, &moved, forces);
    forces.unbalanced = part;
    forces.free = part.above(X::all(GIVES_WAY), body.free(), zero);
}

/// Forces, the motion of the object, and which part of the load is left.
struct Settled<const D: usize, const C: usize, const M: usize, X: Packed> {
    contacts: [Force<C, X>; M],
    moved: [X; D],
    part: X,
}

/// Where the object settles under commands and a load about the centroid.
#[inline(always)]
fn let_go<const D: usize, const C: usize, const M: usize, X: Packed>(
    body: &RigidBody<D, C, M, X>,
    commands: Option<&Commanded<'_, C, X>>,
    load: &[X; D],
) -> Settled<D, C, M, X> {
    let zero = X::all(0.0);
    let fingers = body.fingers();
    let mut contacts = [Force { normal: zero, tangential: [zero; C] }; M];
    for (i, (finger, force)) in fingers.iter().zip(&mut contacts).enumerate() {
        if let Some(commands) = commands {
            let [normal, tangential] = finger.springs;
            force.normal = normal * commands.pressed[i];
            for axis in 0..C {
                force.tangential[axis] = tangential * commands.sheared[axis][i];
            }
        }
    }
    let (mut left, mut part) =
        if commands.is_some() { body.unbalanced(&contacts, load) } else { (*load, zero) };
    let mut moved = [zero; D];
    for time in 0..=TIMES {
        let q = body.motion(&left);
        for k in 0..D {
            moved[k] += q[k];
        }
        for (finger, force) in fingers.iter().zip(&mut contacts) {
            let u = displacement(&finger.arm, &q);
            let less = stretched(finger, &u);
            force.normal -= less.normal;
            for axis in 0..C {
                force.tangential[axis] -= less.tangential[axis];
            }
        }
        (left, part) = body.unbalanced(&contacts, load);
        let improvable = part.above(X::all(IMPROVED), X::all(1.0), zero);
        if time == TIMES || improvable.is_all(0.0) {
            break;
        }
        // Lanes that are good stay as they are, whatever stands beside them.
        for entry in &mut left {
            *entry = improvable.above(zero, *entry, zero);
        }
    }
    Settled { contacts, moved, part }
}

/// The displacements of contacts where the object settles. What moves freely makes them no numbers: it may be anywhere.
#[inline(always)]
fn move_object<const D: usize, const C: usize, const M: usize, X: Packed>(
    body: &RigidBody<D, C, M, X>,
    cause: &Cause<'_, C, X>,
    moved: &mut ObjectMotion<C, M, X>,
) {
    let mut load = [X::all(0.0); D];
    load.copy_from_slice(&cause.load[..D]);
    let mut settled = let_go(body, Some(&cause.commands), &body.carried(&load));
    for entry in &mut settled.moved {
        *entry = body.free().above(X::all(0.0), X::all(f64::NAN), *entry);
    }
    for (at, finger) in moved.at.iter_mut().zip(body.fingers()) {
        *at = displacement(&finger.arm, &settled.moved);
    }
    moved.turn[..D - C].copy_from_slice(&settled.moved[C..]);
}

/// Bounds the rounding of forces: a part of the force, and a part of the force that its
/// spring would exert over the whole displacement that stretches and slackens it. The second is no
/// larger than forces are at all: displacements that ought to cancel leave forces only between two
/// contacts or more, so that the second stiffest of them sets the measure.
#[inline(always)]
fn bound_rounding<const D: usize, const C: usize, const M: usize, X: Packed>(
    body: &RigidBody<D, C, M, X>,
    commands: Option<&Commanded<'_, C, X>>,
    load: &[X; D],
    moved: &[X; D],
    forces: &mut Forces<C, M, X>,
) {
    let zero = X::all(0.0);
    let fingers = body.fingers();
    let (mut shift, mut turn, mut largest) = (zero, zero, zero);
    for k in 0..D {
        if k < C {
            shift += moved[k].abs();
            largest += load[k].abs();
        } else {
            turn += moved[k].abs();
        }
    }
    let span = shift + turn * body.reach;
    let mut sizes = [zero; M];
    let (mut most, mut second) = (zero, zero);
    for (i, finger) in fingers.iter().enumerate() {
        let [normal, tangential] = finger.springs;
        let mut stretched = normal.max(tangential) * span;
        let force = &forces.of[i];
        sizes[i] = force.normal.abs();
        if let Some(commands) = commands {
            stretched += normal * commands.pressed[i].abs();
        }
        for axis in 0..C {
            if let Some(commands) = commands {
                stretched += tangential * commands.sheared[axis][i].abs();
            }
            sizes[i] += force.tangential[axis].abs();
        }
        largest += sizes[i];
        second = second.max(stretched.min(most));
        most = most.max(stretched);
        forces.rounding[i] = stretched;
    }
    largest += second;
    let rounding = X::all(if commands.is_some() { ON_THE_EDGE } else { ROUNDING });
    for (rounded, size) in forces.rounding.iter_mut().zip(sizes).take(fingers.len()) {
        *rounded = rounding * (size + largest.min(*rounded));
    }
}
