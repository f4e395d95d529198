//! Reads loads from Python: an array, a list or a tuple of a force alone, or of a force and a moment.

use std::fmt::Write;

use grasp_lcp::grasp::Wrench;
use numpy::{PyArray1, PyArrayDescrMethods, PyArrayMethods, PyUntypedArray, PyUntypedArrayMethods};
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyFloat, PyInt, PyMapping, PyString};

use crate::errors::{of_json, wrong};

/// Largest number of components of a load: force and moment in space.
const MOST: usize = 6;

/// Reads a load: `C` components of a force (N), or all components with the moment about the origin (N m), or a mapping as in scenes.
pub(crate) fn wrench<const C: usize>(argument: &str, given: &Bound<'_, PyAny>) -> PyResult<Wrench<C>> {
    if given.cast::<PyMapping>().is_ok() {
        let text = mapping_text(argument, given)?;
        // The mapping is parsed as a whole, because a load built from its components would lose its points of action.
        return serde_json::from_str(&text).map_err(|error| of_json(argument, &error));
    }
    let (numbers, count) = few(argument, given)?;
    let all = C * (C + 1) / 2;
    if count != C && count != all {
        let given = if count > MOST { format!("more than {MOST}") } else { count.to_string() };
        return Err(wrong(format_args!(
            "{argument}: {given} numbers given, must be {C} of a force or {all} of a force and a moment"
        )));
    }
    Ok(Wrench::from_components(&numbers[..count]))
}

/// The JSON text of a load that is a mapping as in scenes.
pub(crate) fn mapping_text(argument: &str, given: &Bound<'_, PyAny>) -> PyResult<String> {
    if let Some(text) = given.cast::<PyDict>().ok().and_then(|given| text_of_numbers(given)) {
        return Ok(text);
    }
    // Python converts all other mappings, so that its errors name the key.
    let columns = given.py().import("grasp_lcp._columns")?;
    columns.call_method1("load_text", (argument, given))?.extract()
}

/// The JSON text of a dictionary whose values are finite numbers, or lists of at most [`MOST`] of them; `None` for all others.
fn text_of_numbers(given: &Bound<'_, PyDict>) -> Option<String> {
    let mut text = String::from("{");
    for (key, value) in given {
        let key = key.cast_into::<PyString>().ok()?;
        let key = key.to_str().ok().filter(|key| key.bytes().all(|byte| byte.is_ascii_lowercase()))?;
        let separator = if text.len() > 1 { "," } else { "" };
        if value.is_exact_instance_of::<PyFloat>() || value.is_exact_instance_of::<PyInt>() {
            let number = value.extract::<f64>().ok().filter(|x| x.is_finite())?;
            write!(text, "{separator}\"{key}\":{number:?}").ok()?;
        } else {
            let (numbers, count) = few("", &value).ok()?;
            let numbers = numbers.get(..count).filter(|numbers| numbers.iter().all(|x| x.is_finite()))?;
            write!(text, "{separator}\"{key}\":{numbers:?}").ok()?;
        }
    }
    text.push('}');
    Some(text)
}

/// The components of a load, force and then moment, in the plane (`axes` 2) or in space (3).
#[pyfunction]
pub(crate) fn load_numbers(argument: &str, given: &Bound<'_, PyAny>, axes: usize) -> PyResult<Vec<f64>> {
    Ok(if axes == 2 {
        wrench::<2>(argument, given)?.components().to_vec()
    } else {
        wrench::<3>(argument, given)?.components().to_vec()
    })
}

/// Reads a point of `C` coordinates, m.
pub(crate) fn point<const C: usize>(argument: &str, given: &Bound<'_, PyAny>) -> PyResult<[f64; C]> {
    let (numbers, count) = few(argument, given)?;
    if count != C {
        return Err(wrong(format_args!("{argument}: {count} numbers given, must be {C}")));
    }
    Ok(std::array::from_fn(|k| numbers[k]))
}

/// The first [`MOST`] numbers of the argument, and their count; a count of `MOST + 1` means more than `MOST` numbers.
fn few(argument: &str, given: &Bound<'_, PyAny>) -> PyResult<([f64; MOST], usize)> {
    let mut numbers = [0.0; MOST];
    if let Ok(array) = given.cast::<PyArray1<f64>>() {
        let array = array.try_readonly().map_err(wrong)?;
        let array = array.as_array();
        numbers.iter_mut().zip(&array).for_each(|(to, from)| *to = *from);
        return Ok((numbers, array.len().min(MOST + 1)));
    }
    if let Ok(array) = given.cast::<PyUntypedArray>() {
        let (kind, shape) = (array.dtype().kind(), array.shape());
        if !b"fiu".contains(&kind) {
            let kind = array.dtype();
            return Err(PyTypeError::new_err(format!(
                "{argument}: an array of {kind} given, must be of numbers"
            )));
        }
        if shape.len() != 1 {
            return Err(wrong(format_args!(
                "{argument}: an array of {} dimensions given, must have one",
                shape.len()
            )));
        }
    }
    let no_list = || {
        let kind = given.get_type().name().map_or_else(|_| "this".to_owned(), |name| name.to_string());
        PyTypeError::new_err(format!("{argument}: {kind} given, must be an array or a list of numbers"))
    };
    if given.is_instance_of::<PyString>() {
        return Err(no_list());
    }
    let mut count = 0;
    for item in given.try_iter().map_err(|_| no_list())? {
        let item = item?;
        if count == MOST {
            return Ok((numbers, MOST + 1));
        }
        numbers[count] = item.extract().map_err(|_| {
            let shown = item.repr().map_or_else(|_| "?".to_owned(), |text| text.to_string());
            PyTypeError::new_err(format!("{argument}[{count}] is {shown}, must be a number"))
        })?;
        count += 1;
    }
    Ok((numbers, count))
}
