//! How far a rolling contact can go along a straight line of forces before it leaves its cone.

use nalgebra::SVector;

use crate::formulation::Problem;

/// Slacks below this part of their size are zero: rounding of forces that come out of one linear solve.
pub(crate) const ROUNDING: f64 = 5e-14;

/// One way out of the cone: the step at which it is reached, and the step's own uncertainty from rounding.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Exit<const C: usize> {
    pub(crate) step: f64,
    pub(crate) uncertainty: f64,
    /// Outward normal of the facet, in the scale `h·F_t <= μ F_n`; zero where the normal force itself vanishes.
    pub(crate) facet: SVector<f64, C>,
}

/// Force, its rate, and the sizes that their rounding is measured against.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Line<const C: usize> {
    pub(crate) force: SVector<f64, C>,
    pub(crate) rate: SVector<f64, C>,
    pub(crate) force_size: f64,
    pub(crate) rate_size: f64,
}

impl<const C: usize> Line<C> {
    fn linear(&self, value: f64, rate: f64, weight: f64, facet: SVector<f64, C>) -> Option<Exit<C>> {
        if rate >= -ROUNDING * self.rate_size * weight {
            return None;
        }
        let step = (value / -rate).max(0.0);
        let uncertainty = ROUNDING * weight * (self.force_size + step * self.rate_size) / -rate;
        Some(Exit { step, uncertainty, facet })
    }
}

/// Every facet of the polygon that the line runs into; the vanishing normal force where there are no facets.
pub(crate) fn polygon_exits<const D: usize, const C: usize>(
    problem: &Problem<D, C>,
    contact: usize,
    line: &Line<C>,
) -> Vec<Exit<C>> {
    let mu = problem.mu(contact);
    let normals = problem.normals(contact);
    if normals.is_empty() {
        let vanishing = line.linear(line.force[0], line.rate[0], 1.0, SVector::zeros());
        return vanishing.filter(|_| problem.may_open(contact)).into_iter().collect();
    }
    normals
        .iter()
        .filter_map(|h| {
            let slack = |f: &SVector<f64, C>| mu * f[0] - h.dot(f);
            line.linear(slack(&line.force), slack(&line.rate), mu + h.norm(), *h)
        })
        .collect()
}

/// Where the line leaves the round cone, `μ² F_n² = |F_t|²`: the first root of a quadratic,
///
/// ```text
/// c₀ + 2 c₁ s + c₂ s² = 0,   c₀ = (μF_n - |F_t|)(μF_n + |F_t|),   c₁ = μ²F_n F_n' - F_t·F_t',   c₂ = μ²F_n'² - |F_t'|²
/// ```
///
/// taken as `s = c₀ / (√(c₁² - c₀c₂) - c₁)`, which does not cancel. From the edge itself (c₀ = 0) a line that goes
/// inwards can only come back at `s = -2c₁/c₂`.
pub(crate) fn round_exit<const D: usize, const C: usize>(
    problem: &Problem<D, C>,
    contact: usize,
    line: &Line<C>,
) -> Option<Exit<C>> {
    let mu = problem.mu(contact);
    if mu == 0.0 || mu.is_infinite() || problem.normals(contact).is_empty() {
        return polygon_exits(problem, contact, line).into_iter().next();
    }
    let flat = |f: &SVector<f64, C>| {
        let mut t = *f;
        t[0] = 0.0;
        t
    };
    let (t0, t1) = (flat(&line.force), flat(&line.rate));
    let (n0, n1) = (mu * line.force[0], mu * line.rate[0]);
    let friction = t0.norm();
    let weight = mu + 1.0;
    let on_edge = n0 - friction <= ROUNDING * line.force_size * weight;
    let leaves = |at: &SVector<f64, C>| at / at.norm().max(f64::MIN_POSITIVE);
    if on_edge {
        // At the apex the rates themselves must lie in the cone.
        let outward = if friction > ROUNDING * line.force_size * weight { leaves(&t0) } else { leaves(&t1) };
        if let Some(exit) = line.linear(n0 - friction, n1 - outward.dot(&t1), weight, outward) {
            return Some(exit);
        }
    }
    let c0 = if on_edge { 0.0 } else { (n0 - friction) * (n0 + friction) };
    let c1 = n0 * n1 - t0.dot(&t1);
    let c2 = n1 * n1 - t1.norm_squared();
    let discriminant = c1 * c1 - c0 * c2;
    // Without a root the step is not a number.
    let mut step = if on_edge { -2.0 * c1 / c2 } else { c0 / (discriminant.sqrt() - c1) };
    // Close to a double root the discriminant cancels. The margin itself, μF_n - |F_t|, is concave and does not: Newton's
    // method on it gives back the digits.
    for _ in 0..3 {
        let at = t0 + t1 * step;
        let slope = n1 - leaves(&at).dot(&t1);
        let better = step - (n0 + n1 * step - at.norm()) / slope;
        if slope < 0.0 && better > 0.0 && better.is_finite() {
            step = better;
        }
    }
    // A line through the apex has a double root there, which costs half the digits, and beyond it runs on in the other half
    // of the cone, F_n < 0: the linear root of F_n is the exit then.
    if let Some(apex) = line.linear(line.force[0], line.rate[0], 1.0, SVector::zeros()) {
        let missed = (t0 + t1 * apex.step).norm();
        let through = missed <= ROUNDING * (line.force_size + apex.step * line.rate_size);
        if through || step.is_nan() || step <= 0.0 || step > apex.step {
            return Some(apex);
        }
    }
    if !(step > 0.0 && step.is_finite()) {
        return None;
    }
    let facet = leaves(&(t0 + t1 * step));
    let closing = facet.dot(&t1) - n1;
    if closing <= ROUNDING * line.rate_size * weight {
        // The line touches the cone and stays inside, or its rates are rounding of zero.
        return None;
    }
    let uncertainty = ROUNDING * weight * (line.force_size + step * line.rate_size) / closing;
    Some(Exit { step, uncertainty, facet })
}
