//! A load program in progress: its legs, and the loads and commands at the beginning and the end of the present leg. Along a leg, load and commands
//! change linearly, or the load turns. The drives of a hand (the springs of its joints and tendons, with their force limits) have commands, too, and
//! are treated like contacts.

use alloc::sync::Arc;

use nalgebra::{Matrix, SVector};

use super::body_loads::BodyLoads;
use super::held_torques::HeldTorques;
use super::leg::{Leg, LegGoal};
use super::trajectory::Trajectory;
use super::turn::inside;
use crate::error::Error;
use crate::grasp::{Engine, Wrench};
use crate::numerics::{IntoList, Vector, largest, mapped, paired};
use crate::prelude::*;

/// A load program in progress. The fraction of the present leg that is done is not stored here.
#[derive(Debug, Clone)]
pub(super) struct Program {
    /// The legs, except those that were already complete when legs were last added.
    legs: Vec<Leg<3>>,
    /// Number of complete legs that were removed from `legs`.
    done: usize,
    /// The index of the present leg among all legs, from 0. When all legs are complete, it equals their number.
    pub(super) leg: usize,
    /// The load as a function of the fraction of the present leg that is done.
    pub(super) trajectory: Trajectory<Wrench<3>>,
    /// The program's load at the end of the present leg.
    goal: Wrench<3>,
    /// Commands of all contacts at the beginning and at the end of the present leg, m, in the contact frames.
    pub(super) commands: [Vec<SVector<f64, 3>>; 2],
    /// Commands of joints, then tendons, at the beginning and at the end of the present leg, rad or m.
    joints: [Vec<f64>; 2],
    /// Names of the bodies, if there are several, else empty.
    names: Vec<Arc<str>>,
    /// The loads on single bodies, in addition to the program's load, at the beginning and at the end of the present leg.
    pub(super) bodies: BodyLoads,
    /// The constant torques on the joints of the hand before the program begins, N m or N. They act in addition to the drives.
    held: Vec<f64>,
    /// The constant torques on the joints at the beginning and at the end of the present leg. Empty as long as no leg has changed them; the torques
    /// are then those before the program begins.
    pub(super) torques: HeldTorques,
}

impl Program {
    /// A program without legs, under the load `start` and the commands of the grasp.
    pub(super) fn new(grasp: &Engine, start: Wrench<3>) -> Self {
        let commands: Vec<_> = mapped(grasp.contacts(), &|c| c.command);
        let joints = grasp.joint_commands().to_vec();
        Self {
            legs: Vec::new(),
            done: 0,
            leg: 0,
            trajectory: Trajectory::Straight { from: start, rate: Wrench::ZERO },
            goal: start,
            commands: [commands.clone(), commands],
            joints: [joints.clone(), joints],
            names: grasp.bodies().map_or_else(Vec::new, |bodies| bodies.names.clone()),
            bodies: BodyLoads::default(),
            held: grasp.held_torques(),
            torques: HeldTorques::default(),
        }
    }

    /// Appends legs. If a leg is invalid, returns an error and appends none.
    pub(super) fn extend(&mut self, grasp: &Engine, legs: &[Leg<3>]) -> Result<(), Error> {
        // All legs are checked first, so that either all or none are appended.
        let mut load = self.goal;
        for leg in self.legs.iter().skip(self.leg - self.done + 1) {
            load = leg.load.trajectory(&load).1;
        }
        for (leg, k) in legs.iter().zip(self.done + self.legs.len()..) {
            leg.check(grasp)?;
            drop(leg.of_points(grasp)?);
            leg.load.check_beginning(&load, k, grasp.space())?;
            load = leg.load.trajectory(&load).1;
        }
        // Legs that are complete are removed, so that a program to which legs are added endlessly needs no more storage.
        self.legs.drain(..(self.leg - self.done).min(self.legs.len()));
        self.done = self.leg;
        // Each leg is converted to a leg with one command for each contact point. The checks above have made these legs already, but have not stored
        // them, because another list is needed for that.
        for leg in legs {
            self.legs.push(leg.of_points(grasp)?);
        }
        Ok(())
    }

    /// Begins the leg with the index `leg`. Its load, commands and torques start from their values at the end of the leg before. Returns false if
    /// there is no such leg.
    pub(super) fn begin_leg(&mut self) -> bool {
        let Some(leg) = self.legs.get(self.leg - self.done) else { return false };
        (self.trajectory, self.goal) = leg.load.trajectory(&self.goal);
        leg.commands.append(&mut self.commands);
        leg.joints.append(&mut self.joints);
        self.bodies.append(&self.names, &leg.bodies);
        self.torques.append(&self.held, &leg.torques);
        true
    }

    /// Checks that load, commands, body loads and joint torques at the end of the program equal those at its beginning. They may differ by the
    /// fraction `part` of their largest component along the program.
    ///
    /// # Errors
    /// [`Error::NotClosed`] naming the quantity that differs at the end.
    pub(super) fn check_closed(&self, part: f64) -> Result<(), Error> {
        let mut after = self.clone();
        let (load, [commands, _], [joints, _]) =
            (self.trajectory.at(0.0), self.commands.clone(), self.joints.clone());
        let largest_of = |numbers: &[f64]| largest(numbers, &|x| x.abs());
        let size = |load: &Wrench<3>| largest_of(load.components());
        let on_bodies = |bodies: &BodyLoads, end: usize| largest(bodies.at_end(end), &size);
        let mut most = [
            size(&load),
            largest(&commands, &Matrix::amax),
            largest_of(&joints),
            on_bodies(&self.bodies, 0),
            largest_of(&self.held),
        ];
        let mut has_leg = after.has_leg();
        while has_leg {
            most[0] = most[0].max(size(&after.goal)).max(size(&after.trajectory.at(0.5)));
            most[1] = most[1].max(largest(&after.commands[1], &Matrix::amax));
            most[2] = most[2].max(largest_of(&after.joints[1]));
            most[3] = most[3].max(on_bodies(&after.bodies, 1));
            most[4] = most[4].max(largest_of(after.torques.at_end(1)));
            has_leg = after.next_leg();
        }
        let off = [
            size(&(after.goal - load)),
            largest_of(&paired(&after.commands[1], &commands, &|(end, start)| (end - start).amax())),
            largest_of(&paired(&after.joints[1], &joints, &|(end, start)| end - start)),
            // A program begins without loads on single bodies, so such loads must be zero at its end.
            on_bodies(&after.bodies, 1),
            largest_of(&paired(after.torques.at_end(1), &self.held, &|(end, start)| end - start)),
        ];
        let what =
            ["load", "commands of contacts", "commands of joints", "load of a body", "torques of joints"];
        match (0..what.len()).find(|&k| off[k] > part * most[k]) {
            Some(k) => Err(Error::NotClosed { what: what[k], off: off[k] }),
            None => Ok(()),
        }
    }

    /// Called after the last leg of a closed program, whose load and commands return to their values at the beginning. Sets the load at its end to
    /// `load`, and commands, body loads and joint torques to their values before the program. This removes rounding errors.
    pub(super) fn return_to(&mut self, grasp: &Engine, load: &Wrench<3>) {
        self.goal = *load;
        self.commands[1] = mapped(grasp.contacts(), &|contact| contact.command);
        self.joints[1] = grasp.joint_commands().to_vec();
        self.bodies = BodyLoads::default();
        self.torques = HeldTorques::default();
    }

    /// Whether commands and joint torques stay along all legs. False if legs are known no longer, because more were appended once they were done.
    pub(super) fn changes_loads_alone(&self) -> bool {
        let stays = |leg: &Leg<3>| {
            leg.commands == LegGoal::Stay
                && [&leg.joints, &leg.torques].into_iter().all(|goal| *goal == LegGoal::Stay)
        };
        self.done == 0 && self.legs.iter().all(stays)
    }

    pub(super) fn has_leg(&self) -> bool {
        self.leg - self.done < self.legs.len()
    }

    /// Completes the present leg and begins the next leg; returns false if there is no next leg.
    pub(super) fn next_leg(&mut self) -> bool {
        self.leg += 1;
        self.begin_leg()
    }

    /// Two lists with an entry for each contact and drive. The first has the offsets (command minus clearance, m; accumulated slips are not
    /// subtracted) at the beginning of the present leg. The second has the changes of the offsets over the whole leg.
    pub(super) fn offsets(&self, grasp: &Engine) -> [Vec<SVector<f64, 3>>; 2] {
        let mut offsets = [Vec::new(), Vec::new()];
        self.offsets_into(grasp, &mut offsets);
        offsets
    }

    /// Writes the two lists of [`Self::offsets`] into the caller's lists: the offsets at the beginning of the leg into `base`, and their changes
    /// along the leg into `change`.
    pub(super) fn offsets_into(&self, grasp: &Engine, [base, change]: &mut [Vec<SVector<f64, 3>>; 2]) {
        let ([from, to], [joints_from, joints_to]) = (&self.commands, &self.joints);
        grasp.offsets_under(from.iter().copied(), joints_from, base);
        let of_joints: Vec<_> = joints_to.iter().zip(joints_from).map(|(to, from)| to - from).list();
        grasp.changed_by(to.iter().zip(from).map(|(to, from)| to - from), Some(&of_joints), change);
    }

    /// The sum of the program's load, the loads on bodies and the constant torques on joints. It is a function of the fraction of the present leg
    /// that is done. Moments are about the centroid of the contacts.
    pub(super) fn inside_trajectory(&self, grasp: &Engine) -> Trajectory<Vector> {
        match &self.trajectory {
            Trajectory::Straight { from, rate } => {
                // The change of the load is converted to coordinates directly. If it were the difference of two converted loads, a small change would
                // be lost in rounding errors.
                let (mut from, mut rate) = (grasp.load_unchecked(from), grasp.inside_unchecked(rate));
                for [first, last] in self.other_loads(grasp).into_iter().flatten() {
                    rate += last - &first;
                    from += first;
                }
                Trajectory::Straight { from, rate }
            }
            Trajectory::Turn { load, angle } => {
                let mut load = inside(grasp, load);
                for [constant, _] in self.other_loads(grasp).into_iter().flatten() {
                    load.constant += constant;
                }
                Trajectory::Turn { load, angle: *angle }
            }
        }
    }

    /// Loads in addition to the program's load: loads on single bodies, and constant torques on joints. Each entry has two vectors of generalised
    /// forces, at the beginning and at the end of the present leg; `None` if no leg so far changes these loads.
    fn other_loads(&self, grasp: &Engine) -> [Option<[Vector; 2]>; 2] {
        [self.bodies.inside(grasp), self.torques.inside(grasp)]
    }

    /// The index of the present leg and `fraction`. Once all legs are complete, the index of the last leg and 1.
    pub(super) fn place(&self, fraction: f64) -> (usize, f64) {
        if self.has_leg() || self.leg == 0 { (self.leg, fraction) } else { (self.leg - 1, 1.0) }
    }

    /// The program's load, as the caller gave it, at the fraction `fraction` of the present leg.
    pub(super) fn load_at(&self, fraction: f64) -> Wrench<3> {
        self.trajectory.at(fraction)
    }
}
