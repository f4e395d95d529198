//! The search for an amount: bracketed by trials, then halved.

use super::answer::{Amount, Needed, Press, Quantity, check_part};
use super::question::{Need, Sought};
use super::trial::{Trial, is_far, try_amount};
use crate::ask::Grasp;
use crate::equilibrium::{DriveState, Outcome};
use crate::error::Error;
use crate::grasp::{WholeContacts, Wrench};

/// From what is given amounts are doubled or halved so many times at most.
const MOST_DOUBLINGS: usize = 20;
/// Amounts this close together are one, relatively.
const CLOSE: f64 = 1e-13;
/// At the bound itself rounding may keep a verdict from being told: what does not is then looked for this far beyond, relatively.
const BLURRED: f64 = 1e-9;
/// A scan goes so many times below and above the bound.
const SCANNED: f64 = 4.0;

impl<const C: usize> Grasp<C> {
    /// How much does it need? The least squeeze or friction, the greatest load, arm or angle; see [`Need`].
    ///
    /// ```
    /// use grasp_lcp::need::Need;
    /// use grasp_lcp::planar::{Contact, Grasp, Wrench};
    ///
    /// // Two jaws that press with 10 N each, μ = 0.5: how much do they have to press to carry 12 N?
    /// let jaw = |x: f64, name| Contact::new([x, 0.0], [-x, 0.0]).name(name).series_stiffness(1000.0, 800.0).friction(0.5).pressed_with(10.0);
    /// let gripper = Grasp::new([jaw(-0.03, "left"), jaw(0.03, "right")])?;
    /// let needed = gripper.need(&Need::squeeze(Wrench::force([0.0, -12.0])).if_lower_by(0.1, 0.0))?;
    /// assert!((needed.amount.bound().expect("1.2 times as much") - 1.2).abs() < 1e-12);
    /// assert!(needed.to_string().starts_with("NEEDS 12 N at left and right so that nothing slides, 13.3333 N if friction is 10 % less"), "{needed}");
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    ///
    /// # Errors
    /// As for [`Self::hold`] of its loads; [`Error::Argument`] if a part by which friction or squeeze may be less is not from 0 to less than 1.
    #[doc(alias = "grip force")]
    #[doc(alias = "required")]
    pub fn need(&self, need: &Need<C>) -> Result<Needed, Error> {
        need.check()?;
        let quantity = need.quantity();
        let amount = amount(self, need, [0.0; 2])?;
        let is_uncertain = need.lower.iter().any(|part| *part != 0.0);
        let safe = is_uncertain.then(|| self::amount(self, need, need.lower)).transpose()?;
        let beyond_small_motions = match &amount {
            Amount::Bound { does, .. } | Amount::Any { to: does } => is_far(self, need, *does)?,
            Amount::None { .. } | Amount::Undecided { .. } => false,
        };
        Ok(Needed { quantity, demand: need.demand, amount, safe, lower: need.lower, beyond_small_motions })
    }
}

impl<const C: usize> Need<C> {
    /// Refuses numbers that no grasp would take.
    pub(crate) fn check(&self) -> Result<(), Error> {
        self.base.check("base load")?;
        check_part("part by which friction is less", self.lower[0])?;
        check_part("part by which the squeeze is less", self.lower[1])?;
        match &self.sought {
            Sought::Squeeze { loads } | Sought::Friction { loads, .. } | Sought::Load { loads } => {
                loads.check_size()
            }
            Sought::Arm { .. } | Sought::Angle { .. } => Ok(()),
        }
    }

    fn quantity(&self) -> Quantity {
        match self.sought {
            Sought::Squeeze { .. } => Quantity::Squeeze,
            Sought::Friction { .. } => Quantity::Friction,
            Sought::Load { .. } => Quantity::Load,
            Sought::Arm { .. } => Quantity::Arm,
            Sought::Angle { .. } => Quantity::Angle,
        }
    }
}

/// Where a search begins: at what is given, at a coefficient of friction in the middle of all, at an arm as long as the grasp is wide.
fn start<const C: usize>(grasp: &Grasp<C>, need: &Need<C>) -> f64 {
    let contacts = grasp.contacts();
    match &need.sought {
        Sought::Squeeze { .. } | Sought::Load { .. } => 1.0,
        Sought::Friction { contacts: those, .. } => {
            let is_meant = |i: &usize| those.as_ref().is_none_or(|those| those.contains(i));
            let all = contacts.iter().enumerate().filter(|(i, _)| is_meant(i));
            let given = all.map(|(_, contact)| contact.friction_coefficient()).fold(0.0, f64::max);
            if given > 0.0 && given.is_finite() { given } else { 0.5 }
        }
        Sought::Arm { .. } => {
            let first = contacts.first().map(crate::grasp::Contact::point);
            let away = |contact: &crate::grasp::Contact<C>| {
                (contact.point() - first.unwrap_or(contact.point())).norm()
            };
            let width = contacts.iter().map(away).fold(0.0, f64::max);
            if width > 0.0 { width } else { 1.0 }
        }
        Sought::Angle { turn } => turn.angle(),
    }
}

fn amount<const C: usize>(grasp: &Grasp<C>, need: &Need<C>, less: [f64; 2]) -> Result<Amount, Error> {
    if let Sought::Friction { contacts: Some(contacts), .. } = &need.sought
        && let Some(contact) = contacts.iter().find(|contact| **contact >= grasp.len())
    {
        let (what, allowed) = ("number of the contact", "less than the number of contacts");
        return Err(Error::Argument { what, value: *contact as f64, allowed });
    }
    let tried = |amount: f64| try_amount(grasp, need, amount, less);
    let start = start(grasp, need);
    let is_least = need.quantity().is_least();
    let mut at = start;
    let mut trial = tried(at)?;
    let does = trial == Trial::Does;
    // An angle is not turned beyond what was asked for.
    if does && matches!(need.sought, Sought::Angle { .. }) {
        return Ok(Amount::Any { to: at });
    }
    // From what does towards less of it, from what does not towards more.
    let factor = if does == is_least { 0.5 } else { 2.0 };
    let mut before = None;
    for _ in 0..MOST_DOUBLINGS {
        before = Some((at, trial));
        at *= factor;
        trial = tried(at)?;
        if (trial == Trial::Does) != does {
            break;
        }
    }
    let Some((was, trial_before)) = before else { return Ok(Amount::Any { to: at }) };
    let (mut good, mut bad) = match (does, trial == Trial::Does) {
        (true, true) => return Ok(Amount::Any { to: at }),
        (false, false) => {
            return Ok(match trial {
                Trial::Unknown(doubt) => Amount::Undecided { at, doubt },
                Trial::DoesNot(otherwise) => Amount::None { to: at, otherwise },
                Trial::Does => Amount::Any { to: at },
            });
        }
        (true, false) => (was, (at, trial)),
        (false, true) => (at, (was, trial_before)),
    };
    while (good - bad.0).abs() > CLOSE * good.abs() {
        let middle = 0.5 * (good + bad.0);
        if middle == good || middle == bad.0 {
            break;
        }
        match tried(middle)? {
            Trial::Does => good = middle,
            trial => bad = (middle, trial),
        }
    }
    if let Trial::Unknown(_) = bad.1 {
        bad = beyond_the_blur(good, bad, tried)?;
    }
    let otherwise = match bad.1 {
        Trial::Unknown(doubt) => return Ok(Amount::Undecided { at: bad.0, doubt }),
        Trial::DoesNot(otherwise) => otherwise,
        Trial::Does => String::new(),
    };
    let (presses, at_their_limit) =
        if let Sought::Squeeze { .. } = need.sought { presses(grasp, good)? } else { Default::default() };
    let changes = changes(need.scan, good, is_least, tried)?;
    Ok(Amount::Bound { does: good, does_not: bad.0, otherwise, changes, presses, at_their_limit })
}

/// An amount that clearly does not, close beyond a bound at which it is not known; else the one that was tried.
fn beyond_the_blur(
    good: f64,
    bad: (f64, Trial),
    tried: impl Fn(f64) -> Result<Trial, Error>,
) -> Result<(f64, Trial), Error> {
    let mut gap = bad.0 - good;
    while gap.abs() <= 0.25 * BLURRED * good.abs() {
        gap *= 4.0;
        if let trial @ Trial::DoesNot(_) = tried(good + gap)? {
            return Ok((good + gap, trial));
        }
    }
    Ok(bad)
}

/// How often the verdict changes among amounts around the bound, those next to it included.
fn changes(
    scan: usize,
    bound: f64,
    is_least: bool,
    tried: impl Fn(f64) -> Result<Trial, Error>,
) -> Result<usize, Error> {
    let mut changes = 1;
    let half = scan / 2;
    for (side, up) in [(false, half), (true, scan - half)] {
        // Next to the bound on this side.
        let mut does = side == is_least;
        for k in 1..=up {
            let part = SCANNED.powf(k as f64 / up as f64);
            let amount = if side { bound * part } else { bound / part };
            let now = tried(amount)? == Trial::Does;
            changes += usize::from(now != does);
            does = now;
        }
    }
    Ok(changes)
}

/// What each contact presses with at rest, squeezed so many times as much, and whose drives are at their limit there.
fn presses<const C: usize>(grasp: &Grasp<C>, squeeze: f64) -> Result<(Vec<Press>, Vec<String>), Error> {
    let squeezed = grasp.squeezed(squeeze)?;
    let Outcome::Equilibrium(state) = squeezed.solve(&Wrench::ZERO)? else { return Ok(Default::default()) };
    let parts = WholeContacts::of(grasp.contacts());
    let forces = parts.sum(&|i| state.contacts[i].force[0]);
    let press = |part: crate::grasp::WholeContact| {
        let force = forces[part.contact];
        Press { part, force }
    };
    let joints = state.joints.iter().map(|joint| (joint.state, joint.joint.text()));
    let drives = joints.chain(state.tendons.iter().map(|tendon| (tendon.state, tendon.tendon.text())));
    // A finger that is held by its force alone is there by design.
    let at_their_limit = drives.filter(|(state, _)| *state == DriveState::Yields).map(|(_, name)| name);
    Ok((parts.with(&|_| true).into_iter().map(press).collect(), at_their_limit.collect()))
}
