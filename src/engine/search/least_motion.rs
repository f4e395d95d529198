//! The position of the object in the solution if no spring resists some motions. Positions are admissible if gaps and slips keep their signs. One
//! position, q₀, closes the gaps of contacts that touched before anything moved, in the sense of least squares. The admissible position nearest to q₀
//! is chosen.
//!
//! Forces do not depend on the motions that no spring resists (free motions), the columns of a matrix V. Any position `q = q₀ + V z` is a solution as
//! long as gaps and slips keep their signs. These are conditions `c + g·z >= 0` on the coefficients z. c is the value of a gap or slip at q₀, and g
//! its change per unit of z. The position q with the least |z| is unique. It depends neither on the method that found the contact states nor on the
//! coordinate frame.

use nalgebra::SVector;

use super::answer::SearchSolution;
use super::candidate::for_each_condition;
use crate::contact::ZERO_SLACK;
use crate::numerics::tolerances::SOLVED_ROUNDING;
use crate::numerics::{IntoList, Singular, Vector, chosen, least_distance, mapped, matrix_of, vector_of};
use crate::object::Problem;
use crate::prelude::*;

/// The solution, shifted along motions that no spring resists to the position nearest to q₀ at which gaps and slips keep their signs. At q₀ the
/// contacts that touched before anything moved touch again, in the sense of least squares.
pub(super) fn at_the_least_motion(problem: &Problem, mut found: SearchSolution) -> SearchSolution {
    // If a contact slides on the round cone, its conditions are not linear, since the direction of friction depends on the slip. The solution is then
    // returned unshifted.
    if found.free_motions.is_empty() || found.states.iter().any(|state| state.slide().is_some()) {
        return found;
    }
    let along = |twist: Vector, v: &Vector| {
        let part = v.dot(&twist);
        twist - v * part
    };
    let base = found.free_motions.iter().fold(found.twist.clone(), along);
    let base = &base + to_what_touches(problem, &found, &base);
    let conditions = |problem: &Problem, forces: &[SVector<f64, 3>], twist: &Vector| {
        let mut list = Vec::new();
        for_each_condition(problem, &found.states, forces, twist, &mut |value, size| {
            list.push((value, size));
        });
        list
    };
    let values = conditions(problem, &found.forces, &base);
    let nothing = vec![SVector::zeros(); problem.len()];
    let moving = Problem { offsets: nothing.clone(), ..problem.clone() };
    let changes: Vec<_> = mapped(&found.free_motions, &|v| conditions(&moving, &nothing, v));
    let mut rows: Vec<(f64, Vec<f64>)> = Vec::new();
    for (i, (value, _)) in values.iter().enumerate() {
        let changes = changes.iter().map(|list| list[i]);
        // A gap or slip gives a condition only if it depends on some of the free motions. Its change along such a unit motion must exceed the
        // fraction `SOLVED_ROUNDING` of the rounding scale `size` of this change.
        if changes.clone().any(|(change, size)| change.abs() > SOLVED_ROUNDING * size) {
            rows.push((*value, changes.map(|(change, _)| change).list()));
        }
    }
    if let Some(parts) = least_distance(rows) {
        let moved = found.free_motions.iter().zip(&parts).map(|(v, part)| v * *part);
        found.twist = moved.fold(base, |sum, v| sum + v);
    }
    found
}

/// Returns the shortest motion that no spring resists and that closes, in the sense of least squares, the gaps of open contacts that touched before
/// anything moved.
fn to_what_touches(problem: &Problem, found: &SearchSolution, base: &Vector) -> Vector {
    let touches = |i: &usize| {
        let reach = problem.offsets[*i][0];
        let open = found.states[*i].is_open() && problem.local(*i).may_open();
        open && reach >= -ZERO_SLACK * problem.span(*i, base)
    };
    let open: Vec<usize> = chosen(problem.len(), &touches);
    if open.is_empty() {
        return Vector::zeros();
    }
    let (free, normal) = (&found.free_motions, |i: usize| problem.sites[i].map.column(0));
    let rows = matrix_of(open.len(), free.len(), &|r, k| normal(open[r]).dot(&free[k]));
    let gaps = vector_of(open.len(), &|r| problem.stretch(open[r], base)[0]);
    // `rows` has the normal components of the free motions at the open contacts. Singular values of this matrix below 1e-9 are taken as zero: only a
    // very large motion in such a direction closes a gap.
    let mut motion = Vector::zeros();
    for (v, part) in free.iter().zip(&Singular::new(&rows).solve(&gaps, 1e-9)) {
        motion += v * *part;
    }
    motion
}
