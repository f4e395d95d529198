//! The margin of a linear contradiction: forces that escape it through rounding must be far larger than the data.
//!
//! With a unit y and generators g of length one let `y·g <= δ` for all of them. Then a sum of generators with shares s has
//! `y·Σ s g <= δ Σ s`. A target t with y·t > 0 is such a sum only if `Σ s >= y·t / δ`.

use super::tolerances::{ESCAPE, LEAST_WORK};

/// Whether y contradicts all loads on the line between two loads, except very near its start. y does the work `value` on the first load and `past` on
/// the second. `against` is the most work of a generator against y, `data` the size of the data. At the part t of the line the work is `value + t
/// (past - value)`. From some t on, forces that escape the contradiction exceed the data by [`ESCAPE`].
pub(crate) fn counts_from_here_on(value: f64, past: f64, against: f64, data: f64) -> bool {
    // The condition says that the largest part t without a contradiction is at most 1e-6. Loads before it lie within the rounding of the load at
    // which the path ended.
    ESCAPE * data * against.max(LEAST_WORK) - value <= 1e-6 * (past - value)
}
