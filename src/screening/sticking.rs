//! Three to five contacts, and a pair in space: the forces while every contact sticks.
//!
//! The springs are stretched by the commands, the object held in place; then the object lets go,
//! and moves by `q = T⁻¹ w` with the wrench w that was not balanced. Where stiffnesses differ much
//! T loses what the soft contacts add, but the balance of forces shows it: what they leave of the
//! load is solved for again. Forces that obey both the balance and the springs are right, however
//! little T is known.

use super::balance::RigidBody;
use super::finger::{Force, displacement, stretched};
use super::forces::{Forces, ON_THE_EDGE};
use super::lanes::Lanes;
use crate::contact::ZERO_SLACK as ROUNDING;

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

/// Commands of the fingers or a load, and what part of the forces that they bring about is called
/// rounding.
struct Pulled<const D: usize, const C: usize, const N: usize, const L: usize> {
    commands: Option<[Force<C, L>; N]>,
    load: [Lanes<L>; D],
    rounding: Lanes<L>,
}

/// Forces that the commands of the fingers alone bring about.
#[inline(always)]
pub(super) fn squeeze<const D: usize, const C: usize, const N: usize, const L: usize>(
    body: &RigidBody<D, C, N, L>,
    pressed: &[Lanes<L>; N],
    sheared: &[[Lanes<L>; N]; C],
) -> Forces<C, N, L> {
    let zero = Lanes::ZERO;
    let mut commands = [Force { normal: zero, tangential: [zero; C] }; N];
    for i in 0..N {
        commands[i].normal = pressed[i];
        for axis in 0..C {
            commands[i].tangential[axis] = sheared[axis][i];
        }
    }
    let rounding = Lanes::all(ON_THE_EDGE);
    sticking(body, &Pulled { commands: Some(commands), load: [Lanes::ZERO; D], rounding })
}

/// Forces that a load alone brings about, the fingers at rest.
#[inline(always)]
pub(super) fn load<const D: usize, const C: usize, const N: usize, const L: usize>(
    body: &RigidBody<D, C, N, L>,
    load: &[Lanes<L>; D],
) -> Forces<C, N, L> {
    sticking(body, &Pulled { commands: None, load: body.carried(load), rounding: Lanes::all(ROUNDING) })
}

#[inline(always)]
fn sticking<const D: usize, const C: usize, const N: usize, const L: usize>(
    body: &RigidBody<D, C, N, L>,
    pulled: &Pulled<D, C, N, L>,
) -> Forces<C, N, L> {
    let zero = Lanes::ZERO;
    let mut contacts = [Force { normal: zero, tangential: [zero; C] }; N];
    let (mut left, mut part) = (pulled.load, zero);
    if let Some(commands) = &pulled.commands {
        for i in 0..N {
            let [normal, tangential] = body.fingers[i].springs;
            contacts[i].normal = normal * commands[i].normal;
            for axis in 0..C {
                contacts[i].tangential[axis] = tangential * commands[i].tangential[axis];
            }
        }
        (left, part) = body.unbalanced(&contacts, &pulled.load);
    }
    let mut moved = [zero; D];
    for time in 0..=TIMES {
        let q = body.motion(&left);
        for k in 0..D {
            moved[k] += q[k];
        }
        for i in 0..N {
            let u = displacement(&body.arms[i], &q);
            let less = stretched(&body.fingers[i], &u);
            contacts[i].normal -= less.normal;
            for axis in 0..C {
                contacts[i].tangential[axis] -= less.tangential[axis];
            }
        }
        (left, part) = body.unbalanced(&contacts, &pulled.load);
        let improvable = part.above(Lanes::all(IMPROVED), Lanes::all(1.0), zero);
        if time == TIMES || improvable.0 == [0.0; L] {
            break;
        }
        // Lanes that are good stay as they are, whatever stands beside them.
        for entry in &mut left {
            *entry = improvable.above(zero, *entry, zero);
        }
    }
    let mut forces = with_rounding(body, pulled, &contacts, &moved);
    forces.unbalanced = part;
    forces.free = part.above(Lanes::all(GIVES_WAY), body.free(), zero);
    forces
}

/// The forces with a bound of their rounding: a part of the force, and a part of the force that its
/// spring would exert over the whole displacement that stretches and slackens it. The second is no
/// larger than forces are at all: displacements that ought to cancel leave forces only between two
/// contacts or more, so that the second stiffest of them sets the measure.
#[inline(always)]
fn with_rounding<const D: usize, const C: usize, const N: usize, const L: usize>(
    body: &RigidBody<D, C, N, L>,
    pulled: &Pulled<D, C, N, L>,
    contacts: &[Force<C, L>; N],
    moved: &[Lanes<L>; D],
) -> Forces<C, N, L> {
    let zero = Lanes::ZERO;
    let (mut shift, mut turn, mut largest) = (zero, zero, zero);
    for k in 0..D {
        if k < C {
            shift += moved[k].abs();
            largest += pulled.load[k].abs();
        } else {
            turn += moved[k].abs();
        }
    }
    let span = shift + turn * body.reach;
    let (mut sizes, mut stretched) = ([zero; N], [zero; N]);
    let (mut most, mut second) = (zero, zero);
    let mut forces = Forces::none();
    for i in 0..N {
        let [normal, tangential] = body.fingers[i].springs;
        stretched[i] = normal.max(tangential) * span;
        if let Some(commands) = &pulled.commands {
            stretched[i] += normal * commands[i].normal.abs();
        }
        sizes[i] = contacts[i].normal.abs();
        forces.normal[i] = contacts[i].normal;
        for axis in 0..C {
            if let Some(commands) = &pulled.commands {
                stretched[i] += tangential * commands[i].tangential[axis].abs();
            }
            sizes[i] += contacts[i].tangential[axis].abs();
            forces.tangential[axis][i] = contacts[i].tangential[axis];
        }
        largest += sizes[i];
        second = second.max(stretched[i].min(most));
        most = most.max(stretched[i]);
    }
    largest += second;
    for i in 0..N {
        forces.rounding[i] = pulled.rounding * (sizes[i] + largest.min(stretched[i]));
    }
    forces
}
