//! The command `need`: how much of a quantity (clamping force, friction, load, arm, angle or force) the grasp needs or allows.

use std::collections::BTreeMap;

use grasp_lcp::spatial::{Need, Wrench};
use grasp_lcp::words::printable;

use crate::arguments::{LoadArguments, NeedArguments, Numbers, SoughtQuantity};
use crate::failure::Failure;
use crate::loads::OptionVectors;
use crate::own_masses::{accelerated, of_own_masses, tilted};
use crate::scene_loads::{SceneLoads, own_need, single_load};
use grasp_lcp::scene::{Question, Setup};

impl OptionVectors {
    /// The question for the quantity that the command line names, with the loads of the command line or else of the scene. `None` if the command line
    /// names neither a quantity nor anything else about the need.
    pub(crate) fn need(
        self,
        need_arguments: &NeedArguments,
        setup: &mut Setup<3>,
    ) -> Result<Option<Need>, Failure> {
        let Some(sought) = need_arguments.quantity else {
            if *need_arguments == NeedArguments::default() {
                return Ok(None);
            }
            let message = "say what is needed, such as `squeeze`, beside a load or an option: without it only the scene's own questions are asked, as they stand";
            return Err(Failure::Usage(message.to_owned()));
        };
        refuse_others(need_arguments, sought)?;
        let own = own_need(setup, need_arguments, sought);
        let is_own = own.is_some();
        let Sought { mut need, weight, centre } = match own {
            Some(need) => Sought::of(need),
            None => self.sought(need_arguments, sought, setup)?,
        };
        if let Some(times) = need_arguments.safety {
            need = need.with_safety(times);
        }
        if let Some(percent) = need_arguments.friction_less {
            need = need.if_friction_lower_by(0.01 * percent);
        }
        if let Some(percent) = need_arguments.squeeze_less {
            need = need.if_squeeze_lower_by(0.01 * percent);
        }
        if need_arguments.base.is_some() || weight.is_some() {
            let at = need_arguments.load.at.as_ref().or(centre.as_ref());
            let base = self.base(need_arguments.base.as_ref(), at)?;
            need = need.on_top_of(base + weight.unwrap_or(Wrench::ZERO));
        }
        for (body, load) in self.together_with(&need_arguments.load)? {
            need = need.together_with(body, load);
        }
        Ok(Some(match (need_arguments.repeats, need_arguments.may_slide) {
            (false, false) if is_own && !need_arguments.sticks => need,
            (false, _) if need_arguments.sticks => need.to_stick(),
            (false, _) => need.to_hold(),
            (true, false) => need.to_rest(),
            (true, true) => need.to_stay(),
        }))
    }

    /// The question for the sought quantity, with its loads.
    fn sought(
        self,
        need_arguments: &NeedArguments,
        sought: SoughtQuantity,
        setup: &mut Setup<3>,
    ) -> Result<Sought, Failure> {
        let beside = need_arguments.base.is_some() || need_arguments.any_force.is_some();
        let to_and_fro = to_and_fro(need_arguments);
        let mut asked = need_arguments.load.clone();
        if to_and_fro.is_some() {
            asked.acceleration = None;
        }
        let given = &*of_own_masses(&asked, beside, setup)?;
        let at = self.point(given.at.as_ref())?;
        let mut load = self.wrench(given, beside)?;
        let missing = || Failure::Usage("say for which load: --mass, --force or --moment".to_owned());
        let mut together_with = BTreeMap::new();
        let (loads, weight) = match (sought, to_and_fro) {
            (SoughtQuantity::Arm, _) => {
                let along = need_arguments.along.as_ref().ok_or_else(|| {
                    let axis = if self.axes == 3 { "1,0,0" } else { "1,0" };
                    Failure::Usage(format!("--along is missing: where to, such as --along {axis}"))
                })?;
                let along = self.direction(along, "along")?;
                let length = along.iter().map(|x| x * x).sum::<f64>().sqrt();
                let there = std::array::from_fn(|a| at[a] + along[a] / length);
                let force = self.total_force(given)?;
                // The load is given the point at which it acts, so that the answer takes buckling into account, too.
                let placed = LoadArguments { at: Some(Numbers(at[..self.axes].to_vec())), ..given.clone() };
                let load = self.wrench(&placed, beside)?;
                let per_metre = Wrench::force_at(force, there) + Wrench::force_at(force, at) * -1.0;
                return Ok(Sought::of(Need::arm(load.ok_or_else(missing)?, per_metre)));
            }
            (SoughtQuantity::Angle, _) => {
                if asked.acceleration.is_some() && asked.mass.is_none() && setup.own_mass().is_some() {
                    let message = "--acceleration: must be left out where an angle is sought of bodies with masses of their own; what an acceleration adds, constant in the grasp, is `--base`";
                    return Err(Failure::Usage(message.to_owned()));
                }
                let own = if load.is_none() { tilted(setup)? } else { None };
                let (weight, at) = match own {
                    Some(own) => (own.weight, Some(own.at)),
                    None => (self.total_force(given)?, given.at.clone()),
                };
                let turn = self.turn(weight, at.as_ref(), need_arguments.axis.as_ref())?;
                return Ok(Sought { centre: at, ..Sought::of(Need::angle(turn)) });
            }
            (_, Some(acceleration)) if given.mass.is_none() => {
                let (mass, centre) = accelerated(setup, "acceleration")?;
                if need_arguments.base.is_some() {
                    let message = "--acceleration: accelerates the bodies by their own masses, must stand without --base: what is always there is the `load` of a body";
                    return Err(Failure::Usage(message.to_owned()));
                }
                (self.to_and_fro(mass, acceleration, centre)?.into(), None)
            }
            (_, Some(acceleration)) => {
                let mass = need_arguments.load.mass.unwrap_or(0.0);
                (self.to_and_fro(mass, acceleration, at)?.into(), load)
            }
            (_, None) if load.is_none() => match SceneLoads::of(setup) {
                Some(of_scene) => {
                    together_with = of_scene.together_with;
                    let loads = match need_arguments.any_force {
                        Some(size) => {
                            load = Some(single_load(&of_scene.loads)?);
                            self.loads(load, Some(size), given.at.as_ref())?
                        }
                        None => of_scene.loads,
                    };
                    (loads, need_arguments.base.is_none().then_some(of_scene.base))
                }
                None if sought == SoughtQuantity::Load && need_arguments.any_force.is_none() => {
                    return Err(missing());
                }
                None if beside => (self.loads(load, need_arguments.any_force, given.at.as_ref())?, None),
                // If neither the command line nor the scene's questions have a load, only constant loads of the scene act, such as weights of bodies.
                // Without such constant loads an error follows below.
                None => (Vec::new().into(), None),
            },
            (_, None) => (self.loads(load, need_arguments.any_force, given.at.as_ref())?, None),
        };
        let need = match (sought, &need_arguments.contact, &need_arguments.of) {
            (SoughtQuantity::Friction, Some(name), _) => {
                Need::friction_of([named("contact", name, setup)?], loads)
            }
            (SoughtQuantity::Friction, None, _) => Need::friction(loads),
            (SoughtQuantity::Force, _, Some(part)) => Need::force(part, loads),
            (SoughtQuantity::Force, _, None) => Need::load_at_rest(loads),
            (SoughtQuantity::Load, ..) => Need::load(loads),
            _ => Need::squeeze(loads),
        };
        let need = together_with.into_iter().fold(need, |need, (body, load)| need.together_with(body, load));
        if load.is_none() && !beside && to_and_fro.is_none() {
            let asked = weight.iter().fold(need.clone(), |need, base| need.on_top_of(*base));
            setup.check(&Question::Need(Box::new(asked))).map_err(|_| missing())?;
        }
        let weight = weight.filter(|weight| *weight != Wrench::ZERO);
        Ok(Sought { weight, ..Sought::of(need) })
    }
}

/// A question for a sought quantity, from options of the command line.
struct Sought {
    need: Need,
    /// The constant load that acts in addition; `None` if there is none. For accelerations to and fro it is the load of all other options, such as the
    /// weight of the mass. For loads of the scene it is the base load of the scene's question.
    weight: Option<Wrench>,
    /// Where `--base` acts without `--at`, m; `None` for the origin.
    centre: Option<Numbers>,
}

impl Sought {
    fn of(need: Need) -> Self {
        Self { need, weight: None, centre: None }
    }
}

/// The magnitude of accelerations to and fro along every axis, if `--acceleration` is one number. `None` without this option, and for a vector, which
/// is a constant acceleration of the arm.
fn to_and_fro(need_arguments: &NeedArguments) -> Option<&Numbers> {
    need_arguments.load.acceleration.as_ref().filter(|acceleration| acceleration.0.len() == 1)
}

/// Refuses options that have no meaning for the sought quantity, such as an axis if friction is sought.
fn refuse_others(need_arguments: &NeedArguments, sought: SoughtQuantity) -> Result<(), Failure> {
    let of_its_own = [
        (need_arguments.along.is_some(), SoughtQuantity::Arm, "--along", "an arm"),
        (need_arguments.axis.is_some(), SoughtQuantity::Angle, "--axis", "an angle"),
        (need_arguments.contact.is_some(), SoughtQuantity::Friction, "--contact", "friction"),
        (need_arguments.of.is_some(), SoughtQuantity::Force, "--of", "a force"),
    ];
    if let Some((.., option, of)) = of_its_own.iter().find(|(given, of, ..)| *given && *of != sought) {
        return Err(Failure::Usage(format!("{option}: given, must be left out unless {of} is sought")));
    }
    let is_arm_or_angle = matches!(sought, SoughtQuantity::Arm | SoughtQuantity::Angle);
    let is_more = need_arguments.load.force.is_some()
        || need_arguments.load.moment.is_some()
        || need_arguments.any_force.is_some();
    let message = if need_arguments.load.moment.is_some() && sought == SoughtQuantity::Angle {
        "--moment: given, must be left out where an angle is sought; what acts beside the weight is `beside` of a `turn` in the scene"
    } else if need_arguments.any_force.is_some() && is_arm_or_angle {
        "--any-force: given, must be left out where an arm or an angle is sought"
    } else if to_and_fro(need_arguments).is_some() && (is_more || is_arm_or_angle) {
        "--acceleration: given, must be left out beside other loads, and where an arm or an angle is sought"
    } else {
        return Ok(());
    };
    Err(Failure::Usage(message.to_owned()))
}

/// The index of the contact with the name that an option gives.
pub(crate) fn named(option: &str, name: &str, setup: &Setup<3>) -> Result<usize, Failure> {
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
