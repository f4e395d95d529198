//! The derivatives of the load factor of first slip with respect to all data of a grasp and the load, as a row of numbers. A contact leaves its cone,
//! i.e. ceases to stick, when its margin `α F_n - β |F_t|` vanishes. With friction α is the coefficient of friction and β = 1; for a contact that can
//! only open α = 1 and β = 0. A command is the displacement that a finger would make if there were no object. The springs are solved a second time
//! without a load. In this second solution only the contact that leaves its cone has a command: the derivative of its margin with respect to its
//! force. All derivatives follow from the second solution by the formulas of [`super::gradient`].

use super::answer_slots::AnswerSlots;
use super::block::{Block, Layout, MOST_SCREENED, count, entries};
use super::edge::LeavingEdge;
use super::finger::world;
use super::forces::AnyForces;
use super::lanes::Packed;
use super::method::Method;
use super::moved::{ObjectMotion, worked};
use super::screened::Screened;

/// The layout of a gradient as a row of numbers. Number 0 is the load factor of first slip or, if there is none, a code for the reason. Number 1 is
/// the sum of 2^i over the contacts i that leave their cones. Number 2 is the index, from 0, of the contact whose margin is differentiated. Number 3
/// is positive if the load factor has a kink at these data, so that derivatives are one-sided. The derivatives with respect to points, normals,
/// commands, stiffness and friction follow, each contact by contact. The derivatives with respect to the load come last.
pub(super) struct GradientRow<const C: usize>;

impl<const C: usize> GradientRow<C> {
    pub(super) const CODE: usize = 0;
    pub(super) const LEAVING: usize = 1;
    pub(super) const CONTACT: usize = 2;
    pub(super) const KINK: usize = 3;
    pub(super) const POINTS: usize = 4;

    pub(super) const fn normal(contacts: usize) -> usize {
        Self::POINTS + C * contacts
    }
    pub(super) const fn command(contacts: usize) -> usize {
        Self::normal(contacts) + C * contacts
    }
    pub(super) const fn stiffness(contacts: usize) -> usize {
        Self::command(contacts) + C * contacts
    }
    pub(super) const fn friction(contacts: usize) -> usize {
        Self::stiffness(contacts) + 2 * contacts
    }
    pub(super) const fn load(contacts: usize) -> usize {
        Self::friction(contacts) + contacts
    }
    pub(super) const fn numbers(contacts: usize) -> usize {
        Self::load(contacts) + Layout::<C>::COORDINATES
    }
}

/// The number of entries of the longest [`GradientRow`], for five contacts in space.
const LONGEST_ROW: usize = GradientRow::<3>::numbers(MOST_SCREENED);

/// The contact forces and the motions of the object from which the derivatives of the load factor of first slip are computed. The formulas are in
/// [`super::gradient`].
pub(super) struct Slopes<'a, const C: usize, X: Packed> {
    pub(super) method: Method,
    pub(super) edge: &'a LeavingEdge<C, X>,
    /// The contact forces F at first slip, and the contact forces P of the second solution, whose commands are the derivatives of the margin.
    pub(super) forces: [&'a AnyForces<C, X>; 2],
    /// The displacement and rotation of the object: (u, ω) at first slip, and (v, ω̄) in the second solution, whose commands are the derivatives of
    /// the margin.
    pub(super) motions: [&'a ObjectMotion<C, X>; 2],
    pub(super) first: X::Each<Screened>,
}

impl<const C: usize, X: Packed> Slopes<'_, C, X> {
    /// Computes the [`GradientRow`] of the grasp in each lane and stores it as an answer.
    #[inline(always)]
    pub(super) fn write_gradient(&self, block: &Block<'_, C, X>, slots: &mut AnswerSlots<'_, f64, X>) {
        let contacts = count(block.contacts);
        let mut row = [X::all(0.0); LONGEST_ROW];
        let scale = X::all(-1.0) / self.edge.rate;
        let LeavingEdge { contact, kink, by_friction, .. } = self.edge;
        (row[GradientRow::<C>::CONTACT], row[GradientRow::<C>::KINK]) = (*contact, *kink);
        for i in 0..contacts {
            self.contact(block, i, scale, &mut row);
            row[GradientRow::<C>::friction(contacts) + i] = scale * by_friction[i];
        }
        // The object's motion (v, ω̄) in the second solution is converted to its motion at the origin, to which moments of loads refer.
        let virtually = self.motions[1];
        let mut turn = [X::all(0.0); C];
        turn.copy_from_slice(&virtually.turn[..C]);
        let mut arm = entries(&block.points(), 0);
        for entry in &mut arm {
            *entry = -*entry;
        }
        let less = -scale;
        let load = &mut row[GradientRow::<C>::load(contacts)..];
        let (turned, _) = worked([&turn, &turn, &arm, &arm]);
        for axis in 0..C {
            load[axis] = less * (virtually.at[0][axis] + turned[axis]);
        }
        for axis in 0..Layout::<C>::COORDINATES - C {
            load[C + axis] = less * virtually.turn[axis];
        }
        let numbers = GradientRow::<C>::numbers(contacts);
        for (lane, screened) in self.first.as_ref().iter().enumerate() {
            if let Some(slot) = slots.slot(lane) {
                for (entry, number) in slot.iter_mut().zip(&row[..numbers]) {
                    *entry = number.lane(lane);
                }
                (slot[GradientRow::<C>::CODE], slot[GradientRow::<C>::LEAVING]) =
                    (screened.0.code, screened.0.leaving);
            }
        }
    }

    /// Writes the derivatives of the load factor of first slip with respect to point, normal, command and stiffness of contact i. They are the
    /// derivatives of the sticking margin times `scale`, which is -1 over the derivative of this margin with respect to the load factor.
    #[inline(always)]
    fn contact(&self, block: &Block<'_, C, X>, i: usize, scale: X, row: &mut [X; LONGEST_ROW]) {
        let (zero, contacts) = (X::all(0.0), count(block.contacts));
        let normal = entries(&block.normals(), i);
        let [k_n, k_t] = entries(&block.springs(), i);
        let (force, mut answered) = (self.forces[0].of[i], self.forces[1].of[i]);
        let give = |k: X| k.above(zero, X::all(1.0) / k, zero);
        let gives = match self.method {
            Method::Edges => [k_n, k_t],
            Method::Motions => [give(k_n), give(k_t)],
        };
        if const { C == 2 } && self.method == Method::Edges {
            // If a grasp of two contacts in the plane has a contact without friction, statics alone determines the contact forces. Commands then
            // cause no forces, and the derivatives with respect to commands are zero. A normal compliance `k_n` of zero marks such a grasp. Its
            // forces P in the second solution serve only to compute the motion of the object.
            let squeezes = k_n.above(zero, scale, zero);
            answered.normal = squeezes * answered.normal;
            for entry in &mut answered.tangential {
                *entry = squeezes * *entry;
            }
        } else {
            answered.normal = scale * answered.normal;
            for entry in &mut answered.tangential {
                *entry = scale * *entry;
            }
        }
        let (mut across, mut turns) = (zero, [[zero; C]; 2]);
        for axis in 0..C {
            across += force.tangential[axis] * answered.tangential[axis];
            turns[0][axis] = self.motions[0].turn[axis];
            turns[1][axis] = scale * self.motions[1].turn[axis];
        }
        let stiffness = &mut row[GradientRow::<C>::stiffness(contacts) + 2 * i..][..2];
        stiffness[0] = force.normal * answered.normal * gives[0] * gives[0];
        stiffness[1] = across * gives[1] * gives[1];
        let (force, answered) = (world(&normal, &force), world(&normal, &answered));
        let mut virtually = self.motions[1].at[i];
        for entry in &mut virtually {
            *entry = scale * *entry;
        }
        let with_answered = worked([&turns[0], &self.motions[0].at[i], &answered, &normal]);
        let with_force = worked([&turns[1], &virtually, &force, &normal]);
        for axis in 0..C {
            row[GradientRow::<C>::POINTS + C * i + axis] = with_answered.0[axis] + with_force.0[axis];
            row[GradientRow::<C>::normal(contacts) + C * i + axis] =
                with_answered.1[axis] + with_force.1[axis];
            row[GradientRow::<C>::command(contacts) + C * i + axis] = answered[axis];
        }
    }
}
