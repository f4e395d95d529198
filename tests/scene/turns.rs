//! Loads that turn can be written in scenes in every documented way, read back as they were written, and have the same answers as in Rust.

use std::f64::consts::{FRAC_PI_2, TAU};

use grasp_lcp::ask::Grasp;
use grasp_lcp::grasp::{HandPart, Wrench};
use grasp_lcp::load_path::{EdgeOf, EdgeTouch, Leg, Turn};
use grasp_lcp::planar::hand::{self, Hand, Joint};
use grasp_lcp::scene::{Answer, Fingertip, OnsetAnswer, PathOutcome, Question, Scene, Setup, TurnAnswer};
use grasp_lcp::{Limit, planar, spatial};
use proptest::prelude::TestCaseError;
use serde_json::{Value, json};
use support::jaws::jaw;
use support::random::{Spread, for_all, scene as random_scene};
use support::scene::Scene as Drawn;

type Tested = Result<(), Box<dyn std::error::Error>>;

#[test]
fn each_way_to_say_a_turn_in_the_plane_is_one_of_the_crate() -> Tested {
    let (force, at) = ([1.5, -2.0], [0.25, 0.75]);
    let cable = planar::Wrench::new([0.5, 0.25], -0.125);
    let [weight, turned] = [planar::Turn::tilting(force, at), planar::Turn::force_at(force, at)];
    let (one, other) = (planar::Wrench::force([1.0, 2.0]), planar::Wrench::new([0.0, 3.0], 0.5));
    for (said, expected) in [
        (json!({ "weight": force, "at": at }), weight),
        (json!({ "force": force, "at": at }), turned),
        (json!({ "weight": force, "at": at, "reversed": true }), turned),
        (json!({ "weight": force, "at": at, "reversed": false, "angle_rad": 9.5 }), weight.up_to(9.5)),
        (json!({ "force": force, "at": at, "beside": cable }), turned.beside(cable)),
        (json!({ "force": force }), planar::Turn::force_at(force, [0.0; 2])),
        (json!({ "constant": cable, "cosine": one, "sine": other }), planar::Turn::new(cable, one, other)),
        (json!({ "sine": other }), planar::Turn::new(Wrench::ZERO, Wrench::ZERO, other)),
    ] {
        assert_eq!(serde_json::from_value::<planar::Turn>(said.clone())?, expected, "{said}");
    }
    Ok(())
}

#[test]
fn each_way_to_say_a_turn_in_space_is_one_of_the_crate() -> Tested {
    let (force, at, axis) = ([1.5, -2.0, 0.7], [0.25, 0.75, -0.3], [1.0, 2.0, -3.0]);
    let [weight, turned] =
        [spatial::Turn::tilting(force, at, axis)?, spatial::Turn::force_at(force, at, axis)?];
    let cable = spatial::Wrench::force([0.5, 0.25, 0.125]);
    for (said, expected) in [
        (json!({ "weight": force, "at": at, "axis": axis }), weight),
        (json!({ "force": force, "at": at, "axis": axis, "angle_rad": 2 }), turned.up_to(2.0)),
        (json!({ "weight": force, "at": at, "axis": axis, "beside": cable }), weight.beside(cable)),
        (json!({ "cosine": cable }), spatial::Turn::new(Wrench::ZERO, cable, Wrench::ZERO)),
    ] {
        assert_eq!(serde_json::from_value::<spatial::Turn>(said.clone())?, expected, "{said}");
    }
    Ok(())
}

/// Debug prints floats so that they read back to the same bits.
fn same(a: &impl std::fmt::Debug, b: &impl std::fmt::Debug) -> Result<(), TestCaseError> {
    let (a, b) = (format!("{a:?}"), format!("{b:?}"));
    if a == b { Ok(()) } else { Err(TestCaseError::fail(format!("{a}\n{b}"))) }
}

/// A setup that asks for the first slip under a turning load, and for a load path with the same turn.
fn turned<const D: usize, const C: usize>(drawn: &Drawn<D, C>) -> (Setup<C>, Turn<C>) {
    let load = drawn.wrench();
    let turn = Turn::new(
        load * 0.5,
        load * 0.25,
        Wrench::from_components(&load.components().iter().map(|x| x * x).collect::<Vec<_>>()),
    )
    .up_to(5.0);
    let setup = Setup::new(drawn.contacts.iter().map(|datum| Fingertip::from(datum.contact())));
    let legs = vec![Leg::turn(&turn), Leg::load_to(turn.load_at(0.0)), Leg::turn(&turn.reversed())];
    let follow = Question::Follow { start: turn.load_at(0.0), legs, in_steps: None };
    (setup.ask(Question::OnsetOfTurn(turn)).ask(follow), turn)
}

/// Checks that setup and answers read back to the last bit, and that the answers equal the answers of the grasp.
fn read_back_and_answered<const D: usize, const C: usize>(drawn: &Drawn<D, C>) -> Result<(), TestCaseError> {
    let (setup, turn) = turned(drawn);
    let back: Setup<C> = serde_json::from_str(&serde_json::to_string(&setup).unwrap()).unwrap();
    same(&setup, &back)?;
    let answers = back.answers().unwrap();
    let text = serde_json::to_string(&answers).unwrap();
    same(&answers, &serde_json::from_str::<Vec<Answer<C>>>(&text).unwrap())?;
    let written: Value = serde_json::from_str(&text).unwrap();

    let grasp: Grasp<C> = setup.grasp().unwrap();
    let direct = grasp.onset_of_turn(turn).unwrap();
    let told = &written[0]["onset_of_turn"];
    same(&told["angle_rad"].as_f64(), &direct.onset.factor().filter(|angle| angle.is_finite()))?;
    assert!(told.get("factor").is_none(), "{told}");
    same(&told["touches"].as_array().map(Vec::len), &Some(direct.touches.len()))?;
    let legs = [Leg::turn(&turn), Leg::load_to(turn.load_at(0.0)), Leg::turn(&turn.reversed())];
    let events = grasp.follow(turn.load_at(0.0), &legs).unwrap().run();
    let places: Vec<_> = events.iter().map(|event| (event.leg, event.fraction)).collect();
    let of = |event: &Value| {
        (usize::try_from(event["leg"].as_u64().unwrap()).unwrap(), event["fraction"].as_f64().unwrap())
    };
    let told: Vec<_> = written[1]["follow"]["events"].as_array().unwrap().iter().map(of).collect();
    same(&told, &places)
}

#[test]
fn planar_turns_read_back_to_the_bit_and_are_answered_as_by_calls() {
    let draw = random_scene::<3, 2>(1..5, Spread::Narrow, 0.1);
    for_all(file!(), 60, &draw, |drawn| read_back_and_answered(&drawn));
}

#[test]
fn spatial_turns_read_back_to_the_bit_and_are_answered_as_by_calls() {
    let draw = random_scene::<6, 3>(2..4, Spread::Narrow, 0.05);
    for_all(file!(), 8, &draw, |drawn| read_back_and_answered(&drawn));
}

fn answers_of(scene: Value) -> Result<Vec<Answer<2>>, Box<dyn std::error::Error>> {
    serde_json::from_value::<Scene>(scene)?.answers()?.planar().ok_or("planar".into())
}

fn palm(x: f64) -> Value {
    json!({ "name": if x < 0.0 { "left" } else { "right" }, "point": [x, 0.0], "normal": [-x, 0.0],
        "series_stiffness": [1000.0, 800.0], "friction": 0.5, "pressed_with": 10.0 })
}

/// A box of 12 N whose weight starts horizontal slides on the left palm at 6 sin θ + 3 cos θ = 5.
#[test]
fn a_box_slides_at_the_angle_of_its_closed_form() -> Tested {
    let slides = (5.0 / 45_f64.sqrt()).asin() - 3_f64.atan2(6.0);
    let answers = answers_of(json!({ "format": "grasp-lcp/1", "planar": {
        "contacts": [palm(-1.0), palm(1.0)],
        "questions": [
            { "onset_of_turn": { "force": [12, 0] } },
            { "onset_of_turn": { "force": [12, 0], "angle_rad": slides - 1e-9 } },
            { "follow": { "start": { "force": [12, 0] }, "legs": [{ "turn": { "force": [12, 0], "angle_rad": 0.5 } }] } }
        ]
    }}))?;
    let [Answer::OnsetOfTurn(onset), Answer::OnsetOfTurn(never), Answer::Follow(path)] = &answers[..] else {
        return Err(format!("{answers:?}").into());
    };
    let OnsetAnswer::At(event) = &onset.onset else { return Err(format!("{onset:?}").into()) };
    assert!((event.at.angle - slides).abs() < 1e-15);
    assert_eq!(event.leaving[0].contact.name.as_deref(), Some("left"));
    assert_eq!((&never.onset, never.touches.len()), (&OnsetAnswer::Never, 0));
    // Both palms carry the same tangential force. So the box is lost when the left palm slides.
    let PathOutcome::Lost { loss, .. } = &path.end else { return Err(format!("{path:?}").into()) };
    assert!((loss.fraction * 0.5 - slides).abs() < 1e-15);
    assert!((loss.load.resultant()[1] - 12.0 * slides.sin()).abs() < 1e-13);
    Ok(())
}

/// The heaviest box that never slides just reaches the friction limit of a palm: the largest value of w/2 sin θ + w/4 cos θ is 5.
#[test]
fn an_edge_that_is_touched_is_told_by_the_name_of_its_contact() -> Tested {
    let weight = 20.0 / 5_f64.sqrt();
    let answers = answers_of(json!({ "format": "grasp-lcp/1", "planar": {
        "contacts": [palm(-1.0), palm(1.0)],
        "questions": [{ "onset_of_turn": { "force": [weight, 0], "angle_rad": 2.0 } }]
    }}))?;
    let [Answer::OnsetOfTurn(TurnAnswer { onset: OnsetAnswer::Never, touches, .. })] = &answers[..] else {
        return Err(format!("{answers:?}").into());
    };
    let written = serde_json::to_value(touches)?;
    assert_eq!((&written[0]["contact"], &written[0]["name"]), (&json!(0), &json!("left")));
    assert!((written[0]["angle_rad"].as_f64().ok_or("a number")? - 2_f64.atan()).abs() < 1e-6);
    Ok(())
}

/// Jaws that each close by a command of 4 mm with a compliance of 1.1 mm/N. Their motors stall at 6 N.
fn jaws() -> Value {
    let jaw = |side: f64| {
        json!({
            "joints": [{ "prismatic": [-side, 0.0], "stiffness": 1000, "command": 0.004, "limit": { "saturates": 6 } }],
            "contacts": [{ "point": [side, 0.0], "normal": [-side, 0.0], "series_stiffness": [1e4, 1e4], "friction": 0.5 }]
        })
    };
    json!([jaw(-1.0), jaw(1.0)])
}

#[test]
fn a_limit_that_is_touched_is_told_by_its_joint() -> Tested {
    // Under a pull W one jaw carries 4/1.1 N + W/2. Under this pull in either direction a jaw just reaches 6 N, up to rounding, and no motor stalls.
    let pull = 2.0 * (6.0 - 4.0 / 1.1) * (1.0 - 1e-14);
    let answers = answers_of(json!({ "format": "grasp-lcp/1", "planar": {
        "fingers": jaws(),
        "questions": [{ "onset_of_turn": { "sine": { "force": [pull, 0] } } }]
    }}))?;
    let [Answer::OnsetOfTurn(TurnAnswer { onset: OnsetAnswer::Never, touches, .. })] = &answers[..] else {
        return Err(format!("{answers:?}").into());
    };
    let joint = |touch: &EdgeTouch| match &touch.of {
        EdgeOf::Drive(part) => Some(part.part),
        _ => None,
    };
    let joints: Vec<_> = touches.iter().map(joint).collect();
    assert_eq!(joints, [Some(HandPart::Joint(0)), Some(HandPart::Joint(1))], "{touches:?}");
    for (touch, angle) in touches.iter().zip([TAU - FRAC_PI_2, FRAC_PI_2]) {
        assert!((touch.angle - angle).abs() < 1e-6, "{touch:?}");
    }
    assert_eq!(serde_json::to_value(touches)?[1]["joint"], 1);
    Ok(())
}

#[test]
fn turns_on_hands_are_answered_as_by_calls() -> Tested {
    let turn = json!({ "sine": { "force": [5, 0] }, "angle_rad": 4 });
    let answers = answers_of(json!({ "format": "grasp-lcp/1", "planar": {
        "fingers": jaws(),
        "questions": [{ "onset_of_turn": turn }, { "follow": { "legs": [{ "turn": turn }] } }]
    }}))?;
    let jaw = |side: f64| {
        let pad = jaw::<2>(side, [1e4, 1e4], 0.5);
        let slide = Joint::prismatic([-side, 0.0]).stiffness(1e3).command(0.004).limit(Limit::Saturates(6.0));
        hand::Finger::new([slide]).contact(pad)
    };
    let grasp: planar::Grasp = Hand::new([jaw(-1.0), jaw(1.0)]).grasp()?;
    let turn = planar::Turn::new(Wrench::ZERO, Wrench::ZERO, planar::Wrench::force([5.0, 0.0])).up_to(4.0);
    let direct = grasp.onset_of_turn(turn)?.onset;
    let [Answer::OnsetOfTurn(TurnAnswer { onset: OnsetAnswer::At(event), .. }), Answer::Follow(path)] =
        &answers[..]
    else {
        return Err(format!("{answers:?}").into());
    };
    assert!((event.at.angle - direct.factor().ok_or("stalls")?).abs() < 1e-14);
    assert!((event.at.angle - (2.0 * (6.0 - 4.0 / 1.1) / 5.0_f64).asin()).abs() < 1e-13);
    assert_eq!(event.drives[0].part.part, HandPart::Joint(1));
    let events = grasp.follow(Wrench::ZERO, &[planar::Leg::turn(&turn)])?.run();
    assert!(events.len() > 1 && events.len() == path.events.len());
    for (told, direct) in path.events.iter().zip(&events) {
        assert!((told.fraction - direct.fraction).abs() < 1e-14);
        assert_eq!(told.drives.len(), direct.drives.len());
    }
    Ok(())
}
