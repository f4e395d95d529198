//! Draws what a scene asks: a planar grasp in its first equilibrium, a spatial one in its first answer and as a page with all of them; and how
//! much friction is used while a load turns.

use grasp_lcp::ask::Grasp;
use grasp_lcp::equilibrium::Equilibrium;
use grasp_lcp::load_path::{Onset, OnsetEvent, Ramp};
use grasp_lcp::picture::{Chart, SpatialPage, View, chart_of_turn, draw_grasp};
use grasp_lcp::scene::{Question, Scene, Setup, Space};

use crate::failure::Failure;
use crate::files::Pictures;

/// Draws a scene.
pub(crate) fn draw(scene: &Scene, pictures: &Pictures<'_>) -> Result<(), Failure> {
    let title = pictures.title();
    let turns = match &scene.space {
        Space::Planar(setup) => {
            pictures.save(".svg", &planar(setup, &title)?)?;
            turns(setup, &title)?
        }
        Space::Spatial(setup) => {
            let page = spatial(setup, &title)?;
            pictures.save(".html", &page.to_html()?)?;
            let first = (page.answers() > 0).then_some(0);
            pictures.save(".svg", &page.to_svg(first, View::default())?)?;
            turns(setup, &title)?
        }
    };
    turns.map_or(Ok(()), |svg| pictures.save("_friction.svg", &svg))
}

/// The SVG of a planar scene in the first equilibrium that a question of it has; without one there is nothing to draw.
fn planar(setup: &Setup<2>, title: &str) -> Result<String, Failure> {
    let grasp = setup.grasp()?;
    let Some((what, state)) = first_equilibrium(setup, &grasp)? else {
        let why = "nothing to draw: no question of the scene has an equilibrium or an onset to show";
        return Err(Failure::Usage(why.to_owned()));
    };
    let outline: Vec<[f64; 2]> = setup.outline.iter().map(|corner| (*corner).into()).collect();
    Ok(draw_grasp(&grasp, &state, Some(&outline), &format!("{title}, {what}"))?)
}

/// The page of a spatial scene: one answer for each question that has a state to show.
fn spatial(setup: &Setup<3>, title: &str) -> Result<SpatialPage, Failure> {
    let grasp = setup.grasp()?;
    let mut page = SpatialPage::new(&grasp, title);
    if !setup.outline.is_empty() {
        page = page.outline(setup.outline.iter().copied());
    }
    for (index, question) in setup.questions.iter().enumerate() {
        page = shown(page, setup, &grasp, index + 1, question)?;
    }
    Ok(page)
}

/// What each contact uses of its friction while the load turns, one chart for each such question; none if there is no such question.
fn turns<const C: usize>(setup: &Setup<C>, title: &str) -> Result<Option<String>, Failure> {
    let grasp = setup.grasp()?;
    let turns = setup.questions.iter().enumerate().filter_map(|(i, question)| match question {
        Question::OnsetOfTurn(turn) => Some((i + 1, turn)),
        _ => None,
    });
    let chart = |(number, turn)| chart_of_turn(&grasp, turn, &format!("{title}, question {number}"));
    let charts = turns.map(chart).collect::<Result<Vec<_>, _>>()?;
    if charts.is_empty() { Ok(None) } else { Ok(Some(Chart::sheet(&charts, 1)?)) }
}

/// That of the first question that has one, for the picture, and which it is.
fn first_equilibrium(
    setup: &Setup<2>,
    grasp: &Grasp<2>,
) -> Result<Option<(String, Equilibrium<2>)>, grasp_lcp::Error> {
    for (index, question) in setup.questions.iter().enumerate() {
        let onset = |onset: Onset<2>, at: &dyn Fn(f64) -> String| match onset {
            Onset::At(event) => Some((at(event.factor), grasp.state_at_onset(&event)?)),
            Onset::AlreadySliding(state) => Some(("it slides from the start on".to_owned(), *state)),
            _ => None,
        };
        let found = match question {
            Question::Hold { base, load } => {
                let verdict = grasp.hold(Ramp::load(*base, *load))?;
                let lost = verdict.lost.and_then(|lost| lost.state).map(|state| ("where it is lost", state));
                let state = verdict.state.map(|state| ("under the load", state)).or(lost);
                state.map(|(where_it_is, state)| (where_it_is.to_owned(), *state))
            }
            Question::Solve { load } => {
                let outcome = grasp.solve(load)?;
                outcome.equilibrium().cloned().map(|state| ("under the load".to_owned(), state))
            }
            Question::Onset(ramp) => onset(grasp.onset(&setup.ramp(ramp)?)?, &|factor| {
                format!("onset of sliding, factor {factor:.6}")
            }),
            Question::OnsetOfTurn(turn) => onset(grasp.onset_of_turn(turn)?.onset, &|angle| {
                format!("onset of sliding, turned by {:.4} degrees", angle.to_degrees())
            }),
            _ => None,
        };
        if let Some((what, state)) = found {
            return Ok(Some((format!("question {}: {what}", index + 1), state)));
        }
    }
    Ok(None)
}

/// The equilibrium at an onset of the grasp itself.
fn its_state<const C: usize>(grasp: &Grasp<C>, event: &OnsetEvent<C>) -> Result<Equilibrium<C>, Failure> {
    let lost =
        || Failure::Scene("the equilibrium at the onset is not accurate enough to be drawn".to_owned());
    grasp.state_at_onset(event).ok_or_else(lost)
}

/// The page with the answer to one more question.
fn shown(
    page: SpatialPage,
    setup: &Setup<3>,
    grasp: &Grasp<3>,
    number: usize,
    question: &Question<3>,
) -> Result<SpatialPage, Failure> {
    Ok(match question {
        Question::Hold { base, load } => {
            let verdict = grasp.hold(Ramp::load(*base, *load))?;
            let lost = verdict.lost.and_then(|lost| lost.state);
            match (verdict.state, lost) {
                (Some(state), _) => page.frame(format!("{number}. under the load"), &state),
                (None, Some(state)) => page.frame(format!("{number}. where it is lost"), &state),
                (None, None) => page,
            }
        }
        Question::Solve { load } => page.outcome(format!("{number}. under the load"), &grasp.solve(load)?),
        Question::Onset(ramp) => match grasp.onset(&setup.ramp(ramp)?)? {
            Onset::At(event) => {
                let state = its_state(grasp, &event)?;
                page.frame(format!("{number}. onset of sliding, factor {:.6}", event.factor), &state)
            }
            Onset::AlreadySliding(state) => page.frame(format!("{number}. slides at factor 0"), &state),
            _ => page,
        },
        Question::OnsetOfTurn(turn) => match grasp.onset_of_turn(turn)?.onset {
            Onset::At(event) => {
                let state = its_state(grasp, &event)?;
                let angle = event.factor.to_degrees();
                page.frame(format!("{number}. onset of sliding, turned by {angle:.4} degrees"), &state)
            }
            Onset::AlreadySliding(state) => page.frame(format!("{number}. slides at angle 0"), &state),
            _ => page,
        },
        Question::Follow { start, legs } => {
            let mut path = grasp.follow(start, &setup.legs(legs)?)?;
            let mut page = page;
            for event in path.run() {
                let contacts = event.changes.iter().map(|change| change.contact.text());
                let drives = event.drives.iter().map(|drive| drive.part.text());
                let names: Vec<_> = contacts.chain(drives).collect();
                let label = format!(
                    "{number}. leg {} at {:.6}: {} changes",
                    event.leg,
                    event.fraction,
                    names.join(", ")
                );
                page = page.frame(label, &event.state);
            }
            match path.state() {
                Some(state) => {
                    let (leg, fraction) = path.place();
                    page.frame(format!("{number}. leg {leg} at {fraction:.6}: the path's end"), &state)
                }
                None => page,
            }
        }
        _ => page,
    })
}
