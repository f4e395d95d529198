//! Links with a given tension at rest: Newton's method for the commands under which each link carries its tension.

use crate::numerics::IntoList;
use nalgebra::{DMatrix, DVector};

use super::grasp::Grasp;
use crate::error::Error;
use crate::grasp::Wrench;
use crate::numerics::mapped;
use crate::numerics::tolerances::{NEGLIGIBLE, SOLVED_ROUNDING};
use crate::prelude::*;

impl Grasp<3> {
    /// This grasp with commands under which each link with a given tension pulls with it at rest.
    pub(super) fn installed(self) -> Result<Self, Error> {
        // A squeeze of zero leaves no tension, and no command.
        let wanted = |contact: &crate::grasp::Contact<3>| contact.at_rest.filter(|tension| *tension > 0.0);
        let pressed: Vec<(usize, f64)> =
            self.contacts().iter().enumerate().filter_map(|(i, contact)| Some((i, wanted(contact)?))).list();
        if pressed.is_empty() {
            return Ok(self);
        }
        let stiffness: Vec<f64> = mapped(&pressed, &|(i, _)| self.contacts()[*i].stiffness.series()[0]);
        let mut commands: Vec<[f64; 3]> = mapped(self.contacts(), &|contact| contact.command.into());
        let mut missing = self.missing(&commands, &pressed)?;
        // Limit on Newton steps: one is enough while no contact changes state, and each change of state takes one more.
        for _ in 0..20 {
            let worst = missing
                .iter()
                .zip(&pressed)
                .map(|(missing, (_, force))| missing.abs() / force)
                .fold(0.0, f64::max);
            // Relative error of a tension at which Newton's method stops.
            if worst <= SOLVED_ROUNDING {
                break;
            }
            // Step of the difference quotient, relative to the stretch of the link's spring under its tension. It is small, so that contacts
            // hardly ever change state within it; if none does, the quotient is exact.
            let nudge = 1e-3;
            // Column k: the change of the missing tensions as the command of link k grows by `nudge` times the stretch of its spring.
            let mut change = DMatrix::zeros(pressed.len(), pressed.len());
            for (k, (i, force)) in pressed.iter().enumerate() {
                let mut pulled = commands.clone();
                pulled[*i][0] += nudge * force / stiffness[k];
                change.set_column(k, &(&missing - self.missing(&pulled, &pressed)?));
            }
            let steps = change.lu().solve(&missing).filter(|steps| steps.iter().all(|x| x.is_finite()));
            let Some(steps) = steps else { break };
            for (k, (i, force)) in pressed.iter().enumerate() {
                commands[*i][0] += steps[k] * nudge * force / stiffness[k];
            }
            missing = self.missing(&commands, &pressed)?;
        }
        // A tension with a larger relative error is refused.
        match missing.iter().zip(&pressed).find(|(missing, (_, force))| missing.abs() > NEGLIGIBLE * force) {
            Some((_, (i, force))) => Err(self.not_held(*i, *force)),
            None => self.with_commands(commands),
        }
    }

    /// The given tensions less those with these commands and without load, N.
    fn missing(&self, commands: &[[f64; 3]], pressed: &[(usize, f64)]) -> Result<DVector<f64>, Error> {
        let outcome = self.with_commands(commands.iter().copied())?.solve(Wrench::ZERO)?;
        let state = outcome.equilibrium().ok_or_else(|| self.not_held(pressed[0].0, pressed[0].1))?;
        // The gap of a slack link, times its stiffness, counts as missing tension, too; so the missing tension depends on the command even of a slack
        // link.
        let slack = |i: usize| state.contacts[i].gap.max(0.0) * self.contacts()[i].stiffness.series()[0];
        let each = pressed.iter().map(|(i, force)| force - state.contacts[*i].normal_force() + slack(*i));
        Ok(DVector::from_iterator(pressed.len(), each))
    }

    fn not_held(&self, contact: usize, force: f64) -> Error {
        let link = &self.contacts()[contact];
        Error::Link {
            kind: link.link.map_or("contact", |kind| kind.name()),
            name: link.label_text(contact),
            field: "tension",
            value: force,
            // The allowed values, in words, for the error about a tension that is not reached.
            allowed: "one that the rest of the grasp holds against while nothing else is put on",
        }
    }
}
