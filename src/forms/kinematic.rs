//! The kinematic form (see [`super`]): jumps, gaps and slips, on top of the elastic trial state.
//!
//! The projector is made of orthogonal factors, in which stiffness ratios do not show:
//!
//! ```text
//! P = K - K Gᵀ (G K Gᵀ)⁻¹ G K = K^{1/2} (I - Q Qᵀ) K^{1/2},   K^{1/2}Gᵀ = Q R
//! ```

use nalgebra::{DMatrix, DVector, SVector};

use super::rows::{Form, Row};
use crate::contact::{LocalLaw, Mode, State, tangential};
use crate::lcp::{Basis, Lcp};
use crate::numerics::{Size, Vector};
use crate::object::{Piece, PieceState, Problem};

/// One row in energy coordinates: `ŵ = row · x`, `x` jumps by `column ẑ`, with x = K^{-1/2} F.
struct Jump<D: Size, const C: usize> {
    contact: usize,
    row: SVector<f64, C>,
    column: SVector<f64, C>,
    /// Qᵀ applied to both.
    row_seen: Vector<D>,
    column_seen: Vector<D>,
    w_unit: f64,
    z_unit: f64,
}

/// Every row that the contacts need, on the trial state in which every contact sticks.
fn jumps<D: Size, const C: usize>(problem: &Problem<D, C>, trial: &Piece<D, C>) -> Vec<(Row, Jump<D, C>)> {
    let mut jumps = Vec::new();
    for (contact, local) in problem.locals().enumerate() {
        let (root, seen) = (local.springs.root(), trial.seen(contact));
        let mut push = |meaning: Row, row: SVector<f64, C>, column: SVector<f64, C>| {
            let (w_unit, z_unit) = (row.norm(), 1.0 / column.norm());
            let (row, column) = (row / w_unit, column * z_unit);
            let (row_seen, column_seen) = (&seen * row, &seen * column);
            jumps.push((meaning, Jump { contact, row, column, row_seen, column_seen, w_unit, z_unit }));
        };
        if local.may_open() {
            let normal = root - tangential(&root);
            push(Row::Gap { contact }, normal, normal);
        }
        for (facet, h) in local.facets().iter().enumerate() {
            let row = root.component_mul(&local.cone().facet_row(h));
            push(Row::Slip { contact, facet }, row, tangential(&row));
        }
    }
    jumps
}

/// The kinematic form on the trial state in which every contact sticks; `None` if no contact needs a row or a number
/// overflows.
pub(crate) fn kinematic_form<D: Size, const C: usize>(
    problem: &Problem<D, C>,
    trial: &Piece<D, C>,
    state: &PieceState<D, C>,
) -> Option<Form> {
    let (rows, jumps): (Vec<_>, Vec<_>) = jumps(problem, trial).into_iter().unzip();
    if jumps.is_empty() {
        return None;
    }
    let n = jumps.len();
    let m = DMatrix::from_fn(n, n, |i, j| {
        let (to, from) = (&jumps[i], &jumps[j]);
        let own = if to.contact == from.contact { to.row.dot(&from.column) } else { 0.0 };
        own - to.row_seen.dot(&from.column_seen)
    });
    let q = DVector::from_fn(n, |i, _| {
        let jump = &jumps[i];
        let springs = &problem.sites[jump.contact].springs;
        let force = &state.forces[jump.contact];
        (0..springs.axes()).map(|a| jump.row[a] * force[a] / springs.root_along(a)).sum()
    });
    let z_unit = jumps.iter().map(|jump| jump.z_unit).collect();
    let w_unit = jumps.iter().map(|jump| jump.w_unit).collect();
    Some(Form { lcp: Lcp::new(m, q).ok()?, rows, z_unit, w_unit })
}

/// The contact states of a complementary basis.
pub(crate) fn kinematic_states<D: Size, const C: usize>(
    problem: &Problem<D, C>,
    form: &Form,
    basis: &Basis,
) -> Vec<State<C>> {
    let mut slipping: Vec<Vec<u16>> = vec![Vec::new(); problem.len()];
    let mut open = vec![false; problem.len()];
    for (i, row) in form.rows.iter().enumerate() {
        if basis.contains(i) {
            match *row {
                Row::Gap { contact } => open[contact] = true,
                Row::Slip { contact, facet } => slipping[contact].extend(u16::try_from(facet)),
                _ => {}
            }
        }
    }
    let state = |(contact, local): (usize, LocalLaw<'_, C>)| {
        if open[contact] {
            Mode::Open
        } else if slipping[contact].is_empty() {
            local.unjumped()
        } else {
            local.slipping_state(&slipping[contact]).into()
        }
    };
    problem.locals().enumerate().map(state).collect()
}
