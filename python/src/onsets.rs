//! Onsets of sliding of many grasps, on all cores.

use std::ops::Range;

use grasp_lcp::ask::Grasp;
use grasp_lcp::grasp::Contact;
use grasp_lcp::load_path::{Onset, Ramp};
use grasp_lcp::screening::{Batch, Fingers, Pull, Screened, ScreeningVerdict};
use numpy::{IntoPyArray, PyArray1, PyReadonlyArray2};
use pyo3::prelude::*;

use crate::columns::GivenColumns;
use crate::errors::wrong;
use crate::rows::{Asked, CHUNK, Rows, Status, by_size, status_of};

/// Flat arrays of answers for some rows, load by load within each row.
struct Found {
    factor: Vec<f64>,
    status: Vec<u8>,
    leaving: Vec<bool>,
}

type Arrays<'py> = (Bound<'py, PyArray1<f64>>, Bound<'py, PyArray1<u8>>, Bound<'py, PyArray1<bool>>);

/// Factors, statuses and leaving contacts of B grasps under P loads. Each grasp has its own load if `own`, else all loads.
#[pyfunction]
pub(crate) fn onsets_of_rows<'py>(
    py: Python<'py>,
    columns: GivenColumns<'py>,
    base: PyReadonlyArray2<'py, f64>,
    direction: PyReadonlyArray2<'py, f64>,
    own: bool,
    complete: bool,
) -> PyResult<Arrays<'py>> {
    let (columns, base, direction) = (columns.view(), base.as_array(), direction.as_array());
    let found = py.detach(|| by_size::<Onsets>(&columns, (&base, &direction), own, complete));
    let Found { factor, status, leaving } =
        found.ok_or_else(|| wrong("points: must have 2 or 3 coordinates"))?;
    Ok((factor.into_pyarray(py), status.into_pyarray(py), leaving.into_pyarray(py)))
}

/// The question for factors of the first slip.
struct Onsets;

impl Asked for Onsets {
    type Answer = Found;

    fn screened<const C: usize, const N: usize>(rows: &Rows<'_, C>) -> Found {
        rows.screened::<N>()
    }

    fn whole<const C: usize>(rows: &Rows<'_, C>) -> Option<Found> {
        Some(rows.whole())
    }
}

impl<const C: usize> Rows<'_, C> {
    /// Answers of all rows, with `answer` applied to chunks of rows in parallel.
    fn each(&self, answer: impl Fn(Range<usize>) -> Found + Sync + Send) -> Found {
        let rows = self.columns.rows();
        let mut parts = self.in_chunks(answer).into_iter();
        let Some(mut all) = parts.next() else { return Found::unclear(0, 0) };
        let more = rows.div_ceil(CHUNK).saturating_sub(1) * all.factor.len();
        all.factor.reserve(more);
        all.status.reserve(more);
        all.leaving.reserve(more * self.columns.contacts());
        for part in parts {
            all.factor.extend(part.factor);
            all.status.extend(part.status);
            all.leaving.extend(part.leaving);
        }
        all
    }

    fn found(&self, rows: usize) -> Found {
        let each = if self.own { 1 } else { self.loads.len() };
        Found::unclear(rows * each, self.columns.contacts())
    }

    /// Screens all rows, as grasps of `N` contacts.
    fn screened<const N: usize>(&self) -> Found {
        self.each(|rows| self.screen::<N>(rows))
    }

    /// Answers all rows by the full method, one grasp after the other, for any number of contacts.
    fn whole(&self) -> Found {
        self.each(|rows| {
            let mut found = self.found(rows.len());
            let first = rows.start;
            for row in rows {
                self.ask_whole(row, &mut found, (row - first) * self.of_row(row).len(), |_| true);
            }
            found
        })
    }

    fn screen<const N: usize>(&self, rows: Range<usize>) -> Found {
        let mut found = self.found(rows.len());
        let each = found.factor.len() / rows.len().max(1);
        let asked: Vec<Pull<C>> =
            if self.own { Vec::new() } else { self.pulls.iter().flatten().copied().collect() };
        let mut batch = Batch::<C, N>::with_capacity(if self.own { 0 } else { rows.len() });
        let mut screened = Vec::with_capacity(rows.len());
        let mut left = Vec::new();
        let first = rows.start;
        for row in rows {
            let contacts: [Contact<C>; N] = std::array::from_fn(|i| self.columns.contact(row, i));
            match (Fingers::new(&contacts), self.own) {
                (Ok(fingers), false) => {
                    batch.push(&fingers);
                    screened.push(row - first);
                }
                (Ok(fingers), true) => match &self.pulls[row] {
                    Ok(pull) => found.set(row - first, &fingers.onset(pull), N),
                    Err(status) => found.status[row - first] = *status as u8,
                },
                (Err(_), _) => left.push(row),
            }
        }
        self.scatter(&batch, &asked, &screened, &mut found);
        for row in left {
            // Malformed contacts, or springs that screening does not support: the full method answers or names the fault.
            self.ask_whole(row, &mut found, (row - first) * each, |_| true);
        }
        if self.complete {
            let open = |status: u8| status == Status::Unclear as u8 || status == Status::NotSticking as u8;
            for place in 0..found.factor.len() / each.max(1) {
                if found.status[place * each..(place + 1) * each].iter().any(|status| open(*status)) {
                    self.ask_whole(first + place, &mut found, place * each, open);
                }
            }
        }
        found
    }

    /// Copies the answers of a batch to the places of their rows and loads. `screened` has the row of each grasp in the batch.
    fn scatter<const N: usize>(
        &self,
        batch: &Batch<C, N>,
        asked: &[Pull<C>],
        screened: &[usize],
        found: &mut Found,
    ) {
        if self.own {
            return;
        }
        let mut answers = Vec::with_capacity(screened.len() * asked.len());
        batch.onsets_into(asked, &mut answers);
        let mut answers = answers.iter();
        for row in screened {
            for (p, pull) in self.pulls.iter().enumerate() {
                let place = row * self.pulls.len() + p;
                match pull {
                    Ok(_) => answers.by_ref().take(1).for_each(|answer| found.set(place, answer, N)),
                    Err(status) => found.status[place] = *status as u8,
                }
            }
        }
    }

    /// Answers the loads of one row by the full method where `wanted` accepts the present status. The answers begin at `place`.
    fn ask_whole(&self, row: usize, found: &mut Found, place: usize, wanted: impl Fn(u8) -> bool) {
        let contacts = (0..self.columns.contacts()).map(|i| self.columns.contact::<C>(row, i));
        let grasp = Grasp::<C>::new(contacts);
        for (place, load) in (place..).zip(self.of_row(row)) {
            if !wanted(found.status[place]) {
                continue;
            }
            if let Err(status) = &self.pulls[load] {
                found.status[place] = *status as u8;
                continue;
            }
            let [base, direction] = self.loads[load];
            let onset = grasp.as_ref().map_err(status_of).and_then(|grasp| {
                grasp.onset(Ramp::load(base, direction)).map_err(|error| status_of(&error))
            });
            match onset {
                Ok(onset) => found.set_whole(place, &onset, self.columns.contacts()),
                Err(status) => found.status[place] = status as u8,
            }
        }
    }
}

impl Found {
    fn unclear(answers: usize, contacts: usize) -> Self {
        Self {
            factor: vec![f64::NAN; answers],
            status: vec![Status::Unclear as u8; answers],
            leaving: vec![false; answers * contacts],
        }
    }

    #[inline]
    fn set(&mut self, place: usize, answer: &Screened, contacts: usize) {
        let (status, factor) = ended(answer);
        (self.factor[place], self.status[place]) = (factor, status as u8);
        for contact in answer.leaving() {
            self.leaving[place * contacts + contact] = true;
        }
    }

    fn set_whole<const C: usize>(&mut self, place: usize, onset: &Onset<C>, contacts: usize) {
        let (status, factor) = match onset {
            Onset::At(event) => {
                for leaving in &event.leaving {
                    self.leaving[place * contacts + leaving.contact.index] = true;
                }
                (Status::Leaves, event.factor)
            }
            Onset::Never => (Status::Never, f64::INFINITY),
            Onset::AlreadySliding(_) => (Status::AlreadySliding, f64::NAN),
            Onset::NoBase(_) => (Status::NoBase, f64::NAN),
            Onset::GivesWay { .. } => (Status::GivesWay, f64::NAN),
            _ => (Status::Unclear, f64::NAN),
        };
        (self.factor[place], self.status[place]) = (factor, status as u8);
    }
}

/// Status and factor of a screened row.
#[inline]
pub(crate) fn ended(answer: &Screened) -> (Status, f64) {
    match answer.verdict() {
        ScreeningVerdict::Leaves => (Status::Leaves, answer.factor().unwrap_or(f64::NAN)),
        ScreeningVerdict::Never => (Status::Never, f64::INFINITY),
        ScreeningVerdict::NotSticking => (Status::NotSticking, f64::NAN),
        ScreeningVerdict::GivesWay => (Status::GivesWay, f64::NAN),
        _ => (Status::Unclear, f64::NAN),
    }
}
