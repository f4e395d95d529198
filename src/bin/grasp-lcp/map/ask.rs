//! The question that is asked for every direction, and its answer.

use grasp_lcp::Error;
use grasp_lcp::load_path::{Leaving, Onset, Ramp};
use grasp_lcp::scene::{Question, Setup};
use grasp_lcp::squeeze::WeakestDirection;
use grasp_lcp::words::Words;
use grasp_lcp::{ask::Grasp, grasp::Wrench};

use crate::failure::Failure;

/// The load on top of which the force comes.
pub(crate) fn base<const C: usize>(setup: &Setup<C>) -> Wrench<C> {
    let asked = setup.questions.iter().find_map(|question| match question {
        Question::Onset(ramp) => Some(ramp.base),
        _ => None,
    });
    asked.unwrap_or(Wrench::ZERO)
}

/// More contacts that leave together are counted.
const MANY: usize = 4;

/// When something stops sticking in one direction.
pub(crate) struct First {
    /// N; infinite for never, not a number where that is not known.
    pub(crate) factor: f64,
    /// The contacts that leave, and how.
    pub(crate) who: String,
}

impl First {
    fn told(factor: f64, who: &str) -> Self {
        Self { factor, who: who.to_owned() }
    }
}

/// The direction in which the least force stops sticking, with its size, N. `None` where something does not touch under the base load.
pub(crate) fn weakest<const C: usize>(
    grasp: &Grasp<C>,
    base: &Wrench<C>,
    at: [f64; C],
) -> Result<Option<([f64; C], f64)>, Error> {
    Ok(match grasp.weakest_direction(base, at)? {
        WeakestDirection::Force { size, direction, .. } => Some((direction, size)),
        _ => None,
    })
}

/// The grasp asked in many directions: where no equilibrium is found none is sought among all combinations of contact states.
pub(crate) fn quick<const C: usize>(grasp: &Grasp<C>) -> Grasp<C> {
    grasp.with(&grasp.settings().with_most_states(0))
}

/// What leaves first along a ramp.
pub(crate) fn first<const C: usize>(grasp: &Grasp<C>, ramp: &Ramp<C>) -> Result<First, Error> {
    Ok(match grasp.onset(ramp)? {
        Onset::At(event) => {
            let mut verbs: Vec<_> = event.leaving.iter().map(Leaving::verb).collect();
            verbs.sort_unstable();
            verbs.dedup();
            // Points of a soft fingertip leave by the dozen, and are one contact.
            let who = verbs.into_iter().rev().flat_map(|verb| {
                let does = |i: usize| {
                    event.leaving.iter().any(|left| left.contact.index == i && left.verb() == verb)
                };
                grasp.whole_contacts(does).into_iter().map(move |part| format!("{part} {verb}"))
            });
            let drives = event.drives.iter().map(|drive| format!("{} gives way", drive.part.text()));
            let mut who: Vec<_> = who.chain(drives).collect();
            if who.len() > MANY {
                let others = who.len() - 1;
                who = vec![format!("{} and {others} others", who[0])];
            }
            First { factor: event.factor, who: who.join(", ") }
        }
        Onset::Never => First::told(f64::INFINITY, "never"),
        Onset::GivesWay { factor, .. } => First::told(factor, "nothing resists"),
        _ => First::told(f64::NAN, "not known"),
    })
}

/// An error, with its reason, where there is no sticking equilibrium to start from: no direction has an onset then.
pub(crate) fn check_base<const C: usize>(grasp: &Grasp<C>, ramp: &Ramp<C>) -> Result<(), Failure> {
    match grasp.onset(ramp)? {
        Onset::NoBase(none) => {
            Err(Failure::Scene(format!("no equilibrium exists under the base load: {}", none.proof)))
        }
        Onset::AlreadySliding(_) => Err(Failure::Scene(
            "something slides already under the base load: there is no onset to map".to_owned(),
        )),
        Onset::Undecided(undecided) => Err(Failure::Scene(format!(
            "the equilibrium under the base load is undecided: {}",
            undecided.doubt
        ))),
        _ => Ok(()),
    }
}

/// Lines that say where the force acts, and on top of what.
pub(crate) fn words<const C: usize>(at: [f64; C], base: &Wrench<C>) -> Vec<String> {
    let point = at.map(|x| x.to_string()).join(", ");
    let load = base.components();
    let mut lines = vec![format!("Force at ({point}) m")];
    if load.iter().any(|x| *x != 0.0) {
        lines.push(format!("on top of {}", Words::default().load(base)));
    } else {
        lines.push("no other load".to_owned());
    }
    lines
}

/// Of a map that nobody waits for.
pub(crate) fn too_long() -> Failure {
    Failure::Scene("a map of so many contacts takes more than five minutes".to_owned())
}
