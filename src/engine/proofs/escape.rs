//! The safety factor against rounding of a linear contradiction, i.e. of a proof by Farkas' lemma that a load cannot be balanced. Rounding may
//! hide from such a proof only an equilibrium whose forces are far larger than load and commands.
//!
//! Let the generators g be vectors of length one. The sums `Σ s g` with coefficients s >= 0 are all that contact forces and motions can produce. Let
//! a unit vector y have `y·g <= δ` for each generator, where δ is mere rounding. Then each of these sums has `y·Σ s g <= δ Σ s`. Hence a target t
//! with y·t > 0 is such a sum only if `Σ s >= y·t / δ`, i.e. only with very large coefficients.

use super::tolerances::{ESCAPE, LEAST_WORK};

/// Whether a unit vector y contradicts equilibrium under all loads on a line, except very near its start. The line leads from one load, whose work
/// along y is `value`, to another, whose work is `past`. At the fraction t of the line the work of the load is `(1 - t) value + t past`.
///
/// `negative_work` is the largest magnitude of negative work that a generator does along y; if y proves that the load is unbalanced, it is mere
/// rounding. `data` is the magnitude of load and commands together, N. The contradiction is accepted if rounding can hide from it only an equilibrium
/// with forces larger than `data` by the factor [`ESCAPE`].
pub(crate) fn counts_from_here_on(value: f64, past: f64, negative_work: f64, data: f64) -> bool {
    // If this condition holds, loads at fractions t >= 1e-6 of the line between the two loads are contradicted. Loads at a smaller t differ only
    // by rounding from the load at which the path ended.
    ESCAPE * data * negative_work.max(LEAST_WORK) - value <= 1e-6 * (past - value)
}
