//! Links of a scene are read, written and refused correctly, and each is reported as one link. If an answer depends on an assumed stiffness, it says
//! so.

use grasp_lcp::scene::{Scene, Warning};
use serde_json::Value;

/// A lever on a hinge presses a plate on a bed, and a rope restrains the plate.
const CLAMP: &str = r#"{
"format": "grasp-lcp/1",
"planar": {
"bodies": [{ "name": "plate" }, { "name": "lever", "load": { "force": [0, -50], "at": [0.3, 0.02] } }],
"contacts": [
{ "name": "bed", "on": "plate", "point": [0.1, 0], "normal": [0, 1], "friction": 0.4, "stiffness": 1000000, "soft": { "pair": { "width": 0.1 } } },
{ "name": "nose", "on": "plate", "against": "lever", "point": [0.1, 0.01], "normal": [0, -1], "friction": 0.4, "stiffness": 1000000 }
],
"links": [
{ "name": "pin", "comment": "of steel", "hinge": { "point": [0, 0.02] }, "on": "lever" },
{ "name": "rope", "cable": { "from": [0.2, 0], "to": [0.5, 0] }, "on": "plate", "stiffness": 50000, "slack": 0.00007 },
{ "spring": { "from": [0.3, 0.02], "to": [0.3, 0.5] }, "between": ["lever", "plate"], "stiffness": 1 }
],
"questions": [{ "solve": { "load": { "force": [-100, 0], "at": [0.1, 0.005] } } }, { "follow": { "legs": [{ "load_to": { "force": [-160, 0] }, "commands_by": [[0, 0], [0, 0]] }] } }]
}
}"#;

fn scene(text: &str) -> Scene {
    Scene::from_json(text.as_bytes()).unwrap_or_else(|fault| panic!("{fault}"))
}

fn answers(text: &str) -> Value {
    serde_json::to_value(scene(text).answers().expect("well posed")).expect("written")
}

#[test]
fn it_is_written_as_it_was_read() {
    let clamp = scene(CLAMP);
    let written = serde_json::to_string(&clamp).expect("written");
    assert_eq!(scene(&written), clamp);
    let Some(setup) = clamp.planar() else { panic!("planar") };
    assert_eq!(setup.links[0].comment.as_deref(), Some("of steel"));
    assert_eq!((setup.links.len(), setup.grasp().expect("well posed").len()), (3, 6));
}

#[test]
fn in_space_too() {
    let text = r#"{"format": "grasp-lcp/1", "spatial": {"links": [
        {"hinge": {"point": [0, 0, 1], "axis": [0, 0, 2], "length": 0.5}},
        {"name": "rope", "cable": {"from": [1, 0, 1], "to": [1, 1, 1]}, "stiffness": 1000}
    ], "questions": [{"solve": {"load": {"force": [0, -3, 0], "at": [1, 0, 1]}}}]}}"#;
    let door = scene(text);
    assert_eq!(scene(&serde_json::to_string(&door).expect("written")), door);
    let state = &answers(text)[0]["solve"];
    // Contacts of a single object need no field `on`. The points of the hinge are reported as one contact.
    let told: Vec<_> = state["contacts"]
        .as_array()
        .expect("a list")
        .iter()
        .map(|contact| {
            (
                contact["contact"].as_u64(),
                contact["point"].as_u64(),
                contact["name"].as_str(),
                contact["link"].as_str(),
            )
        })
        .collect();
    assert_eq!(
        told,
        [
            (Some(0), Some(0), Some("hinge 0"), Some("hinge")),
            (Some(0), Some(1), Some("hinge 0"), Some("hinge")),
            (Some(1), None, Some("rope"), Some("cable")),
        ]
    );
    assert!((state["contacts"][2]["force"][0].as_f64().expect("a force") - 3.0).abs() < 1e-12);
}

#[test]
fn answers_say_what_is_a_link() {
    let answers = answers(CLAMP);
    let contacts = answers[0]["solve"]["contacts"].as_array().expect("a list");
    let link = |contact: &Value| contact["link"].as_str().map(str::to_owned);
    assert_eq!(
        contacts.iter().map(link).collect::<Vec<_>>(),
        [None, None, None, Some("hinge".into()), Some("cable".into()), Some("spring".into())]
    );
    assert_eq!(contacts[5]["name"], "spring 2");
    // The plate moves to the left until the rope is tight.
    let events = answers[1]["follow"]["events"].as_array().expect("a list");
    let tight = events.iter().flat_map(|event| event["changes"].as_array().expect("a list"));
    let tight: Vec<_> =
        tight.filter(|change| change["link"] == "cable").map(|change| &change["what"]).collect();
    assert_eq!(tight, ["closes"]);
}

#[test]
fn refused() {
    let message = |from: &str, to: &str| {
        assert!(CLAMP.contains(from), "{from}");
        Scene::from_json(CLAMP.replacen(from, to, 1).as_bytes()).expect_err(to).message
    };
    let hinge = r#""hinge": { "point": [0, 0.02] }"#;
    // For each case: the text to replace, its replacement, the link or field in the message, and the value in the message.
    for (from, to, of, value) in [
        (
            hinge,
            r#""hinge": { "point": [0, 0.02] }, "rigid": { "point": [0, 0], "size": 0.1 }"#,
            "pin: ",
            "2 kinds",
        ),
        (hinge, r#""stiffness": 3"#, "pin: ", "0 kinds"),
        (hinge, r#""hinge": { "point": [0, 0], "length": 0.1 }"#, "pin: hinge: ", "length given"),
        (hinge, r#""ball": { "point": [0, 0] }"#, "pin: ball: ", "the plane"),
        (
            hinge,
            r#""slide": { "point": [0, 0], "direction": [0, 0], "length": 0.1 }"#,
            "pin: direction",
            "slide is 0",
        ),
        (r#""slack": 0.00007"#, r#""slack": -1"#, "rope: slack", "is -1"),
        (r#""slack": 0.00007"#, r#""pretension": -1"#, "rope: pretension", "is -1"),
        (r#""stiffness": 1 }"#, r#""slack": 0 }"#, "stiffness: ", "left out"),
        (r#""stiffness": 1 }"#, r#""stiffness": 0 }"#, "stiffness ", "spring is 0"),
        (
            r#""on": "plate", "stiffness": 50000"#,
            r#""on": "plate", "between": ["plate", "lever"]"#,
            "rope: between",
            "and on: ",
        ),
    ] {
        let told = message(from, to);
        assert!(told.starts_with(of) && told.contains(value), "{told}");
    }
    let told = message(r#""on": "lever""#, r#""on": "arm""#);
    assert!(told.starts_with("body \"arm\"") && told.contains("hinge \"pin\""), "{told}");
    assert!(told.ends_with("plate, lever"), "{told}");
}

/// A beam on three props, one of them a link. Its force depends on its stiffness, and the answer says so. The stiffness of a statically determinate
/// link does not matter.
#[test]
fn a_stiffness_that_counts_is_told() {
    let beam = |prop: &str| {
        format!(
            r#"{{"format": "grasp-lcp/1", "planar": {{"contacts": [
            {{"point": [-1, 0], "normal": [0, 1], "stiffness": 1e9, "friction": 0.5}},
            {{"point": [1, 0], "normal": [0, 1], "stiffness": 1e9, "friction": 0.5}}],
            "links": [{{"name": "rod", {prop}}}],
            "questions": [{{"solve": {{"load": {{"force": [0, -3]}}}}}}]}}}}"#
        )
    };
    let warnings = |prop: &str| scene(&beam(prop)).warnings().expect("well posed");
    let rod = r#""spring": {"from": [0, 0], "to": [0, 1]}"#;
    assert_eq!(warnings(&format!(r#"{rod}, "stiffness": 1e9"#)), []);
    let cable = warnings(r#""cable": {"from": [0, 0], "to": [0, 1]}"#);
    let told = Warning::StiffnessLeftOut {
        contacts: vec![2],
        names: vec!["rod".into()],
        stiffness: 1e9,
        questions: vec![0],
    };
    assert_eq!(cable, [told]);
    let alone = r#"{"format": "grasp-lcp/1", "planar": {"links": [
        {"cable": {"from": [0, 0], "to": [-1, 1]}}, {"cable": {"from": [0, 0], "to": [1, 1]}}],
        "questions": [{"solve": {"load": {"force": [0, -3]}}}]}}"#;
    assert_eq!(scene(alone).warnings().expect("well posed"), []);
}
