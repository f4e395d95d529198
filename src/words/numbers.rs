//! Numbers with their units, and directions. A [`Words`] has the number of digits and the unit of lengths of an answer's text. A format string can
//! pass to the `Display` of an answer only one number, the precision. Therefore a [`Words`] is passed on as this number: the digits, plus codes for
//! the unit of lengths and for the plane.

use core::fmt;

use nalgebra::SVector;

use super::tolerances::ALIKE_IN_WORDS;
use super::unit::Unit;
use crate::numerics::tolerances::NEGLIGIBLE;
use crate::numerics::{Space, amax, dot, mapped};
use crate::prelude::*;

/// Default number of significant digits.
const DEFAULT_DIGITS: usize = 6;

/// The tolerance with which numbers are rounded up or down. A number that differs from a decimal with the written number of digits by less than this
/// fraction is still written as that decimal.
///
/// If smaller, an exact 4 N that was computed as 4.00000001 N is written as 4.00001 N. If larger, a written limit exceeds the computed one by more.
const ROUNDING: f64 = 1e-8;

/// Added to a formatter's precision to mark an answer as planar, although its vectors have three components. This number exceeds every sum of a
/// number of digits and a code for the unit of lengths.
const IN_THE_PLANE: usize = 1 << 14;

/// Factor by which the index in [`UNITS`] of the unit of lengths is multiplied in a formatter's precision, which also holds the number of digits.
const PER_UNIT: usize = 1 << 12;

/// The units of lengths, in the order of their index in a formatter's precision.
const UNITS: [Unit; 4] = [Unit::Metre, Unit::Centimetre, Unit::Millimetre, Unit::Inch];

/// Format of numbers: the number of significant digits and the unit of lengths. Trailing zeros, and a minus sign before zero, are not written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[must_use]
pub struct Words {
    digits: usize,
    /// Whether vectors that are stored with three components belong to the plane or to space.
    space: Space,
    /// Unit of lengths, points and arms. If it is the metre, lengths below 0.1 m are written in mm.
    unit: Unit,
    rounding: Rounding,
}

/// The direction in which a number is rounded to its digits.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Rounding {
    Nearest,
    Up,
    Down,
}

impl Default for Words {
    fn default() -> Self {
        Self { digits: DEFAULT_DIGITS, space: Space::Spatial, unit: Unit::Metre, rounding: Rounding::Nearest }
    }
}

impl Words {
    /// The format for numbers with this many significant digits. Fewer than 1 count as 1, more than 17 as 17.
    pub fn with_digits(digits: usize) -> Self {
        // A double has no more than 17 digits.
        Self { digits: digits.clamp(1, 17), ..Self::default() }
    }

    /// The same format with lengths, points and arms in this unit. If the unit is the metre, lengths below 0.1 m are written in mm.
    pub fn in_unit(self, unit: Unit) -> Self {
        Self { unit, ..self }
    }

    /// The format that [`Self::precision`] put into a formatter: significant digits, plane or space, and the unit of lengths.
    pub(crate) fn of(f: &fmt::Formatter<'_>) -> Self {
        let Some(precision) = f.precision() else { return Self::default() };
        let space = if precision >= IN_THE_PLANE { Space::Planar } else { Space::Spatial };
        let unit = UNITS[precision % IN_THE_PLANE / PER_UNIT];
        Self::with_digits(precision % PER_UNIT).in_space(space).in_unit(unit)
    }

    /// The same format with this many significant digits. Fewer than 1 count as 1, more than 17 as 17.
    pub(crate) fn rounded_to(self, digits: usize) -> Self {
        Self { digits: Self::with_digits(digits).digits, ..self }
    }

    /// The same format with numbers rounded up. It is used for needed amounts: the amount as it is written then suffices, too.
    pub(crate) fn upwards(self) -> Self {
        Self { rounding: Rounding::Up, ..self }
    }

    /// The same format with numbers rounded down. It is used for largest loads: the load as it is written is then held, too.
    pub(crate) fn downwards(self) -> Self {
        Self { rounding: Rounding::Down, ..self }
    }

    /// The number `x`, moved by almost half of its last written digit, so that its nearest decimal is `x` rounded in the direction of this format.
    /// `magnitude` is the decimal exponent of the first digit of `x`: 2 for 345.
    fn directed(self, x: f64, magnitude: f64) -> f64 {
        let half_of_last_digit = 0.5 * 10.0_f64.powf(magnitude + 1.0 - self.digits as f64);
        let moved = (half_of_last_digit - ROUNDING * x.abs()).max(0.0);
        match self.rounding {
            Rounding::Nearest => x,
            Rounding::Up => x + moved,
            Rounding::Down => x - moved,
        }
    }

    /// The same format for vectors of the plane or of space.
    pub(crate) fn in_space(self, space: Space) -> Self {
        Self { space, ..self }
    }

    /// The space of vectors with `C` components; three components may also belong to the plane.
    pub(crate) fn space<const C: usize>(self) -> Space {
        if C == 2 { Space::Planar } else { self.space }
    }

    /// This format as one number, a formatter's precision, for formatting an answer or a part of it: `format!("{answer:.0$}", words.precision())`.
    #[must_use]
    pub fn precision(self) -> usize {
        let unit = UNITS.iter().position(|unit| *unit == self.unit).unwrap_or_default();
        self.digits + PER_UNIT * unit + if self.space == Space::Planar { IN_THE_PLANE } else { 0 }
    }

    /// Number of significant digits.
    #[must_use]
    pub fn digits(self) -> usize {
        self.digits
    }

    /// A number as text, without a unit.
    #[must_use]
    pub fn number(self, x: f64) -> String {
        if x.is_nan() {
            return "not known".to_owned();
        }
        if x.is_infinite() {
            return if x > 0.0 { "∞" } else { "−∞" }.to_owned();
        }
        if x == 0.0 {
            return "0".to_owned();
        }
        let magnitude = x.abs().log10().floor();
        let x = self.directed(x, magnitude);
        if !(-4.0..9.0).contains(&magnitude) {
            let text = format!("{x:.*e}", self.digits - 1);
            let (mantissa, exponent) = text.split_once('e').unwrap_or((&text, "0"));
            return format!("{}e{exponent}", trimmed(mantissa));
        }
        let decimals = (self.digits as f64 - 1.0 - magnitude).max(0.0);
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "from 0 to 20")]
        let text = format!("{x:.*}", decimals as usize);
        trimmed(&text).to_owned()
    }

    /// Numbers as text, in parentheses. Components that are so small compared with the largest that they may be rounding are written as zero.
    #[must_use]
    pub fn numbers(self, components: &[f64]) -> String {
        let largest = amax(components);
        let clean = |x: &f64| self.number(self.beside(*x, largest));
        format!("({})", mapped(components, &clean).join(", "))
    }

    /// The number `x`; zero if `x` is so small in comparison with `largest` that it is due to rounding.
    #[must_use]
    pub fn beside(self, x: f64, largest: f64) -> f64 {
        // Components below this fraction of the largest are taken for rounding errors. With more than six digits the limit is stricter.
        let rounding = if self.digits > DEFAULT_DIGITS { 1e-13 } else { NEGLIGIBLE };
        if x.abs() <= rounding * largest { 0.0 } else { x }
    }

    /// A length in the unit of lengths; if this unit is the metre, lengths below 0.1 m are written in mm.
    #[must_use]
    pub fn length(self, metres: f64) -> String {
        let in_mm = self.unit == Unit::Metre && metres.abs() < 0.1;
        if in_mm { self.in_unit(Unit::Millimetre).reach(metres) } else { self.reach(metres) }
    }

    /// A length in the unit of lengths, for example "0.05 m". Unlike [`Self::length`], it is not written in mm if it is short.
    pub(crate) fn reach(self, metres: f64) -> String {
        format!("{} {}", self.number(self.unit.of_metres(metres)), self.unit)
    }

    /// A point in the unit of lengths: "(0.03, 0) m".
    #[must_use]
    pub fn place<const C: usize>(self, point: &SVector<f64, C>) -> String {
        format!("{} {}", self.vector(&point.map(|x| self.unit.of_metres(x))), self.unit)
    }

    /// An angle in degrees.
    #[must_use]
    pub fn angle(self, radians: f64) -> String {
        format!("{}°", self.number(radians.to_degrees()))
    }

    /// The components of a vector in parentheses.
    pub(crate) fn vector<const C: usize>(self, vector: &SVector<f64, C>) -> String {
        self.numbers(&vector.as_slice()[..self.space::<C>().axes()])
    }

    /// A direction: a signed axis such as "−z", or the components.
    #[must_use]
    pub fn along<const C: usize>(self, direction: &SVector<f64, C>) -> String {
        self.along_axes(&direction.as_slice()[..self.space::<C>().axes()])
    }

    fn along_axes(self, direction: &[f64]) -> String {
        let mut axis = 0;
        for k in 1..direction.len() {
            if direction[k].abs() > direction[axis].abs() {
                axis = k;
            }
        }
        let mut across = direction.to_vec();
        across[axis] = 0.0;
        if dot(&across, &across).sqrt() <= ALIKE_IN_WORDS * dot(direction, direction).sqrt() {
            let sign = if direction[axis] < 0.0 { "−" } else { "+" };
            format!("{sign}{}", ["x", "y", "z"][axis])
        } else {
            self.numbers(direction)
        }
    }
}

fn trimmed(text: &str) -> &str {
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.') } else { text }
}
