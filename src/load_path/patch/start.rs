//! Where a path starts: contacts laid out, and the equilibrium under the first load.

use std::sync::Arc;

use nalgebra::SVector;

use super::PatchPath;
use super::balance::Sums;
use super::layout::{Springs, lay_out};
use super::local::size;
use super::queue::{Course, Queue};
use crate::contact::ZERO_SLACK;
use crate::contact::{Mode, Polygon};
use crate::grasp::Grasp;
use crate::load_path::event::PathEnd;
use crate::load_path::leg::Program;
use crate::object::{Load, Problem};
use crate::search::{Settings, Settled, settle};

impl<'g, const D: usize, const C: usize> PatchPath<'g, D, C> {
    pub(super) fn new(
        grasp: &'g Grasp<D, C>,
        program: Program<D, C>,
        polygon: Arc<Polygon<C>>,
        settings: Settings,
    ) -> Self {
        let springs = Springs::new(grasp.sites());
        let weight = springs.factor.rank().max(1) as f64 / grasp.len() as f64;
        let zero = SVector::zeros();
        Self {
            grasp,
            settings,
            polygon,
            program,
            springs,
            locals: Vec::new(),
            facets: Vec::new(),
            weight,
            sums: Sums::zero(),
            age: 0,
            factors: Sums::zero().factors(),
            travelled: zero,
            travel_rate: zero,
            tau: 0.0,
            y: zero,
            y_rate: zero,
            pace: 1.0,
            ahead: Queue::default(),
            reference: Course::default(),
            last_heading: None,
            gone: 0.0,
            steps: 0,
            stride: 1.0,
            slipping: Queue::default(),
            heading: Course::default(),
            resting: Vec::new(),
            looked: Vec::new(),
            exits: Vec::new(),
            stands: Vec::new(),
            before: Vec::new(),
            at_node: false,
            sets_out: false,
            stalls: 0,
            told: Vec::new(),
            looked_at: 0,
            end: None,
        }
    }

    /// The equilibrium to start from.
    pub(super) fn start(&mut self, wrench: &SVector<f64, D>) {
        let drives = self.grasp.drives();
        let load = Load::from(wrench);
        let problem = Problem::at_rest(self.grasp.sites(), self.polygon.clone(), false, drives, &load);
        (self.locals, self.facets) = lay_out(&problem, &self.springs, self.weight);
        let moves = self.program.begin_leg();
        self.lay_trial();
        self.renew();
        self.factors = self.sums.factors();
        if self.springs.worked_on(wrench).is_some() || !self.everything_sticks() {
            let (settled, effort) = settle(&problem, &self.settings);
            let Settled::Found(found, _) = settled else {
                let cone = self.cone_answered();
                let load = self.program.load_at(0.0);
                let outcome = self.grasp.outcome(&problem, &load, settled, &effort, cone);
                self.end = Some(PathEnd::NoStart(Box::new(outcome)));
                self.locals.clear();
                return;
            };
            for (i, state) in (0..).zip(&found.states) {
                let code = state.on_polygon().unwrap_or(Mode::Open);
                self.put(i, code);
            }
            let x: Vec<f64> = (self.grasp.sites().iter())
                .flat_map(|site| {
                    (0..site.springs.axes())
                        .map(|axis| site.springs.root_along(axis) * site.map.column(axis).dot(&found.twist))
                })
                .collect();
            self.y = (self.springs.factor.coordinates(&x) - self.travelled) * self.weight.sqrt();
            self.renew();
            self.factors = self.sums.factors();
            self.settle_at(0.0);
            self.arrive_all();
        }
        if moves {
            self.set_out();
        } else {
            self.end = Some(PathEnd::Completed);
        }
    }

    /// Whether the trial state is an equilibrium.
    fn everything_sticks(&self) -> bool {
        let mut holds = true;
        for local in &self.locals {
            let u = local.stretch(&self.y, 0.0);
            let level = local.level(&u, 0.0);
            local.for_each_bound(&self.facets, |_, felt| {
                holds &= felt.dot(&u) >= -ZERO_SLACK * size(felt) * level;
            });
        }
        holds
    }
}
