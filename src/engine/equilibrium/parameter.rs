//! Exact derivatives of forces and motion with respect to one datum (a given number of the grasp or its load), while contacts keep their states.
//!
//! In known contact states the contact law is linear: the contact force is `F_i = K_i (a_i - G_iᵀq)`, with the offset a_i (commanded displacement
//! minus clearance and slip), the grasp map G_i and the twist q. K_i depends on stiffness, friction and contact state. The derivative with respect to
//! any datum z takes one more solve with the same factors. W is the load, and v_i = a_i - G_iᵀq the stretch:
//!
//! ```text
//! dF_i = K_i (da_i - G_iᵀdq) + f_i,   f_i = (∂K_i/∂z) v_i,      Σ G_i dF_i + dW = 0
//! friction     sliding:  f = F_n p                     sticking: 0
//! stiffness    normal:   f = (e_n + μ p) F_n / k_n     tangential: f = e_a F_a/k_a minus its part across the facet
//! ```
//!
//! Here p is the friction force of a sliding contact divided by its limit μ F_n. e_a is the unit vector along axis a of the contact frame, e_n that
//! along the normal. F_a and F_n are the components of the contact force along these axes, k_a and k_n the stiffnesses. The "part across the facet"
//! is the part along the facet's normal: the contact slides along this normal, so that friction along it stays at its limit. The stretches v are
//! taken as F/k, so that no difference of large displacements is needed. A change dG_i of the grasp map (file `geometry`) changes the stretch by
//! `-dG_iᵀq` and the balance by `dG_i F_i`. A drive is the spring of a joint or tendon of a hand, with its force limit.

use nalgebra::SVector;

use super::geometry::{map_by_normal, map_by_point};
use super::sticking_response::StickingResponse;
use crate::contact::Mode;
use crate::grasp::Wrench;
use crate::numerics::tolerances::NEGLIGIBLE;
use crate::numerics::{Map, Vector, numbered};
use crate::object::ForcesAndTwist;
use crate::prelude::*;

/// One datum of a grasp or its load, with respect to which forces and motions of an equilibrium are differentiated.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Parameter {
    /// Coefficient of friction of a contact.
    Friction {
        /// Index of the contact, from 0.
        contact: usize,
    },
    /// Series stiffness of a contact, N/m.
    Stiffness {
        /// Index of the contact, from 0.
        contact: usize,
        /// The axis of the contact's frame: 0 normal, then the tangents.
        axis: usize,
    },
    /// Finger command of a contact, m. (A clearance is a normal command of the opposite sign.)
    Command {
        /// Index of the contact, from 0.
        contact: usize,
        /// The axis of the contact's frame: 0 normal, then the tangents.
        axis: usize,
    },
    /// Position of a contact, m, while its frame keeps its directions. Commands and clearance stay along the axes of the frame. Not available for a
    /// contact of a hand: if its position changed, joints would move it differently.
    Point {
        /// Index of the contact, from 0.
        contact: usize,
        /// The coordinate axis along which the point moves, from 0.
        axis: usize,
    },
    /// Direction of the normal of a contact, rad: the whole contact frame turns about the contact point. Stiffness, command, clearance and slip keep
    /// their components along the axes of this frame, and so turn with it. Commands of joints do not change.
    Normal {
        /// Index of the contact, from 0.
        contact: usize,
        /// The tangent towards which the normal tilts, given by its axis in the contact frame: 1, in space also 2. In space 0 means a rotation about
        /// the normal, from t₁ to t₂.
        axis: usize,
    },
    /// Command of a joint of the hand or of a tendon, rad or m.
    JointCommand {
        /// Index of the joint, from 0, finger by finger. Tendons are counted after all joints.
        joint: usize,
    },
    /// Stiffness of the own spring of a joint or of a tendon, N m/rad or N/m.
    JointStiffness {
        /// Index of the joint, from 0, finger by finger. Tendons are counted after all joints.
        joint: usize,
    },
    /// Force limit of the drive of a joint or tendon, N m or N: greatest torque or force of a joint, or greatest tension of a tendon.
    JointLimit {
        /// Index of the joint, from 0, finger by finger. Tendons are counted after all joints.
        joint: usize,
    },
    /// Component of the load on the object: forces first (N), then moments about the origin (N m).
    Load {
        /// Index of the component, from 0.
        component: usize,
    },
}

impl StickingResponse<'_> {
    /// The derivatives of contact forces and twist of the equilibrium `state` with respect to the datum `by`, one given number of grasp or load.
    /// `None` if the grasp has no such datum, or if after a small change of the datum no forces balance in the present contact states.
    pub(crate) fn derivative(&self, state: &ForcesAndTwist, by: Parameter) -> Option<ForcesAndTwist> {
        let ForcesAndTwist { forces, twist } = state;
        let mut offsets = self.at_rest();
        let mut wrench = Vector::zeros();
        let mut direct: Vec<(usize, SVector<f64, 3>)> = Vec::new();
        let (contacts, actuators) = (self.grasp.len(), self.grasp.joint_commands().len());
        match by {
            Parameter::Friction { contact } if contact < contacts => {
                direct.push((contact, self.by_friction(contact, &forces[contact])));
            }
            Parameter::Stiffness { contact, axis }
                if contact < contacts && axis < self.grasp.space().axes() =>
            {
                direct.push((contact, self.by_stiffness(contact, axis, &forces[contact])));
            }
            Parameter::Command { contact, axis }
                if contact < contacts && axis < self.grasp.space().axes() =>
            {
                offsets[contact][axis] = 1.0;
            }
            Parameter::JointCommand { joint } if joint < actuators => {
                let unit: Vec<f64> = numbered(actuators, &|k| f64::from(u8::from(k == joint)));
                offsets = self.grasp.offset_changes(None, Some(&unit));
            }
            Parameter::JointStiffness { joint } if joint < actuators => {
                for (site, drive) in self.grasp.drives_of(joint) {
                    let state = &self.states[site];
                    if !state.is_open() && !state.slides() {
                        direct.push((site, drive.by_stiffness(&forces[site])));
                    }
                }
            }
            Parameter::JointLimit { joint } if joint < actuators => {
                for (site, drive) in self.grasp.drives_of(joint) {
                    let held;
                    (offsets[site], held) = drive.by_limit();
                    wrench += held;
                }
            }
            Parameter::Point { contact, .. } | Parameter::Normal { contact, .. } if contact < contacts => {
                let change = self.map_change(contact, by)?;
                offsets[contact] = -change.tr_mul(twist);
                let mut force = forces[contact];
                force[0] -= self.grasp.contacts()[contact].suction;
                wrench = &change * force;
            }
            Parameter::Load { component } if component < self.grasp.space().of_the_object() => {
                let mut unit = Vector::zeros();
                unit[component] = 1.0;
                wrench = self.grasp.inside_unchecked(&Wrench::among(self.grasp.space(), &unit));
            }
            _ => return None,
        }
        for (site, f) in &direct {
            wrench += &self.problem.sites[*site].map * f;
        }
        let mut solved = self.state(&offsets, &wrench)?;
        for (site, f) in direct {
            solved.forces[site] += f;
        }
        Some(solved)
    }

    /// The derivative of one contact's normal stretch with respect to the datum `by`, m per unit. `twist` is the twist, and `change` its derivative.
    /// `None` if `by` is the point or normal of this contact, and the contact's grasp map has no derivative with respect to it.
    pub(crate) fn normal_stretch_derivative(
        &self,
        contact: usize,
        twist: &Vector,
        change: &Vector,
        by: Parameter,
    ) -> Option<f64> {
        let own = match by {
            Parameter::Command { contact: of, axis: 0 } if of == contact => 1.0,
            Parameter::Point { contact: of, .. } | Parameter::Normal { contact: of, .. } if of == contact => {
                -self.map_change(contact, by)?.tr_mul(twist)[0]
            }
            _ => 0.0,
        };
        Some(self.normal_stretch(contact, own, change))
    }

    /// The derivative of one contact's grasp map with respect to the position of its point (per metre) or the direction of its normal (per radian).
    /// `None` if the axis is out of range, and for the position of a contact of a hand. `None` also if springs resist a motion in the changed
    /// geometry that is free at present: the derivative of that motion is then not defined.
    fn map_change(&self, contact: usize, by: Parameter) -> Option<Map> {
        let site = &self.problem.sites[contact];
        let change = match by {
            Parameter::Point { axis, .. }
                if axis < self.grasp.space().axes() && self.grasp.linkage().is_none() =>
            {
                map_by_point(site, axis, self.grasp.length())
            }
            Parameter::Normal { axis, .. } => map_by_normal(site, axis)?,
            _ => return None,
        };
        let stays_free = |motion: &Vector| {
            let mut offsets = self.at_rest();
            offsets[contact] = change.tr_mul(motion);
            let alone = self.problem.local(contact).springs.stiffest() * change.norm() * motion.norm();
            let response = self.state(&offsets, &Vector::zeros());
            // A free motion, which no spring resists, stays free if the forces that it causes in the changed geometry are only rounding. Forces up to
            // the fraction `NEGLIGIBLE` of `alone` count as rounding. If nothing else gives way, `alone` is an upper bound of the force that the
            // displacement causes in the stiffest spring of the contact.
            response.is_some_and(|response| {
                response.forces.iter().all(|force| force.norm() <= NEGLIGIBLE * alone)
            })
        };
        self.linear_problem.free_motions().iter().all(stays_free).then_some(change)
    }

    /// The derivative of a contact's force with respect to its coefficient of friction μ, at constant spring stretches v. It is (∂K/∂μ) v, with the
    /// tangent stiffness K of the contact.
    fn by_friction(&self, contact: usize, force: &SVector<f64, 3>) -> SVector<f64, 3> {
        let state = &self.states[contact];
        if !state.slides() {
            return SVector::zeros();
        }
        self.problem.local(contact).edge(state).pull * force[0]
    }

    /// The derivative of a contact's force with respect to its stiffness k along one axis, at constant spring stretches v. It is (∂K/∂k) v, with the
    /// tangent stiffness K of the contact.
    fn by_stiffness(&self, contact: usize, axis: usize, force: &SVector<f64, 3>) -> SVector<f64, 3> {
        let local = self.problem.local(contact);
        let state = &self.states[contact];
        let mut f = SVector::zeros();
        if axis >= local.springs.axes() || state.is_open() {
            return f;
        }
        let stretch = local.springs.deflection_along(axis, force[axis]);
        if state.is_sticking() {
            f[axis] = stretch;
        } else if axis == 0 {
            f = local.edge(state).pull * local.cone().limit(stretch);
            f[0] = stretch;
        } else if !matches!(state, Mode::Corner(_))
            && let Some(h) = local.outward(state)
        {
            // The change of force along the axis, minus its part along the facet normal h. Slip along h takes up this part, so that friction along h
            // stays at its limit. On the round cone slip also reduces the stiffness across the direction of sliding.
            let softened =
                state.slide().map_or(stretch, |slide| stretch * local.springs.softening(axis, slide.lambda));
            f = local.edge(state).pull * (-h[axis] * softened);
            f[axis] += softened;
        }
        f
    }
}
