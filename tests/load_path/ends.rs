//! Paths in space end at their exact load: at a fold, where the load has a maximum, or along an asymptote, which is never reached.
//!
//! A body slides on frictionless guides under one finger. Along x it moves freely; across x, a spring K_y holds it. The finger presses with N and was
//! moved across by b. So the friction force first points across, and turns towards x as the body slides. With F_t = μN(-cos θ, sin θ) and the
//! stiffness k of the springs across in series,
//!
//! ```text
//! d(μN sin θ) = -k sin θ dσ            σ the slip
//! ```

use grasp_lcp::load_path::{Loss, LossKind, PathEnd};
use grasp_lcp::spatial::{Contact, Grasp, Leg, LoadPath, Wrench};
use support::assert_close;
use support::programs::numbers;

const KN: f64 = 30.0;
const KT: f64 = 20.0;
const MU: f64 = 0.5;
const GUIDE: f64 = 40.0;
const PRESS: f64 = 0.1;

fn in_series(a: f64, b: f64) -> f64 {
    a * b / (a + b)
}

/// A body under a finger that presses downwards at the origin. Guides let the body move along a line that slopes down by the angle α, and prevent
/// rotation.
fn grasp(alpha: f64) -> Grasp {
    let (sin, cos) = alpha.sin_cos();
    let guide = |point: [f64; 3], normal: [f64; 3]| {
        Contact::new(point, normal).series_stiffness(GUIDE, 1.0).friction(0.0).kept_closed()
    };
    let below = |x: f64, y: f64| guide([x * cos, y, x * sin], [-sin, 0.0, cos]);
    let beside = |x: f64| guide([x * cos, 0.0, x * sin], [0.0, 1.0, 0.0]);
    let finger = Contact::new([0.0; 3], [0.0, 0.0, -1.0])
        .tangent([1.0, 0.0, 0.0])
        .series_stiffness(KN, KT)
        .friction(MU)
        .command([PRESS, 0.0, 0.0]);
    let root = 0.75_f64.sqrt();
    Grasp::new([finger, below(1.0, 0.0), below(-0.5, root), below(-0.5, -root), beside(1.0), beside(-1.0)])
        .unwrap()
}

/// The finger moves sideways by b, then the load grows along x up to `most`.
fn pulled(grasp: &Grasp, b: f64, most: f64) -> LoadPath<'_> {
    let mut commands = [[0.0; 3]; 6];
    commands[0] = [PRESS, 0.0, b];
    let legs = [Leg::commands_to(commands), Leg::load_to(Wrench::force([most, 0.0, 0.0]))];
    let mut path = grasp.follow(Wrench::ZERO, &legs).unwrap();
    path.run();
    path
}

fn lost<'p>(path: &'p LoadPath<'_>, kind: LossKind) -> &'p Loss<3> {
    match path.end() {
        Some(PathEnd::Lost(loss)) if loss.kind == kind => loss,
        end => panic!("{end:?}"),
    }
}

/// If the body moves along a horizontal line, N is constant, and the load μN cos θ approaches μN without reaching it. At the angle θ of the friction
/// force the slip along x is `(μN/k) (cos θ₀ - cos θ + ln(tan(θ₀/2) / tan(θ/2)))`.
#[test]
fn a_friction_force_that_turns_into_the_way_comes_close_to_a_limit() {
    let grasp = grasp(0.0);
    let limit = MU * PRESS * in_series(KN, 3.0 * GUIDE);
    let k = in_series(KT, 2.0 * GUIDE);
    for across in [0.9, 0.5, 0.1, 1e-3] {
        let path = pulled(&grasp, across * limit / k, 2.0 * limit);
        let loss = lost(&path, LossKind::Asymptote);
        assert!((loss.load.resultant()[0] / limit - 1.0).abs() < 1e-9, "{across}: {loss:?}");
        assert_eq!((loss.leg, &numbers(&loss.contacts)[..]), (1, &[0][..]));
        let [x, y, z] = loss.motion.as_ref().expect("a motion").object.translation();
        assert!(x > 0.99 && y.abs() + z.abs() < 1e-9, "{x} {y} {z}");

        // A state on the path at the angle θ of the friction force, before the end.
        let first = f64::asin(across);
        let theta = 0.4 * first;
        let state = path.state_at(1, 0.5 * theta.cos()).unwrap();
        assert_close!(state.contacts[0].force_world[1].abs(), limit * theta.sin());
        let slip = first.cos() - theta.cos() + ((0.5 * first).tan() / (0.5 * theta).tan()).ln();
        assert!(
            (state.contacts[0].slip[1].abs() - slip * limit / k).abs() < 1e-9,
            "{across}: {:?}",
            state.contacts[0]
        );
    }
}

/// Without a sideways force the friction does not turn, so the limit load is reached when the finger begins to slide.
#[test]
fn a_friction_force_along_the_way_holds_no_more_at_once() {
    let grasp = grasp(0.0);
    let limit = MU * PRESS * in_series(KN, 3.0 * GUIDE);
    let path = pulled(&grasp, 0.0, 2.0 * limit);
    assert_close!(lost(&path, LossKind::Corner).load.resultant()[0], limit);
}

/// Rates of (N, F_x, F_y, λ) for one unit of slip if the body moves along a line with the slope α, by hand. Along this line `λ + F_x = N tan α`, and
/// N changes with the displacement t by `k̄ sin α t'`, where k̄ is the stiffness of the normal springs in series.
fn rates(alpha: f64, [_, fx, fy, _]: [f64; 4]) -> [f64; 4] {
    let (sin, cos) = alpha.sin_cos();
    let (normal, guides, across) = (in_series(KN, 3.0 * GUIDE), 3.0 * GUIDE, in_series(KT, 2.0 * GUIDE));
    let (px, py) = (fx / fx.hypot(fy), fy / fx.hypot(fy));
    let along = cos + normal * sin * sin / cos / guides;
    let way = -(KT * px * px + across * py * py) / (KT * px * along + MU * normal * sin);
    let n = normal * sin * way;
    let x = -KT * (along * way + px);
    [n, x, -across * py, n * sin / cos - x]
}

/// The maximum of the load λ, integrated by the classical Runge–Kutta method.
fn maximum(alpha: f64, start: [f64; 4]) -> f64 {
    const STEP: f64 = 1e-4;
    let add = |y: [f64; 4], h: f64, k: [f64; 4]| std::array::from_fn(|i| y[i] + h * k[i]);
    let step = |y: [f64; 4], h: f64| {
        let a = rates(alpha, y);
        let b = rates(alpha, add(y, 0.5 * h, a));
        let c = rates(alpha, add(y, 0.5 * h, b));
        let d = rates(alpha, add(y, h, c));
        std::array::from_fn(|i| y[i] + h / 6.0 * (a[i] + 2.0 * b[i] + 2.0 * c[i] + d[i]))
    };
    let mut y = start;
    while rates(alpha, step(y, STEP))[3] > 0.0 {
        y = step(y, STEP);
    }
    let (mut low, mut high) = (0.0, STEP);
    for _ in 0..50 {
        let middle = 0.5 * (low + high);
        if rates(alpha, step(y, middle))[3] > 0.0 { low = middle } else { high = middle }
    }
    step(y, low)[3]
}

/// If the line of motion slopes away from the finger, N decreases while the friction force turns towards the line, so the load has a maximum.
#[test]
fn a_body_that_slides_away_from_the_finger_folds() {
    for (alpha, across) in [(-0.1, 0.8), (-0.02, 0.8), (-0.1, 0.95)] {
        let grasp = grasp(alpha);
        let normal = PRESS * in_series(KN, 3.0 * GUIDE);
        let k = in_series(KT, 2.0 * GUIDE);
        let path = pulled(&grasp, across * MU * normal / k, 2.0 * MU * normal);
        let loss = lost(&path, LossKind::Fold);

        // Sliding begins where the forces, which grow linearly with the load, reach the cone.
        let onset = path.state_at(1, 0.0).unwrap();
        assert_close!(onset.contacts[0].force_world[1].abs(), across * MU * normal);
        let slides = forces_at_onset(&path);
        let exact = maximum(alpha, slides);
        assert!((loss.load.resultant()[0] / exact - 1.0).abs() < 1e-9, "{alpha} {loss:?} {exact}");
    }
}

/// (N, F_x, F_y, λ) at the first slip, extrapolated from two states before it.
fn forces_at_onset(path: &LoadPath<'_>) -> [f64; 4] {
    let at = |fraction: f64| {
        let state = path.state_at(1, fraction).unwrap();
        let [x, y, z] = state.contacts[0].force_world.into();
        [-z, x, y, state.load.resultant()[0]]
    };
    let (from, to) = (at(0.0), at(1e-3));
    let line = |s: f64| -> [f64; 4] { std::array::from_fn(|i| from[i] + s * (to[i] - from[i])) };
    let margin = |s: f64| {
        let [n, x, y, _] = line(s);
        MU * n - x.hypot(y)
    };
    let (mut low, mut high) = (0.0, 1000.0);
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        if margin(middle) > 0.0 { low = middle } else { high = middle }
    }
    line(low)
}
