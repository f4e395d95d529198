//! A closed cycle of legs (sections of a load program), followed again and again. A piece of the path is a part of a leg on which all contacts keep
//! their states (open, sticking or sliding). The cycle state is what a cycle hands on to the next: forces, gaps, slips and twist. A jump is a motion
//! of the object, under constant load, from one equilibrium to another. The drives of a hand (the springs of its joints and tendons, with their force
//! limits) are treated like contacts.

use nalgebra::{Matrix, SVector};

use super::end_of_theory::end_of_theory;
use super::event::PathEnd;
use super::following::{AnyPath, Following};
use super::leg::Leg;
use super::piecewise_follower::PiecewiseFollower;
use super::stored_piece::StoredPiece;
use crate::contact::{Coulomb, Mode, State};
use crate::equilibrium::{Equilibrium, TooFar};
use crate::error::Error;
use crate::grasp::{Engine, Wrench};
use crate::numerics::tolerances::{NEGLIGIBLE, SOLVED_ROUNDING};
use crate::numerics::{IntoList, Reals, Vector, add_times, largest, numbered};
use crate::prelude::*;
use crate::search::{Doubt, Settings};

/// The path along a closed cycle of legs that is followed again and again.
#[derive(Debug)]
pub(crate) struct Cycles<'g> {
    path: Following<'g, PiecewiseFollower<'g>>,
    legs: Vec<Leg<3>>,
    base: Wrench<3>,
    /// Number of cycles followed so far, including a cycle that the path did not finish.
    completed: usize,
    /// The reason why the theory of small motions ceases to apply: a motion beyond its limit, a leak of a suction cup, or buckling. During the first
    /// cycle the first such event is stored, at whatever point it occurs. Later cycles are only checked for buckling, at the end of each cycle.
    too_far: Option<TooFar>,
    /// The least fraction [`Verdict::left_out`](crate::hold::Verdict::left_out) of the resistance along the first cycle.
    pub(crate) left_out: Option<f64>,
}

/// The cycle state: forces, gaps, slips and twist between two cycles. Each list has an entry for each contact and drive.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct CycleState {
    pub(crate) forces: Vec<SVector<f64, 3>>,
    /// For each contact and drive its gap, m, if it is open; zero if it is closed.
    pub(crate) gaps: Vec<f64>,
    pub(crate) slips: Vec<SVector<f64, 3>>,
    pub(crate) twist: Vector,
    /// For each contact and drive: true if it slides with its lower kinetic friction. Empty if no contact has kinetic friction.
    pub(crate) has_kinetic_friction: Vec<bool>,
}

/// Totals and extremes of one cycle of legs. Each list, except `states`, has an entry for each contact and drive.
#[derive(Debug, Clone)]
pub(crate) struct CycleRecord {
    /// The length that each contact or drive has slid during the cycle, m: the sum of the changes of its slip over the pieces of the path.
    pub(crate) slid: Vec<f64>,
    /// Heat from friction during the cycle, J.
    pub(crate) dissipated: f64,
    /// The largest contact force, N, at the ends of the pieces of the path.
    pub(crate) largest: f64,
    /// For each contact or drive that was open during the whole cycle, its smallest gap, m, at the ends of the pieces of the path. `None` for one
    /// that was closed at some time.
    pub(crate) open: Vec<Option<f64>>,
    /// For each contact or drive, its largest gap, m, at the ends of the pieces of the path on which it was open; zero if it was never open.
    pub(crate) largest_gap: Vec<f64>,
    pub(crate) jumps: usize,
    /// The largest displacement at a contact point, m, in a jump of the cycle.
    pub(crate) jump_motion: f64,
    pub(crate) step_error: f64,
    /// The successive lists of the states of all contacts and drives in the cycle. A new list is added when a leg begins, and when a contact or drive
    /// changes its state. With each list comes the index, within the cycle, of the leg on which the states hold.
    states: Vec<(usize, Vec<State>)>,
}

impl CycleRecord {
    /// Extends this record over the next cycle `next`: adds the totals of that cycle, and replaces each largest or smallest value by that over both
    /// cycles.
    pub(crate) fn append(&mut self, next: &Self) {
        add_times(&mut self.slid, &next.slid, 1.0);
        self.dissipated += next.dissipated;
        self.largest = self.largest.max(next.largest);
        let both = |a: Option<f64>, b: Option<f64>| Some(a?.min(b?));
        self.open.iter_mut().zip(&next.open).for_each(|(open, more)| *open = both(*open, *more));
        self.largest_gap.iter_mut().zip(&next.largest_gap).for_each(|(gap, more)| *gap = gap.max(*more));
        self.jumps += next.jumps;
        self.jump_motion = self.jump_motion.max(next.jump_motion);
        self.step_error = self.step_error.max(next.step_error);
        self.states.extend(next.states.iter().cloned());
    }

    /// Whether contacts and drives had the same states on the same legs in both cycles, apart from directions of sliding on the round cone.
    pub(crate) fn is_like(&self, other: &Self) -> bool {
        let mut both = self.states.iter().zip(&other.states);
        self.states.len() == other.states.len()
            && both.all(|((leg, a), (other, b))| leg == other && are_alike(a, b))
    }
}

/// Whether all contacts and drives have the same states in `a` and `b`, apart from directions of sliding on the round cone.
fn are_alike(a: &[State], b: &[State]) -> bool {
    a.iter().zip(b).all(|(a, b)| a.is_kind_of(b))
}

impl<'g> Cycles<'g> {
    /// The path along the cycle `legs` before its first cycle: it is at the equilibrium under `base`, the load at the beginning of the cycle.
    ///
    /// # Errors
    /// [`Error::NotClosed`] for legs that do not lead back to their beginning. Other errors are those of
    /// [`Grasp::follow`](crate::ask::Grasp::follow), e.g. for data out of range.
    pub(crate) fn at_rest(
        grasp: &'g Engine,
        (base, legs): (&Wrench<3>, &[Leg<3>]),
        settings: &Settings,
    ) -> Result<Self, Error> {
        let path = Following::start(grasp, (base, legs), settings, PiecewiseFollower::at_start)?;
        // A cycle of legs is closed if it ends with its initial loads and commands, up to the fraction `SOLVED_ROUNDING` (1e-12) of their largest
        // values along the cycle.
        path.run.program.check_closed(SOLVED_ROUNDING)?;
        Ok(Self { path, legs: legs.to_vec(), base: *base, completed: 0, too_far: None, left_out: None })
    }

    /// The same cycle of legs, not followed yet, which starts from the cycle state `from`. `None` if `from` is no equilibrium of the grasp. Then a
    /// contact slides at once, or the equilibrium with the slips of `from` has forces that differ from the forces of `from`.
    pub(crate) fn beginning_at(&self, from: &CycleState, settings: &Settings) -> Option<Self> {
        let grasp = self.path.run.grasp;
        let largest = largest(&from.forces, &Matrix::norm);
        let begin = Following::start(grasp, (&self.base, &self.legs), settings, |run, problem| {
            let mut slipped = problem.clone();
            add_times(&mut slipped.offsets, &from.slips, -1.0);
            slipped.slips.clone_from(&from.slips);
            slipped.cones = from.cones(grasp);
            // If a contact has to slide at once, `from` is no equilibrium with these slips, and no search is needed.
            let slides = |(i, force): (usize, &SVector<f64, 3>)| {
                // A contact slides if a sticking condition is violated by more than the fraction `NEGLIGIBLE` (1e-9) of the largest force.
                slipped
                    .local(i)
                    .edges(&Mode::Sticking)
                    .worst(force)
                    .is_some_and(|(_, margin)| margin < -NEGLIGIBLE * largest)
            };
            if from.forces.iter().enumerate().any(slides) {
                return Err(run.undecided(0.0, Doubt::OnTheBoundary));
            }
            PiecewiseFollower::at_start(run, &slipped)
        });
        let path = begin.ok()?;
        let begun = Self {
            path,
            legs: self.legs.clone(),
            base: self.base,
            completed: 0,
            too_far: None,
            left_out: None,
        };
        let forces = &begun.path.follower.as_ref()?.node.at.forces;
        let is_there = forces.iter().zip(&from.forces).all(|(a, b)| (a - b).norm() <= NEGLIGIBLE * largest);
        is_there.then_some(begun)
    }

    /// Sets the limit on the number of integration steps on each leg from now on. Steps are counted along arcs, on which directions of sliding
    /// turn.
    pub(crate) fn allow_steps(&mut self, most_steps: usize) {
        self.path.run.settings.most_steps = most_steps;
    }

    /// The end of the path if it ended within a leg; `None` if all legs so far were completed.
    pub(crate) fn end(&self) -> Option<&PathEnd<3>> {
        self.path.end().filter(|end| !matches!(end, PathEnd::Completed))
    }

    /// The reason why the theory of small motions no longer applies on the path so far: a motion beyond its limit, a leak of a suction cup, or
    /// buckling. `None` if it still applies.
    pub(crate) fn too_far(&self) -> Option<TooFar> {
        self.too_far.clone().or_else(|| Some(self.path.end_of_small_motions()?.what.clone()))
    }

    /// The index of the present leg within the present cycle, from 0, and the fraction of this leg that is done, from 0 to 1.
    pub(crate) fn place(&self) -> (usize, f64) {
        let (leg, fraction) = self.path.place();
        (leg - self.completed.saturating_sub(1) * self.legs.len(), fraction)
    }

    /// The equilibrium at the present point of the path; `None` if it cannot be computed.
    pub(crate) fn state(&self) -> Option<Equilibrium<3>> {
        self.path.state()
    }

    /// Follows one more cycle and returns its totals; `None` if the path [ends](Self::end) before the cycle is complete.
    pub(crate) fn follow_cycle(&mut self) -> Option<CycleRecord> {
        if self.completed > 0 && self.path.end().is_some() {
            self.path.run.program.return_to(self.path.run.grasp, &self.base);
            self.path.continue_with(&self.legs).ok()?;
        }
        self.completed += 1;
        // The list `behind` still has the last piece of the previous cycle, from which the present equilibrium is computed. The first `before` pieces
        // are therefore not counted in this cycle.
        let before = self.path.follower.as_ref().map_or(0, |follower| follower.behind.len());
        while self.path.next().is_some() {}
        if self.completed == 1 {
            self.too_far = end_of_theory(&self.path, self.path.end_of_small_motions()).map(|end| end.what);
            self.left_out = self.path.left_out();
        } else if self.too_far.is_none() {
            // Slips change the contact forces from cycle to cycle, so that the grasp may buckle in a later cycle. This is checked at the end of each
            // cycle.
            let state = self.path.state();
            self.too_far = state.and_then(|state| state.too_far).filter(TooFar::is_unstable);
        }
        self.end().is_none().then_some(())?;
        let first = (self.completed - 1) * self.legs.len();
        let follower = self.path.follower.as_mut()?;
        let energies = core::mem::take(&mut follower.energy);
        let behind = core::mem::take(&mut follower.behind);
        let slips_at_the_end = &follower.segment.problem.slips;
        let n = slips_at_the_end.len();
        let mut record = CycleRecord {
            slid: vec![0.0; n],
            dissipated: energies.iter().map(|leg| leg.dissipated).added(),
            largest: 0.0,
            open: vec![Some(f64::INFINITY); n],
            largest_gap: vec![0.0; n],
            jumps: 0,
            jump_motion: 0.0,
            step_error: core::mem::take(&mut follower.step_error),
            states: Vec::new(),
        };
        for (k, piece) in behind.iter().enumerate().skip(before) {
            // The slips at the end of the piece of the path. If a jump follows, the slips before the jump are taken: the jump is a piece of its own,
            // with its own slips.
            let next = behind
                .get(k + 1)
                .map(|next| next.jump.as_ref().map_or(&next.problem.slips, |jump| &jump.slips));
            record.add(piece, next.unwrap_or(slips_at_the_end), first);
            if piece.jump.is_some() && k > 0 {
                let moved = &piece.there.twist - &behind[k - 1].there.twist;
                let contacts = &self.path.run.grasp.sites()[..self.path.run.grasp.len()];
                let displacement = largest(contacts, &|site| site.map.tr_mul(&moved).norm());
                record.jump_motion = record.jump_motion.max(displacement);
            }
        }
        // The last piece of the path is kept, since the equilibrium at the end of the cycle is computed from it.
        follower.behind.extend(behind.into_iter().last());
        Some(record)
    }

    /// The cycle state at the present point of the path, after the cycles so far. `None` if no equilibrium exists under the load at the beginning of
    /// the cycle, so that there is no path.
    pub(crate) fn cycle_state(&self) -> Option<CycleState> {
        let follower = self.path.follower.as_ref()?;
        let (at, segment) = (&follower.node.at, &follower.segment);
        let offsets = segment.offsets(follower.factor);
        let gap = |i: usize| {
            let open = follower.node.states[i].is_open();
            if open { -segment.grasp.sites()[i].stretch(&offsets[i], &at.twist)[0] } else { 0.0 }
        };
        Some(CycleState {
            forces: at.forces.clone(),
            gaps: numbered(at.forces.len(), &gap),
            slips: segment.problem.slips.clone(),
            twist: at.twist.clone(),
            has_kinetic_friction: segment.problem.has_kinetic_friction(),
        })
    }
}

impl CycleState {
    /// The friction cone of each contact or drive: kinetic if its entry in `has_kinetic_friction` is true, otherwise static. Empty if that list
    /// is empty.
    fn cones(&self, grasp: &Engine) -> Vec<Coulomb> {
        let sites = grasp.sites().iter().zip(&self.has_kinetic_friction);
        sites.map(|(site, is_kinetic)| site.kinetic.filter(|_| *is_kinetic).unwrap_or(site.friction)).list()
    }
}

impl CycleRecord {
    /// Adds a piece of the path to the totals and extremes. `after` are the accumulated slips at its end, and `first` is the index of the cycle's
    /// first leg among all legs followed.
    fn add(&mut self, piece: &StoredPiece<'_>, after: &[SVector<f64, 3>], first: usize) {
        let leg = piece.leg.saturating_sub(first);
        if let Some(jump) = &piece.jump {
            self.jumps += 1;
            for (i, _) in jump.slid.iter().enumerate().filter(|(_, slid)| **slid) {
                self.slid[i] += (piece.problem.slips[i] - jump.slips[i]).norm();
            }
            jump.states.iter().for_each(|states| self.note(leg, states));
        }
        self.largest = self.largest.max(largest(&piece.here.lines, &|line| line.force.norm()));
        self.largest = self.largest.max(largest(&piece.there.forces, &Matrix::norm));
        for (i, state) in piece.states.iter().enumerate() {
            if state.slides() {
                self.slid[i] += (after[i] - piece.problem.slips[i]).norm();
            }
            if !state.is_open() {
                self.open[i] = None;
                continue;
            }
            let offset = piece.problem.offsets[i] + piece.change[i] * piece.to;
            let at_the_end = -piece.problem.sites[i].stretch(&offset, &piece.there.twist)[0];
            let at_the_start = piece.here.gaps[i].gap;
            self.open[i] = self.open[i].map(|gap| gap.min(at_the_start).min(at_the_end));
            self.largest_gap[i] = self.largest_gap[i].max(at_the_start).max(at_the_end);
        }
        self.note(leg, &piece.states);
    }

    fn note(&mut self, leg: usize, states: &[State]) {
        let last = self.states.last();
        let goes_on = last.is_some_and(|(last, before)| *last == leg && are_alike(before, states));
        if !goes_on {
            self.states.push((leg, states.to_vec()));
        }
    }
}
