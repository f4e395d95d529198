//! Words of the crate for parts of answers. Python holds a part as JSON and passes it back for its description.

use grasp_lcp::equilibrium::{ContactAnswer, Equilibrium, JointAnswer, Proof, TendonAnswer};
use grasp_lcp::grasp::Wrench;
use grasp_lcp::load_path::Event;
use grasp_lcp::scene::Answer;
use grasp_lcp::words::{Words, printable};
use pyo3::prelude::*;
use serde::de::DeserializeOwned;

use crate::errors::of_json;

/// The description of a part of an answer, from its JSON. `axes` is the number of axes of a contact.
#[pyfunction]
pub(crate) fn words_of(kind: &str, text: &str, axes: usize) -> PyResult<String> {
    if axes == 2 { part::<2>(kind, text) } else { part::<3>(kind, text) }
}

/// A number with six digits, and zero without a minus sign.
#[pyfunction]
pub(crate) fn words_of_number(number: f64) -> String {
    Words::default().number(number)
}

/// A name with its control characters escaped.
#[pyfunction]
pub(crate) fn words_of_name(name: &str) -> String {
    printable(name).into_owned()
}

fn part<const C: usize>(kind: &str, text: &str) -> PyResult<String>
where
    Wrench<C>: DeserializeOwned,
    Event<C>: DeserializeOwned,
    Answer<C>: DeserializeOwned,
{
    Ok(match kind {
        "equilibrium" => read::<Equilibrium<C>>(kind, text)?.to_string(),
        "contact" => read::<ContactAnswer<C>>(kind, text)?.to_string(),
        "joint" => read::<JointAnswer>(kind, text)?.to_string(),
        "tendon" => read::<TendonAnswer>(kind, text)?.to_string(),
        "proof" => read::<Proof<C>>(kind, text)?.to_string(),
        "event" => read::<Event<C>>(kind, text)?.to_string(),
        "answer" => read::<Answer<C>>(kind, text)?.first_line(Words::default()),
        _ => String::new(),
    })
}

fn read<T: DeserializeOwned>(kind: &str, text: &str) -> PyResult<T> {
    serde_json::from_str(text).map_err(|error| of_json(kind, &error))
}
