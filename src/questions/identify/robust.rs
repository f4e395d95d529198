//! Huber's loss: quadratic in small residuals and linear in large ones, so that a few wrong observations have little influence.

use crate::numerics::tolerances::SOLVED_ROUNDING;
use crate::numerics::{Reals, normal_density, normal_tail, summed};
#[cfg(not(feature = "std"))]
use crate::prelude::*;

/// Huber's loss. The number is the magnitude of the residual, in standard deviations, beyond which the loss is linear; infinity gives least squares.
#[derive(Debug, Clone, Copy)]
pub(super) struct Huber(pub(super) f64);

impl Huber {
    /// The loss of one residual `u`, in standard deviations.
    pub(super) fn loss(self, u: f64) -> f64 {
        let size = u.abs();
        if size <= self.0 { 0.5 * u * u } else { self.0 * (size - 0.5 * self.0) }
    }

    /// The weight of a residual `u` in iteratively reweighted least squares: 1 if the loss is quadratic at `u`, less if it is linear.
    pub(super) fn weight(self, u: f64) -> f64 {
        let size = u.abs();
        if size <= self.0 { 1.0 } else { self.0 / size }
    }

    /// The mean square of normally distributed residuals that are clamped where the loss becomes linear; 1 for least squares.
    pub(super) fn mean_square(self) -> f64 {
        if self.0.is_infinite() {
            return 1.0;
        }
        let tail = normal_tail(self.0);
        1.0 - 2.0 * tail - 2.0 * self.0 * normal_density(self.0) + 2.0 * self.0 * self.0 * tail
    }

    /// The sum of the squares of Huber's psi of the residuals. The residuals are in standard deviations; psi clamps them where the loss becomes
    /// linear.
    pub(super) fn squares(self, residuals: impl Iterator<Item = f64>) -> f64 {
        residuals.map(|u| self.pull(u).powi(2)).added()
    }

    /// A robust standard deviation of residuals with this number of degrees of freedom (Huber's second proposal). It is defined so that the
    /// residuals, divided by this deviation and clamped, have the mean square of clamped normally distributed numbers. If the loss is quadratic for
    /// all residuals, this deviation is that of least squares.
    pub(super) fn scale(self, residuals: &[f64], degrees: usize) -> f64 {
        let all = summed(residuals, &|r| r * r);
        let expected = degrees.max(1) as f64 * self.mean_square();
        let mut scale = (all / degrees.max(1) as f64).sqrt().max(SOLVED_ROUNDING);
        // Sixty rounds of this fixed-point iteration give the standard deviation more digits than it needs.
        for _ in 0..60 {
            let squares = self.squares(residuals.iter().map(|r| r / scale));
            scale = (scale * (squares / expected).sqrt()).max(SOLVED_ROUNDING);
        }
        scale
    }

    /// Huber's psi, the derivative of the loss with respect to the residual: the residual clamped where the loss becomes linear.
    pub(super) fn pull(self, u: f64) -> f64 {
        u.clamp(-self.0, self.0)
    }

    /// The mean derivative of Huber's psi with respect to the residuals, corrected for the number of parameters. It is the fraction of residuals that
    /// are not clamped, taken as at least a half. `all` is the number of residuals, `inside` the number of those not clamped, `unknowns` that of
    /// parameters. Source: Huber and Ronchetti, Robust Statistics, 2009, 7.6.
    pub(super) fn slope(all: usize, inside: usize, unknowns: usize) -> f64 {
        let part = (inside as f64 / all as f64).max(0.5);
        part / (1.0 + unknowns as f64 / all as f64 * (1.0 - part) / part)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numerics::Draw;

    /// For normally distributed numbers the scale is their standard deviation, wherever the loss becomes linear. The mean square of the clamped
    /// numbers equals [`Huber::mean_square`].
    #[test]
    fn the_scale_is_that_of_a_normal_distribution() {
        let drawn: Vec<f64> = (0..20_000).map(|k| 3.0 * Draw::new([1, 2, k]).normal()).collect();
        for corner in [1.0, 2.0, f64::INFINITY] {
            let huber = Huber(corner);
            let scale = huber.scale(&drawn, drawn.len());
            assert!((scale / 3.0 - 1.0).abs() < 0.02, "{corner}: {scale}");
            let mean = huber.squares(drawn.iter().map(|x| x / 3.0)) / drawn.len() as f64;
            assert!((mean - huber.mean_square()).abs() < 0.02, "{corner}: {mean}");
        }
    }

    /// A tenth of all numbers with thirty times the scatter hardly changes the scale.
    #[test]
    fn a_few_far_off_hardly_count() {
        let far = |k: u64| if k.is_multiple_of(10) { 30.0 } else { 1.0 };
        let drawn: Vec<f64> = (0..5000).map(|k| far(k) * Draw::new([7, 2, k]).normal()).collect();
        let [squares, cut] = [f64::INFINITY, 1.5].map(|corner| Huber(corner).scale(&drawn, drawn.len()));
        assert!(squares > 9.0 && cut < 1.7, "{squares} {cut}");
    }

    #[test]
    fn the_loss_is_smooth_at_its_corner() {
        let huber = Huber(1.5);
        let slope = |u: f64| (huber.loss(u + 1e-6) - huber.loss(u - 1e-6)) / 2e-6;
        for u in [-4.0, -1.6, -1.5, 0.3, 1.4, 1.5, 9.0] {
            assert!((slope(u) - u * huber.weight(u)).abs() < 1e-6, "{u}");
        }
    }
}
