//! Loads of the scene's questions, for a question of the command line that has no load.

use std::collections::BTreeMap;

use grasp_lcp::grasp::Wrench;
use grasp_lcp::need::{Need, Quantity};
use grasp_lcp::squeeze::Loads;
use grasp_lcp::words::Words;

use crate::arguments::{NeedArguments, SoughtQuantity};
use crate::failure::Failure;
use grasp_lcp::scene::{Question, Setup};

/// The loads of a scene's question: the constant load, the loads added to it, and loads on other bodies in proportion to the added loads.
pub(crate) struct SceneLoads {
    pub(crate) base: Wrench<3>,
    pub(crate) loads: Loads<3>,
    pub(crate) together_with: BTreeMap<String, Wrench<3>>,
}

impl SceneLoads {
    /// The loads of the scene's first question `need`. If the scene has no question `need`, the loads of several questions `hold` are taken. These
    /// are all questions `hold` that have the same constant load as the first `hold`, and no loads on other bodies. If it has no question `hold`
    /// either, the load of its first question `solve` is taken. Questions whose loads are zero come after all others. A warning says which loads are
    /// taken. `None` without any of these questions.
    pub(crate) fn of(setup: &Setup<3>) -> Option<Self> {
        let kinds: [fn(&Question<3>) -> bool; 3] = [
            |question| matches!(question, Question::Need(_)),
            |question| matches!(question, Question::Hold { .. }),
            |question| matches!(question, Question::Solve { .. }),
        ];
        let questions = || setup.questions.iter().enumerate();
        let first_of = |acts: bool| {
            kinds.iter().find_map(|is| {
                questions().find_map(|(k, question)| {
                    let is_meant = |loads: &(_, Loads<3>, _)| is(question) && acts != is_zero(&loads.1);
                    question.loads().filter(is_meant).zip(Some(k))
                })
            })
        };
        let ((base, mut loads, together_with), first) = first_of(true).or_else(|| first_of(false))?;
        let is_alone = |question: &Question<3>| match question {
            Question::Hold { base: other, load, together_with } => {
                (*other == base && together_with.is_empty()).then_some(*load)
            }
            _ => None,
        };
        let alike: Vec<_> = setup.questions.iter().filter_map(is_alone).collect();
        if is_alone(&setup.questions[first]).is_some() && alike.len() > 1 {
            eprintln!(
                "warning: no load is given: those of the scene's questions `hold` are taken, one at a time"
            );
            loads = alike.into();
        } else {
            let which = in_words(setup.words(Words::default()), &loads);
            eprintln!(
                "warning: no load is given: that of the scene's question {} is taken, {which}",
                first + 1
            );
        }
        Some(Self { base, loads, together_with: together_with.clone() })
    }
}

/// Loads as text: "(0, -4.905) N and 0.2 N m". Moments are about the origin.
fn in_words(words: Words, loads: &Loads<3>) -> String {
    match loads {
        Loads::Each(list) => list.iter().map(|load| words.load(load)).collect::<Vec<_>>().join("; "),
        Loads::AnyForce { size, .. } => format!("{size} N in any direction"),
        _ => "which turns".to_owned(),
    }
}

/// The load beside which a force of any direction acts.
///
/// # Errors
/// If there are several loads, or one that turns.
pub(crate) fn single_load(loads: &Loads<3>) -> Result<Wrench<3>, Failure> {
    match loads {
        Loads::Each(list) if list.len() == 1 => Ok(list[0]),
        Loads::AnyForce { base, .. } => Ok(*base),
        _ => {
            let message = "--any-force: the scene's questions have several loads or one that turns: say beside which the force acts, such as --force 0,-5";
            Err(Failure::Usage(message.to_owned()))
        }
    }
}

/// Whether these are forces and moments of zero.
fn is_zero(loads: &Loads<3>) -> bool {
    matches!(loads, Loads::Each(list) if list.iter().all(|load| *load == Wrench::ZERO))
}

/// The first nonzero constant load (base load or load at the start) of the scene's questions. It comes with the number of its question, from 1.
pub(crate) fn first_base<const C: usize>(setup: &Setup<C>) -> Option<(usize, Wrench<C>)> {
    let bases = setup.questions.iter().map(Question::base);
    let is_loaded = |base: Option<Wrench<C>>| base.filter(|base| *base != Wrench::ZERO);
    bases.zip(1..).find_map(|(base, number)| Some((number, is_loaded(base)?)))
}

/// The scene's own question `need` for the sought quantity. `None` if the scene has no such question, or if the command line gives a load or another
/// option in place of the question's data.
pub(crate) fn own_need(
    setup: &Setup<3>,
    need_arguments: &NeedArguments,
    sought: SoughtQuantity,
) -> Option<Need<3>> {
    let given = [
        &need_arguments.load.force,
        &need_arguments.load.moment,
        &need_arguments.load.acceleration,
        &need_arguments.base,
    ];
    let others = [&need_arguments.along, &need_arguments.axis, &need_arguments.load.at];
    let is_given = given.iter().chain(&others).any(|given| given.is_some())
        || need_arguments.load.mass.is_some()
        || need_arguments.any_force.is_some();
    if is_given || need_arguments.contact.is_some() || need_arguments.of.is_some() {
        return None;
    }
    let quantity = match sought {
        SoughtQuantity::Squeeze => Quantity::Squeeze,
        SoughtQuantity::Friction => Quantity::Friction,
        SoughtQuantity::Load => Quantity::Load,
        SoughtQuantity::Arm => Quantity::Arm,
        SoughtQuantity::Angle => Quantity::Angle,
        SoughtQuantity::Force => Quantity::Force,
    };
    setup.questions.iter().find_map(|question| match question {
        Question::Need(asked) if asked.quantity() == quantity => Some((**asked).clone()),
        _ => None,
    })
}
