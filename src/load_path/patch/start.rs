//! Where a path starts, and where each leg of it does.

use std::sync::Arc;

use nalgebra::SVector;

use super::balance::Balance;
use super::bounds_ahead::BoundsAhead;
use super::moving_contact::size;
use super::patch_path::{Due, PatchPath};
use super::sliding_on::SlidingOn;
use super::stand::Stand;
use super::trial_leg::{TrialLeg, loads};
use crate::contact::{Mode, Polygon, ZERO_SLACK};
use crate::grasp::Grasp;
use crate::load_path::event::{Loss, LossKind, PathEnd};
use crate::load_path::leg::Program;
use crate::object::{Load, Problem, stretched};
use crate::search::{Settings, Settled, settle};

impl<'g, const D: usize, const C: usize> PatchPath<'g, D, C> {
    /// The path from the equilibrium under a load.
    pub(super) fn new(
        grasp: &'g Grasp<D, C>,
        program: Program<D, C>,
        polygon: Arc<Polygon<C>>,
        settings: Settings,
        wrench: &SVector<f64, D>,
    ) -> Self {
        let load = Load::from(wrench);
        let problem = grasp.problem(polygon.clone(), false, grasp.drives(), &load);
        let trial = TrialLeg::new(grasp.sites());
        let mut path = Self {
            grasp,
            settings,
            polygon,
            program,
            balance: Balance::new(&problem, &trial),
            trial,
            ahead: BoundsAhead::new(),
            sliding: SlidingOn::default(),
            stands: Vec::new(),
            due: Due::Nothing,
            stalls: 0,
            told: Vec::new(),
            end: None,
        };
        let moves = path.program.begin_leg();
        path.lay_leg();
        if (path.trial.worked_on(wrench).is_some() || !path.everything_sticks())
            && let Err(end) = path.settle(&problem)
        {
            path.balance.contacts.clear();
            path.end = Some(end);
        } else if moves {
            path.set_out();
        } else {
            path.end = Some(PathEnd::Completed);
        }
        path
    }

    /// The elastic trial state on the present leg.
    fn lay_leg(&mut self) {
        let x = self.trial.lay(self.grasp, &self.program);
        self.balance.begin_leg(self.grasp.sites(), &x);
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

    /// Puts the contacts into the states of the equilibrium to start from, if there is one.
    fn settle(&mut self, problem: &Problem<'g, D, C>) -> Result<(), PathEnd<D, C>> {
        let (settled, effort) = settle(problem, &self.settings);
        let Settled::Found(found, _) = settled else {
            let (cone, load) = (self.cone_answered(), self.program.load_at(0.0));
            let outcome = self.grasp.outcome(problem, &load, settled, &effort, cone);
            return Err(PathEnd::NoStart(Box::new(outcome)));
        };
        for (contact, state) in (0..).zip(&found.states) {
            self.balance.put(contact, state.on_polygon().unwrap_or(Mode::Open));
        }
        let sites = self.grasp.sites();
        let x: Vec<f64> = stretched(sites, |i| sites[i].map.tr_mul(&found.twist)).collect();
        let travelled = self.trial.factor.coordinates(&x) - self.trial.travelled;
        self.balance.y = travelled * self.balance.scale();
        self.balance.renew();
        self.balance.settle_at(0.0);
        self.balance.remember_all();
        Ok(())
    }

    /// Sets out on the present leg, or completes the path.
    pub(super) fn begin_leg(&mut self) {
        if self.program.begin_leg() {
            self.lay_leg();
            self.set_out();
        } else {
            self.end = Some(PathEnd::Completed);
        }
    }

    /// Sets out on the present leg, whose trial state is known.
    fn set_out(&mut self) {
        let (_, change) = loads(self.grasp, &self.program);
        if let Some(v) = self.trial.worked_on(&change) {
            let loss = self.loss(Some(self.grasp.outside(&v)));
            self.end = Some(PathEnd::Lost(Loss { fraction: 0.0, kind: LossKind::GivesWay, ..loss }));
            return;
        }
        self.balance.renew();
        self.balance.settle_at(0.0);
        let all = (0..).take(self.balance.contacts.len()).map(|contact| self.balance.stand_of(contact));
        self.stands.clear();
        self.stands.extend(all.filter(|stand: &Stand<C>| !stand.is_nowhere()));
        self.due = Due::Start;
    }
}
