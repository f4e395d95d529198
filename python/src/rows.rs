//! Rows of grasps with their loads, shared by batches of onsets and of gradients.

use std::ops::Range;

use grasp_lcp::Error;
use grasp_lcp::grasp::Wrench;
use grasp_lcp::screening::Pull;
use grasp_lcp::sweep::map_in_order;
use numpy::ndarray::ArrayView2;

use crate::columns::Columns;
use crate::errors::has_nan;

/// Grasps in one task of a thread. This number stays in the cache of a core from reading to screening.
pub(crate) const CHUNK: usize = 2048;

/// Outcome of a row, numbered as in `grasp_lcp.OnsetStatus`.
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

/// A question about rows, compiled for each size that screening supports.
pub(crate) trait Asked {
    type Answer;

    /// Answers for grasps of `N` contacts.
    fn screened<const C: usize, const N: usize>(rows: &Rows<'_, C>) -> Self::Answer;

    /// Answers for grasps of any other number of contacts; `None` if the question does not support them.
    fn whole<const C: usize>(rows: &Rows<'_, C>) -> Option<Self::Answer>;
}

/// Dispatches question `A` on axes and number of contacts. `None` if it supports no grasps of this size.
pub(crate) fn by_size<'a, A: Asked>(
    columns: &'a Columns<'a>,
    loads: (&ArrayView2<'_, f64>, &ArrayView2<'_, f64>),
    own: bool,
    complete: bool,
) -> Option<A::Answer> {
    let in_plane = || Rows::<2>::new(columns, loads, own, complete);
    let in_space = || Rows::<3>::new(columns, loads, own, complete);
    match (columns.axes(), columns.contacts()) {
        (2, 2) => Some(A::screened::<2, 2>(&in_plane())),
        (2, 3) => Some(A::screened::<2, 3>(&in_plane())),
        (2, 4) => Some(A::screened::<2, 4>(&in_plane())),
        (2, 5) => Some(A::screened::<2, 5>(&in_plane())),
        (2, _) => A::whole(&in_plane()),
        (3, 2) => Some(A::screened::<3, 2>(&in_space())),
        (3, 3) => Some(A::screened::<3, 3>(&in_space())),
        (3, 4) => Some(A::screened::<3, 4>(&in_space())),
        (3, 5) => Some(A::screened::<3, 5>(&in_space())),
        (3, _) => A::whole(&in_space()),
        _ => None,
    }
}

/// Rows of grasps with their loads.
pub(crate) struct Rows<'a, const C: usize> {
    pub(crate) columns: &'a Columns<'a>,
    pub(crate) loads: Vec<[Wrench<C>; 2]>,
    pub(crate) pulls: Vec<Result<Pull<C>, Status>>,
    /// Whether row k has load k alone, in place of all loads.
    pub(crate) own: bool,
    /// Whether the full method answers rows that screening leaves open.
    pub(crate) complete: bool,
}

impl<'a, const C: usize> Rows<'a, C> {
    fn new(
        columns: &'a Columns<'a>,
        (base, direction): (&ArrayView2<'_, f64>, &ArrayView2<'_, f64>),
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

    /// Indices of the loads of a row.
    pub(crate) fn of_row(&self, row: usize) -> Range<usize> {
        if self.own { row..row + 1 } else { 0..self.loads.len() }
    }

    /// Applies `answer` to chunks of rows in parallel, and returns the results in order.
    pub(crate) fn in_chunks<T: Send>(&self, answer: impl Fn(Range<usize>) -> T + Sync + Send) -> Vec<T> {
        let rows = self.columns.rows();
        let chunks: Vec<_> = (0..rows).step_by(CHUNK).map(|first| first..rows.min(first + CHUNK)).collect();
        map_in_order(&chunks, |chunk| answer(chunk.clone()))
    }
}

/// Status of a row that the crate refuses.
pub(crate) fn status_of(error: &Error) -> Status {
    if has_nan(error) { Status::NotANumber } else { Status::Malformed }
}
