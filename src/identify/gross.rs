//! Prediction of gross slip, the loss of the object.

use core::f64::consts::TAU;

use super::leaving::GrossSlip;
use super::model::{NoSlip, Predicted, SlipToPredict};
use super::slip::Grown;
use crate::error::Error;
use crate::grasp::Motion;
use crate::load_path::{Leg, PathEnd};

/// The load factor or angle at gross slip.
pub(super) fn predicted<const C: usize>(
    seen: &SlipToPredict<'_, C>,
) -> Result<Result<Predicted, NoSlip>, Error> {
    let (start, leg, most) = match &seen.slip.grown {
        Grown::Load(load) => {
            let most = seen.grasp.settings().most_load.max(1.0);
            (seen.base, Leg::load_by(*load * most), most)
        }
        Grown::Turn(turn) => {
            let most = turn.angle().max(TAU);
            let around = turn.beside(seen.base).up_to(most);
            (around.load_at(0.0), Leg::turn(&around), most)
        }
    };
    let mut path = seen.grasp.follow(&start, &[leg])?;
    path.by_ref().for_each(drop);
    Ok(match path.end() {
        Some(PathEnd::Lost(loss)) => {
            let at = loss.fraction * most;
            let is_one_object = |motion: &&Motion<C>| motion.bodies.is_empty() && motion.joints.is_empty();
            let is_steady = seen.derivatives && loss.drives.is_empty() && loss.jumped.is_empty();
            let motion = loss.motion.as_ref().filter(|_| is_steady).filter(is_one_object);
            let leaving =
                motion.and_then(|motion| GrossSlip::from_end(seen, at, &motion.object, &path.forces()));
            Ok(Predicted { at, exact: leaving.and_then(|leaving| leaving.derivatives()) })
        }
        Some(PathEnd::Completed) => Err(NoSlip::HoldsTooWell("it is not lost as far as it was followed")),
        Some(PathEnd::NoStart(_)) => Err(NoSlip::HoldsTooLittle("nothing holds where it begins")),
        Some(PathEnd::Undecided { .. }) | None => {
            Err(NoSlip::HoldsTooWell("it is not known where it is lost"))
        }
    })
}
