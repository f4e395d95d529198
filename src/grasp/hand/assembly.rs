//! From a hand as it is given to the coordinates, contacts and drives of a grasp.

use nalgebra::{DMatrix, DVector, SVector};

use super::compliant::split;
use super::drive::{Drive, Owner, Role};
use super::finger::{Finger, MovedBy};
use super::hand_builder::Hand;
use super::joint::{Joint, Limit};
use super::linkage::{Linkage, Named};
use super::positive::{Fault, squares};
use crate::error::{Error, LARGEST, is_moderate};
use crate::grasp::contact::Contact;
use crate::grasp::held_object::Grasp;

/// Motion of one contact with the coordinates beside those of the object, along the coordinate axes.
type Columns<const C: usize> = Vec<(usize, SVector<f64, C>)>;

/// A hand on its way to a grasp.
struct Assembly<const D: usize, const C: usize> {
    contacts: Vec<Contact<C>>,
    motions: Vec<Columns<C>>,
    joints: Vec<Joint<C>>,
    /// Coordinates beside those of the object that are in use.
    used: usize,
    lengths: SVector<f64, D>,
    drives: Vec<Drive<D>>,
    held: SVector<f64, D>,
    bones: Vec<[SVector<f64, C>; 2]>,
    /// Pressing force of each contact.
    presses: Vec<f64>,
}

impl<const C: usize> Hand<C> {
    /// The grasp of an object by this hand, in D coordinates: those of the object, 3 in the plane and 6 in space, and [one for each joint and
    /// each drive that saturates](Self::coordinates). A larger D costs time and changes nothing.
    ///
    /// # Errors
    /// [`Error::EmptyGrasp`] without contacts; [`Error::Coordinates`] if D is too small; [`Error::Hand`] naming joint, tendon or finger, the field and what is
    /// allowed; [`Error::Contact`] as for [`Grasp::new`].
    pub fn grasp<const D: usize>(self) -> Result<Grasp<D, C>, Error> {
        let needed = self.coordinates();
        if needed > D {
            return Err(Error::Coordinates { given: D, needed });
        }
        let Self { fingers, tendons } = self;
        let joints: Vec<Joint<C>> = fingers.iter().flat_map(|finger| finger.joints.iter().cloned()).collect();
        let mut assembly = Assembly {
            contacts: Vec::new(),
            motions: Vec::new(),
            used: joints.len(),
            joints,
            lengths: SVector::repeat(1.0),
            drives: Vec::new(),
            held: SVector::zeros(),
            presses: Vec::new(),
            bones: Vec::new(),
        };
        let mut first = 0;
        for (number, finger) in fingers.iter().enumerate() {
            assembly.add_contacts(finger, number, first)?;
            first += finger.joints.len();
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
            named_tendons.push(assembly.add_tendon(tendon, number)?);
        }
        let pressed = assembly.pressed(&fingers)?;
        let commands = assembly.joints.iter().zip(pressed).map(|(joint, more)| joint.command + more);
        let commands = commands.chain(tendons.iter().map(|tendon| tendon.pull)).collect();
        assembly.grasp(named_tendons, commands)
    }
}

impl<const D: usize, const C: usize> Assembly<D, C> {
    /// Coordinates of the object.
    const OBJECT: usize = C * (C + 1) / 2;

    fn fault<T>(what: String, field: &'static str, value: f64, allowed: &'static str) -> Result<T, Error> {
        Err(Error::Hand { what, field, value, allowed })
    }

    fn label(&self, joint: usize) -> String {
        self.joints[joint]
            .name
            .as_ref()
            .map_or_else(|| format!("joint {joint}"), |name| format!("joint {joint} ({name})"))
    }

    /// The contacts of a finger whose joints begin at `first`.
    fn add_contacts(&mut self, finger: &Finger<C>, number: usize, first: usize) -> Result<(), Error> {
        let count = finger.joints.len();
        let (pads, own) = match &finger.compliance {
            None => (None, Vec::new()),
            Some(matrix) => {
                let split = split(matrix, C * finger.contacts.len());
                let (pads, own) =
                    split.or_else(|fault| refuse(fault, format!("finger {number}"), "compliance"))?;
                (Some(pads), own)
            }
        };
        for (place, carried) in finger.contacts.iter().enumerate() {
            let index = self.contacts.len();
            let mut contact = carried.contact.clone();
            if let Some(pads) = &pads {
                contact.stiffness = contact.stiffness.softened(&SVector::from_fn(|a, _| pads[C * place + a]));
            }
            contact.check(index)?;
            let frame = contact.frame(index)?;
            self.presses.push(contact.press.unwrap_or(0.0));
            let mut columns: Columns<C> = Vec::new();
            let mut given = |matrix: &DMatrix<f64>, turn: bool| {
                if matrix.shape() != (C, count) {
                    let what = format!("jacobian of contact {}", contact.label(index));
                    return Err(Error::Shape { what, given: matrix.shape(), expected: (C, count) });
                }
                if let Some(&value) = matrix.iter().find(|x| !is_moderate(**x)) {
                    let what = format!("contact {}", contact.label(index));
                    return Self::fault(what, "jacobian", value, crate::error::MODERATE);
                }
                for j in 0..count {
                    let column = SVector::from_fn(|a, _| matrix[(a, j)]);
                    columns.push((first + j, if turn { frame * column } else { column }));
                }
                Ok(())
            };
            match &carried.by {
                MovedBy::World(matrix) => given(matrix, false)?,
                MovedBy::Frame(matrix) => given(matrix, true)?,
                MovedBy::Link(link) => {
                    if *link > count {
                        let what = format!("contact {}", contact.label(index));
                        return Self::fault(
                            what,
                            "link",
                            *link as f64,
                            "at most the number of joints of its finger",
                        );
                    }
                    let centres = finger.joints[..*link].iter().filter_map(|joint| joint.motion.centre());
                    let corners: Vec<_> = centres.chain([contact.point]).collect();
                    self.bones.extend(corners.windows(2).map(|pair| [pair[0], pair[1]]));
                    for j in 0..*link {
                        let Some(velocity) = finger.joints[j].motion.of_point(&contact.point) else {
                            return Self::fault(
                                self.label(first + j),
                                "axis",
                                0.0,
                                "of positive, finite length",
                            );
                        };
                        if let Some(&value) = velocity.iter().find(|x| !is_moderate(**x)) {
                            return Self::fault(
                                self.label(first + j),
                                "axis or point",
                                value,
                                crate::error::MODERATE,
                            );
                        }
                        columns.push((first + j, velocity));
                    }
                }
            }
            // What the finger gives way by beside its pads: displacements of no joint.
            for (k, column) in own.iter().enumerate() {
                let along = SVector::from_fn(|a, _| column[C * place + a]);
                columns.push((self.used + k, frame * along));
            }
            self.contacts.push(contact);
            self.motions.push(columns);
        }
        self.press_on_compliance(finger, &own);
        for k in 0..own.len() {
            let mut along = SVector::zeros();
            along[Self::OBJECT + self.used + k] = 1.0;
            self.drives.push(Drive {
                owner: Owner::Nobody,
                role: Role::Holds,
                along,
                stiffness: 1.0,
                bound: f64::INFINITY,
                unit: 1.0,
                commands: Vec::new(),
                rest: 0.0,
            });
        }
        self.used += own.len();
        Ok(())
    }

    /// What gives way beside the pads of a finger is commanded along with its contacts.
    fn press_on_compliance(&mut self, finger: &Finger<C>, own: &[DVector<f64>]) {
        let first = self.contacts.len() - finger.contacts.len();
        let presses: Vec<f64> = self.presses[first..].to_vec();
        for column in own {
            let pushed: f64 = presses.iter().enumerate().map(|(i, force)| column[C * i] * force).sum();
            for (i, contact) in self.contacts[first..].iter_mut().enumerate() {
                let along = SVector::<f64, C>::from_fn(|a, _| column[C * i + a] * pushed);
                if pushed != 0.0 {
                    *contact = contact.clone().resolved();
                    contact.command += along;
                }
            }
        }
    }

    /// Commands of joints that let their contacts press as they are told to, `K⁻¹ Σ Jᵀ F`.
    fn pressed(&self, fingers: &[Finger<C>]) -> Result<Vec<f64>, Error> {
        let mut torques = vec![0.0; self.joints.len()];
        for ((contact, motions), force) in self.contacts.iter().zip(&self.motions).zip(&self.presses) {
            let normal = contact.normal.normalize() * *force;
            for (k, motion) in motions.iter().filter(|(k, _)| *k < self.joints.len()) {
                torques[*k] += motion.dot(&normal);
            }
        }
        let mut first = 0;
        for finger in fingers {
            let count = finger.joints.len();
            let torque = DVector::from_fn(count, |j, _| torques[first + j]);
            if torque.amax() > 0.0 {
                let mut stiffness = finger.coupling.clone().unwrap_or_else(|| DMatrix::zeros(count, count));
                for j in 0..count {
                    stiffness[(j, j)] += finger.joints[j].stiffness;
                }
                let Some(commands) = stiffness.lu().solve(&torque) else {
                    let what = self.label(first);
                    return Self::fault(
                        what,
                        "stiffness",
                        0.0,
                        "positive where a contact of the finger is told how to press",
                    );
                };
                torques[first..first + count].copy_from_slice(commands.as_slice());
            }
            first += count;
        }
        Ok(torques)
    }

    /// Chooses the length by which each joint displacement is measured, a power of two near the longest motion of a contact: scaling then rounds nothing.
    fn measure(&mut self) -> Result<(), Error> {
        for k in 0..self.used {
            let columns = self.motions.iter().flatten().filter(|(coordinate, _)| *coordinate == k);
            let longest = columns.map(|(_, column)| column.norm()).fold(0.0, f64::max);
            if longest * LARGEST < 1.0 {
                if k >= self.joints.len() {
                    continue;
                }
                return Self::fault(self.label(k), "motion of all contacts", longest, "more than nothing");
            }
            self.lengths[Self::OBJECT + k] = power_of_two(longest);
        }
        // Compliances of the finger are springs of one N/m over coordinates that were lengths before.
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
            let k = Self::OBJECT + j;
            let length = self.lengths[k];
            let mut along = SVector::zeros();
            along[k] = 1.0;
            self.held[k] += torque / length;
            if stiffness > 0.0 {
                let spring = Spring { along, stiffness: stiffness / (length * length), unit: length };
                self.drive(Owner::Joint(j), &spring, (j, length), limit, true);
            }
        }
        Ok(())
    }

    /// A stiffness matrix among the joints of a finger.
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
                (0..count).map(|j| (first + j, column[j])).filter(|(_, arm)| *arm != 0.0).collect();
            let (spring, unit) = self.over(&arms, 1.0);
            let drive = Drive {
                owner: Owner::Nobody,
                role: Role::Holds,
                along: spring.along,
                stiffness: spring.stiffness,
                bound: f64::INFINITY,
                unit: spring.unit,
                commands: arms.iter().map(|&(j, arm)| (j, arm / unit)).collect(),
                rest: 0.0,
            };
            self.drives.push(drive);
        }
        Ok(())
    }

    fn add_tendon(&mut self, tendon: &super::tendon::Tendon, number: usize) -> Result<Named, Error> {
        let named = tendon.name.as_ref().map_or_else(String::new, |name| format!(" ({name})"));
        let label = format!("tendon {number}{named}");
        check_spring(&label, tendon.stiffness, tendon.limit)?;
        for (field, value) in [("pull", tendon.pull), ("tension", tendon.tension)] {
            if !is_moderate(value) {
                return Self::fault(label, field, value, crate::error::MODERATE);
            }
        }
        if tendon.arms.len() > self.joints.len() {
            return Self::fault(
                label,
                "number of arms",
                tendon.arms.len() as f64,
                "at most the number of joints",
            );
        }
        if let Some(&value) = tendon.arms.iter().find(|arm| !is_moderate(**arm)) {
            return Self::fault(label, "arm", value, crate::error::MODERATE);
        }
        if matches!(tendon.limit, Some(Limit::Slips(_))) && !tendon.pushes {
            return Self::fault(label, "limit", f64::NAN, "that of a motor: what slips has to push as well");
        }
        let arms: Vec<_> = tendon.arms.iter().copied().enumerate().filter(|(_, arm)| *arm != 0.0).collect();
        if arms.is_empty() {
            return Self::fault(label, "arm over every joint", 0.0, "more than nothing over one of them");
        }
        let (spring, unit) = self.over(&arms, tendon.stiffness);
        self.held += spring.along * (tendon.tension * unit);
        if tendon.stiffness > 0.0 {
            let actuator = self.joints.len() + number;
            self.drive(Owner::Tendon(number), &spring, (actuator, 1.0 / unit), tendon.limit, tendon.pushes);
        }
        Ok(Named { name: tendon.name.clone(), limit: tendon.limit, held: tendon.tension })
    }

    /// A spring over joints with these arms, in inside coordinates, and the power of two by which its arms were divided.
    fn over(&self, arms: &[(usize, f64)], stiffness: f64) -> (Spring<D>, f64) {
        let mut along = SVector::<f64, D>::zeros();
        for &(j, arm) in arms {
            let k = Self::OBJECT + j;
            along[k] = arm / self.lengths[k];
        }
        let unit = power_of_two(along.amax());
        (Spring { along: along / unit, stiffness: stiffness * unit * unit, unit: 1.0 / unit }, unit)
    }

    /// The drive, or both halves of one that saturates.
    fn drive(
        &mut self,
        owner: Owner,
        spring: &Spring<D>,
        command: (usize, f64),
        limit: Option<Limit>,
        pushes: bool,
    ) {
        let bound = limit.map_or(f64::INFINITY, Limit::bound) / spring.unit;
        let drive = Drive {
            owner,
            role: if pushes { Role::Holds } else { Role::Pulls },
            along: spring.along,
            stiffness: spring.stiffness,
            bound,
            unit: spring.unit,
            commands: vec![command],
            rest: 0.0,
        };
        match limit {
            None => self.drives.push(drive),
            Some(Limit::Slips(_)) => self.drives.push(Drive { role: Role::Slips, ..drive }),
            Some(Limit::Saturates(_)) => {
                // Two springs in series about one more coordinate. What each carries is its bound with the force taken off or added, and
                // the bounds themselves are held on both sides of it: the sum is the force.
                let mut between = SVector::zeros();
                between[Self::OBJECT + self.used] = 1.0;
                self.used += 1;
                let stiffness = 2.0 * drive.stiffness;
                let below = if pushes { bound } else { 0.0 };
                self.held += drive.along * bound - between * (bound + below);
                let rest = below / stiffness;
                let lower = Drive { role: Role::EndsBelow, along: between, stiffness, rest, ..drive.clone() };
                let (along, rest) = (between - drive.along, bound / stiffness);
                let commands = Vec::new();
                let upper = Drive { role: Role::EndsAbove, along, stiffness, rest, commands, ..drive };
                self.drives.extend([upper, lower]);
            }
        }
    }

    /// Puts the grasp together.
    fn grasp(mut self, tendons: Vec<Named>, commands: Vec<f64>) -> Result<Grasp<D, C>, Error> {
        // Coordinates that are not in use stay where they are.
        for k in Self::OBJECT + self.used..D {
            let mut along = SVector::zeros();
            along[k] = 1.0;
            let stiffness = self.contacts.first().map_or(1.0, |contact| contact.stiffness.series()[0]);
            self.drives.push(Drive {
                owner: Owner::Nobody,
                role: Role::Holds,
                along,
                stiffness,
                bound: f64::INFINITY,
                unit: 1.0,
                commands: Vec::new(),
                rest: 0.0,
            });
        }
        let name =
            |joint: &Joint<C>| Named { name: joint.name.clone(), limit: joint.limit, held: joint.torque };
        let linkage = Linkage {
            joints: self.joints.iter().map(name).collect(),
            tendons,
            lengths: self.lengths,
            motions: self.motions,
            drives: self.drives,
            held: self.held,
            bones: self.bones,
            commands,
        };
        Grasp::by_hand(self.contacts, linkage)
    }
}

/// A spring of one axis in inside coordinates.
struct Spring<const D: usize> {
    along: SVector<f64, D>,
    stiffness: f64,
    /// Torque or tension for a unit of force.
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

/// The error for a matrix.
fn refuse<T>(fault: Fault, what: String, field: &'static str) -> Result<T, Error> {
    Err(match fault {
        Fault::Shape { rows, columns, size } => Error::Shape {
            what: format!("{field} of {what}"),
            given: (rows, columns),
            expected: (size, size),
        },
        Fault::Entry(value) => Error::Hand { what, field, value, allowed: crate::error::MODERATE },
        Fault::Asymmetry(value) => {
            Error::Matrix { what, field, fault: "differs across its diagonal by", value }
        }
        Fault::Eigenvalue(value) => Error::Matrix { what, field, fault: "has the eigenvalue", value },
    })
}

/// The power of two next to a positive number.
fn power_of_two(x: f64) -> f64 {
    x.log2().round().exp2()
}
