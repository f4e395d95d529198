//! Checks of answers in space, computed from the data of the question alone, without the solver.

use grasp_lcp::spatial::{ContactState, Equilibrium, Grasp, Wrench};
use nalgebra::{Vector3, Vector6};

use support::Failure;
use support::loaded::Scene;

/// The onset of sliding, from two states in which everything sticks and a quadratic equation for each contact.
pub(crate) fn onset_by_hand(scene: &Scene) -> Result<f64, Failure> {
    let (from, to) = (scene.trial(0.0)?, scene.trial(1.0)?);
    let mut first = f64::INFINITY;
    for (i, contact) in scene.contacts.iter().enumerate().filter(|(i, _)| !scene.is_hand(*i)) {
        let (f, change) = (from.contacts[i].force, to.contacts[i].force - from.contacts[i].force);
        let mu = contact.friction_coefficient();
        // The load factor τ at which the force f + τ f' reaches the friction cone: |f_t + τ f'_t|² = μ² (f_n +
        // τ f'_n)², that is a τ² + 2b τ + c = 0.
        let a = change.yz().norm_squared() - (mu * change[0]).powi(2);
        let b = f.yz().dot(&change.yz()) - mu * mu * f[0] * change[0];
        let c = f.yz().norm_squared() - (mu * f[0]).powi(2);
        let root = (b * b - a * c).max(0.0).sqrt();
        // Both roots, computed without cancellation; inside the cone c < 0.
        let q = -b - root.copysign(b);
        for factor in [q / a, c / q] {
            if factor > 0.0 {
                first = first.min(factor);
            }
        }
    }
    Ok(first)
}

/// The largest violation of balance and of the round contact law, relative to the largest force.
pub(crate) fn residual(grasp: &Grasp, load: &Wrench, answer: &Equilibrium) -> f64 {
    let size = largest_force(answer);
    let (mut worst, mut missing) = (0.0_f64, load.to_vector());
    let mut arm = 0.0_f64;
    for ((contact, frame), c) in grasp.contacts().iter().zip(grasp.frames()).zip(&answer.contacts) {
        let (p, k, mu) =
            (contact.point(), contact.series_stiffness_of_axes(), contact.friction_coefficient());
        let u = frame.tr_mul(&Vector3::from(answer.twist.displacement_at(p)));
        let held = k.component_mul(&(contact.commanded() - u));
        // The force K s by which the slip s has relaxed the tangential springs, N.
        let slipped = (held - c.force).yz();
        let friction = c.force.yz();
        let violation = match c.state {
            ContactState::Sliding { .. } => {
                let along = friction.normalize();
                let slip = slipped.component_div(&k.yz());
                let across = k[1].min(k[2]) * slip.perp(&along).abs();
                let backwards = (-slip.dot(&along)).max(0.0) * k[1].min(k[2]);
                (friction.norm() - mu * c.force[0])
                    .abs()
                    .max(across)
                    .max(backwards)
                    .max((held - c.force)[0].abs())
            }
            ContactState::Sticking => (held - c.force).norm(),
            _ => held[0].max(0.0) + c.force.norm(),
        };
        worst = worst.max(violation);
        let force = frame * c.force;
        let moment = p.cross(&force);
        missing += Vector6::new(force.x, force.y, force.z, moment.x, moment.y, moment.z);
        arm = arm.max(p.norm());
    }
    let forces = missing.fixed_rows::<3>(0).norm();
    let moments = missing.fixed_rows::<3>(3).norm() / arm;
    worst.max(forces).max(moments) / size
}

fn largest_force(answer: &Equilibrium) -> f64 {
    answer.contacts.iter().map(|c| c.force.norm()).fold(0.0, f64::max)
}

/// The largest difference of a contact force relative to the largest force.
pub(crate) fn difference(answer: &Equilibrium, exact: &Equilibrium) -> f64 {
    let pairs = answer.contacts.iter().zip(&exact.contacts);
    pairs.map(|(a, b)| (a.force_world - b.force_world).norm()).fold(0.0, f64::max) / largest_force(exact)
}
