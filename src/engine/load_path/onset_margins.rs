//! The margins that vanish at an onset, and how its factor depends on the data, `dτ = -dm / m'`.

use nalgebra::SVector;

use super::onset::{OnsetEvent, StickingState};
use super::sensitivity::{Local, Parameter};
use crate::contact::tangential;
use crate::equilibrium::Cone;
use crate::grasp::{Engine, HandPart, Wrench};
use crate::prelude::*;
use crate::search::Settings;

/// The part of a grasp that leaves at an onset.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Leaver {
    /// A contact, from 0.
    Contact(usize),
    /// A drive of a hand.
    Drive(HandPart),
}

/// The margins that vanish at one onset, with the equilibrium there.
pub(crate) struct OnsetMargins<'g> {
    local: Local<'g>,
    margins: Vec<Margin>,
}

/// `μ F_n - h·F_t` of the leaving contact or drive, or `F_n` alone where friction is absent or unlimited.
struct Margin {
    leaver: Leaver,
    site: usize,
    h: Option<SVector<f64, 3>>,
    /// m' along the ramp.
    slope: f64,
}

impl<'g> OnsetMargins<'g> {
    /// `None` if the onset was reached after a contact had closed on the way or as one closes, or if the event has another number of
    /// contacts.
    pub(crate) fn new(grasp: &'g Engine, event: &OnsetEvent<3>) -> Option<Self> {
        let state = grasp.state_at_onset(event, &Settings::default())?;
        let local = Local::new(grasp, &state)?;
        let has_slipped = |i: usize| {
            let sticks = local.states[i].is_sticking() && !local.problem.local(i).is_frictionless();
            sticks && state.contacts[i].slip.norm() != 0.0
        };
        if (0..grasp.len()).any(has_slipped) {
            return None;
        }
        let StickingState { drive_rates, wrench_rate, leaving, .. } = &event.local;
        // A contact that slides as soon as it touches leaves at a gap, not at a margin.
        if leaving.iter().any(|&site| local.states[site].is_open()) {
            return None;
        }
        let rates = local.piece.solve(grasp.sites(), drive_rates, &wrench_rate.to()).ok()?;
        let mut margins = Vec::with_capacity(leaving.len());
        for &site in leaving {
            let Some(leaver) = grasp.leaver(site) else { continue };
            let Some(h) = facet(&local, event.cone, site) else { continue };
            let mut margin = Margin { leaver, site, h, slope: 1.0 };
            margin.slope = margin.of(&local, &rates.forces[site]);
            margins.push(margin);
        }
        Some(Self { local, margins })
    }

    /// The contacts and drives that leave.
    pub(crate) fn leavers(&self) -> impl Iterator<Item = Leaver> {
        self.margins.iter().map(|margin| margin.leaver)
    }

    /// The derivative, with respect to one datum, of the factor of each contact or drive that leaves. `None` where
    /// [`Sensitivity::of`](crate::ask::Sensitivity::of) has no derivative of the forces.
    pub(crate) fn by(&self, parameter: Parameter) -> Option<Vec<f64>> {
        let (_, forces) = self.local.derivative(parameter)?;
        let of_friction = |margin: &Margin| match parameter {
            Parameter::Friction { contact } if contact == margin.site && margin.h.is_some() => {
                self.local.forces[contact][0]
            }
            _ => 0.0,
        };
        Some(self.margins.iter().map(|m| self.moved(m, &forces, of_friction(m))).collect())
    }

    /// The derivative along an additional load, in proportion to it.
    pub(crate) fn by_load(&self, load: &Wrench<3>) -> Option<Vec<f64>> {
        let forces = self.local.forces_by_load(load)?;
        Some(self.margins.iter().map(|m| self.moved(m, &forces, 0.0)).collect())
    }

    fn moved(&self, margin: &Margin, forces: &[SVector<f64, 3>], direct: f64) -> f64 {
        -(margin.of(&self.local, &forces[margin.site]) + direct) / margin.slope
    }
}

impl Margin {
    fn of(&self, local: &Local, force: &SVector<f64, 3>) -> f64 {
        let cone = local.problem.local(self.site).cone();
        self.h.map_or(force[0], |h| cone.facet_margin(force, &h))
    }
}

/// The facet that is reached; inner `None` where only the normal force counts.
#[expect(clippy::option_option, reason = "there may be no facet to find, and none to look for")]
fn facet(local: &Local, cone: Cone, site: usize) -> Option<Option<SVector<f64, 3>>> {
    let (law, force) = (local.problem.local(site), &local.forces[site]);
    if !law.cone().has_edges() {
        return Some(None);
    }
    if cone == Cone::Round {
        return Some(Some(tangential(force).normalize()));
    }
    law.facets().iter().max_by(|a, b| a.dot(force).total_cmp(&b.dot(force))).map(|h| Some(*h))
}
