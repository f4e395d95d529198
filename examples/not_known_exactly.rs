//! How much does the onset of sliding scatter if friction, stiffness, squeeze and contact places are uncertain?
//!
//! `cargo run --profile quick -p grasp-lcp --example not_known_exactly`

use grasp_lcp::planar::{Contact, Grasp, Ramp, Wrench};
use grasp_lcp::sweep::Uncertainty;

fn main() -> Result<(), grasp_lcp::Error> {
    let finger = |x: f64, y: f64, side: f64, newtons: f64| {
        Contact::new([x, y], [-side, 0.0]).series_stiffness(2e3, 1.5e3).friction(0.5).pressed_with(newtons)
    };
    let grasp = Grasp::new([
        finger(-0.04, 0.02, -1.0, 4.0),
        finger(-0.04, -0.02, -1.0, 4.0),
        finger(0.04, 0.0, 1.0, 8.0),
    ])?;
    let ramp = Ramp::load(Wrench::ZERO, Wrench::force([0.0, -1.0]));

    // Standard deviations: 10 % of friction and stiffness, 5 % of the squeeze, 1 mm of contact places, 2 degrees of
    // contact normals.
    let uncertainty = Uncertainty::seeded(1)
        .with_friction(0.1)
        .with_stiffness(0.1)
        .with_squeeze(0.05)
        .with_position(1e-3)
        .with_normal(2_f64.to_radians());
    println!("slides {}", grasp.onset(&ramp)?);
    let held = grasp.reserve(Wrench::ZERO, &uncertainty, 3.0)?.along(&Wrench::force([0.0, -1.0]));
    println!(
        "with three standard deviations in reserve {held:.6} N are held: fewer than one in 740 slides below"
    );
    let mut samples: Vec<f64> = Vec::new();
    for onset in grasp.onset_of_samples(&ramp, &uncertainty, 10_000) {
        samples.extend(onset?.factor());
    }
    samples.sort_by(f64::total_cmp);
    println!("of 10 000 samples one in a thousand slides below {:.6} N", samples[samples.len() / 1000]);
    Ok(())
}
