//! Equilibria of simple scenes agree with closed forms. The comment above each test derives the numbers by hand.

use grasp_lcp::{Settings, grasp, planar, spatial};
use support::jaws::jaw;

const TIGHT: f64 = 1e-13;

fn close(a: f64, b: f64) -> bool {
    (a - b).abs() <= TIGHT * (1.0 + b.abs())
}

macro_rules! assert_close {
    ($a:expr, $b:expr) => {
        let (a, b) = ($a, $b);
        assert!(close(a, b), "{} = {a}, expected {b}", stringify!($a));
    };
}

fn hold<const C: usize>(
    grasp: &grasp_lcp::ask::Grasp<C>,
    load: grasp::Wrench<C>,
) -> grasp_lcp::equilibrium::Equilibrium<C> {
    let outcome = grasp.solve(load).expect("valid load");
    outcome.equilibrium().unwrap_or_else(|| panic!("no equilibrium: {outcome:?}")).clone()
}

/// Two fingers press along ±x with the command a, so each carries N = k a. A weight w hangs on both tangential springs: the object sinks by w / (2
/// k_t), each contact carries w / 2, and both slide together at w* = 2 μ k a. Beyond, friction is exhausted: the limit load is the load of first
/// slip.
#[test]
fn planar_pinch() {
    let (k, kt, mu, a) = (40.0, 7.0, 0.3, 0.02);
    let finger = |x: f64| jaw::<2>(x, [k, kt], mu).command([a, 0.0]);
    let grasp = planar::Grasp::new([finger(-1.0), finger(1.0)]).unwrap();
    let w = 0.1;
    let state = hold(&grasp, planar::Wrench::force([0.0, -w]));
    assert_close!(state.twist.translation()[1], -w / (2.0 * kt));
    for contact in &state.contacts {
        assert_eq!(contact.state, planar::ContactState::Sticking);
        assert_close!(contact.normal_force(), k * a);
        assert_close!(contact.force_world[1], w / 2.0);
        assert_close!(contact.margin, mu * k * a - w / 2.0);
    }
    let onset = grasp.onset(planar::Wrench::force([0.0, -1.0])).unwrap();
    let event = onset.event().expect("finite onset");
    assert_close!(event.factor, 2.0 * mu * k * a);
    assert_eq!(event.leaving.len(), 2);
    for leaving in &event.leaving {
        // The body sinks, so the finger slips upwards over it.
        let planar::Departure::Slides { direction } = leaving.how else { panic!("slides") };
        assert_close!(direction[1], 1.0);
    }
    // After the first slip no force resists more weight, because the normal forces are constant.
    let beyond = grasp.beyond(event).expect("its own event");
    assert!(matches!(beyond, planar::Beyond::LimitLoad), "{beyond:?}");
    let more = grasp.solve(planar::Wrench::force([0.0, -2.0 * mu * k * a * (1.0 + 1e-9)])).unwrap();
    assert!(matches!(more, planar::Outcome::NoEquilibrium(_)), "{more:?}");
}

/// A block on an incline of slope angle α rests on two feet (springs k, k_t each). With the feet at ±b along the incline
/// and the centre of mass at height h above it, weight w: N₁ + N₂ = w cos α, T = w sin α in all, N₁ - N₂ = w h sin α / b,
/// shared tangentially w sin α / 2 each as long as both stick (equal springs, rotation only changes normals). Its upper
/// foot slides first, when w sin α / 2 = μ (w cos α - w (h/b) sin α) / 2, that is tan α = μ / (1 + μ h / b),
/// whatever the weight. A spring along the incline (kept closed) then takes the rest.
#[test]
fn block_on_an_incline_held_by_a_spring() {
    let (k, kt, mu, b, h, w) = (500.0, 200.0, 0.4, 0.5, 0.3, 10.0);
    let foot = |x: f64| planar::Contact::new([x, -h], [0.0, 1.0]).series_stiffness(k, kt).friction(mu);
    let feet = planar::Grasp::new([foot(-b), foot(b)]).unwrap();
    let weight = |alpha: f64| planar::Wrench::force([-w * alpha.sin(), -w * alpha.cos()]);
    let critical = (mu / (1.0 + mu * h / b)).atan();
    for (alpha, sticks) in [(critical - 1e-6, true), (critical + 1e-6, false)] {
        let state = hold(&feet, weight(alpha));
        let sliding =
            state.contacts.iter().filter(|c| matches!(c.state, planar::ContactState::Sliding { .. })).count();
        assert_eq!(sliding == 0, sticks, "{:?}", state.contacts);
        // Downhill is -x, so the foot at -b carries more, and the foot at +b slides first.
        if !sticks {
            assert!(matches!(state.contacts[1].state, planar::ContactState::Sliding { .. }));
            assert!(matches!(state.contacts[0].state, planar::ContactState::Sticking));
        }
    }
    // Beyond tan α = μ the feet alone cannot hold the block; a spring uphill with stiffness ks does. Both feet slide:
    // the spring force is w sin α - μ w cos α, and the displacement is this force divided by ks.
    let (alpha, ks) = (0.9_f64, 50.0);
    assert!(alpha.tan() > mu);
    assert!(matches!(feet.solve(weight(alpha)).unwrap(), planar::Outcome::NoEquilibrium(_)));
    let spring = planar::Contact::new([0.0, 0.0], [1.0, 0.0]).series_stiffness(ks, 1.0);
    let held = planar::Grasp::new([foot(-b), foot(b), spring]).unwrap();
    let state = hold(&held, weight(alpha));
    let pull = w * alpha.sin() - mu * w * alpha.cos();
    assert_close!(state.contacts[2].normal_force(), pull);
    assert_close!(state.contacts[0].normal_force() + state.contacts[1].normal_force(), w * alpha.cos());
    // The displacement at the height of the spring (the origin) is along x.
    assert_close!(state.twist.translation()[0], -pull / ks);
    for foot in &state.contacts[..2] {
        assert!(matches!(foot.state, planar::ContactState::Sliding { .. }));
        assert_close!(foot.tangential_force().abs(), mu * foot.normal_force());
    }
}

/// Three fingers at 120° press radially with the command a, under an axial load w. By symmetry each carries F_n = k a and the axial force w / 3. An
/// added torque m about the axis gives a second tangential component m / (3 R) at right angles. On the round cone the factor τ of first slip of the
/// load τ (w, m) follows from τ² ((w/3)² + (m/3R)²) = (μ k a)²: a square root, not a linear equation.
#[test]
fn spatial_three_finger_pinch_has_a_quadratic_onset() {
    let (k, kt, mu, a, radius) = (300.0, 120.0, 0.5, 0.01, 0.8);
    let finger = |i: u8| {
        let (sin, cos) = (f64::from(i) * std::f64::consts::TAU / 3.0).sin_cos();
        spatial::Contact::new([radius * cos, radius * sin, 0.0], [-cos, -sin, 0.0])
            .series_stiffness(k, kt)
            .friction(mu)
            .command([a, 0.0, 0.0])
    };
    let grasp = spatial::Grasp::new((0..3).map(finger)).unwrap();
    let (w, m) = (0.7, 0.9);
    let direction = spatial::Wrench::new([0.0, 0.0, -w], [0.0, 0.0, m]);
    let onset = grasp.onset(direction).unwrap();
    let event = onset.event().expect("finite onset");
    let exact = mu * k * a / (w / 3.0).hypot(m / (3.0 * radius));
    assert_close!(event.factor, exact);
    assert_eq!(event.leaving.len(), 3);
    // Inscribed polygons come from below with an error of at most 1 - cos(π/m), circumscribed polygons from above.
    for facets in [4, 8, 16, 64] {
        let half = (std::f64::consts::PI / f64::from(facets)).cos();
        for (fit, low, high) in [
            (grasp_lcp::PolygonFit::Inscribed, half, 1.0),
            (grasp_lcp::PolygonFit::Circumscribed, 1.0, 1.0 / half),
        ] {
            let cone = grasp_lcp::PolygonCone::new(usize::try_from(facets).unwrap(), fit).unwrap();
            let ramp = spatial::Ramp::load(spatial::Wrench::ZERO, direction);
            let factor = grasp
                .with(&Settings::default().with_cone(cone).on_the_polygon())
                .onset(&ramp)
                .unwrap()
                .factor()
                .expect("a sticking base");
            assert!(factor >= exact * low * (1.0 - TIGHT) && factor <= exact * high * (1.0 + TIGHT));
        }
    }
}

/// From a base load inside the cone, the load factor τ of first slip is the larger root of |T₀ + τ T₁|² = (μN)². With T₀ along the axis and T₁ around
/// it, τ = √((μ k a)² - (w/3)²) · 3R / m.
#[test]
fn quadratic_onset_from_a_loaded_base() {
    let (k, kt, mu, a, radius, w, m) = (300.0, 120.0, 0.5, 0.01, 0.8, 1.3, 1.1);
    let finger = |i: u8| {
        let (sin, cos) = (f64::from(i) * std::f64::consts::TAU / 3.0).sin_cos();
        spatial::Contact::new([radius * cos, radius * sin, 0.0], [-cos, -sin, 0.0])
            .series_stiffness(k, kt)
            .friction(mu)
            .command([a, 0.0, 0.0])
    };
    let grasp = spatial::Grasp::new((0..3).map(finger)).unwrap();
    let base = spatial::Wrench::force([0.0, 0.0, -w]);
    let onset =
        grasp.onset(spatial::Ramp::load(base, spatial::Wrench::new([0.0; 3], [0.0, 0.0, m]))).unwrap();
    let limit = mu * k * a;
    let exact = (limit * limit - (w / 3.0) * (w / 3.0)).sqrt() * 3.0 * radius / m;
    assert_close!(onset.factor().expect("a sticking base"), exact);
}

/// Two point contacts on the x axis resist every motion except a rotation about the line through them.
#[test]
fn spatial_pinch_turns_freely_about_its_line() {
    let (k, kt, mu, a) = (100.0, 60.0, 0.6, 0.05);
    let finger = |x: f64| jaw::<3>(x, [k, kt], mu).command([a, 0.0, 0.0]);
    let grasp = spatial::Grasp::new([finger(-1.0), finger(1.0)]).unwrap();
    // A force through the line is carried, half by each contact, and the answer names the free rotation.
    let state = hold(&grasp, spatial::Wrench::force([0.0, 1.0, -2.0]));
    assert_eq!(state.free_motions.len(), 1);
    let turn = state.free_motions[0].object.rotation();
    assert!(turn[0].abs() > 0.5 && turn[1].abs() < TIGHT && turn[2].abs() < TIGHT);
    assert!(state.twist.rotation().iter().all(|r| r.abs() < TIGHT));
    assert_close!(state.contacts[0].force_world[1], -0.5);
    assert_close!(state.contacts[1].force_world[2], 1.0);
    // A moment about the line is not carried.
    let outcome = grasp.solve(spatial::Wrench::new([0.0; 3], [1e-6, 0.0, 0.0])).unwrap();
    let spatial::Outcome::NoEquilibrium(none) = outcome else { panic!("{outcome:?}") };
    let spatial::Proof::FreeMotion { motion, work } = none.proof else { panic!("{:?}", none.proof) };
    assert!(work > 0.0 && motion.object.rotation()[0] > 0.5);
    // A force that misses the line is not carried either.
    let beside = spatial::Wrench::force_at([0.0, 0.0, -1.0], [0.0, 1e-3, 0.0]);
    assert!(matches!(grasp.solve(beside).unwrap(), spatial::Outcome::NoEquilibrium(_)));
}

/// Six frictionless locators (3-2-1) are statically determinate: the forces follow from equilibrium alone, whatever the
/// stiffnesses, and the twist from each spring's own compression.
#[test]
fn six_frictionless_locators() {
    let stiffness = [1e2, 3e4, 5e3, 1e6, 2e2, 7e3];
    let places: [([f64; 3], [f64; 3]); 6] = [
        ([0.0, 0.0, 0.0], [0.0, 0.0, 1.0]),
        ([1.0, 0.0, 0.0], [0.0, 0.0, 1.0]),
        ([0.0, 1.0, 0.0], [0.0, 0.0, 1.0]),
        ([0.2, 0.0, 0.5], [0.0, 1.0, 0.0]),
        ([0.8, 0.0, 0.5], [0.0, 1.0, 0.0]),
        ([0.0, 0.5, 0.5], [1.0, 0.0, 0.0]),
    ];
    let grasp = spatial::Grasp::new(
        places.iter().zip(stiffness).map(|(&(p, n), k)| spatial::Contact::new(p, n).series_stiffness(k, k)),
    )
    .unwrap();
    // Push with (-2, -3, -4) through (0.4, 0.5, 0.5): x and y are balanced at the height of their locators.
    let state = hold(&grasp, spatial::Wrench::force_at([-2.0, -3.0, -4.0], [0.4, 0.5, 0.5]));
    // Moments about x and y at height 0.5 come only from the z forces: N₂ = 4·0.4, N₃ = 4·0.5, N₁ = the rest. Moments about z: N₆ at y = 0.5 balances
    // -2 in line; N₄·0.2 + N₅·0.8 = 3·0.4, N₄ + N₅ = 3.
    let expected = [0.4, 1.6, 2.0, 2.0, 1.0, 2.0];
    for (contact, (n, k)) in state.contacts.iter().zip(expected.iter().zip(stiffness)) {
        assert_eq!(contact.state, spatial::ContactState::Frictionless);
        assert_close!(contact.normal_force(), *n);
        assert!(close(contact.body_core.dot(&contact.force_world) / n, -n / k));
    }
    // An upward pull has no equilibrium; the upward motion is the proof.
    let up = grasp.solve(spatial::Wrench::force([0.0, 0.0, 1.0])).unwrap();
    let spatial::Outcome::NoEquilibrium(none) = up else { panic!("{up:?}") };
    assert!(
        matches!(none.proof, spatial::Proof::SeparatingMotion { work, .. } if work > 0.0),
        "{:?}",
        none.proof
    );
}

/// A bar has two locators at x = -1 and 1 and one locator at its end. The locators move by their commands without a load. All forces are zero, and
/// the bar follows with u_y = (a₁ + a₂)/2, θ = (a₂ - a₁)/2, u_x = a₃, for all stiffnesses and orientations.
#[test]
fn moved_locators_without_a_load_carry_nothing() {
    let a: [f64; 3] = [0.013, -0.007, 0.011];
    for step in 0..50 {
        let (sin, cos) = (0.1 * f64::from(step)).sin_cos();
        let turned = |[x, y]: [f64; 2]| [cos * x - sin * y, sin * x + cos * y];
        let places = [([-1.0, 0.0], [0.0, 1.0]), ([1.0, 0.0], [0.0, 1.0]), ([-1.0, 0.0], [1.0, 0.0])];
        let locators = places.iter().zip([1e2, 3e4, 7e3]).zip(a).map(|((&(p, n), k), a)| {
            let locator = planar::Contact::new(turned(p), turned(n)).series_stiffness(k, k).kept_closed();
            locator.command([a, 0.0])
        });
        let bar = planar::Grasp::new(locators).unwrap();
        let state = hold(&bar, planar::Wrench::ZERO);
        let [x, y] = turned([a[2], 0.5 * (a[0] + a[1])]);
        let twist = state.twist.to_vector();
        assert!((twist[0] - x).abs() < 1e-15 && (twist[1] - y).abs() < 1e-15);
        assert!((twist[2] - 0.5 * (a[1] - a[0])).abs() < 1e-15);
        assert!(state.contacts.iter().all(|c| c.force.norm() < 1e-30));
    }
}

/// A bar on three frictionless supports at x = -1, 0, 1 of equal stiffness, pressed down by w at x = e. Elastic: N = w/3
/// (1 + 3/2 e x). The left support lets go at e = 2/3; beyond it the other two carry w (1 - e) and w e, and the left
/// gap follows from their compressions.
#[test]
fn a_support_lets_go() {
    let (k, w) = (80.0, 6.0);
    let support = |x: f64| planar::Contact::new([x, 0.0], [0.0, 1.0]).series_stiffness(k, k);
    // A guide prevents a motion of the bar along its axis.
    let guide = planar::Contact::new([0.0, 0.0], [1.0, 0.0]).series_stiffness(k, k).kept_closed();
    let bar = planar::Grasp::new([support(-1.0), support(0.0), support(1.0), guide]).unwrap();
    let load = |e: f64| planar::Wrench::force_at([0.0, -w], [e, 0.0]);
    for e in [0.0, 0.3, 0.6] {
        let state = hold(&bar, load(e));
        for (contact, x) in state.contacts.iter().zip([-1.0, 0.0, 1.0]) {
            assert_close!(contact.normal_force(), w / 3.0 * (1.0 + 1.5 * e * x));
        }
    }
    let e = 0.9;
    let state = hold(&bar, load(e));
    assert_eq!(state.contacts[0].state, planar::ContactState::Separated);
    assert_close!(state.contacts[1].normal_force(), w * (1.0 - e));
    assert_close!(state.contacts[2].normal_force(), w * e);
    // The compressions w (1-e)/k at 0 and w e/k at 1 extrapolate to w (2-3e)/k at -1; a negative value is a gap.
    let expected = w * (2.0 * e - 1.0) / k - w * (1.0 - e) / k;
    assert_close!(state.contacts[0].gap, expected);
    assert!(expected > 0.0);
    let onset = bar.onset(planar::Ramp::load(load(0.0), load(1.0) - load(0.0))).unwrap();
    let event = onset.event().expect("finite onset");
    assert_close!(event.factor, 2.0 / 3.0);
    assert!(
        event.leaving.len() == 1
            && event.leaving[0].contact.index == 0
            && event.leaving[0].how == planar::Departure::Opens
    );
    assert!(matches!(bar.beyond(event), Some(planar::Beyond::Continues(_))));
}
