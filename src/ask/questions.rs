//! The questions that every engine answers, for any number of coordinates.

use alloc::sync::Arc;
use core::fmt::Debug;

use nalgebra::{SMatrix, SVector};

use crate::contact::PolygonCone;
use crate::energy::{
    Agreement, AssociatedOutcome, Comparison, MinimumOutcome, PrintedQp, ReducedQp, SecondOrderOutcome,
    Stability, ThreeLaws, Unknowns,
};
use crate::equilibrium::{Accuracy, Bracket, Decomposition, Equilibrium, Outcome, Refutation, Settings};
use crate::error::Error;
use crate::forms::Form;
use crate::grasp::{BodyLoad, Contact, Engine, HandPart, PressOfPart, Wrench};
use crate::hold::Verdict;
use crate::load_path::{
    Beyond, Derivative, GeometryGradient, Leg, LoadPath, Onset, OnsetEvent, OnsetGradient, Parameter, Ramp,
    Response, SteppedPath, StickingRange, Turn, TurnOnset,
};
use crate::numerics::Memory;
use crate::prelude::*;
use crate::shake::{Shakedown, Shaken};
use crate::squeeze::{Bounds, LeastOnset, LeastSqueeze, Loads, WeakestDirection};
use crate::statics::{Budget, Closure, LoadLimit, WrenchBall, WrenchScale};
use crate::structured::{Search, SearchSettings};
use crate::sweep::{OnsetSpread, Reserve, RobustOnset, Uncertainty};

/// Declares the questions once, and answers them by the engine's methods of the same names.
macro_rules! questions {
    { $($(#[$attribute:meta])* fn $name:ident $(<$life:lifetime>)? (&self $(, $argument:ident: $type:ty)*) -> $answer:ty;)* } => {
        /// The questions of [`Grasp`](super::Grasp), with settings where they matter.
        pub(crate) trait Questions<const C: usize>: Debug + Send + Sync + 'static {
            $($(#[$attribute])* fn $name $(<$life>)? (&self $(, $argument: $type)*) -> $answer;)*
            fn with_commands(&self, commands: &[SVector<f64, C>]) -> Changed<C>;
            fn with_joint_commands(&self, commands: &[f64]) -> Changed<C>;
            fn with_joint_torques(&self, torques: &[f64]) -> Changed<C>;
            fn growing_together(&self, one: &Wrench<C>, others: &[(Arc<str>, Wrench<C>)]) -> Changed<C>;
            fn with_body_loads(&self, loads: &[BodyLoad<C>]) -> Changed<C>;
            fn with_friction(&self, friction: &dyn Fn(usize, f64) -> f64) -> Changed<C>;
            fn squeezed(&self, factor: f64) -> Changed<C>;
            fn scaled(&self, part: &str, factor: f64) -> Scaled<C>;
            fn with_contacts(&self, contacts: Vec<Contact<C>>) -> Changed<C>;
            fn sample(&self, uncertainty: &Uncertainty, number: u64) -> Changed<C>;
        }

        impl<const C: usize> Questions<C> for Engine<C> {
            $($(#[$attribute])* fn $name $(<$life>)? (&self $(, $argument: $type)*) -> $answer {
                Engine::$name(self $(, $argument)*)
            })*
            fn with_commands(&self, commands: &[SVector<f64, C>]) -> Changed<C> {
                Ok(Arc::new(Engine::with_commands(self, commands)?))
            }

            fn with_joint_commands(&self, commands: &[f64]) -> Changed<C> {
                Ok(Arc::new(Engine::with_joint_commands(self, commands)?))
            }

            fn with_joint_torques(&self, torques: &[f64]) -> Changed<C> {
                Ok(Arc::new(Engine::with_joint_torques(self, torques)?))
            }

            fn growing_together(&self, one: &Wrench<C>, others: &[(Arc<str>, Wrench<C>)]) -> Changed<C> {
                Ok(Arc::new(Engine::growing_together(self, one, others)?))
            }

            fn with_body_loads(&self, loads: &[BodyLoad<C>]) -> Changed<C> {
                Ok(Arc::new(Engine::with_body_loads(self, loads)?))
            }

            fn with_friction(&self, friction: &dyn Fn(usize, f64) -> f64) -> Changed<C> {
                Ok(Arc::new(Engine::with_friction(self, friction)?))
            }

            fn squeezed(&self, factor: f64) -> Changed<C> {
                Ok(Arc::new(Engine::squeezed(self, factor)?))
            }

            fn scaled(&self, part: &str, factor: f64) -> Scaled<C> {
                let (pressing, engine) = Engine::scaled(self, part, factor)?;
                Ok((pressing, Arc::new(engine)))
            }

            fn with_contacts(&self, contacts: Vec<Contact<C>>) -> Changed<C> {
                Ok(Arc::new(Engine::with_data(self, contacts, &|_| 1.0)?))
            }

            fn sample(&self, uncertainty: &Uncertainty, number: u64) -> Changed<C> {
                Ok(Arc::new(Engine::sample(self, uncertainty, number)?))
            }
        }
    };
}

/// An engine with other data.
type Changed<const C: usize> = Result<Arc<dyn Questions<C>>, Error>;

/// The press of one part, and the engine with this press scaled.
type Scaled<const C: usize> = Result<(PressOfPart, Arc<dyn Questions<C>>), Error>;

questions! {
    fn contacts(&self) -> &[Contact<C>];
    fn refuse_hands(&self, question: &'static str) -> Result<(), Error>;
    fn frame(&self, contact: usize) -> &SMatrix<f64, C, C>;
    fn presses(&self) -> bool;
    fn is_squeezed(&self) -> bool;
    fn is_proportional(&self) -> bool;
    fn loaded_bodies(&self) -> Vec<String>;
    fn unbalanced_along(&self, load: &Wrench<C>, settings: &Settings) -> Result<Option<Vec<f64>>, Error>;
    fn work_along(&self, load: &Wrench<C>, motion: &[f64]) -> Result<f64, Error>;
    fn links(&self) -> &[[SVector<f64, C>; 2]];
    fn joint_centres(&self) -> &[Option<SVector<f64, C>>];
    fn joint_commands(&self) -> &[f64];
    fn label_of(&self, part: HandPart) -> String;
    fn weakest_direction(&self, base: &Wrench<C>, point: [f64; C], settings: &Settings) -> Result<WeakestDirection<C>, Error>;
    fn onset_in(&self, ramp: &Ramp<C>, settings: &Settings, memory: &mut Memory, told: Option<Onset<C>>) -> Result<Onset<C>, Error>;
    fn check_refutation(&self, proof: &Refutation<C>, load: &Wrench<C>) -> Result<Option<f64>, Error>;
    fn search_in<'w>(&self, load: &Wrench<C>, how: &SearchSettings, memory: &'w mut Memory) -> Result<Search<'w, C>, Error>;
    fn accuracy(&self, equilibrium: &Equilibrium<C>) -> Option<Accuracy>;
    fn bracket(&self, load: &Wrench<C>, settings: &Settings) -> Result<Bracket<C>, Error>;
    fn decompose(&self, equilibrium: &Equilibrium<C>) -> Decomposition<C>;
    fn distinct(&self, equilibrium: &Equilibrium<C>) -> Option<Vec<bool>>;
    fn solve(&self, load: &Wrench<C>, settings: &Settings) -> Result<Outcome<C>, Error>;
    fn equilibria(&self, load: &Wrench<C>, settings: &Settings) -> Result<Vec<Equilibrium<C>>, Error>;
    fn refutation(&self, load: &Wrench<C>, settings: &Settings) -> Result<Option<Refutation<C>>, Error>;
    fn kinematic_form(&self, load: &Wrench<C>, cone: &PolygonCone) -> Result<Option<Form>, Error>;
    fn force_form(&self, load: &Wrench<C>, cone: &PolygonCone) -> Result<Option<Form>, Error>;
    fn hold(&self, ramp: &Ramp<C>, settings: &Settings) -> Result<Verdict<C>, Error>;
    fn onset_gradients(&self, event: &OnsetEvent<C>) -> Vec<OnsetGradient<C>>;
    fn onset(&self, ramp: &Ramp<C>, settings: &Settings) -> Result<Onset<C>, Error>;
    fn state_at_onset(&self, event: &OnsetEvent<C>, settings: &Settings) -> Option<Equilibrium<C>>;
    fn beyond(&self, event: &OnsetEvent<C>, settings: &Settings) -> Option<Beyond<C>>;
    fn follow(&self, start: &Wrench<C>, legs: &[Leg<C>], settings: &Settings) -> Result<LoadPath<'_, C>, Error>;
    fn shake(&self, base: &Wrench<C>, cycle: &[Leg<C>], settings: &Settings) -> Result<Shaken<C>, Error>;
    fn sticking_range(&self, ramp: &Ramp<C>, settings: &Settings) -> Result<Option<StickingRange>, Error>;
    fn response(&self, equilibrium: &Equilibrium<C>) -> Option<Response>;
    fn joint_response(&self, equilibrium: &Equilibrium<C>) -> Option<Response>;
    fn sensitivity(&self, equilibrium: &Equilibrium<C>, by: Parameter) -> Option<Derivative<C>>;
    fn onset_of_turn(&self, turn: &Turn<C>, settings: &Settings) -> Result<TurnOnset<C>, Error>;
    fn agreement_with_minimum_energy(&self, ramp: &Ramp<C>, settings: &Settings) -> Result<Agreement<C>, Error>;
    fn compare_with_minimum_energy(&self, load: &Wrench<C>, settings: &Settings) -> Result<Comparison<C>, Error>;
    fn minimum_energy(&self, load: &Wrench<C>, settings: &Settings) -> Result<MinimumOutcome<C>, Error>;
    fn shakedown(&self, base: &Wrench<C>, loads: &[Wrench<C>], settings: &Settings) -> Result<Option<Shakedown<C>>, Error>;
    fn stability(&self, equilibrium: &Equilibrium<C>) -> Stability<C>;
    fn solve_each(&self, loads: &[Wrench<C>], settings: &Settings) -> Vec<Result<Outcome<C>, Error>>;
    fn onset_each(&self, ramps: &[Ramp<C>], settings: &Settings) -> Vec<Result<Onset<C>, Error>>;
    fn onset_of_turn_each(&self, turns: &[Turn<C>], settings: &Settings) -> Vec<Result<TurnOnset<C>, Error>>;
    fn robust_onset(&self, ramp: &Ramp<C>, uncertainty: &Uncertainty, settings: &Settings) -> Result<RobustOnset<C>, Error>;
    fn onset_spread(&self, event: &OnsetEvent<C>, uncertainty: &Uncertainty) -> Result<Option<OnsetSpread>, Error>;
    fn onset_of_samples(&self, ramp: &Ramp<C>, uncertainty: &Uncertainty, samples: u64, settings: &Settings) -> Vec<Result<Onset<C>, Error>>;
    fn force_closure(&self, settings: &Settings) -> Result<Closure<C>, Error>;
    fn form_closure(&self) -> Result<Closure<C>, Error>;
    fn reserve(&self, base: &Wrench<C>, uncertainty: &Uncertainty, sigmas: f64, settings: &Settings) -> Result<Reserve<C>, Error>;
    fn onset_gradients_by_geometry(&self, event: &OnsetEvent<C>) -> Result<Vec<GeometryGradient<C>>, Error>;
    fn follow_in_steps(&self, start: &Wrench<C>, legs: &[Leg<C>], error: f64, settings: &Settings) -> Result<SteppedPath<'_, C>, Error>;
    fn associated_friction(&self, load: &Wrench<C>, settings: &Settings) -> Result<AssociatedOutcome<C>, Error>;
    fn printed_qp(&self, load: &Wrench<C>, cone: &PolygonCone) -> Result<PrintedQp<C>, Error>;
    fn reduced_qp(&self, load: &Wrench<C>, cone: &PolygonCone, unknowns: Unknowns) -> Result<ReducedQp<C>, Error>;
    fn second_order_equilibrium(&self, load: &Wrench<C>, settings: &Settings) -> Result<SecondOrderOutcome<C>, Error>;
    fn three_laws(&self, load: &Wrench<C>, settings: &Settings) -> Result<ThreeLaws<C>, Error>;
    fn least_onset_within(&self, ramp: &Ramp<C>, bounds: &Bounds<C>, settings: &Settings) -> Result<LeastOnset<C>, Error>;
    fn least_squeeze(&self, loads: &Loads<C>, settings: &Settings) -> Result<LeastSqueeze<C>, Error>;
    fn ferrari_canny(&self, budget: Budget, scale: &WrenchScale<C>, settings: &Settings) -> Result<WrenchBall<C>, Error>;
    fn load_limit(&self, base: &Wrench<C>, direction: &Wrench<C>, budget: Budget, settings: &Settings) -> Result<LoadLimit<C>, Error>;
}
