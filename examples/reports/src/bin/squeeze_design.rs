//! Which squeeze carries a given load with a given reserve, and which parameter has the largest influence?
//!
//! `cargo run --release -p reports --bin squeeze_design`

use grasp_lcp::load_path::Parameter;
use grasp_lcp::picture::{Chart, Stroke};
use grasp_lcp::planar::{Contact, Grasp, LeastSqueeze, Loads, Ramp, Turn, WeakestDirection, Wrench};
use grasp_lcp::{Error, Settings};
use support::Failure;

/// A box in a three-finger hand: two fingers on the left, a thumb on the right, pressed by `squeeze` (m).
fn hand(squeeze: f64) -> Result<Grasp, Error> {
    let finger = |name: &str, p: [f64; 2], n: [f64; 2], share: f64, mu: f64, k: f64| {
        Contact::new(p, n)
            .name(name)
            .body_stiffness(5e4, 3e4)
            .finger_stiffness(k, 0.6 * k)
            .friction(mu)
            .command([share * squeeze, 0.0])
    };
    Grasp::new([
        finger("index", [-0.03, 0.02], [1.0, 0.05], 1.0, 0.5, 1200.0),
        finger("middle", [-0.03, -0.02], [1.0, -0.05], 1.0, 0.5, 900.0),
        finger("thumb", [0.03, 0.0], [-1.0, 0.0], 1.2, 0.7, 2000.0),
    ])
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let settings = Settings::default();
    // A weight of 4 N, 4 mm off the centre, to be carried with a safety factor of 1.5 against sliding.
    let weight = Wrench::force_at([0.0, -4.0], [0.004, 0.0]);
    let reserve = 1.5;

    // The hand with commands of 1 mm: the least factor on these commands is the needed command in mm.
    let by_millimetres = hand(1e-3)?;
    let needed = |loads: Loads| -> Result<_, Failure> {
        match by_millimetres.with(&settings).least_squeeze(&loads)? {
            LeastSqueeze::Factor { factor, binding, .. } => {
                Ok((1e-3 * factor, binding.map(|(contact, _)| contact)))
            }
            other => Err(format!("no squeeze suffices: {other:?}").into()),
        }
    };
    let (least, first) = needed(Loads::Each(vec![weight * reserve]))?;
    println!("Least squeeze that carries {reserve} times the weight without sliding: {:.9} mm", 1e3 * least);
    if let Some(contact) = first {
        println!("  below it {} slides first", by_millimetres.contacts()[contact].label_text(contact));
    }
    let upside_down = Turn::tilting([0.0, -4.0 * reserve], [0.004, 0.0]);
    println!("  turned over and back: {:.9} mm", 1e3 * needed(Loads::Turn(upside_down))?.0);
    let any = Loads::AnyForce { base: weight, size: 1.0, point: [0.0, 0.0] };
    println!("  the weight alone and 1 N of any direction beside it: {:.9} mm", 1e3 * needed(any)?.0);

    // Check: with this squeeze the onset factor along the weight equals the required safety factor.
    let grasp = hand(least)?;
    let ramp = Ramp::load(Wrench::ZERO, weight);
    let onset = grasp.with(&settings).onset(&ramp)?;
    let event = onset.event().ok_or("slides at some load")?;
    println!("  onset of sliding with it: {:.12} times the weight", event.factor);
    if let WeakestDirection::Force { size, direction: [x, y], .. } =
        grasp.weakest_direction(weight, [0.0, 0.0])?
    {
        println!("  beside the weight a force of {size:.6} N slides first, towards ({x:.6}, {y:.6})");
    }
    println!("  {}\n", grasp.with(&settings).hold(&ramp)?);

    println!("What one percent more of each parameter does to the onset (percent):");
    println!("            friction   k_n        k_t        command");
    let margins = grasp.sensitivity().onset(event).ok_or("everything sticks before")?;
    let by = |parameter| margins.by(parameter).map_or(f64::NAN, |by| by[0]);
    let mut strongest = (0.0, String::new());
    for (i, contact) in grasp.contacts().iter().enumerate() {
        let name = contact.label_text(i);
        let (k, mu, a) =
            (contact.series_stiffness_of_axes(), contact.friction_coefficient(), contact.commanded());
        let percent = [
            by(Parameter::Friction { contact: i }) * mu,
            by(Parameter::Stiffness { contact: i, axis: 0 }) * k[0],
            by(Parameter::Stiffness { contact: i, axis: 1 }) * k[1],
            by(Parameter::Command { contact: i, axis: 0 }) * a[0],
        ]
        .map(|d| d / event.factor);
        print!("  {name:8}");
        for (value, what) in percent.into_iter().zip(["friction", "k_n", "k_t", "command"]) {
            print!("  {value:+9.4}");
            if value.abs() > f64::abs(strongest.0) {
                strongest = (value, format!("{what} of the {name}"));
            }
        }
        println!();
    }
    println!("what matters most: the {} ({:+.3} % for one percent)\n", strongest.1, strongest.0);

    let curve: Result<Vec<(f64, f64)>, Error> = (0..=60)
        .map(|i| {
            let squeeze = 0.0005 * f64::from(i) * 0.5;
            Ok((1e3 * squeeze, hand(squeeze)?.with(&settings).onset(&ramp)?.factor().unwrap_or(0.0)))
        })
        .collect();
    let chart = Chart::new(
        "Onset of sliding against squeeze",
        "squeeze (mm)",
        "load carried without sliding (times the weight)",
    )
    .series("onset", curve?, Stroke::Line)
    .mark(1e3 * least, format!("{:.3} mm for {reserve} times", 1e3 * least));
    support::save("squeeze_design.svg", &chart.to_svg()?)?;
    Ok(())
}
