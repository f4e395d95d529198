//! Ascent across the edges between triangles of a mesh and the corners between segments of a polyline. A part of a surface is one triangle or
//! segment. A design point is one choice of the places (positions on their surfaces) and commanded normal forces of all contacts. The goal is the
//! value that the search maximises: the load factor of first slip, or a reserve of friction (the least margin of a contact force to the boundary of
//! its friction cone, N).
//!
//! Normals jump at edges and corners, so derivatives on one side of an edge say nothing about the other side. An ascent may end with fingers at the
//! edge of their part (a triangle or segment). These fingers are then moved to an adjacent part: first each finger alone, then all of them together.
//! A further ascent starts from each of these design points and is kept if it ends at a larger value.

use super::ascent::{Ascent, AscentProblem, EvaluatedDesign};
use super::design_point::DesignPoint;
use crate::error::Error;
use crate::numerics::moved;
use crate::numerics::tolerances::NEGLIGIBLE;
use crate::prelude::*;

impl AscentProblem<'_> {
    /// Ascent from a start, continued on adjacent triangles or segments of surfaces as long as the value of the goal grows and steps are left.
    pub(super) fn over_edges(&self, design: EvaluatedDesign) -> Result<Ascent, Error> {
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
        for design_point in self.adjacent(&best.design_point) {
            if *steps >= self.design_space.question.steps() {
                break;
            }
            let Some(design) = self.evaluate(design_point)? else { continue };
            let next = self.ascend(design, *steps)?;
            *steps = next.steps;
            if next.design.value > best.value + NEGLIGIBLE * best.scale {
                return Ok(Some(next));
            }
        }
        Ok(None)
    }

    /// Design points (places and commanded normal forces of all contacts). In each, one contact at the edge of its part (triangle or segment) has
    /// moved to an adjacent part. If there are several such contacts, a further design point has all of them moved, each to its first adjacent part.
    fn adjacent(&self, from: &DesignPoint) -> Vec<DesignPoint> {
        let (mut design_points, mut all, mut move_at_once) = (Vec::new(), from.clone(), 0);
        for (contact, surface) in &self.design_space.question.surfaces {
            let Some(location) = &from.spots[*contact] else { continue };
            let others = location.adjacent(&surface.0);
            if let Some(first) = others.first() {
                all = self.design_space.with_location(&all, *contact, first.clone());
                move_at_once += 1;
            }
            design_points
                .extend(moved(others, &|other| self.design_space.with_location(from, *contact, other)));
        }
        if move_at_once > 1 {
            design_points.push(all);
        }
        design_points
    }
}
