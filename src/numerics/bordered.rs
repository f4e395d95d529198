//! The linear equations of the object's balance, bordered by one column for the load factor and one row for the arclength of a load path. A load path
//! follows equilibria while the load changes.
//!
//! ```text
//! T y  + c z = …      balance
//! gᵀy  + γ z = …      arclength
//! ```
//!
//! T is the stiffness of the object's balance for motions y, and c the column of the load factor z. The row gᵀ and the corner γ are the coefficients
//! of the arclength. T alone becomes singular at a fold of the path (a maximum of the load factor), where the bordered matrix is regular.

use super::add_times::add_times;
use super::coordinates::{Indices, Square, Vector};

/// LU factors with partial pivoting of a bordered matrix: d rows of the balance matrix T, then the border row.
#[derive(Debug, Clone)]
pub(crate) struct Bordered {
    /// The rows of the balance matrix T, stored as columns, overwritten by its LU factors.
    rows: Square,
    /// The last column of the bordered matrix, without its corner.
    last: Vector,
    /// The border row, below the rows of the balance matrix T, without its corner.
    border: Vector,
    corner: f64,
    /// The original index of each row after row exchanges, counted from 0. The border row has index d, the number of rows of T.
    order: Indices,
    order_of_border: usize,
}

impl Bordered {
    /// The LU factors of the bordered matrix; `None` if it is singular. `stiffness` is the balance matrix T, and `cover` the column of the load
    /// factor. `gradient` is the row of the arclength, and `corner` its entry for the load factor.
    pub(crate) fn new(stiffness: &Square, cover: &Vector, gradient: &Vector, corner: f64) -> Option<Self> {
        let size = stiffness.size();
        let (d, entries) = (size.count(), stiffness.as_slice());
        let mut rows = Square::zeros(size);
        for i in 0..d {
            let row = rows.column_slice_mut(i);
            for j in 0..d {
                row[j] = entries[j * d + i];
            }
        }
        let (last, border) = (Vector::from_fn(size, |i| cover[i]), Vector::from_fn(size, |j| gradient[j]));
        let mut factors = Self { rows, last, border, corner, order: size.in_order(), order_of_border: d };
        for k in 0..d {
            factors.eliminate(k)?;
        }
        factors.corner = inverse(factors.corner)?;
        Some(factors)
    }

    /// Eliminates column k below the pivot, which is the largest entry of this column in the remaining rows. `None` if the pivot is zero, subnormal
    /// or not finite.
    fn eliminate(&mut self, k: usize) -> Option<()> {
        let size = self.rows.size();
        let d = size.count();
        let Self { rows, last, border, corner, order, order_of_border } = self;
        let (last, border, order) = (last.as_mut_slice(), border.as_mut_slice(), order.as_mut());
        let (before, behind) = rows.as_mut_slice().split_at_mut((k + 1) * d);
        let top = &mut before[k * d..];
        let (mut pivot, mut most) = (k, top[k].abs());
        for (i, row) in (k + 1..d).zip(behind.chunks_exact(d)) {
            if row[k].abs() > most {
                (pivot, most) = (i, row[k].abs());
            }
        }
        if border[k].abs() > most {
            top.swap_with_slice(border);
            core::mem::swap(&mut last[k], corner);
            core::mem::swap(&mut order[k], order_of_border);
        } else if pivot != k {
            top.swap_with_slice(&mut behind[(pivot - k - 1) * d..][..d]);
            last.swap(k, pivot);
            order.swap(k, pivot);
        }
        let inverse = inverse(top[k])?;
        // The inverse of the pivot is stored, since a pivot is only used as a divisor.
        top[k] = inverse;
        // Components of the pivot row up to the pivot are set to zero, so that loops of fixed length may run over all components.
        let row = Vector::from_fn(size, |j| if j > k { top[j] } else { 0.0 });
        let open = k + 1..d;
        let row = &row.as_slice()[open.clone()];
        let top_last = last[k];
        let below = behind.chunks_exact_mut(d).zip(&mut last[k + 1..]);
        for (below, below_last) in below.chain(core::iter::once((border, corner))) {
            let factor = below[k] * inverse;
            add_times(&mut below[open.clone()], row, -factor);
            below[k] = factor;
            *below_last -= factor * top_last;
        }
        Some(())
    }

    /// The smallest absolute pivot of the factors, divided by the largest.
    pub(crate) fn least_pivot(&self) -> f64 {
        let mut least = 1.0 / self.corner.abs();
        let mut largest = least;
        for k in 0..self.rows.size().count() {
            let pivot = 1.0 / self.rows[(k, k)].abs();
            (least, largest) = (least.min(pivot), largest.max(pivot));
        }
        least / largest
    }

    pub(crate) fn solve(&self, balance: &Vector, last: f64) -> (Vector, f64) {
        let size = self.rows.size();
        let d = size.count();
        let given = |from: usize| if from == d { last } else { balance[from] };
        let order = self.order.as_ref();
        let mut solution = Vector::from_fn(size, |i| given(order[i]));
        let mut z = given(self.order_of_border);
        let (x, border, lasts) = (solution.as_mut_slice(), self.border.as_slice(), self.last.as_slice());
        let rows = self.rows.as_slice();
        for j in 0..d {
            let known = x[j];
            for i in j + 1..d {
                x[i] -= rows[i * d + j] * known;
            }
            z -= border[j] * known;
        }
        z *= self.corner;
        for i in 0..d {
            x[i] -= lasts[i] * z;
        }
        for j in (0..d).rev() {
            x[j] *= rows[j * d + j];
            let known = x[j];
            for i in 0..j {
                x[i] -= rows[i * d + j] * known;
            }
        }
        (solution, z)
    }
}

/// Solves a bordered system of `N` rows once, without storing factors; the result equals the result of [`Bordered::solve`] bit for bit.
/// `stiffness` has the balance matrix T column by column; `column`, `border` and `corner` complete the bordered matrix. The right-hand side is
/// zero except for `last` in the border row. Also returns the smallest absolute pivot divided by the largest. `None` if the bordered matrix is
/// singular.
pub(crate) fn solved_once<const N: usize>(
    stiffness: &[f64],
    [column, border]: [&Vector; 2],
    [corner, last]: [f64; 2],
) -> Option<([f64; N], f64)> {
    let d = N - 1;
    let (mut rows, mut x) = ([[0.0; N]; N], [0.0; N]);
    for i in 0..d {
        for j in 0..d {
            rows[i][j] = stiffness[j * d + i];
        }
        (rows[i][d], rows[d][i]) = (column[i], border[i]);
    }
    (rows[d][d], x[d]) = (corner, last);
    let (mut least, mut most) = (f64::INFINITY, 0.0_f64);
    for k in 0..N {
        let mut pivot = k;
        for i in k + 1..N {
            if rows[i][k].abs() > rows[pivot][k].abs() {
                pivot = i;
            }
        }
        rows.swap(k, pivot);
        x.swap(k, pivot);
        let size = rows[k][k].abs();
        (least, most) = (least.min(size), most.max(size));
        let (top, inverse) = (rows[k], inverse(rows[k][k])?);
        rows[k][k] = inverse;
        for i in k + 1..N {
            let factor = rows[i][k] * inverse;
            for j in k + 1..N {
                rows[i][j] -= factor * top[j];
            }
            x[i] -= factor * x[k];
        }
    }
    for j in (0..N).rev() {
        x[j] *= rows[j][j];
        for i in 0..j {
            x[i] -= rows[i][j] * x[j];
        }
    }
    Some((x, least / most))
}

/// The reciprocal of a pivot; `None` if the pivot is zero, subnormal or not finite.
fn inverse(pivot: f64) -> Option<f64> {
    pivot.is_normal().then(|| 1.0 / pivot)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numerics::{Draw, Size};

    fn same_bits<const N: usize>(case: u64) {
        let (size, mut draw) = (Size::of(N - 1), Draw::new([case, N as u64, 0]));
        let mut stiffness = Square::zeros(size);
        stiffness.as_mut_slice().iter_mut().for_each(|x| *x = draw.normal());
        let [column, border] = [0, 1].map(|_| Vector::from_fn(size, |_| draw.normal()));
        let [corner, last] = [draw.normal(), draw.normal()];
        let once = solved_once::<N>(stiffness.as_slice(), [&column, &border], [corner, last]);
        let factors = Bordered::new(&stiffness, &column, &border, corner);
        let whole = factors.as_ref().map(|factors| factors.solve(&Vector::zeros(), last));
        let (Some((once, pivots)), Some((x, z))) = (once, whole) else { unreachable!("{case}") };
        assert!(x.as_slice().iter().chain([&z]).eq(&once), "{case}: {x:?} {z} {once:?}");
        let least = factors.map_or(0.0, |factors| factors.least_pivot());
        assert!((pivots / least - 1.0).abs() < 1e-14, "{case}: {pivots} {least}");
    }

    #[test]
    fn solved_once_to_the_bits_of_its_factors() {
        for case in 0..500 {
            same_bits::<4>(case);
            same_bits::<7>(case);
        }
    }
}
