//! Predicts first slip with a model of the grasp: the event at which the first contact ceases to stick as the load grows. An observation is a load,
//! or the angle of a turning load, at which slip was observed. The load factor is a multiple of the observed load. The derivatives of the load factor
//! of first slip with respect to the parameters that are sought, such as coefficients of friction, are exact.

use crate::numerics::{IntoList, numbered};
use core::f64::consts::TAU;

use super::model::{Predicted, PredictionFailure, SlipToPredict};
use super::slip::SlipLoad;
use super::unknown::{UnknownKind, carried_by};
use crate::error::Error;
use crate::load_path::{Onset, OnsetEvent, OnsetMargins, Parameter, Ramp};
use crate::prelude::*;

/// The load factor or angle, rad, at which the model predicts first slip for one observation. Derivatives with respect to the parameters are computed
/// if asked for. The inner error is the reason why no slip is predicted.
pub(super) fn predicted(target: &SlipToPredict<'_>) -> Result<Result<Predicted, PredictionFailure>, Error> {
    let onset = match target.slip.growing_load() {
        SlipLoad::Load(load) => target.grasp.onset(Ramp::load(target.base, load))?,
        SlipLoad::Turn(turn) => {
            let around = turn.beside(target.base).up_to(turn.angle().max(TAU));
            target.grasp.onset_of_turn(around)?.onset
        }
    };
    Ok(match &onset {
        Onset::At(event) => {
            let exact = target.derivatives.then(|| exact(target, event)).flatten();
            Ok(Predicted { at: event.factor, exact })
        }
        Onset::GivesWay { factor, .. } => Ok(Predicted { at: *factor, exact: None }),
        Onset::Never => Err(PredictionFailure::HoldsTooWell("nothing slides however far it goes")),
        Onset::AlreadySliding(_) => {
            Err(PredictionFailure::HoldsTooLittle("something slides already where it begins"))
        }
        Onset::NoBase(_) => Err(PredictionFailure::HoldsTooLittle("nothing holds where it begins")),
        Onset::Undecided(_) => {
            Err(PredictionFailure::HoldsTooLittle("it is not known whether anything holds where it begins"))
        }
    })
}

/// Derivatives of the logarithm of the load factor of first slip with respect to the logarithms of the parameters. If several contacts slip together,
/// the factor has a kink, and the mean of the contacts' derivatives is returned. `None` if an exact derivative is not known.
fn exact(target: &SlipToPredict<'_>, event: &OnsetEvent<3>) -> Option<Vec<f64>> {
    let margins = OnsetMargins::new(&target.grasp.engine, event)?;
    let space = target.grasp.engine.space();
    let axes = space.axes();
    let leavers = margins.leavers().len();
    let contacts = target.grasp.contacts();
    // The data of one contact that change with a parameter of this kind, each with its derivative with respect to the logarithm of the parameter.
    let changes = |kind: UnknownKind, contact: usize, value: f64| -> Vec<(Parameter, f64)> {
        let data = &contacts[contact];
        let springs = data.stiffness.series();
        let along = |axis: usize| Parameter::Command { contact, axis };
        match kind {
            UnknownKind::Friction => vec![(Parameter::Friction { contact }, data.friction)],
            UnknownKind::Stiffness => {
                (1..axes).map(|axis| (Parameter::Stiffness { contact, axis }, springs[axis])).list()
            }
            UnknownKind::Squeeze => numbered(axes, &|axis| (along(axis), data.command[axis])),
            UnknownKind::Carried => {
                let pressed = carried_by(data, value).coordinates(space);
                let of_load = |component| (Parameter::Load { component }, pressed[component]);
                let mut changes = numbered(space.of_the_object(), &of_load);
                changes.push((along(0), value / springs[0]));
                changes
            }
        }
    };
    let presses = target.is_pressed_by_commands();
    target.by_unknowns(&|kind, unknown, value| {
        if kind == UnknownKind::Squeeze && !presses {
            return None;
        }
        let mut sum = 0.0;
        for contact in target.contacts_of(unknown) {
            for (parameter, change) in changes(kind, contact, value) {
                // A load component that is zero stays zero. It is skipped, because a derivative with respect to it may be infinite.
                if change != 0.0 {
                    sum += change * margins.by(parameter)?.iter().sum::<f64>();
                }
            }
        }
        Some(sum / (leavers as f64 * event.factor))
    })
}
