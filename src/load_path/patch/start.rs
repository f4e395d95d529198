//! Start of a path, and of each of its legs.

use super::active_set::FacetsReached;
use super::balance::Balance;
use super::bounds_ahead::BoundsAhead;
use super::moving_contact::size;
use super::patch_path::{Due, Patch};
use super::sliding_on::SlidingOn;
use super::trial_leg::{TrialLeg, loads};
use crate::contact::{Mode, ZERO_SLACK};
use crate::load_path::event::{LossKind, PathEnd};
use crate::load_path::journey::Journey;
use crate::object::{Problem, stretched_into};
use crate::prelude::*;
use crate::search::Found;

impl<const C: usize> Patch<C> {
    /// Starts at an equilibrium, if there is one: the one in which everything sticks is tried first.
    pub(super) fn at_start<'g>(
        journey: &Journey<'g, C>,
        problem: &Problem<'g, C>,
    ) -> Result<Self, PathEnd<C>> {
        let trial = TrialLeg::new(problem.sites);
        let mut patch = Self {
            balance: Balance::new(problem, &trial),
            trial,
            ahead: BoundsAhead::new(),
            sliding: SlidingOn::default(),
            stands: Vec::new(),
            due: Due::Nothing,
            is_laid: false,
            stalls: 0,
            told: Vec::new(),
        };
        patch.lay_leg(journey);
        patch.is_laid = journey.program.goes();
        if patch.trial.worked_on(&problem.wrench).is_some() || !patch.everything_sticks() {
            let found = journey.start(problem)?;
            patch.stand_at(problem, &found);
        }
        Ok(patch)
    }

    /// Computes the elastic trial state on the present leg.
    fn lay_leg(&mut self, journey: &Journey<'_, C>) {
        self.trial.lay(journey.grasp, &journey.program);
        self.balance.begin_leg(journey.grasp.sites(), &self.trial.x);
    }

    /// Whether the trial state is an equilibrium.
    fn everything_sticks(&self) -> bool {
        let mut holds = true;
        for contact in &self.balance.contacts {
            let u = self.balance.stretch(contact);
            let level = contact.level(&u, 0.0);
            contact.for_each_bound(self.balance.facets(contact), |_, felt| {
                holds &= felt.dot(&u) >= -ZERO_SLACK * size(felt) * level;
            });
        }
        holds
    }

    /// Puts the contacts into the states of an equilibrium.
    fn stand_at(&mut self, problem: &Problem<'_, C>, found: &Found<C>) {
        for (contact, state) in (0..).zip(&found.states) {
            self.balance.put(contact, state.on_polygon().unwrap_or(Mode::Open));
        }
        let sites = problem.sites;
        let mut x = Vec::new();
        stretched_into(sites, |i| sites[i].map.tr_mul(&found.twist), &mut x);
        let travelled = self.trial.factor.coordinates(&x) - &self.trial.travelled;
        self.balance.y = travelled * self.balance.scale();
        self.balance.renew();
        self.balance.settle_at(0.0);
        self.balance.remember_all();
    }

    /// Starts the present leg.
    pub(super) fn begin_leg(&mut self, journey: &Journey<'_, C>) -> Result<(), PathEnd<C>> {
        if !core::mem::take(&mut self.is_laid) {
            self.lay_leg(journey);
        }
        let (_, change) = loads(journey.grasp, &journey.program);
        if let Some(v) = self.trial.worked_on(&change) {
            return Err(PathEnd::Lost(Box::new(self.loss(journey, LossKind::GivesWay, Some(&v)))));
        }
        self.balance.renew();
        self.balance.settle_at(0.0);
        let all = (0..).take(self.balance.contacts.len()).map(|contact| self.balance.stand_of(contact));
        self.stands.clear();
        self.stands.extend(all.filter(|stand: &FacetsReached<C>| !stand.is_nowhere()));
        self.due = Due::Start;
        Ok(())
    }
}
