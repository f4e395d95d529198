//! The first line of every answer: one sentence, in everyday words, with the result. A leg is a section of a load program. An event is a change of
//! contact states at one point of a load path. First slip is the event at which the first contact ceases to stick; the onset is its load factor. A
//! drive is the spring of a joint or tendon of a hand, with its force limit. A jump is a sudden motion under constant load. The object snaps over if
//! it jumps from a point at which the path of equilibria ends.

use super::answer::Answer;
use super::onset::{OnsetAnswer, OnsetAt, TurnAnswer};
use super::path::{PathAnswer, PathOutcome};
use super::question::Question;
use super::solved::SolveAnswer;
use crate::equilibrium::{ContactState, Equilibrium, Outcome, WholeAnswer};
use crate::grasp::Wrench;
use crate::hold::{LossVerb, NO_MOMENTUM, left_out_caution};
use crate::load_path::{Change, DriveChange, Event, PadChange};
use crate::numerics::{IntoList, mapped};
use crate::words::{Words, listed, printable};

impl<const C: usize> Question<C> {
    /// The first line of the answer to this question: whether the grasp holds, which contacts slip, and under which load or angle. Tables and details
    /// follow this line.
    ///
    /// ```
    /// use grasp_lcp::scene::{Scene, Setup};
    /// use grasp_lcp::words::Words;
    ///
    /// let setup: Setup<2> = serde_json::from_str(r#"{
    ///     "contacts": [
    ///         { "name": "left", "point": [-0.03, 0], "normal": [1, 0], "friction": 0.5, "pressed_with": 10 },
    ///         { "name": "right", "point": [0.03, 0], "normal": [-1, 0], "friction": 0.5, "pressed_with": 10 }
    ///     ],
    ///     "questions": [{ "onset": { "direction": { "force": [0, -1] } } }]
    /// }"#)?;
    /// let (question, answers) = (&setup.questions[0], setup.answers()?);
    /// let says = question.first_line(&answers[0], Words::default());
    /// assert_eq!(says, "FIRST SLIP at 10 N: left and right slide; beyond: no equilibrium; it is the limit load");
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn first_line(&self, answer: &Answer<C>, words: Words) -> String {
        match (self, answer) {
            (Self::Solve { load, together_with }, Answer::Solve(answer)) => {
                let other = |(body, load): (&String, &Wrench<C>)| {
                    format!(", {} on {}", words.load(load), printable(body))
                };
                let others = together_with.iter().map(other).list().concat();
                solved(&format!(" under {}{others}", words.load(load)), answer, words)
            }
            (Self::Onset { base, direction, command_change, joint_change, .. }, Answer::Onset(onset)) => {
                let only_the_load =
                    *base == Wrench::ZERO && command_change.is_none() && joint_change.is_none();
                let place = |factor: f64| match direction.measure().filter(|_| only_the_load) {
                    Some((size, unit)) => format!("{} {unit}", words.number(size * factor)),
                    None => at_factor(factor, words),
                };
                first_slip(onset, &|at| place(at.factor), HOWEVER_FAR, words)
            }
            (Self::OnsetOfTurn(turn), Answer::OnsetOfTurn(answer)) => {
                turned(answer, &format!("while the load turns by {}", words.angle(turn.angle())), words)
            }
            _ => answer.first_line(words),
        }
    }
}

const HOWEVER_FAR: &str = "however far the load goes; `hold` says whether it buckles or moves too far before";

fn at_factor(factor: f64, words: Words) -> String {
    format!("factor {}", words.number(factor))
}

impl<const C: usize> Answer<C> {
    /// The first line of an answer whose question is not given. For `onset` it states the load factor of first slip; [`Question::first_line`] states
    /// the load instead.
    #[must_use]
    pub fn first_line(&self, words: Words) -> String {
        let digits = words.precision();
        match self {
            Self::Hold(answer) => format!("{:.digits$}", answer.verdict),
            Self::Need(answer) => {
                format!("{:.digits$}", answer.needed).lines().next().unwrap_or_default().to_owned()
            }
            Self::Improve(answer) => format!("{:.digits$}", answer.improved),
            Self::Shake(answer) => format!("{:.digits$}", answer.shaken),
            Self::Compare(answer) => answer.says.clone(),
            Self::Shakedown(answer) => answer.says.clone(),
            Self::Identify(answer) => answer.says.clone(),
            Self::Solve(answer) => {
                let state = answer.outcome.equilibrium();
                let under =
                    state.map_or(String::new(), |state| format!(" under {}", words.load(&state.load)));
                solved(&under, answer, words)
            }
            Self::Onset(onset) => first_slip(onset, &|at| at_factor(at.factor, words), HOWEVER_FAR, words),
            Self::OnsetOfTurn(answer) => turned(answer, "while the load turns", words),
            Self::Follow(path) => followed(path, words),
        }
    }
}

/// The first line of `solve`, such as "EQUILIBRIUM under (0, -4) N: everything sticks".
fn solved<const C: usize>(under: &str, answer: &SolveAnswer<C>, words: Words) -> String {
    let digits = words.precision();
    let sentence = match &answer.outcome {
        Outcome::Equilibrium(state) => {
            after_caution(state, words, format!("EQUILIBRIUM{under}: {}", in_short(state)))
        }
        Outcome::NoEquilibrium(none) => format!("NO EQUILIBRIUM{under}: {none:.digits$}"),
        Outcome::Undecided(undecided) => format!("UNDECIDED{under}: {undecided}"),
    };
    let Some(held) = &answer.from_rest else { return sentence };
    let from_rest = format!("put on from rest: {:.digits$}", held.verdict);
    match &answer.outcome {
        // Equilibrium is lost while the load grows from zero; the load is therefore not held. Whether another equilibrium exists under the whole load
        // is undecided.
        Outcome::Undecided(doubt) if held.verdict.holds() == Some(false) => {
            format!("{from_rest}. Whether another equilibrium exists elsewhere is undecided: {doubt}")
        }
        _ => format!("{sentence}; {from_rest}"),
    }
}

/// `sentence`, which is about an equilibrium. A caution precedes the sentence if the motions of this equilibrium are not small, a suction cup leaks
/// or the grasp buckles: "BUCKLES: it buckles: …. Otherwise EQUILIBRIUM".
fn after_caution<const C: usize>(state: &Equilibrium<C>, words: Words, sentence: String) -> String {
    match &state.too_far {
        Some(far) => format!("{}: {}. Otherwise {sentence}", LossVerb::from(far), far.reason(words)),
        None => sentence,
    }
}

const EVERYTHING_STICKS: &str = "everything sticks";

/// Names the contacts that slide in this equilibrium, or says that everything sticks; then names contacts that are open, or open in part.
fn in_short<const C: usize>(state: &Equilibrium<C>) -> String {
    let [mut slide, mut in_part, mut open, mut slack, mut lifted] = [const { Vec::new() }; 5];
    for contact in state.whole_contacts() {
        let name = contact.text();
        match contact {
            WholeAnswer::Pad(pad) if pad.open == pad.points => open.push(name),
            WholeAnswer::Pad(pad) if pad.sliding > 0 && pad.sliding < pad.points - pad.open => {
                in_part.push(format!("{name} ({})", pad.state_text()));
            }
            WholeAnswer::Pad(pad) if pad.sliding > 0 => slide.push(name),
            WholeAnswer::Pad(pad) if pad.open > 0 => {
                lifted.push(format!("{name} ({} of {} points)", pad.open, pad.points));
            }
            WholeAnswer::Point(point) => match point.state {
                ContactState::Sliding { .. } => slide.push(name),
                ContactState::Separated if point.gap > 0.0 && point.contact.link.is_some() => {
                    slack.push(name);
                }
                ContactState::Separated if point.gap > 0.0 => open.push(name),
                _ => {}
            },
            WholeAnswer::Pad(_) => {}
        }
    }
    let first = match (slide.len(), in_part.is_empty()) {
        (0, true) if open.len() + slack.len() + lifted.len() > 0 => {
            "everything that touches sticks".to_owned()
        }
        (0, true) => EVERYTHING_STICKS.to_owned(),
        (0, false) => format!("{} in part", plural(&in_part, "slides")),
        _ => plural(&[slide, in_part].concat(), "slides"),
    };
    let clauses = [(open, "is open"), (slack, "is slack"), (lifted, "is open in part")];
    let clauses = clauses.iter().filter(|(names, _)| !names.is_empty());
    clauses.fold(first, |line, (names, verb)| format!("{line}, {}", plural(names, verb)))
}

/// The names of the contacts that slide; a soft fingertip counts if at least one of its points slides.
fn sliding<const C: usize>(state: &Equilibrium<C>) -> Vec<String> {
    let slides = |contact: &WholeAnswer<'_, C>| match contact {
        WholeAnswer::Pad(pad) => pad.sliding > 0,
        WholeAnswer::Point(point) => matches!(point.state, ContactState::Sliding { .. }),
    };
    state.whole_contacts().filter(slides).map(|contact| contact.text()).list()
}

/// The first line of `onset_of_turn`; see [`first_slip`].
fn turned<const C: usize>(answer: &TurnAnswer<C>, how_far: &str, words: Words) -> String {
    let first = first_slip(&answer.onset, &|at| words.angle(at.angle), how_far, words);
    first + &left_out_caution(answer.left_out)
}

/// The first line of `onset`, such as "FIRST SLIP at 10 N: left and right slide; beyond: the grasp still holds at first".
fn first_slip<const C: usize, At>(
    onset: &OnsetAnswer<C, At>,
    place: &dyn Fn(&At) -> String,
    how_far: &str,
    words: Words,
) -> String {
    let digits = words.precision();
    match onset {
        OnsetAnswer::At(event) => {
            let (what, leaves) = leaving(event, words);
            let (at, beyond) = (place(&event.at), &event.beyond);
            let sentence = format!("{what} at {at}: {leaves}; beyond: {beyond:.digits$}");
            after_caution(&event.state, words, sentence)
        }
        OnsetAnswer::Never => format!("NOTHING SLIDES {how_far}"),
        OnsetAnswer::AlreadySliding { state } => {
            let sentence = format!("SLIDES already where the load begins: {}", in_short(state));
            after_caution(state, words, sentence)
        }
        OnsetAnswer::NoBase(none) => format!("NO EQUILIBRIUM where the load begins: {none:.digits$}"),
        OnsetAnswer::GivesWay { at, reason } => {
            format!("NOTHING SLIDES up to {}, where it gives way: {reason:.digits$}", place(at))
        }
        OnsetAnswer::Undecided(why) => format!("UNDECIDED where the load begins: {why}"),
    }
}

/// What happens at an onset, "FIRST SLIP", "FIRST OPENING" or "FIRST YIELDING". Also the contacts and drives that change there: "left and right
/// slide".
fn leaving<const C: usize, At>(event: &OnsetAt<C, At>, words: Words) -> (&'static str, String) {
    let changes = event.whole_changes();
    let slides = changes.iter().any(|change| {
        use PadChange::{BeginsToSlide, Point, SlidesEverywhere};
        matches!(change.what, Point(Change::Slides { .. }) | BeginsToSlide | SlidesEverywhere)
    });
    let drives = event.drives.iter().map(|drive| (drive.part.text(), drive.what.to_string()));
    let verbs: Vec<(String, String)> =
        changes.iter().map(|change| (change.contact.text(), change.verb_in(words))).chain(drives).list();
    let mut clauses: Vec<String> = Vec::new();
    for group in verbs.chunk_by(|a, b| a.1 == b.1) {
        let names: Vec<&str> = mapped(group, &|(name, _)| name.as_str());
        clauses.push(plural(&names, &group[0].1));
    }
    let what = match (slides, changes.is_empty()) {
        (true, _) => "FIRST SLIP",
        (false, true) => "FIRST YIELDING",
        (false, false) => "FIRST OPENING",
    };
    (what, if clauses.is_empty() { "points of a fingertip change".to_owned() } else { clauses.join(", ") })
}

/// "left slides", "left and right slide": the verb without its final s if there are several names.
fn plural<T: ToString>(names: &[T], verb: &str) -> String {
    let (first, rest) =
        verb.split_once(' ').map_or((verb, String::new()), |(first, rest)| (first, format!(" {rest}")));
    let first = match first {
        _ if names.len() == 1 => first,
        "is" => "are",
        "goes" => "go",
        _ => first.strip_suffix('s').unwrap_or(first),
    };
    format!("{} {first}{rest}", listed(&names.iter().map(T::to_string).list()))
}

/// The first jump of a path in which the object snaps over, or else the first jump: "snaps over at 0.7 of leg 2, (0, -4) N, counting no momentum; ".
/// Empty for a path without jumps.
fn jumps<const C: usize>(path: &PathAnswer<C>, place: &dyn Fn(usize, f64, &Wrench<C>) -> String) -> String {
    let jump = |snaps: bool| {
        let is_meant = |event: &&Event<C>| event.jump.as_ref().is_some_and(|jump| jump.snaps || !snaps);
        let event = path.events.iter().find(is_meant)?;
        let what = if snaps { "snaps over" } else { "jumps" };
        Some(format!("{what} at {}, {NO_MOMENTUM}; ", place(event.leg, event.fraction, &event.load)))
    };
    jump(true).or_else(|| jump(false)).unwrap_or_default()
}

/// The first line of `follow`: "LOST at 0.425 of leg 1, (0, 0, -8.5) N: no contact states carry more; first slip at 0.215 of leg 1, (0, 0, -4.3) N".
fn followed<const C: usize>(path: &PathAnswer<C>, words: Words) -> String {
    let digits = words.precision();
    let place = |leg: usize, fraction: f64, load: &Wrench<C>| {
        let load = if *load == Wrench::ZERO { String::new() } else { format!(", {}", words.load(load)) };
        format!("{} of leg {}{load}", words.number(fraction), leg + 1)
    };
    let slips = |what: &Change<C>| matches!(what, Change::Slides { .. } | Change::ClosesSliding { .. });
    let first = path.events.iter().find(|event| event.changes.iter().any(|change| slips(&change.what)));
    let step = path.steps.iter().find(|step| step.sliding > 0);
    // The first event stores the contact states before it, which are the states at the start of the path. Without events the states at the end equal
    // the states at the start.
    let start = match (path.events.first(), &path.end) {
        (Some(event), _) => Some(&event.state),
        (None, PathOutcome::Completed { state: Some(state) }) if path.steps.is_empty() => Some(&**state),
        _ => None,
    };
    let mut from_start = start.map_or(Vec::new(), sliding);
    // A contact that begins to slide at the very end of the path has no event there, and has not slipped yet.
    let is_moved = |state: &Equilibrium<C>| state.contacts.iter().any(|contact| contact.slip.norm() > 0.0);
    let mut at_the_end = Vec::new();
    if path.events.is_empty() && start.is_none_or(|start| !is_moved(start)) {
        core::mem::swap(&mut from_start, &mut at_the_end);
    }
    let opens = path.events.iter().find_map(|event| {
        let opened = event.whole_changes().into_iter();
        let opened = opened.filter(|change| change.what == PadChange::Point(Change::Opens)).list();
        let (names, verb) =
            (mapped(&opened, &|change| change.contact.text()), opened.first()?.verb_in(words));
        Some(format!("{} at {}", plural(&names, &verb), place(event.leg, event.fraction, &event.load)))
    });
    let slip = match (first, step) {
        (Some(event), _) if !from_start.is_empty() && (event.leg, event.fraction) != (0, 0.0) => {
            let next = place(event.leg, event.fraction, &event.load);
            format!("{} from the start, next slip at {next}", plural(&from_start, "slides"))
        }
        _ if !from_start.is_empty() => format!("{} from the start", plural(&from_start, "slides")),
        (Some(event), _) => format!("first slip at {}", place(event.leg, event.fraction, &event.load)),
        (None, Some(step)) => format!("first slip by {}", place(step.leg, step.fraction, &step.load)),
        (None, None) => match &path.end {
            PathOutcome::Lost { state: Some(state), .. } => format!("{} there", in_short(state)),
            _ if !at_the_end.is_empty() => format!("{} from there on", plural(&at_the_end, "slides")),
            PathOutcome::Completed { .. } if opens.is_some() => {
                format!("no contact begins to slide on the way; {}", opens.unwrap_or_default())
            }
            PathOutcome::Completed { state: Some(state) } if in_short(state) != EVERYTHING_STICKS => {
                format!("no contact begins to slide on the way; there {}", in_short(state))
            }
            _ => "no contact begins to slide on the way".to_owned(),
        },
    };
    let yields = path.events.iter().find_map(|event| {
        let drive = event.drives.iter().find(|drive| drive.what == DriveChange::Yields)?;
        Some(format!("{} yields at {}; ", drive.part.text(), place(event.leg, event.fraction, &event.load)))
    });
    let slip = jumps(path, &place) + &yields.unwrap_or_default() + &slip;
    let sentence = match &path.end {
        PathOutcome::Completed { .. } if path.energies.is_empty() && path.steps.is_empty() => {
            return "NOTHING FOLLOWED: no legs are given".to_owned();
        }
        PathOutcome::Completed { .. } => format!("HELD to the end: {slip}"),
        PathOutcome::Lost { loss, .. } => {
            format!("LOST at {}: {}; {slip}", place(loss.leg, loss.fraction, &loss.load), loss.kind)
        }
        PathOutcome::Undecided { leg, fraction, doubt } => {
            format!("UNDECIDED beyond {} of leg {}: {doubt}; {slip}", words.number(*fraction), leg + 1)
        }
        PathOutcome::NoStart { start } => match &**start {
            Outcome::Undecided(why) => return format!("UNDECIDED where the load begins: {why}"),
            none => return format!("NO START: {none:.digits$}"),
        },
    };
    let sentence = sentence + &left_out_caution(path.left_out);
    match &path.small_motions_end {
        Some(far) => {
            let (fraction, what) = (words.number(far.fraction), far.what.reason(words));
            let verb = LossVerb::from(&far.what);
            format!("{verb} from {fraction} of leg {} on: {what}. Otherwise {sentence}", far.leg + 1)
        }
        None => sentence,
    }
}
