//! Draws what a scene asks: a planar grasp in its first equilibrium, a spatial one in its first answer and as a page with all of them; and how
//! much friction is used while a load turns.

use grasp_lcp::equilibrium::Equilibrium;
use grasp_lcp::grasp::Grasp;
use grasp_lcp::load_path::Onset;
use grasp_lcp::picture::{Chart, SpatialPage, chart_of_turn, draw_grasp};
use grasp_lcp::scene::{Question, Setup, WithGrasp};

type Failure = Box<dyn std::error::Error>;

/// The SVG of a planar scene, if a question of it has an equilibrium.
pub(crate) fn planar(setup: &Setup<3, 2>, title: &str) -> Result<Option<String>, Failure> {
    setup.with_grasp(Still { setup, title })?
}

/// The page of a spatial scene: one answer for each question that has a state to show.
pub(crate) fn spatial(setup: &Setup<6, 3>, title: &str) -> Result<SpatialPage, Failure> {
    setup.with_grasp(Page { setup, title })?
}

/// What each contact uses of its friction while the load turns, one chart for each such question; none if there is no such question.
pub(crate) fn turns<const D: usize, const C: usize>(
    setup: &Setup<D, C>,
    title: &str,
) -> Result<Option<String>, Failure> {
    let charts = setup.with_grasp(Charts { setup, title })??;
    if charts.is_empty() { Ok(None) } else { Ok(Some(Chart::sheet(&charts, 1)?)) }
}

struct Charts<'a, const D: usize, const C: usize> {
    setup: &'a Setup<D, C>,
    title: &'a str,
}

impl<const D: usize, const C: usize> WithGrasp<C> for Charts<'_, D, C> {
    type Output = Result<Vec<Chart>, grasp_lcp::Error>;
    fn with<const W: usize>(self, grasp: &Grasp<W, C>) -> Self::Output {
        let Self { setup, title } = self;
        let turns = setup.questions.iter().enumerate().filter_map(|(i, question)| match question {
            Question::OnsetOfTurn(turn) => Some((i + 1, turn)),
            _ => None,
        });
        let chart = |(number, turn)| {
            chart_of_turn(grasp, &setup.turn(turn), &setup.settings, &format!("{title}, question {number}"))
        };
        turns.map(chart).collect()
    }
}

struct Still<'a> {
    setup: &'a Setup<3, 2>,
    title: &'a str,
}

impl WithGrasp<2> for Still<'_> {
    type Output = Result<Option<String>, Failure>;
    fn with<const W: usize>(self, grasp: &Grasp<W, 2>) -> Self::Output {
        let Some((what, state)) = first_equilibrium(self.setup, grasp)? else { return Ok(None) };
        let outline: Vec<[f64; 2]> = self.setup.outline.iter().map(|corner| (*corner).into()).collect();
        Ok(Some(draw_grasp(grasp, &state, Some(&outline), &format!("{}, {what}", self.title))?))
    }
}

/// That of the first question that has one, for the picture, and which it is.
fn first_equilibrium<const W: usize>(
    setup: &Setup<3, 2>,
    grasp: &Grasp<W, 2>,
) -> Result<Option<(String, Equilibrium<W, 2>)>, grasp_lcp::Error> {
    for (index, question) in setup.questions.iter().enumerate() {
        let onset = |onset: Onset<W, 2>, at: &dyn Fn(f64) -> String| match onset {
            Onset::At(event) => Some((at(event.factor), grasp.state_at_onset(&event)?)),
            Onset::AlreadySliding(state) => Some(("it slides from the start on".to_owned(), *state)),
            _ => None,
        };
        let found = match question {
            Question::Solve { load } => {
                let outcome = grasp.solve_with(&setup.load(load), &setup.settings)?;
                outcome.equilibrium().cloned().map(|state| ("under the load".to_owned(), state))
            }
            Question::Onset(ramp) => {
                onset(grasp.onset_with(&setup.ramp(ramp)?, &setup.settings)?, &|factor| {
                    format!("onset of sliding, factor {factor:.6}")
                })
            }
            Question::OnsetOfTurn(turn) => {
                onset(grasp.onset_of_turn_with(&setup.turn(turn), &setup.settings)?.onset, &|angle| {
                    format!("onset of sliding, turned by {:.4} degrees", angle.to_degrees())
                })
            }
            _ => None,
        };
        if let Some((what, state)) = found {
            return Ok(Some((format!("question {}: {what}", index + 1), state)));
        }
    }
    Ok(None)
}

struct Page<'a> {
    setup: &'a Setup<6, 3>,
    title: &'a str,
}

impl WithGrasp<3> for Page<'_> {
    type Output = Result<SpatialPage, Failure>;
    fn with<const W: usize>(self, grasp: &Grasp<W, 3>) -> Self::Output {
        let Self { setup, title } = self;
        let mut page = SpatialPage::new(grasp, title);
        if !setup.outline.is_empty() {
            page = page.outline(setup.outline.iter().copied());
        }
        for (index, question) in setup.questions.iter().enumerate() {
            page = shown(page, setup, grasp, index + 1, question)?;
        }
        Ok(page)
    }
}

/// The page with the answer to one more question.
fn shown<const W: usize>(
    page: SpatialPage,
    setup: &Setup<6, 3>,
    grasp: &Grasp<W, 3>,
    number: usize,
    question: &Question<6, 3>,
) -> Result<SpatialPage, Failure> {
    let settings = &setup.settings;
    Ok(match question {
        Question::Solve { load } => {
            page.outcome(format!("{number}. under the load"), &grasp.solve_with(&setup.load(load), settings)?)
        }
        Question::Onset(ramp) => match grasp.onset_with(&setup.ramp(ramp)?, settings)? {
            Onset::At(event) => {
                let state = grasp.state_at_onset(&event).ok_or("its own event")?;
                page.frame(format!("{number}. onset of sliding, factor {:.6}", event.factor), &state)
            }
            Onset::AlreadySliding(state) => page.frame(format!("{number}. slides at factor 0"), &state),
            _ => page,
        },
        Question::OnsetOfTurn(turn) => match grasp.onset_of_turn_with(&setup.turn(turn), settings)?.onset {
            Onset::At(event) => {
                let state = grasp.state_at_onset(&event).ok_or("its own event")?;
                let angle = event.factor.to_degrees();
                page.frame(format!("{number}. onset of sliding, turned by {angle:.4} degrees"), &state)
            }
            Onset::AlreadySliding(state) => page.frame(format!("{number}. slides at angle 0"), &state),
            _ => page,
        },
        Question::Follow { start, legs } => {
            let mut path = grasp.follow_with(&setup.load(start), &setup.legs(legs)?, settings)?;
            let mut page = page;
            for event in path.run() {
                let changes = event.changes.iter();
                let contacts = changes.map(|(i, _)| grasp.contacts()[*i].label_text(*i));
                let drives = event.drives.iter().map(|(part, _)| grasp.label_of(*part));
                let names: Vec<_> = contacts.chain(drives).collect();
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
    })
}
