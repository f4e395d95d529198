//! Answers a [`Need`]: the sought amount (of squeeze, friction, load, arm or angle), the amount with which nothing slides, and a safe amount. An
//! amount is sufficient if the grasp meets the demand with it; the bound is the least or greatest sufficient amount. At rest means under the loads
//! that act before the loads of the question.
//!
//! Easier amounts are larger if the least amount is sought, smaller if the greatest is sought; harder amounts are the opposite. The far end is the
//! last sufficient amount on the easier side of the bound. A scan tries further amounts on both sides of a bound that is already found.

use super::answer::{Amount, FarEnd, Needed, Quantity};
use super::bound_scan::{BoundScan, between_known};
use super::checked_need::{CheckedNeed, SafetyDeviations, Sought};
use super::press::ContactPress;
use super::pressed_at_rest::presses;
use super::proved::{at_proved_end, by_proof};
use super::question::{Demand, Need};
use super::range::Range;
use super::search::{BoundSearch, SearchPlan, TrialFunctions, search};
use super::threshold::Threshold;
use super::tolerances::{FAR_FROM_START, NARROW, STEPPED_OVER, USUAL_FRICTION};
use super::trial::Trial;
use super::trial_record::{SearchExtent, TrialRecord};
use crate::ask::Grasp;
use crate::error::Error;
use crate::grasp::{Wrench, inside};
use crate::numerics::{IntoList, Space, chosen, largest, mapped, picked, sort_by_number};
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
    /// assert!(needed.to_string().starts_with("NEEDS 12 N at left and right so that it holds and nothing slides\n  if friction is 10 % less: 13.3333 N"), "{needed}");
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    ///
    /// # Errors
    /// As for [`Self::hold`] of its loads. [`Error::Argument`] for reductions of friction or squeeze outside `0 <= part < 1`, and for a factor of
    /// safety outside `0 < factor <= 1e50`; also for a contact that does not exist. [`Error::Question`] for repeated loads with a force of any
    /// direction, and if the load at rest is sought but not given. [`Error::Part`] if no part with the given name presses.
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
        let asked = posed.on(grasp)?;
        let is_squeezed = grasp.is_squeezed() || asked.sought == Sought::Overlaps;
        let mut safety = asked.safety;
        if !is_squeezed {
            safety.lower[1] = 0.0;
        }
        let trials = TrialRecord::new(grasp, &asked, SafetyDeviations::NONE, start(grasp, &asked));
        let amount = amount(&trials, asked.demand, SearchExtent::Around)?;
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
        let look = SearchExtent::Everywhere(far);
        let safe = (safety != SafetyDeviations::NONE).then(|| {
            let record = TrialRecord::new(grasp, &asked, safety, begin).with_directions_of(&trials);
            self::amount(&record, asked.demand, look)
        });
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
            of: asked.pressed_by(grasp)?,
            anticlockwise: asked.tilts_anticlockwise(grasp.space()),
            by_overlaps: asked.sought == Sought::Overlaps,
            in_place_of_squeeze: quantity == Quantity::Squeeze && !is_squeezed,
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
    // A full trial of a force of any direction takes fifty to some hundreds of verdicts, so a quick trial replaces it.
    let short = |amount: f64| if learns { quick(amount, true) } else { tried.at(amount, demand, true) };
    let rests_otherwise = |one: f64, other: f64| tried.rests_otherwise(one, other);
    let rest_ends = |sufficient: f64, insufficient: f64| tried.rest_ends(sufficient, insufficient);
    let tries = TrialFunctions {
        whole: &whole,
        short: &short,
        quick: &quick,
        rests_otherwise: &rests_otherwise,
        rest_ends: &rest_ends,
        learns,
        is_planar: grasp.space() == Space::Planar,
    };
    let plan = tried.plan(look)?;
    if let Some(proved) = by_proof(&plan, tries)? {
        return Ok(proved);
    }
    // Angles beyond the given turn are not tried.
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
            // `vain` are the amounts tried, none of which is sufficient. With `SearchExtent::Towards` an amount that holds the object is known
            // already. If the verdict on sticking is decided for some amounts, amounts with an undecided verdict are dropped.
            if look == SearchExtent::Towards && vain.iter().any(|(_, trial)| trial.carried().is_some()) {
                vain.retain(|(_, trial)| trial.carried().is_some());
            }
            Ok(nothing_suffices(vain, plan.limits, None))
        }
    }
}

/// Completes the answer after a search has found sufficient amounts: makes the scan, and computes the far end and the forces at rest.
struct FoundAmounts<'f, 'q> {
    tried: &'f TrialRecord<'q>,
    demand: Demand,
    tries: TrialFunctions<'f>,
    /// Number of further amounts to try around the bound once it is found (the scan); 0 if no scan is made.
    scan: usize,
}

impl FoundAmounts<'_, '_> {
    fn known(&self) -> Vec<(f64, Trial)> {
        self.tried.known(self.demand)
    }

    /// The normal forces of the contacts at rest with the squeeze `sufficient`, and the names of drives at their limit; see [`presses`]. Both lists
    /// are empty if another quantity than a squeeze is sought.
    fn presses(&self, sufficient: f64) -> Result<(Vec<ContactPress>, Vec<String>), Error> {
        match self.tried.need.sought {
            Sought::Squeeze | Sought::Overlaps => presses(self.tried.grasp, sufficient, self.tried.need),
            _ => Ok(Default::default()),
        }
    }

    fn far_end(&self, edge: Option<Threshold>) -> Result<Option<FarEnd>, Error> {
        let Some(Threshold { sufficient, insufficient: (insufficient, trial), .. }) = edge else {
            return Ok(None);
        };
        let (Trial::Insufficient { says: otherwise, .. } | Trial::Unknown(otherwise)) = trial else {
            return Ok(None);
        };
        let (presses, at_their_limit) = self.presses(sufficient)?;
        Ok(Some(FarEnd { sufficient, insufficient, otherwise, presses, at_their_limit }))
    }

    /// Tries further amounts between the amounts tried before, those near `near` first; see [`between_known`]. Returns whether one of them has another
    /// verdict than its neighbours. Nothing is tried if no scan is made, or if every amount easier than a sufficient one is known to be sufficient.
    fn changes_between(
        &self,
        plan: &SearchPlan,
        near: f64,
        is_claimed: &dyn Fn(f64) -> bool,
    ) -> Result<bool, Error> {
        let is_asked = !plan.is_monotone && self.scan > 0;
        if is_asked { between_known(&self.known(), is_claimed, (plan, near), self.tries) } else { Ok(false) }
    }

    /// The answer if all amounts that were tried in the harder direction (less squeeze, more load) are sufficient. The last of these amounts is `to`.
    fn any(&self, plan: &SearchPlan, to: f64) -> Result<Amount, Error> {
        let seek = || BoundScan::far_end(to, self.scan, plan, &self.known(), self.tries);
        let mut until = seek()?;
        let end = until.as_ref().map(|edge| edge.sufficient);
        if self
            .changes_between(plan, plan.begin(), &|at| end.is_none_or(|end| (at - to) * (at - end) <= 0.0))?
        {
            until = seek()?;
        }
        let tried = (!plan.is_monotone).then(|| self.tried.amounts(self.demand));
        Ok(Amount::Any { to, until: self.far_end(until)?, tried })
    }

    /// The result of the scan around a bound. The scan is repeated if an amount between its amounts has another verdict than its neighbours, see
    /// [`Self::changes_between`].
    fn around(&self, plan: &mut SearchPlan, bound: &Threshold) -> Result<BoundScan, Error> {
        let sufficient = bound.sufficient;
        let is_squeeze = matches!(self.tried.need.sought, Sought::Squeeze | Sought::Overlaps);
        // If `is_monotone`, a larger squeeze always carries more, but it may move the part too far. Therefore one squeeze is tried that is much
        // larger than the least squeeze and than the given squeeze. If it is insufficient, the whole range is scanned.
        let ample = FAR_FROM_START * sufficient.max(plan.start);
        if plan.is_monotone && is_squeeze && self.scan > 0 && plan.contains(ample) {
            self.tries.at(ample)?;
        }
        // A wedge that is driven in carries less the more friction it has. Friction of a surface may be larger than in the scene, up to about 1.
        let is_friction = matches!(self.tried.need.sought, Sought::Friction { .. });
        if is_friction && !plan.is_monotone && self.scan > 0 && sufficient < USUAL_FRICTION {
            (self.tries.short)(USUAL_FRICTION)?;
        }
        let is_too_much =
            |(at, trial): &(f64, Trial)| *at > sufficient && matches!(trial, Trial::Insufficient { .. });
        plan.is_monotone &= !plan.is_least || !self.known().iter().any(is_too_much);
        let is_far = is_squeeze || matches!(self.tried.need.sought, Sought::Force { .. });
        let around = || BoundScan::of(bound, self.scan, is_far, plan, &self.known(), self.tries);
        let found = around()?;
        if self.changes_between(plan, sufficient, &|_| true)? { around() } else { Ok(found) }
    }

    /// The bracket at the harder end (less squeeze, more load) of an interval of sufficient amounts that is not [narrow](NARROW). Among several such
    /// intervals the one with the hardest end is taken. `None` if `bound` is at this end already, or if all intervals are narrow.
    fn edge_of_a_wide_window(
        &self,
        plan: &SearchPlan,
        bound: &Threshold,
        found: &BoundScan,
    ) -> Option<Threshold> {
        let far = found.until.as_ref().map(|edge| edge.sufficient);
        let own = if plan.is_least { [Some(bound.sufficient), far] } else { [far, Some(bound.sufficient)] };
        let mut all = mapped(&found.elsewhere, &|window| [window.from, window.to]);
        all.push(own);
        let is_wide = |[from, to]: &[Option<f64>; 2]| {
            from.is_none_or(|from| to.is_none_or(|to| to > from * (1.0 + NARROW)))
        };
        let edges = picked(&all, &|ends| ends[usize::from(!plan.is_least)].filter(|_| is_wide(ends)));
        let sufficient =
            edges.into_iter().reduce(|one, other| if plan.is_harder(one, other) { one } else { other })?;
        let known = self.known();
        let harder = known.iter().filter(|(at, trial)| {
            matches!(trial, Trial::Insufficient { .. }) && plan.is_harder(*at, sufficient)
        });
        let insufficient =
            harder.reduce(|one, other| if plan.is_harder(one.0, other.0) { other } else { one })?.clone();
        (sufficient != bound.sufficient).then_some(Threshold { sufficient, insufficient, unknown: None })
    }

    /// The answer [`Amount::Bound`], from the bracket of the least or greatest sufficient amount and from amounts that are tried around it.
    fn bound(
        mut self,
        mut plan: SearchPlan,
        mut bound: Threshold,
        look: SearchExtent,
    ) -> Result<Amount, Error> {
        if is_stepped_over(&plan, bound.sufficient) {
            self.scan = self.tried.need.scan;
        }
        if let Trial::Unknown(doubt) = bound.insufficient.1 {
            return Ok(Amount::Undecided { at: bound.insufficient.0, doubt });
        }
        let mut found = self.around(&mut plan, &bound)?;
        if let Some(edge) = self.edge_of_a_wide_window(&plan, &bound, &found) {
            let measures = self.tries.at(edge.sufficient)?.measures();
            bound = edge.narrowed(self.tries, measures, plan.enough)?;
            found = self.around(&mut plan, &bound)?;
        }
        let (sufficient, insufficient) = (bound.sufficient, bound.insufficient.0);
        let (otherwise, is_too_far) = match &bound.insufficient.1 {
            Trial::Insufficient { says, is_too_far, .. } => (says.clone(), *is_too_far),
            Trial::Sufficient { .. } | Trial::Unknown(_) => (String::new(), false),
        };
        let BoundScan { changes, mut until, elsewhere } = found;
        let far = match look {
            SearchExtent::Everywhere(far) => far,
            SearchExtent::Towards => beyond_the_sufficient(sufficient, plan.is_least, &self.known()),
            SearchExtent::Around => None,
        };
        if let (Some(far), None) = (far, &until) {
            until = far_end_near(far, sufficient, self.tries)?;
        }
        let (presses, at_their_limit) = self.presses(sufficient)?;
        let is_last = plan.is_monotone || plan.is_the_end(insufficient, !plan.is_least);
        let tried = (!is_last).then(|| self.tried.amounts(self.demand));
        Ok(Amount::Bound {
            sufficient,
            insufficient,
            otherwise,
            is_too_far,
            unknown: bound.unknown.map(|(at, _)| at),
            changes,
            until: self.far_end(until)?,
            elsewhere,
            presses,
            at_their_limit,
            tried,
        })
    }
}

/// Whether the search for a safe amount stepped over many amounts. This is so if the sufficient amount is easier than the first amount tried by more
/// than the ratio [`STEPPED_OVER`].
fn is_stepped_over(plan: &SearchPlan, sufficient: f64) -> bool {
    let begin = plan.begin();
    let ratio = if plan.is_least { sufficient / begin } else { begin / sufficient };
    plan.everywhere && !plan.is_monotone && ratio > STEPPED_OVER
}

/// The last sufficient amount and the first insufficient amount among those tried from the bound `sufficient` towards easier amounts (more squeeze,
/// less load). `None` if no tried amount is insufficient.
fn beyond_the_sufficient(sufficient: f64, is_least: bool, known: &[(f64, Trial)]) -> Option<[f64; 2]> {
    let ample = |at: f64| if is_least { at / sufficient } else { sufficient / at };
    let mut beyond: Vec<_> = known.iter().filter(|(at, _)| ample(*at) > 1.0).list();
    sort_by_number(&mut beyond, &|(at, _)| ample(*at));
    let first = beyond.iter().position(|(_, trial)| matches!(trial, Trial::Insufficient { .. }))?;
    let last = beyond[..first]
        .iter()
        .rev()
        .find(|(_, trial)| trial.is_sufficient())
        .map_or(sufficient, |(at, _)| *at);
    Some([last, beyond[first].0])
}

/// The bracket of the far end of the sufficient amounts whose bound is `sufficient`. The far end is expected between the two amounts `far`, which are
/// tried in turn. For a safe amount, `far` is the bracket of the far end with friction, squeeze and loads as given. `None` if neither of the two
/// amounts is insufficient, or if a verdict is undecided.
fn far_end_near(
    far: [f64; 2],
    sufficient: f64,
    tries: TrialFunctions<'_>,
) -> Result<Option<Threshold>, Error> {
    let mut inner = sufficient;
    for amount in far {
        match tries.at(amount)? {
            Trial::Sufficient { .. } => inner = amount,
            Trial::Unknown(_) => return Ok(None),
            trial @ Trial::Insufficient { .. } => {
                let measures = tries.at(inner)?.measures();
                let edge = Threshold { sufficient: inner, insufficient: (amount, trial), unknown: None };
                return edge.beside(tries, measures).map(Some);
            }
        }
    }
    Ok(None)
}

/// The answer if no amount is sufficient. Without a proof, one undecided verdict makes the answer undecided. Otherwise `best` is the first of the
/// amounts with which most of the load is carried.
pub(super) fn nothing_suffices(vain: Vec<(f64, Trial)>, limits: [f64; 2], proof: Option<&Range>) -> Amount {
    let (is_proved, at_rest) = (proof.is_some(), proof.is_some_and(|range| range.is_empty_at_rest));
    let amounts = || vain.iter().map(|(amount, _)| *amount);
    let [from, to] = if is_proved {
        limits
    } else {
        [amounts().fold(f64::INFINITY, f64::min), amounts().fold(0.0, f64::max)]
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
