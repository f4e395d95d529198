//! If a contact loses its force and regains it, it reverses, sticks or opens at the apex of its cone. A contact that has opened closes without
//! tangential force, wherever its finger is by then. The paths are planar and computed by hand.
//!
//! One foot (k, kt, μ) acts on a body on two bonded springs, of total stiffness kb in both directions. The body does not turn. With the foot's
//! command (a, b) and the body at (x, y): N = k (a - y) and T = kt (b - x - s) on the body, kb x = T, kb y = N. If closed, N = c a with c = k kb/(k +
//! kb). While it sticks, T changes by e Δb with e = kt kb/(kt + kb).

use crate::story::{assert_close, assert_story, completed};
use grasp_lcp::load_path::Change;
use grasp_lcp::planar::{Contact, ContactState, Grasp, Leg, LoadPath, Wrench};
use support::ends::limit_load;
use support::jaws::jaw;
use support::programs::{changes, numbers};

const K: f64 = 30.0;
const KT: f64 = 20.0;
const KB: f64 = 10.0;
const MU: f64 = 0.4;
const C: f64 = K * KB / (K + KB);
const E: f64 = KT * KB / (KT + KB);

fn body(mu: f64) -> Grasp {
    let foot = Contact::new([0.0, 0.0], [0.0, 1.0]).series_stiffness(K, KT).friction(mu);
    let spring = |x: f64| Contact::new([x, 0.0], [0.0, 1.0]).series_stiffness(KB / 2.0, KB / 2.0).bonded();
    Grasp::new([foot, spring(-1.0), spring(1.0)]).unwrap()
}

/// A leg that changes the foot's command to (a, b).
fn to(a: f64, b: f64) -> Leg {
    Leg::commands_to(vec![[a, b], [0.0; 2], [0.0; 2]])
}

fn follow<'g>(grasp: &'g Grasp, legs: &[Leg]) -> (LoadPath<'g>, Vec<grasp_lcp::planar::Event>) {
    let mut path = grasp.follow(Wrench::ZERO, legs).unwrap();
    let events = path.run();
    assert!(completed(path.end()), "{:?}", path.end());
    (path, events)
}

/// If the foot is pressed and dragged from zero force (e b > μ c a), it slides from the start. On the second leg it is released while it is dragged
/// on, and slides until N = 0 at the end of the leg. On the third leg it is pressed and dragged back, and slides in the other direction at once. It
/// can reverse only where all its forces vanish. Friction dissipates ∫ μN |ds| with s = b - μN/e. On a leg with N from 0 to N₁ (or back) and b over L
/// this is μN₁ L/2 ∓ (μN₁)²/(2e).
#[test]
fn it_reverses_where_its_force_vanishes() {
    let (a, l) = (0.2, 0.5);
    let grasp = body(MU);
    let (path, events) = follow(&grasp, &[to(a, l), to(0.0, 2.0 * l), to(a, l), to(0.0, l)]);
    let n = C * a;
    // On the last leg the foot sticks at T = -μN₁, and slides as soon as μN is less than |T|. As the foot is released, this is at once.
    assert_story(&events[..2], &[(0, 0.0, vec![(0, "slides")]), (2, 0.0, vec![(0, "reverses")])]);
    let [(0, Change::Reverses { direction })] = changes(&events[1])[..] else { panic!() };
    // The tangent is t = (1, 0), and the foot is dragged back to -x.
    assert_close!(direction[0], -1.0);
    assert_eq!(events[1].other_continuations, Some(0));
    for (leg, sign) in [(0, 1.0), (2, -1.0)] {
        let state = path.state_at(leg, 1.0).unwrap();
        assert_close!(state.contacts[0].force[0], n);
        assert_close!(state.contacts[0].force[1], sign * MU * n);
        assert_close!(state.contacts[0].slip[1], l - sign * MU * n / E);
    }
    let loss = |sign: f64| MU * n * l / 2.0 - sign * (MU * n).powi(2) / (2.0 * E);
    for (leg, heat) in [(0, loss(1.0)), (1, loss(-1.0)), (2, loss(1.0))] {
        assert_close!(path.energies()[leg].dissipated, heat);
        assert!(path.energies()[leg].residual().abs() < 1e-13);
    }
}

/// If the foot is pressed along the normal where N = 0, it sticks with T = 0, and its slip does not change.
#[test]
fn it_sticks_where_its_force_vanishes() {
    let (a, l) = (0.2, 0.5);
    let grasp = body(MU);
    let (path, events) = follow(&grasp, &[to(a, l), to(0.0, 2.0 * l), to(a, 2.0 * l)]);
    assert_story(&events, &[(0, 0.0, vec![(0, "slides")]), (2, 0.0, vec![(0, "sticks")])]);
    let end = path.state().unwrap();
    assert_close!(end.contacts[0].force[0], C * a);
    assert_close!(end.contacts[0].force[1], 0.0);
    assert_close!(end.contacts[0].slip[1], 2.0 * l);
    assert_eq!(end.contacts[0].state, ContactState::Sticking);
}

/// The foot is lifted past N = 0. It first slides, where T = e b = μ c a, then opens, moves, and is lowered at another place. If it is dragged far
/// enough while it is pressed again (e Δb > μ c Δa after closing), it closes sliding. Otherwise it closes and sticks, with T = e (b - b₀) for its
/// position b₀ at the closing point.
#[test]
fn it_closes_without_tangential_force() {
    let (a, b) = (0.2, 0.03);
    let stuck = E * b;
    assert!(stuck < MU * C * a);
    let slides = 1.0 - stuck / (MU * C * a);
    for (drag, how) in [(0.05, "closes"), (0.3, "closes sliding")] {
        let grasp = body(MU);
        // On the first leg the foot sticks. Then it is lifted to -a, moved along, and lowered while it is dragged.
        let legs = [to(a, b), to(-a, b), to(-a, 1.0), to(a, 1.0 + 2.0 * drag)];
        let (path, events) = follow(&grasp, &legs);
        // On the second leg its command is a(1 - 2f) at the fraction f: the foot slides when μ c a(1 - 2f) = e b and opens at f = ½.
        assert_story(
            &events,
            &[(1, slides / 2.0, vec![(0, "slides")]), (1, 0.5, vec![(0, "opens")]), (3, 0.5, vec![(0, how)])],
        );
        let open = path.state_at(2, 1.0).unwrap();
        assert_close!(open.contacts[0].gap, a);
        assert_close!(open.twist.translation()[0], 0.0);
        let end = path.state().unwrap();
        let friction = if how == "closes" { E * drag } else { MU * C * a };
        assert_close!(end.contacts[0].force[1], friction);
        assert_close!(end.contacts[0].slip[1], 1.0 + 2.0 * drag - friction / E);
        assert!(path.energies().iter().all(|e| e.residual().abs() < 1e-13));
    }
}

/// With a clearance the foot closes when its command a equals the clearance. From then on N = c (a - clearance).
#[test]
fn a_clearance_is_travelled_first() {
    let foot = Contact::new([0.0, 0.0], [0.0, 1.0]).series_stiffness(K, KT).friction(MU).clearance(0.3);
    let spring = |x: f64| Contact::new([x, 0.0], [0.0, 1.0]).series_stiffness(KB / 2.0, KB / 2.0).bonded();
    let grasp = Grasp::new([foot, spring(-1.0), spring(1.0)]).unwrap();
    let (path, events) = follow(&grasp, &[to(0.4, 0.0), to(0.4, 0.02), to(0.0, 0.02)]);
    // On the last leg T stays e·0.02 while the foot sticks. It slides where N = c (0.1 - 0.4f) = T/μ, and opens where N = 0, at f = ¼.
    let slides = 0.25 - E * 0.02 / (MU * C * 0.4);
    assert_story(
        &events,
        &[(0, 0.75, vec![(0, "closes")]), (2, slides, vec![(0, "slides")]), (2, 0.25, vec![(0, "opens")])],
    );
    assert_close!(path.state_at(1, 0.0).unwrap().contacts[0].force[0], C * 0.1);
    assert_close!(path.state().unwrap().contacts[0].gap, 0.3);
}

/// Two fingers pinch a body of weight w (N = k a each) and are released until 2μN = w. Only the commands change, and the path ends at a
/// limit load: the body falls.
#[test]
fn letting_go_drops_the_body() {
    let (k, kt, mu, w, a) = (40.0, 6.0, 0.5, 1.2, 0.1);
    let finger = |x: f64| jaw::<2>(x, [k, kt], mu).command([a, 0.0]);
    let grasp = Grasp::new([finger(1.0), finger(-1.0)]).unwrap();
    let let_go = Leg::commands_to(vec![[0.0, 0.0], [0.0, 0.0]]);
    let mut path = grasp.follow(Wrench::ZERO, &[Leg::load_to(Wrench::force([0.0, -w])), let_go]).unwrap();
    assert!(path.run().is_empty());
    let loss = limit_load(&path);
    assert_eq!((loss.leg, &numbers(&loss.contacts)[..]), (1, &[0, 1][..]));
    assert_close!(loss.fraction, 1.0 - w / (2.0 * mu * k * a));
    assert!(loss.motion.as_ref().expect("a motion").object.translation()[1] < -0.99);
    assert_close!(path.state().unwrap().twist.translation()[1], -w / (2.0 * kt));
}

/// In space and without a load, a finger slides on a body that three bonded springs carry. While it slides, it is drawn off the body, and then comes
/// back. All forces vanish together when its normal command, on the way from 1 to -1/2, is zero. They return at the same place.
#[test]
fn drawn_off_while_it_slides_in_space() {
    use grasp_lcp::spatial::{Contact, Grasp, Leg, PathEnd, Wrench};

    let spring = |x: f64, y: f64| {
        Contact::new([x, y, 0.0], [0.0, 0.0, 1.0]).series_stiffness(1e6, 1e6).friction(1.0).bonded()
    };
    for (x, y) in [(0.2, 0.1), (0.0, 0.0), (-0.7, 0.3)] {
        let finger = Contact::new([x, y, 1.0], [0.0, 0.0, -1.0])
            .series_stiffness(1e4, 2e4)
            .friction(0.3)
            .command([1.0, 0.0, 0.0]);
        let grasp = Grasp::new([spring(-1.0, -1.0), spring(1.0, -1.0), spring(0.0, 1.0), finger]).unwrap();
        let to = |command: [f64; 3]| Leg::commands_to([[0.0; 3], [0.0; 3], [0.0; 3], command]);
        let legs = [to([1.0, 1.0, 0.0]), to([-0.5, 1.5, 0.0]), to([1.0, 1.5, 0.3])];
        let mut path = grasp.follow(Wrench::ZERO, &legs).unwrap();
        let events = path.run();
        assert!(matches!(path.end(), Some(PathEnd::Completed)), "{:?}", path.end());
        assert_eq!(events.len(), 3, "{events:?}");
        assert!(matches!(changes(&events[1])[..], [(3, Change::Opens)]));
        assert_eq!(events[1].leg, 1);
        assert!((events[1].fraction - 2.0 / 3.0).abs() < 1e-12, "{}", events[1].fraction);
        assert!(matches!(changes(&events[2])[..], [(3, Change::ClosesSliding { .. } | Change::Closes)]));
        assert!((events[2].fraction - 1.0 / 3.0).abs() < 1e-12, "{}", events[2].fraction);
    }
}
