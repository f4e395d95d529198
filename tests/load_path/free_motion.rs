//! If a motion loses all resistance in the middle of a path, the event names it, and the forces still follow statics. The path continues without this
//! motion while no load works on it, and is lost along it as soon as one does. Closed forms in the plane and in space confirm this.

use crate::story::{assert_close, assert_story, completed};
use grasp_lcp::load_path::{LossKind, PathEnd};
use grasp_lcp::{planar, spatial};
use support::ends::limit_load;
use support::jaws::jaw;
use support::programs::numbers;

/// A body between two frictionless guides rests with its weight w on a foot of stiffness k. The foot is lowered by b, and the body moves down with
/// it. When the body is unloaded, the foot touches it without force. Lowered further, the foot separates from the body, which does not move. Guides
/// at y = ±1 carry a side load P at the origin and a moment M with (P ± M)/2 each, whatever the height of the body.
#[test]
fn a_foot_that_parts_leaves_the_height_free() {
    let (k, w, a, b, p, m) = (40.0, 1.2, 0.05, 0.3, 0.7, 0.2);
    let foot = planar::Contact::new([0.0, -1.0], [0.0, 1.0])
        .series_stiffness(k, 0.6 * k)
        .friction(0.5)
        .command([a, 0.0]);
    let guide = |y: f64| planar::Contact::new([0.0, y], [1.0, 0.0]).series_stiffness(90.0, 1.0).kept_closed();
    let grasp = planar::Grasp::new([foot, guide(1.0), guide(-1.0)]).unwrap();
    let load = |x: f64, y: f64, m: f64| planar::Leg::load_to(planar::Wrench::new([x, y], m));
    let command = |a: f64| planar::Leg::commands_to(vec![[a, 0.0], [0.0; 2], [0.0; 2]]);
    let start = planar::Wrench::force([0.0, -w]);
    let away = [command(a - b), load(0.0, 0.0, 0.0), command(a - 2.0 * b), load(p, 0.0, m)];
    for (last, way) in [
        (load(p, 1.0, m), Some(1.0)),
        // The foot is lower by b, and no contact resists a downward motion of the body.
        (load(p, -1.0, m), Some(-1.0)),
        (load(-p, 0.0, 2.0 * m), None),
    ] {
        let mut path = grasp.follow(start, &away).unwrap();
        let events = path.run();
        assert_story(&events, &[(2, 0.0, vec![(0, "opens")])]);
        let [free] = &events[0].free_motions[..] else { panic!("{:?}", events[0].free_motions) };
        assert_close!(free.object.translation()[1].abs(), 1.0);
        assert!(free.object.translation()[0].abs() + free.object.rotation().abs() < 1e-14);
        assert_close!(path.state_at(0, 1.0).unwrap().twist.translation()[1], a - b - w / k);
        for (leg, fraction) in [(1, 1.0), (2, 0.5), (2, 1.0), (3, 0.5), (3, 1.0)] {
            let state = path.state_at(leg, fraction).unwrap();
            assert_close!(state.twist.translation()[1], a - b);
            assert_eq!(state.free_motions.len(), usize::from(leg > 1));
            let share = if leg == 3 { 0.5 * fraction } else { 0.0 };
            assert_close!(state.contacts[0].force[0], 0.0);
            assert_close!(state.contacts[1].force[0], -share * (p - m));
            assert_close!(state.contacts[2].force[0], -share * (p + m));
        }
        path.continue_with(&[last]).unwrap();
        assert!(path.run().is_empty());
        match (path.end(), way) {
            (Some(PathEnd::Lost(loss)), Some(way)) => {
                assert_eq!((loss.leg, loss.fraction, loss.kind), (4, 0.0, LossKind::GivesWay));
                let motion = loss.motion.as_ref().expect("a motion");
                assert_close!(motion.object.translation()[1], way);
                assert!(
                    motion.object.translation()[0].abs() + motion.object.rotation().abs() < 1e-14,
                    "{motion:?}"
                );
            }
            (Some(PathEnd::Completed), None) => {
                let end = path.state().unwrap();
                assert_close!(end.twist.translation()[1], a - b);
                assert_close!(end.contacts[1].force[0], 0.5 * p + m);
                assert_close!(end.contacts[2].force[0], 0.5 * p - m);
            }
            (end, way) => panic!("{end:?}, expected {way:?}"),
        }
    }
    // The foot returns, touches the body where it separated, and then moves the unloaded body along.
    let mut path = grasp.follow(start, &away).unwrap();
    path.run();
    path.continue_with(&[command(a)]).unwrap();
    let events = path.run();
    assert!(completed(path.end()), "{:?}", path.end());
    assert_eq!(events.len(), 1, "{events:?}");
    assert_close!(events[0].fraction, 0.5);
    let end = path.state().unwrap();
    assert_close!(end.twist.translation()[1], a);
    assert_close!(end.contacts[0].gap, 0.0);
    assert_close!(end.contacts[0].force[0], 0.0);
    // Under a load the foot carries the body again, without an event.
    path.continue_with(&[load(0.0, -w, 0.0)]).unwrap();
    path.run();
    assert!(completed(path.end()), "{:?}", path.end());
    let end = path.state().unwrap();
    assert_close!(end.contacts[0].force[0], w);
    assert_close!(end.twist.translation()[1], a - w / k);
}

/// Two pairs of fingers on the same two points press with N = k a each. One pair is dragged up, the other down, by b each. At kt b = μN all four
/// fingers slide at once. Then nothing resists a vertical motion or a rotation. Yet all friction forces are known, ±μN, and the body stays. Under a
/// load -w the pair that was dragged down sticks again while the other pair slips on: y = -w/(2 kt). At w = 4μN, the limit load, the friction of each
/// finger of the first pair has changed from -μN to μN.
#[test]
fn fingers_dragged_both_ways_hold_all_the_same() {
    let (k, kt, mu, a) = (50.0, 20.0, 0.35, 0.1);
    let n = k * a;
    let finger = |x: f64| jaw::<2>(x, [k, kt], mu).command([a, 0.0]);
    let grasp = planar::Grasp::new([finger(1.0), finger(-1.0), finger(1.0), finger(-1.0)]).unwrap();
    let edge = mu * n / kt;
    // The tangent t of a finger points up at x = 1 and down at x = -1.
    let drag = |b: f64| planar::Leg::commands_to(vec![[a, b], [a, -b], [a, -b], [a, b]]);
    let down = |w: f64| planar::Leg::load_to(planar::Wrench::force([0.0, -w]));
    let up = |state: &planar::Equilibrium| {
        state.contacts.iter().map(|c| c.force_world[1] / (mu * n)).collect::<Vec<_>>()
    };
    let mut path = grasp.follow(planar::Wrench::ZERO, &[drag(2.0 * edge), down(6.0 * mu * n)]).unwrap();
    let events = path.run();
    let all = (0..4).map(|i| (i, "slides")).collect();
    assert_story(&events, &[(0, 0.5, all), (1, 0.0, vec![(2, "sticks"), (3, "sticks")])]);
    assert_eq!(events[0].free_motions.len(), 2);
    for v in &events[0].free_motions {
        assert!(v.object.translation()[0].abs() < 1e-14, "{v:?}");
    }
    let dragged = path.state_at(0, 1.0).unwrap();
    for (got, want) in up(&dragged).into_iter().zip([1.0, 1.0, -1.0, -1.0]) {
        assert_close!(got, want);
    }
    assert!(dragged.twist.to_vector().norm() < 1e-14, "it stays: {:?}", dragged.twist);
    for c in &dragged.contacts {
        assert_close!(c.slip[1].abs(), edge);
    }
    let loss = limit_load(&path);
    assert_eq!(loss.leg, 1);
    assert_close!(loss.fraction, 4.0 / 6.0);
    assert!(loss.motion.as_ref().expect("a motion").object.translation()[1] < -0.99);
    let half = path.state_at(1, 2.0 / 6.0).unwrap();
    for (got, want) in up(&half).into_iter().zip([1.0, 1.0, 0.0, 0.0]) {
        assert_close!(got, want);
    }
    assert_close!(half.twist.translation()[1], -2.0 * mu * n / (2.0 * kt));
    assert!(path.energies().iter().all(|e| e.residual().abs() < 1e-13 && e.dissipated > 0.0));
}

const K: f64 = 45.0;
const KT: f64 = 30.0;
const A: f64 = 0.1;

/// Two fingers pinch a body along x, and a third finger presses from below with the command A. At rest the body is at the height y, and the force of
/// the third finger is k(A - y) = 2 kt y.
fn three_fingers(mu: f64) -> spatial::Grasp {
    let finger = |point: [f64; 3], normal: [f64; 3]| {
        spatial::Contact::new(point, normal)
            .tangent([0.0, 0.0, 1.0])
            .series_stiffness(K, KT)
            .friction(mu)
            .command([A, 0.0, 0.0])
    };
    let pinch = |x: f64| finger([x, 0.0, 0.0], [-x, 0.0, 0.0]);
    spatial::Grasp::new([pinch(1.0), pinch(-1.0), finger([0.0, -1.0, 0.0], [0.0, 1.0, 0.0])]).unwrap()
}

fn third(a: f64) -> spatial::Leg {
    spatial::Leg::commands_to(vec![[A, 0.0, 0.0], [A, 0.0, 0.0], [a, 0.0, 0.0]])
}

/// The third finger is withdrawn and separates from the body when its command is zero. Then the body can turn about the line through the other two
/// fingers. These hold a force f through the line, with f/2 each, and a moment M perpendicular to the line, with ∓M/2. A moment about the line, or a
/// force that misses it, turns the body.
#[test]
fn a_pinch_may_turn_about_its_line() {
    let grasp = three_fingers(0.8);
    let away = third(-A);
    let (force, moment) = ([0.4, -0.9, 0.6], [0.0, 0.3, -0.5]);
    let held = spatial::Leg::load_to(spatial::Wrench::new(force, moment));
    let cases = [
        (spatial::Wrench::new([0.0; 3], [0.1, 0.0, 0.0]), Some(1.0)),
        (spatial::Wrench::new([0.0; 3], [-0.1, 0.0, 0.0]), Some(-1.0)),
        (spatial::Wrench::force_at([0.0, 0.0, 0.2], [0.3, 0.5, 0.0]), Some(1.0)),
        (spatial::Wrench::force_at([0.0, 0.2, 0.0], [0.3, 0.0, 0.5]), Some(-1.0)),
        (spatial::Wrench::force_at([0.2, 0.2, -0.1], [0.3, 0.0, 0.0]), None),
    ];
    for (more, way) in cases {
        let legs = [away.clone(), held.clone(), spatial::Leg::load_by(more)];
        let mut path = grasp.follow(spatial::Wrench::ZERO, &legs).unwrap();
        let events = path.run();
        assert_story(&events, &[(0, 0.5, vec![(2, "opens")])]);
        let [free] = &events[0].free_motions[..] else { panic!("{:?}", events[0].free_motions) };
        let turns = free.object.rotation();
        assert!(turns[0].abs() > 0.1 && turns[1].abs() + turns[2].abs() < 1e-14, "{free:?}");
        assert!(free.object.translation().iter().all(|x| x.abs() < 1e-14), "{free:?}");
        let rest = path.state_at(0, 0.0).unwrap();
        assert_close!(rest.contacts[2].normal_force(), K * A * 2.0 * KT / (2.0 * KT + K));
        let open = path.state_at(1, 1.0).unwrap();
        assert_close!(open.contacts[2].gap, A + open.twist.translation()[1]);
        for (i, side) in [(0, 1.0), (1, -1.0)] {
            let f = open.contacts[i].force_world;
            assert_close!(f[0], -side * K * A - force[0] / 2.0);
            // Moments about y and z, with the fingers at x = ±1: Σ x F_z = M_y and Σ x F_y = -M_z.
            assert_close!(f[1], -force[1] / 2.0 - side * moment[2] / 2.0);
            assert_close!(f[2], -force[2] / 2.0 + side * moment[1] / 2.0);
        }
        match (path.end(), way) {
            (Some(PathEnd::Lost(loss)), Some(way)) => {
                assert_eq!((loss.leg, loss.fraction, loss.kind), (2, 0.0, LossKind::GivesWay));
                let motion = loss.motion.as_ref().expect("a motion");
                let [x, y, z] = motion.object.rotation();
                assert!(x * way > 0.1 && y.abs() + z.abs() < 1e-13, "{motion:?}");
                assert!(motion.object.translation().iter().all(|x| x.abs() < 1e-13), "{motion:?}");
            }
            (Some(PathEnd::Completed), None) => {}
            (end, way) => panic!("{end:?}, expected {way:?}"),
        }
    }
}

/// A moment m about the line of the two fingers is carried by the third finger alone, with the tangential force T₃ = m at the arm 1, on a corner of
/// its polygon. The third finger is withdrawn, so that its normal force is N₃ = N₀(1 - 2f) at the fraction f of the leg. The grasp is lost at μN₃ =
/// m, before this finger separates.
#[test]
fn a_moment_about_the_line_is_lost_while_the_finger_still_presses() {
    let (mu, m) = (0.8, 0.6);
    let grasp = three_fingers(mu);
    let n0 = K * A * 2.0 * KT / (2.0 * KT + K);
    for side in [1.0, -1.0] {
        let turn = spatial::Leg::load_to(spatial::Wrench::new([0.0; 3], [side * m, 0.0, 0.0]));
        let mut path = grasp.follow(spatial::Wrench::ZERO, &[turn, third(-A)]).unwrap();
        assert!(path.run().is_empty());
        let loss = limit_load(&path);
        assert_eq!((loss.leg, &numbers(&loss.contacts)[..]), (1, &[2][..]));
        assert_close!(loss.fraction, 0.5 * (1.0 - m / (mu * n0)));
        let motion = loss.motion.as_ref().expect("a motion");
        assert!(motion.object.rotation()[0] * side > 0.1, "{motion:?}");
        let end = path.state().unwrap();
        assert_close!(end.contacts[2].force_world[2], side * m);
        assert_close!(end.contacts[2].normal_force(), m / mu);
    }
}

/// A slider on two guides holds no load along the guides, and every load across them.
#[test]
fn a_load_that_nothing_resists_has_a_limit_of_zero() -> Result<(), grasp_lcp::Error> {
    let guide = |x: f64| planar::Contact::new([x, 0.0], [0.0, 1.0]).series_stiffness(1e3, 1e3).kept_closed();
    let grasp = planar::Grasp::new([guide(-1.0), guide(1.0)])?;
    let along = grasp.hold(planar::Wrench::force([1.0, 0.0]))?;
    let lost = along.lost.as_ref().map(|lost| (lost.factor, lost.kind));
    assert_eq!((lost, along.holds()), (Some((0.0, LossKind::GivesWay)), Some(false)));
    let across = grasp.hold(planar::Wrench::force([0.0, 1.0]))?;
    assert!(across.lost.is_none() && across.held_to == 100.0 && across.sticks() == Some(true));
    Ok(())
}
