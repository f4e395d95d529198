//! Small linear systems far from singular, by LU with partial pivoting.

use super::tolerances::PARTIAL_PIVOT;
use crate::numerics::{Indices, Size, Square, Vector};

/// LU factors, by partial pivoting, of a square matrix that is far from singular.
#[derive(Debug, Clone)]
pub(crate) struct PartialPivoting {
    /// U on and above the diagonal, L below it.
    lu: Square,
    reciprocal_pivots: Vector,
    row_order: Indices,
}

impl PartialPivoting {
    pub(crate) fn new(matrix: &Square) -> Option<Self> {
        let size = matrix.size();
        let d = size.count();
        let mut lu = matrix.clone();
        let least = PARTIAL_PIVOT * matrix.amax();
        let mut reciprocal_pivots = Vector::all_zero(size);
        let mut row_order = size.in_order();
        let (entries, reciprocal, order) =
            (lu.as_mut_slice(), reciprocal_pivots.as_mut_slice(), row_order.as_mut());
        // With three or six rows the compiler knows the length of the loops.
        match d {
            3 => eliminate(3, entries, reciprocal, order, least)?,
            6 => eliminate(6, entries, reciprocal, order, least)?,
            _ => eliminate(d, entries, reciprocal, order, least)?,
        }
        Some(Self { lu, reciprocal_pivots, row_order })
    }

    pub(crate) fn size(&self) -> Size {
        self.lu.size()
    }

    /// Whether the determinant is positive.
    pub(crate) fn is_positive(&self) -> bool {
        let order = self.row_order.as_ref();
        let mut is_odd = false;
        for i in 0..order.len() {
            is_odd ^= self.reciprocal_pivots[i] < 0.0;
            for j in 0..i {
                is_odd ^= order[j] > order[i];
            }
        }
        !is_odd
    }

    pub(crate) fn solve(&self, b: &Vector) -> Vector {
        let size = self.size();
        let order = self.row_order.as_ref();
        let mut solution = Vector::from_fn(size, |i| b[order[i]]);
        let (lu, reciprocal, x) =
            (self.lu.as_slice(), self.reciprocal_pivots.as_slice(), solution.as_mut_slice());
        match size.count() {
            3 => substitute(3, lu, reciprocal, x),
            6 => substitute(6, lu, reciprocal, x),
            d => substitute(d, lu, reciprocal, x),
        }
        solution
    }
}

/// Gaussian elimination in place: U on and above the diagonal, L below it. `None` if a pivot is at most `least`, or not finite.
#[inline(always)]
fn eliminate(
    d: usize,
    lu: &mut [f64],
    reciprocal_pivots: &mut [f64],
    row_order: &mut [usize],
    least: f64,
) -> Option<()> {
    let (lu, reciprocal_pivots) = (&mut lu[..d * d], &mut reciprocal_pivots[..d]);
    for k in 0..d {
        let (before, behind) = lu.split_at_mut((k + 1) * d);
        let column = &mut before[k * d..];
        let mut pivot = k;
        for i in k + 1..d {
            if column[i].abs() > column[pivot].abs() {
                pivot = i;
            }
        }
        // `large_enough` is false for NaN, too, so that a matrix with NaN has no factors.
        let large_enough = column[pivot].abs() > least && column[pivot].is_finite();
        if !large_enough {
            return None;
        }
        column.swap(k, pivot);
        let reciprocal = 1.0 / column[k];
        for i in k + 1..d {
            column[i] *= reciprocal;
        }
        for other in behind.chunks_exact_mut(d) {
            other.swap(k, pivot);
            let top = other[k];
            for i in k + 1..d {
                other[i] -= column[i] * top;
            }
        }
        if pivot != k {
            row_order.swap(k, pivot);
            before[..k * d].chunks_exact_mut(d).for_each(|column| column.swap(k, pivot));
        }
        reciprocal_pivots[k] = reciprocal;
    }
    Some(())
}

/// Replaces the right-hand side in `x`, whose entries are in the order of the pivot rows, by the solution.
#[inline(always)]
fn substitute(d: usize, lu: &[f64], reciprocal_pivots: &[f64], x: &mut [f64]) {
    let (lu, reciprocal_pivots, x) = (&lu[..d * d], &reciprocal_pivots[..d], &mut x[..d]);
    for k in 0..d {
        let column = &lu[k * d..(k + 1) * d];
        for i in k + 1..d {
            x[i] -= column[i] * x[k];
        }
    }
    for k in (0..d).rev() {
        let column = &lu[k * d..(k + 1) * d];
        x[k] *= reciprocal_pivots[k];
        for i in 0..k {
            x[i] -= column[i] * x[k];
        }
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::{SMatrix, SVector};

    use super::*;

    #[test]
    fn solves_what_needs_its_rows_exchanged() {
        let a = SMatrix::<f64, 3, 3>::new(0.0, 2.0, 1.0, 1.0, 0.0, -3.0, 4.0, 1.0, 0.0);
        let x = SVector::from([1.0, -2.0, 0.5]);
        let found = PartialPivoting::new(&a.into()).map(|lu| lu.solve(&(a * x).into()).to_svector::<3>());
        assert!(found.is_some_and(|found| (found - x).norm() < 1e-15));
    }

    #[test]
    fn leaves_the_nearly_singular_to_others() {
        let nearly = SMatrix::<f64, 3, 3>::new(1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0 + 1e-11);
        assert!(PartialPivoting::new(&nearly.into()).is_none());
        assert!(PartialPivoting::new(&SMatrix::<f64, 3, 3>::repeat(f64::NAN).into()).is_none());
        assert!(PartialPivoting::new(&SMatrix::<f64, 3, 3>::zeros().into()).is_none());
    }
}
