//! Assembly of the coordinates, contacts and drives of a grasp from a hand. A drive is the spring of a joint or tendon, with its force limit. A
//! command is a prescribed displacement of a finger, joint or tendon. In the engine's coordinates moments and rotations refer to the centroid of the
//! contacts.

use nalgebra::DMatrix;

use super::draft::{Assembly, refuse};
use super::drive::{Drive, DriveLaw, DriveOwner};
use super::hand_builder::Hand;
use super::joint::{Joint, JointKind, Limit};
use super::linkage::{Linkage, NamedPart};
use super::positive::squares;
use crate::error::{Error, LARGEST, is_moderate};
use crate::grasp::bodies::{PlacedBodies, refuse_sides};
use crate::grasp::engine::Engine;
use crate::numerics::{IntoList, Size, Vector, mapped, numbered, paired};
use crate::prelude::*;
use crate::words::printable;

impl Hand<3> {
    /// The grasp of an object by this hand. The first coordinates belong to the object: 3 in the plane, 6 in space. The coordinates of the hand
    /// follow; [`Self::coordinates`] is an upper limit of the number of all coordinates.
    ///
    /// # Errors
    /// [`Error::EmptyGrasp`] without contacts; [`Error::Hand`] with the joint, tendon or finger, the field and the allowed values; [`Error::Contact`]
    /// for a contact with a number out of range or without a frame.
    pub(crate) fn engine(self, mut bodies: Option<PlacedBodies>) -> Result<Engine, Error> {
        let others = bodies.as_ref().map_or(0, |bodies| bodies.names.len() - 1);
        let space = self.space();
        let most = Size::of(self.coordinates_in(space) + others * space.of_the_object());
        let used = self.joints();
        let Self { fingers, tendons } = self;
        let mut joints: Vec<Joint<3>> = Vec::with_capacity(used);
        for finger in &fingers {
            joints.extend_from_slice(&finger.joints);
        }
        let mut assembly = Assembly {
            space,
            contacts: Vec::new(),
            motions: Vec::new(),
            used,
            joints,
            lengths: Vector::from_fn(most, |_| 1.0),
            drives: Vec::new(),
            held_forces: Vector::zeros(),
            presses: Vec::new(),
            bones: Vec::new(),
        };
        let mut first = 0;
        for (number, finger) in fingers.iter().enumerate() {
            assembly.add_contacts(finger, number, first)?;
            first += finger.joints.len();
        }
        if let Some(bodies) = &mut bodies {
            assembly.add_bodies(bodies)?;
        } else {
            refuse_sides(&assembly.contacts)?;
        }
        assembly.measure()?;
        assembly.add_joint_drives()?;
        let mut first = 0;
        for (number, finger) in fingers.iter().enumerate() {
            if let Some(matrix) = &finger.coupling {
                assembly.couple(matrix, number, first, finger.joints.len())?;
            }
            first += finger.joints.len();
        }
        let mut named_tendons = Vec::new();
        for (number, tendon) in tendons.iter().enumerate() {
            named_tendons.push(assembly.add_tendon(tendon, number, first)?);
        }
        let pressed = assembly.pressed(&fingers)?;
        let mut commands = paired(&assembly.joints, &pressed, &|(joint, more)| joint.command + more);
        commands.extend(mapped(&tendons, &|tendon| tendon.pull));
        assembly.grasp(named_tendons, commands, bodies)
    }
}

impl Assembly {
    /// Chooses a reference length for each coordinate after the object's: the power of two nearest to the largest displacement of a contact per unit
    /// of the coordinate. Scaling by a power of two causes no rounding. A joint that moves no contact is an error.
    fn measure(&mut self) -> Result<(), Error> {
        for k in 0..self.used {
            let mut longest = 0.0_f64;
            for (coordinate, column) in self.motions.iter().flatten() {
                if *coordinate == k {
                    longest = longest.max(column.norm());
                }
            }
            if longest * LARGEST < 1.0 {
                if k >= self.joints.len() {
                    continue;
                }
                return Self::fault(self.label(k), "motion of all contacts", longest, "more than nothing");
            }
            let object = self.object();
            self.lengths[object + k] = power_of_two(longest);
        }
        // At this stage the only drives are the springs of compliance matrices. Each has the stiffness 1 N/m along its own coordinate, a displacement
        // in m. The stiffness is converted to the reference length of this coordinate.
        for drive in &mut self.drives {
            let k = drive.along.iamax();
            let length = self.lengths[k];
            drive.stiffness = 1.0 / (length * length);
        }
        Ok(())
    }

    fn add_joint_drives(&mut self) -> Result<(), Error> {
        for j in 0..self.joints.len() {
            let Joint { stiffness, command, torque, limit, .. } = self.joints[j];
            let label = self.label(j);
            check_spring(&label, stiffness, limit)?;
            for (field, value) in [("command", command), ("torque", torque)] {
                if !is_moderate(value) {
                    return Self::fault(label, field, value, crate::error::MODERATE);
                }
            }
            let k = self.object() + j;
            let length = self.lengths[k];
            let mut along = Vector::zeros();
            along[k] = 1.0;
            self.held_forces[k] += torque / length;
            if stiffness > 0.0 {
                let spring = Spring { along, stiffness: stiffness / (length * length), unit: length };
                self.drive(DriveOwner::Joint(j), &spring, (j, length), limit, true);
            }
        }
        Ok(())
    }

    /// Adds the stiffness matrix K of a finger's joints, factorised as `K = Σ l lᵀ`. Each column l becomes one drive, a spring along a single axis.
    /// `number` is the index of the finger, `first` the index of its first joint, and `count` the number of its joints.
    fn couple(
        &mut self,
        matrix: &DMatrix<f64>,
        number: usize,
        first: usize,
        count: usize,
    ) -> Result<(), Error> {
        let columns = squares(matrix, count)
            .or_else(|fault| refuse(fault, format!("finger {number}"), "stiffness matrix"))?;
        for column in columns {
            let arms: Vec<_> =
                (0..count).map(|j| (first + j, column[j])).filter(|(_, arm)| *arm != 0.0).list();
            let (spring, unit) = self.over(&arms, 1.0);
            let drive = Drive {
                owner: DriveOwner::Nobody,
                role: DriveLaw::Holds,
                along: spring.along,
                stiffness: spring.stiffness,
                bound: f64::INFINITY,
                unit: spring.unit,
                commands: mapped(&arms, &|&(j, arm)| (j, arm / unit)),
                rest: 0.0,
            };
            self.drives.push(drive);
        }
        Ok(())
    }

    /// Adds the tendon with the index `number`. It has an arm for each of the `count` joints of fingers. Each contact with a constant force has a
    /// prismatic joint of its own along its normal, its slide. Slides come behind the joints of fingers; their arms may be left out.
    fn add_tendon(
        &mut self,
        tendon: &super::tendon::Tendon,
        number: usize,
        count: usize,
    ) -> Result<NamedPart, Error> {
        let named = tendon.name.as_ref().map_or_else(String::new, |name| format!(" ({})", printable(name)));
        let label = format!("tendon {number}{named}");
        check_spring(&label, tendon.stiffness, tendon.limit)?;
        for (field, value) in [("pull", tendon.pull), ("tension", tendon.tension)] {
            if !is_moderate(value) {
                return Self::fault(label, field, value, crate::error::MODERATE);
            }
        }
        if ![count, self.joints.len()].contains(&tendon.arms.len()) {
            return Self::fault(
                label,
                "number of arms",
                tendon.arms.len() as f64,
                "the number of joints, with 0 where the tendon does not pull",
            );
        }
        if let Some(&value) = tendon.arms.iter().find(|arm| !is_moderate(**arm)) {
            return Self::fault(label, "arm", value, crate::error::MODERATE);
        }
        if matches!(tendon.limit, Some(Limit::Slips(_))) && !tendon.pushes {
            let bound = tendon.limit.map_or(0.0, Limit::bound);
            let allowed = "one that saturates: a tendon that slips would have to push as well";
            return Self::fault(label, "limit", bound, allowed);
        }
        let arms: Vec<_> = tendon.arms.iter().copied().enumerate().filter(|(_, arm)| *arm != 0.0).list();
        if arms.is_empty() {
            return Self::fault(label, "arm over every joint", 0.0, "more than nothing over one of them");
        }
        let (spring, unit) = self.over(&arms, tendon.stiffness);
        let along = &spring.along * unit;
        self.held_forces += &along * tendon.tension;
        if tendon.stiffness > 0.0 {
            let actuator = self.joints.len() + number;
            self.drive(
                DriveOwner::Tendon(number),
                &spring,
                (actuator, 1.0 / unit),
                tendon.limit,
                tendon.pushes,
            );
        }
        Ok(NamedPart {
            name: tendon.name.clone(),
            limit: tendon.limit,
            kind: JointKind::Slides,
            held_torque: tendon.tension,
            along,
        })
    }

    /// The spring of a tendon, or of a joint stiffness matrix, with these moment arms at the joints. Its arms are converted to the engine's
    /// coordinates and divided by the power of two closest to the largest of them. This power of two is also returned.
    fn over(&self, arms: &[(usize, f64)], stiffness: f64) -> (Spring, f64) {
        let mut along = Vector::zeros();
        for &(j, arm) in arms {
            let k = self.object() + j;
            along[k] = arm / self.lengths[k];
        }
        let unit = power_of_two(along.amax());
        (Spring { along: along / unit, stiffness: stiffness * unit * unit, unit: 1.0 / unit }, unit)
    }

    /// Adds a drive. A drive that yields at a constant force ([`Limit::Saturates`]) is added as two springs in series, whose laws are those of
    /// frictionless contacts. `command` is the index of the command that stretches the spring, with the stretch in m per unit of this command.
    /// `pushes` is false for a drive that only pulls.
    fn drive(
        &mut self,
        owner: DriveOwner,
        spring: &Spring,
        command: (usize, f64),
        limit: Option<Limit>,
        pushes: bool,
    ) {
        let bound = limit.map_or(f64::INFINITY, Limit::bound) / spring.unit;
        let drive = Drive {
            owner,
            role: if pushes { DriveLaw::Holds } else { DriveLaw::Pulls },
            along: spring.along.clone(),
            stiffness: spring.stiffness,
            bound,
            unit: spring.unit,
            commands: vec![command],
            rest: 0.0,
        };
        match limit {
            None => self.drives.push(drive),
            Some(Limit::Slips(_)) => self.drives.push(Drive { role: DriveLaw::Slips, ..drive }),
            Some(Limit::Saturates(_)) => {
                // This drive becomes two springs in series, each twice as stiff, with an additional coordinate b at the point between them. Neither
                // spring can pull, which bounds the drive's force f. The upper spring, between b and the joint, carries upper bound - f; the lower
                // spring, between the command and b, carries f - lower bound. Constant forces add the bounds: upper bound on the joint, lower bound -
                // upper bound on b. The joint thus gets f, and b is in balance. If f reaches a bound, one spring has no force and opens, as a contact
                // does: the drive yields at constant force.
                let mut between = Vector::zeros();
                between[self.object() + self.used] = 1.0;
                self.used += 1;
                let stiffness = 2.0 * drive.stiffness;
                let below = if pushes { bound } else { 0.0 };
                self.held_forces += &drive.along * bound - &between * (bound + below);
                let rest = below / stiffness;
                let (along, above) = (&between - &drive.along, bound / stiffness);
                let lower =
                    Drive { role: DriveLaw::LowerHalf, along: between, stiffness, rest, ..drive.clone() };
                let commands = Vec::new();
                let upper =
                    Drive { role: DriveLaw::UpperHalf, along, stiffness, rest: above, commands, ..drive };
                self.drives.extend([upper, lower]);
            }
        }
    }

    /// Makes the grasp, as an [`Engine`], from the contacts, joints and drives that were collected.
    fn grasp(
        self,
        tendons: Vec<NamedPart>,
        commands: Vec<f64>,
        bodies: Option<PlacedBodies>,
    ) -> Result<Engine, Error> {
        let size = Size::of(self.object() + self.used);
        let name = |number: usize| {
            let (joint, k) = (&self.joints[number], self.object() + number);
            let mut along = Vector::zeros();
            along[k] = 1.0 / self.lengths[k];
            NamedPart {
                name: joint.name.clone(),
                limit: joint.limit,
                kind: joint.kind(),
                held_torque: joint.torque,
                along,
            }
        };
        let linkage = Linkage {
            joints: numbered(self.joints.len(), &name),
            tendons,
            lengths: Vector::from_fn(size, |k| self.lengths[k]),
            motions: self.motions,
            drives: self.drives,
            held_forces: self.held_forces,
            external_torques: Vector::zeros(),
            bodies: bodies.map(Box::new),
            bones: self.bones,
            axes: mapped(&self.joints, &|joint| joint.motion.axis(self.space)),
            centres: mapped(&self.joints, &|joint| joint.motion.centre()),
            commands,
        };
        Engine::by_hand(size, self.contacts, linkage)
    }
}

/// A spring of one axis in the engine's coordinates. `along` is the generalised force per newton of the spring's force.
struct Spring {
    along: Vector,
    stiffness: f64,
    /// Torque or tension per newton of the spring's force.
    unit: f64,
}

fn check_spring(label: &str, stiffness: f64, limit: Option<Limit>) -> Result<(), Error> {
    let fault = |field, value, allowed| Err(Error::Hand { what: label.to_owned(), field, value, allowed });
    if !(stiffness == 0.0 || (1.0 / LARGEST..=LARGEST).contains(&stiffness)) {
        return fault("stiffness", stiffness, "zero, or from 1e-50 to 1e50");
    }
    let Some(limit) = limit else { return Ok(()) };
    let bound = limit.bound();
    if !(1.0 / LARGEST..=LARGEST).contains(&bound) {
        return fault("limit", bound, "from 1e-50 to 1e50");
    }
    if stiffness == 0.0 {
        return fault(
            "stiffness",
            stiffness,
            "positive where there is a limit: it is that of its own spring",
        );
    }
    Ok(())
}

/// The power of two whose ratio to a positive number is closest to one.
fn power_of_two(x: f64) -> f64 {
    x.log2().round().exp2()
}
