//! Exact derivatives of the onset of sliding: `dτ = -dm / m'` with the margin m that vanishes and its rate m' along the ramp.

use nalgebra::SVector;

use super::onset::{OnsetEvent, RollingState};
use super::sensitivity::{Local, Parameter};
use crate::contact::tangential;
use crate::equilibrium::Cone;
use crate::grasp::{Grasp, HandPart};

/// Derivatives of the load factor (without unit) at which one contact leaves rolling.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct OnsetGradient<const D: usize, const C: usize> {
    /// What leaves: a contact, or a drive of a hand. Where several leave together the onset is the least of their factors: its one-sided derivative along
    /// a change of the data is the least of theirs.
    pub leaving: Leaver,
    /// By every contact's coefficient of friction.
    pub friction: Vec<f64>,
    /// By every contact's series stiffness, axis by axis, m/N.
    pub stiffness: Vec<SVector<f64, C>>,
    /// By every contact's command in its contact frame, axis by axis, 1/m.
    pub command: Vec<SVector<f64, C>>,
    /// By the commands of the joints of a hand, then of its tendons, 1/rad or 1/m.
    pub joint_command: Vec<f64>,
    /// By the stiffnesses of their own springs, rad/(N m) or m/N.
    pub joint_stiffness: Vec<f64>,
    /// By their limits, 1/(N m) or 1/N.
    pub joint_limit: Vec<f64>,
    /// By the components of the base load, or of the constant part of one that turns, 1/N and 1/(N m). Those by the load direction are the
    /// factor times these, those by the parts that turn cos θ and sin θ times. Not a number where a component works on a motion that nothing resists: with such a load there is no equilibrium.
    pub base_load: SVector<f64, D>,
}

/// What leaves at an onset.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Leaver {
    /// A contact, from 0.
    Contact(usize),
    /// A drive of a hand.
    Drive(HandPart),
}

impl<const D: usize, const C: usize> Grasp<D, C> {
    /// Derivatives of the onset by every parameter, one gradient for each leaving contact: `dτ = -dm / m'` with the margin that vanishes,
    /// m = `μ F_n - |F_t|` (F_n where a contact opens), and its rate m' along the ramp. Of a load that turns they are those of the angle.
    /// Empty if the onset was reached after a contact had closed on the way (the history then enters, too), or if the event has another
    /// number of contacts.
    ///
    /// ```
    /// use grasp_lcp::planar::{Contact, Grasp, Ramp, Wrench};
    ///
    /// // Two fingers that each press with 1000 N/m · 0.01 m = 10 N; μ = 0.5.
    /// let finger = |x: f64| Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1000.0, 800.0).friction(0.5).command([0.01, 0.0]);
    /// let grasp = Grasp::new([finger(-1.0), finger(1.0)])?;
    ///
    /// let ramp = Ramp::load(Wrench::ZERO, Wrench::force([0.0, -1.0]));
    /// let onset = grasp.onset(&ramp)?;
    /// // A contact leaves at W = 2 μ N, so ∂W/∂μ = 2 N = 20 newtons.
    /// let gradient = &grasp.onset_gradients(onset.event().expect("slides"))[0];
    /// assert!((gradient.friction[0] - 20.0).abs() < 1e-12);
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    #[must_use]
    pub fn onset_gradients(&self, event: &OnsetEvent<D, C>) -> Vec<OnsetGradient<D, C>> {
        let Some(state) = self.state_at_onset(event) else { return Vec::new() };
        let Some(local) = Local::new(self, &state) else { return Vec::new() };
        let has_slipped = |i: usize| {
            let sticks = local.states[i].is_rolling() && !local.problem.local(i).is_frictionless();
            sticks && state.contacts[i].slip.norm() != 0.0
        };
        if (0..self.len()).any(has_slipped) {
            return Vec::new();
        }
        let OnsetEvent { local: RollingState { drive_rates, wrench_rate, .. }, .. } = event;
        let Ok(rates) = local.piece.solve(self.sites(), drive_rates, wrench_rate) else {
            return Vec::new();
        };
        let one = |site: &usize| self.onset_gradient(&local, event.cone, *site, &rates.forces[*site]);
        event.local.leaving.iter().filter_map(one).collect()
    }

    fn onset_gradient(
        &self,
        local: &Local<D, C>,
        cone: Cone,
        contact: usize,
        rate: &SVector<f64, C>,
    ) -> Option<OnsetGradient<D, C>> {
        let (law, force) = (local.problem.local(contact), &local.forces[contact]);
        // The margin that vanishes: μ F_n - h·F_t, or F_n alone where there is no friction or no limit to it.
        let h = if !law.cone().has_edges() {
            None
        } else if cone == Cone::Round {
            Some(tangential(force).normalize())
        } else {
            Some(*law.facets().iter().max_by(|a, b| a.dot(force).total_cmp(&b.dot(force)))?)
        };
        let margin = |f: &SVector<f64, C>| h.map_or(f[0], |h| law.cone().facet_margin(f, &h));
        let slope = margin(rate);
        let by = |parameter| -> Option<f64> {
            let (_, forces) = local.derivative(parameter)?;
            let own = matches!(parameter, Parameter::Friction { contact: i } if i == contact && h.is_some());
            Some(-(margin(&forces[contact]) + if own { force[0] } else { 0.0 }) / slope)
        };
        let (n, actuators) = (self.len(), 0..self.joint_commands().len());
        let leaving = match self.linkage() {
            Some(linkage) if contact >= n => Leaver::Drive(linkage.part(contact - n)?),
            _ => Leaver::Contact(contact),
        };
        let mut gradient = OnsetGradient {
            leaving,
            friction: Vec::with_capacity(n),
            stiffness: vec![SVector::zeros(); n],
            command: vec![SVector::zeros(); n],
            joint_command: actuators
                .clone()
                .map(|joint| by(Parameter::JointCommand { joint }))
                .collect::<Option<_>>()?,
            joint_stiffness: actuators
                .clone()
                .map(|joint| by(Parameter::JointStiffness { joint }))
                .collect::<Option<_>>()?,
            joint_limit: actuators.map(|joint| by(Parameter::JointLimit { joint })).collect::<Option<_>>()?,
            base_load: SVector::zeros(),
        };
        for i in 0..n {
            gradient.friction.push(by(Parameter::Friction { contact: i })?);
            for axis in 0..C {
                gradient.stiffness[i][axis] = by(Parameter::Stiffness { contact: i, axis })?;
                gradient.command[i][axis] = by(Parameter::Command { contact: i, axis })?;
            }
        }
        for component in 0..D {
            // A load on a free motion is not carried at all: the onset does not depend on what cannot be.
            gradient.base_load[component] = by(Parameter::Load { component }).unwrap_or(f64::NAN);
        }
        Some(gradient)
    }
}
