//! The linear complementarity problem.

use super::error::LcpError;
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

    /// Number n of pairs (w_i, z_i).
    #[must_use]
    pub fn len(&self) -> usize {
        self.q.len()
    }

    /// Whether n = 0.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.q.is_empty()
    }
}
