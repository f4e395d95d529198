//! Rank-revealing orthogonal factors of a tall matrix whose rows differ in magnitude by many decades.
//!
//! The matrix is K^{1/2}Gᵀ, with the stiffness K and the grasp map G, or a similar matrix. With stiffness ratios of 1e14 the magnitudes of rows
//! differ by the factor 1e7. If the normal equations with the matrix G K Gᵀ were solved instead, 14 digits would be lost. Gram–Schmidt with column
//! pivoting, each column orthogonalised twice, keeps the columns of Q orthonormal to working precision for any such rows.

use super::coordinates::{Indices, Size, Square, Vector};
use core::ops::Range;

use super::gram_schmidt::factorise;
use super::orthonormal_set::orthonormalise_against;
use super::pairwise::in_halves;
use super::tolerances::FEW_ROUNDINGS;
use crate::numerics::{Reals, summed};
use crate::prelude::*;

/// Factors `A Π = Q [R11 R12; 0 0]` of an `m x D` matrix A of rank r. Q is `m x r` with orthonormal columns, R11 is upper triangular `r x r`,
/// and Π permutes columns.
#[derive(Debug, Clone)]
pub(crate) struct Orthogonal {
    /// The orthonormal factor Q row by row; entries in columns from number `rank` on are zero.
    q: Vec<f64>,
    r: Square,
    /// The reciprocals of the diagonal entries of the triangular factor R11. Multiplying by them is faster than dividing: a division takes three
    /// times as long, and the next one cannot begin before it ends.
    over_diagonal: Vector,
    order: Indices,
    rank: usize,
}

impl Default for Orthogonal {
    /// Factors of a matrix without rows and columns.
    fn default() -> Self {
        Self::of(Size::default())
    }
}

impl Orthogonal {
    pub(crate) fn new(size: Size, rows: &[Vector]) -> Self {
        let mut factor = Self::of(size);
        factor.assign(size, rows);
        factor
    }

    /// Factors of a matrix without rows.
    fn of(size: Size) -> Self {
        let (r, over_diagonal) = (Square::zeros(size), Vector::all_zero(size));
        Self { q: Vec::new(), r, over_diagonal, order: size.in_order(), rank: 0 }
    }

    /// Factorises another matrix, given by its rows. The buffers of the old factors are used again.
    pub(crate) fn assign(&mut self, size: Size, rows: &[Vector]) {
        if self.size() != size {
            *self = Self { q: core::mem::take(&mut self.q), ..Self::of(size) };
        }
        let d = size.count();
        self.q.clear();
        self.q.resize(rows.len() * d, 0.0);
        for (row, to) in rows.iter().zip(self.q.chunks_exact_mut(d.max(1))) {
            let row = row.as_slice();
            to[..row.len()].copy_from_slice(row);
        }
        // With three or six columns the compiler knows the length of the loops.
        self.rank = match d {
            3 => factorise(3, &mut self.q, &mut self.r, &mut self.over_diagonal, self.order.as_mut()),
            6 => factorise(6, &mut self.q, &mut self.r, &mut self.over_diagonal, self.order.as_mut()),
            _ => factorise(d, &mut self.q, &mut self.r, &mut self.over_diagonal, self.order.as_mut()),
        };
    }

    pub(crate) fn size(&self) -> Size {
        self.r.size()
    }

    pub(crate) fn rank(&self) -> usize {
        self.rank
    }

    /// Row i of Q; its entries from number `rank` on are zero.
    pub(crate) fn row(&self, i: usize) -> &[f64] {
        let d = self.size().count();
        &self.q[i * d..(i + 1) * d]
    }

    /// The coordinates Qᵀx of a vector x along the orthonormal columns of Q.
    pub(crate) fn coordinates(&self, x: &[f64]) -> Vector {
        let d = self.size().count();
        let part = |rows: Range<usize>| {
            let mut sum = Vector::all_zero(self.size());
            let (q, sums) = (&self.q[rows.start * d..rows.end * d], sum.as_mut_slice());
            match d {
                3 => add_rows(3, q, &x[rows], sums),
                6 => add_rows(6, q, &x[rows], sums),
                _ => add_rows(d, q, &x[rows], sums),
            }
            sum
        };
        in_halves(0..x.len(), &part, &|a, b| a + b)
    }

    /// Moves x to the closest vector with `Aᵀx = -w`, for the factored matrix A and a w in the range of Aᵀ. The vector becomes `x - Q y` with
    /// the orthonormal factor Q; y is returned.
    pub(crate) fn project(&self, x: &mut [f64], w: &Vector) -> Vector {
        let load = self.load_coordinates(w);
        let mut moved = Vector::zeros();
        // The projection is repeated to remove its own rounding error. Rows whose magnitudes differ by many decades need more than one repetition.
        for _ in 0..4 {
            let step = self.coordinates(x) + &load;
            if step.norm() <= FEW_ROUNDINGS * summed(x, &|x| x * x).sqrt() {
                break;
            }
            self.subtract(x, &step);
            moved += step;
        }
        moved
    }

    /// Subtracts the combination Q y of the columns of the orthonormal factor Q from x.
    pub(crate) fn subtract(&self, x: &mut [f64], y: &Vector) {
        let (d, y) = (self.size().count(), y.as_slice());
        match (d, y.len()) {
            (3, 3) => subtract_rows(3, &self.q, y, x),
            (6, 6) => subtract_rows(6, &self.q, y, x),
            _ => {
                for (row, x) in self.q.chunks_exact(d.max(1)).zip(x) {
                    *x -= product(row, y);
                }
            }
        }
    }

    /// The dot product of row i of Q and a vector y of coordinates.
    pub(crate) fn along_row(&self, i: usize, y: &Vector) -> f64 {
        product(self.row(i), y)
    }

    /// A solution v of `A v = Q c` for the factored matrix A and its orthonormal factor Q. The components of v for columns of A that depend linearly
    /// on the others (columns without a pivot) are zero.
    pub(crate) fn preimage(&self, c: &Vector) -> Vector {
        let (mut y, mut v) = (Vector::all_zero(self.size()), Vector::all_zero(self.size()));
        let (d, r, over) = (self.size().count(), self.r.as_slice(), self.over_diagonal.as_slice());
        let (y, found, order) = (y.as_mut_slice(), v.as_mut_slice(), self.order.as_ref());
        for i in (0..self.rank).rev() {
            let known: f64 = (i + 1..self.rank).map(|j| r[j * d + i] * y[j]).added();
            y[i] = (c[i] - known) * over[i];
            found[order[i]] = y[i];
        }
        v
    }

    /// The coordinates `y = Qᵀx` of the solutions x of `Aᵀx = w`, with the factored matrix A and its orthonormal factor Q. w must be in the range of
    /// Aᵀ. All solutions x have the same y. This y solves the first r rows of `R11ᵀ y = Πᵀw`, with the triangular factor R11 and the column
    /// permutation Π.
    pub(crate) fn load_coordinates(&self, w: &Vector) -> Vector {
        let mut found = Vector::all_zero(self.size());
        let (d, r, over) = (self.size().count(), self.r.as_slice(), self.over_diagonal.as_slice());
        let (y, order) = (found.as_mut_slice(), self.order.as_ref());
        for i in 0..self.rank {
            let known: f64 = (0..i).map(|j| r[i * d + j] * y[j]).added();
            y[i] = (w[order[i]] - known) * over[i];
        }
        found
    }

    /// An orthonormal basis of the null space {v : A v = 0} of the factored matrix A.
    pub(crate) fn null_space(&self) -> Vec<Vector> {
        let mut basis = Vec::new();
        if self.rank < self.size().count() {
            self.null_space_into(&mut basis);
        }
        basis
    }

    /// Writes an orthonormal basis of the null space {v : A v = 0} of the factored matrix A to `basis`, which gets room for the largest possible null
    /// space.
    pub(crate) fn null_space_into(&self, basis: &mut Vec<Vector>) {
        basis.clear();
        basis.reserve(self.size().count());
        for free in self.rank..self.size().count() {
            let mut c = Vector::zeros();
            for i in 0..self.rank {
                c[i] = -self.r[(i, free)];
            }
            let mut v = self.preimage(&c);
            v[self.order.as_ref()[free]] = 1.0;
            orthonormalise_against(&mut v, basis);
            basis.push(v);
        }
    }
}

/// Adds the rows of `q`, each times its factor in `times`, to `sums`; a row has d entries.
#[inline(always)]
fn add_rows(d: usize, q: &[f64], times: &[f64], sums: &mut [f64]) {
    let sums = &mut sums[..d];
    for (row, times) in q.chunks_exact(d.max(1)).zip(times) {
        for k in 0..d {
            sums[k] += row[k] * times;
        }
    }
}

/// Subtracts from each entry of x the dot product of its row of `q` with y.
#[inline(always)]
fn subtract_rows(d: usize, q: &[f64], y: &[f64], x: &mut [f64]) {
    let y = &y[..d];
    for (row, x) in q.chunks_exact(d.max(1)).zip(x) {
        let mut sum = 0.0;
        for k in 0..d {
            sum += row[k] * y[k];
        }
        *x -= sum;
    }
}

/// The dot product of a row and y over their common length.
fn product(row: &[f64], y: &[f64]) -> f64 {
    let mut sum = 0.0;
    for (entry, y) in row.iter().zip(y) {
        sum += entry * y;
    }
    sum
}

#[cfg(test)]
mod tests {
    use nalgebra::SVector;

    use super::*;

    #[test]
    fn a_dependent_column_gives_its_null_vector() {
        // The third column equals the first minus twice the second; the magnitudes of rows differ by 14 decades.
        let rows = [[1e7, 0.0], [1.0, 1.0], [1e-7, 3e-7], [0.5, 1e7]]
            .map(|[a, b]| Vector::from(SVector::from([a, b, a - 2.0 * b])));
        let factor = Orthogonal::new(Size::of(3), &rows);
        assert_eq!(factor.rank(), 2);
        let null = factor.null_space();
        assert_eq!(null.len(), 1);
        let expected = SVector::from([1.0, -2.0, -1.0]).normalize();
        let null = null[0].to_svector::<3>();
        assert!((null - expected * expected.dot(&null).signum()).norm() < 1e-9);
    }

    #[test]
    fn orthonormal_whatever_the_grading() {
        let rows: Vec<_> = (0..9_i32)
            .map(|i| {
                let (a, s) = (f64::from(i), 10f64.powi(3 * (i % 5)));
                Vector::from(SVector::from([s * a.sin(), s * a.cos(), s * (2.0 * a).sin()]))
            })
            .collect();
        let factor = Orthogonal::new(Size::of(3), &rows);
        assert_eq!(factor.rank(), 3);
        for a in 0..3 {
            for b in 0..3 {
                let product: f64 = (0..9).map(|i| factor.row(i)[a] * factor.row(i)[b]).sum();
                assert!((product - f64::from(u8::from(a == b))).abs() < 1e-15);
            }
        }
    }
}
