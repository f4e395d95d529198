//! The load factor of first slip, at which the first contact ceases to stick, and the rotation of the object up to the whole load. Both are computed
//! for a batch of grasps, each under its own load. The base load acts at load factor 0. A command is the displacement that a finger would make if
//! there were no object. A block holds as many grasps as a SIMD vector has numbers (lanes).

use super::answer_slots::AnswerSlots;
use super::block::Layout;
use super::buckling::{LoadAtPoints, RotationalStiffness};
use super::first_exit::judge;
use super::first_slip::SlipCode;
use super::forces::AnyForces;
use super::kernels::Kernels;
use super::lanes::Packed;
use super::moved::ObjectMotion;
use super::point_batch::PointBatch;
use super::pull::Pull;
use super::question::{PreparedBlock, ScreeningQuestion, WorkingForces};
use super::screened::Screened;
use super::springs::Cause;
use super::tolerances::ON_THE_EDGE;
use crate::contact::ZERO_SLACK;
use crate::equilibrium::LEAST_FRACTION;
use crate::numerics::Vectors;
use crate::numerics::tolerances::NEGLIGIBLE;
use crate::prelude::*;

/// The question for the load factor of first slip, and the rotation, of each grasp of a batch under its own load; `pulls` has one load for each
/// grasp.
pub(crate) struct SlipAndRotation<const C: usize> {
    pub(crate) pulls: Vec<Pull<C>>,
    /// Whether the rotation of the object is computed, too.
    pub(crate) turns: bool,
}

/// The load factor of first slip of one grasp as its load grows, and the rotation of its object computed as if every contact stuck.
#[derive(Clone, Copy)]
pub(crate) struct WhileSticking {
    pub(crate) first: Screened,
    /// Contact forces and the load reduce the stiffness against rotation, because their points of action turn with the object. This number is an
    /// upper bound of the fraction that they take away. If the bound is below 1, the grasp does not buckle. The bound holds under the base load and
    /// under the whole load. NaN if it is not known, if no contact carries a force, or if no rotation was computed.
    pub(crate) taken: f64,
    /// An upper bound of the object's rotation, as that loss of stiffness enlarges it, under the base load and under the whole load (factor 1), rad. NaN
    /// if the position of the object is not determined, or if no rotation was computed.
    pub(crate) grown: f64,
    /// An upper bound of the work that a contact does along the change of its arm, as a part of the elastic work.
    pub(crate) arms: f64,
}

/// A grasp surely does not buckle if forces take away at most this fraction of its stiffness against rotation. At the fraction 1 it may buckle; the
/// difference from 1 is far larger than the rounding of [`WhileSticking::taken`].
const SURELY: f64 = 0.99;

/// A grasp surely does not snap through if a change of arms does at most this part of the elastic work. At a snap-through it does about a fifth. If
/// smaller, ordinary rows take a hundred times as long; if larger, rows that snap through are said to stick.
const SURELY_NO_SNAP: f64 = 0.05;

impl WhileSticking {
    /// Whether the rotation surely stays within its `limit`, rad, with finite rotations, too, and the grasp surely neither buckles nor snaps through.
    pub(crate) fn is_small(&self, limit: f64) -> bool {
        // A change of arms up to `SURELY_NO_SNAP` may enlarge the rotation by a tenth more, by estimate.
        let within = limit / (1.0 + LEAST_FRACTION) * (1.0 - NEGLIGIBLE);
        self.grown <= within && self.taken <= SURELY && self.arms <= SURELY_NO_SNAP
    }
}

impl<const C: usize> SlipAndRotation<C> {
    /// The load factor of first slip and the rotation of every grasp of a batch, on one thread. Empty if the number of loads is not the number of
    /// grasps.
    pub(crate) fn answers(self, batch: &PointBatch<C>) -> Vec<WhileSticking> {
        let mut answers = Vec::new();
        if self.pulls.len() != batch.len() {
            return answers;
        }
        batch.parts(&[self], batch.len(), &mut answers).for_each(Kernels::get().put_on);
        answers
    }

    /// One component of the load on the grasp in each lane of a block, whose first grasp has the index `first` in the batch. Lanes beyond the last
    /// grasp repeat the load of the last grasp.
    #[inline(always)]
    fn lanes<X: Packed>(&self, first: usize, component: impl Fn(&Pull<C>) -> f64) -> X {
        let last = self.pulls.len() - 1;
        X::of(X::each(|lane| component(&self.pulls[(first + lane).min(last)])))
    }

    /// The loads on the grasps of a block at the load factor `factor`: `base + factor · direction` of each grasp's [`Pull`], with their points of
    /// action.
    #[inline(always)]
    fn at_points<X: Packed>(&self, first: usize, factor: f64) -> LoadAtPoints<C, X> {
        let last = self.pulls.len() - 1;
        let loads = X::each(|lane| {
            let pull = &self.pulls[(first + lane).min(last)];
            pull.base + pull.direction * factor
        });
        let loads = loads.as_ref();
        let mut load = LoadAtPoints { force: [X::all(0.0); C], moments: [[X::all(0.0); C]; C] };
        if loads.iter().all(|load| !load.points_of_action().is_known()) {
            return load;
        }
        for a in 0..C {
            load.force[a] = X::of(X::each(|lane| {
                let load = &loads[lane];
                if load.points_of_action().is_known() { load.components()[a] } else { 0.0 }
            }));
            for b in 0..C {
                load.moments[a][b] = X::of(X::each(|lane| loads[lane].points_of_action().product(a, b)));
            }
        }
        load
    }
}

impl<const C: usize> ScreeningQuestion<C> for SlipAndRotation<C> {
    type Answer = WhileSticking;
    const UNKNOWN: WhileSticking = WhileSticking {
        first: Screened(SlipCode::UNKNOWN),
        taken: f64::NAN,
        grown: f64::NAN,
        arms: f64::NAN,
    };

    #[inline(always)]
    fn ask<V: Vectors, X: Packed>(
        &self,
        prepared: &PreparedBlock<'_, V, C, X>,
        [rates, base, _]: WorkingForces<'_, C, X>,
        slots: &mut AnswerSlots<'_, WhileSticking, X>,
    ) {
        let zero = X::all(0.0);
        let [mut at_rest, mut more] = [[zero; 6]; 2];
        for k in 0..Layout::<C>::COORDINATES {
            at_rest[k] = self.lanes(prepared.first, |pull| pull.base.components()[k]);
            more[k] = self.lanes(prepared.first, |pull| pull.direction.components()[k]);
        }
        prepared.under_lanes(&more, rates);
        prepared.under_lanes(&at_rest, base);
        base.add_to(prepared.block.contacts, prepared.squeezed, ON_THE_EDGE / ZERO_SLACK);
        let first = judge(prepared.vectors, &prepared.block, base, rates);
        let [mut taken, mut grown, mut arms] = [X::all(f64::NAN); 3];
        if self.turns {
            let (v, block) = (prepared.vectors, &prepared.block);
            let method = prepared.ready.method();
            let stiffness = RotationalStiffness::of(v, block, method);
            let start = prepared.turned(&at_rest, base);
            let load = self.at_points(prepared.first, 0.0);
            let rest = stiffness.bounds(v, (block, method), (&base.of, &load), &start);
            base.add_to(prepared.block.contacts, rates, 1.0);
            for k in 0..Layout::<C>::COORDINATES {
                more[k] += at_rest[k];
            }
            let end = prepared.turned(&more, base);
            let load = self.at_points(prepared.first, 1.0);
            let there = stiffness.bounds(v, (block, method), (&base.of, &load), &end);
            // `max` returns the other number if one is NaN. Adding zero times `one` keeps its NaN, too.
            let larger = |one: X, other: X| one.max(other) + X::all(0.0) * one;
            taken = larger(rest.taken, there.taken);
            grown = larger(rest.grown, there.grown);
            arms = larger(rest.arms, there.arms);
        }
        let first = first.as_ref();
        slots.each(X::each(|lane| WhileSticking {
            first: first[lane],
            taken: taken.lane(lane),
            grown: grown.lane(lane),
            arms: arms.lane(lane),
        }));
    }
}

impl<V: Vectors, const C: usize, X: Packed> PreparedBlock<'_, V, C, X> {
    /// The object's rotation under the commands and a load, rad, given the contact forces of both together. NaN if the position of the object is not
    /// determined.
    #[inline(always)]
    fn turned(&self, load: &[X; 6], forces: &AnyForces<C, X>) -> [X; 3] {
        let mut moved = ObjectMotion::none();
        let cause = Cause { commands: self.block.commands(), load: *load };
        self.ready.turned(self.vectors, &self.block, &cause, forces, &mut moved);
        moved.turn
    }
}
