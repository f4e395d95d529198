//! Kinetic friction below static friction is respected in verdicts, scenes and needed amounts. Questions that cannot handle it refuse it.

use grasp_lcp::hold::{Holding, WayOut};
use grasp_lcp::need::Need;
use grasp_lcp::planar::{Contact, Grasp, Leg, Outcome, Ramp, Wrench};
use grasp_lcp::scene::Setup;
use grasp_lcp::{Error, Field};

type Tested = Result<(), Error>;

fn foot(name: &str, x: f64, stiffness: f64) -> Contact {
    let contact = Contact::new([x, 0.0], [0.0, 1.0]).name(name).series_stiffness(1000.0, stiffness);
    contact.friction(0.5).pressed_with(10.0)
}

/// Two feet on a frictionless rail. The first foot slides at 10 (1 + ratio)/2 N.
fn feet(kinetic: f64, ratio: f64) -> Result<Grasp, Error> {
    let rail = |x: f64| Contact::new([x, 0.1], [0.0, -1.0]).series_stiffness(1000.0, 1.0).pressed_with(10.0);
    Grasp::new([
        foot("left", -0.1, 1000.0).kinetic(kinetic),
        foot("right", 0.1, 1000.0 * ratio).kinetic(kinetic),
        rail(-0.1),
        rail(0.1),
    ])
}

fn pull(force: f64) -> Wrench {
    Wrench::force([force, 0.0])
}

#[test]
fn it_is_caught() -> Tested {
    let verdict = feet(0.4, 0.5)?.hold(pull(8.0))?;
    assert_eq!(verdict.caught.len(), 1);
    let slipped = &verdict.caught[0].slips[0];
    assert!(slipped.contact.label == "left" && (slipped.distance - 3e-3).abs() < 1e-15);
    let lost = verdict.lost.as_ref().expect("further on");
    assert!((8.0 * lost.factor - 9.0).abs() < 1e-12, "{verdict}");
    let first_slip = verdict.first_slip.expect("left slides");
    assert!((first_slip.factor - 7.5 / 8.0).abs() < 1e-13);
    Ok(())
}

#[test]
fn it_falls() -> Tested {
    for (grasp, held, takes, falls) in [(feet(0.3, 0.9)?, 9.5, 6.0, true), (feet(0.4, 0.5)?, 9.0, 8.0, false)]
    {
        let verdict = grasp.hold(pull(12.0))?;
        let lost = verdict.lost.as_ref().expect("slips out");
        assert!((12.0 * verdict.held_to - held).abs() < 1e-12, "{verdict}");
        assert!(lost.then_takes.is_some_and(|then| (12.0 * then - takes).abs() < 1e-12), "{verdict}");
        assert_eq!((lost.falls_at_once, verdict.caught.is_empty()), (falls, falls), "{verdict}");
        assert!(lost.slide.iter().any(|part| part.label == "left"), "{verdict}");
        let WayOut::SlidesOut { direction } = &lost.way_out else { panic!("{verdict}") };
        assert!(direction[0] > 1.0 - 1e-9, "{verdict}");
        if let Some(caught) = verdict.caught.first() {
            assert!((12.0 * caught.factor - 7.5).abs() < 1e-12, "{verdict}");
            assert!((caught.slips[0].distance - 3e-3).abs() < 1e-12, "{verdict}");
            let sliding: Vec<_> = lost.slide.iter().map(|part| part.label.as_str()).collect();
            assert_eq!(sliding, ["left", "right"]);
        }
    }
    Ok(())
}

/// The grasp is lost at 9 N. This gives the needed load, the squeeze for 8 N, and the friction with the same ratio of both coefficients.
#[test]
fn needs_count_with_it() -> Tested {
    let grasp = feet(0.4, 0.5)?;
    let is = |need: Need<2>, amount: f64| -> Tested {
        let needed = grasp.need(&need.to_hold())?;
        let found = needed.amount.bound().unwrap_or(f64::NAN);
        assert!((found / amount - 1.0).abs() < 1e-9, "{amount}: {needed}");
        Ok(())
    };
    is(Need::load(pull(8.0)), 9.0 / 8.0)?;
    is(Need::squeeze(pull(8.0)), 8.0 / 9.0)?;
    is(Need::friction_of([0, 1], pull(8.0)), 0.5 * 8.0 / 9.0)
}

#[test]
fn coefficients_are_checked() {
    for kinetic in [0.0, -0.1, 0.51, f64::NAN, f64::INFINITY, 1e-9] {
        let refused = Grasp::new([foot("left", 0.0, 1.0).kinetic(kinetic)]).unwrap_err();
        let Error::Contact { field: Field::KineticFriction, contact, value, allowed } = refused else {
            panic!("{refused:?}")
        };
        assert!(contact.index == 0 && value.to_bits() == kinetic.to_bits());
        assert!(allowed.contains("at rest"), "{allowed}");
    }
    assert!(Grasp::new([foot("left", 0.0, 1.0).kinetic(0.5)]).is_ok());
}

#[test]
fn what_does_not_know_it_says_so() -> Tested {
    let grasp = feet(0.4, 0.5)?;
    let leg = Leg::load_to(pull(1.0));
    let refused = [
        ("solve", grasp.solve(pull(8.0)).err()),
        ("follow_in_steps", grasp.follow_in_steps(pull(0.0), std::slice::from_ref(&leg), 1e-4).err()),
        ("equilibria", grasp.equilibria(pull(8.0)).err()),
    ];
    for (name, error) in refused {
        assert!(
            matches!(error, Some(Error::KineticFriction { question, .. }) if question == name),
            "{name}: {error:?}"
        );
    }
    // If nothing slides, only static friction matters.
    assert!(matches!(grasp.solve(pull(7.0))?, Outcome::Equilibrium(_)));
    Ok(())
}

#[test]
fn scenes_say_it_and_keep_it() {
    let text = r#"{"contacts": [
        {"name": "left", "point": [-0.1, 0], "normal": [0, 1], "stiffness": [1000, 1000], "friction": 0.5, "kinetic_friction": 0.4, "pressed_with": 10},
        {"name": "right", "point": [0.1, 0], "normal": [0, 1], "stiffness": [1000, 500], "friction": 0.5, "kinetic_friction": 0.4, "pressed_with": 10},
        {"point": [-0.1, 0.1], "normal": [0, -1], "stiffness": 1000, "pressed_with": 10},
        {"point": [0.1, 0.1], "normal": [0, -1], "stiffness": 1000, "pressed_with": 10}]}"#;
    let setup: Setup<2> = serde_json::from_str(text).unwrap();
    let again: Setup<2> = serde_json::from_str(&serde_json::to_string(&setup).unwrap()).unwrap();
    for setup in [setup, again] {
        let verdict = setup.grasp().unwrap().hold(pull(8.0)).unwrap();
        assert!(matches!(verdict.holding, Holding::Slides { .. }) && verdict.caught.len() == 1);
    }
    let refused = serde_json::from_str::<Setup<2>>(&text.replace("0.4,", "0.6,")).unwrap_err().to_string();
    assert!(refused.contains("left: kinetic friction") && refused.contains("0.6, must be"), "{refused}");
}

/// A contact that already slides at rest has kinetic friction before the load is applied.
#[test]
fn what_slides_at_rest_slides_with_less() -> Tested {
    // Dragged by 12 mm, the contact would carry 5 N by static friction; it slides and carries 4 N.
    let dragged = Contact::new([0.0, 0.0], [0.0, 1.0])
        .series_stiffness(1000.0, 1000.0)
        .friction(0.5)
        .kinetic(0.4)
        .command([0.01, 0.012]);
    let held = |y: f64, k: f64| Contact::new([0.0, y], [0.0, -1.0]).series_stiffness(k, k).bonded();
    let grasp = Grasp::new([dragged, held(0.1, 1e9), held(0.2, 1e9)])?;
    let mut path = grasp.follow(Wrench::ZERO, &[Leg::load_to(pull(0.0))])?;
    let events = path.run();
    let jump = events[0].jump.as_deref().unwrap();
    let forces = [&events[0].state, &jump.state].map(|state| state.contacts[0].force[1].abs());
    assert!((forces[0] - 5.0).abs() < 1e-5 && (forces[1] - 4.0).abs() < 1e-5, "{forces:?}");
    Ok(())
}

/// The stiffer of two feet slides first, and then has kinetic friction. It keeps this friction when the other foot begins to slide, too: `P = (μ_k +
/// μ_s) N`.
#[test]
fn what_slides_on_does_not_stick_again_at_the_limit() -> Tested {
    let weight = 9.81;
    for (mu, ratio) in [(0.6, 0.6), (0.5, 0.7), (0.3, 0.9), (0.4, 0.8)] {
        for (stiff, height) in [(5e5, 0.0), (4e5, 0.0), (5e5, 0.01)] {
            let foot =
                |x: f64, k: f64| Contact::new([x, 0.0], [0.0, 1.0]).series_stiffness(1e5, k).friction(mu);
            let plastic = foot(-0.05, stiff).kinetic(ratio * mu);
            for feet in [[plastic.clone(), foot(0.05, 2e5)], [foot(0.05, 2e5), plastic.clone()]] {
                // The pull at this height moves normal force from the plastic foot to the rubber foot.
                let limit =
                    mu * weight * (1.0 + ratio) * 0.5 / (1.0 - mu * (1.0 - ratio) * 0.5 * height / 0.05);
                let load = Wrench::force_at([2.0 * limit, 0.0], [0.0, height]);
                let verdict = Grasp::new(feet)?.hold(Ramp::load(Wrench::force([0.0, -weight]), load))?;
                assert_eq!(verdict.holds(), Some(false));
                let lost = verdict.lost.as_ref().unwrap().factor * 2.0 * limit;
                assert!((lost - limit).abs() < 1e-6 * limit, "{lost} {limit} {verdict}");
            }
        }
    }
    Ok(())
}
