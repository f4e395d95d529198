//! Scenes may have a part as a mesh and pads that touch it.

use std::fs;
use std::path::{Path, PathBuf};

use grasp_lcp::scene::{Answer, Scene, Warning};
use serde_json::{Value, json};

use crate::shapes::bracket;

/// A folder with the bracket as an OBJ in mm.
fn folder() -> PathBuf {
    let (corners, faces) = bracket();
    let line = |letter: &str, words: Vec<String>| format!("{letter} {}\n", words.join(" "));
    let mut text = String::new();
    for corner in corners {
        text += &line("v", corner.map(|x| x.to_string()).to_vec());
    }
    for face in faces {
        text += &line("f", face.map(|corner| (corner + 1).to_string()).to_vec());
    }
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("touch");
    fs::create_dir_all(&folder).expect("a folder");
    fs::write(folder.join("bracket.obj"), text).expect("a file");
    folder
}

fn jaw(name: &str, from: [f64; 3], closing: f64) -> Value {
    json!({ "name": name, "friction": 0.5, "pressed_with": 40, "touches": {
        "rectangle": [0.02, 0.03], "strips": [1, 1], "from": from, "closing": [closing, 0, 0],
        "layer": { "modulus": 2e6, "thickness": 0.003 } } })
}

fn scene_at(y: f64) -> Value {
    json!({ "format": "grasp-lcp/1", "spatial": {
        "part": { "mesh": "bracket.obj", "unit": "mm", "density": 7850 },
        "contacts": [jaw("left", [-0.01, y, 0.015], 1.0), jaw("right", [0.07, y, 0.015], -1.0)],
        "questions": [{ "hold": { "load": { "force": [0, 100, 0], "at": [0.003, 0.025, 0.015] } } }] } })
}

fn read(scene: &Value) -> Result<Scene, String> {
    Scene::from_json(scene.to_string().as_bytes()).map_err(|fault| fault.to_string())
}

#[test]
fn a_scene_is_laid_on_its_part() {
    let scene = read(&scene_at(0.025)).expect("a scene").with_files_from(folder()).expect("its part");
    assert_eq!(scene.warnings().expect("answered"), []);
    let Some(answers) = scene.answers().expect("answered").spatial() else { panic!("in space") };
    let [Answer::Hold(answer)] = &answers[..] else { panic!("one verdict") };
    let lost = answer.verdict.lost.as_ref().expect("is lost");
    assert!((lost.factor - 0.4).abs() < 1e-10, "{}", lost.factor);
    let Some(setup) = scene.spatial() else { panic!("in space") };
    let part = setup.part_read().expect("is read");
    assert!((part.mass().expect("dense") - 0.132_822).abs() < 1e-9);
    // Each pad is one fingertip with 16 points.
    assert_eq!(setup.grasp().expect("well posed").len(), 32);
}

#[test]
fn a_scene_is_written_as_it_was_read() {
    let given = read(&scene_at(0.025)).expect("a scene");
    let written = serde_json::to_value(&given).expect("written");
    assert_eq!(written["spatial"]["contacts"][0]["touches"]["from"], json!([-0.01, 0.025, 0.015]));
    assert_eq!(written["spatial"]["contacts"][0].get("point"), None);
    assert_eq!(read(&written).expect("a scene"), given);
}

/// The leg of the bracket ends at 40 mm. A pad at 40 mm is partly beyond this end.
#[test]
fn a_pad_that_misses_in_part_is_named() {
    let scene = read(&scene_at(0.04)).expect("a scene").with_files_from(folder()).expect("its part");
    let warnings = scene.warnings().expect("answered");
    let missing = |warning: &Warning| matches!(warning, Warning::MissesInPart { missing, .. } if (*missing - 0.5).abs() < 1e-12);
    assert_eq!(warnings.iter().filter(|warning| missing(warning)).count(), 2, "{warnings:?}");
    assert!(warnings[0].to_string().starts_with("left misses"), "{}", warnings[0]);
    let misses = read(&scene_at(0.06)).expect("a scene").with_files_from(folder()).expect("its part");
    let said = misses.answers().expect_err("no contact").to_string();
    assert!(said.starts_with("contact 0 (left): misses"), "{said}");
}

#[test]
fn faults_name_what_is_missing() {
    let refused = |change: &dyn Fn(&mut Value)| {
        let mut scene = scene_at(0.025);
        change(&mut scene["spatial"]);
        read(&scene).expect_err("a fault")
    };
    let said = refused(&|setup| drop(setup.as_object_mut().expect("an object").remove("part")));
    assert!(said.contains("contact 0: touches") && said.ends_with("no `part`"), "{said}");
    let said = refused(&|setup| setup["contacts"][1]["point"] = json!([0, 0, 0]));
    assert!(said.contains("spatial.contacts[1]") && said.contains("point and touches"), "{said}");
    let said = refused(&|setup| setup["contacts"][0]["stiffness"] = json!(1e4));
    assert!(said.contains("series_stiffness") && said.contains("layer"), "{said}");
    let said = refused(&|setup| setup["contacts"][0]["touches"]["disc"] = json!(0.01));
    assert!(said.contains("number of shapes") && said.contains("is 2"), "{said}");
    let said = refused(&|setup| setup["part"]["mass"] = json!(1));
    assert!(said.contains("mass and density"), "{said}");
    let unread = read(&scene_at(0.025)).expect("a scene").answers().expect_err("no mesh").to_string();
    assert!(unread.starts_with("mesh: ") && unread.contains("not read"), "{unread}");
    let elsewhere =
        read(&scene_at(0.025)).expect("a scene").with_files_from("nowhere").expect_err("no file").to_string();
    assert!(elsewhere.starts_with("mesh: ") && elsewhere.contains(" nowhere/bracket.obj: "), "{elsewhere}");
}

/// A round part between a V and a round finger: pads with a profile in a scene, and a constant force on the flat one.
#[test]
fn a_held_force_and_profiles_are_read() {
    let mut scene = scene_at(0.025);
    let contacts = &mut scene["spatial"]["contacts"];
    let right = contacts[1].as_object_mut().expect("a contact");
    right.remove("pressed_with");
    right.insert("force".to_owned(), json!(40));
    let left = contacts[0]["touches"].as_object_mut().expect("a pad");
    left.remove("rectangle");
    left.insert("disc".to_owned(), json!(0.01));
    left.insert("strips".to_owned(), json!([1, 6]));
    let scene = read(&scene).expect("a scene").with_files_from(folder()).expect("its part");
    let Some(answers) = scene.answers().expect("answered").spatial() else { panic!("in space") };
    let [Answer::Hold(answer)] = &answers[..] else { panic!("one verdict") };
    assert!((answer.verdict.lost.as_ref().expect("is lost").factor - 0.4).abs() < 1e-6);
}

/// A scene may contain vertices and faces. No file is read, and the written scene contains them too.
#[test]
fn a_part_may_be_given_by_arrays() {
    let (corners, faces) = bracket();
    let with = |part: Value| {
        let mut scene = scene_at(0.025);
        scene["spatial"]["part"] = part;
        read(&scene)
    };
    let part = json!({ "vertices": corners, "faces": faces, "unit": "mm", "density": 7850 });
    let scene = with(part.clone()).expect("a scene");
    let expected = read(&scene_at(0.025)).expect("a scene").with_files_from(folder()).expect("its part");
    assert_eq!(scene.answers().expect("answered"), expected.answers().expect("answered"));
    let again = read(&serde_json::to_value(&scene).expect("written")).expect("read");
    assert_eq!(again, scene);
    for (part, said) in [
        (json!({ "unit": "mm" }), "a `mesh`, or"),
        (json!({ "mesh": "a.stl", "vertices": corners, "faces": faces }), "a `mesh`, or"),
        (json!({ "vertices": corners }), "has no faces"),
    ] {
        let error = with(part).expect_err("is refused");
        assert!(error.contains(said), "{error}");
    }
}
