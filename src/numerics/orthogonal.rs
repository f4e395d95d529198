//! Rank-revealing orthogonal factors of a tall matrix with graded rows.
//!
//! The rows are those of K^{1/2}Gᵀ and its kin: with stiffness ratios of 1e14 they differ by 1e7 in size. Normal
//! equations (G K Gᵀ)⁻¹ would lose the square of that; Gram–Schmidt with column pivoting, every column
//! orthogonalised twice, keeps the columns of Q orthonormal to working precision whatever the grading.

use std::ops::Range;

use nalgebra::{SMatrix, SVector};

use super::pairwise::in_halves;

/// A column counts as dependent on those before it when less than this part of it is left after orthogonalisation.
/// It guards against rounding noise (about 1e-16 times a few operations) being taken for a resisted direction; real
/// geometry comes as close as contacts that are parallel to 1e-12.
const DEPENDENT: f64 = 1e-13;

/// Entries of a row are known to this part of the row's size: a normal computed as (cos π/2, sin π/2) has a first
/// component of 6e-17 that resists nothing. Entries that are exactly zero carry no such noise, so that a soft spring is
/// still seen across a direction in which stiff ones have none.
const ENTRY_NOISE: f64 = 4.0 * f64::EPSILON;

/// A projection is repeated at most so often: to solve, and again for what rounding left, more than
/// once where the rows are graded over many decades.
const PASSES: usize = 4;

/// A projection that moves x by less than this part of it is not made: it would only stir the rounding.
const PROJECTED: f64 = 1e-15;

/// `A Π = Q [R11 R12; 0 0]` for an `m x D` matrix A of rank r: Q is `m x r` with orthonormal columns, R11 is upper
/// triangular `r x r`, Π permutes columns.
#[derive(Debug, Clone)]
pub(crate) struct Orthogonal<const D: usize> {
    /// Rows of Q; entries from `rank` on are zero.
    q: Vec<SVector<f64, D>>,
    r: SMatrix<f64, D, D>,
    /// One over the diagonal of R11: a product takes a third of the time of a quotient, and each waits for the one before.
    over_diagonal: [f64; D],
    order: [usize; D],
    rank: usize,
}

impl<const D: usize> Default for Orthogonal<D> {
    fn default() -> Self {
        Self {
            q: Vec::new(),
            r: SMatrix::zeros(),
            over_diagonal: [0.0; D],
            order: std::array::from_fn(|j| j),
            rank: 0,
        }
    }
}

impl<const D: usize> Orthogonal<D> {
    pub(crate) fn new(rows: Vec<SVector<f64, D>>) -> Self {
        let mut factor = Self { q: rows, ..Self::default() };
        factor.factorise();
        factor
    }

    /// The factors of other rows, in the same memory.
    pub(crate) fn assign(&mut self, rows: &[SVector<f64, D>]) {
        self.q.clear();
        self.q.extend_from_slice(rows);
        self.factorise();
    }

    /// The rows in `q` become those of Q.
    fn factorise(&mut self) {
        let rows = &mut self.q;
        let mut r = SMatrix::<f64, D, D>::zeros();
        let mut order: [usize; D] = std::array::from_fn(|j| j);
        let (mut full, mut noise) = lengths_and_noise(rows);
        // Norms of what is left of the columns.
        let mut left = full;
        let mut rank = 0;
        while rank < D {
            let k = rank;
            // The largest remaining column, among those that are more than rounding noise of what they were.
            let mut best = None;
            for j in k..D {
                if left[j] > (DEPENDENT * full[j]).max(noise[j])
                    && best.is_none_or(|(_, most)| left[j] > most)
                {
                    best = Some((j, left[j]));
                }
            }
            let Some((pivot, _)) = best else { break };
            if pivot != k {
                for row in rows.iter_mut() {
                    row.swap_rows(k, pivot);
                }
                r.swap_columns(k, pivot);
                order.swap(k, pivot);
                for list in [&mut full, &mut noise, &mut left] {
                    list.swap_rows(k, pivot);
                }
            }
            let square = again_from_those_before(rows, &mut r, k);
            let norm = square.sqrt();
            if norm <= (DEPENDENT * full[k]).max(noise[k]) {
                // What seemed to be left was noise after all: never a pivot again.
                full[k] = f64::INFINITY;
                continue;
            }
            r[(k, k)] = norm;
            for row in rows.iter_mut() {
                row[k] /= norm;
            }
            rank += 1;
            if rank == D {
                break;
            }
            let along = take_from_the_others(rows, k, &mut left);
            left.apply(|square| *square = square.sqrt());
            for j in rank..D {
                r[(k, j)] = along[j];
            }
        }
        if rank < D {
            for row in rows.iter_mut() {
                *row = masked(row, 0..rank);
            }
        }
        self.over_diagonal = std::array::from_fn(|i| 1.0 / r[(i, i)]);
        (self.r, self.order, self.rank) = (r, order, rank);
    }

    pub(crate) fn rank(&self) -> usize {
        self.rank
    }

    /// Row i of Q, entries from the rank on zero.
    pub(crate) fn row(&self, i: usize) -> &SVector<f64, D> {
        &self.q[i]
    }

    /// Qᵀx.
    pub(crate) fn coordinates(&self, x: &[f64]) -> SVector<f64, D> {
        let part = |rows: std::ops::Range<usize>| {
            let terms = self.q[rows.clone()].iter().zip(&x[rows]);
            terms.fold(SVector::zeros(), |sum, (row, &x)| sum + row * x)
        };
        in_halves(0..x.len(), &part, &|a, b| a + b)
    }

    /// Moves x to the nearest one with `Aᵀx = -w`, for a w that some x reaches. Returns the y of the move
    /// `x - Q y`.
    pub(crate) fn project(&self, x: &mut [f64], w: &SVector<f64, D>) -> SVector<f64, D> {
        let load = self.load_coordinates(w);
        let mut moved = SVector::zeros();
        for _ in 0..PASSES {
            let step = self.coordinates(x) + load;
            if step.norm() <= PROJECTED * x.iter().map(|x| x * x).sum::<f64>().sqrt() {
                break;
            }
            self.subtract(x, &step);
            moved += step;
        }
        moved
    }

    /// x - Q y.
    pub(crate) fn subtract(&self, x: &mut [f64], y: &SVector<f64, D>) {
        for (x, row) in x.iter_mut().zip(&self.q) {
            *x -= row.dot(y);
        }
    }

    /// A solution v of `A v = Q c` with zeros in the dependent columns.
    pub(crate) fn preimage(&self, c: &SVector<f64, D>) -> SVector<f64, D> {
        let mut y = [0.0; D];
        for i in (0..self.rank).rev() {
            let known: f64 = (i + 1..self.rank).map(|j| self.r[(i, j)] * y[j]).sum();
            y[i] = (c[i] - known) * self.over_diagonal[i];
        }
        let mut v = SVector::zeros();
        for i in 0..self.rank {
            v[self.order[i]] = y[i];
        }
        v
    }

    /// The coordinates `y = Qᵀx` of every x with `Aᵀx = w`, for a w that some x reaches: `R11ᵀ y = Πᵀw`, first r rows.
    pub(crate) fn load_coordinates(&self, w: &SVector<f64, D>) -> SVector<f64, D> {
        let mut y = SVector::zeros();
        for i in 0..self.rank {
            let known: f64 = (0..i).map(|j| self.r[(j, i)] * y[j]).sum();
            y[i] = (w[self.order[i]] - known) * self.over_diagonal[i];
        }
        y
    }

    /// An orthonormal basis of the null space {v : A v = 0}.
    pub(crate) fn null_space(&self) -> Vec<SVector<f64, D>> {
        self.null_vectors()[..D - self.rank].to_vec()
    }

    /// The same in the first D - rank places.
    pub(crate) fn null_vectors(&self) -> [SVector<f64, D>; D] {
        let mut basis = [SVector::zeros(); D];
        for free in self.rank..D {
            let mut c = SVector::zeros();
            for i in 0..self.rank {
                c[i] = -self.r[(i, free)];
            }
            let mut v = self.preimage(&c);
            v[self.order[free]] = 1.0;
            let known = free - self.rank;
            orthonormalise_against(&mut v, &basis[..known]);
            basis[known] = v;
        }
        basis
    }
}

/// Lengths of the columns, and of the rounding in them.
fn lengths_and_noise<const D: usize>(rows: &[SVector<f64, D>]) -> (SVector<f64, D>, SVector<f64, D>) {
    let (mut full, mut noise) = (SVector::<f64, D>::zeros(), SVector::<f64, D>::zeros());
    for row in rows {
        let squares = row.component_mul(row);
        full += squares;
        let size = squares.sum();
        noise += row.map(|entry| if entry == 0.0 { 0.0 } else { size });
    }
    (full.map(f64::sqrt), noise.map(|square| square.sqrt() * ENTRY_NOISE))
}

/// The columns that a loop goes over which needs some of them. Of as few as an object has, all: one loop of fixed length is faster, and zeros
/// stand where there is nothing to do.
fn looped<const D: usize>(needed: Range<usize>) -> Range<usize> {
    if D <= 6 { 0..D } else { needed }
}

/// Second pass of column k against the finished columns: the first was their own step of elimination. Returns the square of its length.
fn again_from_those_before<const D: usize>(
    rows: &mut [SVector<f64, D>],
    r: &mut SMatrix<f64, D, D>,
    k: usize,
) -> f64 {
    let again = products(rows, k, 0..k);
    r.set_column(k, &(r.column(k) + again));
    let finished = looped::<D>(0..k);
    let mut square = 0.0;
    for row in rows.iter_mut() {
        let against = again.rows_range(finished.clone()).dot(&row.rows_range(finished.clone()));
        row[k] -= against;
        square += row[k] * row[k];
    }
    square
}

/// Takes the part along column k, a unit vector, from the columns behind it. Returns these parts, and leaves the squares of what remains in `left`.
fn take_from_the_others<const D: usize>(
    rows: &mut [SVector<f64, D>],
    k: usize,
    left: &mut SVector<f64, D>,
) -> SVector<f64, D> {
    let along = products(rows, k, k + 1..D);
    left.fill(0.0);
    let open = looped::<D>(k + 1..D);
    for row in rows.iter_mut() {
        let part = row[k];
        let columns = row.as_mut_slice()[open.clone()].iter_mut();
        for ((x, left), along) in
            columns.zip(&mut left.as_mut_slice()[open.clone()]).zip(&along.as_slice()[open.clone()])
        {
            *x -= along * part;
            *left += *x * *x;
        }
    }
    along
}

/// Products of column k with some columns, zero beside them.
fn products<const D: usize>(rows: &[SVector<f64, D>], k: usize, with: Range<usize>) -> SVector<f64, D> {
    let mut sum = SVector::zeros();
    let over = looped::<D>(with.clone());
    for row in rows {
        let part = row[k];
        let sum = &mut SVector::<f64, D>::as_mut_slice(&mut sum)[over.clone()];
        for (sum, x) in sum.iter_mut().zip(&row.as_slice()[over.clone()]) {
            *sum += x * part;
        }
    }
    masked(&sum, with)
}

/// Zeros beside these components: with all of them at once there is one loop over the rows.
fn masked<const D: usize>(v: &SVector<f64, D>, keep: Range<usize>) -> SVector<f64, D> {
    SVector::from_fn(|j, _| if keep.contains(&j) { v[j] } else { 0.0 })
}

/// v less its part along the vectors of an orthonormal set.
pub(crate) fn without<const D: usize>(v: SVector<f64, D>, basis: &[SVector<f64, D>]) -> SVector<f64, D> {
    basis.iter().fold(v, |v, b| v - b * b.dot(&v))
}

/// v becomes a unit vector orthogonal to an orthonormal set (two passes).
pub(crate) fn orthonormalise_against<const D: usize>(v: &mut SVector<f64, D>, basis: &[SVector<f64, D>]) {
    for _ in 0..2 {
        *v = without(*v, basis);
    }
    let norm = v.norm();
    if norm > 0.0 {
        *v /= norm;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_dependent_column_gives_its_null_vector() {
        // Third column = first - 2 second, rows graded over 14 decades.
        let rows = [[1e7, 0.0], [1.0, 1.0], [1e-7, 3e-7], [0.5, 1e7]]
            .map(|[a, b]| SVector::from([a, b, a - 2.0 * b]));
        let factor = Orthogonal::new(rows.to_vec());
        assert_eq!(factor.rank(), 2);
        let null = factor.null_space();
        assert_eq!(null.len(), 1);
        let expected = SVector::from([1.0, -2.0, -1.0]).normalize();
        assert!((null[0] - expected * expected.dot(&null[0]).signum()).norm() < 1e-9);
    }

    #[test]
    fn orthonormal_whatever_the_grading() {
        let rows: Vec<_> = (0..9_i32)
            .map(|i| {
                let (a, s) = (f64::from(i), 10f64.powi(3 * (i % 5)));
                SVector::from([s * a.sin(), s * a.cos(), s * (2.0 * a).sin()])
            })
            .collect();
        let factor = Orthogonal::new(rows);
        assert_eq!(factor.rank(), 3);
        for a in 0..3 {
            for b in 0..3 {
                let product: f64 = (0..9).map(|i| factor.row(i)[a] * factor.row(i)[b]).sum();
                assert!((product - f64::from(u8::from(a == b))).abs() < 1e-15);
            }
        }
    }
}
