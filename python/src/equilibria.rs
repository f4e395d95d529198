//! Equilibria of many grasps, on all cores.

use std::ops::Range;

use grasp_lcp::Error;
use grasp_lcp::ask::Grasp;
use grasp_lcp::equilibrium::{ContactState, Equilibrium, Outcome};
use grasp_lcp::grasp::Wrench;
use grasp_lcp::sweep::map_in_order;
use numpy::ndarray::ArrayView2;
use numpy::{IntoPyArray, PyReadonlyArray2};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::columns::{Columns, GivenColumns};
use crate::errors::{has_nan, wrong};

/// Number of grasps in one task of a thread. Such a task takes 0.1 ms or more, so that the cost of scheduling is negligible.
const CHUNK: usize = 64;

/// Outcome for one grasp under one load, numbered as in `grasp_lcp.SolveStatus`.
#[derive(Clone, Copy, PartialEq)]
#[repr(u8)]
enum Status {
    Equilibrium,
    NoEquilibrium,
    Undecided,
    NotANumber,
    Malformed,
}

/// Answers for some rows (grasps) as flat arrays: row by row, and load by load within each row. Without an equilibrium numbers are NaN.
#[derive(Default)]
struct EquilibriumColumns {
    status: Vec<u8>,
    twist: Vec<f64>,
    residual: Vec<f64>,
    /// One entry for each contact: its state, its gap (m), and its margin μ F_n - |F_t| (N).
    states: Vec<u8>,
    gap: Vec<f64>,
    margin: Vec<f64>,
    /// One entry for each axis of each contact: forces (N) and slips (m).
    force: Vec<f64>,
    force_world: Vec<f64>,
    slip: Vec<f64>,
}

/// Equilibria of B grasps under P loads, as flat arrays by name. With `own`, grasp k has load k alone; otherwise each grasp has all loads.
#[pyfunction]
pub(crate) fn equilibria_of_rows<'py>(
    py: Python<'py>,
    columns: GivenColumns<'py>,
    load: PyReadonlyArray2<'py, f64>,
    own: bool,
) -> PyResult<Bound<'py, PyDict>> {
    let (columns, load) = (columns.view(), load.as_array());
    let found = py.detach(|| match columns.axes() {
        2 => Some(all::<2>(&columns, &load, own)),
        3 => Some(all::<3>(&columns, &load, own)),
        _ => None,
    });
    let found = found.ok_or_else(|| wrong("points: must have 2 or 3 coordinates"))?;
    let arrays = PyDict::new(py);
    arrays.set_item("status", found.status.into_pyarray(py))?;
    arrays.set_item("states", found.states.into_pyarray(py))?;
    for (name, numbers) in [
        ("twist", found.twist),
        ("residual", found.residual),
        ("gaps", found.gap),
        ("margins", found.margin),
        ("forces", found.force),
        ("forces_world", found.force_world),
        ("slips", found.slip),
    ] {
        arrays.set_item(name, numbers.into_pyarray(py))?;
    }
    Ok(arrays)
}

fn all<const C: usize>(columns: &Columns<'_>, loads: &ArrayView2<'_, f64>, own: bool) -> EquilibriumColumns {
    let load = |p: usize| Wrench::from_components(&loads.row(p).to_vec());
    let loads: Vec<Wrench<C>> = (0..loads.nrows()).map(load).collect();
    let rows = columns.rows();
    let chunks: Vec<_> = (0..rows).step_by(CHUNK).map(|first| first..rows.min(first + CHUNK)).collect();
    let parts = map_in_order(&chunks, |chunk| some(columns, &loads, own, chunk.clone()));
    parts.into_iter().fold(EquilibriumColumns::default(), EquilibriumColumns::and)
}

fn some<const C: usize>(
    columns: &Columns<'_>,
    loads: &[Wrench<C>],
    own: bool,
    rows: Range<usize>,
) -> EquilibriumColumns {
    let mut found = EquilibriumColumns::default();
    for row in rows {
        let grasp = Grasp::<C>::new((0..columns.contacts()).map(|i| columns.contact::<C>(row, i)));
        let of_row = if own { row..row + 1 } else { 0..loads.len() };
        for load in &loads[of_row] {
            let outcome = grasp.as_ref().map_err(status_of);
            match outcome.and_then(|grasp| grasp.solve(load).map_err(|error| status_of(&error))) {
                Ok(Outcome::Equilibrium(state)) => found.push(&state),
                Ok(Outcome::NoEquilibrium(_)) => {
                    found.push_nothing::<C>(Status::NoEquilibrium, columns.contacts());
                }
                Ok(_) => found.push_nothing::<C>(Status::Undecided, columns.contacts()),
                Err(status) => found.push_nothing::<C>(status, columns.contacts()),
            }
        }
    }
    found
}

impl EquilibriumColumns {
    fn push<const C: usize>(&mut self, state: &Equilibrium<C>) {
        let r = &state.residuals;
        let residual =
            [r.equilibrium, r.springs, r.cone, r.gap, r.complementarity].into_iter().fold(0.0, f64::max);
        self.status.push(Status::Equilibrium as u8);
        self.twist.extend(state.twist.components());
        self.residual.push(residual);
        for contact in &state.contacts {
            self.states.push(code_of(&contact.state));
            self.gap.push(contact.gap);
            self.margin.push(contact.margin);
            self.force.extend(contact.force.iter());
            self.force_world.extend(contact.force_world.iter());
            self.slip.extend(contact.slip.iter());
        }
    }

    fn push_nothing<const C: usize>(&mut self, status: Status, contacts: usize) {
        fn more<T: Copy>(list: &mut Vec<T>, count: usize, value: T) {
            list.resize(list.len() + count, value);
        }
        self.status.push(status as u8);
        self.residual.push(f64::NAN);
        more(&mut self.twist, C * (C + 1) / 2, f64::NAN);
        more(&mut self.states, contacts, UNKNOWN);
        for of_contacts in [&mut self.gap, &mut self.margin] {
            more(of_contacts, contacts, f64::NAN);
        }
        for of_axes in [&mut self.force, &mut self.force_world, &mut self.slip] {
            more(of_axes, contacts * C, f64::NAN);
        }
    }

    fn and(mut self, next: Self) -> Self {
        self.status.extend(next.status);
        self.twist.extend(next.twist);
        self.residual.extend(next.residual);
        self.states.extend(next.states);
        self.gap.extend(next.gap);
        self.margin.extend(next.margin);
        self.force.extend(next.force);
        self.force_world.extend(next.force_world);
        self.slip.extend(next.slip);
        self
    }
}

/// Code for the state of a contact of a grasp without an equilibrium.
const UNKNOWN: u8 = 255;

/// The number of a state in `grasp_lcp.ContactState`.
fn code_of<const C: usize>(state: &ContactState<C>) -> u8 {
    match state {
        ContactState::Separated => 0,
        ContactState::Sticking => 1,
        ContactState::Sliding { .. } => 2,
        ContactState::Frictionless => 3,
        #[allow(unreachable_patterns, reason = "the enum may grow")]
        _ => UNKNOWN,
    }
}

/// Status of a grasp and load that the crate refuses with this error.
fn status_of(error: &Error) -> Status {
    if has_nan(error) { Status::NotANumber } else { Status::Malformed }
}
