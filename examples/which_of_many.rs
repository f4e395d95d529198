//! Which of many grasps holds the largest weight? Onsets of sliding of a hundred thousand pairs of fingers round an ellipse.
//!
//! `cargo run --release -p grasp-lcp --example which_of_many`

use std::f64::consts::TAU;

use grasp_lcp::planar::{Batch, Contact, Fingers, Pull, Wrench};
use grasp_lcp::sweep::onsets_of_batch;

fn main() -> Result<(), grasp_lcp::Error> {
    let (long, short) = (0.05, 0.03);
    let finger = |angle: f64| {
        let (sin, cos) = angle.sin_cos();
        Contact::new([long * cos, short * sin], [-cos / long, -sin / short])
            .series_stiffness(2e3, 1.5e3)
            .friction(0.5)
            .pressed_with(8.0)
    };
    let angles: Vec<f64> = (0..448).map(|k| TAU * f64::from(k) / 448.0).collect();
    let pairs: Vec<[f64; 2]> =
        angles.iter().flat_map(|a| angles.iter().filter(move |b| *b > a).map(move |b| [*a, *b])).collect();
    let mut batch = Batch::with_capacity(pairs.len());
    for [a, b] in &pairs {
        batch.push(&Fingers::new(&[finger(*a), finger(*b)])?);
    }

    let weight = Pull::new(&Wrench::ZERO, &Wrench::force([0.0, -1.0]))?;
    let mut onsets = Vec::new();
    onsets_of_batch(&batch, &[weight], &mut onsets);
    let held = onsets.iter().map(|onset| onset.factor().unwrap_or(0.0));
    if let Some((best, most)) = held.enumerate().max_by(|a, b| a.1.total_cmp(&b.1)) {
        let [a, b] = pairs[best].map(f64::to_degrees);
        println!("of {} pairs the best is at {a:.1} and {b:.1} degrees: {most:.4} N", pairs.len());
    }
    Ok(())
}
