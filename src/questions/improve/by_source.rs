//! Contact forces while every contact sticks, and their exact derivatives with respect to the variables of the search for better finger placement.
//! Forces are kept apart by their source, the cause of the force: the base load with fixed commands, the variable commands, or a load. A command is
//! the displacement that a finger would make if there were no object. The variables are the places of contacts (positions on their curves or
//! surfaces) and their commanded normal forces (with the object held in place); a design point is one choice of all of them. The base load acts
//! before the loads of the question grow. A contact is left open if it touches without force and no load of the computation closes it.

use nalgebra::SVector;

use super::design_point::{DesignKind, DesignPoint, DesignSpace, DesignVariable};
use crate::ask::Grasp;
use crate::contact::Mode;
use crate::equilibrium::{Cone, Parameter, StickingResponse};
use crate::error::Error;
use crate::grasp::Wrench;
use crate::numerics::{IntoList, Vector, add_times, all_some, chosen, indexed, numbered, unit};
use crate::object::ForcesAndTwist;
use crate::prelude::*;

/// For each source (base load with fixed commands, variable commands, each load), the forces of all contacts in their frames, N, or derivatives of
/// these forces. A contact that is left open carries no force. Its first component is then the closing force, N: the normal force that its springs
/// would exert if they followed the motion of the object as if the contact were closed.
pub(super) type BySource = Vec<Vec<SVector<f64, 3>>>;

/// Index in [`BySource`] of the forces that do not vary with the variable commands or the loads: they are due to the base load and to fixed commands.
pub(super) const REST: usize = 0;
/// Index in [`BySource`] of the forces due to the normal commands that the search varies.
pub(super) const SQUEEZE: usize = 1;
/// Index in [`BySource`] of the forces due to the first load; the forces due to further loads follow.
pub(super) const LOADS: usize = 2;

/// The contact forces of a grasp, computed as if every contact stuck, apart for each source: base load with fixed commands, variable commands, and
/// each load. Contacts that touch without force may be left open.
#[derive(Debug)]
pub(super) struct StickingForces {
    pub(super) grasp: Grasp<3>,
    /// For each contact whether it is left open: it touches without force and counts as open.
    pub(super) open: Vec<bool>,
    /// Indices of the loads whose sticking conditions are evaluated with these forces. Any other load closes some of the open contacts: its forces
    /// are in another [`StickingForces`], in which these contacts are closed.
    pub(super) judged: Vec<usize>,
    sources: Vec<ForcesAndTwist>,
    /// For each source and contact the closing force, N, of an open contact: the normal force that its springs would exert under this source if it
    /// were closed. Zero unless the contact is left open.
    closing: Vec<Vec<f64>>,
}

/// The series stiffness of a contact along its normal, N/m.
fn normal_stiffness(grasp: &Grasp<3>, contact: usize) -> f64 {
    grasp.contacts()[contact].series_stiffness_of_axes()[0]
}

/// The linear response of a grasp while every contact sticks, except those in `open`.
fn response<'g>(grasp: &'g Grasp<3>, open: &[bool]) -> StickingResponse<'g> {
    let sticking = StickingResponse::new(&grasp.engine, grasp.settings());
    if !open.contains(&true) {
        return sticking;
    }
    let mut states = sticking.states;
    for contact in chosen(open.len(), &|contact| open[*contact]) {
        states[contact] = Mode::Open;
    }
    StickingResponse::in_states(&grasp.engine, Cone::of(grasp.engine.space(), grasp.settings()), &states)
}

impl StickingForces {
    /// The contact forces of a design point (places and commanded normal forces of the contacts). They are computed apart for the base load with
    /// fixed commands, the variable commands, and each of `loads`. Contacts in `open` are left open. `None` if nothing resists one of these loads.
    pub(super) fn of(
        design_space: &DesignSpace<'_>,
        design_point: &DesignPoint,
        open: &[bool],
        (base, loads): (&Wrench<3>, &[Wrench<3>]),
    ) -> Result<Option<Self>, Error> {
        let grasp = Grasp::new(design_space.contacts(design_point))?.with(design_space.settings);
        let (engine, response) = (&*grasp.engine, response(&grasp, open));
        let (mut rest, mut squeeze) = (engine.offsets(), response.at_rest());
        for i in chosen(rest.len(), &|i| design_point.presses[*i].is_some()) {
            squeeze[i][0] = core::mem::take(&mut rest[i][0]);
        }
        let mut sources = vec![
            response.state(&rest, &engine.load_unchecked(base)),
            response.state(&squeeze, &Vector::zeros()),
        ];
        let under = |load| response.state(&response.at_rest(), &engine.inside_unchecked(load));
        loads.iter().map(under).append_to(&mut sources);
        let Some(sources) = all_some(sources.into_iter()) else { return Ok(None) };
        let closing = indexed(&sources, &|(source, state): (usize, &ForcesAndTwist)| {
            let closing = |contact: usize| {
                let offset = if source == REST { rest[contact][0] } else { 0.0 };
                let stretch = response.normal_stretch(contact, offset, &state.twist);
                if open[contact] { stretch * normal_stiffness(&grasp, contact) } else { 0.0 }
            };
            numbered(open.len(), &closing)
        });
        let (open, judged) = (open.to_vec(), numbered(loads.len(), &|load| load));
        Ok(Some(Self { grasp, open, judged, sources, closing }))
    }

    /// The linear response of contact forces of this grasp to loads and commands while every contact sticks that is not left open.
    pub(super) fn response(&self) -> StickingResponse<'_> {
        response(&self.grasp, &self.open)
    }

    /// The force on a contact due to one source alone (base load with fixed commands, variable commands, or one load), in the contact frame, N.
    ///
    /// For a contact that is left open it is the closing force: the normal stretch that the contact's springs would have under this source if the
    /// contact were closed, times their stiffness. If the sum over all sources is negative, the contact has a gap.
    pub(super) fn by(&self, source: usize, contact: usize) -> SVector<f64, 3> {
        if self.open[contact] {
            return unit::<3>(0) * self.closing[source][contact];
        }
        self.sources[source].forces[contact]
    }

    /// The force on a contact under the base load, in the contact frame, N. It is due to this load, to fixed commands, and to variable commands. Zero
    /// for a contact that is left open.
    pub(super) fn at_rest(&self, contact: usize) -> SVector<f64, 3> {
        if self.open[contact] {
            return SVector::zeros();
        }
        self.by(REST, contact) + self.by(SQUEEZE, contact)
    }

    /// Whether a contact is left open: it touches without force and counts as open.
    pub(super) fn is_open(&self, contact: usize) -> bool {
        self.open.get(contact) == Some(&true)
    }

    /// The normal force that the springs of an open contact would exert under the base load and all commands if it were closed, N. If it is negative,
    /// the contact has a gap.
    pub(super) fn closing_at_rest(&self, contact: usize) -> f64 {
        self.closing[REST][contact] + self.closing[SQUEEZE][contact]
    }

    /// The number of loads whose forces are kept apart; a force of any direction counts as one load per axis.
    pub(super) fn loads(&self) -> usize {
        self.sources.len() - LOADS
    }

    /// For each variable (place or commanded normal force), in order, the changes of all contact forces per unit of this variable. `None` if nothing
    /// resists some load once a contact is at another place.
    pub(super) fn derivatives(
        &self,
        design_space: &DesignSpace<'_>,
        design_point: &DesignPoint,
    ) -> Option<Vec<BySource>> {
        let response = self.response();
        design_space
            .variables
            .iter()
            .map(|variable| self.derivative(&response, design_point, variable))
            .collect()
    }

    fn derivative(
        &self,
        response: &StickingResponse<'_>,
        design_point: &DesignPoint,
        variable: &DesignVariable,
    ) -> Option<BySource> {
        let &DesignVariable { contact, what, unit } = variable;
        // The data of the contact that depend on this variable, each with its rate of change per unit of the variable.
        let mut data = Vec::new();
        match what {
            DesignKind::Press { .. } => {
                // An idle contact (open, or touching without force, until a load pushes it) keeps its command.
                if !design_point.idle[contact] {
                    let command = unit / normal_stiffness(&self.grasp, contact);
                    data.push((Parameter::Command { contact, axis: 0 }, command));
                }
            }
            DesignKind::Along(direction) => {
                let location = design_point.spots[contact].as_ref()?;
                let (along, bend) = (&location.along[direction], location.bends[direction] * unit);
                let frame = self.grasp.frames().nth(contact)?;
                for axis in 0..self.grasp.engine.space().axes() {
                    data.push((Parameter::Point { contact, axis }, along[axis] * unit));
                    if axis > 0 {
                        data.push((
                            Parameter::Normal { contact, axis },
                            bend * along.dot(&frame.column(axis).into_owned()),
                        ));
                    }
                }
            }
        }
        let mut changes = vec![response.at_rest(); self.sources.len()];
        for (source, (state, sum)) in self.sources.iter().zip(&mut changes).enumerate() {
            if matches!(what, DesignKind::Press { .. }) && source != SQUEEZE {
                continue;
            }
            for (parameter, times) in data.iter().filter(|(_, times)| *times != 0.0) {
                let by = response.derivative(state, *parameter)?;
                add_times(sum, &by.forces, *times);
                for i in chosen(self.open.len(), &|i| self.open[*i]) {
                    let stretch =
                        response.normal_stretch_derivative(i, &state.twist, &by.twist, *parameter)?;
                    sum[i][0] += stretch * normal_stiffness(&self.grasp, i) * times;
                }
            }
        }
        Some(changes)
    }
}
