//! A body is wedged between two contacts that slide in opposite directions. A couple has turned it until both slide, so that friction pulls it up on
//! one side and down on the other. The forces are the same at every height within an interval, and the answer names this free motion.
//!
//! Two fingers press with N = k_n c from x = ∓1. Frictionless guides carry moments with the stiffness R. Under the couple M
//!
//! ```text
//! θ = (M - 2 μ N) / R,      slip = θ - μ N / k_t ∓ y >= 0      wherever  |y| <= θ - μ N / k_t
//! ```

use grasp_lcp::equilibrium::{ContactState, Outcome};
use grasp_lcp::{planar, spatial};
use support::assert_close;
use support::jaws::jaw;

const KN: f64 = 30.0;
const KT: f64 = 20.0;
const PRESS: f64 = 0.1;
const MU: f64 = 0.5;
const GUIDE: f64 = 7.0;
const COUPLE: f64 = 9.0;

/// The angle θ of the body, and the half width of the interval of heights at which it may be.
fn by_hand(turning: f64) -> (f64, f64) {
    let theta = (COUPLE - 2.0 * MU * KN * PRESS) / turning;
    (theta, theta - MU * KN * PRESS / KT)
}

fn check<const C: usize>(
    state: &grasp_lcp::equilibrium::Equilibrium<C>,
    (theta, room): (f64, f64),
    turn: usize,
) {
    assert!(room > 0.1, "{room}");
    assert!(state.residuals.worst() < 1e-14);
    let [free] = &state.free_motions[..] else { panic!("{:?}", state.free_motions) };
    assert!(state.neutral_motions.is_empty());
    let length = free.object.components().iter().fold(0.0, |length: f64, x| length.hypot(*x));
    let across = length - free.object.components()[1].abs();
    assert!(across < 1e-14, "{free:?}");
    let twist = state.twist.components();
    assert_close!(twist[turn], theta);
    assert!(twist[1].abs() <= room, "{twist:?} {room}");
    for (contact, side) in state.contacts.iter().zip([1.0, -1.0]) {
        assert!(matches!(contact.state, ContactState::Sliding { .. }), "{contact:?}");
        assert_close!(contact.force[0], KN * PRESS);
        assert_close!(contact.force_world[1], side * MU * KN * PRESS);
        assert_close!(contact.slip.norm(), room - side * twist[1]);
    }
}

fn planar_grasp() -> planar::Grasp {
    let finger = |x: f64| jaw::<2>(x, [KN, KT], MU).command([PRESS, 0.0]);
    let guide = |y: f64| {
        planar::Contact::new([0.0, y], [1.0, 0.0]).series_stiffness(GUIDE, 1.0).friction(0.0).kept_closed()
    };
    planar::Grasp::new([finger(-1.0), finger(1.0), guide(1.0), guide(-1.0)]).unwrap()
}

#[test]
fn in_the_plane_the_height_is_anything_in_an_interval() {
    let grasp = planar_grasp();
    let load = planar::Wrench::new([0.0, 0.0], COUPLE);
    // Without a history of slip the solver may return an end of the interval of heights, where one contact has no slip.
    let Outcome::Equilibrium(state) = grasp.solve(load).unwrap() else { panic!("it holds") };
    let (theta, room) = by_hand(2.0 * GUIDE);
    assert_close!(state.twist.rotation(), theta);
    assert!(state.twist.translation()[1].abs() <= room * (1.0 + 1e-15));
    for contact in &state.contacts[..2] {
        assert_close!(contact.force[1], -MU * KN * PRESS);
    }
    let mut path = grasp.follow(planar::Wrench::ZERO, &[planar::Leg::load_to(load)]).unwrap();
    path.run();
    let state = path.state_at(0, 1.0).unwrap();
    check(&state, by_hand(2.0 * GUIDE), 2);
    // With a history of slip the height is known: the body has turned without moving up or down.
    assert!(state.twist.translation()[1].abs() < 1e-15);
}

#[test]
fn in_space_the_height_is_anything_in_an_interval() {
    let finger = |x: f64| {
        spatial::Contact::new([x, 0.0, 0.0], [-x, 0.0, 0.0])
            .tangent([0.0, 1.0, 0.0])
            .series_stiffness(KN, KT)
            .friction(MU)
            .command([PRESS, 0.0, 0.0])
    };
    let guide = |point: [f64; 3], normal: [f64; 3]| {
        spatial::Contact::new(point, normal).series_stiffness(GUIDE, 1.0).friction(0.0).kept_closed()
    };
    let beside = |y: f64, z: f64| guide([0.0, y, z], [1.0, 0.0, 0.0]);
    let below = |y: f64| guide([0.0, y, 0.0], [0.0, 0.0, 1.0]);
    let contacts = [
        finger(-1.0),
        finger(1.0),
        beside(1.0, 1.0),
        beside(1.0, -1.0),
        beside(-1.0, 1.0),
        beside(-1.0, -1.0),
        below(1.0),
        below(-1.0),
    ];
    let grasp = spatial::Grasp::new(contacts).unwrap();
    let load = spatial::Wrench::new([0.0; 3], [0.0, 0.0, COUPLE]);
    let Outcome::Equilibrium(state) = grasp.solve(load).unwrap() else { panic!("it holds") };
    check(&state, by_hand(4.0 * GUIDE), 5);
    let mut path = grasp.follow(spatial::Wrench::ZERO, &[spatial::Leg::load_to(load)]).unwrap();
    path.run();
    let state = path.state_at(0, 1.0).unwrap();
    check(&state, by_hand(4.0 * GUIDE), 5);
    assert!(state.twist.translation()[1].abs() < 1e-15);
}
