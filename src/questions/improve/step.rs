//! The quadratic program of one step of the search for better finger placement. Its variables are the places (positions of contacts on their curves
//! or surfaces) and the commanded normal forces of contacts. The value of a sticking condition under a load, an event in the code, is the load factor
//! that breaks it, or its margin under the load. At first slip the first sticking condition breaks; the base load acts before the other loads grow.
//! Within a box around the present values of the variables, the program maximises the least of the linearised values of sticking conditions, less a
//! curvature term. Let d be the step, bounded by `low` and `high`, B the Hessian, τ_k the value of sticking condition k with gradient g_k, and
//! `h_b·d + left_b >= 0` constraint b:
//!
//! ```text
//! min  t + ½ dᵀB d     such that     t + τ_k + g_k·d >= top,     h_b·d + left_b >= 0,     low <= d <= high
//! ```
//!
//! `top` is a constant above every value that the least of the τ_k can have in the box, so that t is positive and a minimum exists. Let each gradient
//! of a sticking condition or a constraint be weighted by its multiplier. By the optimality conditions the sum of the weighted gradients is B d plus
//! the multipliers of the box (of upper ends minus lower ends). At an optimum of the search the step d is zero. The sum then vanishes in all
//! variables that are not at an end of their range.

use nalgebra::{DMatrix, DVector};

use crate::lcp::{Settings, quadratic_program};
use crate::numerics::tolerances::SOLVED_ROUNDING;
use crate::numerics::{Reals, chosen, mapped, vector_of};
use crate::prelude::*;

/// The data of the quadratic program of one step. `factors` are the values of the sticking conditions under loads, scaled so that the least of them
/// is 1 at the present values of the variables. For first slip they are divided by the load factor of first slip. For a reserve (the least margin
/// under the loads) a factor is 1 plus a quotient. The quotient is the margin of the condition minus the least of all margins, divided by the
/// greatest contact force under the base load. Each variable is divided by its unit: the size of the grasp, a length, for a place, the greatest
/// allowed force for a commanded normal force.
pub(super) struct StepProgram {
    pub(super) factors: Vec<f64>,
    pub(super) gradients: Vec<DVector<f64>>,
    /// Linear constraints `h·d + left >= 0` on the step d: limits of contact forces, and edges of segments, triangles or surfaces, each as the pair
    /// (h, left).
    pub(super) bounds: Vec<(DVector<f64>, f64)>,
    /// The least (at most 0) and greatest (at least 0) step of each variable.
    pub(super) reach: Vec<[f64; 2]>,
}

/// A step d that solves the quadratic program, the gain that it predicts, and its multipliers.
#[derive(Debug, Clone)]
pub(super) struct TrialStep {
    pub(super) d: DVector<f64>,
    /// The predicted increase of the least value of the sticking conditions: by the linearised values, less the curvature term.
    pub(super) gain: f64,
    /// Multipliers of the sticking conditions under loads, at least 0; they add up to one.
    pub(super) events: Vec<f64>,
    pub(super) bounds: Vec<f64>,
    /// For each variable the multipliers of the lower and upper end of its range. A multiplier is zero unless the variable is at that end before the
    /// step.
    pub(super) ends: Vec<[f64; 2]>,
    /// How far the present values of the variables are from first-order optimality: the larger of two residuals. The first is the largest entry of
    /// `Σ λ ∇τ + Σ ν h`, over variables that are not at an end of their range. Here λ are the multipliers of the values τ of sticking conditions, and
    /// ν those of the constraints `h·d + left >= 0`. The second is the residual of complementarity: the sum of all multipliers, each times the
    /// distance of its sticking condition or constraint from being active.
    pub(super) residual: f64,
}

/// The solution of the quadratic program: the step d and multipliers, scaled so that the multipliers of the sticking conditions add up to one.
struct Solved {
    d: DVector<f64>,
    /// Multipliers of all sticking conditions under loads; zero for those that the program omits.
    events: Vec<f64>,
    /// Multipliers of the linear constraints `h·d + left >= 0`.
    bounds: Vec<f64>,
}

impl StepProgram {
    /// The solution of the quadratic program in which each variable moves by at most `radius` and stays within its range. `None` if no sticking
    /// condition has a finite value, or if rounding prevents a solution.
    pub(super) fn step(&self, radius: f64, curvature: &DMatrix<f64>) -> Option<TrialStep> {
        let n = self.reach.len();
        // Among several steps with equal gain, this small multiple of the identity, added to the Hessian, makes the shortest step the best.
        let curvature = curvature + DMatrix::identity(n, n) * 1e-4;
        let Solved { d, events, bounds } = self.solved(radius, &curvature)?;
        let least = self.after(&d).least();
        let now = self.factors.iter().copied().least();
        // The sum of the weighted gradients of sticking conditions and constraints. For a variable at an end of `reach` it is the multiplier of this
        // end, for other variables a residual.
        let mut left = DVector::zeros(n);
        events.iter().zip(&self.gradients).for_each(|(y, g)| left += g * *y);
        bounds.iter().zip(&self.bounds).for_each(|(y, (h, _))| left += h * *y);
        let mut ends = vec![[0.0; 2]; n];
        for j in 0..n {
            let [down, up] = self.reach[j];
            if left[j] > 0.0 && up <= SOLVED_ROUNDING {
                (ends[j][1], left[j]) = (left[j], 0.0);
            } else if left[j] < 0.0 && down >= -SOLVED_ROUNDING {
                (ends[j][0], left[j]) = (-left[j], 0.0);
            }
        }
        let complementarity = events.iter().zip(&self.factors).map(|(y, factor)| y * (factor - now)).added()
            + bounds.iter().zip(&self.bounds).map(|(y, (_, left))| y * left.max(0.0)).added();
        let residual = left.amax().max(complementarity);
        let gain = least - now - 0.5 * (&curvature * &d).dot(&d);
        Some(TrialStep { d, gain, events, bounds, ends, residual })
    }

    /// The values of all sticking conditions under loads after the step d, to first order.
    fn after<'s>(&'s self, d: &'s DVector<f64>) -> impl Iterator<Item = f64> + 's {
        self.factors.iter().zip(&self.gradients).map(|(factor, g)| factor + g.dot(d))
    }

    /// Solves the quadratic program. Its unknowns are the distances of the variables from the lower ends of the box, and t: the constant `top` less
    /// the least value of a sticking condition. `None` if no sticking condition has a finite value, or if rounding prevents a solution.
    fn solved(&self, radius: f64, curvature: &DMatrix<f64>) -> Option<Solved> {
        let n = self.reach.len();
        let low = vector_of(n, &|j| (-radius).max(self.reach[j][0].min(0.0)));
        let high = vector_of(n, &|j| radius.min(self.reach[j][1].max(0.0)));
        let ends = |g: &DVector<f64>| {
            (0..n).fold([0.0; 2], |[least, most], j| {
                let [a, b] = [g[j] * low[j], g[j] * high[j]];
                [least + a.min(b), most + a.max(b)]
            })
        };
        let ranges = mapped(&self.gradients, &ends);
        let top = self.factors.iter().zip(&ranges).map(|(factor, [_, most])| factor + most).least();
        if !top.is_finite() {
            return None;
        }
        // The least value of a sticking condition is at most `top` everywhere in the box. A sticking condition whose value stays above `top` in the
        // whole box is therefore never the least, and the program omits it.
        let mut near = chosen(ranges.len(), &|k| self.factors[*k] + ranges[*k][0] < top);
        if near.is_empty() {
            near.push(0);
        }
        // Now `top` is above every value that the least of the sticking conditions can have in the box. Thus t stays positive, and the multipliers of
        // sticking conditions add up to one.
        let top = top + 0.5;
        // The unknowns are the distances d - low of the step from the lower ends of the box, and t: the constant `top` less the least value of a
        // sticking condition. The rows of the matrix are sticking conditions, linear constraints, and the upper ends of the box.
        let (m, b) = (near.len(), self.bounds.len());
        let mut rows = DMatrix::zeros(m + b + n, n + 1);
        let mut left = DVector::zeros(m + b + n);
        for (row, k) in near.iter().enumerate() {
            let g = &self.gradients[*k];
            rows.view_mut((row, 0), (1, n)).copy_from(&g.transpose());
            (rows[(row, n)], left[row]) = (1.0, self.factors[*k] + g.dot(&low) - top);
        }
        for (row, (h, most)) in (m..).zip(&self.bounds) {
            rows.view_mut((row, 0), (1, n)).copy_from(&h.transpose());
            left[row] = most.max(0.0) + h.dot(&low);
        }
        for j in 0..n {
            (rows[(m + b + j, j)], left[m + b + j]) = (-1.0, high[j] - low[j]);
        }
        let bends = curvature.clone().resize(n + 1, n + 1, 0.0);
        let cost = (curvature * &low).insert_row(n, 1.0);
        let solve = |settings: Settings| quadratic_program(Some(&bends), &cost, &rows, &left, &settings);
        let [z, y] = solve(Settings::one_path()).or_else(|| solve(Settings::default()))?;
        let d = vector_of(n, &|j| (z[j] + low[j]).clamp(low[j], high[j]));
        let share: f64 = y.rows(0, m).sum();
        let share = if share > 0.0 { share } else { 1.0 };
        let mut events = vec![0.0; self.factors.len()];
        near.iter().enumerate().for_each(|(row, k)| events[*k] = y[row] / share);
        let bounds = mapped(&y.as_slice()[m..][..b], &|y| y / share);
        Some(Solved { d, events, bounds })
    }
}
