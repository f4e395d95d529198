//! Generic functions that dominate the run time of tests, compiled here for the plane and for space.
//!
//! This crate is optimised, the tests are not. A test that called the generic function would compile its own copy without optimisation.

use std::ops::ControlFlow;

use grasp_lcp::equilibrium::Equilibrium;
use grasp_lcp::friction::{FrictionProblem, Settings, Solution, SolveProgress};
use grasp_lcp::lcp::Outcome;

use super::ramps::{Friction, slack};
use super::scene::Scene;

type Watch<'w> = &'w mut dyn FnMut(&SolveProgress<'_>) -> ControlFlow<()>;
type Solve<const C: usize> = fn(&FrictionProblem<C>, &Settings, Watch<'_>) -> Outcome<Solution>;
type Slack<const D: usize, const C: usize> = fn(&Scene<D, C>, Friction) -> Option<f64>;
type Violation<const D: usize, const C: usize> = fn(&Scene<D, C>, &Equilibrium<C>, usize) -> f64;

/// Solvers of frictional contact problems, in the plane and in space.
pub static SOLVE: (Solve<2>, Solve<3>) = (FrictionProblem::solve_watched, FrictionProblem::solve_watched);
/// [`slack`] in the plane and in space.
pub static SLACK: (Slack<3, 2>, Slack<6, 3>) = (slack, slack);
/// [`Scene::violation`] in the plane and in space.
pub static VIOLATION: (Violation<3, 2>, Violation<6, 3>) = (Scene::violation, Scene::violation);
