//! Coulomb's law of a frictional contact problem, recomputed.

use grasp_lcp::friction::FrictionProblem;
use nalgebra::DVector;

/// How far forces miss it in the form of de Saxcé, at each contact beside its own sums: no approach, forces in their cones, and slips against
/// them, as r·û = 0.
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
