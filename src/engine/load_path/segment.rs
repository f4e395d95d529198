//! A segment describes one leg (section) of a load program, a ramp or a turn: the load and the spring offsets of contacts (commanded displacement
//! minus clearance and slip) as functions of one parameter, the load factor. On a ramp it is the multiple of the growing load, on a leg the fraction
//! of the leg that is done, and on a turn without a leg the angle. The load changes linearly or turns, and commands change linearly. While contacts
//! keep their states (sticking, sliding or open), forces and motions are linear functions, too, or harmonics of the load's angle. A piece is a part
//! of a leg with fixed contact states. Along an arc, a piece on which directions of sliding turn, arclength takes the place of the load factor. The
//! rate problem is the complementarity problem for the rates of forces and motion. A drive, the spring of a joint or tendon of a hand with its force
//! limit, is treated like a contact.

use nalgebra::{Matrix, SVector};

use super::arc::SharedTerms;
use super::first_exits::{FirstExits, first_reached};
use super::trajectory::Trajectory;
use super::turning_state::TurningState;
use crate::contact::{ActiveSet, Exit, GapLine, Law, Line, State};
use crate::equilibrium::{AnswerFor, NoEquilibrium, Proof};
use crate::grasp::Engine;
use crate::numerics::{Each, IntoList, Reals, Vector, cleared_for, mapped, paired};
use crate::object::{ForcesAndTwist, LinearProblem, Problem, largest_force};
use crate::prelude::*;

/// The load along one leg, ramp or turn as a function of the load factor. The offset of the spring of each contact or drive (command minus clearance
/// and accumulated slip) changes linearly: its value at load factor 0 and its rate are stored.
#[derive(Debug, Clone)]
pub(super) struct Segment<'g> {
    pub(super) grasp: &'g Engine,
    pub(super) answer_for: AnswerFor,
    /// The static problem at load factor 0. Its offsets are commands minus clearances and accumulated slips.
    pub(super) problem: Problem<'g>,
    /// For each contact and drive the rate of the offset of its spring, m per unit of the load factor; zero while the load turns.
    pub(super) change: Vec<SVector<f64, 3>>,
    /// The sum of all loads as a function of the load factor, with moments about the centroid of the contacts.
    pub(super) trajectory: Trajectory<Vector>,
    /// The largest contact force or load on the path so far, N. Rounding errors are proportional to this force even where all forces vanish together.
    pub(super) largest: f64,
}

/// Forces, twist and gaps of the grasp at a load factor, with their rates. On a straight piece the rates are per unit of the load factor, along an
/// arc per unit of arclength.
#[derive(Debug, Clone)]
pub(super) struct PathPoint {
    pub(super) lines: Vec<Line>,
    pub(super) twist: Vector,
    pub(super) twist_rate: Vector,
    /// Rate of the load factor: one on a straight piece; per unit of arclength, and at most one, along an arc.
    pub(super) factor_rate: f64,
    /// Orthonormal motions that stretch no spring in the present contact states.
    pub(super) free_motions: Vec<Vector>,
    /// Orthonormal motions along which contact forces change but stay in balance.
    pub(super) neutral_motions: Vec<Vector>,
    /// The factorised linear problem for forces and twist while contacts keep their states.
    pub(super) linear_problem: alloc::sync::Arc<LinearProblem>,
    /// On an arc, the terms of its equation `T q' = b λ'` from contacts that do not slide. T is the tangent stiffness for the twist q, and b the rate
    /// of the load (and of the forces of commands) per unit of the load factor λ. All points of the arc share these terms.
    pub(super) fixed: SharedTerms,
    pub(super) gaps: Vec<GapLine>,
    /// Largest force (N) and displacement (m) among the terms whose sums are the forces and displacements of this point. Rounding errors are
    /// proportional to these magnitudes.
    pub(super) sizes: [f64; 2],
    /// Largest rate of force and of displacement among the terms whose sums are the rates of forces and displacements of this point. Rounding errors
    /// of these rates are proportional to them.
    pub(super) rate_sizes: [f64; 2],
    /// While the load turns, forces, stretches and twist as harmonic functions of the load's angle. `None` if rates are constant, or if only the
    /// present rates are known.
    pub(super) turned: Option<alloc::sync::Arc<TurningState>>,
}

impl PathPoint {
    /// Forces and twist after the step `step`: a change of the load factor, or an arclength along an arc. They are extrapolated linearly or, while
    /// the load turns, as harmonics.
    pub(super) fn after(&self, step: f64) -> ForcesAndTwist {
        if let Some(turned) = &self.turned {
            let ForcesAndTwist { forces, twist } = turned.after(step);
            return ForcesAndTwist { forces, twist: &self.twist + twist };
        }
        let forces = mapped(&self.lines, &|line| line.force + line.rate * step);
        ForcesAndTwist { forces, twist: &self.twist + &self.twist_rate * step }
    }

    /// A copy of this point in which all rates are multiplied by `part`. `part` is the rate of the load factor per unit of arclength. Rates per unit
    /// of the load factor thus become rates per unit of arclength.
    pub(super) fn slowed(&self, part: f64) -> Self {
        let mut point = self.clone();
        point.twist_rate *= part;
        point.factor_rate *= part;
        point.rate_sizes = point.rate_sizes.each(|size| size * part);
        for (line, gap) in point.lines.iter_mut().zip(&mut point.gaps) {
            line.rate *= part;
            line.rate_size *= part;
            gap.rate *= part;
            gap.rate_size *= part;
        }
        point
    }
}

impl<'g> Segment<'g> {
    /// Forces, twist, gaps and their rates at the load factor `factor`, while contacts have the states `states`. If no spring resists some motion,
    /// many twists are solutions: the twist returned is the one nearest to `near`, and its rate the one nearest to `pushed`. `pushed` is the twist
    /// rate that solves the rate problem. In it contacts that touch without force may push the object along a motion that no spring resists. Returns
    /// an error if forces cannot balance the load or its rate.
    pub(super) fn point_at(
        &self,
        states: &[State],
        factor: f64,
        near: Option<&Vector>,
        pushed: Option<&Vector>,
    ) -> Result<PathPoint, NoEquilibrium<3>> {
        let linear_problem = self.problem.linear_problem(states);
        let rate = match &self.trajectory {
            Trajectory::Straight { rate, .. } => rate,
            Trajectory::Turn { load, angle } => {
                return self.point_on_turn(&linear_problem, (load, *angle), factor, near);
            }
        };
        let base = linear_problem
            .solve(self.problem.sites, &self.problem.offsets, self.problem.load())
            .map_err(|u| self.unbalanced(factor, u.motion))?;
        let rate = linear_problem
            .solve(self.problem.sites, &self.change, rate)
            .map_err(|u| self.unbalanced(factor, u.motion))?;
        let rate = self.pushed_along(&linear_problem, rate, pushed);
        let at = self.state(&linear_problem, factor, near).unwrap_or_else(|| ForcesAndTwist {
            forces: paired(&base.forces, &rate.forces, &|(f, df)| f + df * factor),
            twist: &base.twist + &rate.twist * factor,
        });
        Ok(self.point_with_rates(linear_problem, factor, at, (&rate, 1.0), (0.0, &base)))
    }

    /// A further point of the arc on which `before` lies: the forces and twist `at` at the load factor `factor`. Its rates `rate`, and the rate
    /// `factor_rate` of the load factor, are per unit of arclength.
    pub(super) fn point_on_arc(
        &self,
        before: &PathPoint,
        factor: f64,
        at: &ForcesAndTwist,
        rate: &ForcesAndTwist,
        factor_rate: f64,
    ) -> PathPoint {
        let linear_problem = before.linear_problem.clone();
        let point =
            self.point_with_rates(linear_problem, factor, at.clone(), (rate, factor_rate), (factor, at));
        PathPoint { fixed: before.fixed.clone(), ..point }
    }

    /// The proof that no equilibrium exists beyond a load factor: no contact resists the motion `motion`, along which the rate of the load does work.
    /// If `motion` is `None`, there is no such motion, but sliding contacts push only in directions that cannot balance the load. The proof then has
    /// the motion zero.
    pub(super) fn unbalanced(&self, factor: f64, motion: Option<Vector>) -> NoEquilibrium<3> {
        let v = motion.unwrap_or_else(Vector::zeros);
        let work = v.dot(&self.trajectory.rate_at(factor));
        let proof = Proof::FreeMotion { motion: self.grasp.motion_outside(&v), work };
        NoEquilibrium { proof }
    }

    /// The forces and twist `at` at the load factor `factor`, with their rates. Rounding errors are proportional to the magnitudes of terms: those of
    /// the forces and twist `base` at the load factor `since`, plus those of the change from `since` to `factor`. Forces and twist may be small
    /// differences of these terms.
    pub(super) fn point_with_rates(
        &self,
        linear_problem: alloc::sync::Arc<LinearProblem>,
        factor: f64,
        at: ForcesAndTwist,
        (rate, factor_rate): (&ForcesAndTwist, f64),
        (since, base): (f64, &ForcesAndTwist),
    ) -> PathPoint {
        let ForcesAndTwist { forces, twist } = at;
        let change: Vec<_> = mapped(&self.change, &|a| a * factor_rate);
        let way = factor - since;
        let [base_offsets, offsets] = [since, factor].each(|factor| self.offsets(factor));
        let base_load = self.trajectory.at(since);
        let sites = self.grasp.sites();
        let sizes = |offsets: &[SVector<f64, 3>], twist: &Vector, load: f64, forces: &[SVector<f64, 3>]| {
            let norm = twist.norm();
            let travel = sites.iter().zip(offsets).map(|(site, a)| site.span_moved(a, norm)).most();
            [largest_force(sites, offsets, twist, load, forces.iter().map(Matrix::norm)), travel]
        };
        let [base_force, base_travel] = sizes(&base_offsets, &base.twist, base_load.norm(), &base.forces);
        let load_rate = self.trajectory.rate_at(factor).norm() * factor_rate.abs();
        let rate_sizes = sizes(&change, &rate.twist, load_rate, &rate.forces);
        let most = (base_force + way * rate_sizes[0]).max(self.largest);
        let [norm, norm_of_base, norm_of_rate] = [&twist, &base.twist, &rate.twist].each(Vector::norm);
        let mut lines = Vec::new();
        let mut gaps = Vec::new();
        for (i, site) in self.grasp.sites().iter().enumerate() {
            let (stretch, stretching) =
                (site.stretch(&offsets[i], &twist), site.stretch(&change[i], &rate.twist));
            let span_rate = site.span_moved(&change[i], norm_of_rate);
            // The magnitude of the accumulated slip is added to the magnitudes of terms: the offset is a command minus this slip, and if both cancel,
            // the rounding error of the slip remains.
            let memory = self.problem.slips[i].norm();
            let span_here = site.span_moved(&offsets[i], norm);
            let span =
                memory + span_here.max(site.span_moved(&base_offsets[i], norm_of_base) + way * span_rate);
            let local = self.problem.local(i);
            lines.push(Line {
                force: forces[i],
                rate: rate.forces[i],
                force_size: local.force_size(&forces[i], span, most),
                rate_size: local.force_size(&rate.forces[i], span_rate, rate_sizes[0]),
            });
            gaps.push(GapLine { gap: -stretch[0], rate: -stretching[0], size: span, rate_size: span_rate });
        }
        PathPoint {
            lines,
            twist,
            twist_rate: rate.twist.clone(),
            factor_rate,
            free_motions: linear_problem.free_motions().to_vec(),
            neutral_motions: linear_problem.neutral_motions(),
            linear_problem,
            fixed: SharedTerms::default(),
            gaps,
            sizes: [most, base_travel + way * rate_sizes[1]],
            rate_sizes,
            turned: None,
        }
    }

    /// Forces and twist at a load factor. They are computed from the load and the offsets at this factor. If they were extrapolated from another load
    /// factor, they would have rounding errors proportional to the forces there, which may be larger. If no spring resists some motion, the twist is
    /// the solution nearest to `near`. `None` if forces cannot balance the load.
    pub(super) fn state(
        &self,
        linear_problem: &LinearProblem,
        factor: f64,
        near: Option<&Vector>,
    ) -> Option<ForcesAndTwist> {
        let wrench = self.trajectory.at(factor);
        let at = linear_problem.solve(self.problem.sites, &self.offsets(factor), &wrench).ok()?;
        Some(if let Some(near) = near { self.nearest(linear_problem, at, near) } else { at })
    }

    /// The change of the load factor along a straight piece, from the path point `at`, at the load factor `factor`, to the exit `exit` of a contact.
    /// An exit is an end of the contact's state, such as the point at which its force reaches the boundary of its cone. Rates are taken from `point`.
    pub(super) fn step_to_exit(
        &self,
        contact: usize,
        state: &State,
        exit: &Exit,
        point: &PathPoint,
        factor: f64,
        at: &ForcesAndTwist,
    ) -> f64 {
        if state.is_open() {
            let offset = self.problem.offsets[contact] + self.change[contact] * factor;
            let gap = -self.grasp.sites()[contact].stretch(&offset, &at.twist)[0];
            return gap / -point.gaps[contact].rate;
        }
        self.problem.local(contact).step_to_exit(exit, &at.forces[contact], &point.lines[contact].rate)
    }

    /// For each contact and drive its offset (command minus clearance and accumulated slip, m) at a load factor.
    pub(super) fn offsets(&self, factor: f64) -> Vec<SVector<f64, 3>> {
        let mut offsets = Vec::new();
        self.offsets_into(factor, &mut offsets);
        offsets
    }

    /// Writes the offset of each contact and drive (command minus clearance and accumulated slip, m) at a load factor into the caller's list
    /// `offsets`.
    pub(super) fn offsets_into(&self, factor: f64, offsets: &mut Vec<SVector<f64, 3>>) {
        cleared_for(offsets, self.change.len());
        self.problem.offsets.iter().zip(&self.change).map(|(a, da)| a + da * factor).append_to(offsets);
    }

    /// This segment with commands and load held constant at their values at the load factor `factor`, so that all their rates are zero.
    pub(super) fn at_rest(&self, factor: f64) -> Self {
        let change = vec![SVector::zeros(); self.change.len()];
        let trajectory = Trajectory::Straight { from: self.trajectory.at(factor), rate: Vector::zeros() };
        Segment { problem: self.problem_at(factor), change, trajectory, ..self.clone() }
    }

    /// The static problem at a load factor, with the offsets and the load at this factor and the accumulated slips of the segment.
    pub(super) fn problem_at(&self, factor: f64) -> Problem<'g> {
        let wrench = self.trajectory.at(factor);
        Problem {
            offsets: self.offsets(factor),
            wrench,
            wrench_rounding_error: Vector::zeros(),
            ..self.problem.clone()
        }
    }

    /// Computes the slip of a contact at the load factor `factor`, the twist `twist` and the contact force `force`. Adds it to the accumulated slip,
    /// and subtracts it from the contact's offset. For contacts without tangential stiffness the slip is taken as zero, because it causes no force.
    pub(super) fn remember_slip(
        &mut self,
        contact: usize,
        factor: f64,
        twist: &Vector,
        force: &SVector<f64, 3>,
    ) {
        let site = &self.grasp.sites()[contact];
        let offset = self.problem.offsets[contact] + self.change[contact] * factor;
        let mut slip = site.springs.slip(&site.stretch(&offset, twist), force);
        if !site.springs.resists_tangentially() {
            slip.fill(0.0);
        }
        self.problem.slips[contact] += slip;
        self.problem.offsets[contact] -= slip;
    }

    /// The exits at which a contact's present state may end, each with the step from the path point `point` to it. An exit is a facet of the cone
    /// that the force reaches, the apex, a closing gap, or a reversal of slip. Steps are changes of the load factor, or arclengths along an arc.
    pub(super) fn ways_out(&self, contact: usize, state: &State, point: &PathPoint) -> Vec<Exit> {
        self.problem.local(contact).ways_out(state, &point.lines[contact], &point.gaps[contact])
    }

    /// For every contact the law for the rates of its force and motion, i.e. the condition on these rates under which the contact law stays
    /// satisfied. It follows from the contact state and from the active set. The active set consists of the facets of the cone on which the contact
    /// force lies; on the round cone it is the tangent plane at the force.
    pub(super) fn laws_of_rates(&self, active_sets: &[ActiveSet], states: &[State]) -> Vec<Law> {
        let locals = self.problem.locals().zip(active_sets).zip(states);
        locals.map(|((local, active), state)| local.law_of_rates(active, state)).list()
    }

    /// The smallest step from `point` at which the present state of a contact ends, with all contacts whose states end there. A state ends at a facet
    /// of the cone, the apex, a closing gap or a reversal of slip. For a load that turns, steps up to `rest` (a change of the load factor) are
    /// searched.
    pub(super) fn first_exits(&self, states: &[State], point: &PathPoint, rest: f64) -> FirstExits {
        if let Some(turned) = &point.turned {
            return turned.first_exits(&self.problem, states, rest);
        }
        let ways = states.iter().enumerate().map(|(i, state)| (i, self.ways_out(i, state, point)));
        FirstExits { reached: first_reached(ways.list()), touches: Vec::new() }
    }

    /// The rate problem on this segment at a load factor. `laws` has for each contact the condition on the rates of its force and motion under which
    /// the contact law stays satisfied.
    pub(super) fn rates(&self, factor: f64, laws: Vec<Law>) -> Problem<'g> {
        self.problem.at_rates(laws, self.change.clone(), self.trajectory.rate_at(factor))
    }
}
