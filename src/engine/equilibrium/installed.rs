//! Links that are to have a given tension without load: Newton's method finds the commands that give them this tension. A link is a joint between
//! bodies, such as a cable or a spring; its command is a prescribed displacement of its end.

use nalgebra::{DMatrix, DVector, SVector};

use super::answer::Outcome;
use crate::error::Error;
use crate::grasp::{Contact, Engine, Wrench};
use crate::numerics::tolerances::{NEGLIGIBLE, SOLVED_ROUNDING};
use crate::numerics::{IntoList, Reals, mapped};
use crate::prelude::*;
use crate::search::Settings;

impl Engine {
    /// This grasp with commands of its links such that each link with a given tension has this tension without load. An error if the grasp cannot
    /// hold that tension. If no link has a given tension, nothing changes.
    pub(crate) fn installed(self) -> Result<Self, Error> {
        // The given tension of a link may be zero, because a factor on the squeeze (everything by which contacts press at rest without a load)
        // multiplies given tensions, too. If the tension is zero, the link keeps its command.
        let wanted = |contact: &Contact<3>| contact.at_rest.filter(|tension| *tension > 0.0);
        let pressed: Vec<(usize, f64)> =
            self.contacts().iter().enumerate().filter_map(|(i, contact)| Some((i, wanted(contact)?))).list();
        if pressed.is_empty() {
            return Ok(self);
        }
        let stiffness: Vec<f64> = mapped(&pressed, &|(i, _)| self.contacts()[*i].stiffness.series()[0]);
        let mut commands: Vec<SVector<f64, 3>> = mapped(self.contacts(), &|contact| contact.command);
        let mut missing = self.missing(&commands, &pressed)?;
        // Upper limit of Newton steps. One step is enough while no contact changes its state; each change of state may take one more step.
        for _ in 0..20 {
            let worst =
                missing.iter().zip(&pressed).map(|(missing, (_, force))| missing.abs() / force).most();
            // Newton's method ends once the error of every tension, relative to that tension, is at most `SOLVED_ROUNDING`.
            if worst <= SOLVED_ROUNDING {
                break;
            }
            // Derivatives are difference quotients: the command of a link is changed by the fraction `nudge` of its spring's stretch under its
            // tension. The fraction is so small that contacts hardly ever change their states. If none does, the quotient is exact.
            let nudge = 1e-3;
            // Column k is for the command of link k, which grows by `nudge` times the stretch of its spring. The entries are the decreases of all
            // missing tensions (given minus present tension).
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
        // Newton's method has failed if the tension of a link is off by more than the fraction `NEGLIGIBLE`: the other contacts and links cannot
        // balance this tension.
        match missing.iter().zip(&pressed).find(|(missing, (_, force))| missing.abs() > NEGLIGIBLE * force) {
            Some((_, (i, force))) => Err(self.not_held(*i, *force)),
            None => self.with_commands(&commands),
        }
    }

    /// For each link with a given tension: the given tension minus the tension of the link under `commands` without load, N. An error if no
    /// equilibrium is found.
    fn missing(&self, commands: &[SVector<f64, 3>], pressed: &[(usize, f64)]) -> Result<DVector<f64>, Error> {
        let outcome = self.with_commands(commands)?.solve(&Wrench::ZERO, &Settings::default())?;
        let Outcome::Equilibrium(state) = outcome else {
            return Err(self.not_held(pressed[0].0, pressed[0].1));
        };
        // A slack link has no tension, whatever its command. Its gap times its stiffness is then added to the missing tension (given minus present
        // tension). The missing tension thus depends on the command, as Newton's method needs.
        let slack = |i: usize| state.contacts[i].gap.max(0.0) * self.contacts()[i].stiffness.series()[0];
        let each = |(i, force): &(usize, f64)| force - state.contacts[*i].normal_force() + slack(*i);
        Ok(DVector::from_vec(mapped(pressed, &each)))
    }

    fn not_held(&self, contact: usize, force: f64) -> Error {
        let link = &self.contacts()[contact];
        Error::Link {
            kind: link.link.map_or("contact", |kind| kind.name()),
            name: link.label_text(contact),
            field: "tension",
            value: force,
            // The end of the error message "tension is …, must be …".
            allowed: "one that the rest of the grasp holds against while nothing else is put on",
        }
    }
}
