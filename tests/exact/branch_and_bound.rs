//! On the round cone every question is decided, also for loads far above that of first slip. The answer is an equilibrium, or a proof whose cases can
//! all be checked. If the proof says that no equilibrium exists, Newton's method from many starting points finds none either.

use std::f64::consts::TAU;
use std::ops::AddAssign;

use grasp_lcp::equilibrium::{Outcome, Proof};
use grasp_lcp::spatial::{Contact, Grasp, Wrench};
use nalgebra::{SMatrix, SVector};
use support::jaws::jaw;
use support::samples::{assert_met, samples, seeded};
use support::splitmix::Random;

/// The data of a finger, for the library and for [`breach`].
struct Finger {
    point: SVector<f64, 3>,
    normal: SVector<f64, 3>,
    stiffness: [f64; 2],
    friction: f64,
    press: f64,
}

fn fingers(count: usize, spread: f64, friction: [f64; 2], numbers: &mut Random) -> Vec<Finger> {
    let finger = |i: usize| {
        let (sin, cos) = (TAU * i as f64 / count as f64 + 0.3 * numbers.signed()).sin_cos();
        let point = SVector::from([cos, sin, 0.3 * numbers.signed()]);
        let normal = SVector::from([-cos, -sin, 0.2 * numbers.signed()]).normalize();
        let k = 1000.0 * (spread * numbers.signed()).exp();
        let friction = friction[0] * (friction[1] / friction[0]).powf(0.5 + 0.5 * numbers.signed());
        let stiffness = [k, k * (0.75 + 0.15 * numbers.signed())];
        Finger { point, normal, stiffness, friction, press: 0.01 + 0.005 * numbers.signed() }
    };
    (0..count).map(finger).collect()
}

fn grasp(fingers: &[Finger]) -> Grasp {
    let contact = |f: &Finger| {
        let [normal, tangential] = f.stiffness;
        Contact::new(f.point, f.normal)
            .series_stiffness(normal, tangential)
            .friction(f.friction)
            .command([f.press, 0.0, 0.0])
    };
    Grasp::new(fingers.iter().map(contact)).unwrap()
}

/// The residual of the balance at a twist of the object, with the force of every finger by its contact law.
fn breach(fingers: &[Finger], load: &SVector<f64, 6>, twist: &SVector<f64, 6>) -> SVector<f64, 6> {
    let mut sum = *load;
    for f in fingers {
        let (shift, turn) = (twist.fixed_rows::<3>(0), twist.fixed_rows::<3>(3));
        let moved = shift + turn.cross(&f.point);
        let give = f.normal * f.press - moved;
        let pressed = f.stiffness[0] * give.dot(&f.normal);
        if pressed <= 0.0 {
            continue;
        }
        let traction = (give - f.normal * give.dot(&f.normal)) * f.stiffness[1];
        let share = (f.friction * pressed / traction.norm().max(f64::MIN_POSITIVE)).min(1.0);
        let force = f.normal * pressed + traction * share;
        sum.fixed_rows_mut::<3>(0).add_assign(&force);
        sum.fixed_rows_mut::<3>(3).add_assign(&f.point.cross(&force));
    }
    sum
}

/// Newton's method with finite differences, starting at a twist. Returns whether it finds a balance.
fn newton(fingers: &[Finger], load: &SVector<f64, 6>, mut twist: SVector<f64, 6>) -> bool {
    let mut left = breach(fingers, load, &twist);
    for _ in 0..30 {
        if left.norm() <= 1e-9 * load.norm() {
            return true;
        }
        let slope = SMatrix::<f64, 6, 6>::from_fn(|i, j| {
            let mut near = twist;
            near[j] += 1e-8;
            (breach(fingers, load, &near)[i] - left[i]) / 1e-8
        });
        let Some(step) = slope.lu().solve(&left) else { return false };
        let mut part = 1.0;
        while part > 1e-3 && breach(fingers, load, &(twist - step * part)).norm() > left.norm() {
            part *= 0.5;
        }
        twist -= step * part;
        left = breach(fingers, load, &twist);
    }
    false
}

/// Whether Newton's method finds a balance from any of twenty random twists.
fn attack(fingers: &[Finger], load: &Wrench, numbers: &mut Random) -> bool {
    let load = SVector::from(load.to_vector());
    (0..20).any(|_| newton(fingers, &load, SVector::from_fn(|_, _| 0.05 * numbers.signed())))
}

#[test]
fn every_load_beyond_the_onset_is_decided() {
    let mut numbers = seeded(3);
    let (mut found, mut none, mut reached) = (0, 0, 0);
    for (spread, friction) in [(0.3, [0.3, 0.6]), (0.3, [1e-2, 5.0]), (5.0, [0.2, 0.8])] {
        for count in [3, 3, 4, 4, 5, 6, 8].into_iter().cycle().take(samples(14)) {
            let fingers = fingers(count, spread, friction, &mut numbers);
            let grasp = grasp(&fingers);
            let direction = Wrench::new(numbers.vector(), numbers.vector().map(|x| 0.3 * x));
            let onset = grasp.onset(direction).unwrap();
            let Some(onset) = onset.factor().filter(|factor| factor.is_finite()) else { continue };
            for part in [1.15, 2.5, 6.0] {
                let load = direction * (part * onset);
                match grasp.solve(load).unwrap() {
                    Outcome::Equilibrium(e) => {
                        assert!(e.residuals.worst() <= 1e-12);
                        found += 1;
                        reached += usize::from(attack(&fingers, &load, &mut numbers));
                    }
                    Outcome::NoEquilibrium(answer) => {
                        none += 1;
                        if let Proof::EveryCaseContradicted { escape, .. } = answer.proof {
                            assert!(escape >= 1e4);
                            let proof = grasp.refutation(load).unwrap().expect("again");
                            let checked = proof.check(&grasp, load).unwrap().expect("it holds");
                            // Where `check` contradicts a case in closed form, its factor of safety is at least about that of polygons around the
                            // arcs of the cone.
                            assert!(checked >= 0.5 * escape, "{checked:e} {escape:e}");
                        }
                        let balanced = attack(&fingers, &load, &mut numbers);
                        assert!(!balanced, "{count} {part}");
                    }
                    other => panic!("{count} {part} {other:?}"),
                }
            }
        }
    }
    println!("{found} {none} {reached}");
    assert_met(&[(found, 40), (none, 10)]);
    // A failed search is evidence only if the search usually finds existing equilibria.
    assert!(10 * reached >= 7 * found);
}

/// Two fingers press with 10 N, μ = 1/2. They hold at most 10 N in every perpendicular direction.
#[test]
fn the_limit_of_a_pinch() {
    let finger = |x: f64| jaw::<3>(x, [1000.0, 800.0], 0.5).command([0.01, 0.0, 0.0]);
    let grasp = Grasp::new([finger(-1.0), finger(1.0)]).unwrap();
    for angle in [0.0_f64, 0.3, 1.1, 2.0] {
        let across = Wrench::force([0.0, angle.cos(), angle.sin()]);
        let outcome = |load: f64| grasp.solve(across * load).unwrap();
        assert!(outcome(10.0 * (1.0 - 1e-9)).equilibrium().is_some());
        for excess in [1e-9, 1e-6, 1e-3, 1.0, 1e3] {
            let beyond = outcome(10.0 * (1.0 + excess));
            assert!(matches!(beyond, Outcome::NoEquilibrium(_)), "{excess:e}: {beyond:?}");
        }
    }
}

/// A proof is valid only for its own grasp and load.
#[test]
fn a_proof_holds_for_its_own_scene_alone() {
    let mut numbers = Random(6);
    let [one, other] = [0, 1].map(|_| grasp(&fingers(4, 0.3, [0.3, 0.6], &mut numbers)));
    let load = Wrench::force([0.0, 0.0, -60.0]);
    let proof = one.refutation(load).unwrap().expect("too heavy");
    assert!(proof.cases() > 1);
    assert!(proof.check(&one, load).unwrap().is_some_and(|escape| escape > 1e4));
    assert!(proof.check(&one, load * 0.1).unwrap().is_none());
    assert!(proof.check(&other, load).unwrap().is_none());
}

/// For every kind of contact, a load with an equilibrium has no proof of non-existence.
#[test]
fn no_proof_contradicts_an_equilibrium() {
    let mut numbers = seeded(11);
    let (mut held, mut refuted) = (0, 0);
    for scene in 0..samples(100) {
        let contact = |i: usize| {
            let (sin, cos) = (TAU * i as f64 / 5.0 + 0.4 * numbers.signed()).sin_cos();
            let k = 1000.0 * (2.0 * numbers.signed()).exp();
            let stiffness = [k, k * (0.6 + 0.4 * numbers.signed()), k * (0.6 + 0.4 * numbers.signed())];
            let contact =
                Contact::new([cos, sin, 0.4 * numbers.signed()], [-cos, -sin, 0.4 * numbers.signed()])
                    .series_stiffness_axes(stiffness)
                    .command([
                        0.01 * (0.6 + numbers.signed()),
                        0.003 * numbers.signed(),
                        0.003 * numbers.signed(),
                    ]);
            // Two contacts with round cones, and three of any kind.
            let kind = if i < 2 { 0.0 } else { numbers.uniform() };
            let friction = if kind < 0.4 { 0.4 + 0.3 * numbers.signed() } else { 0.0 };
            let friction = if kind >= 0.7 { f64::INFINITY } else { friction };
            let contact = contact.friction(friction);
            if i < 2 || numbers.signed() < 0.0 { contact } else { contact.kept_closed() }
        };
        let grasp = Grasp::new((0..5).map(contact).collect::<Vec<_>>()).unwrap();
        let load = Wrench::new(numbers.vector(), numbers.vector()) * (10.0 * (3.0 * numbers.signed()).exp());
        let outcome = grasp.solve(load).unwrap();
        let proof = grasp.refutation(load).unwrap();
        held += usize::from(outcome.equilibrium().is_some());
        refuted += usize::from(proof.is_some());
        assert!(outcome.equilibrium().is_none() || proof.is_none(), "{scene} {grasp:?} {load:?}");
    }
    println!("{held} {refuted}");
    assert_met(&[(held, 25), (refuted, 5)]);
}
