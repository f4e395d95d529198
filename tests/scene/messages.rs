//! Malformed scenes are refused with a message that gives the place, the fault and what is allowed.

use std::path::{Path, PathBuf};

use grasp_lcp::scene::{Fault, FaultKind, Question, Scene, Setup};
use grasp_lcp::spatial::Wrench;
use grasp_lcp::{Error, Field};

/// A valid scene, which the tests change at one place. Contacts are on lines 2 and 3, questions on line 4, settings on line 5.
const GOOD: &str = r#"{"format": "grasp-lcp/1", "planar": {"contacts": [
{"name": "index", "point": [1, 0], "normal": [-1, 0], "series_stiffness": [10, 20], "friction": 0.5},
{"name": "thumb", "point": [-1, 0], "normal": [1, 0], "body_stiffness": "rigid", "finger_stiffness": [10, 20], "command": [0.1, 0]}],
"questions": [{"solve": {"load": {"force": [0, -1]}}}, {"follow": {"legs": [{"commands_by": [[0, 0], [0.1, 0]]}]}}],
"settings": {"cone": "round"}}}"#;

/// The fault of the scene with `from` replaced by `to`.
fn fault(from: &str, to: &str) -> Fault {
    assert!(GOOD.contains(from), "{from}");
    Scene::from_json(GOOD.replacen(from, to, 1).as_bytes()).expect_err(to)
}

#[test]
fn the_good_one_is_good() {
    assert_eq!(Scene::from_json(GOOD.as_bytes()).unwrap().answers().unwrap().list().len(), 2);
}

/// A case: the text to replace, its replacement, the line and the column of the fault, the field, and the message about the value.
type Case<'a> = (&'a str, &'a str, [usize; 2], &'a str, &'a str);

fn expect(cases: &[Case]) {
    for (from, to, [line, column], field, said) in cases {
        let fault = fault(from, to);
        assert_eq!(fault.at.map(|at| [at.line, at.column]), Some([*line, *column]), "{fault}");
        assert_eq!(fault.field.as_deref(), Some(*field), "{fault}");
        assert!(fault.kind == FaultKind::Scene && fault.message.contains(said), "{fault}");
    }
}

#[test]
fn the_place_of_a_wrong_value_is_named() {
    expect(&[
        ("0.5", "\"slippery\"", [2, 106], "planar.contacts[0].friction", "\"slippery\" given"),
        ("\"point\": [-1, 0]", "\"point\": [-1, 0, 2]", [3, 37], "planar.contacts[1].point", "be 2 numbers"),
        (
            "[10, 20], \"command\"",
            "[], \"command\"",
            [3, 103],
            "planar.contacts[1].finger_stiffness",
            "0 given",
        ),
        ("\"rigid\"", "\"stiff\"", [3, 79], "planar.contacts[1].body_stiffness", "\"stiff\" given"),
        ("[0, -1]", "[0, -1, 0]", [4, 54], "planar.questions[0].solve.load", "force: 3 numbers"),
        ("[0, -1]", "[0, -2e50]", [4, 52], "planar.questions[0].solve.load.force[1]", "-2e50 must"),
        ("\"round\"", "\"square\"", [5, 29], "planar.settings.cone", "name `square`"),
        (
            "\"cone\": \"round\"",
            "\"polygon\": {\"facets\": 2}",
            [5, 37],
            "planar.settings.polygon",
            "2 facets",
        ),
        ("\"cone\": \"round\"", "\"step_error\": 0", [5, 29], "planar.settings", "step_error is 0"),
        (
            "\"questions\"",
            "\"outline\": [[0, 0], [\"infinite\", 0]], \"questions\"",
            [4, 31],
            "planar.outline[1][0]",
            "\"infinite\" given",
        ),
    ]);
}

#[test]
fn numbers_out_of_range_are_refused_where_they_stand() {
    let first = "planar.contacts[0]";
    expect(&[
        ("0.5", "-0.5", [2, 101], first, "friction coefficient is -0.5"),
        ("[-1, 0]", "[0, 0]", [2, 99], first, "index: normal is 0"),
        ("[10, 20]", "[10, 0]", [2, 99], first, "series stiffness is 0"),
        ("0.5", "0.5, \"clearance\": -1e51", [2, 119], "planar.contacts[0].clearance", "-1e51 must"),
        (
            "\"friction\": 0.5",
            "\"soft\": {\"pair\": {\"width\": 0}}",
            [2, 115],
            first,
            "fingertip: width is 0",
        ),
        (
            "\"friction\": 0.5",
            r#""soft": {"ring": {"radius": 1, "points": 5}}"#,
            [2, 129],
            first,
            "patch is 3, must",
        ),
        ("\"finger_stiffness\": [10, 20], ", "", [3, 101], "planar.contacts[1]", "stiffness is inf"),
    ]);
    // The message about a contact begins with its name.
    assert!(fault("0.5", "-0.5").message.starts_with("index: "));
}

#[test]
fn what_is_missing_doubled_or_unknown_is_named() {
    // For each case: the text to replace, its replacement, and two parts of the message.
    let cases = [
        ("\"friction\"", "\"fricton\"", "field `fricton` (`friction`?)", "`hold`, `soft`, "),
        ("\"settings\"", "\"setting\"", "field `setting` (`settings`?)", "`questions`, `settings`"),
        ("\"planar\"", "\"plane\"", "field `plane` (`planar`?)", "`planar`, `spatial`"),
        ("\"solve\"", "\"slove\"", "name `slove` (`solve`?)", "`solve`, `compare`"),
        ("\"load\"", "\"lode\"", "unknown field `lode`", "be `load`"),
        ("\"force\"", "\"forse\"", "field `forse` (`force`?)", "`force`, `moment`, "),
        ("\"commands_by\"", "\"command_by\"", "field `command_by`", "`commands_by`, "),
        ("\"point\": [1, 0], ", "", "missing field `point`", ""),
        ("\"body_stiffness\"", "\"series_stiffness\"", "series_stiffness is", "body and finger"),
        ("\"friction\": 0.5", "\"finger_stiffness\": [1, 1]", "series_stiffness is", "finger_stiffness"),
        (
            "\"command\": [0.1, 0]",
            "\"command\": [0.1, 0], \"command_world\": [0.1, 0]",
            "command_world",
            "one of them",
        ),
        ("\"friction\": 0.5", "\"name\": \"thumb\"", "field `name`", "twice"),
        ("\"format\": \"grasp-lcp/1\", ", "", "missing field `format`", ""),
        (
            "{\"commands_by\"",
            "{\"load_to\": {}, \"load_by\": {}, \"commands_by\"",
            "and load_to",
            "one of them",
        ),
        ("[[0, 0], [0.1, 0]]", "[[0, 0]]", "1 given", "be 2"),
        ("0.5", "0.5, \"hold\": \"glued\"", "name `glued`", "`kept_closed`, `bonded`"),
        ("\"planar\": {\"contacts\"", "\"contacts\"", "`contacts` (it stands inside `planar` or", "`unit`"),
        ("\"planar\": {\"contacts\"", "\"questions\"", "`questions` (it stands inside `planar`", "`unit`"),
        (
            "{\"load\": {\"force\": [0, -1]}}",
            "{\"force\": [0, -1]}",
            "`force` (it stands inside `load`",
            "`load`",
        ),
    ];
    for (from, to, said, allowed) in cases {
        let fault = fault(from, to);
        assert!(fault.at.is_some() && fault.message.contains(said), "{fault}");
        assert!(fault.message.contains(allowed), "{fault}");
    }
    for (from, to, field) in [
        ("\"friction\"", "\"fricton\"", "planar.contacts[0].fricton"),
        ("\"settings\"", "\"setting\"", "planar.setting"),
        ("\"point\": [1, 0], ", "", "planar.contacts[0]"),
        ("\"body_stiffness\"", "\"series_stiffness\"", "planar.contacts[1]"),
        ("0.5", "0.5, \"hold\": \"glued\"", "planar.contacts[0].hold"),
    ] {
        assert_eq!(fault(from, to).field.as_deref(), Some(field));
    }
    // The features `mesh` and `urdf` add further fields to the format, which messages then list.
    for (is_on, from, to, field) in [
        (cfg!(feature = "mesh"), "\"friction\"", "\"fricton\"", "`touches`"),
        (cfg!(feature = "mesh"), "\"settings\"", "\"setting\"", "`part`"),
        (cfg!(feature = "urdf"), "\"settings\"", "\"setting\"", "`robot`"),
    ] {
        assert_eq!(fault(from, to).message.contains(field), is_on, "{field}");
    }
    let fault_of = |text: &str| Scene::from_json(text.as_bytes()).unwrap_err();
    let empty = fault_of(r#"{"format": "grasp-lcp/1", "spatial": {"contacts": []}}"#);
    assert_eq!(empty.message, Error::EmptyGrasp.to_string());
    assert_eq!((empty.field.as_deref(), empty.at.map(|at| at.column)), (Some("spatial"), Some(53)));
    let neither = fault_of(r#"{"format": "grasp-lcp/1"}"#);
    assert!(neither.message.contains("`planar` or `spatial`"), "{neither}");
    let no_version = fault_of(&GOOD.replacen("\"format\": \"grasp-lcp/1\", ", "", 1));
    assert!(no_version.message.ends_with("write \"format\": \"grasp-lcp/1\""), "{no_version}");
}

#[test]
fn another_version_is_refused_whatever_it_has_in_it() {
    let other = fault("grasp-lcp/1", "grasp-lcp/2");
    assert_eq!(other.field.as_deref(), Some("format"));
    assert!(
        other.message.starts_with("\"grasp-lcp/2\"") && other.message.ends_with("\"grasp-lcp/1\""),
        "{other}"
    );
    let new = r#"{"planar": {"contacts": "of another kind"}, "format": "grasp-lcp/2", "new": true}"#;
    assert_eq!(Scene::from_json(new.as_bytes()).unwrap_err(), other);
    // If `format` is not the first field, reading by serde alone finds a fault in an earlier field. `from_json` looks at the version first.
    assert!(serde_json::from_str::<Scene>(new).is_err());
}

#[test]
fn what_is_no_json_is_no_scene() {
    for (text, line) in
        [("", 1), ("{", 1), ("{\"format\": \"grasp-lcp/1\",\n\n planar", 3), ("\u{feff}{}", 1)]
    {
        let fault = Scene::from_json(text.as_bytes()).unwrap_err();
        assert_eq!(
            (fault.kind, fault.at.map(|at| at.line)),
            (FaultKind::Syntax, Some(line)),
            "{text}: {fault}"
        );
    }
    for (text, said) in
        [("\n ", "is empty"), ("// my gripper\n{}", "no comments"), ("{'format': 1}", "double quotes")]
    {
        let told = Scene::from_json(text.as_bytes()).unwrap_err().message;
        assert!(told.contains(said), "{told}");
    }
    let two = Scene::from_json(format!("{GOOD}\n{GOOD}").as_bytes()).unwrap_err();
    assert!(two.message.contains("more text"), "{two}");
    assert_eq!(two.at.map(|at| [at.line, at.column]), Some([6, 1]));
}

#[test]
fn what_is_meant_is_said() {
    let solve = r#"{"solve": {"load": {"force": [0, -1]}}}"#;
    let told = fault(solve, "\"solve\"");
    let object = r#"{"hold": {"load": {"force": [0, -1]}}}"#;
    assert_eq!(told.field.as_deref(), Some("planar.questions[0]"));
    assert!(told.message.starts_with("\"solve\" given") && told.message.contains(object), "{told}");
    let marked = format!("\u{feff}{GOOD}");
    let told = Scene::from_json(marked.as_bytes()).unwrap_err().to_string();
    assert!(told.contains("byte-order mark") && told.contains("UTF-8"), "{told}");
    for ramp in [
        "{}",
        r#"{"direction": {"force": [0, 0]}}"#,
        r#"{"base": {"force": [0, 1]}}"#,
        r#"{"command_change": [[0, 0], [0, -0.0]]}"#,
    ] {
        let told = fault(solve, &format!("{{\"onset\": {ramp}}}"));
        let still = format!("questions[0]: {}", Error::NothingChanges);
        assert!(told.message.ends_with(&still), "{told}");
    }
}

/// Setups built in Rust are validated when they are asked.
#[test]
fn setups_that_were_not_read_are_checked_as_well() {
    let contact = grasp_lcp::spatial::Contact::new([0.0; 3], [0.0, 0.0, 1.0]).series_stiffness(1.0, 1.0);
    let tip = grasp_lcp::scene::FingertipPatch::Ring { radius: 0.1, points: 4 };
    let soft = grasp_lcp::scene::Fingertip::from(contact.clone()).soft(tip.clone());
    let ask = Question::solve(Wrench::ZERO);
    let bad = grasp_lcp::scene::Fingertip::from(contact.friction(-1.0));
    for bad in [bad.clone(), bad.soft(tip)] {
        let error = Setup::new([soft.clone(), bad]).ask(ask.clone()).answers().unwrap_err();
        let Error::Contact { contact, field: Field::Friction, value: -1.0, .. } = error else {
            panic!("{error}")
        };
        assert_eq!(contact.index, 1);
    }
    assert_eq!(Setup::<3>::new([]).ask(ask).answers().unwrap_err(), Error::EmptyGrasp);
}

fn read(path: &Path) -> Scene {
    Scene::from_json(&std::fs::read(path).unwrap()).unwrap()
}

fn examples() -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../examples/scenes");
    let files = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    let scenes: Vec<_> = files.filter(|path| path.extension().is_some_and(|e| e == "json")).collect();
    assert!(scenes.len() >= 8);
    scenes
}

#[test]
fn the_scene_files_are_answered() {
    for file in examples() {
        let scene = read(&file);
        assert!(scene.comment.is_some() && scene.answers().unwrap().list().len() >= 2, "{}", file.display());
        let back: Scene = serde_json::from_str(&serde_json::to_string(&scene).unwrap()).unwrap();
        assert_eq!(back, scene);
    }
}

#[test]
fn the_papers_grasps_are_those_of_the_paper() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../examples/scenes");
    let Some(fingers) = read(&folder.join("paper_two_fingers.json")).planar() else { panic!("is planar") };
    let grasp = fingers.grasp().unwrap();
    let down = grasp_lcp::planar::Wrench::force([0.0, -1.0]);
    let onset = grasp.onset(down).unwrap();
    assert!((onset.factor().unwrap() - 65f64.sqrt() / 66.0).abs() < 1e-15);
    let Some(disk) = read(&folder.join("paper_disk.json")).planar() else { panic!("is planar") };
    let state = disk.grasp().unwrap().solve(grasp_lcp::planar::Wrench::new([0.1, 0.2], 0.3)).unwrap();
    let forces = state.equilibrium().unwrap().contacts.iter().map(|c| c.force_world).collect::<Vec<_>>();
    // The forces that the paper prints, to the accuracy of its printed normals.
    for (force, printed) in forces.iter().zip([[4.2496, 2.5216], [-4.4164, 2.3483], [0.0666, -5.0651]]) {
        assert!((force - nalgebra::Vector2::from(printed)).norm() < 4e-3, "{force}");
    }
}

#[test]
fn the_scene_in_the_tour_is_that_of_the_paper() {
    let tour = include_str!("../../src/guide/tour.md");
    let scene = tour.split("```json\n").nth(1).and_then(|rest| rest.split("```").next()).unwrap();
    let answers =
        serde_json::to_value(Scene::from_json(scene.as_bytes()).unwrap().answers().unwrap()).unwrap();
    let factor = answers[0]["onset"]["factor"].as_f64().unwrap();
    assert!((factor - 65f64.sqrt() / 66.0).abs() < 1e-15);
}
