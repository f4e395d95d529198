//! What the onset and the equilibrium of a planar pair cost in Rust: the other half of `single.py`.

use std::hint::black_box;
use std::time::Instant;

use grasp_lcp::planar::{Contact, Grasp, Ramp, Wrench};

const CALLS: u32 = 20_000;
const REPEATS: usize = 15;

/// The least time of a call, in microseconds.
fn best(mut call: impl FnMut()) -> f64 {
    let mut time = || {
        let start = Instant::now();
        (0..CALLS).for_each(|_| call());
        start.elapsed().as_secs_f64() / f64::from(CALLS) * 1e6
    };
    (0..REPEATS).map(|_| time()).fold(f64::INFINITY, f64::min)
}

fn main() -> Result<(), grasp_lcp::Error> {
    let finger = |side: f64| {
        Contact::new([0.04 * side, 0.0], [-side, 0.0])
            .body_stiffness(5e4, 3e4)
            .finger_stiffness(2e3, 1.5e3)
            .friction(0.5)
            .pressed_with(8.0)
    };
    let grasp = Grasp::new([finger(-1.0).name("left"), finger(1.0).name("right")])?;
    let load = Wrench::force([0.0, -4.905]);
    let ramp = || Ramp::load(Wrench::ZERO, black_box(load));
    println!("onset  {:6.2} µs", best(|| drop(black_box(grasp.onset(ramp())))));
    println!("solve  {:6.2} µs", best(|| drop(black_box(grasp.solve(black_box(&load))))));
    Ok(())
}
