//! Load programs of pads of hundreds of springs followed on lists of contact states, against numbers that can be written down: a pad pressed by a parabola
//! and dragged (every contact slides at a known load, and back at twice the range, Masing's rule), dragged until it gives way, and pads that
//! touch one pair of contacts after the other.
//!
//! All friction acts along y = 0 through the middle of the pad, so a shear load Q there neither tilts nor lifts the block: with
//! c the tangential stiffness of each contact and f_i = μ N_i,
//!
//! ```text
//! Q(x) = Σ_i min(c x, f_i)             first loading, contact i slides from x = f_i / c on
//! Q = Q_0 - 2 Q((x_0 - x)/2)           on the way back from (x_0, Q_0), contact i slides back from x = x_0 - 2 f_i / c on
//! ```

use grasp_lcp::planar::{Change, Contact, Grasp, Leg, PathEnd, Wrench};
use grasp_lcp::{load_path, spatial};
use support::programs::numbers;

const MU: f64 = 0.4;
const K: f64 = 70.0;
const C: f64 = 50.0;

fn real(n: usize) -> f64 {
    f64::from(u32::try_from(n).unwrap())
}

fn at(i: usize, n: usize) -> f64 {
    real(2 * i + 1) / real(n) - 1.0
}

/// A pressure that no two contacts share, unless they are images of each other.
fn press(i: usize, n: usize) -> f64 {
    1.0 - at(i, n) * at(i, n)
}

struct Pad {
    grasp: Grasp,
    /// μ N_i in the order of the contacts.
    limits: Vec<f64>,
}

impl Pad {
    fn new(n: usize) -> Self {
        let foot = |i: usize| {
            Contact::new([at(i, n), 0.0], [0.0, 1.0])
                .series_stiffness(K, C)
                .friction(MU)
                .command([press(i, n) / K, 0.0])
        };
        let limits = (0..n).map(|i| MU * press(i, n)).collect();
        Self { grasp: Grasp::new((0..n).map(foot)).unwrap(), limits }
    }

    fn load(&self, q: f64) -> Wrench {
        Wrench::force([q, -self.limits.iter().sum::<f64>() / MU])
    }

    /// Q(x).
    fn virgin(&self, x: f64) -> f64 {
        self.limits.iter().map(|limit| (C * x).min(*limit)).sum()
    }
}

fn close(x: f64, y: f64, size: f64) {
    assert!((x - y).abs() <= 1e-12 * size, "{x} {y}");
}

#[test]
fn every_contact_slides_where_it_must_and_back_at_twice_the_range() {
    for n in [2, 33, 100, 1000] {
        let pad = Pad::new(n);
        // Half of the contacts, more or less, slide at the turning point.
        let x0 = 0.6 * MU / C;
        let [most, least] = [pad.virgin(x0), pad.virgin(x0) - 2.0 * pad.virgin(0.9 * x0)];
        let legs = [most, least].map(|q| Leg::load_to(pad.load(q)));
        let mut path = pad.grasp.follow_patch(&pad.load(0.0), &legs).unwrap();
        let events: Vec<_> = path.by_ref().collect();
        assert!(matches!(path.end(), Some(PathEnd::Completed)), "{:?}", path.end());
        let (mut slid, mut stuck, mut back) = (vec![false; n], vec![false; n], vec![false; n]);
        for event in &events {
            let x = pad.limits[event.contact] / C;
            match (event.leg, event.change) {
                (0, Change::Slides { direction }) => {
                    // The fingers stay behind.
                    assert!(direction[0] < 0.0);
                    close(event.fraction * most, pad.virgin(x), most);
                    slid[event.contact] = true;
                }
                (1, Change::Sticks) => {
                    close(event.fraction, 0.0, 1.0);
                    stuck[event.contact] = true;
                }
                (1, Change::Slides { direction }) => {
                    assert!(direction[0] > 0.0);
                    let q = most + (least - most) * event.fraction;
                    close(q, most - 2.0 * pad.virgin(x), most);
                    back[event.contact] = true;
                }
                _ => panic!("{event:?}"),
            }
        }
        for i in 0..n {
            let x = pad.limits[i] / C;
            assert_eq!([slid[i], stuck[i], back[i]], [x < x0, x < x0, x < 0.9 * x0], "{i}");
        }
        let changes = slid.iter().chain(&stuck).chain(&back).filter(|changed| **changed).count();
        assert_eq!(changes, events.len());
        let state = path.state().unwrap();
        close(state.twist.translation()[0], x0 - 2.0 * 0.9 * x0, x0);
        assert!(state.residuals.worst() <= 1e-12, "{:?}", state.residuals);
        for (i, contact) in state.contacts.iter().enumerate() {
            // Held back on the way there, then pushed on by up to as much.
            let there = (C * x0).min(pad.limits[i]);
            let force = (there - C * 1.8 * x0).max(-pad.limits[i]);
            close(contact.force[1], -force, pad.limits[n / 2]);
        }
    }
}

#[test]
fn it_gives_way_when_every_contact_slides() {
    for n in [3, 40, 500, 5000] {
        let pad = Pad::new(n);
        let most: f64 = pad.limits.iter().sum();
        let mut path =
            pad.grasp.follow_patch(&pad.load(0.0), &[Leg::load_to(pad.load(1.25 * most))]).unwrap();
        let events: Vec<_> = path.by_ref().collect();
        // The last ones reach their limit where the path ends.
        let last = pad.limits.iter().copied().fold(0.0, f64::max);
        let expected = pad.limits.iter().filter(|limit| **limit < last * (1.0 - 1e-12)).count();
        assert_eq!(events.len(), expected);
        assert!(matches!(path.beyond(), Some(load_path::Beyond::LimitLoad)));
        let loss = path.end().and_then(load_path::PathEnd::loss).expect("a loss");
        close(loss.load.to_vector()[0], most, most);
        assert_eq!(numbers(&loss.contacts), (0..n).collect::<Vec<_>>());
        let motion = loss.motion.as_ref().unwrap();
        assert!(motion.object.translation()[0] > 0.9 && motion.object.rotation().abs() < 1e-6, "{motion:?}");
        let state = path.state().unwrap();
        let carried: f64 = state.contacts.iter().map(|contact| contact.force[1].abs()).sum();
        close(carried, most, most);
    }
}

/// Pairs of contacts at ±x with clearances that grow from the middle outwards: pressed, pair j touches when the block has moved by its clearance,
/// at the load that the pairs before it carry there; let go, they part at the same loads.
#[test]
fn pairs_touch_and_part_at_known_loads() {
    let (n, deepest) = (60, 0.5);
    let clearance = |j: usize| (real(j) / real(n)).powi(2);
    let spring = |i: usize| {
        let (j, side) = (i / 2, if i.is_multiple_of(2) { 1.0 } else { -1.0 });
        Contact::new([side * (0.1 + real(j)), 0.0], [0.0, 1.0])
            .series_stiffness(K, C)
            .friction(MU)
            .clearance(clearance(j))
            .command([0.01, 0.0])
    };
    let grasp = Grasp::new((0..2 * n).map(spring)).unwrap();
    // Load at which the block has gone down by z from where the innermost pair touches without force.
    let load = |z: f64| -> f64 { (0..n).map(|j| 2.0 * K * (z - clearance(j)).max(0.0)).sum() };
    let press = |z: f64| Wrench::force([0.0, -load(z)]);
    let (first, most) = (0.5 * clearance(1), load(deepest));
    let legs = [Leg::load_to(press(deepest)), Leg::load_to(press(first))];
    let mut path = grasp.follow_patch(&press(first), &legs).unwrap();
    let events: Vec<_> = path.by_ref().collect();
    assert!(matches!(path.end(), Some(PathEnd::Completed)), "{:?}", path.end());
    let touching = (1..n).filter(|&j| clearance(j) < deepest).count();
    assert_eq!(events.len(), 4 * touching);
    let (from, to) = (load(first), most);
    for event in &events {
        let expected = load(clearance(event.contact / 2));
        let (change, q) = if event.leg == 0 {
            (Change::Closes, from + (to - from) * event.fraction)
        } else {
            (Change::Opens, to + (from - to) * event.fraction)
        };
        assert_eq!(event.change, change);
        close(q, expected, most);
    }
    assert!(path.state().unwrap().residuals.worst() <= 1e-12);
}

/// A round pad in space, dragged along the first tangent of all contacts, a corner of their polygons: along it the polygon is the round cone, and
/// the sum of springs in a row is that of the plane.
#[test]
fn a_pad_in_space_slides_like_one_in_the_plane() {
    let n = 200;
    // Rings of eight contacts with one pressure each: no tilt whatever slides.
    let pressure = |i: usize| 1.0 - 0.03 * real(i / 8);
    let foot = |i: usize| {
        let (sin, cos) = (real(i % 8) * std::f64::consts::FRAC_PI_4).sin_cos();
        let r = 1.0 + real(i / 8);
        spatial::Contact::new([r * cos, r * sin, 0.0], [0.0, 0.0, 1.0])
            .tangent([1.0, 0.0, 0.0])
            .series_stiffness(K, C)
            .friction(MU)
            .command([pressure(i) / K, 0.0, 0.0])
    };
    let grasp = spatial::Grasp::new((0..n).map(foot)).unwrap();
    let pressed: f64 = (0..n).map(pressure).sum();
    let load = |q: f64| spatial::Wrench::force([q, 0.0, -pressed]);
    let virgin = |x: f64| -> f64 { (0..n).map(|i| (C * x).min(MU * pressure(i))).sum() };
    let (x0, limit) = (0.7 * MU / C, MU * pressed);
    let legs = [virgin(x0), virgin(x0) - 2.0 * virgin(0.9 * x0), 1.1 * limit]
        .map(|q| spatial::Leg::load_to(load(q)));
    let mut path = grasp.follow_patch(&load(0.0), &legs).unwrap();
    let ends = [0.0, virgin(x0), virgin(x0) - 2.0 * virgin(0.9 * x0), 1.1 * limit];
    let mut slides = [0; 3];
    for event in path.by_ref() {
        let q = ends[event.leg] + (ends[event.leg + 1] - ends[event.leg]) * event.fraction;
        let x = MU * pressure(event.contact) / C;
        match (event.leg, event.change) {
            (leg, spatial::Change::Slides { direction }) => {
                let sign = if leg == 1 { 1.0 } else { -1.0 };
                assert!((direction[0] * sign - 1.0).abs() < 1e-9, "{direction:?}");
                slides[leg] += 1;
                match leg {
                    0 => close(q, virgin(x), limit),
                    1 => close(q, virgin(x0) - 2.0 * virgin(x), limit),
                    _ => {}
                }
            }
            (1 | 2, spatial::Change::Sticks) => assert!(event.fraction.abs() < 1e-12),
            _ => panic!("{event:?}"),
        }
    }
    let sliding = |x: f64| (0..n).filter(|&i| MU * pressure(i) / C < x).count();
    assert_eq!(slides[..2], [sliding(x0), sliding(0.9 * x0)]);
    assert!(matches!(path.beyond(), Some(load_path::Beyond::LimitLoad)));
    let loss = path.end().and_then(load_path::PathEnd::loss).expect("a loss");
    close(loss.load.to_vector()[0], limit, limit);
    assert_eq!(loss.contacts.len(), n);
}
