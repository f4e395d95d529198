//! What a ray proves.
//!
//! If M is copositive-plus, the direction ẑ of a secondary ray has ẑᵀMẑ = 0, hence (M + Mᵀ)ẑ = 0, Mᵀẑ = −Mẑ ≤ 0 and
//! qᵀẑ < 0 (Cottle, Pang & Stone, proof of theorem 4.4.12): it is itself a Farkas vector. Whether it is one can be
//! checked without knowing the class of M. When it is not, the linear program min { t : M z + q + t h ≥ 0, z, t ≥ 0 } decides
//! whether the constraints can be met at all; its dual solution is a Farkas vector if they cannot.

use super::Lcp;
use super::dictionary::Unknown;
use super::lemke::Path;
use super::outcome::{Outcome, Proof, Ray};
use super::scaling::Scaling;
use super::settings::Settings;
use nalgebra::{DMatrix, DVector};

/// Whether y is a Farkas vector up to the rounding of its sums.
pub(crate) fn check(lcp: &Lcp, y: &DVector<f64>) -> bool {
    let n = lcp.len();
    if y.len() != n || !y.iter().all(|y| y.is_finite() && *y >= 0.0) {
        return false;
    }
    let rounding = 8.0 * (n as f64 + 2.0) * f64::EPSILON;
    let sums = |column: &[f64]| {
        column.iter().zip(y).fold((0.0, 0.0), |(sum, terms), (m, y)| (sum + m * y, terms + (m * y).abs()))
    };
    let (sum, terms) = sums(lcp.q.as_slice());
    let descends = terms.is_finite() && sum < -rounding * terms;
    descends
        && lcp.m.as_slice().chunks_exact(n.max(1)).all(|column| {
            let (sum, terms) = sums(column);
            terms.is_finite() && sum <= rounding * terms
        })
}

/// The ray along which the entering variable grows for ever, in the caller's units and with largest entry 1. `None` if
/// it leaves the range of double precision there.
pub(crate) fn ray(lcp: &Lcp, path: &Path, entering: Unknown) -> Option<Ray> {
    let mut direction = DVector::zeros(lcp.len());
    let mut balanced = DVector::zeros(lcp.len());
    let mut covering_rate = 0.0;
    let mut set = |j: usize, rate: f64| {
        balanced[j] = rate;
        direction[j] = rate * path.scaling.column[j];
    };
    if let Unknown::Z(e) = entering {
        set(e, 1.0);
    }
    let noise = 1e-12 * super::dictionary::largest(&path.dictionary.u).max(1.0);
    for (basic, u) in path.dictionary.basic.iter().zip(&path.dictionary.u) {
        match *basic {
            Unknown::Z(j) if *u > noise => set(j, *u),
            Unknown::Covering if *u > noise => covering_rate = *u,
            _ => {}
        }
    }
    // A Farkas vector weighs rows, so it is read in the units of rows.
    let y = DVector::from_fn(lcp.len(), |i, _| balanced[i] * path.scaling.row[i]);
    let proof = if check(lcp, &y) { Proof::Infeasible(y) } else { Proof::None };
    let size = direction.amax();
    if direction.iter().any(|x| !x.is_finite()) {
        return None;
    }
    if size > 0.0 {
        direction /= size;
        covering_rate /= size;
    }
    covering_rate.is_finite().then_some(Ray { direction, covering_rate, proof, pivots: path.pivots })
}

/// A Farkas vector from the linear program, if the constraints cannot be met.
pub(crate) fn by_linear_programming(
    lcp: &Lcp,
    scaling: &Scaling,
    settings: &Settings,
) -> Option<DVector<f64>> {
    let n = lcp.len();
    let a = DMatrix::from_fn(n, n, |i, j| lcp.m[(i, j)] * scaling.row[i] * scaling.column[j]);
    let b = DVector::from_fn(n, |i, _| lcp.q[i] * scaling.row[i]);
    let program = least_violation(&a, &b, settings)?;
    let y = DVector::from_fn(n, |i, _| program.y[i] * scaling.row[i]);
    check(lcp, &y).then_some(y)
}

/// The solution of min { t : A x + b + t 1 ≥ 0, x, t ≥ 0 } and of its dual max { −bᵀy : Aᵀy ≤ 0, 1ᵀy ≤ 1, y ≥ 0 }.
pub(crate) struct Program {
    pub(crate) x: DVector<f64>,
    pub(crate) y: DVector<f64>,
}

/// Both solutions from one complementarity problem, whose matrix [0, −Aᵀ; A, 0] is copositive-plus: Lemke's method is
/// guaranteed to solve it, since the program is feasible and bounded.
pub(crate) fn least_violation(a: &DMatrix<f64>, b: &DVector<f64>, settings: &Settings) -> Option<Program> {
    let (rows, columns) = a.shape();
    let size = columns + 1 + rows;
    let mut m = DMatrix::zeros(size, size);
    let mut q = DVector::zeros(size);
    for i in 0..rows {
        for j in 0..=columns {
            let entry = if j == columns { 1.0 } else { a[(i, j)] };
            m[(columns + 1 + i, j)] = entry;
            m[(j, columns + 1 + i)] = -entry;
        }
        q[columns + 1 + i] = b[i];
    }
    q[columns] = 1.0;
    let settings =
        Settings { covering: None, max_pivots: None, retries: 0, enumerate_up_to: 0, ..settings.clone() };
    let problem = Lcp::new(m, q).ok()?;
    let Outcome::Solved(solution) = super::Workspace::new().follow_once(&problem, &settings) else {
        return None;
    };
    Some(Program {
        x: solution.z.rows(0, columns).into_owned(),
        y: solution.z.rows(columns + 1, rows).into_owned(),
    })
}
