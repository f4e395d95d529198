//! Where Newton's method on the rates does not arrive: the ladder of `equilibrium` on the rates of all contacts, and the
//! end of the path where that has no answer either.

use nalgebra::SVector;

use super::PatchPath;
use super::standing::Stand;
use crate::contact::{Law, Mode, State};
use crate::equilibrium::Cone;
use crate::grasp::Twist;
use crate::load_path::event::{Loss, PathEnd};
use crate::load_path::loss::{end_of_path, leaving_motion};
use crate::load_path::segment::Segment;
use crate::load_path::transition::everything_slides;
use crate::object::{Load, Problem};
use crate::proofs::separates_from_here_on;
use crate::search::{Settled, settle};

/// With more contacts the end of a path is only named, where a motion proves a limit load.
const FEW: usize = 32;

impl<'g, const D: usize, const C: usize> PatchPath<'g, D, C> {
    pub(super) fn cone_answered(&self) -> Cone {
        Cone::of::<C>(&self.settings)
    }

    /// The present leg, as the path of few contacts has it, with the slip up to where each contact has come into its state.
    pub(super) fn segment(&self) -> Segment<'g, D, C> {
        let [base, change] = self.program.drives(self.grasp);
        let [from, to] = self.program.load.map(|w| self.grasp.inside_unchecked(&w));
        let mut problem =
            Problem::at_rest(self.grasp.sites(), self.polygon.clone(), false, base, &Load::from(&from));
        for (i, local) in self.locals.iter().enumerate() {
            let site = &self.grasp.sites()[i];
            for axis in 1..site.springs.axes() {
                let slip = local.memory[axis] / site.springs.root_along(axis);
                problem.slips[i][axis] = slip;
                problem.drives[i][axis] -= slip;
            }
        }
        Segment { grasp: self.grasp, cone: self.cone_answered(), problem, change, direction: to - from }
    }

    /// The laws of the rates of all contacts.
    fn laws(&self, problem: &Problem<'_, D, C>, stands: &[Stand]) -> Vec<Law<C>> {
        let on = |contact: usize, facets: &[u16]| {
            let normals = &problem.polygon(contact).normals;
            Law::Edge(facets.iter().map(|&j| normals[usize::from(j)]).collect())
        };
        let law = |(i, local): (usize, &super::local::Local<D, C>)| match local.code {
            Mode::Open => Law::Absent,
            Mode::Rolling => Law::Bonded,
            sliding => {
                let normals = &problem.polygon(i).normals;
                let own = sliding.own_facets(normals.len());
                Law::Edge(own.into_iter().flatten().map(|j| normals[j]).collect())
            }
        };
        let mut laws: Vec<Law<C>> = self.locals.iter().enumerate().map(law).collect();
        for (stand, before) in stands.iter().zip(&self.before) {
            let i = stand.contact as usize;
            laws[i] = if stand.apex {
                problem.laws[i].clone()
            } else if !stand.facets().is_empty() {
                on(i, stand.facets())
            } else if before.0 == Mode::Open {
                Law::Absent
            } else {
                Law::Bonded
            };
        }
        laws
    }

    /// What has slid up to here becomes memory.
    pub(super) fn arrive_all(&mut self) {
        for local in &mut self.locals {
            if local.slides() {
                let u = local.stretch(&self.y, self.tau);
                local.remember(&u, &self.facets);
            }
        }
    }

    /// Asks the ladder for the states of everything that stands on an edge or slides.
    pub(super) fn ask_the_ladder(&mut self, stands: &mut Vec<Stand>) -> Result<(), PathEnd<D, C>> {
        self.arrive_all();
        let segment = self.segment();
        let rates = segment.rates(self.laws(&segment.problem, stands));
        self.looked_at += self.locals.len();
        let loss = self.loss(stands, None);
        let many = self.locals.len() > FEW;
        if many && let Some(limit) = self.proved_limit(&segment, &rates, &loss) {
            return Err(limit);
        }
        let (settled, effort) = settle(&rates, &self.settings);
        let Settled::Found(found, _) = settled else {
            return Err(match settled {
                Settled::FreeMotion(v) if many => {
                    let motion = self.grasp.outside(&v);
                    PathEnd::GivesWay { leg: loss.leg, fraction: loss.fraction, motion }
                }
                Settled::NoneOf(_) | Settled::Separating(_) if many => PathEnd::Ends(loss),
                _ if many => self.undecided(),
                _ => {
                    let (sliding, forces) = (everything_slides(&rates), self.forces());
                    let settled = (settled, &effort);
                    end_of_path(&segment, &rates, settled, &sliding, &forces, loss, &self.settings)
                }
            });
        };
        for (i, state) in found.states.iter().enumerate() {
            let whole = segment.problem.local(i).of_the_rates(&rates.laws[i], *state);
            let code = whole.and_then(State::on_polygon).unwrap_or(Mode::Open);
            // What slid and has not been asked before.
            let contact = u32::try_from(i).unwrap_or(u32::MAX);
            if code != self.locals[i].code && !stands.iter().any(|stand| stand.contact == contact) {
                let stand = self.stand_of(i);
                self.arrive(&stand);
                stands.push(stand);
            }
            self.put(contact, code);
        }
        if self.solve_rates() { Ok(()) } else { Err(self.undecided()) }
    }

    /// A limit load, where the motion with which everything on an edge slides off separates the load just beyond from all that friction can
    /// do.
    fn proved_limit(
        &self,
        segment: &Segment<'g, D, C>,
        rates: &Problem<'g, D, C>,
        loss: &Loss<D>,
    ) -> Option<PathEnd<D, C>> {
        let here = segment.problem_at(loss.fraction);
        let motion = leaving_motion(rates, &here.wrench, &everything_slides(rates))?;
        separates_from_here_on(&here, &motion, &rates.wrench)
            .then(|| PathEnd::LimitLoad(Loss { motion: Some(self.grasp.outside(&motion)), ..loss.clone() }))
    }

    pub(super) fn loss(&self, stands: &[Stand], motion: Option<Twist<D>>) -> Loss<D> {
        let mut contacts: Vec<usize> = stands.iter().map(|stand| stand.contact as usize).collect();
        contacts.extend((0..self.locals.len()).filter(|&i| self.locals[i].slides()));
        contacts.sort_unstable();
        contacts.dedup();
        let load = self.program.load_at(self.tau);
        Loss { leg: self.program.leg, fraction: self.tau, load, contacts, motion }
    }

    /// Where rounding keeps the path from being followed further.
    pub(super) fn undecided(&self) -> PathEnd<D, C> {
        PathEnd::Undecided { leg: self.program.leg, fraction: self.tau }
    }

    /// The motion in which the object goes on.
    pub(super) fn twist_rate(&self) -> SVector<f64, D> {
        let rate = self.springs.factor.preimage(&(self.travel_rate + self.y_rate / self.weight.sqrt()));
        self.without_free_motions(rate)
    }

    /// The same as a unit motion, if it moves.
    pub(super) fn unit_motion(&self) -> Option<Twist<D>> {
        let rate = self.twist_rate();
        (rate.norm() > 0.0).then(|| self.grasp.outside(&rate.normalize()))
    }
}
