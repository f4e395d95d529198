//! The program of one step: the least of the linearised events is maximised within a box, less a quadratic term of the curvature.
//!
//! ```text
//! min  t + ½ dᵀB d     such that     t + τ_k + g_k·d >= top,     h_b·d + left_b >= 0,     low <= d <= high
//! ```
//!
//! `top` is a constant above every reachable value, so that t is positive. A minimum exists. The multipliers of the box and B d are the residual of
//! stationarity at d = 0.

use nalgebra::{DMatrix, DVector};

use crate::lcp::{Settings, quadratic_program};
use crate::numerics::tolerances::SOLVED_ROUNDING;
use crate::numerics::{IntoList, mapped, vector_of};
use crate::prelude::*;

/// A program in numbers near one: factors relative to the present value, variables in their units.
pub(super) struct StepProgram {
    pub(super) factors: Vec<f64>,
    pub(super) gradients: Vec<DVector<f64>>,
    /// Linear bounds `h·d + left >= 0`.
    pub(super) bounds: Vec<(DVector<f64>, f64)>,
    /// Limits of each variable, down and up.
    pub(super) reach: Vec<[f64; 2]>,
}

/// A step and its multipliers.
#[derive(Debug, Clone)]
pub(super) struct TrialStep {
    pub(super) d: DVector<f64>,
    /// Predicted gain of the first slip, relative to its present value.
    pub(super) gain: f64,
    /// Multipliers of the events; they add up to one.
    pub(super) events: Vec<f64>,
    pub(super) bounds: Vec<f64>,
    /// Multipliers of the limits of each variable, down and up.
    pub(super) ends: Vec<[f64; 2]>,
    /// Residual of `Σ λ ∇τ + Σ ν ∇b = 0` and of complementarity of events and bounds.
    pub(super) residual: f64,
}

/// The solution of the program.
struct Solved {
    d: DVector<f64>,
    /// Multipliers of all events.
    events: Vec<f64>,
    /// Multipliers of the bounds.
    bounds: Vec<f64>,
}

impl StepProgram {
    /// The step within a box of half width `radius`; `None` where rounding prevents it.
    pub(super) fn step(&self, radius: f64, curvature: &DMatrix<f64>) -> Option<TrialStep> {
        let n = self.reach.len();
        // The added term selects the shortest of several steps with equal gain.
        let curvature = curvature + DMatrix::identity(n, n) * 1e-4;
        let Solved { d, events, bounds } = self.solved(radius, &curvature)?;
        let least = self.after(&d).fold(f64::INFINITY, f64::min);
        let now = self.factors.iter().copied().fold(f64::INFINITY, f64::min);
        // At a limit of a variable the remaining gradient is its multiplier; elsewhere it is a residual.
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
        let complementarity =
            events.iter().zip(&self.factors).map(|(y, factor)| y * (factor - now)).sum::<f64>()
                + bounds.iter().zip(&self.bounds).map(|(y, (_, left))| y * left.max(0.0)).sum::<f64>();
        let residual = left.amax().max(complementarity);
        let gain = least - now - 0.5 * (&curvature * &d).dot(&d);
        Some(TrialStep { d, gain, events, bounds, ends, residual })
    }

    /// Linearised values of all events after a step.
    fn after<'s>(&'s self, d: &'s DVector<f64>) -> impl Iterator<Item = f64> + 's {
        self.factors.iter().zip(&self.gradients).map(|(factor, g)| factor + g.dot(d))
    }

    /// Solves the program with unknowns that are counted from the lower ends of the box.
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
        let mut top = f64::INFINITY;
        for (factor, [_, most]) in self.factors.iter().zip(&ranges) {
            top = top.min(factor + most);
        }
        if !top.is_finite() {
            return None;
        }
        // Events that stay above `top` in the whole box cannot be the least.
        let mut near: Vec<usize> = (0..ranges.len()).list();
        near.retain(|k| self.factors[*k] + ranges[*k][0] < top);
        if near.is_empty() {
            near.push(0);
        }
        // `top` lies above every reachable value. It keeps t positive, so that the multipliers of events add
        // up to one.
        let top = top + 0.5;
        // The unknowns are d - low and t; the rows are events, bounds, and the upper ends of the box.
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
