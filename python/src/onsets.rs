//! Onsets of sliding of many grasps, on all cores.

use std::ops::Range;

use grasp_lcp::ask::Grasp;
use grasp_lcp::load_path::{Onset, Ramp};
use grasp_lcp::screening::{PointBatch, Pull, Screened, ScreeningVerdict};
use numpy::{IntoPyArray, PyArray1, PyReadonlyArray2};
use pyo3::prelude::*;

use crate::columns::GivenColumns;
use crate::errors::wrong;
use crate::rows::{Rows, Status, status_of};

/// Answers for some rows (grasps) as flat arrays: row by row, and load by load within each row.
struct OnsetColumns {
    factor: Vec<f64>,
    status: Vec<u8>,
    leaving: Vec<bool>,
}

type Arrays<'py> = (Bound<'py, PyArray1<f64>>, Bound<'py, PyArray1<u8>>, Bound<'py, PyArray1<bool>>);

/// First-slip factors, statuses, and flags of the contacts that stop sticking, for B grasps under P loads. With `own`, grasp k has load k alone;
/// otherwise each grasp has all loads.
#[pyfunction]
pub(crate) fn onsets_of_rows<'py>(
    py: Python<'py>,
    columns: GivenColumns<'py>,
    base: PyReadonlyArray2<'py, f64>,
    direction: PyReadonlyArray2<'py, f64>,
    own: bool,
    complete: bool,
) -> PyResult<Arrays<'py>> {
    let (columns, loads) = (columns.view(), (&base.as_array(), &direction.as_array()));
    let found = match columns.axes() {
        2 => {
            let rows = Rows::<2>::new(&columns, loads, own, complete)?;
            py.detach(|| rows.onsets())
        }
        3 => {
            let rows = Rows::<3>::new(&columns, loads, own, complete)?;
            py.detach(|| rows.onsets())
        }
        _ => return Err(wrong("points: must have 2 or 3 coordinates")),
    };
    let OnsetColumns { factor, status, leaving } = found;
    Ok((factor.into_pyarray(py), status.into_pyarray(py), leaving.into_pyarray(py)))
}

impl<const C: usize> Rows<'_, C> {
    /// Answers of all rows, in parallel.
    fn onsets(&self) -> OnsetColumns {
        let parts = self.in_chunks(|rows| self.screen(rows));
        let mut all = OnsetColumns::unclear(0, 0);
        let answers = parts.iter().map(|part| part.factor.len()).sum();
        all.factor.reserve(answers);
        all.status.reserve(answers);
        all.leaving.reserve(answers * self.columns.contacts());
        for part in parts {
            all.factor.extend(part.factor);
            all.status.extend(part.status);
            all.leaving.extend(part.leaving);
        }
        all
    }

    fn screen(&self, rows: Range<usize>) -> OnsetColumns {
        let each = if self.own { 1 } else { self.loads.len() };
        let contacts = self.columns.contacts();
        let mut found = OnsetColumns::unclear(rows.len() * each, contacts);
        let mut asked: Vec<Pull<C>> =
            if self.own { Vec::new() } else { self.pulls.iter().flatten().copied().collect() };
        let mut batch = PointBatch::with_capacity(self.pads.counts().iter().sum(), rows.len());
        let (mut screened, mut left, mut points) = (Vec::with_capacity(rows.len()), Vec::new(), Vec::new());
        let first = rows.start;
        for row in rows {
            self.fill(row, &mut points);
            match (self.own, self.pulls.get(row)) {
                (true, Some(Err(status))) => found.status[row - first] = *status as u8,
                (true, Some(Ok(pull))) if batch.push(&points) => {
                    asked.push(*pull);
                    screened.push(row - first);
                }
                (false, _) if batch.push(&points) => screened.push(row - first),
                _ => left.push(row),
            }
        }
        let mut answers = Vec::with_capacity(screened.len() * each);
        if self.own {
            answers = batch.own_onsets(asked);
        } else {
            batch.onsets_into(&asked, &mut answers);
        }
        let mut answers = answers.iter();
        for row in screened {
            let pulls = if self.own { &self.pulls[first + row..=first + row] } else { &self.pulls[..] };
            for (place, pull) in (row * each..).zip(pulls) {
                match pull {
                    Ok(_) => answers.by_ref().take(1).for_each(|answer| found.set(place, answer, contacts)),
                    Err(status) => found.status[place] = *status as u8,
                }
            }
        }
        for row in left {
            // Screening refuses malformed contacts, and numbers of points or springs that it does not support. `Grasp::onset` answers these rows or
            // finds the fault.
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

    /// Answers the loads of one grasp (row) by `Grasp::onset`, without screening, if `wanted` accepts their present status. The answers of the row
    /// begin at index `place`.
    fn ask_whole(&self, row: usize, found: &mut OnsetColumns, place: usize, wanted: impl Fn(u8) -> bool) {
        let mut points = Vec::new();
        self.fill(row, &mut points);
        let grasp = Grasp::<C>::new(points);
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
                Ok(onset) => found.set_whole(place, &onset, &self.pads.counts()),
                Err(status) => found.status[place] = status as u8,
            }
        }
    }
}

impl OnsetColumns {
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

    /// Sets an answer of `Grasp::onset`; `counts` has the number of points of each contact.
    fn set_whole<const C: usize>(&mut self, place: usize, onset: &Onset<C>, counts: &[usize]) {
        let (status, factor) = match onset {
            Onset::At(event) => {
                let (leaving, mut end) = (&mut self.leaving[place * counts.len()..], 0);
                for (leaves, count) in leaving.iter_mut().zip(counts) {
                    let points = end..end + count;
                    *leaves = event.leaving.iter().any(|leaving| points.contains(&leaving.contact.index));
                    end = points.end;
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

/// Status and load factor of an answer of screening.
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
