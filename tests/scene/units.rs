//! A scene in another unit of length has the same values in metres, field by field. In the scenes below, an `@` marks every length. Every field that
//! the page of fields gives in m must be marked.

use grasp_lcp::scene::{Scene, Warning};
use grasp_lcp::words::{Unit, Words};

/// Scenes with `@` before every length.
const MARKED: [&str; 4] = [
    r#"{"format": "grasp-lcp/1", "spatial": {
        "contacts": [
            {"name": "left", "point": [@-20, 0, 0], "normal": [1, 0, 0], "tangent": [0, 1, 0], "stiffness": [600000, 200000], "friction": 0.35,
             "pressed_with": 120, "clearance": @1, "soft": {"rectangle": {"sides": [@20, @30], "strips": [1, 2]}}},
            {"name": "right", "point": [@20, 0, 0], "normal": [-1, 0, 0], "stiffness": 600000, "friction": 0.35, "command": [@2, @1, 0],
             "soft": {"disc": {"radius": @6, "annuli": 1, "points": 4}}},
            {"name": "cup", "point": [0, 0, @10], "normal": [0, 0, -1], "stiffness": 9000, "friction": 0.35, "suction": {"radius": @15, "pressure": 60000}},
            {"name": "ring", "point": [0, @5, @10], "normal": [0, 0, -1], "stiffness": 9000, "command_world": [@2, @1, 0],
             "soft": {"ring": {"radius": @3, "points": 4}}},
            {"name": "on a sheet", "point": [@5, @5, @10], "normal": [0, 0, -1], "stiffness": 9000,
             "surface": {"rectangle": {"corner": [0, 0, @10], "sides": [[@10, 0, 0], [0, @10, 0]]}}},
            {"name": "on a can", "point": [@10, 0, @5], "normal": [-1, 0, 0], "stiffness": 9000,
             "surface": {"cylinder": {"axis": [[0, 0, 0], [0, 0, @20]], "radius": @10}}},
            {"name": "on a ball", "point": [@10, 0, 0], "normal": [-1, 0, 0], "stiffness": 9000, "surface": {"sphere": {"centre": [@0, 0, 0], "radius": @10}}},
            {"name": "on a mesh", "point": [@1, @1, 0], "normal": [0, 0, 1], "stiffness": 9000, "surface": {"triangles": [[[0, 0, 0], [@5, 0, 0], [0, @5, 0]]]}}
        ],
        "outline": [[@1, @2, @3], [@4, @5, @6]],
        "questions": [
            {"hold": {"load": {"mass": 1.8, "at": [0, 0, @-25], "inertia": [1e-3, 1e-3, 1e-3], "accelerated": [5, 0, 3],
                "turning": {"about": [@100, 0, 0], "velocity_deg": [0, 0, 90]}}, "base": {"force": [0, 0, -3], "moment": [0.1, 0, 0], "at": [@7, 0, 0]}}},
            {"onset_of_turn": {"weight": [0, 0, -2], "at": [0, 0, @9], "axis": [1, 0, 0]}},
            {"need": {"quantity": "arm", "load": {"force": [0, 0, -2], "at": [@9, 0, 0]}, "per_metre": {"moment": [0, 2, 0]}}},
            {"need": {"quantity": "squeeze", "any_force": 3, "at": [@9, 0, 0]}},
            {"onset": {"direction": {"force": [0, 0, -1]}, "command_change": [[@1, 0, 0], [0, @1, 0], [0, 0, 0], [0, 0, 0], [0, 0, 0], [0, 0, 0], [0, 0, 0], [0, 0, 0]]}}
        ]
    }}"#,
    r#"{"format": "grasp-lcp/1", "planar": {
        "contacts": [{"name": "palm", "point": [0, @-10], "normal": [0, 1], "stiffness": 9000, "friction": 0.3, "soft": {"pair": {"width": @8}}}],
        "fingers": [
            {"joints": [{"revolute": {"point": [@-30, @-40]}, "stiffness": 2, "command": 0.2, "limit": {"saturates": 3}},
                        {"prismatic": [1, 0], "stiffness": 1000, "command": @4, "torque": 1}],
             "stiffness_matrix": [[1, 0], [0, 1]],
             "contacts": [{"point": [@-10, 0], "normal": [1, 0], "stiffness": 9000, "friction": 0.5, "soft": {"pad": {"width": @5, "strips": 2}}}]},
            {"joints": [{"revolute": {"point": [@30, @-40]}, "stiffness": 2}], "compliance": [[1e-4, 0], [0, 1e-4]],
             "contacts": [{"point": [@10, 0], "normal": [-1, 0], "friction": 0.5}]}
        ],
        "tendons": [{"arms": [@10, 1, @-12], "stiffness": 5000, "pull": @3}],
        "questions": [
            {"onset": {"direction": {"force": [0, -1]}, "joint_change": [0.1, @2, 0.1, @3]}},
            {"follow": {"legs": [{"joints_by": [0.1, @2, 0.1, @3]}, {"joints_to": [0.1, @2, 0.1, @3]}, {"commands_by": [[@1, 0], [0, 0], [0, 0]]},
                {"commands_to": [[@1, 0], [0, 0], [0, 0]], "load_to": {"force": [0, -1], "at": [@1, @2]}}, {"torques_by": [1, 2, 3]}]}},
            {"improve": {"any_force": 2, "at": [@1, @2]}}
        ]
    }}"#,
    r#"{"format": "grasp-lcp/1", "planar": {
        "bodies": [{"name": "point", "mass": 2, "centre_of_mass": [0, @50], "outline": [[@-50, 0], [@50, 0], [0, @100]], "load": {"force": [1, 0], "at": [0, @20]}},
                   {"name": "lid", "mass": 1, "centre_of_mass": [0, @150]}],
        "gravity": [0, -9.81],
        "contacts": [{"on": "point", "point": [@-40, 0], "normal": [0, 1], "friction": 0.4}, {"on": "point", "point": [@40, 0], "normal": [0, 1], "friction": 0.4}],
        "links": [{"hinge": {"point": [@-50, @100]}, "between": ["lid", "point"]},
                  {"spring": {"from": [@50, @100], "to": [@50, @80]}, "between": ["lid", "point"], "stiffness": 500, "pretension": 3},
                  {"cable": {"from": [@50, @100], "to": [@150, 0]}, "on": "lid", "stiffness": 500, "slack": @2},
                  {"slide": {"point": [0, @50], "direction": [0, 1], "length": @20}, "on": "point"},
                  {"rigid": {"point": [0, @50], "size": @20}, "on": "point"}],
        "questions": [{"hold": {"load": {"force": [1, 0]}, "together_with": {"point": {"force": [2, 0], "at": [0, @30]}}}},
                      {"follow": {"legs": [{"body_loads_by": {"point": {"force": [2, 0], "at": [0, @30]}}}]}}]
    }}"#,
    r#"{"format": "grasp-lcp/1", "planar": {
        "contacts": [
            {"point": [@-20, 0], "normal": [1, 0], "stiffness": 9000, "friction": 0.3, "pressed_with": 5, "surface": {"segment": [[@-20, @-9], [@-20, @9]]}},
            {"point": [@20, 0], "normal": [-1, 0], "stiffness": 9000, "friction": 0.3, "pressed_with": 5, "surface": {"polyline": [[@20, @-9], [@20, @9]]}},
            {"point": [@20, 0], "normal": [-1, 0], "stiffness": 9000, "surface": {"circle": {"centre": [0, 0], "radius": @20}}},
            {"point": [@20, 0], "normal": [-1, 0], "stiffness": 9000, "surface": {"arc": {"centre": [0, 0], "radius": @20, "from_deg": -30, "over_deg": 60}}},
            {"point": [@20, 0], "normal": [-1, 0], "stiffness": 9000, "surface": {"spline": [[@20, @-9], [@21, 0], [@20, @9]]}},
            {"point": [@20, 0], "normal": [-1, 0], "stiffness": 9000, "surface": {"closed_spline": [[@20, @-9], [@21, 0], [@-20, @9]]}}
        ],
        "questions": [{"identify": {"unknowns": [{"quantity": "friction"}], "layouts": [[[@1, 0], [@2, 0], [@3, 0], [@4, 0], [@5, 0], [@6, 0]]],
            "slips": [{"load": {"force": [0, -2], "at": [@5, 0]}, "layout": 1}]}}]
    }}"#,
];

/// The marked scene in another unit: marked lengths are divided by a number, and the field `unit` is added.
fn said(marked: &str, unit: &str, divided_by: f64) -> Scene {
    let mut text = String::new();
    for (k, part) in marked.split('@').enumerate() {
        let end = part.find(|c: char| !c.is_ascii_digit() && c != '-').unwrap_or(part.len());
        let end = if k == 0 { 0 } else { end };
        if let Ok(length) = part[..end].parse::<f64>() {
            text += &(length / divided_by).to_string();
        }
        text += &part[end..];
    }
    let text = text.replacen('{', &format!(r#"{{"unit": "{unit}","#), 1);
    Scene::from_json(text.as_bytes()).unwrap_or_else(|fault| panic!("{unit}: {fault}"))
}

#[test]
fn lengths_in_mm_or_cm_are_those_in_m() {
    for marked in MARKED {
        let in_metres = said(marked, "m", 1000.0);
        for (unit, divided_by) in [("mm", 1.0), ("cm", 10.0)] {
            let scene = said(marked, unit, divided_by);
            assert_eq!(Some(scene.unit), Unit::of(unit));
            // Lengths that are divided by 10 or 100 are rounded, so only the scene in mm must agree to the last bit.
            if unit == "mm" {
                assert_eq!(scene.setup, in_metres.setup);
            }
            let [here, there] =
                [&scene, &in_metres].map(|scene| serde_json::to_value(scene).expect("is written"));
            assert_near(&here, &there);
        }
    }
}

/// Sentences give an arm, the motion of the object and a centre of rotation in the unit of the scene. The fields of the answers are in m.
#[test]
fn sentences_have_the_unit_of_their_scene() {
    let marked = r#"{"format": "grasp-lcp/1", "planar": {
        "contacts": [{"name": "left", "point": [@-40, 0], "normal": [1, 0], "stiffness": 2000, "friction": 0.5, "pressed_with": 8, "soft": {"pad": {"width": @20, "strips": 2}}},
                     {"name": "right", "point": [@40, 0], "normal": [-1, 0], "stiffness": 2000, "friction": 0.5, "pressed_with": 8, "soft": {"pad": {"width": @20, "strips": 2}}}],
        "questions": [{"need": {"quantity": "arm", "load": {"force": [0, -2]}, "per_metre": {"moment": 2}}},
                      {"hold": {"load": {"force": [0, -2], "at": [@300, 0]}}}]
    }}"#;
    let lines = |unit: &str, divided_by: f64| {
        let scene = said(marked, unit, divided_by);
        let Some(answers) = scene.answers().expect("answers").planar() else { panic!("in the plane") };
        let words = Words::default().in_unit(scene.unit);
        answers.iter().map(|answer| answer.first_line(words)).collect::<Vec<_>>()
    };
    let (in_metres, in_mm) = (lines("m", 1000.0), lines("mm", 1.0));
    // Each number before " m" becomes a number before " mm" that is a thousand times as large.
    for (metres, mm) in in_metres.iter().zip(&in_mm) {
        let numbers = |line: &str, unit: &str| -> Vec<f64> {
            let parts: Vec<_> = line
                .split_whitespace()
                .map(|word| word.trim_matches(|c: char| ",;:()".contains(c)))
                .collect();
            let lengths = parts.windows(2).filter(|pair| pair[1] == unit);
            lengths.map(|pair| pair[0].parse().expect("a number")).collect()
        };
        let (long, short) = (numbers(metres, "m"), numbers(metres, "mm"));
        assert!(!long.is_empty() || !short.is_empty(), "{metres}");
        assert!(numbers(mm, "m").is_empty(), "{mm}");
        assert_eq!(numbers(mm, "mm").len(), long.len() + short.len(), "{metres} {mm}");
        let largest = |list: &[f64]| list.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
        let all = largest(&[1e3 * largest(&long), largest(&short)]);
        assert!((largest(&numbers(mm, "mm")) - all).abs() <= 1e-5 * all, "{metres} {mm}");
    }
}

fn assert_near(one: &serde_json::Value, other: &serde_json::Value) {
    use serde_json::Value::{Array, Number, Object};
    match (one, other) {
        (Array(a), Array(b)) => {
            assert_eq!(a.len(), b.len());
            a.iter().zip(b).for_each(|(a, b)| assert_near(a, b));
        }
        (Object(a), Object(b)) => {
            assert!(a.keys().eq(b.keys()));
            a.values().zip(b.values()).for_each(|(a, b)| assert_near(a, b));
        }
        (Number(a), Number(b)) => {
            let (a, b) = (a.as_f64().expect("a number"), b.as_f64().expect("a number"));
            assert!((a - b).abs() <= 1e-12 * b.abs().max(1e-3), "{a} {b}");
        }
        (one, other) => assert_eq!(one, other),
    }
}

/// Every field in m on the page of fields is marked in a scene above, except fields that need a mesh.
#[test]
fn every_field_in_metres_is_a_length() {
    let page = include_str!("../../examples/scenes/FIELDS.md");
    let mut fields = 0;
    for line in page.lines() {
        let Some((name, about)) =
            line.trim_start().strip_prefix("* `").and_then(|rest| rest.split_once("` ("))
        else {
            continue;
        };
        let is_length = [", m.", ", m;", ", m,", ", m: ", "each contact, m", "rad or m", "or m;"]
            .iter()
            .any(|unit| format!("{about}.").contains(unit));
        // Positions of a robot's joints are in radians or metres, as in its file. The unit of the scene does not apply.
        let is_of_a_robot = ["commanded", "joints"].contains(&name);
        if !is_length || is_of_a_robot || ["disc", "rectangle", "round", "thickness"].contains(&name) {
            continue;
        }
        fields += 1;
        let marked = |text: &str| {
            text.split(&format!("\"{name}\": "))
                .skip(1)
                .any(|rest| rest.split(['}', ':']).next().expect("a part").contains('@'))
        };
        assert!(MARKED.iter().any(|text| marked(text)), "{line}");
    }
    assert!(fields > 40, "{fields}");
}

/// Pads that touch a mesh, and the mesh itself.
#[test]
fn a_mesh_without_a_unit_has_that_of_its_scene() {
    let text = r#"{"format": "grasp-lcp/1", "unit": "mm", "spatial": {"part": {"mesh": "part.stl", "density": 7850},
        "contacts": [{"friction": 0.5, "pressed_with": 40, "touches": {"rectangle": [20, 30], "round": 50, "from": [-45, 0, 0], "closing": [1, 0, 0],
            "layer": {"modulus": 2e6, "thickness": 3}, "strips": [2, 3]}}]}}"#;
    let scene = Scene::from_json(text.as_bytes()).expect("a scene");
    let Some(setup) = scene.spatial() else { panic!("in space") };
    let part = setup.part.as_ref().expect("a part");
    assert_eq!((part.unit, part.density), (Unit::Millimetre, Some(7850.0)));
    let touches = setup.contacts[0].touches.as_ref().expect("a pad");
    assert_eq!(
        (touches.rectangle, touches.round, touches.from),
        (Some([0.02, 0.03]), Some(0.05), [-0.045, 0.0, 0.0])
    );
    let layer = touches.layer.expect("a layer");
    assert_eq!((layer.modulus, layer.thickness, touches.strips), (2e6, 0.003, Some([2, 3])));
    let disc = text
        .replace(r#""rectangle": [20, 30], "round": 50"#, r#""disc": 20"#)
        .replace(", \"strips\": [2, 3]", "");
    let Some(setup) = Scene::from_json(disc.as_bytes()).expect("a scene").spatial() else {
        panic!("in space")
    };
    assert_eq!(setup.contacts[0].touches.as_ref().and_then(|touches| touches.disc), Some(0.02));
    let own = text.replace(r#""part.stl""#, r#""part.stl", "unit": "cm""#);
    let Some(setup) = Scene::from_json(own.as_bytes()).expect("a scene").spatial() else {
        panic!("in space")
    };
    assert_eq!(setup.part.expect("a part").unit, Unit::Centimetre);
}

#[test]
fn what_cannot_be_read_in_mm_is_refused() {
    let two = r#"{"format": "grasp-lcp/1", "unit": "UNIT", "planar": {"contacts": [{"point": [0, 0], "normal": [0, 1]}]}}"#;
    let fault = |text: &str| Scene::from_json(text.as_bytes()).expect_err("is refused").to_string();
    assert!(fault(&two.replace("UNIT", "feet")).contains("unit: "), "{}", fault(two));
    assert!(fault(&two.replace("UNIT", "feet")).contains("name `feet`"), "{}", fault(two));
    // A scene read by serde alone has no text in which lengths can be found.
    let by_serde = serde_json::from_str::<Scene>(&two.replace("UNIT", "mm")).expect_err("is refused");
    assert!(by_serde.to_string().starts_with("unit: mm") && by_serde.to_string().contains("from_json"));
    let jacobian = r#"{"format": "grasp-lcp/1", "unit": "mm", "planar": {"fingers": [{"joints": [{"stiffness": 2}],
        "contacts": [{"point": [0, 0], "normal": [0, 1], "stiffness": 1000, "moved_by": {"jacobian": [[0.1], [0]]}}]}]}}"#;
    let beside = |text: &str, what: &str| {
        let told = fault(text);
        assert!(told.starts_with("unit: mm given") && told.contains(what), "{told}");
    };
    beside(jacobian, "a jacobian");
    let robot = r#"{"format": "grasp-lcp/1", "unit": "mm", "spatial": {"robot": {"urdf": "hand.urdf", "stiffness": {"others": 3},
        "contacts": {"tip": [{"point": [0, 0, 0], "normal": [0, 0, 1]}]}}}}"#;
    beside(robot, "a robot");
    // Other faults keep their place in the text.
    let fault = fault(&two.replace("UNIT", "mm").replace("[0, 1]", "\"up\""));
    assert!(fault.contains("planar.contacts[0].normal"), "{fault}");
}

/// The load hangs 25 m below two fingers, on their line, so that it has no arm.
#[test]
fn a_far_load_without_an_arm_is_named() {
    let text = r#"{"format": "grasp-lcp/1", "planar": {"contacts": [
        {"point": [-0.02, 0], "normal": [1, 0], "friction": 0.35, "pressed_with": 120}, {"point": [0.02, 0], "normal": [-1, 0], "friction": 0.35, "pressed_with": 120}],
        "questions": [{"hold": {"load": {"mass": 1.8, "at": [0, -25]}}}]}}"#;
    let warning = |text: &str| {
        let scene = Scene::from_json(text.as_bytes()).expect("a scene");
        scene.far_load_in(text.as_bytes())
    };
    let told = warning(text).expect("is named");
    let Warning::ManyMetres { what, length, beside } = &told else { panic!("{told}") };
    assert!(what.starts_with("a load") && (length - 25.0).abs() < 1e-12, "{told}");
    assert!(beside.is_some_and(|apart| (apart - 0.04).abs() < 1e-12), "{told}");
    assert_eq!(warning(&text.replace("-25", "-0.025")), None);
    // A long lever arm of the load has its own warning. Thus this warning about a far load is not given.
    assert_eq!(warning(&text.replace("[0, -25]", "[25, 0]")), None);
}
