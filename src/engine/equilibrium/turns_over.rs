//! Whether forces drive an object on along a motion that nothing resists. A part that two fingertips pinch below its centre of mass turns over,
//! although every contact sticks. A part that is pinched above its centre of mass hangs.
//!
//! Along such a free motion the springs store no energy. Therefore the potential of contact forces and loads alone determines the stability. Its
//! second derivative is the geometric stiffness K_g, which arises because the lever arms of forces turn with the object.

use nalgebra::{DMatrix, SVector};

use super::answer::Equilibrium;
use super::left_out::forces_in;
use crate::grasp::{Engine, Motion, Wrench};
use crate::numerics::tolerances::NEGLIGIBLE;
use crate::numerics::{Vector, every_index, largest, mapped, numbered, symmetric_eigen};
use crate::prelude::*;

impl Engine {
    /// A motion that nothing resists and along which forces drive the bodies on: the potential of contact forces and `load` falls as the bodies turn.
    /// The forces are those of the equilibrium `there`, the motion is a combination of its free motions.
    ///
    /// `None` if there is no such motion. Also `None` if the potential cannot be computed, because a vacuum acts or the point of action of a load is
    /// not known. Also `None` if a free motion moves a joint or shears a closed contact, whose potential would have to be included.
    pub(crate) fn driven_on(&self, there: &Equilibrium<3>, load: &Wrench<3>) -> Option<Motion<3>> {
        let free = mapped(&there.local.free_motions, &|motion| motion.to());
        self.driven_along(&free, &forces_in(&there.contacts), load)
    }

    /// [`Self::driven_on`] for these contact forces, N, along the coordinate axes, and these free motions.
    pub(crate) fn driven_along(
        &self,
        free: &[Vector],
        forces: &[SVector<f64, 3>],
        load: &Wrench<3>,
    ) -> Option<Motion<3>> {
        let (least, motion) = self.free_stiffness(free, forces, load)?.pop()?;
        (least < 0.0).then(|| self.motion_outside(&motion))
    }

    /// The principal geometric stiffnesses of contact forces and `load` along the unit motions `free`, each with its motion, in descending order.
    /// Stiffnesses within rounding are set to zero. `None` if `free` is empty. Also `None` if the potential cannot be computed, because a vacuum
    /// acts, the point of action of a load is not known, or a free motion moves a joint or shears a closed contact.
    pub(crate) fn free_stiffness(
        &self,
        free: &[Vector],
        forces: &[SVector<f64, 3>],
        load: &Wrench<3>,
    ) -> Option<Vec<(f64, Vector)>> {
        if free.is_empty()
            || self.vacuum().is_some()
            || !self.acts_at_known_points(load)
            || !free.iter().all(|motion| self.turns_in_place(forces, motion))
        {
            return None;
        }
        let (all, count) = (self.geometric_stiffness(forces, load), free.len());
        let (values, parts) =
            symmetric_eigen(&DMatrix::from_fn(count, count, |k, l| free[k].dot(&(&all * &free[l]))));
        // A geometric stiffness (N/m) smaller than this number is due to rounding of forces and lever arms.
        let rounding = NEGLIGIBLE * largest(forces, &SVector::norm) / self.length();
        let motion = |k: usize| (0..count).fold(Vector::zeros(), |sum, l| sum + &free[l] * parts[(l, k)]);
        let of = |k: usize| (if values[k].abs() > rounding { values[k] } else { 0.0 }, motion(k));
        Some(numbered(count, &of))
    }

    /// Whether a unit motion moves no joint, and moves no contact that carries a force relative to its finger. Ropes and springs may swing.
    fn turns_in_place(&self, forces: &[SVector<f64, 3>], motion: &Vector) -> bool {
        // A displacement of the contact within rounding of the displacements that a unit motion causes counts as none.
        let is_still = |i: usize| {
            let site = &self.sites()[i];
            site.map.tr_mul(motion).norm() <= NEGLIGIBLE * site.span_moved(&SVector::zeros(), 1.0)
        };
        self.motion_outside(motion).joints.iter().all(|joint| *joint == 0.0)
            && every_index(self.len(), &|i| forces[i].norm() == 0.0 || self.rope(i).is_some() || is_still(i))
    }
}
