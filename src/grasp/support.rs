//! Which coordinates a site feels.

use crate::numerics::{Map, Size};
use core::ops::Range;

use super::rotation::of_the_object;
use crate::prelude::*;

/// The coordinates in which a map has entries, as two ranges: those of the object, or none of them, and some joints next to each other; or
/// those of two bodies of which neither has the coordinates of the object. A contact feels the joints of one finger, a drive its own.
#[derive(Debug, Clone)]
pub(crate) struct Support<D: Size> {
    size: D,
    ranges: [Range<usize>; 2],
}

impl<D: Size> Support<D> {
    /// That of these two maps together, in which only its rows are kept.
    pub(super) fn of<const C: usize>(map: &mut Map<D, C>, rest: &mut Map<D, C>) -> Self {
        let size = map.size();
        let count = size.count();
        let is_felt = |k: &usize| map.row(*k).iter().chain(rest.row(*k).iter()).any(|x| *x != 0.0);
        let mut felt: Vec<usize> = map.rows().chain(rest.rows()).filter(is_felt).collect();
        felt.sort_unstable();
        felt.dedup();
        let object = of_the_object::<C>().min(count);
        let others = &felt[felt.partition_point(|k| *k < object)..];
        let all = others.first().zip(others.last()).map_or(count..count, |(first, last)| *first..last + 1);
        let of_object = others.len() < felt.len();
        let ranges = if of_object { [0..object, all] } else { apart(all, others) };
        map.keep(&ranges);
        rest.keep(&ranges);
        Self { size, ranges }
    }

    /// Its coordinates, as two ranges. Of a grasp without joints the first is all there is, and of a length known to the compiler.
    #[inline(always)]
    pub(crate) fn ranges<const C: usize>(&self) -> [Range<usize>; 2] {
        let all = self.size.count();
        if all == of_the_object::<C>() { [0..all, all..all] } else { self.ranges.clone() }
    }
}

/// A range divided where it is not felt for longest.
fn apart(range: Range<usize>, felt: &[usize]) -> [Range<usize>; 2] {
    let Range { start, end } = range;
    let (mut gap, mut last) = (end..end, start);
    for &k in felt {
        if k - last > gap.len() + 1 {
            gap = last + 1..k;
        }
        last = k;
    }
    [start..gap.start, gap.end..end]
}
