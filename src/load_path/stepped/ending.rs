//! How a path in steps ends where no step leads on.

use super::stepped_path::Steps;
use crate::contact::Law;
use crate::load_path::event::{LossKind, PathEnd};
use crate::load_path::journey::Journey;
use crate::load_path::loss::end_of_path;
use crate::search::{Doubt, Settled, settle};

impl<'g, const D: usize, const C: usize> Steps<'g, D, C> {
    /// The end where no step leads on: the motion tells it, or the proof that nothing balances the rates of what stands on an edge. Else the path is
    /// undecided, for this reason.
    pub(super) fn end_here(&self, journey: &Journey<'g, D, C>, doubt: Doubt) -> PathEnd<D, C> {
        let fraction = self.standing.fraction;
        let edge = self.standing.edge(journey);
        let leaves = |i: &usize| matches!(edge.rates.laws[*i], Law::Edge(_) | Law::Cone { .. });
        let leaving = (0..edge.rates.len()).filter(leaves).collect();
        if let Some(kind) = self.pace.speeds.run_to(fraction) {
            let motion = self.pace.rate.map(|v| journey.grasp.outside(&v.normalize()));
            return PathEnd::Lost(journey.loss(fraction, kind, leaving, motion));
        }
        match settle(&edge.rates, &journey.settings) {
            (Settled::Found(..) | Settled::Undecided(_), _) => journey.undecided(fraction, doubt),
            (nothing, effort) => {
                let loss = journey.loss(fraction, LossKind::Corner, leaving, None);
                end_of_path(&edge, (nothing, &effort), loss, &journey.settings)
            }
        }
    }
}
