//! The native module `_grasp_lcp` of the Python package `grasp_lcp`. The package wraps it in documented, typed classes and functions.
//!
//! Numbers are passed as arrays, answers as JSON in the format of [`grasp_lcp::scene`], of which the package reads what it needs.
//! This crate contains no mechanics. Malformed input is a `ValueError` or a `TypeError` that names the argument.

use pyo3::prelude::*;

mod answers;
mod columns;
mod equilibria;
mod errors;
mod friction;
mod gradients;
mod grasp;
mod lcp;
mod loads;
mod onsets;
mod pictures;
mod quality;
mod rows;
mod stored_grasp;
mod verdicts;
mod watch;
mod words;

/// The native half of `grasp_lcp`.
#[pymodule]
mod _grasp_lcp {
    /// The version of the package, which is that of the crate.
    #[pymodule_export]
    const VERSION: &str = env!("CARGO_PKG_VERSION");

    /// The page of all fields of a scene, in Markdown.
    #[pymodule_export]
    const FIELDS: &str = include_str!("../../examples/scenes/FIELDS.md");

    #[pymodule_export]
    use super::answers::LazyAnswer;
    #[pymodule_export]
    use super::columns::points_of_pads;
    #[pymodule_export]
    use super::equilibria::equilibria_of_rows;
    #[pymodule_export]
    use super::friction::solve_friction;
    #[pymodule_export]
    use super::gradients::onset_gradients_of_rows;
    #[pymodule_export]
    use super::grasp::{Grasp, answers_of_scene, warnings_of_scene};
    #[pymodule_export]
    use super::lcp::solve_lcp;
    #[pymodule_export]
    use super::loads::load_numbers;
    #[pymodule_export]
    use super::onsets::onsets_of_rows;
    #[pymodule_export]
    use super::verdicts::{amounts_of_rows, verdicts_of_rows};
    #[pymodule_export]
    use super::watch::Watch;
    #[pymodule_export]
    use super::words::{words_of, words_of_name, words_of_number};
}
