//! The linear complementarity problem.

use super::error::LcpError;
use crate::numerics::matrix_of;
use nalgebra::{DMatrix, DVector};

/// A linear complementarity problem (M, q) with finite entries: find z with 0 ≤ z ⟂ w = M z + q ≥ 0
/// (Cottle, Pang & Stone, *The Linear Complementarity Problem*, 1992).
#[derive(Debug, Clone, PartialEq)]
pub struct Lcp {
    pub(super) m: DMatrix<f64>,
    pub(super) q: DVector<f64>,
}

impl Lcp {
    /// The problem with the n × n matrix M and the vector q of n entries; n may be 0.
    ///
    /// # Errors
    ///
    /// [`LcpError::NotSquare`] for M, [`LcpError::Length`] if the length of q differs from the number of rows of M.
    /// [`LcpError::MatrixEntry`] and [`LcpError::VectorEntry`] for an entry that is not finite.
    pub fn new(m: DMatrix<f64>, q: DVector<f64>) -> Result<Self, LcpError> {
        LcpError::check_square("M", &m)?;
        LcpError::check_vector("q", &q, m.nrows())?;
        Ok(Self { m, q })
    }

    /// The problem with the given n rows of M, each of n entries, and the n entries of q.
    ///
    /// ```
    /// use grasp_lcp::lcp::Lcp;
    ///
    /// let problem = Lcp::from_rows(&[[2.0, 1.0], [1.0, 2.0]], &[-5.0, -6.0])?;
    /// assert_eq!(problem.matrix()[(1, 0)], 1.0);
    /// # Ok::<(), grasp_lcp::lcp::LcpError>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`LcpError::RowLength`] for the first row whose length differs from the number of rows. [`LcpError::Length`] if the length of q differs from
    /// the number of rows. [`LcpError::MatrixEntry`] and [`LcpError::VectorEntry`] for an entry that is not finite.
    pub fn from_rows<R: AsRef<[f64]>>(rows: &[R], q: &[f64]) -> Result<Self, LcpError> {
        let n = rows.len();
        if let Some(row) = rows.iter().position(|row| row.as_ref().len() != n) {
            return Err(LcpError::RowLength { row, given: rows[row].as_ref().len(), needed: n });
        }
        Self::new(matrix_of(n, n, &|i, j| rows[i].as_ref()[j]), DVector::from_column_slice(q))
    }
    /// The matrix M (n × n).
    #[must_use]
    pub fn matrix(&self) -> &DMatrix<f64> {
        &self.m
    }

    /// The vector q (n entries).
    #[must_use]
    pub fn vector(&self) -> &DVector<f64> {
        &self.q
    }

    /// Number n of complementary pairs (w_i, z_i): the rows of M.
    #[must_use]
    pub fn len(&self) -> usize {
        self.q.len()
    }

    /// Whether the problem has no rows, n = 0.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.q.is_empty()
    }
}
