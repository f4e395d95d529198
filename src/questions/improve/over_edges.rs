//! Ascent across the edges between triangles of a mesh and the corners between segments of a polyline.
//!
//! Normals jump at edges and corners, so derivatives on one side of an edge say nothing about the other side. Fingers that ended at the edge of their
//! part (a triangle or segment) are moved to an adjacent part, each alone and all at once. An ascent starts from each of these placings and is kept
//! if it ends at a larger value.

use super::ascent::{Ascent, Climb, Design};
use super::placing::Placing;
use crate::error::Error;
use crate::numerics::tolerances::NEGLIGIBLE;
use crate::prelude::*;

impl Climb<'_> {
    /// Ascent from a start, continued on adjacent triangles or segments of surfaces as long as the value grows and steps are left.
    pub(super) fn over_edges(&self, design: Design) -> Result<Ascent, Error> {
        let mut best = self.ascend(design, 0)?;
        let mut steps = best.steps;
        while let Some(better) = self.ascend_from_adjacent(&best, &mut steps)? {
            best = better;
        }
        best.steps = steps;
        Ok(best)
    }

    /// The first ascent found that starts on an adjacent triangle or segment and ends at a larger value than `ended`. `None` if no such ascent ends
    /// at a larger value, or no steps are left.
    fn ascend_from_adjacent(&self, ended: &Ascent, steps: &mut usize) -> Result<Option<Ascent>, Error> {
        let best = &ended.design;
        for placing in self.adjacent(&best.placing) {
            if *steps >= self.choice.question.steps() {
                break;
            }
            let Some(design) = self.evaluate(placing)? else { continue };
            let next = self.ascend(design, *steps)?;
            *steps = next.steps;
            if next.design.value > best.value + NEGLIGIBLE * best.scale {
                return Ok(Some(next));
            }
        }
        Ok(None)
    }

    /// Placings in which one finger at the edge of its part (triangle or segment) has moved to an adjacent part. If there are several such fingers, a
    /// further placing has all of them moved, each to its first adjacent part.
    fn adjacent(&self, from: &Placing) -> Vec<Placing> {
        let (mut placings, mut all, mut move_at_once) = (Vec::new(), from.clone(), 0);
        for (contact, surface) in &self.choice.question.surfaces {
            let Some(spot) = &from.spots[*contact] else { continue };
            let others = spot.adjacent(&surface.0);
            if let Some(first) = others.first() {
                all = self.choice.with_spot(&all, *contact, first.clone());
                move_at_once += 1;
            }
            for other in others {
                placings.push(self.choice.with_spot(from, *contact, other));
            }
        }
        if move_at_once > 1 {
            placings.push(all);
        }
        placings
    }
}
