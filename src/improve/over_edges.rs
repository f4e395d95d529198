//! Ascent across the edges of a mesh and the corners of a polyline.
//!
//! Normals jump there, so that derivatives on one side say nothing about the other. Fingers at the end of their part are moved to the adjacent parts,
//! one by one and all at once, and the ascent continues from there. The new place is kept if the value has grown in the end.

use super::ascent::{Ascent, Climb, Held};
use super::placing::Placing;
use super::spot::Spot;
use crate::error::Error;
use crate::numerics::tolerances::NEGLIGIBLE;
use crate::prelude::*;

impl<const C: usize> Climb<'_, C> {
    /// Ascent from a start, and on from part to part as long as the value grows and steps are left.
    pub(super) fn over_edges(&self, held: Held<C>) -> Result<Ascent<C>, Error> {
        let mut best = self.up(held, 0)?;
        let mut steps = best.steps;
        while let Some(better) = self.beyond(&best, &mut steps)? {
            best = better;
        }
        best.steps = steps;
        Ok(best)
    }

    /// The ascent from an adjacent part, if it ends at a larger value.
    fn beyond(&self, ended: &Ascent<C>, steps: &mut usize) -> Result<Option<Ascent<C>>, Error> {
        let here = &ended.held;
        for placing in self.beside(&here.placing) {
            if *steps >= self.choice.question.steps {
                break;
            }
            let Some(held) = self.held(placing)? else { continue };
            let next = self.up(held, *steps)?;
            *steps = next.steps;
            if next.held.value > here.value + NEGLIGIBLE * here.scale {
                return Ok(Some(next));
            }
        }
        Ok(None)
    }

    /// Placings with one finger moved from the end of its part to an adjacent part, and one placing with all such fingers moved to their first
    /// adjacent part.
    fn beside(&self, from: &Placing<C>) -> Vec<Placing<C>> {
        let others = self.choice.question.surfaces.iter().map(|(contact, surface)| {
            let spot = from.spots[*contact].as_ref();
            (*contact, spot.map_or(Vec::new(), |spot| spot.beside(surface)))
        });
        let others: Vec<(usize, Vec<Spot<C>>)> = others.filter(|(_, spots)| !spots.is_empty()).collect();
        let one = others.iter().flat_map(|(contact, spots)| {
            spots.iter().map(|spot| self.choice.put(from, *contact, spot.clone()))
        });
        let mut placings: Vec<_> = one.collect();
        if others.len() > 1 {
            let all = others.iter().fold(from.clone(), |placing, (contact, spots)| {
                self.choice.put(&placing, *contact, spots[0].clone())
            });
            placings.push(all);
        }
        placings
    }
}
