//! Scenes can describe suction as a cup with its lip, or as a vacuum force within a pad.

use grasp_lcp::scene::{Answer, Cup, Fingertip, OnsetAnswer, Scene, Setup};
use grasp_lcp::spatial::{Contact, SuctionCup};
use serde_json::{Value, json};

fn with(contact: &Value) -> Result<Scene, serde_json::Error> {
    let mut cup = json!({ "name": "lip", "point": [0, 0, 0], "normal": [0, 0, -1], "series_stiffness": [6000, 3000], "friction": 0.5 });
    cup.as_object_mut().expect("an object").extend(contact.as_object().expect("an object").clone());
    let pad = |name: &str, y: f64| json!({ "name": name, "point": [0, y, 0], "normal": [0, 0, -1], "series_stiffness": [30000, 15000], "friction": 0.8 });
    let weight = json!({ "force": [0, 0, -19.62] });
    let questions = json!([
        { "onset": { "base": weight, "direction": { "force": [1, 0, 0] } } },
        { "onset": { "base": weight, "direction": { "force": [1, 0, 0], "at": [0, 0, -0.01] } } },
        { "onset": { "direction": { "force": [0, 0, -1], "at": [0.05, 0, -0.01] } } }
    ]);
    let contacts = json!([cup, pad("pad l", -0.05), pad("pad r", 0.05)]);
    serde_json::from_value(
        json!({ "format": "grasp-lcp/1", "spatial": { "contacts": contacts, "questions": questions } }),
    )
}

fn onsets(scene: &Scene) -> Vec<f64> {
    let Some(answers) = scene.answers().expect("answers").spatial() else { panic!("in space") };
    let factor = |answer: &Answer<3>| match answer {
        Answer::Onset(OnsetAnswer::At(event)) => event.at.factor,
        other => panic!("{other:?}"),
    };
    answers.iter().map(factor).collect()
}

/// A scene has a cup and two friction pads on a plate of 2 kg. Its numbers are those of a plate on a ring of contacts, with the vacuum of 62.83 N as
/// a load.
#[test]
fn a_cup_holds_what_its_vacuum_does_as_a_load() {
    let cases = [
        json!({ "suction": { "radius": 0.02, "pressure": 50000 } }),
        json!({ "suction": { "radius": 0.02, "points": 12, "force": 62.831_853_071_795_86 } }),
        json!({ "suction": 62.831_853_071_795_86, "soft": { "ring": { "radius": 0.02, "points": 12 } } }),
    ];
    for case in &cases {
        let scene = with(case).expect("a scene");
        let expected = [21.605_926_535_898, 3.323_988_697_830, 1.121_997_376_282];
        for (found, expected) in onsets(&scene).into_iter().zip(expected) {
            assert!((found - expected).abs() < 1e-11, "{case}: {found} {expected}");
        }
        let written = serde_json::to_value(&scene).expect("is written");
        let back: Scene = serde_json::from_value(written.clone()).expect("is read");
        assert_eq!(back, scene, "{written}");
        assert_eq!(written["spatial"]["contacts"][0]["suction"].is_number(), case["suction"].is_number());
    }
}

#[test]
fn a_cup_is_the_one_of_the_crate() {
    let lip = Contact::new([0.0; 3], [0.0, 0.0, -1.0]).name("lip").series_stiffness(8e3, 4e3).friction(0.5);
    let setup = Setup::<3>::new([Fingertip::from(lip.clone()).with_cup(Cup::of_pressure(0.02, 6e4))]);
    let expected = SuctionCup::of_pressure(0.02, 12, 6e4).unwrap().contacts(&lip).unwrap();
    assert_eq!(
        setup.grasp().unwrap().contacts(),
        grasp_lcp::spatial::Grasp::new(expected).unwrap().contacts()
    );
    // If a grasp is written as a scene, every point of the lip has its part of the vacuum.
    let scene = Scene::from(&setup.grasp().unwrap());
    let back: Scene = serde_json::from_value(serde_json::to_value(&scene).unwrap()).unwrap();
    let Some(points) = back.spatial() else { panic!("in space") };
    let load = grasp_lcp::spatial::Wrench::force([3.0, 0.0, -20.0]);
    let [one, other] =
        [points.grasp().unwrap(), setup.grasp().unwrap()].map(|grasp| grasp.solve(load).unwrap());
    let forces = |outcome: &grasp_lcp::spatial::Outcome| {
        outcome.equilibrium().unwrap().contacts.iter().map(|c| c.force).collect::<Vec<_>>()
    };
    assert_eq!(forces(&one), forces(&other));
}

#[test]
fn what_is_no_cup_is_told() {
    let cases = [
        (json!({ "suction": { "radius": 0.02 } }), "pressure or a force"),
        (json!({ "suction": { "radius": 0.02, "pressure": 1, "force": 1 } }), "pressure or a force"),
        (json!({ "suction": { "radius": 0, "force": 1 } }), "fingertip: radius is 0"),
        (json!({ "suction": { "radius": 0.02, "pressure": -1 } }), "vacuum is -1"),
        (json!({ "suction": -5 }), "lip: suction is -5"),
        (json!({ "suction": "60 kPa" }), "a force, N, "),
        (
            json!({ "suction": { "radius": 0.02, "force": 1 }, "soft": { "ring": { "radius": 0.02, "points": 6 } } }),
            "soft and suction: ",
        ),
    ];
    for (contact, expected) in cases {
        let told = with(&contact).expect_err("refused").to_string();
        assert!(told.contains(expected), "{told}");
    }
    let planar = r#"{"format": "grasp-lcp/1", "planar": {"contacts": [{"point": [0, 0], "normal": [0, 1], "series_stiffness": [1, 1], "suction": {"radius": 1, "force": 1}}]}}"#;
    let told = serde_json::from_str::<Scene>(planar).expect_err("no ring").to_string();
    assert!(told.contains("number of axes") && told.contains("is 3, must"), "{told}");
}

/// A cup of 60 N holds a body of 19.62 N. A force of 10 N to the side slides it at μ = 0.5 with less than 39.62 N of vacuum, the number to enter, not
/// with the 20 N by which the lip presses then.
#[test]
fn the_vacuum_that_is_needed_under_gravity() {
    let scene: Scene = serde_json::from_str(
        r#"{ "format": "grasp-lcp/1", "spatial": {
            "bodies": [{ "name": "plate", "mass": 2, "centre_of_mass": [0, 0, -0.01] }], "gravity": [0, 0, -9.81],
            "contacts": [{ "name": "cup", "on": "plate", "point": [0, 0, 0], "normal": [0, 0, -1], "stiffness": 1e5, "friction": 0.5, "suction": { "radius": 0.02, "force": 60 } }],
            "questions": [{ "need": { "quantity": "squeeze", "load": { "force": [10, 0, 0] } } }] } }"#,
    )
    .expect("a scene");
    let Some(answers) = scene.answers().expect("answers").spatial() else { panic!("in space") };
    let Answer::Need(needed) = &answers[0] else { panic!("{answers:?}") };
    assert!(needed.needed.to_string().contains(" kPa (39.62 N) at cup"), "{}", needed.needed);
}
