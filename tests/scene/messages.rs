//! Malformed scenes are refused with a message that says where, what, and what is allowed.

use std::path::{Path, PathBuf};

use grasp_lcp::scene::{FaultKind, Question, Scene, Setup, Space};
use grasp_lcp::spatial::Wrench;
use grasp_lcp::{Error, Field};

/// Line 1 opens, contacts stand on lines 2 and 3, questions on line 4, settings on line 5.
const GOOD: &str = r#"{"format": "grasp-lcp/1", "planar": {"contacts": [
{"name": "index", "point": [1, 0], "normal": [-1, 0], "series_stiffness": [10, 20], "friction": 0.5},
{"name": "thumb", "point": [-1, 0], "normal": [1, 0], "body_stiffness": "rigid", "finger_stiffness": [10, 20], "command": [0.1, 0]}],
"questions": [{"solve": {"load": {"force": [0, -1]}}}, {"follow": {"legs": [{"commands_by": [[0, 0], [0.1, 0]]}]}}],
"settings": {"cone": "round"}}}"#;

/// The message with `from` replaced by `to`.
fn message(from: &str, to: &str) -> String {
    assert!(GOOD.contains(from), "{from}");
    Scene::from_json(GOOD.replacen(from, to, 1).as_bytes()).expect_err(to).to_string()
}

#[test]
fn the_good_one_is_good() {
    assert_eq!(Scene::from_json(GOOD.as_bytes()).unwrap().answers().unwrap().len(), 2);
}

/// Every case has the message that is expected of it.
fn expect(cases: &[(&str, &str, &str)]) {
    let told = cases.iter().map(|(from, to, expected)| (message(from, to), *expected));
    let wrong: Vec<_> = told.filter(|(told, expected)| told != expected).collect();
    assert!(wrong.is_empty(), "{wrong:#?}");
}

#[test]
fn the_place_of_a_wrong_value_is_named() {
    expect(&[
        (
            "0.5",
            "\"slippery\"",
            "line 2, column 106: planar.contacts[0].friction: \"slippery\" given, must be a number or \"infinite\"",
        ),
        (
            "\"point\": [-1, 0]",
            "\"point\": [-1, 0, 2]",
            "line 3, column 37: planar.contacts[1].point: a list of 3 given, must be 2 numbers in a planar scene",
        ),
        (
            "[10, 20], \"command\"",
            "[], \"command\"",
            "line 3, column 103: planar.contacts[1].finger_stiffness: 0 given, must be one for all directions, or 2 (normal, tangential), each a number or \"rigid\"",
        ),
        (
            "\"rigid\"",
            "\"stiff\"",
            "line 3, column 79: planar.contacts[1].body_stiffness: \"stiff\" given, must be a number or \"rigid\"",
        ),
        (
            "[0, -1]",
            "[0, -1, 0]",
            "line 4, column 54: planar.questions[0].solve.load: force: 3 numbers given, must be 2 in the plane",
        ),
        (
            "[0, -1]",
            "[0, -2e50]",
            "line 4, column 52: planar.questions[0].solve.load.force[1]: -2e50 must be finite and at most 1e50 in size",
        ),
        (
            "\"round\"",
            "\"square\"",
            "line 5, column 29: planar.settings.cone: unknown name `square`, must be `round` or `polygon`",
        ),
        (
            "\"cone\": \"round\"",
            "\"polygon\": {\"facets\": 2}",
            "line 5, column 37: planar.settings.polygon: friction cone: 2 facets, must be from 3 to 4096",
        ),
        (
            "\"cone\": \"round\"",
            "\"step_error\": 0",
            "line 5, column 29: planar.settings: step_error is 0, must be between 0 and 1",
        ),
        (
            "\"questions\"",
            "\"outline\": [[0, 0], [\"infinite\", 0]], \"questions\"",
            "line 4, column 31: planar.outline[1][0]: \"infinite\" given, must be a number",
        ),
    ]);
}

#[test]
fn numbers_out_of_range_are_refused_where_they_stand() {
    expect(&[
        (
            "0.5",
            "-0.5",
            "line 2, column 101: planar.contacts[0]: index: friction coefficient is -0.5, must be from 0 to 1e50, or infinite",
        ),
        (
            "[-1, 0]",
            "[0, 0]",
            "line 2, column 99: planar.contacts[0]: index: normal is 0, must be of positive, finite length",
        ),
        (
            "[10, 20]",
            "[10, 0]",
            "line 2, column 99: planar.contacts[0]: index: series stiffness is 0, must be positive and finite",
        ),
        (
            "0.5",
            "0.5, \"clearance\": -1e51",
            "line 2, column 119: planar.contacts[0].clearance: -1e51 must be finite and at most 1e50 in size",
        ),
        (
            "\"friction\": 0.5",
            "\"soft\": {\"pair\": {\"width\": 0}}",
            "line 2, column 115: planar.contacts[0]: index: soft fingertip: width is 0, must be from 1e-50 to 1e50",
        ),
        (
            "\"friction\": 0.5",
            "\"soft\": {\"ring\": {\"radius\": 1, \"points\": 5}}",
            "line 2, column 129: planar.contacts[0]: index: soft fingertip: number of axes of the patch is 3, must be 2: a pair or a pad",
        ),
        (
            "\"finger_stiffness\": [10, 20], ",
            "",
            "line 3, column 101: planar.contacts[1]: thumb: series stiffness is inf, must be from 1e-50 to 1e50 (give a stiffness, and leave at most one side rigid)",
        ),
    ]);
}

#[test]
fn what_is_missing_doubled_or_unknown_is_named() {
    let cases = [
        (
            "\"friction\"",
            "\"fricton\"",
            "unknown field `fricton` (`friction`?), must be one of `name`, `comment`, `on`, `against`, `point`, `normal`, `tangent`, `body_stiffness`, `finger_stiffness`, `series_stiffness`, `stiffness`, `friction`, `kinetic_friction`, `command`, `command_world`, `pressed_with`, `force`, `clearance`, `hold`, `soft`, `suction`, `surface`, `moved_by`",
        ),
        (
            "\"settings\"",
            "\"setting\"",
            "planar.setting: unknown field `setting` (`settings`?), must be one of `contacts`, `fingers`, `tendons`, `bodies`, `links`, `gravity`, `loaded`, `shared_by_mass`, `outline`, `questions`, `settings`",
        ),
        (
            "\"planar\"",
            "\"plane\"",
            "unknown field `plane` (`planar`?), must be one of `$schema`, `format`, `id`, `comment`, `unit`, `planar`, `spatial`",
        ),
        (
            "\"solve\"",
            "\"slove\"",
            "unknown name `slove` (`solve`?), must be one of `hold`, `need`, `improve`, `solve`, `compare`, `onset`, `onset_of_turn`, `follow`, `shake`, `shakedown`, `identify`",
        ),
        ("\"load\"", "\"lode\"", "unknown field `lode`, must be `load`"),
        (
            "\"force\"",
            "\"forse\"",
            "unknown field `forse` (`force`?), must be one of `force`, `moment`, `at`, `mass`, `inertia`, `gravity`, `accelerated`, `turning`",
        ),
        (
            "\"commands_by\"",
            "\"command_by\"",
            "unknown field `command_by` (`commands_by`?), must be one of `load_by`, `load_to`, `commands_by`, `commands_to`",
        ),
        ("\"point\": [1, 0], ", "", "planar.contacts[0]: missing field `point`"),
        (
            "\"body_stiffness\"",
            "\"series_stiffness\"",
            "planar.contacts[1]: series_stiffness is body and finger together",
        ),
        (
            "\"friction\": 0.5",
            "\"finger_stiffness\": [1, 1]",
            "series_stiffness is body and finger together: give it, or body_stiffness and finger_stiffness",
        ),
        (
            "\"command\": [0.1, 0]",
            "\"command\": [0.1, 0], \"command_world\": [0.1, 0]",
            "planar.contacts[1]: command and command_world: a contact has one of them",
        ),
        ("\"friction\": 0.5", "\"name\": \"thumb\"", "field `name` stands there twice, must be once"),
        ("\"format\": \"grasp-lcp/1\", ", "", "missing field `format`"),
        (
            "{\"commands_by\"",
            "{\"load_to\": {}, \"load_by\": {}, \"commands_by\"",
            "load_by and load_to: a leg has one of them",
        ),
        (
            "[[0, 0], [0.1, 0]]",
            "[[0, 0]]",
            "questions[1]: commands of a leg: 1 given, must be 2, one a contact",
        ),
        (
            "0.5",
            "0.5, \"hold\": \"glued\"",
            "planar.contacts[0].hold: unknown name `glued`, must be one of `unilateral`, `kept_closed`, `bonded`",
        ),
    ];
    for (from, to, expected) in cases {
        let message = message(from, to);
        // Contacts from surfaces have two fields more, robots one.
        let of_features = [
            (cfg!(feature = "mesh"), "`normal`, `tangent`", "`normal`, `touches`, `tangent`"),
            (cfg!(feature = "mesh"), "`outline`, ", "`outline`, `part`, "),
            (cfg!(feature = "urdf"), "`part`, ", "`part`, `robot`, "),
        ];
        let expected = of_features
            .iter()
            .filter(|(is_on, ..)| *is_on)
            .fold(expected.to_owned(), |expected, (_, without, with)| expected.replace(without, with));
        assert!(message.contains(&expected) && message.starts_with("line "), "{message}");
    }
    let empty = r#"{"format": "grasp-lcp/1", "spatial": {"contacts": []}}"#;
    let expected = "spatial: a grasp needs at least one contact, none was given";
    assert_eq!(
        Scene::from_json(empty.as_bytes()).unwrap_err().to_string(),
        format!("line 1, column 53: {expected}")
    );
    let neither = r#"{"format": "grasp-lcp/1"}"#;
    assert!(
        Scene::from_json(neither.as_bytes())
            .unwrap_err()
            .message
            .contains("missing field `planar` or `spatial`")
    );
    let no_version = GOOD.replacen("\"format\": \"grasp-lcp/1\", ", "", 1);
    let told = Scene::from_json(no_version.as_bytes()).unwrap_err().message;
    assert_eq!(told, "missing field `format`: write \"format\": \"grasp-lcp/1\"");
}

#[test]
fn another_version_is_refused_whatever_it_has_in_it() {
    let expected = "format: \"grasp-lcp/2\" is not a format that is read here, must be \"grasp-lcp/1\"";
    assert_eq!(message("grasp-lcp/1", "grasp-lcp/2"), expected);
    let new = r#"{"planar": {"contacts": "of another kind"}, "format": "grasp-lcp/2", "new": true}"#;
    assert_eq!(Scene::from_json(new.as_bytes()).unwrap_err().to_string(), expected);
    // Without the version first, whoever reads by serde alone is told of what comes first.
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
    for (text, said) in [
        ("\n ", "the text is empty, must be a scene"),
        ("// my gripper\n{}", "JSON has no comments: scenes, contacts and bodies have a field `comment`"),
        ("{'format': 1}", "names and texts stand in double quotes, not in single ones"),
    ] {
        let told = Scene::from_json(text.as_bytes()).unwrap_err().to_string();
        assert!(told.contains(said), "{told}");
    }
    let two = format!("{GOOD}\n{GOOD}");
    assert!(
        Scene::from_json(two.as_bytes())
            .unwrap_err()
            .to_string()
            .contains("line 6, column 1: there is more text behind the end of the scene")
    );
}

#[test]
fn what_is_meant_is_said() {
    let told = message(r#"{"solve": {"load": {"force": [0, -1]}}}"#, "\"solve\"");
    let object = r#"must be a question with what it needs, such as {"hold": {"load": {"force": [0, -1]}}}"#;
    assert!(told.contains("planar.questions[0]: \"solve\" given") && told.contains(object), "{told}");
    let marked = format!("\u{feff}{GOOD}");
    let told = Scene::from_json(marked.as_bytes()).unwrap_err().to_string();
    assert!(told.contains("byte-order mark") && told.contains("UTF-8"), "{told}");
    let still = "questions[0]: onset: direction, command_change and joint_change are zero, one of them must change something";
    for ramp in [
        "{}",
        r#"{"direction": {"force": [0, 0]}}"#,
        r#"{"base": {"force": [0, 1]}}"#,
        r#"{"command_change": [[0, 0], [0, -0.0]]}"#,
    ] {
        let told = message(r#"{"solve": {"load": {"force": [0, -1]}}}"#, &format!("{{\"onset\": {ramp}}}"));
        assert!(told.ends_with(still), "{told}");
    }
}

/// What a program puts together is checked when it is asked.
#[test]
fn setups_that_were_not_read_are_checked_as_well() {
    let contact = grasp_lcp::spatial::Contact::new([0.0; 3], [0.0, 0.0, 1.0]).series_stiffness(1.0, 1.0);
    let tip = grasp_lcp::scene::Tip::Ring { radius: 0.1, points: 4 };
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
        assert!(scene.comment.is_some() && scene.answers().unwrap().len() >= 2, "{}", file.display());
        let back: Scene = serde_json::from_str(&serde_json::to_string(&scene).unwrap()).unwrap();
        assert_eq!(back, scene);
    }
}

#[test]
fn the_papers_grasps_are_those_of_the_paper() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../examples/scenes");
    let Space::Planar(fingers) = read(&folder.join("paper_two_fingers.json")).space else {
        panic!("is planar")
    };
    let grasp = fingers.grasp().unwrap();
    let down = grasp_lcp::planar::Wrench::force([0.0, -1.0]);
    let onset = grasp.onset(down).unwrap();
    assert!((onset.factor().unwrap() - 65f64.sqrt() / 66.0).abs() < 1e-15);
    let Space::Planar(disk) = read(&folder.join("paper_disk.json")).space else { panic!("is planar") };
    let state = disk.grasp().unwrap().solve(grasp_lcp::planar::Wrench::new([0.1, 0.2], 0.3)).unwrap();
    let forces = state.equilibrium().unwrap().contacts.iter().map(|c| c.force_world).collect::<Vec<_>>();
    // As printed, to what the printed normals are off.
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
