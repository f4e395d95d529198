//! `draw` makes a picture for every question of a scene. Names do not overlap, and nothing leaves the sheet.

use std::path::Path;

use serde_json::Value;
use support::svg::{outside, overlap, plaques, shapes};

use crate::{ROOT, folder, run, run_on, text};

/// One question of each kind, and questions without an equilibrium.
const KINDS: &str = r#"{
    "format": "grasp-lcp/1",
    "planar": {
        "contacts": [
            { "name": "left", "point": [-0.04, 0], "normal": [1, 0], "series_stiffness": [2e3, 1.5e3], "friction": 0.5, "pressed_with": 8 },
            { "name": "right", "point": [0.04, 0], "normal": [-1, 0], "series_stiffness": [2e3, 1.5e3], "friction": 0.5, "pressed_with": 8 }
        ],
        "outline": [[-0.04, -0.05], [0.04, -0.05], [0.04, 0.05], [-0.04, 0.05]],
        "questions": [
            { "hold": { "load": { "force": [0, -4] } } },
            { "hold": { "load": { "force": [0, -9.81], "at": [0.01, 0] } } },
            { "need": { "quantity": "squeeze", "load": { "force": [0, -9.81] } } },
            { "need": { "quantity": "friction", "load": { "force": [0, -9.81] } } },
            { "need": { "quantity": "angle", "turn": { "weight": [0, -7.4] } } },
            { "need": { "quantity": "load", "any_force": 5, "load": { "force": [0, -2] } } },
            { "solve": { "load": { "force": [0, -4] } } },
            { "solve": { "load": { "force": [0, -40] } } },
            { "onset": { "direction": { "force": [0, -1] } } },
            { "onset": { "base": { "force": [0, -50] }, "direction": { "force": [0, -1] } } },
            { "onset_of_turn": { "weight": [0, -7] } },
            { "follow": { "legs": [{ "load_to": { "force": [0, -6] } }, { "load_to": { "force": [10, -6] } }] } }
        ]
    }
}"#;
/// Text in the picture of each question.
const SAID: [&str; 12] = [
    "HOLDS, everything sticks",
    "where it goes",
    "NEEDS 9.81 N",
    "friction of 0.613",
    "TAKES 11.79",
    "TAKES 1.",
    "EQUILIBRIUM under (0, -4) N",
    "at 8 N of 40 N",
    "FIRST SLIP at 8 N",
    "NO EQUILIBRIUM where",
    "nothing slides",
    "where it goes",
];

/// All text of a picture.
fn words(svg: &str) -> String {
    let texts = shapes(svg).expect("is read").into_iter().filter(|shape| shape.tag == "text");
    texts.map(|text| text.words).collect::<Vec<_>>().join(" ")
}

fn check(what: &str, svg: &str) {
    let names = plaques(svg).expect("is read");
    assert_eq!(overlap(&names), None, "{what}");
    let outside = outside(svg).expect("is read");
    assert!(outside.is_none(), "{what}: {outside:?}");
}

fn picture(folder: &Path, scene: &str, number: usize) -> String {
    let name = if number == 1 { format!("{scene}.svg") } else { format!("{scene}_{number}.svg") };
    std::fs::read_to_string(folder.join(&name)).unwrap_or_else(|error| panic!("{name}: {error}"))
}

#[test]
fn every_kind_of_question_is_drawn() {
    let folder = folder("kinds");
    let drawn =
        run_on(KINDS.as_bytes(), &["draw", "-", "--name", "kinds", "-o", &folder.display().to_string()]);
    assert!(drawn.status.success(), "{}", text(&drawn.stderr));
    for (k, said) in SAID.iter().enumerate() {
        let svg = picture(&folder, "kinds", k + 1);
        assert!(words(&svg).contains(said), "question {}: {}", k + 1, words(&svg));
        check(&format!("question {}", k + 1), &svg);
        // Every picture has two arrows of contacts and one of the load.
        let load =
            shapes(&svg).expect("is read").into_iter().filter(|s| s.ink == "#000000" && s.width == Some(3.0));
        assert_eq!(load.count(), 1, "question {}", k + 1);
    }
    // Questions about holding, first slip, turning loads and load programs have charts of their paths.
    let charts = words(&std::fs::read_to_string(folder.join("kinds_friction.svg")).expect("is there"));
    for chart in [1, 2, 9, 11, 12].map(|number| format!("kinds, question {number}")) {
        assert!(charts.contains(&chart), "{chart}: {charts}");
    }
    assert!(charts.contains("legs of the") && charts.contains("this load"));
}

#[test]
fn slips_of_a_load_that_repeats_are_drawn_cycle_by_cycle() {
    let folder = folder("cycles");
    for (name, charts) in [("block", 2), ("fixture", 2), ("tool", 1)] {
        let scene = Path::new(ROOT).join(format!("examples/scenes/repeat/{name}.json")).display().to_string();
        let drawn = run(&["draw", &scene, "-o", &folder.display().to_string()]);
        assert!(drawn.status.success(), "{name}: {}", text(&drawn.stderr));
        let svg = std::fs::read_to_string(folder.join(format!("{name}_cycles.svg"))).expect("is there");
        assert!(words(&svg).contains("question 1: slip"), "{name}");
        // A load that comes to rest has no hysteresis loop.
        assert_eq!(words(&svg).contains("question 1: friction"), charts == 2, "{name}");
        check(name, &svg);
    }
}

#[test]
fn the_questions_of_all_example_scenes_are_drawn() {
    let folder = folder("examples");
    let output = folder.display().to_string();
    for entry in std::fs::read_dir(Path::new(ROOT).join("examples/scenes")).expect("is there") {
        let path = entry.expect("a file").path();
        if path.extension().is_none_or(|end| end != "json") {
            continue;
        }
        let name = path.file_stem().expect("a name").to_string_lossy().into_owned();
        let drawn = run(&["draw", &path.display().to_string(), "-o", &output]);
        assert!(drawn.status.success(), "{name}: {}", text(&drawn.stderr));
        let scene: Value = serde_json::from_slice(&std::fs::read(&path).expect("is read")).expect("is JSON");
        let setup = if scene["planar"].is_object() { &scene["planar"] } else { &scene["spatial"] };
        for number in 1..=setup["questions"].as_array().map_or(0, Vec::len) {
            check(&format!("{name}, question {number}"), &picture(&folder, &name, number));
        }
        let page = folder.join(format!("{name}.html")).exists();
        assert!(page, "{name}");
    }
}

#[test]
fn a_scene_without_questions_is_the_grasp_alone() {
    let folder = folder("alone");
    let mut scene: Value = serde_json::from_str(KINDS).expect("is JSON");
    scene["planar"]["questions"] = Value::Array(Vec::new());
    let output = folder.display().to_string();
    let drawn = run_on(scene.to_string().as_bytes(), &["draw", "-", "--name", "alone", "-o", &output]);
    assert!(drawn.status.success(), "{}", text(&drawn.stderr));
    assert!(words(&picture(&folder, "alone", 1)).contains("left"));
}
