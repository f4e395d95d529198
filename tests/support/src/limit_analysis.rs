//! The largest load that contact forces can balance, by an interior-point method (Clarabel).

use clarabel::algebra::CscMatrix;
use clarabel::solver::{
    DefaultSettingsBuilder, DefaultSolver, IPSolver, NonnegativeConeT, SecondOrderConeT, SolverStatus,
    SupportedConeT, ZeroConeT,
};
use nalgebra::{DMatrix, DVector};

use super::interior_point::sparse;

/// The bound of normal forces.
#[derive(Debug, Clone, Copy)]
pub enum Bound {
    /// Largest normal force of each contact.
    Each(f64),
    /// Largest sum of all normal forces.
    Total(f64),
}

/// The largest λ >= 0 with `Σ G_i f_i + base + λ rate = 0`, `|f_t| <= μ f_n` and bounded normal forces. `None` if no such λ exists, or the method
/// does not converge. `contacts` has the grasp map and the friction coefficient of each contact.
pub fn load_limit(
    contacts: &[(DMatrix<f64>, f64)],
    base: &DVector<f64>,
    rate: &DVector<f64>,
    bound: Bound,
) -> Option<f64> {
    let (d, c) = contacts.first()?.0.shape();
    let n = contacts.len();
    let variables = c * n + 1;
    let factor = variables - 1;
    let bounds = if let Bound::Each(_) = bound { n } else { 1 };
    let rows = d + bounds + 1 + c * n;
    let mut a = DMatrix::<f64>::zeros(rows, variables);
    let mut b = vec![0.0; rows];
    let mut cones: Vec<SupportedConeT<f64>> = vec![ZeroConeT(d), NonnegativeConeT(bounds + 1)];
    a.view_mut((0, factor), (d, 1)).copy_from(rate);
    for k in 0..d {
        b[k] = -base[k];
    }
    let (Bound::Each(most) | Bound::Total(most)) = bound;
    b[d..d + bounds].fill(most);
    // The factor is not negative.
    a[(d + bounds, factor)] = -1.0;
    for (i, (map, mu)) in contacts.iter().enumerate() {
        a.view_mut((0, c * i), (d, c)).copy_from(map);
        a[(d + if bounds == n { i } else { 0 }, c * i)] = 1.0;
        let cone = d + bounds + 1 + c * i;
        a[(cone, c * i)] = -mu;
        for axis in 1..c {
            a[(cone + axis, c * i + axis)] = -1.0;
        }
        cones.push(SecondOrderConeT(c));
    }
    let mut q = vec![0.0; variables];
    q[factor] = -1.0;
    let p = CscMatrix::zeros((variables, variables));
    let settings = DefaultSettingsBuilder::default().verbose(false).build().ok()?;
    let mut solver = DefaultSolver::new(&p, &q, &sparse(&a), &b, &cones, settings).ok()?;
    solver.solve();
    (solver.solution.status == SolverStatus::Solved).then(|| solver.solution.x[factor])
}
