//! The minimum power principle over one step, with the normal forces of friction **given**.
//!
//! In a step from rest the springs store energy, friction dissipates μ N_i |s_i|, and the load does work W·q. With given N_i
//!
//! ```text
//! minimise  Σ ½ k_n (a_n - n·u)²  +  Σ min over s of [½ k_t (a_t - t·u - s)² + μ N |s|]  -  W·q
//! ```
//!
//! is convex, and its minimum has `F_t = k_t (a_t - t·u)` cut off at ±μ N. It is Coulomb's law exactly if N_i is the normal force
//! of the answer.

use grasp_lcp::planar::{Grasp, Twist, Wrench};
use nalgebra::{Matrix3, Vector2, Vector3};

/// Motion of the object, and forces (F_n, F_t) of every contact.
pub struct Answer {
    /// Twist of the object.
    pub twist: Twist,
    /// Force of each contact, N.
    pub forces: Vec<Vector2<f64>>,
}

/// The minimum with given normal forces N. `None` if springs do not hold the object, or the method does not converge.
pub fn minimum_power(grasp: &Grasp, load: &Wrench, normal_forces: &[f64]) -> Option<Answer> {
    // Newton's method on a piecewise quadratic function: the step is exact once every contact is on its final piece.
    let mut q = Vector3::zeros();
    for _ in 0..100 {
        let mut stiffness = Matrix3::zeros();
        let mut missing = load.to_vector();
        let mut forces = Vec::new();
        for ((contact, frame), normal) in grasp.contacts().iter().zip(grasp.frames()).zip(normal_forces) {
            let (p, k, a) = (contact.point(), contact.series_stiffness_of_axes(), contact.commanded());
            let wrench_along = |axis: usize| {
                let e = frame.column(axis);
                Vector3::new(e[0], e[1], p[0] * e[1] - p[1] * e[0])
            };
            let (n, t) = (wrench_along(0), wrench_along(1));
            let pressed = k[0] * (a[0] - n.dot(&q));
            let (limit, sheared) = (contact.friction_coefficient() * normal, k[1] * (a[1] - t.dot(&q)));
            let force = Vector2::new(pressed.max(0.0), sheared.clamp(-limit, limit));
            if pressed > 0.0 {
                stiffness += n * n.transpose() * k[0];
            }
            if sheared.abs() < limit {
                stiffness += t * t.transpose() * k[1];
            }
            missing += n * force[0] + t * force[1];
            forces.push(force);
        }
        let step = stiffness.lu().solve(&missing)?;
        if step.amax() <= 1e-15 * (1e-3 + q.amax()) {
            return Some(Answer { twist: Twist::from_vector(q), forces });
        }
        q += step;
    }
    None
}
