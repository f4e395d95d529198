//! Problems 0 ≤ z ⟂ w = M z + q ≥ 0 with one matrix M and many right-hand sides q.

use super::error::LcpError;
use super::outcome::OutcomeView;
use super::problem::Lcp;
use super::settings::Settings;
use super::workspace::Workspace;
use nalgebra::{DMatrix, DVector};

/// A series of problems with the same M, each solved from the basis of the previous problem.
///
/// The dictionary (condensed tableau) of the last basis is kept. A new q costs about as much as one pivot for its values, plus one pivot per change
/// of the basis. From the third problem on nothing is allocated, unless a path fails.
///
/// ```
/// use grasp_lcp::lcp::{Series, OutcomeView, Settings};
/// use nalgebra::{DMatrix, DVector};
///
/// let m = DMatrix::from_row_slice(2, 2, &[2.0, 1.0, 1.0, 2.0]);
/// let mut series = Series::new(m, Settings::default())?;
/// for (q, pivots) in [([-5.0, -6.0], 3), ([-5.0, -6.1], 0)] {
///     let q = DVector::from_column_slice(&q);
///     let OutcomeView::Solved(solution) = series.solve(&q)? else { panic!("M > 0") };
///     assert_eq!(solution.pivots, pivots);
/// }
/// # Ok::<(), grasp_lcp::lcp::LcpError>(())
/// ```
#[derive(Debug, Clone)]
pub struct Series {
    lcp: Lcp,
    settings: Settings,
    workspace: Workspace,
    /// Whether the workspace holds the dictionary of a complementary basis, from which the next problem can start.
    started: bool,
}

impl Series {
    /// A series of problems with the n × n matrix M.
    ///
    /// # Errors
    ///
    /// [`LcpError::NotSquare`] for a matrix that is not square, [`LcpError::MatrixEntry`] for an
    /// entry that is not finite.
    pub fn new(m: DMatrix<f64>, settings: Settings) -> Result<Self, LcpError> {
        let q = DVector::zeros(m.nrows());
        Ok(Self { lcp: Lcp::new(m, q)?, settings, workspace: Workspace::new(), started: false })
    }

    /// Solves the problem with right-hand side q (n entries).
    ///
    /// # Errors
    ///
    /// [`LcpError::Length`] if the length of q differs from the number of rows of M, [`LcpError::VectorEntry`] for an entry that is not finite.
    pub fn solve(&mut self, q: &DVector<f64>) -> Result<OutcomeView<'_>, LcpError> {
        LcpError::check_vector("q", q, self.lcp.len())?;
        self.lcp.q.copy_from(q);
        let failure = if self.started {
            self.workspace.solve_next(&self.lcp, &self.settings)
        } else {
            self.workspace.solve_first(&self.lcp, &self.settings)
        };
        self.started = failure.is_none() && self.workspace.is_complementary();
        Ok(self.workspace.answer(failure))
    }
}
