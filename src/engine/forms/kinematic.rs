//! The kinematic form of a grasp: a linear complementarity problem whose unknowns are jumps, the gaps and slips of the contacts. Its slacks are
//! normal forces and friction margins. All jumps are zero in the elastic trial, the solution in which every contact sticks.
//!
//! The form needs the matrix P, the change of all contact forces per unit of a displacement at one contact while the object gives way. G is the grasp
//! map of all contacts, and K the diagonal matrix of their stiffnesses. P is computed by orthogonal factors Q and R, whose accuracy does not depend
//! on ratios of stiffnesses:
//!
//! ```text
//! P = K - K Gᵀ (G K Gᵀ)⁻¹ G K = K^{1/2} (I - Q Qᵀ) K^{1/2},   K^{1/2}Gᵀ = Q R
//! ```
//!
//! With many coordinates Q is not computed. Instead, a linear solve with the stiffness G K Gᵀ gives the displacements of all coordinates under each
//! jump. The entries of P follow from the stretches that these displacements cause at the contacts.

use nalgebra::SVector;

use super::rows::{Form, Row};
use crate::contact::{LocalLaw, Mode, State, tangential};
use crate::lcp::{Basis, Lcp};
use crate::numerics::{Each, IntoList, all_some, mapped, matrix_of, numbered, total, vector_of};
use crate::object::{ForcesAndTwist, LinearProblem, Problem};
use crate::prelude::*;

/// One complementary pair of the kinematic form: a gap or slip ẑ of a contact as unknown, and its slack ŵ. The contact force F is scaled by the
/// contact's stiffnesses K to x = K^{-1/2} F, a square root of energy. The unknown adds `column · ẑ` to x, and the slack is `ŵ = row · x`.
struct GapOrSlip {
    contact: usize,
    row: SVector<f64, 3>,
    column: SVector<f64, 3>,
    w_unit: f64,
    z_unit: f64,
}

/// The complementary pairs of the contacts `contacts` in the kinematic form, as two lists: the meaning of each pair, and its gap or slip with
/// its slack.
fn jumps(problem: &Problem, contacts: &[usize]) -> (Vec<Row>, Vec<GapOrSlip>) {
    let (mut rows, mut jumps) = (Vec::new(), Vec::new());
    for &contact in contacts {
        let local = problem.local(contact);
        let root = local.springs.root();
        let mut push = |meaning: Row, row: SVector<f64, 3>, column: SVector<f64, 3>| {
            let (w_unit, z_unit) = (row.norm(), 1.0 / column.norm());
            let (row, column) = (row / w_unit, column * z_unit);
            rows.push(meaning);
            jumps.push(GapOrSlip { contact, row, column, w_unit, z_unit });
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
    (rows, jumps)
}

/// The kinematic form of all contacts. `trial` is the linear problem in which every contact sticks (the elastic trial), and `state` its solution.
/// `None` if no contact may open or slide, or if a number overflows.
pub(crate) fn kinematic_form(
    problem: &Problem,
    trial: &LinearProblem,
    state: &ForcesAndTwist,
) -> Option<Form> {
    let (rows, jumps) = jumps(problem, &numbered(problem.len(), &|contact| contact));
    if jumps.is_empty() {
        return None;
    }
    if trial.is_banded() {
        let of_jump = |jump: &GapOrSlip| trial.displacements_under(jump.contact, &jump.column);
        let displacements = all_some(jumps.iter().map(of_jump))?;
        return form(problem, state, rows, &jumps, &|i, j| {
            trial.weighted_stretch(jumps[i].contact, &jumps[i].row, &displacements[j])
        });
    }
    // Each jump (a gap or slip component ẑ) adds `column · ẑ` to the scaled contact forces x, and its slack is `row · x`. Both vectors are multiplied
    // here by Qᵀ, with the orthogonal factor Q of K^{1/2}Gᵀ = Q R. The term with Q Qᵀ in each matrix entry is then a dot product.
    let mut transformed = Vec::with_capacity(jumps.len());
    for of_contact in jumps.chunk_by(|a, b| a.contact == b.contact) {
        let by_contact = trial.factor_rows(of_contact[0].contact);
        transformed.extend(mapped(of_contact, &|jump| [jump.row, jump.column].each(|v| &by_contact * v)));
    }
    form(problem, state, rows, &jumps, &|i, j| transformed[i][0].dot(&transformed[j][1]))
}

/// Displacements of all coordinates of the grasp under a unit of each jump (gap or slip) of a contact; `None` for contacts not yet computed. The
/// list is by contact, so that a later kinematic form of another set of contacts reuses it.
#[derive(Debug, Default)]
pub(crate) struct UnitDisplacements(Vec<Option<Vec<Vec<f64>>>>);

/// The kinematic form of the given contacts in a problem with many coordinates. All other contacts stick, as in the elastic trial `trial`, whose
/// solution is `state`. Displacements under jumps (gaps and slips) are taken from the list `known`, or computed and stored there. `None` if a number
/// overflows or there is no band matrix.
pub(crate) fn kinematic_form_among(
    problem: &Problem,
    trial: &LinearProblem,
    state: &ForcesAndTwist,
    contacts: &[usize],
    UnitDisplacements(known): &mut UnitDisplacements,
) -> Option<Form> {
    let (rows, jumps) = jumps(problem, contacts);
    for of_contact in jumps.chunk_by(|a, b| a.contact == b.contact) {
        let contact = of_contact[0].contact;
        if known.len() <= contact {
            known.resize(contact + 1, None);
        }
        if known[contact].is_none() {
            let mut displacements: Vec<Vec<f64>> = Vec::with_capacity(of_contact.len());
            for (k, jump) in of_contact.iter().enumerate() {
                // If two facets have opposite normals, the displacements under a slip along one normal are those under a slip along the other with
                // reversed sign.
                let opposite = of_contact[..k].iter().position(|other| other.column == -jump.column);
                displacements.push(match opposite {
                    Some(other) => mapped(&displacements[other], &|x| -x),
                    None => trial.displacements_under(contact, &jump.column)?,
                });
            }
            known[contact] = Some(displacements);
        }
    }
    let mut displacements = Vec::with_capacity(jumps.len());
    for of_contact in jumps.chunk_by(|a, b| a.contact == b.contact) {
        if let Some(known) = &known[of_contact[0].contact] {
            displacements.extend(known);
        }
    }
    form(problem, state, rows, &jumps, &|i, j| {
        trial.weighted_stretch(jumps[i].contact, &jumps[i].row, displacements[j])
    })
}

/// Assembles the kinematic form from its jumps (gaps and slips) and from `state`, the forces and twist of the elastic trial; `None` if a number
/// overflows. `coupling(i, j)` returns by how much a unit of the unknown of jump j reduces the slack of jump i because the object gives way.
fn form(
    problem: &Problem,
    state: &ForcesAndTwist,
    rows: Vec<Row>,
    jumps: &[GapOrSlip],
    coupling: &dyn Fn(usize, usize) -> f64,
) -> Option<Form> {
    let n = jumps.len();
    let m = matrix_of(n, n, &|i, j| {
        let (to, from) = (&jumps[i], &jumps[j]);
        let own = if to.contact == from.contact { to.row.dot(&from.column) } else { 0.0 };
        own - coupling(i, j)
    });
    let q = vector_of(n, &|i| {
        let jump = &jumps[i];
        let springs = &problem.sites[jump.contact].springs;
        let force = &state.forces[jump.contact];
        total(springs.axes(), &|a| jump.row[a] * force[a] / springs.root_along(a))
    });
    let z_unit = mapped(jumps, &|jump| jump.z_unit);
    let w_unit = mapped(jumps, &|jump| jump.w_unit);
    Some(Form { lcp: Lcp::new(m, q).ok()?, rows, z_unit, w_unit })
}

/// The state of each contact, and of each drive (the spring of a joint or tendon), that a complementary basis of the kinematic form describes.
/// Contacts without a pair in the form keep their state in the elastic trial.
pub(crate) fn kinematic_states(problem: &Problem, form: &Form, basis: &Basis) -> Vec<State> {
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
    let state = |(contact, local): (usize, LocalLaw<'_>)| {
        if open[contact] {
            Mode::Open
        } else if slipping[contact].is_empty() {
            local.trial_state()
        } else {
            local.slipping_state(&slipping[contact])
        }
    };
    problem.locals().enumerate().map(state).list()
}
