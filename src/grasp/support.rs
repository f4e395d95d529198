//! Which coordinates a site feels.

use crate::numerics::{Map, Size};
use std::ops::Range;

use super::rotation::of_the_object;

/// The coordinates in which a map has entries, as two ranges: those of the object, or none of them, and some joints next to each other; or
/// those of two bodies of which neither has the coordinates of the object. A contact feels the joints of one finger, a drive its own.
#[derive(Debug, Clone)]
pub(crate) struct Support<D: Size> {
    size: D,
    ranges: [Range<usize>; 2],
}

impl<D: Size> Support<D> {
    pub(super) fn of<const C: usize>(map: &Map<D, C>, rest: &Map<D, C>) -> Self {
        let size = map.size();
        let count = size.count();
        let felt = |k: &usize| map.row(*k).iter().chain(rest.row(*k).iter()).any(|x| *x != 0.0);
        let object = of_the_object::<C>().min(count);
        let first = (object..count).find(felt).unwrap_or(count);
        let end = (first..count).rev().find(felt).map_or(first, |last| last + 1);
        let of_object = (0..object).any(|k| felt(&k));
        let ranges = if of_object { [0..object, first..end] } else { apart(first..end, felt) };
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
fn apart(range: Range<usize>, felt: impl Fn(&usize) -> bool) -> [Range<usize>; 2] {
    let Range { start, end } = range;
    let (mut gap, mut last) = (end..end, start);
    for k in (start..end).filter(felt) {
        if k - last > gap.len() + 1 {
            gap = last + 1..k;
        }
        last = k;
    }
    [start..gap.start, gap.end..end]
}
