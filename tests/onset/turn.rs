//! While a load turns, the answer reports contacts that reach their friction limit without sliding, gaps that close, and turns that end early.
//! Invalid turns are refused.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use grasp_lcp::load_path::{EdgeOf, Parameter, PathEnd};
use grasp_lcp::planar::{self, Turn, Wrench};
use grasp_lcp::{Error, PolygonCone, Settings, spatial};
use support::jaws::jaw;
use support::programs::changes;

fn palm(x: f64) -> planar::Contact {
    jaw::<2>(x, [1000.0, 800.0], 0.5).pressed_with(10.0)
}

/// A box between two palms whose weight starts horizontal: each palm carries F_n = 10 ∓ w/2 cos θ and F_t = w/2 sin θ.
fn box_on_its_side(weight: f64) -> (planar::Grasp, Turn) {
    let grasp = planar::Grasp::new([palm(-1.0), palm(1.0)]).expect("two palms");
    (grasp, Turn::force_at([weight, 0.0], [0.0, 0.0]))
}

#[test]
fn an_edge_that_is_touched_is_told() {
    // The first palm reaches μ F_n = F_t where w/2 sin θ + w/4 cos θ = 5. The left side is at most w √5 / 4.
    let least = 20.0 / 5_f64.sqrt();
    let angle = 2_f64.atan();
    for (part, touches, slides) in [
        (1.0 - 1e-9, false, false),
        (1.0 - 1e-15, true, false),
        (1.0, true, false),
        (1.0 + 1e-11, false, true),
        (1.0 + 1e-3, false, true),
    ] {
        let (grasp, turn) = box_on_its_side(least * part);
        let answer = grasp.onset_of_turn(turn).unwrap();
        assert_eq!(answer.onset.event().is_some(), slides, "{part}: {answer:?}");
        assert_eq!(!answer.touches.is_empty(), touches, "{part}: {answer:?}");
        if let Some(touch) = answer.touches.first() {
            assert!(
                matches!(&touch.of, EdgeOf::Contact(contact) if contact.index == 0)
                    && (touch.angle - angle).abs() < 1e-6,
                "{answer:?}"
            );
        }
        if let Some(event) = answer.onset.event() {
            // For a load slightly above the least one, the palm slides before the angle of the least load, by about √(2 · relative excess of the
            // load).
            let before = angle - event.factor - (1.0 / part).acos();
            assert!(before.abs() < 1e-15 / (1.0 / part).acos().max(1e-7), "{part}: {before:e}");
        }
    }
}

#[test]
fn a_turn_ends_where_it_is_told_to() {
    let (grasp, turn) = box_on_its_side(12.0);
    let onset = |turn: Turn| grasp.onset_of_turn(turn).unwrap().onset.factor().unwrap();
    let whole = onset(turn);
    for angle in [7.0 * TAU, whole * (1.0 + 1e-9)] {
        assert!((onset(turn.up_to(angle)) - whole).abs() < 1e-15);
    }
    assert!(onset(turn.up_to(whole * (1.0 - 1e-9))).is_infinite());
    // The reversed turn has the same angle.
    assert!((onset(turn.reversed()) - whole).abs() < 1e-15);
}

#[test]
fn a_gap_that_closes_on_the_way_carries_until_it_opens_again() {
    // A third, frictionless palm is 2 mm below. The box reaches it when each of the others carries 800 N/m · 2 mm = 1.6 N.
    let below = planar::Contact::new([0.0, -1.0], [0.0, 1.0])
        .series_stiffness(500.0, 400.0)
        .friction(0.0)
        .clearance(2e-3);
    let grasp = planar::Grasp::new([palm(-1.0), palm(1.0), below]).unwrap();
    let turn = Turn::force_at([9.5, 0.0], [0.0, 0.0]).reversed();
    let alone = planar::Grasp::new([palm(-1.0), palm(1.0)]).unwrap().onset_of_turn(turn).unwrap();
    assert!(alone.onset.factor().unwrap() < 1.0);
    let onset = grasp.onset_of_turn(turn).unwrap().onset;
    let event = onset.event().expect("opens");
    assert!((event.factor - (PI - (3.2_f64 / 9.5).asin())).abs() < 1e-15, "{}", event.factor);
    let leaving: Vec<_> = event.leaving.iter().map(|leaving| (leaving.contact.index, leaving.how)).collect();
    assert_eq!(leaving, [(2, planar::Departure::Opens)]);
    let angle = event.factor;
    // A path of straight legs between loads on the arc approximates the turn. The error of its first slip falls with the square of the number of
    // legs.
    let error = |chords: usize| {
        let at = |k: usize| turn.load_at(3.0 * k as f64 / chords as f64);
        let legs: Vec<_> = (1..=chords).map(|k| planar::Leg::load_to(at(k))).collect();
        let mut path = grasp.follow(at(0), &legs).unwrap();
        let event = path.find(|event| changes(event).contains(&(2, planar::Change::Opens))).expect("opens");
        (3.0 * (event.leg as f64 + event.fraction) / chords as f64 - angle).abs()
    };
    // The error depends on the place of the first slip within a leg, so the largest error over neighbouring numbers of legs is used.
    let worst = |about: usize| (about..about + 8).map(error).fold(0.0, f64::max);
    let [coarse, fine] = [20, 320].map(worst);
    let order = (coarse / fine).log2() / 16_f64.log2();
    assert!((order - 2.0).abs() < 0.15, "{coarse:e} {fine:e} {order}");
}

#[test]
fn what_nothing_resists_gives_way_at_once() {
    // Two points cannot carry a moment about the line between them.
    let finger = |x: f64| jaw::<3>(x, [1000.0, 800.0], 0.5).pressed_with(10.0);
    let grasp = spatial::Grasp::new([finger(-1.0), finger(1.0)]).unwrap();
    let off_the_line = spatial::Turn::tilting([0.0, 0.0, -2.0], [0.0, 0.0, -0.1], [1.0, 0.0, 0.0]).unwrap();
    let answer = grasp.onset_of_turn(off_the_line).unwrap();
    assert!(matches!(answer.onset, spatial::Onset::GivesWay { factor: 0.0, .. }), "{answer:?}");
    // A weight on the line through both fingers turns as in the plane.
    let on_the_line = spatial::Turn::force_at([12.0, 0.0, 0.0], [0.0; 3], [0.0, 0.0, 1.0]).unwrap();
    let (plane, turn) = box_on_its_side(12.0);
    let known = plane.onset_of_turn(turn).unwrap().onset.factor().unwrap();
    let angle = grasp.onset_of_turn(on_the_line).unwrap().onset.factor().unwrap();
    assert!((angle - known).abs() < 1e-15, "{angle} {known}");
}

#[test]
fn polygons_close_in_on_the_round_cone() {
    let finger = |angle: f64| {
        let point = [angle.cos(), angle.sin(), 0.0];
        spatial::Contact::new(point, point.map(|x| -x))
            .series_stiffness(1000.0, 700.0)
            .friction(0.6)
            .pressed_with(5.0)
    };
    let grasp = spatial::Grasp::new([0.3, 2.1, 4.4].map(finger)).unwrap();
    let turn = spatial::Turn::tilting([0.5, 0.0, -7.5], [0.05, 0.1, 0.0], [0.3, 1.0, 0.2]).unwrap();
    let round = grasp.onset_of_turn(turn).unwrap().onset.factor().unwrap();
    let facets = |count: usize| {
        let cone = PolygonCone::new(count, grasp_lcp::PolygonFit::Inscribed).unwrap();
        let settings = Settings::default().on_the_polygon().with_cone(cone);
        grasp.with(&settings).onset_of_turn(turn).unwrap().onset.factor().unwrap()
    };
    let [coarse, fine] = [16, 128].map(facets);
    assert!(round.is_finite() && coarse < round && fine < round, "{coarse} {fine} {round}");
    assert!(round - coarse < 0.1 && round - fine < (round - coarse) / 8.0, "{coarse} {fine} {round}");
}

#[test]
fn the_state_at_the_onset_and_what_comes_beyond() {
    let (grasp, turn) = box_on_its_side(12.0);
    let onset = grasp.onset_of_turn(turn).unwrap().onset;
    let event = onset.event().unwrap();
    let state = grasp.state_at_onset(event).expect("its own");
    assert!((state.contacts[0].friction_used() - 0.5).abs() < 1e-15 && state.residuals.worst() < 1e-15);
    assert!((event.load.resultant()[1] - 12.0 * event.factor.sin()).abs() < 1e-14);
    // By the balance of moments about the middle, both palms carry the same force. If one palm slides, the other slides too.
    assert!(matches!(grasp.beyond(event), Some(planar::Beyond::LimitLoad)));
    // A load path along a short chord of the turn, which starts just before the first slip, is lost at the first slip too.
    let near = |angle: f64| turn.load_at(event.factor + angle);
    let mut path = grasp.follow(near(-1e-4), &[planar::Leg::load_to(near(1e-4))]).unwrap();
    path.run();
    assert!(matches!(path.end(), Some(PathEnd::Lost(loss)) if (loss.fraction - 0.5).abs() < 1e-4));
}

#[test]
fn gradients_are_those_of_small_changes() {
    let grasp = |[mu, k, command]: [f64; 3]| {
        let finger = |angle: f64, [mu, k, command]: [f64; 3]| {
            let point = [angle.cos(), angle.sin(), 0.1 * angle.sin()];
            spatial::Contact::new(point, point.map(|x| -x))
                .series_stiffness(k, 0.7 * k)
                .friction(mu)
                .command([command, 0.0, 0.0])
        };
        let usual = [0.6, 1000.0, 6e-3];
        spatial::Grasp::new([finger(0.3, [mu, k, command]), finger(2.1, usual), finger(4.4, usual)]).unwrap()
    };
    let turn = |aside: f64| {
        spatial::Turn::tilting([0.5, 0.0, -8.5], [0.05, 0.1, 0.0], [0.3, 1.0, 0.2])
            .unwrap()
            .beside(spatial::Wrench::force([0.0, aside, 0.0]))
    };
    let data = [0.6, 1000.0, 6e-3];
    let angle =
        |data: [f64; 3], aside: f64| grasp(data).onset_of_turn(turn(aside)).unwrap().onset.factor().unwrap();
    let onset = grasp(data).onset_of_turn(turn(0.0)).unwrap().onset;
    let held = grasp(data);
    let margins = held.sensitivity().onset(onset.event().expect("slides")).expect("sticks before");
    let by = |parameter| margins.by(parameter).expect("a datum")[0];
    let by_axis = [0, 1, 2].map(|axis| by(Parameter::Stiffness { contact: 0, axis }));
    let stiffness = by_axis[0] + 0.7 * (by_axis[1] + by_axis[2]);
    let known =
        [by(Parameter::Friction { contact: 0 }), stiffness, by(Parameter::Command { contact: 0, axis: 0 })];
    let by_load = by(Parameter::Load { component: 1 });
    let mut felt = 0;
    for (k, known) in known.into_iter().enumerate() {
        let step = 1e-5 * data[k];
        let moved = |by: f64| angle(std::array::from_fn(|j| data[j] + if j == k { by } else { 0.0 }), 0.0);
        let difference = (moved(step) - moved(-step)) / (2.0 * step);
        assert!(
            (difference - known).abs() < 1e-7 * (1.0 / data[k] + known.abs()),
            "{k}: {difference} {known}"
        );
        felt += usize::from(known.abs() * data[k] > 1e-3);
    }
    let difference = (angle(data, 1e-5) - angle(data, -1e-5)) / 2e-5;
    assert!((difference - by_load).abs() < 1e-7, "{difference} {by_load}");
    assert!(felt >= 2 && by_load.abs() > 1e-3);
}

#[test]
fn what_is_no_turn_is_refused() {
    let (grasp, turn) = box_on_its_side(12.0);
    for angle in [0.0, -1.0, f64::NAN, f64::INFINITY, 2e6] {
        let refused = grasp.onset_of_turn(turn.up_to(angle)).unwrap_err();
        let Error::Argument { what, value, .. } = refused else { panic!("{refused}") };
        assert!(what.starts_with("angle") && value.to_bits() == angle.to_bits(), "{what} {value}");
    }
    let bad = Wrench::force([f64::NAN, 0.0]);
    for (turn, what) in [
        (Turn::new(bad, Wrench::ZERO, Wrench::ZERO), "constant"),
        (Turn::new(Wrench::ZERO, bad, Wrench::ZERO), "cosine"),
        (Turn::new(Wrench::ZERO, Wrench::ZERO, bad), "sine"),
    ] {
        let refused = grasp.onset_of_turn(turn).unwrap_err();
        let Error::Wrench { what: told, component: 0, .. } = refused else { panic!("{refused}") };
        assert!(told.starts_with(what), "{told}");
    }
    for axis in [[0.0; 3], [f64::NAN, 0.0, 1.0], [0.0, f64::INFINITY, 0.0]] {
        let refused = spatial::Turn::tilting([0.0, 0.0, -1.0], [0.0; 3], axis).unwrap_err();
        assert!(matches!(refused, Error::Argument { what, .. } if what.ends_with("the axis")), "{refused}");
    }
    // A turning load of zero changes nothing.
    let still = Turn::new(Wrench::force([0.0, -1.0]), Wrench::ZERO, Wrench::ZERO).up_to(FRAC_PI_2.max(PI));
    assert!(grasp.onset_of_turn(still).unwrap().onset.factor().unwrap().is_infinite());
}
