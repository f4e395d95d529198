//! The brief verdict on a load that is put on in the coordinates of slips.

use super::verdict::{FirstSlip, Holding, Verdict};
use crate::grasp::{Engine, WholeContacts};
use crate::load_path::{InSlips, Ramp, SlipEnd};
use crate::numerics::tolerances::NEGLIGIBLE;
use crate::prelude::*;
use crate::search::Settings;

impl Engine {
    /// A brief verdict from the slips of the contacts; `None` where a path has to follow the load.
    pub(super) fn held_in_slips(&self, ramp: &Ramp<3>, settings: &Settings) -> Option<(Verdict<3>, f64)> {
        let InSlips { slid, all_slide, factor, end, farthest } =
            self.in_slips(ramp, settings.most_load.max(1.0), settings)?;
        let (contact, first) = *slid.first()?;
        // Nearer to the whole load rounding would decide.
        let is_clear = |factor: f64| (factor - 1.0).abs() > NEGLIGIBLE;
        if !(is_clear(first) && (is_clear(factor) || matches!(end, SlipEnd::Held))) {
            return None;
        }
        let parts = WholeContacts::of(self.contacts());
        let (open, would_pull, give_way) = (Vec::new(), Vec::new(), Vec::new());
        let slide = parts.with(&|i| i == contact);
        let lost = match &end {
            SlipEnd::Held => None,
            SlipEnd::TooFar(motion) => {
                Some(self.gone_too_far(factor, &self.too_far(motion)?, None, all_slide.is_some()))
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
            lost,
            state: None,
        };
        Some((verdict, farthest))
    }
}
