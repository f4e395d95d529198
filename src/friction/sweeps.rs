//! Gauss–Seidel over contacts: each in turn is given the force that its law asks for while the others stay.
//!
//! (M. Jean, Comput. Methods Appl. Mech. Eng. 177, 1999.) Slow to converge, and in stacks it may go round in circles, but hard to lead astray: it finds
//! roughly how large the forces are, from none at all. The rest is left to Newton's method.

use super::blocks::Blocks;
use super::one_contact;
use super::problem::{FrictionProblem, part};
#[cfg(not(feature = "std"))]
use crate::prelude::*;
use nalgebra::{DVector, SVector};

/// Goes through all contacts once. Returns how far forces have moved, as part of their size: √(Σ Δrᵀ A Δr / Σ rᵀ A r), A the own block of a contact.
pub(super) fn sweep<const C: usize>(
    problem: &FrictionProblem<C>,
    blocks: &Blocks<C>,
    r: &mut DVector<f64>,
) -> f64 {
    let (mut moved, mut size) = (0.0, 0.0);
    for i in 0..problem.len() {
        let before: SVector<f64, C> = part(r, i);
        let b = part::<C>(&problem.q, i) + blocks.by_others(i, r);
        let own = blocks.own(i);
        let Some(after) = one_contact::answer(own, &b, problem.mu[i]) else { continue };
        let change = after - before;
        moved += change.dot(&(own * change)).abs();
        size += after.dot(&(own * after)).abs();
        r.fixed_rows_mut::<C>(C * i).copy_from(&after);
    }
    if size > 0.0 { (moved / size).sqrt() } else { 0.0 }
}
