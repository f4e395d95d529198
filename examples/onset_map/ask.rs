//! The question that is asked for every direction, and its answer.

use grasp_lcp::grasp::{Grasp, Wrench};
use grasp_lcp::load_path::{Departure, Onset, Ramp};
use grasp_lcp::scene::{Question, Setup};
use grasp_lcp::{Error, Settings};

use crate::Failure;

/// Where the force acts: numbers between commas, or the origin.
pub(crate) fn point<const C: usize>(text: Option<&str>) -> Result<[f64; C], Failure> {
    let Some(text) = text else { return Ok([0.0; C]) };
    let numbers: Option<Vec<f64>> =
        text.split(',').map(|number| number.trim().parse().ok().filter(|x: &f64| x.is_finite())).collect();
    let point = numbers.and_then(|numbers| <[f64; C]>::try_from(numbers).ok());
    point.ok_or_else(|| format!("--at {text}: must be {C} finite numbers with commas between them").into())
}

/// The load on top of which the force comes.
pub(crate) fn base<const D: usize, const W: usize, const C: usize>(setup: &Setup<D, C>) -> Wrench<W, C> {
    let asked = setup.questions.iter().find_map(|question| match question {
        Question::Onset(ramp) => Some(setup.load(&ramp.base)),
        _ => None,
    });
    asked.unwrap_or(Wrench::ZERO)
}

/// More contacts that leave together are counted.
const MANY: usize = 4;

/// When something leaves rolling in one direction.
pub(crate) struct First {
    /// N; infinite for never, not a number where that is not known.
    pub(crate) factor: f64,
    /// The contacts that leave, and how.
    pub(crate) who: String,
}

/// Settings for many directions: where no equilibrium is found none is sought among all combinations of contact states.
pub(crate) fn quick(settings: &Settings) -> Settings {
    (*settings).with_most_states(0)
}

pub(crate) fn first<const D: usize, const C: usize>(
    grasp: &Grasp<D, C>,
    settings: &Settings,
    ramp: &Ramp<D, C>,
) -> Result<First, Error> {
    Ok(match grasp.onset_with(ramp, settings)? {
        Onset::At(event) => {
            let who = event.leaving.iter().map(|leaving| {
                let does = if matches!(leaving.how, Departure::Opens) { "opens" } else { "slides" };
                format!("{} {does}", grasp.contacts()[leaving.contact].label_text(leaving.contact))
            });
            let drives = event.drives.iter().map(|(part, _)| format!("{} gives way", grasp.label_of(*part)));
            let mut who: Vec<_> = who.chain(drives).collect();
            // Points of a soft fingertip leave by the dozen.
            if who.len() > MANY {
                let others = who.len() - 1;
                who = vec![format!("{} and {others} others", who[0])];
            }
            First { factor: event.factor, who: who.join(", ") }
        }
        Onset::Never => First { factor: f64::INFINITY, who: "never".to_owned() },
        Onset::GivesWay { factor, .. } => First { factor, who: "nothing resists".to_owned() },
        _ => First { factor: f64::NAN, who: "not known".to_owned() },
    })
}

/// An error, with its reason, where there is no rolling equilibrium to start from: no direction has an onset then.
pub(crate) fn check_base<const D: usize, const W: usize, const C: usize>(
    grasp: &Grasp<W, C>,
    setup: &Setup<D, C>,
    ramp: &Ramp<W, C>,
) -> Result<(), Failure> {
    match grasp.onset_with(ramp, &setup.settings)? {
        Onset::NoBase(none) => {
            Err(format!("no equilibrium exists under the base load: {:?}", none.proof).into())
        }
        Onset::AlreadySliding(_) => {
            Err("something slides already under the base load: there is no onset to map".into())
        }
        Onset::Undecided(undecided) => {
            Err(format!("the equilibrium under the base load is undecided: {:?}", undecided.doubt).into())
        }
        _ => Ok(()),
    }
}

/// Lines that say where the force acts, and on top of what.
pub(crate) fn words<const D: usize, const C: usize>(at: [f64; C], base: &Wrench<D, C>) -> Vec<String> {
    let point = at.map(|x| x.to_string()).join(", ");
    let load = base.as_vector();
    let mut lines = vec![format!("Force at ({point}) m")];
    if load.iter().any(|x| *x != 0.0) {
        let load: Vec<_> = load.iter().map(ToString::to_string).collect();
        lines.push(format!("on top of ({}) N, N m", load.join(", ")));
    } else {
        lines.push("no other load".to_owned());
    }
    lines
}
