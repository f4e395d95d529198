//! Three to five contacts, and a pair in space: the forces while every contact rolls.
//!
//! The springs are stretched by the commands, the object held in place; then the object lets go, and moves by `q = T⁻¹ w` with the wrench w that
//! was not balanced. Where stiffnesses differ much T loses what the soft contacts add, but the balance of forces shows it: what they leave
//! of the load is solved for again. Forces that obey both the balance and the springs are right, however little T is known.

use super::balance::Body;
use super::block::Block;
use super::exit::{Forces, ON_THE_EDGE};
use super::finger::{Force, displacement, stretched};
use super::lanes::Lanes;
use crate::load_path::ROUNDING;

/// Forces that leave this part of the load unbalanced are improved.
const IMPROVED: f64 = 1e-14;
/// Times that they are improved at most.
const TIMES: usize = 3;
/// If motions are free and this part of the load stays unbalanced, it works on them.
const GIVES_WAY: f64 = 1e-6;

/// Commands of the fingers and a load, and what part of the forces that they bring about is called rounding.
struct Pulled<const D: usize, const C: usize, const N: usize, const L: usize> {
    commands: [Force<C, L>; N],
    load: [Lanes<L>; D],
    rounding: Lanes<L>,
}

/// Forces at factor zero of the load, and their rates, for which the fingers are at rest.
#[inline(always)]
pub(super) fn forces<const D: usize, const C: usize, const N: usize, const L: usize>(
    block: &Block<C, N, L>,
    base: &[Lanes<L>; D],
    direction: &[Lanes<L>; D],
) -> [Forces<C, N, L>; 2] {
    let body = Body::<D, C, N, L>::new(block);
    let at_rest = [Force { normal: Lanes::default(), tangential: [Lanes::default(); C] }; N];
    let mut commands = at_rest;
    for i in 0..N {
        commands[i].normal = block.pressed[i];
        for axis in 0..C {
            commands[i].tangential[axis] = block.sheared[axis][i];
        }
    }
    let base = Pulled { commands, load: *base, rounding: Lanes::all(ON_THE_EDGE) };
    let direction = Pulled { commands: at_rest, load: *direction, rounding: Lanes::all(ROUNDING) };
    if L == 1 {
        // A scene that is alone puts its two loads side by side.
        let both = rolling(&body.twice(), &side_by_side(&base, &direction));
        return [lane(&both, 0), lane(&both, 1)];
    }
    [rolling(&body, &base), rolling(&body, &direction)]
}

#[inline(always)]
fn side_by_side<const D: usize, const C: usize, const N: usize, const L: usize>(
    one: &Pulled<D, C, N, L>,
    two: &Pulled<D, C, N, L>,
) -> Pulled<D, C, N, 2> {
    let pair = |one: Lanes<L>, two: Lanes<L>| Lanes([one.0[0], two.0[0]]);
    let mut both = Pulled {
        commands: [Force { normal: Lanes::default(), tangential: [Lanes::default(); C] }; N],
        load: [Lanes::default(); D],
        rounding: pair(one.rounding, two.rounding),
    };
    for i in 0..N {
        let (into, [one, two]) = (&mut both.commands[i], [&one.commands[i], &two.commands[i]]);
        into.normal = pair(one.normal, two.normal);
        for axis in 0..C {
            into.tangential[axis] = pair(one.tangential[axis], two.tangential[axis]);
        }
    }
    for k in 0..D {
        both.load[k] = pair(one.load[k], two.load[k]);
    }
    both
}

#[inline(always)]
fn lane<const C: usize, const N: usize, const L: usize>(
    both: &Forces<C, N, 2>,
    lane: usize,
) -> Forces<C, N, L> {
    let mut forces = Forces::none();
    for i in 0..N {
        forces.normal[i] = Lanes::all(both.normal[i].0[lane]);
        forces.rounding[i] = Lanes::all(both.rounding[i].0[lane]);
        for axis in 0..C {
            forces.tangential[axis][i] = Lanes::all(both.tangential[axis][i].0[lane]);
        }
    }
    forces.unbalanced = Lanes::all(both.unbalanced.0[lane]);
    forces.free = Lanes::all(both.free.0[lane]);
    forces
}

#[inline(always)]
fn rolling<const D: usize, const C: usize, const N: usize, const L: usize>(
    body: &Body<D, C, N, L>,
    pulled: &Pulled<D, C, N, L>,
) -> Forces<C, N, L> {
    let zero = Lanes::default();
    let load = body.carried(&pulled.load);
    let mut contacts = [Force { normal: zero, tangential: [zero; C] }; N];
    for i in 0..N {
        let [normal, tangential] = body.fingers[i].springs;
        contacts[i].normal = normal * pulled.commands[i].normal;
        for axis in 0..C {
            contacts[i].tangential[axis] = tangential * pulled.commands[i].tangential[axis];
        }
    }
    let (mut left, mut part) = body.unbalanced(&contacts, &load);
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
        (left, part) = body.unbalanced(&contacts, &load);
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
    forces.free = part.above(Lanes::all(GIVES_WAY), body.free, zero);
    forces
}

/// What of a force may be rounding: a part of it, and of what its spring exerts over all that stretches and slackens it, as far as forces are
/// that large at all. Displacements that ought to cancel leave forces only between two contacts or more, so there the second stiffest
/// sets the measure.
#[inline(always)]
fn with_rounding<const D: usize, const C: usize, const N: usize, const L: usize>(
    body: &Body<D, C, N, L>,
    pulled: &Pulled<D, C, N, L>,
    contacts: &[Force<C, L>; N],
    moved: &[Lanes<L>; D],
) -> Forces<C, N, L> {
    let zero = Lanes::default();
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
        let commands = &pulled.commands[i];
        stretched[i] = normal.max(tangential) * span + normal * commands.normal.abs();
        sizes[i] = contacts[i].normal.abs();
        forces.normal[i] = contacts[i].normal;
        for axis in 0..C {
            stretched[i] += tangential * commands.tangential[axis].abs();
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
