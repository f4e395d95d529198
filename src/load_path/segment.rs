//! One straight stretch of a load program: load and finger commands are affine in a factor, and so is everything else as
//! long as every contact keeps its state.

use std::sync::Arc;

use nalgebra::{Matrix, SVector};

use super::margin::{Exit, Line, ROUNDING, polygon_exits, round_exit};
use crate::equilibrium::{Cone, NoEquilibrium, Proof, force_size, largest_force, span};
use crate::formulation::{Law, Piece, PieceState, Problem, Slide, State};
use crate::grasp::Grasp;

/// Load and drives at factor 0 and their rates, with the slip of the contacts so far.
pub(super) struct Segment<'g, const D: usize, const C: usize> {
    pub(super) grasp: &'g Grasp<D, C>,
    pub(super) cone: Cone,
    /// At factor 0; its drives count from the slip so far.
    pub(super) problem: Problem<'g, D, C>,
    /// Rates of the drives.
    pub(super) change: Vec<SVector<f64, C>>,
    /// Rate of the load.
    pub(super) direction: SVector<f64, D>,
}

/// The state at a factor and its rates.
#[derive(Debug, Clone)]
pub(super) struct Here<const D: usize, const C: usize> {
    pub(super) lines: Vec<Line<C>>,
    pub(super) twist: SVector<f64, D>,
    pub(super) twist_rate: SVector<f64, D>,
    /// Motions that stretch no spring in these states.
    pub(super) free_motions: Vec<SVector<f64, D>>,
    pub(super) neutral_motions: Vec<SVector<f64, D>>,
    /// The linear piece of these states.
    pub(super) piece: Arc<Piece<D, C>>,
    /// Gap of every contact, its rate, and the sizes that the rounding of both is measured against.
    pub(super) gaps: Vec<[f64; 4]>,
    /// Largest force and displacement of the terms that the state and its rates are sums of.
    pub(super) sizes: [f64; 2],
    pub(super) rate_sizes: [f64; 2],
}

/// Contacts that stand on an edge of their cone, at its apex or at a closed gap, with the facets concerned.
pub(super) type Standing<const C: usize> = Vec<(usize, Vec<Exit<C>>)>;

impl<'g, const D: usize, const C: usize> Segment<'g, D, C> {
    /// Forces, gaps and their rates at a factor. Where the states leave motions free, the twist is that nearest to
    /// `near`: nothing drives the object along them.
    pub(super) fn look(
        &self,
        states: &[State],
        factor: f64,
        near: Option<&SVector<f64, D>>,
    ) -> Result<Here<D, C>, NoEquilibrium<D>> {
        let piece = Arc::new(Piece::new(&self.problem, states));
        let base = piece
            .solve(self.problem.sites, &self.problem.drives, self.problem.load())
            .map_err(|u| self.unbalanced(u.motion))?;
        let rate = piece
            .solve(self.problem.sites, &self.change, &self.direction)
            .map_err(|u| self.unbalanced(u.motion))?;
        let at = self.state(&piece, factor, near).unwrap_or_else(|| PieceState {
            forces: base.forces.iter().zip(&rate.forces).map(|(f, df)| f + df * factor).collect(),
            twist: base.twist + rate.twist * factor,
        });
        Ok(self.here(piece, factor, at, &rate, (0.0, &base)))
    }

    /// The same where contacts slide on the round cone: the first order of what comes next from a state, as long as it lasts.
    pub(super) fn tangent(
        &self,
        states: &[State],
        factor: f64,
        at: &PieceState<D, C>,
        directions: &[Option<SVector<f64, C>>],
    ) -> Result<Here<D, C>, NoEquilibrium<D>> {
        let mut linear = self.problem.clone();
        for (i, direction) in directions.iter().enumerate() {
            if let (State::Sliding { .. }, Some(direction)) = (states[i], direction) {
                let slide = Slide::new(&self.grasp.sites()[i], direction, 0.0);
                linear.laws[i] = self.problem.turning(i, slide);
            }
        }
        let piece = Arc::new(Piece::new(&linear, states));
        let rate = piece
            .solve(self.problem.sites, &self.change, &self.direction)
            .map_err(|u| self.unbalanced(u.motion))?;
        Ok(self.here(piece, factor, at.clone(), &rate, (factor, at)))
    }

    fn unbalanced(&self, motion: Option<SVector<f64, D>>) -> NoEquilibrium<D> {
        let v = motion.unwrap_or_else(SVector::zeros);
        let proof = Proof::FreeMotion { motion: self.grasp.outside(&v), work: v.dot(&self.direction) };
        NoEquilibrium { proof }
    }

    /// A state at a factor with its rates. What vanishes on the way is known up to the rounding of the terms: those of the state
    /// that it was reached from, at another factor, and the way from there.
    fn here(
        &self,
        piece: Arc<Piece<D, C>>,
        factor: f64,
        at: PieceState<D, C>,
        rate: &PieceState<D, C>,
        (since, base): (f64, &PieceState<D, C>),
    ) -> Here<D, C> {
        let PieceState { forces, twist } = at;
        let way = factor - since;
        let [base_drives, drives] = [since, factor].map(|factor| self.drives(factor));
        let base_load = self.problem.wrench + self.direction * since;
        let sites = self.grasp.sites();
        let sizes =
            |drives: &[SVector<f64, C>], twist: &SVector<f64, D>, load: f64, forces: &[SVector<f64, C>]| {
                let travel =
                    sites.iter().zip(drives).map(|(site, a)| span(site, a, twist)).fold(0.0, f64::max);
                [largest_force(sites, drives, twist, load, forces.iter().map(Matrix::norm)), travel]
            };
        let [base_force, base_travel] = sizes(&base_drives, &base.twist, base_load.norm(), &base.forces);
        let rate_sizes = sizes(&self.change, &rate.twist, self.direction.norm(), &rate.forces);
        let most = base_force + way * rate_sizes[0];
        let mut lines = Vec::new();
        let mut gaps = Vec::new();
        for (i, site) in self.grasp.sites().iter().enumerate() {
            let (moved, moving) = (site.map.tr_mul(&twist), site.map.tr_mul(&rate.twist));
            let span_rate = span(site, &self.change[i], &rate.twist);
            let span_here = span(site, &drives[i], &twist);
            let span = span_here.max(span(site, &base_drives[i], &base.twist) + way * span_rate);
            lines.push(Line {
                force: forces[i],
                rate: rate.forces[i],
                force_size: force_size(site, &forces[i], span, most),
                rate_size: force_size(site, &rate.forces[i], span_rate, rate_sizes[0]),
            });
            gaps.push([moved[0] - drives[i][0], moving[0] - self.change[i][0], span, span_rate]);
        }
        Here {
            lines,
            twist,
            twist_rate: rate.twist,
            free_motions: piece.free_motions().to_vec(),
            neutral_motions: piece.neutral_motions(),
            piece,
            gaps,
            sizes: [most, base_travel + way * rate_sizes[1]],
            rate_sizes,
        }
    }

    /// Forces and twist at a factor, solved there: interpolated from afar they would carry the rounding of what they are there.
    /// Where the states leave motions free, the twist is that nearest to `near`.
    pub(super) fn state(
        &self,
        piece: &Piece<D, C>,
        factor: f64,
        near: Option<&SVector<f64, D>>,
    ) -> Option<PieceState<D, C>> {
        let wrench = self.problem.wrench + self.direction * factor;
        let PieceState { mut forces, mut twist } =
            piece.solve(self.problem.sites, &self.drives(factor), &wrench).ok()?;
        if let Some(near) = near {
            for v in piece.free_motions() {
                twist += v * v.dot(&(near - twist));
            }
            for v in &piece.neutral_motions() {
                let shift = v * v.dot(&(near - twist));
                twist += shift;
                for (f, change) in forces.iter_mut().zip(piece.forces_along(&self.problem, &shift)) {
                    *f += change;
                }
            }
        }
        Some(PieceState { forces, twist })
    }

    /// How far it is from a state, in steps along a straight piece, to where a contact reaches an edge.
    pub(super) fn way_to(
        &self,
        contact: usize,
        state: State,
        exit: &Exit<C>,
        here: &Here<D, C>,
        factor: f64,
        at: &PieceState<D, C>,
    ) -> f64 {
        let (force, rate) = (&at.forces[contact], &here.lines[contact].rate);
        if state == State::Open {
            let site = &self.grasp.sites()[contact];
            let gap = site.map.column(0).dot(&at.twist)
                - (self.problem.drives[contact][0] + self.change[contact][0] * factor);
            return gap / -here.gaps[contact][1];
        }
        let slack = |f: &SVector<f64, C>| {
            if exit.facet.norm() == 0.0 { f[0] } else { self.problem.mu(contact) * f[0] - exit.facet.dot(f) }
        };
        slack(force) / -slack(rate)
    }

    /// The drives at a factor.
    pub(super) fn drives(&self, factor: f64) -> Vec<SVector<f64, C>> {
        self.problem.drives.iter().zip(&self.change).map(|(a, da)| a + da * factor).collect()
    }

    /// The local problem at a factor.
    pub(super) fn problem_at(&self, factor: f64) -> Problem<'g, D, C> {
        let wrench = self.problem.wrench + self.direction * factor;
        Problem { drives: self.drives(factor), wrench, wrench_rest: SVector::zeros(), ..self.problem.clone() }
    }

    /// The slip of a contact so far becomes memory: its springs count from there.
    pub(super) fn remember_slip(
        &mut self,
        contact: usize,
        factor: f64,
        twist: &SVector<f64, D>,
        force: &SVector<f64, C>,
    ) {
        let site = &self.grasp.sites()[contact];
        let stretch = self.problem.drives[contact] + self.change[contact] * factor - site.map.tr_mul(twist);
        for axis in 1..site.axes {
            let slip = stretch[axis] - force[axis] / site.k[axis];
            self.problem.slips[contact][axis] += slip;
            self.problem.drives[contact][axis] -= slip;
        }
    }

    pub(super) fn exits(&self, contact: usize, here: &Here<D, C>) -> Vec<Exit<C>> {
        if self.problem.laws[contact] == Law::Bonded {
            return Vec::new();
        }
        if self.cone == Cone::Round {
            round_exit(&self.problem, contact, &here.lines[contact]).into_iter().collect()
        } else {
            polygon_exits(&self.problem, contact, &here.lines[contact])
        }
    }

    /// Where an open contact closes.
    fn closing(gap: &[f64; 4]) -> Option<Exit<C>> {
        let [gap, rate, span, span_rate] = *gap;
        (rate < -ROUNDING * span_rate).then(|| {
            let step = (gap / -rate).max(0.0);
            Exit { step, uncertainty: ROUNDING * (span + step * span_rate) / -rate, facet: SVector::zeros() }
        })
    }

    pub(super) fn ways_out(&self, contact: usize, state: State, here: &Here<D, C>) -> Vec<Exit<C>> {
        match state {
            State::Rolling => self.exits(contact, here),
            State::Open => Self::closing(&here.gaps[contact]).into_iter().collect(),
            // The facets on which it slides stay reached.
            State::Sliding { first, second } => {
                let normals = self.problem.normals(contact);
                let mut exits = self.exits(contact, here);
                exits.retain(|e| e.facet != normals[first] && second.is_none_or(|s| e.facet != normals[s]));
                exits
            }
        }
    }

    /// The smallest step to an edge, an apex or a closed gap, and everything that reaches one there.
    pub(super) fn first_exits(&self, states: &[State], here: &Here<D, C>) -> Option<(f64, Standing<C>)> {
        let ways: Standing<C> =
            states.iter().enumerate().map(|(i, &state)| (i, self.ways_out(i, state, here))).collect();
        let first =
            ways.iter().flat_map(|(_, exits)| exits).min_by(|a, b| a.step.total_cmp(&b.step)).copied()?;
        // Symmetric grasps reach several edges at once: equal up to the rounding of both.
        let tied = |exit: &Exit<C>| exit.step - first.step <= exit.uncertainty + first.uncertainty;
        let together = ways
            .into_iter()
            .map(|(i, exits)| (i, exits.into_iter().filter(tied).collect::<Vec<_>>()))
            .filter(|(_, exits)| !exits.is_empty())
            .collect();
        Some((first.step, together))
    }

    /// The same grasp driven at the rates of this stretch, with these laws. The round cone matters only at its apex: on an edge it
    /// is a facet.
    pub(super) fn rates(&self, laws: Vec<Law<C>>) -> Problem<'g, D, C> {
        let mut rates = Problem {
            laws,
            drives: self.change.clone(),
            slips: vec![SVector::zeros(); self.grasp.len()],
            wrench: self.direction,
            ..self.problem.clone()
        };
        rates.round &= (0..rates.len()).any(|i| rates.may_slide(i));
        rates
    }
}
