//! On rings of 2 to 64 identical contacts, in the plane and in space, symmetric changes at one load are one event with all contacts concerned, and no
//! path cycles. If all contacts behave alike, events are computed by hand. If a side load makes groups of contacts slide one group after another,
//! paths are compared with their mirror images.

use std::f64::consts::{FRAC_PI_8, TAU};

use crate::story::{Line, assert_close, assert_story, completed};
use grasp_lcp::Settings;
use grasp_lcp::load_path::{Beyond, Event, PathEnd};
use grasp_lcp::{planar, spatial};
use support::jaws::around;
use support::programs::{changes, numbers};

const K: f64 = 10.0;
const KT: f64 = 4.0;
const MU: f64 = 0.3;
const A: f64 = 0.1;
/// Stiffness of the elastic base, in N/m and N m/rad.
const BASE: f64 = 1.0;

fn ring(n: usize) -> impl Iterator<Item = (f64, f64)> {
    (0..n).map(move |i| {
        let (sin, cos) = (TAU * i as f64 / n as f64).sin_cos();
        (cos, sin)
    })
}

fn fingers(n: usize) -> impl Iterator<Item = planar::Contact> {
    (0..n).map(move |i| around::<2>(i, n, 1.0, [K, KT], MU).command([A, 0.0]))
}

/// Commands a for n fingers, and zero for the `rest` of the contacts.
fn squeeze<const C: usize>(n: usize, rest: usize, a: f64) -> Vec<nalgebra::SVector<f64, C>> {
    let mut command = nalgebra::SVector::zeros();
    command[0] = a;
    let zeros = std::iter::repeat_n(nalgebra::SVector::zeros(), rest);
    std::iter::repeat_n(command, n).chain(zeros).collect()
}

fn all(n: usize, what: &'static str) -> Vec<(usize, &'static str)> {
    (0..n).map(|i| (i, what)).collect()
}

/// Under a growing torque all contacts slide at once at M = n μN.
#[test]
fn a_torque_takes_all_at_once() {
    for n in 2..=64 {
        let grasp = planar::Grasp::new(fingers(n)).unwrap();
        let limit = n as f64 * MU * K * A;
        for sign in [1.0, -1.0] {
            let leg = planar::Leg::load_to(planar::Wrench::new([0.0; 2], 1.6 * sign * limit));
            let mut path = grasp.follow(planar::Wrench::ZERO, &[leg]).unwrap();
            assert!(path.run().is_empty(), "{n}");
            // With up to 7 contacts the library enumerates all states beyond the loss. With more contacts it is unknown whether another equilibrium
            // exists.
            let Some(PathEnd::Lost(loss)) = path.end() else { panic!("{n}: {:?}", path.end()) };
            assert!(n > 7 || matches!(path.beyond(), Some(Beyond::LimitLoad)), "{n}");
            assert_close!(loss.fraction, 1.0 / 1.6);
            assert_eq!(numbers(&loss.contacts), (0..n).collect::<Vec<_>>());
            let motion = loss.motion.as_ref().expect("a motion");
            assert!(motion.object.rotation() * sign > 0.1, "{n}: {motion:?}");
            assert!(motion.object.translation().iter().all(|x| x.abs() < 1e-12), "{n}: {motion:?}");
        }
    }
}

/// The ring is squeezed to the command 2a and turned by M. Each of n fingers carries kt θ = kt M/(n kt + B), with the stiffness B of the elastic
/// base. Then the squeeze is reduced to a/2. All fingers slide at once, at the command a' with μka' = kt θ, and turn on to θ = (M - n μ k a/2)/B.
/// When the ring is squeezed again to 2a, all fingers stick. When the torque is removed, the tangential force of each changes by kt M/(n kt + B).
#[test]
fn squeezed_turned_let_go_and_squeezed_again() {
    for n in 2..=64 {
        let guide =
            |x: f64| planar::Contact::new([x, 0.0], [0.0, x]).series_stiffness(0.5 * BASE, 1.0).kept_closed();
        let grasp = planar::Grasp::new(fingers(n).chain([guide(1.0), guide(-1.0)])).unwrap();
        let size = n as f64;
        let share = 1.2 * MU * K * A;
        let torque = share * (size * KT + BASE) / KT;
        let turn = |m: f64| planar::Leg::load_to(planar::Wrench::new([0.0; 2], m));
        let press = |a: f64| planar::Leg::commands_to(squeeze::<2>(n, 2, a));
        let legs = [press(2.0 * A), turn(torque), press(0.5 * A), press(2.0 * A), turn(0.0)];
        let mut path = grasp.follow(planar::Wrench::ZERO, &legs).unwrap();
        let events = path.run();
        assert!(completed(path.end()), "{n}: {:?}", path.end());
        // The command 2a - 3a/2 f on this leg reaches a' = 1.2 a at the fraction f.
        assert_story(&events, &[(2, 0.8 / 1.5, all(n, "slides")), (3, 0.0, all(n, "sticks"))]);
        let loose = path.state_at(2, 1.0).unwrap();
        assert_close!(loose.twist.rotation(), (torque - size * MU * K * 0.5 * A) / BASE);
        let end = path.state().unwrap();
        for c in &end.contacts[..n] {
            assert_close!(c.normal_force(), 2.0 * K * A);
            // t = (n_y, -n_x) points in the direction of a positive rotation, and friction opposes it.
            assert_close!(c.force[1], share - MU * K * 0.5 * A);
        }
        assert!(path.energies().iter().all(|e| e.residual().abs() < 1e-13));
    }
}

/// Checks that no two events of a leg have the same load, and that every event contains the mirror images of its contacts.
fn assert_mirrored<const C: usize>(n: usize, events: &[Event<C>]) {
    for pair in events.windows(2) {
        let apart = pair[1].leg > pair[0].leg || pair[1].fraction - pair[0].fraction > 1e-9;
        assert!(apart, "{n}: two events at {} {}", pair[0].leg, pair[0].fraction);
    }
    for event in events {
        let contacts: Vec<usize> = changes(event).iter().map(|(i, _)| *i).collect();
        for &i in contacts.iter().filter(|&&i| i < n) {
            assert!(
                contacts.contains(&((n - i) % n)),
                "{n}: {contacts:?} at {} {}",
                event.leg,
                event.fraction
            );
        }
        assert!(event.state.residuals.worst() < 1e-12, "{n}: {:?}", event.state.residuals);
    }
}

/// The displacement x at first slip under a side load along x, and the contacts that slide. At the angle φ a contact has N_i = N + k x cos φ and T_i
/// = kt x |sin φ|.
fn first_to_let_go(n: usize) -> (f64, Vec<usize>) {
    let at = |(c, s): (f64, f64)| {
        let x = MU * K * A / (KT * s.abs() - MU * K * c);
        if x > 0.0 { x } else { f64::INFINITY }
    };
    let each: Vec<f64> = ring(n).map(at).collect();
    let first = each.iter().copied().fold(f64::INFINITY, f64::min);
    (first, (0..n).filter(|&i| each[i] < first * (1.0 + 1e-9)).collect())
}

/// Under a side load that is applied, reversed and applied again, against an elastic base, contacts slide, open and close in pairs.
#[test]
fn a_side_load_goes_through_mirror_images() {
    for n in 2..=64 {
        let base = |x: f64| {
            planar::Contact::new([x, 0.0], [0.0, 1.0]).series_stiffness(0.5 * BASE, 0.5 * BASE).bonded()
        };
        let grasp = planar::Grasp::new(fingers(n).chain([base(0.5), base(-0.5)])).unwrap();
        let (x, who) = first_to_let_go(n);
        let stiffness = BASE + if n == 2 { 2.0 * K } else { 0.5 * n as f64 * (K + KT) };
        let most = 3.0 * x * stiffness;
        let push = |f: f64| planar::Leg::load_to(planar::Wrench::force([f, 0.0]));
        let mut path = grasp.follow(planar::Wrench::ZERO, &[push(most), push(-most), push(most)]).unwrap();
        let events = path.run();
        assert!(completed(path.end()), "{n}: {:?}", path.end());
        assert_close!(events[0].fraction, 1.0 / 3.0);
        assert_eq!(changes(&events[0]).iter().map(|(i, _)| *i).collect::<Vec<_>>(), who, "{n}");
        assert_mirrored(n, &events);
        // In each leg every contact slides, sticks, opens and closes at most a few times.
        assert!(events.len() <= 3 * 4 * (n / 2 + 1), "{n}: {} events", events.len());
        let end = path.state().unwrap();
        assert!(
            end.twist.translation()[1].abs() + end.twist.rotation().abs() < 1e-12,
            "{n}: {:?}",
            end.twist
        );
        assert!(path.energies().iter().all(|e| e.residual().abs() < 1e-13 && e.dissipated >= 0.0));
    }
}

/// A ring in space about the axis z, with first tangents along this axis. Guides form an elastic base with the stiffness BASE along and about the
/// axis.
fn ring_in_space(n: usize) -> spatial::Grasp {
    let finger =
        |i: usize| around::<3>(i, n, 1.0, [K, KT], MU).tangent([0.0, 0.0, 1.0]).command([A, 0.0, 0.0]);
    let seat = |(c, s): (f64, f64)| {
        spatial::Contact::new([c, s, 0.0], [0.0, 0.0, 1.0]).series_stiffness(0.25 * BASE, 1.0).kept_closed()
    };
    let stop = |(c, s): (f64, f64)| {
        spatial::Contact::new([c, s, 0.0], [-s, c, 0.0]).series_stiffness(0.25 * BASE, 1.0).kept_closed()
    };
    spatial::Grasp::new((0..n).map(finger).chain(ring(4).map(seat)).chain(ring(4).map(stop))).unwrap()
}

/// A force along and a moment about the axis act together and drag all fingers alike, at an angle π/8 + δ to their first tangent. On the polygon,
/// with r = μN cos π/8, they slide along the facet at π/8 when the drag per finger KT|Q|/(n KT + B) cos δ is r. They turn at the corner of this facet
/// when the drag along the facet is r tan π/8. When the load is taken back they stick, and slide back after twice the load of first slip.
#[test]
fn a_ring_on_facets_slides_and_turns_as_one() {
    for n in 2..=64 {
        let grasp = ring_in_space(n);
        let (r, all_springs) = (MU * K * A * FRAC_PI_8.cos(), n as f64 * KT + BASE);
        for delta in [-0.3, 0.2] {
            let (sin, cos) = (FRAC_PI_8 + delta).sin_cos();
            // t₂ = n × z is (-s, c, 0) along the circumference for n = -(c, s, 0).
            let pull = |q: f64| {
                spatial::Leg::load_to(spatial::Wrench::new([0.0, 0.0, -q * cos], [0.0, 0.0, -q * sin]))
            };
            let slides = r * all_springs / (KT * delta.cos());
            let turns = r * FRAC_PI_8.tan() * all_springs / (KT * delta.sin().abs());
            let most = 1.25 * turns.max(2.0 * slides);
            let legs = [pull(most), pull(0.0)];
            let on_facets = Settings::default().on_the_polygon();
            let asked = grasp.with(&on_facets);
            let mut path = asked.follow(spatial::Wrench::ZERO, &legs).unwrap();
            let events = path.run();
            assert!(completed(path.end()), "{n}: {:?}", path.end());
            let expected: [Line; 4] = [
                (0, slides / most, all(n, "slides")),
                (0, turns / most, all(n, "turns")),
                (1, 0.0, all(n, "sticks")),
                (1, 2.0 * slides / most, all(n, "slides")),
            ];
            assert_story(&events, &expected);
            assert_eq!(events[0].free_motions.len(), 0);
        }
    }
}

/// On the round cone the drag keeps its direction, so friction does not turn, r = μN, and the contacts slide back after twice the first load.
#[test]
fn a_ring_in_space_slides_and_sticks_as_one() {
    for n in [2, 3, 4, 5, 8, 13, 64] {
        let grasp = ring_in_space(n);
        for angle in [0.2, FRAC_PI_8, 1.1] {
            let (sin, cos) = f64::sin_cos(angle);
            let pull = |q: f64| {
                spatial::Leg::load_to(spatial::Wrench::new([0.0, 0.0, -q * cos], [0.0, 0.0, -q * sin]))
            };
            let slides = MU * K * A * (n as f64 * KT + BASE) / KT;
            let most = 2.5 * slides;
            let mut path = grasp.follow(spatial::Wrench::ZERO, &[pull(most), pull(0.0)]).unwrap();
            let events = path.run();
            assert!(completed(path.end()), "{n}: {:?}", path.end());
            let expected: [Line; 3] = [
                (0, 1.0 / 2.5, all(n, "slides")),
                (1, 0.0, all(n, "sticks")),
                (1, 2.0 / 2.5, all(n, "slides")),
            ];
            assert_story(&events, &expected);
            for contact in &path.state_at(0, 0.7).unwrap().contacts[..n] {
                assert_close!(contact.force[1], MU * K * A * cos);
                assert_close!(contact.force[2], MU * K * A * sin);
            }
        }
    }
}

/// Releasing and squeezing again in space, under a pull along the axis, has one event each.
#[test]
fn a_ring_in_space_let_go_and_squeezed_again() {
    for n in 2..=64 {
        let grasp = ring_in_space(n);
        let share = 1.2 * MU * K * A;
        let weight = share * (n as f64 * KT + BASE) / KT;
        let pull = |w: f64| spatial::Leg::load_to(spatial::Wrench::force([0.0, 0.0, -w]));
        let press = |a: f64| spatial::Leg::commands_to(squeeze::<3>(n, 8, a));
        let legs = [press(2.0 * A), pull(weight), press(0.5 * A), press(2.0 * A), pull(0.0)];
        let mut path = grasp.follow(spatial::Wrench::ZERO, &legs).unwrap();
        let events = path.run();
        assert!(completed(path.end()), "{n}: {:?}", path.end());
        assert_story(&events, &[(2, 0.8 / 1.5, all(n, "slides")), (3, 0.0, all(n, "sticks"))]);
        for c in &path.state().unwrap().contacts[..n] {
            assert_close!(c.force_world[2], MU * K * 0.5 * A - share);
        }
    }
}

/// Under a side load in space the axis stays upright by symmetry, and events contain mirror images.
#[test]
fn a_side_load_in_space_goes_through_mirror_images() {
    for n in [2, 3, 4, 5, 6, 8, 11, 16, 31, 64] {
        let grasp = ring_in_space(n);
        let (x, who) = first_to_let_go(n);
        // Two of the four stops resist a force along x.
        let stiffness = 0.5 * BASE + if n == 2 { 2.0 * K } else { 0.5 * n as f64 * (K + KT) };
        let most = 2.0 * x * stiffness;
        let push = |f: f64| spatial::Leg::load_to(spatial::Wrench::force([f, 0.0, 0.0]));
        let mut path = grasp.follow(spatial::Wrench::ZERO, &[push(most), push(-most), push(most)]).unwrap();
        let events = path.run();
        assert!(completed(path.end()), "{n}: {:?}", path.end());
        assert_close!(events[0].fraction, 0.5);
        assert_eq!(changes(&events[0]).iter().map(|(i, _)| *i).collect::<Vec<_>>(), who, "{n}");
        assert_mirrored(n, &events);
    }
}
