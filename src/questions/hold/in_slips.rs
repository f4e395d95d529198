//! The fast way to a brief verdict (one without equilibria and proofs). The load path is computed with the slips of the sliding contacts as its only
//! unknowns ([`InSlips`]). Unlike on the full load path, contact states are not searched for at each event. The load factor is the multiple of the
//! growing load that acts; 1 is the whole load. At first slip the first contact ceases to stick.

use nalgebra::SVector;

use super::applied_load::PathFacts;
use super::verdict::{FirstSlip, Holding, Verdict};
use crate::grasp::Engine;
use crate::load_path::{InSlips, Ramp, SlipEnd};
use crate::numerics::paired;
use crate::numerics::tolerances::NEGLIGIBLE;
use crate::prelude::*;
use crate::search::Settings;

impl Engine {
    /// The brief verdict (without equilibria and proofs) from a path with the slips of contacts as unknowns. In these cases it returns `None`, and
    /// the caller follows the full load path: a contact opens or stops sliding, no contact slides, or the grasp buckles. `None` also if rounding
    /// could change the verdict, because the load factor of first slip or of the end of the path is 1 up to rounding.
    pub(super) fn held_in_slips(
        &self,
        ramp: &Ramp<3>,
        settings: &Settings,
    ) -> Option<(Verdict<3>, PathFacts)> {
        let InSlips { slid, all_slide, factor, end, forces, farthest } =
            self.in_slips(ramp, settings.most_load.max(1.0), settings)?;
        let (contact, first) = *slid.first()?;
        // A load factor closer to 1 than this equals the whole load up to rounding. Rounding would then decide whether the load is held.
        let is_clear = |factor: f64| (factor - 1.0).abs() > NEGLIGIBLE;
        if !(is_clear(first) && (is_clear(factor) || matches!(end, SlipEnd::Held))) {
            return None;
        }
        // If the grasp buckles, only the full load path gives the load at which it buckles.
        let buckles = |(forces, factor): (&Vec<SVector<f64, 3>>, f64)| {
            let forces = paired(self.sites(), forces, &|(site, force)| site.frame * force);
            let load = ramp.load_at(factor);
            self.may_buckle(&load) && self.buckles(&forces, &|_| false, &load)
        };
        if forces.iter().zip([0.0, factor]).any(buckles) {
            return None;
        }
        let parts = self.wholes();
        let (open, would_pull, give_way) = (Vec::new(), Vec::new(), Vec::new());
        let slide = parts.with(&|i| i == contact);
        let lost = match &end {
            SlipEnd::Held => None,
            SlipEnd::TooFar(motion) => {
                Some(self.gone_too_far(factor, &self.too_far(motion), None, all_slide))
            }
            SlipEnd::Lost(loss) => Some(self.lost(factor, loss, None)),
        };
        let holding = match lost {
            Some(_) if factor < 1.0 => Holding::Lost,
            _ if first > 1.0 => Holding::Sticks,
            _ => Holding::Slides {
                contacts: parts.with(&|i| slid.iter().any(|(k, from)| *k == i && *from < 1.0)),
            },
        };
        let verdict = Verdict {
            base: ramp.base,
            load: ramp.direction,
            holding,
            first_slip: Some(FirstSlip { factor: first, slide, open, would_pull, give_way }),
            caught: Vec::new(),
            held_to: factor,
            everything_slides: all_slide,
            left_out: None,
            swing: None,
            lost,
            state: None,
        };
        Some((verdict, PathFacts { farthest, ..Default::default() }))
    }
}
