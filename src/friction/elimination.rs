//! Block elimination of systems with one block row per contact. Contacts with few neighbours are eliminated first.
//!
//! In piles and stacks each contact is coupled with few others, so most blocks are zero and remain so. Pivots are the diagonal blocks, without a
//! search for larger pivots in other block rows. Usually the matrix W, which maps contact forces to velocities, is positive semidefinite, and these
//! pivots are regular. If a pivot is singular, [`solve`] returns `None`.

use super::blocks::{Blocks, ContactBlock};
use super::problem::part;
use crate::numerics::keep;
use crate::prelude::*;
use alloc::collections::BinaryHeap;
use core::cmp::Reverse;
use nalgebra::DVector;

/// The elimination order by minimum degree: the next contact is one with the fewest remaining neighbours.
pub(super) fn order<const C: usize>(blocks: &Blocks<C>) -> Vec<usize> {
    let mut near: Vec<Vec<usize>> = vec![Vec::new(); blocks.len()];
    for i in 0..blocks.len() {
        for (j, _) in blocks.off_diagonal(i) {
            near[i].push(*j);
            near[*j].push(i);
        }
    }
    by_degree(near)
}

/// The elimination order by minimum degree, from lists of the neighbours of each contact.
fn by_degree(mut near: Vec<Vec<usize>>) -> Vec<usize> {
    // Entries of the heap are pairs of degree (number of remaining neighbours) and contact. Outdated pairs of a contact remain in the heap and
    // are skipped.
    let mut waiting = BinaryHeap::new();
    for (i, near) in near.iter_mut().enumerate() {
        near.sort_unstable();
        near.dedup();
        waiting.push(Reverse((near.len(), i)));
    }
    let mut is_eliminated = vec![false; near.len()];
    let mut order = Vec::with_capacity(near.len());
    while let Some(Reverse((degree, i))) = waiting.pop() {
        if is_eliminated[i] || near[i].len() != degree {
            continue;
        }
        is_eliminated[i] = true;
        order.push(i);
        let around = core::mem::take(&mut near[i]);
        for j in &around {
            near[*j].extend_from_slice(&around);
            near[*j].sort_unstable();
            near[*j].dedup();
            keep(&mut near[*j], &|k| *k != i && k != j);
            waiting.push(Reverse((near[*j].len(), *j)));
        }
    }
    order
}

/// The inverse of a block by row operations with partial pivoting; `None` if the block is singular.
fn inverse<const C: usize>(mut block: ContactBlock<C>) -> Option<ContactBlock<C>> {
    let mut inverse = ContactBlock::<C>::identity();
    for k in 0..C {
        let mut pivot = k;
        for row in k + 1..C {
            if block[(row, k)].abs() > block[(pivot, k)].abs() {
                pivot = row;
            }
        }
        for matrix in [&mut block, &mut inverse] {
            matrix.swap_rows(k, pivot);
        }
        let over = block[(k, k)];
        for column in 0..C {
            block[(k, column)] /= over;
            inverse[(k, column)] /= over;
        }
        for row in 0..C {
            let times = block[(row, k)];
            for column in 0..C {
                if row != k {
                    block[(row, column)] -= times * block[(k, column)];
                    inverse[(row, column)] -= times * inverse[(k, column)];
                }
            }
        }
    }
    inverse.iter().all(|x| x.is_finite()).then_some(inverse)
}

/// A block row of a matrix: pairs of a contact, whose block column it is, and a nonzero block.
pub(super) type SparseRow<const C: usize> = Vec<(usize, ContactBlock<C>)>;

/// Solves a linear system, given its block rows by contact and its right-hand side. `order` lists the contacts in the order of elimination. `None` if
/// a pivot is singular.
pub(super) fn solve<const C: usize>(
    order: &[usize],
    rows: &[SparseRow<C>],
    rhs: &DVector<f64>,
) -> Option<DVector<f64>> {
    let n = order.len();
    let mut position = vec![0; n];
    for (k, i) in order.iter().enumerate() {
        position[*i] = k;
    }
    // Both lists follow the elimination order. `pivots` has the inverses of the pivot blocks, `uppers` the block rows of the upper triangle.
    let mut pivots: Vec<ContactBlock<C>> = Vec::with_capacity(n);
    let mut uppers: Vec<SparseRow<C>> = Vec::with_capacity(n);
    let mut work: Vec<ContactBlock<C>> = vec![ContactBlock::zeros(); n];
    let mut present = vec![false; n];
    let mut x = rhs.clone();
    for (k, i) in order.iter().enumerate() {
        for (j, block) in &rows[*i] {
            work[position[*j]] = *block;
            present[position[*j]] = true;
        }
        let mut value = part::<C>(rhs, *i);
        for before in 0..k {
            if !present[before] {
                continue;
            }
            present[before] = false;
            let factor = work[before] * pivots[before];
            value -= factor * part::<C>(&x, order[before]);
            for (j, block) in &uppers[before] {
                let change = factor * block;
                if present[*j] {
                    work[*j] -= change;
                } else {
                    work[*j] = -change;
                    present[*j] = true;
                }
            }
        }
        present[k] = false;
        pivots.push(inverse(work[k])?);
        let mut upper = Vec::new();
        for j in k + 1..n {
            if core::mem::take(&mut present[j]) {
                upper.push((j, work[j]));
            }
        }
        uppers.push(upper);
        x.fixed_rows_mut::<C>(C * i).copy_from(&value);
    }
    for k in (0..n).rev() {
        let i = order[k];
        let mut value = part::<C>(&x, i);
        for (j, block) in &uppers[k] {
            value -= block * part::<C>(&x, order[*j]);
        }
        x.fixed_rows_mut::<C>(C * i).copy_from(&(pivots[k] * value));
    }
    x.iter().all(|x| x.is_finite()).then_some(x)
}
