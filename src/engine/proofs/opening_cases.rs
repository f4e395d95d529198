//! A proof that no equilibrium exists beyond a load, if the contacts have too many combinations of contact states to try them all. For each choice of
//! open contacts the remaining conditions are convex.
//!
//! With the closed contacts chosen, contact forces F_i that balance the load W exist only if there are a motion q and friction forces with
//!
//! ```text
//! Σ G_i F_i + W = 0,    F_n = k (a_n - n·u(q)),    F_t in F_n times the friction polygon    closed
//! n·u(q) - a_n >= 0                                                                        open
//! ```
//!
//! G_i is the grasp map, k the normal stiffness, a_n the commanded normal offset (commanded displacement minus clearance), and n·u(q) the normal
//! motion of a contact. These conditions do not fix the direction of friction. They are linear, Γ x + w = 0 with unknowns x >= 0, columns γ of the
//! matrix Γ and a vector w. At the x >= 0 for which Γ x + w is smallest, this residual y has y·γ >= 0 for all columns γ. If y·w > 0, then y proves
//! that no x solves the conditions (Farkas). Along a line of loads w is linear. Thus y·w >= 0 at the first load and y·w > 0 at the last prove that no
//! load between them can be balanced.

use nalgebra::{DMatrix, DVector, SVector};

use super::escape::counts_from_here_on;
use crate::contact::LocalLaw;
use crate::lcp::{Lcp, Outcome, Settings};
use crate::numerics::{Vector, chosen, every_index, largest, unit};
use crate::object::Problem;
use crate::prelude::*;

/// True if it is proved that contact forces balance no load on a line of loads. The line leads from the load of the problem `here` to that of the
/// problem `past`, slightly farther on the load path. The first millionth of the line is excepted.
pub(crate) fn nothing_holds(here: &Problem, past: &Problem) -> bool {
    let free: Vec<usize> = chosen(here.len(), &|&i| here.local(i).may_open());
    let whole = !here.locals().any(|local| local.is_absent() || local.is_on_an_edge());
    // If n contacts may open, there are 2ⁿ choices of open contacts. For n > 8 it takes too long to try all of them.
    whole
        && free.len() <= 8
        && every_index(1_usize << free.len(), &|choice| {
            let mut open = vec![false; here.len()];
            for (bit, &i) in free.iter().enumerate() {
                open[i] = choice >> bit & 1 == 1;
            }
            proved(&columns(here, &open), &constant(here, &open), &constant(past, &open))
        })
}

/// Whether the linear system `Γ x + w = 0` has a row for this contact. The first rows of the system are the equations of equilibrium. The further
/// rows are inequalities, in the order of contacts: one for each contact that may open or has friction.
fn has_row(local: &LocalLaw<'_>) -> bool {
    local.pairs() > 0
}

fn rows(problem: &Problem) -> usize {
    problem.size().count() + problem.locals().filter(has_row).count()
}

/// Number of axes along which the force of a closed contact follows from its springs. A bonded contact, which neither opens nor slides, has all of
/// its axes. Any other contact has the normal alone; its friction is a separate unknown.
fn springs(local: &LocalLaw<'_>) -> usize {
    if local.is_bonded() { local.springs.axes() } else { 1 }
}

/// What given stretches of the contacts contribute to the equations and inequalities of the linear system `Γ x + w = 0`, without friction. The first
/// entries are `wrench` plus the wrench of the spring forces of closed contacts. Then each contact with an inequality has an entry: the normal force
/// of its springs at the stretch `stretch`, with the opposite sign if the contact is open.
fn response(
    problem: &Problem,
    open: &[bool],
    stretch: &dyn Fn(usize) -> SVector<f64, 3>,
    mut wrench: Vector,
) -> DVector<f64> {
    let mut w = DVector::zeros(rows(problem));
    let balance = problem.size().count();
    let mut row = balance;
    for (i, (site, local)) in problem.sites.iter().zip(problem.locals()).enumerate() {
        let pushed = site.springs.force(&stretch(i));
        if has_row(&local) {
            w[row] = if open[i] { -pushed[0] } else { pushed[0] };
            row += 1;
        }
        if !open[i] {
            for axis in 0..springs(&local) {
                wrench += site.map.column(axis) * pushed[axis];
            }
        }
    }
    w.iter_mut().zip(wrench.iter()).take(balance).for_each(|(w, wrench)| *w = *wrench);
    w
}

/// The constant vector w of the linear system `Γ x + w = 0`, which results from offsets and load.
fn constant(problem: &Problem, open: &[bool]) -> DVector<f64> {
    response(problem, open, &|i| problem.offsets[i], problem.wrench.clone())
}

/// Columns of the matrix Γ of `Γ x + w = 0`, scaled to length one: motions in both directions, friction forces, and slacks of the inequalities.
fn columns(problem: &Problem, open: &[bool]) -> Vec<DVector<f64>> {
    let count = rows(problem);
    let mut list = Vec::new();
    let mut push = |column: DVector<f64>, both_ways: bool| {
        let size = column.norm();
        if size > 0.0 {
            if both_ways {
                list.push(&column / -size);
            }
            list.push(column / size);
        }
    };
    let size = problem.size();
    for axis in 0..size.count() {
        let along = Vector::unit(size, axis);
        let stretch = |i: usize| -problem.sites[i].map.tr_mul(&along);
        push(response(problem, open, &stretch, Vector::zeros()), true);
    }
    let mut row = size.count();
    for (i, (site, local)) in problem.sites.iter().zip(problem.locals()).enumerate() {
        let own = has_row(&local).then_some(row);
        let force = |f: &SVector<f64, 3>, taken: f64| {
            let mut column = DVector::zeros(count);
            column.iter_mut().zip((&site.map * f).iter()).for_each(|(to, from)| *to = *from);
            if let Some(row) = own {
                column[row] = -taken;
            }
            column
        };
        if !open[i] && local.never_slides() && !local.is_bonded() {
            for axis in 1..local.springs.axes() {
                push(force(&unit(axis), 0.0), true);
            }
        } else if !open[i] && !local.facets().is_empty() {
            for corner in &local.polygon.corners {
                push(force(&(corner * local.cone().limit(1.0)), 1.0), false);
            }
        }
        if let Some(row) = own {
            let mut slack = DVector::zeros(count);
            slack[row] = -1.0;
            push(slack, false);
        }
        row += usize::from(own.is_some());
    }
    list
}

fn proved(columns: &[DVector<f64>], here: &DVector<f64>, past: &DVector<f64>) -> bool {
    let size = past.norm();
    let gamma = DMatrix::from_columns(columns);
    let w = past / size;
    let Ok(lcp) = Lcp::new(gamma.tr_mul(&gamma), gamma.tr_mul(&w)) else { return false };
    let settings = Settings { enumerate_up_to: 0, ..Settings::default() };
    let Outcome::Solved(solution) = lcp.solve_with(&settings) else { return false };
    let y = (&gamma * &solution.z + &w).normalize();
    let negative_work = largest(columns, &|column| -y.dot(column));
    let (here, past) = (y.dot(here) / size, y.dot(&w));
    past > 0.0 && counts_from_here_on(here, past, negative_work, 1.0)
}
