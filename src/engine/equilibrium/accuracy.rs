//! Estimated errors of forces and displacements of an equilibrium, and the condition number of its contact forces. A command is a prescribed
//! displacement of a finger. An equilibrium stores the solution, in the engine's scaled units, from which it was made, unless it was read from a
//! file.

use nalgebra::SVector;

use super::answer::{Equilibrium, LocalAnswer};
use super::cone::Cone;
use crate::contact::State;
use crate::grasp::{Engine, Wrench};
use crate::numerics::{Draw, IntoList, Reals, Vector, add_times};
use crate::object::{ForcesAndTwist, LinearProblem, Load, PreciseTwist, Problem};
use crate::prelude::*;
use crate::search::FoundBy;
#[cfg(feature = "serde")]
use crate::serial::AsComputed;

/// Estimated errors of an equilibrium with respect to the exact equilibrium with the same contact states, and the condition number of the contact
/// forces.
///
/// The residuals of all conditions are evaluated in twice the working precision. Solving the linear problem with these residuals as right-hand side
/// gives the errors. For the condition number all given numbers (points, frames, stiffnesses, friction, commands, load) are varied at once, with
/// three patterns of signs. This is a small-sample estimate (C. S. Kenney and A. J. Laub, SIAM J. Sci. Comput. 15, 1994).
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct Accuracy {
    /// Estimated error of the contact forces, N: the largest error of all contacts. The given points, contact frames, stiffnesses, friction, commands
    /// and load are taken as exact.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
    pub force: f64,
    /// Estimated error of the displacements of the body at the contacts, m: the largest error of all contacts. Errors along motions that nothing
    /// resists are not included.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
    pub displacement: f64,
    /// Condition number of the contact forces with respect to all given numbers: points, contact frames, stiffnesses, friction, commands and load. A
    /// relative error ε of these numbers causes force errors of about `condition · ε`, relative to the largest force. Rounding of a normal to double
    /// precision alone causes `condition · 1.1e-16`.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
    pub condition: f64,
}

impl Engine {
    /// Estimated errors of an equilibrium. `None` if the equilibrium lacks the stored solution of the engine, because it was read from a file. `None`
    /// also for an equilibrium on a load path on the round cone in which a contact slides.
    pub(crate) fn accuracy(&self, equilibrium: &Equilibrium<3>) -> Option<Accuracy> {
        let problem = self.problem_of(equilibrium)?;
        // The slips along a load path on the round cone depend on its history, so that the present equilibrium does not determine them.
        let slides = equilibrium.local.states.iter().any(State::slides);
        if equilibrium.rule == FoundBy::LoadPath && equilibrium.cone == Cone::Round && slides {
            return None;
        }
        let at = ForcesAndTwist { forces: equilibrium.site_forces(), twist: equilibrium.local.twist.to() };
        let twist = PreciseTwist::new(problem.size(), at.twist.clone());
        // The direction in which each contact slides on the round cone is recomputed from the present force and slip.
        let states = problem.slid_on(&equilibrium.local.states, &at.forces, &twist);
        let linear_problem = LinearProblem::new(&problem, &states);
        let largest = problem.largest_force(&at.forces, &at.twist);
        let missing = linear_problem.correction(&problem, &states, (&at.forces, &twist), largest);
        let size = |forces: &[SVector<f64, 3>]| forces.iter().map(nalgebra::Matrix::norm).most();
        let mut displacement = 0.0_f64;
        for (i, site) in self.sites().iter().enumerate() {
            let moved = site.map.tr_mul(&missing.twist).norm();
            // The displacement of a contact is a sum of terms up to `span`, m. The rounding error of storing this displacement, half a unit in the
            // last place of these terms, is added to its error `moved` in the solution.
            displacement = displacement.max(moved + 0.5 * f64::EPSILON * problem.span(i, &at.twist));
        }
        let varied = |pattern| {
            let variation = Variation::new(self, &equilibrium.load, &problem, &states, &at, pattern);
            let mut forces = linear_problem.forces_of(&variation.stretches, &variation.load);
            add_times(&mut forces, &variation.friction_changes, 1.0);
            size(&forces)
        };
        // All given numbers of grasp, commands and load are varied together, three times, each time with another pattern of signs.
        let most = (0..3).map(varied).most();
        Some(Accuracy {
            force: size(&missing.forces) + missing.doubt,
            displacement,
            condition: if largest > 0.0 { most / largest } else { 0.0 },
        })
    }

    /// The equilibrium problem (contact laws, load and finger offsets, i.e. commands minus clearances and slips) that an equilibrium solves. `None`
    /// if the equilibrium lacks the engine's own solution, for example because it was read from a file.
    pub(crate) fn problem_of(&self, equilibrium: &Equilibrium<3>) -> Option<Problem<'_>> {
        if !equilibrium.knows_all_of(self.sites().len()) {
            return None;
        }
        let wrench = self.load_unchecked(&equilibrium.load);
        let load = Load { wrench, rounding_error: self.inside_rounding_error(&equilibrium.load) };
        let LocalAnswer { slips, cones, offsets, .. } = &equilibrium.local;
        let problem = self.problem_on(equilibrium.cone, offsets.clone(), &load);
        Some(Problem { slips: slips.clone(), cones: cones.clone(), ..problem })
    }
}

/// A variation of all given numbers: every number of grasp, commands and load changes by plus or minus its own value, to first order. The fields hold
/// the resulting changes of contact stretches, friction forces and load.
struct Variation {
    /// Change of the stretch of each contact, m.
    stretches: Vec<SVector<f64, 3>>,
    load: Vector,
    /// Change of the friction force of each contact due to the change of its coefficient of friction, N.
    friction_changes: Vec<SVector<f64, 3>>,
}

impl Variation {
    fn new(
        grasp: &Engine,
        load: &Wrench<3>,
        problem: &Problem,
        states: &[State],
        at: &ForcesAndTwist,
        pattern: u64,
    ) -> Self {
        let mut signs = Draw::new([pattern, 0, 0]);
        let space = grasp.space();
        let load = load.coordinates(space).map(|w| w * signs.sign());
        let n = problem.len();
        let mut variation = Self {
            stretches: vec![SVector::zeros(); n],
            load: grasp.inside_unchecked(&Wrench::among(space, &load)),
            friction_changes: vec![SVector::zeros(); n],
        };
        if let Some(bodies) = grasp.bodies() {
            let own = bodies.loads.iter().map(|load| load.coordinates(space).map(|w| w * signs.sign()));
            let own: Vec<_> = own.map(|load| Wrench::among(space, &load)).list();
            variation.load += grasp.combine_wrenches(bodies, &own);
        }
        for (i, site) in problem.sites.iter().enumerate() {
            let (force, offset) = (&at.forces[i], &problem.offsets[i]);
            if states[i].slides() {
                let sign = signs.sign();
                for a in 1..3 {
                    variation.friction_changes[i][a] = force[a] * sign;
                }
            }
            site.map.push(&variation.friction_changes[i], &mut variation.load);
            // The coordinates of a contact point are varied by their own magnitude: a relative error refers to the distance from the origin, not from
            // neighbouring points.
            let point = grasp
                .contacts()
                .get(i)
                .map_or_else(SVector::zeros, |contact| contact.point.map(|x| x * signs.sign()));
            let give = site.springs.deflection(force);
            for a in 0..site.springs.axes() {
                let axis = site.frame.column(a).into_owned();
                let moved = grasp.moments_of(i, &point, &axis);
                let stretch = &mut variation.stretches[i][a];
                *stretch = offset[a] * signs.sign() + give[a] * signs.sign();
                for k in 0..site.map.size().count() {
                    let turned = site.map[(k, a)] * signs.sign();
                    let entry = turned + moved[k];
                    *stretch += entry * at.twist[k];
                    variation.load[k] += entry * force[a];
                }
            }
        }
        variation
    }
}
