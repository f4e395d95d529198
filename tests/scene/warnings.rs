//! Words of warning: each for what is hardly meant, and none where it is meant.

use grasp_lcp::planar::Contact;
use grasp_lcp::scene::{Scene, Setup};

const JAWS: &str = r#"{"format": "grasp-lcp/1", "planar": {"contacts": [
    {"name": "left", "point": [-0.04, 0], "normal": [1, 0], "friction": 0.35, "pressed_with": 8, "stiffness": 10000},
    {"name": "right", "point": [0.04, 0], "normal": [-1, 0], "friction": 0.35, "pressed_with": 8, "stiffness": 10000}],
    "questions": [{"hold": {"load": {"force": [0, -1]}}}]}}"#;

fn warnings(text: &str) -> Vec<String> {
    let scene = Scene::from_json(text.as_bytes()).unwrap_or_else(|fault| panic!("{text}: {fault}"));
    scene.warnings().expect("well posed").iter().map(ToString::to_string).collect()
}

/// The one warning about the jaws with something replaced everywhere begins like this.
fn one(changes: &[(&str, &str)], begins: &str) {
    let text = changes.iter().fold(JAWS.to_owned(), |text, (from, to)| {
        assert!(text.contains(from), "{from}");
        text.replace(from, to)
    });
    let told = warnings(&text);
    assert!(told.len() == 1 && told[0].starts_with(begins), "{changes:?}: {told:?}");
}

#[test]
fn nothing_is_odd_about_two_jaws() {
    assert_eq!(warnings(JAWS), [""; 0]);
}

#[test]
fn numbers_in_another_unit() {
    one(
        &[("0.35", "35")],
        "friction 35 at left and right: coefficients are rarely above 1; in percent? Then it is 0.35",
    );
    one(
        &[("0.04", "40")],
        "the contacts are apart by up to 80 m: lengths are in m; is this in mm? A scene then says \"unit\": \"mm\"",
    );
    let pad = r#""stiffness": 10000, "soft": {"pair": {"width": 20}}"#;
    one(
        &[(r#""stiffness": 10000"#, pad)],
        "the patch of left is as wide as 20 m, and contacts are 0.08 m apart",
    );
    let low = r#""force": [0, -1], "at": [25, 0]"#;
    one(&[(r#""force": [0, -1]"#, low)], "a load acts at a distance of 25 m, and contacts are 0.08 m apart");
    let steel = [(r#""stiffness": 10000"#, r#""stiffness": 210e9"#)];
    one(&steel, "stiffness 2.1e11 N/m at left and right, out of proportion to the rest: contacts of steel");
    one(
        &[(r#""pressed_with": 8"#, r#""pressed_with": 1e12"#)],
        "1e12 N at left and right, out of proportion to the rest",
    );
    let heavy = r#""mass": 1800"#;
    one(
        &[(r#""force": [0, -1]"#, heavy)],
        "a load has 17658 N, and contacts press with 16 N together: masses are in kg; is this in g?",
    );
    // An infinite coefficient is none in percent, and the size of a direction says nothing.
    let more = [
        ("0.35", r#""infinite""#),
        (r#"{"hold": {"load": {"force": [0, -1]}}}"#, r#"{"onset": {"direction": {"force": [0, -1e6]}}}"#),
    ];
    let text = more.iter().fold(JAWS.to_owned(), |text, (from, to)| text.replace(from, to));
    assert_eq!(warnings(&text), [""; 0]);
}

#[test]
fn normals_the_wrong_way_round() {
    let same = "the normals of left and right point the same way: contacts cannot press against each other";
    one(&[(r#""normal": [1, 0]"#, r#""normal": [-1, 0]"#)], same);
    let out = [
        (r#""normal": [1, 0]"#, r#""normal": [-1, 0.001]"#),
        (r#""normal": [-1, 0]"#, r#""normal": [1, 0]"#),
    ];
    one(&out, "the normals of left and right point away from the middle: so they do for fingers in a hole");
    // An outline shows whether they stand in a hole.
    let hole = r#""outline": [[-0.04, -1], [-0.04, 1], [-1, 1], [-1, -1]], "questions""#;
    let text =
        out.iter().fold(JAWS.replace(r#""questions""#, hole), |text, (from, to)| text.replace(from, to));
    assert!(!warnings(&text).iter().any(|told| told.contains("in a hole")), "{:?}", warnings(&text));
}

/// Feet that a weight presses on as hard as they are told: all normals point up, and nothing is said.
#[test]
fn feet_under_a_weight_are_told_apart_from_it() {
    let feet = JAWS.replace("[1, 0]", "[0, 1]").replace("[-1, 0]", "[0, 1]").replace("0.35", "0.5");
    assert!(
        warnings(&feet).iter().any(|told| told.starts_with("the normals of left and right")),
        "{:?}",
        warnings(&feet)
    );
    let stand = feet.replace(
        r#""load": {"force": [0, -1]}"#,
        r#""base": {"force": [0, -16]}, "load": {"force": [1, 0]}"#,
    );
    assert_eq!(warnings(&stand), [""; 0]);
}

#[test]
fn friction_that_is_missing_everywhere() {
    let none = "no contact has friction: nothing is held but what normals push against";
    one(&[(r#""friction": 0.35, "#, "")], none);
    assert_eq!(warnings(&JAWS.replacen(r#""friction": 0.35, "#, "", 1)), [""; 0]);
}

/// Four frictionless normals around a rectangle, off the corners so that they turn it neither way: form closure needs no friction.
#[test]
fn locators_need_no_friction() {
    let at =
        |x: f64, y: f64, n: [f64; 2]| Contact::new([x, y], n).series_stiffness(1e4, 1e4).pressed_with(1.0);
    let around = [
        at(-1.0, 0.5, [1.0, 0.0]),
        at(1.0, -0.5, [-1.0, 0.0]),
        at(0.5, -1.0, [0.0, 1.0]),
        at(-0.5, 1.0, [0.0, -1.0]),
        at(0.5, 1.0, [0.0, -1.0]),
        at(-0.5, -1.0, [0.0, 1.0]),
    ];
    let told = Setup::new(around.map(Into::into)).warnings().expect("well posed");
    assert!(!told.iter().any(|told| told.to_string().contains("friction")), "{told:?}");
}

#[test]
fn contacts_that_stand_there_twice() {
    let twice =
        JAWS.replace("0.04, 0], \"normal\": [-1, 0]", "-0.04, 0], \"normal\": [-1, 0]").replace("--", "-");
    let told = warnings(&twice);
    assert!(
        told.iter().any(|told| told.starts_with("left and right are in one place, with parallel normals")),
        "{told:?}"
    );
}

/// A bracket on a round post: no finger presses, its load jams it. A pinch without a squeeze is told of.
#[test]
fn a_load_that_jams_needs_no_finger() {
    let bracket = r#"{"format": "grasp-lcp/1", "planar": {"contacts": [
        {"name": "upper", "point": [0.02, 0.1], "normal": [-1, 0], "friction": 0.2, "stiffness": 1e6},
        {"name": "lower", "point": [-0.02, 0], "normal": [1, 0], "friction": 0.2, "stiffness": 1e6}],
        "questions": [{"hold": {"load": {"force": [0, -100], "at": [0.2, 0]}}}]}}"#;
    assert_eq!(warnings(bracket), [""; 0]);
    let idle = JAWS.replace(r#""pressed_with": 8, "#, "");
    let told = warnings(&idle);
    assert!(
        told.len() == 1 && told[0].starts_with("no finger presses: every command is zero or missing"),
        "{told:?}"
    );
}

/// A belt and a floor of equal stiffness share a pretension; a tension is what is left of it.
#[test]
fn a_pull_that_gives_way() {
    let belted = |pull: &str| {
        format!(
            r#"{{"format": "grasp-lcp/1", "planar": {{
            "contacts": [{{"name": "floor", "point": [0, 0], "normal": [0, 1], "friction": 0.5, "stiffness": 1e4}}],
            "links": [{{"name": "belt", "cable": {{"from": [0, 1], "to": [0, 0]}}, "stiffness": 1e4, {pull}}}],
            "questions": [{{"hold": {{"load": {{"force": [40, 0]}}}}}}]}}}}"#
        )
    };
    let told = warnings(&belted(r#""pretension": 100"#));
    assert!(
        told.len() == 1 && told[0].starts_with("belt pulls with 50 N at rest, not with 100 N"),
        "{told:?}"
    );
    let installed = belted(r#""tension": 100"#);
    assert_eq!(warnings(&installed), [""; 0]);
    let scene: Scene = serde_json::from_str(&installed).expect("a scene");
    assert_eq!(scene, serde_json::from_value(serde_json::to_value(&scene).expect("written")).expect("read"));
    let answers = serde_json::to_value(scene.answers().expect("well posed")).expect("written");
    let says = answers[0]["hold"]["says"].as_str().expect("a sentence");
    assert!(says.starts_with("HOLDS, everything sticks: 50 N (1.25 times this load)"), "{says}");
    let both = belted(r#""tension": 100, "pretension": 100"#);
    let told = Scene::from_json(both.as_bytes()).expect_err("both").to_string();
    assert!(
        told.contains(
            "belt: pretension and tension: before anything gives way, or at rest; give one of them"
        ),
        "{told}"
    );
    // Nothing holds against a rope that pulls away from the floor.
    let away = installed.replace(r#""to": [0, 0]"#, r#""to": [0, 2]"#);
    let scene = Scene::from_json(away.as_bytes()).expect("a scene");
    let told = scene.answers().expect_err("it flies off").to_string();
    assert!(
        told.starts_with(
            "cable \"belt\": tension is 100, must be one that the rest of the grasp holds against"
        ),
        "{told}"
    );
}
