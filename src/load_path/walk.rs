//! The walk along a ramp while nothing slides: from closing contact to closing contact, up to the first that leaves.

use nalgebra::SVector;

use super::beyond::{Beyond, just_beyond};
use super::margin::{Exit, Line, ROUNDING, polygon_exits, round_exit};
use super::onset::{Departure, Leaving, Onset, OnsetEvent};
use super::ramp::Ramp;
use crate::equilibrium::{
    Cone, ContactState, Doubt, Effort, Found, NoEquilibrium, Proof, Rung, Settings, Settled, Undecided,
    WorkDone, force_size, settle,
};
use crate::formulation::{Law, Piece, Problem, State};
use crate::grasp::Grasp;

/// The walk along the ramp while nothing slides.
pub(super) struct Walk<'a, const D: usize, const C: usize> {
    pub(super) grasp: &'a Grasp<D, C>,
    pub(super) ramp: &'a Ramp<D, C>,
    pub(super) settings: &'a Settings,
    pub(super) cone: Cone,
    pub(super) rule: Rung,
    /// At factor 0, with the slip of contacts that closed since.
    pub(super) problem: Problem<'a, D, C>,
    /// Rates of drives and load.
    pub(super) change: Vec<SVector<f64, C>>,
    pub(super) direction: SVector<f64, D>,
    pub(super) factor: f64,
}

/// The state at the present factor and its rates.
struct Here<const D: usize, const C: usize> {
    lines: Vec<Line<C>>,
    twist: SVector<f64, D>,
    free_motions: Vec<SVector<f64, D>>,
    /// Gap of every contact, its rate, and the sizes that the rounding of both is measured against.
    gaps: Vec<[f64; 4]>,
}

/// Contacts that stand on an edge of their cone, at its apex or at a closed gap, with the facets concerned.
type Standing<const C: usize> = Vec<(usize, Vec<Exit<C>>)>;

impl<const D: usize, const C: usize> Walk<'_, D, C> {
    pub(super) fn run(&mut self, mut states: Vec<State>) -> Onset<D, C> {
        let mut reached: Option<Standing<C>> = None;
        // Every turn closes a contact for good or ends the walk; the bound only guards against rounding.
        for _ in 0..2 * states.len() + 2 {
            let mut here = match self.look(&states) {
                Ok(here) => here,
                Err(reason) => return Onset::GivesWay { factor: self.factor, reason },
            };
            let at_base = reached.is_none();
            let standing = reached.take().unwrap_or_else(|| self.standing_at_base(&states, &here));
            if !standing.is_empty() {
                let rates = self.rates(&states, &here, &standing);
                let (settled, effort) = settle(&rates, self.settings);
                let stays = |found: &Found<D, C>| {
                    standing.iter().all(|&(i, _)| match found.states[i] {
                        State::Sliding { .. } => false,
                        // What carried no force at the base and opens at once never rolled.
                        State::Open => at_base || states[i] == State::Open,
                        State::Rolling => true,
                    })
                };
                match settled {
                    Settled::Found(found, _) if stays(&found) => {
                        for &(i, _) in &standing {
                            if states[i] == State::Open && found.states[i] == State::Rolling {
                                self.close(i, &here);
                            }
                            states[i] = found.states[i];
                        }
                        here = match self.look(&states) {
                            Ok(here) => here,
                            Err(reason) => return Onset::GivesWay { factor: self.factor, reason },
                        };
                    }
                    settled => return self.event(states, &here, &standing, &rates, settled, &effort),
                }
            }
            match self.first_exits(&states, &here) {
                None => return Onset::Never,
                Some((step, next)) => {
                    self.factor += step;
                    reached = Some(next);
                }
            }
        }
        Onset::Undecided(Undecided { doubt: Doubt::OnTheBoundary, work: WorkDone::default() })
    }

    /// Forces, gaps and their rates at the present factor.
    fn look(&self, states: &[State]) -> Result<Here<D, C>, NoEquilibrium<D>> {
        let piece = Piece::new(&self.problem, states);
        let unbalanced = |motion: Option<SVector<f64, D>>| {
            let v = motion.unwrap_or_else(SVector::zeros);
            let proof = Proof::FreeMotion { motion: self.grasp.outside(&v), work: v.dot(&self.direction) };
            NoEquilibrium { proof }
        };
        let base =
            piece.solve(&self.problem.drives, &self.problem.wrench).map_err(|u| unbalanced(u.motion))?;
        let rate = piece.solve(&self.change, &self.direction).map_err(|u| unbalanced(u.motion))?;
        let twist = base.twist + rate.twist * self.factor;
        let drives = self.drives();
        let forces: Vec<_> =
            base.forces.iter().zip(&rate.forces).map(|(f, df)| f + df * self.factor).collect();
        let largest =
            |forces: &[SVector<f64, C>], load: f64| forces.iter().fold(load, |most, f| most.max(f.norm()));
        let load = self.problem.wrench + self.direction * self.factor;
        let (most, most_rate) = (largest(&forces, load.norm()), largest(&rate.forces, self.direction.norm()));
        let mut lines = Vec::new();
        let mut gaps = Vec::new();
        for (i, site) in self.grasp.sites().iter().enumerate() {
            let (moved, moving) = (site.map.tr_mul(&twist), site.map.tr_mul(&rate.twist));
            let reach = site.map.norm();
            let span = drives[i].norm() + reach * twist.norm();
            let span_rate = self.change[i].norm() + reach * rate.twist.norm();
            lines.push(Line {
                force: forces[i],
                rate: rate.forces[i],
                force_size: force_size(site, &forces[i], span, most),
                rate_size: force_size(site, &rate.forces[i], span_rate, most_rate),
            });
            gaps.push([moved[0] - drives[i][0], moving[0] - self.change[i][0], span, span_rate]);
        }
        Ok(Here { lines, twist, free_motions: piece.free_motions().to_vec(), gaps })
    }

    /// The drives at the present factor.
    fn drives(&self) -> Vec<SVector<f64, C>> {
        self.problem.drives.iter().zip(&self.change).map(|(a, da)| a + da * self.factor).collect()
    }

    /// The local problem at the present factor.
    fn problem_here(&self) -> Problem<'_, D, C> {
        let wrench = self.problem.wrench + self.direction * self.factor;
        Problem { drives: self.drives(), wrench, ..self.problem.clone() }
    }

    /// A contact closes where its finger now is: F_t = 0 to begin with, its slip has followed the surfaces.
    fn close(&mut self, contact: usize, here: &Here<D, C>) {
        let stretch = self.drives()[contact] - self.grasp.sites()[contact].map.tr_mul(&here.twist);
        for axis in 1..self.grasp.sites()[contact].axes {
            self.problem.slips[contact][axis] += stretch[axis];
            self.problem.drives[contact][axis] -= stretch[axis];
        }
    }

    fn exits(&self, contact: usize, here: &Here<D, C>) -> Vec<Exit<C>> {
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

    fn ways_out(&self, contact: usize, state: State, here: &Here<D, C>) -> Vec<Exit<C>> {
        match state {
            State::Rolling => self.exits(contact, here),
            State::Open => Self::closing(&here.gaps[contact]).into_iter().collect(),
            State::Sliding { .. } => Vec::new(),
        }
    }

    /// At the base, a contact on its way out that has no way left to go, or that touches without force, whose fate
    /// only the rates decide.
    fn standing_at_base(&self, states: &[State], here: &Here<D, C>) -> Standing<C> {
        let mut standing = Vec::new();
        for (i, &state) in states.iter().enumerate() {
            let mut exits = self.ways_out(i, state, here);
            exits.retain(|exit| exit.step <= exit.uncertainty);
            let line = &here.lines[i];
            let weightless = state == State::Rolling
                && self.problem.laws[i] != Law::Bonded
                && line.force.norm() <= ROUNDING * line.force_size;
            if weightless || !exits.is_empty() {
                standing.push((i, exits));
            }
        }
        standing
    }

    /// The smallest step to an edge, an apex or a closed gap, and everything that reaches one there.
    fn first_exits(&self, states: &[State], here: &Here<D, C>) -> Option<(f64, Standing<C>)> {
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

    /// The problem in rates: what stands on an edge has that edge, the rest sticks or stays open.
    fn rates(&self, states: &[State], here: &Here<D, C>, standing: &Standing<C>) -> Problem<'_, D, C> {
        let mut laws: Vec<Law<C>> =
            states.iter().map(|s| if *s == State::Open { Law::Absent } else { Law::Bonded }).collect();
        for (i, exits) in standing {
            let facets: Vec<_> = exits.iter().map(|exit| exit.facet).filter(|h| h.norm() > 0.0).collect();
            let line = &here.lines[*i];
            let apex = states[*i] == State::Open
                || facets.is_empty()
                || facets.len() >= C
                || line.force.norm() <= 1e-12 * line.force_size;
            laws[*i] = if apex { self.problem.laws[*i].clone() } else { Law::Edge(facets) };
        }
        Problem {
            laws,
            drives: self.change.clone(),
            slips: vec![SVector::zeros(); self.grasp.len()],
            wrench: self.direction,
            ..self.problem.clone()
        }
    }

    fn event(
        &self,
        states: Vec<State>,
        here: &Here<D, C>,
        standing: &Standing<C>,
        rates: &Problem<D, C>,
        settled: Settled<D, C>,
        effort: &Effort,
    ) -> Onset<D, C> {
        let problem = self.problem_here();
        let beyond = just_beyond(self.grasp, &problem, rates, settled, effort, self.settings, self.cone);
        let leaving = match &beyond {
            Beyond::Continues(continuation) => standing
                .iter()
                .filter_map(|&(contact, _)| match continuation.states[contact] {
                    ContactState::Sliding { direction } => {
                        Some(Leaving { contact, how: Departure::Slides { direction } })
                    }
                    ContactState::Separated if states[contact] == State::Rolling => {
                        Some(Leaving { contact, how: Departure::Opens })
                    }
                    _ => None,
                })
                .collect(),
            _ => standing.iter().map(|(contact, exits)| self.driven_out(*contact, exits)).collect(),
        };
        let load = self.ramp.load_at(self.factor);
        let found = Found {
            states,
            forces: here.lines.iter().map(|line| line.force).collect(),
            twist: here.twist,
            free_motions: here.free_motions.clone(),
            neutral_motions: Vec::new(),
        };
        let state = self.grasp.equilibrium(&problem, &load, &found, self.rule, &Effort::default(), self.cone);
        Onset::At(Box::new(OnsetEvent {
            factor: self.factor,
            load,
            leaving,
            state,
            beyond,
            polygon_factor: None,
        }))
    }

    /// How the load drives a contact out of its cone when there is no equilibrium to show where it would go.
    fn driven_out(&self, contact: usize, exits: &[Exit<C>]) -> Leaving<C> {
        let outward = exits.iter().fold(SVector::zeros(), |sum, exit| sum + exit.facet);
        let how = if outward.norm() == 0.0 {
            Departure::Opens
        } else {
            Departure::Slides { direction: self.grasp.sites()[contact].frame * outward.normalize() }
        };
        Leaving { contact, how }
    }
}
