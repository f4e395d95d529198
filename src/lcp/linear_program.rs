//! The least violation of linear constraints, by linear programming. If the least violation is positive, the dual solution proves infeasibility.
//!
//! If Lemke's path ends in a ray that proves nothing, the solver tries the linear program min { t : M z + q + t 1 ≥ 0, z, t ≥ 0 } with the vector of
//! ones 1. The number t is the violation. If the minimum of t is positive, no z ≥ 0 satisfies M z + q ≥ 0, and the dual solution is a Farkas vector.
//! It satisfies Mᵀy ≤ 0; a margin δ > 0 tightens this constraint to Mᵀy ≤ −δ 1, so that rounding does not break it.

use super::farkas::cleaned;
use super::outcome::{Certificate, Outcome, Unsolved};
use super::problem::Lcp;
use super::quadratic_program::quadratic_program;
use super::scaling::Scaling;
use super::settings::Settings;
use crate::numerics::{IntoList, matrix_of, vector_of};
use nalgebra::{DMatrix, DVector};

/// A proof that M z + q ≥ 0 and z ≥ 0 contradict each other, exactly or up to rounding. The proof is a single row of M z + q that is negative for
/// every z ≥ 0, or else the dual solution of the linear program. `None` if no proof is found.
pub(super) fn proof(lcp: &Lcp, scaling: &Scaling, settings: &Settings) -> Option<Unsolved> {
    let n = lcp.len();
    if let Some(row) = (0..n).find(|row| lcp.has_certain_sign(*row, 1.0, 0..n)) {
        let y = vector_of(n, &|i| if i == row { 1.0 } else { 0.0 });
        return Some(Outcome::Infeasible(Certificate { y, pivots: 0 }));
    }
    let (a, b) = scaling.balanced(&lcp.m, &lcp.q);
    // For large problems only one program is solved, since each further margin δ costs one more Lemke path of a problem of 2 n + 1 rows. If rounding
    // invalidates the proof, the outcome is `NearlyInfeasible`. That is no loss, since data of large problems usually contain rounding errors
    // themselves.
    let margins = if n <= 64 { &MARGINS[..] } else { &MARGINS[..1] };
    let mut nearly = None;
    for y in contradictions(&a, &b, margins, settings) {
        let proof = lcp.farkas_proof(&vector_of(n, &|i| y[i] * scaling.row[i]));
        if let Some(Outcome::Infeasible(_)) = proof {
            return proof;
        }
        nearly = nearly.or(proof);
    }
    nearly
}

/// Dual solutions y ≥ 0 with bᵀy < 0, which may prove that no x ≥ 0 satisfies A x + b ≥ 0. Each margin δ, by which the constraints Aᵀy ≤ 0 are
/// tightened, gives one dual solution. The list ends at the first margin that gives none.
fn contradictions<'a>(
    a: &'a DMatrix<f64>,
    b: &'a DVector<f64>,
    margins: &'a [f64],
    settings: &'a Settings,
) -> impl Iterator<Item = DVector<f64>> + 'a {
    let dual = move |margin: &f64| {
        let y = least_violation(a, b, *margin, settings)?.y;
        (y.dot(b) < 0.0).then_some(y)
    };
    margins.iter().map_while(dual)
}

impl Lcp {
    /// Candidates for a proof by Farkas' lemma that A x + b ≥ 0 and x ≥ 0 contradict each other. The entries of A must be of the order of 1. For each
    /// margin δ the dual solution y with Aᵀy ≤ −δ 1 is returned in several forms ([`cleaned`]): as computed; with entries that are only noise set to
    /// zero; and as integer vectors with nearly the same ratios.
    pub(crate) fn contradictions<'a>(
        a: &'a DMatrix<f64>,
        b: &'a DVector<f64>,
        settings: &'a Settings,
    ) -> impl Iterator<Item = DVector<f64>> + 'a {
        contradictions(a, b, &MARGINS, settings).flat_map(|y| cleaned(&y).list())
    }
}

/// The margins δ by which the constraints Aᵀy ≤ −δ 1 of the dual linear programs are tightened. Without a margin the dual solution y lies on
/// some of the constraints, and rounding may move it outside. With a margin it stays inside, if the tightened constraints have a solution.
pub(super) const MARGINS: [f64; 4] = [0.0, 1e-3, 1e-6, 1e-9];

/// The least violation of the conditions { z_α ≥ 0, (M z + q)_α = 0, (M z + q)_ᾱ ≥ 0 }. The set α has the i with z_i basic, its complement ᾱ the
/// other i; z_ᾱ is zero. The nonzero entries of M must lie near 1. `None` if the program cannot be solved. The solution x of the program holds the
/// z_α. Its dual solution y has one entry per row of M; in the rows α, where (M z + q)_i = 0, an entry may have either sign.
pub(super) fn of_piece(
    (m, q): (&DMatrix<f64>, &DVector<f64>),
    alpha: &[usize],
    margin: f64,
    settings: &Settings,
) -> Option<LinearProgram> {
    let (n, k) = (q.len(), alpha.len());
    // Each row in α, which must be zero, appears a second time with the opposite sign.
    let row = |i: usize| if i < n { (i, 1.0) } else { (alpha[i - n], -1.0) };
    let a = matrix_of(n + k, k, &|i, j| row(i).1 * m[(row(i).0, alpha[j])]);
    let size_of_q = q.amax();
    let size_of_q = if size_of_q > 0.0 { size_of_q } else { 1.0 };
    let b = vector_of(n + k, &|i| row(i).1 * q[row(i).0] / size_of_q);
    let LinearProgram { x, y } = least_violation(&a, &b, margin, settings)?;
    let mut folded = y.rows(0, n).into_owned();
    for (i, back) in alpha.iter().zip(y.iter().skip(n)) {
        folded[*i] -= back;
    }
    Some(LinearProgram { x: x * size_of_q, y: folded })
}

/// The solution, x and y, of min { t − δ 1ᵀx : A x + b + t 1 ≥ 0, x, t ≥ 0 } and of its dual max { −bᵀy : Aᵀy ≤ −δ 1, 1ᵀy ≤ 1, y ≥ 0 }, with a margin
/// δ.
pub(super) struct LinearProgram {
    pub(super) x: DVector<f64>,
    pub(super) y: DVector<f64>,
}

/// Solves the program of [`LinearProgram`] and its dual, with the violation t as an additional column of A and δ = `margin`. `None` if the program is
/// unbounded, as it may be for δ > 0, or if rounding prevents the solution.
fn least_violation(
    a: &DMatrix<f64>,
    b: &DVector<f64>,
    margin: f64,
    settings: &Settings,
) -> Option<LinearProgram> {
    let columns = a.ncols();
    // If a column of zeros had the cost −δ, the program would be unbounded; such a column has the cost 0.
    let cost = |j: usize| match j {
        j if j == columns => 1.0,
        j if a.column(j).iter().all(|a| *a == 0.0) => 0.0,
        _ => -margin,
    };
    let cost = vector_of(columns + 1, &|j| cost(j));
    let Settings { pivot_tolerance, tie_tolerance, residual_tolerance, .. } = *settings;
    let settings = Settings { pivot_tolerance, tie_tolerance, residual_tolerance, ..Settings::one_path() };
    let [x, y] = quadratic_program(None, &cost, &a.clone().insert_column(columns, 1.0), b, &settings)?;
    Some(LinearProgram { x: x.rows(0, columns).into_owned(), y })
}
