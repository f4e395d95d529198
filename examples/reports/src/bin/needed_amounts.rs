//! Are the amounts that `need` finds right, compared with brute force, and how many verdicts does it compute for one?
//!
//! `cargo run --release -p reports --bin needed_amounts [scenes [amounts [family [first scene]]]]`
//!
//! In random scenes of each quantity, `hold` tries many amounts around each answer of `need`. The family `cards` has houses of cards.

use std::ops::Range;

use grasp_lcp::Error;
use grasp_lcp::need::Need;
use grasp_lcp::planar::Wrench;
use support::Failure;
use support::amounts::{self, Quantity, Scene, checked};
use support::best_time::once;
use support::cards::HouseOfCards;
use support::samples::seeded;
use support::splitmix::Random;

fn main() -> Result<(), Failure> {
    let asked =
        |at: usize, default: i32| std::env::args().nth(at).map_or(Ok(default), |count| count.parse::<i32>());
    let (scenes, amounts) = (asked(1, 10)?, asked(2, 40)?);
    let family = std::env::args().nth(3).unwrap_or_default();
    let first = asked(4, 0)?;
    println!("{scenes} scenes of each quantity, {amounts} amounts around each answer\n");
    println!("                         scenes                  amounts tried    run time of need");
    println!(
        "sought                   wrong   undecided       mean    most     in holds (median, all, most)"
    );
    let planar = |name: &str, quantity: Quantity<2>| {
        survey(&family, (name, ""), &amounts::planar, quantity, (first..first + scenes, amounts))
    };
    let spatial = |name: &str, quantity: Quantity<3>| {
        survey(&family, (name, " in space"), &amounts::spatial, quantity, (first..first + scenes, amounts))
    };
    planar("squeeze", amounts::squeeze())?;
    spatial("squeeze", amounts::squeeze())?;
    planar("friction", amounts::friction())?;
    spatial("friction", amounts::friction())?;
    planar("load", amounts::load())?;
    spatial("load", amounts::load())?;
    planar("load at rest", amounts::at_rest())?;
    spatial("load at rest", amounts::at_rest())?;
    planar("arm", amounts::arm())?;
    spatial("arm", amounts::arm())?;
    planar("force", amounts::force())?;
    spatial("force", amounts::force())?;
    if family == "cards" {
        cards()?;
    }
    Ok(())
}

/// Compares the least friction of houses of cards with the result of a linear program (HiGHS: balance of each card, `|F_t| <= μ
/// F_n`).
fn cards() -> Result<(), Failure> {
    println!("\nhouse of cards      least friction    by a linear program    run time, s");
    for (rows, least) in [(2, 0.332_787), (4, 0.399_078), (8, 0.432_130)] {
        let house = HouseOfCards::of(rows);
        let grasp = house.bodies(0.5).grasp()?;
        let (needed, time) = once(|| Ok(grasp.need(&Need::friction(Wrench::ZERO).if_lower_by(0.0, 0.0))?))?;
        let does = needed.amount.bound().unwrap_or(f64::NAN);
        println!("{rows} rows, {:3} cards {does:18.6}{least:23}{time:15.1}", house.cards());
    }
    Ok(())
}

/// Prints a line for a quantity, and a line for each scene in which an answer of `need` is wrong.
fn survey<const C: usize>(
    family: &str,
    (quantity, space): (&str, &str),
    draw: &dyn Fn(&mut Random) -> Result<Scene<C>, Error>,
    question: Quantity<C>,
    (scenes, amounts): (Range<i32>, i32),
) -> Result<(), Failure> {
    let name = format!("{quantity}{space}");
    if !family.is_empty() && family != name {
        return Ok(());
    }
    let (mut wrong, mut undecided, mut counts, mut times) = (Vec::new(), 0, Vec::new(), Vec::new());
    for number in scenes {
        let mut random = seeded(u64::try_from(number)?);
        let scene = draw(&mut random)?;
        let found = checked(&scene, question, amounts, &mut random)?;
        if let Some(first) = found.wrong.first() {
            wrong.push(format!("  {name} {number}: {} claims, {first}", found.wrong.len()));
        }
        undecided += i32::from(found.is_undecided);
        counts.extend(found.tried.map(|count| count as f64));
        times.push(found.times);
    }
    let mean = |list: &[f64]| list.iter().sum::<f64>() / list.len().max(1) as f64;
    let most = |list: &[f64]| list.iter().copied().fold(0.0, f64::max);
    let mut ratios: Vec<f64> = times.iter().map(|[need, hold]| need / hold).collect();
    ratios.sort_by(f64::total_cmp);
    let sum = |which: usize| times.iter().map(|times| times[which]).sum::<f64>();
    println!(
        "{name:24}{:6}{undecided:12}{:12.1}{:8}{:12.1}{:10.1}{:10.1}",
        wrong.len(),
        mean(&counts),
        most(&counts),
        ratios.get(ratios.len() / 2).unwrap_or(&0.0),
        sum(0) / sum(1),
        most(&ratios)
    );
    for line in wrong {
        println!("{line}");
    }
    Ok(())
}
