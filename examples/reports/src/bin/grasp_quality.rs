//! Quality measures of grasp planners, compared with the loads that the same fingers hold. The measures are force closure, that of Ferrari and Canny,
//! and limit analysis; the loads are the onset of sliding and the limit load of elastic fingers with their squeeze.
//!
//! `cargo run --release -p reports --bin grasp_quality`

use std::hint::black_box;

use grasp_lcp::Settings;
use grasp_lcp::spatial::{Contact, Grasp, Ramp, Wrench};
use grasp_lcp::statics::{Budget, Closure, LoadLimit, WrenchScale};
use support::Failure;
use support::best_time::best_in_turns;

/// Radius of a jar, m, and its weight, N.
const RADIUS: f64 = 0.04;
const WEIGHT: f64 = 5.0;
/// Largest normal force of a finger, N.
const MOST: f64 = 20.0;

/// Fingers in a ring at these angles (degrees) and heights (m); their squeeze is balanced.
fn ring(fingers: &[(f64, f64)], press: f64) -> Result<Grasp, grasp_lcp::Error> {
    let tip = |&(degrees, height): &(f64, f64)| {
        let (sin, cos) = f64::to_radians(degrees).sin_cos();
        Contact::new([RADIUS * cos, RADIUS * sin, height], [-cos, -sin, 0.0])
            .series_stiffness(3000.0, 2000.0)
            .friction(0.6)
            .pressed_with(press)
    };
    Grasp::new(fingers.iter().map(tip))
}

/// Three fingers under the bottom of the jar, which carry it without a squeeze.
fn from_below() -> Result<Grasp, grasp_lcp::Error> {
    let tip = |degrees: f64| {
        let (sin, cos) = degrees.to_radians().sin_cos();
        Contact::new([0.8 * RADIUS * cos, 0.8 * RADIUS * sin, -RADIUS], [0.0, 0.0, 1.0])
            .series_stiffness(3000.0, 2000.0)
            .friction(0.6)
    };
    Grasp::new([90.0, 210.0, 330.0].map(tip))
}

fn or_dash(value: Option<f64>) -> String {
    value.map_or_else(
        || "-".into(),
        |value| if value.is_finite() { format!("{value:.2}") } else { "any".into() },
    )
}

fn main() -> Result<(), Failure> {
    let even = |n: u32| -> Vec<_> { (0..n).map(|k| (360.0 * f64::from(k) / f64::from(n), 0.0)).collect() };
    let staggered = [(0.0, -0.02), (72.0, 0.02), (144.0, -0.02), (216.0, 0.02), (288.0, 0.0)];
    let grasps = [
        ("two, 8 N each", ring(&even(2), 8.0)?),
        ("three, 8 N each", ring(&even(3), 8.0)?),
        ("three, 2 N each", ring(&even(3), 2.0)?),
        ("three on one side", ring(&[(60.0, 0.0), (90.0, 0.0), (120.0, 0.0)], 8.0)?),
        ("five, staggered, 8 N", ring(&staggered, 8.0)?),
        ("three from below", from_below()?),
    ];
    println!(
        "Fingers round a jar of {WEIGHT} N, μ = 0.6. Forces in N; moments about the centroid, over the largest distance of a finger from it."
    );
    println!("{:47} | could, if none presses with more than {MOST} N", "");
    println!("{:47} | {:20} | {:28}", "", "so much of its weight", "these fingers, squeezed so");
    println!(
        "  {:21} {:6} {:>7} {:>7} | {:>9} {:>10} | {:>10} {:>8}",
        "", "closed", "ε total", "ε each", "carry", "needed", "slide from", "hold to"
    );
    let weight = Wrench::force([0.0, 0.0, -WEIGHT]);
    for (name, grasp) in &grasps {
        let closed = match grasp.statics().force_closure()? {
            Closure::Closed { .. } => "yes",
            Closure::Open { .. } => "no",
            _ => "edge",
        };
        let [total, each] =
            [Budget::Total(1.0), Budget::Each(1.0)].map(|budget| grasp.statics().ferrari_canny(budget));
        let carry = match grasp.statics().load_limit(Wrench::ZERO, weight, Budget::Each(MOST))? {
            LoadLimit::Factor { at_least, .. } => Some(WEIGHT * at_least),
            _ => None,
        };
        let [_, needed] = grasp.statics().budget_needed(weight, Budget::Each(1.0))?;
        let onset = grasp.onset(weight)?;
        let verdict = grasp.hold(weight)?;
        println!(
            "  {name:21} {closed:6} {:7.4} {:7.4} | {:>9} {:>10} | {:>10} {:>8}",
            total?.at_least,
            each?.at_least,
            or_dash(carry),
            if needed.is_finite() { format!("{needed:.2}") } else { "never".into() },
            or_dash(onset.factor().map(|factor| WEIGHT * factor)),
            or_dash(match verdict.lost {
                Some(lost) => Some(WEIGHT * lost.factor),
                None => verdict.holds().map(|_| f64::INFINITY),
            }),
        );
    }
    println!(
        "\nClosure and ε know neither the squeeze nor the load: the second and the third grasp are one to them, and only one of them holds the jar."
    );
    println!(
        "Two fingers hold it without being closed, since nothing turns it about their line; three below carry what they cannot squeeze."
    );

    let five = &grasps[4].1;
    let octagons = Settings::default().on_the_polygon();
    let scale = WrenchScale { about: [0.0; 3], length: RADIUS };
    let ramp = Ramp::load(Wrench::ZERO, weight);
    let of = |budget: Budget, settings: &Settings| -> Result<(), Failure> {
        black_box(five.with(settings).statics().ferrari_canny_scaled(budget, &scale)?);
        Ok(())
    };
    let seconds = best_in_turns([
        &mut || of(Budget::Total(1.0), &octagons),
        &mut || of(Budget::Each(1.0), &octagons),
        &mut || of(Budget::Total(1.0), &Settings::default()),
        &mut || of(Budget::Each(1.0), &Settings::default()),
        &mut || {
            black_box(five.onset(&ramp)?);
            Ok(())
        },
    ])?;
    println!("\nWhat it costs, five fingers, best of several:");
    let names =
        ["ε total, 8 facets", "ε each, 8 facets", "ε total, round", "ε each, round", "onset of sliding"];
    for (name, seconds) in names.iter().zip(seconds) {
        println!("  {name:18} {:8.3} ms", 1e3 * seconds);
    }
    Ok(())
}
