//! The end of a path followed in steps, where no further step is possible: a loss of equilibrium, or undecided. A leg is a section of the load
//! program.

use super::stepped_path::SteppedFollower;
use crate::contact::Law;
use crate::load_path::end_of_path::end_of_path;
use crate::load_path::event::{LossKind, PathEnd};
use crate::load_path::program_run::ProgramRun;
use crate::numerics::{Vector, chosen};
use crate::prelude::*;
use crate::search::{Doubt, SearchOutcome, settle};

impl<'g> SteppedFollower<'g> {
    /// The end of the path, if no step leads further. Equilibrium is lost if the object's speed, per unit of the fraction of the leg, grows without
    /// bound. It is also lost if the problem for the rates of forces and motion has no solution. Otherwise it is undecided whether the path
    /// continues, for the reason `doubt`.
    pub(super) fn end_here(&self, run: &ProgramRun<'g>, doubt: Doubt) -> PathEnd<3> {
        let fraction = self.present.fraction;
        let edge = self.present.edge(run);
        let leaves = |i: &usize| matches!(edge.rates.laws[*i], Law::Edge(_) | Law::Cone { .. });
        let leaving = chosen(edge.rates.len(), &leaves);
        if self.pace.speeds.grow_without_bound_at(fraction) {
            // The limit on `changed` distinguishes a maximum of the load from an asymptote, i.e. a load that the path only approaches. Near a maximum
            // contact forces keep changing; towards an asymptote they become constant while the object moves. `changed` is the largest change of a
            // force in the last step, divided by the change that the motion would cause if all contacts stuck. Before maxima `changed` is some
            // hundredths, at least a thousandth; towards asymptotes it falls to about 1e-5. The limit lies between these numbers.
            let kind = if self.pace.changed < 2e-4 { LossKind::Asymptote } else { LossKind::Fold };
            let motion = self.pace.rate.as_ref().map(Vector::normalize);
            return PathEnd::Lost(Box::new(run.loss(fraction, kind, leaving, motion.as_ref())));
        }
        match settle(&edge.rates, &run.settings) {
            (SearchOutcome::Found(..) | SearchOutcome::Undecided(_), _) => run.undecided(fraction, doubt),
            (nothing, effort) => {
                let loss = run.loss(fraction, LossKind::Corner, leaving, None);
                end_of_path(&edge, (nothing, &effort), loss, &run.settings)
            }
        }
    }
}
