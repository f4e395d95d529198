//! Prediction of first slip, and its exact derivatives.

use core::f64::consts::TAU;

use super::model::{NoSlip, Predicted, SlipToPredict};
use super::slip::Grown;
use super::unknown::{UnknownKind, carried_by};
use crate::error::Error;
use crate::load_path::{Onset, OnsetEvent, OnsetGradient, Ramp};
use crate::prelude::*;

/// The load factor or angle at first slip.
pub(super) fn predicted<const C: usize>(
    seen: &SlipToPredict<'_, C>,
) -> Result<Result<Predicted, NoSlip>, Error> {
    let onset = match seen.slip.grown() {
        Grown::Load(load) => seen.grasp.onset(Ramp::load(seen.base, load))?,
        Grown::Turn(turn) => {
            let around = turn.beside(seen.base).up_to(turn.angle().max(TAU));
            seen.grasp.onset_of_turn(around)?.onset
        }
    };
    Ok(match &onset {
        Onset::At(event) => {
            let exact = seen.derivatives.then(|| exact(seen, event)).flatten();
            Ok(Predicted { at: event.factor, exact })
        }
        Onset::GivesWay { factor, .. } => Ok(Predicted { at: *factor, exact: None }),
        Onset::Never => Err(NoSlip::HoldsTooWell("nothing slides however far it goes")),
        Onset::AlreadySliding(_) => Err(NoSlip::HoldsTooLittle("something slides already where it begins")),
        Onset::NoBase(_) => Err(NoSlip::HoldsTooLittle("nothing holds where it begins")),
        Onset::Undecided(_) => {
            Err(NoSlip::HoldsTooLittle("it is not known whether anything holds where it begins"))
        }
    })
}

/// Derivatives of the logarithm of the factor. If several contacts leave together, the mean of theirs: each is valid on one side of a kink.
fn exact<const C: usize>(seen: &SlipToPredict<'_, C>, event: &OnsetEvent<C>) -> Option<Vec<f64>> {
    let gradients = seen.grasp.sensitivity().onset_gradients(event);
    if gradients.is_empty() {
        return None;
    }
    let contacts = seen.grasp.contacts();
    let by_kind = |gradient: &OnsetGradient<C>, kind: UnknownKind, unknown: usize, value: f64| {
        let springs = |i: usize| contacts[i].stiffness.series();
        let of = |i: usize| match kind {
            UnknownKind::Friction => gradient.friction[i] * contacts[i].friction,
            UnknownKind::Stiffness => (1..C).map(|a| gradient.stiffness[i][a] * springs(i)[a]).sum::<f64>(),
            UnknownKind::Squeeze => gradient.command[i].dot(&contacts[i].command),
            UnknownKind::Carried => {
                let pressed = carried_by(&contacts[i], value);
                let by_base = pressed.components().iter().zip(&gradient.base_load);
                // A zero component of the load has no effect, even where its derivative is infinite.
                let by_base: f64 = by_base.filter(|(x, _)| **x != 0.0).map(|(x, by)| x * by).sum();
                gradient.command[i][0] * value / springs(i)[0] + by_base
            }
        };
        seen.contacts_of(unknown).map(of).sum::<f64>()
    };
    let presses = seen.is_pressed_by_commands();
    seen.by_unknowns(&|kind, unknown, value| {
        if kind == UnknownKind::Squeeze && !presses {
            return None;
        }
        // The squeeze of some contacts scales only their normal commands; the exact derivative includes tangential ones.
        let along = |i: usize| contacts[i].command.iter().skip(1).any(|x| *x != 0.0);
        if kind == UnknownKind::Squeeze
            && seen.asked.unknowns[unknown].contacts.is_some()
            && seen.contacts_of(unknown).any(along)
        {
            return None;
        }
        let sum: f64 = gradients.iter().map(|gradient| by_kind(gradient, kind, unknown, value)).sum();
        Some(sum / (gradients.len() as f64 * event.factor))
    })
}
