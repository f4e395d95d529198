//! Rank-revealing orthogonal factors of a tall matrix with graded rows.
//!
//! The rows are those of K^{1/2}Gᵀ and similar matrices: with stiffness ratios of 1e14 they differ by 1e7 in size. Normal
//! equations (G K Gᵀ)⁻¹ would lose the square of that. Gram–Schmidt with column pivoting, every column
//! orthogonalised twice, keeps the columns of Q orthonormal to working precision for any grading.

use crate::numerics::Indices;
use crate::numerics::{Size, Square, Vector};
use core::ops::Range;

use super::pairwise::in_halves;
use crate::prelude::*;

/// A column counts as dependent on those before it when less than this part of it is left after orthogonalisation.
/// It keeps rounding noise (about 1e-16 times a few operations) from being taken for a resisted direction. Contacts
/// in real geometry are parallel up to 1e-12.
const DEPENDENT: f64 = 1e-13;

/// Relative rounding of an entry, as a part of the row's size: a normal computed as (cos π/2, sin π/2) has a first
/// component of 6e-17 that resists nothing. Entries that are exactly zero carry no such noise, so a soft spring
/// still counts across a direction in which stiff springs have no entry.
const ENTRY_NOISE: f64 = 4.0 * f64::EPSILON;

/// Largest number of times that a projection is repeated: once to solve, and again for its own rounding. Rows graded
/// over many decades need more than one repetition.
const PASSES: usize = 4;

/// A projection that moves x by less than this part of itself is skipped: it would change rounding only.
const PROJECTED: f64 = 1e-15;

/// `A Π = Q [R11 R12; 0 0]` for an `m x D` matrix A of rank r: Q is `m x r` with orthonormal columns, R11 is upper
/// triangular `r x r`, Π permutes columns.
#[derive(Debug, Clone)]
pub(crate) struct Orthogonal {
    /// Rows of Q; entries at `rank` and above are zero.
    q: Vec<Vector>,
    r: Square,
    /// The inverse diagonal of R11: a product takes a third of the time of a quotient, and each waits for the one before.
    over_diagonal: Vector,
    order: Indices,
    rank: usize,
}

impl Default for Orthogonal {
    /// Factors of no rows and, if the number of columns is known at run time only, of no columns.
    fn default() -> Self {
        Self::of(Size::default(), Vec::new())
    }
}

impl Orthogonal {
    pub(crate) fn new(size: Size, rows: Vec<Vector>) -> Self {
        let mut factor = Self::of(size, rows);
        factor.factorise();
        factor
    }

    /// Rows that are not factorised yet.
    fn of(size: Size, rows: Vec<Vector>) -> Self {
        let (r, over_diagonal) = (Square::zeros(size), Vector::all_zero(size));
        Self { q: rows, r, over_diagonal, order: size.in_order(), rank: 0 }
    }

    /// The factors of other rows, in the same memory.
    pub(crate) fn assign(&mut self, size: Size, rows: &[Vector]) {
        if self.size() != size {
            *self = Self::of(size, core::mem::take(&mut self.q));
        }
        self.q.clear();
        self.q.extend_from_slice(rows);
        self.factorise();
    }

    pub(crate) fn size(&self) -> Size {
        self.r.size()
    }

    /// Factorises the rows in `q`, which become those of Q.
    fn factorise(&mut self) {
        let size = self.size();
        let d = size.count();
        let Self { q: rows, r, over_diagonal, order, rank: found } = self;
        let order = order.as_mut();
        r.fill(0.0);
        order.iter_mut().enumerate().for_each(|(j, order)| *order = j);
        for row in rows.iter_mut() {
            row.reach(size);
        }
        let (mut full, mut noise) = lengths_and_noise(size, rows);
        // Norms of the remaining parts of the columns.
        let mut left = full.clone();
        let [full, noise, left] = [&mut full, &mut noise, &mut left].map(Vector::as_mut_slice);
        let mut rank = 0;
        while rank < d {
            let k = rank;
            // The largest remaining column, among those that exceed the rounding noise of their original size.
            let mut best = None;
            for j in k..d {
                if left[j] > (DEPENDENT * full[j]).max(noise[j])
                    && best.is_none_or(|(_, most)| left[j] > most)
                {
                    best = Some((j, left[j]));
                }
            }
            let Some((pivot, _)) = best else { break };
            if pivot != k {
                for row in rows.iter_mut() {
                    row.as_mut_slice().swap(k, pivot);
                }
                r.swap_columns(k, pivot);
                order.swap(k, pivot);
                for list in [&mut *full, &mut *noise, &mut *left] {
                    list.swap(k, pivot);
                }
            }
            let square = again_from_those_before(rows, r, k);
            let norm = square.sqrt();
            if norm <= (DEPENDENT * full[k]).max(noise[k]) {
                // The remainder was noise: the column is never a pivot again.
                full[k] = f64::INFINITY;
                continue;
            }
            r[(k, k)] = norm;
            for row in rows.iter_mut() {
                row.as_mut_slice()[k] /= norm;
            }
            rank += 1;
            if rank == d {
                break;
            }
            let along = take_from_the_others(size, rows, k, left);
            for square in &mut *left {
                *square = square.sqrt();
            }
            for (j, along) in along.iter().enumerate().skip(rank) {
                r[(k, j)] = *along;
            }
        }
        if rank < d {
            for row in rows.iter_mut() {
                keep(row, 0..rank);
            }
        }
        for i in 0..d {
            over_diagonal[i] = 1.0 / r[(i, i)];
        }
        *found = rank;
    }

    pub(crate) fn rank(&self) -> usize {
        self.rank
    }

    /// Row i of Q; its entries at the rank and above are zero.
    pub(crate) fn row(&self, i: usize) -> &Vector {
        &self.q[i]
    }

    /// Qᵀx.
    pub(crate) fn coordinates(&self, x: &[f64]) -> Vector {
        let part = |rows: Range<usize>| {
            let mut sum = Vector::all_zero(self.size());
            let sums = sum.as_mut_slice();
            for (row, &x) in self.q[rows.clone()].iter().zip(&x[rows]) {
                sums.iter_mut().zip(row.iter()).for_each(|(sum, y)| *sum += y * x);
            }
            sum
        };
        in_halves(0..x.len(), &part, &|a, b| a + b)
    }

    /// Moves x to the nearest vector with `Aᵀx = -w`, for a w in the range of Aᵀ. Returns the y of the move
    /// `x - Q y`.
    pub(crate) fn project(&self, x: &mut [f64], w: &Vector) -> Vector {
        let load = self.load_coordinates(w);
        let mut moved = Vector::zeros();
        for _ in 0..PASSES {
            let step = self.coordinates(x) + &load;
            if step.norm() <= PROJECTED * x.iter().map(|x| x * x).sum::<f64>().sqrt() {
                break;
            }
            self.subtract(x, &step);
            moved += step;
        }
        moved
    }

    /// x - Q y.
    pub(crate) fn subtract(&self, x: &mut [f64], y: &Vector) {
        for (x, row) in x.iter_mut().zip(&self.q) {
            *x -= row.dot(y);
        }
    }

    /// A solution v of `A v = Q c` with zeros in the dependent columns.
    pub(crate) fn preimage(&self, c: &Vector) -> Vector {
        let (mut y, mut v) = (Vector::all_zero(self.size()), Vector::all_zero(self.size()));
        let (d, r, over) = (self.size().count(), self.r.as_slice(), self.over_diagonal.as_slice());
        let (y, found, order) = (y.as_mut_slice(), v.as_mut_slice(), self.order.as_ref());
        for i in (0..self.rank).rev() {
            let known: f64 = (i + 1..self.rank).map(|j| r[j * d + i] * y[j]).sum();
            y[i] = (c[i] - known) * over[i];
            found[order[i]] = y[i];
        }
        v
    }

    /// The coordinates `y = Qᵀx` of every x with `Aᵀx = w`, for a w in the range of Aᵀ: `R11ᵀ y = Πᵀw`, first r rows.
    pub(crate) fn load_coordinates(&self, w: &Vector) -> Vector {
        let mut found = Vector::all_zero(self.size());
        let (d, r, over) = (self.size().count(), self.r.as_slice(), self.over_diagonal.as_slice());
        let (y, order) = (found.as_mut_slice(), self.order.as_ref());
        for i in 0..self.rank {
            let known: f64 = (0..i).map(|j| r[i * d + j] * y[j]).sum();
            y[i] = (w[order[i]] - known) * over[i];
        }
        found
    }

    /// An orthonormal basis of the null space {v : A v = 0}.
    pub(crate) fn null_space(&self) -> Vec<Vector> {
        let mut basis = Vec::new();
        if self.rank < self.size().count() {
            self.null_space_into(&mut basis);
        }
        basis
    }

    /// [`Self::null_space`] in the memory of `basis`, which gets room for the null space of any rows.
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

/// Lengths of the columns, and of the rounding in them.
fn lengths_and_noise(size: Size, rows: &[Vector]) -> (Vector, Vector) {
    let (mut full, mut noise) = (Vector::all_zero(size), Vector::all_zero(size));
    for row in rows {
        let mut sum = 0.0;
        for (full, x) in full.iter_mut().zip(row.iter()) {
            let square = x * x;
            *full += square;
            sum += square;
        }
        noise.iter_mut().zip(row.iter()).for_each(|(noise, &x)| *noise += if x == 0.0 { 0.0 } else { sum });
    }
    (full.map(f64::sqrt), noise.map(|square| square.sqrt() * ENTRY_NOISE))
}

/// Orthogonalises column k a second time against the finished columns: the first time was their own elimination step. Returns its squared length.
fn again_from_those_before(rows: &mut [Vector], r: &mut Square, k: usize) -> f64 {
    let size = r.size();
    let again = products(size, rows, k, 0..k);
    r.column_slice_mut(k).iter_mut().zip(again.iter()).for_each(|(r, again)| *r += again);
    let finished = 0..k;
    let again = &again.as_slice()[finished.clone()];
    let mut square = 0.0;
    for row in rows.iter_mut() {
        let row = row.as_mut_slice();
        let terms = again.iter().zip(&row[finished.clone()]);
        let against = terms.fold(0.0, |sum, (again, x)| sum + again * x);
        row[k] -= against;
        square += row[k] * row[k];
    }
    square
}

/// Subtracts the projection on column k, a unit vector, from the columns behind it. Returns the coefficients, and leaves the squared lengths of the
/// remaining columns in `left`.
fn take_from_the_others(size: Size, rows: &mut [Vector], k: usize, left: &mut [f64]) -> Vector {
    let along = products(size, rows, k, k + 1..size.count());
    left.fill(0.0);
    let open = k + 1..size.count();
    let (left, parts) = (&mut left[open.clone()], &along.as_slice()[open.clone()]);
    for row in rows.iter_mut() {
        let row = row.as_mut_slice();
        let part = row[k];
        for ((x, left), along) in row[open.clone()].iter_mut().zip(left.iter_mut()).zip(parts) {
            *x -= along * part;
            *left += *x * *x;
        }
    }
    along
}

/// Products of column k with the columns `with`; the other entries are zero.
fn products(size: Size, rows: &[Vector], k: usize, with: Range<usize>) -> Vector {
    let mut sum = Vector::all_zero(size);
    let over = with.clone();
    let sums = &mut sum.as_mut_slice()[over.clone()];
    for row in rows {
        let row = row.as_slice();
        let part = row[k];
        sums.iter_mut().zip(&row[over.clone()]).for_each(|(sum, x)| *sum += x * part);
    }
    if over != with {
        keep(&mut sum, with);
    }
    sum
}

/// Sets all other components to zero, after one loop over the rows that computed all of them.
fn keep(v: &mut Vector, kept: Range<usize>) {
    for (j, x) in v.iter_mut().enumerate() {
        *x = if kept.contains(&j) { *x } else { 0.0 };
    }
}

/// v minus its projection on an orthonormal set.
pub(crate) fn without(mut v: Vector, basis: &[Vector]) -> Vector {
    for b in basis {
        let along = b.dot(&v);
        v -= b * along;
    }
    v
}

/// Makes v a unit vector orthogonal to an orthonormal set, in two passes.
pub(crate) fn orthonormalise_against(v: &mut Vector, basis: &[Vector]) {
    for _ in 0..2 {
        *v = without(core::mem::take(v), basis);
    }
    let norm = v.norm();
    if norm > 0.0 {
        *v /= norm;
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::SVector;

    use super::*;

    #[test]
    fn a_dependent_column_gives_its_null_vector() {
        // Third column = first - 2 second, rows graded over 14 decades.
        let rows = [[1e7, 0.0], [1.0, 1.0], [1e-7, 3e-7], [0.5, 1e7]]
            .map(|[a, b]| Vector::from(SVector::from([a, b, a - 2.0 * b])));
        let factor = Orthogonal::new(Size::of(3), rows.to_vec());
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
        let factor = Orthogonal::new(Size::of(3), rows);
        assert_eq!(factor.rank(), 3);
        for a in 0..3 {
            for b in 0..3 {
                let product: f64 = (0..9).map(|i| factor.row(i)[a] * factor.row(i)[b]).sum();
                assert!((product - f64::from(u8::from(a == b))).abs() < 1e-15);
            }
        }
    }
}
