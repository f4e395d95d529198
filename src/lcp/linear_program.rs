//! The least violation of linear constraints, by linear programming.
//!
//! Where a ray is no proof, the program min { t : M z + q + t 1 ≥ 0, z, t ≥ 0 } decides. If its
//! least t is positive, no z ≥ 0 has M z + q ≥ 0, and the dual solution is a Farkas vector.

use super::outcome::{Outcome, Proof};
use super::problem::Lcp;
use super::scaling::Scaling;
use super::settings::Settings;
use super::workspace::Workspace;
use nalgebra::{DMatrix, DVector};

/// A proof that the constraints cannot be met: one row of them, or the dual solution of the linear program.
pub(super) fn proof(lcp: &Lcp, scaling: &Scaling, settings: &Settings) -> Option<Proof> {
    let hopeless = |i: &usize| lcp.q[*i] < 0.0 && lcp.m.row(*i).iter().all(|m| *m <= 0.0);
    if let Some(row) = (0..lcp.len()).find(hopeless) {
        return Some(Proof::Infeasible(DVector::from_fn(lcp.len(), |i, _| if i == row { 1.0 } else { 0.0 })));
    }
    let (a, b) = scaling.balanced(&lcp.m, &lcp.q);
    let proof = |margin| {
        let program = least_violation(&a, &b, margin, settings)?;
        lcp.farkas_proof(&DVector::from_fn(lcp.len(), |i, _| program.y[i] * scaling.row[i]))
    };
    let nearly = proof(0.0)?;
    if matches!(nearly, Proof::Infeasible(_)) {
        return Some(nearly);
    }
    let exact = MARGINS
        .iter()
        .filter_map(|margin| proof(*margin))
        .find(|proof| matches!(proof, Proof::Infeasible(_)));
    Some(exact.unwrap_or(nearly))
}

/// A vertex of the dual program lies on its constraints, and rounding puts it beyond them. By these margins it is kept inside, where there is room.
pub(super) const MARGINS: [f64; 3] = [1e-3, 1e-6, 1e-9];

/// The solution of min { t − δ 1ᵀx : A x + b + t 1 ≥ 0, x, t ≥ 0 } and of its dual max { −bᵀy : Aᵀy ≤ −δ 1,
/// 1ᵀy ≤ 1, y ≥ 0 }, with a margin δ.
pub(super) struct Program {
    pub(super) x: DVector<f64>,
    pub(super) y: DVector<f64>,
}

/// Both solutions from one complementarity problem, whose matrix [0, −Aᵀ; A, 0] (with t as one more
/// column of A) is copositive-plus.
///
/// Lemke's method is guaranteed to solve it, since the program is feasible and bounded.
pub(super) fn least_violation(
    a: &DMatrix<f64>,
    b: &DVector<f64>,
    margin: f64,
    settings: &Settings,
) -> Option<Program> {
    let (rows, columns) = a.shape();
    let size = columns + 1 + rows;
    let mut m = DMatrix::zeros(size, size);
    let mut q = DVector::zeros(size);
    let a = a.clone().insert_column(columns, 1.0);
    m.view_mut((columns + 1, 0), a.shape()).copy_from(&a);
    m.view_mut((0, columns + 1), (columns + 1, rows)).copy_from(&-a.transpose());
    // A column of zeros leaves no room.
    for (q, column) in q.iter_mut().zip(a.column_iter()).take(columns) {
        *q = if column.iter().all(|a| *a == 0.0) { 0.0 } else { -margin };
    }
    q.rows_mut(columns + 1, rows).copy_from(b);
    q[columns] = 1.0;
    let settings =
        Settings { covering: None, max_pivots: None, retries: 0, enumerate_up_to: 0, ..settings.clone() };
    let problem = Lcp::new(m, q).ok()?;
    let Outcome::Solved(solution) = Workspace::new().follow_once(&problem, &settings) else {
        return None;
    };
    Some(Program {
        x: solution.z.rows(0, columns).into_owned(),
        y: solution.z.rows(columns + 1, rows).into_owned(),
    })
}
