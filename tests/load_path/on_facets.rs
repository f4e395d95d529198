//! Load paths in space on a polygonal cone agree with hand calculations. Pads slide along a facet, turn at a corner and continue along the next
//! facet. All contacts of a ring slide at once.
//!
//! All numbers come from the geometry of the polygon (8 facets, inscribed: corner j at angle jπ/4 of the contact's tangents on the circle of radius
//! μN, facets between at distance r = μN cos π/8) and from scalar springs.

use std::f64::consts::{FRAC_PI_4, FRAC_PI_8, TAU};

use grasp_lcp::Settings;
use grasp_lcp::spatial::{Change, Contact, Event, Grasp, Leg, LoadPath, PathEnd, Wrench};
use nalgebra::Vector2;
use support::assert_close;

const K: f64 = 60.0;
const KT: f64 = 25.0;
const KB: f64 = 8.0;
const MU: f64 = 0.5;
const N: f64 = 3.0;

/// The unit vector at an angle.
fn at(angle: f64) -> Vector2<f64> {
    Vector2::new(angle.cos(), angle.sin())
}

/// Four feet at z = 0 under a block, each pressed with N, and next to them four bonded springs with the total stiffness KB in every direction. Loads
/// in z = 0 neither tilt nor lift the block: F_i = -KT(u + s), Σ F_i - KB u + Q = 0.
fn block() -> Grasp {
    let corners = [[1.0, 1.0], [-1.0, 1.0], [-1.0, -1.0], [1.0, -1.0]];
    let foot = |[x, y]: [f64; 2]| {
        Contact::new([x, y, 0.0], [0.0, 0.0, 1.0])
            .tangent([1.0, 0.0, 0.0])
            .series_stiffness(K, KT)
            .friction(MU)
            .command([N / K, 0.0, 0.0])
    };
    let spring = |[x, y]: [f64; 2]| {
        Contact::new([x, y, 0.0], [0.0, 0.0, 1.0]).series_stiffness(KB / 4.0, KB / 4.0).bonded()
    };
    let block = Grasp::new(corners.map(foot).into_iter().chain(corners.map(spring))).unwrap();
    block.with(&Settings::default().on_the_polygon())
}

/// The block is pulled by -Q, so that the friction on it points along +Q.
fn pulled(q: Vector2<f64>) -> Wrench {
    Wrench::force([-q[0], -q[1], -4.0 * N])
}

/// Follows these loads on the polygonal cone.
fn follow<'g>(grasp: &'g Grasp, loads: &[Vector2<f64>]) -> (LoadPath<'g>, Vec<Event>) {
    let legs: Vec<_> = loads.iter().map(|q| Leg::load_to(pulled(*q))).collect();
    let mut path = grasp.follow(pulled(Vector2::zeros()), &legs).unwrap();
    let events = path.run();
    assert!(matches!(path.end(), Some(PathEnd::Completed)), "{:?}", path.end());
    assert!(path.energies().iter().all(|e| e.residual().abs() < 1e-13 && e.dissipated >= 0.0));
    (path, events)
}

/// The change that all four feet have in common, and its direction.
fn together(event: &Event) -> (&'static str, Option<Vector2<f64>>) {
    let words: Vec<_> = event
        .changes
        .iter()
        .map(|change| match &change.what {
            Change::Slides { direction } => ("slides", Some(direction.xy())),
            Change::Turns { direction } => ("turns", Some(direction.xy())),
            Change::Reverses { direction } => ("reverses", Some(direction.xy())),
            Change::Sticks => ("sticks", None),
            other => panic!("{other:?}"),
        })
        .collect();
    let contacts: Vec<_> = event.changes.iter().map(|change| change.contact.index).collect();
    assert_eq!(contacts, [0, 1, 2, 3]);
    let differ = |(word, d): &(&str, Option<Vector2<f64>>)| {
        *word != words[0].0 || d.zip(words[0].1).is_some_and(|(a, b)| (a - b).norm() > 1e-12)
    };
    assert!(!words.iter().any(differ), "{words:?}");
    words[0]
}

fn assert_event(event: &Event, leg: usize, fraction: f64, what: &str, angle: Option<f64>) {
    assert_eq!(event.leg, leg);
    assert_close!(event.fraction, fraction);
    let (word, direction) = together(event);
    assert_eq!(word, what);
    if let Some((d, angle)) = direction.zip(angle) {
        assert!((d - at(angle)).norm() < 1e-12, "{d} {angle}");
    }
}

/// Friction force of a foot and the displacement of the block.
fn foot(state: &grasp_lcp::spatial::Equilibrium) -> (Vector2<f64>, Vector2<f64>) {
    let [x, y, _] = state.twist.translation();
    (state.contacts[0].force_world.xy(), Vector2::new(x, y))
}

/// The pull is at the angle π/8 + δ, 0 < δ < π/8. While the feet stick, u = -Q/(4KT + KB) and F = KT Q/(4KT + KB). They slide when the part of F
/// across the facet at π/8 is r, from Q₁ = r (4KT + KB)/(KT cos δ) on. Along the facet the springs still stick, so that F moves along the facet to
/// its corner, at the distance r tan π/8. F reaches this corner at Q₂ = r tan(π/8)(4KT + KB)/(KT sin δ). Then F stays at the corner, F = μN at(π/4),
/// and the block slips in the direction of the pull. During unloading F moves from the corner by -ΔQ KT/(4KT + KB) and first meets the opposite
/// facet, where the part of F across is -r: ΔQ = 2r(4KT + KB)/(KT cos δ).
#[test]
fn a_pad_slides_along_a_facet_to_its_corner() {
    let grasp = block();
    let (r, all) = (MU * N * FRAC_PI_8.cos(), 4.0 * KT + KB);
    for delta in [0.1, 0.25, 0.35] {
        let way = at(FRAC_PI_8 + delta);
        let (across, along) = (at(FRAC_PI_8), at(FRAC_PI_8 + TAU / 4.0));
        let q1 = r * all / (KT * delta.cos());
        let q2 = r * FRAC_PI_8.tan() * all / (KT * delta.sin());
        let q = 1.5 * q2.max(2.0 * q1);
        let (path, events) = follow(&grasp, &[way * q, Vector2::zeros()]);
        assert_event(&events[0], 0, q1 / q, "slides", Some(FRAC_PI_8));
        assert_event(&events[1], 0, q2 / q, "turns", Some(FRAC_PI_8 + delta));
        assert_event(&events[2], 1, 0.0, "sticks", None);
        assert_event(&events[3], 1, 2.0 * q1 / q, "slides", Some(FRAC_PI_8 + TAU / 2.0));
        let (f, u) = foot(&path.state_at(0, 0.5 * (q1 + q2) / q).unwrap());
        let load = way * (0.5 * (q1 + q2));
        assert_close!(f.dot(&across), r);
        assert_close!(f.dot(&along), KT / all * load.dot(&along));
        assert_close!(u.dot(&across), (4.0 * r - load.dot(&across)) / KB);
        let (f, u) = foot(&path.state_at(0, 1.0).unwrap());
        let corner = at(FRAC_PI_4) * (MU * N);
        assert!((f - corner).norm() < 1e-12, "{f}");
        assert!((u - (corner * 4.0 - way * q) / KB).norm() < 1e-11, "{u}");
    }
}

/// Under a pull Q towards a corner (at π/4) all feet slide at once on both facets of this corner, at KT Q/(4KT + KB) = μN. Under a pull perpendicular
/// to a facet (at π/8) they slide where this force is r, and never turn. In both cases they slide back after twice this load.
#[test]
fn pulled_at_a_corner_and_at_a_facet_nothing_turns() {
    let grasp = block();
    let all = 4.0 * KT + KB;
    for (angle, strength) in [(FRAC_PI_4, MU * N), (FRAC_PI_8, MU * N * FRAC_PI_8.cos()), (TAU / 2.0, MU * N)]
    {
        let slides = strength * all / KT;
        let q = 3.0 * slides;
        let (path, events) = follow(&grasp, &[at(angle) * q, at(angle) * -q]);
        assert_eq!(events.len(), 3, "{angle}");
        assert_event(&events[0], 0, 1.0 / 3.0, "slides", Some(angle));
        assert_event(&events[1], 1, 0.0, "sticks", None);
        assert_event(&events[2], 1, 1.0 / 3.0, "slides", Some(angle + TAU / 2.0));
        let (f, u) = foot(&path.state().unwrap());
        assert!((f + at(angle) * strength).norm() < 1e-12);
        assert!((u - at(angle) * ((q - 4.0 * strength) / KB)).norm() < 1e-11);
    }
}

/// The block is pulled towards the corner at π/4 until it slides. Then a load at the angle ψ is added: Q + λ P at(ψ). If |ψ - π/4| < π/8, within the
/// normal cone of the corner, the forces stay at the corner and only the slip turns, without an event. If |ψ - π/4| is between π/8 and 5π/8, they
/// move along the facet at 3π/8. Across this facet they remain at r, and along it the springs take KT/(4KT + KB) of λP. They reach the next corner,
/// at π/2 and the distance 2r tan π/8, where λP sin(ψ - 3π/8) KT/(4KT + KB) = 2r tan π/8. With larger angles the feet stick.
#[test]
fn the_load_turns_and_the_feet_follow() {
    let grasp = block();
    let (r, all) = (MU * N * FRAC_PI_8.cos(), 4.0 * KT + KB);
    let q = at(FRAC_PI_4) * (2.0 * MU * N * all / KT);
    for (psi, sweeps) in [(0.3 * TAU / 2.0, false), (0.45 * TAU / 2.0, true), (0.6 * TAU / 2.0, true)] {
        let more = 2.0 * 2.0 * r * FRAC_PI_8.tan() * all / (KT * (psi - 3.0 * FRAC_PI_8).sin().abs());
        let (path, events) = follow(&grasp, &[q, q + at(psi) * more]);
        assert_event(&events[0], 0, 0.5, "slides", Some(FRAC_PI_4));
        let (f, _) = foot(&path.state().unwrap());
        if sweeps {
            assert_event(&events[1], 1, 0.0, "turns", Some(3.0 * FRAC_PI_8));
            assert_event(&events[2], 1, 0.5, "turns", Some(psi));
            assert_eq!(events.len(), 3);
            assert!((foot(&events[2].state).0 - at(TAU / 4.0) * (MU * N)).norm() < 1e-12);
            assert!((f - at(TAU / 4.0) * (MU * N)).norm() < 1e-12);
        } else {
            assert_eq!(events.len(), 1, "the corner stays");
            assert!((f - at(FRAC_PI_4) * (MU * N)).norm() < 1e-12);
        }
    }
    let (_, events) = follow(&grasp, &[q, q + at(FRAC_PI_4 + 0.7 * TAU / 2.0) * 0.1]);
    assert_event(&events[1], 1, 0.0, "sticks", None);
    assert_eq!(events.len(), 2);
}

/// n fingers press on a cylinder of radius R at half its height. Two pairs of frictionless guides form an elastic torsion stop (kg R_g² each side).
/// If the cylinder is turned about its axis by θ, all friction forces are KT R θ along the circumference, towards a corner of every polygon. All n
/// fingers let go at θ = μN/(KT R) and the torque n R μN + 2 kg θ. So there is one event on the way there, and one on the way back.
#[test]
fn a_ring_turned_about_its_axis_has_one_event() {
    for n in [2_u32, 3, 4, 7, 12, 33, 64] {
        let (radius, kg) = (0.7, 3.0);
        let finger = |i: u32| {
            let d = at(TAU * f64::from(i) / f64::from(n));
            Contact::new([radius * d[0], radius * d[1], 0.0], [-d[0], -d[1], 0.0])
                .tangent([0.0, 0.0, 1.0])
                .series_stiffness(K, KT)
                .friction(MU)
                .command([N / K, 0.0, 0.0])
        };
        let stop = |side: f64| {
            Contact::new([side, 0.0, 0.0], [0.0, -side, 0.0]).series_stiffness(kg, 1.0).kept_closed()
        };
        let ring = Grasp::new((0..n).map(finger).chain([stop(1.0), stop(-1.0)])).unwrap();
        let theta = MU * N / (KT * radius);
        let lets_go = f64::from(n) * radius * MU * N + 2.0 * kg * theta;
        let torque = |m: f64| Leg::load_to(Wrench::new([0.0; 3], [0.0, 0.0, m]));
        let most = 1.25 * lets_go;
        let asked = ring.with(&Settings::default().on_the_polygon());
        let mut path = asked.follow(Wrench::ZERO, &[torque(most), torque(-most), torque(most)]).unwrap();
        let events = path.run();
        assert!(matches!(path.end(), Some(PathEnd::Completed)), "{n}: {:?}", path.end());
        let got: Vec<_> = events.iter().map(|e| (e.leg, e.changes.len())).collect();
        let all = n as usize;
        assert_eq!(got, [(0, all), (1, all), (1, all), (2, all), (2, all)], "{n}");
        let after = [0.8, 0.0, 0.8, 0.0, 0.8];
        for (event, fraction) in events.iter().zip(after) {
            assert_close!(event.fraction, fraction);
        }
        assert_close!(events[0].state.twist.rotation()[2], theta);
        for finger in &events[0].state.contacts[..all] {
            assert_close!(finger.friction_force(), MU * N);
            assert_close!(finger.normal_force(), N);
        }
    }
}
