//! The equilibria that pictures show for an answer; the grasp alone if the answer has no equilibrium. The base load acts before the load of the
//! question grows. First slip is the event at which the first contact ceases to stick. A drive is the spring of a joint or tendon of a hand, with its
//! force limit.

use grasp_lcp::ask::Grasp;
use grasp_lcp::equilibrium::{Equilibrium, Outcome};
use grasp_lcp::grasp::{Motion, Wrench};
use grasp_lcp::hold::Verdict;
use grasp_lcp::improve::{Improve, ImproveGoal, Improved};
use grasp_lcp::load_path::{Event, Leg};
use grasp_lcp::need::{Amount, Need, Needed};
use grasp_lcp::scene::{Answer, OnsetAnswer, PathAnswer, PathOutcome, Question, Setup};
use grasp_lcp::shake::Shaken;
use grasp_lcp::words::Words;

use crate::failure::Failure;
use crate::words::NO_WORDS;

/// The content of one picture: an equilibrium or the grasp alone, with the label and the sentences that the picture shows.
pub(super) struct ShownState {
    pub(super) label: String,
    pub(super) says: Vec<String>,
    /// The grasp to draw, if it is not the grasp of the scene. It has, for example, the needed friction or commands, or improved finger places.
    pub(super) grasp: Option<Grasp<3>>,
    pub(super) what: PictureContent,
}

/// The content of a picture: an equilibrium, or the grasp alone.
pub(super) enum PictureContent {
    /// An equilibrium; if the object is lost at this equilibrium, also the motion of the object.
    State { state: Box<Equilibrium<3>>, leaving: Option<Motion<3>> },
    /// The grasp without an equilibrium, and the load if it is known.
    Nothing { load: Option<Wrench<3>> },
}

/// The equilibria that illustrate the answer to one question. A load program has one for each event, i.e. change of contact states, and one for its
/// end.
pub(super) struct ShownAnswers(pub(super) Vec<ShownState>);

impl ShownAnswers {
    /// The equilibria that are saved as pictures of their own: the index of each, and the end of the picture's file name. For a load program this is
    /// the last equilibrium, for other questions the first. Improved fingers also have a picture of the grasp before the improvement.
    pub(super) fn keys(&self) -> Vec<(usize, &'static str)> {
        let begins = |shown: &ShownState, with| shown.label.starts_with(with);
        let key = self.0.first().map(|first| if begins(first, EVENT_LABEL) { self.0.len() - 1 } else { 0 });
        let before = self.0.iter().position(|shown| begins(shown, BEFORE_LABEL)).filter(|k| Some(*k) != key);
        key.map(|key| (key, "")).into_iter().chain(before.map(|before| (before, "_before"))).collect()
    }
}

/// The beginning of the label of an event along a load program, such as "leg 1 at 0.5: left slides". A leg is a section of the program.
const EVENT_LABEL: &str = "leg ";
/// The beginning of the label of a grasp before its finger places are improved.
const BEFORE_LABEL: &str = "before";

/// The equilibria that illustrate an answer. The equilibrium that [`ShownAnswers::keys`] lists first is shown with the first line of the answer.
pub(super) fn shown(
    setup: &Setup<3>,
    grasp: &Grasp<3>,
    question: &Question<3>,
    answer: Answer<3>,
    words: Words,
) -> Result<ShownAnswers, Failure> {
    let grasp = &setup.grasp_of(grasp, question)?;
    let question = &*setup.meant(question)?;
    let says = question.first_line(&answer, words);
    let mut states = match (question, answer) {
        (Question::Hold { .. }, Answer::Hold(answer)) => held(answer.verdict, question.ramp()?.load_at(1.0)),
        (Question::Need(asked), Answer::Need(answer)) => vec![needed(grasp, asked, &answer.needed)?],
        (Question::Improve(asked), Answer::Improve(answer)) => improved(grasp, asked, &answer.improved)?,
        (Question::Solve { load, .. }, Answer::Solve(answer)) => {
            let from_rest = answer.from_rest.map(|held| held.verdict);
            solved(grasp, load, answer.outcome, from_rest, words)?
        }
        (Question::Compare { base, load }, Answer::Compare(answer)) => {
            vec![under(answer.comparison.equilibrium, *base + *load)]
        }
        (Question::Onset { .. }, Answer::Onset(onset)) => {
            let ramp = question.ramp()?;
            let at = |factor: f64| format!("factor {}", Words::default().number(factor));
            vec![first_slip(grasp, onset, &ramp.load_at(0.0), Leg::along(&ramp), &|place| at(place.factor))?]
        }
        (Question::OnsetOfTurn(turn), Answer::OnsetOfTurn(answer)) => {
            let at = |angle: f64| format!("turned by {}", Words::default().angle(angle));
            let (start, leg) = (turn.load_at(0.0), Leg::turn(turn));
            vec![first_slip(grasp, answer.onset, &start, leg, &|place| at(place.angle))?]
        }
        (Question::Follow { start, legs, .. }, Answer::Follow(path)) => {
            followed(path, start, legs.len(), words)
        }
        (_, Answer::Shake(answer)) => vec![shaken(answer.shaken)],
        (Question::Shakedown { base, .. }, Answer::Shakedown(_)) => {
            vec![ShownState { label: "at rest".to_owned(), ..under(grasp.solve(base)?, *base) }]
        }
        _ => vec![nothing("no picture", None)],
    };
    let of_program = states.first().is_some_and(|first| first.label.starts_with(EVENT_LABEL));
    let key = if of_program { states.last_mut() } else { states.first_mut() };
    if let Some(shown) = key {
        shown.says.insert(0, says);
    }
    Ok(ShownAnswers(states))
}

fn nothing(label: &str, load: Option<Wrench<3>>) -> ShownState {
    ShownState {
        label: label.to_owned(),
        says: Vec::new(),
        grasp: None,
        what: PictureContent::Nothing { load },
    }
}

fn state(label: impl Into<String>, state: Equilibrium<3>, leaving: Option<Motion<3>>) -> ShownState {
    let what = PictureContent::State { state: Box::new(state), leaving };
    ShownState { label: label.into(), says: Vec::new(), grasp: None, what }
}

/// The equilibrium under a load; if none was found, the grasp and the load alone.
fn under(outcome: Outcome<3>, load: Wrench<3>) -> ShownState {
    match outcome {
        Outcome::Equilibrium(found) => state("under the load", *found, None),
        _ => nothing("under the load", Some(load)),
    }
}

/// The equilibrium under the load; then, if the object is lost on the load path, the equilibrium at the loss, with the motion of the object.
fn held(verdict: Verdict<3>, load: Wrench<3>) -> Vec<ShownState> {
    let lost = verdict.lost.and_then(|lost| Some(state("where it is lost", *lost.state?, lost.motion)));
    let under = verdict.state.map(|found| state("under the load", *found, None));
    let states: Vec<_> = under.into_iter().chain(lost).collect();
    if states.is_empty() { vec![nothing("does it hold?", Some(load))] } else { states }
}

/// The equilibrium between two cycles, with the motion of the object in each cycle; without an equilibrium the grasp under the base load.
fn shaken(shaken: Shaken<3>) -> ShownState {
    let (drift, base) = (shaken.drift(), shaken.base);
    match shaken.state {
        Some(between) => state("between two cycles", *between, drift),
        None => nothing("does it survive?", Some(base)),
    }
}

/// The answer to `need`: the grasp with the needed value of the sought quantity, such as friction. This grasp is shown in equilibrium under the most
/// demanding load of the question. If no value was found, the given grasp is shown with the load alone.
fn needed(grasp: &Grasp<3>, need: &Need<3>, needed: &Needed) -> Result<ShownState, Failure> {
    let (amount, label) = match &needed.amount {
        Amount::Bound { sufficient, .. } => (Some(*sufficient), "with what it needs"),
        Amount::Any { to, .. } => (Some(*to), "with an amount that suffices"),
        _ => (None, "what does it need?"),
    };
    let found = amount.map(|amount| grasp.with_amount(need, amount)).transpose()?.flatten();
    Ok(match found {
        Some((other, found)) => ShownState { grasp: Some(other), ..state(label, found, None) },
        None => nothing(label, need.given_load()),
    })
}

/// The improved grasp and the original grasp. Each is shown in equilibrium under the load at first slip or, if the goal is the largest margin to the
/// friction limit, under the full load. If this load is not known or infinite, the grasp is shown under the base load.
fn improved(
    grasp: &Grasp<3>,
    asked: &Improve<3>,
    improved: &Improved<3>,
) -> Result<Vec<ShownState>, Failure> {
    let base = asked.base();
    let (times, when): (fn(f64) -> f64, _) = match improved.goal {
        ImproveGoal::Reserve => (|_| 1.0, "under the load"),
        // The load just below first slip is shown: exactly at first slip, rounding errors decide whether a contact slides.
        _ => (|factor| factor * (1.0 - 1e-9), "at first slip"),
    };
    let seen = |grasp: &Grasp<3>, label: &str, value: Option<f64>| {
        let value = value.filter(|value| value.is_finite());
        let at = asked.load().zip(value).map(|(load, value)| base + load * times(value));
        let load = at.unwrap_or(base);
        let label = format!("{label}, {}", if at.is_some() { when } else { "at rest" });
        Ok::<_, Failure>(ShownState { label, ..under(grasp.solve(load)?, load) })
    };
    let before = seen(grasp, BEFORE_LABEL, improved.before)?;
    if improved.after.is_none() {
        return Ok(vec![before]);
    }
    let other = improved.placed(grasp)?;
    let after = seen(&other, "after", improved.after)?;
    Ok(vec![ShownState { grasp: Some(other), ..after }, before])
}

/// The equilibrium under the load. If none was found, the load grows from zero along a load path. The equilibrium shown is then the one under the
/// whole load, or the one at which the object is lost.
fn solved(
    grasp: &Grasp<3>,
    load: &Wrench<3>,
    outcome: Outcome<3>,
    from_rest: Option<Verdict<3>>,
    words: Words,
) -> Result<Vec<ShownState>, Failure> {
    if let Outcome::Equilibrium(found) = outcome {
        return Ok(vec![state("under the load", *found, None)]);
    }
    let verdict = from_rest.map_or_else(|| grasp.hold(load), Ok)?;
    let says = format!("Put on from rest: {verdict:.0$}", words.precision());
    let mut shown = held(verdict, *load).swap_remove(0);
    shown.says.push(says);
    shown.label = match shown.what {
        PictureContent::State { .. } => format!("put on from rest, {}", shown.label),
        PictureContent::Nothing { .. } => "under the load".to_owned(),
    };
    Ok(vec![shown])
}

/// The equilibrium at first slip, or at the start if a contact slides there. If nothing slides, the picture shows the equilibrium at the end of the
/// load path along `leg`, a section of a load program. If the load path has no start, the picture shows the grasp alone under the load `start`.
fn first_slip<At>(
    grasp: &Grasp<3>,
    onset: OnsetAnswer<3, At>,
    start: &Wrench<3>,
    leg: Leg<3>,
    at: &dyn Fn(&At) -> String,
) -> Result<ShownState, Failure> {
    let label = match onset {
        OnsetAnswer::At(event) => {
            return Ok(state(format!("onset of sliding, {}", at(&event.at)), event.state, None));
        }
        OnsetAnswer::AlreadySliding { state: found } => {
            return Ok(state("something slides from the start on", *found, None));
        }
        OnsetAnswer::GivesWay { at: place, .. } => {
            format!("nothing slides, but it gives way, {}", at(&place))
        }
        OnsetAnswer::Never => "nothing slides on the way".to_owned(),
        _ => return Ok(nothing("onset of sliding", Some(*start))),
    };
    let mut path = grasp.follow(start, &[leg])?;
    path.run();
    let loss = path.end().and_then(|end| end.loss());
    let leaving = loss.and_then(|loss| loss.motion.clone());
    Ok(path
        .state()
        .map_or_else(|| nothing(&label, Some(*start)), |found| state(label.clone(), found, leaving)))
}

/// The equilibria at the events of a load program, then the equilibrium at its end. If the end has no equilibrium, the last picture shows the grasp
/// alone under the load `start`.
fn followed(path: PathAnswer<3>, start: &Wrench<3>, legs: usize, words: Words) -> Vec<ShownState> {
    let mut states: Vec<_> = path.events.into_iter().map(|event| changed(event, words)).collect();
    let (found, leaving, (leg, fraction), how) = match path.end {
        PathOutcome::Completed { state } => {
            (state, None, (legs.saturating_sub(1), 1.0), "all legs are held to their end")
        }
        PathOutcome::Lost { loss, state, .. } => (state, loss.motion, (loss.leg, loss.fraction), "lost"),
        PathOutcome::Undecided { leg, fraction, .. } => {
            (None, None, (leg, fraction), "what comes next is undecided")
        }
        PathOutcome::NoStart { .. } => (None, None, (0, 0.0), "nothing to start from"),
        _ => (None, None, (0, 0.0), NO_WORDS),
    };
    let label = format!("{EVENT_LABEL}{} at {}: {how}", leg + 1, Words::default().number(fraction));
    states.push(match found {
        Some(found) => state(label, *found, leaving),
        None => nothing(&label, Some(*start)),
    });
    states
}

/// The picture of an event: the equilibrium at the event. Its label names the contacts that change their state, and the drives that reach their
/// limit.
fn changed(event: Event<3>, words: Words) -> ShownState {
    let contacts = event.whole_changes();
    let contacts =
        contacts.iter().map(|change| format!("{} {}", change.contact.text(), change.verb_in(words)));
    let drives = event.drives.iter().map(|drive| format!("{} {}", drive.part.text(), drive.what));
    let what: Vec<_> = contacts.chain(drives).collect();
    let what = if what.is_empty() { "a motion is free".to_owned() } else { what.join(", ") };
    let fraction = Words::default().number(event.fraction);
    state(format!("{EVENT_LABEL}{} at {fraction}: {what}", event.leg + 1), event.state, None)
}
