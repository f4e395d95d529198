//! When a linear contradiction counts: what escapes it, because of rounding, has to be larger than the data by far.
//!
//! With a unit y and generators g of length one let `y·g <= δ` for all of them. Then a sum of generators with shares s has
//! `y·Σ s g <= δ Σ s`. A target t with y·t > 0 is such a sum only if `Σ s >= y·t / δ`.

/// The least factor of what escapes over the data with which a contradiction counts.
pub(crate) const ESCAPE: f64 = 1e4;
/// No generator of length one is known to do less than this along a unit y: rounding.
pub(crate) const LEAST_WORK: f64 = 1e-15;
