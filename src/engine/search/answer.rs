//! The result of a search for an equilibrium under a load, and the work that it took. The search starts from the elastic trial, the solution in which
//! every contact sticks. It tries contact states (open, sticking, sliding), or cases: a case restricts the contact states and perhaps the directions
//! of friction. A drive, the spring of a joint or tendon of a hand, is treated like a contact. A solution has a twist (motion of the object, of
//! joints and of further bodies). It may also have free motions, which stretch no spring, and neutral motions, along which forces change but stay in
//! balance.

use nalgebra::SVector;

use crate::contact::State;
use crate::grasp::Coordinates;
use crate::numerics::{Vector, mapped};
use crate::prelude::*;

/// The method that found a solution. If several equilibria exist, the method determines which of them is returned.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "snake_case"))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub enum FoundBy {
    /// Everything sticks: the elastic trial, in which all contacts stick, satisfies every condition. No complementarity problem was solved.
    EverythingSticks,
    /// Everything that touches sticks: contacts that pull if they stick are open, and all others satisfy every condition while they stick. No
    /// complementarity problem was solved.
    EverythingTouchingSticks,
    /// Lemke's method on the kinematic form, whose unknowns are gaps and slips. Its pivots start at the elastic trial, in which all contacts stick.
    KinematicForm,
    /// Newton's method for the motion of the object, of which each contact force is a function. It starts at the elastic trial (all contacts stick)
    /// or, with round cones, at one of three starts. With fewer than 32 contacts the first start is a point of an artificial viscous motion, which
    /// leads from the elastic trial towards a nearby equilibrium. If several equilibria exist, Newton's method then finds this equilibrium. The next
    /// starts are the elastic trial, and the twist for friction limits that do not depend on normal forces.
    Newton,
    /// Lemke's method on the force form, whose unknowns are contact forces. Its pivots start from zero forces.
    ForceForm,
    /// Trial of all combinations of contact states: the first that satisfies every condition. On the round cone the first case of contact states and
    /// directions of friction from which Newton's method converges. Equilibria listed by [`Grasp::equilibria`](crate::ask::Grasp::equilibria) are
    /// found in this way, too.
    Enumeration,
    /// A load path was followed: the contact states come from its history.
    LoadPath,
}

/// The reason why it stays undecided whether an equilibrium exists.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "snake_case"))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub enum Doubt {
    /// Lemke's method ended on rays, which prove nothing, and not every combination of contact states could be tried. Either there are too many
    /// contacts for [`Settings::most_states`](crate::Settings::most_states), or on the round cone the cases that were tried gave neither an
    /// equilibrium nor a proof.
    RayWithoutProof,
    /// Some combination of contact states violates a condition so little that rounding may be the cause. The load is then on the
    /// boundary of the loads that the grasp can hold, up to the working precision.
    OnTheBoundary,
    /// Contact states were found, but moment arms or stiffnesses of the grasp differ by more than the working precision resolves. Forces and twist
    /// cannot be computed accurately: residuals exceed 1e-10 (1e-12 on the round cone).
    Inaccurate,
    /// Lemke's method reached its limit of pivots, failed numerically or needs too large a matrix. There are also too many contacts to try every
    /// combination of contact states.
    OutOfPivots,
    /// On a load path: one leg (a section of the load program) needs more than [`Settings::most_steps`](crate::Settings::most_steps) steps or jumps.
    /// Steps are made along arcs, on which contacts slide in turning directions on the round cone; jumps lead from static to kinetic friction.
    OutOfSteps,
}

/// A solution of an equilibrium problem, in the engine's units: states and forces of contacts and drives, twist of the object.
#[derive(Debug, Clone)]
pub(crate) struct SearchSolution {
    pub(crate) states: Vec<State>,
    pub(crate) forces: Vec<SVector<f64, 3>>,
    pub(crate) twist: Vector,
    pub(crate) free_motions: Vec<Vector>,
    pub(crate) neutral_motions: Vec<Vector>,
    /// Rounding scales: a force, N, and a displacement, m, to which the rounding errors of the solution are proportional. On a load path the solution
    /// is a sum of changes along the path, and the scales are the magnitudes of the terms of this sum. Both are zero for a solution that was not
    /// reached along a path.
    pub(crate) sizes: [f64; 2],
    /// On the round cone, the largest difference, N, between a contact force and its value in the solution on polygonal cones from which Newton's
    /// method started. `None` if Newton's method did not start from such a solution.
    pub(crate) from_polygon: Option<f64>,
}

impl SearchSolution {
    /// A solution of a single search: it was not reached along a load path or from polygonal cones, and it has no free or neutral motions.
    pub(crate) fn new(states: Vec<State>, forces: Vec<SVector<f64, 3>>, twist: Vector) -> Self {
        Self {
            states,
            forces,
            twist,
            free_motions: Vec::new(),
            neutral_motions: Vec::new(),
            sizes: [0.0; 2],
            from_polygon: None,
        }
    }
}

/// A [`SearchSolution`] in the form in which answers store it: its motions (twist, free and neutral motions) are lists of numbers.
#[derive(Debug, Clone)]
pub(crate) struct StoredSolution {
    pub(crate) states: Vec<State>,
    pub(crate) forces: Vec<SVector<f64, 3>>,
    pub(crate) twist: Coordinates,
    free_motions: Vec<Coordinates>,
    neutral_motions: Vec<Coordinates>,
    sizes: [f64; 2],
    from_polygon: Option<f64>,
}

impl StoredSolution {
    /// Converts a solution to lists of numbers; the twist is written into `list`, whose allocation is reused.
    pub(crate) fn of(found: SearchSolution, list: Vec<f64>) -> Self {
        Self {
            states: found.states,
            forces: found.forces,
            twist: Coordinates::of_in(&found.twist, list),
            free_motions: mapped(&found.free_motions, &Coordinates::of),
            neutral_motions: mapped(&found.neutral_motions, &Coordinates::of),
            sizes: found.sizes,
            from_polygon: found.from_polygon,
        }
    }

    pub(crate) fn found(&self) -> SearchSolution {
        SearchSolution {
            states: self.states.clone(),
            forces: self.forces.clone(),
            twist: self.twist.to(),
            free_motions: mapped(&self.free_motions, &Coordinates::to),
            neutral_motions: mapped(&self.neutral_motions, &Coordinates::to),
            sizes: self.sizes,
            from_polygon: self.from_polygon,
        }
    }
}

/// The result of a search for an equilibrium under a load.
#[derive(Debug, Clone)]
pub(crate) enum SearchOutcome {
    Found(SearchSolution, FoundBy),
    /// No equilibrium exists: the load does work along this motion, which no spring resists if every contact sticks.
    FreeMotion(Vector),
    /// No equilibrium exists, since no admissible forces balance the load: this motion separates the load from the friction wrench cone.
    Separating(Vector),
    /// No equilibrium exists: every combination of contact states violates a condition by more than rounding. The field is the number of combinations
    /// tried.
    NoneOf(usize),
    /// No equilibrium exists on the round cone. Contact states were divided into `cases` cases, and each case was proved to have no equilibrium.
    /// Because of rounding the proof does not exclude equilibria whose stretches and forces exceed those of the elastic trial (everything sticks) by
    /// at least the factor `escape`.
    Contradicted {
        cases: usize,
        escape: f64,
    },
    /// No equilibrium was found, and no proof that none exists. The field is the reason.
    Undecided(Doubt),
}

/// The effort of one search for an equilibrium: numbers of pivots of Lemke's method, of rows of its largest problem, and of combinations of contact
/// states.
#[derive(Debug, Clone, Default)]
pub(crate) struct SearchCounts {
    pub(crate) pivots: usize,
    /// Number of rows of the largest complementarity problem solved.
    pub(crate) rows: usize,
    pub(crate) combinations: usize,
    /// Number of facets of a contact's polygonal cone.
    pub(crate) facets: usize,
    /// True if the complementarity problem for gaps and slips (kinematic form), with a dense matrix, was proved to have no solution, up to rounding.
    /// Always false with round cones.
    pub(crate) no_slips: bool,
}
