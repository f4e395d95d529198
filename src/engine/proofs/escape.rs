//! The margin of a linear contradiction: rounding may hide only an equilibrium whose forces are far larger than the data.
//!
//! With a unit y and generators g of length one let `y·g <= δ` for all of them. Then a sum of generators with shares s has
//! `y·Σ s g <= δ Σ s`. A target t with y·t > 0 is such a sum only if `Σ s >= y·t / δ`.

use super::tolerances::{ESCAPE, LEAST_WORK};

/// Whether y contradicts all loads on the line between two loads, except very near its start. y does the work `value` on the first load and `past` on
/// the second. `against` is the most work of a generator against y, within rounding, and `data` the size of the data. At the fraction t of the line
/// the work is `value + t (past - value)`. The contradiction counts where forces that rounding could hide exceed the data by the factor [`ESCAPE`].
pub(crate) fn counts_from_here_on(value: f64, past: f64, against: f64, data: f64) -> bool {
    // The condition says that the contradiction counts from t = 1e-6 on. Loads before that lie within the rounding of the load at which the path ended.
    ESCAPE * data * against.max(LEAST_WORK) - value <= 1e-6 * (past - value)
}
