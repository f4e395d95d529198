//! From part to part of a surface where those meet: over the edges of a mesh, and the corners of a polyline.
//!
//! Normals jump there, so that no derivative tells what lies beyond. Fingers that stand at the end of their part are put on the parts beside it, one by
//! one and all at once, and go up from there as far as that leads. They stay if they have gained in the end.

use super::ascent::{Ascent, Climb, Held};
use super::placing::Placing;
use super::spot::Spot;
use crate::error::Error;
use crate::prelude::*;

/// What is gained has to be this part of the scale of values: rounding would lead to and fro.
const GAINED: f64 = 1e-9;

impl<const C: usize> Climb<'_, C> {
    /// Up from a start, and from part to part as long as that gains and there are steps left.
    pub(super) fn over_edges(&self, held: Held<C>) -> Result<Ascent<C>, Error> {
        let mut best = self.up(held, 0)?;
        let mut steps = best.steps;
        while let Some(better) = self.beyond(&best, &mut steps)? {
            best = better;
        }
        best.steps = steps;
        Ok(best)
    }

    /// An ascent from the parts beside one that has ended, if it leads to more.
    fn beyond(&self, ended: &Ascent<C>, steps: &mut usize) -> Result<Option<Ascent<C>>, Error> {
        let here = &ended.held;
        for placing in self.beside(&here.placing) {
            if *steps >= self.choice.question.steps {
                break;
            }
            let Some(held) = self.held(placing)? else { continue };
            let next = self.up(held, *steps)?;
            *steps = next.steps;
            if next.held.value > here.value + GAINED * here.scale {
                return Ok(Some(next));
            }
        }
        Ok(None)
    }

    /// The placing with each finger at the end of its part put on each part beside it, and with all of them on the first ones.
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
