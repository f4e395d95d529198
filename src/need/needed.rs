//! What is asked, searched for and answered.

use super::answer::{Amount, FarEnd, Needed, Press, Quantity, check_part};
use super::around::Around;
use super::question::{Need, Sought};
use super::search::{Searched, Threshold, search};
use super::trial::{Trial, is_far, try_amount};
use crate::ask::Grasp;
use crate::equilibrium::{DriveState, Outcome};
use crate::error::Error;
use crate::grasp::{WholeContacts, Wrench};
use crate::prelude::*;
use crate::squeeze::Loads;

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
        let (demand, lower, force) = (need.demand, need.lower, need.force());
        Ok(Needed { quantity, demand, amount, safe, lower, force, beyond_small_motions })
    }
}

impl<const C: usize> Need<C> {
    /// Refuses numbers that no grasp would take.
    pub(crate) fn check(&self) -> Result<(), Error> {
        self.base.check("base load")?;
        check_part("part by which friction is less", self.lower[0])?;
        check_part("part by which the squeeze is less", self.lower[1])?;
        if let (true, Sought::Squeeze { loads } | Sought::Friction { loads, .. } | Sought::Load { loads }) =
            (self.demand.repeats(), &self.sought)
            && matches!(loads, Loads::AnyForce { .. })
        {
            let fault = "is one of loads that repeat, must be another for a force of any direction";
            return Err(Error::Question { question: "need", field: "demand", fault });
        }
        match &self.sought {
            Sought::Squeeze { loads } | Sought::Friction { loads, .. } | Sought::Load { loads } => {
                loads.check_size()
            }
            Sought::Arm { .. } | Sought::Angle { .. } => Ok(()),
        }
    }

    /// The size of a single force that is sought so many times.
    fn force(&self) -> Option<f64> {
        match &self.sought {
            Sought::Load { loads: Loads::Each(list) } if list.len() == 1 => {
                list[0].measure().filter(|(_, unit)| *unit == "N").map(|(size, _)| size)
            }
            _ => None,
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
    let tries = |amount: f64| try_amount(grasp, need, amount, less);
    let is_least = need.quantity().is_least();
    let start = start(grasp, need);
    // Of a load that is put on from rest all less was on before. An angle is not turned beyond what was asked for.
    let everywhere = match need.sought {
        Sought::Squeeze { .. } | Sought::Friction { .. } | Sought::Arm { .. } => true,
        Sought::Angle { .. } if tries(start)? == Trial::Does => return Ok(Amount::Any { to: start }),
        Sought::Angle { .. } | Sought::Load { .. } => false,
    };
    let bound = match search(&tries, start, is_least, everywhere)? {
        Searched::Threshold(edge) => edge.halved(&tries)?,
        Searched::All(to) => return Ok(Amount::Any { to }),
        Searched::Nothing(vain) => return Ok(nothing_does(vain)),
    };
    let (does, does_not) = (bound.does, bound.does_not.0);
    let otherwise = match &bound.does_not.1 {
        Trial::Unknown(doubt) => return Ok(Amount::Undecided { at: does_not, doubt: doubt.clone() }),
        Trial::DoesNot { says, .. } => says.clone(),
        Trial::Does => String::new(),
    };
    let is_squeeze = matches!(need.sought, Sought::Squeeze { .. });
    let at_rest = |does: f64| if is_squeeze { presses(grasp, does) } else { Ok(Default::default()) };
    let Around { changes, until, elsewhere } = Around::of(&bound, need.scan, is_least, is_squeeze, &tries)?;
    let far_end = |edge: Threshold| {
        let Threshold { does, does_not: (does_not, trial) } = edge;
        let (Trial::DoesNot { says: otherwise, .. } | Trial::Unknown(otherwise)) = trial else {
            return Ok::<_, Error>(None);
        };
        let (presses, at_their_limit) = at_rest(does)?;
        Ok(Some(FarEnd { does, does_not, otherwise, presses, at_their_limit }))
    };
    let until = until.map(far_end).transpose()?.flatten();
    let (presses, at_their_limit) = at_rest(does)?;
    Ok(Amount::Bound { does, does_not, otherwise, changes, until, elsewhere, presses, at_their_limit })
}

/// Told from amounts of which none does: by one of which it is not known, or by the one that carries most, the first of them if several do.
fn nothing_does(vain: Vec<(f64, Trial)>) -> Amount {
    let amounts = || vain.iter().map(|(amount, _)| *amount);
    let [from, to] = [amounts().fold(f64::INFINITY, f64::min), amounts().fold(0.0, f64::max)];
    let mut none = Amount::None { from, to, best: to, otherwise: String::new() };
    let mut most = f64::NEG_INFINITY;
    for (amount, trial) in vain {
        let carried = trial.carried();
        match trial {
            Trial::Unknown(doubt) => return Amount::Undecided { at: amount, doubt },
            Trial::DoesNot { says: otherwise, .. } if carried > most => {
                most = carried;
                none = Amount::None { from, to, best: amount, otherwise };
            }
            Trial::DoesNot { .. } | Trial::Does => {}
        }
    }
    none
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
