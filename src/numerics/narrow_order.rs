//! An order of coordinates in which coupled coordinates are close to each other, so that a matrix over these coordinates has a narrow band.
//!
//! A coupling is a pair of ranges of coordinates between which the matrix may have entries. Coordinates that occur in the same couplings form one
//! node of a graph, and each coupling joins nodes. The nodes are visited breadth first, starting from a peripheral node, and neighbours of low degree
//! first (Cuthill–McKee order).
//!
//! Source: A. George and J. W. H. Liu, Computer Solution of Large Sparse Positive Definite Systems (1981), chapter 4.

use core::ops::Range;

use super::increasing::increasing;
use super::mapped::mapped;
use crate::prelude::*;

/// For each of `count` coordinates, its position in the new order, counted from 0. A coupling is a pair of ranges of coordinates; the matrix may have
/// entries between any two coordinates of these ranges.
pub(crate) fn narrow_order(count: usize, couplings: &[[Range<usize>; 2]]) -> Vec<usize> {
    let (starts, neighbours) = graph(count, couplings);
    let node_count = neighbours.len();
    let mut numbers = vec![0; count];
    let (mut next, mut visited) = (0, vec![false; node_count]);
    for node in 0..node_count {
        if visited[node] {
            continue;
        }
        let from = peripheral(&neighbours, node, &mut visited);
        for node in levels_from(&neighbours, from, &mut visited).into_iter().flatten() {
            visited[node] = true;
            for k in starts[node]..starts[node + 1] {
                numbers[k] = next;
                next += 1;
            }
        }
    }
    numbers
}

/// The half bandwidth of a matrix over the coordinates: the largest distance in the new order between two coordinates of the same coupling.
pub(crate) fn widest(numbers: &[usize], couplings: &[[Range<usize>; 2]]) -> usize {
    let mut widest = 0;
    for ranges in couplings {
        let (mut least, mut most) = (usize::MAX, 0);
        for range in ranges {
            for number in &numbers[range.clone()] {
                (least, most) = (least.min(*number), most.max(*number));
            }
        }
        widest = widest.max(most.saturating_sub(least));
    }
    widest
}

/// Returns two lists. The first has the first coordinate of each node and, as its last entry, the number of coordinates. The second has the
/// neighbours of each node.
fn graph(count: usize, couplings: &[[Range<usize>; 2]]) -> (Vec<usize>, Vec<Vec<usize>>) {
    let mut starts = vec![0, count];
    for range in couplings.iter().flatten() {
        if !range.is_empty() {
            starts.extend([range.start, range.end]);
        }
    }
    starts.sort_unstable();
    starts.dedup();
    let mut neighbours = vec![Vec::new(); starts.len() - 1];
    let mut coupled = Vec::new();
    for ranges in couplings {
        coupled.clear();
        for range in ranges.iter().filter(|range| !range.is_empty()) {
            let first = starts.partition_point(|start| *start < range.start);
            for node in first..neighbours.len() {
                if starts[node] >= range.end {
                    break;
                }
                coupled.push(node);
            }
        }
        for (k, node) in coupled.iter().enumerate() {
            neighbours[*node].extend_from_slice(&coupled[..k]);
            neighbours[*node].extend_from_slice(&coupled[k + 1..]);
        }
    }
    for list in &mut neighbours {
        list.sort_unstable();
        list.dedup();
    }
    (starts, neighbours)
}

/// A node at the periphery of the graph of couplings, from which a breadth-first search has many levels. The search starts at `node` and moves
/// to a node of the last level until the number of levels no longer increases.
fn peripheral(neighbours: &[Vec<usize>], mut node: usize, visited: &mut [bool]) -> usize {
    let mut levels = levels_from(neighbours, node, visited);
    loop {
        let farthest = levels.last().map_or(&[][..], Vec::as_slice);
        let Some(next) = farthest.iter().min_by_key(|node| neighbours[**node].len()) else { return node };
        let further = levels_from(neighbours, *next, visited);
        if further.len() <= levels.len() {
            return node;
        }
        (node, levels) = (*next, further);
    }
}

/// All nodes reachable from the node `from`, level by level. Marks that the function sets in `visited` are cleared at the end.
fn levels_from(neighbours: &[Vec<usize>], from: usize, visited: &mut [bool]) -> Vec<Vec<usize>> {
    visited[from] = true;
    let mut levels = vec![vec![from]];
    while let Some(level) = levels.last() {
        let mut next = Vec::new();
        for node in level {
            let begin = next.len();
            for other in &neighbours[*node] {
                if !core::mem::replace(&mut visited[*other], true) {
                    next.push(*other);
                }
            }
            let last = next.split_off(begin);
            for k in increasing(&mapped(&last, &|other| neighbours[*other].len() as f64)) {
                next.push(last[k]);
            }
        }
        if next.is_empty() {
            break;
        }
        levels.push(next);
    }
    for node in levels.iter().flatten() {
        visited[*node] = false;
    }
    levels
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_grid_is_as_wide_as_its_short_side() {
        // A grid of 20 by 5 nodes with 3 coordinates each, numbered along the long side.
        let at = |row: usize, column: usize| 3 * (20 * row + column)..3 * (20 * row + column) + 3;
        let along = (0..5).flat_map(|row| (0..19).map(move |column| [at(row, column), at(row, column + 1)]));
        let across = (0..4).flat_map(|row| (0..20).map(move |column| [at(row, column), at(row + 1, column)]));
        let couplings: Vec<_> = along.chain(across).collect();
        let mut numbers = narrow_order(300, &couplings);
        assert!(widest(&numbers, &couplings) < 3 * 7);
        numbers.sort_unstable();
        assert!(numbers.iter().copied().eq(0..300));
    }

    #[test]
    fn what_nothing_couples_has_its_number_too() {
        let mut numbers = narrow_order(9, &[[6..9, 0..3], [3..3, 3..3]]);
        assert_eq!(widest(&numbers, &[[6..9, 0..3]]), 5);
        numbers.sort_unstable();
        assert!(numbers.iter().copied().eq(0..9));
    }
}
