//! Bodies with masses can be tilted and accelerated under the scene's gravity, and no weight is counted twice.

use grasp_lcp::Settings;
use grasp_lcp::scene::Scene;

/// A box of 1 kg on a tray of 0.2 m, μ = 0.4, its centre of mass 0.05 m up.
fn on_a_tray(question: &str) -> String {
    format!(
        r#"{{"format": "grasp-lcp/1", "planar": {{"gravity": [0, -9.81],
        "bodies": [{{"name": "box", "mass": 1, "centre_of_mass": [0, 0.05]}}, {{"name": "lid", "mass": 0.5, "centre_of_mass": [0, 0.12]}}],
        "contacts": [
            {{"name": "tray", "on": "box", "point": [0, 0], "normal": [0, 1], "friction": 0.4, "stiffness": 1e6, "soft": {{"pair": {{"width": 0.2}}}}}},
            {{"name": "rim", "on": "lid", "against": "box", "point": [0, 0.1], "normal": [0, 1], "friction": 0.6, "stiffness": 1e6, "soft": {{"pair": {{"width": 0.2}}}}}}],
        "questions": [{question}]}}}}"#
    )
}

/// The tray in space, tilted about the axis -y.
const IN_SPACE: &str = r#"{"format": "grasp-lcp/1", "spatial": {"gravity": [0, 0, -9.81],
    "bodies": [{"name": "box", "mass": 2, "centre_of_mass": [0, 0, 0.01]}],
    "contacts": [{"on": "box", "point": [0, 0, 0], "normal": [0, 0, 1], "tangent": [1, 0, 0], "friction": 0.4, "stiffness": 1e6, "soft": {"rectangle": {"sides": [0.2, 0.2]}}}],
    "questions": [{"need": {"quantity": "angle", "demand": "held", "turn": {"axis": [0, -2, 0]}}}]}}"#;

fn answer(text: &str) -> serde_json::Value {
    let scene = Scene::from_json(text.as_bytes()).unwrap_or_else(|fault| panic!("{fault}"));
    let again: Scene = serde_json::from_value(serde_json::to_value(&scene).expect("written")).expect("read");
    assert_eq!(scene, again);
    serde_json::to_value(scene.answers().expect("well posed")).expect("written")
}

/// A box on a tray slides at the angle of friction, for every weight.
#[test]
fn gravity_itself_turns() {
    let expected = 0.4_f64.atan().to_degrees();
    let plane = on_a_tray(r#"{"need": {"quantity": "angle", "demand": "held", "turn": {"angle_deg": 80}}}"#);
    for text in [plane.as_str(), &plane.replace(r#""angle_deg": 80"#, r#""reversed": true"#), IN_SPACE] {
        let says = answer(text)[0]["need"]["says"].as_str().expect("a sentence").to_owned();
        let told =
            says.split_whitespace().nth(1).and_then(|angle| angle.trim_end_matches('°').parse::<f64>().ok());
        assert!(told.is_some_and(|angle| (angle - expected).abs() < 1e-3), "{says}");
    }
}

/// Under the scene's gravity, the angle of first slip equals that of bodies without gravity whose weight is given as a load.
#[test]
fn an_onset_is_that_of_the_weight_as_a_load() {
    let own = on_a_tray(r#"{"onset_of_turn": {"angle_deg": 80}}"#);
    let centre = (0.05 + 0.5 * 0.12) / 1.5;
    let turn = format!(r#"{{"weight": [0, {}], "at": [0, {centre}], "angle_deg": 80}}"#, -1.5 * 9.81);
    let as_load = own.replacen(r#""gravity": [0, -9.81]"#, r#""shared_by_mass": true"#, 1);
    let as_load = as_load.replacen(r#"{"angle_deg": 80}"#, &turn, 1);
    let [own, as_load] = [own, as_load].map(|text| answer(&text)[0]["onset_of_turn"]["angle_rad"].as_f64());
    let (own, as_load) = (own.expect("slides"), as_load.expect("slides"));
    assert!((own - as_load).abs() < 1e-12, "{own} {as_load}");
}

fn refused(question: &str) -> String {
    Scene::from_json(on_a_tray(question).as_bytes()).expect_err(question).to_string()
}

#[test]
fn a_weight_that_is_there_already_is_refused() {
    for (question, field, body, instead) in [
        (
            r#"{"need": {"quantity": "angle", "turn": {"weight": [0, -9.81], "at": [0, 0.05]}}}"#,
            "need.turn.weight",
            "box",
            "gravity itself turns",
        ),
        (r#"{"hold": {"load": {"mass": 1}}}"#, "hold.load.mass", "box", "\"gravity\" all zeros"),
        (
            r#"{"hold": {"load": {"force": [1, 0]}, "together_with": {"lid": {"mass": 1}}}}"#,
            "hold.together_with.lid.mass",
            "lid",
            "\"gravity\" all zeros",
        ),
        (
            r#"{"follow": {"legs": [{"turn": {"weight": [0, -1]}}]}}"#,
            "follow.legs[0].turn.weight",
            "box",
            "gravity itself turns",
        ),
    ] {
        let told = refused(question);
        assert!(told.starts_with(&format!("planar.questions[0].{field}: ")), "{told}");
        assert!(told.contains(&format!(" {body}, ")) && told.ends_with(instead), "{told}");
    }
}

#[test]
fn what_counts_no_weight_twice_is_answered() {
    for question in [
        r#"{"hold": {"load": {"mass": 1, "gravity": [0, 0], "accelerated": [1, 0], "at": [0, 0.05]}}}"#,
        r#"{"hold": {"load": {"force": [0, -9.81]}}}"#,
        r#"{"onset_of_turn": {"force": [1, 0], "at": [0, 0.05]}}"#,
    ] {
        answer(&on_a_tray(question));
    }
}

#[test]
fn nothing_turns_where_no_body_has_a_weight() {
    let question = r#"{"onset_of_turn": {"angle_deg": 80}}"#;
    let weightless = on_a_tray(question).replace(r#""gravity": [0, -9.81],"#, "");
    let told = Scene::from_json(weightless.as_bytes()).expect_err("no weight").to_string();
    assert!(told.contains("questions[0]: turn: ") && told.contains("weight is missing"), "{told}");
    let leg = r#"{"follow": {"start": {"force": [0, -1]}, "legs": [{"turn": {}}]}}"#;
    let scene = Scene::from_json(on_a_tray(leg).as_bytes()).expect("a leg");
    assert!(scene.answers().is_err_and(|error| error.to_string().contains("onset_of_turn")));
}

#[test]
fn a_base_beside_the_gravity_that_turns_is_refused() {
    let told = refused(r#"{"need": {"quantity": "angle", "turn": {}, "base": {"force": [1, 0]}}}"#);
    assert!(told.contains("need: base given") && told.contains("gravity turns"), "{told}");
}

/// Gravity that turns makes the grasp anew, with the settings of the grasp that was given.
#[test]
fn settings_are_kept_where_gravity_turns() {
    let scene = Scene::from_json(IN_SPACE.as_bytes()).expect("a scene");
    let setup = scene.spatial().expect("a scene in space");
    let mut settings = Settings::default();
    settings.small_motions.rotation = 1e-9;
    let grasp = setup.grasp().expect("well posed").with(&settings);
    let tilted = setup.grasp_of(&grasp, &setup.questions[0]).expect("a weight that turns");
    assert_eq!(tilted.settings().small_motions, settings.small_motions);
}

/// A scene may state a gravity also if only loads have masses. This gravity pulls at the masses of loads too, unless a load has its own gravity.
#[test]
fn the_gravity_of_a_scene_pulls_at_masses_in_loads() {
    let of = |load: &str| {
        let contacts = r#"[{"name": "l", "on": "box", "point": [-0.03, 0, 0], "normal": [1, 0, 0], "friction": 0.5, "stiffness": 1e5, "pressed_with": 10},
            {"name": "r", "on": "box", "point": [0.03, 0, 0], "normal": [-1, 0, 0], "friction": 0.5, "stiffness": 1e5, "pressed_with": 10}]"#;
        let bodies = r#""bodies": [{"name": "box"}], "gravity": [0, -9.81, 0]"#;
        let text = format!(
            r#"{{"format": "grasp-lcp/1", "spatial": {{{bodies}, "contacts": {contacts}, "questions": [{{"hold": {{"load": {load}}}}}]}}}}"#
        );
        answer(&text)[0]["hold"]["load"]["force"].as_array().expect("a force").clone()
    };
    assert_eq!(of(r#"{"mass": 0.5}"#), [0.0, -4.905, 0.0]);
    assert_eq!(of(r#"{"mass": 0.5, "gravity": [0, 0, -9.81]}"#), [0.0, 0.0, -4.905]);
}

/// On an arm that turns, each body has the acceleration of its own place, not that of the common centre of mass.
#[test]
fn a_turning_arm_with_loads_shared_by_mass_is_refused() {
    let shared = |question: &str| {
        on_a_tray(question).replacen(r#""gravity": [0, -9.81]"#, r#""shared_by_mass": true"#, 1)
    };
    let load = r#"{"mass": 1.5, "at": [0, 0], "turning": {"about": [1, 0], "velocity_deg": 90}}"#;
    let fault = Scene::from_json(shared(&format!(r#"{{"hold": {{"load": {load}}}}}"#)).as_bytes());
    let fault = fault.expect_err("turns").to_string();
    assert!(
        fault.contains("questions[0].hold.load.turning: must be left out where bodies share loads"),
        "{fault}"
    );
    // The inertia of one body alone may turn.
    let on_one =
        format!(r#"{{"hold": {{"load": {{"force": [0, -1]}}, "together_with": {{"lid": {load}}}}}}}"#);
    let lone = Scene::from_json(on_a_tray(&on_one).replacen(r#""gravity": [0, -9.81],"#, "", 1).as_bytes());
    assert!(lone.is_ok(), "{lone:?}");
}
