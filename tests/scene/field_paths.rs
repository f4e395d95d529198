//! A wrong value anywhere in a scene is reported under the path of its own field.

use std::path::Path;

use grasp_lcp::scene::Scene;
use serde_json::{Value, json};

/// The example scenes, which are valid.
fn scenes() -> Vec<Value> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../examples/scenes");
    let mut texts = Vec::new();
    for file in folder.read_dir().unwrap() {
        let file = file.unwrap().path();
        let ending = file.extension().and_then(|ending| ending.to_str()).unwrap_or("");
        if ending == "json" || ending == "jsonl" {
            let text = std::fs::read_to_string(&file).unwrap();
            texts.extend(match ending {
                "json" => vec![text],
                _ => text.lines().map(str::to_owned).collect(),
            });
        }
    }
    texts.retain(|text| Scene::from_json(text.as_bytes()).is_ok());
    texts.iter().map(|text| serde_json::from_str(text).unwrap()).collect()
}

/// Collects, for all values within this value, a pointer for [`Value::pointer`] and the path of the field in messages.
fn places(value: &Value, pointer: &str, path: &str, found: &mut Vec<(String, String)>) {
    match value {
        Value::Object(fields) => {
            for (name, value) in fields {
                let dot = if path.is_empty() { "" } else { "." };
                let (pointer, path) = (format!("{pointer}/{name}"), format!("{path}{dot}{name}"));
                places(value, &pointer, &path, found);
                found.push((pointer, path));
            }
        }
        // Of a list, only the first and the last entry are tested.
        Value::Array(list) => {
            for i in [0, list.len().wrapping_sub(1)] {
                let Some(value) = list.get(i) else { continue };
                let (pointer, path) = (format!("{pointer}/{i}"), format!("{path}[{i}]"));
                places(value, &pointer, &path, found);
                found.push((pointer, path));
            }
        }
        _ => {}
    }
}

#[test]
fn a_wrong_value_is_reported_under_its_own_field() {
    let wrong = [json!({ "nowhere": [1] }), json!([[[[1]]]]), json!(true)];
    let mut asked = 0;
    for scene in scenes() {
        let mut found = Vec::new();
        places(&scene, "", "", &mut found);
        for (pointer, path) in found {
            for wrong in &wrong {
                let mut faulty = scene.clone();
                *faulty.pointer_mut(&pointer).unwrap() = wrong.clone();
                // The same faulty scene on one line and on many lines. White space must not matter.
                for text in [faulty.to_string(), serde_json::to_string_pretty(&faulty).unwrap()] {
                    let Err(fault) = Scene::from_json(text.as_bytes()) else { continue };
                    let field = fault.field.clone().unwrap_or_default();
                    let rest = field.strip_prefix(&path);
                    let inside = rest.is_some_and(|rest| rest.is_empty() || rest.starts_with(['.', '[']));
                    assert!(inside, "{path} {wrong} {fault}");
                    asked += 1;
                }
            }
        }
    }
    assert!(asked > 1000, "{asked}");
}

/// Braces, quotes and commas may be part of a name.
#[test]
fn names_with_signs_of_json_are_names() {
    let legs = json!([{ "body_loads_by": { "a \"left\"], {b}": { "force": [1, "x"] } } }]);
    let contact = json!({ "name": "\"}], {\\", "point": [0, 0], "normal": [1, 0], "friction": 0.5 });
    let planar = json!({ "contacts": [contact], "questions": [{ "follow": { "legs": legs } }] });
    let scene = json!({ "format": "grasp-lcp/1", "planar": planar }).to_string();
    let field = Scene::from_json(scene.as_bytes()).unwrap_err().field;
    let expected = "planar.questions[0].follow.legs[0].body_loads_by.a \"left\"], {b}.force[1]";
    assert_eq!(field.as_deref(), Some(expected));
}

/// An invalid id is reported under `id`, also if it is the last field.
#[test]
fn an_id_is_a_text_or_a_whole_number() {
    let contact = r#"{"point": [0, 0], "normal": [1, 0], "stiffness": 1}"#;
    let scene = format!(r#"{{"format": "grasp-lcp/1", "planar": {{"contacts": [{contact}]}}, "id": 7}}"#);
    assert!(Scene::from_json(scene.as_bytes()).is_ok());
    for id in ["[1]", "1.5", "{}", "18446744073709551615", "true"] {
        let fault = Scene::from_json(scene.replace('7', id).as_bytes()).unwrap_err();
        assert_eq!(fault.field.as_deref(), Some("id"), "{fault}");
    }
}
