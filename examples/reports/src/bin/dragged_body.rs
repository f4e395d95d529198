//! A finger drags a body round a corner: the direction of sliding turns, and the body follows a tractrix, Leibniz's curve. Compares error and run time
//! of the load path on the round cone with those of paths on polygons.
//!
//! `cargo run --release -p reports --bin dragged_body`

use std::error::Error;

use grasp_lcp::Settings;
use grasp_lcp::picture::{Chart, Stroke};
use grasp_lcp::spatial::{Grasp, Leg, Wrench};
use grasp_lcp::{PolygonCone, PolygonFit};
use support::best_time::timed;
use support::tractrix::{self, WAY, exact, leash, limit};

const SAMPLES: u32 = 200;

/// The track of the slip; the largest error of the friction force relative to its size, and the library's estimate of this error; the run time, s.
struct Followed {
    track: Vec<(f64, f64)>,
    error: f64,
    estimate: f64,
    time: f64,
}

fn follow(grasp: &Grasp, legs: &[Leg], settings: &Settings) -> Result<Followed, Box<dyn Error>> {
    let asked = grasp.with(settings);
    let (path, time) = timed(|| {
        let mut path = asked.follow(Wrench::ZERO, legs)?;
        path.run();
        Ok(path)
    })?;
    let (mut track, mut error) = (Vec::new(), 0.0_f64);
    for k in 0..=SAMPLES {
        let f = f64::from(k) / f64::from(SAMPLES);
        let state = path.state_at(1, f).ok_or("the path goes on")?;
        let contact = &state.contacts[0];
        error = error.max(tractrix::off(&contact.force, WAY * f));
        track.push((contact.slip[1] / leash(), contact.slip[2] / leash()));
    }
    Ok(Followed { track, error, estimate: path.step_error(), time })
}

fn main() -> Result<(), Box<dyn Error>> {
    let (grasp, ways) = tractrix::scene()?;
    let legs = tractrix::legs(ways);
    println!("A finger goes {:.3} mm one way and {WAY} times as far at a right angle to it;", 1e3 * leash());
    println!("what it drags is held by springs. Friction force {:.3} N against the tractrix:\n", limit());
    println!("  cone                      worst error   estimated       time (µs)   time / that of 8 facets");
    let mut lines = Vec::new();
    for tolerance in [1e-13, 1e-10, 1e-7, 1e-4] {
        let settings = Settings::default().with_step_error(tolerance);
        lines.push((format!("round, steps to {tolerance:.0e}"), true, follow(&grasp, &legs, &settings)?));
    }
    for facets in [8, 16, 32, 64, 128] {
        let cone = PolygonCone::new(facets, PolygonFit::Inscribed)?;
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
