//! Links that pull with a force once they are installed: what they have to be pulled with before all else gives way.

use nalgebra::{DMatrix, DVector};

use super::grasp::Grasp;
use crate::error::Error;
use crate::grasp::Wrench;
use crate::prelude::*;

/// Forces that differ by less than this part are the same.
const SAME: f64 = 1e-12;

/// Newton's steps: one leads there while no contact begins to touch, to open or to slide, and each of these takes one more.
const STEPS: usize = 20;

/// A step of a difference, in parts of the pull: small, so that hardly ever something begins to touch within it, and exact where nothing does.
const NUDGE: f64 = 1e-3;

/// A force that is missed by more is not reached.
const NEAR: f64 = 1e-9;

/// Said of a force that nothing holds against.
const HELD: &str = "one that the rest of the grasp holds against while nothing else is put on";

impl<const C: usize> Grasp<C> {
    /// This grasp with commands such that links pull at rest with the tension that they are told.
    pub(super) fn installed(self) -> Result<Self, Error> {
        let wanted = |contact: &crate::grasp::Contact<C>| contact.at_rest;
        let told: Vec<(usize, f64)> = self
            .contacts()
            .iter()
            .enumerate()
            .filter_map(|(i, contact)| Some((i, wanted(contact)?)))
            .collect();
        if told.is_empty() {
            return Ok(self);
        }
        let stiffness: Vec<f64> =
            told.iter().map(|(i, _)| self.contacts()[*i].stiffness.series()[0]).collect();
        let mut commands: Vec<[f64; C]> =
            self.contacts().iter().map(|contact| contact.command.into()).collect();
        let mut off = self.missing(&commands, &told)?;
        for _ in 0..STEPS {
            let worst = off.iter().zip(&told).map(|(off, (_, force))| off.abs() / force).fold(0.0, f64::max);
            if worst <= SAME {
                break;
            }
            // How much less is missing where each one is pulled by a little of what its own spring stretches under its force.
            let mut change = DMatrix::zeros(told.len(), told.len());
            for (k, (i, force)) in told.iter().enumerate() {
                let mut pulled = commands.clone();
                pulled[*i][0] += NUDGE * force / stiffness[k];
                change.set_column(k, &(&off - self.missing(&pulled, &told)?));
            }
            let steps = change.lu().solve(&off).filter(|steps| steps.iter().all(|x| x.is_finite()));
            let Some(steps) = steps else { break };
            for (k, (i, force)) in told.iter().enumerate() {
                commands[*i][0] += steps[k] * NUDGE * force / stiffness[k];
            }
            off = self.missing(&commands, &told)?;
        }
        match off.iter().zip(&told).find(|(off, (_, force))| off.abs() > NEAR * force) {
            Some((_, (i, force))) => Err(self.not_held(*i, *force)),
            None => self.with_commands(commands),
        }
    }

    /// What pulls lack to those that are told, with these commands and without load.
    fn missing(&self, commands: &[[f64; C]], told: &[(usize, f64)]) -> Result<DVector<f64>, Error> {
        let outcome = self.with_commands(commands.iter().copied())?.solve(&Wrench::ZERO)?;
        let state = outcome.equilibrium().ok_or_else(|| self.not_held(told[0].0, told[0].1))?;
        // One that is slack lacks what would close its gap as well: so its command counts there, too.
        let slack = |i: usize| state.contacts[i].gap.max(0.0) * self.contacts()[i].stiffness.series()[0];
        let each = told.iter().map(|(i, force)| force - state.contacts[*i].normal_force() + slack(*i));
        Ok(DVector::from_iterator(told.len(), each))
    }

    fn not_held(&self, contact: usize, force: f64) -> Error {
        let link = &self.contacts()[contact];
        Error::Link {
            kind: link.link.map_or("contact", |kind| kind.name()),
            name: link.label_text(contact),
            field: "tension",
            value: force,
            allowed: HELD,
        }
    }
}
