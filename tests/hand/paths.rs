//! Events on load paths of hands agree with a sequence of equilibria in small load steps, in the plane and in space.

use grasp_lcp::Limit;
use grasp_lcp::{planar, spatial};
use support::samples::{assert_met, samples, seeded};
use support::splitmix::Random;

/// A planar hand of two fingers of two joints.
fn plane(numbers: &mut Random, limit: fn(f64) -> Limit) -> planar::Grasp {
    let mut finger = |x: f64| {
        let mut joint = |px: f64, py: f64, bound: f64| {
            let point = [x * (px + 0.2 * numbers.uniform()), py + 0.2 * numbers.signed()];
            planar::hand::Joint::revolute(point)
                .stiffness(40.0 + 30.0 * numbers.uniform())
                .limit(limit(bound * (1.0 + 0.4 * numbers.uniform())))
        };
        let joints = [joint(1.3, -1.0, 3.3), joint(1.2, 0.4, 1.5)];
        let normal = [-x, 0.2 * numbers.signed()];
        let pad = planar::Contact::new([x, 0.2 * numbers.signed()], normal)
            .series_stiffness(2e3, 1.5e3)
            .friction(0.9 + 0.4 * numbers.uniform())
            .pressed_with(3.0);
        planar::hand::Finger::new(joints).contact(pad)
    };
    planar::hand::Hand::new([finger(-1.0), finger(1.0)]).grasp().expect("well posed")
}

/// Saturating drives have no memory. So a path without contact slip passes through equilibria at rest: after every event its state agrees with
/// `solve`, and between events no state changes.
#[test]
fn saturating_joints_pass_through_equilibria_at_rest() {
    let mut numbers = seeded(19);
    let (mut yields, mut compared) = (0, 0);
    for _ in 0..samples(40) {
        let grasp = plane(&mut numbers, Limit::Saturates);
        let load =
            planar::Wrench::new([2.0 * numbers.signed(), 2.0 * numbers.signed()], 0.5 * numbers.signed());
        let mut path =
            grasp.follow(planar::Wrench::ZERO, &[planar::Leg::load_to(load * 3.0)]).expect("a load");
        let mut slid = false;
        let mut from = 0.0;
        while let Some(event) = path.next() {
            let middle = 0.5 * (from + event.fraction);
            if !slid && event.fraction > from {
                let on_the_path = path.state_at(0, middle).expect("has passed");
                let outcome = grasp.solve(load * (3.0 * middle)).expect("a load");
                let at_rest = outcome.equilibrium().unwrap();
                for (a, b) in on_the_path.contacts.iter().zip(&at_rest.contacts) {
                    assert!((a.force - b.force).norm() < 1e-9, "{} {}", a.force, b.force);
                }
                for (a, b) in on_the_path.joints.iter().zip(&at_rest.joints) {
                    assert!((a.torque - b.torque).abs() < 1e-9 && (a.yielded - b.yielded).abs() < 1e-10);
                }
                compared += 1;
            }
            yields += event.drives.len();
            slid |= !event.changes.is_empty();
            from = event.fraction;
        }
    }
    assert_met(&[(yields, 20), (compared, 20)]);
}

/// The path of a slipping joint agrees with many short steps. Each is an equilibrium at rest with the commands minus the previous slip, because a clutch is a
/// spring whose command moves with the slip.
#[test]
fn slipping_joints_follow_small_steps() {
    let mut numbers = seeded(23);
    let mut slipped = 0;
    for _ in 0..samples(12) {
        let grasp = plane(&mut numbers, Limit::Slips);
        let load =
            planar::Wrench::new([2.0 * numbers.signed(), 0.3 * numbers.signed()], 0.1 * numbers.signed());
        let legs = [planar::Leg::load_to(load * 3.0), planar::Leg::load_to(load * -1.0)];
        let mut path = grasp.follow(planar::Wrench::ZERO, &legs).expect("a load");
        let events = path.run();
        if events.iter().any(|event| !event.changes.is_empty()) || path.state_at(1, 1.0).is_none() {
            continue;
        }
        let mut memory = grasp.clone();
        let steps = 400;
        for k in 1..=2 * steps {
            let part = f64::from(k) / f64::from(steps);
            let factor = if part <= 1.0 { 3.0 * part } else { 3.0 - 4.0 * (part - 1.0) };
            let outcome = memory.solve(load * factor).expect("a load");
            let at_rest = outcome.equilibrium().expect("holds");
            let shifted: Vec<f64> =
                memory.joint_commands().iter().zip(&at_rest.joints).map(|(c, j)| c - j.yielded).collect();
            memory = memory.with_joint_commands(&shifted).expect("as many");
        }
        let outcome = memory.solve(load * -1.0).expect("a load");
        let (stepped, followed) =
            (outcome.equilibrium().expect("holds"), path.state_at(1, 1.0).expect("has passed"));
        for (a, b) in stepped.contacts.iter().zip(&followed.contacts) {
            assert!((a.force - b.force).norm() < 1e-9 * a.force.norm().max(1.0), "{} {}", a.force, b.force);
        }
        slipped += usize::from(followed.joints.iter().any(|j| j.yielded.abs() > 1e-4));
    }
    assert_met(&[(slipped, 2)]);
}

/// In space, with sliding contacts on round cones and saturating joints, all states on the path satisfy the conditions of equilibrium.
#[test]
fn in_space_every_state_on_the_way_is_an_equilibrium() {
    let mut numbers = seeded(29);
    let (mut states, mut yields, mut slides) = (0, 0, 0);
    for round in 0..samples(10) {
        let limit = if round % 2 == 0 { Limit::Saturates } else { Limit::Slips };
        let mut finger = |k: u32| {
            let (sin, cos) = (f64::from(k) * std::f64::consts::TAU / 3.0 + 0.2 * numbers.signed()).sin_cos();
            let mut joint = |height: f64, bound: f64| {
                let point = [1.3 * cos, 1.3 * sin, height + 0.1 * numbers.signed()];
                let axis = [sin + 0.1 * numbers.signed(), -cos, 0.1 * numbers.signed()];
                spatial::hand::Joint::revolute(point, axis)
                    .stiffness(60.0)
                    .limit(limit(bound * (1.0 + numbers.uniform())))
            };
            let joints = [joint(-1.0, 3.6), joint(-0.4, 1.8)];
            let pad = spatial::Contact::new([cos, sin, 0.1 * numbers.signed()], [-cos, -sin, 0.1])
                .series_stiffness(2e3, 1.5e3)
                .friction(0.5)
                .pressed_with(3.0);
            spatial::hand::Finger::new(joints).contact(pad)
        };
        let grasp: spatial::Grasp =
            spatial::hand::Hand::new((0..3).map(&mut finger)).grasp().expect("well posed");
        let load = spatial::Wrench::force(numbers.vector().map(|f| 12.0 * f));
        let mut path = grasp.follow(spatial::Wrench::ZERO, &[spatial::Leg::load_to(load)]).expect("a load");
        let events = path.run();
        yields += events.iter().map(|event| event.drives.len()).sum::<usize>();
        slides += events.iter().map(|event| event.changes.len()).sum::<usize>();
        if path.state().is_none() {
            continue;
        }
        let (_, end) = path.place();
        for k in 0..20 {
            let state = path.state_at(0, end * f64::from(k) / 20.0).expect("has passed");
            assert!(state.residuals.worst() < 1e-9, "{:?}", state.residuals);
            states += 1;
        }
    }
    assert_met(&[(states, 100), (yields, 3), (slides, 5)]);
}
