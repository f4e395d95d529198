//! Derivatives of the load factor of first slip with respect to all data of a grasp.
//!
//! At the load factor τ of first slip a contact leaves its cone, i.e. ceases to stick. Its margin m, the distance of its force from the boundary of
//! the cone, is then zero. Therefore `dτ = -dm / m'`, with m' the derivative of m with respect to τ. Let g = ∂m/∂F be the derivative of m with
//! respect to the force of that contact. The equilibrium of the springs is computed once more, with g as the command of its finger (the displacement
//! that it would make if there were no object) and nothing else. All derivatives follow from the forces P and the motion (v, ω̄) of the object in
//! that second solution. F and (u, ω) are the contact force and the motion at first slip. Of each motion, u or v is the displacement at the contact,
//! ω or ω̄ the rotation. Subscripts n and t mean normal and tangential, k is a stiffness. The derivatives with respect to the data of each contact
//! are
//!
//! ```text
//! ∂m/∂a = P                          command                 ∂m/∂p = ω̄ × F + ω × P        point
//! ∂m/∂k_n = F_n P_n / k_n²           stiffness               ∂m/∂θ = v × F + u × P        its frame turns, with springs and commands
//! ∂m/∂k_t = F_t·P_t / k_t²                                   ∂m/∂W = -(v, ω̄) at the origin   load
//! ```
//!
//! All derivatives together thus cost one more solve of the springs than the load factor, whatever the number of data.

use super::answer_slots::AnswerSlots;
use super::block::Block;
use super::edge::LeavingEdge;
use super::first_exit::judge;
use super::forces::AnyForces;
use super::gradient_row::{GradientRow, Slopes};
use super::lanes::Packed;
use super::moved::ObjectMotion;
use super::pull::Pull;
use super::question::{PreparedBlock, ScreeningQuestion, WorkingForces};
use super::screened::Screened;
use super::springs::Cause;
use crate::numerics::Vectors;

/// A question that screening answers: what are the derivatives, with respect to all data, of the load factor of first slip under the growing load
/// `pull`?
#[derive(Debug, Clone, Copy)]
pub(crate) struct GradientOf<const C: usize> {
    pub(super) pull: Pull<C>,
    /// The contact whose margin is differentiated; for `None` the first contact that leaves its cone. If the given contact does not leave its cone at
    /// first slip, the derivatives are NaN.
    pub(super) contact: Option<usize>,
}

impl<const C: usize> ScreeningQuestion<C> for GradientOf<C> {
    type Answer = f64;
    const UNKNOWN: f64 = f64::NAN;

    fn answers(contacts: usize) -> usize {
        GradientRow::<C>::numbers(contacts)
    }

    #[inline(always)]
    fn ask<V: Vectors, X: Packed>(
        &self,
        prepared: &PreparedBlock<'_, V, C, X>,
        [rates, forces, answered]: WorkingForces<'_, C, X>,
        slots: &mut AnswerSlots<'_, f64, X>,
    ) {
        let (v, block, ready) = (prepared.vectors, &prepared.block, prepared.ready);
        let Pull { base, direction, loaded } = &self.pull;
        prepared.under(direction, rates);
        if *loaded {
            prepared.squeezed_under(base, forces);
        } else {
            forces.copy_from(prepared.squeezed);
        }
        let first = judge(v, block, forces, rates);
        let mut edge = LeavingEdge::none();
        reach(v, &mut edge, block.friction(), (first, self.contact), [rates, forces]);
        let probe = edge.probe(block.contacts);
        ready.squeeze(v, block, Some(&probe), answered);
        let (mut moved, mut virtually) = (ObjectMotion::none(), ObjectMotion::none());
        let mut load = [X::all(0.0); 6];
        for ((load, base), direction) in load.iter_mut().zip(base.components()).zip(direction.components()) {
            *load = X::all(*base) + edge.factor * X::all(*direction);
        }
        ready.moved(v, block, &Cause { commands: block.commands(), load }, forces, &mut moved);
        let probed = Cause { commands: probe, load: [X::all(0.0); 6] };
        ready.moved(v, block, &probed, answered, &mut virtually);
        let slopes = Slopes {
            method: ready.method(),
            edge: &edge,
            forces: [forces, answered],
            motions: [&moved, &virtually],
            first,
        };
        write_gradient(v, &slopes, block, slots);
    }
}

#[inline(never)]
fn reach<V: Vectors, const C: usize, X: Packed>(
    v: V,
    edge: &mut LeavingEdge<C, X>,
    friction: &[X],
    first: (X::Each<Screened>, Option<usize>),
    [rates, forces]: [&mut AnyForces<C, X>; 2],
) {
    v.run(
        #[inline(always)]
        || edge.reach(friction, first, rates, forces),
    );
}

#[inline(never)]
fn write_gradient<V: Vectors, const C: usize, X: Packed>(
    v: V,
    slopes: &Slopes<'_, C, X>,
    block: &Block<'_, C, X>,
    slots: &mut AnswerSlots<'_, f64, X>,
) {
    v.run(
        #[inline(always)]
        || slopes.write_gradient(block, slots),
    );
}
