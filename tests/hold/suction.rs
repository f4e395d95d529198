//! The vacuum of suction cups acts in addition to the load. Answers agree with balances by hand, and with the same grasp if the caller adds the
//! vacuum to the load.

use grasp_lcp::hold::WayOut;
use grasp_lcp::need::{Amount, Need, Needed};
use grasp_lcp::planar::hand::{Finger, Hand, Joint};
use grasp_lcp::spatial::{
    Contact, Departure, Grasp, Leg, LoadPath, Ramp, SoftFingertip, SuctionCup, Turn, Wrench,
};
use grasp_lcp::{Error, Field, planar};
use support::jaws::jaw;

const RADIUS: f64 = 0.02;
const VACUUM: f64 = 60.0;
const FRICTION: f64 = 0.5;

type Tested = Result<(), Error>;

fn is(found: f64, expected: f64) {
    assert!((found - expected).abs() <= 1e-11 * (1.0 + expected.abs()), "{found} {expected}");
}

/// A cup on top of a plate, tilted and off the origin, so that no terms cancel by chance.
fn lip() -> Contact {
    Contact::new([0.3, -0.1, 0.2], [0.2, -0.1, -1.0])
        .name("cup")
        .series_stiffness(8e3, 4e3)
        .friction(FRICTION)
}

fn pads() -> [Contact; 2] {
    [[0.3, -0.15, 0.2], [0.3, -0.05, 0.2]].map(|at| {
        Contact::new(at, [0.2, -0.1, -1.0]).series_stiffness(3e4, 1e4).friction(0.8).command([1e-4, 0.0, 0.0])
    })
}

/// The grasp with a suction cup, the grasp with a ring of contacts in place of the cup, and the vacuum of the cup as a load on the second grasp.
fn both() -> Result<(Grasp, Grasp, Wrench), Error> {
    let cup = SuctionCup::of_force(RADIUS, 12, VACUUM)?;
    let grasp = Grasp::new([cup.contacts(&lip())?, pads().to_vec()].concat())?;
    let by_hand = Grasp::new([SoftFingertip::ring(RADIUS, 12)?.contacts(&lip())?, pads().to_vec()].concat())?;
    let normal = nalgebra::Vector3::new(0.2, -0.1, -1.0).normalize();
    let pull = Wrench::force_at(normal * -VACUUM, [0.3, -0.1, 0.2]);
    Ok((grasp, by_hand, pull))
}

#[test]
fn a_vacuum_is_a_load_that_nobody_has_to_name() -> Tested {
    let (grasp, by_hand, pull) = both()?;
    let weight = Wrench::force_at([0.2, 0.3, -4.0], [0.31, -0.09, 0.15]);
    let [solved, expected] = [grasp.solve(weight)?, by_hand.solve(weight + pull)?];
    let [state, expected] = [&solved, &expected].map(|outcome| outcome.equilibrium().expect("held"));
    assert_eq!(state.load, weight);
    assert!(state.residuals.worst() < 1e-14, "{:?}", state.residuals);
    for (one, other) in state.contacts.iter().zip(&expected.contacts) {
        let off = (one.force - other.force).norm();
        assert!(off < 1e-11 * VACUUM, "{off:e}: {one:?} {other:?}");
    }
    for (one, other) in state.twist.components().iter().zip(expected.twist.components()) {
        is(*one, *other);
    }
    let push = Wrench::force([1.0, 0.5, 0.2]);
    let factors = [grasp.onset(Ramp::load(weight, push))?, by_hand.onset(Ramp::load(weight + pull, push))?];
    let [factor, by_load] = factors.map(|onset| onset.factor().expect("slides"));
    is(factor, by_load);
    let turn = Turn::tilting([0.0, 0.0, -20.0], [0.3, -0.1, 0.1], [1.0, 0.0, 0.0])?;
    let angles = [grasp.onset_of_turn(turn)?, by_hand.onset_of_turn(turn.beside(pull))?];
    let [angle, by_load] = angles.map(|found| found.onset.factor().expect("slides"));
    is(angle, by_load);
    // The verdict ends when the first point of the lip opens. The load path continues, as if the vacuum lasted.
    let paths = [(&grasp, weight), (&by_hand, weight + pull)].map(|(grasp, start)| {
        let mut path = grasp.follow(start, &[Leg::load_to(start + push)]).expect("a path");
        path.run();
        path
    });
    let is_open =
        |path: &LoadPath<'_>| path.forces()[..12].iter().any(|force| *force == nalgebra::Vector3::zeros());
    assert!(paths.iter().all(|path| is_open(path) && path.place() == (0, 1.0)));
    for (one, other) in paths[0].forces().iter().zip(paths[1].forces()) {
        assert!((one - other).norm() < 1e-9 * VACUUM, "{one} {other}");
    }
    Ok(())
}

/// Each single kind of load, applied from zero: tension, shear, peeling and torsion.
#[test]
fn one_kind_of_load_alone() -> Tested {
    let lip = Contact::new([0.0; 3], [0.0, 0.0, -1.0])
        .tangent([1.0, 0.0, 0.0])
        .series_stiffness(8e3, 4e3)
        .friction(FRICTION);
    let plate = Grasp::new(
        SuctionCup::of_pressure(RADIUS, 12, VACUUM / (std::f64::consts::PI * RADIUS * RADIUS))?
            .contacts(&lip)?,
    )?;
    let cases = [
        (Wrench::force([0.0, 0.0, -1.0]), VACUUM, 12, false),
        (Wrench::force([1.0, 0.0, 0.0]), FRICTION * VACUUM, 12, true),
        (Wrench::new([0.0; 3], [0.0, 1.0, 0.0]), VACUUM * RADIUS / 2.0, 1, false),
        (Wrench::new([0.0; 3], [0.0, 0.0, 1.0]), FRICTION * VACUUM * RADIUS, 12, true),
    ];
    for (load, factor, leaving, slides) in cases {
        let onset = plate.onset(load)?;
        let event = onset.event().expect("it leaves");
        is(event.factor, factor);
        assert_eq!(event.leaving.len(), leaving);
        assert!(event.leaving.iter().all(|l| slides == matches!(l.how, Departure::Slides { .. })));
    }
    let needed = plate.need(&Need::squeeze(Wrench::force([9.0, 0.0, 0.0])))?;
    is(needed.amount.bound().expect("some vacuum does"), 9.0 / (FRICTION * VACUUM));
    Ok(())
}

/// Three cups in a row; W hangs at the distance b from the middle, beyond the last cup. That cup opens at V = W (1/3 + b/2a). If it
/// kept its vacuum, the beam would still be in equilibrium.
#[test]
fn a_cup_that_is_open_all_around_has_let_go() -> Tested {
    let (a, b) = (0.1, 0.12);
    let cup = |x: f64, name: &str| {
        planar::Contact::new([x, 0.0], [0.0, -1.0])
            .name(name)
            .series_stiffness(5e3, 5e3)
            .friction(0.5)
            .suction(VACUUM)
    };
    let beam = planar::Grasp::new([cup(-a, "far"), cup(0.0, "middle"), cup(a, "near")])?;
    let expected = VACUUM / (1.0 / 3.0 + b / (2.0 * a));
    let verdict = beam.hold(planar::Wrench::force_at([0.0, -100.0], [b, 0.0]))?;
    let lost = verdict.lost.as_ref().expect("it lets go");
    is(lost.factor * 100.0, expected);
    let WayOut::LetsGo { cups } = &lost.way_out else { panic!("{verdict}") };
    assert_eq!((cups.len(), &*cups[0].label, verdict.holds()), (1, "near", Some(false)));

    let half = beam.hold(planar::Wrench::force_at([0.0, -0.5 * expected], [b, 0.0]))?;
    assert_eq!(half.holds(), Some(true));
    is(half.lost.expect("twice as much").factor, 2.0);
    Ok(())
}

/// The vacuum pulls equally on finger and object, so the joint behind the cup carries only the hanging load.
#[test]
fn a_joint_does_not_feel_it() -> Tested {
    let cup = planar::Contact::new([0.0, 0.0], [0.0, -1.0])
        .series_stiffness(5e3, 5e3)
        .friction(0.5)
        .suction(VACUUM);
    let lift = Finger::new([Joint::prismatic([0.0, 1.0]).stiffness(2e3)]).contact(cup);
    let side = |x: f64| jaw::<2>(x, [1e4, 1e-3], 0.0).pressed_with(5.0);
    let grasp = Hand::new([lift, Finger::fixed(side(-0.1)), Finger::fixed(side(0.1))]).grasp()?;
    let outcome = grasp.solve(planar::Wrench::force([0.0, -20.0]))?;
    let state = outcome.equilibrium().expect("it hangs");
    is(state.joints[0].torque.abs(), 20.0);
    is(state.contacts[0].normal_force(), VACUUM - 20.0);
    assert!(state.residuals.worst() < 1e-13, "{:?}", state.residuals);
    Ok(())
}

#[test]
fn what_is_no_vacuum_is_refused() {
    let refused = Grasp::new([lip().suction(-1.0)]).expect_err("it pushes");
    let Error::Contact { contact, field: Field::Suction, value: -1.0, .. } = refused else {
        panic!("{refused}")
    };
    assert_eq!(contact.to_string(), "0 (cup)");
    for (force, pressure) in [(-1.0, -1.0), (f64::NAN, f64::NAN), (f64::INFINITY, f64::INFINITY)] {
        assert!(
            SuctionCup::of_force(RADIUS, 12, force).is_err()
                && SuctionCup::of_pressure(RADIUS, 12, pressure).is_err()
        );
    }
    assert!(SuctionCup::of_force(0.0, 12, 1.0).is_err() && SuctionCup::of_force(RADIUS, 2, 1.0).is_err());
}

/// The force of the only pressing contact in an answer, N, and the pressure if it is a cup, Pa.
fn press(needed: &Needed) -> (f64, Option<f64>) {
    let Amount::Bound { presses, .. } = &needed.amount else { panic!("{needed}") };
    assert_eq!(presses.len(), 1, "{needed}");
    (presses[0].force, presses[0].pressure)
}

/// The pressure of a cup acts on the area of its lip. In the plane suction is given as a force.
#[test]
fn a_cup_needs_a_pressure_and_two_edges_in_the_plane_a_force() -> Tested {
    let above = Contact::new([0.0; 3], [0.0, 0.0, -1.0]).series_stiffness(8e3, 4e3).friction(FRICTION);
    let cup = Grasp::new(SuctionCup::of_force(RADIUS, 12, VACUUM)?.contacts(&above)?)?;
    let (force, pressure) = press(&cup.need(&Need::squeeze(Wrench::force([0.0, 0.0, -30.0])))?);
    is(force, 30.0);
    is(pressure.expect("a cup") * std::f64::consts::PI * RADIUS * RADIUS, 30.0);
    let above = planar::Contact::new([0.0; 2], [0.0, -1.0])
        .series_stiffness(8e3, 4e3)
        .friction(FRICTION)
        .suction(VACUUM);
    let edges = planar::Grasp::new(planar::SoftFingertip::pair(2.0 * RADIUS)?.contacts(&above)?)?;
    let (force, pressure) = press(&edges.need(&Need::squeeze(planar::Wrench::force([0.0, -30.0])))?);
    is(force, 30.0);
    assert_eq!(pressure, None);
    Ok(())
}
