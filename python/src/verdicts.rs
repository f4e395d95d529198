//! Verdicts on the loads of many grasps, and the amounts that they need, on all cores.

use grasp_lcp::Settings;
use grasp_lcp::ask::Grasp;
use grasp_lcp::equilibrium::Doubt;
use grasp_lcp::grasp::{Contact, Wrench};
use grasp_lcp::hold::{LossVerb, VerdictKind};
use grasp_lcp::need::{Demand, Quantity, ShortAmount};
use numpy::{IntoPyArray, PyArray1, PyReadonlyArray2};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::columns::GivenColumns;
use crate::errors::{has_nan, of_json, wrong};
use crate::rows::Rows;

/// The number in `grasp_lcp.VerdictStatus` of a malformed row. The number before it marks a row with a NaN.
const MALFORMED: u8 = 8;
/// The number in the arrays for an answer without a motion, or without a doubt (a reason why it is undecided).
const NONE: u8 = 255;

/// Verdicts on B grasps under P loads as flat arrays by name, row by row. With `own`, grasp k has load k alone; otherwise each grasp has all loads.
#[pyfunction]
pub(crate) fn verdicts_of_rows<'py>(
    py: Python<'py>,
    columns: GivenColumns<'py>,
    base: PyReadonlyArray2<'py, f64>,
    load: PyReadonlyArray2<'py, f64>,
    own: bool,
    settings: Option<&str>,
    beyond: bool,
) -> PyResult<Bound<'py, PyDict>> {
    let settings = read(settings)?;
    let settings = if beyond { settings } else { settings.with_most_load(1.0) };
    let (columns, loads) = (columns.view(), (&base.as_array(), &load.as_array()));
    let found = match columns.axes() {
        2 => {
            let rows = Rows::<2>::new(&columns, loads, own, false)?;
            py.detach(|| Grasp::hold_batch(rows.count(), &rows.each(), &settings))
        }
        3 => {
            let rows = Rows::<3>::new(&columns, loads, own, false)?;
            py.detach(|| Grasp::hold_batch(rows.count(), &rows.each(), &settings))
        }
        _ => return Err(wrong("points: must have 2 or 3 coordinates")),
    };
    let number = |given: Option<f64>, nothing: f64| given.unwrap_or(nothing);
    let (mut status, mut motion, mut doubt) = (Vec::new(), Vec::new(), Vec::new());
    let (mut first_slip, mut held_to, mut gross_slip) = (Vec::new(), Vec::new(), Vec::new());
    for verdict in found {
        let known = verdict.as_ref().ok();
        let nothing =
            if known.is_some_and(|verdict| verdict.held_to > 0.0) { f64::INFINITY } else { f64::NAN };
        status.push(match &verdict {
            Ok(verdict) => number_of_kind(verdict.how),
            Err(error) => MALFORMED - u8::from(has_nan(error)),
        });
        motion.push(known.and_then(|verdict| verdict.motion).map_or(NONE, number_of_motion));
        doubt.push(known.and_then(|verdict| verdict.doubt).map_or(NONE, number_of_doubt));
        first_slip.push(number(known.and_then(|verdict| verdict.first_slip), nothing));
        held_to.push(number(known.map(|verdict| verdict.held_to), f64::NAN));
        gross_slip.push(number(known.and_then(|verdict| verdict.everything_slides), f64::NAN));
    }
    let arrays = PyDict::new(py);
    for (name, codes) in [("status", status), ("motion", motion), ("doubt", doubt)] {
        arrays.set_item(name, codes.into_pyarray(py))?;
    }
    for (name, numbers) in [("first_slip", first_slip), ("held_to", held_to), ("gross_slip", gross_slip)] {
        arrays.set_item(name, numbers.into_pyarray(py))?;
    }
    Ok(arrays)
}

/// Base loads, and loads that grow on top of them.
type Loads<'py> = (PyReadonlyArray2<'py, f64>, PyReadonlyArray2<'py, f64>);
type Amounts<'py> = (Bound<'py, PyArray1<f64>>, Bound<'py, PyArray1<u8>>);

/// Amounts that B grasps need under P loads, and their statuses, row by row. With `own`, grasp k has load k alone; otherwise each grasp has all loads.
#[pyfunction]
pub(crate) fn amounts_of_rows<'py>(
    py: Python<'py>,
    columns: GivenColumns<'py>,
    loads: Loads<'py>,
    own: bool,
    quantity: &str,
    sticks: bool,
    settings: Option<&str>,
) -> PyResult<Amounts<'py>> {
    let settings = read(settings)?;
    let quantity = match quantity {
        "squeeze" => Quantity::Squeeze,
        "load" => Quantity::Load,
        other => return Err(wrong(format_args!("quantity is {other:?}, must be squeeze or load"))),
    };
    let asked = (quantity, if sticks { Demand::Sticks } else { Demand::Held });
    let (columns, loads) = (columns.view(), (&loads.0.as_array(), &loads.1.as_array()));
    let found = match columns.axes() {
        2 => {
            let rows = Rows::<2>::new(&columns, loads, own, false)?;
            py.detach(|| Grasp::need_batch(rows.count(), &rows.each(), asked, &settings))
        }
        3 => {
            let rows = Rows::<3>::new(&columns, loads, own, false)?;
            py.detach(|| Grasp::need_batch(rows.count(), &rows.each(), asked, &settings))
        }
        _ => return Err(wrong("points: must have 2 or 3 coordinates")),
    };
    let mut status = Vec::with_capacity(found.len());
    let mut amounts = Vec::with_capacity(found.len());
    for amount in found {
        status.push(match &amount {
            Ok(ShortAmount::Bound(_)) => 0,
            Ok(ShortAmount::Any) => 1,
            Ok(ShortAmount::None) => 2,
            Ok(_) => 3,
            Err(error) => 5 - u8::from(has_nan(error)),
        });
        amounts.push(amount.ok().and_then(ShortAmount::bound).unwrap_or(f64::NAN));
    }
    Ok((amounts.into_pyarray(py), status.into_pyarray(py)))
}

fn read(settings: Option<&str>) -> PyResult<Settings> {
    let settings = settings.map_or_else(|| Ok(Settings::default()), serde_json::from_str);
    settings.map_err(|error| of_json("settings", &error))
}

impl<const C: usize> Rows<'_, C> {
    /// The number of questions: grasps times loads of each grasp.
    fn count(&self) -> usize {
        if self.own { self.columns.rows() } else { self.columns.rows() * self.loads.len() }
    }

    /// A function for batches of the crate: it writes the contacts of question `number`, and returns its base load and its load.
    fn each(&self) -> impl Fn(usize, &mut Vec<Contact<C>>) -> [Wrench<C>; 2] + Sync {
        let each = if self.own { 1 } else { self.loads.len() };
        move |number, points| {
            self.columns.fill(&self.pads, number / each, points);
            self.loads[if self.own { number } else { number % each }]
        }
    }
}

/// The number of a verdict in `grasp_lcp.VerdictStatus`.
fn number_of_kind(how: VerdictKind) -> u8 {
    match how {
        VerdictKind::Sticks => 0,
        VerdictKind::Slides => 1,
        VerdictKind::Loose => 2,
        VerdictKind::Lost => 3,
        VerdictKind::NoRest => 4,
        VerdictKind::LostAtRest => 5,
        VerdictKind::TurnsOver => 9,
        _ => 6,
    }
}

/// The number of a motion in `grasp_lcp.LossMotion`.
fn number_of_motion(motion: LossVerb) -> u8 {
    match motion {
        LossVerb::Drops => 0,
        LossVerb::LiftsOff => 1,
        LossVerb::SlipsOut => 2,
        LossVerb::TipsOver => 3,
        LossVerb::TurnsOut => 4,
        LossVerb::LetsGo => 5,
        LossVerb::GoesTooFar => 7,
        LossVerb::Buckles => 8,
        LossVerb::Leaks => 9,
        LossVerb::TurnsOver => 10,
        _ => 6,
    }
}

/// The number of a doubt, the reason why an answer is undecided, in `grasp_lcp.Doubt`.
fn number_of_doubt(doubt: Doubt) -> u8 {
    match doubt {
        Doubt::RayWithoutProof => 0,
        Doubt::OnTheBoundary => 1,
        Doubt::Inaccurate => 2,
        Doubt::OutOfPivots => 3,
        _ => 4,
    }
}
