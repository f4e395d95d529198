//! A small linear system that is far from singular: partial pivoting, nothing to reveal.

use nalgebra::{SMatrix, SVector};

/// A pivot below this part of the largest entry is left to those who can tell a singular state from a soft one
/// ([`super::CompletePivoting`], [`super::Orthogonal`]). Above it a solution has some six digits, and steps of refinement the rest.
const REGULAR: f64 = 1e-10;

/// Partial-pivoting LU of a regular `D x D` matrix.
#[derive(Debug, Clone)]
pub(crate) struct PartialPivoting<const D: usize> {
    /// Column by column: U above the diagonal, L below it.
    lu: [[f64; D]; D],
    reciprocal_pivots: [f64; D],
    row_order: [usize; D],
}

impl<const D: usize> PartialPivoting<D> {
    /// The factors, unless the matrix is nearly singular or not finite.
    pub(crate) fn new(matrix: &SMatrix<f64, D, D>) -> Option<Self> {
        let mut lu = matrix.data.0;
        let least = REGULAR * matrix.amax();
        let mut reciprocal_pivots = [0.0; D];
        let mut row_order: [usize; D] = std::array::from_fn(|i| i);
        for k in 0..D {
            let mut pivot = k;
            for i in k + 1..D {
                if lu[k][i].abs() > lu[k][pivot].abs() {
                    pivot = i;
                }
            }
            // Written so that it also turns away what is not a number.
            let large_enough = lu[k][pivot].abs() > least && lu[k][pivot].is_finite();
            if !large_enough {
                return None;
            }
            if pivot != k {
                row_order.swap(k, pivot);
                for column in &mut lu {
                    column.swap(k, pivot);
                }
            }
            reciprocal_pivots[k] = 1.0 / lu[k][k];
            for i in k + 1..D {
                lu[k][i] *= reciprocal_pivots[k];
            }
            let factors = lu[k];
            for column in &mut lu[k + 1..] {
                let top = column[k];
                for i in k + 1..D {
                    column[i] -= factors[i] * top;
                }
            }
        }
        Some(Self { lu, reciprocal_pivots, row_order })
    }

    pub(crate) fn solve(&self, b: &SVector<f64, D>) -> SVector<f64, D> {
        let mut x: [f64; D] = std::array::from_fn(|i| b[self.row_order[i]]);
        for k in 0..D {
            for i in k + 1..D {
                x[i] -= self.lu[k][i] * x[k];
            }
        }
        for k in (0..D).rev() {
            x[k] *= self.reciprocal_pivots[k];
            for i in 0..k {
                x[i] -= self.lu[k][i] * x[k];
            }
        }
        SVector::from(x)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn solves_what_needs_its_rows_exchanged() {
        let a = SMatrix::<f64, 3, 3>::new(0.0, 2.0, 1.0, 1.0, 0.0, -3.0, 4.0, 1.0, 0.0);
        let x = SVector::from([1.0, -2.0, 0.5]);
        let found = PartialPivoting::new(&a).map(|lu| lu.solve(&(a * x)));
        assert!(found.is_some_and(|found| (found - x).norm() < 1e-15));
    }

    #[test]
    fn leaves_the_nearly_singular_to_others() {
        let nearly = SMatrix::<f64, 3, 3>::new(1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0 + 1e-11);
        assert!(PartialPivoting::new(&nearly).is_none());
        assert!(PartialPivoting::new(&SMatrix::<f64, 3, 3>::repeat(f64::NAN)).is_none());
        assert!(PartialPivoting::new(&SMatrix::<f64, 3, 3>::zeros()).is_none());
    }
}
