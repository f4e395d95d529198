//! One equilibrium after another in the same memory.

use alloc::sync::Arc;

use nalgebra::SVector;

use super::newton::{newton, trial_holds};
use super::path::{PivotEnd, StatePath};
use super::solution::Solution;
use super::view::{EquilibriumView, Search, Viewed};
use crate::contact::{ContactResponse, Law, Polygon, PolygonCone};
use crate::error::Error;
use crate::forms::Row;
use crate::grasp::{Engine, Site, Space, Twist, Wrench};
use crate::numerics::{Memory, Orthogonal, Vector, without};
use crate::object::{Problem, spring_rows, stretched_into, twist_if_all_stick, worked_on};
use crate::prelude::*;

/// Memory for equilibria of one grasp after another, by Lemke's method on lists of contact states.
#[derive(Debug, Clone)]
pub(crate) struct Workspace {
    pub(super) path: StatePath,
    /// K^{1/2}Gᵀ, one row per spring of the contacts, and its factors: they are kept from the
    /// last scene if only load, commands or friction have changed.
    springs: Vec<Vector>,
    factor: Orthogonal,
    /// Orthonormal motions that stretch none of these springs.
    free: Vec<Vector>,
    /// x⁰, spring by spring.
    x: Vec<f64>,
    laws: Vec<Law>,
    offsets: Vec<SVector<f64, 3>>,
    polygon: Arc<Polygon>,
    /// The settings of the present question.
    pub(super) asked: SearchSettings,
    /// The responses of the contacts on the round cone.
    answers: Vec<ContactResponse>,
    pub(super) solution: Solution,
    /// R q in the trial state.
    travelled: Vector,
    /// The number of Newton's steps, if Newton's method found the solution.
    pub(super) newton_steps: Option<usize>,
    pub(super) twist: Twist<3>,
}

/// The settings of a search.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct SearchSettings {
    /// The polygonal cone of the answer, or that of the start for the round cone.
    pub(crate) cone: PolygonCone,
    /// Whether the answer is for the round cone.
    pub(crate) round: bool,
    /// Whether Lemke's first path is the only one.
    pub(crate) one_path: bool,
}

impl Workspace {
    fn new(space: Space, asked: SearchSettings) -> Self {
        Self {
            path: StatePath::default(),
            springs: Vec::new(),
            factor: Orthogonal::default(),
            free: Vec::new(),
            x: Vec::new(),
            laws: Vec::new(),
            offsets: Vec::new(),
            polygon: Polygon::shared(space, &asked.cone),
            asked,
            answers: Vec::new(),
            solution: Solution::default(),
            travelled: Vector::zeros(),
            newton_steps: None,
            twist: Twist::ZERO,
        }
    }

    fn solve(&mut self, grasp: &Engine, load: &Wrench<3>) -> Result<Search<'_, 3>, Error> {
        // Number of other covering vectors that are tried after a first path without solution.
        let other_paths = if self.asked.one_path { 0 } else { 3 };
        let wrench = grasp.load_alone(load, "load")?;
        self.path.pivots = 0;
        self.laws.clear();
        self.laws.extend(grasp.sites().iter().map(Site::whole_law));
        grasp.offsets_into(&mut self.offsets);
        let mut problem = Problem {
            sites: grasp.sites(),
            polygon: self.polygon.clone(),
            turned: Vec::new(),
            cones: Vec::new(),
            laws: core::mem::take(&mut self.laws),
            offsets: core::mem::take(&mut self.offsets),
            slips: Vec::new(),
            wrench,
            wrench_rest: Vector::zeros(),
            infinite_friction_has_edges: false,
            round: false,
            trial: None,
        };
        let found = self.seek(&mut problem, other_paths);
        (self.laws, self.offsets) = (problem.laws, problem.offsets);
        let pivots = self.path.pivots;
        Ok(match found {
            None => Search::FreeMotion,
            Some(false) => Search::NotFound { pivots },
            Some(true) => {
                self.twist = grasp.outside(&self.solution.twist);
                Search::Found(EquilibriumView::of(self))
            }
        })
    }

    /// Whether an equilibrium was found; `None` if no contact resists the load.
    fn seek(&mut self, problem: &mut Problem, other_paths: usize) -> Option<bool> {
        // Number of contacts from which Newton's method is tried first.
        let newton_first = other_paths > 0 && problem.len() >= 32 && !self.asked.round;
        self.newton_steps = None;
        if newton_first && let Some(from) = twist_if_all_stick(problem, &mut self.answers) {
            // The start is a step, too.
            let steps = newton(problem, from, &mut self.answers, &mut self.solution);
            self.newton_steps = steps.map(|steps| steps + 1);
        }
        if self.newton_steps.is_some() {
            return Some(true);
        }
        if !self.stick(problem) {
            return None;
        }
        Some(if self.asked.round {
            self.round_off(problem, other_paths)
        } else {
            self.search(problem, other_paths)
        })
    }

    /// Searches an equilibrium on the round cone: the trial itself, Newton's method from the trial, or Newton's method from an
    /// equilibrium on polygons. If only one path is allowed, only the last is tried.
    fn round_off(&mut self, problem: &mut Problem, other_paths: usize) -> bool {
        if other_paths > 0 {
            problem.round = true;
            let trial = self.least_motion(&self.travelled);
            let Self { x, answers, solution, .. } = self;
            if trial_holds(problem, (x, &trial), answers, solution) {
                return true;
            }
            if self.newton_on_the_round_cone(problem, trial) {
                return true;
            }
            problem.round = false;
        }
        if !self.search(problem, other_paths) {
            return false;
        }
        problem.round = true;
        self.newton_on_the_round_cone(problem, self.solution.twist.clone())
    }

    fn newton_on_the_round_cone(&mut self, problem: &Problem, from: Vector) -> bool {
        self.newton_steps = newton(problem, from, &mut self.answers, &mut self.solution);
        let twist = core::mem::take(&mut self.solution.twist);
        self.solution.twist = without(twist, &self.free);
        self.newton_steps.is_some()
    }

    /// The rows of a contact whose jump is basic.
    pub(super) fn rows(&self, contact: usize) -> [Option<Row>; 3] {
        let gap = Row::Gap { contact };
        let slip = |facet| Row::Slip { contact, facet };
        if self.asked.round {
            let state = &self.answers[contact].state;
            return [state.is_open().then_some(gap), state.slides().then_some(slip(0)), None];
        }
        if self.newton_steps.is_some() {
            let state = &self.answers[contact].state;
            let [first, second] = state.own_facets(self.polygon.normals.len());
            return [state.is_open().then_some(gap), first.map(slip), second.map(slip)];
        }
        let gaps = usize::from(self.path.form.locals[contact].contact.gap);
        let row = |pair: usize| pair.checked_sub(gaps).map_or(gap, slip);
        let mut rows = self.path.basis.active[contact].iter().map(row);
        core::array::from_fn(|_| rows.next())
    }

    /// Computes the trial state in which every contact sticks; `false` if no contact resists the load.
    fn stick(&mut self, problem: &Problem) -> bool {
        let sites = problem.sites;
        if !spring_rows(sites, &mut self.springs) {
            self.factor.assign(problem.size(), &self.springs);
            self.factor.null_space_into(&mut self.free);
        }
        if worked_on(&self.free, &problem.wrench).is_some() {
            return false;
        }
        stretched_into(sites, |contact| problem.offsets[contact], &mut self.x);
        self.travelled = self.factor.project(&mut self.x, &problem.wrench);
        true
    }

    fn search(&mut self, problem: &Problem, other_paths: usize) -> bool {
        self.path.form.assign(problem, &self.factor, &self.x);
        let limit = self.path.pivot_limit();
        for attempt in 0..=other_paths {
            let end = self.path.run_from_trial(attempt, self.path.pivots + limit);
            if end == PivotEnd::Complementary
                && let Some(y) = self.solution.take(&mut self.path, problem)
            {
                let moved = &self.travelled + y / self.path.form.coordinates.weight.sqrt();
                self.solution.twist = self.least_motion(&moved);
                return true;
            }
        }
        false
    }

    /// The least motion with the coordinates R q.
    fn least_motion(&self, travelled: &Vector) -> Vector {
        without(self.factor.preimage(travelled), &self.free)
    }
}

impl Engine {
    /// [`Workspace::solve`](crate::ask::Workspace::solve), in memory that this engine has used before or that is new.
    pub(crate) fn search_in<'w>(
        &self,
        load: &Wrench<3>,
        asked: &SearchSettings,
        memory: &'w mut Memory,
    ) -> Result<Search<'w, 3>, Error> {
        let workspace = memory.of(|| Workspace::new(self.space(), *asked));
        workspace.asked = *asked;
        workspace.solve(self, load)
    }
}

impl Viewed for Workspace {
    fn forces(&self) -> &[SVector<f64, 3>] {
        &self.solution.forces
    }

    fn twist(&self) -> Twist<3> {
        self.twist
    }

    fn residual(&self) -> f64 {
        self.solution.residual
    }

    fn pivots(&self) -> usize {
        self.path.pivots
    }

    fn newton_steps(&self) -> Option<usize> {
        self.newton_steps
    }

    fn rows(&self, contact: usize) -> [Option<Row>; 3] {
        Self::rows(self, contact)
    }
}
