//! One equilibrium after another in the same memory.

use std::sync::Arc;

use nalgebra::SVector;

use super::newton::newton;
use super::path::{End, Path};
use super::solution::Solution;
use crate::contact::{Law, Polygon, PolygonCone};
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
/// After the first scene it allocates nothing for scenes with no more contacts (with thousands of
/// them the thread pool of the feature `parallel` may). It looks for one equilibrium, in space on
/// the polygonal cone, and says how exactly it satisfies every condition; it proves nothing where
/// it finds none. [`Grasp::solve`] knows more ways to one, proofs that there is none, the round
/// cone and the answer as physics.
///
/// Each scene is solved by itself, from slips of zero: nothing of the answer before goes into the
/// next one. `D` and `C` are 3 and 2 in the plane, 6 and 3 in space.
#[derive(Debug, Clone)]
pub struct Workspace<const D: usize, const C: usize> {
    path: Path<D, C>,
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
    solution: Solution<D, C>,
    /// R q in the trial state.
    travelled: SVector<f64, D>,
    /// Steps of Newton's method, if they led to the solution.
    newton_steps: Option<usize>,
    twist: Twist<D, C>,
}

/// How a search for an equilibrium ended.
#[derive(Debug, Clone, Copy)]
#[non_exhaustive]
pub enum Search<'a, const D: usize, const C: usize> {
    /// An equilibrium, each condition satisfied to 1e-10 of its terms ([`View::residual`]).
    Found(View<'a, D, C>),
    /// The load works on a motion that no contact resists: there is no equilibrium.
    FreeMotion,
    /// Lemke's paths ended on rays, at the limit on their pivots (10 000 + 100 a row of the
    /// kinematic form) or on a point that does not satisfy every condition. There may be an
    /// equilibrium or none.
    NotFound {
        /// Pivots of all paths.
        pivots: usize,
    },
}

/// An equilibrium in the memory of its workspace.
#[derive(Debug, Clone, Copy)]
pub struct View<'a, const D: usize, const C: usize> {
    workspace: &'a Workspace<D, C>,
}

impl<'a, const D: usize, const C: usize> View<'a, D, C> {
    /// Forces on the object in the contact frames, N, one a contact in the order of the grasp:
    /// (`F_n`, `F_t`…), `F_n` > 0 pushes.
    #[must_use]
    pub fn forces(&self) -> &'a [SVector<f64, C>] {
        &self.workspace.solution.forces
    }

    /// Motion of the object: displacement of the origin (m) and rotation (rad), the least one if
    /// the contacts leave it free motions.
    #[must_use]
    pub fn twist(&self) -> Twist<D, C> {
        self.workspace.twist
    }

    /// The largest violation of a condition, relative to the sizes of its terms: balance of forces
    /// and moments, friction cones, gaps and slips. At most 1e-10, as a rule a few roundings.
    #[must_use]
    pub fn residual(&self) -> f64 {
        self.workspace.solution.residual
    }

    /// Pivots of Lemke's method, on all paths; 0 if every contact rolls or Newton's method led to
    /// the equilibrium.
    #[must_use]
    pub fn pivots(&self) -> usize {
        self.workspace.path.pivots
    }

    /// Steps of Newton's method, if they led to it: then no pivot was needed.
    #[must_use]
    pub fn newton_steps(&self) -> Option<usize> {
        self.workspace.newton_steps
    }

    /// The pairs of the kinematic form whose jump (gap or slip) is basic, contact by contact. A
    /// contact that rolls has none, and one that is open has its [`Row::Gap`]. One that slides
    /// across a facet has one [`Row::Slip`], at a corner of the polygon it has two.
    pub fn jumps(&self) -> impl Iterator<Item = Row> + 'a {
        let workspace = self.workspace;
        (0..self.forces().len()).flat_map(move |contact| workspace.rows(contact)).flatten()
    }
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
            solution: Solution::default(),
            travelled: SVector::zeros(),
            newton_steps: None,
            twist: Twist::from_vector(SVector::zeros()),
        }
    }

    /// The polygonal cone that answers are for.
    #[must_use]
    pub fn cone(&self) -> PolygonCone {
        self.cone
    }

    /// An equilibrium of a grasp under a load on the object. It is found by Newton's method from 32
    /// contacts on, if that arrives, else along up to four of Lemke's paths from the elastic trial
    /// state. A step of Newton's method and a pivot cost O(n) with n contacts.
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
    /// number of contacts.
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
        let problem = Problem {
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
        let by_newton = other_paths > 0 && problem.len() >= MANY;
        self.newton_steps = by_newton.then(|| newton(&problem, &mut self.solution)).flatten();
        let balanced = self.newton_steps.is_some() || self.stick(&problem);
        let found = self.newton_steps.is_some() || (balanced && self.search(&problem, other_paths));
        (self.laws, self.drives) = (problem.laws, problem.drives);
        let pivots = self.path.pivots;
        Ok(if !balanced {
            Search::FreeMotion
        } else if found {
            self.twist = grasp.outside(&self.solution.twist);
            Search::Found(View { workspace: self })
        } else {
            Search::NotFound { pivots }
        })
    }

    /// The rows of a contact whose jumps are basic.
    fn rows(&self, contact: usize) -> [Option<Row>; 3] {
        let gap = Row::Gap { contact };
        let slip = |facet| Row::Slip { contact, facet };
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
                let free = self.factor.null_vectors();
                let free = &free[..D - self.factor.rank()];
                self.solution.twist = without(self.factor.preimage(&moved), free);
                return true;
            }
        }
        false
    }
}
