//! Whether forces drive an object on along a motion that nothing resists. A part that two fingertips pinch below its centre of mass turns over,
//! although every contact sticks. A part that is pinched above its centre of mass hangs.
//!
//! Along such a free motion the springs store no energy. Therefore the potential of contact forces and loads alone determines the stability. Its
//! second derivative is the geometric stiffness K_g, which arises because the lever arms of forces turn with the object. If K_g is positive, a load W
//! moves the object by q until it hangs, with `K_g q = W` along the free motions. Example: a weight G hangs at the distance l below a hinge, and a
//! force F pulls it to the side. The weight then hangs at the angle `F l / (G l)` to the vertical. Motions are small within the limits of rotation,
//! slip and opening up to which the linear theory is trusted. A command is the displacement that a finger would make if there were no object.

use nalgebra::{DMatrix, SVector};

use super::verdict::Verdict;
use crate::contact::State;
use crate::equilibrium::{Equilibrium, StickingResponse, forces_in};
use crate::grasp::{Engine, Motion, Wrench};
use crate::load_path::Ramp;
use crate::numerics::tolerances::NEGLIGIBLE;
use crate::numerics::{Vector, every_index, largest, mapped, numbered, paired, symmetric_eigen, without};
use crate::prelude::*;
use crate::search::Settings;

impl Engine {
    /// A motion that nothing resists and along which forces drive the bodies on: the potential of contact forces and `load` falls as the bodies turn.
    /// The forces are those of the equilibrium `there`, the motion is a combination of its free motions.
    ///
    /// `None` if there is no such motion. Also `None` if the potential cannot be computed, because a vacuum acts or the point of action of a load is
    /// not known. Also `None` if a free motion moves a joint or shears a closed contact, whose potential would have to be included.
    pub(super) fn driven_on(&self, there: &Equilibrium<3>, load: &Wrench<3>) -> Option<Motion<3>> {
        let free = mapped(&there.local.free_motions, &|motion| motion.to());
        let (least, motion) = self.free_stiffness(&free, &forces_in(&there.contacts), load)?.pop()?;
        (least < 0.0).then(|| self.motion_outside(&motion))
    }

    /// Sets [`Verdict::swing`] for an object that is lost as soon as the load begins to act, unless commands change with the load. If the object
    /// swings to a new position, the proof `nothing_near` of the loss is removed. The proof takes the lever arms of the load as constant, but they
    /// change as the object swings.
    pub(super) fn let_swing(&self, verdict: &mut Verdict<3>, ramp: &Ramp<3>, settings: &Settings) {
        let is_load_alone = ramp.command_change.is_none() && ramp.joint_change.is_none();
        if verdict.held_to <= NEGLIGIBLE && verdict.holds() == Some(false) && is_load_alone {
            verdict.swing = self.swing(&ramp.load_at(1.0), settings);
        }
        if let (Some(_), Some(lost)) = (&verdict.swing, &mut verdict.lost) {
            lost.nothing_near = None;
        }
    }

    /// The small motion from rest to the position in which the object hangs under the whole `load`, along motions that nothing resists.
    ///
    /// `None` if the load does no work along such motions, or the object would hang only beyond small motions. Contacts carry the part of the load
    /// that does no work along these motions; `None` also if a contact slides or opens under this part.
    fn swing(&self, load: &Wrench<3>, settings: &Settings) -> Option<Motion<3>> {
        let sticking = StickingResponse::new(self, settings);
        let (free, whole) = (sticking.linear_problem.free_motions(), self.load_alone(load, "load").ok()?);
        let forces = sticking.forces(&self.offsets(), &without(whole.clone(), free)).ok()?;
        let mut each = sticking.edges.iter().zip(forces.of.iter().zip(&forces.sizes));
        let sticks = each.all(|(edges, (force, size))| edges.hold(force, *size));
        if !sticks || sticking.states.iter().any(State::is_open) {
            return None;
        }
        let forces = paired(self.sites(), &forces.of, &|(site, force)| site.frame * force);
        let mut sway = Vector::zeros();
        for (stiffness, motion) in self.free_stiffness(free, &forces, load)? {
            let drive = motion.dot(&whole);
            if stiffness > 0.0 {
                sway += motion * (drive / stiffness);
            } else if stiffness < 0.0 || drive.abs() > NEGLIGIBLE * whole.norm() {
                return None;
            }
        }
        let most = settings.small_motions.rotation;
        let turns_little = self.each_moves(&sway).iter().all(|body| body.twist.parts().1.size() <= most);
        let leans_little = |i: usize| {
            let lean = |length: f64| {
                [1, 2].map(|axis| self.across(i, axis).dot(&sway)).map(|x| x.abs() <= most * length)
            };
            self.rope(i).is_none_or(|length| lean(length) == [true; 2])
        };
        let rounding = NEGLIGIBLE * sway.norm();
        let seen = sway.map(|x| if x.abs() > rounding { x } else { 0.0 });
        (sway.norm() > 0.0 && turns_little && every_index(self.len(), &leans_little))
            .then(|| self.motion_outside(&seen))
    }

    /// The principal geometric stiffnesses of contact forces and `load` along the unit motions `free`, each with its motion, in descending order.
    /// Stiffnesses within rounding are set to zero. `None` if `free` is empty. Also `None` if the potential cannot be computed, because a vacuum
    /// acts, the point of action of a load is not known, or a free motion moves a joint or shears a closed contact.
    fn free_stiffness(
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
