//! The data of a hand as plain numbers, and its equilibria by enumeration.
//!
//! This oracle does not use the library's coordinates. A joint holds or is at one of its bounds. A tendon is slack, taut or at its bound. A contact
//! is open, sticks, or slides in either direction. Every combination is a linear system for the twist and the joint displacements.

use grasp_lcp::Limit;
use grasp_lcp::nalgebra::DMatrix;
use grasp_lcp::planar::Contact;
use grasp_lcp::planar::Grasp;
use grasp_lcp::planar::hand::{Finger, Hand, Joint, Tendon};
use num_traits::{One, Signed, Zero};

use super::affine::{Affine, Q, Solved, exact, float, solved};

/// One contact. The normal has integer components and an integer length.
pub(super) struct Touch {
    pub(super) point: [f64; 2],
    pub(super) normal: [i32; 2],
    pub(super) stiffness: [f64; 2],
    pub(super) friction: f64,
    pub(super) command: [f64; 2],
    pub(super) finger: usize,
    /// Number of joints that move the contact.
    pub(super) link: usize,
}

#[derive(Clone, Copy)]
pub(super) struct Knuckle {
    pub(super) point: [f64; 2],
    pub(super) stiffness: f64,
    pub(super) command: f64,
    pub(super) torque: f64,
    pub(super) bound: Option<Limit>,
}

pub(super) struct Cable {
    pub(super) arms: Vec<f64>,
    pub(super) stiffness: f64,
    pub(super) pull: f64,
    pub(super) tension: f64,
    pub(super) bound: Option<f64>,
}

pub(super) struct Scene {
    pub(super) touches: Vec<Touch>,
    pub(super) fingers: Vec<Vec<Knuckle>>,
    pub(super) coupling: Vec<Option<Vec<Vec<f64>>>>,
    pub(super) cable: Option<Cable>,
    pub(super) load: [f64; 3],
}

/// A state of one part: its forces, and the quantities that must not be negative.
struct Choice {
    forces: Vec<Affine>,
    conditions: Vec<Affine>,
}

/// An equilibrium of the oracle: contact forces in the contact frames, and joint displacements.
pub(super) struct Exact {
    pub(super) forces: Vec<[f64; 2]>,
    pub(super) joints: Vec<f64>,
}

pub(super) enum Verdict {
    Clear(Vec<Exact>),
    /// A condition holds with equality, or there is a family of solutions.
    Borderline,
}

impl Scene {
    fn joints(&self) -> Vec<(usize, usize, Knuckle)> {
        let of = |(f, finger): (usize, &Vec<Knuckle>)| {
            finger.iter().enumerate().map(move |(j, k)| (f, j, *k)).collect::<Vec<_>>()
        };
        self.fingers.iter().enumerate().flat_map(of).collect()
    }

    /// Stretches of a contact's springs: normal, tangential.
    fn stretches(&self, touch: &Touch) -> [Affine; 2] {
        let joints = self.joints();
        let n = 3 + joints.len();
        let length = f64::from(touch.normal[0]).hypot(f64::from(touch.normal[1]));
        let normal = touch.normal.map(|c| exact(f64::from(c)) / exact(length));
        let frame = [normal.clone(), [normal[1].clone(), -normal[0].clone()]];
        let p = touch.point.map(exact);
        [0, 1].map(|a| {
            let axis = &frame[a];
            let mut v = Affine::constant(n, exact(touch.command[a]));
            v.row[0] = -axis[0].clone();
            v.row[1] = -axis[1].clone();
            v.row[2] = &axis[0] * &p[1] - &axis[1] * &p[0];
            for (k, (finger, j, knuckle)) in joints.iter().enumerate() {
                if *finger == touch.finger && *j < touch.link {
                    let c = knuckle.point.map(exact);
                    v.row[3 + k] = -&axis[0] * (&p[1] - &c[1]) + &axis[1] * (&p[0] - &c[0]);
                }
            }
            v
        })
    }

    pub(super) fn census(&self) -> Verdict {
        let joints = self.joints();
        let n = 3 + joints.len();
        let mut parts: Vec<Vec<Choice>> = Vec::new();
        for touch in &self.touches {
            let v = self.stretches(touch);
            let [kn, kt] = touch.stiffness.map(exact);
            let mu = exact(touch.friction);
            let (normal, stuck) = (v[0].times(&kn), v[1].times(&kt));
            let mut options = vec![Choice {
                forces: vec![Affine::zero(n), Affine::zero(n)],
                conditions: vec![v[0].times(&-Q::one())],
            }];
            let edge = normal.times(&mu);
            options.push(Choice {
                forces: vec![normal.clone(), stuck.clone()],
                conditions: vec![
                    normal.clone(),
                    edge.clone().plus(&stuck, &Q::one()),
                    edge.clone().plus(&stuck, &-Q::one()),
                ],
            });
            for sign in [Q::one(), -Q::one()] {
                options.push(Choice {
                    forces: vec![normal.clone(), edge.times(&sign)],
                    conditions: vec![normal.clone(), stuck.times(&sign).plus(&edge, &-Q::one())],
                });
            }
            parts.push(options);
        }
        for (k, (_, _, knuckle)) in joints.iter().enumerate() {
            let mut elastic = Affine::constant(n, exact(knuckle.command) * exact(knuckle.stiffness));
            elastic.row[3 + k] = -exact(knuckle.stiffness);
            parts.push(bounded(n, &elastic, knuckle.bound.map(|b| [-b.bound(), b.bound()])));
        }
        if let Some(cable) = &self.cable {
            let k = exact(cable.stiffness);
            let mut elastic = Affine::constant(n, exact(cable.pull) * &k);
            for (j, arm) in cable.arms.iter().enumerate() {
                elastic.row[3 + j] = -exact(*arm) * &k;
            }
            let mut options =
                vec![Choice { forces: vec![Affine::zero(n)], conditions: vec![elastic.times(&-Q::one())] }];
            let mut taut = vec![elastic.clone()];
            if let Some(bound) = cable.bound {
                let over = elastic.clone().plus(&Affine::constant(n, exact(bound)), &-Q::one());
                taut.push(over.times(&-Q::one()));
                options
                    .push(Choice { forces: vec![Affine::constant(n, exact(bound))], conditions: vec![over] });
            }
            options.push(Choice { forces: vec![elastic], conditions: taut });
            parts.push(options);
        }
        let mut choice = vec![0; parts.len()];
        let mut found: Vec<Exact> = Vec::new();
        loop {
            match self.solve(&parts, &choice, &joints, n) {
                Some(None) => return Verdict::Borderline,
                Some(Some(solution)) => found.push(solution),
                None => {}
            }
            let Some(place) = (0..choice.len()).find(|&i| choice[i] + 1 < parts[i].len()) else { break };
            choice[place] += 1;
            choice[..place].fill(0);
        }
        Verdict::Clear(found)
    }

    /// The equilibrium of a combination of states, if it has one. `Some(None)` if a condition holds with equality, so that it is a borderline case.
    #[allow(clippy::option_option)]
    fn solve(
        &self,
        parts: &[Vec<Choice>],
        choice: &[usize],
        joints: &[(usize, usize, Knuckle)],
        n: usize,
    ) -> Option<Option<Exact>> {
        let mut balance: Vec<Affine> = (0..n).map(|_| Affine::zero(n)).collect();
        for (row, w) in balance.iter_mut().zip(self.load) {
            row.constant += exact(w);
        }
        for (i, touch) in self.touches.iter().enumerate() {
            let v = self.stretches(touch);
            let chosen = &parts[i][choice[i]];
            for a in 0..2 {
                let force = &chosen.forces[a];
                // The generalised force on a coordinate is minus the force times the derivative of the stretch.
                for k in 0..n {
                    let arm = -v[a].row[k].clone();
                    balance[k] = balance[k].clone().plus(force, &arm);
                }
            }
        }
        for (k, (_, _, knuckle)) in joints.iter().enumerate() {
            let drive = &parts[self.touches.len() + k][choice[self.touches.len() + k]].forces[0];
            balance[3 + k] = balance[3 + k].clone().plus(drive, &Q::one());
            balance[3 + k].constant += exact(knuckle.torque);
        }
        let mut first = 0;
        for (finger, coupling) in self.fingers.iter().zip(&self.coupling) {
            if let Some(matrix) = coupling {
                for a in 0..finger.len() {
                    for b in 0..finger.len() {
                        balance[3 + first + a].row[3 + first + b] -= exact(matrix[a][b]);
                        balance[3 + first + a].constant += exact(matrix[a][b]) * exact(finger[b].command);
                    }
                }
            }
            first += finger.len();
        }
        if let Some(cable) = &self.cable {
            let last = parts.len() - 1;
            for (j, arm) in cable.arms.iter().enumerate() {
                balance[3 + j] =
                    balance[3 + j].clone().plus(&parts[last][choice[last]].forces[0], &exact(*arm));
                balance[3 + j].constant += exact(*arm) * exact(cable.tension);
            }
        }
        let x = match solved(&balance, n) {
            Solved::Point(x) => x,
            Solved::Nothing => return None,
            Solved::Family => return Some(None),
        };
        let mut tie = false;
        for (part, &chosen) in parts.iter().zip(choice) {
            for condition in &part[chosen].conditions {
                let value = condition.at(&x);
                if value.is_negative() {
                    return None;
                }
                tie |= value.is_zero();
            }
        }
        if tie {
            return Some(None);
        }
        let forces = (0..self.touches.len())
            .map(|i| [0, 1].map(|a| float(&parts[i][choice[i]].forces[a].at(&x))))
            .collect();
        Some(Some(Exact { forces, joints: x[3..].iter().map(float).collect() }))
    }

    pub(super) fn grasp(&self) -> Result<Grasp, grasp_lcp::Error> {
        let fingers = self.fingers.iter().enumerate().map(|(f, joints)| {
            let joints = joints.iter().map(|k| {
                let joint =
                    Joint::revolute(k.point).stiffness(k.stiffness).command(k.command).torque(k.torque);
                if let Some(bound) = k.bound { joint.limit(bound) } else { joint }
            });
            let mut finger = Finger::new(joints);
            if let Some(matrix) = &self.coupling[f] {
                finger = finger.coupled(DMatrix::from_fn(matrix.len(), matrix.len(), |a, b| matrix[a][b]));
            }
            for touch in self.touches.iter().filter(|touch| touch.finger == f) {
                let contact = Contact::new(touch.point, touch.normal.map(f64::from))
                    .series_stiffness(touch.stiffness[0], touch.stiffness[1])
                    .friction(touch.friction)
                    .command(touch.command);
                finger = finger.contact_on(touch.link, contact);
            }
            finger
        });
        let mut hand = Hand::new(fingers);
        if let Some(cable) = &self.cable {
            let mut tendon = Tendon::new(cable.arms.clone())
                .stiffness(cable.stiffness)
                .pull(cable.pull)
                .tension(cable.tension);
            if let Some(bound) = cable.bound {
                tendon = tendon.limit(Limit::Saturates(bound));
            }
            hand = hand.tendon(tendon);
        }
        hand.grasp()
    }
}

/// The states of a spring with two force bounds.
fn bounded(n: usize, elastic: &Affine, bounds: Option<[f64; 2]>) -> Vec<Choice> {
    let Some(bounds) = bounds else {
        return vec![Choice { forces: vec![elastic.clone()], conditions: vec![] }];
    };
    let past = |bound: f64, sign: f64| {
        elastic.clone().plus(&Affine::constant(n, exact(bound)), &-Q::one()).times(&exact(sign))
    };
    let [below, above] = [past(bounds[0], -1.0), past(bounds[1], 1.0)];
    let inside = [&below, &above].map(|c| c.times(&-Q::one())).to_vec();
    vec![
        Choice { forces: vec![elastic.clone()], conditions: inside },
        Choice { forces: vec![Affine::constant(n, exact(bounds[0]))], conditions: vec![below] },
        Choice { forces: vec![Affine::constant(n, exact(bounds[1]))], conditions: vec![above] },
    ]
}
