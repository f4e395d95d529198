//! How much of its friction each contact uses while the load turns.

use super::chart::Chart;
use super::palette::PALETTE;
use super::series::{ChartSeries, Stroke};
use crate::ask::Grasp;
use crate::equilibrium::{ContactAnswer, ContactState};
use crate::error::{ContactLabel, Error};
use crate::load_path::{Change, Event, Leg, PathEnd, Turn};

/// Angles at which states are drawn, events besides.
const SAMPLES: u32 = 180;
/// Events closer than this part of what is drawn have one label.
const APART: f64 = 0.15;

/// A chart of `|F_t| / (μ F_n)` of each contact against the angle, from angle 0 on along the path under the load that turns: to its last
/// angle, or to where the path ends. The first contact that stops sticking is marked, and so is the end. Contacts that are open, without
/// friction or never slide are left out; of more than eight those are drawn that use most.
///
/// ```
/// use grasp_lcp::picture::chart_of_turn;
/// use grasp_lcp::planar::{Contact, Grasp, Turn};
///
/// // A tray of 4 N between two palms that press with 10 N each, tilted until it slides.
/// let palm = |name: &str, y: f64| {
///     Contact::new([0.0, 0.01 * y], [0.0, -y]).name(name).series_stiffness(1e3, 8e2).friction(0.125).pressed_with(10.0)
/// };
/// let palms = Grasp::new([palm("below", -1.0), palm("above", 1.0)])?;
/// let turn = Turn::tilting([0.0, -4.0], [0.0, 0.0]);
/// let svg = chart_of_turn(&palms, &turn, "A tray")?.to_svg()?;
/// assert!(svg.contains("lost: above on the edge") && svg.contains("angle (degrees)"));
/// // A tray that falls from the start on has no curve.
/// let heavy = Turn::tilting([40.0, 0.0], [0.0, 0.0]);
/// assert!(chart_of_turn(&palms, &heavy, "A tray")?.to_svg().is_err());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// As for [`Grasp::onset_of_turn`].
pub fn chart_of_turn<const C: usize>(grasp: &Grasp<C>, turn: &Turn<C>, title: &str) -> Result<Chart, Error> {
    let mut path = grasp.follow(&turn.load_at(0.0), &[Leg::turn(turn)])?;
    let events = path.run();
    let degrees = |fraction: f64| (fraction * turn.angle()).to_degrees();
    let last = path.end().and_then(PathEnd::fraction).unwrap_or(1.0);
    let mut fractions: Vec<f64> = (0..=SAMPLES).map(|k| last * f64::from(k) / f64::from(SAMPLES)).collect();
    fractions.extend(events.iter().map(|event| event.fraction));
    fractions.sort_by(f64::total_cmp);
    let mut curves = vec![Vec::with_capacity(fractions.len()); grasp.len()];
    let on_the_way = fractions.into_iter().map(|fraction| Some((fraction, path.state_at(0, fraction)?)));
    let end = path.state().map(|state| (path.place().1, state));
    for (fraction, state) in on_the_way.chain([end]).flatten() {
        for ((curve, answer), contact) in curves.iter_mut().zip(&state.contacts).zip(grasp.contacts()) {
            curve.push((degrees(fraction), part_used(answer, contact.friction)));
        }
    }
    let named = curves.into_iter().enumerate().map(|(i, points)| ChartSeries {
        name: grasp.contacts()[i].label_text(i),
        points,
        stroke: Stroke::Line,
    });
    let mut chart = Chart::new(title, "angle (degrees)", "friction used, |F_t| / (μ F_n)");
    for ChartSeries { name, points, stroke } in fullest(named.collect()) {
        chart = chart.series(name, points, stroke);
    }
    let left = events.iter().find_map(|event| Some((event.fraction, left_by(event)?)));
    let end = match path.end() {
        Some(PathEnd::Lost(loss)) => {
            let names: Vec<_> = loss.contacts.iter().map(ContactLabel::text).collect();
            let who =
                if left.is_none() { format!(": {} on the edge", names.join(", ")) } else { String::new() };
            Some((last, format!("lost{who}")))
        }
        Some(PathEnd::Undecided { .. }) => Some((last, "undecided beyond".to_owned())),
        _ => None,
    };
    let marks = match (left, end) {
        (Some((at, left)), Some((to, end))) if to - at < APART * to => vec![(at, format!("{left}, {end}"))],
        (left, end) => left.into_iter().chain(end).collect(),
    };
    Ok(marks.into_iter().fold(chart, |chart, (fraction, label)| chart.mark(degrees(fraction), label)))
}

/// The part of its friction that a contact uses; not a number where that says nothing.
fn part_used<const C: usize>(answer: &ContactAnswer<C>, friction: f64) -> f64 {
    match answer.state {
        ContactState::Sticking | ContactState::Sliding { .. } if answer.margin.is_finite() => {
            answer.friction_used() / friction
        }
        _ => f64::NAN,
    }
}

/// The curves that there are, or as many as there are colours for: those that come highest.
fn fullest(mut curves: Vec<ChartSeries>) -> Vec<ChartSeries> {
    let most = |series: &ChartSeries| series.points.iter().map(|(_, y)| *y).fold(f64::NEG_INFINITY, f64::max);
    curves.retain(|series| most(series).is_finite());
    let mut highest: Vec<f64> = curves.iter().map(most).collect();
    highest.sort_by(|a, b| b.total_cmp(a));
    if let Some(least) = highest.get(PALETTE.len() - 1) {
        curves.retain(|series| most(series) >= *least);
        curves.truncate(PALETTE.len());
    }
    curves
}

/// Who stops sticking at an event, and how, if anybody does.
fn left_by<const C: usize>(event: &Event<C>) -> Option<String> {
    let word = |change: &Change<C>| match change {
        Change::Slides { .. } => Some("slides"),
        Change::Opens => Some("opens"),
        _ => None,
    };
    let mut changes = event.changes.iter();
    let contact =
        changes.find_map(|change| Some(format!("{} {}", change.contact.text(), word(&change.what)?)));
    contact.or_else(|| event.drives.first().map(|drive| format!("{} gives way", drive.part.text())))
}
