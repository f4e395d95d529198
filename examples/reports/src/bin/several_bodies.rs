//! Several bodies: are equilibria of everyday piles decided, how long do walls take, and how thick must an arch be?
//!
//! `cargo run --release -p reports --bin several_bodies [piles of each kind [rows of bricks]]` (400 and 32 by default)

use grasp_lcp::grasp::{Bodies, Wrench};
use grasp_lcp::{planar, spatial};
use support::best_time::once;
use support::piles::{Arch, books, boxes, wall};
use support::spatial_piles::spatial_wall;
use support::splitmix::Random;

type Failure = Box<dyn std::error::Error>;

fn main() -> Result<(), Failure> {
    let mut numbers = std::env::args().skip(1).map(|text| text.parse::<usize>());
    let (each, rows) =
        (numbers.next().transpose()?.unwrap_or(400), numbers.next().transpose()?.unwrap_or(32));
    piles(each)?;
    walls(rows)?;
    spatial_walls(rows)?;
    falling_walls(rows)?;
    arches()
}

/// Boxes on a table, the last pushed, and pulled upwards by two fingers.
fn piles(each: usize) -> Result<(), Failure> {
    println!("{each} piles of each kind; of those in which boxes stand on each other at all:\n");
    println!(
        "{:<28}{:>8}{:>8}{:>12}{:>12}{:>12}",
        "", "asked", "hold", "undecided", "median ms", "longest ms"
    );
    let mut random = Random(2026);
    for (count, fingers) in [(2, false), (2, true), (4, false), (4, true), (8, false)] {
        let (mut held, mut undecided, mut times) = (0, 0, Vec::new());
        for pile in (0..each).filter_map(|_| boxes(&mut random, count, fingers)) {
            let grasp = pile.bodies.grasp()?;
            let (verdict, time) = once(|| Ok(grasp.hold(pile.load)?))?;
            let holds = verdict.holds();
            times.push(1e3 * time);
            held += usize::from(holds == Some(true));
            undecided += usize::from(holds.is_none());
        }
        times.sort_by(f64::total_cmp);
        let (Some(median), Some(longest)) = (times.get(times.len() / 2), times.last()) else { continue };
        let name = format!("{count} boxes{}", if fingers { ", two fingers" } else { "" });
        println!("{name:<28}{:>8}{held:>8}{undecided:>12}{median:>12.3}{longest:>12.1}", times.len());
    }
    Ok(())
}

/// Walls that are pushed at the top, and rows of books that are carried between hands: prints numbers of contacts and run times.
fn walls(rows: usize) -> Result<(), Failure> {
    println!("\n{:<24}{:>10}{:>12}{:>12}{:>14}", "", "contacts", "solve ms", "hold ms", "ms a body");
    for rows in [3, 6, 9, 10, 14, 20, 32].into_iter().filter(|side| *side <= rows) {
        let push = planar::Wrench::force_at([5.0, 0.0], [0.5, 0.5 * rows as f64 - 0.1]);
        timed(&format!("{} bricks, pushed", rows * rows), rows * rows, wall(rows), push)?;
    }
    for count in [10, 30, 100, 300, 1000].into_iter().filter(|count| *count <= rows * rows) {
        timed(
            &format!("{count} books, one pulled"),
            count,
            books(count),
            planar::Wrench::force([0.0, -5.0]),
        )?;
    }
    Ok(())
}

/// Walls in space, where each half of a brick rests on four points.
fn spatial_walls(rows: usize) -> Result<(), Failure> {
    for rows in [3, 6, 10, 14, 17].into_iter().filter(|side| 2 * *side <= rows) {
        let push = spatial::Wrench::force_at([5.0, 0.0, 0.0], [0.5, 0.0, 0.5 * rows as f64 - 0.1]);
        timed(&format!("{} bricks in space", rows * rows), rows * rows, spatial_wall(rows), push)?;
    }
    Ok(())
}

/// Walls that cannot stand: they are tilted by 45°, while friction holds up to 31° only.
fn falling_walls(rows: usize) -> Result<(), Failure> {
    println!("\n{:<24}{:>10}{:>12}", "tilted by 45°", "contacts", "solve ms");
    for rows in [3, 6, 10, 14, 20, 32].into_iter().filter(|side| *side <= rows) {
        fall(&format!("{} bricks", rows * rows), wall(rows).gravity([7.0, -7.0]))?;
    }
    for rows in [3, 6, 10].into_iter().filter(|side| 2 * *side <= rows) {
        fall(&format!("{} bricks in space", rows * rows), spatial_wall(rows).gravity([7.0, 0.0, -7.0]))?;
    }
    Ok(())
}

/// Prints the time to prove that the bodies have no equilibrium.
fn fall<const C: usize>(name: &str, bodies: Bodies<C>) -> Result<(), Failure> {
    let grasp = bodies.grasp()?;
    let (outcome, time) = once(|| Ok(grasp.solve(Wrench::ZERO)?))?;
    println!("{name:<24}{:>10}{:>12.1}   {outcome}", grasp.len(), 1e3 * time);
    Ok(())
}

/// Prints the run times of an equilibrium and of a verdict.
fn timed<const C: usize>(
    name: &str,
    count: usize,
    bodies: Bodies<C>,
    load: Wrench<C>,
) -> Result<(), Failure> {
    let grasp = bodies.grasp()?;
    let (rests, solving) = once(|| Ok(grasp.solve(Wrench::ZERO)?))?;
    let (verdict, holding) = once(|| Ok(grasp.hold(load)?))?;
    let says = match (rests.equilibrium().is_some(), verdict.holds()) {
        (false, _) => "does not stand",
        (true, Some(true)) => "holds",
        (true, Some(false)) => "does not hold",
        (true, None) => "undecided",
    };
    let ([solved, held], contacts) = ([solving, holding].map(|time| 1e3 * time), grasp.len());
    println!("{name:<24}{contacts:>10}{solved:>12.1}{held:>12.1}{:>14.3}   {says}", held / count as f64);
    Ok(())
}

/// Prints the least thickness of semicircular arches over their mean radius, by the line of thrust and by equilibria. The arches stand
/// under their own weight, without sliding.
fn arches() -> Result<(), Failure> {
    println!(
        "\n{:<12}{:>20}{:>20}   (Milankovitch: 0.1075 for many stones)",
        "stones", "line of thrust", "equilibria"
    );
    for stones in [5, 8, 13, 21] {
        let (mut falls, mut stands) = (0.0, 0.3);
        while stands - falls > 1e-9 {
            let thickness = 0.5 * (falls + stands);
            let outcome = Arch { stones, thickness }.voussoirs().bodies(10.0).grasp()?.solve(Wrench::ZERO)?;
            *(if outcome.equilibrium().is_some() { &mut stands } else { &mut falls }) = thickness;
        }
        println!("{stones:<12}{:>20.9}{stands:>20.9}", Arch::least_thickness(stones));
    }
    println!("{:<12}{:>20.9}", 400, Arch::least_thickness(400));
    Ok(())
}
