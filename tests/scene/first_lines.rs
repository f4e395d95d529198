//! The first line of a path tells what slides and what yields; a short answer tells the least margin of friction.

use grasp_lcp::scene::Scene;
use grasp_lcp::words::Words;
use serde_json::{Value, json};

fn scene(setup: &Value) -> Scene {
    serde_json::from_value(json!({ "format": "grasp-lcp/1", "planar": setup })).expect("a scene")
}

fn first_line(setup: &Value) -> String {
    let scene = scene(setup);
    let answers = scene.answers().expect("well posed").planar().expect("planar");
    scene.planar().expect("planar").questions[0].first_line(&answers[0], Words::default())
}

fn foot(name: &str, x: f64, along: f64) -> Value {
    json!({ "name": name, "point": [x, 0], "normal": [0, 1], "stiffness": 1e4, "friction": 0.5, "command": [0.001, along] })
}

/// A foot is dragged by 5 mm against a spring of 1e4 N/m, which takes 50 N. The foot slides, because it presses with far less than 100 N, and μ =
/// 0.5. Without this drag nothing slides at 2 N.
#[test]
fn a_foot_slides_from_the_start() {
    let on_feet = |dragged: f64, legs: Value| {
        let lid = json!({ "name": "lid", "point": [0, 0.1], "normal": [0, -1], "stiffness": 1e4, "friction": 0.9, "command": [0.003, 0] });
        json!({ "contacts": [foot("a", -0.1, dragged), foot("b", 0.1, 0.0), lid], "questions": [{ "follow": { "legs": legs } }] })
    };
    let pull = json!([{ "load_to": { "force": [-2, 0] } }]);
    assert_eq!(first_line(&on_feet(0.005, pull.clone())), "HELD to the end: a slides from the start");
    assert_eq!(first_line(&on_feet(0.0, pull)), "HELD to the end: no contact begins to slide on the way");
    let hard = first_line(&on_feet(0.005, json!([{ "load_to": { "force": [-30, 0] } }])));
    assert!(hard.contains("a slides from the start, next slip at 0."), "{hard}");
    assert_eq!(first_line(&on_feet(0.0, json!([]))), "NOTHING FOLLOWED: no legs are given");
}

/// Two jaws press with 8 N each, μ = 0.5. They begin to slide at 8 N, where the path ends. A push of 17 N along the pinch line opens one of equal jaws
/// at 16 N, and nothing slides.
#[test]
fn what_happens_at_the_end_of_a_path_or_without_slip() {
    let jaws = |legs: Value| {
        let jaw = |name: &str, x: f64| json!({ "name": name, "point": [x, 0], "normal": [-x.signum(), 0], "stiffness": [2000, 1500], "friction": 0.5, "pressed_with": 8 });
        first_line(
            &json!({ "contacts": [jaw("left", -0.04), jaw("right", 0.04)], "questions": [{ "follow": { "legs": legs } }] }),
        )
    };
    let down = jaws(json!([{ "load_to": { "force": [0, -8] } }]));
    assert_eq!(down, "HELD to the end: left and right slide from there on");
    let along = jaws(json!([{ "load_to": { "force": [17, 0] } }, { "load_to": { "force": [0, 0] } }]));
    let words = "no contact begins to slide on the way; left opens at 0.941176 of leg 1, (16, 0) N";
    assert!(along.ends_with(words), "{along}");
}

/// A rope of 3e4 N/m pulls a block against two of 5e3 N/m with a pretension of 10 N each. Both are slack from 4e4 N/m · 2 mm = 80 N on.
#[test]
fn ropes_go_slack_and_do_not_open() {
    let rope = |name: &str, to: [f64; 2], stiffness: f64, pretension: f64| json!({ "name": name, "on": "block", "cable": { "from": [0, 0], "to": to }, "stiffness": stiffness, "pretension": pretension });
    let links = [
        rope("left", [-1.0, 0.0], 3e4, 20.0),
        rope("one", [1.0, 0.0], 5e3, 10.0),
        rope("two", [2.0, 0.0], 5e3, 10.0),
        rope("up", [0.0, 1.0], 1e4, 10.0),
        rope("down", [0.0, -1.0], 1e4, 10.0),
    ];
    let under = |question: Value| {
        first_line(
            &json!({ "bodies": [{ "name": "block" }], "contacts": [], "links": links, "questions": [question] }),
        )
    };
    let pulled = under(json!({ "follow": { "legs": [{ "load_to": { "force": [100, 0] } }] } }));
    assert!(pulled.ends_with("; one and two go slack at 0.8 of leg 1, (80, 0) N"), "{pulled}");
    let solved = under(json!({ "solve": { "load": { "force": [100, 0] } } }));
    assert!(solved.ends_with("everything that touches sticks, one and two are slack"), "{solved}");
}

/// A spring of 1000 N/m shares a pull with a motor of 10 N m/rad on an arm of 0.1 m. The motor stalls at 5 N. With its tip of 1e6 N/m, the object has
/// then moved by 5.005 mm.
#[test]
fn a_motor_that_stalls_is_named() {
    let tip =
        json!({ "name": "tip", "point": [0.05, 0], "normal": [-1, 0], "stiffness": 1e6, "hold": "bonded" });
    let motor = json!({ "name": "motor", "revolute": { "point": [0.05, 0.1] }, "stiffness": 10, "limit": { "saturates": 0.5 } });
    let spring = json!({ "name": "spring", "point": [-0.05, 0], "normal": [1, 0], "stiffness": 1000, "hold": "bonded" });
    let said = first_line(&json!({
        "contacts": [spring], "fingers": [{ "joints": [motor], "contacts": [tip] }],
        "questions": [{ "follow": { "legs": [{ "load_to": { "force": [20.01, 0] } }, { "load_to": { "force": [0, 0] } }] } }]
    }));
    let yields =
        "HELD to the end: motor yields at 0.5 of leg 1, (10.005, 0) N; no contact begins to slide on the way";
    assert!(said.starts_with("GOES TOO FAR from ") && said.ends_with(yields), "{said}");
}

/// A roller without friction is not named as the contact with the least margin of friction.
#[test]
fn a_roller_does_not_count_as_a_margin() {
    let mut roller = foot("roller", 0.1, 0.0);
    roller["friction"] = json!(0);
    let on_feet = json!({ "contacts": [foot("a", -0.1, 0.0), roller], "questions": [{ "solve": { "load": { "force": [1, -20] } } }] });
    let brief = &scene(&on_feet).planar().expect("planar").brief_answers().expect("well posed")[0];
    // The foot carries half of the weight. Its margin is 0.5 · 10 N less the push of 1 N.
    assert!(
        (brief.margin.expect("a foot") - 4.0).abs() < 1e-9 && brief.first.as_deref() == Some("a"),
        "{brief:?}"
    );
}
