//! Error and run time of polygonal cones with 4 … 128 facets in space, compared with the default, Newton's method on the round cone.
//!
//! Three grasps, two questions each: the load at which the first contact slides, and the contact forces far beyond it. The reference answers are
//! checked here from the question alone: the onset by solving the quadratic equations again, the sliding state by its balance and its contact law.
//!
//! The last table compares run times on the round cone and on a polygon, for random grasps with 3 to 20 contacts.
//!
//! `cargo run --release -p reports --bin cone_error`

mod by_hand;
mod round_cost;

use by_hand::{difference, onset_by_hand, residual};
use grasp_lcp::picture::{Chart, Stroke};
use grasp_lcp::spatial::{ContactState, Grasp};
use grasp_lcp::{PolygonCone, PolygonFit, Settings};
use support::Failure;
use support::best_time::{best_in_turns, once, timed};
use support::loaded::{Scene, dragged_block, four_fingers, three_fingers};

const FACETS: [u32; 6] = [4, 8, 16, 32, 64, 128];
/// With more contacts than this number, the polygon of 1024 facets takes too long.
const MANY: usize = 4;
/// Errors below this are rounding errors.
const ROUNDING: f64 = 1.1e-16;

/// The polygonal cones that are compared. The last one is inscribed and turned, see [`turned_onset`].
const METHODS: [&str; 4] = ["inscribed", "circumscribed", "balanced", "turned"];

fn polygon(facets: u32, method: usize) -> Result<Settings, Failure> {
    let fit = [PolygonFit::Inscribed, PolygonFit::Circumscribed, PolygonFit::Balanced, PolygonFit::Inscribed]
        [method];
    // Neither proofs of non-existence nor an enumeration of contact states are included in the time.
    let settings = Settings::default().with_most_states(0).on_the_polygon();
    Ok(settings.with_cone(PolygonCone::new(usize::try_from(facets)?, fit)?))
}

/// Facets, error and run time (s) of each polygonal cone; error and run time of the default, Newton's method on the round cone. The error of an
/// undecided answer is NaN.
struct Measured {
    polygons: Vec<Vec<(u32, f64, f64)>>,
    default: (f64, f64),
    /// Run times of a turned polygon with eight facets, and of the default, s; measured for sliding states alone.
    proposal: Option<(f64, f64)>,
}

/// The onset on a polygon that is turned so that its corners lie along the tractions at the onset of the unturned polygon.
fn turned_onset(scene: &Scene, settings: &Settings) -> Result<f64, Failure> {
    let first = Grasp::new(scene.contacts.clone())?.with(&settings.on_the_polygon()).onset(scene.ramp())?;
    let there = scene.turned(first.factor().ok_or("a sticking base")?)?;
    let second = Grasp::new(there.contacts.clone())?.with(&settings.on_the_polygon()).onset(there.ramp())?;
    Ok(second.factor().ok_or("a sticking base")?)
}

fn measure_onset(scene: &Scene) -> Result<Measured, Failure> {
    let exact = onset_by_hand(scene)?;
    let (grasp, ramp) = (Grasp::new(scene.contacts.clone())?, scene.ramp());
    let settings = Settings::default().with_most_states(0);
    let (factor, time) =
        timed(|| Ok(grasp.with(&settings).onset(&ramp)?.factor().ok_or("a sticking base")?))?;
    let mut polygons = Vec::new();
    for method in 0..METHODS.len() {
        let mut row = Vec::new();
        for facets in FACETS {
            if method == 3 && !scene.may_turn() {
                continue;
            }
            let on = polygon(facets, method)?;
            let (factor, time) = timed(|| {
                if method == 3 {
                    turned_onset(scene, &on)
                } else {
                    Ok(grasp.with(&on.on_the_polygon()).onset(&ramp)?.factor().ok_or("a sticking base")?)
                }
            })?;
            row.push((facets, (factor / exact - 1.0).abs(), time));
        }
        polygons.push(row);
    }
    println!("  onset at factor {factor:.12}, by hand {exact:.12}");
    Ok(Measured { polygons, default: ((factor / exact - 1.0).abs(), time), proposal: None })
}

fn measure_sliding(scene: &Scene) -> Result<Measured, Failure> {
    let factor = scene.deep * onset_by_hand(scene)?;
    let (grasp, load) = scene.at(factor)?;
    let held = |grasp: &Grasp, settings: &Settings| Ok(grasp.with(settings).solve(load)?);
    let (outcome, time) = timed(|| held(&grasp, &Settings::default()))?;
    let exact = outcome.equilibrium().ok_or_else(|| format!("no equilibrium: {outcome:?}"))?;
    let residual = residual(&grasp, &load, exact);
    let sliding = exact.contacts.iter().filter(|c| matches!(c.state, ContactState::Sliding { .. })).count();
    println!(
        "  sliding state at factor {factor:.6}: {sliding} of {} contacts slide, residual recomputed {residual:.0e}",
        grasp.len()
    );
    if grasp.len() <= MANY {
        let (answer, time) = once(|| held(&grasp, &polygon(1024, 0)?))?;
        if let Some(answer) = answer.equilibrium() {
            println!("  1024 facets come to {:.1e} of it in {:.1} s", difference(answer, exact), time);
        }
    }
    let (mut polygons, mut proposal) = (Vec::new(), None);
    for method in 0..METHODS.len() {
        let mut row = Vec::new();
        for facets in FACETS {
            if method == 3 && !scene.may_turn() {
                continue;
            }
            let on = polygon(facets, method)?;
            let (answer, time) = if method == 3 {
                timed(|| {
                    let turned = scene.turned(factor)?;
                    held(&turned.at(factor)?.0, &on)
                })?
            } else {
                timed(|| held(&grasp, &on))?
            };
            if method == 3 && facets == 8 {
                let ready = scene.turned(factor)?.at(factor)?.0;
                let [alone, whole] = best_in_turns([&mut || held(&ready, &on).map(drop), &mut || {
                    held(&grasp, &Settings::default()).map(drop)
                }])?;
                proposal = Some((alone, whole));
            }
            let error = answer.equilibrium().map_or(f64::NAN, |answer| difference(answer, exact));
            row.push((facets, error, time));
        }
        polygons.push(row);
    }
    Ok(Measured { polygons, default: (residual, time), proposal })
}

/// The order p of convergence, errors ~ 1/m^p with m facets, by least squares in logarithms.
fn order(row: &[(u32, f64, f64)]) -> f64 {
    let points: Vec<_> =
        row.iter().filter(|r| r.1 > 100.0 * ROUNDING).map(|r| (f64::from(r.0).ln(), r.1.ln())).collect();
    let n = points.len() as f64;
    let mean = points.iter().fold((0.0, 0.0), |m, p| (m.0 + p.0 / n, m.1 + p.1 / n));
    let (over, under) = points
        .iter()
        .fold((0.0, 0.0), |s, p| (s.0 + (p.0 - mean.0) * (p.1 - mean.1), s.1 + (p.0 - mean.0).powi(2)));
    -over / under
}

fn report(question: &str, measured: &Measured) {
    println!("  {question}: error, time in µs");
    print!("    facets");
    for method in METHODS {
        print!("{method:>24}");
    }
    println!();
    for (j, facets) in FACETS.iter().enumerate() {
        print!("    {facets:6}");
        for row in &measured.polygons {
            match row.get(j) {
                Some((_, error, time)) if error.is_nan() => {
                    print!("{:>12} {:>11.1}", "undecided", 1e6 * time);
                }
                Some((_, error, time)) => print!("{:>12.2e} {:>11.1}", error, 1e6 * time),
                None => print!("{:>24}", "-"),
            }
        }
        println!();
    }
    print!("    falls like");
    for row in measured.polygons.iter().filter(|row| !row.is_empty()) {
        print!("{:>20}    ", format!("1/m^{:.2}", order(row)));
    }
    let (error, time) = measured.default;
    println!("\n    default, on the round cone: {error:.1e}, {:.1} µs", 1e6 * time);
    let all = || measured.polygons.iter().flatten();
    let as_fast = all().filter(|r| r.2 <= time).map(|r| r.1).fold(f64::INFINITY, f64::min);
    if as_fast.is_finite() {
        println!("    the best polygon in that time: {as_fast:.1e}");
    } else {
        println!("    no polygon is as fast");
    }
    let best = all().fold((f64::INFINITY, 0.0), |b, r| if r.1 < b.0 { (r.1, r.2) } else { b });
    println!("    the best polygon of all: {:.1e} in {:.1} times that time", best.0, best.1 / time);
    if let Some((proposal, whole)) = measured.proposal {
        println!("    turned polygon {:.1} µs, round cone {:.1} µs", 1e6 * proposal, 1e6 * whole);
    }
}

fn chart(title: &str, error: &str, measured: &Measured) -> Chart {
    let (least, time) = measured.default;
    let default = vec![(time, least.max(ROUNDING))];
    let mut chart = Chart::new(title, "time of one call (s)", error).log_log();
    chart = chart.series("round cone (default)", default, Stroke::Circles);
    for (method, row) in METHODS.iter().zip(&measured.polygons).filter(|(_, row)| !row.is_empty()) {
        let points = row.iter().map(|&(_, error, time)| (time, error.max(ROUNDING))).collect();
        chart = chart.series(format!("{method}, m = 4 … 128"), points, Stroke::Line);
    }
    chart
}

fn main() -> Result<(), Failure> {
    let mut charts = Vec::new();
    for scene in [three_fingers(), four_fingers(), dragged_block()] {
        println!("{}", scene.name);
        let onset = measure_onset(&scene)?;
        report("onset", &onset);
        let sliding = measure_sliding(&scene)?;
        report("sliding state", &sliding);
        println!();
        charts.push(chart(&format!("Onset: {}", scene.name), "relative error of the onset", &onset));
        let title = format!("Far beyond it: {}", scene.name);
        charts.push(chart(&title, "error of a contact force / largest force", &sliding));
    }
    round_cost::print()?;
    support::save("cone_error.svg", &Chart::sheet(&charts, 2)?)?;
    Ok(())
}
