//! Gauss–Seidel over contacts: each contact in turn gets the force that Coulomb's law requires while all other forces are fixed.
//!
//! (M. Jean, Comput. Methods Appl. Mech. Eng. 177, 1999.) Sweeps converge slowly, and in stacks may cycle, but they are robust: from zero forces
//! they find the magnitude of the solution. Newton's method does the rest.

use super::blocks::Blocks;
use super::one_contact;
use super::problem::{FrictionProblem, part};
#[cfg(not(feature = "std"))]
use crate::prelude::*;
use nalgebra::{DVector, SVector};

/// Updates the force of every contact once. Returns the relative change of the forces, √(Σ Δrᵀ A Δr / Σ rᵀ A r), summed over the contacts. Here r is
/// a contact's force, Δr its change, and A the contact's diagonal block of the matrix W from contact forces to relative velocities.
pub(super) fn sweep<const C: usize>(
    problem: &FrictionProblem<C>,
    blocks: &Blocks<C>,
    r: &mut DVector<f64>,
) -> f64 {
    let (mut moved, mut size) = (0.0, 0.0);
    for i in 0..problem.len() {
        let before: SVector<f64, C> = part(r, i);
        let b = part::<C>(&problem.q, i) + blocks.by_others(i, r);
        let own = blocks.diagonal(i);
        let Some(after) = one_contact::answer(own, &b, problem.mu[i]) else { continue };
        let change = after - before;
        moved += change.dot(&(own * change)).abs();
        size += after.dot(&(own * after)).abs();
        r.fixed_rows_mut::<C>(C * i).copy_from(&after);
    }
    if size > 0.0 { (moved / size).sqrt() } else { 0.0 }
}
