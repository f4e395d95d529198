//! Intervals hold the truth as often as they say: 95 of 100 times, within what chance allows with so few draws.

use support::Failure;
use support::identified::{first_slips, pinch, three_feet};

/// With 300 draws 95 % scatter by 1.3 %: four of these on both sides. The report `identified` draws a thousand.
const DRAWS: usize = 300;

fn is_as_said(name: &str, unknowns: usize, percent: impl Fn(usize) -> f64) {
    for unknown in 0..unknowns {
        let percent = percent(unknown);
        assert!((90.0..=99.0).contains(&percent), "{name}, unknown {unknown}: {percent} %");
    }
}

#[test]
fn of_friction_from_few_slips() -> Result<(), Failure> {
    for slips in [3, 6] {
        let known = pinch(slips)?;
        let coverage = known.coverage(DRAWS)?;
        is_as_said(known.name, 1, |unknown| coverage.percent(unknown));
    }
    Ok(())
}

#[test]
fn of_first_slips_with_a_known_scatter() -> Result<(), Failure> {
    let known = first_slips()?;
    let coverage = known.coverage(DRAWS)?;
    is_as_said(known.name, 2, |unknown| coverage.percent(unknown));
    Ok(())
}

#[test]
fn of_friction_and_loads_of_supports() -> Result<(), Failure> {
    let known = three_feet(16)?;
    let coverage = known.coverage(100)?;
    is_as_said(known.name, 4, |unknown| coverage.percent(unknown));
    Ok(())
}
