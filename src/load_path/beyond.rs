//! The first step beyond the onset: does the equilibrium go on, and if not, is there any other?
//!
//! Whether it goes on is a complementarity problem in rates among the contacts that stand on an edge. If that has no
//! solution this equilibrium ends here. Whether another exists just beyond is found by trying every combination of
//! contact states at `τ* + ε`, with ε infinitely small. A condition holds there if its value at τ* is positive, or zero with
//! a rate that is not negative.

use nalgebra::SVector;

use crate::contact::ZERO_SLACK;
use crate::equilibrium::{Cone, ContactState, NoEquilibrium, Outcome};
use crate::grasp::{Grasp, Twist};
use crate::object::{Piece, Problem};
use crate::search::{
    Doubt, Effort, Rung, Settings, Settled, combinations, for_each_combination, for_each_condition,
};

/// A state that holds for less than this part of the way that brought the load here is taken to end at the event.
const FLEETING: f64 = 1e-9;

/// What comes after the onset: whether the equilibrium goes on as the load factor grows beyond it.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub enum Beyond<const D: usize, const C: usize> {
    /// The equilibrium goes on with these contacts sliding or open.
    Continues(Box<Continuation<D, C>>),
    /// No equilibrium exists just beyond: the onset is the limit load. Every combination of contact states was tried (in the plane and on
    /// polygons).
    LimitLoad {
        /// How many.
        combinations: usize,
    },
    /// This equilibrium ends here, but others exist at slightly larger loads: the grasp snaps over to one of them or is
    /// lost. A quasi-static analysis cannot say which.
    Snap {
        /// Combinations of contact states that hold just beyond.
        others: usize,
    },
    /// This equilibrium ends here: the rates have no solution, for this reason, whose work is that of the load direction, J for one
    /// unit of the factor. Whether others exist beyond was not searched: there are more combinations of contact states than
    /// [`Settings::most_states`], or the cone is round. A load path ([`Grasp::reserve`], [`Grasp::follow`]) looks further.
    Ends(NoEquilibrium<D>),
    /// Nothing can be said, and why.
    Undecided(Doubt),
}

/// How an equilibrium goes on past an event, per unit of load factor.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct Continuation<const D: usize, const C: usize> {
    /// What every contact does next, in the order of the grasp. The direction of a sliding contact is that of its slip rate.
    pub states: Vec<ContactState<C>>,
    /// Rates of the contact forces on the object in the contact frames, N for one unit of the factor.
    pub force_rates: Vec<SVector<f64, C>>,
    /// Rate of the object's twist, m and rad for one unit of the factor.
    pub twist_rate: Twist<D>,
    /// By which rule it was found.
    pub rule: Rung,
}

/// Reads the rates that were settled, and searches for others where there are none.
pub(crate) fn just_beyond<const D: usize, const C: usize>(
    grasp: &Grasp<D, C>,
    here: &Problem<D, C>,
    rates: &Problem<D, C>,
    settled: Settled<D, C>,
    effort: &Effort,
    settings: &Settings,
    cone: Cone,
) -> Beyond<D, C> {
    if let Settled::Found(found, rule) = settled {
        let states = grasp.contact_states(rates, &found);
        let twist_rate = grasp.outside(&found.twist);
        return Beyond::Continues(Box::new(Continuation {
            states,
            force_rates: found.forces,
            twist_rate,
            rule,
        }));
    }
    let searched = cone != Cone::Round && combinations(here) <= settings.most_states as f64;
    if !matches!(settled, Settled::Undecided(_)) && searched {
        return search_beyond(here, rates);
    }
    let load = grasp.wrench_outside(&rates.wrench);
    match grasp.outcome(rates, &load, settled, effort, cone) {
        Outcome::NoEquilibrium(reason) => Beyond::Ends(reason),
        Outcome::Undecided(undecided) => Beyond::Undecided(undecided.doubt),
        Outcome::Equilibrium(_) => Beyond::Undecided(Doubt::OnTheBoundary),
    }
}

/// A step of the load factor that makes up the whole load, or all the commands; zero if there is neither.
pub(super) fn whole_way<const D: usize, const C: usize>(here: &Problem<D, C>, rates: &Problem<D, C>) -> f64 {
    let total = |drives: &[SVector<f64, C>]| drives.iter().map(nalgebra::Matrix::norm).sum::<f64>();
    let load_way = here.wrench.norm() / rates.wrench.norm();
    let command_way = total(&here.drives) / total(&rates.drives);
    let way = load_way.min(command_way);
    if way.is_finite() { way } else { 0.0 }
}

fn search_beyond<const D: usize, const C: usize>(
    here: &Problem<D, C>,
    rates: &Problem<D, C>,
) -> Beyond<D, C> {
    // The whole laws, driven at the rates.
    let rates = &Problem {
        drives: rates.drives.clone(),
        wrench: rates.wrench,
        wrench_rest: rates.wrench_rest,
        ..here.clone()
    };
    let way = whole_way(here, rates);
    let (mut others, mut tried) = (0, 0);
    for_each_combination(here, |states| {
        tried += 1;
        let piece = Piece::new(here, &states);
        let (Ok(now), Ok(next)) = (
            piece.solve(here.sites, &here.drives, here.load()),
            piece.solve(rates.sites, &rates.drives, &rates.wrench),
        ) else {
            return false;
        };
        let rounding = (ZERO_SLACK * piece.growth()).min(1e-10);
        let mut values = Vec::new();
        for_each_condition(here, &states, &now.forces, &now.twist, |value, size| {
            values.push((value, size));
        });
        let mut holds = true;
        let mut at = 0;
        for_each_condition(rates, &states, &next.forces, &next.twist, |rate, rate_size| {
            let (value, size) = values[at];
            at += 1;
            // Also what would be gone within the uncertainty of the load factor itself.
            let fleeting = rate < 0.0 && value <= FLEETING * way * -rate;
            let zero = value.abs() <= rounding * size || (value > 0.0 && fleeting);
            holds &= if zero { rate >= -rounding * rate_size } else { value > 0.0 };
        });
        others += usize::from(holds);
        false
    });
    if others > 0 { Beyond::Snap { others } } else { Beyond::LimitLoad { combinations: tried } }
}
