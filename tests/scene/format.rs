//! A scene that is written and read back gives the same grasp, questions and answers, to the last bit.

use grasp_lcp::ask::Grasp;
use grasp_lcp::equilibrium::Outcome;
use grasp_lcp::grasp::{Contact, Motion, Twist, Wrench};
use grasp_lcp::scene::{Answer, Fingertip, FingertipPatch, Question, Scene, Setup};
use grasp_lcp::{PolygonCone, PolygonFit, Settings, planar, spatial};
use proptest::prelude::TestCaseError;
use serde_json::{Value, json};
use support::jaws::jaw;
use support::random::{Spread, for_all, scene};
use support::scene::Scene as Drawn;

/// Contacts that in turn use all ways to give stiffness, name, hold and tangent.
fn contacts<const D: usize, const C: usize>(drawn: &Drawn<D, C>) -> Vec<Contact<C>> {
    let contact = |(i, datum): (usize, &support::scene::Datum<C>)| {
        let contact = datum.contact();
        match i % 4 {
            0 => contact,
            1 => contact.body_stiffness_axes(datum.stiffness * 1.7).name("thumb \"1\"\n"),
            2 => contact
                .finger_stiffness_axes(datum.stiffness * 3.1)
                .body_stiffness_axes(datum.stiffness)
                .kept_closed(),
            _ => contact.tangent(datum.tangent).bonded().name(""),
        }
    };
    drawn.contacts.iter().enumerate().map(contact).collect()
}

/// Debug prints floats so that they read back to the same bits.
fn same(a: &impl std::fmt::Debug, b: &impl std::fmt::Debug) -> Result<(), TestCaseError> {
    let (a, b) = (format!("{a:?}"), format!("{b:?}"));
    if a == b { Ok(()) } else { Err(TestCaseError::fail(format!("{a}\n{b}"))) }
}

fn there_and_back(scene: &Scene) -> Scene {
    serde_json::from_str(&serde_json::to_string(scene).unwrap()).unwrap()
}

#[test]
fn planar_grasps_read_back_to_the_bit() {
    let draw = scene::<3, 2>(1..6, Spread::Wide, 0.05);
    for_all(file!(), 100, &draw, |drawn| {
        let grasp = planar::Grasp::new(contacts(&drawn)).unwrap();
        let Some(back) = there_and_back(&Scene::from(&grasp)).planar() else { panic!("was planar") };
        let back = back.grasp().unwrap();
        same(&grasp.contacts(), &back.contacts())?;
        same(&grasp.solve(drawn.wrench()), &back.solve(drawn.wrench()))
    });
}

#[test]
fn spatial_grasps_read_back_to_the_bit() {
    let draw = scene::<6, 3>(1..5, Spread::Wide, 0.05);
    for_all(file!(), 60, &draw, |drawn| {
        let grasp = spatial::Grasp::new(contacts(&drawn)).unwrap();
        let Some(back) = there_and_back(&Scene::from(&grasp)).spatial() else { panic!("was spatial") };
        let back = back.grasp().unwrap();
        same(&grasp.contacts(), &back.contacts())?;
        same(&grasp.solve(drawn.wrench()), &back.solve(drawn.wrench()))
    });
}

/// Checks that answers read back as they were written, agree with the answers of the grasp, and are written without `null`.
fn answers_read_back<const D: usize, const C: usize>(drawn: &Drawn<D, C>) -> Result<(), TestCaseError>
where
    Setup<C>: Into<Scene>,
{
    let load = drawn.wrench();
    // A question about first slip needs a load other than zero.
    let direction = if load == Wrench::ZERO { Wrench::from_components(&[1.0; D]) } else { load };
    let asked: Vec<Question<C>> = serde_json::from_value(json!([
        { "solve": { "load": load } },
        { "onset": { "base": load * 0.5, "direction": direction } },
        { "follow": { "start": load * 0.1, "legs": [{ "load_to": load }, { "load_by": load * -0.5 }] } },
    ]))
    .unwrap();
    let settings = Settings::default().with_step_error(1e-8).with_most_states(300);
    let mut setup = Setup::new(contacts(drawn).into_iter().map(Fingertip::from)).with_settings(settings);
    for question in asked {
        setup = setup.ask(question);
    }
    let answers = setup.answers().unwrap();
    let text = serde_json::to_string(&answers).unwrap();
    assert!(!text.contains("null"), "{text}");
    let back: Vec<Answer<C>> = serde_json::from_str(&text).unwrap();
    same(&answers, &back)?;
    let grasp = setup.grasp().unwrap();
    let direct = grasp.with(&setup.settings).solve(load).unwrap();
    let written: Value = serde_json::from_str(&text).unwrap();
    let solved = &written[0]["solve"];
    match direct.equilibrium() {
        Some(state) => {
            for (c, told) in state.contacts.iter().zip(solved["contacts"].as_array().unwrap()) {
                let force: Vec<f64> = serde_json::from_value(told["force"].clone()).unwrap();
                same(&c.force.as_slice(), &force.as_slice())?;
            }
        }
        None => assert!(solved["outcome"] != "equilibrium"),
    }
    only_equilibria_have_forces(&written);
    // The scene as text has the same answers.
    let scene: Scene = setup.into();
    same(&serde_json::to_string(&there_and_back(&scene).answers().unwrap()).unwrap(), &text)
}

/// Checks that objects with a twist have residuals, and that others have no forces.
fn only_equilibria_have_forces(value: &Value) {
    match value {
        Value::Array(list) => list.iter().for_each(only_equilibria_have_forces),
        Value::Object(fields) => {
            assert_eq!(fields.contains_key("twist"), fields.contains_key("residuals"), "{value}");
            let outcome = fields.get("outcome").and_then(Value::as_str);
            if matches!(outcome, Some("no_equilibrium" | "undecided" | "never" | "no_base" | "gives_way")) {
                let shown = ["twist", "force", "state"].into_iter().find(|f| fields.contains_key(*f));
                assert!(shown.is_none(), "{value}");
            }
            fields.values().for_each(only_equilibria_have_forces);
        }
        _ => {}
    }
}

#[test]
fn planar_answers_read_back_to_the_bit() {
    let draw = scene::<3, 2>(1..5, Spread::Wide, 0.1);
    for_all(file!(), 60, &draw, |drawn| answers_read_back(&drawn));
}

#[test]
fn spatial_answers_read_back_to_the_bit() {
    let draw = scene::<6, 3>(1..4, Spread::Narrow, 0.05);
    for_all(file!(), 8, &draw, |drawn| answers_read_back(&drawn));
}

/// A motion of a hand is written with the motions of its joints. A load is refused if it has joints.
#[test]
fn motions_of_hands_read_back_with_their_joints() {
    let written = json!({ "translation": [1.0, 0.0], "rotation": 0.1, "joints": [1e-300, 1.0 / 3.0] });
    let motion: Motion<2> = serde_json::from_value(written.clone()).unwrap();
    assert_eq!(motion.joints, [1e-300, 1.0 / 3.0]);
    assert_eq!(serde_json::to_value(&motion).unwrap(), written);
    let without: Motion<2> = serde_json::from_value(json!({ "translation": [1.0, 0.0] })).unwrap();
    assert_eq!(without.joints, [0.0; 0]);
    let refused = serde_json::from_value::<planar::Wrench>(json!({ "joints": [1] })).unwrap_err().to_string();
    assert!(refused.contains("joints"), "{refused}");
}

#[test]
fn what_is_left_out_has_the_defaults_of_the_crate() {
    let scene: Scene = serde_json::from_value(json!({
        "format": "grasp-lcp/1",
        "planar": { "contacts": [{ "point": [1, 2], "normal": [-1, 0], "finger_stiffness": [10, 20] }] }
    }))
    .unwrap();
    let Some(setup) = scene.planar() else { panic!("is planar") };
    assert_eq!(setup.contacts[0].contact, Contact::new([1.0, 2.0], [-1.0, 0.0]).finger_stiffness(10.0, 20.0));
    assert_eq!(setup.settings, Settings::default());
    assert!(setup.questions.is_empty() && setup.outline.is_empty() && scene.id.is_none());
    // Fields with default values are not written.
    let written = serde_json::to_string(&scene).unwrap();
    let expected = r#"{"format":"grasp-lcp/1","planar":{"contacts":[{"point":[1.0,2.0],"normal":[-1.0,0.0],"finger_stiffness":[10.0,20.0]}]}}"#;
    assert_eq!(written, expected);
}

#[test]
fn settings_are_those_of_the_crate() {
    let settings: Settings = serde_json::from_value(json!({
        "cone": "polygon", "polygon": { "facets": 12, "fit": "balanced" },
        "max_pivots": 40, "most_states": 100, "step_error": 1e-7
    }))
    .unwrap();
    let expected = Settings::default()
        .with_cone(PolygonCone::new(12, PolygonFit::Balanced).unwrap())
        .on_the_polygon()
        .with_max_pivots(40)
        .with_most_states(100)
        .with_step_error(1e-7);
    assert_eq!(settings, expected);
    let back: Settings = serde_json::from_str(&serde_json::to_string(&settings).unwrap()).unwrap();
    assert_eq!(back, expected);
}

#[test]
fn stiffness_and_commands_are_said_in_several_ways() {
    let inf = f64::INFINITY;
    let contact = || spatial::Contact::new([1.0, 0.0, 0.0], [-1.0, 0.0, 0.0]);
    let cases = [
        (json!({ "series_stiffness": [5, 4] }), contact().series_stiffness(5.0, 4.0)),
        (json!({ "series_stiffness": [5, 4, 3] }), contact().series_stiffness_axes([5.0, 4.0, 3.0])),
        (
            json!({ "body_stiffness": "rigid", "finger_stiffness": [5, 4, 3] }),
            contact().finger_stiffness_axes([5.0, 4.0, 3.0]),
        ),
        (
            json!({ "body_stiffness": [7, "rigid"], "finger_stiffness": ["rigid", 3] }),
            contact().body_stiffness(7.0, inf).finger_stiffness(inf, 3.0),
        ),
        (
            json!({ "series_stiffness": [5, 4], "command": [3, 2, 1], "clearance": -0.5 }),
            contact().series_stiffness(5.0, 4.0).command([3.0, 2.0, 1.0]).clearance(-0.5),
        ),
        (
            json!({ "series_stiffness": [5, 4], "command_world": [3, 2, 1] }),
            contact().series_stiffness(5.0, 4.0).command_world([3.0, 2.0, 1.0]),
        ),
        (
            json!({ "series_stiffness": [5, 4], "command_world": [0, 0, 0] }),
            contact().series_stiffness(5.0, 4.0).command_world([0.0; 3]),
        ),
    ];
    for (said, expected) in cases {
        let mut entry = json!({ "point": [1, 0, 0], "normal": [-1, 0, 0] });
        entry.as_object_mut().unwrap().extend(said.as_object().unwrap().clone());
        let finger: Fingertip<3> = serde_json::from_value(entry).unwrap();
        assert_eq!(finger.contact, expected);
        let back: Fingertip<3> = serde_json::from_value(serde_json::to_value(&finger).unwrap()).unwrap();
        assert_eq!(back, finger);
    }
}

#[test]
fn a_force_may_act_anywhere() {
    let plane: Wrench<2> =
        serde_json::from_value(json!({ "force": [1, -2], "moment": 0.5, "at": [3, 4] })).unwrap();
    assert_eq!(plane, Wrench::<2>::force_at([1.0, -2.0], [3.0, 4.0]) + Wrench::<2>::new([0.0; 2], 0.5));
    let space: Wrench<3> = serde_json::from_value(json!({ "force": [1, -2, 3], "at": [4, 5, 7] })).unwrap();
    assert_eq!(space, Wrench::<3>::force_at([1.0, -2.0, 3.0], [4.0, 5.0, 7.0]));
    assert_eq!(serde_json::from_str::<Wrench<3>>("{}").unwrap(), Wrench::ZERO);
}

#[test]
fn what_is_not_finite_is_said_in_words() {
    let twist = Twist::<2>::from_vector([f64::NAN, f64::INFINITY, f64::NEG_INFINITY]);
    let text = serde_json::to_string(&twist).unwrap();
    assert_eq!(text, r#"{"translation":["not a number","infinite"],"rotation":"-infinite"}"#);
    let back: Twist<2> = serde_json::from_str(&text).unwrap();
    assert!(back.translation()[0].is_nan() && back.rotation() == f64::NEG_INFINITY);
    // In a force, a word in place of a number is refused.
    for word in ["infinite", "rigid", "not a number"] {
        assert!(serde_json::from_value::<Wrench<2>>(json!({ "force": [0, word] })).is_err());
    }
    let endless = planar::Contact::new([0.0, 0.0], [0.0, 1.0])
        .series_stiffness(10.0, 10.0)
        .friction(f64::INFINITY)
        .command([0.1, 0.0])
        .kept_closed();
    let guide = endless.clone().tangent([1.0, 0.0]).name("guide");
    let grasp = planar::Grasp::new([endless, guide.bonded()]).unwrap();
    let scene: Scene = Setup::from(&grasp).ask(Question::solve(Wrench::ZERO)).into();
    let answers = serde_json::to_value(there_and_back(&scene).answers().unwrap()).unwrap();
    assert_eq!(answers[0]["solve"]["contacts"][0]["margin"], "infinite");
}

/// A soft fingertip in a scene gives the contacts of the library's soft fingertip. Its points have the command of their contact.
#[test]
fn soft_fingertips_are_spread() {
    let finger = |x: f64| jaw::<3>(x, [2000.0, 1000.0], 0.5).command([0.005, 0.0, 0.0]);
    let patch = spatial::SoftFingertip::disc(0.006, 1, 4, spatial::Pressure::Hertz).unwrap();
    let tip =
        FingertipPatch::Disc { radius: 0.006, annuli: 1, points: 4, pressure: spatial::Pressure::Hertz };
    let squeeze = json!([{ "onset": { "direction": { "moment": [0.01, 0, 0] }, "command_change": [[0.001, 0, 0], [0, 0, 0]] } }]);
    let squeeze: Vec<Question<3>> = serde_json::from_value(squeeze).unwrap();
    let soft = Fingertip::from(finger(-0.03).name("thumb")).soft(tip);
    let setup = Setup::new([soft, finger(0.03).into()]).ask(squeeze[0].clone());

    let mut points = patch.contacts(&finger(-0.03).name("thumb")).unwrap();
    points.push(finger(0.03));
    let grasp = Grasp::<3>::new(points).unwrap();
    let mut change = vec![nalgebra::Vector3::new(0.001, 0.0, 0.0); 8];
    change.push(nalgebra::Vector3::zeros());
    let ramp = spatial::Ramp::load(Wrench::ZERO, spatial::Wrench::new([0.0; 3], [0.01, 0.0, 0.0]));
    let expected = grasp.onset(ramp.with_commands(change)).unwrap();

    let Some(back) = there_and_back(&setup.clone().into()).spatial() else { panic!("was spatial") };
    assert_eq!(back, setup);
    assert_eq!(back.grasp().unwrap().contacts(), grasp.contacts());
    let answers = Scene::from(back).answers().unwrap();
    assert_eq!(answers.clone().spatial().expect("in space").len(), 1);
    let answer = serde_json::to_value(&answers).unwrap();
    assert_eq!(answer[0]["onset"]["factor"], expected.factor().unwrap());
    let touch = &answer[0]["onset"]["state"]["contacts"];
    assert_eq!(
        (&touch[3]["contact"], &touch[3]["point"], &touch[3]["name"]),
        (&json!(0), &json!(3), &json!("thumb"))
    );
    assert_eq!((&touch[8]["contact"], touch[8].get("point")), (&json!(1), None));
}

/// A rectangle has one strip in half of each side unless the scene says otherwise.
#[test]
fn rectangular_pads_are_spread() {
    let contact = |soft: &str| {
        let told = format!(
            r#"{{"point": [0, 0, 0], "normal": [0, 0, 1], "series_stiffness": [2e3, 1e3], "soft": {{"rectangle": {soft}}}}}"#
        );
        serde_json::from_str::<Fingertip<3>>(&told)
    };
    let (sides, finger) =
        ([0.02, 0.012], spatial::Contact::new([0.0; 3], [0.0, 0.0, 1.0]).series_stiffness(2e3, 1e3));
    for (soft, strips) in
        [(r#"{"sides": [0.02, 0.012]}"#, [1, 1]), (r#"{"sides": [0.02, 0.012], "strips": [2, 1]}"#, [2, 1])]
    {
        let tip = contact(soft).unwrap();
        assert_eq!(tip.soft, Some(FingertipPatch::Rectangle { sides, strips }));
        let grasp = Setup::new([tip]).grasp().unwrap();
        let expected = Grasp::<3>::new(
            spatial::SoftFingertip::rectangle(sides, strips).unwrap().contacts(&finger).unwrap(),
        );
        assert_eq!(grasp.contacts(), expected.unwrap().contacts());
    }
    assert!(contact(r#"{"sides": [0.02]}"#).unwrap_err().to_string().contains('2'));
}

/// An answer of a grasp in Rust is written like the answer of its scene, which adds `accuracy` and `distinct`. After reading, an answer has only the
/// written data.
#[test]
fn an_answer_that_was_read_has_nothing_more_to_say() {
    let jaw = |side: f64| jaw::<2>(side, [1e3, 8e2], 0.5);
    let grasp = planar::Grasp::new([-1.0, 1.0].map(|side| jaw(side).pressed_with(8.0).name("jaw"))).unwrap();
    let load = planar::Wrench::force([0.0, -4.0]);
    let outcome = grasp.solve(load).unwrap();
    let written = serde_json::to_value(&outcome).unwrap();
    let setup = Setup::from(&grasp).ask(Question::solve(load));
    let mut told = serde_json::to_value(setup.answers().unwrap()).unwrap()[0]["solve"].take();
    assert!(told.as_object_mut().unwrap().remove("accuracy").is_some());
    for contact in told["contacts"].as_array_mut().unwrap() {
        assert_eq!(contact.as_object_mut().unwrap().remove("distinct"), Some(json!(true)));
    }
    assert_eq!(written, told);

    let back: Outcome<2> = serde_json::from_value(written).unwrap();
    let (state, back) = (outcome.equilibrium().unwrap(), back.equilibrium().unwrap());
    assert_eq!((&state.contacts, &state.residuals), (&back.contacts, &back.residuals));
    assert_eq!(back.contacts[1].contact.text(), "jaw");
    assert!(grasp.accuracy(state).is_some() && grasp.accuracy(back).is_none());
    assert!(grasp.distinct(state).is_some() && grasp.distinct(back).is_none());
}
