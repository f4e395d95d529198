//! Planar load paths agree with closed forms: wedges near their locking angle, a lost continuation, the order of loading, zero and infinite friction.
//!
//! The comment above each test derives its numbers by hand from springs, Coulomb's law and balance alone.

use crate::story::{assert_close, assert_story, completed, story};
use grasp_lcp::load_path::LossKind;
use grasp_lcp::planar;
use support::ends::{limit_load, snap};
use support::jaws::jaw;
use support::programs::numbers;

/// A wedge with flank normals (±c, s), s = 0.6, c = 0.8, driven down between two fingers. Two frictionless guides keep it upright. Without them the
/// wedge could also turn under the same forces, with one flank sliding and the other not.
fn wedge(mu: f64) -> planar::Grasp {
    let (k, kt) = (100.0, 200.0);
    let flank = |side: f64| {
        planar::Contact::new([side, 0.0], [-4.0 * side, 3.0]).series_stiffness(k, kt).friction(mu)
    };
    let guide = |y: f64| planar::Contact::new([0.0, y], [1.0, 0.0]).series_stiffness(1e4, 1.0).kept_closed();
    planar::Grasp::new([flank(1.0), flank(-1.0), guide(3.0), guide(-3.0)]).unwrap()
}

/// The wedge angle is tan α = s/c = 0.75. Sinking by y compresses each flank by k s y and drags it by kt c y. Since kt c > μ k s, it slides from the
/// first moment on, with N = k s y and the load W = 2N(s + μc). When the load is taken back, the flanks stick while y falls by δ: N falls by k s δ,
/// and the upward friction T by kt c δ. They slide back when T = -μN, at δ* = 2μN₁/(kt c + μ k s) and the load W* = W₁ - 2δ*(k s² + kt c²) = 2N(s -
/// μc). W* is positive for μ < tan α. For larger μ it is negative: the unloaded wedge stays stuck, and W* is the limit load at which it is pulled
/// out.
#[test]
fn a_wedge_locks_at_its_angle() {
    let (k, kt, s, c, w1) = (100.0, 200.0, 0.6, 0.8, 6.0);
    let down = |w: f64| planar::Wrench::force([0.0, -w]);
    let tan = 0.75_f64;
    for mu in [0.25, 0.5, tan - 1e-6, tan + 1e-6, 0.9, 1.5] {
        let n1 = w1 / (2.0 * (s + mu * c));
        let back = 2.0 * mu * n1 / (kt * c + mu * k * s);
        let pulls_out = w1 - 2.0 * back * (k * s * s + kt * c * c);
        assert!((pulls_out > 0.0) == (mu < tan), "by hand");
        let grasp = wedge(mu);
        let mut path = grasp
            .follow(down(0.0), &[planar::Leg::load_to(down(w1)), planar::Leg::load_to(down(0.0))])
            .unwrap();
        let mut events = path.run();
        assert!(completed(path.end()), "{mu}: {:?}", path.end());
        let sinks = path.state_at(0, 1.0).unwrap();
        for contact in &sinks.contacts[..2] {
            assert_close!(contact.normal_force(), n1);
            assert_close!(contact.friction_force(), mu * n1);
            assert_close!(contact.slip.norm(), c * n1 / (k * s) - mu * n1 / kt);
        }
        assert_close!(sinks.twist.translation()[1], -n1 / (k * s));
        let rest = path.state_at(1, 1.0).unwrap();
        let mut expected =
            vec![(0, 0.0, vec![(0, "slides"), (1, "slides")]), (1, 0.0, vec![(0, "sticks"), (1, "sticks")])];
        if mu < tan {
            expected.push((1, 1.0 - pulls_out / w1, vec![(0, "slides"), (1, "slides")]));
            let left = rest.contacts.iter().map(|c| c.force.norm()).fold(0.0, f64::max);
            // Near the locking angle the rounding of the load is amplified by the inverse distance from this angle.
            assert!(left < 1e-14 * w1 / (tan - mu), "{mu} {left}");
        } else {
            // Without load, N s + T c = 0, after W₁ has been taken back with the stiffness of sticking flanks.
            let n = n1 - k * s * w1 / (2.0 * (k * s * s + kt * c * c));
            for contact in &rest.contacts[..2] {
                assert_close!(contact.normal_force(), n);
                assert_close!(contact.friction_force(), n * tan);
                assert_eq!(contact.state, planar::ContactState::Sticking);
            }
            path.continue_with(&[planar::Leg::load_to(down(2.0 * pulls_out))]).unwrap();
            events.extend(path.run());
            let loss = limit_load(&path);
            assert_eq!((loss.leg, &numbers(&loss.contacts)[..]), (2, &[0, 1][..]));
            // The small pull-out load has the absolute rounding error of W₁.
            assert!((loss.fraction - 0.5).abs() < 1e-14 * w1 / pulls_out.abs(), "{mu}: {}", loss.fraction);
            let [x, y] = loss.motion.as_ref().expect("a motion").object.translation();
            assert!(y > 0.99 && x.abs() < 1e-9, "it comes out: {x} {y}");
        }
        if mu >= tan {
            assert_story(&events, &expected);
        } else {
            // At the end of the unloading, without force, an opening may be reported too.
            assert_story(&events[..3], &expected);
            assert!(events[3..].iter().all(|e| e.fraction > 1.0 - 1e-12), "{:?}", story(&events));
        }
    }
}

/// Exactly at the locking angle the wedge stays until the load is gone, and then any pull takes it out. The forces of the locked wedge are those of
/// the sticking state, N = N₁ - k s δ with T = -μN, up to rounding. When the wedge is pressed again, its state is the one before unloading.
#[test]
fn a_wedge_at_its_locking_angle() {
    let down = |w: f64| planar::Wrench::force([0.0, -w]);
    let (k, kt, s, c, mu, w1) = (100.0, 200.0, 0.6, 0.8, 0.75, 6.0);
    let n1 = w1 / (2.0 * (s + mu * c));
    let n = n1 - k * s * w1 / (2.0 * (k * s * s + kt * c * c));
    let grasp = wedge(mu);
    for (then, holds) in [(w1, true), (-1.0, false)] {
        let legs = [w1, 0.0, then].map(|w| planar::Leg::load_to(down(w)));
        let mut path = grasp.follow(down(0.0), &legs).unwrap();
        path.run();
        let unloaded = path.state_at(1, 1.0 - 1e-13).unwrap();
        for contact in &unloaded.contacts[..2] {
            assert_close!(contact.normal_force(), n);
            assert_close!(contact.friction_force(), mu * n);
        }
        if holds {
            assert!(completed(path.end()), "{:?}", path.end());
            assert_close!(path.state().unwrap().twist.translation()[1], -n1 / (k * s));
        } else {
            let loss = limit_load(&path);
            assert!(
                (f64::from(u32::try_from(loss.leg).unwrap()) + loss.fraction - 2.0).abs() < 1e-12,
                "{loss:?}"
            );
        }
    }
}

/// A body on two oblique bonded springs, with one frictional foot beneath (normal y, k = 13, kt = 14, μ = 3/2, pressed by a = 24/13). The springs at
/// (±1, 0) have the stiffness 13 along (3,4)/5 and 1/2 across. Their sum is S = [10 12; 12 17], and they do not turn the body. Without a pull the
/// displacement is u = (-1/2, 1), and the foot has N = 11, T = 7. With the pull (-τ, 0) and a sticking foot, (S + K)u = (-τ, 24) with the foot's
/// stiffness K, so N = 11 - 13τ/48, T = 7 + 35τ/48, and T = 3/2 N at τ* = 912/109, N* = 952/109.
///
/// Sliding at τ*, S u' = N'(3/2, 1) + (-1, 0) with N' = -13u_y' has the determinant 10·30 - 12·31.5 = -78 < 0 and gives
/// u' = (30, -12)/78, N' = 2, T' = 3. The slip rate s' = -T'/14 - u_x' = -3/14 - 5/13 < 0 is against the friction. So this equilibrium ends.
/// With the foot open, u = τ(-17, 12)/26 clears the foot if u_y > 24/13, τ > 4: the body snaps off (sliding the other way needs τ < 4).
#[test]
fn a_continuation_lost_by_snapping() {
    let spring = |x: f64| planar::Contact::new([x, 0.0], [3.0, 4.0]).series_stiffness(13.0, 0.5).bonded();
    let foot = |k: f64| {
        planar::Contact::new([0.0, 0.0], [0.0, 1.0])
            .series_stiffness(k, 14.0)
            .friction(1.5)
            .command([24.0 / k, 0.0])
    };
    let pull = |tau: f64| planar::Wrench::force([-tau, 0.0]);
    let grasp = planar::Grasp::new([foot(13.0), spring(-1.0), spring(1.0)]).unwrap();
    let mut path = grasp.follow(pull(0.0), &[planar::Leg::load_to(pull(10.0))]).unwrap();
    assert!(path.run().is_empty());
    let loss = snap(&path, LossKind::Corner);
    let snap = 912.0 / 109.0;
    assert_close!(loss.fraction, snap / 10.0);
    assert_eq!(numbers(&loss.contacts), [0]);
    let last = path.state().unwrap();
    assert_close!(last.contacts[0].normal_force(), 952.0 / 109.0);
    assert_close!(last.contacts[0].force_world[0], 1428.0 / 109.0);
    // The body moves against the direction u' of increasing load: (-30, 12).
    let [x, y] = loss.motion.as_ref().expect("a motion").object.translation();
    assert_close!(y / x, -0.4);
    assert!(x < 0.0);
    assert!(path.energies()[0].residual().abs() < 1e-13);
    // Enumeration finds three equilibria before τ*: sticking, sliding (both meet at τ*) and open. Beyond τ* only the open one exists.
    let all = |tau: f64| grasp.equilibria(pull(tau)).unwrap();
    assert_eq!((all(snap * 0.999).len(), all(snap * 1.001).len()), (3, 1));
    let open = all(snap * 1.001).remove(0);
    assert_close!(open.twist.translation()[1], snap * 1.001 * 12.0 / 26.0);
    // A softer foot with k = 3 and the same force at rest slides on and opens, because the determinant 26 + k(10 - 12μ) = 2 is positive. Sticking:
    // [24 12; 12 20]u = (-τ, 24), so N = 24 - 3u_y with u_y = 12(τ + 48)/336, and T = 14(20τ + 288)/336. Sliding: [10 16.5; 12 20]u = (36 - τ, 24)
    // with the determinant 2, so u_y = (240 - 12(36 - τ))/2 = 6τ - 96 and N = 24 - 18τ + 288.
    let soft = planar::Grasp::new([foot(3.0), spring(-1.0), spring(1.0)]).unwrap();
    let mut path = soft.follow(pull(0.0), &[planar::Leg::load_to(pull(40.0))]).unwrap();
    let events = path.run();
    assert!(completed(path.end()), "{:?}", path.end());
    // The foot slides where T = 3/2 N: (20τ + 288)/24 = 36 - 4.5(τ + 48)/28. It opens where N = 0.
    let slides = (36.0 - 4.5 * 48.0 / 28.0 - 12.0) / (20.0 / 24.0 + 4.5 / 28.0);
    let opens = 312.0 / 18.0;
    assert_story(&events, &[(0, slides / 40.0, vec![(0, "slides")]), (0, opens / 40.0, vec![(0, "opens")])]);
}

/// Two fingers squeeze an object with N = k a each, and one frictionless guide of stiffness kg also carries load. If both fingers stick, a weight w
/// lowers the object by y = w/(2kt + kg), and each finger carries T = kt y. If the squeeze a₁ comes first, this is the state under the load. If the
/// load comes at the smaller squeeze a₀, the object slides at kt y = μka₀; T keeps this value, and y = (w - 2μka₀)/kg. Squeezing afterwards adds
/// nothing to T. If the object is squeezed to a₁, loaded and released to a₀, it slides from N = T/μ on and ends in the second state. Squeezing again
/// does not undo this.
#[test]
fn the_order_of_loading_matters() {
    let (k, kt, kg, mu, w) = (40.0, 6.0, 8.0, 0.5, 1.2);
    let (loose, tight) = (0.01, 0.1);
    let finger = |x: f64| jaw::<2>(x, [k, kt], mu).command([loose, 0.0]);
    let guide =
        |x: f64| planar::Contact::new([x, 0.0], [0.0, 1.0]).series_stiffness(kg / 2.0, 1.0).kept_closed();
    let grasp = planar::Grasp::new([finger(1.0), finger(-1.0), guide(2.0), guide(-2.0)]).unwrap();
    let squeeze = |a: f64| planar::Leg::commands_to(vec![[a, 0.0], [a, 0.0], [0.0; 2], [0.0; 2]]);
    let load = || planar::Leg::load_to(planar::Wrench::force([0.0, -w]));
    let both = |what| vec![(0, what), (1, what)];
    let (stuck, slid) = (kt * w / (2.0 * kt + kg), mu * k * loose);
    let slides_at = slid * (2.0 * kt + kg) / (kt * w);
    let lets_go = (tight - stuck / (mu * k)) / (tight - loose);
    let orders = [
        (vec![squeeze(tight), load()], vec![], stuck),
        (vec![load(), squeeze(tight)], vec![(0, slides_at, both("slides")), (1, 0.0, both("sticks"))], slid),
        (
            vec![squeeze(tight), load(), squeeze(loose), squeeze(tight)],
            vec![(2, lets_go, both("slides")), (3, 0.0, both("sticks"))],
            slid,
        ),
    ];
    for (legs, expected, friction) in orders {
        let mut path = grasp.follow(planar::Wrench::ZERO, &legs).unwrap();
        assert_story(&path.run(), &expected);
        assert!(completed(path.end()));
        let end = path.state().unwrap();
        for finger in &end.contacts[..2] {
            assert_close!(finger.normal_force(), k * tight);
            assert_close!(finger.force_world[1], friction);
        }
        assert_close!(end.twist.translation()[1], -(w - 2.0 * friction) / kg);
    }
}

/// Without friction the state depends on the load alone. A plank lies on n supports of stiffness k and is loaded by w at the distance e from the
/// middle. With the supports i >= m closed, Σ F = w and Σ F x = w e give F_i = w/n' (1 + (x_i - mean)(e - mean)/variance), with mean and variance
/// over the n' closed supports. So F_m = 0 at e = mean + variance/(mean - x_m). Support m opens at this e when e grows, and closes there when e
/// decreases.
#[test]
fn frictionless_supports_open_one_by_one_and_close_again() {
    let (n, w, k) = (6_u32, 3.0, 50.0);
    let at = |i: u32| f64::from(i) - 2.5;
    let support = |i: u32| planar::Contact::new([at(i), 0.0], [0.0, 1.0]).series_stiffness(k, k);
    let guide = planar::Contact::new([0.0, 0.0], [1.0, 0.0]).series_stiffness(k, k).kept_closed();
    let plank = planar::Grasp::new((0..n).map(support).chain([guide])).unwrap();
    let load = |e: f64| planar::Wrench::force_at([0.0, -w], [e, 0.0]);
    let reach = 2.4;
    let mut path = plank
        .follow(load(0.0), &[planar::Leg::load_to(load(reach)), planar::Leg::load_to(load(0.0))])
        .unwrap();
    let events = path.run();
    assert!(completed(path.end()));
    let mut out = Vec::new();
    for m in 0..n - 1 {
        let left: Vec<f64> = (m..n).map(at).collect();
        let count = f64::from(n - m);
        let mean = left.iter().sum::<f64>() / count;
        let variance = left.iter().map(|x| (x - mean) * (x - mean)).sum::<f64>() / count;
        let e = mean + variance / (mean - at(m));
        if e < reach {
            out.push((m as usize, e / reach));
        }
    }
    assert_eq!(out.len(), 4);
    let mut expected: Vec<_> = out.iter().map(|&(m, f)| (0, f, vec![(m, "opens")])).collect();
    expected.extend(out.iter().rev().map(|&(m, f)| (1, 1.0 - f, vec![(m, "closes")])));
    assert_story(&events, &expected);
    assert!(path.energies().iter().all(|e| e.dissipated == 0.0));
    for support in &path.state().unwrap().contacts[..n as usize] {
        assert_close!(support.normal_force(), w / f64::from(n));
    }
}

/// Infinite friction. A foot (stiffnesses k and kt, pressed by a) acts next to bonded springs, of total stiffness kb in both directions. Under shear
/// the foot never slides. Under a lifting load it opens at y = a, under the load kb a. A shear P while the foot is open moves the object to x = P/kb.
/// When the load is lowered, the foot closes at y = a again, and sticks there with F_t = 0. After the shear is removed, the foot pulls back: x = P/kb
/// · kt/(kt + kb), F_t = kb x.
#[test]
fn infinite_friction_never_slides() {
    let (k, kt, kb, a, p) = (30.0, 20.0, 10.0, 0.1, 2.0);
    let foot = planar::Contact::new([0.0, 0.0], [0.0, 1.0])
        .series_stiffness(k, kt)
        .friction(f64::INFINITY)
        .command([a, 0.0]);
    let spring =
        |x: f64| planar::Contact::new([x, 0.0], [0.0, 1.0]).series_stiffness(kb / 2.0, kb / 2.0).bonded();
    let grasp = planar::Grasp::new([foot, spring(-1.0), spring(1.0)]).unwrap();
    let load = |x: f64, y: f64| planar::Leg::load_to(planar::Wrench::force([x, y]));
    let start = planar::Wrench::ZERO;
    // No shear force causes an event.
    let mut path = grasp.follow(start, &[load(1e6, 0.0), load(-1e6, 0.0), load(0.0, 0.0)]).unwrap();
    assert!(path.run().is_empty() && completed(path.end()));
    // Without shear the foot opens at y = a, under the load kb a. It closes there at another x, and sticks with F_t = 0.
    let lift = 2.0 * kb * a;
    let legs = [load(0.0, lift), load(p, lift), load(p, 0.0), load(0.0, 0.0)];
    let mut path = grasp.follow(start, &legs).unwrap();
    assert_story(&path.run(), &[(0, 0.5, vec![(0, "opens")]), (2, 0.5, vec![(0, "closes")])]);
    assert!(completed(path.end()));
    let closed = path.state_at(2, 1.0).unwrap();
    assert_close!(closed.contacts[0].force_world[0], 0.0);
    assert_close!(closed.twist.translation()[0], p / kb);
    // After the shear force is removed, the foot sticks at x = P/kb and pulls the body back: kt(P/kb - x) = kb x.
    let x = p / kb * kt / (kt + kb);
    assert_close!(path.state().unwrap().twist.translation()[0], x);
    assert_close!(path.state().unwrap().contacts[0].force_world[0], kb * x);
}

/// A foot with infinite friction would open while it carries a tangential force. It is on the springs S = [10 12; 12 17] of the test on snapping,
/// with a = 24/13. The load (40, 0) pulls, then (0, 80f) lifts. While the foot sticks, [24 12; 12 30]u = (40, 80f + 24). At f = 131/260, u_y = a and
/// F_t = -14u_x = -406/39. Without a normal force this tangential force would vanish at once. Then S u = (40, 80f) would give u_y = (800f - 480)/26 <
/// a, with the body inside the foot. No continuous motion exists from this state, so the path ends with a snap.
#[test]
fn infinite_friction_that_has_to_let_go_of_a_force_ends_the_path() {
    let a = 24.0 / 13.0;
    let foot = planar::Contact::new([0.0, 0.0], [0.0, 1.0])
        .series_stiffness(13.0, 14.0)
        .friction(f64::INFINITY)
        .command([a, 0.0]);
    let spring = |x: f64| planar::Contact::new([x, 0.0], [3.0, 4.0]).series_stiffness(13.0, 0.5).bonded();
    let grasp = planar::Grasp::new([foot, spring(-1.0), spring(1.0)]).unwrap();
    let load = |x: f64, y: f64| planar::Leg::load_to(planar::Wrench::force([x, y]));
    let mut path = grasp.follow(planar::Wrench::ZERO, &[load(40.0, 0.0), load(40.0, 80.0)]).unwrap();
    assert!(path.run().is_empty());
    // Without the force of the foot the body would sink onto the foot again.
    let loss = limit_load(&path);
    assert_eq!(loss.kind, LossKind::LetsGo);
    assert_eq!((loss.leg, &numbers(&loss.contacts)[..]), (1, &[0][..]));
    assert_close!(loss.fraction, 131.0 / 260.0);
    let last = path.state().unwrap();
    assert_close!(last.contacts[0].force[0], 0.0);
    assert_close!(last.contacts[0].force[1], -406.0 / 39.0);
    assert_close!(last.twist.translation()[1], a);
}
