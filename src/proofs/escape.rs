//! When a linear contradiction counts: what escapes it, because of rounding, has to be larger than the data by far.
//!
//! With a unit y and generators g of length one let `y·g <= δ` for all of them. Then a sum of generators with shares s has
//! `y·Σ s g <= δ Σ s`. A target t with y·t > 0 is such a sum only if `Σ s >= y·t / δ`.

/// The least factor of what escapes over the data with which a contradiction counts.
pub(crate) const ESCAPE: f64 = 1e4;
/// No generator of length one is known to do less than this along a unit y: rounding.
pub(crate) const LEAST_WORK: f64 = 1e-15;
/// A contradiction of all loads beyond one counts from where the load exceeds it by this part of the way to the next on. The rest is
/// rounding of the place where the path ended.
const EXCESS: f64 = 1e-6;

/// Whether nothing holds on the way from a load at which y does `here` to one at which it does `past`, when generators do up to `against`
/// along -y and the data have this size. At the part t of the way the work is `here + t (past - here)`, so that what escapes
/// is larger than the data by [`ESCAPE`] from some t on.
pub(crate) fn counts_from_here_on(here: f64, past: f64, against: f64, data: f64) -> bool {
    ESCAPE * data * against.max(LEAST_WORK) - here <= EXCESS * (past - here)
}
