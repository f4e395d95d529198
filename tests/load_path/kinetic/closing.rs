//! A contact that closes while it slides has no static friction to lose. It slides with the kinetic coefficient at once, without a jump.

use grasp_lcp::ask::Grasp;
use grasp_lcp::grasp::{Contact, Wrench};
use grasp_lcp::load_path::{Change, Leg, PathEnd};

/// A stiff arm moves an object against a wall 1 mm away, and along this wall. For each mm of normal motion the object slides 2 mm.
fn pressed_on<const C: usize>(along: [f64; C], wall: Contact<C>, arm: Vec<Contact<C>>) {
    let grasp = Grasp::new(
        [wall.series_stiffness(1e3, 1e3).friction(0.5).kinetic(0.3).clearance(1e-3)].into_iter().chain(arm),
    )
    .unwrap();
    let commands = (0..grasp.len()).map(|i| if i == 0 { [0.0; C] } else { along });
    let mut path = grasp.follow(Wrench::ZERO, &[Leg::commands_by(commands)]).unwrap();
    let events = path.run();
    assert!(matches!(path.end(), Some(PathEnd::Completed)), "{:?}", path.end());
    let closes = |change: &Change<C>| matches!(change, Change::ClosesSliding { .. });
    assert!(events.iter().any(|event| event.changes.iter().any(|change| closes(&change.what))));
    assert!(events.iter().all(|event| event.jump.is_none()));
    let force = path.forces()[0];
    let friction = force.rows(1, C - 1).norm();
    assert!((force[0] - 1.0).abs() < 1e-5, "{force}");
    assert!((friction / force[0] - 0.3).abs() < 1e-9, "{force}");
}

#[test]
fn in_the_plane() {
    let arm = |y: f64| Contact::new([0.0, y], [1.0, 0.0]).series_stiffness(1e9, 1e9).bonded();
    // The wall's contact frame has the normal n = x and the tangent t = -y.
    pressed_on([-2e-3, 4e-3], Contact::new([-0.1, 0.0], [1.0, 0.0]), vec![arm(-0.1), arm(0.1)]);
}

#[test]
fn on_the_round_cone() {
    let arm = |y: f64, z: f64| {
        Contact::new([0.0, y, z], [1.0, 0.0, 0.0])
            .tangent([0.0, 1.0, 0.0])
            .series_stiffness(1e9, 1e9)
            .bonded()
    };
    let arms = vec![arm(-0.1, 0.0), arm(0.1, 0.0), arm(0.0, 0.1)];
    pressed_on([-2e-3, 2.4e-3, -3.2e-3], Contact::new([-0.1, 0.0, 0.0], [1.0, 0.0, 0.0]), arms);
}
