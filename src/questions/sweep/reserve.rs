//! The reserve: the load up to which all contacts of a grasp with uncertain data keep sticking, with a probability that is given as a number of
//! standard deviations. The base load acts before the load grows.

use super::interaction::PerturbedGrasp;
use super::source_forces::{source_forces, unit};
use super::stuck_grasp::StuckGrasp;
use super::uncertainty::Uncertainty;
use crate::contact::State;
use crate::equilibrium::{Cone, Outcome, Settings, StickingResponse};
use crate::error::Error;
use crate::grasp::{Engine, Wrench, face_of_struct, inside, same_on_both_sides};
use crate::numerics::{Vector, numbered};
use crate::prelude::*;

/// The loads up to which all contacts of a grasp keep sticking with s standard deviations in reserve. The probability that any contact ceases to
/// stick is at most Φ(-s), with the normal distribution Φ. A load of any direction is added to one base load.
/// [`Grasp::reserve`](crate::ask::Grasp::reserve) returns this type.
#[derive(Debug, Clone)]
pub struct Reserve<const C: usize> {
    rest: BaseState,
    sigmas: f64,
}

/// The behaviour of the grasp under the base load: no contact slides, some contact slides or no equilibrium exists, or the equilibrium is undecided.
#[derive(Debug, Clone)]
enum BaseState {
    Sticks(Box<StuckGrasp>),
    Slides,
    NotKnown,
}

same_on_both_sides! { BaseState }

face_of_struct! {
    Reserve { rest, sigmas }
}

impl<const C: usize> Reserve<C> {
    /// The largest multiple x >= 0 of the load `direction` for which all contacts keep sticking under the base load plus x times `direction`, with
    /// the required number of standard deviations in reserve. Infinite if there is no largest multiple; NaN if the equilibrium under the base load is
    /// undecided.
    ///
    /// Zero if a contact slides under the base load, or ceases to stick under it with more than the allowed probability. A contact that is open under
    /// the base load counts as a failure as soon as it closes, because later changes of contact states are not computed.
    #[must_use]
    pub fn along(&self, direction: &Wrench<C>) -> f64 {
        match &self.rest {
            BaseState::NotKnown => f64::NAN,
            BaseState::Slides => 0.0,
            BaseState::Sticks(sticking) => sticking.most(&inside(direction)),
        }
    }

    /// The reserve that was asked for, as a number s of standard deviations. The allowed probability that any contact ceases to stick is Φ(-s), with
    /// the normal distribution Φ.
    #[must_use]
    pub fn sigmas(&self) -> f64 {
        self.sigmas
    }
}

impl Engine {
    pub(crate) fn reserve(
        &self,
        base: &Wrench<3>,
        uncertainty: &Uncertainty,
        sigmas: f64,
        settings: &Settings,
    ) -> Result<Reserve<3>, Error> {
        // A reserve of more than eight standard deviations means a failure probability below 1e-15, which cannot be told from rounding.
        if !(sigmas > 0.0 && sigmas <= 8.0) {
            let what = "standard deviations in reserve";
            return Err(Error::Argument { what, value: sigmas, allowed: "above 0, at most 8" });
        }
        if uncertainty.position != 0.0 {
            self.refuse_hands("reserve with uncertain positions")?;
        }
        let rest = match self.solve(base, settings)? {
            Outcome::Equilibrium(state) if state.local.states.iter().any(State::slides) => BaseState::Slides,
            Outcome::Equilibrium(state) => {
                let states = &state.local.states;
                BaseState::Sticks(Box::new(self.sticking(base, states, uncertainty, sigmas, settings)?))
            }
            Outcome::NoEquilibrium(_) => BaseState::Slides,
            Outcome::Undecided(_) => BaseState::NotKnown,
        };
        Ok(Reserve { rest, sigmas })
    }

    fn sticking(
        &self,
        base: &Wrench<3>,
        states: &[State],
        uncertainty: &Uncertainty,
        sigmas: f64,
        settings: &Settings,
    ) -> Result<StuckGrasp, Error> {
        let cone = Cone::of(self.space(), settings);
        let response = StickingResponse::in_states(self, cone, states);
        let data = self.data(uncertainty);
        let source_forces = source_forces(&response, cone, &data, sigmas)?;
        let mut unresisted = Vec::new();
        for motion in response.linear_problem.free_motions() {
            let of = |k: usize| self.inside_unchecked(&unit(self.space(), k)).dot(motion);
            let work: Vec<f64> = numbered(self.space().of_the_object(), &of);
            unresisted.push(Wrench::among(self.space(), &Vector::from_slice(&work)));
        }
        let load_spread = uncertainty.load;
        let off = PerturbedGrasp { grasp: self.clone(), cone, states: states.to_vec(), data, load_spread };
        let spreads = [sigmas, uncertainty.friction];
        Ok(StuckGrasp::new(off, response.edges, source_forces, base, unresisted, spreads))
    }
}
