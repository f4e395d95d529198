//! Quadratic programs solved by an interior-point method (Clarabel), independent of pivoting methods.

use clarabel::algebra::CscMatrix;
use clarabel::solver::{
    DefaultSettingsBuilder, DefaultSolver, IPSolver, NonnegativeConeT, SolverStatus, SupportedConeT,
    ZeroConeT,
};
use nalgebra::{DMatrix, DVector};

use crate::quadratic_program::QuadraticProgram;

pub(crate) fn sparse(m: &DMatrix<f64>) -> CscMatrix<f64> {
    let (rows, columns) = m.shape();
    let (mut starts, mut row_of, mut values) = (vec![0], Vec::new(), Vec::new());
    for j in 0..columns {
        for i in 0..rows {
            if m[(i, j)] != 0.0 {
                row_of.push(i);
                values.push(m[(i, j)]);
            }
        }
        starts.push(values.len());
    }
    CscMatrix::new(rows, columns, starts, row_of, values)
}

/// Outcome of the interior-point method.
#[derive(Debug)]
pub enum Oracle {
    /// A minimum, and its relative tolerance according to the method.
    Minimum(DVector<f64>, f64),
    /// No minimum exists: the program is infeasible or unbounded.
    None,
    /// The method did not converge. Programs whose constraints leave no interior are hard for it.
    Silent,
}

/// Solves a quadratic program to a tolerance of 1e-12.
pub fn interior_point(qp: &QuadraticProgram) -> Oracle {
    interior_point_within(qp, 1e-12)
}

/// Solves a quadratic program to a tolerance of feasibility and of the gap between primal and dual value, absolute and relative.
pub fn interior_point_within(qp: &QuadraticProgram, tolerance: f64) -> Oracle {
    interior_point_and_multipliers(qp, tolerance).0
}

/// Solves a quadratic program, and returns the multipliers of its inequality rows too. They have no meaning without a minimum.
pub fn interior_point_and_multipliers(qp: &QuadraticProgram, tolerance: f64) -> (Oracle, Vec<f64>) {
    let (n, m, k) = (qp.g.len(), qp.c.len(), qp.d.len());
    let mut upper = qp.h.clone();
    upper.fill_lower_triangle(0.0, 1);
    // A x + s = b with s = 0 for equalities and s >= 0 for -B x <= -D.
    let mut rows = DMatrix::zeros(m + k, n);
    rows.view_mut((0, 0), (m, n)).copy_from(&qp.a);
    rows.view_mut((m, 0), (k, n)).copy_from(&-&qp.b);
    let right: Vec<f64> = qp.c.iter().copied().chain(qp.d.iter().map(|d| -d)).collect();
    let cones: Vec<SupportedConeT<f64>> = [(m, ZeroConeT(m)), (k, NonnegativeConeT(k))]
        .into_iter()
        .filter(|(size, _)| *size > 0)
        .map(|(_, cone)| cone)
        .collect();
    let settings = DefaultSettingsBuilder::default()
        .verbose(false)
        .tol_gap_abs(tolerance)
        .tol_gap_rel(tolerance)
        .tol_feas(tolerance)
        .build()
        .expect("valid settings");
    let mut solver =
        DefaultSolver::new(&sparse(&upper), qp.g.as_slice(), &sparse(&rows), &right, &cones, settings)
            .expect("a valid program");
    solver.solve();
    let x = DVector::from_column_slice(&solver.solution.x);
    let oracle = match solver.solution.status {
        SolverStatus::Solved => Oracle::Minimum(x, 1e-10),
        // This status means that only the reduced tolerances of the method are met.
        SolverStatus::AlmostSolved => Oracle::Minimum(x, 1e-4),
        SolverStatus::PrimalInfeasible | SolverStatus::DualInfeasible => Oracle::None,
        _ => Oracle::Silent,
    };
    (oracle, solver.solution.z.split_off(m))
}
