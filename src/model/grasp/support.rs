//! The coordinates in which the grasp map of a site has nonzero entries. A site is a contact, or a drive: the spring of a joint or tendon of a hand,
//! with its force limit.

use crate::numerics::{Map, Space, any_index};
use core::ops::Range;

use crate::prelude::*;

/// Coordinates in which a grasp map has nonzero entries, as two ranges. For a contact with the object, one range holds the object's coordinates and
/// the other the joints of one finger, or another body. For a contact between two other bodies, each range holds one body. The ranges of a drive hold
/// the joints on which it acts.
#[derive(Debug, Clone)]
pub(crate) struct Support {
    ranges: [Range<usize>; 2],
}

impl Support {
    /// The ranges of coordinates that contain all nonzero entries of the grasp map `map` and of its rounding error `rest`. Rows outside these ranges
    /// are removed from both.
    pub(super) fn of(space: Space, map: &mut Map, rest: &mut Map) -> Self {
        let count = map.size().count();
        let object = space.of_the_object().min(count);
        if count == object {
            return Self { ranges: [0..object, object..object] };
        }
        let mut indices = Vec::new();
        for k in map.rows().chain(rest.rows()) {
            let (of_map, of_rest) = (map.row(k), rest.row(k));
            if any_index(3, &|a| of_map[a] != 0.0 || of_rest[a] != 0.0) {
                indices.push(k);
            }
        }
        indices.sort_unstable();
        indices.dedup();
        let others = &indices[indices.partition_point(|k| *k < object)..];
        let all = others.first().zip(others.last()).map_or(count..count, |(first, last)| *first..last + 1);
        let of_object = others.len() < indices.len();
        let ranges = if of_object { [0..object, all] } else { split_at_gap(all, others) };
        map.keep_rows(&ranges);
        rest.keep_rows(&ranges);
        Self { ranges }
    }

    /// Both ranges of coordinates in which the grasp map has nonzero entries. If the grasp has only the object's coordinates, the first range
    /// contains all of them and the second is empty.
    #[inline]
    pub(crate) fn ranges(&self) -> [Range<usize>; 2] {
        self.ranges.clone()
    }
}

/// Divides a range of coordinates at the longest gap between the coordinates in `indices`, where a grasp map has nonzero entries.
fn split_at_gap(range: Range<usize>, indices: &[usize]) -> [Range<usize>; 2] {
    let Range { start, end } = range;
    let (mut gap, mut last) = (end..end, start);
    for &k in indices {
        if k - last > gap.len() + 1 {
            gap = last + 1..k;
        }
        last = k;
    }
    [start..gap.start, gap.end..end]
}
