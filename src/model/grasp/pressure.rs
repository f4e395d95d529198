//! Pressure profiles of a soft fingertip, and the quadrature points that represent them.

use crate::numerics::{Each, Space};
use crate::prelude::*;

/// Profile of the pressure p(r) at the distance r from the centre of a contact patch. The patch is a disc of radius R in space, and a line of
/// half-width R in the plane.
///
/// Means weighted by the pressure, ⟨f⟩ = ∫ f p / ∫ p:
///
/// | profile | p(r) ~ | disc ⟨r⟩ | disc ⟨r²⟩ | line ⟨r²⟩ |
/// |---|---|---|---|---|
/// | uniform | 1 | 2/3 R | 1/2 R² | 1/3 R² |
/// | parabolic | 1 - (r/R)² | 8/15 R | 1/3 R² | 1/5 R² |
/// | Hertz | √(1 - (r/R)²) | 3π/16 R | 2/5 R² | 1/4 R² |
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "snake_case"))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub enum Pressure {
    /// Constant pressure: a flat punch on a bed of springs, or the lip of a cup.
    #[default]
    Uniform,
    /// A paraboloid, zero at the rim: a ball pressed into a bed of springs.
    Parabolic,
    /// An ellipsoid, zero at the rim: a ball pressed into an elastic half-space (Hertz 1882).
    Hertz,
}

/// A quadrature node: the load at one distance from the centre.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Layer {
    /// Distance from the centre, in units of the radius.
    pub(super) distance: f64,
    /// Fraction of the normal load that acts at this distance; the fractions of all nodes sum to one.
    pub(super) weight: f64,
}

impl Pressure {
    /// Quadrature nodes for `bands` bands of equal width (annuli of a disc, or strips on both sides of a line), two nodes per band.
    ///
    /// At the distance ρ from the centre the load has the density ρ^(c-2) p(ρ), with c = 2 for a line and 3 for a disc. Its moments over the band [a,
    /// b] are `m_k = ∫ ρ^k density dρ`. One node lies on the outer edge b, the other node at x. Their shares of the load and x are chosen to
    /// reproduce m_0, m_1 and m_2 (Radau's rule with two points):
    ///
    /// ```text
    /// x = (b m_1 - m_2) / (b m_0 - m_1),   share at x = (b m_0 - m_1) / (b - x),   at b = (m_1 - x m_0) / (b - x)
    /// ```
    ///
    /// Load, ⟨r⟩, ⟨r²⟩ and the radius of the rim thus agree with the continuum for any number of bands.
    pub(super) fn layers(self, space: Space, bands: usize) -> Vec<Layer> {
        let around = i32::from(space == Space::Spatial);
        let moment = |k, a, b| self.integral(k + around, b) - self.integral(k + around, a);
        let total = moment(0, 0.0, 1.0);
        let edge = |j: usize| j as f64 / bands as f64;
        let mut layers = Vec::with_capacity(2 * bands);
        for j in 0..bands {
            let (a, b) = (edge(j), edge(j + 1));
            let [m0, m1, m2] = [0, 1, 2].each(|k| moment(k, a, b) / total);
            let x = (b * m1 - m2) / (b * m0 - m1);
            let inner = (b * m0 - m1) / (b - x);
            layers.push(Layer { distance: x, weight: inner });
            layers.push(Layer { distance: b, weight: m0 - inner });
        }
        layers
    }

    /// An antiderivative of `ρ^power p(ρ)` at `rho`, for powers 0 to 3; distances ρ are in units of the radius.
    fn integral(self, power: i32, rho: f64) -> f64 {
        let monomial = |k: i32| rho.powi(k + 1) / f64::from(k + 1);
        match self {
            Self::Uniform => monomial(power),
            Self::Parabolic => monomial(power) - monomial(power + 2),
            Self::Hertz => {
                let s = ((1.0 - rho) * (1.0 + rho)).sqrt();
                match power {
                    0 => 0.5 * (rho.asin() + rho * s),
                    1 => -s.powi(3) / 3.0,
                    2 => (rho.asin() - rho * s * (1.0 - 2.0 * rho * rho)) / 8.0,
                    _ => s.powi(5) / 5.0 - s.powi(3) / 3.0,
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Compares the moments of the nodes of each band with integrals of the density over this band by the midpoint rule.
    fn layers_carry_the_moments_of_their_band(space: Space) {
        let density = |pressure: Pressure, r: f64| {
            (if space == Space::Spatial { r } else { 1.0 })
                * match pressure {
                    Pressure::Uniform => 1.0,
                    Pressure::Parabolic => 1.0 - r * r,
                    Pressure::Hertz => (1.0 - r * r).sqrt(),
                }
        };
        let steps = 200_000_u32;
        for pressure in [Pressure::Uniform, Pressure::Parabolic, Pressure::Hertz] {
            for bands in [1, 2, 5] {
                let samples: Vec<_> = (0..steps)
                    .map(|i| (f64::from(i) + 0.5) / f64::from(steps))
                    .map(|r| (r, density(pressure, r)))
                    .collect();
                let total: f64 = samples.iter().map(|(_, p)| p).sum();
                let layers = pressure.layers(space, bands);
                for (band, samples) in layers.chunks(2).zip(samples.chunks(steps as usize / bands)) {
                    for k in 0..=2 {
                        let from_layers: f64 = band.iter().map(|l| l.weight * l.distance.powi(k)).sum();
                        let integral = samples.iter().map(|(r, p)| p * r.powi(k)).sum::<f64>() / total;
                        assert!((from_layers - integral).abs() < 1e-8, "{pressure:?} {bands} {k}");
                    }
                }
            }
        }
    }

    #[test]
    fn layers_carry_the_moments_of_a_disc() {
        layers_carry_the_moments_of_their_band(Space::Spatial);
    }

    #[test]
    fn layers_carry_the_moments_of_a_line() {
        layers_carry_the_moments_of_their_band(Space::Planar);
    }

    /// Thin bands lose digits to cancellation. The quadrature nodes of such bands must still lie in their bands, in order, and carry positive
    /// fractions of the load.
    #[test]
    fn layers_lie_in_their_bands() {
        for pressure in [Pressure::Uniform, Pressure::Parabolic, Pressure::Hertz] {
            for bands in [1, 7, 64, 1024] {
                for layers in [Space::Planar, Space::Spatial].map(|space| pressure.layers(space, bands)) {
                    for (j, band) in layers.chunks(2).enumerate() {
                        let (a, b) = (j as f64 / bands as f64, (j + 1) as f64 / bands as f64);
                        assert!(a < band[0].distance && band[0].distance < b && band[1].distance == b);
                        assert!(band.iter().all(|layer| layer.weight > 0.0), "{pressure:?} {bands} {band:?}");
                    }
                    let sum: f64 = layers.iter().map(|layer| layer.weight).sum();
                    assert!((sum - 1.0).abs() < 1e-13, "{sum}");
                }
            }
        }
    }
}
