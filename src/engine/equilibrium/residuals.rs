//! Residuals of an answer: by how much it violates each condition. A finger's offset is its command (a prescribed displacement) minus clearance. A
//! bonded contact neither opens nor slips. A load path is a sequence of equilibria; an event is a change of contact states at one point of it.

use crate::numerics;
#[cfg(feature = "serde")]
use crate::serial::AsComputed;

/// Relative residuals of an equilibrium; all are zero in exact arithmetic, and usually about 1e-16. No answer with a residual above 1e-10 (1e-12 on
/// the round cone) is called an equilibrium.
///
/// Residuals are recomputed from points, frames, stiffnesses, commands and load, not from data of the solver. Forces are divided by the largest
/// contact force or load. This divisor is at least 1e-25 of the least force that the displacements could cause in a spring, so that it is not zero.
/// Displacements of a contact are divided by the sum of the magnitudes of its own displacements. Products of force and displacement are divided by
/// the product of these two divisors. On a load path only the slip since the contact states were last determined is used, for example since the last
/// event.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct Residuals {
    /// Equilibrium: the imbalance `|Σ F_i + W|` of contact forces and load, divided by a force. This divisor is the sum of the magnitudes of all
    /// terms, plus the least force that a contact's displacements could cause in its spring. The imbalance of moments has another divisor. It is the
    /// sum of the magnitudes of all moments, plus the divisor of forces times the root mean square lever arm of the contacts. The residual is the
    /// larger of the two ratios. For a hand and for several bodies it also covers every joint and body.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
    pub equilibrium: f64,
    /// Contact springs: `|F/k - (a - u_c + g - s)|` axis by axis, with the finger's offset a and the body's displacement u_c. The gap g is along the
    /// normal, and the slip s along the tangents.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
    pub springs: f64,
    /// Friction cone: `max(0, -F_n)`, and `max(0, |F_t| - μ F_n)` divided by 1 + μ. On a polygonal cone the largest `h·F_t` over the facet normals h
    /// takes the place of |F_t|. Zero for bonded contacts, whose force no cone limits. The first term is left out for contacts that are kept closed
    /// ([`Hold`](crate::grasp::Hold)), whose normal force may pull.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
    pub cone: f64,
    /// Penetration: `max(0, -g)`; `|g|` of a bonded contact.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
    pub gap: f64,
    /// Complementarity: `|F_n g|` with the gap g, and `|μ F_n |s| - F_t·s|` divided by 1 + μ, with the slip s. The second expression is zero iff
    /// there is no slip, or friction is at its limit and along the slip. For contacts that may not slip this residual is `|s|`.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
    pub complementarity: f64,
}

impl Residuals {
    /// The residuals of an answer that contains NaN or an infinite number: all of them infinite, so that no tolerance accepts the answer.
    pub(super) const NONE_HOLDS: Self = Self {
        equilibrium: f64::INFINITY,
        springs: f64::INFINITY,
        cone: f64::INFINITY,
        gap: f64::INFINITY,
        complementarity: f64::INFINITY,
    };

    /// The largest residual; infinite if a residual is not a number.
    #[must_use]
    pub fn worst(&self) -> f64 {
        let all = [self.equilibrium, self.springs, self.cone, self.gap, self.complementarity];
        numerics::largest(&all, &|r| if r.is_nan() { f64::INFINITY } else { *r })
    }
}
