//! Conditions on contact forces in energy coordinates, with their values if everything sticks. A condition is that a normal force is not negative, or
//! that a force is inside a facet of its friction cone.
//!
//! Let F be the contact forces, K the stiffness and G the grasp map. Energy coordinates are `x = K^{-1/2} F`. In them every condition `n·x >= 0` on
//! one contact's force has a normal n of unit length, so that ratios of stiffnesses cancel. With the orthogonal factor Q of `K^{1/2}Gᵀ = Q R`,
//! `Π = QQᵀ` is the projector on the motions of the object. Let x⁰ be the forces if everything sticks. The optimality conditions need only the values
//! `n·x⁰`, and the products `n·Π n'` and `n·(1 - Π) n'` of two normals n, n'.

use nalgebra::{DMatrix, DVector, SVector};

use crate::Settings;
use crate::contact::{LocalLaw, Spring};
use crate::grasp::Site;
use crate::lcp::{self, Lcp, Outcome};
use crate::numerics::tolerances::SOLVED_ROUNDING;
use crate::numerics::{IntoList, Map, Vector, unit};
use crate::object::{LinearProblem, Problem};
use crate::prelude::*;

/// A condition `normal·x_i >= 0` on the force of one contact i, in energy coordinates `x = K^{-1/2} F`.
#[derive(Debug, Clone)]
pub(super) struct ForceCondition {
    pub(super) contact: usize,
    /// Index, from 0, of the facet of the friction cone to which the condition belongs; `None` for the condition that the normal force is not
    /// negative.
    pub(super) facet: Option<usize>,
    /// The coefficients of this condition for the force F_i in N, `law·F_i >= 0`. The product is the friction margin `μ F_n - h·F_t` at a facet h, or
    /// the normal force F_n.
    law: SVector<f64, 3>,
    /// The condition's coefficients in energy coordinates, `K^{1/2} law` with the contact's stiffness K, divided by their norm.
    pub(super) normal: SVector<f64, 3>,
    /// The norm of `K^{1/2} law`, by which this vector is divided so that `normal` has unit length.
    pub(super) length: f64,
    /// Bound of the rounding error of [`Self::value`], as a multiple of the rounding error of the largest contact force.
    pub(super) weight: f64,
    /// Qᵀ times the normal, with the orthogonal factor Q of all springs: the coordinates of the normal's projection on motions of the object.
    pub(super) rows_of_factor: Vector,
}

impl ForceCondition {
    fn new(
        (contact, local): (usize, &LocalLaw<'_>),
        facet: Option<usize>,
        law: SVector<f64, 3>,
        rows_of_factor: &Map,
    ) -> Self {
        let normal = law.component_mul(&local.springs.root());
        let length = normal.norm();
        let normal = normal / length;
        let weight = local.cone().round_weight();
        Self { contact, facet, law, normal, length, weight, rows_of_factor: rows_of_factor * normal }
    }

    /// The left side of the condition for the contact forces `forces`, N: the friction margin `μ F_n - h·F_t` at the facet h, or the normal force
    /// F_n.
    pub(super) fn value(&self, forces: &[SVector<f64, 3>]) -> f64 {
        self.law.dot(&forces[self.contact])
    }

    /// Whether these contact forces satisfy the condition up to rounding. `largest` is the largest magnitude of these forces, N.
    pub(super) fn holds(&self, forces: &[SVector<f64, 3>], largest: f64) -> bool {
        self.value(forces) >= -SOLVED_ROUNDING * largest * self.weight
    }

    /// Whether the left side of the condition is zero or negative up to rounding for these contact forces. `largest` is the largest magnitude of
    /// them, N.
    pub(super) fn binds(&self, forces: &[SVector<f64, 3>], largest: f64) -> bool {
        self.value(forces) <= SOLVED_ROUNDING * largest * self.weight
    }

    /// The product `n·Π n'` of the normals of two conditions, with the projector Π on motions of the object: their coupling through these motions.
    pub(super) fn through_the_object(&self, other: &Self) -> f64 {
        self.rows_of_factor.dot(&other.rows_of_factor)
    }

    /// The product `n·(1 - Π) n'` of the normals of two conditions, with the projector Π on motions of the object: their coupling through forces that
    /// balance one another.
    pub(super) fn past_the_object(&self, other: &Self) -> f64 {
        let own = if self.contact == other.contact { self.normal.dot(&other.normal) } else { 0.0 };
        own - self.rows_of_factor.dot(&other.rows_of_factor)
    }
}

/// A linear problem with springs only along those axes of contact frames for which `holds(contact, axis)` is true; axis 0 is the normal.
pub(super) fn axis_springs(sites: &[Site], holds: &dyn Fn(usize, usize) -> bool) -> LinearProblem {
    LinearProblem::of_springs(sites, &|contact, list| {
        let springs = &sites[contact].springs;
        let held = (0..springs.axes()).filter(|axis| holds(contact, *axis));
        list.extend(held.map(|axis| Spring::along_axis(axis, springs.force_along(axis, 1.0))));
    })
}

/// The conditions of all contacts, contact by contact: `F_n >= 0` for contacts for which `presses` is true, and one condition for each facet of the
/// friction cone if `with_facets` is true.
pub(super) fn rows(
    problem: &Problem,
    stuck: &LinearProblem,
    presses: &dyn Fn(&LocalLaw<'_>) -> bool,
    with_facets: bool,
) -> Vec<ForceCondition> {
    let mut rows = Vec::new();
    for (i, local) in problem.locals().enumerate() {
        let rows_of_factor = stuck.factor_rows(i);
        let mut push = |facet, law| rows.push(ForceCondition::new((i, &local), facet, law, &rows_of_factor));
        if presses(&local) {
            push(None, unit(0));
        }
        for (j, h) in local.facets().iter().enumerate().filter(|_| with_facets) {
            push(Some(j), local.cone().facet_row(h));
        }
    }
    rows
}

/// The left side `n·x` of each condition, with its unit normal n and the contact forces in energy coordinates x.
pub(super) fn values<'r>(
    rows: impl IntoIterator<Item = &'r ForceCondition>,
    forces: &[SVector<f64, 3>],
) -> DVector<f64> {
    DVector::from_vec(rows.into_iter().map(|row| row.value(forces) / row.length).list())
}

/// The square matrix with `rows` rows and these entries; `None` for more than 10 000 rows.
pub(super) fn dense(rows: usize, entry: impl FnMut(usize, usize) -> f64) -> Option<DMatrix<f64>> {
    // A thousand contacts in space on eight facets have 9 000 rows; a matrix of 10 000 rows takes 0.8 gigabytes.
    (rows <= 10_000).then(|| DMatrix::from_fn(rows, rows, entry))
}

/// The limit of pivots of Lemke's method for a dense matrix with this many rows. It is the limit set by the caller, or else the default limit of the
/// solver, reduced for large matrices, for which a pivot takes long.
pub(super) fn most_pivots(rows: usize, settings: &Settings) -> Option<usize> {
    let entries = (rows * rows).max(1) as f64;
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // positive and far below 2^64
    // Without a limit set by the caller, the pivots may take about ten seconds in all.
    let affordable = (2e11 / entries) as usize;
    let default = lcp::Settings::default().pivot_limit(rows);
    settings.max_pivots.or_else(|| Some(affordable).filter(|most| *most < default))
}

/// The outcome of Lemke's method on the linear complementarity problem with this matrix and vector; `None` if a number is not finite.
pub(super) fn by_pivots(matrix: DMatrix<f64>, vector: DVector<f64>, settings: &Settings) -> Option<Outcome> {
    let max_pivots = most_pivots(vector.len(), settings);
    let settings = lcp::Settings { max_pivots, enumerate_up_to: 0, ..lcp::Settings::default() };
    Some(Lcp::new(matrix, vector).ok()?.solve_with(&settings))
}
