//! Does `improve` reach the best placement of fingers from any start, and how long does it take?

use std::f64::consts::TAU;
use std::time::Instant;

use grasp_lcp::improve::{Improve, SearchEnd, Surface};
use grasp_lcp::planar::{Contact, Grasp, Loads, Wrench};
use grasp_lcp::spatial;
use rayon::prelude::*;

/// Number of random starts of each case, and of steps of the grid around the circle.
const STARTS: usize = 200;
const STEPS: usize = 120;
const RADIUS: f64 = 0.05;

fn main() -> Result<(), grasp_lcp::Error> {
    println!("closed forms                                  first slip      off by   residual");
    pinch()?;
    disc()?;
    can()?;
    against_a_grid()
}

fn told(what: &str, after: Option<f64>, exact: f64, residual: Option<f64>) {
    let after = after.unwrap_or(f64::NAN);
    let (off, residual) = ((after - exact).abs() / exact, residual.unwrap_or(f64::NAN));
    println!("{what:42} {after:13.9} N {off:11.1e} {residual:10.1e}");
}

/// Improves a pinch of two jaws that press with the force N each, under a load at the distance e from the middle. If
/// one jaw is higher by 2 μ e, both carry half of the load, and the grasp holds 2 μ N.
fn pinch() -> Result<(), grasp_lcp::Error> {
    let jaw =
        |x: f64| Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1e3, 8e2).friction(0.5).pressed_with(8.0);
    let edge = |x: f64| Surface::segment([x, -0.02], [x, 0.02]);
    for aside in [0.0, 0.01] {
        let load = Wrench::force_at([0.0, -1.0], [aside, 0.0]);
        let question = Improve::new(load).along(0, edge(-0.03)).along(1, edge(0.03)).pressing_at_most(10.0);
        let improved = Grasp::new([jaw(-0.03), jaw(0.03)])?.improve(&question)?;
        told(&format!("pinch, the load {} mm aside", 1e3 * aside), improved.after, 10.0, improved.residual);
    }
    Ok(())
}

/// Improves three fingers that press with at most N each on a disc, under a force of any direction. The best grasp
/// has the fingers 120° apart and holds 3 N sin α, with the friction angle α = atan μ.
fn disc() -> Result<(), grasp_lcp::Error> {
    let fingers = [0.3, 1.9, 4.4].map(|angle| finger(angle, 1e3));
    let any = Loads::AnyForce { base: Wrench::ZERO, size: 1.0, point: [0.0; 2] };
    let improved = Grasp::new(fingers)?.improve(&around(any).pressing_at_most(10.0))?;
    told("three fingers on a disc, any force", improved.after, 15.0 / 1.25_f64.sqrt(), improved.residual);
    Ok(())
}

/// Improves three fingers that press with at most N each on a can, under its weight. The best grasp holds 3 μ N.
fn can() -> Result<(), grasp_lcp::Error> {
    let finger = |angle: f64, height: f64| {
        let (sin, cos) = angle.sin_cos();
        let contact = spatial::Contact::new([RADIUS * cos, RADIUS * sin, height], [-cos, -sin, 0.0]);
        contact.series_stiffness(1e3, 8e2).friction(0.5).pressed_with(9.0)
    };
    let can = || Surface::cylinder([0.0, 0.0, -0.03], [0.0, 0.0, 0.03], RADIUS);
    let question = Improve::new(spatial::Wrench::force([0.0, 0.0, -1.0]));
    let question = (0..3).fold(question, |question, k| question.along(k, can())).pressing_at_most(10.0);
    let start = [finger(0.2, 0.01), finger(2.0, -0.012), finger(4.5, 0.004)];
    let improved = spatial::Grasp::new(start)?.improve(&question)?;
    told("three fingers on a can, its weight", improved.after, 15.0, improved.residual);
    Ok(())
}

fn finger(angle: f64, tangential: f64) -> Contact {
    let (sin, cos) = angle.sin_cos();
    let contact = Contact::new([RADIUS * cos, RADIUS * sin], [-cos, -sin]).series_stiffness(1e3, tangential);
    contact.friction(0.5).pressed_with(10.0)
}

fn around(loads: impl Into<Loads>) -> Improve<2> {
    let disc = || Surface::circle([0.0; 2], RADIUS);
    Improve::new(loads).along(0, disc()).along(1, disc()).along(2, disc())
}

/// Compares the results from random starts, on a disc under two loads, with the best grasp on a grid of angles.
fn against_a_grid() -> Result<(), grasp_lcp::Error> {
    let loads = [Wrench::force([0.0, -1.0]), Wrench::new([0.5, 0.0], 0.01)];
    let first_slip = |angles: [f64; 3]| {
        let grasp = Grasp::new(angles.map(|angle| finger(angle, 7e2))).ok()?;
        let factor = |load: &Wrench| grasp.onset(load).ok()?.factor();
        loads.iter().map(factor).try_fold(f64::INFINITY, |least, factor| Some(least.min(factor?)))
    };
    let angle = |k: usize| TAU * k as f64 / STEPS as f64;
    let rows: Vec<(usize, usize)> = (0..STEPS).flat_map(|a| (a + 1..STEPS).map(move |b| (a, b))).collect();
    let best_of = |(a, b): &(usize, usize)| {
        let all = (b + 1..STEPS).filter_map(|c| first_slip([angle(*a), angle(*b), angle(c)]));
        all.fold(0.0, f64::max)
    };
    let clock = Instant::now();
    let grid = rows.par_iter().map(best_of).reduce(|| 0.0, f64::max);
    let grid_time = clock.elapsed();
    let golden = |k: usize| TAU * (0.618_033_988_749_895 * (k + 1) as f64).fract();
    let clock = Instant::now();
    let mut least: f64 = f64::INFINITY;
    let (mut below, mut proved, mut steps, mut given) = (0, 0, 0, 0);
    for start in 0..STARTS {
        let fingers = [0, 1, 2].map(|k| finger(golden(3 * start + k), 7e2));
        let question = around(loads.to_vec()).with_seed(start as u64);
        let improved = Grasp::new(fingers)?.improve(&question)?;
        let after = improved.after.unwrap_or(0.0);
        least = least.min(after);
        below += usize::from(after < grid - 1e-6);
        proved += usize::from(improved.search == SearchEnd::Optimum);
        given += usize::from(improved.before.is_some());
        steps += improved.steps;
    }
    let time = clock.elapsed();
    println!("\n{STARTS} random starts on a disc under two loads, {given} of them stick at rest");
    println!("  best of {STEPS}³ angles, in {grid_time:.1?}     {grid:.9}");
    println!("  least of all answers                {least:.9}, {below} below the grid by more than 1e-6");
    println!("  proved to first order               {proved}");
    println!("  steps, time an answer               {}, {:.2?}", steps / STARTS, time.div_f64(STARTS as f64));
    Ok(())
}
