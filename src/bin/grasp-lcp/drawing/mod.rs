//! Pictures of a scene: one for each question, a page with all of them, and charts of friction forces as fractions of their limits.

mod charts;
mod shown;

use grasp_lcp::picture::{Chart, Page, View};
use grasp_lcp::scene::{Answer, Scene, Setup};
use grasp_lcp::words::Words;

use self::charts::{chart, cycles};
use self::shown::{PictureContent, ShownState, shown};
use crate::failure::Failure;
use crate::files::Pictures;

/// Draws a scene: an HTML page and still pictures (SVG) of its answers, or of the grasp alone, and charts.
pub(crate) fn draw(scene: &Scene, pictures: &Pictures) -> Result<(), Failure> {
    let setup = &scene.setup;
    let words = setup.words(Words::default().in_unit(scene.unit));
    let answers = scene.answers_in(words)?;
    charts(setup, answers.list(), pictures)?;
    let grasp = setup.grasp()?;
    let mut page = Page::new(&grasp, pictures.title());
    if !setup.outline.is_empty() {
        page = page.outline(setup.outline.iter().copied());
    }
    for (number, body) in setup.bodies.iter().enumerate().filter(|(_, body)| !body.outline.is_empty()) {
        page = page.body_outline(number, body.outline.iter().copied());
    }
    #[cfg(feature = "mesh")]
    if let Some(part) = setup.part_read() {
        page = part.edges(SHARP).into_iter().fold(page, Page::outline);
    }
    let mut stills = Vec::new();
    for (index, (question, answer)) in setup.questions.iter().zip(answers.list()).enumerate() {
        let answers = shown(setup, &grasp, question, answer.clone(), words)?;
        let keys = answers.keys().into_iter();
        stills.extend(keys.map(|(key, besides)| (ending(index + 1, besides), page.answers() + key)));
        for ShownState { label, mut says, grasp: other, what } in answers.0 {
            let label = format!("{}. {label}", index + 1);
            page = match what {
                PictureContent::State { state, leaving } => {
                    let page = page.frame_of(label, other.as_ref().unwrap_or(&grasp), &state);
                    page.maybe_leaving(leaving.as_ref())
                }
                PictureContent::Nothing { load } => {
                    let page = page.nothing(label, said_first(&mut says));
                    if let Some(load) = load { page.under(load) } else { page }
                }
            };
            page = says.into_iter().fold(page, Page::says);
        }
    }
    // A planar grasp without an answer has no page, because a page shows no more than the picture. A spatial grasp can be turned on its page.
    if setup.axes() == 3 || page.answers() > 0 {
        pictures.save(".html", &page.to_html()?)?;
    }
    if stills.is_empty() {
        return pictures.save(".svg", &page.to_svg(None, View::default())?);
    }
    for (ending, answer) in stills {
        pictures.save(&ending, &page.to_svg(Some(answer), View::default())?)?;
    }
    Ok(())
}

/// If the grasped object is given as a mesh, an edge between two faces is drawn if their normals differ by more than this angle, rad.
#[cfg(feature = "mesh")]
const SHARP: f64 = 0.5;

/// The end of a picture's file name: `_` and the number of the question, omitted for the first question; then the text `besides`, which tells several
/// pictures of one question apart, and `.svg`.
fn ending(number: usize, besides: &str) -> String {
    if number == 1 { format!("{besides}.svg") } else { format!("_{number}{besides}.svg") }
}

/// Removes and returns the first line of an answer, which says why there is no equilibrium to show.
fn said_first(says: &mut Vec<String>) -> String {
    if says.is_empty() { String::new() } else { says.remove(0) }
}

/// Saves two files of charts. The first has a chart for each question with a load path, one below the other: the fraction of its friction limit that
/// each contact uses. The second has charts of slips and friction forces over the cycles of repeated loads.
fn charts(setup: &Setup<3>, answers: &[Answer<3>], pictures: &Pictures) -> Result<(), Failure> {
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
