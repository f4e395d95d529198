//! The number of coordinates, and the arithmetic that depends on it.

use core::fmt::Debug;
use core::ops::Range;

use nalgebra::{SMatrix, SVector};

use super::list::{List, Short};
use super::map_entries::{FewRows, MapEntries};
use crate::prelude::*;

/// The number of coordinates, fixed by the type or known at run time.
pub(crate) trait Size: Copy + PartialEq + Debug + Default + Send + Sync + 'static {
    /// Components of a vector.
    type List: List;
    /// Entries of a square matrix, column by column.
    type Square: List;
    /// Entries of a matrix with a row for each coordinate and C columns, column by column.
    type Map<const C: usize>: MapEntries<C>;
    /// Entries of a matrix with C rows and a column for each coordinate, column by column.
    type Seen<const C: usize>: List;
    /// A number for each coordinate, for example a permutation.
    type Indices: AsRef<[usize]> + AsMut<[usize]> + Clone + Debug + Send + Sync;

    /// The identity permutation.
    fn in_order(self) -> Self::Indices;
    /// The size with this number of coordinates; a fixed size ignores it.
    fn of(count: usize) -> Self;
    fn count(self) -> usize;
    /// The coordinates of a loop that needs `needed`. A fixed size returns all of them: a loop whose length the compiler knows is
    /// faster, with zeros where there is nothing to do.
    fn looped(self, needed: Range<usize>) -> Range<usize>;
    fn dot(a: &Self::List, b: &Self::List) -> f64;
    /// `A v`.
    fn times(self, a: &Self::Square, v: &Self::List) -> Self::List;
    /// `A B`.
    fn product(self, a: &Self::Square, b: &Self::Square) -> Self::Square;
    /// `G f`.
    fn mapped<const C: usize>(self, map: &Self::Map<C>, f: &SVector<f64, C>) -> Self::List;
    /// Adds `G f`.
    fn add_mapped<const C: usize>(self, map: &Self::Map<C>, f: &SVector<f64, C>, to: &mut Self::List);
    /// `|G f|²`.
    fn mapped_square<const C: usize>(self, map: &Self::Map<C>, f: &SVector<f64, C>) -> f64;
    /// The square of the length of a column of G.
    fn column_square<const C: usize>(self, map: &Self::Map<C>, a: usize) -> f64;
    /// `Gᵀv`.
    fn felt<const C: usize>(self, map: &Self::Map<C>, v: &Self::List) -> SVector<f64, C>;
    /// `S v`.
    fn seen<const C: usize>(self, seen: &Self::Seen<C>, v: &Self::List) -> SVector<f64, C>;
    /// `Sᵀf`.
    fn seen_back<const C: usize>(self, seen: &Self::Seen<C>, f: &SVector<f64, C>) -> Self::List;
}

/// A number of coordinates that is fixed by the type.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Fixed<const D: usize>;

/// A number of coordinates that is known at run time.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Any(usize);

impl<const D: usize> Size for Fixed<D> {
    type List = SVector<f64, D>;
    type Square = SMatrix<f64, D, D>;
    type Map<const C: usize> = SMatrix<f64, D, C>;
    type Seen<const C: usize> = SMatrix<f64, C, D>;
    type Indices = [usize; D];

    #[inline]
    fn in_order(self) -> [usize; D] {
        core::array::from_fn(|k| k)
    }

    fn of(_: usize) -> Self {
        Self
    }

    #[inline]
    fn count(self) -> usize {
        D
    }

    #[inline]
    fn looped(self, _: Range<usize>) -> Range<usize> {
        0..D
    }

    #[inline]
    fn dot(a: &Self::List, b: &Self::List) -> f64 {
        a.dot(b)
    }

    #[inline]
    fn times(self, a: &Self::Square, v: &Self::List) -> Self::List {
        a * v
    }

    #[inline]
    fn product(self, a: &Self::Square, b: &Self::Square) -> Self::Square {
        a * b
    }

    #[inline]
    fn mapped<const C: usize>(self, map: &Self::Map<C>, f: &SVector<f64, C>) -> Self::List {
        map * f
    }

    #[inline]
    fn add_mapped<const C: usize>(self, map: &Self::Map<C>, f: &SVector<f64, C>, to: &mut Self::List) {
        *to += map * f;
    }

    #[inline]
    fn mapped_square<const C: usize>(self, map: &Self::Map<C>, f: &SVector<f64, C>) -> f64 {
        (map * f).norm_squared()
    }

    #[inline]
    fn column_square<const C: usize>(self, map: &Self::Map<C>, a: usize) -> f64 {
        map.column(a).into_owned().norm_squared()
    }

    #[inline]
    fn felt<const C: usize>(self, map: &Self::Map<C>, v: &Self::List) -> SVector<f64, C> {
        map.tr_mul(v)
    }

    #[inline]
    fn seen<const C: usize>(self, seen: &Self::Seen<C>, v: &Self::List) -> SVector<f64, C> {
        seen * v
    }

    #[inline]
    fn seen_back<const C: usize>(self, seen: &Self::Seen<C>, f: &SVector<f64, C>) -> Self::List {
        seen.tr_mul(f)
    }
}

impl Size for Any {
    type List = Short;
    type Square = Vec<f64>;
    type Map<const C: usize> = FewRows;
    type Seen<const C: usize> = Vec<f64>;
    type Indices = Vec<usize>;

    fn in_order(self) -> Vec<usize> {
        (0..self.0).collect()
    }

    fn of(count: usize) -> Self {
        Self(count)
    }

    #[inline]
    fn count(self) -> usize {
        self.0
    }

    #[inline]
    fn looped(self, needed: Range<usize>) -> Range<usize> {
        needed
    }

    #[inline]
    fn dot(a: &Short, b: &Short) -> f64 {
        dot(a.slice(), b.slice())
    }

    #[inline]
    fn times(self, a: &Vec<f64>, v: &Short) -> Short {
        combined(self.0, a, v.slice())
    }

    fn product(self, a: &Vec<f64>, b: &Vec<f64>) -> Vec<f64> {
        b.chunks_exact(self.0.max(1))
            .flat_map(|column| combined(self.0, a, column).slice().to_vec())
            .collect()
    }

    #[inline]
    fn mapped<const C: usize>(self, map: &FewRows, f: &SVector<f64, C>) -> Short {
        let mut sum = Short::zeros(self.0);
        self.add_mapped(map, f, &mut sum);
        sum
    }

    #[inline]
    fn add_mapped<const C: usize>(self, map: &FewRows, f: &SVector<f64, C>, to: &mut Short) {
        to.reach(self.0);
        let to = to.slice_mut();
        for_each_mapped(map, f, |k, sum| to[k] += sum);
    }

    #[inline]
    fn mapped_square<const C: usize>(self, map: &FewRows, f: &SVector<f64, C>) -> f64 {
        let mut squares = Lanes::of(self.0);
        for_each_mapped(map, f, |k, sum| squares.add(k, sum * sum));
        squares.sum()
    }

    #[inline]
    fn column_square<const C: usize>(self, map: &FewRows, a: usize) -> f64 {
        in_lanes(self.0, map.of_column(a).map(|(k, x)| (k, x * x)))
    }

    #[inline]
    fn felt<const C: usize>(self, map: &FewRows, v: &Short) -> SVector<f64, C> {
        SVector::from_fn(|a, _| map.felt(a, self.0, v.slice()))
    }

    #[inline]
    fn seen<const C: usize>(self, seen: &Vec<f64>, v: &Short) -> SVector<f64, C> {
        let mut sum = SVector::zeros();
        for (column, v) in seen.chunks_exact(C).zip(v.slice()) {
            for a in 0..C {
                sum[a] += column[a] * v;
            }
        }
        sum
    }

    #[inline]
    fn seen_back<const C: usize>(self, seen: &Vec<f64>, f: &SVector<f64, C>) -> Short {
        let mut back = Short::zeros(self.0);
        for (back, column) in back.slice_mut().iter_mut().zip(seen.chunks_exact(C)) {
            *back = (0..C).map(|a| column[a] * f[a]).sum();
        }
        back
    }
}

/// The dot product over the common length, in four sums side by side: no addition waits for the one before.
#[inline]
fn dot(a: &[f64], b: &[f64]) -> f64 {
    let end = a.len().min(b.len());
    let ((a, a_rest), (b, b_rest)) = (a[..end].as_chunks::<4>(), b[..end].as_chunks::<4>());
    let mut sums = [0.0; 4];
    for (a, b) in a.iter().zip(b) {
        for lane in 0..4 {
            sums[lane] += a[lane] * b[lane];
        }
    }
    let rest: f64 = a_rest.iter().zip(b_rest).map(|(a, b)| a * b).sum();
    (sums[0] + sums[2]) + (sums[1] + sums[3]) + rest
}

/// The four sums of [`dot`], for terms that arrive with their indices.
struct Lanes {
    sums: [f64; 4],
    rest: f64,
    /// Terms from this index on are added to the rest.
    whole: usize,
}

impl Lanes {
    fn of(count: usize) -> Self {
        Self { sums: [0.0; 4], rest: 0.0, whole: count / 4 * 4 }
    }

    #[inline]
    fn add(&mut self, k: usize, term: f64) {
        *(if k < self.whole { &mut self.sums[k % 4] } else { &mut self.rest }) += term;
    }

    #[inline]
    fn sum(self) -> f64 {
        let Self { sums, rest, .. } = self;
        (sums[0] + sums[2]) + (sums[1] + sums[3]) + rest
    }
}

/// The sum that [`dot`] makes of `count` terms, of which only these, with their indices, are not zero.
#[inline]
pub(super) fn in_lanes(count: usize, terms: impl Iterator<Item = (usize, f64)>) -> f64 {
    let mut lanes = Lanes::of(count);
    terms.for_each(|(k, term)| lanes.add(k, term));
    lanes.sum()
}

/// Calls `visit` with each existing row and its entry of `G f`.
#[inline]
fn for_each_mapped<const C: usize>(map: &FewRows, f: &SVector<f64, C>, mut visit: impl FnMut(usize, f64)) {
    for k in MapEntries::<C>::rows(map) {
        let terms = (0..C).filter(|a| f[*a] != 0.0).map(|a| MapEntries::<C>::entry(map, k, a) * f[a]);
        visit(k, terms.fold(0.0, |sum, term| sum + term));
    }
}

/// Matrix–vector product, column by column.
#[inline]
fn combined(rows: usize, columns: &[f64], times: &[f64]) -> Short {
    let mut sum = Short::zeros(rows);
    let list = sum.slice_mut();
    for (column, times) in columns.chunks_exact(rows.max(1)).zip(times) {
        // Many factors are zero.
        if *times != 0.0 {
            list.iter_mut().zip(column).for_each(|(sum, entry)| *sum += entry * times);
        }
    }
    sum
}
