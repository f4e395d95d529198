//! Entries of the grasp map of a contact, from its force to the coordinates of the grasp. For up to six coordinates all rows are stored, otherwise
//! the nonzero rows. The coordinates of a grasp describe the motion of the object, of joints and of further bodies.
//!
//! With several bodies a contact acts on two of them, so its map has entries in few rows. Sums over these rows equal sums over all rows bit for bit,
//! since adding zeros changes nothing.

use crate::numerics::IntoList;
use core::ops::Range;

use nalgebra::SVector;

use super::list::List;
use super::products::{SumLanes, dot, dot_whole};
use super::size::{Size, WHOLE};
use crate::prelude::*;

/// Entries of a matrix with a row per coordinate and a column per axis of a contact.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum MapEntries {
    /// All entries, column by column, with zeros beyond the last coordinate.
    Whole([[f64; WHOLE]; 3]),
    Few(FewRows),
}

/// Entries of a few stored rows; all other rows are zero.
#[derive(Debug, Clone, PartialEq, Default)]
pub(super) struct FewRows {
    rows: Vec<usize>,
    /// Entries of the stored rows, column by column.
    entries: Vec<f64>,
}

impl MapEntries {
    #[inline]
    pub(super) fn zeros(size: Size) -> Self {
        if size.count() <= WHOLE { Self::Whole([[0.0; WHOLE]; 3]) } else { Self::Few(FewRows::default()) }
    }

    #[inline]
    pub(super) fn entry(&self, k: usize, a: usize) -> &f64 {
        match self {
            Self::Whole(columns) => &columns[a][k],
            Self::Few(few) => few
                .rows
                .binary_search(&k)
                .map_or(&0.0, |position| &few.entries[a * few.rows.len() + position]),
        }
    }

    #[inline]
    pub(super) fn entry_mut(&mut self, k: usize, a: usize) -> &mut f64 {
        match self {
            Self::Whole(columns) => &mut columns[a][k],
            Self::Few(few) => few.entry_mut(k, a, 3),
        }
    }

    /// Sets the entry in row `k` and column `a`. A nonzero entry adds its row to the stored rows; a zero does not.
    #[inline]
    pub(super) fn set(&mut self, k: usize, a: usize, x: f64) {
        match self {
            Self::Whole(columns) => columns[a][k] = x,
            Self::Few(few) => {
                if x != 0.0 || few.rows.binary_search(&k).is_ok() {
                    *few.entry_mut(k, a, 3) = x;
                }
            }
        }
    }

    /// Number of stored rows.
    #[inline]
    pub(super) fn row_count(&self, size: Size) -> usize {
        match self {
            Self::Whole(_) => size.count(),
            Self::Few(few) => few.rows.len(),
        }
    }

    /// Index of the row that is stored at this position in the list of stored rows.
    #[inline]
    pub(super) fn row(&self, position: usize) -> usize {
        match self {
            Self::Whole(_) => position,
            Self::Few(few) => few.rows[position],
        }
    }

    /// The entries of column `a` in the rows with indices in `range`, all of which must be stored.
    #[inline]
    pub(super) fn column(&self, a: usize, range: Range<usize>) -> &[f64] {
        match self {
            Self::Whole(columns) => &columns[a][range],
            Self::Few(few) => {
                let (count, from) = (few.rows.len(), few.rows.partition_point(|k| *k < range.start));
                &few.entries[a * count..(a + 1) * count][from..from + range.len()]
            }
        }
    }

    /// Stores exactly the rows with indices in these ranges, if not all rows are stored. Rows that were not stored before get zeros.
    pub(super) fn keep_rows(&mut self, ranges: &[Range<usize>; 2]) {
        if let Self::Few(_) = self {
            let rows: Vec<usize> = ranges.iter().cloned().flatten().list();
            let mut entries = Vec::with_capacity(3 * rows.len());
            for a in 0..3 {
                rows.iter().map(|k| *self.entry(*k, a)).append_to(&mut entries);
            }
            *self = Self::Few(FewRows { rows, entries });
        }
    }

    /// Adds the product `G f` of this matrix G and a contact force f to a list that has all coordinates.
    #[inline]
    pub(super) fn add_mapped(&self, f: &SVector<f64, 3>, to: &mut List) {
        match self {
            Self::Whole(_) => {
                let sum = self.mapped(f);
                match to.fixed_mut::<WHOLE>() {
                    Some(to) => (0..WHOLE).for_each(|k| to[k] += sum[k]),
                    None => to.slice_mut().iter_mut().zip(sum).for_each(|(to, sum)| *to += sum),
                }
            }
            Self::Few(few) => {
                let to = to.slice_mut();
                few.rows
                    .iter()
                    .enumerate()
                    .for_each(|(position, k)| to[*k] += few.mapped(position, f.as_slice()));
            }
        }
    }

    /// The squared norm `|G f|²` of the product of this matrix G and a contact force f.
    #[inline]
    pub(super) fn mapped_square(&self, size: Size, f: &SVector<f64, 3>) -> f64 {
        match self {
            Self::Whole(_) => {
                let sum = self.mapped(f);
                dot_whole(&sum, &sum)
            }
            Self::Few(few) => {
                let mut squares = SumLanes::of(size.count());
                for (position, k) in few.rows.iter().enumerate() {
                    let sum = few.mapped(position, f.as_slice());
                    squares.add(*k, sum * sum);
                }
                squares.sum()
            }
        }
    }

    /// The product `Gᵀv` of this matrix G, transposed, and a vector v, given by `list`; components beyond the end of `list` are zero.
    #[inline]
    pub(super) fn tr_mul(&self, size: Size, list: &List) -> SVector<f64, 3> {
        let mut product = SVector::zeros();
        match (self, list.fixed::<WHOLE>()) {
            (Self::Whole(columns), Some(list)) => {
                for a in 0..3 {
                    product[a] = dot_whole(&columns[a], list);
                }
            }
            (Self::Whole(columns), None) => {
                for a in 0..3 {
                    product[a] = dot(&columns[a], list.slice());
                }
            }
            (Self::Few(few), _) => {
                for a in 0..3 {
                    product[a] = few.tr_mul_column(a, size.count(), list.slice());
                }
            }
        }
        product
    }

    pub(super) fn column_square(&self, a: usize, size: Size) -> f64 {
        match self {
            Self::Whole(columns) => dot_whole(&columns[a], &columns[a]),
            Self::Few(few) => {
                let mut squares = SumLanes::of(size.count());
                few.of_column(a).for_each(|(k, x)| squares.add(k, x * x));
                squares.sum()
            }
        }
    }

    /// The product `G f` of this matrix G and a contact force f. Only called if all rows are stored; otherwise the result is zero.
    #[inline]
    fn mapped(&self, f: &SVector<f64, 3>) -> [f64; WHOLE] {
        let mut sum = [0.0; WHOLE];
        if let Self::Whole(columns) = self {
            for (column, f) in columns.iter().zip(f.as_slice()) {
                for k in 0..WHOLE {
                    sum[k] += column[k] * f;
                }
            }
        }
        sum
    }
}

impl FewRows {
    fn entry_mut(&mut self, k: usize, a: usize, columns: usize) -> &mut f64 {
        let position = self.rows.binary_search(&k).unwrap_or_else(|position| {
            // Zeros are inserted from the last column to the first, so that positions in earlier columns stay valid.
            (0..columns).rev().for_each(|a| self.entries.insert(a * self.rows.len() + position, 0.0));
            self.rows.insert(position, k);
            position
        });
        &mut self.entries[a * self.rows.len() + position]
    }

    /// For each stored row, its index and its entry in column `a`.
    #[inline]
    fn of_column(&self, a: usize) -> impl Iterator<Item = (usize, f64)> + '_ {
        let count = self.rows.len();
        self.rows.iter().copied().zip(self.entries[a * count..(a + 1) * count].iter().copied())
    }

    /// The component of the product of this matrix and `f` in the stored row number `position`.
    #[inline]
    fn mapped(&self, position: usize, f: &[f64]) -> f64 {
        let mut sum = 0.0;
        for (a, f) in f.iter().enumerate() {
            if *f != 0.0 {
                sum += self.entries[a * self.rows.len() + position] * f;
            }
        }
        sum
    }

    /// The dot product of column `a` with a vector of `count` components; components beyond the end of `list` are zero.
    #[inline]
    fn tr_mul_column(&self, a: usize, count: usize, list: &[f64]) -> f64 {
        let end = count.min(list.len());
        let mut lanes = SumLanes::of(end);
        for (k, x) in self.of_column(a) {
            if k < end {
                lanes.add(k, x * list[k]);
            }
        }
        lanes.sum()
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Map, Size, Vector};
    use crate::numerics::generic;
    use nalgebra::SVector;

    /// Reference for the order of summation: the dot product as four interleaved sums. Terms after the last multiple of four are added at the end.
    fn dense(a: &[f64], b: &[f64]) -> f64 {
        let (mut sums, whole) = ([0.0; 4], a.len() / 4 * 4);
        (0..whole).for_each(|k| sums[k % 4] += a[k] * b[k]);
        let rest: f64 = (whole..a.len()).map(|k| a[k] * b[k]).sum();
        (sums[0] + sums[2]) + (sums[1] + sums[3]) + rest
    }

    #[test]
    fn sums_over_few_rows_have_the_bits_of_those_over_all() {
        let size = Size::of(23);
        let mut map = Map::zeros(size);
        for (n, k) in [22, 3, 14, 4, 15].into_iter().enumerate() {
            map.set_row(k, &SVector::<f64, 3>::new(generic(2 * n), generic(2 * n + 1), generic(80 + n)));
        }
        let v = Vector::from_fn(size, |k| generic(40 + k));
        let product = map.tr_mul(&v);
        for a in 0..3 {
            let column: Vec<f64> = (0..23).map(|k| map[(k, a)]).collect();
            assert_eq!(product[a].to_bits(), dense(&column, v.as_slice()).to_bits());
        }
        let f = SVector::<f64, 3>::new(0.3, -0.7, 0.2);
        let mut pushed = Vector::zeros();
        map.push(&f, &mut pushed);
        assert_eq!(pushed, &map * f);
        assert_eq!(map.pushed_norm(&f).to_bits(), pushed.norm().to_bits());
    }
}
