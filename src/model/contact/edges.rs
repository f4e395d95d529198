//! The boundary of a contact's friction cone as linear conditions `a·F >= 0` on the contact force F. While they hold, the contact keeps sticking. The
//! file also selects the conditions that a set of possible forces violates most. In code names an edge is such a condition.
//!
//! The round cone has a tangent facet `a(φ) = (μ, -cos φ, -sin φ)` at every angle φ. At a given force F the margin `a·F` is therefore a trigonometric
//! function of φ.

use core::f64::consts::{FRAC_PI_2, TAU};

use nalgebra::{SMatrix, SVector};

use super::law::LocalLaw;
use super::state::State;
use super::tangential::tangential;
use super::tolerances::ZERO_SLACK;
use crate::numerics::{Harmonic, IntoList, Turning, lowest, mapped, moved, numbered, picked, unit};
use crate::prelude::*;

/// Conditions on the force of a contact that keeps sticking. For a contact that stays open, they apply to a vector whose first component is the gap.
#[derive(Debug, Clone)]
pub(crate) enum Edges {
    /// `a·F >= 0` for each row a of coefficients: a facet, or the normal force or the gap alone.
    Rows(Vec<SVector<f64, 3>>),
    /// The round friction cone, `μ F_n >= |F_t|`.
    Round {
        /// The coefficient of friction μ.
        limit: f64,
    },
}

/// The coefficients `(limit, -cos φ, -sin φ)` of the facets of a round cone with friction coefficient `limit`, as functions of the angle φ.
pub(crate) fn round_rows(limit: f64) -> Harmonic<SVector<f64, 3>> {
    Harmonic { constant: unit(0) * limit, cosine: -unit(1), sine: -unit(2) }
}

/// Whether a condition `value >= 0` with the coefficients `row` is violated by more than rounding. The rounding error of the force is proportional to
/// its rounding scale `size`, N.
pub(crate) fn is_broken(value: f64, row: &SVector<f64, 3>, size: f64) -> bool {
    value < -ZERO_SLACK * row.norm() * size
}

/// Whether a condition with the coefficients `row` involves friction, and not only the normal force or the gap.
pub(crate) fn involves_friction(row: &SVector<f64, 3>) -> bool {
    row[1] != 0.0 || row[2] != 0.0
}

impl Edges {
    /// The coefficients of the condition `a·F >= 0` with the least value at a force F, and this value; `None` without conditions.
    pub(crate) fn worst(&self, force: &SVector<f64, 3>) -> Option<(SVector<f64, 3>, f64)> {
        match self {
            Self::Rows(rows) => lowest(rows, &|row| row.dot(force)).map(|row| (*row, row.dot(force))),
            Self::Round { limit } => {
                let friction = tangential(force);
                let size = friction.norm();
                let mut row = friction / -size.max(f64::MIN_POSITIVE);
                row[0] = *limit;
                Some((row, limit * force[0] - size))
            }
        }
    }

    /// Whether a force satisfies all conditions up to rounding. The rounding error of the force is proportional to its rounding scale `size`, N.
    pub(crate) fn hold(&self, force: &SVector<f64, 3>, size: f64) -> bool {
        self.worst(force).is_none_or(|(row, value)| !is_broken(value, &row, size))
    }

    /// The coefficients of all conditions; for a round cone, the coefficients of its facets at the angles that the function `angles` returns.
    pub(crate) fn rows(
        &self,
        angles: &dyn Fn(&Harmonic<SVector<f64, 3>>) -> Vec<f64>,
    ) -> Vec<SVector<f64, 3>> {
        match self {
            Self::Rows(rows) => rows.clone(),
            Self::Round { limit } => {
                let around = round_rows(*limit);
                moved(angles(&around), &|angle| around.at(angle))
            }
        }
    }

    /// The coefficients of all conditions. For a round cone, only the coefficients of the facets at which `value`, a function of the coefficients,
    /// has a local minimum over the angle. If `value` has no minimum, the facets at four angles are used.
    pub(crate) fn least(&self, value: &dyn Fn(&SVector<f64, 3>) -> f64) -> Vec<SVector<f64, 3>> {
        self.rows(&|around| {
            let angles = local_minima(&|angle| value(&around.at(angle)));
            if angles.is_empty() { (0..4).map(|k| FRAC_PI_2 * f64::from(k)).list() } else { angles }
        })
    }

    /// The conditions that some contact force `F + A x` with `|x| = size` may violate, as their coefficients a. F is `force`, and A is `influence`.
    /// The least value of a condition over all these x is `a·F - size |Aᵀa|`. For a round cone, one facet at which this value has a negative local
    /// minimum is returned, or none. For [`Self::Rows`] all conditions are returned.
    pub(crate) fn on_a_sphere(
        &self,
        force: &SVector<f64, 3>,
        influence: &SMatrix<f64, 3, 3>,
        size: f64,
    ) -> Vec<SVector<f64, 3>> {
        self.rows(&|around| {
            let vector = around.map(|row| influence.tr_mul(row) * size);
            Turning { number: around.map(|row| row.dot(force)), vector }.deepest(TAU).into_iter().list()
        })
    }

    /// For each condition that the force violates while the load turns, an angle of the load at which the violation has a local maximum. The load
    /// keeps its magnitude, so the contact force `force` is a harmonic function of the angle. Angles are from 0 to `most`, rad.
    pub(crate) fn on_a_turn(&self, force: &Harmonic<SVector<f64, 3>>, most: f64) -> Vec<f64> {
        let nothing = Harmonic::new([SVector::zeros(); 3]);
        let margins = match self {
            Self::Rows(rows) => mapped(rows, &|row| (force.map(|x| row.dot(x)), nothing)),
            Self::Round { limit } => vec![(force.map(|x| limit * x[0]), force.map(tangential))],
        };
        picked(&margins, &|&(number, vector)| Turning { number, vector }.deepest(most))
    }
}

/// The angles of all local minima of a periodic function of an angle.
fn local_minima(of: &dyn Fn(f64) -> f64) -> Vec<f64> {
    // The function is sampled every 10 degrees. The samples could miss a local minimum that is narrower than this spacing.
    let count = 36;
    let step = TAU / count as f64;
    let values: Vec<f64> = numbered(count, &|k| of(step * k as f64));
    let lowest =
        |k: &usize| values[*k] <= values[(k + count - 1) % count] && values[*k] < values[(k + 1) % count];
    let refine = |k: usize| {
        // A golden-section search narrows the interval between the two neighbours, which enclose the minimum.
        let golden = 0.5 * (5.0_f64.sqrt() - 1.0);
        let (mut from, mut to) = (step * (k as f64 - 1.0), step * (k as f64 + 1.0));
        for _ in 0..60 {
            let (a, b) = (to - golden * (to - from), from + golden * (to - from));
            if of(a) < of(b) { to = b } else { from = a }
        }
        0.5 * (from + to)
    };
    (0..count).filter(lowest).map(refine).list()
}

impl LocalLaw<'_> {
    /// The conditions under which a contact keeps sticking; for an open contact, the condition that its gap (the first component) stays nonnegative.
    /// A bonded contact, which neither opens nor slips, has no conditions, and neither has an absent one.
    pub(crate) fn edges(&self, state: &State) -> Edges {
        if self.is_absent() || self.is_bonded() {
            return Edges::Rows(Vec::new());
        }
        if self.has_a_round_edge() && !state.is_open() {
            return Edges::Round { limit: self.cone().limit(1.0) };
        }
        let facets = self.facets();
        if state.is_open() || facets.is_empty() && self.may_open() {
            return Edges::Rows(vec![unit(0)]);
        }
        Edges::Rows(facets.iter().map(|h| self.cone().facet_row(h)).list())
    }
}
