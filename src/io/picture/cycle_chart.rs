//! Charts of the slips of contacts while a load repeats, and of the loops of friction force against slip in the last cycle. The base load acts before
//! the repeated loads and stays constant. A leg is a section of a load program.

use nalgebra::SVector;

use super::chart::Chart;
use super::friction_chart::{DrawnProgram, MOST_CURVES, some};
use super::layout::CHART;
use super::palette::PALETTE;
use super::series::Stroke;
use crate::ask::Grasp;
use crate::equilibrium::Equilibrium;
use crate::error::Error;
use crate::grasp::{ContactPoints, Wrench};
use crate::load_path::Leg;
use crate::numerics::{IntoList, chosen, highest, increasing, largest, mapped, moved};

/// Two charts of `count` cycles that begin under the base load. The first chart has the slip of each contact against the number of cycles. The second
/// has the friction of each contact against its slip in the last cycle. The area within a loop of the second chart is the heat of that cycle. Slip
/// and friction are components along the direction in which the contact slips farthest. For a soft fingertip the chart shows the mean slip of its
/// points and the sum of their forces. A note names the contacts without a curve: they never slide, or slide less than the sixteen contacts that are
/// drawn. Charts without a curve are omitted: both charts if no contact slides, the second chart if no contact slides in the last cycle.
///
/// ```
/// use grasp_lcp::picture::charts_of_cycles;
/// use grasp_lcp::planar::{Contact, Grasp, Leg, Wrench};
///
/// // A block on two feet that is pulled, and rocked to and fro: it walks.
/// let foot = |name: &str, x: f64| Contact::new([x, 0.0], [0.0, 1.0]).name(name).series_stiffness(1e5, 1e5).friction(0.5);
/// let block = Grasp::new([foot("left foot", -0.1), foot("right foot", 0.1)])?;
/// let rock = |moment: f64| [0.4, -0.4].map(|part| Leg::there_and_back(Wrench::new([0.0, 0.0], part * moment))).concat();
/// let pulled = Wrench::force([3.5, -10.0]);
/// let charts = charts_of_cycles(&block, &pulled, &rock(1.0), 4, "A block")?;
/// assert!(charts[0].to_svg()?.contains("cycles") && charts[1].to_svg()?.contains("friction (N)"));
/// assert!(charts_of_cycles(&block, &pulled, &rock(0.1), 4, "A block")?.is_empty());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`Error::Wrench`] if a load, or [`Error::Contact`] if a command, is not finite or beyond 1e50; [`Error::Size`] if a leg has more or fewer commands
/// than there are contacts.
pub fn charts_of_cycles<const C: usize>(
    grasp: &Grasp<C>,
    base: &Wrench<C>,
    cycle: &[Leg<C>],
    count: usize,
    title: &str,
) -> Result<Vec<Chart>, Error> {
    let legs: Vec<_> = (0..count).flat_map(|_| cycle.iter().cloned()).list();
    let place = |leg: usize, fraction: f64| (leg as f64 + fraction) / cycle.len() as f64;
    let drawn = DrawnProgram { grasp, start: *base, legs: &legs, axis: "cycles", place: &place };
    let mut path = grasp.follow(base, &legs)?;
    let events = path.run();
    let states = drawn.states(&path, &events);
    let tips = grasp.engine.wholes();
    let slides: Vec<_> = mapped(tips, &|tip| SlipHistory::of(tip, &states));
    let farthest = largest(&slides, &|slide| slide.farthest);
    // Slips below this fraction of the longest slip count as zero, so that rounding errors give no curves.
    let no_slip = 1e-6;
    let is_link = |tip: usize| tips[tip].label.link.is_some();
    let mut order: Vec<_> = chosen(tips.len(), &|k| !is_link(*k) && slides[*k].farthest > no_slip * farthest);
    if order.is_empty() {
        return Ok(Vec::new());
    }
    let lengths: Vec<f64> = mapped(&order, &|k| -slides[*k].farthest);
    order = moved(increasing(&lengths), &|i| order[i]);
    let others = if order.len() > MOST_CURVES { "slide less, or nowhere" } else { "slide nowhere" };
    order.truncate(MOST_CURVES);
    order.sort_unstable();
    let (leg, fraction) = drawn.followed_to(&path);
    let last = place(leg, fraction).ceil().max(1.0);
    let mut slips = Chart::new(format!("{title}: slip"), drawn.axis, "slip (mm)");
    let mut loops = Chart::new(format!("{title}: friction in cycle {last}"), "slip (mm)", "friction (N)");
    for (k, tip) in order.iter().enumerate() {
        let (name, curve) = (tips[*tip].text(), &slides[*tip].curve);
        let stroke = if k < PALETTE.len() { Stroke::Line } else { Stroke::Dashed };
        slips = slips.series(name.clone(), mapped(curve, &|(x, slip, _)| (*x, *slip)), stroke);
        let of_the_last: Vec<_> = curve.iter().filter(|(x, ..)| *x >= last - 1.0).list();
        let slips = || of_the_last.iter().map(|(_, slip, _)| *slip);
        if slips().fold(f64::MIN, f64::max) - slips().fold(f64::MAX, f64::min) > no_slip * farthest {
            loops = loops.series(name, mapped(&of_the_last, &|(_, s, force)| (*s, *force)), stroke);
        }
    }
    let listed = |those: Vec<usize>| {
        let names: Vec<_> = mapped(&those, &|tip| tips[*tip].text());
        (!names.is_empty()).then(|| some(&names, CHART.listed_names, CHART.listed_letters))
    };
    let rest = listed(chosen(tips.len(), &|tip| !is_link(*tip) && !order.contains(tip)))
        .map(|names| format!("Not drawn: {names} ({others})."));
    let links = listed(chosen(tips.len(), &|tip| is_link(*tip)))
        .map(|names| format!("Links, such as bolts and straps, do not slide: {names}."));
    let notes: Vec<_> = rest.into_iter().chain(links).list();
    if !notes.is_empty() {
        slips = slips.note(notes.join(" "));
    }
    let marks = drawn.marks(&path, &events);
    let slips = marks.into_iter().fold(slips, |chart, (x, label)| chart.mark(x, label));
    Ok(vec![slips, loops].into_iter().filter(|chart| !chart.is_empty()).list())
}

/// Slip and friction of a contact during all cycles, along the direction of its largest slip.
struct SlipHistory {
    /// Largest slip since the beginning of the first cycle, mm.
    farthest: f64,
    /// Points of the curves: position on the axis of cycles, slip in mm, and friction in N.
    curve: Vec<(f64, f64, f64)>,
}

impl SlipHistory {
    fn of<const C: usize>(tip: &ContactPoints, states: &[(f64, Equilibrium<C>)]) -> Self {
        let points = tip.range.len() as f64;
        let tangential = |mut vector: SVector<f64, C>| {
            vector[0] = 0.0;
            vector
        };
        let slip = |state: &Equilibrium<C>| {
            let slips = state.contacts[tip.range.clone()].iter().map(|answer| answer.slip);
            tangential(slips.sum::<SVector<f64, C>>()) * (1e3 / points)
        };
        let force = |state: &Equilibrium<C>| {
            tangential(state.contacts[tip.range.clone()].iter().map(|answer| answer.force).sum())
        };
        let start = states.first().map_or_else(SVector::zeros, |(_, state)| slip(state));
        let moved = |state: &Equilibrium<C>| slip(state) - start;
        let moves = mapped(states, &|(_, state)| moved(state));
        let longest = highest(&moves, &SVector::norm).copied().unwrap_or_else(SVector::zeros);
        let farthest = longest.norm();
        let along = if farthest > 0.0 { longest / farthest } else { longest };
        let curve = states.iter().map(|(x, state)| (*x, along.dot(&moved(state)), along.dot(&force(state))));
        Self { farthest, curve: curve.list() }
    }
}
