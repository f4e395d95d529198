//! Questions of a scene, or of the command line in their place.

use std::io::{self, Write};
use std::process::ExitCode;

use grasp_lcp::equilibrium::Outcome;
use grasp_lcp::grasp::Wrench;
use grasp_lcp::scene::{
    Answer, Answers, Goal, LegAsked, OnsetAnswer, PathOutcome, Question, RampAsked, Setup, Space,
};
use grasp_lcp::{planar, spatial};

use crate::arguments::{Ask, LoadArguments, Numbers};
use crate::failure::{Failure, UNDECIDED};
use crate::{files, report};

/// What is asked.
pub(crate) enum Asked {
    Everything,
    Solve(LoadArguments),
    Onset(LoadArguments),
    Turn { weight: Option<Numbers>, at: Option<Numbers>, axis: Option<Numbers> },
    Follow { to: Vec<Numbers>, at: Option<Numbers> },
}

/// Asks and prints. The code says whether everything is decided.
pub(crate) fn ask(ask: &Ask, asked: &Asked) -> Result<ExitCode, Failure> {
    let mut scene = files::read(&ask.scene)?;
    match &mut scene.space {
        Space::Planar(setup) => {
            let moment = |m: &[f64]| planar::Wrench::new([0.0; 2], m[0]);
            put(setup, asked, &Words { force_at: planar::Wrench::force_at, moment, turn: planar_turn })?;
        }
        Space::Spatial(setup) => {
            let moment = |m: &[f64]| spatial::Wrench::new([0.0; 3], [m[0], m[1], m[2]]);
            put(setup, asked, &Words { force_at: spatial::Wrench::force_at, moment, turn: spatial_turn })?;
        }
    }
    let answers = scene.answers()?;
    let mut out = io::stdout().lock();
    if ask.json {
        serde_json::to_writer_pretty(&mut out, &answers).map_err(io::Error::from)?;
        writeln!(out)?;
    } else {
        if let Some(comment) = &scene.comment {
            writeln!(out, "{comment}")?;
        }
        match (&scene.space, &answers) {
            (Space::Planar(setup), Answers::Planar(answers)) => report::print(&mut out, setup, answers)?,
            (Space::Spatial(setup), Answers::Spatial(answers)) => report::print(&mut out, setup, answers)?,
            _ => {}
        }
    }
    let undecided = match &answers {
        Answers::Planar(list) => list.iter().any(is_undecided),
        Answers::Spatial(list) => list.iter().any(is_undecided),
    };
    Ok(if undecided { ExitCode::from(UNDECIDED) } else { ExitCode::SUCCESS })
}

/// A weight, where it acts and the axis, as a question about a load that turns.
type TurnOf<const C: usize> =
    fn(&Numbers, Option<&Numbers>, Option<&Numbers>) -> Result<Question<C>, Failure>;

/// What the numbers of the command line mean in the plane, or in space.
struct Words<const C: usize> {
    force_at: fn([f64; C], [f64; C]) -> Wrench<C>,
    /// Of as many components as there are planes to turn in.
    moment: fn(&[f64]) -> Wrench<C>,
    turn: TurnOf<C>,
}

/// Puts the question of the command line in place of the scene's; without one, those of its kind stay.
fn put<const C: usize>(setup: &mut Setup<C>, asked: &Asked, words: &Words<C>) -> Result<(), Failure> {
    let question = match asked {
        Asked::Everything | Asked::Turn { weight: None, at: None, axis: None } => None,
        Asked::Solve(load) => words.wrench(load)?.map(|load| Question::Solve { load }),
        Asked::Onset(load) => words.wrench(load)?.map(|load| Question::Onset(RampAsked::along(load))),
        Asked::Turn { weight: Some(weight), at, axis } => {
            Some((words.turn)(weight, at.as_ref(), axis.as_ref())?)
        }
        Asked::Turn { weight: None, .. } => return Err(Failure::Usage("--weight is missing".to_owned())),
        Asked::Follow { to, at } => words.follow(to, at.as_ref())?,
    };
    match question {
        Some(question) => setup.questions = vec![question],
        None => setup.questions.retain(|question| is_of_kind(question, asked)),
    }
    if setup.questions.is_empty() {
        let message = match asked {
            Asked::Everything => {
                "the scene asks nothing: use `onset`, `solve`, `turn` or `follow` with a load"
            }
            Asked::Solve(_) | Asked::Onset(_) => "the scene has no such question: say --force or --moment",
            Asked::Turn { .. } => "the scene has no such question: say --weight",
            Asked::Follow { .. } => "the scene has no such question: say --to",
        };
        return Err(Failure::Usage(message.to_owned()));
    }
    Ok(())
}

fn is_of_kind<const C: usize>(question: &Question<C>, asked: &Asked) -> bool {
    match asked {
        Asked::Everything => true,
        Asked::Solve(_) => matches!(question, Question::Solve { .. }),
        Asked::Onset(_) => matches!(question, Question::Onset(_)),
        Asked::Turn { .. } => matches!(question, Question::OnsetOfTurn(_)),
        Asked::Follow { .. } => matches!(question, Question::Follow { .. }),
    }
}

impl<const C: usize> Words<C> {
    /// The load of the command line, if there is one.
    fn wrench(&self, load: &LoadArguments) -> Result<Option<Wrench<C>>, Failure> {
        let LoadArguments { force, moment, at } = load;
        if force.is_none() && at.is_some() {
            return Err(Failure::Usage("--at without --force: a moment acts anywhere".to_owned()));
        }
        let mut all = Wrench::ZERO;
        if let Some(force) = force {
            all = self.push(force, "force", at.as_ref())?;
        }
        if let Some(moment) = moment {
            let (given, expected) = (moment.0.len(), C * (C - 1) / 2);
            if given != expected {
                return Err(Failure::Usage(format!("--moment: {given} given, must be {expected}")));
            }
            all = all + (self.moment)(&moment.0);
        }
        Ok((force.is_some() || moment.is_some()).then_some(all))
    }

    /// A force at a point.
    fn push(&self, force: &Numbers, option: &str, at: Option<&Numbers>) -> Result<Wrench<C>, Failure> {
        let force = force.array(option).map_err(Failure::Usage)?;
        let at = at.map_or(Ok([0.0; C]), |at| at.array("at")).map_err(Failure::Usage)?;
        Ok((self.force_at)(force, at))
    }

    fn follow(&self, to: &[Numbers], at: Option<&Numbers>) -> Result<Option<Question<C>>, Failure> {
        if to.is_empty() {
            return Ok(None);
        }
        let leg = |force| self.push(force, "to", at).map(|load| LegAsked::new(Some(Goal::To(load)), None));
        let legs = to.iter().map(leg).collect::<Result<_, _>>()?;
        Ok(Some(Question::Follow { start: Wrench::ZERO, legs }))
    }
}

fn planar_turn(
    weight: &Numbers,
    at: Option<&Numbers>,
    axis: Option<&Numbers>,
) -> Result<Question<2>, Failure> {
    if axis.is_some() {
        return Err(Failure::Usage("--axis: there is none in the plane".to_owned()));
    }
    let weight = weight.array("weight").map_err(Failure::Usage)?;
    let at = at.map_or(Ok([0.0; 2]), |at| at.array("at")).map_err(Failure::Usage)?;
    Ok(Question::OnsetOfTurn(planar::Turn::tilting(weight, at)))
}

fn spatial_turn(
    weight: &Numbers,
    at: Option<&Numbers>,
    axis: Option<&Numbers>,
) -> Result<Question<3>, Failure> {
    let axis =
        axis.ok_or_else(|| Failure::Usage("--axis is missing: about which the grasp is tilted".to_owned()))?;
    let weight = weight.array("weight").map_err(Failure::Usage)?;
    let at = at.map_or(Ok([0.0; 3]), |at| at.array("at")).map_err(Failure::Usage)?;
    let turn = spatial::Turn::tilting(weight, at, axis.array::<3>("axis").map_err(Failure::Usage)?)?;
    Ok(Question::OnsetOfTurn(turn))
}

fn is_undecided<const C: usize>(answer: &Answer<C>) -> bool {
    match answer {
        Answer::Solve(answer) => matches!(answer, Outcome::Undecided(_)),
        Answer::Onset(answer) => matches!(answer, OnsetAnswer::Undecided(_)),
        Answer::OnsetOfTurn(answer) => matches!(answer.onset, OnsetAnswer::Undecided(_)),
        Answer::Follow(answer) => matches!(answer.end, PathOutcome::Undecided { .. }),
        _ => false,
    }
}
