//! The printed schemas admit everything that the program reads and writes, and the program refuses what the schemas refuse.

use std::collections::BTreeSet;

use boon::{Compiler, SchemaIndex, Schemas};
use grasp_lcp::scene::Scene;
use serde_json::{Value, json};

use crate::{run, run_on, scene, text};

/// A schema of the program, with its validator.
struct Judge {
    schema: Value,
    schemas: Schemas,
    index: SchemaIndex,
}

impl Judge {
    fn of(what: &str) -> Self {
        let printed = run(&["schema", what]);
        assert!(printed.status.success());
        let schema: Value = serde_json::from_slice(&printed.stdout).expect("JSON");
        let (mut schemas, mut compiler) = (Schemas::new(), Compiler::new());
        compiler.add_resource("schema.json", schema.clone()).expect("a resource");
        let index = compiler.compile("schema.json", &mut schemas).expect("a schema of draft 2020-12");
        Self { schema, schemas, index }
    }

    fn refuses(&self, value: &Value) -> Option<String> {
        self.schemas.validate(value, self.index).err().map(|error| format!("{error:#}"))
    }
}

/// All scenes of the examples, by name.
fn scenes() -> Vec<(String, Value)> {
    let folders = ["", "bodies"];
    let folders = folders.into_iter().flat_map(|name| std::fs::read_dir(scene(name)).expect("scenes"));
    let paths = folders.map(|entry| entry.expect("an entry").path());
    let scenes = paths.filter(|path| path.extension().is_some_and(|end| end == "json"));
    let read = |path: std::path::PathBuf| {
        let scene = serde_json::from_slice(&std::fs::read(&path).expect("a scene")).expect("JSON");
        (path.display().to_string(), scene)
    };
    let mut all: Vec<_> = scenes.map(read).collect();
    all.sort_by(|a, b| a.0.cmp(&b.0));
    assert!(all.len() > 10);
    all
}

/// Names of all fields within a value.
fn fields(value: &Value, names: &mut BTreeSet<String>) {
    match value {
        Value::Object(map) => {
            names.extend(map.keys().cloned());
            map.values().for_each(|value| fields(value, names));
        }
        Value::Array(list) => list.iter().for_each(|value| fields(value, names)),
        _ => {}
    }
}

#[test]
fn scenes_and_their_answers_are_of_their_schemas() {
    let (of_scenes, of_answers) = (Judge::of("scene"), Judge::of("answers"));
    let (mut known, mut told) = (BTreeSet::new(), BTreeSet::new());
    fields(&of_answers.schema, &mut known);
    for (name, scene) in scenes() {
        assert_eq!(of_scenes.refuses(&scene), None, "{name}");
        let answers = run(&["ask", &name, "--json"]);
        let answers: Value = serde_json::from_slice(&answers.stdout).expect("answers");
        assert_eq!(of_answers.refuses(&answers), None, "{name}");
        fields(&answers, &mut told);
    }
    let unknown: Vec<_> = told.difference(&known).collect();
    assert!(unknown.is_empty(), "{unknown:?}");
}

#[test]
fn lines_of_the_stream_are_of_their_schema() {
    let judge = Judge::of("line");
    let mut input = std::fs::read(scene("stream.jsonl")).expect("scenes");
    input.extend(b"\n{\n{\"format\": \"grasp-lcp/1\", \"planar\": {\"contacts\": []}}\n[]\n");
    for arguments in [&["stream"][..], &["stream", "--brief"]] {
        let output = text(&run_on(&input, arguments).stdout);
        let mut lines = 0;
        for line in output.lines() {
            let reply = serde_json::from_str(line).expect("JSON");
            assert_eq!(judge.refuses(&reply), None, "{line}");
            lines += 1;
        }
        assert!(lines > 5);
    }
}

/// All changes of a value in one place that may make it invalid.
fn spoiled(value: &Value) -> Vec<Value> {
    let mut all = Vec::new();
    match value {
        Value::Object(map) => {
            for (name, part) in map {
                let with = |new: Option<(&str, Value)>| {
                    let mut map = map.clone();
                    map.remove(name);
                    map.extend(new.map(|(name, value)| (name.to_owned(), value)));
                    Value::Object(map)
                };
                all.push(with(None));
                all.push(with(Some(("misspelt", part.clone()))));
                all.extend(spoiled(part).into_iter().map(|part| with(Some((name, part)))));
            }
        }
        Value::Array(list) => {
            all.push(Value::Array(list[..list.len().saturating_sub(1)].to_vec()));
            all.push(list.iter().chain(list.last()).cloned().collect());
            for (k, part) in list.iter().enumerate() {
                let with = |new: Value| {
                    let mut list = list.clone();
                    list[k] = new;
                    Value::Array(list)
                };
                all.extend(spoiled(part).into_iter().map(with));
            }
        }
        Value::Number(_) => {
            all.extend([json!("rigid"), json!(-1), json!([1, 2]), json!(0), json!(1e60), json!(null)]);
        }
        Value::String(_) => all.extend([json!("infinite"), json!(3.5), json!({}), json!(null)]),
        Value::Bool(_) => all.push(json!("yes")),
        Value::Null => {}
    }
    all
}

#[test]
fn what_the_schema_refuses_is_refused() {
    let judge = Judge::of("scene");
    let (mut both, mut reader, mut neither) = (0, 0, 0);
    for (name, scene) in scenes() {
        let mut all = spoiled(&scene);
        // Changes in long lists are alike, so only a part of them is checked.
        let step = (all.len() / 400).max(1);
        all = all.into_iter().step_by(step).collect();
        for spoiled in all {
            let read = Scene::from_json(spoiled.to_string().as_bytes());
            match (judge.refuses(&spoiled), read) {
                (Some(reason), Ok(_)) => panic!("{name} {reason} {spoiled}"),
                (Some(_), Err(_)) => both += 1,
                (None, Err(_)) => reader += 1,
                (None, Ok(_)) => neither += 1,
            }
        }
    }
    println!("refused by both {both}, by the reader alone {reader}, by neither {neither}");
    assert!(both > 5 * reader, "{both} {reader}");
}
