//! Quality of identification from slips: how often intervals contain the truth, and which supports explain measured pushes.
//!
//! `cargo run --release -p reports --bin identified [draws] [turns of the ellipse] [layouts] [heights of the pusher]`
//!
//! Intervals should contain the truth 95 times in 100. Slips of grasps with known data are drawn with scatter a thousand times, and the intervals
//! that contain the truth are counted; with a thousand draws the standard error of this count is 0.7 in 100. Some slips are drawn with scatter that a
//! group shares.
//!
//! Then friction and loads of supports are identified from measured pushes (see [`support::measured_pushes`]), layout by layout, with a known weight
//! of the block. The loads are compared with those by statics ([`supports`]). Two questions follow: do pushes share errors ([`in_common`]), and does
//! another model explain them better ([`other_models`])?

mod in_common;
mod other_models;
mod supports;

use std::error::Error;
use std::time::Instant;

use support::Failure;
use support::identified::{Known, first_slips, pinch, pinch_in_series, three_feet, three_feet_by_direction};
use support::measured_pushes::LAYOUTS;

fn main() -> Result<(), Box<dyn Error>> {
    let draws = std::env::args().nth(1).map_or(Ok(1000), |draws| draws.parse())?;
    let turns = std::env::args().nth(2).map_or(Ok(8), |turns| turns.parse::<u8>())?;
    let layouts = std::env::args().nth(3).map_or(Ok(LAYOUTS.len()), |layouts| layouts.parse())?;
    let heights =
        std::env::args().nth(4).map_or(Ok(other_models::HEIGHTS.len()), |heights| heights.parse())?;
    println!("Of {draws} draws so many in 100 have the truth in their interval of 95 %:\n");
    println!("{:<64}{:>6}{:>9}   unknown by unknown", "", "slips", "scatter");
    for slips in [3, 5, 10, 30] {
        covered(&pinch(slips)?, draws)?;
    }
    covered(&first_slips()?, draws)?;
    covered(&three_feet(16)?, draws)?;
    println!("\nThe same where slips of a group share errors:\n");
    for series in [3, 6, 12] {
        covered(&pinch_in_series(series, 5)?, draws)?;
    }
    covered(&pinch_in_series(6, 5)?.without_groups(), draws)?;
    for directions in [8, 16] {
        covered(&three_feet_by_direction(directions)?, draws)?;
    }
    covered(&three_feet_by_direction(16)?.without_groups(), draws)?;
    supports::of_pushes(layouts)?;
    in_common::by_direction(layouts)?;
    other_models::compared(turns, layouts, heights)
}

fn covered<const C: usize>(known: &Known<C>, draws: usize) -> Result<(), Failure> {
    let start = Instant::now();
    let coverage = known.coverage(draws)?;
    let seconds = start.elapsed().as_secs_f64();
    let told = |unknown: usize| {
        let open = draws - coverage.told[unknown];
        let open = if open > 0 { format!(" ({open} not told)") } else { String::new() };
        format!("{:.1}{open}", coverage.percent(unknown))
    };
    let told: Vec<_> = (0..known.truth.len()).map(told).collect();
    let told_scatter = if known.is_told { "told" } else { "sought" };
    let groups = known.shared.as_ref().map_or(String::new(), |shared| {
        let groups = shared.count();
        if shared.is_told { format!(" ({groups} groups)") } else { format!(" ({groups} groups, not told)") }
    });
    println!(
        "{:<64}{:>6}{told_scatter:>9}   {}   ({:.1} ms each)",
        format!("{}{groups}", known.name),
        known.loads.len(),
        told.join(" "),
        1e3 * seconds / draws as f64
    );
    Ok(())
}
