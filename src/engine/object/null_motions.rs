//! Null vectors of the tangent stiffness T = BᵀA, stored as a band matrix, and their mechanical meaning.
//!
//! A maps a motion of the object to the stretches of all springs, each multiplied by the square root of the spring's stiffness (scaled stretches). Bᵀ
//! maps the spring forces, each divided by this root (scaled forces), to a wrench on the object.
//!
//! ```text
//! A n = 0             the motion n stretches no spring: free
//! A n ≠ 0, T n = 0    forces change along n but stay in balance: neutral
//! B z = 0             no spring balances a load that does work along the motion z
//! B z ≠ 0, Tᵀz = 0    no motion changes the work of the springs along z: without balance along z there is no solution
//! ```

use super::banded_tangent::{BandedTangent, SpringRows};
use super::tolerances::NO_WORK;
use crate::numerics::tolerances::LINEARLY_DEPENDENT;
use crate::numerics::{
    BandFactors, IntoList, Singular, Size, Vector, add_times, amax, dot, matrix_of, orthonormalise_against,
    scale,
};
use crate::prelude::*;

/// Null vectors of the tangent stiffness T (`free`, `neutral`) and of its transpose (`unbalanced`, `without_response`). All four lists are empty if T
/// is regular.
#[derive(Debug, Clone)]
pub(super) struct NullMotions {
    /// Null vectors n of the tangent stiffness T that stretch no spring: A n = 0 with the matrix A of spring stretches. Orthonormal.
    pub(super) free: Vec<Vector>,
    /// Null vectors n of the tangent stiffness T that stretch springs (A n ≠ 0): forces change along n but stay in balance. Orthonormal, and
    /// orthogonal to the free motions.
    pub(super) neutral: Vec<Vector>,
    /// Left null vectors z of the tangent stiffness T along which no spring pushes: B z = 0 with the matrix B of push directions. Orthonormal.
    pub(super) unbalanced: Vec<Vector>,
    /// Left null vectors z of the tangent stiffness T along which springs push. Each comes with its vector B z ≠ 0 for the matrix B of push
    /// directions. The vectors B z have an entry for each spring and are orthonormal.
    without_response: Vec<(Vector, Vec<f64>)>,
}

/// Null vectors of the tangent stiffness or of its transpose, divided by whether they stretch springs.
struct SortedNullVectors {
    /// Null vectors that stretch no spring.
    unstretched: Vec<Vector>,
    /// All other null vectors, each with the stretches of all springs, scaled so that these stretches have norm one.
    stretched: Vec<(Vector, Vec<f64>)>,
}

impl NullMotions {
    /// The null motions of the tangent stiffness T, from its LU factors as a band matrix. All lists are empty if T is regular. `None` if T is nearly,
    /// but not exactly, singular.
    pub(super) fn of(band: &BandedTangent) -> Option<Self> {
        let nothing = Self {
            free: Vec::new(),
            neutral: Vec::new(),
            unbalanced: Vec::new(),
            without_response: Vec::new(),
        };
        if !band.factors.is_singular() {
            return Some(nothing);
        }
        let (stretches, pushes) = (&band.stretches, band.pushes.as_ref().unwrap_or(&band.stretches));
        let of_right =
            sorted_null_vectors(band, [stretches, pushes], band.factors.null_vectors(), BandFactors::solve)?;
        let of_left = sorted_null_vectors(
            band,
            [pushes, stretches],
            band.factors.left_null_vectors(),
            BandFactors::solve_transposed,
        )?;
        let mut found = Self {
            free: of_right.unstretched,
            unbalanced: of_left.unstretched,
            without_response: of_left.stretched,
            ..nothing
        };
        for (mut v, _) in of_right.stretched {
            let known: Vec<_> = found.free.iter().chain(&found.neutral).cloned().list();
            orthonormalise_against(&mut v, &known);
            found.neutral.push(v);
        }
        Some(found)
    }

    /// The sum of the left null vectors in `without_response`, each weighted by the work that the load and the spring forces `x` do along it. `None`
    /// if all these weights are zero. `x` holds the scaled force of each spring at zero twist, due to the contact offsets a (commands minus
    /// clearances and slips): `s·a`, with the vector s along which the spring is stretched.
    pub(super) fn motion_of_work(&self, x: &[f64], load: &Vector) -> Option<Vector> {
        let mut sum = Vector::zeros();
        for (z, stretches) in &self.without_response {
            sum += z * (dot(stretches, x) + z.dot(load));
        }
        (sum.norm() > 0.0).then_some(sum)
    }

    /// True if no spring forces can balance the load under the given contact offsets. `x` holds the scaled force of each spring that the offsets
    /// cause at zero twist. Along a motion z in `without_response`, no twist changes the work of the spring forces, so this work is that of `x`. If
    /// the load and the forces `x` together do more work along z than rounding explains, there is no balance. `growth` returns the factor by which
    /// the LU factors amplify rounding.
    pub(super) fn are_out_of_reach(&self, x: &[f64], load: &Vector, growth: &dyn Fn() -> f64) -> bool {
        self.without_response.iter().any(|(z, stretches)| {
            let sizes = |a: &[f64], b: &[f64]| {
                let mut sum = 0.0;
                for (a, b) in a.iter().zip(b) {
                    sum += (a * b).abs();
                }
                sum
            };
            let known = NO_WORK * (sizes(stretches, x) + sizes(z.as_slice(), load.as_slice()));
            let work = (dot(stretches, x) + z.dot(load)).abs();
            work > known && work > known * growth()
        })
    }
}

/// Groups null vectors of the tangent stiffness T = BᵀA, or of its transpose, by whether they stretch springs. For null vectors of T, `side` is A and
/// `other` is B; for null vectors of the transpose, `side` is B and `other` is A. The entries of `vectors` refer to columns of `side` that are scaled
/// to length one. `None` if some vector stretches springs and, by more than rounding, is not a null vector.
fn sorted_null_vectors(
    band: &BandedTangent,
    [side, other]: [&SpringRows; 2],
    vectors: Vec<Vec<f64>>,
    solve: fn(&BandFactors, &mut [f64]),
) -> Option<SortedNullVectors> {
    let springs = &band.springs;
    let mut found: Vec<(Vector, Vec<f64>)> = Vec::new();
    for mut q in vectors {
        let mut stretches = vec![0.0; springs.counts.iter().sum()];
        springs.stretch(side, &mut q, &mut |spring, stretch| stretches[spring] = stretch);
        // The forces due to the stretches of a null vector should be in balance. Rounding of T and its factors leaves a small imbalance, which two
        // corrections remove.
        for _ in 0..2 {
            let mut back = vec![0.0; q.len()];
            springs.add(other, &stretches, &mut back);
            solve(&band.factors, &mut back);
            springs.stretch(side, &mut back, &mut |spring, stretch| stretches[spring] -= stretch);
            add_times(&mut q, &back, -1.0);
        }
        let mut v = Vector::from_fn(Size::of(q.len()), |k| q[band.numbers[k]]);
        // Gram–Schmidt orthogonalisation against the null vectors found so far; the second pass removes the rounding of the first.
        for _ in 0..2 {
            for (known, of_known) in &found {
                let along = v.dot(known);
                v -= known * along;
                add_times(&mut stretches, of_known, -along);
            }
            let unit = 1.0 / v.norm();
            v *= unit;
            scale(&mut stretches, unit);
        }
        found.push((v, stretches));
    }
    let count = found.len();
    let axes = Singular::new(&matrix_of(count, count, &|i, j| dot(&found[i].1, &found[j].1))).right;
    let mut apart = SortedNullVectors { unstretched: Vec::new(), stretched: Vec::new() };
    for axis in axes.column_iter() {
        let mut v = Vector::zeros();
        let mut stretches = vec![0.0; springs.counts.iter().sum()];
        for ((known, of_known), part) in found.iter().zip(axis.iter()) {
            v += known * *part;
            add_times(&mut stretches, of_known, *part);
        }
        let length = dot(&stretches, &stretches).sqrt();
        // A unit motion is free if it hardly stretches any spring. The norm of the scaled stretches is then at most 1e-11 of the largest scaled
        // stretch of a spring under any unit motion. If the motion does stretch a spring, even a soft one, the ratio of the two is above 1e-6.
        if length <= 1e-11 * side.longest {
            apart.unstretched.push(v);
            continue;
        }
        let mut left = vec![0.0; band.numbers.len()];
        springs.add(other, &stretches, &mut left);
        let left = amax(&left);
        // The tangent stiffness T is singular along a motion if the spring forces that the motion causes are in balance. Because of rounding their
        // resultant is then not zero, but at most the fraction `LINEARLY_DEPENDENT` of the norm of the stretches. The comparison is false for NaN.
        let singular = left <= LINEARLY_DEPENDENT * length;
        if !singular {
            return None;
        }
        let unit = 1.0 / length;
        scale(&mut stretches, unit);
        apart.stretched.push((v * unit, stretches));
    }
    Some(apart)
}
