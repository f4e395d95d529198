//! Gradients of the onsets of many grasps, on all cores.

use std::ops::Range;

use grasp_lcp::ask::Grasp;
use grasp_lcp::grasp::Contact;
use grasp_lcp::screening::{Batch, Fingers, Pull, ScreenedGradients};
use numpy::{IntoPyArray, PyArray1, PyReadonlyArray2};
use pyo3::prelude::*;

use crate::columns::GivenColumns;
use crate::errors::wrong;
use crate::onsets::ended;
use crate::rows::{Rows, Status, status_of};

/// Gradients in the layout of `ScreenedGradients`, one row for each grasp and load, and the status of each row. A row begins with the factor instead
/// of its code.
struct GradientRows {
    numbers: Vec<f64>,
    status: Vec<u8>,
}

type Arrays<'py> = (Bound<'py, PyArray1<f64>>, Bound<'py, PyArray1<u8>>);

/// Gradients of B grasps of two to five contacts under P loads. With `own`, grasp k has load k alone; otherwise each grasp has all loads.
#[pyfunction]
pub(crate) fn onset_gradients_of_rows<'py>(
    py: Python<'py>,
    columns: GivenColumns<'py>,
    base: PyReadonlyArray2<'py, f64>,
    direction: PyReadonlyArray2<'py, f64>,
    own: bool,
) -> PyResult<Arrays<'py>> {
    let (columns, loads) = (columns.view(), (&base.as_array(), &direction.as_array()));
    let found = match columns.axes() {
        2 => {
            let rows = Rows::<2>::new(&columns, loads, own, false)?;
            py.detach(|| rows.of_size())
        }
        3 => {
            let rows = Rows::<3>::new(&columns, loads, own, false)?;
            py.detach(|| rows.of_size())
        }
        _ => None,
    };
    let GradientRows { numbers, status } =
        found.ok_or_else(|| wrong("points: gradients are of grasps of 2 to 5 contacts"))?;
    Ok((numbers.into_pyarray(py), status.into_pyarray(py)))
}

impl<const C: usize> Rows<'_, C> {
    /// Gradients for the grasps' number of contacts; `None` unless it is 2 to 5.
    fn of_size(&self) -> Option<GradientRows> {
        Some(match self.columns.contacts() {
            2 => self.slopes::<2>(),
            3 => self.slopes::<3>(),
            4 => self.slopes::<4>(),
            5 => self.slopes::<5>(),
            _ => return None,
        })
    }

    fn slopes<const N: usize>(&self) -> GradientRows {
        let mut parts = self.in_chunks(|rows| self.differentiate::<N>(rows)).into_iter();
        let Some(mut all) = parts.next() else {
            return GradientRows { numbers: Vec::new(), status: Vec::new() };
        };
        for part in parts {
            all.numbers.extend(part.numbers);
            all.status.extend(part.status);
        }
        all
    }

    fn differentiate<const N: usize>(&self, rows: Range<usize>) -> GradientRows {
        let each = if self.own { 1 } else { self.pulls.len() };
        let mut slopes = GradientRows::unclear(rows.len() * each, ScreenedGradients::<C>::width(N));
        let asked: Vec<Pull<C>> =
            if self.own { Vec::new() } else { self.pulls.iter().flatten().copied().collect() };
        let mut batch = Batch::<C, N>::with_capacity(if self.own { 0 } else { rows.len() });
        let (mut screened, mut gradients) = (Vec::with_capacity(rows.len()), ScreenedGradients::new());
        let first = rows.start;
        for row in rows {
            let place = (row - first) * each;
            let contacts: [Contact<C>; N] = std::array::from_fn(|i| self.columns.contact(row, i));
            match (Fingers::new(&contacts), self.own) {
                (Ok(fingers), false) => {
                    batch.push(&fingers);
                    screened.push(place);
                }
                (Ok(fingers), true) => match &self.pulls[row] {
                    Ok(pull) => {
                        fingers.onset_gradient_into(pull, &mut gradients);
                        slopes.set(place, &gradients, 0);
                    }
                    Err(status) => slopes.status[place] = *status as u8,
                },
                // Screening refuses malformed contacts and some springs. A fault of the load takes precedence over a fault of the contacts.
                (Err(_), _) => {
                    let status =
                        Grasp::<C>::new(contacts).map_or_else(|error| status_of(&error), |_| Status::Unclear);
                    for (place, pull) in (place..).zip(&self.pulls[self.of_row(row)]) {
                        slopes.status[place] = *pull.as_ref().err().unwrap_or(&status) as u8;
                    }
                }
            }
        }
        if self.own {
            return slopes;
        }
        batch.onset_gradients_into(&asked, &mut gradients);
        let mut answered = 0;
        for place in screened {
            for (p, pull) in self.pulls.iter().enumerate() {
                match pull {
                    Ok(_) => {
                        slopes.set(place + p, &gradients, answered);
                        answered += 1;
                    }
                    Err(status) => slopes.status[place + p] = *status as u8,
                }
            }
        }
        slopes
    }
}

impl GradientRows {
    fn unclear(answers: usize, width: usize) -> Self {
        let mut numbers = vec![f64::NAN; answers * width];
        for row in numbers.chunks_exact_mut(width) {
            row[1..4].copy_from_slice(&[0.0, -1.0, 0.0]);
        }
        Self { numbers, status: vec![Status::Unclear as u8; answers] }
    }

    fn set<const C: usize>(&mut self, place: usize, gradients: &ScreenedGradients<C>, answered: usize) {
        let Some(gradient) = gradients.get(answered) else { return };
        let width = self.numbers.len() / self.status.len();
        let row = &mut self.numbers[place * width..(place + 1) * width];
        row.copy_from_slice(&gradients.numbers()[answered * width..(answered + 1) * width]);
        let (status, factor) = ended(&gradient.screened());
        (self.status[place], row[0]) = (status as u8, factor);
    }
}
