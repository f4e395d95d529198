//! The question for an amount on the command line.

use grasp_lcp::grasp::Wrench;
use grasp_lcp::need::{Demand, Quantity};
use grasp_lcp::scene::{NeedAsked, Setup};
use grasp_lcp::words::printable;

use crate::arguments::{QuantityAsked, Wanted};
use crate::asking::Meaning;
use crate::failure::Failure;
use crate::loads::{direction, point, total_force};
use crate::own_masses::{accelerated, of_own_masses, tilted};

impl<const C: usize> Meaning<C> {
    /// The question for the quantity of the command line; `None` if there is none.
    pub(crate) fn need(
        &self,
        wanted: &Wanted,
        setup: &mut Setup<C>,
    ) -> Result<Option<NeedAsked<C>>, Failure> {
        let Some(sought) = wanted.quantity else { return Ok(None) };
        refuse_others(wanted, sought)?;
        let mut asked = NeedAsked::of(match sought {
            QuantityAsked::Squeeze => Quantity::Squeeze,
            QuantityAsked::Friction => Quantity::Friction,
            QuantityAsked::Load => Quantity::Load,
            QuantityAsked::Arm => Quantity::Arm,
            QuantityAsked::Angle => Quantity::Angle,
            QuantityAsked::Force => Quantity::Force,
        });
        asked.of.clone_from(&wanted.of);
        asked.safety = wanted.safety;
        [asked.friction_less, asked.squeeze_less] =
            [wanted.friction_less, wanted.squeeze_less].map(|percent| percent.map(|percent| 0.01 * percent));
        if wanted.base.is_some() {
            asked.base = Some(self.base(wanted.base.as_ref(), wanted.load.at.as_ref())?);
        }
        asked.demand = match (wanted.repeats, wanted.may_slide) {
            (false, _) if wanted.sticks => Demand::Sticks,
            (false, _) => Demand::Held,
            (true, false) => Demand::Rests,
            (true, true) => Demand::Stays,
        };
        asked.together_with = self.together_with(&wanted.load)?;
        self.put_loads(&mut asked, wanted, sought, setup)?;
        asked.contact = wanted.contact.as_ref().map(|name| named("contact", name, setup)).transpose()?;
        Ok(Some(asked))
    }

    /// Sets the loads of a question from the options.
    fn put_loads(
        &self,
        asked: &mut NeedAsked<C>,
        wanted: &Wanted,
        sought: QuantityAsked,
        setup: &mut Setup<C>,
    ) -> Result<(), Failure> {
        let beside = wanted.base.is_some() || wanted.any_force.is_some();
        let given = &*of_own_masses(&wanted.load, beside, setup)?;
        let at = point(given.at.as_ref())?;
        let load = self.wrench(given)?;
        let missing = || Failure::Usage("say for which load: --mass, --force or --moment".to_owned());
        match (sought, wanted.acceleration) {
            (QuantityAsked::Arm, _) => {
                let along = wanted.along.as_ref().ok_or_else(|| {
                    let axis = if C == 3 { "1,0,0" } else { "1,0" };
                    Failure::Usage(format!("--along is missing: where to, such as --along {axis}"))
                })?;
                let along: [f64; C] = direction(along, "along")?;
                let length = along.iter().map(|x| x * x).sum::<f64>().sqrt();
                let there = std::array::from_fn(|a| at[a] + along[a] / length);
                let force = total_force(given)?;
                asked.per_metre = Some((self.force_at)(force, there) + (self.force_at)(force, at) * -1.0);
                asked.load = Some(load.ok_or_else(missing)?);
            }
            (QuantityAsked::Angle, _) => {
                let own = if load.is_none() { tilted(setup) } else { None };
                let (weight, at) = match own {
                    Some(own) => (own.weight, Some(own.at)),
                    None => (total_force(given)?, given.at.clone()),
                };
                asked.turn = Some((self.turn)(weight, at.as_ref(), wanted.axis.as_ref())?);
            }
            (_, Some(acceleration)) if given.mass.is_none() => {
                let (mass, centre) = accelerated(setup, "acceleration")?;
                if asked.base.is_some() {
                    let message = "--acceleration: accelerates the bodies by their own masses, must stand without --base: what is always there is the `load` of a body";
                    return Err(Failure::Usage(message.to_owned()));
                }
                asked.loads = self.accelerated(mass, acceleration, centre);
            }
            (_, Some(acceleration)) => {
                let weight = load.unwrap_or(Wrench::ZERO);
                asked.base = Some(asked.base.unwrap_or(Wrench::ZERO) + weight);
                asked.loads = self.accelerated(wanted.load.mass.unwrap_or(0.0), acceleration, at);
            }
            (_, None) if load.is_none() && wanted.any_force.is_none() => return Err(missing()),
            (_, None) => {
                (asked.load, asked.any_force) = (load, wanted.any_force);
                asked.at = wanted.any_force.map(|_| at.into());
            }
        }
        Ok(())
    }
}

/// Refuses options that belong to another quantity.
fn refuse_others(wanted: &Wanted, sought: QuantityAsked) -> Result<(), Failure> {
    let of_its_own = [
        (wanted.along.is_some(), QuantityAsked::Arm, "--along", "an arm"),
        (wanted.axis.is_some(), QuantityAsked::Angle, "--axis", "an angle"),
        (wanted.contact.is_some(), QuantityAsked::Friction, "--contact", "friction"),
        (wanted.of.is_some(), QuantityAsked::Force, "--of", "a force"),
    ];
    if let Some((.., option, of)) = of_its_own.iter().find(|(given, of, ..)| *given && *of != sought) {
        return Err(Failure::Usage(format!("{option}: given, must be left out unless {of} is sought")));
    }
    let is_arm_or_angle = matches!(sought, QuantityAsked::Arm | QuantityAsked::Angle);
    let is_more = wanted.load.force.is_some() || wanted.load.moment.is_some() || wanted.any_force.is_some();
    let message = if wanted.any_force.is_some() && is_arm_or_angle {
        "--any-force: given, must be left out where an arm or an angle is sought"
    } else if wanted.acceleration.is_some() && (is_more || is_arm_or_angle) {
        "--acceleration: given, must be left out beside other loads, and where an arm or an angle is sought"
    } else {
        return Ok(());
    };
    Err(Failure::Usage(message.to_owned()))
}

/// The index of the contact with the name that an option gives.
pub(crate) fn named<const C: usize>(option: &str, name: &str, setup: &Setup<C>) -> Result<usize, Failure> {
    let labels: Vec<_> = setup.entries().enumerate().map(|(i, entry)| entry.contact.label_text(i)).collect();
    let name = printable(name);
    let mut by_name = (0..labels.len()).filter(|i| labels[*i] == name);
    match (by_name.next(), by_name.next()) {
        (Some(contact), None) => Ok(contact),
        (None, _) => {
            let all = labels.join(", ");
            Err(Failure::Usage(format!("--{option}: there is no {name}, must be one of {all}")))
        }
        (Some(_), Some(_)) => {
            Err(Failure::Usage(format!("--{option}: there are several {name}, must be the name of one")))
        }
    }
}
