//! Load paths on the round cone with turning sliding directions agree with curves in closed form.

use std::f64::consts::FRAC_PI_2;

use grasp_lcp::Settings;
use grasp_lcp::spatial::{Change, Contact, Grasp, Leg, PathEnd, Wrench};
use nalgebra::{Vector2, Vector3};
use support::assert_close;
use support::programs::changes;

const K: f64 = 80.0;
const KT: f64 = 50.0;
const MU: f64 = 0.5;
const A: f64 = 0.1;
/// Stiffness of the elastic support along each axis, N/m.
const BASE: f64 = 400.0;

/// A finger on top of a body on four bonded springs around it, equally stiff along all axes. A push at its middle does not turn
/// the body.
fn dragged() -> Grasp {
    let finger = Contact::new([0.0; 3], [0.0, 0.0, 1.0])
        .tangent([1.0, 0.0, 0.0])
        .series_stiffness(K, KT)
        .friction(MU)
        .command([A, 0.0, 0.0]);
    let support = |x: f64, y: f64| {
        Contact::new([x, y, 0.0], [0.0, 0.0, 1.0])
            .series_stiffness(BASE / 4.0, BASE / 4.0)
            .friction(1.0)
            .bonded()
    };
    let around = [(1.0, 0.0), (-1.0, 0.0), (0.0, 1.0), (0.0, -1.0)];
    Grasp::new([finger].into_iter().chain(around.map(|(x, y)| support(x, y)))).unwrap()
}

/// Settings with the smallest step error, so that closed forms are met to rounding.
fn to_all_digits() -> Settings {
    Settings::default().with_step_error(1e-13)
}

/// The springs of finger and support in series.
fn in_series(k: f64) -> f64 {
    k * BASE / (k + BASE)
}

fn normal_force() -> f64 {
    in_series(K) * A
}

/// The length of the leash, an imaginary line from the finger to the contact point that it drags along. It is the deflection of the springs at which
/// the contact slides.
fn leash() -> f64 {
    MU * normal_force() / in_series(KT)
}

/// A leg that moves the finger by (x, y).
fn drag(x: f64, y: f64) -> Leg {
    let mut commands = vec![Vector3::zeros(); 5];
    commands[0] = Vector3::new(0.0, x, y);
    Leg::commands_by(commands)
}

/// The finger moves straight, starting perpendicular to its leash of length L (see [`leash`]). The dragged point follows a tractrix, and the friction
/// force points along the leash, at the angle θ to the path with
///
/// ```text
/// tan(θ/2) = tan(θ₀/2) exp(-x/L)
/// ```
///
/// The slip is the position of the dragged point. Paths are short, long, and a million leashes long.
#[test]
fn what_is_dragged_follows_a_tractrix() {
    let grasp = dragged();
    let l = leash();
    for way in [0.3, 10.0, 100.0, 1e6] {
        for ahead in [1.0, 1.3] {
            let legs = [drag(0.0, ahead * l), drag(way * l, 0.0)];
            let asked = grasp.with(&to_all_digits());
            let mut path = asked.follow(Wrench::ZERO, &legs).unwrap();
            let events = path.run();
            assert!(matches!(path.end(), Some(PathEnd::Completed)), "{:?}", path.end());
            // There is one event, when the leash is tight and the contact slides. If this is at the end of a leg, the event belongs to the beginning
            // of the next leg.
            let [event] = &events[..] else { panic!("{events:?}") };
            assert!(matches!(changes(event)[..], [(0, Change::Slides { .. })]));
            let at = event.leg as f64 + event.fraction;
            assert_close!(at, 1.0 / ahead);
            // The rounding error grows with the length of the path, measured in leash lengths.
            let most = 1e-11_f64.max(1e-15 * way);
            assert!(path.step_error() > 0.0 && path.step_error() < most, "{}", path.step_error());
            for f in [0.01, 0.2, 0.5, 0.77, 1.0] {
                let state = path.state_at(1, f).unwrap();
                let contact = &state.contacts[0];
                assert_close!(contact.normal_force(), normal_force());
                assert_close!(contact.friction_force(), MU * normal_force());
                let theta = 2.0 * (-f * way).exp().atan();
                assert_close!(contact.force[1], MU * normal_force() * theta.cos());
                assert_close!(contact.force[2], MU * normal_force() * theta.sin());
                assert_close!(contact.slip[1], l * (f * way - theta.cos()));
                assert_close!(contact.slip[2], l * (ahead - theta.sin()));
                assert!(state.residuals.worst() < 1e-14, "{:?}", state.residuals);
            }
            for energy in path.energies() {
                assert!(energy.residual().abs() < 1e-12, "{energy:?}");
                assert!(energy.dissipated >= 0.0);
            }
        }
    }
}

/// The heat of the tractrix is the integral of F_t·ds with ds = dx cos θ along the leash: μN L ln cosh(x/L) from a right angle.
#[test]
fn the_heat_of_a_tractrix() {
    let grasp = dragged();
    let l = leash();
    for way in [0.5, 4.0, 40.0_f64] {
        let asked = grasp.with(&to_all_digits());
        let mut path = asked.follow(Wrench::ZERO, &[drag(0.0, l), drag(way * l, 0.0)]).unwrap();
        path.run();
        // The logarithm of cosh(way), written so that it does not overflow.
        let heat = MU * normal_force() * l * (way + (0.5 * (1.0 + (-2.0 * way).exp())).ln());
        assert_close!(path.energies()[1].dissipated, heat);
    }
}

/// If the finger moves on a circle of radius R, the dragged point ends on a circle of radius ρ with ρ² + L² = R². The leash of length L is tangent to
/// this smaller circle.
#[test]
fn round_in_a_circle_what_is_dragged_keeps_to_a_smaller_one() {
    let grasp = dragged();
    let l = leash();
    let radius = 2.0 * l;
    // The circle is made of chords, one leg each, repeated until the initial state has no influence.
    let sides = 96_u32;
    let at = |i: u32| {
        let angle = std::f64::consts::TAU * f64::from(i) / f64::from(sides);
        (radius * angle.cos(), radius * angle.sin())
    };
    let chord = |i: u32| drag(at(i + 1).0 - at(i).0, at(i + 1).1 - at(i).1);
    let legs: Vec<_> = (0..4 * sides).map(chord).collect();
    let settings = Settings::default().with_step_error(1e-9);
    let asked = grasp.with(&settings);
    let mut path = asked.follow(Wrench::ZERO, &legs).unwrap();
    path.run();
    let ((last, _), end) = (path.place(), path.state().unwrap());
    assert_eq!(last + 1, legs.len());
    // The position of the dragged point, from the centre of the circle.
    let slip = &end.contacts[0].slip;
    let place = Vector2::new(slip[1] + radius, slip[2]);
    // A polygon of 96 sides is a circle up to (π/96)²/2 or so.
    let expected = (radius * radius - l * l).sqrt();
    assert!((place.norm() - expected).abs() < 2e-3 * l, "{} {expected}", place.norm());
    let force = Vector2::new(end.contacts[0].force[1], end.contacts[0].force[2]);
    assert!(force.normalize().dot(&place.normalize()).abs() < 2e-3 + 1.0 / f64::from(sides));
}

/// Coarser steps have larger errors, which stay below the estimate of the path.
#[test]
fn the_error_of_the_steps_is_what_was_asked_for() {
    let grasp = dragged();
    let l = leash();
    let legs = [drag(0.0, l), drag(6.0 * l, 0.0)];
    for tolerance in [1e-4, 1e-6, 1e-8, 1e-10, 1e-12] {
        let settings = Settings::default().with_step_error(tolerance);
        let asked = grasp.with(&settings);
        let mut path = asked.follow(Wrench::ZERO, &legs).unwrap();
        path.run();
        let mut worst = 0.0_f64;
        for part in 1..=20 {
            let f = f64::from(part) / 20.0;
            let state = path.state_at(1, f).unwrap();
            let theta = 2.0 * (-6.0 * f).exp().atan();
            let exact = Vector2::new(theta.cos(), theta.sin()) * (MU * normal_force());
            let force = &state.contacts[0].force;
            worst = worst.max((Vector2::new(force[1], force[2]) - exact).norm() / normal_force());
        }
        assert!(worst <= path.step_error().max(1e-14), "{tolerance:e}: {worst:e} {:e}", path.step_error());
        assert!(path.step_error() <= 100.0 * tolerance);
    }
}

/// With two different tangential stiffnesses the leash is an ellipse. The finger moves parallel to one axis of the ellipse, at a distance from it.
/// The reference is a closest-point return with much finer steps and extrapolation, computed in this test.
#[test]
fn springs_that_differ_along_the_tangents() {
    let (k1, k2) = (70.0, 20.0);
    let finger = Contact::new([0.0; 3], [0.0, 0.0, 1.0])
        .tangent([1.0, 0.0, 0.0])
        .series_stiffness_axes([K, k1, k2])
        .friction(MU)
        .command([A, 0.0, 0.0]);
    // A very stiff bonded contact keeps the body in place.
    let held = |x: f64, y: f64| {
        Contact::new([x, y, 0.0], [0.0, 0.0, 1.0]).series_stiffness(1e12, 1e12).friction(1.0).bonded()
    };
    let grasp =
        Grasp::new([finger, held(1.0, 0.0), held(-1.0, 0.0), held(0.0, 1.0), held(0.0, -1.0)]).unwrap();
    let r = MU * K * A;
    let (x, y) = (0.4, 1.1 * r / k2);
    let asked = grasp.with(&to_all_digits());
    let mut path = asked.follow(Wrench::ZERO, &[drag(0.0, y), drag(x, 0.0)]).unwrap();
    path.run();
    let end = path.state().unwrap();
    let reference = extrapolated(|n| returned(k1, k2, r, [0.0, y], [x, 0.0], n));
    assert!(
        (end.contacts[0].force[1] - reference[0]).abs() < 1e-9 * r,
        "{:?} {reference:?}",
        end.contacts[0].force
    );
    assert!((end.contacts[0].force[2] - reference[1]).abs() < 1e-9 * r);
    assert!(reference[0] > 0.5 * r && reference[1] > 0.01 * r);
}

/// The force after n steps along two legs. In each step F = S (a - s) with S = (K⁻¹ + λ)⁻¹, the command a and the slip s. λ is found by bisection so
/// that F is on the cone, and then s grows by λF.
fn returned(k1: f64, k2: f64, r: f64, first: [f64; 2], second: [f64; 2], n: u32) -> [f64; 2] {
    let (mut a, mut s, mut f) = ([0.0; 2], [0.0; 2], [0.0; 2]);
    for leg in [first, second] {
        for _ in 0..n {
            for axis in 0..2 {
                a[axis] += leg[axis] / f64::from(n);
            }
            let force = |lambda: f64| {
                [k1 * (a[0] - s[0]) / (1.0 + lambda * k1), k2 * (a[1] - s[1]) / (1.0 + lambda * k2)]
            };
            let (mut low, mut high) = (0.0, 1.0);
            if force(low)[0].hypot(force(low)[1]) > r {
                for _ in 0..60 {
                    let middle = 0.5 * (low + high);
                    let outside = force(middle)[0].hypot(force(middle)[1]) > r;
                    *(if outside { &mut low } else { &mut high }) = middle;
                }
            }
            f = force(low);
            for axis in 0..2 {
                s[axis] += low * f[axis];
            }
        }
    }
    f
}

/// Richardson extrapolation of a quantity whose error is a power series in 1/n.
fn extrapolated(of: impl Fn(u32) -> [f64; 2]) -> [f64; 2] {
    let table: Vec<_> = [1000, 2000, 4000, 8000].map(of).to_vec();
    let mut row = table;
    for k in 1..4 {
        let ratio = f64::from((1 << k) - 1);
        row = row.windows(2).map(|w| [0, 1].map(|a| w[1][a] + (w[1][a] - w[0][a]) / ratio)).collect();
    }
    row[0]
}

/// If the finger moves perpendicular to the leash, the force starts tangentially to the edge of its cone, and the contact slides at once.
#[test]
fn a_leash_at_right_angles_gives_way_at_once() {
    let grasp = dragged();
    let l = leash();
    let asked = grasp.with(&to_all_digits());
    let mut path = asked.follow(Wrench::ZERO, &[drag(0.0, l), drag(1e-3 * l, 0.0)]).unwrap();
    let events = path.run();
    assert_eq!((events[0].leg, events[0].fraction), (1, 0.0));
    let turned = FRAC_PI_2 - 2.0 * (-1e-3_f64).exp().atan();
    let force = &path.state().unwrap().contacts[0].force;
    assert_close!(force[1], MU * normal_force() * turned.sin());
}
