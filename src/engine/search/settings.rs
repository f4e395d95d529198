//! Settings of searches for the equilibrium of a grasp under a load, and of load paths (equilibria while loads and finger commands change). Searches
//! start from the elastic trial, the solution in which every contact sticks. They may try cases: a case restricts the contact states (open, sticking,
//! sliding), and perhaps the directions of friction.

use super::small_motions::SmallMotions;
use crate::contact::PolygonCone;
use crate::numerics::Space;

/// Limits and tolerances of searches for an equilibrium and of load paths, with sound defaults.
///
/// ```
/// use grasp_lcp::{PolygonFit, PolygonCone, Settings};
///
/// // A polygon of 16 facets around the round cone, as in programs without a round cone, and only short searches.
/// let polygon = Settings::default().on_the_polygon().with_cone(PolygonCone::new(16, PolygonFit::Circumscribed)?).with_most_states(100);
/// assert!(!polygon.round && polygon.cone.facets() == 16);
/// # Ok::<(), grasp_lcp::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
#[must_use]
pub struct Settings {
    /// The polygonal friction cone in space, on which Lemke's method pivots; by default 8 facets, inscribed in the round cone. Ignored in the plane.
    /// For equilibria on the round cone each contact's polygon is rotated: a corner then lies along the friction force of the elastic trial, and more
    /// facets only cost time. For equilibria on the polygon itself more facets come closer to the round cone, at the cost of more pivots. With m
    /// facets, the error of the load at which the first contact ceases to stick falls like 1/m². The error of an equilibrium with sliding contacts
    /// falls like 1/m.
    pub cone: PolygonCone,
    /// In space, whether equilibria and load paths are computed with the round cone (the default) or with the polygon itself. Ignored in the plane.
    pub round: bool,
    /// Upper limit of the number of pivots of Lemke's method on one complementarity problem of a grasp, all its runs together. `None` (the default)
    /// allows about a second of computing time. A search over thousands of contacts on which Newton's method has failed then gives up with
    /// [`Doubt::OutOfPivots`](super::Doubt::OutOfPivots). The quadratic programs of [`energy`](crate::energy), whose matrices are dense, may take
    /// some ten seconds.
    pub max_pivots: Option<usize>,
    /// If Lemke's method finds no equilibrium, all combinations of contact states are tried, provided that their number is at most this limit. The
    /// default is 20 000, which takes a few hundredths of a second: enough for 7 contacts in the plane, or 3 contacts with 8 facets in space. On the
    /// round cone branch and bound divides the contact states and friction directions of up to 32 contacts into cases. A case of n contacts is
    /// counted as n³/400 combinations, but at least as five: the default allows 4 000 cases for up to 12 contacts. A smaller limit is faster if no
    /// equilibrium exists. With 0 neither combinations nor cases are tried, and there are no proofs by trying all of them. A larger limit gives
    /// proofs for more contacts.
    pub most_states: usize,
    /// On a load path on the round cone, the upper limit of the estimated error of one step along an arc. An arc is a part of the path on which
    /// contacts slide in turning directions. Errors of forces are relative to the largest force, errors of slips to the largest displacement. The
    /// default is 1e-9. Step lengths scale with the eighth root of this limit: 1e-13 takes about three times as many steps. If rounding allows only a
    /// larger error, [`LoadPath::step_error`](crate::load_path::LoadPath::step_error) returns that error. Straight parts of a path need no steps.
    pub step_error: f64,
    /// On a load path, the upper limit of the number of steps within one leg, a section of the load program. Steps are made along arcs, on which
    /// contacts slide on the round cone; refused steps are included. The same number (default 20 000) limits the jumps from static to kinetic
    /// friction. A path that needs more ends [undecided](crate::load_path::PathEnd::Undecided) at the point reached.
    pub most_steps: usize,
    /// [`hold`](crate::ask::Grasp::hold) searches for the loss of the grasp up to this multiple of the load in the question (default 100). With a
    /// value of at most 1 the search stops at this load itself.
    pub most_load: f64,
    /// Upper limit of the number of cycles of a repeated load that [`shake`](crate::ask::Grasp::shake) follows (default 1 000).
    pub most_cycles: usize,
    /// Limits of small motions: by default a tenth of a radian, and slips of a tenth of the grasp's size.
    pub small_motions: SmallMotions,
    /// True if searches for a static equilibrium omit the last method, which tries every case and takes longest if no equilibrium exists.
    pub(crate) is_quick: bool,
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            cone: PolygonCone::default(),
            round: true,
            max_pivots: None,
            most_states: 20_000,
            step_error: 1e-9,
            most_steps: 20_000,
            most_load: 100.0,
            most_cycles: 1_000,
            small_motions: SmallMotions::default(),
            is_quick: false,
        }
    }
}

impl Settings {
    setters! {
        /// These settings with another polygonal friction cone ([`Settings::cone`]).
        pub fn with_cone(mut self, cone: PolygonCone) { self.cone = cone; }

        /// These settings, with equilibria and load paths on the polygonal cone instead of the round cone.
        pub fn on_the_polygon(mut self) { self.round = false; }
    }

    /// Whether equilibria in this space are computed with the round cone; never in the plane.
    pub(crate) fn is_round(&self, space: Space) -> bool {
        space == Space::Spatial && self.round
    }

    setters! {
        /// These settings with another [`Settings::most_states`], the largest number of combinations of contact states that are all tried.
        pub fn with_most_states(mut self, most_states: usize) { self.most_states = most_states; }

        /// These settings with another allowed error of a step along an arc (a part of a load path on which contacts slide in turning directions).
        /// With 1e-13 nearly all digits are correct; below 1e-14 no step is accurate enough because of rounding.
        pub fn with_step_error(mut self, step_error: f64) { self.step_error = step_error; }

        /// These settings with another upper limit of the number of steps along arcs within one leg (section) of a load path. The same number limits
        /// the jumps from static to kinetic friction.
        pub fn with_most_steps(mut self, most_steps: usize) { self.most_steps = most_steps; }

        /// These settings with another [`Settings::most_load`]: [`hold`](crate::ask::Grasp::hold) searches for the loss of the grasp up to this
        /// multiple of the load in the question.
        pub fn with_most_load(mut self, most_load: f64) { self.most_load = most_load; }

        /// These settings with another upper limit of the number of cycles of a repeated load that are followed.
        pub fn with_most_cycles(mut self, most_cycles: usize) { self.most_cycles = most_cycles; }

        /// These settings with other limits of small motions: a rotation, rad, and a slip as a fraction of the grasp's size.
        pub fn with_small_motions(mut self, rotation: f64, slip: f64) {
            self.small_motions = SmallMotions { rotation, slip };
        }

        /// These settings with an upper limit of the number of pivots of Lemke's method on one complementarity problem.
        pub fn with_max_pivots(mut self, max_pivots: usize) { self.max_pivots = Some(max_pivots); }
    }
}
