//! How far can a cup be tilted in the hand? The report has the angle at which the first finger slides, for every direction of the tilt; the fraction
//! of friction that each finger uses; the errors if straight loads replace the turn; and run times.
//!
//! `cargo run --release -p reports --bin tilted_cup`

use std::f64::consts::{FRAC_PI_2, PI};

use grasp_lcp::picture::{Chart, Stroke, chart_of_turn};
use grasp_lcp::spatial::{Contact, Grasp, Leg, Onset, PathEnd, Ramp, Turn, Wrench};
use grasp_lcp::sweep::map_in_order;
use support::Failure;
use support::best_time::best_in_turns;

/// Radius of the cup and half of its height, m.
const RADIUS: f64 = 0.035;
const HALF: f64 = 0.045;

/// A thumb opposite three fingers at two thirds of the height. Each finger presses with `press`, N; the thumb balances them.
fn hand(press: f64) -> Result<Grasp, grasp_lcp::Error> {
    let tip = |name: &str, degrees: f64, press: f64| {
        let (sin, cos) = f64::to_radians(degrees).sin_cos();
        Contact::new([RADIUS * cos, RADIUS * sin, HALF / 3.0], [-cos, -sin, 0.0])
            .name(name)
            .series_stiffness(3000.0, 2000.0)
            .friction(0.6)
            .pressed_with(press)
    };
    let fingers = [("index", -25.0), ("middle", 0.0), ("ring", 25.0)].map(|(name, at)| tip(name, at, press));
    // The outer fingers press at 25° to the direction of the thumb. The thumb balances the components of their forces along this direction.
    let sum = press * (1.0 + 2.0 * f64::to_radians(25.0).cos());
    Grasp::new([&[tip("thumb", 180.0, sum)], &fingers[..]].concat())
}

/// The weight (N) of a cup with its centre at this height (m), tilted towards a direction until it is upside down.
fn tilted(weight: f64, height: f64, degrees: f64) -> Result<Turn, grasp_lcp::Error> {
    let (sin, cos) = degrees.to_radians().sin_cos();
    // By the right-hand rule z turns towards (cos, sin) about (-sin, cos).
    Ok(Turn::tilting([0.0, 0.0, -weight], [0.0, 0.0, height], [-sin, cos, 0.0])?.up_to(PI))
}

fn angle_of(onset: &Onset) -> Result<f64, Failure> {
    onset.factor().ok_or_else(|| "the cup is held upright".into())
}

/// For directions every half degree, the direction and the angle at which the first finger slides, degrees.
fn slides_towards(grasp: &Grasp, weight: f64, height: f64) -> Result<Vec<(f64, f64)>, Failure> {
    let directions: Vec<f64> = (0..=720).map(|k| f64::from(k) / 2.0).collect();
    let turns: Result<Vec<_>, _> =
        directions.iter().map(|degrees| tilted(weight, height, *degrees)).collect();
    let mut slides = Vec::new();
    for (degrees, onset) in directions.iter().zip(map_in_order(&turns?, |turn| grasp.onset_of_turn(turn))) {
        let angle = angle_of(&onset?.onset)?;
        if angle.is_finite() {
            slides.push((*degrees, angle.to_degrees()));
        }
    }
    Ok(slides)
}

fn main() -> Result<(), Failure> {
    let cups = [("empty, 1 N", 1.0, 0.0), ("half full, 3 N", 3.0, -0.015), ("full, 6 N", 6.0, 0.0)];
    let grasp = hand(4.0)?;
    println!(
        "A cup between a thumb and three fingers that press with 4 N each, μ = 0.6. It slides when tilted by (degrees)"
    );
    println!("  {:16} {:>9} {:>9} {:>9} {:>9}", "towards", "fingers", "index", "thumb", "ring");
    let mut chart = Chart::new(
        "A cup tilted in the hand",
        "tilted towards (degrees)",
        "first finger slides at (degrees)",
    );
    for (name, weight, height) in cups {
        let at = |degrees: f64| -> Result<f64, Failure> {
            let onset = grasp.onset_of_turn(tilted(weight, height, degrees)?)?.onset;
            Ok(angle_of(&onset)?.to_degrees())
        };
        let shown = |degrees: f64| -> Result<String, Failure> {
            let angle = at(degrees)?;
            Ok(if angle.is_finite() { format!("{angle:.4}") } else { "never".into() })
        };
        let [fingers, index, thumb, ring] = [shown(0.0)?, shown(270.0)?, shown(180.0)?, shown(90.0)?];
        println!("  {name:16} {fingers:>9} {index:>9} {thumb:>9} {ring:>9}");
        let slides = slides_towards(&grasp, weight, height)?;
        if !slides.is_empty() {
            chart = chart.series(name, slides, Stroke::Dots);
        }
    }

    let turn = tilted(6.0, 0.0, 270.0)?;
    let exact = angle_of(&grasp.onset_of_turn(turn)?.onset)?;
    println!("\nA quarter turn of the full cup towards the index finger in chords, each a straight ramp:");
    for chords in [9_u32, 90, 900] {
        let at = |k: u32| turn.load_at(FRAC_PI_2 * f64::from(k) / f64::from(chords));
        let legs: Vec<_> = (1..=chords).map(|k| Leg::load_to(at(k))).collect();
        let mut path = grasp.follow(at(0), &legs)?;
        let first = path.next().map(|event| (event.leg, event.fraction));
        let (leg, fraction) = first.or(path.end().and_then(place)).ok_or("it slides")?;
        let angle = FRAC_PI_2 * (leg as f64 + fraction) / f64::from(chords);
        println!(
            "  {chords:4} chords: {:.6} degrees, off by {:.1e}",
            angle.to_degrees(),
            (angle - exact).abs().to_degrees()
        );
    }

    let ramp = Ramp::load(Wrench::ZERO, Wrench::force([0.0, -0.4, -1.0]));
    let mut straight = || grasp.onset(&ramp).map(drop).map_err(Failure::from);
    let mut turning = || grasp.onset_of_turn(turn).map(drop).map_err(Failure::from);
    let [straight, turning] = best_in_turns([&mut straight, &mut turning])?;
    println!(
        "\nAn onset takes {:.1} µs along a ramp, and {:.1} times that while the load turns.",
        1e6 * straight,
        turning / straight
    );
    support::save("tilted_cup.svg", &chart.to_svg()?)?;
    let title = "The full cup tilted towards the index finger";
    let used = chart_of_turn(&grasp, &turn, title)?;
    support::save("tilted_cup_friction.svg", &used.to_svg()?)?;
    Ok(())
}

fn place(end: &PathEnd) -> Option<(usize, f64)> {
    end.leg().zip(end.fraction())
}
