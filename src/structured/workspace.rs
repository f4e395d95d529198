//! One equilibrium after another in the same memory.

use std::sync::Arc;

use nalgebra::SVector;

use super::newton::newton;
use super::path::{End, Path};
use super::round_cone;
use super::solution::Solution;
use super::view::{Search, View};
use crate::contact::{Answer, Law, Polygon, PolygonCone};
use crate::error::Error;
use crate::forms::Row;
use crate::grasp::{Grasp, Site, Twist, Wrench};
use crate::numerics::{Orthogonal, without};
use crate::object::{Problem, spring_rows, stretched_into, worked_on};

/// Paths with other covering vectors that are tried after a first one without solution.
const OTHER_PATHS: usize = 3;
/// From this many contacts on Newton's method is tried first.
const MANY: usize = 32;

/// Memory for equilibria under one load after another, by Lemke's method on lists of contact
/// states.
///
/// After the first scene it allocates nothing for scenes with no more contacts. The first that needs
/// Lemke's method after others that Newton's has settled is a first scene, too. With thousands of
/// contacts the thread pool of the feature `parallel` may allocate.
///
/// It looks for one equilibrium, in space on the polygonal cone or
/// [on the round one](Self::on_the_round_cone), and says how exactly it satisfies every condition.
/// It proves nothing where it finds none. [`Grasp::solve`] knows more ways to one, proofs that there
/// is none, and the answer as physics.
///
/// Each scene is solved by itself, from slips of zero: nothing of the answer before goes into the
/// next one. `D` and `C` are 3 and 2 in the plane, 6 and 3 in space.
#[derive(Debug, Clone)]
pub struct Workspace<const D: usize, const C: usize> {
    pub(super) path: Path<D, C>,
    /// K^{1/2}Gᵀ, row by row the springs of the contacts, and its factors: they are those of the
    /// last scene if only load, commands or friction have changed.
    springs: Vec<SVector<f64, D>>,
    factor: Orthogonal<D>,
    /// x⁰, spring by spring.
    x: Vec<f64>,
    laws: Vec<Law<C>>,
    drives: Vec<SVector<f64, C>>,
    cone: PolygonCone,
    polygon: Arc<Polygon<C>>,
    /// Whether answers are for the round cone.
    round: bool,
    /// What contacts answer there.
    answers: Vec<Answer<C>>,
    pub(super) solution: Solution<D, C>,
    /// R q in the trial state.
    travelled: SVector<f64, D>,
    /// Steps of Newton's method, if they led to the solution.
    pub(super) newton_steps: Option<usize>,
    pub(super) twist: Twist<D, C>,
}

impl<const D: usize, const C: usize> Default for Workspace<D, C> {
    fn default() -> Self {
        Self::new(PolygonCone::default())
    }
}

impl<const D: usize, const C: usize> Workspace<D, C> {
    /// A workspace without memory yet, for answers on this polygonal cone, which is looked at in
    /// space only.
    #[must_use]
    pub fn new(cone: PolygonCone) -> Self {
        Self {
            path: Path::default(),
            springs: Vec::new(),
            factor: Orthogonal::default(),
            x: Vec::new(),
            laws: Vec::new(),
            drives: Vec::new(),
            cone,
            polygon: Polygon::shared(&cone),
            round: false,
            answers: Vec::new(),
            solution: Solution::default(),
            travelled: SVector::zeros(),
            newton_steps: None,
            twist: Twist::from_vector(SVector::zeros()),
        }
    }

    /// A workspace without memory yet, for answers on the round cone: by Newton's method from the
    /// elastic trial state, else from an equilibrium on the default polygonal cone. In the plane
    /// there is only one cone.
    ///
    /// ```
    /// use grasp_lcp::spatial::{Contact, Grasp, Wrench};
    /// use grasp_lcp::structured::{Search, Workspace};
    ///
    /// // Four fingers on a ring, 10 N each, μ = 0.5: the round cone carries 20 N upwards whatever the frames.
    /// let finger = |x: f64, y: f64| {
    ///     Contact::new([x, y, 0.0], [-x, -y, 0.0]).series_stiffness(1e3, 8e2).friction(0.5).command([0.01, 0.0, 0.0])
    /// };
    /// let grasp = Grasp::new([finger(1.0, 0.0), finger(0.0, 1.0), finger(-1.0, 0.0), finger(0.0, -1.0)])?;
    /// let mut workspace = Workspace::on_the_round_cone();
    /// for up in [0.0, 10.0, 19.9] {
    ///     let Search::Found(found) = workspace.solve(&grasp, &Wrench::force([0.0, 0.0, up]))? else { panic!("it holds") };
    ///     assert!(found.residual() < 1e-13);
    /// }
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    #[must_use]
    pub fn on_the_round_cone() -> Self {
        Self { round: C == 3, ..Self::default() }
    }

    /// The polygonal cone that answers are for, or that leads to the round one.
    #[must_use]
    pub fn cone(&self) -> PolygonCone {
        self.cone
    }

    /// Whether answers are for the round cone.
    #[must_use]
    pub fn is_round(&self) -> bool {
        self.round
    }

    /// An equilibrium of a grasp under a load on the object. It is found by Newton's method from 32
    /// contacts on and on the round cone, if that arrives, else along up to four of Lemke's paths from
    /// the elastic trial state. A step of Newton's method and a pivot cost O(n) with n contacts.
    ///
    /// ```
    /// use grasp_lcp::PolygonCone;
    /// use grasp_lcp::planar::{Contact, Grasp, Wrench};
    /// use grasp_lcp::structured::{Search, Workspace};
    ///
    /// // Eight springs under a block of 16 N, which is pulled sideways: μ = 0.5 holds 8 N.
    /// let spring = |i: u8| {
    ///     Contact::new([f64::from(i), 0.0], [0.0, 1.0]).series_stiffness(1000.0, 800.0).friction(0.5).command([0.002, 0.0])
    /// };
    /// let grasp = Grasp::new((0..8).map(spring))?;
    /// let mut workspace = Workspace::new(PolygonCone::default());
    /// for pull in 0..8 {
    ///     let load = Wrench::force_at([f64::from(pull), -16.0], [3.5, 0.0]);
    ///     let Search::Found(found) = workspace.solve(&grasp, &load)? else { panic!("it holds") };
    ///     assert!(found.residual() < 1e-14);
    ///     assert!((found.twist().translation()[0] - f64::from(pull) / 6400.0).abs() < 1e-15);
    /// }
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Wrench`] if a component of the load is not finite or larger than 1e50.
    pub fn solve(&mut self, grasp: &Grasp<D, C>, load: &Wrench<D, C>) -> Result<Search<'_, D, C>, Error> {
        self.solve_along(OTHER_PATHS, grasp, load)
    }

    /// The same along Lemke's first path only, that of the covering vector of ones, whatever the
    /// number of contacts. On the round cone Newton's method goes on from where it leads.
    ///
    /// # Errors
    /// As for [`Workspace::solve`].
    pub fn solve_along_one_path(
        &mut self,
        grasp: &Grasp<D, C>,
        load: &Wrench<D, C>,
    ) -> Result<Search<'_, D, C>, Error> {
        self.solve_along(0, grasp, load)
    }

    fn solve_along(
        &mut self,
        other_paths: usize,
        grasp: &Grasp<D, C>,
        load: &Wrench<D, C>,
    ) -> Result<Search<'_, D, C>, Error> {
        let wrench = grasp.load_alone(load, "load")?;
        self.path.pivots = 0;
        self.laws.clear();
        self.laws.extend(grasp.sites().iter().map(Site::whole_law));
        grasp.drives_into(&mut self.drives);
        let mut problem = Problem {
            sites: grasp.sites(),
            polygon: self.polygon.clone(),
            turned: Vec::new(),
            laws: std::mem::take(&mut self.laws),
            drives: std::mem::take(&mut self.drives),
            slips: Vec::new(),
            wrench,
            wrench_rest: SVector::zeros(),
            infinite_friction_has_edges: false,
            round: false,
            trial: None,
        };
        let found = self.seek(&mut problem, other_paths);
        (self.laws, self.drives) = (problem.laws, problem.drives);
        let pivots = self.path.pivots;
        Ok(match found {
            None => Search::FreeMotion,
            Some(false) => Search::NotFound { pivots },
            Some(true) => {
                self.twist = grasp.outside(&self.solution.twist);
                Search::Found(View::of(self))
            }
        })
    }

    /// Whether an equilibrium is found; `None` if no contact resists the load.
    fn seek(&mut self, problem: &mut Problem<D, C>, other_paths: usize) -> Option<bool> {
        let newton_first = other_paths > 0 && problem.len() >= MANY && !self.round;
        self.newton_steps = newton_first.then(|| newton(problem, &mut self.solution)).flatten();
        if self.newton_steps.is_some() {
            return Some(true);
        }
        if !self.stick(problem) {
            return None;
        }
        Some(if self.round {
            self.round_off(problem, other_paths)
        } else {
            self.search(problem, other_paths)
        })
    }

    /// An equilibrium on the round cone: the trial itself, what Newton's method finds from there, or from an
    /// equilibrium on polygons. Along one path only the last.
    fn round_off(&mut self, problem: &mut Problem<D, C>, other_paths: usize) -> bool {
        if other_paths > 0 {
            problem.round = true;
            let trial = self.least_motion(&self.travelled);
            let Self { x, answers, solution, .. } = self;
            if round_cone::trial_holds(problem, (x, &trial), answers, solution) {
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
        self.newton_on_the_round_cone(problem, self.solution.twist)
    }

    fn newton_on_the_round_cone(&mut self, problem: &Problem<D, C>, from: SVector<f64, D>) -> bool {
        self.newton_steps = round_cone::newton(problem, from, &mut self.answers, &mut self.solution);
        self.solution.twist = self.at_rest_along_free_motions(self.solution.twist);
        self.newton_steps.is_some()
    }

    /// The rows of a contact whose jumps are basic.
    pub(super) fn rows(&self, contact: usize) -> [Option<Row>; 3] {
        let gap = Row::Gap { contact };
        let slip = |facet| Row::Slip { contact, facet };
        if self.round {
            let state = &self.answers[contact].state;
            return [state.is_open().then_some(gap), state.slides().then_some(slip(0)), None];
        }
        if self.newton_steps.is_some() {
            let state = &self.solution.states[contact];
            let [first, second] = state.own_facets(self.polygon.normals.len());
            return [state.is_open().then_some(gap), first.map(slip), second.map(slip)];
        }
        let gaps = usize::from(self.path.form.locals[contact].contact.gap);
        let row = |pair: usize| pair.checked_sub(gaps).map_or(gap, slip);
        let mut rows = self.path.basis.active[contact].iter().map(row);
        std::array::from_fn(|_| rows.next())
    }

    /// The trial state in which every contact sticks; `false` if no contact resists the load.
    fn stick(&mut self, problem: &Problem<D, C>) -> bool {
        let sites = problem.sites;
        if !spring_rows(sites).eq(self.springs.iter().copied()) {
            self.springs.clear();
            self.springs.extend(spring_rows(sites));
            self.factor.assign(&self.springs);
        }
        let free = self.factor.null_vectors();
        if worked_on(&free[..D - self.factor.rank()], &problem.wrench).is_some() {
            return false;
        }
        stretched_into(sites, |contact| problem.drives[contact], &mut self.x);
        self.travelled = self.factor.project(&mut self.x, &problem.wrench);
        true
    }

    fn search(&mut self, problem: &Problem<D, C>, other_paths: usize) -> bool {
        self.path.form.assign(problem, &self.factor, &self.x);
        let limit = self.path.pivot_limit();
        for attempt in 0..=other_paths {
            let end = self.path.run_from_trial(attempt, self.path.pivots + limit);
            if end == End::Complementary
                && let Some(y) = self.solution.take(&mut self.path, problem)
            {
                let moved = self.travelled + y / self.path.form.coordinates.weight.sqrt();
                self.solution.twist = self.least_motion(&moved);
                return true;
            }
        }
        false
    }

    /// The least motion with these coordinates R q.
    fn least_motion(&self, travelled: &SVector<f64, D>) -> SVector<f64, D> {
        self.at_rest_along_free_motions(self.factor.preimage(travelled))
    }

    fn at_rest_along_free_motions(&self, twist: SVector<f64, D>) -> SVector<f64, D> {
        without(twist, &self.factor.null_vectors()[..D - self.factor.rank()])
    }
}
