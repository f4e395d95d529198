//! The coordinates in which a site's map has entries.

use crate::numerics::Map;
use core::ops::Range;

use crate::numerics::Space;
use crate::prelude::*;

/// Coordinates in which a map has entries, as two ranges. The ranges are those of the object, if any, and of some neighbouring joints, or those
/// of two other bodies. A contact depends on the joints of one finger, a drive on its own joint.
#[derive(Debug, Clone)]
pub(crate) struct Support {
    ranges: [Range<usize>; 2],
}

impl Support {
    /// Common support of two maps, which then store only the rows of these ranges.
    pub(super) fn of(space: Space, map: &mut Map, rest: &mut Map) -> Self {
        let count = map.size().count();
        let object = space.of_the_object().min(count);
        if count == object {
            return Self { ranges: [0..object, object..object] };
        }
        let mut felt = Vec::new();
        for k in map.rows().chain(rest.rows()) {
            let (of_map, of_rest) = (map.row(k), rest.row(k));
            if (0..3).any(|a| of_map[a] != 0.0 || of_rest[a] != 0.0) {
                felt.push(k);
            }
        }
        felt.sort_unstable();
        felt.dedup();
        let others = &felt[felt.partition_point(|k| *k < object)..];
        let all = others.first().zip(others.last()).map_or(count..count, |(first, last)| *first..last + 1);
        let of_object = others.len() < felt.len();
        let ranges = if of_object { [0..object, all] } else { apart(all, others) };
        map.keep(&ranges);
        rest.keep(&ranges);
        Self { ranges }
    }

    /// Both ranges of coordinates. If the grasp has no joints the first range contains all coordinates.
    #[inline]
    pub(crate) fn ranges(&self) -> [Range<usize>; 2] {
        self.ranges.clone()
    }
}

/// Divides a range at its longest gap between the coordinates in `felt`.
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
