//! The geometric stiffness, which small motions leave out: as the object turns, the arms of the forces at rest turn with it.
//!
//! The energy of springs that already carry F has a second derivative in two parts, the elastic one and `-Σ F_i · ∂²u_i/∂q²`. For a rotation θ the
//! second part is `Σ (F·r) |θ|² - (F·θ)(r·θ)`, in the plane `Σ F·r θ²`. Fingers that press against each
//! other make it negative. It is compared with `W·q`, the work of the load on the motion, which is `q·Kq` for the secant stiffness K that resists.

use crate::equilibrium::Equilibrium;
use crate::grasp::Engine;
use crate::numerics::{dot, summed};

impl Engine {
    /// The geometric stiffness as a fraction of the resistance to the motion q from rest to another state with the same commands:
    /// `Σ [(F·r) |θ|² - (F·θ)(r·θ)] / (ΔW·q)`, with forces F at rest, arms r about the centroid of the contacts and the rotation θ of q.
    ///
    /// It is negative where the forces lower the resistance. A load at rest counts as acting at the point of its line nearest to the centroid. `None`
    /// if the fraction is at most a tenth, for several bodies, and where the load does no positive work.
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
        // Fractions up to a tenth are not reported. A smaller threshold would add a caution to ordinary verdicts; a larger one would hide a loss of
        // stability until it is near.
        (kept > 0.0).then(|| left_out / kept).filter(|part| part.abs() > 0.1)
    }
}
