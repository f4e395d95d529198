//! Pictures of a scene: one for each question, a page for a spatial grasp, and charts of the friction that is used.

mod charts;
mod shown;

use grasp_lcp::nalgebra::Vector2;
use grasp_lcp::picture::{Chart, PlanarPage, PlanarPicture, SpatialPage, View};
use grasp_lcp::scene::{Answer, Scene, Setup, Space};
use grasp_lcp::words::Words;

use self::charts::{chart, cycles};
use self::shown::{Shown, What, shown};
use crate::failure::Failure;
use crate::files::Pictures;

/// Draws a scene.
pub(crate) fn draw(scene: &Scene, pictures: &Pictures) -> Result<(), Failure> {
    let words = Words::default().in_unit(scene.unit);
    match &scene.space {
        Space::Planar(setup) => {
            let answers = setup.answers_in(words)?;
            charts(setup, &answers, pictures)?;
            planar(setup, answers, words, pictures)
        }
        Space::Spatial(setup) => {
            let answers = setup.answers_in(words)?;
            charts(setup, &answers, pictures)?;
            spatial(setup, answers, words, pictures)
        }
    }
}

/// Edges of a part are drawn where its faces meet at more than this angle, rad.
#[cfg(feature = "mesh")]
const SHARP: f64 = 0.5;

/// The end of a picture's file name: `_` and the number of the question, left out for the first question; then `besides` and `.svg`.
fn ending(number: usize, besides: &str) -> String {
    if number == 1 { format!("{besides}.svg") } else { format!("_{number}{besides}.svg") }
}

/// Removes and returns the first line of an answer, which says why there is no equilibrium to show.
fn said_first(says: &mut Vec<String>) -> String {
    if says.is_empty() { String::new() } else { says.remove(0) }
}

/// A picture for each question: its equilibrium, or the grasp alone.
fn planar(
    setup: &Setup<2>,
    answers: Vec<Answer<2>>,
    words: Words,
    pictures: &Pictures,
) -> Result<(), Failure> {
    let (grasp, title) = (setup.grasp()?, pictures.title());
    let corners = |outline: &Vec<Vector2<f64>>| outline.iter().map(|corner| (*corner).into()).collect();
    let of_bodies = setup.bodies.iter().map(|body| &body.outline);
    let outlines: Vec<Vec<[f64; 2]>> = if setup.bodies.is_empty() {
        vec![corners(&setup.outline)]
    } else {
        of_bodies.map(corners).collect()
    };
    let outlines = || outlines.iter().map(Vec::as_slice);
    if setup.questions.is_empty() {
        return pictures.save(".svg", &PlanarPicture::new(&grasp, &title).outlines(outlines()).to_svg()?);
    }
    let mut page = PlanarPage::new(&grasp, &title).outlines(outlines());
    let mut stills = Vec::new();
    for (index, (question, answer)) in setup.questions.iter().zip(answers).enumerate() {
        let answers = shown(setup, &grasp, question, answer, words)?;
        let keys = answers.keys();
        for (k, Shown { label, mut says, grasp: other, what }) in answers.0.into_iter().enumerate() {
            let grasp = other.as_ref().unwrap_or(&grasp);
            if let Some((_, besides)) = keys.iter().find(|(key, _)| *key == k) {
                let title = format!("{title}, question {}: {label}", index + 1);
                let mut picture = PlanarPicture::new(grasp, &title).outlines(outlines());
                for sentence in &says {
                    picture = picture.says(sentence);
                }
                let picture = match &what {
                    What::State { state, leaving } => picture.state(state).maybe_leaving(leaving.as_ref()),
                    What::Nothing { load: Some(load) } => picture.load(*load),
                    What::Nothing { load: None } => picture,
                };
                stills.push((ending(index + 1, besides), picture.to_svg()?));
            }
            let label = format!("{}. {label}", index + 1);
            page = match what {
                What::State { state, leaving } => {
                    page.frame_of(label, grasp, &state).maybe_leaving(leaving.as_ref())
                }
                What::Nothing { load } => {
                    let page = page.nothing(label, said_first(&mut says));
                    if let Some(load) = load { page.under(load) } else { page }
                }
            };
            page = says.into_iter().fold(page, PlanarPage::says);
        }
    }
    pictures.save(".html", &page.to_html()?)?;
    stills.iter().try_for_each(|(end, still)| pictures.save(end, still))
}

/// The page with all answers, and a picture for each question.
fn spatial(
    setup: &Setup<3>,
    answers: Vec<Answer<3>>,
    words: Words,
    pictures: &Pictures,
) -> Result<(), Failure> {
    let grasp = setup.grasp()?;
    let mut page = SpatialPage::new(&grasp, pictures.title());
    if !setup.outline.is_empty() {
        page = page.outline(setup.outline.iter().copied());
    }
    for (number, body) in setup.bodies.iter().enumerate().filter(|(_, body)| !body.outline.is_empty()) {
        page = page.body_outline(number, body.outline.iter().copied());
    }
    #[cfg(feature = "mesh")]
    if let Some(part) = setup.part_read() {
        page = part.edges(SHARP).into_iter().fold(page, SpatialPage::outline);
    }
    let mut stills = Vec::new();
    for (index, (question, answer)) in setup.questions.iter().zip(answers).enumerate() {
        let answers = shown(setup, &grasp, question, answer, words)?;
        let keys = answers.keys().into_iter();
        stills.extend(keys.map(|(key, besides)| (ending(index + 1, besides), page.answers() + key)));
        for Shown { label, mut says, grasp: other, what } in answers.0 {
            let label = format!("{}. {label}", index + 1);
            page = match what {
                What::State { state, leaving } => {
                    let page = page.frame_of(label, other.as_ref().unwrap_or(&grasp), &state);
                    page.maybe_leaving(leaving.as_ref())
                }
                What::Nothing { load } => {
                    let page = page.nothing(label, said_first(&mut says));
                    if let Some(load) = load { page.under(load) } else { page }
                }
            };
            page = says.into_iter().fold(page, SpatialPage::says);
        }
    }
    pictures.save(".html", &page.to_html()?)?;
    if stills.is_empty() {
        return pictures.save(".svg", &page.to_svg(None, View::default())?);
    }
    for (ending, answer) in stills {
        pictures.save(&ending, &page.to_svg(Some(answer), View::default())?)?;
    }
    Ok(())
}

/// Saves the charts of the fraction of friction that each contact uses, one below the other for each question with a load path; and charts of cycles.
fn charts<const C: usize>(
    setup: &Setup<C>,
    answers: &[Answer<C>],
    pictures: &Pictures,
) -> Result<(), Failure> {
    let (grasp, title) = (setup.grasp()?, pictures.title());
    let mut charts = Vec::new();
    for (index, (question, answer)) in setup.questions.iter().zip(answers).enumerate() {
        charts.extend(chart(setup, &grasp, (question, answer), &format!("{title}, question {}", index + 1))?);
    }
    charts.retain(|chart| !chart.is_empty());
    if !charts.is_empty() {
        pictures.save("_friction.svg", &Chart::sheet(&charts, 1)?)?;
    }
    let mut of_cycles = Vec::new();
    for (index, (question, answer)) in setup.questions.iter().zip(answers).enumerate() {
        of_cycles.extend(cycles(
            setup,
            &grasp,
            (question, answer),
            &format!("{title}, question {}", index + 1),
        )?);
    }
    if of_cycles.is_empty() { Ok(()) } else { pictures.save("_cycles.svg", &Chart::sheet(&of_cycles, 2)?) }
}
