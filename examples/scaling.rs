//! How do the solvers scale, from a pinch to a hundred thousand contacts?
//!
//! `cargo run --release --example scaling` prints each figure, best of several runs, beside the dense solver in the same run
//! where that is still affordable (load paths beside `Grasp::follow`). One function a group of rows; `main` is the table of contents.
#![allow(clippy::doc_markdown)]

use std::error::Error;
use std::hint::black_box;
use std::time::Instant;

use grasp_lcp::formulation::PolygonCone;
use grasp_lcp::grasp::{Grasp, Wrench};
use grasp_lcp::load_path::{Leg, PathEnd};
use grasp_lcp::structured::{Search, Workspace};
use grasp_lcp::{Settings, planar, spatial};
use nalgebra::SVector;

type Outcome = Result<(), Box<dyn Error>>;

fn main() -> Outcome {
    println!("{:<58} {:>12} {:>12} {:>9}  remarks", "work", "time", "dense", "ratio");
    few_contacts()?;
    patches()?;
    whole_paths()?;
    growth()?;
    whole_solve()
}

/// Three to five contacts in space, 8 facets, some sliding: one solve in a workspace that has seen the grasp before.
fn few_contacts() -> Outcome {
    for count in 3..=5 {
        let (grasp, load) = fingers(count)?;
        let mut workspace = Workspace::default();
        let time = best(2000, || {
            black_box(workspace.solve(black_box(&grasp), black_box(&load)).is_ok());
        });
        let dense = dense(&grasp, &load, 200);
        row(
            &format!("equilibrium, {count} contacts in space, 8 facets"),
            time,
            dense,
            &found(&mut workspace, &grasp, &load)?,
        );
    }
    Ok(())
}

/// Patches two thirds of which slide in the plane, half in space: by Lemke's method alone, and with Newton's method as a start.
fn patches() -> Outcome {
    for n in [100, 1000, 10_000, 100_000] {
        let (grasp, load) = planar_patch(n)?;
        patch("plane", &grasp, &load, n <= 300)?;
    }
    for n in [100, 1000, 10_000] {
        let (grasp, load) = spatial_patch(n)?;
        patch("space", &grasp, &load, n <= 100)?;
    }
    Ok(())
}

fn patch<const D: usize, const C: usize>(
    place: &str,
    grasp: &Grasp<D, C>,
    load: &Wrench<D>,
    affordable: bool,
) -> Outcome {
    let runs = (20_000 / grasp.len()).clamp(3, 50);
    let mut workspace = Workspace::default();
    let lemke = best(runs, || {
        black_box(workspace.solve_along_one_path(grasp, load).is_ok());
    });
    let remarks = remark(workspace.solve_along_one_path(grasp, load)?);
    let dense = if affordable { dense(grasp, load, 3) } else { f64::NAN };
    let name = format!("equilibrium, patch in the {place}, n = {}", grasp.len());
    row(&format!("{name}, Lemke"), lemke, dense, &remarks);
    let newton = best(runs, || {
        black_box(workspace.solve(grasp, load).is_ok());
    });
    row(&format!("{name}, Newton first"), newton, dense, &found(&mut workspace, grasp, load)?);
    Ok(())
}

/// Whole load paths, pressed to begin with and sheared up to where most of the patch slides, and back: every event exact, from the
/// public question on, with the equilibrium to start from; beside `Grasp::follow` where that is still affordable.
fn whole_paths() -> Outcome {
    for n in [100, 1000, 10_000, 100_000] {
        let (grasp, load) = planar_patch(n)?;
        whole_path("plane", &grasp, &load, n <= 100)?;
    }
    for n in [100, 1000] {
        let (grasp, load) = spatial_patch(n)?;
        whole_path("space", &grasp, &load, n <= 100)?;
    }
    Ok(())
}

fn whole_path<const D: usize, const C: usize>(
    place: &str,
    grasp: &Grasp<D, C>,
    load: &Wrench<D>,
    affordable: bool,
) -> Outcome {
    // Along the normals, which all contacts share.
    let press = SVector::from_fn(|k, _| if k == C - 1 { load.as_vector()[k] } else { 0.0 });
    let press = Wrench::from_vector(press);
    let there_and_back = [Leg::load_to(*load), Leg::load_to(press)];
    for (name, legs) in [("", &there_and_back[..1]), (" and back", &there_and_back)] {
        let mut path = grasp.follow_patch(press, legs)?;
        let events = path.by_ref().count();
        let residual = path.state().map_or(f64::NAN, |state| state.residuals.worst());
        let looked = path.contacts_looked_at() as f64 / events as f64;
        let how = if matches!(path.end(), Some(PathEnd::Completed)) { "" } else { ", not completed" };
        let time = best((20_000 / grasp.len()).clamp(5, 50), || {
            black_box(grasp.follow_patch(press, legs).map_or(0, Iterator::count));
        });
        let settings = Settings::default().on_the_polygon();
        let whole = || grasp.follow_with(press, legs, &settings).map(|mut path| path.run().len());
        let long = if affordable { best(3, || drop(black_box(whole()))) } else { f64::NAN };
        row(
            &format!("load path{name}, patch in the {place}, n = {}", grasp.len()),
            time,
            long,
            &format!("{events} events of {looked:.0} contacts, residual {residual:.1e}{how}"),
        );
    }
    Ok(())
}

/// The exponent p of n^p between 10³ and 10⁵ contacts in the plane.
fn growth() -> Outcome {
    let mut times = Vec::new();
    for n in [1000, 100_000] {
        let (grasp, load) = planar_patch(n)?;
        let mut workspace = Workspace::default();
        times.push(best((20_000 / n).clamp(3, 20), || {
            black_box(workspace.solve_along_one_path(&grasp, &load).is_ok());
        }));
    }
    println!("growth of Lemke's cost from n = 10³ to 10⁵: n^{:.2}", (times[1] / times[0]).log10() / 2.0);
    Ok(())
}

/// From the public question to the answer as physics: building the scene with its validation, and solving it.
fn whole_solve() -> Outcome {
    for n in [10_000, 100_000] {
        let build = best(3, || {
            black_box(planar_patch(n).is_ok());
        });
        let (grasp, load) = planar_patch(n)?;
        let mut worst = f64::NAN;
        let solve = best(3, || {
            if let Ok(outcome) = grasp.solve_with(&load, &Settings::default()) {
                worst = outcome.equilibrium().map_or(f64::NAN, |e| e.residuals.worst());
            }
        });
        row(&format!("building the grasp, plane, n = {n}"), build, f64::NAN, "");
        row(&format!("Grasp::solve, plane, n = {n}"), solve, f64::NAN, &format!("residual {worst:.1e}"));
    }
    Ok(())
}

/// Fingers around a body, pressed unevenly, under a load that makes some of them slide.
fn fingers(count: usize) -> Result<(spatial::Grasp, spatial::Wrench), grasp_lcp::Error> {
    let contact = |i: usize| {
        let (sin, cos) = (std::f64::consts::TAU * i as f64 / count as f64).sin_cos();
        spatial::Contact::new([cos, sin, 0.2 * uneven(i)], [-cos, -sin, 0.1])
            .tangent([0.0, 0.0, 1.0])
            .series_stiffness(10.0, 8.0)
            .friction(0.3)
            .command([0.1 * (0.4 + uneven(i)), 0.02 * uneven(i + 7), 0.0])
    };
    let pull = if count == 3 { 0.33 } else { 0.27 };
    let grasp = spatial::Grasp::new((0..count).map(contact))?;
    Ok((grasp, spatial::Wrench::new([0.02, 0.03, -pull * count as f64], [0.0, 0.0, 0.02])))
}

/// A pad along x, pressed most in the middle and sheared until the outer two thirds slide.
fn planar_patch(n: usize) -> Result<(planar::Grasp, planar::Wrench), grasp_lcp::Error> {
    let press = |i: usize| {
        let x = (i as f64 + 0.5) / n as f64 * 2.0 - 1.0;
        (x, (1.0 - x * x).sqrt() * (0.95 + 0.1 * uneven(i)))
    };
    let contact = |i: usize| {
        let (x, press) = press(i);
        planar::Contact::new([x, 0.0], [0.0, 1.0])
            .series_stiffness(1.0, 0.8)
            .friction(0.3)
            .command([press, 0.0])
    };
    let grasp = planar::Grasp::new((0..n).map(contact))?;
    let pressed: f64 = (0..n).map(|i| press(i).1).sum();
    Ok((grasp, planar::Wrench::new([0.98 * 0.3 * pressed, -pressed], 0.0)))
}

/// A round pad, pressed most in the middle, sheared and turned until the outer half slides.
fn spatial_patch(n: usize) -> Result<(spatial::Grasp, spatial::Wrench), grasp_lcp::Error> {
    let place = |i: usize| {
        let r = ((i as f64 + 0.5) / n as f64).sqrt();
        (r, i as f64 * 2.399_963_229_728_653, (1.0 - r * r).sqrt() * (0.95 + 0.1 * uneven(i)))
    };
    let contact = |i: usize| {
        let (r, angle, press) = place(i);
        let (sin, cos) = angle.sin_cos();
        spatial::Contact::new([r * cos, r * sin, 0.0], [0.0, 0.0, 1.0])
            .tangent([1.0, 0.0, 0.0])
            .series_stiffness(1.0, 0.8)
            .friction(0.3)
            .command([press, 0.0, 0.0])
    };
    let grasp = spatial::Grasp::new((0..n).map(contact))?;
    let pressed: f64 = (0..n).map(|i| place(i).2).sum();
    let load = spatial::Wrench::new([0.23 * pressed, 0.07 * pressed, -pressed], [0.0, 0.0, 0.035 * pressed]);
    Ok((grasp, load))
}

/// A fixed sequence without structure in [0, 1).
fn uneven(i: usize) -> f64 {
    (i as f64 * 0.618_033_988_749_894_9 + 0.37).fract()
}

/// The kinematic form made and solved as a dense problem, without check of the answer as physics.
fn dense<const D: usize, const C: usize>(grasp: &Grasp<D, C>, load: &Wrench<D>, runs: usize) -> f64 {
    best(runs, || {
        if let Ok(Some(form)) = grasp.kinematic_form(load, &PolygonCone::default()) {
            black_box(form.lcp.solve());
        }
    })
}

fn found<const D: usize, const C: usize>(
    workspace: &mut Workspace<D, C>,
    grasp: &Grasp<D, C>,
    load: &Wrench<D>,
) -> Result<String, grasp_lcp::Error> {
    Ok(remark(workspace.solve(grasp, load)?))
}

fn remark<const D: usize, const C: usize>(search: Search<'_, D, C>) -> String {
    let Search::Found(view) = search else { return format!("{search:?}") };
    let mut last = None;
    let slides = view.jumps().filter(|row| last.replace(contact_of(row)) != Some(contact_of(row))).count();
    let way =
        view.newton_steps().map_or(format!("{} pivots", view.pivots()), |steps| format!("{steps} steps"));
    format!("{slides} of {} slide, {way}, residual {:.1e}", view.forces().len(), view.residual())
}

fn contact_of(row: &grasp_lcp::formulation::Row) -> usize {
    use grasp_lcp::formulation::Row;
    match *row {
        Row::Gap { contact } | Row::Slip { contact, .. } => contact,
        _ => usize::MAX,
    }
}

/// Best time of several runs, s.
fn best(runs: usize, mut work: impl FnMut()) -> f64 {
    (0..runs)
        .map(|_| {
            let start = Instant::now();
            work();
            start.elapsed().as_secs_f64()
        })
        .fold(f64::INFINITY, f64::min)
}

fn row(work: &str, time: f64, dense: f64, remarks: &str) {
    let ratio = if dense.is_nan() { String::new() } else { format!("{:.1}", dense / time) };
    println!("{work:<58} {:>12} {:>12} {ratio:>9}  {remarks}", unit(time), unit(dense));
}

fn unit(time: f64) -> String {
    match time {
        t if t.is_nan() => String::new(),
        t if t < 1e-3 => format!("{:.2} µs", t * 1e6),
        t => format!("{:.2} ms", t * 1e3),
    }
}
