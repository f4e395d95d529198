//! What slips tell: how often intervals hold the truth, and what measured pushes say of the supports that they were made on.
//!
//! `cargo run --release -p reports --bin identified`
//!
//! Intervals are asked to hold the truth 95 times in 100. Slips of grasps whose numbers are known are drawn with scatter a thousand times, and how often that is so
//! is counted; with a thousand draws chance alone is off by 0.7 in 100. Then friction and loads of supports are found from measured pushes (see
//! [`support::measured_pushes`]), layout by layout, the block weighed, beside what the supports carry by statics.

use std::error::Error;
use std::time::Instant;

use grasp_lcp::identify::{Identify, Slip, Unknown};
use grasp_lcp::nalgebra::Vector2;
use grasp_lcp::spatial::Wrench;
use support::Failure;
use support::identified::{Known, first_slips, pinch, three_feet};
use support::measured_pushes::{LAYOUTS, Push, SURFACES, WEIGHT, blocks, normal_forces, pushes, supports};

const DRAWS: usize = 1000;

fn main() -> Result<(), Box<dyn Error>> {
    println!("Of {DRAWS} draws so many in 100 have the truth in their interval of 95 %:\n");
    println!("{:<42}{:>8}{:>10}   unknown by unknown", "", "slips", "scatter");
    for slips in [3, 5, 10, 30] {
        covered(&pinch(slips)?)?;
    }
    covered(&first_slips()?)?;
    covered(&three_feet(16)?)?;
    supports_of_pushes()
}

fn covered<const C: usize>(known: &Known<C>) -> Result<(), Failure> {
    let start = Instant::now();
    let coverage = known.coverage(DRAWS)?;
    let seconds = start.elapsed().as_secs_f64();
    let told = |unknown: usize| {
        let open = DRAWS - coverage.told[unknown];
        let open = if open > 0 { format!(" ({open} not told)") } else { String::new() };
        format!("{:.1}{open}", coverage.percent(unknown))
    };
    let told: Vec<_> = (0..known.truth.len()).map(told).collect();
    let told_scatter = if known.is_told { "told" } else { "sought" };
    println!(
        "{:<42}{:>8}{told_scatter:>10}   {}   ({:.1} ms each)",
        known.name,
        known.loads.len(),
        told.join(" "),
        1e3 * seconds / DRAWS as f64
    );
    Ok(())
}

/// Friction and what each support carries, from the pushes of one surface and one layout.
fn supports_of_pushes() -> Result<(), Box<dyn Error>> {
    let (blocks, pushes) = (blocks()?, pushes()?);
    println!(
        "\nLoads of supports in N, from 50 measured pushes each, the block weighed; so many standard errors from what statics says:\n"
    );
    println!(
        "{:<11}{:<8}{:>16}   {:<28}{:<28}{:<28}{:>9}{:>14}",
        "", "", "friction", "first", "second", "third", "scatter", "centre (mm)"
    );
    let (mut within, mut all) = (0, 0);
    for surface in SURFACES {
        for (layout, (name, _)) in LAYOUTS.iter().enumerate() {
            let own = pushes.iter().filter(|push| push.surface == surface && push.layout == layout);
            let slip = |push: &Push| {
                Slip::gross(Wrench::new([push.load.x, push.load.y, 0.0], [0.0, 0.0, push.load.z]))
            };
            let carried = (0..3).map(|k| Unknown::carried().of_contacts([k]).starting_at(WEIGHT / 3.0));
            let unknowns = std::iter::once(Unknown::friction().starting_at(0.3)).chain(carried);
            let asked = Identify::new(unknowns, own.map(slip)).knowing(1..4, WEIGHT, 1e-3);
            let found = asked.answered_by(&blocks[layout])?;
            let error = |k: usize| found.estimates[k].standard_error;
            let mut told = Vec::new();
            for (k, truth) in normal_forces(&supports(layout)).iter().enumerate() {
                let value = found.estimates[1 + k].value;
                told.push(match error(1 + k) {
                    Some(error) => {
                        let off = (value - truth) / error;
                        all += 1;
                        within += usize::from(off.abs() <= 2.0);
                        format!("{value:.2} ± {error:.2} of {truth:.2} ({off:+.1})")
                    }
                    None => format!("not fixed, of {truth:.2}"),
                });
            }
            let mu = error(0).map_or("not fixed".to_owned(), |error| {
                format!("{:.4} ± {error:.4}", found.estimates[0].value)
            });
            let scatter = found.scatter.map_or(String::new(), |scatter| format!("{:.1} %", 100.0 * scatter));
            // The loads balance the weight where it acts.
            let moments = supports(layout).into_iter().zip(&found.estimates[1..]);
            let centre: Vector2<f64> = moments.map(|(at, load)| at * (1e3 * load.value / WEIGHT)).sum();
            println!(
                "{surface:<11}{name:<8}{mu:>16}   {:<28}{:<28}{:<28}{scatter:>9}{:>8.1}, {:.1}",
                told[0], told[1], told[2], centre.x, centre.y
            );
            for combination in &found.free {
                println!("{:19}{}", "", combination.says);
            }
        }
    }
    println!(
        "\n{within} of {all} loads are within two standard errors. The centre is that of mass, which these loads balance, from where it was said to be."
    );
    Ok(())
}
