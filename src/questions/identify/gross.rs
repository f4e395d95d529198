//! Predicts gross slip with a model of the grasp: the event at which the object is lost. The object then slides at all contacts, tips over or leaves
//! in another way. An observation is a load, or the angle of a turning load, at which slip was observed. The load factor is a multiple of the
//! observed load. The derivatives of the load factor with respect to the parameters that are sought, such as coefficients of friction, are computed,
//! too.
//!
//! In an experiment an object is seen to slip as soon as it leaves, even if a gap closes afterwards and the load path continues. The gross slip that
//! the model predicts is therefore the first event of the load path at which the object leaves.

use core::f64::consts::TAU;

use nalgebra::SVector;

use super::leaving::GrossSlip;
use super::model::{Predicted, PredictionFailure, SlipToPredict};
use super::slip::SlipLoad;
use crate::error::Error;
use crate::grasp::{Motion, Twist};
use crate::load_path::{Leg, PathEnd};
use crate::numerics::mapped;
use crate::prelude::*;

/// The load factor or angle, rad, at which the model predicts gross slip for one observation. Derivatives with respect to the parameters are computed
/// if asked for. The inner error is the reason why no slip is predicted.
pub(super) fn predicted(target: &SlipToPredict<'_>) -> Result<Result<Predicted, PredictionFailure>, Error> {
    let (start, leg, most) = match target.slip.growing_load() {
        SlipLoad::Load(load) => {
            let most = target.grasp.settings().most_load.max(1.0);
            (target.base, Leg::load_by(load * most), most)
        }
        SlipLoad::Turn(turn) => {
            let most = turn.angle().max(TAU);
            let around = turn.beside(target.base).up_to(most);
            (around.load_at(0.0), Leg::turn(&around), most)
        }
    };
    let mut path = target.grasp.follow(start, &[leg])?;
    let prediction = |at: f64, motion: Option<&Twist<3>>, forces: &[SVector<f64, 3>]| {
        let motion = motion.filter(|_| target.derivatives);
        let leaving = motion.and_then(|motion| GrossSlip::from_end(target, at, motion, forces));
        Predicted { at, exact: leaving.and_then(|leaving| leaving.derivatives()) }
    };
    for event in path.by_ref() {
        let Some(jump) = event.jump.filter(|jump| !jump.reaches.is_empty()) else { continue };
        let forces: Vec<_> = mapped(&event.state.contacts, &|contact| contact.force);
        let motion = match &jump.moved[..] {
            [object] if event.drives.is_empty() => Some(&object.twist),
            _ => None,
        };
        return Ok(Ok(prediction(event.fraction * most, motion, &forces)));
    }
    Ok(match path.end() {
        Some(PathEnd::Lost(loss)) => {
            let is_one_object = |motion: &&Motion<3>| motion.bodies.is_empty() && motion.joints.is_empty();
            let is_steady = loss.drives.is_empty() && loss.jumped.is_empty();
            let motion = loss.motion.as_ref().filter(|_| is_steady).filter(is_one_object);
            Ok(prediction(loss.fraction * most, motion.map(|motion| &motion.object), &path.forces()))
        }
        Some(PathEnd::Completed) => {
            Err(PredictionFailure::HoldsTooWell("it is not lost as far as it was followed"))
        }
        Some(PathEnd::NoStart(_)) => Err(PredictionFailure::HoldsTooLittle("nothing holds where it begins")),
        Some(PathEnd::Undecided { .. }) | None => {
            Err(PredictionFailure::HoldsTooWell("it is not known where it is lost"))
        }
    })
}
