//! Parsers of the command line's numbers. The error of each parser states the unit and the allowed range.

use std::ops::RangeInclusive;

use grasp_lcp::words::Unit;

use crate::failure::Failure;

/// A number of larger magnitude, in SI units, is refused: no length, force or mass of a real object is larger.
const LARGEST_NUMBER: f64 = 1e50;

/// Numbers separated by commas.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Numbers(pub(crate) Vec<f64>);

impl std::str::FromStr for Numbers {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let number = |part: &str| match part.trim().parse::<f64>() {
            Ok(number) if number.is_finite() => Ok(number),
            _ if has_unit(part) => {
                Err(format!("`{part}` has a unit, must be a number; of lengths write --unit mm beside them"))
            }
            _ => Err(format!(
                "`{part}` is no finite number; write numbers with commas between them, such as 0,0,-1"
            )),
        };
        text.split(',').map(number).collect::<Result<_, _>>().map(Self)
    }
}

/// Whether `part` is a number followed by a unit of length.
fn has_unit(part: &str) -> bool {
    let number = part.trim().trim_end_matches(char::is_alphabetic);
    number.trim().parse::<f64>().is_ok() && Unit::of(&part.trim()[number.len()..]).is_some()
}

impl Numbers {
    /// Converts lengths in this unit to m.
    pub(crate) fn bring_to_metres(&mut self, unit: Unit) {
        for length in &mut self.0 {
            *length = unit.in_metres(*length);
        }
    }

    /// Components along the axes, two in the plane and three in space; the third is zero in the plane. Any other count of numbers is an error.
    pub(crate) fn along_axes(&self, axes: usize, option: &str) -> Result<[f64; 3], Failure> {
        if self.0.len() != axes {
            let space = if axes == 3 { "three numbers in space" } else { "two numbers in the plane" };
            return Err(Failure::Usage(format!("--{option}: {} given, must be {space}", self.0.len())));
        }
        Ok(std::array::from_fn(|a| self.0.get(a).copied().unwrap_or(0.0)))
    }
}

/// A force on one of several bodies, and the point where it acts.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct BodyPush {
    pub(crate) body: String,
    pub(crate) force: Numbers,
    pub(crate) at: Option<Numbers>,
}

impl std::str::FromStr for BodyPush {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        // The name of a body may contain an equals sign, a force may not: the last equals sign separates name and force.
        let Some((body, push)) = text.rsplit_once('=') else {
            return Err(format!("`{text}` names no body; write it with its force, such as upper=-5,0@0,0.2"));
        };
        let (force, at) = push.split_once('@').map_or((push, None), |(force, at)| (force, Some(at)));
        Ok(Self { body: body.to_owned(), force: force.parse()?, at: at.map(str::parse).transpose()? })
    }
}

/// Parses a mass, kg.
pub(crate) fn kilograms(text: &str) -> Result<f64, String> {
    within(text, f64::MIN_POSITIVE..=LARGEST_NUMBER, "a number of kg, more than 0, such as 0.5")
}

/// Parses the magnitude of a force, N.
pub(crate) fn newtons(text: &str) -> Result<f64, String> {
    within(text, 0.0..=LARGEST_NUMBER, "a number of N, from 0 on, such as 4.9")
}

/// Parses a standard deviation or a reduction, in percent.
pub(crate) fn percent(text: &str) -> Result<f64, String> {
    within(text, 0.0..=100.0_f64.next_down(), "a number of percent, from 0 to less than 100, such as 10")
}

/// Parses a safety factor, by which a load is multiplied.
pub(crate) fn times(text: &str) -> Result<f64, String> {
    within(text, f64::MIN_POSITIVE..=1e6, "how many times, above 0, at most 1e6, such as 2")
}

/// Parses the number of standard deviations by which uncertain data may deviate before a contact slides, for the map of forces in all directions.
pub(crate) fn deviations(text: &str) -> Result<f64, String> {
    within(text, f64::MIN_POSITIVE..=8.0, "a number of standard deviations, above 0, at most 8")
}

fn within(text: &str, range: RangeInclusive<f64>, allowed: &str) -> Result<f64, String> {
    let number = text.trim().parse().ok().filter(|number| range.contains(number));
    number.ok_or_else(|| format!("must be {allowed}"))
}

/// Parses a unit of length.
pub(crate) fn unit(text: &str) -> Result<Unit, String> {
    Unit::of(text).ok_or_else(|| "must be m, cm, mm or in".to_owned())
}

/// Parses a whole number.
pub(crate) fn count(text: &str) -> Result<usize, String> {
    text.trim().parse().map_err(|_| "must be a whole number, from 0 on".to_owned())
}
