//! For loads that turn, events and states agree with closed forms, mirror images and chords: where contacts slide, stick and slide back, and what
//! each turn leaves behind.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use grasp_lcp::load_path::{Change, PathEnd};
use grasp_lcp::planar::{Contact, Grasp, Leg, Turn, Wrench};
use grasp_lcp::{Error, Settings, spatial};
use support::programs::changes;

#[test]
fn a_block_on_a_spring_goes_round_its_hysteresis() -> Result<(), Error> {
    // Two feet press with 1 N together. A pull P sin θ acts against a spring of 20 N/m and against the feet, which stick with 50 N/m up to the
    // friction limit μ N = 0.3 N. The feet take 5/7 of the pull, and slide where this is the friction limit. After a turning point they stick, and
    // slide back where 5/7 of the change of the pull is twice the friction limit.
    let (mu, pull, turns) = (0.3, 0.9, 5_u32);
    let foot = |x: f64| {
        Contact::new([x, 0.0], [0.0, 1.0]).series_stiffness(1e3, 25.0).friction(mu).command([1.5e-3, 0.0])
    };
    let lid = Contact::new([0.0, 0.0], [0.0, -1.0]).series_stiffness(1e3, 1.0);
    let spring = Contact::new([0.0, 0.0], [1.0, 0.0]).series_stiffness(20.0, 1.0).kept_closed();
    let grasp = Grasp::new([foot(-1.0), foot(1.0), lid, spring])?;
    let angle = TAU * f64::from(turns);
    let turn = Turn::new(Wrench::ZERO, Wrench::ZERO, Wrench::force([pull, 0.0])).up_to(angle);
    let mut path = grasp.follow(Wrench::ZERO, &[Leg::turn(&turn)])?;
    let events = path.run();
    assert!(matches!(path.end(), Some(PathEnd::Completed)), "{:?}", path.end());
    assert_eq!(events.len(), 1 + 4 * turns as usize);
    let (first, back) = ((1.4 * mu / pull).asin(), (1.0 - 2.8 * mu / pull).asin());
    for (k, event) in events.iter().enumerate() {
        let half = (k / 2) as f64 * PI;
        let (known, slides) = match k {
            0 => (first, true),
            _ if k % 2 == 1 => (FRAC_PI_2 + half, false),
            _ => (half - back, true),
        };
        assert!((event.fraction * angle - known).abs() < 1e-13, "{k}: {} {known}", event.fraction * angle);
        for (contact, change) in changes(event) {
            assert!(contact < 2 && matches!(change, Change::Slides { .. }) == slides, "{k}: {change:?}");
        }
        assert_eq!(event.changes.len(), 2);
    }
    // The whole slip: `once` from rest to the first turning point, twice as much in each half turn, and the rest of the last half turn.
    let once = pull / 20.0 - 0.07 * mu;
    let slipped = once + (2.0 * f64::from(turns) - 1.0) * 2.0 * once + once - 0.07 * mu;
    let energy = path.energies()[0];
    assert!((energy.dissipated - mu * slipped).abs() < 1e-14, "{energy:?} {}", mu * slipped);
    assert!(energy.residual().abs() < 1e-15, "{energy:?}");
    Ok(())
}

/// Eight fingers press on a shaft from all sides. A rotating load reduces the pressure of some of them.
fn shaft(sense: f64) -> Grasp {
    let finger = |k: i32| {
        let (sin, cos) = (sense * TAU * (f64::from(k) + 0.3) / 8.0).sin_cos();
        Contact::new([cos, sin], [-cos, -sin]).series_stiffness(1e3, 600.0).friction(0.2).pressed_with(1.0)
    };
    Grasp::new((0..8).map(finger)).expect("valid")
}

fn radial(sense: f64) -> Turn {
    let turn = Turn::force_at([2.4, 0.0], [0.0, 0.0]);
    if sense < 0.0 { turn.reversed() } else { turn }
}

/// The rotation of the shaft at the end of each turn of the load.
fn creep(sense: f64, turns: usize) -> Result<Vec<f64>, Error> {
    let grasp = shaft(sense);
    let mut path = grasp.follow(Wrench::force([2.4, 0.0]), &vec![Leg::turn(&radial(sense)); turns])?;
    path.run();
    assert!(matches!(path.end(), Some(PathEnd::Completed)), "{:?}", path.end());
    Ok((0..turns).filter_map(|leg| path.state_at(leg, 1.0)).map(|state| state.twist.rotation()).collect())
}

#[test]
fn a_shaft_creeps_with_each_turn_of_its_load() -> Result<(), Error> {
    let [on, back] = [creep(1.0, 6)?, creep(-1.0, 6)?];
    let each: Vec<f64> = on.windows(2).map(|two| two[1] - two[0]).collect();
    println!("{on:?} {each:?}");
    // From the third turn on, the creep per turn is constant. The creep of the mirror image is opposite.
    assert!(each[3].abs() > 1e-4 && (each[4] - each[3]).abs() < 1e-12, "{each:?}");
    for (on, back) in on.iter().zip(&back) {
        assert!((on + back).abs() < 1e-15, "{on} {back}");
    }
    Ok(())
}

#[test]
fn one_leg_of_many_turns_is_many_legs() -> Result<(), Error> {
    let grasp = shaft(1.0);
    let legs = creep(1.0, 4)?;
    let mut path = grasp.follow(Wrench::force([2.4, 0.0]), &[Leg::turn(&radial(1.0).up_to(4.0 * TAU))])?;
    path.run();
    let end = path.state().expect("has passed");
    assert!((end.twist.rotation() - legs[3]).abs() < 1e-14);
    Ok(())
}

#[test]
fn chords_close_in_on_a_turn_in_the_plane() -> Result<(), Error> {
    let grasp = shaft(1.0);
    let exact = creep(1.0, 2)?[1];
    let chord_error = |chords: i32| -> Result<f64, Error> {
        let legs: Vec<_> = (1..=2 * chords)
            .map(|k| Leg::load_to(radial(1.0).load_at(TAU * f64::from(k) / f64::from(chords))))
            .collect();
        let mut path = grasp.follow(Wrench::force([2.4, 0.0]), &legs)?;
        path.run();
        Ok((path.state().expect("has passed").twist.rotation() - exact).abs())
    };
    // The error depends on the place of events within a chord of the turn, so the largest error over neighbouring numbers of chords is used.
    let worst = |about: i32| {
        (about..about + 6).try_fold(0.0, |most: f64, n| Ok::<_, Error>(most.max(chord_error(n)?)))
    };
    let [coarse, fine] = [worst(20)?, worst(1280)?];
    let order = (coarse / fine).log2() / 6.0;
    assert!((order - 2.0).abs() < 0.2 && fine < 1e-4 * exact.abs(), "{coarse:e} {fine:e} {order}");
    Ok(())
}

#[test]
fn chords_close_in_on_a_turn_on_the_round_cone() -> Result<(), Error> {
    // A turning force drags a plate on three feet, and the sliding directions follow it.
    let foot = |x: f64, y: f64, mu: f64| {
        spatial::Contact::new([x, y, 0.0], [0.0, 0.0, 1.0])
            .series_stiffness(500.0, 300.0)
            .friction(mu)
            .command([4e-3, 0.0, 0.0])
    };
    let spring = |axis: usize| {
        let mut normal = [0.0; 3];
        normal[axis] = 1.0;
        spatial::Contact::new([0.0, 0.0, 0.2], normal).series_stiffness(40.0, 1.0).kept_closed()
    };
    let grasp = spatial::Grasp::new([
        foot(-1.0, -1.0, 0.3),
        foot(1.0, -1.0, 0.4),
        foot(0.0, 2.0, 0.5),
        spring(0),
        spring(1),
    ])?;
    let weight = spatial::Wrench::force([0.0, 0.0, -3.0]);
    let turn =
        spatial::Turn::force_at([1.4, 0.0, 0.0], [0.3, 0.0, 0.0], [0.0, 0.0, 1.0])?.beside(weight).up_to(5.0);
    let start = [spatial::Leg::load_to(turn.load_at(0.0))];
    let settings = Settings::default().with_step_error(1e-13);
    let asked = grasp.with(&settings);
    let mut path = asked.follow(weight, &[&start[..], &[spatial::Leg::turn(&turn)]].concat())?;
    let events = path.run();
    assert!(matches!(path.end(), Some(PathEnd::Completed)), "{:?}", path.end());
    assert!(events.len() > 2, "{events:?}");
    let exact = path.state().expect("has passed");
    let energy = path.energies()[1];
    assert!(energy.residual().abs() < 1e-11 && energy.dissipated > 1e-3, "{energy:?}");
    let chord_error = |chords: i32| -> Result<f64, Error> {
        let angle = |k: i32| 5.0 * f64::from(k) / f64::from(chords);
        let chord = |k: i32| spatial::Leg::load_to(turn.load_at(angle(k)));
        let legs: Vec<_> = start.iter().cloned().chain((1..=chords).map(chord)).collect();
        let asked = grasp.with(&settings);
        let mut path = asked.follow(weight, &legs)?;
        path.run();
        let end = path.state().expect("has passed");
        let apart = |(a, b): (&spatial::ContactAnswer, &spatial::ContactAnswer)| (a.force - b.force).norm();
        Ok(end.contacts.iter().zip(&exact.contacts).map(apart).fold(0.0, f64::max))
    };
    let [coarse, fine] = [chord_error(20)?, chord_error(320)?];
    let order = (coarse / fine).log2() / 4.0;
    println!("{coarse:e} {fine:e} {order}");
    assert!((order - 2.0).abs() < 0.3 && fine < 1e-4, "{coarse:e} {fine:e} {order}");
    Ok(())
}

#[test]
fn what_cannot_be_followed_exactly_is_refused() {
    let grasp = shaft(1.0);
    let turn = radial(1.0);
    let both = Leg::turn(&turn).and_commands_by([[1e-3, 0.0]; 8]);
    let refused = grasp.follow(Wrench::ZERO, &[both]).expect_err("refused");
    assert_eq!(refused, Error::CommandsWhileTurning);
    let refused = grasp.follow(Wrench::ZERO, &[Leg::turn(&turn.up_to(f64::NAN))]).expect_err("refused");
    let Error::Argument { what, value, .. } = refused else { panic!("{refused}") };
    assert!(what.starts_with("angle") && value.is_nan(), "{what} {value}");
}

/// If a turning load starts at another load than the one that acts before its leg, the leg is refused. Otherwise only the change of the turning load
/// would be applied.
#[test]
fn a_turn_does_not_begin_with_a_jump() -> Result<(), Error> {
    let grasp = shaft(1.0);
    let (light, heavy) = (Leg::turn(&radial(1.0)), Leg::turn(&Turn::force_at([4.8, 0.0], [0.0, 0.0])));
    let (none, pull) = (Wrench::ZERO, Wrench::force([2.4, 0.0]));
    let refused = |start: Wrench, legs: &[Leg]| grasp.follow(start, legs).err();
    let jump = |leg, begins: f64, before: f64| {
        Some(Error::TurnBegins { leg, begins: vec![begins, 0.0, 0.0], before: vec![before, 0.0, 0.0] })
    };
    assert_eq!(refused(none, std::slice::from_ref(&light)), jump(0, 2.4, 0.0));
    assert_eq!(refused(pull, &[Leg::load_by(pull * -1.0), light.clone()]), jump(1, 2.4, 0.0));
    assert_eq!(refused(none, &[Leg::load_to(pull), light.clone()]), None);
    // The start of the turn may differ from the acting load by no more than the rounding of six written digits.
    assert_eq!(refused(pull * (1.0 + 4e-7), std::slice::from_ref(&light)), None);
    assert_eq!(grasp.shake(pull * 3.0, std::slice::from_ref(&light)).err(), jump(0, 2.4, 2.4 * 3.0));
    let mut path = grasp.follow(pull, &[Leg::load_to(pull * 2.0), heavy.clone()])?;
    path.next();
    path.continue_with(&[Leg::load_to(pull)])?;
    assert_eq!(path.continue_with(&[heavy]).err(), jump(3, 4.8, 2.4));
    path.continue_with(&[light])
}
