//! Charts of friction. Along a load path they show the friction force of each contact, as a fraction of its limit. For a repeated load they show
//! slips and friction forces. The base load acts from the start; the load of the question, times a load factor that grows from zero, acts in
//! addition. First slip is the event at which the first contact ceases to stick.

use grasp_lcp::ask::Grasp;
use grasp_lcp::picture::{Chart, chart_of_load, chart_of_program, chart_of_turn, charts_of_cycles};
use grasp_lcp::scene::{Answer, OnsetAnswer, Question, Setup};

use crate::failure::Failure;

/// The right end of the axis of load factors, divided by the largest load factor of interest, so that the curves go on a little beyond it. Load
/// factors of interest are 1 (the load itself), that of first slip, and that at which equilibrium is lost.
const CHART_END: f64 = 1.25;

/// The chart of a question with a load path: for each contact one curve, the fraction of its friction limit that the contact uses along the path.
/// `None` for a question without a load path.
pub(super) fn chart(
    setup: &Setup<3>,
    grasp: &Grasp<3>,
    (question, answer): (&Question<3>, &Answer<3>),
    title: &str,
) -> Result<Option<Chart>, Failure> {
    let grasp = &setup.grasp_of(grasp, question)?;
    Ok(match (&*setup.meant(question)?, answer) {
        (Question::Hold { .. }, Answer::Hold(answer)) => {
            let (ramp, verdict) = (question.ramp()?, &answer.verdict);
            let first_slip = verdict.first_slip.as_ref().map(|first| first.factor);
            let marks = [first_slip, verdict.lost.as_ref().map(|lost| lost.factor)];
            // If first slip or the loss of equilibrium is beyond five times the load, it does not extend the chart. Otherwise the range of load
            // factors from 0 to 1 would become too small.
            let farthest = marks.into_iter().flatten().filter(|factor| *factor <= 5.0).fold(1.0, f64::max);
            let chart = chart_of_load(grasp, &ramp, CHART_END * farthest, title)?;
            let reaches = verdict.held_to >= 1.0;
            Some(if reaches { chart.mark(1.0, "this load") } else { chart })
        }
        (Question::Onset { .. }, Answer::Onset(onset)) => {
            let factor = match onset {
                OnsetAnswer::At(event) => event.at.factor,
                OnsetAnswer::GivesWay { at, .. } => at.factor,
                OnsetAnswer::NoBase(_) | OnsetAnswer::Undecided(_) => return Ok(None),
                _ => 1.0,
            };
            let farthest = if factor > 0.0 { factor } else { 1.0 };
            Some(chart_of_load(grasp, &question.ramp()?, CHART_END * farthest, title)?)
        }
        (Question::OnsetOfTurn(turn), _) => Some(chart_of_turn(grasp, turn, title)?),
        (Question::Follow { start, legs, in_steps: None }, _) if !legs.is_empty() => {
            Some(chart_of_program(grasp, *start, legs, title)?)
        }
        _ => None,
    })
}

/// Charts of a repeated load that begins under the base load; none for any other question. The first has the slips of contacts in each cycle. The
/// second has the loops of friction force against slip in the last cycle. The charts have as many cycles as were computed for the answer, but at
/// least 4 and at most 12.
pub(super) fn cycles(
    setup: &Setup<3>,
    grasp: &Grasp<3>,
    (question, answer): (&Question<3>, &Answer<3>),
    title: &str,
) -> Result<Vec<Chart>, Failure> {
    let (Question::Shake { base, .. }, Answer::Shake(answer)) = (question, answer) else {
        return Ok(Vec::new());
    };
    let (grasp, cycle) = (&setup.grasp_of(grasp, question)?, question.legs()?);
    Ok(charts_of_cycles(grasp, base, &cycle, answer.shaken.cycles.clamp(4, 12), title)?)
}
