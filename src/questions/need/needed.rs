//! Answers a [`Need`]: the sought amount (of squeeze, friction, load, arm or angle), the amount with which nothing slides, and a safe amount. An
//! amount is sufficient if the grasp meets the demand with it, e.g. the object is held or nothing slides. The trial of an amount computes whether the
//! amount is sufficient. The bound is the least or greatest sufficient amount. At rest means under the loads that act before the loads of the
//! question.
//!
//! Easier amounts are larger if the least amount is sought, smaller if the greatest is sought; harder amounts are smaller in the first case and
//! larger in the second. The far end is the last sufficient amount on the easier side of the bound. A scan tries further amounts on both sides of a
//! bound that is already found. A safe amount is sufficient also with less friction and squeeze, or with larger loads.

use super::answer::{Amount, Needed, Quantity};
use super::checked_need::{CheckedNeed, SafetyDeviations, Sought};
use super::found_amounts::FoundAmounts;
use super::loading::Loading;
use super::proved::{at_proved_end, by_proof};
use super::question::{Demand, Need};
use super::range::Range;
use super::search::{BoundSearch, TrialFunctions, search};
use super::tolerances::WITHIN_THE_BOUND;
use super::trial::Trial;
use super::trial_record::{SearchExtent, TrialRecord};
use crate::ask::Grasp;
use crate::error::Error;
use crate::grasp::{Wrench, inside};
use crate::numerics::{Space, chosen, largest, least};
use crate::prelude::*;
use crate::squeeze::Loads;

impl<const C: usize> Grasp<C> {
    /// The amount that a grasp needs: the least squeeze, friction or force, the greatest load, arm or angle; see [`Need`].
    ///
    /// ```
    /// use grasp_lcp::need::Need;
    /// use grasp_lcp::planar::{Contact, Grasp, Wrench};
    ///
    /// // Two jaws that press with 10 N each, μ = 0.5: how much do they have to press to carry 12 N?
    /// let jaw = |x: f64, name| Contact::new([x, 0.0], [-x, 0.0]).name(name).series_stiffness(1e4, 8e3).friction(0.5).pressed_with(10.0);
    /// let gripper = Grasp::new([jaw(-0.03, "left"), jaw(0.03, "right")])?;
    /// let needed = gripper.need(&Need::squeeze(Wrench::force([0.0, -12.0])).if_lower_by(0.1, 0.0))?;
    /// assert!((needed.amount.bound().expect("1.2 times as much") - 1.2).abs() < 1e-12);
    /// assert!(needed.to_string().starts_with("NEEDS 12 N at left and right so that it holds and nothing slides\n  if friction is 10 % less: 13.3334 N"), "{needed}");
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Wrench`] if a load is not finite or beyond 1e50. [`Error::Argument`] for reductions of friction or squeeze outside `0 <= part < 1`,
    /// and for a factor of safety outside `0 < factor <= 1e50`; also for a contact that does not exist. [`Error::Question`] for repeated loads with a
    /// force of any direction, and if the load at rest is sought but not given. [`Error::Part`] if no part with the given name presses.
    #[doc(alias = "grip force")]
    #[doc(alias = "required")]
    pub fn need(&self, need: &Need<C>) -> Result<Needed, Error> {
        inside(need).answered_by(&inside(self))
    }
}

impl Need<3> {
    /// Answers this need for a grasp in the form of the engine, whose vectors have three components in the plane, too.
    fn answered_by(&self, grasp: &Grasp<3>) -> Result<Needed, Error> {
        let grasp = &self.growing(grasp)?;
        let posed = self.posed(grasp.space())?;
        self.check_acts(grasp.is_loaded_at_rest())?;
        let quantity = posed.quantity();
        let contacts = match &posed.sought {
            Sought::Friction { contacts: Some(those) } => {
                let points = grasp.points_of(those)?;
                grasp.engine.wholes().with(&|i| points.contains(&i))
            }
            _ => Vec::new(),
        };
        let asked = posed.on(grasp)?;
        let is_squeezed = grasp.is_squeezed() || asked.sought == Sought::Overlaps;
        let mut safety = asked.safety;
        if !is_squeezed {
            safety.lower[1] = 0.0;
        }
        let mut trials = TrialRecord::new(grasp, &asked, SafetyDeviations::NONE, start(grasp, &asked));
        let amount = amount(&trials, asked.demand, SearchExtent::Around)?;
        // The first amount of the search may be too large, so that the object is not held. The search for the amount with which nothing slides then
        // begins at the largest amount that holds the object.
        if let Amount::Bound { until: Some(end), .. } | Amount::Any { until: Some(end), .. } = &amount
            && asked.quantity().is_least()
        {
            trials.start = trials.start.min(end.sufficient);
        }
        let sticks = match asked.demand {
            Demand::Held => Some(self::amount(&trials, Demand::Sticks, SearchExtent::Towards)?),
            _ => None,
        };
        let worse = (1.0 - safety.lower[0]) * (1.0 - safety.lower[1]) / safety.load;
        let begin = amount.bound().map_or(trials.start, |sufficient| match asked.sought {
            Sought::Angle { .. } => trials.start,
            _ if asked.quantity().is_least() => sufficient / worse,
            _ => sufficient * worse,
        });
        let far = match &amount {
            Amount::Bound { until: Some(end), .. } => Some([end.sufficient, end.insufficient]),
            _ => None,
        };
        let (look, of) = (SearchExtent::Everywhere(far), asked.pressed_by(grasp)?);
        let safe = (safety != SafetyDeviations::NONE).then(|| {
            let record = TrialRecord::new(grasp, &asked, safety, begin).with_directions_of(&trials);
            let mut safe = self::amount(&record, asked.demand, look)?;
            let reduction = match (&asked.sought, of.as_ref()) {
                (Sought::Friction { .. }, _) => safety.lower[0],
                (Sought::Squeeze | Sought::Overlaps, _) => safety.lower[1],
                (_, Some(of)) if of.is_command => safety.lower[1],
                _ => 0.0,
            };
            safe.end_before(&amount, asked.quantity().is_least(), reduction);
            Ok(safe)
        });
        let jumps = amount.bound().is_some_and(|at| trials.jumps_with(at));
        let left_out = match amount.bound().filter(|_| !asked.demand.repeats()) {
            // At the bound itself rounding decides whether a contact that is about to open resists. Therefore the fraction `left_out` is computed for
            // a sufficient amount beside the bound.
            Some(at) => {
                let beside =
                    if asked.quantity().is_least() { at / WITHIN_THE_BOUND } else { at * WITHIN_THE_BOUND };
                Loading::of(grasp, &asked, beside, SafetyDeviations::NONE)?.left_out()?
            }
            None => None,
        };
        Ok(Needed {
            quantity: asked.quantity(),
            demand: asked.demand,
            amount,
            sticks,
            safe: safe.transpose()?,
            lower: safety.lower,
            safety: safety.load,
            is_loaded_at_rest: asked.base != Wrench::ZERO || grasp.is_loaded_at_rest(),
            force: asked.force_of_load(),
            of,
            anticlockwise: asked.tilts_anticlockwise(grasp.space()),
            by_overlaps: asked.sought == Sought::Overlaps,
            in_place_of_squeeze: quantity == Quantity::Squeeze && !is_squeezed,
            jumps,
            left_out,
            scales_kinetic: asked.scales_kinetic(grasp.contacts()),
            scales_any_force: asked.scales_any_force(),
            contacts,
            without_friction: match asked.sought {
                Sought::Friction { contacts: None } => {
                    let wholes = grasp.engine.wholes();
                    wholes.with(&|i| grasp.contacts()[i].friction_coefficient() == 0.0)
                }
                _ => Vec::new(),
            },
        })
    }
}

/// The first amount that a search tries. Multiples of a squeeze, load or force begin at 1, friction at the largest given coefficient (0.5 if all are
/// 0 or one is infinite). An arm begins at the largest distance of a contact from the first contact (1 m if this is 0), an angle at the whole turn.
fn start(grasp: &Grasp<3>, need: &CheckedNeed) -> f64 {
    let contacts = grasp.contacts();
    match &need.sought {
        Sought::Squeeze | Sought::Overlaps | Sought::Load | Sought::Force { .. } => 1.0,
        Sought::Friction { contacts: those, .. } => {
            let is_meant = |i: &usize| those.as_ref().is_none_or(|those| those.contains(i));
            let all = chosen(contacts.len(), &is_meant);
            let given = largest(&all, &|i| contacts[*i].friction_coefficient());
            if given > 0.0 && given.is_finite() { given } else { 0.5 }
        }
        Sought::Arm { .. } => {
            let first = contacts.first().map(crate::grasp::Contact::point);
            let away = |contact: &crate::grasp::Contact<3>| {
                (contact.point() - first.unwrap_or(contact.point())).norm()
            };
            let width = largest(contacts, &away);
            if width > 0.0 { width } else { 1.0 }
        }
        Sought::Angle { turn } => turn.angle(),
    }
}

fn amount(tried: &TrialRecord<'_>, demand: Demand, look: SearchExtent) -> Result<Amount, Error> {
    let (grasp, need) = (tried.grasp, tried.need);
    let whole = |amount: f64| tried.at(amount, demand, false);
    let quick = |amount: f64, short: bool| tried.quick(amount, demand, short);
    let learns = matches!(need.loads, Loads::AnyForce { .. });
    // A short trial follows load paths only up to the loads of the question. For a force of any direction, even a full trial of one amount computes
    // fifty to some hundreds of verdicts, one for each direction tried. The short trial is then a quick trial, and only in directions that are known
    // to be weak.
    let short = |amount: f64| if learns { quick(amount, true) } else { tried.at(amount, demand, true) };
    let differ = |one: f64, other: f64| tried.differ(one, other);
    let rest_ends = |sufficient: f64, insufficient: f64| tried.rest_ends(sufficient, insufficient);
    let tries = TrialFunctions {
        whole: &whole,
        short: &short,
        quick: &quick,
        differ: &differ,
        rest_ends: &rest_ends,
        learns,
        is_planar: grasp.space() == Space::Planar,
    };
    let plan = tried.plan(look)?;
    if let Some(proved) = by_proof(&plan, tries)? {
        return Ok(proved);
    }
    // If the whole turn is sufficient, the search ends: angles beyond the given turn are not tried.
    if matches!(need.sought, Sought::Angle { .. }) && tries.at(plan.start)?.is_sufficient() {
        return Ok(Amount::Any { to: plan.start, until: None, tried: None });
    }
    let scan = if look == SearchExtent::Around { need.scan } else { 0 };
    let found = FoundAmounts { tried, demand, tries, scan };
    match search(tries, &plan, &found.known())? {
        BoundSearch::Threshold(edge) => found.bound(plan, edge, look),
        BoundSearch::All(to) => match at_proved_end(to, &plan, tries)? {
            Some(edge) => found.bound(plan, edge, look),
            None => found.any(&plan, to),
        },
        BoundSearch::Nothing(mut vain) => {
            // `vain` are the amounts tried, none of which is sufficient. `SearchExtent::Towards` means that the amount with which nothing slides is
            // sought. If it is decided for some amounts whether something slides, the undecided amounts are dropped, so that the answer is decided.
            if look == SearchExtent::Towards && vain.iter().any(|(_, trial)| trial.carried().is_some()) {
                vain.retain(|(_, trial)| trial.carried().is_some());
            }
            Ok(nothing_suffices(vain, plan.limits, None))
        }
    }
}

/// The answer if no amount of `vain`, the amounts tried with their results, is sufficient. The argument `proof` is given if it is proved, for every
/// amount, that contact forces cannot balance the loads. It is then the empty range of amounts. Without such a proof one undecided trial makes the
/// answer undecided. Otherwise the amount `best` of the answer is the amount with which the largest part of the load is carried, the first of several
/// such amounts. If the object moves too far already at rest, it is the amount with the smallest motions. With a proof the answer states that all
/// amounts within `limits` are excluded.
pub(super) fn nothing_suffices(vain: Vec<(f64, Trial)>, limits: [f64; 2], proof: Option<&Range>) -> Amount {
    let (is_proved, at_rest) = (proof.is_some(), proof.is_some_and(|range| range.is_empty_at_rest));
    let [from, to] = if is_proved {
        limits
    } else {
        [least(&vain, &|(amount, _)| *amount), largest(&vain, &|(amount, _)| *amount)]
    };
    let tried = vain.len();
    let mut none = Amount::None { from, to, best: to, tried, is_proved, at_rest, otherwise: String::new() };
    let mut most = f64::NEG_INFINITY;
    for (amount, trial) in vain {
        let carried = trial.nearness().unwrap_or(f64::NEG_INFINITY);
        match trial {
            Trial::Unknown(doubt) if !is_proved => return Amount::Undecided { at: amount, doubt },
            Trial::Insufficient { says: otherwise, .. } if carried > most => {
                most = carried;
                none = Amount::None { from, to, best: amount, tried, is_proved, at_rest, otherwise };
            }
            _ => {}
        }
    }
    none
}
