//! Beyond the end of a load path, or beyond an onset (the load factor at which the first contact ceases to stick): whether any other equilibrium
//! exists at a slightly larger load factor. Along a leg (a section of a load program) the fraction of the leg that is done takes the place of the
//! load factor. The grasp snaps over if the object moves, under nearly the same load, to another equilibrium. A fold is a maximum of the load along a
//! path. The offset of a contact's springs is the command of its finger (a displacement) minus clearance and accumulated slip.
//!
//! A proof that no equilibrium exists may be a motion: a virtual motion at the end, or another motion that separates the load from all possible
//! contact forces. In the plane, and in space with polygonal friction cones, every combination of contact states is tried. The load factor is `τ* +
//! ε`, with τ* the load factor at the end and ε infinitesimal. At `τ* + ε` a condition for a contact state (open, sticking or sliding) holds if its
//! value at τ* is positive, or zero with a rate that is not negative. On the round cone an equilibrium at a slightly larger load factor is searched
//! for without regard to the path.

use nalgebra::SVector;

use super::segment::Segment;
use super::tolerances::LITTLE_BEYOND;
use crate::contact::{MOST_SLACK, ZERO_SLACK};
use crate::equilibrium::{ContactState, NoEquilibrium, Outcome, site_states};
use crate::forms::kinematic_form;
use crate::grasp::{Engine, Motion, WholeContact};
use crate::lcp;
use crate::numerics::tolerances::NEGLIGIBLE;
use crate::numerics::{Vector, largest, summed};
use crate::object::{LinearProblem, Problem};
use crate::prelude::*;
use crate::proofs::{nothing_holds, separates_from_here_on, separating_motion};
use crate::search::{
    Doubt, FoundBy, SearchCounts, SearchOutcome, SearchSolution, Settings, combinations, dense_is_affordable,
    for_each_combination, for_each_condition, settle,
};
#[cfg(feature = "serde")]
use crate::serial::AsComputed;

/// The situation just beyond an onset or beyond the end of a path.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(tag = "what", rename_all = "snake_case")
)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub enum Beyond<const C: usize> {
    /// The equilibrium continues with the contact states and rates given here. This answer occurs only beyond an onset. A load path is followed as
    /// far as its equilibrium continues, so that no continuation exists at its end.
    Continues(Box<Continuation<C>>),
    /// No equilibrium exists just beyond: a limit load. It is proved by a virtual motion, or in the plane and on polygonal friction cones by a trial
    /// of every combination of contact states. On the round cone the proof may be for a somewhat larger load only. That load exceeds the load at the
    /// end by at most a hundredth of the whole load or of all commands. Without any load yet, it lies at most a hundredth of the leg beyond the end.
    LimitLoad,
    /// This equilibrium ends here, but others exist at slightly larger loads. After an onset, a load path under the same load shows whether the grasp
    /// snaps over to one of them ([`Jump::snaps`](super::Jump::snaps)). At the end of a load path it is known that the grasp does not snap over. In
    /// the model that load paths use, with artificial viscous dampers at the contacts, the object reaches none of these equilibria by small motions.
    Snap,
    /// This equilibrium ends here: the complementarity problem for the rates of forces and motion has no solution. Whether other equilibria exist at
    /// larger loads is not known, because there are too many contacts to try all combinations of states. The limit is 32 contacts on the round cone,
    /// and [`Settings::most_states`] combinations on other cones.
    Ends {
        /// The reason why no rates of forces and motion exist. A work stated in the reason is done by the rate of the load, J per unit of the load
        /// factor.
        reason: NoEquilibrium<C>,
    },
    /// The lips of these suction cups are open all around, and their vacuum is gone. What remains is another grasp, without their vacuum.
    WithoutVacuum {
        /// The cups whose vacuum is gone.
        cups: Vec<WholeContact>,
    },
    /// It is not known whether an equilibrium exists at slightly larger loads.
    Undecided {
        /// The reason why the search ended without an answer.
        doubt: Doubt,
    },
}

/// The continuation of an equilibrium past an event, with rates per unit of the load factor.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct Continuation<const C: usize> {
    /// The next state of every contact, in the order of the grasp. The direction of a sliding contact is the direction of its slip rate.
    pub states: Vec<ContactState<C>>,
    /// Rates of the contact forces on the object in the contact frames, N for one unit of the load factor.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<Vec<SVector<f64, C>>>"))]
    pub force_rates: Vec<SVector<f64, C>>,
    /// Rate of the object's twist, m and rad for one unit of the load factor.
    pub twist_rate: Motion<C>,
    /// The method that found the solution of the complementarity problem for the rates.
    pub rule: FoundBy,
}

/// [`Beyond::Continues`] with the contact states and rates of the solution `found`. `found` solves `rates`, the complementarity problem for the rates
/// of forces and motion after an event. [`Beyond::WithoutVacuum`] if a suction cup is open all around.
pub(super) fn continuation(
    grasp: &Engine,
    rates: &Problem,
    found: SearchSolution,
    rule: FoundBy,
) -> Beyond<3> {
    let (mut states, mut force_rates) = (site_states(rates, &found), found.forces);
    states.truncate(grasp.len());
    let cups = grasp.cups_open(|i| states[i] == ContactState::Separated);
    if !cups.is_empty() {
        return Beyond::WithoutVacuum { cups };
    }
    force_rates.truncate(grasp.len());
    Beyond::Continues(Box::new(Continuation {
        states,
        force_rates,
        twist_rate: grasp.motion_outside(&found.twist),
        rule,
    }))
}

/// The point at which a load path ends: the load factor, and the contact forces there.
pub(super) struct EquilibriumEnd<'f> {
    pub(super) factor: f64,
    pub(super) forces: &'f [SVector<f64, 3>],
    /// A virtual motion of the object, about the centroid of the contacts, along which no contact force does work in the contact states at the end.
    /// This motion may prove that no equilibrium exists beyond the end. `None` if no such motion is known.
    pub(super) motion: Option<Vector>,
}

/// The situation beyond the end of a path. `settled` is the outcome of a search for a solution of `rates`, the complementarity problem for the rates
/// of forces and motion at the end. Either the search found that no solution exists, or it was undecided.
pub(super) fn beyond_end(
    segment: &Segment<'_>,
    rates: &Problem,
    (settled, effort): (SearchOutcome, &SearchCounts),
    end: &EquilibriumEnd<'_>,
    settings: &Settings,
) -> Beyond<3> {
    let problem = segment.problem_at(end.factor);
    // The static equilibrium problem beyond the end. The load factor is larger by `part` times [`way_beyond`], the change that builds up the whole
    // load.
    let past = |part: f64| segment.problem_at(end.factor + part * way_beyond(&problem, rates));
    let separates = |v: &Vector| separates_from_here_on(&problem, v, &rates.wrench);
    if end.motion.as_ref().is_some_and(separates)
        || separating_motion(&past(LITTLE_BEYOND)).as_ref().is_some_and(separates)
    {
        return Beyond::LimitLoad;
    }
    let load = || segment.grasp.wrench_outside(&rates.wrench);
    if segment.problem.round {
        let beyond = from_scratch(past, end.forces, settings);
        let Beyond::Undecided { .. } = beyond else { return beyond };
        return match segment.grasp.outcome(rates, &load(), settled, effort, segment.answer_for) {
            Outcome::NoEquilibrium(reason) => Beyond::Ends { reason },
            _ => beyond,
        };
    }
    // With many contacts the search for rates may end undecided although no rates of forces and motion exist. Farkas' lemma may then prove that
    // none exist.
    let settled = match settled {
        SearchOutcome::Undecided(_) if effort.no_slips || no_rates(rates) => SearchOutcome::NoneOf(0),
        settled => settled,
    };
    if !matches!(settled, SearchOutcome::Undecided(_))
        && combinations(&problem) <= settings.most_states as f64
    {
        return search_beyond(&problem, rates);
    }
    match segment.grasp.outcome(rates, &load(), settled, effort, segment.answer_for) {
        // The proof covers all load factors from the end up to a hundredth of `way_beyond` (the change that builds up the whole load) beyond it. If
        // the distance were shorter, the loads would hardly differ from the load at the end, and the proof could fail because of rounding.
        Outcome::NoEquilibrium(_) if nothing_holds(&problem, &past(1e-2)) => Beyond::LimitLoad,
        Outcome::NoEquilibrium(reason) => Beyond::Ends { reason },
        Outcome::Undecided(undecided) => Beyond::Undecided { doubt: undecided.doubt },
        Outcome::Equilibrium(_) => Beyond::Undecided { doubt: Doubt::OnTheBoundary },
    }
}

/// Whether Farkas' lemma excludes every choice of slip rates and gap rates. If so, `rates`, the problem for the rates of forces and motion, has no
/// solution. The lemma is applied to the kinematic form of `rates`, an LCP in these slip rates and gap rates. This LCP is computed in floating point,
/// and the proof holds up to the rounding of its matrix. Linear programs with twice as many rows as the LCP search for the proof. Returns false if
/// their dense matrices would be too large.
pub(super) fn no_rates(rates: &Problem) -> bool {
    if !dense_is_affordable(rates, 2) {
        return false;
    }
    let trial = rates.trial();
    let Ok(state) = trial.solve(rates.sites, &rates.offsets, &rates.wrench) else { return false };
    let settings = lcp::Settings { prove_infeasible: true, ..lcp::Settings::one_path() };
    kinematic_form(rates, &trial, &state).is_some_and(|form| form.lcp.solve_with(&settings).is_infeasible())
}

/// Searches for an equilibrium slightly beyond the end of a path, where contact forces are `forces`. Contacts keep their slip so far, but their
/// states need not continue the path. `past(part)` is the static problem at a load factor that exceeds the load factor at the end by `part`
/// times [`way_beyond`].
fn from_scratch<'g>(
    past: impl Fn(f64) -> Problem<'g>,
    forces: &[SVector<f64, 3>],
    settings: &Settings,
) -> Beyond<3> {
    // Whether the search at the distance `part` beyond the end of the path finds another equilibrium, i.e. one whose forces differ from those at the
    // end by more than they could change along a continued path.
    let another = |part: &f64| match settle(&past(*part), settings).0 {
        SearchOutcome::Found(found, _) => !is_near(&found.forces, forces, *part),
        _ => false,
    };
    let mut why = Doubt::RayWithoutProof;
    // Three distances beyond the end are tried in turn, because at a short distance the search on the round cone may end undecided. Their unit
    // [`way_beyond`] is the change of the load factor that builds up the whole load.
    for part in [LITTLE_BEYOND, 1e-4, 1e-2] {
        match settle(&past(part), settings).0 {
            // The search has exceeded the allowed number of pivots of Lemke's method. It is expected to exceed this number at a larger distance, too,
            // so no further distance is tried.
            SearchOutcome::Undecided(Doubt::OutOfPivots) => {
                return Beyond::Undecided { doubt: Doubt::OutOfPivots };
            }
            SearchOutcome::Undecided(doubt) => why = doubt,
            SearchOutcome::Found(found, _) => {
                // If each force found is near the force at the end of the path, within the tolerance of [`is_near`], the search is repeated nearer to
                // the end: at 1e-8 and 1e-10. There the forces of the path itself agree with those at the end even better. The forces of another
                // equilibrium do not.
                let is_another = !is_near(&found.forces, forces, part) || [1e-8, 1e-10].iter().any(another);
                // Forces near those at the end may belong to the equilibrium of the path itself, which because of rounding seems to exist a little
                // beyond the end. The answer is then undecided. If the forces differ, another equilibrium exists to which the grasp can snap over.
                return if is_another {
                    Beyond::Snap
                } else {
                    Beyond::Undecided { doubt: Doubt::OnTheBoundary }
                };
            }
            _ => return Beyond::LimitLoad,
        }
    }
    Beyond::Undecided { doubt: why }
}

/// Whether `found` could be the contact forces of a continued path at the distance `part` beyond its end, where the forces are `forces`. This
/// requires that each contact force in `found` differs from that in `forces` by at most √ε times the largest force. ε is the smaller of `part` and
/// 1e-6 ([`LITTLE_BEYOND`]). The root is taken because forces may change with the root of the distance, as next to a fold.
fn is_near(found: &[SVector<f64, 3>], forces: &[SVector<f64, 3>], part: f64) -> bool {
    let largest = largest(forces, &nalgebra::Matrix::norm);
    let near = part.min(LITTLE_BEYOND).sqrt();
    found.iter().zip(forces).all(|(f, g)| (f - g).norm() <= near * largest)
}

/// The unit of distances beyond the end: the change of the load factor, [`whole_way`], that builds up the whole load or all commands. If this change
/// is nearly zero, because there is no load yet, the unit is 1: for a load path the whole leg.
fn way_beyond(problem: &Problem, rates: &Problem) -> f64 {
    let way = whole_way(problem, rates);
    if way > ZERO_SLACK { way } else { 1.0 }
}

/// The smaller of two changes of the load factor. The first builds up the whole present load at its present rate, the second all present offsets of
/// the contact springs at their rates. Zero if neither is finite.
fn whole_way(problem: &Problem, rates: &Problem) -> f64 {
    let total = |offsets: &[SVector<f64, 3>]| summed(offsets, &nalgebra::Matrix::norm);
    let load_way = problem.wrench.norm() / rates.wrench.norm();
    let command_way = total(&problem.offsets) / total(&rates.offsets);
    let way = load_way.min(command_way);
    if way.is_finite() { way } else { 0.0 }
}

fn search_beyond(problem: &Problem, rates: &Problem) -> Beyond<3> {
    // The problem for rates: the present rates of load and springs' offsets take the place of load and offsets. Each contact has its complete
    // law, since any contact states may occur.
    let rates = &Problem {
        offsets: rates.offsets.clone(),
        wrench: rates.wrench.clone(),
        wrench_rounding_error: rates.wrench_rounding_error.clone(),
        ..problem.clone()
    };
    let way = whole_way(problem, rates);
    let mut another = false;
    for_each_combination(problem, &mut |states| {
        let linear_problem = LinearProblem::new(problem, &states);
        let (Ok(now), Ok(next)) = (
            linear_problem.solve(problem.sites, &problem.offsets, problem.load()),
            linear_problem.solve(rates.sites, &rates.offsets, &rates.wrench),
        ) else {
            return false;
        };
        // A condition for a contact state is zero up to rounding if its value is at most this fraction of the magnitude of its terms. The fraction
        // has an upper bound: a larger violation is real, however badly conditioned the linear problem is.
        let rounding = (ZERO_SLACK * linear_problem.growth()).min(MOST_SLACK);
        let mut values = Vec::new();
        for_each_condition(problem, &states, &now.forces, &now.twist, &mut |value, size| {
            values.push((value, size));
        });
        let mut holds = true;
        let mut at = 0;
        for_each_condition(rates, &states, &next.forces, &next.twist, &mut |rate, rate_size| {
            let (value, size) = values[at];
            at += 1;
            // A condition that is positive at the end of the path also counts as zero if it becomes zero within the fraction `NEGLIGIBLE` of `way`.
            // `way` is the change of the load factor that builds up the whole load. The load factor at the end is known only to about this accuracy.
            let fleeting = rate < 0.0 && value <= NEGLIGIBLE * way * -rate;
            let zero = value.abs() <= rounding * size || (value > 0.0 && fleeting);
            holds &= if zero { rate >= -rounding * rate_size } else { value > 0.0 };
        });
        another |= holds;
        another
    });
    if another { Beyond::Snap } else { Beyond::LimitLoad }
}
