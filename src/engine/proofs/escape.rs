//! The margin of a linear contradiction: forces that escape it through rounding must be far larger than the data.
//!
//! With a unit y and generators g of length one let `y·g <= δ` for all of them. Then a sum of generators with shares s has
//! `y·Σ s g <= δ Σ s`. A target t with y·t > 0 is such a sum only if `Σ s >= y·t / δ`.

use super::tolerances::{ESCAPE, LEAST_WORK};

/// Whether a contradiction counts on the way from a load on which y does the work `here` to a load with the work `past`. Generators do up to
/// `against` along -y, and the data have the size `data`. At the part t of the way the work is `here + t (past - here)`, so that an escape
/// exceeds the data by [`ESCAPE`] from some t on.
pub(crate) fn counts_from_here_on(here: f64, past: f64, against: f64, data: f64) -> bool {
    // A contradiction of all loads beyond a load counts from this part of the way to the next load on. The rest is rounding of the place where
    // the path ended.
    ESCAPE * data * against.max(LEAST_WORK) - here <= 1e-6 * (past - here)
}
