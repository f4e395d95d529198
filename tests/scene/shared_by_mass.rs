//! A force that all bodies share by mass acts on each at its centre of mass unless a point is given, and bodies are accelerated by their own masses.

use grasp_lcp::scene::{Answer, Scene};

/// Three boxes of 100 kg, 0.6 m wide and 0.5 m high, on each other: μ = 0.5.
///
/// Their centre of mass is 0.75 m up, so that they tip at 0.3/0.75 = 0.4 of their weight and would slide at 0.5 of it.
fn boxes(question: &str) -> String {
    let face = |name: &str, y: f64, of: &str| {
        format!(
            r#"{{"name": "{name}", {of}, "point": [0, {y}], "normal": [0, 1], "friction": 0.5, "stiffness": 1e7, "soft": {{"pair": {{"width": 0.6}}}}}}"#
        )
    };
    let faces = [
        face("floor", 0.0, r#""on": "bottom""#),
        face("lower", 0.5, r#""on": "middle", "against": "bottom""#),
        face("upper", 1.0, r#""on": "top", "against": "middle""#),
    ];
    format!(
        r#"{{"format": "grasp-lcp/1", "planar": {{"gravity": [0, -9.81], "shared_by_mass": true,
        "bodies": [{{"name": "bottom", "mass": 100, "centre_of_mass": [0, 0.25]}}, {{"name": "middle", "mass": 100, "centre_of_mass": [0, 0.75]}},
            {{"name": "top", "mass": 100, "centre_of_mass": [0, 1.25]}}],
        "contacts": [{}], "questions": [{question}]}}}}"#,
        faces.join(", ")
    )
}

/// The multiple of the load at which the boxes are lost.
fn lost(text: &str) -> f64 {
    let scene = Scene::from_json(text.as_bytes()).unwrap_or_else(|fault| panic!("{fault}"));
    match &scene.answers().expect("well posed").planar().expect("in the plane")[0] {
        Answer::Hold(answer) => answer.verdict.lost.as_ref().expect("tips or slides").factor,
        other => panic!("{other:?}"),
    }
}

const WEIGHT: f64 = 300.0 * 9.81;

#[test]
fn a_force_acts_at_the_common_centre_of_mass() {
    for (load, factor) in [
        (format!(r#"{{"force": [{WEIGHT}, 0]}}"#), 0.4),
        (format!(r#"{{"force": [{WEIGHT}, 0], "at": [0, 0.75]}}"#), 0.4),
        (format!(r#"{{"force": [{WEIGHT}, 0], "at": [0, 0]}}"#), 0.5),
        // A load in the form in which answers are written (force and moment) has its moment about the origin.
        (format!(r#"{{"force": [{WEIGHT}, 0], "moment": 0}}"#), 0.5),
        (r#"{"accelerated": [-9.81, 0]}"#.to_owned(), 0.4),
        (r#"{"mass": 300, "gravity": [0, 0], "accelerated": [-9.81, 0]}"#.to_owned(), 0.4),
    ] {
        let found = lost(&boxes(&format!(r#"{{"hold": {{"load": {load}}}}}"#)));
        assert!((found - factor).abs() < 1e-9, "{load}: {found}");
    }
}

/// If a scene has a unit of length, its centres of mass have this unit too.
#[test]
fn in_millimetres() {
    let text = boxes(&format!(r#"{{"hold": {{"load": {{"force": [{WEIGHT}, 0]}}}}}}"#))
        .replacen(r#""planar""#, r#""unit": "mm", "planar""#, 1)
        .replace("0.25]", "250]")
        .replace("0.75]", "750]")
        .replace("1.25]", "1250]")
        .replace("[0, 0.5]", "[0, 500]")
        .replace(r#""point": [0, 1]"#, r#""point": [0, 1000]"#)
        .replace(r#""width": 0.6"#, r#""width": 600"#);
    assert!((lost(&text) - 0.4).abs() < 1e-9, "{}", lost(&text));
}

/// A box alone shares no load with other bodies. Its centre of mass is 0.8 m up, so that it tips before it slides.
#[test]
fn one_body_is_accelerated_by_its_own_mass() {
    let text = r#"{"format": "grasp-lcp/1", "planar": {"gravity": [0, -9.81], "bodies": [{"name": "box", "mass": 7, "centre_of_mass": [0, 0.8]}],
        "contacts": [{"name": "floor", "on": "box", "point": [0, 0], "normal": [0, 1], "friction": 0.5, "stiffness": 1e7, "soft": {"pair": {"width": 0.6}}}],
        "questions": [{"hold": {"load": {"accelerated": [-9.81, 0]}}}]}}"#;
    assert!((lost(text) - 0.3 / 0.8).abs() < 1e-9, "{}", lost(text));
}

#[test]
fn what_cannot_be_completed_is_refused() {
    let alone = boxes(r#"{"hold": {"load": {"accelerated": [-9.81, 0]}}}"#);
    for without in [r#""shared_by_mass": true,"#, r#""gravity": [0, -9.81], "#] {
        let fault = Scene::from_json(alone.replacen(without, "", 1).as_bytes()).expect_err("no mass");
        assert_eq!(fault.field.as_deref(), Some("planar.questions[0].hold.load"), "{fault}");
        assert!(fault.at.is_some() && fault.message.contains("\"shared_by_mass\""), "{fault}");
    }
    let wrong = alone.replacen("-9.81, 0]}}}", "-9.81, 0]}}}, {\"holds\": 1}", 1);
    let fault = Scene::from_json(wrong.as_bytes()).expect_err("no such question");
    assert!(fault.message.contains("holds") && fault.at.is_none(), "{fault}");
}
