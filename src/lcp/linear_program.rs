//! The least violation of linear constraints, by linear programming.

use super::outcome::Outcome;
use super::problem::Lcp;
use super::scaling::Scaling;
use super::settings::Settings;
use super::workspace::Workspace;
use nalgebra::{DMatrix, DVector};

/// A Farkas vector from the linear program, if the constraints cannot be met.
pub(crate) fn farkas_vector(lcp: &Lcp, scaling: &Scaling, settings: &Settings) -> Option<DVector<f64>> {
    let (a, b) = scaling.balanced(&lcp.m, &lcp.q);
    let program = least_violation(&a, &b, settings)?;
    let y = DVector::from_fn(lcp.len(), |i, _| program.y[i] * scaling.row[i]);
    lcp.proves_infeasible(&y).then_some(y)
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
    let Outcome::Solved(solution) = Workspace::new().follow_once(&problem, &settings) else {
        return None;
    };
    Some(Program {
        x: solution.z.rows(0, columns).into_owned(),
        y: solution.z.rows(columns + 1, rows).into_owned(),
    })
}
