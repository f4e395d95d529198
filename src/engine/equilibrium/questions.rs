//! The questions of a caller for one equilibrium (`solve`) and for all equilibria (`equilibria`) under a load.

use super::answer::{Equilibrium, Outcome, Undecided, WorkDone};
use super::cone::{AnswerFor, Cone};
use super::contact_answer::ContactState;
use super::no_equilibrium::{NoEquilibrium, Proof};
use super::tolerances::ACCURATE;
use crate::contact::Polygon;
use crate::error::Error;
use crate::grasp::{Engine, Wrench};
use crate::numerics::Vector;
use crate::numerics::tolerances::NEGLIGIBLE;
use crate::object::Problem;
use crate::prelude::*;
use crate::search::{
    Doubt, FoundBy, SearchCounts, SearchOutcome, SearchSolution, Settings, combinations,
    on_the_solution_interval, search, settle, settle_at_rest,
};

impl Engine {
    pub(crate) fn solve(&self, load: &Wrench<3>, settings: &Settings) -> Result<Outcome<3>, Error> {
        let problem = self.problem_under(load, settings)?;
        let (mut settled, effort) = settle_at_rest(&problem, settings);
        if let SearchOutcome::Found(found, rule) = settled {
            settled = SearchOutcome::Found(on_the_solution_interval(&problem, found), rule);
        }
        let outcome = self.outcome(&problem, load, settled, &effort, AnswerFor::of(self.space(), settings));
        outcome.equilibrium().map_or(Ok(()), |state| self.refuse_kinetic_slides("solve", state))?;
        Ok(outcome)
    }

    /// Returns an error if a contact with kinetic friction slides in the equilibrium `state`, which was computed with static friction.
    fn refuse_kinetic_slides(&self, question: &'static str, state: &Equilibrium<3>) -> Result<(), Error> {
        let slides = |i: &usize| matches!(state.contacts[*i].state, ContactState::Sliding { .. });
        match self.weaker_once_they_slide().find(slides) {
            Some(i) => Err(Error::KineticFriction { question, contact: self.contacts()[i].label(i) }),
            None => Ok(()),
        }
    }

    pub(crate) fn equilibria(
        &self,
        load: &Wrench<3>,
        settings: &Settings,
    ) -> Result<Vec<Equilibrium<3>>, Error> {
        let problem = self.problem_under(load, settings)?;
        let combinations = combinations(&problem);
        if combinations > settings.most_states as f64 {
            return Err(Error::TooManyStates {
                contacts: self.len(),
                combinations,
                most: settings.most_states,
            });
        }
        let search = search(&problem, false);
        let effort = SearchCounts { combinations: search.tried, ..SearchCounts::default() };
        let (mut list, mut known) = (Vec::<Equilibrium<3>>::new(), Vec::<SearchSolution>::new());
        let mut add = |found: SearchSolution, rule, effort: &SearchCounts| {
            if known.iter().any(|other| same(&problem, other, &found)) {
                return;
            }
            let answer_for = AnswerFor::of(self.space(), settings);
            let equilibrium = self.equilibrium(&problem, load, found.clone(), rule, effort, answer_for);
            if accurate(&equilibrium) {
                list.push(equilibrium);
                known.push(found);
            }
        };
        for found in search.found {
            add(found, FoundBy::Enumeration, &effort);
        }
        // On the round cone, the search for all equilibria, above, starts Newton's method from equilibria on a polygonal cone. A polygon inside the
        // round cone may allow no equilibrium, or none near an equilibrium on the round cone. Newton's method then misses the equilibrium on the
        // round cone. Therefore the search of `solve` is made, too, which has other starts.
        if problem.round
            && let (SearchOutcome::Found(found, rule), effort) = settle(&problem, settings)
        {
            add(found, rule, &effort);
        }
        list.iter().try_for_each(|state| self.refuse_kinetic_slides("equilibria", state))?;
        Ok(list)
    }

    /// The equilibrium problem of this grasp under a load, with the friction cone of the settings. Returns an error if the load is invalid, or if the
    /// limits up to which rotations, slips and openings count as small are invalid.
    pub(super) fn problem_under(&self, load: &Wrench<3>, settings: &Settings) -> Result<Problem<'_>, Error> {
        settings.small_motions.check()?;
        let polygon = Polygon::shared(self.space(), &settings.cone);
        let load = self.load(load, "load")?;
        Ok(self.problem(polygon, settings.is_round(self.space()), self.offsets(), &load))
    }

    pub(crate) fn outcome(
        &self,
        problem: &Problem,
        load: &Wrench<3>,
        settled: SearchOutcome,
        effort: &SearchCounts,
        answer_for: AnswerFor,
    ) -> Outcome<3> {
        let none = |proof| Outcome::NoEquilibrium(NoEquilibrium { proof });
        let motion_and_work = |v: &Vector| (self.motion_outside(v), v.dot(&problem.wrench));
        match settled {
            SearchOutcome::Found(found, rule) => {
                let equilibrium = self.equilibrium(problem, load, found, rule, effort, answer_for);
                if accurate(&equilibrium) {
                    Outcome::Equilibrium(Box::new(equilibrium))
                } else {
                    Outcome::Undecided(Undecided { doubt: Doubt::Inaccurate, work: equilibrium.work })
                }
            }
            SearchOutcome::FreeMotion(v) => {
                let (motion, work) = motion_and_work(&v);
                none(Proof::FreeMotion { motion, work })
            }
            SearchOutcome::Separating(v) => {
                let (motion, work) = motion_and_work(&v);
                none(Proof::SeparatingMotion { motion, work })
            }
            SearchOutcome::NoneOf(combinations) => none(Proof::EveryStateTried { combinations }),
            SearchOutcome::Contradicted { cases, escape } => {
                none(Proof::EveryCaseContradicted { cases, escape })
            }
            SearchOutcome::Undecided(doubt) => {
                let work = WorkDone {
                    pivots: effort.pivots,
                    rows_made: effort.rows,
                    rows_left_out: self.left_out(effort, answer_for.cone, false),
                    combinations: effort.combinations,
                };
                Outcome::Undecided(Undecided { doubt, work })
            }
        }
    }
}

/// True if every residual is within the tolerance of an equilibrium: 1e-12 on the round cone, otherwise 1e-10 ([`ACCURATE`]).
fn accurate(equilibrium: &Equilibrium<3>) -> bool {
    // If a residual on the round cone exceeds 1e-12, Newton's method has not converged.
    let most = if equilibrium.cone == Cone::Round { 1e-12 } else { ACCURATE };
    equilibrium.residuals.worst() <= most
}

/// Whether two solutions are the same equilibrium: their forces and twists agree. If both have motions that no contact resists, their twists may
/// differ.
fn same(problem: &Problem, a: &SearchSolution, b: &SearchSolution) -> bool {
    let size = |found: &SearchSolution| problem.largest_force(&found.forces, &found.twist);
    // Solutions are the same if forces and motions differ by at most the fraction `NEGLIGIBLE` of the largest force or motion.
    let force = NEGLIGIBLE * size(a).max(size(b));
    let motion = NEGLIGIBLE * a.twist.norm().max(b.twist.norm());
    let moves_freely = !a.free_motions.is_empty() && !b.free_motions.is_empty();
    a.forces.iter().zip(&b.forces).all(|(x, y)| (x - y).norm() <= force)
        && (moves_freely || (&a.twist - &b.twist).norm() <= motion)
}
