//! Grasps in space under loads that make them slide: three designed scenes, and random scenes.

use grasp_lcp::spatial::{Contact, Equilibrium, Grasp, Ramp, Wrench};
use nalgebra::{Vector2, Vector3};

use crate::Failure;
use crate::splitmix::Random;

/// A grasp, a ramp of load and finger commands, and a multiple of the load factor at first slip at which contacts slide far.
pub struct Scene {
    /// Name in tables and pictures.
    pub name: &'static str,
    /// Contacts with their commands at factor 0.
    pub contacts: Vec<Contact>,
    /// The load at factor 0.
    pub base: Wrench,
    /// Change of the load per unit of the factor.
    pub direction: Wrench,
    /// Change of the finger commands per unit of the factor, in the contact frames, m.
    pub commands: Vec<Vector3<f64>>,
    /// Multiple of the load factor at first slip at which contacts slide far.
    pub deep: f64,
}

impl Scene {
    /// The ramp, from factor 0 on.
    pub fn ramp(&self) -> Ramp {
        Ramp::load(self.base, self.direction).with_commands(self.commands.clone())
    }

    fn commands_at(&self, factor: f64) -> Vec<Vector3<f64>> {
        self.contacts.iter().zip(&self.commands).map(|(c, change)| c.commanded() + change * factor).collect()
    }

    /// The grasp with its commands at a factor, and the load.
    pub fn at(&self, factor: f64) -> Result<(Grasp, Wrench), Failure> {
        let grasp = Grasp::new(self.contacts.clone())?.with_commands(self.commands_at(factor))?;
        Ok((grasp, self.base + self.direction * factor))
    }

    /// The elastic trial state at a factor: the equilibrium if no contact could slide or open.
    pub fn trial(&self, factor: f64) -> Result<Equilibrium, Failure> {
        let stuck = Grasp::new(self.contacts.iter().map(|c| c.clone().bonded()))?;
        let stuck = stuck.with_commands(self.commands_at(factor))?;
        let held = stuck.solve(self.base + self.direction * factor)?;
        Ok(held.equilibrium().ok_or("bonded contacts hold")?.clone())
    }

    /// Whether the first tangents may be turned about the normals. They may if both tangential stiffnesses are equal and no command is
    /// tangential, because stiffness and commands refer to the tangents.
    pub fn may_turn(&self) -> bool {
        self.contacts.iter().enumerate().all(|(i, c)| {
            let k = c.series_stiffness_of_axes();
            let sideways =
                c.commanded().yz() != Vector2::zeros() || self.commands[i].yz() != Vector2::zeros();
            self.is_hand(i) || (k[1] == k[2] && !sideways)
        })
    }

    /// Whether contact `i` is the bonded hand, which has no friction cone.
    pub fn is_hand(&self, i: usize) -> bool {
        self.contacts[i].label_text(i) == "hand"
    }

    /// The scene with the first corner of each friction polygon along the tangential force of the elastic trial state at a factor.
    pub fn turned(&self, factor: f64) -> Result<Self, Failure> {
        let trial = self.trial(factor)?;
        let frames = Grasp::new(self.contacts.clone())?;
        let mut contacts = self.contacts.clone();
        for (i, (contact, frame)) in contacts.iter_mut().zip(frames.frames()).enumerate() {
            let [_, x, y] = trial.contacts[i].force.into();
            if !self.is_hand(i) && x.hypot(y) > 0.0 {
                *contact = contact.clone().tangent(frame * Vector3::new(0.0, x, y));
            }
        }
        let Self { name, base, direction, deep, .. } = *self;
        Ok(Self { name, contacts, base, direction, commands: self.commands.clone(), deep })
    }
}

/// Three fingertips around an object of 60 mm, pulled down and to the side off its middle.
pub fn three_fingers() -> Scene {
    let finger = |degrees: f64, height: f64, mu: f64| {
        let (sin, cos) = degrees.to_radians().sin_cos();
        Contact::new([0.03 * cos, 0.03 * sin, height], [-cos, -sin, 0.0])
            .tangent([0.0, 0.0, 1.0])
            .body_stiffness(2e5, 1e5)
            .finger_stiffness(1500.0, 900.0)
            .friction(mu)
            .command([0.003, 0.0, 0.0])
    };
    Scene {
        name: "three fingers",
        contacts: vec![finger(5.0, 0.002, 0.6), finger(125.0, -0.004, 0.5), finger(238.0, 0.005, 0.7)],
        base: Wrench::ZERO,
        direction: Wrench::force_at([0.5, 0.2, -1.0], [0.004, -0.006, 0.01]),
        commands: vec![Vector3::zeros(); 3],
        deep: 2.5,
    }
}

/// Four fingertips with ridged skin: three times softer across the ridges than along.
pub fn four_fingers() -> Scene {
    let finger = |degrees: f64, height: f64, squeeze: f64, mu: f64, ridges: [f64; 3]| {
        let (sin, cos) = degrees.to_radians().sin_cos();
        Contact::new([0.035 * cos, 0.035 * sin, height], [-cos, -sin, 0.0])
            .tangent(ridges)
            .body_stiffness(2e5, 1e5)
            .finger_stiffness_axes([1500.0, 1200.0, 400.0])
            .friction(mu)
            .command([squeeze, 0.0, 0.0])
    };
    Scene {
        name: "four fingers, ridged",
        contacts: vec![
            finger(180.0, 0.002, 0.0051, 0.9, [0.3, 0.2, 1.0]),
            finger(50.0, 0.008, 0.003, 0.5, [-0.2, 0.4, 1.0]),
            finger(-3.0, 0.004, 0.001, 0.3, [0.1, -1.0, 0.6]),
            finger(-48.0, -0.006, 0.003, 0.8, [0.5, 0.6, 1.0]),
        ],
        base: Wrench::ZERO,
        direction: Wrench::force_at([0.25, 0.1, -1.0], [0.01, -0.012, 0.02]),
        commands: vec![Vector3::zeros(); 4],
        deep: 2.3,
    }
}

/// A block of 20 N on twelve feet, dragged by a hand at one of its corners, so that it also rotates.
pub fn dragged_block() -> Scene {
    let mut contacts = Vec::new();
    for row in 0..3 {
        for column in 0..4 {
            let point = [0.04 * f64::from(column) - 0.06, 0.03 * f64::from(row) - 0.03, 0.0];
            contacts.push(
                Contact::new(point, [0.0, 0.0, 1.0])
                    .tangent([1.0, 0.0, 0.0])
                    .series_stiffness(2e4, 1.2e4)
                    .friction(0.4),
            );
        }
    }
    let hand = Contact::new([0.07, 0.05, 0.01], [0.0, 0.0, 1.0]).tangent([1.0, 0.0, 0.0]);
    contacts.push(hand.name("hand").series_stiffness(50.0, 400.0).bonded());
    let mut commands = vec![Vector3::zeros(); 12];
    commands.push(Vector3::new(0.0, 0.001, 0.0025));
    Scene {
        name: "block on twelve feet, dragged askew",
        contacts,
        base: Wrench::force_at([0.0, 0.0, -20.0], [0.008, -0.005, 0.02]),
        direction: Wrench::ZERO,
        commands,
        deep: 3.0,
    }
}

/// Fingertips on a ball of 60 mm that press towards its middle within some 20 degrees. The load is a force in a random direction
/// beside the middle.
pub fn random_fingers(count: usize, random: &mut Random) -> Scene {
    let contacts: Vec<_> = (0..count)
        .map(|_| {
            let outward = Vector3::from(random.vector()).normalize();
            let inward = Vector3::from(random.vector()) * 0.35 - outward;
            let softness = 0.5 + random.uniform();
            Contact::new((outward * 0.03).data.0[0], inward.data.0[0])
                .series_stiffness(1500.0 * softness, 900.0 * softness)
                .friction(0.3 + 0.6 * random.uniform())
                .command([0.002 + 0.002 * random.uniform(), 0.0, 0.0])
        })
        .collect();
    let point = Vector3::from(random.vector()) * 0.01;
    Scene {
        name: "random fingers",
        commands: vec![Vector3::zeros(); count],
        contacts,
        base: Wrench::ZERO,
        direction: Wrench::force_at(Vector3::from(random.vector()).normalize().data.0[0], point.data.0[0]),
        deep: 1.2 + 1.3 * random.uniform(),
    }
}
