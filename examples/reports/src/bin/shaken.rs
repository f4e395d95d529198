//! Repeated loads: do verdicts agree with cycles that are followed one by one, how long do they take, and from which load on does a rocked roller never
//! come to rest?
//!
//! `cargo run --release -p reports --bin shaken [cycles of each kind [grasps of the shake test]]` (60 and 2 000 by default)

use std::time::Instant;

use grasp_lcp::Error;
use grasp_lcp::load_path::Leg;
use grasp_lcp::shake::Repeats;
use grasp_lcp::spatial::{Contact, Grasp, Wrench};
use rayon::prelude::*;
use support::best_time::once;
use support::shaken::{
    Cycle, fault, in_space, in_the_plane, rocked_in_space, rocked_in_the_plane, roller_rests_up_to,
};
use support::splitmix::Random;

type Failure = Box<dyn std::error::Error>;

fn main() -> Result<(), Failure> {
    let mut numbers = std::env::args().skip(1).map(|text| text.parse::<usize>());
    let (each, grasps) =
        (numbers.next().transpose()?.unwrap_or(60), numbers.next().transpose()?.unwrap_or(2_000));
    println!(
        "{each} random cycles of each kind. Verdicts that speak of up to 400 cycles are judged by following those; the cost is told in followed cycles.\n"
    );
    println!(
        "{:<26}{:>7}{:>10}{:>10}{:>7}{:>7}{:>11}{:>7}{:>8}{:>9}",
        "", "rests", "dies out", "to and fro", "walks", "lost", "undecided", "wrong", "median", "at most"
    );
    kind("fingers in the plane", each, 1e-6, in_the_plane)?;
    kind("rocked in the plane", each, 1e-6, rocked_in_the_plane)?;
    kind("fingers in space", each / 4, 1e-5, in_space)?;
    kind("rocked in space", each / 4, 1e-5, rocked_in_space)?;
    println!("\nA roller that is rocked by w half widths of its contact rests up to this part of μ P:\n");
    println!("{:>5}{:>14}{:>14}{:>22}", "w", "41 springs", "81 springs", "1 - 3 w / 2 + w³ / 2");
    for w in [0.1, 0.2, 0.3_f64] {
        let rests = |springs| Ok::<_, Error>(roller_rests_up_to(springs, w)?.unwrap_or(f64::NAN));
        let (coarse, fine, limit) = (rests(41)?, rests(81)?, 1.0 - 1.5 * w + 0.5 * w.powi(3));
        println!("{w:>5}{coarse:>14.4}{fine:>14.4}{limit:>22.4}");
    }
    shake_test(grasps)
}

/// Compares the verdicts on one kind of scenes with followed cycles, and prints their number and times.
fn kind<const C: usize>(
    name: &str,
    each: usize,
    error: f64,
    draw: impl Fn(&mut Random) -> Result<Cycle<C>, Error>,
) -> Result<(), Failure> {
    let mut random = Random(2026);
    let (mut counts, mut wrong, mut costs) = ([0; 6], 0, Vec::new());
    for _ in 0..each {
        let cycle = draw(&mut random)?;
        let (shaken, time) = once(|| Ok(cycle.grasp.shake(cycle.base, &cycle.legs)?))?;
        let (_, one) = once(|| {
            let mut path = cycle.grasp.follow(cycle.base, &cycle.legs)?;
            Ok(path.by_ref().count())
        })?;
        costs.push(time / one);
        let kind = match shaken.repeats {
            Repeats::Rests { .. } => 0,
            Repeats::DiesOut { .. } => 1,
            Repeats::Alternates { .. } => 2,
            Repeats::Walks { .. } => 3,
            Repeats::Lost { .. } | Repeats::NoRest { .. } => 4,
            _ => 5,
        };
        counts[kind] += 1;
        wrong += usize::from(fault(&cycle, &shaken, 30, error)?.is_some());
    }
    costs.sort_by(f64::total_cmp);
    let [rests, dies_out, alternates, walks, lost, undecided] = counts;
    let (median, most) = (costs[costs.len() / 2], costs[costs.len() - 1]);
    println!(
        "{name:<26}{rests:>7}{dies_out:>10}{alternates:>10}{walks:>7}{lost:>7}{undecided:>11}{wrong:>7}{median:>8.1}{most:>9.0}"
    );
    Ok(())
}

/// Prints how many grasps of three fingers on a ball survive a weight and accelerations of 2 g to and fro along three axes. Also prints the number of
/// verdicts in a second.
fn shake_test(grasps: usize) -> Result<(), Failure> {
    let mut random = Random(45);
    let drawn: Vec<_> = (0..grasps).map(|_| three_fingers(&mut random)).collect::<Result<_, _>>()?;
    let weight = Wrench::force([0.0, 0.0, -1.0]);
    let pulls = (0..6).map(|k| {
        let mut force = [0.0; 3];
        force[k / 2] = if k % 2 == 0 { 2.0 } else { -2.0 };
        Wrench::force(force)
    });
    let cycle: Vec<_> = pulls.flat_map(Leg::there_and_back).collect();
    let start = Instant::now();
    let answers: Vec<_> =
        drawn.par_iter().map(|grasp| grasp.shake(weight, &cycle)).collect::<Result<_, _>>()?;
    let seconds = start.elapsed().as_secs_f64();
    let count = |rests: Option<bool>| answers.iter().filter(|shaken| shaken.stays() == rests).count();
    println!(
        "\nA shake test of {grasps} grasps by three fingers, 2 g along three axes: {} stay, {} leave, {} undecided; {:.0} verdicts a second on {} threads",
        count(Some(true)),
        count(Some(false)),
        count(None),
        grasps as f64 / seconds,
        rayon::current_num_threads()
    );
    Ok(())
}

fn three_fingers(random: &mut Random) -> Result<Grasp, Error> {
    let mut between = |low: f64, high: f64| low + (high - low) * random.uniform();
    let finger = |i: i32| {
        let angle = std::f64::consts::TAU * (f64::from(i) + between(-0.15, 0.15)) / 3.0;
        let height: f64 = between(-0.4, 0.4);
        let normal = [-angle.cos() * height.cos(), -angle.sin() * height.cos(), -height.sin()];
        Contact::new(normal.map(|x| -0.03 * x), normal)
            .series_stiffness(between(1e3, 1e4), between(1e3, 1e4))
            .friction(between(0.4, 0.9))
            .pressed_with(between(2.0, 8.0))
    };
    Grasp::new((0..3).map(finger).collect::<Vec<_>>())
}
