//! Scenes of several bodies are read and written, agree with bodies built in Rust, and are refused if they make no sense.

use grasp_lcp::hold::WayOut;
use grasp_lcp::planar::{Bodies, Body, Contact, Wrench};
use grasp_lcp::scene::{Answer, Scene};

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
    slides_at_3_newtons(BOXES);
}

fn slides_at_3_newtons(scene: &str) {
    let scene: Scene = serde_json::from_str(scene).expect("a scene");
    let Some(answers) = scene.answers().expect("well posed").planar() else { panic!("planar") };
    let Answer::Hold(answer) = &answers[0] else { panic!("hold was asked") };
    let verdict = &answer.verdict;
    assert!((6.0 * verdict.held_to - 3.0).abs() < 1e-12, "{verdict}");
    let WayOut::Apart { bodies } = &verdict.lost.as_ref().expect("slides").way_out else {
        panic!("{verdict}")
    };
    let [upper] = &bodies[..] else { panic!("{verdict}") };
    let WayOut::SlidesOut { direction } = &upper.way else { panic!("{verdict}") };
    assert!(upper.body == "upper" && direction[0] > 1.0 - 1e-9, "{verdict}");
}

/// The lower box is pulled in one direction, and the upper box in the other with half the force. The upper box slides at 3 N.
#[test]
fn loads_of_bodies_grow_together() {
    let hold = r#"{ "hold": { "load": { "force": [6, 0], "at": [0, 0.2] } } }"#;
    let growing = |more: &str| {
        let asked = format!(
            r#"{{ "hold": {{ "load": {{ "force": [6, 0], "at": [0, 0.2] }}, "together_with": {{ "lower": {{ "force": [-12, 0], "at": [0, 0.1] }} }}{more} }} }}"#
        );
        BOXES.replacen(hold, &asked, 1)
    };
    slides_at_3_newtons(&growing(""));
    let scene: Scene = serde_json::from_str(&growing("")).expect("a scene");
    let written = serde_json::to_string(&scene).expect("written");
    assert_eq!(serde_json::from_str::<Scene>(&written).expect("a scene"), scene);
    let refused = |text: &str| serde_json::from_str::<Scene>(text).expect_err("refused").to_string();
    let told = [
        (growing(r#", "base": { "force": [1, 0] }"#), "together_with given", "a base"),
        (
            growing("").replacen(r#""force": [6, 0]"#, r#""force": [0, 0]"#, 1),
            "together_with given",
            "to grow with",
        ),
        (
            growing("").replacen(r#"{ "lower": { "force""#, r#"{ "lid": { "force""#, 1),
            "body \"lid\"",
            "the scene",
        ),
    ];
    for (text, what, why) in told {
        let message = refused(&text);
        assert!(message.contains(what) && message.contains(why), "{message}");
    }
}

/// Equilibria and needed amounts also use loads of bodies that grow together. The upper box is just held at 3 N, so half of the given load of 6 N is
/// the bound.
#[test]
fn loads_grow_together_in_other_questions() {
    let hold = r#"{ "hold": { "load": { "force": [6, 0], "at": [0, 0.2] } } }"#;
    let others = r#""together_with": { "lower": { "force": [-12, 0], "at": [0, 0.1] } }"#;
    let answer = |question: &str| {
        let scene: Scene = serde_json::from_str(&BOXES.replacen(hold, question, 1)).expect("a scene");
        let written = serde_json::to_string(&scene).expect("written");
        assert_eq!(serde_json::from_str::<Scene>(&written).expect("a scene"), scene);
        serde_json::to_value(scene.answers().expect("well posed")).expect("written")[0].clone()
    };
    let amount = answer(&format!(
        r#"{{ "need": {{ "quantity": "load", "demand": "held", "load": {{ "force": [6, 0], "at": [0, 0.2] }}, "friction_less": 0, "squeeze_less": 0, {others} }} }}"#
    ));
    let says = amount["need"]["says"].as_str().expect("a sentence");
    assert!(says.starts_with("TAKES only 0.5 times"), "{says}");
    let under = |newtons: f64| {
        answer(&format!(
            r#"{{ "solve": {{ "load": {{ "force": [{newtons}, 0], "at": [0, 0.2] }}, "together_with": {{ "lower": {{ "force": [{}, 0], "at": [0, 0.1] }} }} }} }}"#,
            -2.0 * newtons
        ))
    };
    assert_eq!(under(2.999)["solve"]["outcome"], "equilibrium");
    assert_eq!(under(3.001)["solve"]["outcome"], "no_equilibrium");
    // The contacts on the table carry the difference of both loads.
    let carried: f64 = under(2.0)["solve"]["contacts"].as_array().expect("contacts")[..2]
        .iter()
        .map(|contact| contact["force_world"][0].as_f64().expect("a number"))
        .sum();
    assert!((carried - 2.0).abs() < 1e-12, "{carried}");
}

/// A leg states the change of the load of each body.
#[test]
fn legs_have_loads_of_bodies() {
    let hold = r#"{ "hold": { "load": { "force": [6, 0], "at": [0, 0.2] } } }"#;
    let follow = |legs: &str| BOXES.replacen(hold, &format!(r#"{{ "follow": {{ "legs": [{legs}] }} }}"#), 1);
    let legs = r#"{ "body_loads_to": { "lower": { "force": [-4, 0], "at": [0, 0.1] } } }, { "load_to": { "force": [6, 0], "at": [0, 0.2] }, "body_loads_by": { "lower": { "force": [-2, 0], "at": [0, 0.1] } } }"#;
    let scene: Scene = serde_json::from_str(&follow(legs)).expect("a scene");
    let written = serde_json::to_string(&scene).expect("written");
    assert_eq!(serde_json::from_str::<Scene>(&written).expect("a scene"), scene);
    let answers = serde_json::to_value(scene.answers().expect("well posed")).expect("written");
    let path = &answers[0]["follow"];
    assert_eq!(path["outcome"], "lost", "{path}");
    let fraction = path["fraction"].as_f64().expect("a number");
    assert!((fraction - 0.5).abs() < 1e-12, "{fraction}");
    let loads = &path["state"]["body_loads"];
    assert_eq!(loads[0]["body"], "lower");
    assert!((loads[0]["load"]["force"][0].as_f64().expect("a number") + 5.0).abs() < 1e-11, "{loads}");
    let refused = |legs: &str| serde_json::from_str::<Scene>(&follow(legs)).expect_err("refused").to_string();
    let told = refused(r#"{ "body_loads_by": { "lid": { "force": [1, 0] } } }"#);
    assert!(told.contains("body \"lid\"") && told.contains("the scene"), "{told}");
    let one = r#"{ "lower": { "force": [1, 0] } }"#;
    let told = refused(&format!(r#"{{ "body_loads_by": {one}, "body_loads_to": {one} }}"#));
    assert!(told.contains("and body_loads_to") && told.contains("lower is in"), "{told}");
}

#[test]
fn it_is_written_as_it_was_read() {
    let scene: Scene = serde_json::from_str(BOXES).expect("a scene");
    let written = serde_json::to_string(&scene).expect("written");
    let again: Scene = serde_json::from_str(&written).expect("a scene");
    assert_eq!(scene, again);
    let Some(setup) = again.planar() else { panic!("planar") };
    assert_eq!((setup.bodies.len(), setup.bodies[1].outline.len()), (2, 3));
}

/// An answer has the motion of each body, and reads back.
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
        (r#""loaded": "upper""#, r#""loaded": "lid""#, "body \"lid\"", "lower, upper"),
        (
            r#""loaded": "upper""#,
            r#""loaded": "upper", "shared_by_mass": true"#,
            "loaded and",
            "shared_by_mass",
        ),
        (r#""loaded": "upper""#, r#""outline": [[0, 0], [1, 0], [0, 1]]"#, "outline", "each has its"),
        (r#""against": "lower""#, r#""against": "upper""#, "body \"upper\"", "both sides"),
        (r#""on": "upper", "#, "", "body ", "must be said"),
        (r#""mass": 2"#, r#""mass": -2"#, "body \"lower\"", "has mass -2"),
    ];
    for (from, to, what, why) in cases {
        let told = refused(from, to);
        assert!(told.contains(what) && told.contains(why), "{told}");
    }
    let alone = r#"{ "format": "grasp-lcp/1", "planar": { "gravity": [0, -1], "contacts": [{ "point": [0, 0], "normal": [0, 1] }] } }"#;
    let told = serde_json::from_str::<Scene>(alone).expect_err("no bodies").to_string();
    assert!(told.contains("gravity: ") && told.contains("bodies alone"), "{told}");
}
