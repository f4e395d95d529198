//! The model of a grasp for trial values of the parameters: the loads at which it predicts slip, and their derivatives. A parameter is
//! a number of the grasp that is sought, such as a coefficient of friction. An observation ([`Slip`]) is a load or angle at which slip was observed.
//! A known sum is a sum of parameters that is known from another measurement. A carried force is the normal force of a contact before the load of an
//! observation grows. The load factor is a multiple of the observed load. The squeeze is everything by which contacts press at rest without a load.

use nalgebra::DMatrix;

use super::question::Identify;
use super::slip::{Slip, SlipKind, SlipLoad};
use super::tolerances::INDISTINCT;
use super::unknown::UnknownKind;
use super::{first, gross};
use crate::ask::Grasp;
use crate::error::Error;
use crate::grasp::Wrench;
use crate::numerics::{IntoList, chosen, every_index, mapped, summed};
use crate::prelude::*;
use crate::sweep::map_in_order;

/// Step of a central difference in the logarithm of a parameter. Truncation and rounding then both cause relative errors of some 1e-8.
const LOGARITHM_STEP: f64 = 1e-4;

/// The model: the question [`Identify`], with a grasp for each layout (arrangement of the contact points) in which slip was observed.
pub(super) struct Model<'a> {
    pub(super) layouts: &'a [Grasp<3>],
    pub(super) asked: &'a Identify<3>,
}

/// The grasp of one layout (arrangement of the contact points) with trial values of the parameters. `base` is the constant load that balances the
/// carried forces among the parameters.
pub(super) struct LayoutGuess {
    pub(super) grasp: Grasp<3>,
    pub(super) base: Wrench<3>,
}

/// The reason why the model predicts no slip for an observation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum PredictionFailure {
    /// The grasp holds however far the load grows: friction, or the squeeze, is too large for the observed load. The text is the reason as a clause.
    HoldsTooWell(&'static str),
    /// A contact slides, or the object is lost, before the load grows: friction, or the squeeze, is too small. The text is the reason as a clause.
    HoldsTooLittle(&'static str),
}

impl PredictionFailure {
    /// The reason as a clause of a sentence.
    pub(super) fn says(self) -> &'static str {
        match self {
            Self::HoldsTooWell(says) | Self::HoldsTooLittle(says) => says,
        }
    }
}

/// The load factor or angle at which the model predicts slip, with derivatives.
#[derive(Clone)]
pub(super) struct Predicted {
    /// The load factor, or the angle of a turning load, rad.
    pub(super) at: f64,
    /// The derivatives of the logarithm of `at` with respect to the logarithms of the parameters, if exact derivatives are known.
    pub(super) exact: Option<Vec<f64>>,
}

/// The residuals of all observations and known sums, and their derivatives, for one set of values of the parameters.
#[derive(Clone)]
pub(super) struct Linear {
    /// Logarithm of the observed over the predicted value, for each observation and then for each known sum of parameters.
    pub(super) residuals: Vec<f64>,
    /// Derivatives of the logarithm of the predicted value with respect to the logarithms of the parameters, one row for each residual.
    pub(super) jacobian: DMatrix<f64>,
    /// Number of observations without exact derivatives. Their derivatives are difference quotients of predictions.
    pub(super) by_differences: usize,
}

impl Model<'_> {
    /// The grasps of all layouts with the parameters whose logarithms are `logs`, each with the constant load that balances the carried forces
    /// sought.
    pub(super) fn at(&self, logs: &[f64]) -> Result<Vec<LayoutGuess>, Error> {
        let mut guesses = Vec::with_capacity(self.layouts.len());
        for (layout, grasp) in self.layouts.iter().enumerate() {
            let (mut contacts, mut base) = (grasp.contacts().to_vec(), Wrench::ZERO);
            let mut squeeze = 1.0;
            for (unknown, log) in self.asked.unknowns.iter().zip(logs) {
                if !unknown.is_in(layout) {
                    continue;
                }
                unknown.put(layout, log.exp(), &mut contacts, &mut base);
                if unknown.kind == UnknownKind::Squeeze && unknown.contacts.is_none() {
                    squeeze = log.exp();
                }
            }
            let mut grasp = grasp.with_contacts(contacts)?.installed_again()?;
            if squeeze != 1.0 {
                grasp = grasp.squeezed(squeeze)?;
            }
            guesses.push(LayoutGuess { grasp, base });
        }
        Ok(guesses)
    }

    /// The residuals of all observations and known sums. The inner error holds the index, from 0, of the first observation in the list for which the
    /// model predicts no slip, and the reason.
    pub(super) fn residuals(
        &self,
        logs: &[f64],
    ) -> Result<Result<Vec<f64>, (usize, PredictionFailure)>, Error> {
        Ok(self.predicted(logs, false)?.map(|all| self.log_residuals(logs, &all)))
    }

    /// The residuals of all observations and known sums, and their derivatives. The inner error holds the index, from 0, of the first observation in
    /// the list for which the model predicts no slip, and the reason.
    pub(super) fn linear(&self, logs: &[f64]) -> Result<Result<Linear, (usize, PredictionFailure)>, Error> {
        let all = match self.predicted(logs, true)? {
            Ok(all) => all,
            Err(none) => return Ok(Err(none)),
        };
        let (slips, knowns, columns) = (all.len(), self.asked.known.len(), logs.len());
        let mut jacobian = DMatrix::zeros(slips + knowns, columns);
        let unknown: Vec<_> = chosen(slips, &|k| all[*k].exact.is_none());
        for (k, prediction) in all.iter().enumerate() {
            let Some(exact) = &prediction.exact else { continue };
            for j in 0..columns {
                jacobian[(k, j)] = exact[j];
            }
        }
        if !unknown.is_empty() {
            for column in 0..columns {
                let differences = self.differences(logs, column, &unknown, &all)?;
                for (k, value) in unknown.iter().zip(differences) {
                    jacobian[(*k, column)] = value;
                }
            }
        }
        for (k, known) in self.asked.known.iter().enumerate() {
            let sum: f64 = summed(&known.unknowns, &|j| logs[*j].exp());
            for j in &known.unknowns {
                jacobian[(slips + k, *j)] = logs[*j].exp() / sum;
            }
        }
        // Small difference quotients may be mere rounding, and are set to zero. Otherwise a prediction would seem to depend on parameters on which it
        // does not.
        jacobian.apply(|x| *x = if x.abs() > INDISTINCT { *x } else { 0.0 });
        Ok(Ok(Linear { residuals: self.log_residuals(logs, &all), jacobian, by_differences: unknown.len() }))
    }

    /// Derivatives, by central differences, of the logarithms of predicted loads with respect to the logarithm of parameter number `column`. `those`
    /// are the indices of the observations. If the model predicts no slip for one of the two changed values, the difference is one-sided. If it
    /// predicts none for both, the derivative is zero.
    fn differences(
        &self,
        logs: &[f64],
        column: usize,
        those: &[usize],
        middle: &[Predicted],
    ) -> Result<Vec<f64>, Error> {
        let beside = |by: f64| {
            let mut logs = logs.to_vec();
            logs[column] += by;
            let layouts = self.at(&logs)?;
            let prediction = self.slips(those, &layouts, false, &logs);
            let mut all = Vec::with_capacity(prediction.len());
            for prediction in prediction {
                all.push(prediction?);
            }
            Ok::<_, Error>(all)
        };
        let (up, down) = (beside(LOGARITHM_STEP)?, beside(-LOGARITHM_STEP)?);
        let difference = |((up, down), k): ((Result<Predicted, _>, Result<Predicted, _>), &usize)| {
            let here = middle[*k].at;
            match (up, down) {
                (Ok(up), Ok(down)) => (up.at / down.at).ln() / (2.0 * LOGARITHM_STEP),
                (Ok(up), Err(_)) => (up.at / here).ln() / LOGARITHM_STEP,
                (Err(_), Ok(down)) => (here / down.at).ln() / LOGARITHM_STEP,
                (Err(_), Err(_)) => 0.0,
            }
        };
        Ok(up.into_iter().zip(down).zip(those).map(difference).list())
    }

    /// Logarithm of the observed over the predicted value, for each observation and then for each known sum of parameters.
    fn log_residuals(&self, logs: &[f64], all: &[Predicted]) -> Vec<f64> {
        let slips = self
            .asked
            .slips
            .iter()
            .zip(all)
            .map(|(slip, prediction)| (slip.observed_at() / prediction.at).ln());
        let knowns = self.asked.known.iter().map(|known| {
            let sum: f64 = summed(&known.unknowns, &|j| logs[*j].exp());
            (known.value / sum).ln()
        });
        slips.chain(knowns).list()
    }

    fn predicted(
        &self,
        logs: &[f64],
        derivatives: bool,
    ) -> Result<Result<Vec<Predicted>, (usize, PredictionFailure)>, Error> {
        let layouts = self.at(logs)?;
        let numbers: Vec<_> = (0..self.asked.slips.len()).list();
        let prediction = self.slips(&numbers, &layouts, derivatives, logs);
        let mut all = Vec::with_capacity(prediction.len());
        for (k, prediction) in prediction.into_iter().enumerate() {
            match prediction? {
                Ok(predicted) => all.push(predicted),
                Err(why) => return Ok(Err((k, why))),
            }
        }
        Ok(Ok(all))
    }

    /// Predicts slip for the observations with the indices `those`, on all cores. Observations under the same conditions are predicted once.
    fn slips(
        &self,
        those: &[usize],
        layouts: &[LayoutGuess],
        derivatives: bool,
        logs: &[f64],
    ) -> Vec<Result<Result<Predicted, PredictionFailure>, Error>> {
        let slips = &self.asked.slips;
        let mut distinct: Vec<usize> = Vec::new();
        let mut alike = Vec::with_capacity(those.len());
        for k in those {
            let known = distinct.iter().position(|other| slips[*other].is_like(&slips[*k]));
            alike.push(known.unwrap_or(distinct.len()));
            if known.is_none() {
                distinct.push(*k);
            }
        }
        let prediction = map_in_order(&distinct, |k| self.slip(layouts, *k, derivatives, logs));
        mapped(&alike, &|place| prediction[*place].clone())
    }

    /// Predicts slip for one observation: its load factor or angle, with derivatives if asked for. The inner error is the reason why none is
    /// predicted.
    fn slip(
        &self,
        layouts: &[LayoutGuess],
        number: usize,
        derivatives: bool,
        logs: &[f64],
    ) -> Result<Result<Predicted, PredictionFailure>, Error> {
        let slip = &self.asked.slips[number];
        let LayoutGuess { grasp, base } = &layouts[slip.layout()];
        let squeezed;
        let grasp = if slip.squeeze() == 1.0 {
            grasp
        } else {
            squeezed = grasp.squeezed(slip.squeeze())?;
            &squeezed
        };
        let target =
            SlipToPredict { grasp, base: *base + slip.base(), slip, asked: self.asked, logs, derivatives };
        let prediction = match slip.kind {
            SlipKind::First => first::predicted(&target)?,
            SlipKind::Gross => gross::predicted(&target)?,
        };
        Ok(prediction.and_then(|prediction| {
            if prediction.at > 0.0 {
                Ok(prediction)
            } else {
                Err(PredictionFailure::HoldsTooLittle("something slides before anything pulls"))
            }
        }))
    }
}

/// The data for the prediction of one observation: the grasp with trial values of the parameters (their logarithms are `logs`), loads and question.
pub(super) struct SlipToPredict<'a> {
    pub(super) grasp: &'a Grasp<3>,
    /// The constant loads that act before the observed load grows.
    pub(super) base: Wrench<3>,
    pub(super) slip: &'a Slip<3>,
    pub(super) asked: &'a Identify<3>,
    pub(super) logs: &'a [f64],
    /// Whether the prediction includes derivatives with respect to the parameters.
    pub(super) derivatives: bool,
}

impl SlipToPredict<'_> {
    /// The total load at this load factor; for a turning load, at this angle, rad.
    pub(super) fn load_at(&self, at: f64) -> Wrench<3> {
        match self.slip.growing_load() {
            SlipLoad::Load(load) => self.base + load * at,
            SlipLoad::Turn(turn) => self.base + turn.load_at(at),
        }
    }

    /// The derivative of the total load with respect to the load factor; for a turning load, with respect to the angle.
    pub(super) fn load_rate(&self, at: f64) -> Wrench<3> {
        match self.slip.growing_load() {
            SlipLoad::Load(load) => load,
            SlipLoad::Turn(turn) => {
                let ([_, cosine, sine], (sin, cos)) = (turn.parts(), at.sin_cos());
                sine * cos - cosine * sin
            }
        }
    }

    /// The contact points to which the parameter with this index belongs, in the layout (arrangement of the contact points) of this observation.
    pub(super) fn contacts_of(&self, unknown: usize) -> impl Iterator<Item = usize> {
        let (unknown, layout) = (&self.asked.unknowns[unknown], self.slip.layout());
        (0..self.grasp.len()).filter(move |i| unknown.is_of(layout, *i))
    }

    /// The derivatives of the logarithm of a predicted load factor or angle with respect to the logarithms of all parameters, in order. `by` returns
    /// the derivative with respect to one parameter, given its kind (friction, carried force, squeeze or stiffness), index and value. The derivatives
    /// with respect to parameters of other layouts are zero. `None` if one derivative is not known or not finite.
    pub(super) fn by_unknowns(
        &self,
        by: &dyn Fn(UnknownKind, usize, f64) -> Option<f64>,
    ) -> Option<Vec<f64>> {
        let mut all = Vec::with_capacity(self.logs.len());
        for (j, log) in self.logs.iter().enumerate() {
            let unknown = &self.asked.unknowns[j];
            let is_in = unknown.is_in(self.slip.layout());
            let value = if is_in { by(unknown.kind, j, log.exp())? } else { 0.0 };
            if !value.is_finite() {
                return None;
            }
            all.push(value);
        }
        Some(all)
    }

    /// Whether the squeeze is due to commands of contacts alone, not to given forces, tensions, joints or a vacuum. Only then are exact derivatives
    /// with respect to a factor on the squeeze known, and those of the load of gross slip.
    pub(super) fn is_pressed_by_commands(&self) -> bool {
        let grasp = self.grasp;
        grasp.joint_commands().is_empty()
            && every_index(grasp.len(), &|i| {
                let contact = &grasp.contacts()[i];
                contact.force.is_none() && contact.at_rest.is_none() && contact.suction == 0.0
            })
    }
}
