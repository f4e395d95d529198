//! Scenes of several bodies: read, written, refused, and the same as in Rust.

use grasp_lcp::planar::{Bodies, Body, Contact, Wrench};
use grasp_lcp::scene::{Scene, Space};

const BOXES: &str = r#"{
    "format": "grasp-lcp/1",
    "planar": {
        "bodies": [
            { "name": "lower", "mass": 2, "centre_of_mass": [0, 0.1] },
            { "name": "upper", "load": { "force": [0, -10], "at": [0, 0.3] }, "outline": [[-0.1, 0.2], [0.1, 0.2], [0, 0.4]] }
        ],
        "gravity": [0, -10],
        "loaded": "upper",
        "contacts": [
            { "on": "lower", "point": [-0.1, 0], "normal": [0, 1], "stiffness": 100000, "friction": 0.5 },
            { "on": "lower", "point": [0.1, 0], "normal": [0, 1], "stiffness": 100000, "friction": 0.5 },
            { "on": "upper", "against": "lower", "point": [0, 0.2], "normal": [0, 1], "stiffness": 100000, "friction": 0.3, "soft": { "pair": { "width": 0.2 } } }
        ],
        "questions": [{ "hold": { "load": { "force": [6, 0], "at": [0, 0.2] } } }]
    }
}"#;

fn says(text: &str) -> String {
    let scene: Scene = serde_json::from_str(text).expect("a scene");
    let answers = serde_json::to_value(scene.answers().expect("well posed")).expect("written");
    answers[0]["hold"]["says"].as_str().expect("a sentence").to_owned()
}

#[test]
fn a_scene_is_the_bodies_that_it_says() {
    let at =
        |x: f64, y: f64, mu: f64| Contact::new([x, y], [0.0, 1.0]).series_stiffness(1e5, 1e5).friction(mu);
    let half = |x: f64| Contact::new([x, 0.2], [0.0, 1.0]).series_stiffness(5e4, 5e4).friction(0.3);
    let grasp = Bodies::new([
        Body::new("lower").mass(2.0, [0.0, 0.1]),
        Body::new("upper").load(Wrench::force_at([0.0, -10.0], [0.0, 0.3])),
    ])
    .gravity([0.0, -10.0])
    .loaded("upper")
    .contacts([at(-0.1, 0.0, 0.5), at(0.1, 0.0, 0.5)].map(|contact| contact.on("lower")))
    .contacts([half(-0.1), half(0.1)].map(|contact| contact.on("upper").against("lower")))
    .grasp()
    .expect("well posed");
    let verdict = grasp.hold(Wrench::force_at([6.0, 0.0], [0.0, 0.2])).expect("well posed");
    assert!((verdict.lost.as_ref().expect("slides").factor - 0.5).abs() < 1e-12);
    assert!(says(BOXES).starts_with("SLIPS OUT at 3 N of 6 N: upper moves along +x"), "{}", says(BOXES));
}

/// The lower box is pulled one way and the upper one the other, twice as hard: it slides at 3 N.
#[test]
fn loads_of_bodies_grow_together() {
    let hold = r#"{ "hold": { "load": { "force": [6, 0], "at": [0, 0.2] } } }"#;
    let growing = |more: &str| {
        let asked = format!(
            r#"{{ "hold": {{ "load": {{ "force": [6, 0], "at": [0, 0.2] }}, "together_with": {{ "lower": {{ "force": [-12, 0], "at": [0, 0.1] }} }}{more} }} }}"#
        );
        BOXES.replacen(hold, &asked, 1)
    };
    assert!(
        says(&growing("")).starts_with("SLIPS OUT at 3 N of 6 N: upper moves along +x"),
        "{}",
        says(&growing(""))
    );
    let scene: Scene = serde_json::from_str(&growing("")).expect("a scene");
    let written = serde_json::to_string(&scene).expect("written");
    assert_eq!(serde_json::from_str::<Scene>(&written).expect("a scene"), scene);
    let refused = |text: &str| serde_json::from_str::<Scene>(text).expect_err("refused").to_string();
    let told = [
        (
            growing(r#", "base": { "force": [1, 0] }"#),
            "hold or onset: together_with given, must be left out beside a base: what is always there is the `load` of a body",
        ),
        (
            growing("").replacen(r#""force": [6, 0]"#, r#""force": [0, 0]"#, 1),
            "hold or onset: together_with given, must be left out without a load to grow with",
        ),
        (
            growing("").replacen(r#"{ "lower": { "force""#, r#"{ "lid": { "force""#, 1),
            "body \"lid\" is to be loaded, and is none of the scene",
        ),
    ];
    for (text, words) in told {
        let message = refused(&text);
        assert!(message.contains(words), "{message}");
    }
}

#[test]
fn it_is_written_as_it_was_read() {
    let scene: Scene = serde_json::from_str(BOXES).expect("a scene");
    let written = serde_json::to_string(&scene).expect("written");
    let again: Scene = serde_json::from_str(&written).expect("a scene");
    assert_eq!(scene, again);
    let Space::Planar(setup) = &again.space else { panic!("planar") };
    assert_eq!((setup.bodies.len(), setup.bodies[1].outline.len()), (2, 3));
}

/// An answer has each body with its motion, and reads back.
#[test]
fn bodies_are_in_the_answer() {
    let asked = BOXES.replace(
        r#""hold": { "load": { "force": [6, 0], "at": [0, 0.2] } }"#,
        r#""solve": { "load": { "force": [1, 0] } }"#,
    );
    let scene: Scene = serde_json::from_str(&asked).expect("a scene");
    let answers = serde_json::to_value(scene.answers().expect("well posed")).expect("written");
    let bodies =
        answers[0]["solve"]["equilibrium"]["bodies"].as_array().or(answers[0]["solve"]["bodies"].as_array());
    let names: Vec<_> =
        bodies.expect("bodies").iter().map(|body| body["body"].as_str().expect("a name")).collect();
    assert_eq!(names, ["lower", "upper"]);
}

#[test]
fn what_makes_no_sense_is_refused() {
    let refused = |from: &str, to: &str| {
        assert!(BOXES.contains(from), "{from}");
        serde_json::from_str::<Scene>(&BOXES.replace(from, to)).expect_err("makes no sense").to_string()
    };
    let cases = [
        (
            r#""loaded": "upper""#,
            r#""loaded": "lid""#,
            "body \"lid\" is to be loaded, and is none of lower, upper",
        ),
        (r#""loaded": "upper""#, r#""loaded": "upper", "shared_by_mass": true"#, "loaded and shared_by_mass"),
        (
            r#""loaded": "upper""#,
            r#""outline": [[0, 0], [1, 0], [0, 1]]"#,
            "of several bodies each has its own",
        ),
        (r#""against": "lower""#, r#""against": "upper""#, "is on both sides of contact"),
        (r#""on": "upper", "#, "", "it must be said"),
        (r#""mass": 2"#, r#""mass": -2"#, "has mass -2"),
    ];
    for (from, to, message) in cases {
        let told = refused(from, to);
        assert!(told.contains(message), "{told}");
    }
    let alone = r#"{ "format": "grasp-lcp/1", "planar": { "gravity": [0, -1], "contacts": [{ "point": [0, 0], "normal": [0, 1] }] } }"#;
    let told = serde_json::from_str::<Scene>(alone).expect_err("no bodies").to_string();
    assert!(told.contains("gravity: of a scene with bodies alone"), "{told}");
}
