//! The states of a grasp that a picture shows for a question.

use grasp_lcp::ask::Grasp;
use grasp_lcp::equilibrium::{Equilibrium, Outcome};
use grasp_lcp::grasp::{Motion, Wrench};
use grasp_lcp::hold::Verdict;
use grasp_lcp::improve::{Improve, ImproveGoal};
use grasp_lcp::load_path::{Event, Leg, Onset, PathEnd};
use grasp_lcp::need::{Amount, Need};
use grasp_lcp::scene::{Question, Setup};
use grasp_lcp::shake::Shaken;
use grasp_lcp::words::Words;

use crate::failure::Failure;
use crate::words::NO_WORDS;

/// One answer in a picture.
pub(super) struct Shown<const C: usize> {
    pub(super) label: String,
    pub(super) says: Vec<String>,
    /// The grasp of the answer if it differs from that of the scene.
    pub(super) grasp: Option<Grasp<C>>,
    pub(super) what: What<C>,
}

/// The content of a picture.
pub(super) enum What<const C: usize> {
    /// An equilibrium, and the motion of the object as it is lost, if it is.
    State { state: Box<Equilibrium<C>>, leaving: Option<Motion<C>> },
    /// The reason why there is no equilibrium, and the load.
    Nothing { why: String, load: Option<Wrench<C>> },
}

/// The answers to one question; of a program one for each event, and its end.
pub(super) struct ShownAnswers<const C: usize>(pub(super) Vec<Shown<C>>);

impl<const C: usize> ShownAnswers<C> {
    /// The answers that represent the question, and the ends of their pictures' names: the first of a hold, the last of a program. Improved fingers
    /// also have a picture of the grasp before.
    pub(super) fn keys(&self) -> Vec<(usize, &'static str)> {
        let begins = |shown: &Shown<C>, with| shown.label.starts_with(with);
        let key = self.0.first().map(|first| if begins(first, EVENT_LABEL) { self.0.len() - 1 } else { 0 });
        let before = self.0.iter().position(|shown| begins(shown, BEFORE_LABEL)).filter(|k| Some(*k) != key);
        key.map(|key| (key, "")).into_iter().chain(before.map(|before| (before, "_before"))).collect()
    }
}

/// The beginning of labels of events.
const EVENT_LABEL: &str = "leg ";
/// The label of a grasp before its improvement.
const BEFORE_LABEL: &str = "before";

/// The answers to show for a question.
pub(super) fn shown<const C: usize>(
    setup: &Setup<C>,
    grasp: &Grasp<C>,
    question: &Question<C>,
) -> Result<ShownAnswers<C>, Failure> {
    let grasp = &setup.grasp_of(grasp, question)?;
    Ok(ShownAnswers(match &*setup.meant(question)? {
        Question::Hold { .. } => {
            let ramp = question.ramp()?;
            held(grasp.hold(ramp.clone())?, ramp.load_at(1.0))
        }
        Question::Need(asked) => vec![needed(grasp, asked)?],
        Question::Improve(asked) => improved(setup, grasp, asked)?,
        Question::Solve { load, .. } => vec![solved(grasp, load)?],
        Question::Compare { base, load } => {
            let (load, compared) = (*base + *load, grasp.energy().compare(*base + *load)?);
            let says = compared.to_string();
            vec![match compared.equilibrium {
                Outcome::Equilibrium(found) => Shown { says: vec![says], ..state("under the load", *found) },
                none => {
                    Shown { says: vec![says], ..nothing("under the load", no_equilibrium(&none), Some(load)) }
                }
            }]
        }
        Question::Onset { .. } => {
            let ramp = question.ramp()?;
            let at = |factor: f64| format!("factor {}", Words::default().number(factor));
            vec![onset(grasp, grasp.onset(&ramp)?, &ramp.load_at(0.0), Leg::along(&ramp), &at)?]
        }
        Question::OnsetOfTurn(turn) => {
            let at = |angle: f64| format!("turned by {}", Words::default().angle(angle));
            let onset_of_turn = grasp.onset_of_turn(turn)?.onset;
            vec![onset(grasp, onset_of_turn, &turn.load_at(0.0), Leg::turn(turn), &at)?]
        }
        Question::Follow { start, legs, in_steps: None } => followed(grasp, start, legs)?,
        Question::Follow { start, legs, in_steps: Some(error) } => {
            let mut path = grasp.follow_in_steps(start, legs, *error)?;
            path.by_ref().for_each(drop);
            vec![last(path.state(), path.place(), path.end(), start)]
        }
        Question::Shake { base, .. } => shaken(grasp.shake(base, &question.legs()?)?),
        Question::Shakedown { base, loads } => {
            let found = grasp.statics().shakedown(base, loads)?;
            let says = found.map_or_else(|| NO_WORDS.to_owned(), |found| found.to_string());
            let mut at_rest = solved(grasp, base)?;
            "at rest".clone_into(&mut at_rest.label);
            at_rest.says.push(says);
            vec![at_rest]
        }
        _ => vec![nothing("no picture", NO_WORDS.to_owned(), None)],
    }))
}

fn nothing<const C: usize>(label: &str, why: String, load: Option<Wrench<C>>) -> Shown<C> {
    Shown { label: label.to_owned(), says: Vec::new(), grasp: None, what: What::Nothing { why, load } }
}

fn state<const C: usize>(label: impl Into<String>, state: Equilibrium<C>) -> Shown<C> {
    let what = What::State { state: Box::new(state), leaving: None };
    Shown { label: label.into(), says: Vec::new(), grasp: None, what }
}

/// The grasp under the load, or where it is lost with the motion of the object. The loss beyond the load comes second.
fn held<const C: usize>(verdict: Verdict<C>, load: Wrench<C>) -> Vec<Shown<C>> {
    let says = verdict.to_string();
    let lost = verdict.lost.and_then(|lost| {
        let mut shown = state("where it is lost", *lost.state?);
        if let What::State { leaving, .. } = &mut shown.what {
            *leaving = lost.motion;
        }
        Some(shown)
    });
    let under = verdict.state.map(|found| state("under the load", *found));
    let mut answers: Vec<_> = under.into_iter().chain(lost).collect();
    match answers.first_mut() {
        Some(first) => first.says.push(says),
        None => answers.push(nothing("does it hold?", says, Some(load))),
    }
    answers
}

/// The grasp between two cycles, with the motion of the object in each cycle.
fn shaken<const C: usize>(shaken: Shaken<C>) -> Vec<Shown<C>> {
    let (says, drift, base) = (shaken.to_string(), shaken.drift(), shaken.base);
    let Some(between) = shaken.state else { return vec![nothing("does it survive?", says, Some(base))] };
    let mut shown = state("between two cycles", *between);
    if let What::State { leaving, .. } = &mut shown.what {
        *leaving = drift;
    }
    shown.says.push(says);
    vec![shown]
}

/// The grasp with the needed amount, under the load that uses most of it.
fn needed<const C: usize>(grasp: &Grasp<C>, need: &Need<C>) -> Result<Shown<C>, Failure> {
    let needed = grasp.need(need)?;
    let says = needed.to_string();
    let (amount, label) = match &needed.amount {
        Amount::Bound { does, .. } => (Some(*does), "with what it needs"),
        Amount::Any { to, .. } => (Some(*to), "with an amount that does"),
        _ => (None, "what does it need?"),
    };
    let found = amount.map(|amount| grasp.with_amount(need, amount)).transpose()?.flatten();
    Ok(match found {
        Some((other, found)) => Shown { grasp: Some(other), says: vec![says], ..state(label, found) },
        None => nothing(label, says, need.given_load()),
    })
}

/// The improved grasp and the original one. Each is at its first slip along the load, under the load that leaves a reserve, or else at rest.
fn improved<const C: usize>(
    setup: &Setup<C>,
    grasp: &Grasp<C>,
    asked: &Improve<C>,
) -> Result<Vec<Shown<C>>, Failure> {
    let improved = grasp.improve(&setup.improve(asked)?)?;
    let says = improved.to_string();
    let base = asked.base();
    let (times, when): (fn(f64) -> f64, _) = match improved.goal {
        ImproveGoal::Reserve => (|_| 1.0, "under the load"),
        // At first slip itself, rounding would decide whether a contact slides.
        _ => (|factor| factor * (1.0 - 1e-9), "at first slip"),
    };
    let seen = |grasp: &Grasp<C>, label: &str, value: Option<f64>| {
        let at = asked
            .load()
            .zip(value.filter(|value| value.is_finite()))
            .map(|(load, value)| base + load * times(value));
        let mut shown = solved(grasp, &at.unwrap_or(base))?;
        shown.label = format!("{label}, {}", if at.is_some() { when } else { "at rest" });
        Ok::<_, Failure>(shown)
    };
    let before = seen(grasp, BEFORE_LABEL, improved.before)?;
    if improved.after.is_none() {
        return Ok(vec![Shown { says: vec![says], ..before }]);
    }
    let other = improved.placed(grasp)?;
    let after = seen(&other, "after", improved.after)?;
    Ok(vec![Shown { grasp: Some(other), says: vec![says], ..after }, before])
}

/// The equilibrium, or the reason why there is none and the answer from rest.
fn solved<const C: usize>(grasp: &Grasp<C>, load: &Wrench<C>) -> Result<Shown<C>, Failure> {
    let why = match grasp.solve(load)? {
        Outcome::Equilibrium(found) => return Ok(state("under the load", *found)),
        none => no_equilibrium(&none),
    };
    let from_rest = held(grasp.hold(*load)?, *load).into_iter().next();
    Ok(match from_rest {
        Some(mut shown) if matches!(shown.what, What::State { .. }) => {
            shown.label = format!("put on from rest, {}", shown.label);
            shown.says.insert(0, why);
            shown
        }
        _ => nothing("under the load", why, Some(*load)),
    })
}

/// The reason why there is no equilibrium.
fn no_equilibrium<const C: usize>(outcome: &Outcome<C>) -> String {
    match outcome {
        Outcome::NoEquilibrium(none) => format!("No equilibrium exists: {none}."),
        Outcome::Undecided(undecided) => {
            format!("Undecided: no equilibrium was found and none was ruled out ({}).", undecided.doubt)
        }
        _ => NO_WORDS.to_owned(),
    }
}

/// The grasp at first slip; at the end of the path if nothing slides.
fn onset<const C: usize>(
    grasp: &Grasp<C>,
    onset: Onset<C>,
    start: &Wrench<C>,
    leg: Leg<C>,
    at: &dyn Fn(f64) -> String,
) -> Result<Shown<C>, Failure> {
    let label = match onset {
        Onset::At(event) => {
            let inaccurate = "the equilibrium at the onset is not accurate enough to be drawn";
            let label = format!("onset of sliding, {}", at(event.factor));
            return Ok(match grasp.state_at_onset(&event) {
                Some(found) => state(label, found),
                None => nothing(&label, inaccurate.to_owned(), Some(event.load)),
            });
        }
        Onset::AlreadySliding(found) => return Ok(state("something slides from the start on", *found)),
        Onset::NoBase(none) => {
            let why = format!("No equilibrium exists at the start: {none}.");
            return Ok(nothing("onset of sliding", why, Some(*start)));
        }
        Onset::Undecided(undecided) => {
            let why = format!("Undecided at the start ({}).", undecided.doubt);
            return Ok(nothing("onset of sliding", why, Some(*start)));
        }
        Onset::GivesWay { factor, .. } => format!("nothing slides, but it gives way, {}", at(factor)),
        _ => "nothing slides on the way".to_owned(),
    };
    let mut path = grasp.follow(start, &[leg])?;
    path.run();
    Ok(end(path.state(), path.end(), &label)
        .unwrap_or_else(|| nothing("onset of sliding", label, Some(*start))))
}

/// The events of a program, and its end.
fn followed<const C: usize>(
    grasp: &Grasp<C>,
    start: &Wrench<C>,
    legs: &[Leg<C>],
) -> Result<Vec<Shown<C>>, Failure> {
    let mut path = grasp.follow(start, legs)?;
    let events = path.run();
    let mut answers: Vec<_> = events.into_iter().map(|event| changed(grasp, event)).collect();
    answers.push(last(path.state(), path.place(), path.end(), start));
    Ok(answers)
}

/// The end of a program at a leg and a fraction of it.
fn last<const C: usize>(
    there: Option<Equilibrium<C>>,
    (leg, fraction): (usize, f64),
    ended: Option<&PathEnd<C>>,
    start: &Wrench<C>,
) -> Shown<C> {
    let (how, why) = match ended {
        Some(PathEnd::Completed) => ("all legs are held to their end", String::new()),
        Some(PathEnd::Lost(loss)) => ("lost", format!("Lost: {}.", loss.kind)),
        Some(PathEnd::NoStart(start)) => ("nothing to start from", no_equilibrium(start)),
        Some(PathEnd::Undecided { doubt, .. }) => ("what comes next is undecided", doubt.to_string()),
        _ => ("the path's end", String::new()),
    };
    let label = format!("{EVENT_LABEL}{leg} at {}: {how}", Words::default().number(fraction));
    let Some(mut shown) = end(there, ended, &label) else { return nothing(&label, why, Some(*start)) };
    shown.says.extend(Some(why).filter(|why| !why.is_empty()));
    shown
}

/// The equilibrium at an event, with the contacts that change their state there.
fn changed<const C: usize>(grasp: &Grasp<C>, event: Event<C>) -> Shown<C> {
    let parts = grasp.whole_contacts(|i| event.changes.iter().any(|change| change.contact.index == i));
    let drives = event.drives.iter().map(|drive| drive.part.text());
    let names: Vec<_> = parts.iter().map(ToString::to_string).chain(drives).collect();
    let what = if names.is_empty() {
        "a motion is free".to_owned()
    } else {
        format!("{} changes", names.join(", "))
    };
    state(
        format!("{EVENT_LABEL}{} at {}: {what}", event.leg, Words::default().number(event.fraction)),
        event.state,
    )
}

/// The end of a path, with the motion of the object if it is lost.
fn end<const C: usize>(
    there: Option<Equilibrium<C>>,
    ended: Option<&PathEnd<C>>,
    label: &str,
) -> Option<Shown<C>> {
    let mut shown = state(label, there?);
    if let What::State { leaving, .. } = &mut shown.what {
        *leaving = ended.and_then(PathEnd::loss).and_then(|loss| loss.motion.clone());
    }
    Some(shown)
}
