//! Snap-through: parts turn under a load until nothing resists it any more, like a toggle near its dead centre. The theory of small motions keeps the
//! arms of all forces, and does not see it.
//!
//! The equilibrium of small motions is known. From it Newton's method leads, under the same load, to the equilibrium with exact rotations of all parts
//! ([`TurningParts`]), whose share grows from 0 to 1. If the tangent stiffness is no longer positive definite on the way, the load is lost. This
//! stiffness contains the turning forces, as in `left_out`.
//!
//! The same equilibrium says how far parts turn where the forces that turn with them take much of the resistance.

use nalgebra::SVector;

use super::answer::Equilibrium;
use super::left_out::{LEAST_FRACTION, positive_factors, sticking_springs};
use super::tolerances::{
    FARTHEST_MOTION, FIRST_SHARE, LAST_NEWTON_STEP, LEAST_SHARE, MOST_SHARES, NEWTON_STEPS_OF_A_SHARE,
    WORK_OF_ARMS,
};
use super::too_far::{MotionData, TooFar};
use super::turning_parts::{TurningParts, carried_load};
use crate::contact::State;
use crate::grasp::{Engine, Wrench};
use crate::numerics::{Vector, indexed, mapped};
use crate::prelude::*;
use crate::search::SmallMotions;

impl Engine {
    /// What finite rotations of its parts make of an equilibrium of small motions: the load is lost ([`TooFar::Buckles`]), or a motion is beyond its
    /// limit. `None` if neither is so, if a contact slides, or if the points of action of the load are not known. `None` also if rotations hardly change
    /// the motion: no contact does a hundredth of the elastic work along the change of arms, and forces that turn with the parts take little resistance.
    /// `None` also, for a motion beyond its limit, if springs leave some motion free.
    pub(crate) fn too_far_with_turned_parts(
        &self,
        small: &SmallMotions,
        standing: &MotionData<'_>,
        load: &Wrench<3>,
    ) -> Option<TooFar> {
        let beyond = |twist: &Vector| self.farthest_beyond(small, &MotionData { twist, ..*standing });
        match self.with_turned_parts(standing, load, Some(small))? {
            // A motion that is beyond its limit before the load is lost says more than the loss.
            WithTurnedParts::Lost(last) => beyond(&last).or(Some(TooFar::Buckles)),
            WithTurnedParts::Held(turned) => beyond(&turned?),
        }
    }

    /// The change of the resistance to a load by finite rotations of all parts, as a fraction of the resistance without them: `ΔW·q / ΔW·q' - 1`. ΔW is
    /// the change of the load from the equilibrium `rest` to the equilibrium `there`, q the motion between them, and q' the same motion with finite
    /// rotations. Negative if the resistance becomes lower. `None` if the fraction is at most [`LEAST_FRACTION`], if the load is lost, if arms hardly
    /// change, if springs do not resist some motion, or if the load does no work.
    pub(super) fn lost_resistance(&self, rest: &Equilibrium<3>, there: &Equilibrium<3>) -> Option<f64> {
        let turned = self.turned_from(there)?.held()?;
        let turned_at_rest = match self.turned_from(rest) {
            Some(turned) => turned.held()?,
            None => rest.local.twist.to(),
        };
        let carried = |of: &Equilibrium<3>| carried_load(self.sites(), &site_forces(of));
        let change = carried(there) - carried(rest);
        let kept = change.dot(&(there.local.twist.to() - rest.local.twist.to()));
        let now = change.dot(&(turned - turned_at_rest));
        (kept > 0.0 && now > 0.0).then(|| kept / now - 1.0).filter(|part| part.abs() > LEAST_FRACTION)
    }

    /// The fate of the load of an equilibrium, as [`Self::with_turned_parts`] says.
    fn turned_from(&self, of: &Equilibrium<3>) -> Option<WithTurnedParts> {
        let (local, forces, twist) = (&of.local, site_forces(of), of.local.twist.to());
        let (offsets, slips, states) = (&local.offsets[..], &local.slips[..], &local.states[..]);
        let standing = MotionData { offsets, slips, states, forces: &forces, twist: &twist };
        self.with_turned_parts(&standing, &of.load, None)
    }

    /// The fate of an equilibrium's load if its parts turn by finite rotations. `None` if a contact slides, or if the points of action of the load are
    /// not known. `None` also if arms hardly change, unless forces enlarge the motion beyond the limits `small`; without `small` that is not asked.
    fn with_turned_parts(
        &self,
        standing: &MotionData<'_>,
        load: &Wrench<3>,
        small: Option<&SmallMotions>,
    ) -> Option<WithTurnedParts> {
        // The tangent stiffness of a contact that slides is not symmetric: its friction changes with its normal force alone.
        if standing.states.iter().any(State::slides) || !self.may_buckle(load) {
            return None;
        }
        let grown = small.and_then(|small| self.grown_too_far(small, standing, load));
        if grown.is_none() && !self.arms_may_matter(standing) {
            return None;
        }
        let (parts, twist) = (TurningParts::new(self, standing, load), standing.twist);
        let whole = grown.as_ref().map_or(0.0, Vector::norm).max(twist.norm());
        (grown.is_some() || parts.arms_matter(twist)).then(|| parts.follow(whole))
    }

    /// The motion to which the forces of an equilibrium, which turn with its parts, enlarge its motion q: `(K + K_g)⁻¹ K q` with the stiffness K and the
    /// geometric stiffness K_g. `None` unless a part of it is near or beyond its limit, and larger by more than the fraction [`LEAST_FRACTION`].
    fn grown_too_far(
        &self,
        small: &SmallMotions,
        standing: &MotionData<'_>,
        load: &Wrench<3>,
    ) -> Option<Vector> {
        let motions = |twist: &Vector| self.counted_motions(small, &MotionData { twist, ..*standing });
        let forces = indexed(self.contacts(), &|(i, _)| self.sites()[i].frame * standing.forces[i]);
        let (elastic, geometric) = self.stiffnesses(&forces, &|i| standing.states[i].is_open(), load);
        let mut grown = &elastic * standing.twist;
        let sum = |i, j| elastic[(i, j)] + geometric[(i, j)];
        positive_factors(elastic.size().count(), &sum)?.solve(grown.as_mut_slice());
        // The change of arms may enlarge the motion further, so that it is asked a little below the limit, too.
        let more = 1.0 + LEAST_FRACTION;
        let mut pairs = motions(standing.twist).into_iter().zip(motions(&grown));
        let is_far = pairs.any(|(linear, grown)| {
            let grown = grown.over_the_limit();
            more * grown > 1.0 && grown > more * linear.over_the_limit()
        });
        is_far.then_some(grown)
    }

    /// Whether the change of arms can make some contact do more than the fraction [`WORK_OF_ARMS`] of the elastic work of all contacts: the arm r of a
    /// force changes by at most `½ |θ|² |r|` beyond the first order of the rotation θ, a rope or spring of length L by the square of its lean over 2 L.
    fn arms_may_matter(&self, standing: &MotionData<'_>) -> bool {
        let axes = self.space().axes();
        let (mut elastic, mut largest) = (0.0, 0.0_f64);
        for (i, site) in self.sites().iter().enumerate() {
            if standing.states[i].is_open() {
                continue;
            }
            let linear = site.map.tr_mul(standing.twist);
            let force = sticking_springs(site) * linear;
            elastic += force.dot(&linear).abs();
            let Some(contact) = self.contacts().get(i) else { continue };
            let mut reach = 0.0;
            let mut lean = linear[1].hypot(linear[2]);
            let sides = self.bodies().map_or([Some(0), None], |bodies| {
                let (on, against) = bodies.sides[i];
                [Some(on), against]
            });
            for body in sides.into_iter().flatten() {
                let (first, centre) = self.reference_of(body);
                let turned = |k: usize| standing.twist[first + axes + k] / self.rotation_length(first, k);
                let squared: f64 = (0..self.space().planes().len()).map(|k| turned(k) * turned(k)).sum();
                reach +=
                    0.5 * squared * (contact.point - centre).norm().max((self.far_end(i) - centre).norm());
                lean += squared.sqrt() * contact.normal.norm();
            }
            reach += self.rope(i).map_or(0.0, |length| 0.5 * lean * lean / length);
            largest = largest.max(force.norm() * reach);
        }
        largest > WORK_OF_ARMS * elastic
    }
}

/// The forces of all contacts and drives in an equilibrium, N, in their frames.
fn site_forces(of: &Equilibrium<3>) -> Vec<SVector<f64, 3>> {
    let mut forces = mapped(&of.contacts, &|contact| contact.force);
    forces.extend(&of.local.drive_forces);
    forces
}

/// The fate of a load, if the parts that carry it turn by finite rotations.
enum WithTurnedParts {
    /// The equilibrium of small motions does not lead to one with finite rotations. The motion of all coordinates is the last on the way.
    Lost(Vector),
    /// The load is held after this motion of all coordinates; `None` if springs do not resist some motion.
    Held(Option<Vector>),
}

impl WithTurnedParts {
    /// The motion of all coordinates with finite rotations. `None` if the load is lost, or if springs do not resist some motion.
    fn held(self) -> Option<Vector> {
        if let Self::Held(motion) = self { motion } else { None }
    }
}

impl TurningParts<'_> {
    /// Whether the change of arms makes some contact do more than the fraction [`WORK_OF_ARMS`] of the elastic work of all contacts, in the motion
    /// `twist` of small motions.
    fn arms_matter(&self, twist: &Vector) -> bool {
        let (mut elastic, mut largest) = (0.0, 0.0_f64);
        for (i, site) in self.engine.sites().iter().enumerate() {
            let linear = site.map.tr_mul(twist);
            let force = self.springs[i] * linear;
            elastic += force.dot(&linear).abs();
            largest = largest.max(force.dot(&(self.site(i, 1.0).moved - linear)).abs());
        }
        largest > WORK_OF_ARMS * elastic
    }

    /// Follows the equilibrium from small motions to finite rotations. `whole` is the length of the motion, as far as it is known.
    fn follow(mut self, whole: f64) -> WithTurnedParts {
        let (mut share, mut step) = (0.0, FIRST_SHARE);
        for _ in 0..MOST_SHARES {
            if share >= 1.0 || step < LEAST_SHARE {
                break;
            }
            let before = (self.bodies.clone(), self.displaced.clone());
            let next = f64::min(share + step, 1.0);
            if self.balance(next, whole) {
                (share, step) = (next, 2.0 * step);
            } else {
                (self.bodies, self.displaced) = before;
                step *= 0.25;
            }
        }
        if share < 1.0 {
            return WithTurnedParts::Lost(self.displaced);
        }
        WithTurnedParts::Held(self.resisted.is_none().then_some(self.displaced))
    }

    /// Finds the equilibrium with this share of exact rotations by Newton's method, from the present position. False if the tangent stiffness is not
    /// positive definite on the way, or if the position moves by more than [`FARTHEST_MOTION`] times `whole`, the length of the whole motion.
    fn balance(&mut self, share: f64, whole: f64) -> bool {
        let mut moved = 0.0;
        for _ in 0..NEWTON_STEPS_OF_A_SHARE {
            let (mut step, stiffness) = self.imbalance(share);
            let count = stiffness.size().count();
            let Some(factors) = positive_factors(count, &|i, j| stiffness[(i, j)]) else { return false };
            factors.solve(step.as_mut_slice());
            moved += step.norm();
            if moved > FARTHEST_MOTION * whole || moved.is_nan() {
                return false;
            }
            self.move_by(&step);
            if step.norm() <= LAST_NEWTON_STEP * whole {
                return true;
            }
        }
        false
    }
}
