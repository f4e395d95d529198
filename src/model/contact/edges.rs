//! The edges of a contact's cone, as conditions on its force while it sticks.

use nalgebra::SVector;

use super::law::LocalLaw;
use super::tangential::tangential;
use crate::prelude::*;

/// Conditions on the force of a sticking contact.
#[derive(Debug, Clone)]
pub(crate) enum Edges {
    /// `a·F >= 0` for each row: facets, or the normal force alone.
    Rows(Vec<SVector<f64, 3>>),
    /// `limit F_n >= |F_t|`.
    Round {
        /// The coefficient of friction.
        limit: f64,
    },
}

impl Edges {
    /// The row with the least value for a force, and that value; `None` without conditions.
    pub(crate) fn worst(&self, force: &SVector<f64, 3>) -> Option<(SVector<f64, 3>, f64)> {
        match self {
            Self::Rows(rows) => {
                let values = rows.iter().map(|row| (*row, row.dot(force)));
                values.min_by(|(_, a), (_, b)| a.total_cmp(b))
            }
            Self::Round { limit } => {
                let friction = tangential(force);
                let size = friction.norm();
                let mut row = friction / -size.max(f64::MIN_POSITIVE);
                row[0] = *limit;
                Some((row, limit * force[0] - size))
            }
        }
    }
}

impl LocalLaw<'_> {
    /// The conditions of sticking.
    pub(crate) fn edges(&self) -> Edges {
        if self.has_a_round_edge() {
            return Edges::Round { limit: self.cone().limit(1.0) };
        }
        if self.is_bonded() {
            return Edges::Rows(Vec::new());
        }
        let facets = self.facets();
        if facets.is_empty() && self.may_open() {
            let mut normal = SVector::zeros();
            normal[0] = 1.0;
            return Edges::Rows(vec![normal]);
        }
        Edges::Rows(facets.iter().map(|h| self.cone().facet_row(h)).collect())
    }
}
