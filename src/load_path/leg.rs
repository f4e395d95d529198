//! Load programs: legs along which load and finger commands change linearly.

use nalgebra::SVector;

use super::ramp::vectors;
use crate::error::{Error, Field};
use crate::grasp::{Grasp, Wrench};

/// One leg of a load program: the load, the finger commands, or both go straight to where they are told.
///
/// A squeeze is a leg of commands, loading and unloading are legs of the load; what is not mentioned stays as it is. Loads are what pulls
/// on the object (N, N m about the origin); commands are displacements of the fingers in their contact frames (m), the normal part
/// positive into the object. Both change in proportion to the fraction of the leg, from 0 to 1.
///
/// ```
/// use grasp_lcp::planar::{Contact, Grasp, Leg, Wrench};
///
/// // Two fingers that each press with 1000 N/m · 0.01 m = 10 N; μ = 0.5.
/// let finger = |x: f64| Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1000.0, 800.0).friction(0.5).command([0.01, 0.0]);
/// let grasp = Grasp::new([finger(-1.0), finger(1.0)])?;
///
/// // Squeeze by 5 mm more, hang 12 N on, let go of half the squeeze while the load goes back to nothing.
/// let press = |by: f64| [[by, 0.0]; 2];
/// let legs = [
///     Leg::commands_by(press(0.005)),
///     Leg::load_to(Wrench::force([0.0, -12.0])),
///     Leg::commands_to(press(0.0075)).and_load_to(Wrench::ZERO),
/// ];
/// let mut path = grasp.follow(&Wrench::ZERO, &legs)?;
/// assert!(path.run().is_empty()); // 6 N on each side, of 0.5 · 15 N
/// let squeezed = path.state_at(0, 1.0).expect("has passed");
/// assert!((squeezed.contacts[0].normal_force() - 15.0).abs() < 1e-13);
/// let at_last = path.state_at(2, 1.0).expect("has passed");
/// assert!((at_last.contacts[0].normal_force() - 7.5).abs() < 1e-13);
/// # Ok::<(), grasp_lcp::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Leg<const D: usize, const C: usize> {
    load: Goal<Wrench<D, C>>,
    commands: Goal<Vec<SVector<f64, C>>>,
}

#[derive(Debug, Clone, PartialEq)]
enum Goal<T> {
    Stay,
    By(T),
    To(T),
}

impl<const D: usize, const C: usize> Leg<D, C> {
    const STAY: Self = Self { load: Goal::Stay, commands: Goal::Stay };

    /// The load changes by this much.
    #[must_use]
    pub fn load_by(change: Wrench<D, C>) -> Self {
        Self { load: Goal::By(change), ..Self::STAY }
    }

    /// The load changes to this.
    #[must_use]
    pub fn load_to(load: Wrench<D, C>) -> Self {
        Self { load: Goal::To(load), ..Self::STAY }
    }

    /// The finger commands change by this much: one displacement a contact, each in its contact frame (m).
    #[must_use]
    pub fn commands_by(change: impl IntoIterator<Item = impl Into<[f64; C]>>) -> Self {
        Self { commands: Goal::By(vectors(change)), ..Self::STAY }
    }

    /// The finger commands change to these: one displacement a contact, each in its contact frame (m).
    #[must_use]
    pub fn commands_to(commands: impl IntoIterator<Item = impl Into<[f64; C]>>) -> Self {
        Self { commands: Goal::To(vectors(commands)), ..Self::STAY }
    }

    /// Meanwhile the load changes by this much.
    #[must_use]
    pub fn and_load_by(self, change: Wrench<D, C>) -> Self {
        Self { load: Goal::By(change), ..self }
    }

    /// Meanwhile the load changes to this.
    #[must_use]
    pub fn and_load_to(self, load: Wrench<D, C>) -> Self {
        Self { load: Goal::To(load), ..self }
    }

    /// Meanwhile the finger commands change by this much.
    #[must_use]
    pub fn and_commands_by(self, change: impl IntoIterator<Item = impl Into<[f64; C]>>) -> Self {
        Self { commands: Goal::By(vectors(change)), ..self }
    }

    /// Meanwhile the finger commands change to these.
    #[must_use]
    pub fn and_commands_to(self, commands: impl IntoIterator<Item = impl Into<[f64; C]>>) -> Self {
        Self { commands: Goal::To(vectors(commands)), ..self }
    }

    fn check(&self, grasp: &Grasp<D, C>) -> Result<(), Error> {
        if let Goal::By(load) | Goal::To(load) = &self.load {
            grasp.inside(load, "load of a leg")?;
        }
        if let Goal::By(commands) | Goal::To(commands) = &self.commands {
            grasp.check_commands(commands, "commands of a leg", Field::CommandChange)?;
        }
        Ok(())
    }

    /// Load at the end of the leg.
    fn load_after(&self, load: &Wrench<D, C>) -> Wrench<D, C> {
        match &self.load {
            Goal::Stay => *load,
            Goal::By(change) => *load + *change,
            Goal::To(goal) => *goal,
        }
    }

    /// Commands at the end of the leg.
    fn commands_after(&self, commands: &[SVector<f64, C>]) -> Vec<SVector<f64, C>> {
        match &self.commands {
            Goal::Stay => commands.to_vec(),
            Goal::By(change) => commands.iter().zip(change).map(|(u, du)| u + du).collect(),
            Goal::To(goal) => goal.clone(),
        }
    }
}

/// A program on its way: the present leg, and the goals between which it leads.
#[derive(Debug, Clone)]
pub(super) struct Program<const D: usize, const C: usize> {
    legs: Vec<Leg<D, C>>,
    /// The present leg; as many as there are legs when all are done.
    pub(super) leg: usize,
    /// Load at the beginning and at the end of the present leg.
    pub(super) load: [Wrench<D, C>; 2],
    /// Finger commands at the beginning and at the end of the present leg.
    pub(super) commands: [Vec<SVector<f64, C>>; 2],
}

impl<const D: usize, const C: usize> Program<D, C> {
    /// Without legs, at rest under a load and the commands of a grasp.
    pub(super) fn new(grasp: &Grasp<D, C>, start: Wrench<D, C>) -> Self {
        let commands: Vec<_> = grasp.contacts().iter().map(|c| c.command).collect();
        Self { legs: Vec::new(), leg: 0, load: [start; 2], commands: [commands.clone(), commands] }
    }

    /// Appends legs, all or none of them.
    pub(super) fn extend(&mut self, grasp: &Grasp<D, C>, legs: &[Leg<D, C>]) -> Result<(), Error> {
        legs.iter().try_for_each(|leg| leg.check(grasp))?;
        self.legs.extend_from_slice(legs);
        Ok(())
    }

    /// Sets out from where the last leg ended; false if there is no leg to go.
    pub(super) fn begin_leg(&mut self) -> bool {
        let Some(leg) = self.legs.get(self.leg) else { return false };
        self.load = [self.load[1], leg.load_after(&self.load[1])];
        let after = leg.commands_after(&self.commands[1]);
        self.commands = [std::mem::replace(&mut self.commands[1], after.clone()), after];
        true
    }

    /// Drives, commands less clearances, at the beginning of the present leg, and what they change by.
    pub(super) fn drives(&self, grasp: &Grasp<D, C>) -> [Vec<SVector<f64, C>>; 2] {
        let [from, to] = &self.commands;
        let base = from.iter().zip(grasp.contacts()).map(|(command, contact)| {
            let mut a = *command;
            a[0] -= contact.clearance;
            a
        });
        [base.collect(), to.iter().zip(from).map(|(to, from)| to - from).collect()]
    }

    /// The load at a fraction of the present leg.
    pub(super) fn load_at(&self, fraction: f64) -> Wrench<D, C> {
        self.load[0] + (self.load[1] - self.load[0]) * fraction
    }
}
