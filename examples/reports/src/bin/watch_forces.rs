//! How long does the watch over measured contact forces take in the worst case?
//!
//! `cargo run --release -p reports --bin watch_forces` evaluates the watch for a million random states of five fingers in space, from well held to
//! torn off. It prints the mean and the worst time of an evaluation.

use std::hint::black_box;
use std::time::Instant;

use grasp_lcp::spatial::{Contact, Fingers, Wrench};
use support::splitmix::Random;

const STATES: usize = 1_000_000;
/// Number of random force states for each grasp.
const OF_EACH: usize = 100;
/// Number of repetitions of each evaluation; the shortest time counts, since longer ones contain interruptions of the process.
const REPEATS: usize = 3;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut random = Random(5);
    let (mut all, mut worst, mut interrupted) = (0.0, 0.0_f64, 0.0_f64);
    let (mut held, mut slides) = (0, 0);
    for _ in 0..STATES / OF_EACH {
        let mut number = || 2.0 * random.uniform() - 1.0;
        let fingers = [(); 5].map(|()| {
            let out = [number(), number(), number()];
            Contact::new(out.map(|x| 0.05 * x), out.map(|x| 0.2 * number() - x))
                .series_stiffness(2e3 * (1.5 + number()), 1.5e3)
                .friction(0.6 + 0.4 * number())
                .pressed_with(5.0)
        });
        let watch = Fingers::new(&fingers)?;
        for _ in 0..OF_EACH {
            let to_come = Wrench::new([0; 3].map(|_| 5.0 * number()), [0; 3].map(|_| 0.1 * number()));
            let forces = std::array::from_fn(|i| {
                let normal = fingers[i].point().map(|x| -100.0 * x);
                [0, 1, 2].map(|axis| normal[axis] + 3.0 * number())
            });
            let mut best = f64::INFINITY;
            for _ in 0..REPEATS {
                let start = Instant::now();
                let watched = black_box(watch.watch(black_box(&forces), black_box(&to_come))?);
                let time = start.elapsed().as_secs_f64();
                best = best.min(time);
                interrupted = interrupted.max(time);
                held += usize::from(watched.margin() > 0.0);
                slides += usize::from(watched.margin() <= 0.0);
            }
            all += best;
            worst = worst.max(best);
        }
    }
    println!(
        "{STATES} states of five fingers in space, {:.0} % of them inside of all cones",
        share(held, slides)
    );
    println!("  a look takes {:.2} µs, at worst {:.2} µs", 1e6 * all / STATES as f64, 1e6 * worst);
    println!("  {:.0} µs at worst with all that interrupted it", 1e6 * interrupted);
    Ok(())
}

fn share(held: usize, slides: usize) -> f64 {
    100.0 * held as f64 / (held + slides) as f64
}
