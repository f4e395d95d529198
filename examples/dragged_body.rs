//! A finger drags a body round a corner: its sliding direction turns, and what it drags follows a tractrix. The load path on the round cone
//! against paths on polygons: error and run time, beside the curve that Leibniz wrote down.
//!
//! `cargo run --release --example dragged_body`

mod support;

use std::error::Error;
use std::time::Instant;

use grasp_lcp::Settings;
use grasp_lcp::picture::{Chart, Stroke};
use grasp_lcp::spatial::{Contact, Grasp, Leg, Wrench};
use grasp_lcp::{Fit, PolygonCone};
use nalgebra::Vector3;

/// Finger and support, N/m along and across the normal.
const FINGER: [f64; 2] = [2e4, 1e4];
const SUPPORT: f64 = 4e4;
const FRICTION: f64 = 0.5;
/// Commanded squeeze, m.
const SQUEEZE: f64 = 1e-3;
/// The way of the finger after the corner, in leashes.
const WAY: f64 = 4.0;
const SAMPLES: u32 = 200;

/// Springs in series.
fn series(finger: f64) -> f64 {
    finger * SUPPORT / (finger + SUPPORT)
}

/// Friction force once it slides, N.
fn limit() -> f64 {
    FRICTION * series(FINGER[0]) * SQUEEZE
}

/// How far the finger is ahead of what it drags, m.
fn leash() -> f64 {
    limit() / series(FINGER[1])
}

fn scene() -> Result<(Grasp, [Leg; 2]), grasp_lcp::Error> {
    let finger = Contact::new([0.0; 3], [0.0, 0.0, 1.0])
        .name("finger")
        .tangent([1.0, 0.0, 0.0])
        .series_stiffness(FINGER[0], FINGER[1])
        .friction(FRICTION)
        .command([SQUEEZE, 0.0, 0.0]);
    let support = [(0.02, 0.0), (-0.02, 0.0), (0.0, 0.02), (0.0, -0.02)].map(|(x, y)| {
        Contact::new([x, y, 0.0], [0.0, 0.0, 1.0])
            .series_stiffness(SUPPORT / 4.0, SUPPORT / 4.0)
            .friction(1.0)
            .bonded()
    });
    let drag = |x: f64, y: f64| {
        let mut commands = vec![Vector3::zeros(); 5];
        commands[0] = Vector3::new(0.0, x, y);
        Leg::commands_by(commands)
    };
    // As far as the leash goes, then off at a right angle.
    let legs = [drag(0.0, leash()), drag(WAY * leash(), 0.0)];
    Ok((Grasp::new([finger].into_iter().chain(support))?, legs))
}

/// The angle of the friction force to the way after the corner: tan(θ/2) = exp(-x/L).
fn exact(leashes: f64) -> f64 {
    2.0 * (-leashes).exp().atan()
}

/// Where it goes, the worst error of the friction force over its size, and the run time, s.
struct Followed {
    track: Vec<(f64, f64)>,
    error: f64,
    estimate: f64,
    time: f64,
}

fn follow(grasp: &Grasp, legs: &[Leg], settings: &Settings) -> Result<Followed, Box<dyn Error>> {
    let mut time = f64::INFINITY;
    let begin = Instant::now();
    while begin.elapsed().as_secs_f64() < 0.2 {
        let start = Instant::now();
        grasp.follow_with(Wrench::ZERO, legs, settings)?.run();
        time = time.min(start.elapsed().as_secs_f64());
    }
    let mut path = grasp.follow_with(Wrench::ZERO, legs, settings)?;
    path.run();
    let (mut track, mut error) = (Vec::new(), 0.0_f64);
    for k in 0..=SAMPLES {
        let f = f64::from(k) / f64::from(SAMPLES);
        let state = path.state_at(1, f).ok_or("the path goes on")?;
        let contact = &state.contacts[0];
        let (sin, cos) = exact(WAY * f).sin_cos();
        let off = (contact.force[1] / limit() - cos).hypot(contact.force[2] / limit() - sin);
        error = error.max(off);
        track.push((contact.slip[1] / leash(), contact.slip[2] / leash()));
    }
    Ok(Followed { track, error, estimate: path.step_error(), time })
}

fn main() -> Result<(), Box<dyn Error>> {
    let (grasp, legs) = scene()?;
    println!("A finger goes {:.3} mm one way and {WAY} times as far at a right angle to it;", 1e3 * leash());
    println!("what it drags is held by springs. Friction force {:.3} N against the tractrix:\n", limit());
    println!("  cone                      worst error   estimated       time (µs)   time / that of 8 facets");
    let mut lines = Vec::new();
    for tolerance in [1e-13, 1e-10, 1e-7, 1e-4] {
        let settings = Settings::default().with_step_error(tolerance);
        lines.push((format!("round, steps to {tolerance:.0e}"), true, follow(&grasp, &legs, &settings)?));
    }
    for facets in [8, 16, 32, 64, 128] {
        let cone = PolygonCone::new(facets, Fit::Inscribed)?;
        let settings = Settings::default().with_cone(cone).on_the_polygon();
        lines.push((format!("{facets} facets, inscribed"), false, follow(&grasp, &legs, &settings)?));
    }
    let eight = lines.iter().find(|line| !line.1).map_or(f64::NAN, |line| line.2.time);
    for (name, round, followed) in &lines {
        let estimate = if *round { format!("{:.1e}", followed.estimate) } else { String::new() };
        println!(
            "  {name:24} {:12.1e} {estimate:>11} {:15.0} {:15.1}",
            followed.error,
            1e6 * followed.time,
            followed.time / eight
        );
    }
    let tractrix = |k: u32| {
        let x = WAY * f64::from(k) / f64::from(SAMPLES);
        let (sin, cos) = exact(x).sin_cos();
        (x - cos, 1.0 - sin)
    };
    let every = |track: &[(f64, f64)]| track.iter().copied().step_by(10).collect::<Vec<_>>();
    let track =
        Chart::new("What is dragged round a corner", "slip along the way / leash", "slip across / leash")
            .series("tractrix", (0..=SAMPLES).map(tractrix).collect(), Stroke::Line)
            .series("round cone", every(&lines[0].2.track), Stroke::Circles)
            .series("8 facets", lines[4].2.track.clone(), Stroke::Dashed);
    let points = |round: bool| -> Vec<(f64, f64)> {
        let chosen = lines.iter().filter(|line| line.1 == round);
        chosen.map(|(_, _, followed)| (1e6 * followed.time, followed.error)).collect()
    };
    let cost = Chart::new("Error against run time", "run time (µs)", "worst error of the friction force")
        .log_log()
        .series("round cone, steps to 1e-4 … 1e-13", points(true), Stroke::Line)
        .series("8 … 128 facets", points(false), Stroke::Dashed);
    support::save("dragged_body.svg", &Chart::sheet(&[track, cost], 2)?)?;
    Ok(())
}
