//! Jumps of slip of two feet and of a slider agree with closed forms.

use grasp_lcp::load_path::Parameter;
use grasp_lcp::planar::{Change, PathEnd};
use grasp_lcp::planar::{Contact, Event, Grasp, Leg, Wrench};

/// Two feet pressed with n newtons that slide along x only, with these tangential stiffnesses. A frictionless rail keeps the object level.
fn feet(n: f64, friction: [f64; 2], stiffness: [f64; 2]) -> Grasp {
    let foot = |x: f64, k: f64| {
        let contact = Contact::new([x, 0.0], [0.0, 1.0]).series_stiffness(1000.0, k).friction(friction[0]);
        contact.kinetic(friction[1]).pressed_with(n)
    };
    let rail = |x: f64| Contact::new([x, 0.1], [0.0, -1.0]).series_stiffness(1000.0, 1.0).pressed_with(n);
    Grasp::new([foot(-0.1, stiffness[0]), foot(0.1, stiffness[1]), rail(-0.1), rail(0.1)]).unwrap()
}

fn pulled(grasp: &Grasp, force: f64) -> (Vec<Event>, Option<PathEnd>, f64) {
    let mut path = grasp.follow(Wrench::ZERO, &[Leg::load_to(Wrench::force([force, 0.0]))]).unwrap();
    let events = path.run();
    let end = path.end().cloned();
    (events, end, path.place().1 * force)
}

/// Two feet press with 10 N each, and the ratio of their stiffnesses is one half. At a pull of 7.5 N they carry 5 and 2.5 N. The stiff foot slides,
/// and its friction falls to 4 N, so that the soft foot carries 3.5 N. At 9 N the soft foot slides too, and 8 N of friction are left.
#[test]
fn of_two_feet_one_catches_what_the_other_loses() {
    let grasp = feet(10.0, [0.5, 0.4], [1000.0, 500.0]);
    let (events, end, lost_at) = pulled(&grasp, 12.0);
    let [event] = &events[..] else { panic!("{events:?}") };
    assert!((12.0 * event.fraction - 7.5).abs() < 1e-13);
    let jump = event.jump.as_deref().unwrap();
    let carried = |state: &grasp_lcp::planar::Equilibrium, i: usize| state.contacts[i].force[1].abs();
    for (i, before, after) in [(0, 5.0, 4.0), (1, 2.5, 3.5)] {
        assert!((carried(&event.state, i) - before).abs() < 1e-13);
        assert!((carried(&jump.state, i) - after).abs() < 1e-13);
    }
    // At 7.5 N the object jumps from 5 to 7 mm. Then the stiff foot has slipped by 3 mm, because its spring is still deformed by 4 mm.
    let [slip] = &jump.slips[..] else { panic!("{:?}", jump.slips) };
    assert_eq!(slip.contact.index, 0);
    assert!((slip.slip.norm() - 3e-3).abs() < 1e-15);
    let stored = |a: f64, b: f64| 0.5 * (a * a / 1000.0 + b * b / 500.0);
    let lost = 7.5 * 2e-3 - (stored(4.0, 3.5) - stored(5.0, 2.5));
    assert!((jump.energy_lost - lost).abs() < 1e-15 && lost > 4.0 * 3e-3);
    assert!((lost_at - 9.0).abs() < 1e-12);
    assert!(matches!(end, Some(PathEnd::Lost(_))));
}

/// The jump of the stiff foot ends in an equilibrium if and only if k₂/k₁ <= μ_k/μ_s, with the stiffness k₁ of the stiff foot and k₂ of the soft
/// foot.
#[test]
fn the_ratio_of_stiffnesses_decides() {
    for (rest, sliding) in [(0.5, 0.4), (0.8, 0.3), (1.2, 1.1), (0.3, 0.299_99)] {
        let edge = sliding / rest;
        for off in [1e-1, 1e-3, 1e-6, 1e-9, 1e-12] {
            for (ratio, is_caught) in [(edge * (1.0 - off), true), (edge * (1.0 + off), false)] {
                // With equal stiffness both feet slide at once.
                if ratio >= 1.0 {
                    continue;
                }
                let grasp = feet(10.0, [rest, sliding], [1000.0, 1000.0 * ratio]);
                let first = (1.0 + ratio) * rest * 10.0;
                let (events, end, place) = pulled(&grasp, 1.01 * first);
                let jumped = events.iter().any(|event| event.jump.is_some());
                assert_eq!(jumped, is_caught, "{off} {events:?} {end:?}");
                if !is_caught {
                    assert!(
                        matches!(end, Some(PathEnd::Lost(ref loss)) if !loss.jumped.is_empty()),
                        "{end:?}"
                    );
                    assert!((place - first).abs() < 1e-11 * first, "{off} {place} {first}");
                }
            }
        }
    }
}

/// With equal stiffness both feet slide at 10 N, and kinetic friction carries only 8 N.
#[test]
fn both_at_once_are_lost() {
    let (events, end, place) = pulled(&feet(10.0, [0.5, 0.4], [1000.0; 2]), 12.0);
    assert!(events.is_empty());
    assert!(matches!(end, Some(PathEnd::Lost(_))) && (place - 10.0).abs() < 1e-12);
}

/// A bonded spring of stiffness k drags a slider over a foot. When the slider begins to move, the force drops by (μ_s - μ_k) N, and then kinetic
/// friction acts.
fn slider(k: f64) -> Grasp {
    let foot = Contact::new([0.0, 0.0], [0.0, 1.0])
        .series_stiffness(1e3, 1e9)
        .friction(0.5)
        .kinetic(0.4)
        .pressed_with(10.0);
    let weight = Contact::new([0.0, 0.0], [0.0, -1.0]).series_stiffness(1e3, 1.0).pressed_with(10.0);
    let spring = |y: f64| Contact::new([0.0, y], [1.0, 0.0]).series_stiffness(0.5 * k, 1e-6).bonded();
    Grasp::new([foot, weight, spring(-0.1), spring(0.1)]).unwrap()
}

/// The slider moves to and fro a thousand times. At each reversal it sticks, so that the force drops by (μ_s - μ_k) N twice in each period.
#[test]
fn a_slider_drops_twice_a_period_for_a_thousand_periods() {
    let grasp = slider(1000.0);
    let to = |x: f64| {
        let none = [0.0, 0.0];
        Leg::commands_by([none, none, [x, 0.0], [x, 0.0]])
    };
    let mut path = grasp.follow(Wrench::ZERO, &[to(0.02)]).unwrap();
    assert_eq!(path.run().len(), 1);
    for period in 0..1000 {
        for back in [-0.04, 0.04] {
            path.continue_with(&[to(back)]).unwrap();
            let events = path.run();
            let [sticks, slides] = &events[..] else { panic!("{period}: {events:?}") };
            assert!(matches!(sticks.changes[0].what, Change::Sticks) && sticks.fraction == 0.0);
            // After a reversal, the friction changes from 4 N in one direction to 5 N in the other. This change of 9 N deforms a spring of 1000 N/m
            // by 9 mm.
            assert!((slides.fraction * 0.04 - 9e-3).abs() < 1e-8, "{period}: {}", slides.fraction);
            let jump = slides.jump.as_deref().unwrap();
            let drop = slides.state.contacts[0].force[1].abs() - jump.state.contacts[0].force[1].abs();
            assert!((drop - 1.0).abs() < 1e-10, "{period}: {drop}");
        }
    }
}

/// If the same pull of 7.5 N is reached by a turning load, the jump is the same.
#[test]
fn a_load_that_turns_jumps_as_a_straight_one() {
    let grasp = feet(10.0, [0.5, 0.4], [1000.0, 500.0]);
    let none = Wrench::ZERO;
    let turn =
        grasp_lcp::planar::Turn::new(none, none, Wrench::force([8.5, 0.0])).up_to(std::f64::consts::PI);
    let mut path = grasp.follow(none, &[Leg::turn(&turn)]).unwrap();
    let events = path.run();
    assert!(matches!(path.end(), Some(PathEnd::Completed)));
    assert!((8.5 * (events[0].fraction * std::f64::consts::PI).sin() - 7.5).abs() < 1e-12);
    let state = &events[0].jump.as_deref().unwrap().state;
    for (i, after) in [(0, 4.0), (1, 3.5)] {
        assert!((state.contacts[i].force[1].abs() - after).abs() < 1e-12);
    }
    // After a quarter turn the load decreases, and the sliding foot sticks.
    assert!(matches!(events[1].changes[0].what, Change::Sticks) && (events[1].fraction - 0.5).abs() < 1e-9);
}

/// If the drag pauses after each slip, the slider sticks again: it needs 5 N to slide, and the force drops to 4 N.
#[test]
fn a_pause_lets_friction_of_rest_come_back() {
    let grasp = slider(1000.0);
    let none = [0.0, 0.0];
    let by = |x: f64| Leg::commands_by([none, none, [x, 0.0], [x, 0.0]]);
    let mut path = grasp.follow(Wrench::ZERO, &[by(0.0045)]).unwrap();
    assert!(path.run().is_empty());
    for step in 0..1000 {
        // The spring must move by (μ_s - μ_k) N / k = 1 mm to bring the force from 4 N to 5 N, where the slider slips.
        path.continue_with(&[by(0.001), by(0.0)]).unwrap();
        let events = path.run();
        let [slides, sticks] = &events[..] else { panic!("{step}: {events:?}") };
        assert!((slides.fraction - 0.5).abs() < 1e-4, "{step}: {}", slides.fraction);
        assert!(slides.jump.is_some() && matches!(sticks.changes[0].what, Change::Sticks));
        let force = path.forces()[0][1].abs();
        assert!((force - 4.0).abs() < 1e-9, "{step}: {force}");
        // After half of this motion the slider still sticks.
        path.continue_with(&[by(0.0005)]).unwrap();
        assert!(path.run().is_empty() && (path.forces()[0][1].abs() - 4.5).abs() < 1e-3);
    }
}

/// The friction of the sliding foot is 0.4 (the kinetic coefficient) times its normal force, and derivatives use this coefficient.
#[test]
fn derivatives_have_the_friction_of_sliding() {
    let grasp = feet(10.0, [0.5, 0.4], [1000.0, 500.0]);
    let (events, ..) = pulled(&grasp, 12.0);
    let state = &events[0].jump.as_deref().unwrap().state;
    let by_press = grasp.sensitivity().of(state, Parameter::Command { contact: 0, axis: 0 }).unwrap();
    let [normal, friction] = by_press.forces[0].into();
    assert!(normal > 100.0 && (friction.abs() - 0.4 * normal).abs() < 1e-10 * normal, "{by_press:?}");
}
