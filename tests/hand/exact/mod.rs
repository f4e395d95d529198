//! The library agrees with exhaustive enumeration in rational arithmetic on planar hands.

mod affine;
mod census;

use grasp_lcp::Limit;
use grasp_lcp::planar::Wrench;
use grasp_lcp::planar::hand::DriveState;
use grasp_lcp::planar::{Equilibrium, Outcome};
use support::samples::{assert_met, samples, seeded};
use support::splitmix::Random;

use census::{Cable, Exact, Knuckle, Scene, Touch, Verdict};

/// Converts a small integer to an index.
fn index(whole: f64) -> usize {
    (0..16).find(|k| f64::from(*k) >= whole).map_or(0, |k: u8| k.into())
}

/// A random hand of two fingers with one or two contacts each.
fn scene(numbers: &mut Random, kind: usize) -> Scene {
    let mut pick = |most: f64| (numbers.uniform() * most).floor();
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

fn apart(exact: &Exact, found: &Equilibrium) -> f64 {
    let size = exact.forces.iter().flatten().fold(1.0_f64, |most, f| most.max(f.abs()));
    let forces =
        exact.forces.iter().zip(&found.contacts).flat_map(|(a, b)| [a[0] - b.force[0], a[1] - b.force[1]]);
    let motion = exact.joints.iter().fold(1.0_f64, |most, f| most.max(f.abs()));
    let joints = exact.joints.iter().zip(&found.joints).map(|(a, b)| (a - b.displacement) / motion);
    forces.map(|f| f / size).chain(joints).fold(0.0, |most, x| most.max(x.abs()))
}

#[test]
fn every_equilibrium_of_a_hand_is_found_and_none_is_denied() {
    let mut numbers = seeded(41);
    let (mut clear, mut held, mut several, mut none, mut yields, mut slack, mut undecided) =
        (0, 0, 0, 0, 0, 0, 0);
    for number in 0..samples(60) {
        let scene = scene(&mut numbers, number % 6);
        let grasp = scene.grasp().expect("well posed");
        let load = Wrench::new([scene.load[0], scene.load[1]], scene.load[2]);
        let Verdict::Clear(list) = scene.census() else { continue };
        clear += 1;
        match grasp.solve(load).expect("a load") {
            Outcome::Equilibrium(found) => {
                held += 1;
                let nearest = list.iter().map(|e| apart(e, &found)).fold(f64::INFINITY, f64::min);
                assert!(nearest < 1e-9, "{number} {nearest} {}", list.len());
                yields += usize::from(found.joints.iter().any(|j| j.state == DriveState::Yields));
                slack += usize::from(found.tendons.iter().any(|t| t.state == DriveState::Slack));
            }
            Outcome::NoEquilibrium(proof) => {
                none += 1;
                assert!(list.is_empty(), "{number} {proof:?} {}", list.len());
            }
            _ => undecided += 1,
        }
        let all = grasp.equilibria(load).expect("few states");
        assert_eq!(all.len(), list.len(), "{number}");
        several += usize::from(list.len() > 1);
        for e in &list {
            assert!(all.iter().any(|found| apart(e, found) < 1e-9), "{number}");
        }
    }
    println!(
        "{clear} clear, {held} held, {none} none, {several} several, {yields} yield, {slack} slack, {undecided} undecided"
    );
    assert_eq!(undecided, 0);
    assert_met(&[(clear, 33), (held, 8), (none, 3), (several, 1), (yields, 3), (slack, 0)]);
}
