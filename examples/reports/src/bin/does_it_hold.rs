//! Does `hold` decide everyday grippers under loads close to the largest one that they hold, and how long does it take?
//!
//! `cargo run --release -p reports --bin does_it_hold [how many]`
//!
//! Opposed soft jaws that are pulled along their faces keep their normal forces N. With the friction coefficient μ they hold 2 μ N. Each gripper
//! gets loads around this limit.

use std::time::Instant;

use grasp_lcp::spatial::{Contact, Grasp, SoftFingertip, Wrench};
use support::Failure;
use support::splitmix::Random;

const AROUND: [f64; 5] = [0.5, 0.99, 1.01, 1.5, 4.0];

fn main() -> Result<(), Failure> {
    let count = std::env::args().nth(1).map_or(Ok(500), |count| count.parse::<usize>())?;
    println!("{count} grippers with two soft jaws, asked at {AROUND:?} times 2 μ N\n");
    println!("points   decided   wrong   proved near   time (ms): median   99 %    most");
    for points in [3, 6, 12, 24] {
        let mut random = Random(1);
        let (mut decided, mut wrong, mut lost, mut proved) = (0, 0, 0, 0);
        let mut times = Vec::new();
        for _ in 0..count {
            let (grasp, limit) = gripper(&mut random, points)?;
            for part in AROUND {
                let start = Instant::now();
                let verdict = grasp.hold(Wrench::force([0.0, 0.0, -limit * part]))?;
                times.push(1e3 * start.elapsed().as_secs_f64());
                decided += usize::from(verdict.holds().is_some());
                wrong += usize::from(verdict.holds().is_some_and(|holds| holds != (part < 1.0)));
                if verdict.holds() == Some(false) {
                    lost += 1;
                    let near = verdict.lost.and_then(|lost| lost.nothing_near);
                    proved += usize::from(near.is_some());
                }
            }
        }
        times.sort_by(f64::total_cmp);
        let at = |percent: usize| times[(times.len() - 1) * percent / 100];
        println!(
            "{:6}   {decided:7}   {wrong:5}   {proved:5} of {lost:5}   {:17.3} {:7.3} {:7.3}",
            2 * points,
            at(50),
            at(99),
            at(100)
        );
    }
    Ok(())
}

/// Two ring-shaped soft pads that face each other, and the load that they hold, N.
fn gripper(random: &mut Random, points: usize) -> Result<(Grasp, f64), grasp_lcp::Error> {
    let mut between = |low: f64, high: f64| low + (high - low) * random.uniform();
    let (friction, press, radius) = (between(0.1, 1.0), between(1.0, 100.0), between(0.003, 0.015));
    let stiffness = [between(500.0, 5e4), between(500.0, 5e4)];
    let ring = SoftFingertip::ring(radius, points)?;
    let jaw = |x: f64| {
        let jaw = Contact::new([x, 0.0, 0.0], [-x, 0.0, 0.0]);
        jaw.series_stiffness(stiffness[0], stiffness[1]).friction(friction).pressed_with(press)
    };
    let grasp = Grasp::new([ring.contacts(&jaw(-0.03))?, ring.contacts(&jaw(0.03))?].concat())?;
    Ok((grasp, 2.0 * friction * press))
}
