//! Residual of Coulomb's law in a frictional contact problem, recomputed from the data.

use grasp_lcp::friction::FrictionProblem;
use nalgebra::DVector;

/// The worst violation of Coulomb's law by forces r, in de Saxcé's form. At each contact: no approach, the force in its cone, and r·û = 0, so that
/// friction opposes slip. Velocities are relative to the terms of `W r + q` at the contact, forces to the force of the contact.
pub fn missed_law<const C: usize>(problem: &FrictionProblem<C>, r: &DVector<f64>) -> f64 {
    let u = problem.matrix() * r + problem.vector();
    let terms = problem.matrix().abs() * r.abs() + problem.vector().abs();
    let mut worst: f64 = 0.0;
    for (i, mu) in problem.friction().iter().enumerate() {
        let (force, velocity) = (r.rows(C * i, C), u.rows(C * i, C));
        let size = terms.rows(C * i, C).amax();
        worst = worst.max(-velocity[0] / size);
        if force.norm() > 0.0 {
            worst = worst.max((force.rows(1, C - 1).norm() - mu * force[0]) / force.norm());
            let power = force.dot(&velocity) + mu * velocity.rows(1, C - 1).norm() * force[0];
            worst = worst.max(power.abs() / (force.norm() * size));
        }
    }
    worst
}
