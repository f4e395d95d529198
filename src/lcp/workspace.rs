//! Memory for solving many problems.

use super::Lcp;
use super::basis::Basis;
use super::conclusion::Point;
use super::dictionary::Unknown;
use super::lemke::Path;
use super::outcome::{BreakdownCause, Outcome, Solution};
use super::residuals::Residuals;
use super::settings::Settings;
use nalgebra::DVector;

/// Memory that is kept between problems: once it has held a problem of some size, solving further problems of at most
/// that size allocates nothing, as long as they are solved by the first path.
///
/// ```
/// use grasp_lcp::lcp::{Answer, Lcp, Settings, Workspace};
/// use nalgebra::{DMatrix, DVector};
///
/// let mut workspace = Workspace::new();
/// for load in 1..4 {
///     let problem = Lcp::new(DMatrix::from_element(1, 1, 2.0), DVector::from_element(1, -f64::from(load)))?;
///     let Answer::Solved(solution) = workspace.solve(&problem, &Settings::default()) else { panic!("2 > 0") };
///     assert_eq!(solution.z, [f64::from(load) / 2.0]);
/// }
/// # Ok::<(), grasp_lcp::lcp::LcpError>(())
/// ```
#[derive(Debug, Clone, Default)]
pub struct Workspace {
    pub(crate) path: Path,
    /// Where the last path ended, and another point to compare it with.
    pub(super) point: Point,
    pub(super) spare: Point,
    /// Which basic z's are zero but for rounding.
    pub(super) vanishing: Vec<bool>,
    pub(super) correction: Vec<f64>,
    pub(super) defect: Vec<f64>,
    pub(super) basis: Basis,
    /// Of the point, once it has passed as a solution.
    pub(super) residuals: Option<Residuals>,
    pub(super) degenerate: bool,
}

/// What a [`Workspace`] or a [`Series`](super::Series) answers: a view of the solution it holds, or the [`Outcome`] that is not one.
#[derive(Debug, Clone, PartialEq)]
pub enum Answer<'a> {
    /// The problem is solved.
    Solved(SolutionView<'a>),
    /// It is not; the outcome is never [`Outcome::Solved`].
    Unsolved(Box<Outcome>),
}

/// A [`Solution`] that still lies in the memory of its [`Workspace`] or [`Series`](super::Series); the fields mean the same.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct SolutionView<'a> {
    /// z (n entries, none negative).
    pub z: &'a [f64],
    /// w = M z + q (n entries, none negative; exactly zero where z_i is basic).
    pub w: &'a [f64],
    /// Which z_i are basic.
    pub basis: &'a Basis,
    /// The violations at z, recomputed from the M and q given.
    pub residuals: Residuals,
    /// Pivots made, on all paths.
    pub pivots: usize,
    /// Whether a basic variable is zero.
    pub degenerate: bool,
}

impl SolutionView<'_> {
    /// A copy that outlives the workspace.
    #[must_use]
    pub fn to_solution(&self) -> Solution {
        Solution {
            z: DVector::from_column_slice(self.z),
            w: DVector::from_column_slice(self.w),
            basis: self.basis.clone(),
            residuals: self.residuals,
            pivots: self.pivots,
            degenerate: self.degenerate,
        }
    }
}

impl Answer<'_> {
    /// A copy that outlives the workspace.
    #[must_use]
    pub fn into_outcome(self) -> Outcome {
        match self {
            Self::Solved(view) => Outcome::Solved(view.to_solution()),
            Self::Unsolved(outcome) => *outcome,
        }
    }
}

impl Workspace {
    /// A workspace without memory yet.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Solves a problem like [`Lcp::solve_with`].
    pub fn solve(&mut self, lcp: &Lcp, settings: &Settings) -> Answer<'_> {
        let outcome = self.solve_cold(lcp, settings);
        self.answer(outcome)
    }

    /// Solves a problem like [`Lcp::solve_from`].
    pub fn solve_from(&mut self, lcp: &Lcp, basis: &Basis, settings: &Settings) -> Answer<'_> {
        let outcome = self.solve_warm(lcp, basis, settings);
        self.answer(outcome)
    }

    pub(crate) fn answer(&self, failure: Option<Outcome>) -> Answer<'_> {
        match (failure, self.residuals) {
            (None, Some(residuals)) => Answer::Solved(SolutionView {
                z: &self.point.z,
                w: &self.point.w,
                basis: &self.basis,
                residuals,
                pivots: self.path.pivots,
                degenerate: self.degenerate,
            }),
            (failure, _) => Answer::Unsolved(Box::new(failure.unwrap_or(Outcome::Breakdown {
                pivots: self.path.pivots,
                cause: BreakdownCause::SingularBasis,
            }))),
        }
    }

    /// Room for the steps that only some problems need.
    pub(super) fn reserve(&mut self, n: usize) {
        for scratch in [
            &mut self.correction,
            &mut self.defect,
            &mut self.spare.z,
            &mut self.spare.w,
            &mut self.spare.terms,
        ] {
            scratch.reserve(n.saturating_sub(scratch.len()));
        }
    }

    /// Whether the dictionary is that of a complementary basis.
    pub(crate) fn is_complementary(&self) -> bool {
        let dictionary = &self.path.dictionary;
        dictionary.basic.iter().all(|basic| match *basic {
            Unknown::W(i) => !dictionary.is_active(i),
            Unknown::Z(i) => dictionary.is_active(i),
            Unknown::Covering => false,
        })
    }

    /// Whether the dictionary is that of this complementary basis.
    pub(crate) fn holds(&self, basis: &Basis) -> bool {
        self.is_complementary()
            && (0..basis.len()).all(|i| self.path.dictionary.is_active(i) == basis.contains(i))
    }
}
