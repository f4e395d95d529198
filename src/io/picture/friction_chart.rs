//! Charts of the friction force of each contact along a load path, as a fraction of its limit μ F_n. A soft fingertip counts as one contact. A leg is
//! a section of the load program. Along a leg, load and commands change linearly, or the load turns. An event is a change of contact states at one
//! point of the path. A jump is a sudden motion of the object under constant load. A drive is the spring of a joint or tendon of a hand, with its
//! force limit.

use super::chart::Chart;
use super::fingertip::without_rounding;
use super::layout::CHART;
use super::palette::PALETTE;
use super::series::{ChartSeries, Stroke};
use super::words::shortened;
use crate::ask::Grasp;
use crate::equilibrium::{ContactAnswer, ContactState, Equilibrium};
use crate::error::Error;
use crate::grasp::{Contact, ContactPoints, Hold, WholeContacts, Wrench};
use crate::load_path::{Change, Event, Leg, LoadPath, PathEnd};
use crate::numerics::{IntoList, largest, mapped, moved, sort_by_number};
use crate::words::opens;

/// Largest number of curves in a chart: each colour has a solid and a dashed line. The note below the chart names further curves.
pub(super) const MOST_CURVES: usize = 2 * PALETTE.len();

/// A load program with its grasp, and the horizontal axis along which a chart draws the equilibria of the load path.
pub(super) struct DrawnProgram<'a, const C: usize> {
    pub(super) grasp: &'a Grasp<C>,
    pub(super) start: Wrench<C>,
    pub(super) legs: &'a [Leg<C>],
    pub(super) axis: &'a str,
    /// The position on the horizontal axis of a point of the load path. The point is given by the index of a leg, and by the fraction of this leg
    /// that is done.
    pub(super) place: &'a dyn Fn(usize, f64) -> f64,
}

impl<const C: usize> DrawnProgram<'_, C> {
    /// The chart with one curve per contact, from the start to the end of the path. One mark shows the first point of the path at which a contact
    /// slides or opens, or a drive reaches its limit. Another shows where the path ends, if it ends before the end of the program.
    pub(super) fn chart(&self, title: &str) -> Result<Chart, Error> {
        let mut path = self.grasp.follow(self.start, self.legs)?;
        let events = path.run();
        let tips = self.grasp.engine.wholes();
        let states = self.states(&path, &events);
        let curve = |tip: &ContactPoints| -> Vec<(f64, f64)> {
            let used = |(x, state): &(f64, Equilibrium<C>)| {
                (*x, friction_fraction(tip, self.grasp.contacts(), state))
            };
            mapped(&states, &used)
        };
        let named = tips
            .iter()
            .map(|tip| (tip, ChartSeries { name: tip.text(), points: curve(tip), stroke: Stroke::Line }));
        let mut chart = Chart::new(title, self.axis, "friction used, |F_t| / (μ F_n)");
        let SharedCurves { drawn, left_out } = shared(named.collect(), self.grasp.contacts());
        for (k, series) in drawn.iter().enumerate() {
            let is_hidden = drawn[..k].iter().any(|earlier| coincide(earlier, series));
            let stroke = if is_hidden || k >= PALETTE.len() { Stroke::Dashed } else { Stroke::Line };
            chart = chart.series(series.name.clone(), series.points.clone(), stroke);
        }
        if !left_out.is_empty() && !states.is_empty() {
            chart = chart.note(format!("Not drawn: {}.", left_out.join("; ")));
        }
        let marks = self.marks(&path, &events);
        Ok(marks.into_iter().fold(chart, |chart, (x, label)| chart.mark(x, label)))
    }

    /// The point up to which the load program was followed: the index of the last leg, from 0, and the fraction of this leg.
    pub(super) fn followed_to(&self, path: &LoadPath<C>) -> (usize, f64) {
        let last = path.end().and_then(|end| Some((end.leg()?, end.fraction()?)));
        last.unwrap_or((self.legs.len().saturating_sub(1), 1.0))
    }

    /// Equilibria along the load path for the curves of the chart, each with its position on the horizontal axis. They are taken at regular
    /// intervals, at events, and after jumps.
    pub(super) fn states(&self, path: &LoadPath<C>, events: &[Event<C>]) -> Vec<(f64, Equilibrium<C>)> {
        let (last, end) = self.followed_to(path);
        let on_leg = |leg: usize| {
            let to = if leg == last { end } else { 1.0 };
            let turns = self.legs.get(leg).is_some_and(Leg::turns);
            // On a leg (a section of the load program) along which the load changes linearly, curves are smooth between events, and few points
            // suffice. The events themselves are added.
            let count = if turns { 180 } else { (48 / (last + 1)).max(16) };
            let mut fractions: Vec<f64> = (0..=count).map(|k| to * k as f64 / count as f64).list();
            fractions.extend(events.iter().filter(|event| event.leg == leg).map(|event| event.fraction));
            sort_by_number(&mut fractions, &|fraction| *fraction);
            fractions.into_iter().map(move |fraction| (leg, fraction))
        };
        let on_the_way = (0..=last).flat_map(on_leg);
        // A jump at an event, i.e. a sudden change of equilibrium at constant load, adds the equilibrium after the jump at the same position.
        let after = |leg: usize, part: f64| {
            let here = events.iter().find(|event| (event.leg, event.fraction) == (leg, part))?;
            Some(here.jump.as_ref()?.state.clone())
        };
        let on_the_way = on_the_way.flat_map(|(leg, part)| {
            let states = [path.state_at(leg, part), after(leg, part)];
            states.into_iter().flatten().map(move |state| ((self.place)(leg, part), state))
        });
        let at_the_end = path.state().map(|state| {
            let (leg, part) = path.place();
            ((self.place)(leg, part), state)
        });
        on_the_way.chain(at_the_end).list()
    }

    pub(super) fn marks(&self, path: &LoadPath<C>, events: &[Event<C>]) -> Vec<(f64, String)> {
        let tips = self.grasp.engine.wholes();
        let left = events
            .iter()
            .find_map(|event| Some(((self.place)(event.leg, event.fraction), change_in_words(event, tips)?)));
        let (last, part) = self.followed_to(path);
        let to = (self.place)(last, part);
        let end = match path.end() {
            Some(PathEnd::Lost(loss)) => {
                let edge = |tip: &&ContactPoints| {
                    loss.contacts.iter().any(|contact| tip.range.contains(&contact.index))
                };
                let names: Vec<_> = tips.iter().filter(edge).map(ContactPoints::text).list();
                let names = some(&names, 2, CHART.mark_letters);
                let who = if left.is_none() { format!(": {names} on the edge") } else { String::new() };
                Some((to, format!("lost{who}")))
            }
            Some(PathEnd::Undecided { .. }) => Some((to, "undecided beyond".to_owned())),
            _ => None,
        };
        match (left, end) {
            // If the first change of a contact or drive and the end of the path are close, they share one label.
            (Some((at, left)), Some((to, end))) if to - at < 0.15 * to => {
                vec![(at, format!("{left}, {end}"))]
            }
            (left, end) => left.into_iter().chain(end).list(),
        }
    }
}

/// The fraction of its friction that a fingertip uses: the sum of the friction forces of its points divided by the sum of their limits μ F_n. It is 1
/// if all points slide. It is NaN if no point sticks or slides with finite friction, or if the forces are rounding errors.
fn friction_fraction<const C: usize>(
    tip: &ContactPoints,
    contacts: &[Contact<C>],
    state: &Equilibrium<C>,
) -> f64 {
    let (answers, contacts) = (&state.contacts[tip.range.clone()], &contacts[tip.range.clone()]);
    let force = largest(answers, &|answer| answer.force.norm());
    if force > 0.0 && without_rounding(force, state) == 0.0 {
        return f64::NAN;
    }
    let rubs = |answer: &&ContactAnswer<C>| {
        matches!(answer.state, ContactState::Sticking | ContactState::Sliding { .. })
            && answer.margin.is_finite()
    };
    if let ([answer], [contact]) = (answers, contacts) {
        return if rubs(&answer) {
            answer.friction_used() / contact.friction_coefficient()
        } else {
            f64::NAN
        };
    }
    // The margin is μ F_n - |F_t|; friction force and margin therefore add up to the limit μ F_n.
    let (used, all) = answers.iter().filter(rubs).fold((0.0, 0.0), |(used, all), answer| {
        (used + answer.friction_force(), all + answer.friction_force() + answer.margin)
    });
    if all > 0.0 { used / all } else { f64::NAN }
}

/// The curves that a chart draws, and the texts of its note. Each text names contacts without a curve, and the reason why they have none.
struct SharedCurves {
    drawn: Vec<ChartSeries>,
    left_out: Vec<String>,
}

/// Divides the curves of the contacts into curves that the chart draws and curves that its note names. Only curves with a finite value are drawn. If
/// there are more than [`MOST_CURVES`] such curves, those with the largest values are drawn.
fn shared<const C: usize>(
    curves: Vec<(&ContactPoints, ChartSeries)>,
    contacts: &[Contact<C>],
) -> SharedCurves {
    let most = |series: &ChartSeries| series.points.iter().map(|(_, y)| *y).fold(f64::NEG_INFINITY, f64::max);
    let mut left_out = Vec::new();
    let (mut drawn, none): (Vec<_>, Vec<_>) =
        curves.into_iter().partition(|(_, series)| most(series).is_finite());
    for why in ["no friction", "glued", "friction without limit", "never touches"] {
        let those = none.iter().filter(|(tip, _)| no_curve(&contacts[tip.range.start]) == why);
        let names: Vec<_> = those.map(|(tip, _)| tip.text()).list();
        if !names.is_empty() {
            left_out.push(format!("{} ({why})", some(&names, CHART.listed_names, CHART.listed_letters)));
        }
    }
    let mut highest: Vec<f64> = mapped(&drawn, &|(_, series)| most(series));
    sort_by_number(&mut highest, &|factor| *factor);
    highest.reverse();
    if drawn.len() > MOST_CURVES {
        let least = highest[MOST_CURVES - 1];
        let mut room = MOST_CURVES;
        let (kept, lower): (Vec<_>, Vec<_>) = drawn.into_iter().partition(|(_, series)| {
            let is_kept = room > 0 && most(series) >= least;
            room -= usize::from(is_kept);
            is_kept
        });
        let names: Vec<_> = mapped(&lower, &|(tip, _)| tip.text());
        left_out.push(format!(
            "{} that use no more than {least:.3} of their friction: {}",
            names.len(),
            some(&names, CHART.listed_names, CHART.listed_letters)
        ));
        drawn = kept;
    }
    SharedCurves { drawn: moved(drawn, &|(_, series)| series), left_out }
}

/// Whether two curves coincide on paper. If so, the caller draws the second curve dashed, which keeps both visible.
fn coincide(a: &ChartSeries, b: &ChartSeries) -> bool {
    let near = |(p, q): (&(f64, f64), &(f64, f64))| match (p.1.is_nan(), q.1.is_nan()) {
        // A difference of two fractions of friction of at most 4e-3 is invisible on paper.
        (false, false) => (p.1 - q.1).abs() <= 4e-3,
        (none, neither) => none == neither,
    };
    a.points.iter().zip(&b.points).all(near)
}

/// The reason why a contact has no curve: glued, no friction, infinite friction, or else never touching.
fn no_curve<const C: usize>(contact: &Contact<C>) -> &'static str {
    let friction = contact.friction_coefficient();
    if contact.hold == Hold::Bonded {
        "glued"
    } else if friction == 0.0 {
        "no friction"
    } else if friction.is_infinite() {
        "friction without limit"
    } else {
        "never touches"
    }
}

/// The first `most` names, joined by commas and each shortened to `letters`, and the number of the others.
pub(super) fn some(names: &[String], most: usize, letters: usize) -> String {
    let more = names.len().saturating_sub(most);
    let shown: Vec<_> = mapped(&names[..names.len() - more], &|name| shortened(name, letters));
    let shown = shown.join(", ");
    if more > 0 { format!("{shown} and {more} more") } else { shown }
}

/// The first contact that slides or opens at an event, or else the first drive that reaches its limit, in words such as "left slides". `None` if
/// neither exists.
fn change_in_words<const C: usize>(event: &Event<C>, tips: &WholeContacts) -> Option<String> {
    let contact = event.changes.iter().find_map(|change| {
        let tip = tips.at(change.contact.index);
        let change_text = match (&change.what, tip.is_soft()) {
            (Change::Slides { .. }, false) => "slides",
            (Change::Opens, false) => opens(change.contact.link),
            (Change::Slides { .. }, true) => "begins to slide",
            (Change::Opens, true) => "begins to open",
            _ => return None,
        };
        Some(format!("{} {change_text}", shortened(&tip.text(), CHART.mark_letters)))
    });
    contact.or_else(|| event.drives.first().map(|drive| format!("{} gives way", drive.part.text())))
}
