//! The loads of a question, and the load factor of first slip under them: the multiple of a load at which the first contact ceases to stick. The base
//! load acts before the other loads grow. The goal is the value that the search for better finger placement maximises: this load factor, or a reserve
//! of friction.

use super::goal::ImproveGoal;
use super::question::Improve;
use crate::ask::Grasp;
use crate::error::Error;
use crate::grasp::Wrench;
use crate::load_path::{Onset, Ramp};
use crate::numerics::{Each, numbered};
use crate::prelude::*;
use crate::squeeze::{Loads, WeakestDirection};

/// The base load of a question, the loads that are added to it one at a time, and the goal.
pub(super) struct LoadSet {
    pub(super) base: Wrench<3>,
    pub(super) loads: Vec<Wrench<3>>,
    pub(super) goal: ImproveGoal,
    /// The point, m, and the magnitude, N, of a force of any direction. `loads` then holds the force of this magnitude along each coordinate axis.
    /// `None` if the loads of the question are single loads, which act one at a time.
    pub(super) any: Option<([f64; 3], f64)>,
}

impl LoadSet {
    /// The loads of a question for finger placement; a contact has `axes` axes, two in the plane and three in space.
    pub(super) fn of(axes: usize, question: &Improve<3>, loads: &Loads<3>) -> Self {
        let (base, goal) = (question.base(), question.goal());
        match loads {
            Loads::Each(list) => Self { base, loads: list.clone(), goal, any: None },
            Loads::AnyForce { base: beside, size, point } => {
                let axis = |axis: usize| {
                    let force = [0, 1, 2].each(|k| if k == axis { *size } else { 0.0 });
                    Wrench::force_through(&(*point).into(), &force.into())
                };
                Self { base: base + *beside, loads: numbered(axes, &axis), goal, any: Some((*point, *size)) }
            }
            Loads::Turn(_) => Self { base, loads: Vec::new(), goal, any: None },
        }
    }

    /// The least load factor, over all loads, at which a contact ceases to stick, or beyond which nothing resists a load. `None` if a contact slides
    /// under the base load, or no equilibrium under the base load is found.
    pub(super) fn first_slip(&self, grasp: &Grasp<3>) -> Result<Option<f64>, Error> {
        if let Some((point, size)) = self.any {
            return Ok(match grasp.weakest_direction(self.base, point)? {
                WeakestDirection::Force { size: least, .. } => Some(least / size),
                WeakestDirection::Never => Some(f64::INFINITY),
                _ => None,
            });
        }
        let mut least = f64::INFINITY;
        for load in &self.loads {
            let onset = grasp.onset(Ramp::load(self.base, *load))?;
            let (Onset::At(_) | Onset::Never | Onset::GivesWay { .. }) = onset else { return Ok(None) };
            let Some(factor) = onset.factor() else { return Ok(None) };
            least = least.min(factor);
        }
        Ok(Some(least))
    }
}
