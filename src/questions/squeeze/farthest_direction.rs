//! The direction in which the least force through a point makes a motion exceed its limit of small motions (up to which the linear theory is
//! trusted), while everything sticks.
//!
//! Let x be the force, and s the vector of a rotation, slip or opening whose magnitude must not exceed its limit L. While everything sticks s is
//! affine in x: `s = a + B x`, where a is its value under the base load. The shortest x with `|s| = L` satisfies `x = λ Bᵀs` with a multiplier λ. In
//! the singular value decomposition `B = U diag(σ) Vᵀ`, with `c = Uᵀa`, therefore `s_i = c_i / (1 - λ σ_i²)`. |s| grows with λ, up to infinity at
//! 1/σ₁² (σ₁ is the largest σ). A bisection therefore finds the λ with |s| = L.

use nalgebra::{DMatrix, DVector, SMatrix, SVector};

use super::loads::check_point;
use crate::equilibrium::{CountedMotion, MotionData, StickingResponse, push};
use crate::error::Error;
use crate::grasp::{Engine, Wrench};
use crate::numerics::{Reals, Singular};
use crate::object::ForcesAndTwist;
#[cfg(not(feature = "std"))]
use crate::prelude::*;
use crate::search::Settings;

impl Engine {
    /// The magnitude (N) and unit direction of the least force through `point` (m) with which a motion exceeds its limit of small motions. The force
    /// acts in addition to a base load under which everything sticks. As long as everything sticks, no smaller force has this effect in any
    /// direction. `None` if no force has this effect.
    pub(crate) fn farthest_direction(
        &self,
        base: &Wrench<3>,
        point: [f64; 3],
        settings: &Settings,
    ) -> Result<Option<(f64, [f64; 3])>, Error> {
        check_point(&point)?;
        let load = self.load_alone(base, "base load")?;
        let sticking = StickingResponse::new(self, settings);
        let (offsets, at_rest) = (self.offsets(), sticking.at_rest());
        let motions = |offsets: &[SVector<f64, 3>], state: &ForcesAndTwist| {
            let (forces, twist) = (&state.forces, &state.twist);
            let standing = MotionData { offsets, slips: &at_rest, states: &sticking.states, forces, twist };
            self.counted_motions(&settings.small_motions, &standing)
        };
        let Some(under_base) = sticking.state(&offsets, &load) else { return Ok(None) };
        let mut by_axis = Vec::with_capacity(3);
        for axis in 0..3 {
            let unit = core::array::from_fn(|k| if k == axis { 1.0 } else { 0.0 });
            let load = self.inside_unchecked(&push(&point, &unit));
            let Some(state) = sticking.state(&at_rest, &load) else { return Ok(None) };
            by_axis.push(motions(&at_rest, &state));
        }
        let mut least: Option<(f64, SVector<f64, 3>)> = None;
        for (k, motion) in motions(&offsets, &under_base).iter().enumerate() {
            let by_force = SMatrix::from_columns(&[0, 1, 2].map(|axis| by_axis[axis][k].shift));
            let force = shortest_to_the_limit(motion, &by_force);
            if force.is_some_and(|(size, _)| least.is_none_or(|(least, _)| size < least)) {
                least = force;
            }
        }
        Ok(least.map(|(size, direction)| (size, direction.into())))
    }
}

/// The magnitude and direction of the shortest force x (N) with which a motion reaches its limit, if x adds the vector `by_force x` to this motion;
/// `None` if no x brings it to the limit.
fn shortest_to_the_limit(
    motion: &CountedMotion,
    by_force: &SMatrix<f64, 3, 3>,
) -> Option<(f64, SVector<f64, 3>)> {
    let (limit, start) = (motion.limit, motion.shift);
    let force = if motion.is_opening() {
        let gradient = by_force.row(0).transpose();
        gradient * ((limit - start[0]) / gradient.norm_squared())
    } else {
        shortest_to_length(limit, &start, by_force)?
    };
    let size = force.norm();
    (size > 0.0 && size.is_finite()).then(|| (size, force / size))
}

/// The shortest x with `|a + B x| = length`, where |a| is less than `length`; `None` if B is zero.
fn shortest_to_length(length: f64, a: &SVector<f64, 3>, b: &SMatrix<f64, 3, 3>) -> Option<SVector<f64, 3>> {
    let singular = Singular::new(&DMatrix::from_column_slice(3, 3, b.as_slice()));
    let values = &singular.values;
    let along = singular.along(&DVector::from_column_slice(a.as_slice()));
    let beside = a.norm_squared() - along.iter().map(|c| c * c).added();
    // `part` is 1 - λ σ₁², from 1 for no force to 0 for λ = 1/σ₁².
    let divisor = |i: usize, part: f64| 1.0 - (1.0 - part) * (values[i] / values[0]).powi(2);
    let others = |part: f64| {
        let square = |i: usize| (along[i] / divisor(i, part)).powi(2);
        beside.max(0.0) + square(1) + square(2)
    };
    let along_first = |part: f64| (length * length - others(part)).max(0.0).sqrt();
    let (mut low, mut high) = (0.0, 1.0);
    // For a trial λ, `along_first` is the first component with which s has the length L, given the other components. The actual first component is c₁
    // / `part`. While its magnitude is smaller, |s| is less than L. Sixty halvings reduce the error to rounding.
    for _ in 0..60 {
        let part = 0.5 * (low + high);
        let is_within = along_first(part) * part > along[0].abs();
        *(if is_within { &mut high } else { &mut low }) = part;
    }
    let first = along_first(high).copysign(along[0]) - along[0];
    let component = |i: usize| (1.0 - high) * values[i] * along[i] / (divisor(i, high) * values[0].powi(2));
    let x = DVector::from_column_slice(&[first / values[0], component(1), component(2)]);
    let x = &singular.right * x;
    (values[0] > 0.0).then(|| SVector::from([x[0], x[1], x[2]]))
}

#[cfg(test)]
mod tests {
    use nalgebra::{SMatrix, Vector3};

    use super::shortest_to_length;
    use crate::numerics::generic;

    /// With the computed shortest force x, the motion `a + B x` has the required length. None of 4 000 other forces of the same magnitude, in all
    /// directions, gives a longer motion.
    #[test]
    fn no_other_direction_goes_farther() {
        let mut drawn = 0;
        let mut number = || {
            drawn += 1;
            2.0 * generic(drawn) - 2.0
        };
        for round in 0..300 {
            // Some maps B are singular. Some motions a under the base load are zero, or perpendicular to the largest motion that a unit force causes.
            let mut b = SMatrix::<f64, 3, 3>::from_fn(|_, _| number());
            let mut a = Vector3::from_fn(|_, _| 0.5 * number());
            match round % 4 {
                1 => b.row_mut(2).fill(0.0),
                2 => a = Vector3::zeros(),
                3 => (b, a[0]) = (SMatrix::from_diagonal(&Vector3::new(2.0, 1.0, 0.5)), 0.0),
                _ => {}
            }
            let x = shortest_to_length(2.0, &a, &b).expect("it moves");
            assert!(((a + b * x).norm() - 2.0).abs() < 1e-12, "{a} {b} {x}");
            for k in 0..4000 {
                let (z, turn) = (f64::from(k) / 1999.5 - 1.0, 2.4 * f64::from(k));
                let across = (1.0 - z * z).max(0.0).sqrt();
                let other = Vector3::new(across * turn.cos(), across * turn.sin(), z) * x.norm();
                assert!((a + b * other).norm() <= 2.0 + 1e-12, "{a} {b} {x} {other}");
            }
        }
        assert!(shortest_to_length(2.0, &Vector3::zeros(), &SMatrix::zeros()).is_none());
    }
}
