//! Load paths in space agree with closed forms: Masing's rule in torsion, fingers that drag a body to and fro, a table that lifts its feet and tips,
//! and weights in a grip. Friction forces lie on corners of the polygon, which are also on the round cone.

use std::f64::consts::TAU;

use crate::story::{assert_close, assert_story, completed};
use grasp_lcp::spatial::{Contact, Grasp, Leg, Wrench};
use support::ends::limit_load;
use support::jaws::around;
use support::programs::numbers;

const K: f64 = 40.0;
const KT: f64 = 16.0;
const A: f64 = 0.05;
/// Normal force of each finger.
const N: f64 = K * A;
/// Stiffness of the elastic base about the axis.
const BASE: f64 = 6.0;

/// Fingers on the unit circle about z, one for each entry of `frictions`, with first tangents along z and second tangents along the circle. An
/// elastic base resists rotation about z, and guides prevent all other motions.
fn grip(frictions: &[f64]) -> Grasp {
    let n = frictions.len();
    let finger = |i: usize| {
        around::<3>(i, n, 1.0, [K, KT], frictions[i]).tangent([0.0, 0.0, 1.0]).command([A, 0.0, 0.0])
    };
    let stop = |i: usize| {
        let (s, c) = (TAU * i as f64 / 4.0).sin_cos();
        Contact::new([c, s, 0.0], [-s, c, 0.0]).series_stiffness(BASE / 4.0, 1.0).kept_closed()
    };
    Grasp::new((0..n).map(finger).chain((0..4).map(stop))).unwrap()
}

fn turn(moment: f64) -> Leg {
    Leg::load_to(Wrench::new([0.0; 3], [0.0, 0.0, moment]))
}

/// Two pairs of opposite fingers have the friction limits f = μN of 1/2 and 1/4 of their normal force. During the first loading, M = V(θ) = 2 min(kt
/// θ, f₁) + 2 min(kt θ, f₂) + B θ with the stiffness B of the base. After a turning point (θ₁, M₁), unloading follows the same curve twice as large,
/// M = M₁ - 2 V((θ₁ - θ)/2). The weaker pair slides back at θ₁ - 2 f₂/kt, the stronger pair at θ₁ - 2 f₁/kt. A full cycle dissipates Σ 4 f (θ₁ -
/// f/kt). A smaller loop inside closes where it began.
#[test]
fn torsion_follows_masing() {
    let strengths = [0.5 * N, 0.25 * N];
    let grasp = grip(&[0.5, 0.25, 0.5, 0.25]);
    let virgin = |t: f64| BASE * t + strengths.iter().map(|f| 2.0 * f.min(KT * t)).sum::<f64>();
    let most = 1.75 * strengths[0] / KT;
    let m1 = virgin(most);
    let inside = m1 - 2.0 * virgin(0.6 * strengths[0] / KT);
    let mut path =
        grasp.follow(Wrench::ZERO, &[turn(m1), turn(-m1), turn(m1), turn(inside), turn(m1)]).unwrap();
    let events = path.run();
    assert!(completed(path.end()), "{:?}", path.end());
    let (strong, weak) = (strengths[0] / KT, strengths[1] / KT);
    let pair = |first: usize, what| vec![(first, what), (first + 2, what)];
    let all = |what| (0..4).map(|i| (i, what)).collect::<Vec<_>>();
    let back = |x: f64| virgin(x) / m1;
    let part = |x: f64| 2.0 * virgin(x) / (m1 - inside);
    let mut expected =
        vec![(0, virgin(weak) / m1, pair(1, "slides")), (0, virgin(strong) / m1, pair(0, "slides"))];
    for leg in [1, 2] {
        expected.push((leg, 0.0, all("sticks")));
        expected.push((leg, back(weak), pair(1, "slides")));
        expected.push((leg, back(strong), pair(0, "slides")));
    }
    // Only the weaker pair slides in the small loop. Loading beyond this loop would slide both pairs again.
    expected.extend([(3, 0.0, all("sticks")), (3, part(weak), pair(1, "slides"))]);
    expected.extend([(4, 0.0, pair(1, "sticks")), (4, part(weak), pair(1, "slides"))]);
    assert_story(&events, &expected);
    for (leg, from, sign) in [(1, m1, 1.0), (2, -m1, -1.0), (3, m1, 1.0)] {
        for step in 1..=16 {
            let state = path.state_at(leg, f64::from(step) / 16.0).unwrap();
            let gone = sign * (sign * most - state.twist.rotation()[2]);
            let moment = state.load.to_vector()[5];
            assert_close!(sign * (from - moment), 2.0 * virgin(gone / 2.0));
        }
    }
    let cycle: f64 = path.energies()[1..3].iter().map(|e| e.dissipated).sum();
    let area = |x: f64| strengths.iter().map(|f| 2.0 * 4.0 * f * (x - f / KT).max(0.0)).sum::<f64>();
    assert_close!(cycle, area(most));
    let small: f64 = path.energies()[3..5].iter().map(|e| e.load_work).sum();
    assert_close!(small, area(0.6 * strong));
    let end = path.state().unwrap();
    assert_close!(end.twist.rotation()[2], most);
    for (i, c) in end.contacts[..4].iter().enumerate() {
        assert_close!(c.force[2], -strengths[i % 2]);
    }
}

/// Six fingers (friction limit f = μN each) drag the body about its axis by c, against the elastic base, and back to -c. They carry the body to θ* =
/// 6f/B, where they slide, at c* = θ* + f/kt. On the way back they slide when they have moved by 2c*. In each cycle the fingers do the work 6·4 f (c
/// - c*), and all of it becomes heat.
#[test]
fn fingers_drag_the_body_to_and_fro() {
    let mu = 0.3;
    let (f, grasp) = (mu * N, grip(&[mu; 6]));
    let carried = 6.0 * f / BASE;
    let slides = carried + f / KT;
    let c = 2.5 * slides;
    let drag = |c: f64| {
        let still = std::iter::repeat_n([0.0; 3], 4);
        Leg::commands_to(std::iter::repeat_n([A, 0.0, c], 6).chain(still).collect::<Vec<_>>())
    };
    let mut path = grasp.follow(Wrench::ZERO, &[drag(c), drag(-c), drag(c)]).unwrap();
    let events = path.run();
    assert!(completed(path.end()), "{:?}", path.end());
    let all = |what| (0..6).map(|i| (i, what)).collect::<Vec<_>>();
    let mut expected = vec![(0, slides / c, all("slides"))];
    for leg in [1, 2] {
        expected.extend([(leg, 0.0, all("sticks")), (leg, slides / c, all("slides"))]);
    }
    assert_story(&events, &expected);
    for (leg, sign) in [(0, 1.0), (1, -1.0), (2, 1.0)] {
        assert_close!(path.state_at(leg, 1.0).unwrap().twist.rotation()[2], sign * carried);
    }
    let heat: f64 = path.energies()[1..3].iter().map(|e| e.dissipated).sum();
    let work: f64 = path.energies()[1..3].iter().map(|e| e.finger_work).sum();
    assert_close!(heat, 24.0 * f * (c - slides));
    assert_close!(work, heat);
    assert!(path.energies().iter().all(|e| e.load_work == 0.0 && e.residual().abs() < 1e-13));
}

/// A table on four frictionless feet at (±1, ±1), with a weight w at (e, e). The foot at (x, y) carries F = w/4 (1 + e (x + y)), so that the far foot
/// lifts at e = 1/2. Then three feet carry the table: w e at the foot nearest to the weight, and w (1 - e)/2 at each of its two neighbours. The
/// neighbours lift together at e = 1. Beyond, the nearest foot alone does not hold the table. If the weight returns before e = 1, the far foot comes
/// down where it lifted, at e = 1/2.
#[test]
fn a_table_lifts_its_feet_and_tips() {
    let (k, w) = (70.0, 5.0);
    let corners = [[1.0, 1.0], [-1.0, 1.0], [-1.0, -1.0], [1.0, -1.0]];
    let foot = |[x, y]: [f64; 2]| Contact::new([x, y, 0.0], [0.0, 0.0, 1.0]).series_stiffness(k, 1.0);
    let guide =
        |x: f64, normal: [f64; 3]| Contact::new([x, 0.0, 0.0], normal).series_stiffness(k, 1.0).kept_closed();
    let guides = [guide(0.0, [1.0, 0.0, 0.0]), guide(1.0, [0.0, 1.0, 0.0]), guide(-1.0, [0.0, 1.0, 0.0])];
    let table = Grasp::new(corners.map(foot).into_iter().chain(guides)).unwrap();
    let at = |e: f64| Leg::load_to(Wrench::force_at([0.0, 0.0, -w], [e, e, 0.0]));
    let start = Wrench::force([0.0, 0.0, -w]);
    let mut path = table.follow(start, &[at(0.8), at(0.0), at(1.25)]).unwrap();
    let events = path.run();
    assert_story(
        &events,
        &[
            (0, 0.5 / 0.8, vec![(2, "opens")]),
            (1, 1.0 - 0.5 / 0.8, vec![(2, "closes")]),
            (2, 0.5 / 1.25, vec![(2, "opens")]),
        ],
    );
    let three = path.state_at(0, 1.0).unwrap();
    for (c, expected) in three.contacts.iter().zip([0.8 * w, 0.1 * w, 0.0, 0.1 * w]) {
        assert_close!(c.normal_force(), expected);
    }
    // The three loaded feet define the plane of the table. The gap at the fourth follows from opposite corners, (0.8 w - 2·0.1 w) / k.
    assert_close!(three.contacts[2].gap, (0.8 * w - 0.2 * w) / k);
    for c in &path.state_at(1, 1.0).unwrap().contacts[..4] {
        assert_close!(c.normal_force(), w / 4.0);
    }
    let loss = limit_load(&path);
    assert_eq!((loss.leg, &numbers(&loss.contacts)[..]), (2, &[1, 3][..]));
    assert_close!(loss.fraction, 1.0 / 1.25);
    let work: f64 = path.energies()[..2].iter().map(|e| e.load_work).sum();
    assert!(work.abs() < 1e-13, "{work}");
}

/// A weight along the axis of a grip. With one coefficient of friction all n fingers slide at once: the first slip and the limit load are at w = n
/// μN. With different coefficients they slide pair by pair as the weight sinks by z, at kt z = μ_i N, and the limit load Σ μ_i N is larger than that
/// of the first slip. For up to eight fingers the limit is proved.
#[test]
fn a_grip_loses_its_weight_at_once_or_one_after_the_other() {
    let cases: [(&[f64], &[f64]); 5] = [
        (&[0.4; 3], &[]),
        (&[0.4; 5], &[]),
        (&[0.4; 8], &[]),
        (&[0.2, 0.5, 0.2, 0.5], &[0.2]),
        (&[0.2, 0.5, 0.3, 0.2, 0.5, 0.3], &[0.2, 0.3]),
    ];
    for (frictions, before) in cases {
        let grasp = grip(frictions);
        let limit: f64 = frictions.iter().map(|mu| mu * N).sum();
        let pull = Leg::load_to(Wrench::force([0.0, 0.0, -1.6 * limit]));
        let mut path = grasp.follow(Wrench::ZERO, &[pull]).unwrap();
        let events = path.run();
        let carried = |z: f64| frictions.iter().map(|mu| (mu * N).min(KT * z)).sum::<f64>();
        let expected: Vec<_> = before
            .iter()
            .map(|mu| {
                let who = (0..frictions.len()).filter(|&i| frictions[i] == *mu);
                (0, carried(mu * N / KT) / (1.6 * limit), who.map(|i| (i, "slides")).collect())
            })
            .collect();
        assert_story(&events, &expected);
        let loss = limit_load(&path);
        assert_close!(loss.fraction, 1.0 / 1.6);
        assert_eq!(numbers(&loss.contacts), (0..frictions.len()).collect::<Vec<_>>());
        assert!(loss.motion.as_ref().expect("a motion").object.translation()[2] < -0.9);
    }
}
