//! What small motions leave out to first order: as the object turns, the forces at rest act on arms that turn with it.
//!
//! Springs that carry F already have the second derivative of their energy in two parts, that of their stiffness and `-Σ F_i · ∂²u_i/∂q²`, which is
//! `(F·r) |θ|² - (F·θ)(r·θ)` for a rotation θ, in the plane `F·r θ²` (see [`Stability`](crate::energy::Stability)). Fingers that press against each other make
//! it negative. Beside it stands the work of the load on the motion, that of the whole stiffness that resists.

use crate::equilibrium::Equilibrium;
use crate::grasp::Engine;
use crate::numerics::Size;

/// From this part of what resists on it is worth a word.
const WORTH_A_WORD: f64 = 0.1;

impl<D: Size, const C: usize> Engine<D, C> {
    /// What the forces at rest add to what resists the motion from there to another state of the same commands, as a part of it, where that is more than a
    /// tenth. A load at rest acts at the point of its line that is nearest to the contacts. Of several bodies nothing is told.
    pub(super) fn left_out_by_small_motions(
        &self,
        rest: &Equilibrium<C>,
        there: &Equilibrium<C>,
    ) -> Option<f64> {
        if self.bodies().is_some() {
            return None;
        }
        let (load, twist) = (there.load - rest.load, there.twist.components());
        let moved = twist.iter().zip(rest.twist.components()).map(|(to, from)| to - from);
        let moved: alloc::vec::Vec<f64> = moved.collect();
        let kept: f64 = moved.iter().zip(load.components()).map(|(q, w)| q * w).sum();
        let rotation = &moved[C..];
        let square: f64 = rotation.iter().map(|x| x * x).sum();
        let mut left_out = 0.0;
        for (contact, answer) in self.contacts().iter().zip(&rest.contacts) {
            let (force, arm) = (answer.force_world, contact.point - self.origin());
            left_out += force.dot(&arm) * square;
            if C == 3 {
                let along =
                    |v: &nalgebra::SVector<f64, C>| v.iter().zip(rotation).map(|(a, b)| a * b).sum::<f64>();
                left_out -= along(&force) * along(&arm);
            }
        }
        (kept > 0.0).then(|| left_out / kept).filter(|part| part.abs() > WORTH_A_WORD)
    }
}
