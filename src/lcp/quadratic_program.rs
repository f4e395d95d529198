//! Convex quadratic programs with nonnegative unknowns, solved as complementarity problems of their optimality conditions.

use crate::numerics::vector_of;
use nalgebra::{DMatrix, DVector};

use super::error::LcpError;
use super::outcome::Outcome;
use super::problem::Lcp;
use super::settings::Settings;

/// The complementarity problem that states the optimality conditions of a quadratic program:
///
/// ```text
/// minimise  gᵀx + ½ xᵀH x     subject to  A x + b >= 0,  x >= 0,
///
/// 0 <= x ⟂ H x - Aᵀy + g >= 0,     0 <= y ⟂ A x + b >= 0;
/// ```
///
/// `None` for H means H = 0. For a positive semidefinite H the matrix `[H, -Aᵀ; A, 0]` is copositive-plus, so Lemke's method finds a minimum if
/// one exists.
fn optimality_conditions(
    h: Option<&DMatrix<f64>>,
    g: &DVector<f64>,
    a: &DMatrix<f64>,
    b: &DVector<f64>,
) -> Result<Lcp, LcpError> {
    let (rows, columns) = a.shape();
    let mut m = DMatrix::zeros(columns + rows, columns + rows);
    if let Some(h) = h {
        m.view_mut((0, 0), (columns, columns)).copy_from(h);
    }
    m.view_mut((columns, 0), (rows, columns)).copy_from(a);
    m.view_mut((0, columns), (columns, rows)).copy_from(&-a.transpose());
    Lcp::new(m, vector_of(columns + rows, &|i| if i < columns { g[i] } else { b[i - columns] }))
}

/// The minimiser x of gᵀx + ½ xᵀH x under the constraints A x + b >= 0 and x >= 0, and the multipliers y of the rows of A x + b. `None` without a
/// minimum, or if rounding prevents the solution.
pub(crate) fn quadratic_program(
    h: Option<&DMatrix<f64>>,
    g: &DVector<f64>,
    a: &DMatrix<f64>,
    b: &DVector<f64>,
    settings: &Settings,
) -> Option<[DVector<f64>; 2]> {
    let (rows, columns) = a.shape();
    let conditions = optimality_conditions(h, g, a, b).ok()?;
    let Outcome::Solved(solution) = conditions.solve_with(settings) else { return None };
    Some([solution.z.rows(0, columns).into_owned(), solution.z.rows(columns, rows).into_owned()])
}
