//! The end of a search for an equilibrium, and its effort.

use nalgebra::SVector;

use crate::contact::State;
use crate::grasp::Coordinates;
use crate::numerics::{Vector, mapped};
use crate::prelude::*;

/// The method that found a solution. If several equilibria exist, it tells which of them this is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "snake_case"))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub enum FoundBy {
    /// Everything sticks: the elastic trial state satisfies every condition. No complementarity problem was made.
    EverythingSticks,
    /// Everything that touches sticks: contacts that would pull are open, and all others satisfy every condition while they stick. No complementarity
    /// problem was made.
    EverythingTouchingSticks,
    /// Lemke's method on the kinematic form, whose path of jumps starts at the elastic trial state.
    KinematicForm,
    /// Newton's method for the motion of the object, of which each contact force is a function. On the round cone with few contacts it starts near
    /// the equilibrium to which the stuck grasp relaxes, and so finds that one of several; otherwise it starts at the elastic trial state.
    Newton,
    /// Lemke's method on the force form, whose path of forces starts from zero.
    ForceForm,
    /// The first combination of contact states that satisfies every condition; on the round cone, the first case of contact states and directions of
    /// friction from which Newton's method converges. [`Grasp::equilibria`](crate::ask::Grasp::equilibria) finds some of its equilibria in this way.
    Enumeration,
    /// A load path was followed: the states come from its history.
    LoadPath,
}

/// The reason why a question stays undecided.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "snake_case"))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub enum Doubt {
    /// Lemke's method ended on rays, which prove nothing, and not every combination of states could be tried. Either there are too many contacts for
    /// [`Settings::most_states`](crate::Settings::most_states), or on the round cone the cases that were tried did not decide.
    RayWithoutProof,
    /// Some combination of contact states violates a condition so little that rounding may be the cause. The load is then on the
    /// boundary of the loads that the grasp can hold, up to the working precision.
    OnTheBoundary,
    /// Contact states were found, but arms or stiffnesses of the grasp differ by more than the working precision resolves. Forces and twist cannot be
    /// computed accurately: residuals exceed 1e-10 (1e-12 on the round cone).
    Inaccurate,
    /// Lemke's method reached its limit of pivots, broke down or would need too large a matrix, with too many contacts to try every combination.
    OutOfPivots,
    /// On a load path: a leg needs more than [`Settings::most_steps`](crate::Settings::most_steps) steps along sliding arcs of the round cone, or
    /// more jumps from static to kinetic friction.
    OutOfSteps,
}

/// A solution of a problem: states, forces and motion.
#[derive(Debug, Clone)]
pub(crate) struct Found {
    pub(crate) states: Vec<State>,
    pub(crate) forces: Vec<SVector<f64, 3>>,
    pub(crate) twist: Vector,
    pub(crate) free_motions: Vec<Vector>,
    pub(crate) neutral_motions: Vec<Vector>,
    /// On a load path, the sizes of the forces, N, and displacements, m, whose sums are this solution. They scale its rounding where terms cancel.
    /// Zero for a solution that was not reached along a path.
    pub(crate) sizes: [f64; 2],
    /// On the round cone, the largest change of a contact force from the answer on polygons, N.
    pub(crate) from_polygon: Option<f64>,
}

impl Found {
    /// A solution of a single search: no load path led to it, and every motion is resisted.
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

/// A [`Found`] whose twist is a list of numbers, as answers store it.
#[derive(Debug, Clone)]
pub(crate) struct Kept {
    pub(crate) states: Vec<State>,
    pub(crate) forces: Vec<SVector<f64, 3>>,
    pub(crate) twist: Coordinates,
    free_motions: Vec<Coordinates>,
    neutral_motions: Vec<Coordinates>,
    sizes: [f64; 2],
    from_polygon: Option<f64>,
}

impl Kept {
    /// Converts a solution; `list` is the memory for its twist.
    pub(crate) fn of(found: Found, list: Vec<f64>) -> Self {
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

    pub(crate) fn found(&self) -> Found {
        Found {
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

/// The result of a search.
#[derive(Debug, Clone)]
pub(crate) enum Settled {
    Found(Found, FoundBy),
    /// The load works on a motion that no spring resists.
    FreeMotion(Vector),
    /// No admissible forces balance the load: this motion separates it from the friction wrench cone.
    Separating(Vector),
    /// Every combination of contact states violates a condition clearly; this is the number of combinations.
    NoneOf(usize),
    /// On the round cone, each case was proved to have no equilibrium. An equilibrium that rounding hides from this proof would be larger than the
    /// data by the factor `escape`.
    Contradicted {
        cases: usize,
        escape: f64,
    },
    /// No equilibrium was found, and no proof that there is none.
    Undecided(Doubt),
}

/// Effort of a search.
#[derive(Debug, Clone, Default)]
pub(crate) struct Effort {
    pub(crate) pivots: usize,
    /// Number of rows of the largest complementarity problem.
    pub(crate) rows: usize,
    pub(crate) combinations: usize,
    /// Number of facets of a contact's polygonal cone.
    pub(crate) facets: usize,
    /// Whether Farkas' lemma excludes every choice of slips and gaps of the kinematic form, up to its rounding. Never on the round cone.
    pub(crate) no_slips: bool,
}
