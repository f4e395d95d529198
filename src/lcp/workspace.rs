//! Scratch buffers of the solver, used again from problem to problem. A dictionary is the condensed tableau of one basis. The problem is 0 ≤ z ⟂ w =
//! M z + q ≥ 0.

use super::basis::Basis;
use super::dictionary::LemkeVariable;
use super::memory::make_room;
use super::outcome::{BreakdownCause, OutcomeView, Unsolved};
use super::path::LemkePath;
use super::point::LcpPoint;
use super::residuals::Residuals;
use super::solution::SolutionView;
use crate::prelude::*;

/// Scratch buffers of the solver: vectors that are used again from problem to problem.
///
/// Once a workspace has solved a problem, it allocates nothing for other problems that are no larger. Only problems whose first path of Lemke's
/// method finds no solution need further allocations.
///
/// ```
/// use grasp_lcp::lcp::{Lcp, OutcomeView, Settings, Workspace};
/// use nalgebra::{DMatrix, DVector};
///
/// let mut workspace = Workspace::new();
/// for load in 1..4 {
///     let q = DVector::from_element(1, -f64::from(load));
///     let problem = Lcp::new(DMatrix::from_element(1, 1, 2.0), q)?;
///     let answer = workspace.solve(&problem, &Settings::default());
///     let OutcomeView::Solved(solution) = answer else { panic!("2 > 0") };
///     assert_eq!(solution.z, [f64::from(load) / 2.0]);
/// }
/// # Ok::<(), grasp_lcp::lcp::LcpError>(())
/// ```
#[derive(Debug, Clone, Default)]
pub struct Workspace {
    pub(super) path: LemkePath,
    /// The point z, with slacks w, at the end of the last path of Lemke's method.
    pub(super) point: LcpPoint,
    /// A second point, which replaces `point` if it has the smaller residuals.
    pub(super) candidate: LcpPoint,
    /// Entry j is `true` if z_j is basic at the end of the last path, but zero up to rounding.
    pub(super) vanishing: Vec<bool>,
    pub(super) correction: Vec<f64>,
    pub(super) defect: Vec<f64>,
    pub(super) basis: Basis,
    /// The residuals of `point`; `None` until `point` has been accepted as a solution.
    pub(super) residuals: Option<Residuals>,
    pub(super) degenerate: bool,
}

impl Workspace {
    /// A workspace whose buffers are empty.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    pub(super) fn answer(&self, failure: Option<Unsolved>) -> OutcomeView<'_> {
        let view = |residuals| SolutionView {
            z: &self.point.z,
            w: &self.point.w,
            basis: &self.basis,
            residuals,
            pivots: self.path.pivots,
            degenerate: self.degenerate,
        };
        let broken =
            || OutcomeView::Breakdown { pivots: self.path.pivots, cause: BreakdownCause::SingularBasis };
        match failure {
            Some(unsolved) => unsolved.into(),
            None => self.residuals.map_or_else(broken, |residuals| OutcomeView::Solved(view(residuals))),
        }
    }

    pub(super) fn reserve(&mut self, n: usize) {
        let LcpPoint { z, w, terms } = &mut self.candidate;
        for scratch in [&mut self.correction, &mut self.defect, z, w, terms] {
            make_room(scratch, n);
        }
    }

    /// Whether the dictionary that the workspace holds belongs to a complementary basis.
    pub(super) fn is_complementary(&self) -> bool {
        let dictionary = &self.path.dictionary;
        dictionary.basic.iter().all(|basic| match *basic {
            LemkeVariable::W(i) => !dictionary.is_active(i),
            LemkeVariable::Z(i) => dictionary.is_active(i),
            LemkeVariable::Covering => false,
        })
    }

    /// Whether the dictionary that the workspace holds belongs to this complementary basis.
    pub(super) fn holds(&self, basis: &Basis) -> bool {
        self.is_complementary()
            && (0..basis.len()).all(|i| self.path.dictionary.is_active(i) == basis.contains(i))
    }
}
