//! Answers in words and tables.

use std::io::{self, Write};

use grasp_lcp::equilibrium::{ContactAnswer, ContactState, Equilibrium, Outcome, row};
use grasp_lcp::load_path::{Beyond, Change, Departure, EdgeOf, Leaving, PartChange};
use grasp_lcp::scene::{Answer, OnsetAnswer, PathAnswer, PathOutcome, Question, Setup, TurnAnswer};

use crate::words::{NO_WORDS, doing, gives_way, left, proof, wrench};

/// Prints the answers to the questions of a scene.
pub(crate) fn print<const C: usize>(
    out: &mut dyn Write,
    comment: Option<&str>,
    setup: &Setup<C>,
    answers: &[Answer<C>],
) -> io::Result<()> {
    let is_a_sentence = |answer: &Answer<C>| matches!(answer, Answer::Hold(_) | Answer::Need(_));
    // A sentence is what was asked for, and comes first.
    if !answers.iter().all(is_a_sentence) {
        if let Some(comment) = comment {
            writeln!(out, "{comment}")?;
        }
        let points = setup.points().unwrap_or_default();
        writeln!(out, "{} contacts, {points} points of contact", setup.entries().count())?;
    }
    for (question, answer) in setup.questions.iter().zip(answers) {
        match (question, answer) {
            (_, Answer::Hold(answer)) => {
                writeln!(out, "{}", answer.says)?;
                if let Some(state) = &answer.verdict.state {
                    table(out, setup, state)?;
                }
            }
            (_, Answer::Need(answer)) => writeln!(out, "{}", answer.says)?,
            (Question::Solve { load }, Answer::Solve(outcome)) => {
                writeln!(out, "\nUnder the load {}", wrench(load))?;
                solved(out, setup, outcome)?;
                // Nothing was found by a search; what happens from rest is known all the same.
                if let (Outcome::Undecided(_), Ok(Ok(verdict))) =
                    (outcome, setup.grasp().map(|grasp| grasp.hold(*load)))
                {
                    writeln!(out, "  put on from rest: {verdict}")?;
                }
            }
            (Question::Onset(ramp), Answer::Onset(onset)) => {
                write!(
                    out,
                    "\nOnset of sliding from {} along {}",
                    wrench(&ramp.base),
                    wrench(&ramp.direction)
                )?;
                writeln!(
                    out,
                    "{}",
                    if ramp.command_change.is_some() { ", finger commands changing along" } else { "" }
                )?;
                slides(out, setup, onset)?;
            }
            (Question::OnsetOfTurn(turn), Answer::OnsetOfTurn(onset)) => {
                let (from, most) = (wrench(&turn.load_at(0.0)), turn.angle().to_degrees());
                writeln!(out, "\nOnset of sliding from {from} while the load turns by {most:.6} degrees")?;
                slides_turned(out, setup, onset)?;
            }
            (Question::Follow { start, legs }, Answer::Follow(path)) => {
                writeln!(out, "\nLoad program of {} legs from {}", legs.len(), wrench(start))?;
                followed(out, setup, path)?;
            }
            _ => writeln!(out, "{NO_WORDS}")?,
        }
    }
    Ok(())
}

fn solved<const C: usize>(out: &mut dyn Write, setup: &Setup<C>, outcome: &Outcome<C>) -> io::Result<()> {
    match outcome {
        Outcome::Equilibrium(state) => table(out, setup, state)?,
        Outcome::NoEquilibrium(none) => writeln!(out, "  no equilibrium exists: {}", proof(&none.proof))?,
        Outcome::Undecided(why) => writeln!(out, "  undecided: {}", why.doubt)?,
        _ => writeln!(out, "  {NO_WORDS}")?,
    }
    Ok(())
}

fn slides<const C: usize>(out: &mut dyn Write, setup: &Setup<C>, onset: &OnsetAnswer<C>) -> io::Result<()> {
    match onset {
        OnsetAnswer::At(event) => {
            writeln!(out, "  at factor {:.12}, that is {}", event.at.factor, wrench(&event.load))?;
            leave(out, &event.leaving, &event.drives)?;
            table(out, setup, &event.state)?;
            goes_on(out, &event.beyond)?;
        }
        OnsetAnswer::Never => writeln!(out, "  never: everything keeps sticking however far the load goes")?,
        OnsetAnswer::AlreadySliding { state } => {
            writeln!(out, "  something slides already at factor 0:")?;
            table(out, setup, state)?;
        }
        OnsetAnswer::NoBase(none) => {
            writeln!(out, "  no equilibrium exists at factor 0: {}", proof(&none.proof))?;
        }
        OnsetAnswer::Undecided(why) => writeln!(out, "  undecided at factor 0: {}", why.doubt)?,
        OnsetAnswer::GivesWay { at, reason } => {
            let (factor, why) = (at.factor, proof(&reason.proof));
            writeln!(out, "  nothing slides, but from factor {factor:.12} on nothing resists: {why}")?;
        }
        _ => writeln!(out, "  {NO_WORDS}")?,
    }
    Ok(())
}

fn slides_turned<const C: usize>(
    out: &mut dyn Write,
    setup: &Setup<C>,
    answer: &TurnAnswer<C>,
) -> io::Result<()> {
    match &answer.onset {
        OnsetAnswer::At(event) => {
            let (angle, load) = (event.at.angle, wrench(&event.load));
            writeln!(out, "  at {:.9} degrees, {angle:.12} rad, that is {load}", angle.to_degrees())?;
            leave(out, &event.leaving, &event.drives)?;
            table(out, setup, &event.state)?;
            goes_on(out, &event.beyond)?;
        }
        OnsetAnswer::Never => writeln!(out, "  never: everything keeps sticking up to the last angle")?,
        OnsetAnswer::AlreadySliding { state } => {
            writeln!(out, "  something slides already at angle 0:")?;
            table(out, setup, state)?;
        }
        OnsetAnswer::NoBase(none) => {
            writeln!(out, "  no equilibrium exists at angle 0: {}", proof(&none.proof))?;
        }
        OnsetAnswer::Undecided(why) => writeln!(out, "  undecided at angle 0: {}", why.doubt)?,
        OnsetAnswer::GivesWay { at, reason } => {
            let (angle, why) = (at.angle, proof(&reason.proof));
            writeln!(out, "  nothing slides, but from {angle:.12} rad on nothing resists: {why}")?;
        }
        _ => writeln!(out, "  {NO_WORDS}")?,
    }
    for touch in &answer.touches {
        let who = match &touch.of {
            EdgeOf::Contact(contact) => contact.text(),
            EdgeOf::Drive(part) => part.text(),
            _ => NO_WORDS.to_owned(),
        };
        writeln!(out, "  {who} touches its edge at {:.9} degrees", touch.angle.to_degrees())?;
    }
    Ok(())
}

/// Who stops sticking, and how.
fn leave<const C: usize>(
    out: &mut dyn Write,
    leaving: &[Leaving<C>],
    drives: &[PartChange],
) -> io::Result<()> {
    for Leaving { contact, how, .. } in leaving {
        match how {
            Departure::Slides { direction } => {
                writeln!(
                    out,
                    "  {} slides over the object along {}",
                    contact.text(),
                    row(direction.as_slice())
                )?;
            }
            Departure::Opens => writeln!(out, "  {} opens", contact.text())?,
        }
    }
    for PartChange { part, what, .. } in drives {
        writeln!(out, "  {} {}", part.text(), what)?;
    }
    Ok(())
}

/// What comes after an onset.
fn goes_on<const C: usize>(out: &mut dyn Write, next: &Beyond<C>) -> io::Result<()> {
    match next {
        Beyond::Continues(next) => {
            let sliding = next.states.iter().filter(|s| matches!(s, ContactState::Sliding { .. })).count();
            writeln!(out, "  beyond: the grasp holds on, points that slide: {sliding}")?;
        }
        other => beyond(out, other)?,
    }
    Ok(())
}

fn followed<const C: usize>(out: &mut dyn Write, setup: &Setup<C>, path: &PathAnswer<C>) -> io::Result<()> {
    for event in &path.events {
        for change in &event.changes {
            let what = match &change.what {
                Change::Slides { direction } => format!("slides along {}", row(direction.as_slice())),
                Change::Sticks => "sticks".to_owned(),
                Change::Reverses { direction } => format!("slides back along {}", row(direction.as_slice())),
                Change::Turns { direction } => format!("turns to {}", row(direction.as_slice())),
                Change::Opens => "opens".to_owned(),
                Change::Closes => "closes".to_owned(),
                Change::ClosesSliding { direction } => {
                    format!("closes, sliding along {}", row(direction.as_slice()))
                }
            };
            let at = format!("leg {} at {:.9}", event.leg, event.fraction);
            writeln!(out, "  {at}, {}: {} {what}", wrench(&event.load), change.contact.text())?;
        }
        for PartChange { part, what, .. } in &event.drives {
            let at = format!("leg {} at {:.9}", event.leg, event.fraction);
            writeln!(out, "  {at}, {}: {} {}", wrench(&event.load), part.text(), what)?;
        }
    }
    match &path.end {
        PathOutcome::Completed { state: Some(state) } => {
            writeln!(out, "  all legs are held to their end:")?;
            table(out, setup, state)?;
        }
        PathOutcome::Completed { state: None } => writeln!(out, "  all legs are held to their end")?,
        PathOutcome::Lost { loss, beyond: next } => {
            let how = loss.kind;
            let at = format!("{:.9} of leg {}", loss.fraction, loss.leg);
            writeln!(out, "  this equilibrium ends at {at}, {}: {how}", wrench(&loss.load))?;
            beyond(out, next)?;
        }
        PathOutcome::Undecided { leg, fraction, doubt } => {
            writeln!(out, "  held to {fraction:.9} of leg {leg}, beyond not known: {doubt}")?;
        }
        PathOutcome::NoStart { start } => {
            writeln!(out, "  there is nothing to start from:")?;
            solved(out, setup, start)?;
        }
        _ => writeln!(out, "  {NO_WORDS}")?,
    }
    Ok(())
}

/// One line for each contact of the scene; forces of a soft fingertip are sums over its points.
fn table<const C: usize>(out: &mut dyn Write, setup: &Setup<C>, state: &Equilibrium<C>) -> io::Result<()> {
    writeln!(out, "  {:24} {:>12} {:>12} {:>12}  state", "contact", "F_n (N)", "|F_t| (N)", "margin (N)")?;
    for (index, entry) in setup.entries().enumerate() {
        let points: Vec<&ContactAnswer<C>> =
            state.contacts.iter().filter(|c| c.contact.index == index).collect();
        let sum = |axis: usize| points.iter().map(|c| c.force[axis]).sum::<f64>();
        let tangential = (1..C).map(sum).fold(0.0, f64::hypot);
        let margin = points.iter().map(|c| c.margin).fold(f64::INFINITY, f64::min);
        let label = entry.contact.label_text(index);
        writeln!(out, "  {label:24} {:12.6} {tangential:12.6} {margin:12.6}  {}", sum(0), doing(&points))?;
    }
    for joint in &state.joints {
        let (label, torque, margin) = (joint.joint.text(), joint.torque, joint.margin);
        let (what, unit) = if joint.slides { ("force", "N") } else { ("torque", "N m") };
        writeln!(
            out,
            "  {label:24} {what:7} {torque:12.6} {unit}{}{}",
            left(margin),
            gives_way(joint.state)
        )?;
    }
    for tendon in &state.tendons {
        let (label, tension, margin) = (tendon.tendon.text(), tendon.tension, tendon.margin);
        writeln!(out, "  {label:24} tension {tension:12.6} N{}{}", left(margin), gives_way(tendon.state))?;
    }
    let worst = state.residuals.worst();
    writeln!(out, "  the object moves by {}, residual {worst:.0e}", row(state.twist.components()))?;
    Ok(())
}

/// What lies beyond an onset where the equilibrium ends, or beyond the end of a path.
fn beyond<const C: usize>(out: &mut dyn Write, beyond: &Beyond<C>) -> io::Result<()> {
    match beyond {
        Beyond::LimitLoad => writeln!(out, "  beyond: no equilibrium; it is the limit load")?,
        Beyond::Snap => writeln!(out, "  beyond: another equilibrium; the grasp snaps over or is lost")?,
        Beyond::Ends { reason } => {
            writeln!(out, "  beyond: this equilibrium ends: {}", proof(&reason.proof))?;
        }
        Beyond::Undecided { doubt } => writeln!(out, "  beyond: not known: {doubt}")?,
        _ => writeln!(out, "  beyond: {NO_WORDS}")?,
    }
    Ok(())
}
