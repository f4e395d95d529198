//! Every event of these load paths has a closed form.

use grasp_lcp::planar::{Change, Contact, ContactState, Event, Grasp, Leg, LoadPath, PathEnd, Wrench};
use support::assert_close;
use support::ends::limit_load;
use support::jaws::{around, jaw};
use support::programs::{changes, numbers};

fn pull(force: f64) -> Wrench {
    Wrench::force([force, 0.0])
}

/// Feet in a row under a block that a stiff bilateral guide keeps from rising. Foot i is pressed by N_i, has the tangential stiffness kt and slides
/// at μ_i N_i. Pulled sideways, the feet are Jenkins elements in parallel.
fn row_of_feet(limits: &[f64], kt: f64) -> Grasp {
    let (k, press) = (10.0, 0.1);
    let feet = limits.iter().map(|limit| {
        // All at the same place, so that nothing turns and N_i = k press.
        Contact::new([0.0, 0.0], [0.0, 1.0])
            .series_stiffness(k, kt)
            .friction(limit / (k * press))
            .command([press, 0.0])
    });
    // Two frictionless guides from above hold the block down and level, against the feet.
    let stiff = 1e6;
    let n = f64::from(u32::try_from(limits.len()).unwrap());
    let guides = [-1.0, 1.0].map(|x| {
        let push = n * k * press / 2.0 / stiff;
        Contact::new([x, 0.0], [0.0, -1.0]).series_stiffness(stiff, 1.0).command([push, 0.0])
    });
    Grasp::new(feet.chain(guides)).unwrap()
}

fn run<'g>(grasp: &'g Grasp, legs: &[Leg]) -> (LoadPath<'g>, Vec<Event>) {
    let mut path = grasp.follow(Wrench::ZERO, legs).unwrap();
    let events = path.run();
    (path, events)
}

/// The friction limits are 1, 2 and 4 N, with kt = 8 N/m each. Foot 1 slides from the displacement x = 1/8 on, at the load 3. Foot 2 slides from x =
/// 2/8 on, at the load 1 + 2 + 2 = 5. Foot 3 slides at x = 4/8, at 1 + 2 + 4 = 7, the limit load.
#[test]
fn feet_slide_one_after_the_other_up_to_the_limit_load() {
    let grasp = row_of_feet(&[1.0, 2.0, 4.0], 8.0);
    let (path, events) = run(&grasp, &[Leg::load_to(pull(10.0))]);
    let expected = [(0, 3.0, 0.125), (1, 5.0, 0.25)];
    assert_eq!(events.len(), 2, "{events:?}");
    for (event, (contact, load, x)) in events.iter().zip(expected) {
        assert_close!(event.fraction, load / 10.0);
        assert_close!(event.state.twist.translation()[0], x);
        let [(at, Change::Slides { direction })] = changes(event)[..] else { panic!("{:?}", changes(event)) };
        assert_eq!(at, contact);
        // The body moves to +x, so each foot slips relative to it to -x.
        assert_close!(direction[0], -1.0);
        assert_eq!(event.other_continuations, Some(0));
    }
    let loss = limit_load(&path);
    assert_close!(loss.fraction, 0.7);
    assert_eq!(numbers(&loss.contacts), [0, 1, 2]);
    let motion = loss.motion.as_ref().expect("a ray");
    assert_close!(motion.object.translation()[0].abs(), 1.0);
    assert!(motion.object.translation()[0] > 0.0);
    for energy in path.energies() {
        assert!(energy.residual().abs() < 1e-13, "{energy:?}");
    }
}

/// Leg, displacement, and the changes of the contacts.
type Line = (usize, f64, Vec<(usize, &'static str)>);

/// Masing's rule for feet with friction limits 1 and 2 N, kt = 8 N/m, and a third foot that never slides (limit 1000). The load goes to 7 N at x₁ =
/// 0.5 m (forces 1, 2 and 4), then to -7 N and back to 7 N. After each reversal both feet stick, and slide back when x has changed by 2·1/8 and by
/// 2·2/8. In each full cycle friction takes 4 f (X - f/kt) with the amplitude X = 0.5: 4·1·(0.375) + 4·2·(0.25) = 3.5 J.
#[test]
fn a_hysteresis_loop_with_its_area() {
    let grasp = row_of_feet(&[1.0, 2.0, 1000.0], 8.0);
    let there = Leg::load_to(pull(7.0));
    let back = Leg::load_to(pull(-7.0));
    let (path, events) = run(&grasp, &[there.clone(), back.clone(), there.clone(), back, there]);
    assert!(matches!(path.end(), Some(PathEnd::Completed)));
    let story: Vec<Line> = events
        .iter()
        .map(|e| {
            let words = e.changes.iter().map(|change| {
                let word = match change.what {
                    Change::Slides { direction } if direction[0] < 0.0 => "slides -",
                    Change::Slides { .. } => "slides +",
                    Change::Sticks => "sticks",
                    _ => "?",
                };
                (change.contact.index, word)
            });
            (e.leg, e.state.twist.translation()[0], words.collect())
        })
        .collect();
    let mut expected: Vec<Line> = vec![(0, 0.125, vec![(0, "slides -")]), (0, 0.25, vec![(1, "slides -")])];
    for leg in 1..5 {
        let (s, word) = if leg % 2 == 1 { (1.0, "slides +") } else { (-1.0, "slides -") };
        expected.push((leg, s * 0.5, vec![(0, "sticks"), (1, "sticks")]));
        expected.push((leg, s * 0.25, vec![(0, word)]));
        expected.push((leg, 0.0, vec![(1, word)]));
    }
    assert_eq!(story.len(), expected.len(), "{story:#?}");
    for (got, want) in story.iter().zip(&expected) {
        assert_eq!((got.0, &got.2), (want.0, &want.2));
        assert_close!(got.1, want.1);
    }
    let heat: f64 = path.energies()[1..3].iter().map(|e| e.dissipated).sum();
    assert_close!(heat, 3.5);
    let work: f64 = path.energies()[1..3].iter().map(|e| e.load_work).sum();
    assert_close!(work, 3.5);
    for energy in path.energies() {
        assert!(energy.residual().abs() < 1e-13 && energy.dissipated >= 0.0, "{energy:?}");
    }
    // The state halfway along leg 1, where the load is zero, without solving again.
    let state = path.state_at(1, 0.5).expect("passed");
    assert_close!(state.load.to_vector()[0], 0.0);
    // While x falls from 0.5 to 0.25, all three feet stick, and the load falls from 7 to 7 - 24·0.25 = 1 N. The last newton takes 1/16 m at 16 N/m.
    assert_close!(state.twist.translation()[0], 0.25 - 1.0 / 16.0);
    assert!(state.residuals.worst() < 1e-13, "{:?}", state.residuals);
    assert!(path.state_at(5, 0.0).is_none());
}

/// Complete unloading leaves residual forces. The friction limits are 1 and 1000 N. At 5 N, x = 0.5 and the forces are 1 and 4. During unloading foot
/// 1 first sticks, until x has fallen by 2/8 to 0.25 and its force is -1, at the load 1. Then it slides back, and x falls to 1/8 at 8 N/m.
#[test]
fn residual_forces_after_unloading() {
    let grasp = row_of_feet(&[1.0, 1000.0], 8.0);
    let (path, events) = run(&grasp, &[Leg::load_to(pull(5.0)), Leg::load_to(pull(0.0))]);
    assert_eq!(events.len(), 3);
    assert_close!(events[0].fraction, 0.4);
    assert_close!(events[1].fraction, 0.0);
    assert_close!(events[2].fraction, 0.8);
    let ((leg, fraction), state) = (path.place(), path.state().expect("followed"));
    assert_eq!((leg, fraction), (1, 1.0));
    assert_close!(state.twist.translation()[0], 0.125);
    assert_close!(state.contacts[0].force_world[0], 1.0);
    assert_close!(state.contacts[1].force_world[0], -1.0);
    assert!(matches!(state.contacts[0].state, ContactState::Sliding { .. }));
    // During reloading foot 1 first sticks, and slides again from x = 0.375 on, at the load 8·0.375 + 1.
    let mut path = path;
    path.continue_with(&[Leg::load_by(pull(5.0))]).unwrap();
    let events = path.run();
    assert_eq!(events.len(), 2, "{events:#?}");
    assert_eq!(changes(&events[0]), [(0, Change::Sticks)]);
    assert_close!(events[1].state.twist.translation()[0], 0.375);
    assert_close!(events[1].fraction, 4.0 / 5.0);
}

/// A bar on three frictionless supports at -1, 0 and 1. Its load moves outwards past e = 2/3, where the far support opens, and back. The support
/// closes again, and the forces at the end are those at the start.
#[test]
fn a_support_lets_go_and_takes_hold_again() {
    let (k, w) = (80.0, 6.0);
    let support = |x: f64| Contact::new([x, 0.0], [0.0, 1.0]).series_stiffness(k, k);
    let guide = Contact::new([0.0, 0.0], [1.0, 0.0]).series_stiffness(k, k).kept_closed();
    let bar = Grasp::new([support(-1.0), support(0.0), support(1.0), guide]).unwrap();
    let load = |e: f64| Wrench::force_at([0.0, -w], [e, 0.0]);
    let mut path = bar.follow(load(0.0), &[Leg::load_to(load(0.9)), Leg::load_to(load(0.0))]).unwrap();
    let events = path.run();
    assert_eq!(events.len(), 2);
    assert_close!(events[0].fraction, 2.0 / 2.7);
    assert_eq!(changes(&events[0]), [(0, Change::Opens)]);
    assert_close!(events[1].fraction, 1.0 - 2.0 / 2.7);
    assert_eq!(changes(&events[1]), [(0, Change::Closes)]);
    let end = path.state().unwrap();
    for contact in &end.contacts[..3] {
        assert_close!(contact.normal_force(), w / 3.0);
    }
    let total: f64 = path.energies().iter().map(|e| e.load_work).sum();
    assert!(total.abs() < 1e-13, "{total}");
}

/// A finger that is withdrawn, moved sideways and pressed again starts with F_t = 0.
#[test]
fn regrasping_starts_without_tangential_force() {
    let (k, kt, mu) = (10.0, 6.0, 0.5);
    let side = |x: f64| jaw::<2>(x, [k, kt], mu).command([0.1, 0.0]);
    // Two pairs of fingers touch at the same points. One pair holds the object while the other pair regrasps.
    let grasp = Grasp::new([side(-1.0), side(1.0), side(-1.0), side(1.0)]).unwrap();
    let w = 0.4;
    let (hold, away) = ([0.1, 0.0], [-0.1, 0.0]);
    let commands = |pair: [f64; 2]| [hold, hold, pair, pair];
    let legs = [
        Leg::load_to(Wrench::force([0.0, -w])),
        Leg::commands_to(commands(away)),
        Leg::commands_to(commands(hold)),
    ];
    let (path, events) = run(&grasp, &legs);
    assert!(matches!(path.end(), Some(PathEnd::Completed)), "{:?}", path.end());
    // Four fingers share the load, with 0.1 N each. While the second pair lets go, it slides where μ N, with μ = 0.5, equals the tangential force. It
    // opens where the normal force N is zero, and closes again later.
    let kinds: Vec<_> = events.iter().map(|e| (e.leg, e.changes.len())).collect();
    assert_eq!(kinds.first(), Some(&(1, 2)), "{events:#?}");
    let end = path.state().unwrap();
    for c in &end.contacts[..2] {
        assert_close!(c.force_world[1], w / 2.0);
    }
    for c in &end.contacts[2..] {
        assert_close!(c.normal_force(), 1.0);
        assert_close!(c.force_world[1], 0.0);
        assert_eq!(c.state, ContactState::Sticking);
    }
    for energy in path.energies() {
        assert!(energy.residual().abs() < 1e-13, "{energy:?}");
    }
}

/// On a ring of n identical contacts under a torque all contacts slide at one torque, which is the limit torque.
#[test]
fn rings_have_one_event() {
    for n in [2, 3, 5, 8, 17, 64] {
        let finger = |i: usize| around::<2>(i, n, 1.0, [10.0, 4.0], 0.3).command([0.1, 0.0]);
        // An elastic stop about the axis carries the part of the torque that exceeds the friction.
        let stop = Contact::new([1.0, 0.0], [0.0, -1.0]).series_stiffness(0.5, 1.0).kept_closed();
        let counter = Contact::new([-1.0, 0.0], [0.0, 1.0]).series_stiffness(0.5, 1.0).kept_closed();
        let ring = Grasp::new((0..n).map(finger).chain([stop, counter])).unwrap();
        let torque = |m: f64| Leg::load_to(Wrench::new([0.0, 0.0], m));
        let size = n as f64;
        let (path, events) = run(&ring, &[torque(size), torque(-size), torque(size)]);
        assert!(matches!(path.end(), Some(PathEnd::Completed)), "{n}: {:?}", path.end());
        let sizes: Vec<_> = events.iter().map(|e| (e.leg, e.changes.len())).collect();
        assert_eq!(sizes, [(0, n), (1, n), (1, n), (2, n), (2, n)], "{n}");
        // All contacts slide where the rotation times kt is μ N. With the stop the torque is then n · 0.3 · (1 + 1.0/(4 n)).
        assert_close!(events[0].fraction * size, size * 0.3 + 0.3 / 4.0);
    }
}

/// In the paper's second grasp the first slip and the limit load coincide.
#[test]
fn the_paper_ends_at_its_onset() {
    let grasp = support::paper::two_fingers().unwrap();
    let (path, events) = run(&grasp, &[Leg::load_to(Wrench::force([0.0, -1.0]))]);
    assert!(events.is_empty());
    let loss = limit_load(&path);
    assert_close!(loss.fraction, 65f64.sqrt() / 66.0);
    assert_eq!(numbers(&loss.contacts), [0, 1]);
    let motion = loss.motion.as_ref().expect("a ray");
    assert!(motion.object.translation()[1] < -0.99, "{motion:?}");
}
