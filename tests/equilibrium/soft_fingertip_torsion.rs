//! A pinch with soft fingertips under torsion agrees with closed forms: its rotation, the first slip of points, the spread of slip, and the limit.

use std::f64::consts::{FRAC_PI_6, PI};

use crate::pinch::{KN, KT, MU, N, R, finger, pinch, spin, tips};
use grasp_lcp::spatial::{
    Beyond, Change, ContactState, Departure, Grasp, Leg, Outcome, PathEnd, Pressure, SoftFingertip, Wrench,
};
use grasp_lcp::{PolygonCone, PolygonFit, Settings};
use support::programs::changes;
use support::{assert_relatively_close, relatively_close};

/// Pressure profiles of a disc, each with the mean radius ⟨r⟩, weighted by the pressure, over the radius R.
const PROFILES: [(Pressure, f64); 3] =
    [(Pressure::Uniform, 2.0 / 3.0), (Pressure::Parabolic, 8.0 / 15.0), (Pressure::Hertz, 3.0 * PI / 16.0)];

/// A pinch by two points turns freely. A pinch by two soft tips turns by M/2k_θ. Under forces through its line it is as stiff as a pinch by
/// points. The first points of a tip slide at the moment of a closed form: all points of a ring, or the rim of a disc.
#[test]
fn a_pinch_no_longer_turns_freely() {
    let points = Grasp::new([finger(-1.0), finger(1.0)]).unwrap();
    assert!(matches!(points.solve(spin(1e-6)).unwrap(), Outcome::NoEquilibrium(_)));
    let push = Wrench::force([0.3, -0.7, 0.5]);
    let by_points = points.solve(push).unwrap();
    let by_points = by_points.equilibrium().expect("within friction");
    assert_eq!(by_points.free_motions.len(), 1);
    for (tip, mean, square) in tips() {
        let grasp = pinch(&tip, finger);
        let moment = 0.9 * 2.0 * MU * N * square * R;
        let turned = grasp.solve(spin(moment)).unwrap();
        let turned = turned.equilibrium().expect("within friction");
        assert!(turned.free_motions.is_empty());
        assert_relatively_close!(turned.twist.rotation()[0], moment / (2.0 * KT * square * R * R));
        let pushed = grasp.solve(push).unwrap();
        let pushed = pushed.equilibrium().expect("within friction");
        assert!(pushed.free_motions.is_empty());
        let (a, b) = (pushed.twist.to_vector(), by_points.twist.to_vector());
        assert!((a - b).rows(0, 3).norm() < 1e-13 * b.rows(0, 3).norm(), "{a} {b}");
        let onset = grasp.onset(spin(1.0)).unwrap();
        let event = onset.event().expect("friction is finite");
        assert_relatively_close!(event.factor, 2.0 * MU * N * square * R);
        let rim: Vec<_> = [tip.points(), tip.points()]
            .into_iter()
            .flatten()
            .enumerate()
            .filter(|(_, (at, _))| at.norm() > R * (1.0 - 1e-9))
            .map(|(i, _)| i)
            .collect();
        assert_eq!(event.leaving.iter().map(|l| l.contact.index).collect::<Vec<_>>(), rim);
        assert!(event.leaving.iter().all(|l| matches!(l.how, Departure::Slides { .. })));
        if mean == 1.0 {
            assert_eq!(rim.len(), grasp.len());
            let beyond = grasp.beyond(event).expect("its own event");
            assert!(!matches!(beyond, Beyond::Continues(_)), "{beyond:?}");
        }
    }
}

/// Tangents of stiffness k_1 and k_2. At the angle α from the first tangent a point of a ring carries (-k_1 sin α, k_2 cos α) R θ times its share and
/// slides at `R θ √((k_1 sin α)² + (k_2 cos α)²) = μ N`: points whose motion is along the stiffer tangent slide first.
#[test]
fn uneven_tangential_stiffness() {
    for (k1, k2, first, turned) in
        [(300.0, 900.0, 0, 0.0), (900.0, 300.0, 2, 0.0), (300.0, 900.0, 1, FRAC_PI_6)]
    {
        let finger = |side: f64| {
            finger(side).series_stiffness_axes([KN, k1, k2]).tangent([0.0, turned.cos(), turned.sin()])
        };
        let points = if first == 1 { 12 } else { 8 };
        let tip = SoftFingertip::ring(R, points).unwrap();
        let grasp = pinch(&tip, finger);
        let onset = grasp.onset(spin(1.0)).unwrap();
        let event = onset.event().expect("friction is finite");
        let exact = 2.0 * MU * N * R * 0.5 * (k1 + k2) / k1.max(k2);
        assert_relatively_close!(event.factor, exact);
        assert_relatively_close!(2.0 * tip.first_sliding(&finger(1.0), N), exact);
        let contacts: Vec<_> = event.leaving.iter().map(|l| l.contact.index).collect();
        let start = if first == 2 { points / 4 } else { 0 };
        assert_eq!(contacts, [0, points / 2, points, 3 * points / 2].map(|i| i + start));
        let state = grasp.state_at_onset(event).expect("its own event");
        assert_relatively_close!(state.twist.rotation()[0], exact / ((k1 + k2) * R * R));
    }
}

/// After the first slip the points of the rim slide, each with the friction μ N w_i, and the points inside still stick: `M/2 = Σ w_i r_i min(k_t r_i
/// θ, μ N)`. All points slide at the limit moment 2 μ N ⟨r⟩. This holds for any number of points on a ring.
#[test]
fn slip_spreads_from_the_rim_up_to_the_limit() {
    for (pressure, mean) in PROFILES {
        for (annuli, points) in [(2, 4), (1, 5), (1, 6), (1, 8)] {
            let tip = SoftFingertip::disc(R, annuli, points, pressure).unwrap();
            let grasp = pinch(&tip, finger);
            let innermost = tip.points().map(|(at, _)| at.norm()).fold(R, f64::min);
            for sticking in [0.95, 0.7, 0.4, 0.3].into_iter().filter(|part| part * R > innermost) {
                let turn = MU * N / (KT * sticking * R);
                let moment: f64 = 2.0
                    * tip
                        .points()
                        .map(|(at, w)| w * at.norm() * (KT * at.norm() * turn).min(MU * N))
                        .sum::<f64>();
                let state = grasp.solve(spin(moment)).unwrap();
                let state = state.equilibrium().expect("below the limit");
                assert!((state.twist.rotation()[0] / turn - 1.0).abs() < 1e-11);
                for (contact, (at, _)) in
                    state.contacts.iter().zip([tip.points(), tip.points()].into_iter().flatten())
                {
                    let slides = matches!(contact.state, ContactState::Sliding { .. });
                    assert_eq!(slides, at.norm() > sticking * R, "{contact:?}");
                }
            }
            let limit = 2.0 * MU * N * mean * R;
            assert_relatively_close!(2.0 * tip.torsional_limit(&finger(1.0), N), limit);
            assert!(grasp.solve(spin(limit * (1.0 - 1e-9))).unwrap().equilibrium().is_some());
            // The proof beyond the limit is fast only for few contacts.
            if annuli == 1 {
                assert!(grasp.solve(spin(limit * (1.0 + 1e-9))).unwrap().equilibrium().is_none());
            }
        }
    }
}

/// The path stops when the innermost ring slides, after an event for each of the others, from the rim inwards.
///
/// Four points on a ring, with every other ring rotated by 45°, slide along multiples of 45° of the tangents. There the
/// default polygon has corners, which are on the round cone.
#[test]
fn a_path_of_torsion() {
    for (pressure, mean) in PROFILES {
        let tip = SoftFingertip::disc(R, 2, 4, pressure).unwrap();
        let grasp = pinch(&tip, finger);
        let limit = 2.0 * MU * N * mean * R;
        let mut path = grasp.follow(Wrench::ZERO, &[Leg::load_to(spin(2.0 * limit))]).unwrap();
        let events = path.run();
        let radii: Vec<_> = tip.points().step_by(4).map(|(at, _)| at.norm()).collect();
        assert_eq!(radii.len(), 4);
        for (event, radius) in events.iter().zip(radii[1..].iter().rev()) {
            let sticks_inside = |r: f64| (r / radius).min(1.0);
            let moment: f64 =
                tip.points().map(|(at, w)| 2.0 * MU * N * w * at.norm() * sticks_inside(at.norm())).sum();
            assert_relatively_close!(event.fraction * 2.0 * limit, moment);
            assert_eq!(event.changes.len(), 8);
            assert!(changes(event).iter().all(|(i, change)| {
                matches!(change, Change::Slides { .. })
                    && relatively_close(tip.points().nth(i % 16).unwrap().0.norm(), *radius)
            }));
        }
        assert!(events.len() >= 3 && !matches!(path.end(), Some(PathEnd::Completed) | None));
        let ((_, fraction), state) = (path.place(), path.state().expect("where it stopped"));
        assert_relatively_close!(fraction, 0.5);
        assert!(state.contacts.iter().all(|c| (c.friction_used() / MU - 1.0).abs() < 1e-11));
    }
}

/// On a polygon with points at any angle the limit is between the closed form for friction μ cos(π/m) and for μ / cos(π/m).
#[test]
fn limit_between_polygons() {
    let tip = SoftFingertip::disc(R, 1, 5, Pressure::Hertz).unwrap();
    let grasp = pinch(&tip, finger);
    let limit = 2.0 * tip.torsional_limit(&finger(1.0), N);
    let inside = (PI / 8.0).cos();
    let holds = |moment: f64, fit: PolygonFit| {
        let settings = Settings::default().on_the_polygon().with_cone(PolygonCone::new(8, fit).unwrap());
        grasp.with(&settings).solve(spin(moment)).unwrap().equilibrium().is_some()
    };
    assert!(holds(limit * inside * (1.0 - 1e-9), PolygonFit::Inscribed));
    assert!(!holds(limit * (1.0 + 1e-9), PolygonFit::Inscribed));
    assert!(holds(limit * (1.0 - 1e-9), PolygonFit::Circumscribed));
    assert!(!holds(limit / inside * (1.0 + 1e-9), PolygonFit::Circumscribed));
}

/// Turned by θ, a uniform disc slides beyond `r_s = μ N / (k_t θ)`. With x = r_s/R,
/// `M/(μ N R) = ∫_0^x 2ρ · ρ²/x dρ + ∫_x^1 2ρ · ρ dρ = 2/3 - x³/6`. The worst difference falls like 1/bands².
#[test]
fn the_moment_between_onset_and_limit_converges() {
    let worst = [1, 2, 4, 8, 16].map(|annuli| {
        let tip = SoftFingertip::disc(1.0, annuli, 3, Pressure::Uniform).unwrap();
        let points: Vec<_> = tip.points().map(|(at, w)| (at.norm(), w)).collect();
        let difference = |x: f64| {
            let moment: f64 = points.iter().map(|(r, w)| w * r * (r / x).min(1.0)).sum();
            (moment - (2.0 / 3.0 - x.powi(3) / 6.0)).abs()
        };
        (1..=4000).map(|i| difference(f64::from(i) / 4000.0)).fold(0.0, f64::max)
    });
    for (found, said) in worst.into_iter().zip([0.041, 0.0163, 0.0056]) {
        assert!(found < said && found > 0.97 * said, "{said} {found}");
    }
    assert!(worst.windows(2).skip(2).all(|w| w[0] / w[1] > 3.5 && w[0] / w[1] < 4.1), "{worst:?}");
}
