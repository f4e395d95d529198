//! Ascent across the edges of a mesh and the corners of a polyline.
//!
//! Normals jump there, so that derivatives on one side say nothing about the other. Fingers at the end of their part are moved to the adjacent parts,
//! one by one and all at once, and the ascent continues from there. The new place is kept if the value has grown in the end.

use super::ascent::{Ascent, Climb, Design};
use super::placing::Placing;
use crate::error::Error;
use crate::numerics::tolerances::NEGLIGIBLE;
use crate::prelude::*;

impl Climb<'_> {
    /// Ascent from a start, continued on adjacent parts as long as the value grows and steps are left.
    pub(super) fn over_edges(&self, design: Design) -> Result<Ascent, Error> {
        let mut best = self.ascend(design, 0)?;
        let mut steps = best.steps;
        while let Some(better) = self.ascend_from_adjacent(&best, &mut steps)? {
            best = better;
        }
        best.steps = steps;
        Ok(best)
    }

    /// The ascent from an adjacent part, if it ends at a larger value.
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

    /// Placings with one finger moved from the end of its part to an adjacent part, and one placing with all such fingers moved to their first
    /// adjacent part.
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
