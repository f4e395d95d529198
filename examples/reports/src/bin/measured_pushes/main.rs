//! Blind predictions of measured pushes of a block on three supports: friction from one layout of the supports predicts forces and motions of all
//! others.
//!
//! `cargo run --release -p reports --bin measured_pushes [folder for pictures]`
//!
//! 400 pushes of a triangular block that slides on three points of known place and load, on hardboard and on plywood (Zhou, Paolini, Bagnell and Mason,
//! ICRA 2016; see [`support::measured_pushes`]).
//!
//! The block slides steadily under the load at which a grasp of three contacts in space is lost. This load is proportional to the coefficient of
//! friction, so that each push gives a coefficient. The median over one layout predicts the other three. Two simpler models are compared: an
//! ellipsoid with the same largest force and moment (Howe and Cutkosky 1996), and a force of μ times the weight for any moment.

mod charts;
mod repeats;

use std::error::Error;
use std::path::PathBuf;

use grasp_lcp::nalgebra::Vector3;
use grasp_lcp::picture::Chart;
use rayon::prelude::*;
use support::best_time::timed;
use support::measured_pushes::{
    LAYOUTS, Limit, Push, SURFACES, WEIGHT, blocks, limit, normal_forces, pushes, supports,
};

/// Length by which moments are divided to compare them with forces, m: about the distance of the supports from the centre of mass.
const LENGTH: f64 = 0.05;

fn main() -> Result<(), Box<dyn Error>> {
    let (pushes, blocks) = (pushes()?, blocks()?);
    let (limits, seconds) = timed(|| {
        let limits = pushes.par_iter().map(|push| limit(&blocks, push).map_err(|error| error.to_string()));
        Ok(limits.collect::<Result<Vec<_>, _>>()?)
    })?;
    println!(
        "All {} pushes are decided, in {:.0} ms on {} threads.\n",
        limits.len(),
        1e3 * seconds,
        rayon::current_num_threads()
    );
    println!(
        "Friction from one layout, the three others predicted: |predicted - measured| / measured of the force, in percent.\n"
    );
    println!(
        "{:<11}{:<8}{:>8}{:>11}{:>11}{:>11}{:>11}{:>15}{:>10}",
        "", "from", "μ", "median", "90 %", "ellipsoid", "μ weight", "motion off by", "scatter"
    );
    let mut worst: f64 = 0.0;
    for surface in SURFACES {
        for from in 0..LAYOUTS.len() {
            let others = || {
                let all = pushes.iter().zip(&limits);
                all.filter(move |(push, _)| push.surface == surface && push.layout != from)
            };
            let [(mu, off), (_, ellipsoid), (_, weight)] =
                MODELS.map(|(_, model)| blind((&pushes, &limits), surface, from, model));
            let turned = others().map(|(push, limit)| angle_between(&push.motion, &limit.motion));
            let [median, most] = [50, 90].map(|part| 100.0 * quantile(off.clone(), part));
            worst = worst.max(median);
            println!(
                "{surface:<11}{:<8}{mu:>8.4}{median:>11.1}{most:>11.1}{:>11.1}{:>11.1}{:>13.1} °{:>10.1}",
                LAYOUTS[from].0,
                100.0 * quantile(ellipsoid, 50),
                100.0 * quantile(weight, 50),
                quantile(turned.collect(), 50),
                100.0 * quantile(others().map(|(push, _)| push.scatter).collect(), 50),
            );
        }
    }
    println!(
        "\nThe largest of these medians: {worst:.1} %. Scatter: of the force during one push, over its mean, in the median."
    );
    error_against_time(&pushes, &limits, &blocks)?;
    by_layout(&pushes, &limits);
    let floors = SURFACES.map(|surface| repeats::scatter(&pushes, &limits, surface));
    repeats::told(&floors);
    by_direction(&pushes, &limits);
    if let Some(folder) = std::env::args_os().nth(1).map(PathBuf::from) {
        std::fs::create_dir_all(&folder)?;
        std::fs::write(
            folder.join("measured_pushes.svg"),
            Chart::sheet(&charts::of_surfaces(&pushes, &limits, &floors), 2)?,
        )?;
    }
    Ok(())
}

/// A model of friction: it predicts the fraction of a measured push at which the block slides if the coefficient of friction is one.
type Model = fn(&Push, &Limit) -> f64;

const MODELS: [(&str, Model); 3] = [
    ("three contacts in space, exact limit", |_, limit| limit.factor),
    ("ellipsoid", |push, _| on_the_ellipsoid(push)),
    ("μ times the weight", |push, _| WEIGHT / push.load.xy().norm()),
];

/// The median coefficient of friction of a model on the layout `from`, and its relative errors on all other layouts.
fn blind((pushes, limits): (&[Push], &[Limit]), surface: &str, from: usize, model: Model) -> (f64, Vec<f64>) {
    let those = |is_own: bool| {
        let all = pushes.iter().zip(limits);
        all.filter(move |(push, _)| push.surface == surface && (push.layout == from) == is_own)
    };
    let mu = quantile(those(true).map(|(push, limit)| 1.0 / model(push, limit)).collect(), 50);
    (mu, those(false).map(|(push, limit)| (mu * model(push, limit) - 1.0).abs()).collect())
}

/// Prints the run time of each model for a push on one thread, and the median error of all blind predictions.
fn error_against_time(
    pushes: &[Push],
    limits: &[Limit],
    blocks: &[grasp_lcp::spatial::Grasp],
) -> Result<(), Box<dyn Error>> {
    let (_, exact) = timed(|| {
        let limits = pushes.iter().map(|push| limit(blocks, push).map(|limit| limit.factor));
        limits.sum::<Result<f64, _>>()
    })?;
    println!("\nError against run time, on one thread:\n\n{:<38}{:>10}{:>14}", "", "median", "µs a push");
    for (k, (name, model)) in MODELS.into_iter().enumerate() {
        let all = SURFACES.iter().flat_map(|surface| (0..LAYOUTS.len()).map(move |from| (surface, from)));
        let off = all.flat_map(|(surface, from)| blind((pushes, limits), surface, from, model).1);
        let off = 100.0 * quantile(off.collect(), 50);
        let seconds = if k == 0 {
            exact
        } else {
            timed(|| Ok(pushes.iter().zip(limits).map(|(push, limit)| model(push, limit)).sum::<f64>()))?.1
        };
        println!("{name:<38}{off:>8.1} %{:>14.3}", 1e6 * seconds / pushes.len() as f64);
    }
    println!("\nA simulator beside it: python/examples/mujoco_pushes.py.");
    Ok(())
}

/// Prints coefficients from the pushes of each layout. If these coefficients scatter, no model with a single coefficient can be right.
fn by_layout(pushes: &[Push], limits: &[Limit]) {
    println!("\nThe coefficient of friction that each push tells, its median and where half of them lie:\n");
    for surface in SURFACES {
        for (layout, (name, _)) in LAYOUTS.iter().enumerate() {
            let own = pushes
                .iter()
                .zip(limits)
                .filter(|(push, _)| push.surface == surface && push.layout == layout);
            let told: Vec<f64> = own.map(|(_, limit)| 1.0 / limit.factor).collect();
            let [low, median, high] = [25, 50, 75].map(|part| quantile(told.clone(), part));
            println!("{surface:<11}{name:<8}{median:>8.3}{low:>10.3} to {high:.3}");
        }
    }
}

/// Prints coefficients from pushes in opposite directions; with a single coefficient of friction both would be equal.
fn by_direction(pushes: &[Push], limits: &[Limit]) {
    println!(
        "\nThe median coefficient of pushes one way and the other, in percent beside that of all of the layout:\n"
    );
    println!("{:<19}{:>18}{:>18}{:>22}", "", "towards +x, -x", "towards +y, -y", "turning left, right");
    for surface in SURFACES {
        for (layout, (name, _)) in LAYOUTS.iter().enumerate() {
            let own = || {
                let all = pushes.iter().zip(limits);
                all.filter(move |(push, _)| push.surface == surface && push.layout == layout)
            };
            let median = |is_meant: &dyn Fn(&Push) -> bool| {
                let those = own().filter(|(push, _)| is_meant(push)).map(|(_, limit)| 1.0 / limit.factor);
                quantile(those.collect(), 50)
            };
            let all = median(&|_| true);
            let beside = |component: usize| {
                let ways = [1.0, -1.0].map(|sign| median(&|push: &Push| sign * push.load[component] > 0.0));
                let [one, other] = ways.map(|mu| format!("{:+.0}", 100.0 * (mu / all - 1.0)));
                format!("{one}, {other}")
            };
            println!("{surface:<11}{name:<8}{:>18}{:>18}{:>22}", beside(0), beside(1), beside(2));
        }
    }
    println!(
        "\nWith supports 33 mm apart (3pts1) pushes that turn right tell 3 to 5 % more than those that turn left, on both surfaces: a lever of 15 mm, of which a"
    );
    println!(
        "millimetre between finger and centre of mass is much. On plywood the second layout rubs 14 % more towards +y than back: one coefficient is not right for both."
    );
}

/// The fraction of a push that lies on the ellipsoid for a coefficient of one. The ellipsoid's axes are the largest friction force, and the largest
/// moment of friction about the centre.
fn on_the_ellipsoid(push: &Push) -> f64 {
    let at = supports(push.layout);
    let loads = normal_forces(&at);
    let moment: f64 = at.iter().zip(loads).map(|(at, load)| load * at.norm()).sum();
    1.0 / (push.load.xy().norm() / WEIGHT).hypot(push.load.z / moment)
}

/// Angle between two motions, degrees, with rotations multiplied by [`LENGTH`].
fn angle_between(a: &Vector3<f64>, b: &Vector3<f64>) -> f64 {
    let [a, b] = [a, b].map(|v| Vector3::new(v.x, v.y, LENGTH * v.z));
    a.angle(&b).to_degrees()
}

/// The value below which `percent` of the values lie.
fn quantile(mut values: Vec<f64>, percent: usize) -> f64 {
    values.sort_by(f64::total_cmp);
    values[(values.len() - 1) * percent / 100]
}
