//! Serde forms of problems and outcomes: matrices as lists of rows, vectors as lists.
//!
//! | type | in JSON |
//! |---|---|
//! | [`Lcp`] | `{"m": [[2, 1], [1, 2]], "q": [-5, -6]}` |
//! | [`MixedLcp`] | `{"a": …, "c": …, "d": …, "m": …, "b": …, "q": …}` |
//! | [`Outcome`](super::Outcome) | `{"solved": {"z": …, "w": …, "basis": [0, 1], …}}`, `{"infeasible": {"y": …, "pivots": 3}}`, … |

use super::basis::Basis;
use super::mixed::MixedLcp;
use super::problem::Lcp;
use crate::numerics::{Each, IntoList, matrix_of};
use crate::prelude::*;
use nalgebra::{DMatrix, DVector};
use serde::de::Error;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

/// A matrix as a list of rows. The other blocks give the number of columns, which a matrix without rows does not show.
#[derive(Serialize, Deserialize)]
#[serde(transparent)]
struct Rows(Vec<Vec<f64>>);

impl Rows {
    fn of(matrix: &DMatrix<f64>) -> Self {
        Self(matrix.row_iter().map(|row| row.iter().copied().list()).list())
    }

    /// The matrix; `what` names it in messages.
    fn matrix(&self, what: &str, columns: usize) -> Result<DMatrix<f64>, String> {
        if let Some((i, row)) = self.0.iter().enumerate().find(|(_, row)| row.len() != columns) {
            return Err(format!("row {i} of {what} has {} numbers, must be {columns}", row.len()));
        }
        Ok(matrix_of(self.0.len(), columns, &|i, j| self.0[i][j]))
    }
}

#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields, rename = "Lcp")]
struct Square {
    m: Vec<Vec<f64>>,
    q: Vec<f64>,
}

impl Serialize for Lcp {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        Square { m: Rows::of(&self.m).0, q: self.q.as_slice().to_vec() }.serialize(serializer)
    }
}

impl<'de> Deserialize<'de> for Lcp {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let Square { m, q } = Square::deserialize(deserializer)?;
        Self::from_rows(&m, &q).map_err(D::Error::custom)
    }
}

#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields, rename = "MixedLcp")]
struct Blocks {
    a: Rows,
    c: Rows,
    d: Rows,
    m: Rows,
    b: Vec<f64>,
    q: Vec<f64>,
}

impl Serialize for MixedLcp {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let (free, n, whole) = (self.free(), self.len(), self.whole());
        let block = |at, shape| Rows::of(&whole.m.view(at, shape).into_owned());
        Blocks {
            a: block((0, 0), (free, free)),
            c: block((0, free), (free, n)),
            d: block((free, 0), (n, free)),
            m: block((free, free), (n, n)),
            b: whole.q.as_slice()[..free].to_vec(),
            q: whole.q.as_slice()[free..].to_vec(),
        }
        .serialize(serializer)
    }
}

impl<'de> Deserialize<'de> for MixedLcp {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let Blocks { a, c, d, m, b, q } = Blocks::deserialize(deserializer)?;
        let (free, n) = (b.len(), q.len());
        let read = || -> Result<Self, String> {
            let [a, d] = [a.matrix("a", free)?, d.matrix("d", free)?];
            let [c, m] = [c.matrix("c", n)?, m.matrix("m", n)?];
            let [b, q] = [b, q].each(DVector::from_vec);
            Self::new(&a, &c, &d, &m, &b, &q).map_err(|error| error.to_string())
        };
        read().map_err(D::Error::custom)
    }
}

/// A basis is serialised as the list of the i with z_i basic.
impl Serialize for Basis {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_seq(self.iter())
    }
}

/// Serialises a vector as a list.
pub(crate) fn list<S: Serializer>(v: &DVector<f64>, serializer: S) -> Result<S::Ok, S::Error> {
    v.as_slice().serialize(serializer)
}
