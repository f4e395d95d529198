//! Prints what a scene asks, in words and tables.

use grasp_lcp::Error;
use grasp_lcp::grasp::Grasp;
use grasp_lcp::load_path::LossKind;
use grasp_lcp::scene::{
    Answer, Beyond, Departure, Doing, DriveTurn, EdgeOf, Equilibrium, Leaving, OnsetAnswer, PathAnswer,
    PathEnd, Question, Setup, SolveAnswer, Touch, Turn, TurnAnswer, TurnOnset, WithGrasp,
};

use super::predict_words::{doing, drive_word, gives_way, left, name, part_name, proof, row, wrench};

/// Answers every question of a scene and prints the answers.
pub(crate) fn predict<const D: usize, const C: usize>(setup: &Setup<D, C>) -> Result<(), Error> {
    let points = setup.with_grasp(Points)?;
    println!("{} contacts, {points} points of contact", setup.entries().count());
    for (question, answer) in setup.questions.iter().zip(setup.answers()?) {
        match (question, &answer) {
            (Question::Solve { load }, Answer::Solve(outcome)) => {
                println!("\nUnder the load {}", wrench(load));
                solved(setup, outcome);
            }
            (Question::Onset(ramp), Answer::Onset(onset)) => {
                print!("\nOnset of sliding from {} along {}", wrench(&ramp.base), wrench(&ramp.direction));
                println!(
                    "{}",
                    if ramp.command_change.is_some() { ", finger commands changing along" } else { "" }
                );
                slides(setup, onset);
            }
            (Question::OnsetOfTurn(turn), Answer::OnsetOfTurn(onset)) => {
                let (from, most) = (wrench(&turn.load_at(0.0)), turn.angle().to_degrees());
                println!("\nOnset of sliding from {from} while the load turns by {most:.6} degrees");
                slides_turned(setup, onset);
            }
            (Question::Follow { start, legs }, Answer::Follow(path)) => {
                println!("\nLoad program of {} legs from {}", legs.len(), wrench(start));
                followed(setup, path);
            }
            (_, other) => println!("{other:?}"),
        }
    }
    Ok(())
}

/// Number of contacts that a grasp has, soft fingertips spread.
struct Points;

impl<const C: usize> WithGrasp<C> for Points {
    type Output = usize;
    fn with<const W: usize>(self, grasp: &Grasp<W, C>) -> usize {
        grasp.len()
    }
}

fn solved<const D: usize, const C: usize>(setup: &Setup<D, C>, outcome: &SolveAnswer<D, C>) {
    match outcome {
        SolveAnswer::Equilibrium(state) => table(setup, state),
        SolveAnswer::NoEquilibrium(why) => println!("  no equilibrium exists: {}", proof(why)),
        SolveAnswer::Undecided { doubt } => println!("  undecided: {doubt:?}"),
        other => println!("  {other:?}"),
    }
}

fn slides<const D: usize, const C: usize>(setup: &Setup<D, C>, onset: &OnsetAnswer<D, C>) {
    match onset {
        OnsetAnswer::At(event) => {
            println!("  at factor {:.12}, that is {}", event.factor, wrench(&event.load));
            leave(&event.leaving, &event.drives);
            table(setup, &event.state);
            goes_on(&event.beyond);
        }
        OnsetAnswer::Never => println!("  never: everything keeps rolling however far the load goes"),
        OnsetAnswer::AlreadySliding { state } => {
            println!("  something slides already at factor 0:");
            table(setup, state);
        }
        OnsetAnswer::NoBase(why) => println!("  no equilibrium exists at factor 0: {}", proof(why)),
        OnsetAnswer::GivesWay { factor, reason } => {
            println!("  nothing slides, but from factor {factor:.12} on nothing resists: {}", proof(reason));
        }
        other => println!("  {other:?}"),
    }
}

fn slides_turned<const D: usize, const C: usize>(setup: &Setup<D, C>, answer: &TurnAnswer<D, C>) {
    match &answer.onset {
        TurnOnset::At(event) => {
            let (angle, load) = (event.angle, wrench(&event.load));
            println!("  at {:.9} degrees, {angle:.12} rad, that is {load}", angle.to_degrees());
            leave(&event.leaving, &event.drives);
            table(setup, &event.state);
            goes_on(&event.beyond);
        }
        TurnOnset::Never => println!("  never: everything keeps rolling up to the last angle"),
        TurnOnset::AlreadySliding { state } => {
            println!("  something slides already at angle 0:");
            table(setup, state);
        }
        TurnOnset::NoBase(why) => println!("  no equilibrium exists at angle 0: {}", proof(why)),
        TurnOnset::GivesWay { angle, reason } => {
            println!("  nothing slides, but from {angle:.12} rad on nothing resists: {}", proof(reason));
        }
        other => println!("  {other:?}"),
    }
    for touch in &answer.touches {
        let who = match &touch.of {
            EdgeOf::Contact(place) => name(place),
            EdgeOf::Drive(part) => part_name(part),
            other => format!("{other:?}"),
        };
        println!("  {who} touches its edge at {:.9} degrees", touch.angle.to_degrees());
    }
}

/// Who leaves rolling, and how.
fn leave<const C: usize>(leaving: &[Leaving<C>], drives: &[DriveTurn]) {
    for Leaving { place, how, .. } in leaving {
        match how {
            Departure::Slides { direction } => {
                println!("  {} slides over the object along {}", name(place), row(direction.as_slice()));
            }
            Departure::Opens => println!("  {} opens", name(place)),
            other => println!("  {} {other:?}", name(place)),
        }
    }
    for DriveTurn { part, what, .. } in drives {
        println!("  {} {}", part_name(part), drive_word(*what));
    }
}

/// What comes after an onset.
fn goes_on<const D: usize, const C: usize>(next: &Beyond<D, C>) {
    match next {
        Beyond::Continues { states, .. } => {
            let sliding = states.iter().filter(|s| matches!(s, Doing::Sliding { .. })).count();
            println!("  beyond: the grasp holds on, points that slide: {sliding}");
        }
        other => beyond(other),
    }
}

fn followed<const D: usize, const C: usize>(setup: &Setup<D, C>, path: &PathAnswer<D, C>) {
    for event in &path.events {
        for change in &event.changes {
            let what = match &change.what {
                Turn::Slides { direction } => format!("slides along {}", row(direction.as_slice())),
                Turn::Sticks => "sticks".to_owned(),
                Turn::Reverses { direction } => format!("slides back along {}", row(direction.as_slice())),
                Turn::Turns { direction } => format!("turns to {}", row(direction.as_slice())),
                Turn::Opens => "opens".to_owned(),
                Turn::Closes => "closes".to_owned(),
                Turn::ClosesSliding { direction } => {
                    format!("closes, sliding along {}", row(direction.as_slice()))
                }
                other => format!("{other:?}"),
            };
            let at = format!("leg {} at {:.9}", event.leg, event.fraction);
            println!("  {at}, {}: {} {what}", wrench(&event.load), name(&change.place));
        }
        for DriveTurn { part, what, .. } in &event.drives {
            let at = format!("leg {} at {:.9}", event.leg, event.fraction);
            println!("  {at}, {}: {} {}", wrench(&event.load), part_name(part), drive_word(*what));
        }
    }
    match &path.end {
        PathEnd::Completed { state: Some(state) } => {
            println!("  all legs are held to their end:");
            table(setup, state);
        }
        PathEnd::Completed { state: None } => println!("  all legs are held to their end"),
        PathEnd::Lost { loss, beyond: next } => {
            let how = match loss.kind {
                LossKind::Fold => "the load has a maximum",
                LossKind::Corner => "no contact states carry more",
                LossKind::Asymptote => "the object moves on without bound",
                LossKind::GivesWay => "nothing resists",
                _ => "a contact lets go",
            };
            let at = format!("{:.9} of leg {}", loss.fraction, loss.leg);
            println!("  this equilibrium ends at {at}, {}: {how}", wrench(&loss.load));
            beyond(next);
        }
        PathEnd::NoStart { start } => {
            println!("  there is nothing to start from:");
            solved(setup, start);
        }
        other => println!("  {other:?}"),
    }
}

/// One line for each contact of the scene; forces of a soft fingertip are sums over its points.
fn table<const D: usize, const C: usize>(setup: &Setup<D, C>, state: &Equilibrium<D, C>) {
    println!("  {:24} {:>12} {:>12} {:>12}  state", "contact", "F_n (N)", "|F_t| (N)", "margin (N)");
    for (index, entry) in setup.entries().enumerate() {
        let points: Vec<&Touch<C>> = state.contacts.iter().filter(|c| c.place.contact == index).collect();
        let sum = |axis: usize| points.iter().map(|c| c.force[axis]).sum::<f64>();
        let tangential = (1..C).map(sum).fold(0.0, f64::hypot);
        let margin = points.iter().map(|c| c.margin).fold(f64::INFINITY, f64::min);
        let label = entry.contact.label_text(index);
        println!("  {label:24} {:12.6} {tangential:12.6} {margin:12.6}  {}", sum(0), doing(&points));
    }
    for joint in &state.joints {
        let (label, torque, margin) = (part_name(&joint.part), joint.torque, joint.margin);
        println!("  {label:24} torque  {torque:12.6}{}{}", left(margin), gives_way(joint.state));
    }
    for tendon in &state.tendons {
        let (label, tension, margin) = (part_name(&tendon.part), tendon.tension, tendon.margin);
        println!("  {label:24} tension {tension:12.6}{}{}", left(margin), gives_way(tendon.state));
    }
    let r = &state.residuals;
    let worst = [r.equilibrium, r.springs, r.cone, r.gap, r.complementarity].into_iter().fold(0.0, f64::max);
    println!("  the object moves by {}, residual {worst:.0e}", row(state.twist.as_vector().as_slice()));
}

/// What lies beyond an onset where the equilibrium ends, or beyond the end of a path.
fn beyond<const D: usize, const C: usize>(beyond: &Beyond<D, C>) {
    match beyond {
        Beyond::LimitLoad => println!("  beyond: no equilibrium; it is the limit load"),
        Beyond::Snap => println!("  beyond: another equilibrium; the grasp snaps over or is lost"),
        Beyond::Ends { reason } => println!("  beyond: this equilibrium ends: {}", proof(reason)),
        other => println!("  beyond: {other:?}"),
    }
}
