//! The bordered linear system of a step along a load path, for many coordinates. The tangent stiffness T is a band; the column c, the row gᵀ and the
//! corner γ are its border. y and z are the unknowns, b and β the right-hand sides.
//!
//! ```text
//! T y  + c z = b          z = (β - gᵀT⁻¹b) / (γ - gᵀT⁻¹c)
//! gᵀy  + γ z = β          y = T⁻¹b - T⁻¹c z
//! ```
//!
//! If T is nearly singular these formulas lose digits, which iterative refinement restores (W. Govaerts, Stable solvers and block elimination for
//! bordered systems, SIAM J. Matrix Anal. Appl. 12, 1991). If T is singular, the caller factorises the whole bordered matrix.

use super::add_times::add_times;
use super::band::{Band, BandFactors};
use crate::numerics::dot;
use crate::prelude::*;

/// Factors of a bordered matrix [T c; gᵀ γ], based on the factors of its band T.
#[derive(Debug, Clone)]
pub(crate) struct BorderedBand {
    band: Band,
    factors: BandFactors,
    cover: Vec<f64>,
    gradient: Vec<f64>,
    corner: f64,
    /// The vector T⁻¹c, with the band matrix T and the column c beside it.
    covered: Vec<f64>,
    /// The reciprocal of γ - gᵀT⁻¹c. gᵀ is the row below the band matrix T, c the column beside it, and γ the corner.
    inverse: f64,
}

impl BorderedBand {
    /// Factorises the band matrix T and the bordered matrix [T c; gᵀ γ]. c is `cover`, g is `gradient`, γ is `corner`; their entries are in the
    /// order of the rows of the band. `None` if T or the bordered matrix is singular.
    pub(crate) fn new(band: Band, cover: Vec<f64>, gradient: Vec<f64>, corner: f64) -> Option<Self> {
        let factors = band.clone().factors().filter(|factors| !factors.is_singular())?;
        let mut covered = cover.clone();
        factors.solve(&mut covered);
        let pivot = corner - dot(&gradient, &covered);
        let inverse = pivot.is_normal().then(|| 1.0 / pivot)?;
        Some(Self { band, factors, cover, gradient, corner, covered, inverse })
    }

    /// Solves the system T y + c z = b, gᵀy + γ z = β of the bordered matrix. Replaces b in `balance` by the solution y; `last` is β. Returns z.
    pub(crate) fn solve(&self, balance: &mut [f64], last: f64) -> f64 {
        let given = balance.to_vec();
        let mut z = self.solve_once(balance, last);
        let mut left = vec![0.0; given.len()];
        // Two steps of iterative refinement restore the digits that are lost if the band matrix is nearly singular.
        for _ in 0..2 {
            left.copy_from_slice(&given);
            self.band.subtract_product(balance, &mut left);
            add_times(&mut left, &self.cover, -z);
            let missing = last - dot(&self.gradient, balance) - self.corner * z;
            z += self.solve_once(&mut left, missing);
            add_times(balance, &left, 1.0);
        }
        z
    }

    fn solve_once(&self, b: &mut [f64], last: f64) -> f64 {
        self.factors.solve(b);
        let z = (last - dot(&self.gradient, b)) * self.inverse;
        add_times(b, &self.covered, -z);
        z
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numerics::generic;

    /// The bordered matrix of a nearly singular band is regular; its solution must be accurate to rounding.
    #[test]
    fn solves_near_a_singular_band() {
        let (count, half_bandwidth) = (24, 3);
        for off in [1.0, 1e-4, 1e-8] {
            let mut band = Band::zeros(count, half_bandwidth);
            let mut full = vec![vec![0.0; count + 1]; count + 1];
            let mut add = |i: usize, j: usize, x: f64| {
                band.add(i, j, x);
                full[i][j] += x;
            };
            // The stiffness matrix of a chain of springs that is attached by a spring of stiffness `off`. For a small `off` it is nearly singular.
            for k in 1..count {
                for (i, j, x) in [(k, k, 1.0), (k - 1, k - 1, 1.0), (k, k - 1, -1.0), (k - 1, k, -1.0)] {
                    add(i, j, x);
                }
            }
            add(0, 0, off);
            let [cover, gradient] = [1, 7].map(|k| (0..count).map(|i| generic(i + k)).collect::<Vec<_>>());
            let corner = 0.3;
            for i in 0..count {
                (full[i][count], full[count][i]) = (cover[i], gradient[i]);
            }
            full[count][count] = corner;
            let x: Vec<f64> = (0..=count).map(|k| (k as f64).sin()).collect();
            let b: Vec<f64> = full.iter().map(|row| dot(row, &x)).collect();
            let bordered = BorderedBand::new(band, cover, gradient, corner).expect("regular");
            let mut y = b[..count].to_vec();
            let z = bordered.solve(&mut y, b[count]);
            let worst = y.iter().zip(&x).map(|(a, b)| (a - b).abs()).fold((z - x[count]).abs(), f64::max);
            assert!(worst < 1e-11, "{off:e}: {worst:e}");
        }
    }
}
