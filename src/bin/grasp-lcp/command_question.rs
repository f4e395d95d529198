//! The questions of the command line. The numbers of its options become loads in the plane or in space. A base load is constant: it acts before the
//! load of a question grows, and then together with this load.

use crate::arguments::{Command, LoadArguments, Numbers};
use crate::failure::Failure;
use crate::loads::OptionVectors;
use crate::own_masses::{of_own_masses, refuse_mass, tilted};
use crate::scene_loads::{SceneLoads, first_base};
use grasp_lcp::equilibrium::Equilibrium;
use grasp_lcp::improve::{Improve, ImproveGoal};
use grasp_lcp::load_path::Leg;
use grasp_lcp::scene::{Question, Setup};
use grasp_lcp::spatial::{Turn, Wrench};
use grasp_lcp::squeeze::Loads;
use grasp_lcp::words::Words;
use std::collections::BTreeMap;

/// Replaces the scene's questions by the question of the command line. If the command line has no load, the scene's questions of the same kind are
/// kept.
pub(crate) fn put(setup: &mut Setup<3>, asked: &Command) -> Result<(), Failure> {
    let question = question_of(asked, setup)?;
    match question {
        Some(question) => {
            warn_of_load_left_out(setup, &question);
            warn_of_weight_that_grows(setup, asked);
            setup.questions = vec![question];
        }
        None if setup.questions.iter().any(|question| is_of_kind(question, asked)) => {
            setup.questions.retain(|question| is_of_kind(question, asked));
        }
        None => setup.questions = of_the_scene(setup, asked),
    }
    if setup.questions.is_empty()
        && let Some(rest) = at_rest(asked)
    {
        eprintln!(
            "warning: the scene has no such question, and no load is given: what stands at rest is asked"
        );
        setup.questions.push(rest);
    }
    if setup.questions.is_empty() { Err(Failure::Usage(missing(asked))) } else { Ok(()) }
}

/// Warns if a question of the scene has a constant load (base load or load at the start), but `question` has none. `question` is the question of the
/// command line. The answer is then about the load of the command line alone.
fn warn_of_load_left_out(setup: &Setup<3>, question: &Question<3>) {
    let is_own = setup.questions.iter().any(|own| own.loads().is_some() && own.loads() == question.loads());
    if question.base() == Some(Wrench::ZERO)
        && !is_own
        && let Some((number, base)) = first_base(setup)
    {
        let load = setup.words(Words::default()).load(&base);
        eprintln!(
            "warning: the load acts alone, without that at rest of the scene's question {number}, {load}"
        );
    }
}

/// Warns that a multiple of the load multiplies the weight of `--mass`, too, although the user may want only its inertial force to grow. The warning
/// is given if the load has an acceleration and no contact presses without the load. Example: a box on a belt tips over at some acceleration of the
/// belt. If its weight grew with its inertial force, the box might stand at any multiple.
fn warn_of_weight_that_grows(setup: &Setup<3>, asked: &Command) {
    let load = match asked {
        Command::Hold { load, .. } => load,
        Command::Need { need_arguments, .. } => &need_arguments.load,
        _ => return,
    };
    let accelerates = load.acceleration.as_ref().is_some_and(|acceleration| acceleration.0.len() > 1);
    let at_rest =
        || setup.grasp().ok()?.solve(Wrench::ZERO).ok()?.equilibrium().map(Equilibrium::largest_force);
    if load.mass.is_some() && accelerates && at_rest() == Some(0.0) {
        eprintln!(
            "warning: weight and inertia of --mass grow together, and multiples of this load multiply both; to accelerate what stands there already, give its weight as --base and m·a as --force"
        );
    }
}

/// The question of the command line; `None` if it gives nothing to ask, i.e. no load, no quantity for `need` and no table for `identify`.
fn question_of(asked: &Command, setup: &mut Setup<3>) -> Result<Option<Question<3>>, Failure> {
    let words = OptionVectors::of(setup);
    Ok(match asked {
        Command::Hold { load, base, safety, .. } => {
            let asked = &*of_own_masses(load, base.is_some(), setup)?;
            words.hold(asked, base.as_ref(), *safety)?
        }
        Command::Need { need_arguments, .. } => {
            words.need(need_arguments, setup)?.map(|asked| Question::Need(Box::new(asked)))
        }
        Command::Improve { load, base, any_force, at_most, reserve, .. } => {
            let load = &*of_own_masses(load, base.is_some() || any_force.is_some(), setup)?;
            words.improve(load, base.as_ref(), *any_force, *at_most, *reserve)?
        }
        Command::Turn { mass: None, weight: None, at: None, base: None, axis: None, .. }
            if setup.own_mass().is_none()
                || setup.questions.iter().any(|question| is_of_kind(question, asked)) =>
        {
            None
        }
        Command::Solve { load, .. } => {
            let asked = &*of_own_masses(load, false, setup)?;
            let together_with = words.together_with(asked)?;
            words.wrench(asked, false)?.map(|load| Question::Solve { load, together_with })
        }
        Command::Compare { load, base, .. } => {
            let asked = &*of_own_masses(load, base.is_some(), setup)?;
            if !asked.together_with.is_empty() {
                let message = "--together-with: given, must be left out of a comparison";
                return Err(Failure::Usage(message.to_owned()));
            }
            let load = words.wrench(asked, base.is_some())?;
            let base = words.base(base.as_ref(), asked.at.as_ref())?;
            load.map(|load| Question::Compare { base, load })
        }
        Command::Onset { load, .. } => {
            let asked = &*of_own_masses(load, false, setup)?;
            let together_with = words.together_with(asked)?;
            let (base, command_change, joint_change) = (Wrench::ZERO, None, None);
            let along =
                |direction| Question::Onset { base, direction, command_change, joint_change, together_with };
            words.wrench(asked, false)?.map(along)
        }
        Command::Turn { mass, weight, at, base, axis, .. } => {
            refuse_mass(setup, *mass)?;
            let own = if mass.is_none() && weight.is_none() { tilted(setup)? } else { None };
            if own.is_some() && at.is_some() && base.is_none() {
                let message = "--at: must be left out where the bodies turn by their own masses, each of which acts at its own centre";
                return Err(Failure::Usage(message.to_owned()));
            }
            let (weight, centre) = match (weight, mass, own) {
                (_, _, Some(own)) => (own.weight, Some(own.at)),
                (Some(weight), ..) => (weight.along_axes(words.axes, "weight")?, at.clone()),
                (None, Some(mass), _) => (words.weight_of(*mass)?, at.clone()),
                (None, None, _) => return Err(Failure::Usage("--mass is missing, or --weight".to_owned())),
            };
            let turn = words.turn(weight, centre.as_ref(), axis.as_ref())?;
            Some(Question::OnsetOfTurn(
                turn.beside(words.base(base.as_ref(), at.as_ref().or(centre.as_ref()))?),
            ))
        }
        Command::Follow { to, from, at, .. } => words.follow(to, from.as_ref(), at.as_ref())?,
        Command::Shake { shakes, .. } => words.shake(shakes, setup)?,
        Command::Identify { slips, .. } => words.identify(slips, setup)?,
        _ => None,
    })
}

/// The error message if neither the scene nor the command line has a question for the command `asked`.
fn missing(asked: &Command) -> String {
    let say = match asked {
        Command::Compare { .. } | Command::Onset { .. } => "--mass, --force or --moment",
        Command::Need { .. } => "what is needed, such as `squeeze --mass 0.4`",
        Command::Improve { .. } => "--mass, --force or --any-force",
        Command::Turn { .. } => "--mass or --weight",
        Command::Follow { .. } => "--to",
        Command::Identify { .. } => "a table of slips behind the scene",
        Command::Shake { .. } => "--force, or --mass and --acceleration",
        _ => {
            return "the scene asks nothing: use `hold`, `need`, `improve`, `onset`, `solve`, `compare`, `turn`, `follow` or `shake` with a load".to_owned();
        }
    };
    format!("the scene has no such question: say {say}")
}

/// For the command `hold` and a scene with a question `need`: the questions whether the grasp holds the loads of this question, one for each load.
/// Otherwise an empty list.
fn of_the_scene(setup: &Setup<3>, asked: &Command) -> Vec<Question<3>> {
    let is_needed =
        |question: &Question<3>| matches!(question, Question::Need(_)) && question.loads().is_some();
    let is_held = matches!(asked, Command::Hold { .. }) && setup.questions.iter().any(is_needed);
    match is_held.then(|| SceneLoads::of(setup)).flatten() {
        Some(SceneLoads { base, loads: Loads::Each(list), together_with }) => {
            let hold = |load| Question::Hold { base, load, together_with: together_with.clone() };
            list.into_iter().map(hold).collect()
        }
        _ => Vec::new(),
    }
}

/// The question whether the object is in equilibrium without any load. It is asked if neither the command line nor the scene has a question. `None`
/// unless the command is `hold` or `solve`.
fn at_rest(asked: &Command) -> Option<Question<3>> {
    let (load, together_with) = (Wrench::ZERO, BTreeMap::new());
    match asked {
        Command::Hold { .. } => Some(Question::Hold { base: Wrench::ZERO, load, together_with }),
        Command::Solve { .. } => Some(Question::Solve { load, together_with }),
        _ => None,
    }
}

fn is_of_kind(question: &Question<3>, asked: &Command) -> bool {
    matches!(
        (asked, question),
        (Command::Ask(_), _)
            | (Command::Hold { .. }, Question::Hold { .. })
            | (Command::Need { .. }, Question::Need(_))
            | (Command::Improve { .. }, Question::Improve(_))
            | (Command::Solve { .. }, Question::Solve { .. })
            | (Command::Compare { .. }, Question::Compare { .. })
            | (Command::Onset { .. }, Question::Onset { .. })
            | (Command::Turn { .. }, Question::OnsetOfTurn(_))
            | (Command::Follow { .. }, Question::Follow { .. })
            | (Command::Identify { .. }, Question::Identify(_))
            | (Command::Shake { .. }, Question::Shake { .. } | Question::Shakedown { .. })
    )
}

impl OptionVectors {
    /// The sum of three loads as a wrench about the origin: the force `--force`, the moment `--moment`, and the weight and inertial force of the mass
    /// `--mass`. The inertial force is minus mass times acceleration. `None` if none of these options is given. `beside` is true if another option
    /// gives a force at the point `--at`: then `--at` is allowed without `--force` and `--mass`, otherwise it is an error.
    pub(crate) fn wrench(self, load: &LoadArguments, beside: bool) -> Result<Option<Wrench>, Failure> {
        let LoadArguments { force, moment, at, mass, .. } = load;
        if force.is_none() && mass.is_none() && at.is_some() && !beside {
            return Err(Failure::Usage("--at without --force or --mass: a moment acts anywhere".to_owned()));
        }
        let mut all = Wrench::ZERO;
        if let Some(force) = force {
            all = self.push(force, "force", at.as_ref())?;
        }
        if mass.is_some() {
            all = all + self.pull_of_mass(load)?;
        }
        if let Some(moment) = moment {
            all = all + Wrench::new([0.0; 3], self.about_axes(moment, "moment")?);
        }
        Ok((force.is_some() || moment.is_some() || mass.is_some()).then_some(all))
    }

    /// Loads on other bodies that grow in proportion to the load of the command line.
    pub(crate) fn together_with(self, load: &LoadArguments) -> Result<BTreeMap<String, Wrench>, Failure> {
        if !load.together_with.is_empty()
            && load.force.is_none()
            && load.moment.is_none()
            && load.mass.is_none()
        {
            let message =
                "--together-with without --force, --moment or --mass: there is no load to grow with";
            return Err(Failure::Usage(message.to_owned()));
        }
        let mut all = BTreeMap::new();
        for push in &load.together_with {
            let wrench = self.push(&push.force, "together-with", push.at.as_ref())?;
            let sum = all.entry(push.body.clone()).or_insert(Wrench::ZERO);
            *sum = *sum + wrench;
        }
        Ok(all)
    }

    /// The question whether the grasp holds a load multiplied by `safety`; if there is only a base load, whether the grasp holds the base load.
    fn hold(
        self,
        load: &LoadArguments,
        base: Option<&Numbers>,
        safety: Option<f64>,
    ) -> Result<Option<Question<3>>, Failure> {
        let wrench = self.wrench(load, base.is_some())?;
        let (wrench, times) = match (wrench, safety) {
            (None, Some(_)) => {
                let message = "--safety: of a load, say --mass, --force or --moment";
                return Err(Failure::Usage(message.to_owned()));
            }
            (wrench, times) => (wrench.or(base.map(|_| Wrench::ZERO)), times.unwrap_or(1.0)),
        };
        let (base, mut together_with) = (self.base(base, load.at.as_ref())?, self.together_with(load)?);
        for load in together_with.values_mut() {
            *load = *load * times;
        }
        Ok(wrench.map(|load| Question::Hold { base, load: load * times, together_with }))
    }

    /// The question `improve`. `None` if the command line gives no load: the caller then asks the scene's own questions. Options that need a load are
    /// an error without one.
    fn improve(
        self,
        load: &LoadArguments,
        base: Option<&Numbers>,
        any_force: Option<f64>,
        at_most: Option<f64>,
        reserve: bool,
    ) -> Result<Option<Question<3>>, Failure> {
        if !load.together_with.is_empty() {
            let message = "--together-with: given, must be left out where fingers are improved";
            return Err(Failure::Usage(message.to_owned()));
        }
        let wrench = self.wrench(load, base.is_some() || any_force.is_some())?;
        if wrench.is_none() && any_force.is_none() {
            let given = base.is_some() || at_most.is_some() || reserve;
            let missing =
                "say which load is to slide late: --mass, --force, --moment or --any-force".to_owned();
            return if given { Err(Failure::Usage(missing)) } else { Ok(None) };
        }
        let loads = self.loads(wrench, any_force, load.at.as_ref())?;
        let mut question = Improve::new(loads).on_top_of(self.base(base, load.at.as_ref())?);
        if let Some(force) = at_most {
            question = question.pressing_at_most(force);
        }
        if reserve {
            question = question.with_goal(ImproveGoal::Reserve);
        }
        Ok(Some(Question::Improve(Box::new(question))))
    }

    /// The wrench of a force that acts at the point `at`, or at the origin without it; `option` is the option that an error names.
    pub(crate) fn push(self, force: &Numbers, option: &str, at: Option<&Numbers>) -> Result<Wrench, Failure> {
        Ok(Wrench::force_at(force.along_axes(self.axes, option)?, self.point(at)?))
    }

    /// The constant load of the option `--base`; zero without this option.
    pub(crate) fn base(self, base: Option<&Numbers>, at: Option<&Numbers>) -> Result<Wrench, Failure> {
        base.map_or(Ok(Wrench::ZERO), |base| self.push(base, "base", at))
    }

    fn follow(
        self,
        to: &[Numbers],
        from: Option<&Numbers>,
        at: Option<&Numbers>,
    ) -> Result<Option<Question<3>>, Failure> {
        if to.is_empty() {
            let missing = from.map_or(Ok(None), |_| Err(Failure::Usage("--from without --to".to_owned())));
            return missing;
        }
        let start = from.map_or(Ok(Wrench::ZERO), |from| self.push(from, "from", at))?;
        let leg = |force| self.push(force, "to", at).map(Leg::load_to);
        let legs = to.iter().map(leg).collect::<Result<_, _>>()?;
        Ok(Some(Question::Follow { start, legs, in_steps: None }))
    }

    /// The turning load of a tilted grasp: `weight`, N, acts at the point `at`. In space the grasp is tilted about `axis`. In the plane it is tilted
    /// from x to y (anticlockwise), but clockwise if `axis` is 0,0,-1.
    pub(crate) fn turn(
        self,
        weight: [f64; 3],
        at: Option<&Numbers>,
        axis: Option<&Numbers>,
    ) -> Result<Turn, Failure> {
        let axis = match (self.axes, axis) {
            (2, Some(Numbers(axis))) => match axis[..] {
                [x, y, z] if x == 0.0 && y == 0.0 && z != 0.0 => [0.0, 0.0, z.signum()],
                _ => {
                    let message =
                        "--axis: in the plane it must be 0,0,1 for anticlockwise or 0,0,-1 for clockwise";
                    return Err(Failure::Usage(message.to_owned()));
                }
            },
            (2, None) => [0.0, 0.0, 1.0],
            (_, Some(axis)) => self.direction(axis, "axis")?,
            (_, None) => {
                let message = "--axis is missing: about which the grasp is tilted, such as --axis 1,0,0";
                return Err(Failure::Usage(message.to_owned()));
            }
        };
        Ok(Turn::tilting(weight, self.point(at)?, axis)?)
    }
}
