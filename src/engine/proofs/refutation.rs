//! A proof that no equilibrium exists on the round cone, case by case, as a certificate that can be checked.
//!
//! The contact states are divided into cases, one contact at a time, until each case is contradicted. A label restricts the state of a contact, or
//! the direction of its friction; a case gives every contact a label. A contradiction of a case is a virtual motion y of the object with virtual
//! contact forces φ_i that balance one another, `Σ G_i φ_i = 0`. Contact i has the grasp map G_i, the offset a_i (commanded displacement minus
//! clearance and slip) and the force F_i. Its stretch at the twist q is `v_i = a_i - G_iᵀq`. If there were an equilibrium under the load W,
//!
//! ```text
//! Σ (φ_i·v_i + (G_iᵀy)·F_i)  =  Σ φ_i·a_i - y·W  >  0
//! ```
//!
//! would hold at its twist q; the check of a certificate verifies that the right side is positive. If, under the labels of the case, no contact's
//! term on the left side can be positive, the case has no equilibrium. The elastic trial is the solution in which every contact sticks.

use crate::numerics::{IntoList, Reals, Vector};
use nalgebra::SVector;

use super::tolerances::{ESCAPE, LEAST_WORK};
use crate::contact::{Label, LocalLaw, State};
use crate::grasp::Site;
use crate::object::{LinearProblem, Problem};
use crate::prelude::*;

/// A step of the proof that no equilibrium exists, for the present case of contact states. Steps are in depth-first order: a division is followed by
/// all steps of its second case, then by all steps of its first case.
#[derive(Debug, Clone)]
pub(crate) enum ProofStep {
    /// The present case is divided into two. In each case the label of this contact, which restricts its state, is one of the `halves`. Together both
    /// labels allow every contact state that the contact's label allowed before.
    Divided { contact: usize, halves: [Label; 2] },
    /// The present case is contradicted by a virtual motion and virtual forces.
    Contradicted { motion: Vector, forces: Vec<SVector<f64, 3>> },
}

/// Checks a proof that no equilibrium exists, without searching. The proof may miss an equilibrium because of rounding. Returns a lower bound of the
/// norm of such an equilibrium, divided by the norm of the elastic trial. The norm is that of stretches and forces in energy units, √J. `None` if the
/// steps omit a case or do not contradict it, or if the lower bound is below [`ESCAPE`].
pub(crate) fn check(problem: &Problem, steps: &[ProofStep]) -> Option<f64> {
    let trial = problem.trial();
    let state = trial.solve(problem.sites, &problem.offsets, problem.load()).ok()?;
    let stored = |forces: &[SVector<f64, 3>]| {
        problem.sites.iter().zip(forces).map(|(site, f)| 2.0 * site.springs.stored(f)).added()
    };
    let data = stored(&state.forces).sqrt();
    let mut open = vec![problem.each(|local| local.first_label())];
    let mut least = f64::INFINITY;
    for step in steps {
        let labels = open.pop()?;
        match step {
            ProofStep::Divided { contact, halves } => {
                if !labels.get(*contact)?.is_covered_by(halves) {
                    return None;
                }
                for half in halves {
                    let mut labels = labels.clone();
                    labels[*contact] = *half;
                    open.push(labels);
                }
            }
            ProofStep::Contradicted { motion, forces } => {
                least = least.min(escape(problem, &labels, motion, forces)? / data);
            }
        }
    }
    (open.is_empty() && least >= ESCAPE).then_some(least)
}

/// Searches for a proof, with a single case, that no equilibrium exists with the given offsets and load. Rounding may hide an equilibrium from the
/// proof. Returns a lower bound of the norm, √J, of its stretches and forces, divided by that norm of the elastic trial. `None` without a proof.
///
/// In a rate problem (for derivatives along a load path), all contacts that may slide or open are assumed to do so. The tangent stiffness
/// `Σ G_i C_i G_iᵀ` of the object may then be singular; C_i is the tangent stiffness and G_i the grasp map of contact i. A left null vector is a
/// virtual motion y for which the virtual forces `-C_iᵀG_iᵀy` balance one another. [`check`] verifies the proof for all contact states, not only for
/// the assumed ones.
pub(crate) fn yields(problem: &Problem) -> Option<f64> {
    let states = problem.yielding();
    let motion =
        LinearProblem::new(problem, &states).motion_without_response(&problem.offsets, &problem.wrench)?;
    let forces = |sign: f64| {
        let force = |((site, local), state): ((&Site, LocalLaw<'_>), &State)| {
            local.tangent(state).matrix().tr_mul(&site.map.tr_mul(&motion)) * -sign
        };
        problem.sites.iter().zip(problem.locals()).zip(&states).map(force).list()
    };
    let step = |sign: f64| ProofStep::Contradicted { motion: &motion * sign, forces: forces(sign) };
    [-1.0, 1.0].into_iter().find_map(|sign| check(problem, &[step(sign)]))
}

/// Rounding may hide an equilibrium from the contradiction of a case. Returns a lower bound of the norm of such an equilibrium: the norm, in √J, of
/// the stretches and forces of all contacts together. `None` if there is no contradiction.
fn escape(problem: &Problem, labels: &[Label], motion: &Vector, forces: &[SVector<f64, 3>]) -> Option<f64> {
    if forces.len() != problem.len() {
        return None;
    }
    let (mut gain, mut size, mut worst) = (-motion.dot(&problem.wrench), 0.0, 0.0_f64);
    let mut unbalanced = Vector::zeros();
    let mut balanced_size = 0.0;
    for (i, phi) in forces.iter().enumerate() {
        let (local, site) = (problem.local(i), &problem.sites[i]);
        let u = site.map.tr_mul(motion);
        gain += phi.dot(&problem.offsets[i]);
        site.map.push(phi, &mut unbalanced);
        let pushed = local.springs.force(&u);
        balanced_size += site.map.pushed_norm(phi) + site.map.pushed_norm(&pushed);
        size += 2.0 * (local.springs.stored(phi) + local.springs.stored(&pushed));
        worst = worst.max(local.most_work(&labels[i], phi, &u));
    }
    // The imbalance of virtual forces may be 1e-13 of a sum of norms. The sum is over their wrenches and over the wrenches of the spring forces that
    // the virtual motion causes. Such an imbalance hides an equilibrium only if its motion is 1e13 times as large as that of the elastic trial.
    let is_balanced = unbalanced.norm() <= 1e-13 * balanced_size;
    (is_balanced && gain > 0.0).then(|| gain / worst.max(LEAST_WORK * size.sqrt()))
}
