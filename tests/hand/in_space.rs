//! Answers for spatial hands agree with the linear system for twist and joints, solved with a hundred digits.

use grasp_lcp::equilibrium::FoundBy;
use grasp_lcp::nalgebra::{DMatrix, Vector3};
use grasp_lcp::spatial::Contact;
use grasp_lcp::spatial::hand::{Finger, Hand, Joint};
use grasp_lcp::spatial::{Grasp, Wrench};
use support::dyadic::{Dyadic, solve};
use support::samples::{assert_met, samples, seeded};
use support::splitmix::Random;

const BITS: u64 = 400;

/// Number of joints of a finger.
const JOINTS: usize = 4;

struct Tip {
    point: [f64; 3],
    normal: [f64; 3],
    pad: [f64; 2],
    friction: f64,
    command: f64,
    jacobian: DMatrix<f64>,
    stiffness: [f64; JOINTS],
    commands: [f64; JOINTS],
}

fn tips(count: usize, ratio: f64, numbers: &mut Random) -> Vec<Tip> {
    let turn = std::f64::consts::TAU / count as f64;
    let tip = |k: usize, numbers: &mut Random| {
        let angle = turn * (k as f64 + 0.2 * numbers.signed());
        let outward = Vector3::new(angle.cos(), angle.sin(), 0.3 * numbers.signed());
        let normal = -outward + 0.1 * Vector3::from(numbers.vector());
        let jacobian = DMatrix::from_fn(3, JOINTS, |_, _| 0.05 * numbers.signed());
        let stiffness = [0; JOINTS].map(|_| 1.0 + 4.0 * numbers.uniform());
        let pad = 2e3 * ratio * (1.0 + numbers.uniform());
        let force = 10.0 * (1.0 + 0.1 * numbers.signed());
        // Joints and pad are commanded for the squeeze.
        let unit = normal.normalize() * force;
        let torque = |j: usize| (0..3).map(|a| jacobian[(a, j)] * unit[a]).sum::<f64>();
        let commands = std::array::from_fn(|j| torque(j) / stiffness[j]);
        Tip {
            point: (outward * 0.04).into(),
            normal: normal.into(),
            pad: [pad, 0.7 * pad],
            friction: 0.6,
            command: force / pad,
            jacobian,
            stiffness,
            commands,
        }
    };
    (0..count).map(|k| tip(k, numbers)).collect()
}

fn grasp(tips: &[Tip]) -> Grasp {
    let finger = |tip: &Tip| {
        let joints =
            tip.stiffness.iter().zip(tip.commands).map(|(k, c)| Joint::given().stiffness(*k).command(c));
        let contact = Contact::new(tip.point, tip.normal)
            .series_stiffness(tip.pad[0], tip.pad[1])
            .friction(tip.friction)
            .command([tip.command, 0.0, 0.0]);
        Finger::new(joints).contact_moved_by(tip.jacobian.clone(), contact)
    };
    Hand::new(tips.iter().map(finger)).grasp().expect("well posed")
}

fn d(x: f64) -> Dyadic {
    Dyadic::new(x)
}

/// Contact forces while everything sticks, exact except for the last division.
struct Sticking {
    matrix: Vec<Vec<Dyadic>>,
    /// For each axis of each contact, the row that maps twist and joint displacements (q, φ) to the displacement along this axis.
    rows: Vec<[Vec<Dyadic>; 3]>,
    k: Vec<[f64; 3]>,
}

impl Sticking {
    fn new(tips: &[Tip], grasp: &Grasp) -> Self {
        let n = 6 + JOINTS * tips.len();
        let mut matrix = vec![vec![Dyadic::zero(); n]; n];
        let (mut rows, mut stiffnesses) = (Vec::new(), Vec::new());
        for (i, (tip, frame)) in tips.iter().zip(grasp.frames()).enumerate() {
            let k = [tip.pad[0], tip.pad[1], tip.pad[1]];
            let of_axis = [0, 1, 2].map(|a| {
                let mut row = vec![Dyadic::zero(); n];
                let axis = [0, 1, 2].map(|b| d(frame[(b, a)]));
                for b in 0..3 {
                    row[b] = axis[b].clone();
                    let (x, y) = ((b + 1) % 3, (b + 2) % 3);
                    row[3 + b] = &(&d(tip.point[x]) * &axis[y]) - &(&d(tip.point[y]) * &axis[x]);
                    for j in 0..JOINTS {
                        let place = 6 + JOINTS * i + j;
                        row[place] = &row[place] - &(&axis[b] * &d(tip.jacobian[(b, j)]));
                    }
                }
                row
            });
            for (row, k) in of_axis.iter().zip(k) {
                for a in 0..n {
                    if row[a].is_zero() {
                        continue;
                    }
                    for b in 0..n {
                        matrix[a][b] = &matrix[a][b] + &(&(&row[a] * &row[b]) * &d(k));
                    }
                }
            }
            for j in 0..JOINTS {
                let place = 6 + JOINTS * i + j;
                matrix[place][place] = &matrix[place][place] + &d(tip.stiffness[j]);
            }
            rows.push(of_axis);
            stiffnesses.push(k);
        }
        Self { matrix, rows, k: stiffnesses }
    }

    /// Contact forces under a load; commands are included if `commanded`.
    fn forces(&self, tips: &[Tip], load: &Wrench, commanded: bool) -> Vec<[Dyadic; 3]> {
        let n = self.matrix.len();
        let mut side: Vec<Dyadic> =
            (0..n).map(|k| d(load.components().get(k).copied().unwrap_or(0.0))).collect();
        if commanded {
            for (i, tip) in tips.iter().enumerate() {
                let push = &d(self.k[i][0]) * &d(tip.command);
                for (b, side) in side.iter_mut().enumerate() {
                    *side = &*side + &(&self.rows[i][0][b] * &push);
                }
                for j in 0..JOINTS {
                    let place = 6 + JOINTS * i + j;
                    side[place] = &side[place] + &(&d(tip.stiffness[j]) * &d(tip.commands[j]));
                }
            }
        }
        let x = solve(&self.matrix, &side, BITS).expect("regular");
        let force = |(i, tip): (usize, &Tip)| {
            [0, 1, 2].map(|a| {
                let drive = if commanded && a == 0 { d(tip.command) } else { Dyadic::zero() };
                let v = self.rows[i][a].iter().zip(&x).fold(drive, |v, (g, x)| &v - &(g * x));
                &v * &d(self.k[i][a])
            })
        };
        tips.iter().enumerate().map(force).collect()
    }
}

/// `(μ F_n)² - |F_t|²` at a factor, and its derivative with respect to the factor.
fn margin(mu: f64, base: &[Dyadic; 3], rate: &[Dyadic; 3], factor: f64) -> (Dyadic, Dyadic) {
    let at = [0, 1, 2].map(|a| &base[a] + &(&rate[a] * &d(factor)));
    let weight = [&d(mu) * &d(mu), d(-1.0), d(-1.0)];
    let mut sums = (Dyadic::zero(), Dyadic::zero());
    for a in 0..3 {
        sums.0 = &sums.0 + &(&weight[a] * &(&at[a] * &at[a]));
        sums.1 = &sums.1 + &(&(&weight[a] * &(&at[a] * &rate[a])) * &d(2.0));
    }
    sums
}

#[test]
fn onsets_and_forces_are_right_to_the_last_digits() {
    let mut numbers = seeded(7);
    let (mut onsets, mut worst, mut worst_force) = (0, 0.0_f64, 0.0_f64);
    for number in 0..samples(10) {
        let ratio = 10f64.powi([0, 3, 6, 9, 12][number % 5]);
        let tips = tips(3 + number % 3, ratio, &mut numbers);
        let grasp = grasp(&tips);
        let load = Wrench::new(numbers.vector(), numbers.vector().map(|m| 0.02 * m));
        let outcome = grasp.solve(Wrench::ZERO).expect("a load");
        let Some(rest) = outcome.equilibrium().filter(|e| e.rule == FoundBy::EverythingSticks) else {
            continue;
        };
        let sticking = Sticking::new(&tips, &grasp);
        let base = sticking.forces(&tips, &Wrench::ZERO, true);
        let largest = rest.contacts.iter().map(|c| c.force.norm()).fold(0.0, f64::max);
        for (exact, found) in base.iter().zip(&rest.contacts) {
            for a in 0..3 {
                worst_force = worst_force.max((&exact[a] - &d(found.force[a])).float().abs() / largest);
            }
        }
        let rate = sticking.forces(&tips, &load, false);
        let onset = grasp.onset(load).expect("loads");
        let Some(event) = onset.event() else { continue };
        for (i, tip) in tips.iter().enumerate() {
            let (value, slope) = margin(tip.friction, &base[i], &rate[i], event.factor);
            if event.leaving[0].contact.index == i {
                worst = worst.max((value.float() / slope.float() / event.factor).abs());
                onsets += 1;
            } else {
                assert!(!value.is_negative(), "{number} {i}");
            }
        }
    }
    println!("{onsets} onsets, worst factor {worst:e}, worst force {worst_force:e}");
    assert_met(&[(onsets, 6)]);
    assert!(worst < 1e-13 && worst_force < 1e-13);
}
