//! Gross slip: where the object is lost, and exact derivatives where normal forces stay.
//!
//! Where the last motion q̇ lifts nothing, the virtual work of all forces on it is that of friction: `(W₀ + λ W)·q̇ = Σ μ_i N_i |v_i|`. At any nearby data
//! the forces there do as much on this motion, to second order in how the directions of slip turn. So where the normal forces are those of rest
//!
//! ```text
//! dλ = Σ |v_i| d(μ_i N_i) / (W·q̇)
//! ```

use core::f64::consts::TAU;

use nalgebra::{SMatrix, SVector};

use super::model::{NoSlip, Predicted, SlipToPredict};
use super::slip::Grown;
use super::unknown::UnknownKind;
use crate::equilibrium::{ContactState, Equilibrium};
use crate::error::Error;
use crate::grasp::{Contact, Twist, Wrench};
use crate::load_path::{Leg, Parameter, PathEnd};
use crate::prelude::*;

/// What is this small beside the largest, a force or a velocity, is none: the derivative is off by as much.
const NONE: f64 = 1e-6;

/// Where the object is lost.
pub(super) fn predicted<const C: usize>(
    seen: &SlipToPredict<'_, C>,
) -> Result<Result<Predicted, NoSlip>, Error> {
    let (start, leg, most) = match &seen.slip.grown {
        Grown::Load(load) => {
            let most = seen.grasp.settings().most_load.max(1.0);
            (seen.base, Leg::load_by(*load * most), most)
        }
        Grown::Turn(turn) => {
            let most = turn.angle().max(TAU);
            let around = turn.beside(seen.base).up_to(most);
            (around.load_at(0.0), Leg::turn(&around), most)
        }
    };
    let mut path = seen.grasp.follow(&start, &[leg])?;
    let at_rest = seen.derivatives.then(|| path.state()).flatten();
    path.by_ref().for_each(drop);
    Ok(match path.end() {
        Some(PathEnd::Lost(loss)) => {
            let at = loss.fraction * most;
            let motion = loss.motion.as_ref().filter(|_| loss.drives.is_empty() && loss.jumped.is_empty());
            let exact = at_rest.zip(motion).and_then(|(rest, motion)| {
                Lost { seen, at, rest, motion: motion.object, forces: path.forces() }.derivatives()
            });
            Ok(Predicted { at, exact })
        }
        Some(PathEnd::Completed) => Err("it is not lost as far as it was followed"),
        Some(PathEnd::NoStart(_)) => Err("nothing holds where it begins"),
        Some(PathEnd::Undecided { .. }) | None => Err("it is not known where it is lost"),
    })
}

/// A loss, from the state at rest to the motion with which the object leaves.
struct Lost<'a, 's, const C: usize> {
    seen: &'a SlipToPredict<'s, C>,
    at: f64,
    rest: Equilibrium<C>,
    motion: Twist<C>,
    forces: Vec<SVector<f64, C>>,
}

impl<const C: usize> Lost<'_, '_, C> {
    /// Of the logarithm of the factor. `None` where another law would have to say.
    fn derivatives(&self) -> Option<Vec<f64>> {
        let load = self.seen.load()?;
        let settings = self.seen.grasp.settings();
        if (C > 2 && !settings.round) || !self.seen.is_pressed_by_commands() {
            return None;
        }
        let slips = self.slip_rates()?;
        let power = dot(load, &self.motion);
        let limits = self.limits();
        let worked: f64 = limits.iter().zip(&slips).map(|(limit, slip)| limit * slip).sum();
        // What was found is what this law says, else it is none of this law.
        let told = (worked - dot(&self.seen.base, &self.motion)) / power;
        let is_this_law = (told - self.at).abs() <= NONE * self.at;
        if !is_this_law {
            return None;
        }
        self.seen.by_unknowns(|kind, unknown, value| {
            let changes = self.limit_changes(kind, unknown, value)?;
            let work: f64 = changes.iter().zip(&slips).map(|(change, slip)| change * slip).sum();
            Some(work / (power * self.at))
        })
    }

    /// How fast each contact that presses slips, for one unit of the motion. `None` where one of them opens or is pressed on, or where normal forces are not
    /// those of rest, or something slid there.
    fn slip_rates(&self) -> Option<Vec<f64>> {
        let largest = self.forces.iter().map(|force| force[0]).fold(0.0, f64::max);
        let contacts = self.seen.grasp.contacts().iter().zip(self.seen.grasp.frames());
        let velocity = |(contact, frame): (&Contact<C>, &SMatrix<f64, C, C>)| {
            SVector::<f64, C>::from_fn(|axis, _| {
                let unit = Wrench::force_through(&contact.point, &frame.column(axis).into_owned());
                dot(&unit, &self.motion)
            })
        };
        let velocities: Vec<_> = contacts.map(velocity).collect();
        let fastest = velocities.iter().map(SVector::norm).fold(0.0, f64::max);
        let rate = |(i, v): (usize, &SVector<f64, C>)| {
            let [here, rest] = [self.forces[i][0], self.rest.contacts.get(i)?.force[0]];
            let slid = matches!(self.rest.contacts[i].state, ContactState::Sliding { .. });
            let stays = (here - rest).abs() <= NONE * largest && !slid;
            if here <= NONE * largest && stays {
                return Some(0.0);
            }
            (stays && v[0].abs() <= NONE * fastest).then(|| v.rows_range(1..).norm())
        };
        velocities.iter().enumerate().map(rate).collect()
    }

    /// What friction each contact can carry at most, N.
    fn limits(&self) -> Vec<f64> {
        let contacts = self.seen.grasp.contacts().iter();
        contacts.zip(&self.forces).map(|(contact, force)| contact.friction * force[0]).collect()
    }

    /// How these limits change with the logarithm of an unknown.
    fn limit_changes(&self, kind: UnknownKind, unknown: usize, value: f64) -> Option<Vec<f64>> {
        let grasp = self.seen.grasp;
        let contacts = grasp.contacts();
        let mut changes = vec![0.0; grasp.len()];
        let of_rest = |by: Parameter, times: f64, changes: &mut Vec<f64>| {
            let derivative = grasp.sensitivity().of(&self.rest, by)?;
            let forces = contacts.iter().zip(&derivative.forces);
            changes.iter_mut().zip(forces).for_each(|(change, (contact, force))| {
                *change += contact.friction * force[0] * times;
            });
            Some(())
        };
        let limits = self.limits();
        for i in self.seen.contacts_of(unknown) {
            match kind {
                UnknownKind::Friction => changes[i] += limits[i],
                UnknownKind::Carried => changes[i] += contacts[i].friction * value,
                UnknownKind::Squeeze => {
                    let all = self.seen.asked.unknowns[unknown].contacts.is_none();
                    for axis in 0..if all { C } else { 1 } {
                        let times = contacts[i].command[axis];
                        if times != 0.0 {
                            of_rest(Parameter::Command { contact: i, axis }, times, &mut changes)?;
                        }
                    }
                }
                UnknownKind::Stiffness => {
                    for axis in 1..C {
                        let times = contacts[i].stiffness.series()[axis];
                        of_rest(Parameter::Stiffness { contact: i, axis }, times, &mut changes)?;
                    }
                }
            }
        }
        Some(changes)
    }
}

/// Work of a load on a motion.
fn dot<const C: usize>(load: &Wrench<C>, motion: &Twist<C>) -> f64 {
    load.components().iter().zip(motion.components()).map(|(w, q)| w * q).sum()
}
