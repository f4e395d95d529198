//! The shortest vector τ that satisfies linear inequalities with given vectors a_i and numbers b_i:
//!
//! ```text
//! min |τ|,    b_i + a_i·τ >= 0
//! ```
//!
//! τ follows from the point closest to (0, 1) in the cone that the vectors (a_i, -b_i) span. The residual r, (0, 1) less this point, is a positive
//! multiple of (-τ, 1).
//!
//! Source: least-distance programming, Lawson and Hanson, Solving Least Squares Problems (1974), chapter 23, section 4.

use super::nearest_point::NearestPoint;
use super::tolerances::{NEGLIGIBLE, SOLVED_ROUNDING};
use crate::numerics::{dot, largest, mapped, moved, summed};
use crate::prelude::*;

/// The shortest vector τ with `b + a·τ >= 0` for all `rows` (b, a). The vectors a have equal numbers of components and are not zero. `None` if
/// no τ satisfies all rows, if there are no rows, or if rounding ends the search.
pub(crate) fn least_distance(rows: Vec<(f64, Vec<f64>)>) -> Option<Vec<f64>> {
    let largest = largest(&rows, &|(value, _)| value.abs());
    let count = rows.first()?.1.len();
    let generator = |(value, mut row): (f64, Vec<f64>)| {
        row.push(if largest > 0.0 { -value / largest } else { 0.0 });
        let length = summed(&row, &|x| x * x).sqrt();
        for x in &mut row {
            *x /= length;
        }
        row
    };
    let generators: Vec<Vec<f64>> = moved(rows, &generator);
    let mut target = vec![0.0; count + 1];
    target[count] = 1.0;
    let mut nearest = NearestPoint::new(&target);
    for _ in 0..4 * generators.len() + 4 {
        let works = |k: &usize| {
            let work: f64 = dot(&generators[*k], nearest.residual());
            if nearest.has(*k) { f64::NEG_INFINITY } else { work }
        };
        let most = (0..generators.len()).max_by(|a, b| works(a).total_cmp(&works(b)))?;
        // The closest point is found if every generator g = (a, -b) of the cone has `g·r <= 0` with the residual r, up to rounding.
        if works(&most) <= SOLVED_ROUNDING {
            let (parts, last) = nearest.residual().split_at(count);
            // If the last component of the residual r is zero, no vector τ satisfies all inequalities.
            return (last[0] > NEGLIGIBLE).then(|| mapped(parts, &|r| -r / last[0] * largest));
        }
        if !nearest.add_generator(most, &generators[most], &target) {
            return None;
        }
        nearest.move_to_closest(&target);
    }
    None
}
