//! The geometric stiffness, which the theory of small motions neglects. As the object turns, the arms of the forces under the base load turn with it.
//!
//! Let contact i carry the force F_i and move by u_i with the motion q of the object. The energy of the springs has a second derivative in two parts,
//! the elastic one and `-Σ F_i · ∂²u_i/∂q²`. For a rotation θ and arms r_i of the contacts the second part is `Σ (F·r) |θ|² - (F·θ)(r·θ)`, in the
//! plane `Σ F·r θ²`. Fingers that press against each other make it negative. This second part is compared with the work `W·q` of the load on the
//! motion, which equals `q·Kq` with the secant stiffness K of the grasp.

use crate::equilibrium::Equilibrium;
use crate::grasp::Engine;
use crate::numerics::{dot, summed};

impl Engine {
    /// The geometric stiffness as a fraction of the resistance to the motion q from the equilibrium `rest` under the base load to the equilibrium
    /// `there`, with the same commands: `Σ [(F·r) |θ|² - (F·θ)(r·θ)] / (ΔW·q)`. F are the contact forces in `rest`, and r their arms about the origin
    /// of twists, the centroid of the contacts. θ is the rotation in q, and ΔW the change of the load.
    ///
    /// The fraction is negative where the forces lower the resistance. The base load counts as acting at the point of its line nearest to the
    /// centroid. `None` if the size of the fraction is at most a tenth, for several bodies, and where `ΔW·q` is not positive.
    pub(super) fn left_out_by_small_motions(
        &self,
        rest: &Equilibrium<3>,
        there: &Equilibrium<3>,
    ) -> Option<f64> {
        if self.bodies().is_some() {
            return None;
        }
        let (load, twist) = (there.load - rest.load, there.twist.components());
        let moved = twist.iter().zip(rest.twist.components()).map(|(to, from)| to - from);
        let moved: alloc::vec::Vec<f64> = moved.collect();
        let kept: f64 = dot(&moved, load.components());
        let rotation = &moved[3..];
        let square: f64 = summed(rotation, &|x| x * x);
        let mut left_out = 0.0;
        for (contact, answer) in self.contacts().iter().zip(&rest.contacts) {
            let (force, arm) = (answer.force_world, contact.point - self.origin());
            left_out += force.dot(&arm) * square;
            let along =
                |v: &nalgebra::SVector<f64, 3>| v.iter().zip(rotation).map(|(a, b)| a * b).sum::<f64>();
            left_out -= along(&force) * along(&arm);
        }
        // Fractions up to a tenth are not returned. A smaller threshold would add a caution to ordinary verdicts; a larger one would hide a loss of
        // stability until it is near.
        (kept > 0.0).then(|| left_out / kept).filter(|part| part.abs() > 0.1)
    }
}
