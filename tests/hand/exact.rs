//! Planar hands and exhaustive enumeration in rationals say the same.
//!
//! The oracle knows nothing of the library's coordinates: a joint is at one of its bounds or holds, a tendon is slack, taut or at its bound, a contact
//! is open, rolls or slides either way. Every combination is a linear system for the twist and the joint displacements.

use grasp_lcp::Limit;
use grasp_lcp::nalgebra::DMatrix;
use grasp_lcp::planar::hand::{DriveState, Finger, Grasp, Hand, Joint, Tendon, Wrench};
use grasp_lcp::planar::{Contact, Equilibrium, Outcome};
use num_rational::BigRational;
use num_traits::{FromPrimitive, One, Signed, Zero};
use support::numbers::Numbers;

type Q = BigRational;

fn exact(x: f64) -> Q {
    Q::from_f64(x).expect("finite")
}

/// One contact: normal with integer components of integer length.
struct Touch {
    point: [f64; 2],
    normal: [i32; 2],
    stiffness: [f64; 2],
    friction: f64,
    command: [f64; 2],
    finger: usize,
    /// So many of its joints move it.
    link: usize,
}

#[derive(Clone, Copy)]
struct Knuckle {
    point: [f64; 2],
    stiffness: f64,
    command: f64,
    torque: f64,
    bound: Option<Limit>,
}

struct Cable {
    arms: Vec<f64>,
    stiffness: f64,
    pull: f64,
    tension: f64,
    bound: Option<f64>,
}

struct Scene {
    touches: Vec<Touch>,
    fingers: Vec<Vec<Knuckle>>,
    coupling: Vec<Option<Vec<Vec<f64>>>>,
    cable: Option<Cable>,
    load: [f64; 3],
}

/// `row · (q, φ) + constant`.
#[derive(Clone)]
struct Affine {
    row: Vec<Q>,
    constant: Q,
}

impl Affine {
    fn zero(n: usize) -> Self {
        Self { row: vec![Q::zero(); n], constant: Q::zero() }
    }

    fn constant(n: usize, constant: Q) -> Self {
        Self { constant, ..Self::zero(n) }
    }

    fn plus(mut self, other: &Self, factor: &Q) -> Self {
        for (a, b) in self.row.iter_mut().zip(&other.row) {
            *a += b * factor;
        }
        self.constant += &other.constant * factor;
        self
    }

    fn times(&self, factor: &Q) -> Self {
        Self::zero(self.row.len()).plus(self, factor)
    }

    fn at(&self, x: &[Q]) -> Q {
        self.row.iter().zip(x).fold(self.constant.clone(), |sum, (a, x)| sum + a * x)
    }
}

/// What one part does: the force it exerts, and what must not be negative.
struct Choice {
    forces: Vec<Affine>,
    conditions: Vec<Affine>,
}

/// An equilibrium of the oracle: contact forces in the contact frames, joint displacements.
struct Exact {
    forces: Vec<[f64; 2]>,
    joints: Vec<f64>,
}

enum Verdict {
    Clear(Vec<Exact>),
    /// A condition holds with equality, or a whole family solves.
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

    fn census(&self) -> Verdict {
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

    /// The solution of a combination, if it has one; `Some(None)` where that is a matter of equality.
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
                // The force does on every coordinate minus what its stretch loses by it.
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
        let x = match eliminate(balance, n) {
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

    fn grasp(&self) -> Result<Grasp<14>, grasp_lcp::Error> {
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

/// A spring that ends at two bounds.
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

enum Solved {
    Point(Vec<Q>),
    Nothing,
    Family,
}

fn eliminate(mut rows: Vec<Affine>, n: usize) -> Solved {
    let mut singular = false;
    let mut done = 0;
    let mut pivots = Vec::new();
    for k in 0..n {
        let Some(p) = (done..rows.len()).find(|&i| !rows[i].row[k].is_zero()) else {
            singular = true;
            continue;
        };
        rows.swap(done, p);
        let scale = Q::one() / &rows[done].row[k];
        rows[done] = rows[done].times(&scale);
        for i in 0..rows.len() {
            if i != done && !rows[i].row[k].is_zero() {
                let factor = -rows[i].row[k].clone();
                let pivot = rows[done].clone();
                rows[i] = rows[i].clone().plus(&pivot, &factor);
            }
        }
        pivots.push(k);
        done += 1;
    }
    if !singular {
        return Solved::Point(rows.iter().map(|row| -row.constant.clone()).collect());
    }
    if rows[done..].iter().all(|row| row.constant.is_zero()) { Solved::Family } else { Solved::Nothing }
}

fn float(x: &Q) -> f64 {
    num_traits::ToPrimitive::to_f64(x).unwrap_or(f64::NAN)
}

/// A small whole number as an index.
fn index(whole: f64) -> usize {
    (0..16).find(|k| f64::from(*k) >= whole).map_or(0, |k: u8| k.into())
}

/// A random hand of two fingers with one or two contacts each.
fn scene(numbers: &mut Numbers, kind: usize) -> Scene {
    let mut pick = |most: f64| (numbers.part() * most).floor();
    let normals = [[4, 3], [12, 5], [24, 7], [15, 8], [63, 16], [35, 12]];
    let (mut touches, mut fingers, mut coupling) = (Vec::new(), Vec::new(), Vec::new());
    for (f, side) in [-1.0, 1.0].into_iter().enumerate() {
        let count = 1 + usize::from(!kind.is_multiple_of(3) && f == 0);
        let mut joints = Vec::new();
        for j in 0..count {
            let point = [side * (2.0 + 0.25 * pick(8.0)), -2.0 + j as f64 + 0.25 * pick(8.0)];
            let limited = kind >= 2 && pick(2.0) == 0.0;
            let bound = limited.then(|| {
                let bound = 0.125 * (1.0 + pick(6.0));
                if pick(2.0) == 0.0 { Limit::Slips(bound) } else { Limit::Saturates(bound) }
            });
            let stiffness =
                if kind == 5 && bound.is_none() && pick(3.0) == 0.0 { 0.0 } else { 1.0 + pick(12.0) };
            let command = side * (1.0 + pick(8.0)) / 8.0;
            joints.push(Knuckle { point, stiffness, command, torque: side * (pick(5.0) - 1.0) / 8.0, bound });
        }
        let n = joints.len();
        coupling.push((n == 2 && kind % 2 == 1).then(|| {
            let (a, b, c) = (1.0 + pick(4.0), pick(4.0) - 2.0, 1.0 + pick(4.0));
            // A rank-one part and a diagonal: positive semidefinite by construction.
            vec![vec![a * a + c, a * b], vec![a * b, b * b]]
        }));
        let contacts = 1 + usize::from(kind == 4 && f == 0);
        for c in 0..contacts {
            let [nx, ny] = normals[index(pick(6.0))];
            let normal = [if side < 0.0 { nx } else { -nx }, if pick(2.0) == 0.0 { ny } else { -ny }];
            touches.push(Touch {
                point: [side * (0.5 + 0.25 * pick(4.0)), 0.25 * pick(8.0) - 1.0 + c as f64],
                normal,
                stiffness: [1.0 + pick(30.0), 1.0 + pick(30.0)],
                friction: [0.25, 0.5, 0.75, 1.0, 1.5][index(pick(5.0))],
                command: [pick(6.0) / 16.0, (pick(9.0) - 4.0) / 16.0],
                finger: f,
                link: if c == 0 { n } else { 1 },
            });
        }
        fingers.push(joints);
    }
    let cable = (kind == 3).then(|| Cable {
        arms: (0..fingers.iter().map(Vec::len).sum())
            .map(|_| (1.0 + pick(4.0)) / 4.0 * if pick(2.0) == 0.0 { 1.0 } else { -1.0 })
            .collect(),
        stiffness: 1.0 + pick(20.0),
        pull: (pick(9.0) - 3.0) / 8.0,
        tension: pick(3.0) / 4.0,
        bound: (pick(2.0) == 0.0).then(|| 0.25 * (1.0 + pick(6.0))),
    });
    let load = [pick(9.0) - 4.0, pick(9.0) - 4.0, pick(5.0) - 2.0].map(|w| w / 16.0);
    Scene { touches, fingers, coupling, cable, load }
}

fn apart(exact: &Exact, found: &Equilibrium<14>) -> f64 {
    let size = exact.forces.iter().flatten().fold(1.0_f64, |most, f| most.max(f.abs()));
    let forces =
        exact.forces.iter().zip(&found.contacts).flat_map(|(a, b)| [a[0] - b.force[0], a[1] - b.force[1]]);
    let motion = exact.joints.iter().fold(1.0_f64, |most, f| most.max(f.abs()));
    let joints = exact.joints.iter().zip(&found.joints).map(|(a, b)| (a - b.displacement) / motion);
    forces.map(|f| f / size).chain(joints).fold(0.0, |most, x| most.max(x.abs()))
}

#[test]
fn every_equilibrium_of_a_hand_is_found_and_none_is_denied() {
    let mut numbers = Numbers(41);
    let (mut clear, mut held, mut several, mut none, mut yields, mut slack, mut undecided) =
        (0, 0, 0, 0, 0, 0, 0);
    for number in 0..240 {
        let scene = scene(&mut numbers, number % 6);
        let grasp = scene.grasp().expect("well posed");
        let load = Wrench::new([scene.load[0], scene.load[1]], scene.load[2]);
        let Verdict::Clear(list) = scene.census() else { continue };
        clear += 1;
        match grasp.solve(&load).expect("a load") {
            Outcome::Equilibrium(found) => {
                held += 1;
                let nearest = list.iter().map(|e| apart(e, &found)).fold(f64::INFINITY, f64::min);
                assert!(nearest < 1e-9, "{number}: {nearest} from {} equilibria", list.len());
                yields += usize::from(found.joints.iter().any(|j| j.state == DriveState::Yields));
                slack += usize::from(found.tendons.iter().any(|t| t.state == DriveState::Slack));
            }
            Outcome::NoEquilibrium(proof) => {
                none += 1;
                assert!(list.is_empty(), "{number}: {proof:?} against {} equilibria", list.len());
            }
            _ => undecided += 1,
        }
        let all = grasp.equilibria(&load).expect("few states");
        assert_eq!(all.len(), list.len(), "{number}");
        several += usize::from(list.len() > 1);
        for e in &list {
            assert!(all.iter().any(|found| apart(e, found) < 1e-9), "{number}: one is missing");
        }
    }
    println!(
        "{clear} clear, {held} held, {none} none, {several} several, {yields} yield, {slack} slack, {undecided} undecided"
    );
    assert_eq!(undecided, 0);
    assert!(clear > 200 && held > 80 && none > 20 && several > 20 && yields > 30 && slack > 2);
}
