//! Onsets of sliding of many grasps, on all cores.

use std::ops::Range;

use grasp_lcp::Error;
use grasp_lcp::ask::Grasp;
use grasp_lcp::grasp::{Contact, Wrench};
use grasp_lcp::load_path::{Onset, Ramp};
use grasp_lcp::screening::{Batch, Fingers, Pull, Screened, ScreeningVerdict};
use grasp_lcp::sweep::map_in_order;
use numpy::ndarray::ArrayView2;
use numpy::{IntoPyArray, PyArray1, PyReadonlyArray2};
use pyo3::prelude::*;

use crate::columns::{Columns, GivenColumns};
use crate::errors::{has_nan, wrong};

/// Grasps that a thread takes at once: so many stay in its cache from being read to being screened.
pub(crate) const CHUNK: usize = 2048;

/// How a row ends; `grasp_lcp.OnsetStatus` has the numbers.
#[derive(Clone, Copy, PartialEq)]
#[repr(u8)]
pub(crate) enum Status {
    Leaves,
    Never,
    NotSticking,
    GivesWay,
    Unclear,
    AlreadySliding,
    NoBase,
    NotANumber,
    Malformed,
}

/// Answers of some rows, load by load within each.
struct Found {
    factor: Vec<f64>,
    status: Vec<u8>,
    leaving: Vec<bool>,
}

type Arrays<'py> = (Bound<'py, PyArray1<f64>>, Bound<'py, PyArray1<u8>>, Bound<'py, PyArray1<bool>>);

/// Factors, states and leaving contacts of B grasps under P loads: all loads for each grasp, or each its own.
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
    let found = py.detach(|| match (columns.axes(), columns.contacts()) {
        (2, 2) => Some(Rows::<2>::new(&columns, &base, &direction, own, complete).screened::<3, 2>()),
        (2, 3) => Some(Rows::<2>::new(&columns, &base, &direction, own, complete).screened::<3, 3>()),
        (2, 4) => Some(Rows::<2>::new(&columns, &base, &direction, own, complete).screened::<3, 4>()),
        (2, 5) => Some(Rows::<2>::new(&columns, &base, &direction, own, complete).screened::<3, 5>()),
        (2, _) => Some(Rows::<2>::new(&columns, &base, &direction, own, complete).whole()),
        (3, 2) => Some(Rows::<3>::new(&columns, &base, &direction, own, complete).screened::<6, 2>()),
        (3, 3) => Some(Rows::<3>::new(&columns, &base, &direction, own, complete).screened::<6, 3>()),
        (3, 4) => Some(Rows::<3>::new(&columns, &base, &direction, own, complete).screened::<6, 4>()),
        (3, 5) => Some(Rows::<3>::new(&columns, &base, &direction, own, complete).screened::<6, 5>()),
        (3, _) => Some(Rows::<3>::new(&columns, &base, &direction, own, complete).whole()),
        _ => None,
    });
    let Found { factor, status, leaving } =
        found.ok_or_else(|| wrong("points: must have 2 or 3 coordinates"))?;
    Ok((factor.into_pyarray(py), status.into_pyarray(py), leaving.into_pyarray(py)))
}

/// What is asked of each row.
pub(crate) struct Rows<'a, const C: usize> {
    pub(crate) columns: &'a Columns<'a>,
    loads: Vec<[Wrench<C>; 2]>,
    pub(crate) pulls: Vec<Result<Pull<C>, Status>>,
    /// Whether each row has its own load.
    pub(crate) own: bool,
    /// Whether the method of the whole answers what screening leaves open.
    complete: bool,
}

impl<'a, const C: usize> Rows<'a, C> {
    pub(crate) fn new(
        columns: &'a Columns<'a>,
        base: &ArrayView2<'_, f64>,
        direction: &ArrayView2<'_, f64>,
        own: bool,
        complete: bool,
    ) -> Self {
        let load = |of: &ArrayView2<'_, f64>, p: usize| Wrench::from_components(&of.row(p).to_vec());
        let loads: Vec<_> = (0..direction.nrows()).map(|p| [load(base, p), load(direction, p)]).collect();
        let pull = |[base, direction]: &[_; 2]| match Pull::new(base, direction) {
            Ok(_) if *direction == Wrench::ZERO => Err(Status::Malformed),
            pull => pull.map_err(|error| status_of(&error)),
        };
        let pulls = loads.iter().map(pull).collect();
        Self { columns, loads, pulls, own, complete }
    }

    /// Loads of a row.
    pub(crate) fn of_row(&self, row: usize) -> Range<usize> {
        if self.own { row..row + 1 } else { 0..self.loads.len() }
    }

    /// What comes of some rows at once.
    pub(crate) fn in_chunks<T: Send>(&self, answer: impl Fn(Range<usize>) -> T + Sync + Send) -> Vec<T> {
        let rows = self.columns.rows();
        let chunks: Vec<_> = (0..rows).step_by(CHUNK).map(|first| first..rows.min(first + CHUNK)).collect();
        map_in_order(&chunks, |chunk| answer(chunk.clone()))
    }

    /// Every row by what answers some of them.
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

    /// Grasps of `N` contacts, screened side by side.
    fn screened<const D: usize, const N: usize>(&self) -> Found {
        self.each(|rows| self.screen::<D, N>(rows))
    }

    /// Grasps of any number of contacts, one by one.
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

    fn screen<const D: usize, const N: usize>(&self, rows: Range<usize>) -> Found {
        let mut found = self.found(rows.len());
        let each = found.factor.len() / rows.len().max(1);
        let asked: Vec<Pull<C>> =
            if self.own { Vec::new() } else { self.pulls.iter().flatten().copied().collect() };
        let mut batch = Batch::<D, C, N>::with_capacity(if self.own { 0 } else { rows.len() });
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
            // Malformed, or with springs that are no business of screening: the whole method knows.
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

    /// The answers of a batch to where their rows and loads have them.
    fn scatter<const D: usize, const N: usize>(
        &self,
        batch: &Batch<D, C, N>,
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

    /// The onsets of one row by the whole method, where it is wanted, from the given place on.
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
                grasp.onset(&Ramp::load(base, direction)).map_err(|error| status_of(&error))
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

/// How screening ended, with the factor.
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

/// What is wrong with a row.
pub(crate) fn status_of(error: &Error) -> Status {
    if has_nan(error) { Status::NotANumber } else { Status::Malformed }
}
