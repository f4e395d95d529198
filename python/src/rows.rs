//! Many grasps with their loads, one grasp a row: the input of batches of onsets, gradients and verdicts.

use std::ops::Range;

use grasp_lcp::Error;
use grasp_lcp::grasp::{Contact, Wrench};
use grasp_lcp::screening::Pull;
use grasp_lcp::sweep::map_in_order;
use numpy::ndarray::ArrayView2;
use pyo3::PyResult;

use crate::columns::{Columns, Pads};
use crate::errors::has_nan;

/// Number of contact points in one task of a thread. They stay in the cache of a core from reading to screening.
const POINTS: usize = 6144;

/// Outcome for one grasp under one load, numbered as in `grasp_lcp.OnsetStatus`.
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

/// Grasps, one a row, with their loads.
pub(crate) struct Rows<'a, const C: usize> {
    pub(crate) columns: &'a Columns<'a>,
    pub(crate) pads: Pads<C>,
    pub(crate) loads: Vec<[Wrench<C>; 2]>,
    pub(crate) pulls: Vec<Result<Pull<C>, Status>>,
    /// Whether row k has load k alone; otherwise each row has all loads.
    pub(crate) own: bool,
    /// Whether `Grasp::onset`, the slower method, answers the grasps that screening does not decide.
    pub(crate) complete: bool,
}

impl<'a, const C: usize> Rows<'a, C> {
    /// Grasps, one a row, with their base loads and load directions.
    ///
    /// # Errors
    /// Pads that are malformed.
    pub(crate) fn new(
        columns: &'a Columns<'a>,
        (base, direction): (&ArrayView2<'_, f64>, &ArrayView2<'_, f64>),
        own: bool,
        complete: bool,
    ) -> PyResult<Self> {
        let load = |of: &ArrayView2<'_, f64>, p: usize| Wrench::from_components(&of.row(p).to_vec());
        let loads: Vec<_> = (0..direction.nrows()).map(|p| [load(base, p), load(direction, p)]).collect();
        let pull = |[base, direction]: &[_; 2]| match Pull::new(base, direction) {
            Ok(_) if *direction == Wrench::ZERO => Err(Status::Malformed),
            pull => pull.map_err(|error| status_of(&error)),
        };
        let pulls = loads.iter().map(pull).collect();
        Ok(Self { columns, pads: columns.pads()?, loads, pulls, own, complete })
    }

    /// Writes the points of all contacts of a row into a list, whose memory is reused.
    pub(crate) fn fill(&self, row: usize, points: &mut Vec<Contact<C>>) {
        points.clear();
        self.columns.fill(&self.pads, row, points);
    }

    /// Indices of the loads of a row.
    pub(crate) fn of_row(&self, row: usize) -> Range<usize> {
        if self.own { row..row + 1 } else { 0..self.loads.len() }
    }

    /// Applies `answer` to chunks of rows in parallel, and returns the results in order.
    pub(crate) fn in_chunks<T: Send>(&self, answer: impl Fn(Range<usize>) -> T + Sync + Send) -> Vec<T> {
        let (rows, points) = (self.columns.rows(), self.pads.counts().iter().sum::<usize>());
        let chunk = (POINTS / points.max(1)).max(1);
        let chunks: Vec<_> = (0..rows).step_by(chunk).map(|first| first..rows.min(first + chunk)).collect();
        map_in_order(&chunks, |chunk| answer(chunk.clone()))
    }
}

/// Status of a grasp and load that the crate refuses with this error.
pub(crate) fn status_of(error: &Error) -> Status {
    if has_nan(error) { Status::NotANumber } else { Status::Malformed }
}
