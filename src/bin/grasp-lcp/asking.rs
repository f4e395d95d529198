//! Answers the questions of a scene, or in their place the question of the command line.

use std::io::{self, Write};
use std::process::ExitCode;

use grasp_lcp::energy::ComparisonVerdict;
use grasp_lcp::equilibrium::Outcome;
use grasp_lcp::hold::Holding;
use grasp_lcp::identify::FitEnding;
use grasp_lcp::need::Amount;
use grasp_lcp::scene::{Answer, OnsetAnswer, PathOutcome, Scene, Setup};
use grasp_lcp::shake::Repeats;
use grasp_lcp::words::{Unit, Words};

use crate::arguments::{Command, SceneArguments};
use crate::command_question::put;
use crate::failure::{EXIT_UNDECIDED, Failure};
use crate::own_masses::{refuse_turning, shared_centre};
use crate::progress_line::ProgressLine;
use crate::words::Style;
use crate::{files, report};

/// Answers the questions of a scene file, or the question of the command line, and prints the answers. The exit code is 4 if an answer is undecided,
/// i.e. if the search ended with neither a result nor a proof.
pub(crate) fn ask(ask: &SceneArguments, asked: Command) -> Result<ExitCode, Failure> {
    ask_of(files::read(&ask.scene)?, ask, asked)
}

/// Answers the questions of a scene that is already read, or the question of the command line, and prints the answers. Error messages name the file
/// `ask.scene`. The exit code is 4 if an answer is undecided.
pub(crate) fn ask_of(
    mut scene: Scene,
    ask: &SceneArguments,
    mut asked: Command,
) -> Result<ExitCode, Failure> {
    let unit = ask.unit.unwrap_or(scene.unit);
    asked.lengths_to_metres(unit);
    if let Some(centre) = shared_centre(&scene.setup) {
        refuse_turning(&asked)?;
        asked.act_at(&centre);
    }
    let (given, asked) = (scene.clone(), &asked);
    put(&mut scene.setup, asked)?;
    files::warn_at_once(&ask.scene, &scene, Some(&given))?;
    let is_decided = if ask.json {
        let answers = ProgressLine::during("answers", ask.progress, || scene.answers_in(words(ask, unit)));
        let answers = answers.map_err(|error| files::refused(&ask.scene, &error))?;
        let mut out = io::stdout().lock();
        serde_json::to_writer_pretty(&mut out, &answers).map_err(io::Error::from)?;
        writeln!(out)?;
        !answers.list().iter().any(is_undecided)
    } else {
        one_by_one(&scene.setup, ask, unit)?
    };
    ProgressLine::during("whether the stiffness left out matters", ask.progress, || {
        files::warn_of_stiffness(&ask.scene, &scene)
    })?;
    if matches!(asked, Command::Hold { vary_stiffness: true, .. }) {
        let depends = scene.setup.depends_on_tangential_stiffness();
        let depends = depends.map_err(|error| files::refused(&ask.scene, &error))?;
        let said = if depends.is_empty() {
            "and its first slip stay within"
        } else {
            "or its first slip CHANGES by more than"
        };
        eprintln!(
            "stiffness: what it holds {said} 5 % with a tenth or ten times the stiffness along tangents, of all contacts or of one"
        );
    }
    Ok(if is_decided { ExitCode::SUCCESS } else { ExitCode::from(EXIT_UNDECIDED) })
}

fn words(ask: &SceneArguments, unit: Unit) -> Words {
    Words::with_digits(ask.digits.into()).in_unit(unit)
}

/// Prints each answer at once, before the next question is answered. Returns false if an answer is undecided.
fn one_by_one(setup: &Setup<3>, ask: &SceneArguments, unit: Unit) -> Result<bool, Failure> {
    let refused = |error| files::refused(&ask.scene, &error);
    let style = Style { words: setup.words(words(ask, unit)), axes: setup.axes(), points: ask.points };
    // All questions are checked before the first answer is printed.
    setup.questions.iter().try_for_each(|question| setup.check(question)).map_err(refused)?;
    let grasp = setup.grasp().map_err(refused)?;
    let mut is_decided = true;
    for (k, question) in setup.questions.iter().enumerate() {
        let what = format!("question {} of {}", k + 1, setup.questions.len());
        let answer =
            ProgressLine::during(&what, ask.progress, || setup.answer_in(&grasp, question, style.words));
        let (answer, mut out) = (answer.map_err(refused)?, io::stdout().lock());
        if k > 0 {
            writeln!(out)?;
        }
        report::print(&mut out, style, setup, (question, &answer))?;
        is_decided &= !is_undecided(&answer);
        out.flush()?;
    }
    Ok(is_decided)
}

fn is_undecided(answer: &Answer<3>) -> bool {
    match answer {
        Answer::Hold(answer) => matches!(answer.verdict.holding, Holding::Undecided { .. }),
        Answer::Need(answer) => matches!(answer.needed.amount, Amount::Undecided { .. }),
        Answer::Solve(answer) => matches!(answer.outcome, Outcome::Undecided(_)),
        Answer::Compare(answer) => matches!(answer.comparison.verdict, ComparisonVerdict::Unsolved),
        Answer::Onset(answer) => matches!(answer, OnsetAnswer::Undecided(_)),
        Answer::OnsetOfTurn(answer) => matches!(answer.onset, OnsetAnswer::Undecided(_)),
        Answer::Shakedown(answer) => answer.found.is_none(),
        Answer::Identify(answer) => answer.identified.ending != FitEnding::Converged,
        Answer::Shake(answer) => matches!(answer.shaken.repeats, Repeats::Undecided { .. }),
        Answer::Follow(answer) => match &answer.end {
            PathOutcome::NoStart { start } => matches!(**start, Outcome::Undecided(_)),
            end => matches!(end, PathOutcome::Undecided { .. }),
        },
        _ => false,
    }
}
