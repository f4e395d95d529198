//! States and torques of the joints and tendons of a hand in an equilibrium. A drive is the spring of a joint or tendon, with its force limit. At
//! this limit the drive yields: its motor or clutch gives way at constant force.

use nalgebra::SVector;

use crate::contact::State;
use crate::grasp::{Drive, DriveLaw, DriveOwner, Engine, HandPart, JointKind, Linkage, NamedPart, PartLabel};
use crate::numerics::{indexed, numbered};
use crate::object::Problem;
use crate::prelude::*;
use crate::search::SearchSolution;
#[cfg(feature = "serde")]
use crate::serial::AsComputed;

/// Displacement and torques of one joint in an equilibrium, and the state of its drive.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct JointAnswer {
    /// Label of the joint.
    #[cfg_attr(feature = "serde", serde(flatten))]
    pub joint: PartLabel,
    /// Kind of the joint's motion: rotation, translation, or a motion given only by Jacobians.
    #[cfg_attr(feature = "serde", serde(default))]
    pub kind: JointKind,
    /// State of the joint's own drive.
    pub state: DriveState,
    /// Displacement φ of the joint from the posture in which the contacts were given, rad or m.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
    pub displacement: f64,
    /// Torque on the joint along its displacement φ, N m or N. It is the sum of the torques of its own drive, of couplings with other joints, of
    /// tendons, and of constant torques. It balances the contact forces F and the external torque τ_ext on the joint: `τ = Σ Jᵀ F - τ_ext` with the
    /// Jacobians J of the contacts.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
    pub torque: f64,
    /// Torque of the joint's own drive, without constant torques, N m or N; zero without a drive.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
    pub drive: f64,
    /// Margin of the drive, N m or N: the greatest allowed torque or force minus |drive|; infinite if there is no force limit.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
    pub margin: f64,
    /// Displacement by which the joint's own drive has given way in addition to its spring, `θ - φ - drive/k`, rad or m. Here θ is the command, φ the
    /// joint's displacement and k the stiffness. Zero while the drive holds, apart from earlier slip of a clutch.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
    pub yielded: f64,
}

/// Tension of one tendon in an equilibrium, and the state of its drive.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct TendonAnswer {
    /// Label of the tendon.
    #[cfg_attr(feature = "serde", serde(flatten))]
    pub tendon: PartLabel,
    /// State of the tendon's drive.
    pub state: DriveState,
    /// Tension of the tendon, N: the sum of the tension of its spring and its constant tension.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
    pub tension: f64,
    /// Greatest allowed tension of the drive's spring minus the present tension of the spring, N; infinite if the tension is not limited.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
    pub margin: f64,
    /// Displacement by which the tendon's drive has given way in addition to its spring, `x - r·φ - T/k`, m. Here x is the motor's displacement, r
    /// are the moment arms, and φ the joint displacements. T is the tension of the spring, without the constant tension, and k its stiffness.
    /// Negative while the tendon is slack.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
    pub yielded: f64,
}

/// State of the drive of a joint or of a tendon.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "snake_case"))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub enum DriveState {
    /// The force of the drive is that of its spring, below any limit.
    Holds,
    /// The drive yields: it gives way at a constant torque or force, which has reached its greatest allowed value.
    Yields,
    /// A tendon without tension, which follows the joints.
    Slack,
    /// The joint has no spring of its own: a constant torque acts, or drives of other joints hold it.
    Absent,
}

/// State, torque or tension, and yielded displacement of a joint or tendon. A drive that yields at constant force is modelled by two springs in
/// series, one for each bound of the force; their states and displacements are combined here.
struct CombinedDrives {
    carried: f64,
    state: DriveState,
    yielded: f64,
}

impl Engine {
    /// Answers for the joints and the tendons of the hand, from the solution `found` of the equilibrium problem.
    pub(super) fn hand_answers(
        &self,
        problem: &Problem,
        found: &SearchSolution,
    ) -> (Vec<JointAnswer>, Vec<TendonAnswer>) {
        let Some(linkage) = self.linkage() else { return (Vec::new(), Vec::new()) };
        let own = |owner: DriveOwner| self.owner_state(linkage, problem, found, owner);
        let mut exerted = linkage.held_forces.clone();
        for (site, force) in self.sites().iter().zip(&found.forces).skip(self.len()) {
            exerted += &site.map * force;
        }
        let object = self.space().of_the_object();
        let joint = |j: usize| {
            let length = linkage.lengths[object + j];
            let CombinedDrives { carried, state, yielded } = own(DriveOwner::Joint(j));
            let displacement = found.twist[object + j] / length;
            let margin = margin(&linkage.joints[j], carried, state);
            let torque = exerted[object + j] * length;
            let joint = linkage.label(HandPart::Joint(j));
            JointAnswer {
                joint,
                kind: linkage.joints[j].kind,
                state,
                displacement,
                torque,
                drive: carried,
                margin,
                yielded,
            }
        };
        let tendon = |(number, named): (usize, &NamedPart)| {
            let CombinedDrives { carried, state, yielded } = own(DriveOwner::Tendon(number));
            let margin = margin(named, carried, state);
            let tendon = linkage.label(HandPart::Tendon(number));
            TendonAnswer { tendon, state, tension: carried + named.held_torque, margin, yielded }
        };
        let joints = numbered(linkage.joints.len(), &joint);
        (joints, indexed(&linkage.tendons, &tendon))
    }

    fn owner_state(
        &self,
        linkage: &Linkage,
        problem: &Problem,
        found: &SearchSolution,
        owner: DriveOwner,
    ) -> CombinedDrives {
        let mut own = CombinedDrives { carried: 0.0, state: DriveState::Absent, yielded: 0.0 };
        for (k, drive) in linkage.drives.iter().enumerate().filter(|(_, drive)| drive.owner == owner) {
            let i = self.len() + k;
            let (state, force) = (&found.states[i], &found.forces[i]);
            let stretch = problem.stretch(i, &found.twist);
            own.carried = drive.carried(force).unwrap_or(own.carried);
            let (drive_state, along) = drive_state(drive, state, &stretch, force, &problem.slips[i]);
            if drive_state != DriveState::Holds || own.state == DriveState::Absent {
                own.state = drive_state;
            }
            own.yielded += drive.displacement(along);
        }
        own
    }
}

/// The margin of a joint or tendon, N m or N: the force limit of its drive minus the magnitude of the force `carried`. Zero while the drive yields,
/// infinite without a force limit.
fn margin(named: &NamedPart, carried: f64, state: DriveState) -> f64 {
    match named.limit {
        None => f64::INFINITY,
        Some(_) if state == DriveState::Yields => 0.0,
        Some(limit) => limit.bound() - carried.abs(),
    }
}

/// State of a drive, and the displacement by which it has yielded. The displacement is in m also for a revolute joint, since the engine treats drives
/// like contacts; `Drive::displacement` converts it to rad. While the drive holds, this displacement is only the earlier slip of a clutch.
fn drive_state(
    drive: &Drive,
    state: &State,
    stretch: &SVector<f64, 3>,
    force: &SVector<f64, 3>,
    slipped: &SVector<f64, 3>,
) -> (DriveState, f64) {
    let open = state.is_open();
    match drive.role {
        DriveLaw::Pulls if open => (DriveState::Slack, stretch[0].min(0.0)),
        DriveLaw::UpperHalf if open => (DriveState::Yields, (-stretch[0]).max(0.0)),
        // The lower limit of the tension of a tendon is zero; a tendon at this limit is slack.
        DriveLaw::LowerHalf if open && drive.pulls_only() => (DriveState::Slack, stretch[0].min(0.0)),
        DriveLaw::LowerHalf if open => (DriveState::Yields, stretch[0].min(0.0)),
        DriveLaw::Holds | DriveLaw::Pulls | DriveLaw::UpperHalf | DriveLaw::LowerHalf => {
            (DriveState::Holds, 0.0)
        }
        DriveLaw::Slips if state.slides() => {
            let elastic = drive.deflection(force[1]);
            (DriveState::Yields, stretch[1] - elastic + slipped[1])
        }
        DriveLaw::Slips => (DriveState::Holds, slipped[1]),
    }
}
