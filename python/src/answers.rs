//! Answers of the crate that are kept as Rust values; their JSON is written only when Python reads it.

use std::sync::Arc;

use grasp_lcp::equilibrium::{Equilibrium, Outcome};
use grasp_lcp::grasp::Wrench;
use grasp_lcp::load_path::{Onset, TurnOnset};
use grasp_lcp::scene::Setup;
use numpy::ndarray::Array2;
use numpy::{IntoPyArray, PyArray2};
use pyo3::prelude::*;
use serde::Serialize;

use crate::errors::{refused, wrong};
use crate::pictures::PythonPicture;
use crate::stored_grasp::StoredGrasp;

/// An answer returned to Python.
#[derive(IntoPyObject)]
pub(crate) enum Reply {
    /// An answer kept as a Rust value, from a grasp without joints.
    Unwritten(LazyAnswer),
    /// JSON of the scene format, for hands with joints and for several bodies.
    Written(String),
}

/// An answer as a Rust value, not yet written as JSON.
pub(crate) enum UnwrittenAnswer<const C: usize> {
    Solved(Outcome<C>, Wrench<C>),
    Onset(Onset<C>),
    Turn(TurnOnset<C>),
}

/// Access of Python to an answer: outcome, factor and columns are read directly, all other data from its JSON.
trait PythonAnswer: Send + Sync {
    fn outcome(&self) -> &'static str;
    fn factor(&self) -> Option<f64>;
    fn column<'py>(&self, py: Python<'py>, name: &str) -> Option<Bound<'py, PyArray2<f64>>>;
    fn json(&self) -> PyResult<String>;
    fn svg(&self, title: &str) -> PyResult<Option<String>>;
    fn page(&self, title: &str) -> PyResult<Option<String>>;
}

struct Of<const C: usize> {
    kept: Arc<StoredGrasp<C>>,
    raw: UnwrittenAnswer<C>,
}

/// An answer whose JSON is written on request; see `grasp_lcp.Answer`.
#[pyclass(frozen, module = "grasp_lcp._grasp_lcp")]
pub(crate) struct LazyAnswer(Box<dyn PythonAnswer>);

#[pymethods]
impl LazyAnswer {
    #[getter]
    fn outcome(&self) -> &'static str {
        self.0.outcome()
    }

    #[getter]
    fn factor(&self) -> Option<f64> {
        self.0.factor()
    }

    /// Numbers of the contacts of an equilibrium, one row a contact: `forces`, `forces_world`, `slips`, `gaps` or `margins`; the `twist` in one row.
    fn column<'py>(&self, py: Python<'py>, name: &str) -> Option<Bound<'py, PyArray2<f64>>> {
        self.0.column(py, name)
    }

    fn json(&self) -> PyResult<String> {
        self.0.json()
    }

    fn svg(&self, title: &str) -> PyResult<Option<String>> {
        self.0.svg(title)
    }

    fn page(&self, title: &str) -> PyResult<Option<String>> {
        self.0.page(title)
    }
}

impl Reply {
    pub(crate) fn told<const C: usize>(kept: Arc<StoredGrasp<C>>, raw: UnwrittenAnswer<C>) -> Self
    where
        StoredGrasp<C>: PythonPicture<C>,
    {
        Self::Unwritten(LazyAnswer(Box::new(Of { kept, raw })))
    }
}

/// The JSON text of an answer in the format of scenes.
pub(crate) fn json(answer: &impl Serialize) -> PyResult<String> {
    serde_json::to_string(answer).map_err(wrong)
}

/// The outcome of the search for the load at first slip, as a word of the scene format.
fn word<const C: usize>(onset: &Onset<C>) -> &'static str {
    match onset {
        Onset::At(_) => "at",
        Onset::Never => "never",
        Onset::AlreadySliding(_) => "already_sliding",
        Onset::NoBase(_) => "no_base",
        Onset::GivesWay { .. } => "gives_way",
        _ => "undecided",
    }
}

impl<const C: usize> Of<C> {
    fn onset(&self) -> Option<&Onset<C>> {
        match &self.raw {
            UnwrittenAnswer::Solved(..) => None,
            UnwrittenAnswer::Onset(onset) => Some(onset),
            UnwrittenAnswer::Turn(turn) => Some(&turn.onset),
        }
    }

    /// The equilibrium to draw, if there is one.
    fn state(&self) -> PyResult<Option<Equilibrium<C>>> {
        let grasp = self.kept.without_joints("pictures").map_err(refused)?;
        Ok(match (&self.raw, self.onset()) {
            (UnwrittenAnswer::Solved(outcome, _), _) => outcome.equilibrium().cloned(),
            (_, Some(Onset::At(event))) => grasp.state_at_onset(event),
            (_, Some(Onset::AlreadySliding(state))) => Some((**state).clone()),
            _ => None,
        })
    }
}

impl<const C: usize> PythonAnswer for Of<C>
where
    StoredGrasp<C>: PythonPicture<C>,
{
    fn outcome(&self) -> &'static str {
        match &self.raw {
            UnwrittenAnswer::Solved(Outcome::Equilibrium(_), _) => "equilibrium",
            UnwrittenAnswer::Solved(Outcome::NoEquilibrium(_), _) => "no_equilibrium",
            UnwrittenAnswer::Solved(..) => "undecided",
            UnwrittenAnswer::Onset(onset) => word(onset),
            UnwrittenAnswer::Turn(turn) => word(&turn.onset),
        }
    }

    fn factor(&self) -> Option<f64> {
        self.onset().and_then(Onset::factor)
    }

    fn column<'py>(&self, py: Python<'py>, name: &str) -> Option<Bound<'py, PyArray2<f64>>> {
        let UnwrittenAnswer::Solved(outcome, _) = &self.raw else { return None };
        let state = outcome.equilibrium()?;
        let mut numbers = Vec::with_capacity(C * state.contacts.len());
        if name == "twist" {
            numbers.extend(state.twist.components());
        }
        for contact in &state.contacts {
            match name {
                "forces" => numbers.extend(contact.force.iter()),
                "forces_world" => numbers.extend(contact.force_world.iter()),
                "slips" => numbers.extend(contact.slip.iter()),
                "gaps" => numbers.push(contact.gap),
                "margins" => numbers.push(contact.margin),
                _ => {}
            }
        }
        let rows = if name == "twist" { 1 } else { state.contacts.len() };
        let columns = numbers.len() / rows.max(1);
        Some(Array2::from_shape_vec((rows, columns), numbers).ok()?.into_pyarray(py))
    }

    fn json(&self) -> PyResult<String> {
        let grasp = self.kept.without_joints("answers").map_err(refused)?;
        match &self.raw {
            UnwrittenAnswer::Solved(outcome, load) => {
                json(&Setup::tell_outcome(grasp, load, outcome).map_err(refused)?)
            }
            UnwrittenAnswer::Onset(onset) => json(&Setup::tell_onset(grasp, onset)),
            UnwrittenAnswer::Turn(turn) => json(&Setup::tell_onset_of_turn(grasp, turn)),
        }
    }

    fn svg(&self, title: &str) -> PyResult<Option<String>> {
        self.state()?.map(|state| self.kept.svg(&state, title)).transpose()
    }

    fn page(&self, title: &str) -> PyResult<Option<String>> {
        self.state()?.map_or(Ok(None), |state| self.kept.page(&state, title))
    }
}
