//! The small motion with which an object swings until its load hangs, if nothing resists this motion.
//!
//! Along such a free motion the potential of contact forces and loads alone resists. If its second derivative K_g is positive, a load W moves the object
//! by q until it hangs, with `K_g q = W` along the free motions. Example: a weight G hangs at the distance l below a hinge, and a force F pulls it to
//! the side. The weight then hangs at the angle `F l / (G l)` to the vertical. Motions are small within the limits of rotation, slip and opening up to
//! which the linear theory is trusted. A command is the displacement that a finger makes if there is no object.

use super::verdict::Verdict;
use crate::contact::State;
use crate::equilibrium::StickingResponse;
use crate::grasp::{Engine, Motion, Wrench};
use crate::load_path::Ramp;
use crate::numerics::tolerances::NEGLIGIBLE;
use crate::numerics::{Vector, every_index, paired, without};
use crate::search::Settings;

impl Engine {
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
            // The drive of a motion that the load does not drive is rounding.
            if drive.abs() <= NEGLIGIBLE * whole.norm() && stiffness >= 0.0 {
                continue;
            }
            if stiffness > 0.0 {
                sway += motion * (drive / stiffness);
            } else {
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
}
