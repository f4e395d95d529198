//! Problems from rows, from the entries of a sparse matrix, and from text.

use super::error::LcpError;
use super::problem::Lcp;
use crate::numerics::matrix_of;
use crate::prelude::*;
use core::fmt;
use core::str::FromStr;
use nalgebra::{DMatrix, DVector};

impl Lcp {
    /// The problem with the rows of M, each of n entries, and q.
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
    /// [`LcpError::RowLength`] for a row whose length differs from the number of rows. Otherwise as for [`Lcp::new`].
    pub fn from_rows<R: AsRef<[f64]>>(rows: &[R], q: &[f64]) -> Result<Self, LcpError> {
        let n = rows.len();
        if let Some(row) = rows.iter().position(|row| row.as_ref().len() != n) {
            return Err(LcpError::RowLength { row, given: rows[row].as_ref().len(), needed: n });
        }
        Self::new(matrix_of(n, n, &|i, j| rows[i].as_ref()[j]), DVector::from_column_slice(q))
    }

    /// The problem with the entries (row, column, value) of a sparse M, counted from 0, and q. Entries that are not given are zero; entries at
    /// the same position are added.
    ///
    /// ```
    /// use grasp_lcp::lcp::Lcp;
    ///
    /// // A string of four points: −1, 2, −1 in each row.
    /// let n = 4;
    /// let row = |i: usize| [(i, i.wrapping_sub(1), -1.0), (i, i, 2.0), (i, i + 1, -1.0)];
    /// let places = (0..n).flat_map(row).filter(|(_, j, _)| *j < n);
    /// let problem = Lcp::from_triplets(places, &[-1.0; 4])?;
    /// assert!(problem.solve().solution().is_some_and(|solution| (solution.z[1] - 3.0).abs() < 1e-14));
    /// # Ok::<(), grasp_lcp::lcp::LcpError>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`LcpError::Place`] for an entry outside of M. Otherwise as for [`Lcp::new`].
    pub fn from_triplets(
        entries: impl IntoIterator<Item = (usize, usize, f64)>,
        q: &[f64],
    ) -> Result<Self, LcpError> {
        let n = q.len();
        let mut m = DMatrix::zeros(n, n);
        for (row, column, value) in entries {
            *m.get_mut((row, column)).ok_or(LcpError::Place { row, column, size: n })? += value;
        }
        Self::new(m, DVector::from_column_slice(q))
    }
}

/// Reads a problem from numbers separated by white space: n, the rows of M, and q. The rest of a line after `#` is a comment.
///
/// ```
/// use grasp_lcp::lcp::Lcp;
///
/// let problem: Lcp = "2  # pairs\n 2 1\n 1 2\n -5 -6".parse()?;
/// assert_eq!(problem.to_string(), "2\n2e0 1e0\n1e0 2e0\n-5e0 -6e0\n");
/// assert_eq!(problem.to_string().parse::<Lcp>()?, problem);
/// # Ok::<(), grasp_lcp::lcp::LcpError>(())
/// ```
///
/// [`LcpError::Word`] for a word that is not a number, [`LcpError::Count`] if the text does not have 1 + n² + n numbers.
impl FromStr for Lcp {
    type Err = LcpError;

    fn from_str(text: &str) -> Result<Self, LcpError> {
        let mut words = Vec::new();
        for line in text.lines() {
            words.extend(line.split('#').next().unwrap_or(line).split_whitespace());
        }
        let wrong = |at: usize, word: &str, allowed| LcpError::Word { at, word: word.to_string(), allowed };
        let first = words.first().copied().ok_or(LcpError::Count { given: 0, needed: 1 })?;
        let n: usize = first.parse().map_err(|_| wrong(0, first, "the number of pairs"))?;
        let mut numbers: Vec<f64> = Vec::with_capacity(words.len());
        for (at, word) in words.iter().enumerate().skip(1) {
            numbers.push(word.parse().map_err(|_| wrong(at, word, "a number"))?);
        }
        let needed = n.saturating_mul(n).saturating_add(n);
        if numbers.len() != needed {
            return Err(LcpError::Count { given: 1 + numbers.len(), needed: needed.saturating_add(1) });
        }
        let (m, q) = numbers.split_at(n * n);
        Self::new(DMatrix::from_row_slice(n, n, m), DVector::from_column_slice(q))
    }
}

/// Writes the text that [`Lcp::from_str`] reads back bit by bit.
impl fmt::Display for Lcp {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "{}", self.len())?;
        for i in 0..self.len() {
            line(f, self.m.row(i).iter())?;
        }
        if self.is_empty() { Ok(()) } else { line(f, self.q.iter()) }
    }
}

fn line<'a>(f: &mut fmt::Formatter<'_>, numbers: impl Iterator<Item = &'a f64>) -> fmt::Result {
    for (k, x) in numbers.enumerate() {
        write!(f, "{}{x:e}", if k == 0 { "" } else { " " })?;
    }
    writeln!(f)
}
