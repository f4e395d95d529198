//! How a path in steps ends where no step leads on.

use nalgebra::SVector;

use super::one_step::Standing;
use super::stepped_path::{Step, SteppedPath};
use crate::contact::{Law, Line, ZERO_SLACK};
use crate::load_path::event::{Loss, LossKind, PathEnd};
use crate::load_path::loss::leaving_motion;
use crate::object::Problem;
use crate::search::{Doubt, Settled, settle};

/// Friction in reserve, and forces that a gap would take to close, below this part of the largest force are none: the last steps are parts of
/// 1e-12 of a leg. With less a contact that such a step would bring to its edge still holds, and the limit is not seen.
const AT_AN_EDGE: f64 = 1e-9;

impl<const D: usize, const C: usize> SteppedPath<'_, D, C> {
    /// Ends the path where it stands: at a limit, if what happens there can be told, else undecided for this reason.
    pub(super) fn give_up(&mut self, at: Standing<D, C>, doubt: Doubt) -> Option<Step<D, C>> {
        let (leg, fraction) = (self.program.leg, at.fraction);
        let lost = if doubt == Doubt::OnTheBoundary { self.loss(&at) } else { None };
        self.standing = Some(at);
        self.end = Some(lost.map_or(PathEnd::Undecided { leg, fraction, doubt }, PathEnd::Lost));
        None
    }

    /// The loss where no step leads on: the motion tells it, or the proof that nothing balances the rates of what stands on an edge.
    fn loss(&self, at: &Standing<D, C>) -> Option<Loss<D, C>> {
        let rates = self.rates(at);
        let (kind, motion) = match self.pace.speeds.run_to(at.fraction) {
            Some(kind) => (kind, self.pace.rate.map(|v| v.normalize())),
            None => match settle(&rates, &self.settings).0 {
                Settled::Found(..) | Settled::Undecided(_) => return None,
                Settled::FreeMotion(v) => (LossKind::GivesWay, Some(v)),
                Settled::Separating(_) | Settled::NoneOf(_) | Settled::Contradicted { .. } => {
                    let load = self.course.at(at.fraction);
                    (LossKind::Corner, leaving_motion(&rates, &load, &rates.yielding()))
                }
            },
        };
        let leaves = |i: &usize| matches!(rates.laws[*i], Law::Edge(_) | Law::Cone { .. });
        Some(Loss {
            leg: self.program.leg,
            fraction: at.fraction,
            load: self.program.load_at(at.fraction),
            kind,
            contacts: (0..rates.len()).filter(leaves).collect(),
            drives: Vec::new(),
            motion: motion.map(|v| self.grasp.outside(&v)),
        })
    }

    /// The problem of the rates, with edges as near as the last steps can tell.
    fn rates(&self, at: &Standing<D, C>) -> Problem<'_, D, C> {
        let largest = at.largest_force();
        let near = largest * (AT_AN_EDGE / ZERO_SLACK);
        let law = |i: usize| {
            let (local, state) = (self.problem.local(i), &at.states[i]);
            let line = Line { force: at.forces[i], rate: SVector::zeros(), force_size: near, rate_size: 0.0 };
            let mut stand = local.stand(&line);
            if state.is_open() {
                let [base, change] = &self.drives;
                let drive = base[i] + change[i] * at.fraction - at.slips[i];
                let gap = -self.problem.sites[i].stretch(&drive, &at.twist)[0];
                stand.apex = local.springs.force_along(0, gap) <= AT_AN_EDGE * largest;
            }
            local.law_of_rates(&stand, state)
        };
        let laws = (0..self.problem.len()).map(law).collect();
        self.problem.at_rates(laws, self.drives[1].clone(), self.course.rate_at(at.fraction))
    }
}
