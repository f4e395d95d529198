//! Forces while every contact sticks, and their exact derivatives by places and squeezes.
//!
//! A grasp whose contacts neither open nor slide at any force is linear. Its forces are the sum of those by the load at rest, by the squeeze, and by
//! each load, which are computed separately.

use nalgebra::SVector;

use super::placing::{Choice, DesignKind, DesignVariable, Placing};
use crate::ask::Grasp;
use crate::equilibrium::Equilibrium;
use crate::error::Error;
use crate::grasp::{Contact, Hold, Wrench};
use crate::load_path::Parameter;
use crate::numerics::{mapped, numbered};
use crate::prelude::*;

/// Forces of all contacts in their frames, N.
pub(super) type FrameForces<const C: usize> = Vec<SVector<f64, C>>;

/// One value for each source of forces.
#[derive(Debug, Clone)]
pub(super) struct BySource<F> {
    /// Forces that do not depend on the squeeze.
    pub(super) rest: F,
    /// Forces of the squeeze that may change.
    pub(super) squeeze: F,
    /// Forces of each load.
    pub(super) loads: Vec<F>,
}

impl<F> BySource<F> {
    fn each<'s, G>(&'s self, mut f: impl FnMut(&'s F) -> Option<G>) -> Option<BySource<G>> {
        let loads = self.loads.iter().map(&mut f).collect::<Option<_>>()?;
        Some(BySource { rest: f(&self.rest)?, squeeze: f(&self.squeeze)?, loads })
    }
}

/// The forces of a grasp whose contacts stick at any force.
#[derive(Debug)]
pub(super) struct StickingForces<const C: usize> {
    states: BySource<(Grasp<C>, Equilibrium<C>)>,
    pub(super) forces: BySource<FrameForces<C>>,
}

impl<const C: usize> StickingForces<C> {
    /// The forces of a placing, under the load at rest and under each of `loads`; `None` where nothing resists one of them.
    pub(super) fn of(
        choice: &Choice<'_, C>,
        placing: &Placing<C>,
        base: &Wrench<C>,
        loads: &[Wrench<C>],
    ) -> Result<Option<Self>, Error> {
        let contacts = choice.contacts(placing);
        let with = |keep: &dyn Fn(usize, Contact<C>) -> Contact<C>| {
            Grasp::new(numbered(contacts.len(), &|i| keep(i, glued(contacts[i].clone()))))
        };
        let idle = |mut contact: Contact<C>| {
            (contact.command, contact.clearance) = (SVector::zeros(), 0.0);
            contact
        };
        let is_free = |i: usize| placing.presses[i].is_some();
        let at_rest = with(&|i, contact| {
            if !is_free(i) {
                return contact;
            }
            let command = contact.command;
            let mut contact = idle(contact);
            for axis in 1..C {
                contact.command[axis] = command[axis];
            }
            contact
        })?;
        let squeezed = with(&|i, contact| {
            let press = contact.command[0] - contact.clearance;
            let mut contact = idle(contact);
            contact.command[0] = if is_free(i) { press } else { 0.0 };
            contact
        })?;
        let loaded = with(&|_, contact| idle(contact))?;
        let state = |grasp: &Grasp<C>, load: &Wrench<C>| {
            let outcome = grasp.solve(load)?;
            Ok::<_, Error>(outcome.equilibrium().cloned().map(|state| (grasp.clone(), state)))
        };
        let mut states = Vec::new();
        for load in loads {
            let Some(state) = state(&loaded, load)? else { return Ok(None) };
            states.push(state);
        }
        let (Some(rest), Some(squeeze)) = (state(&at_rest, base)?, state(&squeezed, &Wrench::ZERO)?) else {
            return Ok(None);
        };
        let states = BySource { rest, squeeze, loads: states };
        let forces = states.each(|(_, state)| Some(mapped(&state.contacts, &|contact| contact.force)));
        Ok(forces.map(|forces| Self { states, forces }))
    }

    /// The force of a contact at rest.
    pub(super) fn at_rest(&self, contact: usize) -> SVector<f64, C> {
        self.forces.rest[contact] + self.forces.squeeze[contact]
    }

    /// Changes of all forces by one unit of each variable; `None` where another place leaves a load unbalanced.
    pub(super) fn derivatives(
        &self,
        choice: &Choice<'_, C>,
        placing: &Placing<C>,
    ) -> Option<Vec<BySource<FrameForces<C>>>> {
        choice.variables.iter().map(|variable| self.derivative(placing, variable)).collect()
    }

    fn derivative(
        &self,
        placing: &Placing<C>,
        variable: &DesignVariable,
    ) -> Option<BySource<FrameForces<C>>> {
        let &DesignVariable { contact, what, unit } = variable;
        let by = |state: &(Grasp<C>, Equilibrium<C>), parameter| {
            let derivative = state.0.sensitivity().of(&state.1, parameter)?;
            Some(derivative.forces)
        };
        match what {
            DesignKind::Press { .. } => {
                let grasp = &self.states.squeeze.0;
                let stiffness = grasp.contacts()[contact].series_stiffness_of_axes()[0];
                let mut squeeze = by(&self.states.squeeze, Parameter::Command { contact, axis: 0 })?;
                for force in &mut squeeze {
                    *force *= unit / stiffness;
                }
                let none = vec![SVector::zeros(); squeeze.len()];
                let loads = vec![none.clone(); self.states.loads.len()];
                Some(BySource { rest: none, squeeze, loads })
            }
            DesignKind::Along(axis) => {
                let spot = placing.spots[contact].as_ref()?;
                let (along, bend) = (&spot.along[axis], spot.bends[axis]);
                self.states.each(|state| {
                    let mut sum = vec![SVector::zeros(); state.1.contacts.len()];
                    let mut add = |parameter, times: f64| {
                        if times != 0.0 {
                            let forces = by(state, parameter)?;
                            for (sum, force) in sum.iter_mut().zip(forces) {
                                *sum += force * (times * unit);
                            }
                        }
                        Some(())
                    };
                    for axis in 0..C {
                        add(Parameter::Point { contact, axis }, along[axis])?;
                    }
                    let frame = state.0.frames().nth(contact)?;
                    for axis in 1..C {
                        add(Parameter::Normal { contact, axis }, bend * along.dot(&frame.column(axis)))?;
                    }
                    Some(sum)
                })
            }
        }
    }
}

/// The contact without opening and sliding.
fn glued<const C: usize>(mut contact: Contact<C>) -> Contact<C> {
    contact.kinetic = None;
    if contact.hold != Hold::Bonded {
        contact.hold = Hold::KeptClosed;
        if contact.friction > 0.0 {
            contact.friction = f64::INFINITY;
        }
    }
    contact
}
