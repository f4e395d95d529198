//! Charts of the friction that is used along a load path.

use grasp_lcp::ask::Grasp;
use grasp_lcp::load_path::Onset;
use grasp_lcp::picture::{Chart, chart_of_load, chart_of_program, chart_of_turn, charts_of_cycles};
use grasp_lcp::scene::{Question, Setup};

use crate::failure::Failure;

/// The end of a chart, as a multiple of the farthest load factor of interest: the load itself, first slip or loss.
const CHART_END: f64 = 1.25;

/// The chart of a question, if it has a load path.
pub(super) fn chart<const C: usize>(
    setup: &Setup<C>,
    grasp: &Grasp<C>,
    question: &Question<C>,
    title: &str,
) -> Result<Option<Chart>, Failure> {
    let grasp = &setup.grasp_of(grasp, question)?;
    Ok(match &*setup.meant(question)? {
        Question::Hold { .. } => {
            let ramp = question.ramp()?;
            let verdict = grasp.hold(ramp.clone())?;
            let marks = [verdict.first_slip.map(|first| first.factor), verdict.lost.map(|lost| lost.factor)];
            // The path beyond this load factor would fill the chart.
            let farthest = marks.into_iter().flatten().filter(|factor| *factor <= 5.0).fold(1.0, f64::max);
            let chart = chart_of_load(grasp, &ramp, CHART_END * farthest, title)?;
            let reaches = verdict.held_to >= 1.0;
            Some(if reaches { chart.mark(1.0, "this load") } else { chart })
        }
        Question::Onset { .. } => {
            let ramp = question.ramp()?;
            match grasp.onset(&ramp)? {
                Onset::At(event) if event.factor > 0.0 => {
                    Some(chart_of_load(grasp, &ramp, CHART_END * event.factor, title)?)
                }
                Onset::GivesWay { factor, .. } if factor > 0.0 => {
                    Some(chart_of_load(grasp, &ramp, CHART_END * factor, title)?)
                }
                Onset::NoBase(_) | Onset::Undecided(_) => None,
                _ => Some(chart_of_load(grasp, &ramp, CHART_END, title)?),
            }
        }
        Question::OnsetOfTurn(turn) => Some(chart_of_turn(grasp, turn, title)?),
        Question::Follow { start, legs, in_steps: None } if !legs.is_empty() => {
            Some(chart_of_program(grasp, *start, legs, title)?)
        }
        _ => None,
    })
}

/// Slips under a repeated load, cycle by cycle from rest, and the loop that remains.
pub(super) fn cycles<const C: usize>(
    setup: &Setup<C>,
    grasp: &Grasp<C>,
    question: &Question<C>,
    title: &str,
) -> Result<Vec<Chart>, Failure> {
    let Question::Shake { base, .. } = question else { return Ok(Vec::new()) };
    let (grasp, cycle) = (&setup.grasp_of(grasp, question)?, question.legs()?);
    let until = grasp.shake(base, &cycle)?.cycles;
    Ok(charts_of_cycles(grasp, base, &cycle, until.clamp(4, 12), title)?)
}
