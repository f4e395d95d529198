//! Gram–Schmidt orthogonalisation with column pivoting, on a matrix stored row by row. Every column is orthogonalised twice against the finished
//! columns, which keeps Q orthonormal to working precision.
//!
//! All functions are inlined with the number of columns d, so that the compiler knows the length of loops for d = 3 and d = 6.

use crate::numerics::Each;
use core::ops::Range;

use super::coordinates::{Square, Vector, WHOLE};
use super::tolerances::{FEW_ROUNDINGS, LINEARLY_DEPENDENT};
#[cfg(not(feature = "std"))]
use crate::prelude::*;

/// Factorises the matrix A with d columns whose rows are in `q`, one after another. The rows of the orthonormal factor Q overwrite them. Writes
/// the triangular factor to `r`, the reciprocals of its diagonal to `over_diagonal`, and the order of columns to `order`. Returns the rank.
#[inline(always)]
pub(super) fn factorise(
    d: usize,
    q: &mut [f64],
    r: &mut Square,
    over_diagonal: &mut Vector,
    order: &mut [usize],
) -> usize {
    let size = r.size();
    r.fill(0.0);
    order.iter_mut().enumerate().for_each(|(j, order)| *order = j);
    // Four lists with a number for each column of A. `full` is the length of the column, and `noise` a bound on the length of its rounding error.
    // `left` is the length of the column's remainder: the column less its projections on the finished columns. `parts` is the coefficient of the
    // column along the newest column of Q.
    let [mut full, mut noise, mut left, mut parts] = [(); 4].each(|()| Vector::all_zero(size));
    let [full, noise, left, parts] =
        [&mut full, &mut noise, &mut left, &mut parts].each(|list| &mut list.as_mut_slice()[..d]);
    lengths_and_noise(d, q, full, noise);
    left.copy_from_slice(full);
    let mut rank = 0;
    while rank < d {
        let k = rank;
        // The pivot column is the column with the longest remainder, among the columns whose remainder exceeds their rounding errors.
        let mut best = None;
        for j in k..d {
            if left[j] > (LINEARLY_DEPENDENT * full[j]).max(noise[j])
                && best.is_none_or(|(_, most)| left[j] > most)
            {
                best = Some((j, left[j]));
            }
        }
        let Some((pivot, _)) = best else { break };
        if pivot != k {
            for row in q.chunks_exact_mut(d) {
                row.swap(k, pivot);
            }
            r.swap_columns(k, pivot);
            order.swap(k, pivot);
            for list in [&mut *full, &mut *noise, &mut *left] {
                list.swap(k, pivot);
            }
        }
        let square = reorthogonalise(d, q, (parts, r.column_slice_mut(k)), k);
        let norm = square.sqrt();
        if norm <= (LINEARLY_DEPENDENT * full[k]).max(noise[k]) {
            // The remainder of this column consists of rounding errors, so the column is never chosen again.
            full[k] = f64::INFINITY;
            continue;
        }
        r[(k, k)] = norm;
        for row in q.chunks_exact_mut(d) {
            row[k] /= norm;
        }
        rank += 1;
        if rank == d {
            break;
        }
        subtract_from_later(d, q, k, (parts, left));
        for j in rank..d {
            left[j] = left[j].sqrt();
            r[(k, j)] = parts[j];
        }
    }
    if rank < d {
        for row in q.chunks_exact_mut(d.max(1)) {
            row[rank..].fill(0.0);
        }
    }
    for i in 0..d {
        over_diagonal[i] = 1.0 / r[(i, i)];
    }
    rank
}

#[inline(always)]
fn lengths_and_noise(d: usize, q: &[f64], full: &mut [f64], noise: &mut [f64]) {
    for row in q.chunks_exact(d.max(1)) {
        let mut sum = 0.0;
        for k in 0..d {
            let square = row[k] * row[k];
            full[k] += square;
            sum += square;
        }
        for k in 0..d {
            noise[k] += if row[k] == 0.0 { 0.0 } else { sum };
        }
    }
    for k in 0..d {
        (full[k], noise[k]) = (full[k].sqrt(), noise[k].sqrt() * FEW_ROUNDINGS);
    }
}

/// Orthogonalises column k a second time against the finished columns, since rounding in [`subtract_from_later`] leaves a component along them.
/// Adds the coefficients to column k of the triangular factor R, and returns the squared length of the remainder.
#[inline(always)]
fn reorthogonalise(d: usize, q: &mut [f64], (parts, r): (&mut [f64], &mut [f64]), k: usize) -> f64 {
    let over = looped(d, 0..k);
    add_products(d, q, k, (parts, over.clone()));
    parts[k..].fill(0.0);
    let (parts, r) = (&parts[..d], &mut r[..d]);
    for j in over.clone() {
        r[j] += parts[j];
    }
    let mut square = 0.0;
    for row in q.chunks_exact_mut(d) {
        let mut against = 0.0;
        for j in over.clone() {
            against += parts[j] * row[j];
        }
        row[k] -= against;
        square += row[k] * row[k];
    }
    square
}

/// Subtracts from the later columns their projection on column k, a unit vector. Stores the coefficients in `parts`, and the squared lengths of the
/// remainders in `left`.
#[inline(always)]
fn subtract_from_later(d: usize, q: &mut [f64], k: usize, (parts, left): (&mut [f64], &mut [f64])) {
    let over = looped(d, k + 1..d);
    add_products(d, q, k, (parts, over.clone()));
    parts[..=k].fill(0.0);
    left.fill(0.0);
    let (parts, left) = (&parts[..d], &mut left[..d]);
    for row in q.chunks_exact_mut(d) {
        let part = row[k];
        for j in over.clone() {
            row[j] -= parts[j] * part;
            left[j] += row[j] * row[j];
        }
    }
}

/// Dot products of column k with the columns `over`; all other entries of `products` are set to zero.
#[inline(always)]
fn add_products(d: usize, q: &[f64], k: usize, (products, over): (&mut [f64], Range<usize>)) {
    let products = &mut products[..d];
    products.fill(0.0);
    for row in q.chunks_exact(d) {
        let part = row[k];
        for j in over.clone() {
            products[j] += row[j] * part;
        }
    }
}

/// Range of columns for a loop that must cover the columns `needed`. For at most six columns it is the range of all columns, whose length the
/// compiler knows. The additional columns have zero coefficients, so they change nothing.
#[inline(always)]
fn looped(d: usize, needed: Range<usize>) -> Range<usize> {
    if d <= WHOLE { 0..d } else { needed }
}
