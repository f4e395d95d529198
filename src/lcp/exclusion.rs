//! Proofs, without rounding, that no solution belongs to a complementary basis.
//!
//! Let α be the set of i with z_i basic, and ᾱ its complement. The points of this basis form the piece { z_α ≥ 0, (M z + q)_α = 0, (M z + q)_ᾱ ≥ 0 }.
//! By Farkas' lemma the piece is empty if there is a v with
//!
//! ```text
//! v_ᾱ ≥ 0,     (Mᵀv)_α ≤ 0,     qᵀv < 0
//! ```
//!
//! If the principal block M_αα is regular, exactly one z has z_ᾱ = 0 and (M z + q)_α = 0: the point of the basis. If this point violates a condition
//! of the piece, v is derived from a row of the inverse of the block. The sums (Mᵀv)_α of such a v are zero in exact arithmetic. They are shifted
//! slightly below zero, so that rounding cannot make them positive. For singular blocks v comes from a linear program. Every v is checked by sums
//! without rounding; if none passes, the basis is not excluded.

use super::farkas::{Domain, cleaned};
use super::linear_program::{self, MARGINS};
use super::problem::Lcp;
use super::scaling::Scaling;
use super::settings::Settings;
use crate::numerics::{IntoList, Reals, any_index, chosen, increasing, mapped, matrix_of, vector_of};
use crate::prelude::*;
use nalgebra::{DMatrix, DVector};

/// True if, for each of the 2ⁿ complementary bases, a proof is found that no solution belongs to the basis. The caller keeps n to at most 20, since
/// the time doubles with each row.
pub(super) fn every_basis(lcp: &Lcp, scaling: &Scaling, settings: &Settings) -> bool {
    let n = lcp.len();
    let (m, q) = scaling.balanced(&lcp.m, &lcp.q);
    let judge = ExclusionTest { lcp, scaling, settings, m, q };
    (0..1_u32 << n).all(|bits| {
        let alpha: Vec<usize> = chosen(n, &|i| bits >> i & 1 == 1);
        judge.excludes(&alpha)
    })
}

struct ExclusionTest<'a> {
    lcp: &'a Lcp,
    scaling: &'a Scaling,
    settings: &'a Settings,
    /// The matrix M with scaled rows and columns, so that nonzero entries lie near 1. The right-hand side `q` is multiplied by the same row factors.
    m: DMatrix<f64>,
    q: DVector<f64>,
}

impl ExclusionTest<'_> {
    fn excludes(&self, alpha: &[usize]) -> bool {
        self.by_one_row(alpha) || self.by_broken_conditions(alpha) || self.by_linear_program(alpha)
    }

    /// Whether one row of M and q alone excludes the basis α. Row i does so if q_i < 0 and row i of M has no positive entry in the columns α:
    /// then w_i < 0. For i in α, where w_i must be zero, row i also excludes the basis if q_i > 0 and the row has no negative entry in the columns α.
    fn by_one_row(&self, alpha: &[usize]) -> bool {
        let hopeless = |i: usize, sign: f64| self.lcp.has_certain_sign(i, sign, alpha.iter().copied());
        any_index(self.q.len(), &|i| hopeless(i, 1.0)) || alpha.iter().any(|i| hopeless(*i, -1.0))
    }

    /// Whether a row of the inverse of the regular block M_αα, taken as the vector v of the proof, excludes the basis. Three rows are tried, for
    /// the conditions that the point of the basis violates most.
    fn by_broken_conditions(&self, alpha: &[usize]) -> bool {
        let (n, size) = (self.q.len(), alpha.len());
        let block = matrix_of(size, size, &|i, j| self.m[(alpha[i], alpha[j])]);
        let rhs = vector_of(size, &|i| -self.q[alpha[i]]);
        let Some(z) = solved(&block, &rhs) else { return false };
        let transposed = block.transpose();
        let row = |i: usize| vector_of(size, &|j| self.m[(i, alpha[j])]);
        let w = |i: usize| self.q[i] + row(i).dot(&z);
        let outside = (0..n).filter(|i| !alpha.contains(i)).map(|i| (w(i), ViolatedCondition::Slack(i)));
        let mut broken: Vec<_> =
            (0..size).map(|j| (z[j], ViolatedCondition::Domain(j))).chain(outside).list();
        broken.retain(|(value, _)| *value < 0.0);
        let values: Vec<f64> = mapped(&broken, &|(value, _)| *value);
        let reach = z.iter().map(|z| z.abs()).added();
        increasing(&values).into_iter().take(3).any(|position| {
            let (value, which) = &broken[position];
            // The proof needs (Mᵀv)_α ≤ 0 and qᵀv < 0. A shift of (Mᵀv)_α below zero raises the negative qᵀv, and may use up this fraction of its
            // magnitude. If the fraction were near 0 or 1, rounding would decide the sign of (Mᵀv)_α or of qᵀv.
            let used_up = 0.25;
            let push = if reach > 0.0 { used_up * -value / reach } else { used_up };
            let mut target = DVector::from_element(size, -push);
            let mut v = DVector::zeros(n);
            match which {
                ViolatedCondition::Domain(j) => target[*j] -= 1.0,
                ViolatedCondition::Slack(i) => {
                    target -= row(*i);
                    v[*i] = 1.0;
                }
            }
            let Some(within) = solved(&transposed, &target) else { return false };
            for (i, within) in alpha.iter().zip(&within) {
                v[*i] = *within;
            }
            self.proves(alpha, &v)
        })
    }

    /// Whether a dual solution of a linear program, taken as the vector v of the proof, excludes the basis α. The program minimises the largest
    /// violation of the conditions z_α ≥ 0, (M z + q)_α = 0, (M z + q)_ᾱ ≥ 0. The dual program is solved once for each margin δ in [`MARGINS`] (0 to
    /// 1e-3), with its constraints tightened by δ. With δ > 0 the dual solution satisfies the constraints in spite of rounding.
    fn by_linear_program(&self, alpha: &[usize]) -> bool {
        let program = |margin| linear_program::of_piece((&self.m, &self.q), alpha, margin, self.settings);
        MARGINS.into_iter().filter_map(program).any(|program| self.proves(alpha, &program.y))
    }

    /// Whether the vector v, as computed or [`cleaned`] of rounding, proves that no solution belongs to the basis α. The entries of `v` are
    /// multipliers of the scaled rows, and are first converted to multipliers of the given rows.
    fn proves(&self, alpha: &[usize], v: &DVector<f64>) -> bool {
        let y = vector_of(v.len(), &|i| v[i] * self.scaling.row[i]);
        let basic = |i: usize| alpha.contains(&i);
        let domain = |j| if basic(j) { Domain::NotNegative } else { Domain::Zero };
        cleaned(&y).any(|y| self.lcp.contradicts(&y, &basic, &domain))
    }
}

/// The solution of a square system; `None` if its matrix is singular. An empty system has the empty solution.
fn solved(block: &DMatrix<f64>, rhs: &DVector<f64>) -> Option<DVector<f64>> {
    if rhs.is_empty() { Some(rhs.clone()) } else { block.clone().full_piv_lu().solve(rhs) }
}

/// A condition that the point of a basis α violates, because z_j or w_i is negative.
enum ViolatedCondition {
    /// The condition z_j ≥ 0 of a basic z_j, given by the position of j in the list α.
    Domain(usize),
    Slack(usize),
}
