//! Draws what a scene asks: a planar grasp in its first equilibrium, a spatial one in its first answer and as a page with all of them.

use grasp_lcp::picture::{SpatialPage, draw_grasp};
use grasp_lcp::planar;
use grasp_lcp::scene::{Question, Setup};
use grasp_lcp::spatial::Onset;

type Failure = Box<dyn std::error::Error>;

/// The SVG of a planar scene, if a question of it has an equilibrium.
pub(crate) fn planar(setup: &Setup<3, 2>, title: &str) -> Result<Option<String>, Failure> {
    let Some(state) = first_equilibrium(setup)? else { return Ok(None) };
    let outline: Vec<[f64; 2]> = setup.outline.iter().map(|corner| (*corner).into()).collect();
    Ok(Some(draw_grasp(&setup.grasp()?, &state, Some(&outline), title)?))
}

/// That of the first question that has one, for the picture.
fn first_equilibrium(setup: &Setup<3, 2>) -> Result<Option<planar::Equilibrium>, grasp_lcp::Error> {
    let grasp = setup.grasp()?;
    for question in &setup.questions {
        let state = match question {
            Question::Solve { load } => grasp.solve_with(load, &setup.settings)?.equilibrium().cloned(),
            Question::Onset(ramp) => match grasp.onset_with(&setup.ramp(ramp)?, &setup.settings)? {
                planar::Onset::At(event) => grasp.state_at_onset(&event),
                planar::Onset::AlreadySliding(state) => Some(*state),
                _ => None,
            },
            _ => None,
        };
        if state.is_some() {
            return Ok(state);
        }
    }
    Ok(None)
}

/// The page of a spatial scene: one answer for each question that has a state to show.
pub(crate) fn spatial(setup: &Setup<6, 3>, title: &str) -> Result<SpatialPage, Failure> {
    let (grasp, settings) = (setup.grasp()?, &setup.settings);
    let mut page = SpatialPage::new(&grasp, title);
    if !setup.outline.is_empty() {
        page = page.outline(setup.outline.iter().copied());
    }
    for (index, question) in setup.questions.iter().enumerate() {
        let number = index + 1;
        page = match question {
            Question::Solve { load } => {
                page.outcome(format!("{number}. under the load"), &grasp.solve_with(load, settings)?)
            }
            Question::Onset(ramp) => match grasp.onset_with(&setup.ramp(ramp)?, settings)? {
                Onset::At(event) => {
                    let state = grasp.state_at_onset(&event).ok_or("its own event")?;
                    page.frame(format!("{number}. onset of sliding, factor {:.6}", event.factor), &state)
                }
                Onset::AlreadySliding(state) => page.frame(format!("{number}. slides at factor 0"), &state),
                _ => page,
            },
            Question::Follow { start, legs } => {
                let mut path = grasp.follow_with(start, &setup.legs(legs)?, settings)?;
                for event in path.run() {
                    let changes = event.changes.iter();
                    let names: Vec<_> = changes.map(|(i, _)| grasp.contacts()[*i].label_text(*i)).collect();
                    let label = format!(
                        "{number}. leg {} at {:.6}: {} changes",
                        event.leg,
                        event.fraction,
                        names.join(", ")
                    );
                    page = page.frame(label, &event.state);
                }
                match path.position() {
                    Some((leg, fraction, state)) => {
                        page.frame(format!("{number}. leg {leg} at {fraction:.6}: the path's end"), &state)
                    }
                    None => page,
                }
            }
            _ => page,
        };
    }
    Ok(page)
}
