//! The response of a grasp whose contacts keep their states. It is linear in loads, commands and small changes of the grasp's numbers, such as
//! stiffnesses. One factorisation serves all of them. In the engine's coordinates moments and rotations refer to the centroid of the contacts. An
//! offset of a finger is its command (a prescribed displacement) minus clearance.
//!
//! Forces are listed for all contacts, then for the drives of a hand (springs of joints and tendons), which are treated like contacts. A contact that
//! sticks keeps its state if its force satisfies linear conditions: F is inside every facet of the friction cone, or on the round cone
//! `|F_t| <= μ F_n`. Code names call these conditions [`Edges`].

use alloc::sync::Arc;

use nalgebra::SVector;

use super::cone::Cone;
use crate::contact::{Edges, LocalLaw, State};
use crate::grasp::{Engine, Motion, Wrench};
use crate::numerics::{IntoList, Vector, largest, unit};
use crate::object::{ForcesAndTwist, LinearProblem, Load, Problem};
use crate::prelude::*;
use crate::search::Settings;

/// The linear response of forces and twist to loads and finger offsets, while contacts and drives keep known states.
pub(crate) struct StickingResponse<'g> {
    pub(crate) grasp: &'g Engine,
    pub(super) problem: Problem<'g>,
    pub(crate) states: Vec<State>,
    pub(crate) linear_problem: Arc<LinearProblem>,
    /// For each contact and drive, the conditions under which it keeps its state: on its force if it sticks, on its gap if it is open.
    pub(crate) edges: Vec<Edges>,
}

/// Forces of all contacts and drives, N, in `of`. For each force `sizes` has its rounding scale, N: the magnitude of the terms that add up to the
/// force, to which the rounding error is proportional.
#[derive(Debug, Clone)]
pub(crate) struct ContactForces {
    pub(crate) of: Vec<SVector<f64, 3>>,
    pub(crate) sizes: Vec<f64>,
}

impl<'g> StickingResponse<'g> {
    /// The linear response of the grasp while every contact and drive sticks, except those that their law keeps open. The friction cone is that of
    /// the settings.
    pub(crate) fn new(grasp: &'g Engine, settings: &Settings) -> Self {
        let problem = Self::at_rest_on(grasp, Cone::of(grasp.space(), settings));
        let states = problem.trial_states();
        Self::of(grasp, problem, &states)
    }

    /// The linear response of the grasp while contacts and drives keep `states`, with the friction cone `cone`.
    pub(crate) fn in_states(grasp: &'g Engine, cone: Cone, states: &[State]) -> Self {
        Self::of(grasp, Self::at_rest_on(grasp, cone), states)
    }

    fn at_rest_on(grasp: &'g Engine, cone: Cone) -> Problem<'g> {
        grasp.problem_on(cone, grasp.offsets(), &Load::from(&Vector::zeros()))
    }

    /// The linear response of the grasp while contacts and drives keep `states`. Offsets and load of `problem` are not used.
    pub(crate) fn of(grasp: &'g Engine, problem: Problem<'g>, states: &[State]) -> Self {
        let linear_problem = problem.linear_problem(states);
        let edges = problem.locals().zip(states).map(|(local, state)| local.edges(state)).list();
        Self { grasp, problem, states: states.to_vec(), linear_problem, edges }
    }

    /// The contact law, with friction cone and springs, of one contact. For an index after the contacts, the law of a drive.
    pub(crate) fn law(&self, contact: usize) -> LocalLaw<'_> {
        self.problem.local(contact)
    }

    /// The stretch of the normal spring of one contact, m. The finger has the offset `offset` (command minus clearance) along the normal, and the
    /// object the twist `twist`. Negative if the contact has a gap.
    pub(crate) fn normal_stretch(&self, contact: usize, offset: f64, twist: &Vector) -> f64 {
        self.problem.sites[contact].stretch(&unit::<3>(0).scale(offset), twist)[0]
    }

    /// A list of zero offsets, one for each contact and drive. An offset is a command minus clearance.
    pub(crate) fn at_rest(&self) -> Vec<SVector<f64, 3>> {
        vec![SVector::zeros(); self.problem.len()]
    }

    /// Forces of contacts and drives under the finger offsets `offsets` (commands minus clearances) and the load `load` in the engine's
    /// coordinates. Contacts and drives keep the states of this response. The error value is a motion that no spring resists and along which the
    /// load does work.
    pub(crate) fn forces(
        &self,
        offsets: &[SVector<f64, 3>],
        load: &Vector,
    ) -> Result<ContactForces, Motion<3>> {
        match self.linear_problem.solve(self.problem.sites, offsets, load) {
            Ok(state) => {
                let sizes = self.problem.force_sizes(offsets, load.norm(), &state);
                Ok(ContactForces { of: state.forces, sizes })
            }
            Err(unbalanced) => {
                let motion = unbalanced.motion.unwrap_or_else(Vector::zeros);
                Err(self.grasp.motion_outside(&motion))
            }
        }
    }

    /// Forces of contacts and drives under a load alone, without commands. The error value is a motion that no spring resists and along which
    /// the load does work.
    pub(crate) fn by_load(&self, load: &Wrench<3>) -> Result<ContactForces, Motion<3>> {
        self.forces(&self.at_rest(), &self.grasp.inside_unchecked(load))
    }

    /// Forces and motion of the object under the finger offsets `offsets` and the load `load`, in the engine's coordinates. `None` if in the contact
    /// states of this response no forces balance the load.
    pub(crate) fn state(&self, offsets: &[SVector<f64, 3>], load: &Vector) -> Option<ForcesAndTwist> {
        self.linear_problem.solve(self.problem.sites, offsets, load).ok()
    }
}

impl Engine {
    /// The least margin of all contacts and drives under a load, as a fraction of the largest force. The margin is the unused friction
    /// `μ F_n - |F_t|`, or without friction the normal force, N. The forces are computed as if every contact stuck, so that a margin may be negative:
    /// the force is then outside its cone. `None` if the load is invalid, if nothing resists it, or if all forces are zero.
    pub(crate) fn sticking_margin(&self, load: &Wrench<3>, settings: &Settings) -> Option<f64> {
        let sticking = StickingResponse::new(self, settings);
        let forces = sticking.forces(&self.offsets(), &self.load_alone(load, "load").ok()?).ok()?.of;
        let largest = largest(&forces, &SVector::norm);
        let worst = |(edges, force): (&Edges, &SVector<f64, 3>)| Some(edges.worst(force)?.1);
        let least = sticking.edges.iter().zip(&forces).filter_map(worst).min_by(f64::total_cmp)?;
        (largest > 0.0).then(|| least / largest)
    }
}
