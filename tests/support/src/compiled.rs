//! What has parameters and takes most of the time of tests, compiled here for the plane and for space. Tests are not optimised: each of them would compile
//! it once more, and slower, and takes what stands here instead.

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

/// Problems of friction alone.
pub static SOLVE: (Solve<2>, Solve<3>) = (FrictionProblem::solve_watched, FrictionProblem::solve_watched);
/// What forces leave of friction while everything sticks.
pub static SLACK: (Slack<3, 2>, Slack<6, 3>) = (slack, slack);
/// What an answer leaves of the conditions of an equilibrium.
pub static VIOLATION: (Violation<3, 2>, Violation<6, 3>) = (Scene::violation, Scene::violation);
