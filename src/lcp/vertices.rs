//! Vertices of small polyhedra, for problems in which linear programming has failed because entries differ by many orders of magnitude.
//!
//! The problem has n rows. Let α be the set of i with z_i basic, and ᾱ its complement. If the piece { z_α ≥ 0, (M z + q)_α = 0, (M z + q)_ᾱ ≥ 0 } is
//! not empty, it has a vertex: a point where k components of M z + q are zero and at most k entries of z are nonzero.
//!
//! A Farkas vector is a y ≥ 0 with Mᵀy ≤ 0 and qᵀy < 0. It proves that no z ≥ 0 satisfies M z + q ≥ 0. The vectors y ≥ 0 with Mᵀy ≤ 0 form a cone,
//! and if Farkas vectors exist, some extreme ray of this cone is one. Each vertex or extreme ray is the solution of a small regular system, whose
//! rows and columns are scaled for this system alone.

use super::farkas::cleaned;
use super::linear_program::MARGINS;
use super::principal;
use super::problem::Lcp;
use super::scaling::Scaling;
use crate::numerics::{Reals, mapped, matrix_of, vector_of};
use crate::prelude::*;
use nalgebra::{DMatrix, DVector};

/// Candidates for vertices of the set { z_α ≥ 0, (M z + q)_α = 0, (M z + q)_ᾱ ≥ 0 } of the basis α (`alpha`). Each candidate is a vector z_α with k
/// chosen entries that may be nonzero, such that k chosen components of M z + q vanish. The caller must check the other conditions.
pub(super) fn of_piece<'a>(lcp: &'a Lcp, alpha: &'a [usize]) -> impl Iterator<Item = DVector<f64>> + 'a {
    let n = lcp.len();
    subsets(alpha.len()).filter(|columns| !columns.is_empty()).flat_map(move |columns| {
        let chosen: Vec<usize> = mapped(&columns, &|k| alpha[*k]);
        let count = columns.len();
        subsets(n).filter(move |rows| rows.len() == count).filter_map(move |rows| {
            let block = matrix_of(count, count, &|i, j| lcp.m[(rows[i], chosen[j])]);
            let values = without_single_entries(&block, &vector_of(count, &|i| -lcp.q[rows[i]]))?;
            let mut basic = DVector::zeros(alpha.len());
            for (k, value) in columns.iter().zip(&values) {
                basic[*k] = *value;
            }
            Some(basic)
        })
    })
}

/// A Farkas vector, found among the extreme rays of the cone { y ≥ 0, Mᵀy ≤ 0 }. It is the ray's direction as computed, or this vector moved into the
/// cone by a margin that covers rounding. `None` if no extreme ray gives an exact proof.
pub(super) fn farkas(lcp: &Lcp, scaling: &Scaling) -> Option<DVector<f64>> {
    let n = lcp.len();
    let (m, q) = scaling.balanced(&lcp.m, &lcp.q);
    let size_of_q = if q.amax() > 0.0 { q.amax() } else { 1.0 };
    subsets(n).filter(|rows| !rows.is_empty()).find_map(|rows| {
        let k = rows.len();
        // An extreme ray y is determined by the positions of its k nonzero entries, and by k − 1 columns of [M, q] whose products with y vanish.
        subsets(n + 1).filter(|columns| columns.len() + 1 == k).find_map(|columns| {
            let column = |j: usize, row: usize| if j < n { m[(row, j)] } else { q[row] / size_of_q };
            MARGINS.into_iter().find_map(|margin| {
                let system = matrix_of(k, k, &|i, r| columns.get(i).map_or(1.0, |j| column(*j, rows[r])));
                let target = vector_of(k, &|i| if i + 1 < k { -margin } else { 1.0 });
                let corner = system.full_piv_lu().solve(&target)?;
                let mut y = DVector::zeros(n);
                for (row, entry) in rows.iter().zip(&corner) {
                    y[*row] = entry * scaling.row[*row];
                }
                cleaned(&y).find(|y| lcp.proves_infeasible(y))
            })
        })
    })
}

/// Solves a square system; `None` if it is singular. Rows and columns with a single nonzero entry are eliminated first. Otherwise a regular system
/// could appear singular, since no scaling brings such an entry and all others near 1.
fn without_single_entries(block: &DMatrix<f64>, rhs: &DVector<f64>) -> Option<DVector<f64>> {
    let size = rhs.len();
    let alone = |line: &mut dyn Iterator<Item = f64>| {
        let mut entries = line.enumerate().filter(|(_, x)| *x != 0.0).map(|(k, _)| k);
        entries.next().filter(|_| entries.next().is_none())
    };
    let row = (0..size).find_map(|i| Some((i, alone(&mut block.row(i).iter().copied())?)));
    let column = (0..size).find_map(|j| Some((alone(&mut block.column(j).iter().copied())?, j)));
    let Some((i, j)) = row.or(column) else { return principal::solve_block(block.clone(), rhs) };
    let rest = block.clone().remove_row(i).remove_column(j);
    let others = (0..size).filter(|k| *k != j);
    let (value, x) = if row.is_some() {
        let value = rhs[i] / block[(i, j)];
        let left = rhs - block.column(j) * value;
        (value, without_single_entries(&rest, &left.remove_row(i))?)
    } else {
        let x = without_single_entries(&rest, &rhs.clone().remove_row(i))?;
        let sum: f64 = others.zip(&x).map(|(k, x)| block[(i, k)] * x).added();
        ((rhs[i] - sum) / block[(i, j)], x)
    };
    value.is_finite().then(|| x.insert_row(j, value))
}

/// All subsets of 0 … count − 1, in order of increasing number of elements.
fn subsets(count: usize) -> Subsets {
    Subsets { count, size: 0, bits: 0 }
}

/// Iterator over subsets: all subsets of `size` elements, then those of one element more. `bits` encodes the next set to be tested: bit i is 1 if i
/// belongs to it. Only sets of `size` elements are returned.
struct Subsets {
    count: usize,
    size: usize,
    bits: u32,
}

impl Iterator for Subsets {
    type Item = Vec<usize>;

    fn next(&mut self) -> Option<Vec<usize>> {
        while self.size <= self.count {
            if self.bits >> self.count != 0 {
                (self.size, self.bits) = (self.size + 1, 0);
                continue;
            }
            let bits = self.bits;
            self.bits += 1;
            if bits.count_ones() as usize == self.size {
                let mut members = Vec::with_capacity(self.size);
                for i in 0..self.count {
                    if bits >> i & 1 == 1 {
                        members.push(i);
                    }
                }
                return Some(members);
            }
        }
        None
    }
}
