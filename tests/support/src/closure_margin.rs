//! The largest distance from the edges of their friction cones at which contact forces balance each other, by an interior-point method (Clarabel).

use clarabel::algebra::CscMatrix;
use clarabel::solver::{
    DefaultSettingsBuilder, DefaultSolver, IPSolver, NonnegativeConeT, SecondOrderConeT, SolverStatus,
    SupportedConeT, ZeroConeT,
};
use nalgebra::DMatrix;

use super::interior_point::sparse;

/// The largest t with `Σ G_i f_i = 0`, `|f_t| <= μ f_n - t` and `f_n <= 1`. If the maps have full rank, t is positive exactly if the cones reach
/// every wrench. `None` if the method does not converge. `contacts` has the grasp map and the friction coefficient of each contact.
pub fn closure_margin(contacts: &[(DMatrix<f64>, f64)]) -> Option<f64> {
    let (d, c) = contacts.first()?.0.shape();
    let n = contacts.len();
    let variables = c * n + 1;
    let t = variables - 1;
    let rows = d + n + c * n;
    let mut a = DMatrix::<f64>::zeros(rows, variables);
    let mut b = vec![0.0; rows];
    let mut cones: Vec<SupportedConeT<f64>> = vec![ZeroConeT(d), NonnegativeConeT(n)];
    for (i, (map, mu)) in contacts.iter().enumerate() {
        a.view_mut((0, c * i), (d, c)).copy_from(map);
        a[(d + i, c * i)] = 1.0;
        b[d + i] = 1.0;
        let cone = d + n + c * i;
        a[(cone, c * i)] = -mu;
        a[(cone, t)] = 1.0;
        for axis in 1..c {
            a[(cone + axis, c * i + axis)] = -1.0;
        }
        cones.push(SecondOrderConeT(c));
    }
    let mut q = vec![0.0; variables];
    q[t] = -1.0;
    let p = CscMatrix::zeros((variables, variables));
    let settings = DefaultSettingsBuilder::default().verbose(false).build().ok()?;
    let mut solver = DefaultSolver::new(&p, &q, &sparse(&a), &b, &cones, settings).ok()?;
    solver.solve();
    (solver.solution.status == SolverStatus::Solved).then(|| solver.solution.x[t])
}
