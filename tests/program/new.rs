//! Scenes to begin with: asked at once, and explained.

use std::collections::BTreeSet;

use serde_json::Value;

use crate::{run, run_on, text};

const NAMES: [&str; 6] = ["gripper", "three-fingers", "suction", "fixture", "hand", "wedge"];

#[test]
fn every_scene_answers_at_once() {
    for name in NAMES {
        let scene = run(&["new", name]).stdout;
        let asked = run_on(&scene, &["ask", "-"]);
        assert!(asked.status.success() && asked.stderr.is_empty(), "{name}: {}", text(&asked.stderr));
        for command in ["hold", "need"] {
            let answer = text(&run_on(&scene, &[command, "-"]).stdout);
            let says = ["HOLDS, everything sticks", "NEEDS ", "TAKES "];
            assert!(says.iter().any(|begin| answer.starts_with(begin)), "{name} {command}: {answer}");
        }
    }
}

/// JSON has no comments: the help has a line for every name of a field.
#[test]
fn every_field_is_explained() {
    let help = text(&run(&["new", "--help"]).stdout);
    let mut fields = BTreeSet::new();
    for name in NAMES {
        collect(&serde_json::from_slice(&run(&["new", name]).stdout).expect("JSON"), &mut fields);
    }
    assert!(fields.len() > 20, "{fields:?}");
    let words: BTreeSet<_> = help.split(|c: char| !(c.is_alphanumeric() || c == '_')).collect();
    let missing: Vec<_> = fields.iter().filter(|field| !words.contains(field.as_str())).collect();
    assert!(missing.is_empty(), "{missing:?}");
}

fn collect(value: &Value, fields: &mut BTreeSet<String>) {
    match value {
        Value::Object(object) => {
            fields.extend(object.keys().cloned());
            object.values().for_each(|value| collect(value, fields));
        }
        Value::Array(list) => list.iter().for_each(|value| collect(value, fields)),
        _ => {}
    }
}

#[test]
fn an_unknown_name_lists_those_there_are() {
    let output = run(&["new", "grippr"]);
    let message = text(&output.stderr);
    assert_eq!(output.status.code(), Some(2));
    assert!(NAMES.iter().all(|name| message.contains(name)), "{message}");
}
