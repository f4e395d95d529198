//! One step of a stiff differential equation `y' = f(y)` by the extrapolated linearly implicit Euler method.
//!
//! ```text
//! (1 - h_j J) Δ = h_j f(y),   h_j = h / j,   j = 1, 2, 3, …        T_jk = T_j,k-1 + (T_j,k-1 - T_j-1,k-1) / (j / (j-k+1) - 1)
//! ```
//!
//! J is the Jacobian of f, and Δ the change in a substep. T_j1 is the result of j substeps of length h_j. Each further column k of the extrapolation
//! scheme T_jk removes one power of h from the error. The difference of the last two columns estimates the remaining error. A step damps every
//! variable, however fast it decays. The caller solves systems with J, whose structure it knows.
//!
//! Source: Hairer and Wanner, Solving Ordinary Differential Equations II, second edition, section IV.9.

use super::add_times::{add_times, scale};
use super::dormand_prince::Stepped;
use crate::numerics::IntoList;
use crate::prelude::*;

/// One step of length `length` of y' = f(y), with an error below `tolerance`. The variables y are changes since the start of the step, where f(0) is
/// `first`; `rate` computes f(y), and `size` measures an error of y. For a length h, `damped` returns a function that solves `(1 - hJ) Δ = x` in
/// place, with the Jacobian J of f. `damped` returns `None` if this matrix is singular. The result is `None` if such a matrix is singular, or if f is
/// not defined at some y. Also `None` if the error does not fall below the tolerance.
pub(crate) fn implicit_step<F: Fn(&mut [f64])>(
    length: f64,
    first: &[f64],
    mut rate: impl FnMut(&[f64], &mut [f64]) -> Option<()>,
    damped: impl Fn(f64) -> Option<F>,
    size: impl Fn(&[f64]) -> f64,
    tolerance: f64,
) -> Option<Stepped> {
    let (mut y, mut change) = (vec![0.0; first.len()], vec![0.0; first.len()]);
    let mut before: Vec<Vec<f64>> = Vec::new();
    let mut last_error = f64::INFINITY;
    // Row j of the extrapolation scheme costs j substeps. A step that is not accurate after nine rows is too long, and the caller tries a shorter
    // one.
    for j in 1..=9 {
        let part = length / j as f64;
        let solve = damped(part)?;
        y.fill(0.0);
        for k in 0..j {
            if k == 0 {
                change.copy_from_slice(first);
            } else {
                rate(&y, &mut change)?;
            }
            scale(&mut change, part);
            solve(&mut change);
            add_times(&mut y, &change, 1.0);
        }
        let mut row = vec![y.clone()];
        for k in 1..j {
            let ratio = j as f64 / (j - k) as f64 - 1.0;
            let better = row[k - 1].iter().zip(&before[k - 1]).map(|(new, old)| new + (new - old) / ratio);
            row.push(better.list());
        }
        if j > 1 {
            let apart: Vec<f64> = row[j - 1].iter().zip(&row[j - 2]).map(|(a, b)| a - b).list();
            let error = size(&apart);
            if error <= tolerance {
                return row.pop().map(|change| Stepped { change, error });
            }
            // The first four rows of the extrapolation scheme may be too coarse for their error estimate. After them a step fails if the estimated
            // error grows from one row to the next.
            if !error.is_finite() || j > 4 && error > last_error {
                return None;
            }
            last_error = error;
        }
        before = row;
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A body moves by x' = cos θ at the angle θ from a direction, and turns towards it by θ' = -c sin θ. For any c the angle at the time t obeys
    /// `tan(θ/2) = tan(θ₀/2) exp(-ct)`, with θ₀ at t = 0.
    #[test]
    fn what_relaxes_fast_has_relaxed() {
        for (c, start) in [(1.0, 1.0), (1e3, 1e-6), (1e8, 1e-8)] {
            let rate = |y: &[f64], out: &mut [f64]| {
                let (sin, cos) = f64::sin_cos(start + y[0]);
                (out[0], out[1]) = (-c * sin, cos);
                Some(())
            };
            let size = |e: &[f64]| e[0].hypot(e[1]);
            let first = [-c * f64::sin(start), f64::cos(start)];
            let damped = |h: f64| {
                Some(move |x: &mut [f64]| {
                    x[0] /= 1.0 + h * c * start.cos();
                    x[1] -= h * start.sin() * x[0];
                })
            };
            let there = implicit_step(0.5, &first, rate, damped, size, 1e-9);
            let [angle, way] = there.map_or([f64::NAN; 2], |there| [there.change[0], there.change[1]]);
            let end = 2.0 * ((0.5 * start).tan() * f64::exp(-0.5 * c)).atan();
            assert!((start + angle - end).abs() < 1e-9, "{c:e}: {} {end}", start + angle);
            // The exact distance is x = ∫ -cos θ dθ / (c sin θ) from θ₀ to the final angle.
            let exact = (start.sin() / end.sin()).ln() / c;
            assert!(!exact.is_finite() || (way - exact).abs() < 1e-9, "{c:e}: {way} {exact}");
        }
    }
}
