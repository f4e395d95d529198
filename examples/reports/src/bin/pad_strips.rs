//! What do the strips of a rectangular pad cost, in error and in time?
//!
//! `cargo run --release -p reports --bin pad_strips [MOST]`
//!
//! A gripper with two pads of 20 mm by 30 mm, 120 N and friction 0.35 carries 1.8 kg, 25 mm below the pads, while the arm accelerates sideways. The
//! load shears and twists the pads at once, so that the answer depends on the distribution of pressure. Errors are relative to the finest pad; times
//! are the best of five, relative to that of one strip.

use std::time::Instant;

use grasp_lcp::load_path::Ramp;
use grasp_lcp::spatial::{Contact, Grasp, SoftFingertip, Wrench};
use support::Failure;

/// Largest number of strips in half of each side, unless another number is given.
const MOST: usize = 4;

fn main() -> Result<(), Failure> {
    // The load of 1.8 kg under gravity while the arm accelerates with 3 m/s² upwards and 5 m/s² sideways, in the plane of the pads.
    let load = Wrench::force_at([0.0, -1.8 * 5.0, -1.8 * (9.81 + 3.0)], [0.0, 0.0, -0.025]);
    let most = std::env::args().nth(1).map_or(Ok(MOST), |count| count.parse::<usize>())?;
    let mut rows = Vec::new();
    for strips in 1..=most {
        let grasp = gripper(strips)?;
        let (mut best, mut times) = (f64::INFINITY, [0.0; 2]);
        // A test that only checks that the program runs sets ONE_CALL; otherwise the best of five runs counts.
        for _ in 0..if std::env::var_os("ONE_CALL").is_some() { 1 } else { 5 } {
            let start = Instant::now();
            let verdict = grasp.hold(Ramp::load(Wrench::ZERO, load))?;
            best = best.min(start.elapsed().as_secs_f64());
            let first = verdict.first_slip.map_or(f64::NAN, |slip| slip.factor);
            times = [first, verdict.lost.map_or(f64::NAN, |lost| lost.factor)];
        }
        rows.push((2 * 16 * strips * strips, times, best));
    }
    let finest = rows.last().map_or([f64::NAN; 2], |row| row.1);
    println!("strips  points  first slip (times the load)  lost at   error (%)   time");
    for (strips, (points, [first, lost], seconds)) in (1..=most).zip(&rows) {
        let error = 100.0 * (lost / finest[1] - 1.0);
        println!(
            "{strips:6}  {points:6}  {first:27.4}  {lost:7.4}  {error:10.2}  {:5.1}",
            seconds / rows[0].2
        );
    }
    Ok(())
}

/// The gripper. Its limits of small motions are so large that they never end the load path.
fn gripper(strips: usize) -> Result<Grasp, Failure> {
    let pad = SoftFingertip::rectangle([0.02, 0.03], [strips, strips])?;
    let mut contacts = Vec::new();
    for side in [-1.0, 1.0] {
        let jaw = Contact::new([0.02 * side, 0.0, 0.0], [-side, 0.0, 0.0])
            .tangent([0.0, 1.0, 0.0])
            .series_stiffness(4.2e5, 1.4e5)
            .friction(0.35)
            .pressed_with(120.0);
        contacts.extend(pad.contacts(&jaw)?);
    }
    Ok(Grasp::new(contacts)?.with(&grasp_lcp::Settings::default().with_small_motions(1e50, 1e50)))
}
