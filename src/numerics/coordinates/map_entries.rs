//! Entries of a map: in place for a fixed number of coordinates, otherwise of the rows that have entries.
//!
//! A contact of several bodies acts on two of them, however many there are, so its map has entries in few rows. Sums over these rows have the bits of
//! sums over all rows, since zeros change none.

use core::fmt::Debug;
use core::ops::Range;

use nalgebra::SMatrix;

use super::size::in_lanes;
use crate::prelude::*;

/// Entries of a matrix with a row for each coordinate and C columns.
pub(crate) trait MapEntries<const C: usize>: Clone + Debug + PartialEq + Send + Sync {
    fn zeros() -> Self;
    fn entry(&self, k: usize, a: usize) -> &f64;
    fn entry_mut(&mut self, k: usize, a: usize) -> &mut f64;
    /// Sets an entry; a zero does not create a missing row.
    fn set(&mut self, k: usize, a: usize, x: f64);
    /// The existing rows, in order.
    fn rows(&self) -> impl Iterator<Item = usize> + '_;
    /// The entries of a column in a range of existing rows.
    fn column(&self, a: usize, range: Range<usize>) -> &[f64];
    /// Keeps the rows of these ranges only, and creates those that are missing.
    fn keep(&mut self, ranges: &[Range<usize>; 2]);
}

impl<const D: usize, const C: usize> MapEntries<C> for SMatrix<f64, D, C> {
    #[inline]
    fn zeros() -> Self {
        SMatrix::<f64, D, C>::zeros()
    }

    #[inline]
    fn entry(&self, k: usize, a: usize) -> &f64 {
        &self[(k, a)]
    }

    #[inline]
    fn entry_mut(&mut self, k: usize, a: usize) -> &mut f64 {
        &mut self[(k, a)]
    }

    #[inline]
    fn set(&mut self, k: usize, a: usize, x: f64) {
        self[(k, a)] = x;
    }

    #[inline]
    fn rows(&self) -> impl Iterator<Item = usize> + '_ {
        0..D
    }

    #[inline]
    fn column(&self, a: usize, range: Range<usize>) -> &[f64] {
        &self.as_slice()[a * D..(a + 1) * D][range]
    }

    #[inline]
    fn keep(&mut self, _: &[Range<usize>; 2]) {}
}

/// Entries of a few rows; all others are zero.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct FewRows {
    rows: Vec<usize>,
    /// Column by column.
    entries: Vec<f64>,
}

impl FewRows {
    /// The rows with their entries in a column.
    #[inline]
    pub(super) fn of_column(&self, a: usize) -> impl Iterator<Item = (usize, f64)> + '_ {
        let count = self.rows.len();
        self.rows.iter().copied().zip(self.entries[a * count..(a + 1) * count].iter().copied())
    }

    /// A column times a vector of `count` components; those behind the end of its list are zero.
    #[inline]
    pub(super) fn felt(&self, a: usize, count: usize, list: &[f64]) -> f64 {
        let end = count.min(list.len());
        in_lanes(end, self.of_column(a).filter(|(k, _)| *k < end).map(|(k, x)| (k, x * list[k])))
    }
}

impl<const C: usize> MapEntries<C> for FewRows {
    fn zeros() -> Self {
        Self { rows: Vec::new(), entries: Vec::new() }
    }

    #[inline]
    fn entry(&self, k: usize, a: usize) -> &f64 {
        self.rows.binary_search(&k).map_or(&0.0, |place| &self.entries[a * self.rows.len() + place])
    }

    fn entry_mut(&mut self, k: usize, a: usize) -> &mut f64 {
        let place = self.rows.binary_search(&k).unwrap_or_else(|place| {
            // From the last column on, so that earlier positions stay valid.
            (0..C).rev().for_each(|a| self.entries.insert(a * self.rows.len() + place, 0.0));
            self.rows.insert(place, k);
            place
        });
        &mut self.entries[a * self.rows.len() + place]
    }

    fn set(&mut self, k: usize, a: usize, x: f64) {
        if x != 0.0 || self.rows.binary_search(&k).is_ok() {
            *MapEntries::<C>::entry_mut(self, k, a) = x;
        }
    }

    fn rows(&self) -> impl Iterator<Item = usize> + '_ {
        self.rows.iter().copied()
    }

    #[inline]
    fn column(&self, a: usize, range: Range<usize>) -> &[f64] {
        let (count, from) = (self.rows.len(), self.rows.partition_point(|k| *k < range.start));
        &self.entries[a * count..(a + 1) * count][from..from + range.len()]
    }

    fn keep(&mut self, ranges: &[Range<usize>; 2]) {
        let rows: Vec<usize> = ranges.iter().cloned().flatten().collect();
        let mut entries = Vec::with_capacity(C * rows.len());
        for a in 0..C {
            entries.extend(rows.iter().map(|k| *MapEntries::<C>::entry(self, *k, a)));
        }
        *self = Self { rows, entries };
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Any, Map, Size, Vector};
    use crate::numerics::generic;
    use nalgebra::SVector;

    /// The dot product in four sums side by side and the remainder.
    fn dense(a: &[f64], b: &[f64]) -> f64 {
        let (mut sums, whole) = ([0.0; 4], a.len() / 4 * 4);
        (0..whole).for_each(|k| sums[k % 4] += a[k] * b[k]);
        let rest: f64 = (whole..a.len()).map(|k| a[k] * b[k]).sum();
        (sums[0] + sums[2]) + (sums[1] + sums[3]) + rest
    }

    #[test]
    fn sums_over_few_rows_have_the_bits_of_those_over_all() {
        let size = Any::of(23);
        let mut map = Map::<Any, 2>::zeros(size);
        for (n, k) in [22, 3, 14, 4, 15].into_iter().enumerate() {
            map.set_row(k, &SVector::<f64, 2>::new(generic(2 * n), generic(2 * n + 1)));
        }
        let v = Vector::from_fn(size, |k| generic(40 + k));
        let felt = map.tr_mul(&v);
        for a in 0..2 {
            let column: Vec<f64> = (0..23).map(|k| map[(k, a)]).collect();
            assert_eq!(felt[a].to_bits(), dense(&column, v.as_slice()).to_bits());
        }
        let f = SVector::<f64, 2>::new(0.3, -0.7);
        let mut pushed = Vector::zeros();
        map.push(&f, &mut pushed);
        assert_eq!(pushed, &map * f);
        assert_eq!(map.pushed_norm(&f).to_bits(), pushed.norm().to_bits());
    }
}
