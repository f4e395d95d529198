//! The page of all fields of a scene, `examples/scenes/FIELDS.md`, agrees with the schema. The program and Python print this page.

use std::collections::BTreeSet;
use std::fmt::Write as _;

use serde_json::{Map, Value};

use crate::{ROOT, run, run_on, text};

/// The name of a definition without the number that marks its spatial version.
fn base(name: &str) -> &str {
    name.rsplit('/').next().unwrap_or(name).trim_end_matches(char::is_numeric)
}

/// The kind of a value in a few words.
fn kind(of: &Value) -> String {
    if let Some(name) = of["$ref"].as_str() {
        return base(name).to_owned();
    }
    if let Some(word) = of["const"].as_str() {
        return format!("`{word}`");
    }
    if let Some(words) = of["enum"].as_array() {
        return words
            .iter()
            .map(|word| format!("`{}`", word.as_str().unwrap_or("null")))
            .collect::<Vec<_>>()
            .join(" or ");
    }
    for several in ["anyOf", "oneOf"] {
        if let Some(each) = of[several].as_array() {
            let kinds: BTreeSet<_> =
                each.iter().map(kind).filter(|one| !one.is_empty() && one != "null").collect();
            return kinds.into_iter().collect::<Vec<_>>().join(" or ");
        }
    }
    let first = of["type"].as_str().or_else(|| of["type"][0].as_str()).unwrap_or_default();
    match first {
        "array" if of["items"].is_object() => format!("list of {}", kind(&of["items"])),
        other => other.to_owned(),
    }
}

/// Adds lines for the fields of an object and of its variants.
fn fields(page: &mut String, of: &Value) {
    let required: BTreeSet<_> =
        of["required"].as_array().into_iter().flatten().filter_map(Value::as_str).collect();
    for (name, field) in of["properties"].as_object().into_iter().flatten() {
        let must = if required.contains(name.as_str()) { ", required" } else { "" };
        let about = field["description"].as_str().map(|about| format!(": {about}")).unwrap_or_default();
        writeln!(page, "* `{name}` ({}{must}){about}", kind(field)).expect("text");
        // Variants that are objects have fields of their own.
        if field["properties"].is_object() {
            let mut own = String::new();
            fields(&mut own, field);
            for line in own.lines() {
                writeln!(page, "  {line}").expect("text");
            }
        }
    }
    for several in ["oneOf", "anyOf"] {
        for variant in of[several].as_array().into_iter().flatten() {
            fields(page, variant);
        }
    }
}

/// Lines for the allowed words of an enumeration. For other values without fields, one line with their kind.
fn values(page: &mut String, of: &Value) {
    let each = of["oneOf"].as_array().map_or(&[][..], Vec::as_slice);
    if each.is_empty() {
        writeln!(page, "* {}", kind(of)).expect("text");
    }
    for value in each {
        let about = value["description"].as_str().map(|about| format!(": {about}")).unwrap_or_default();
        writeln!(page, "* {}{about}", kind(value)).expect("text");
    }
}

const HEAD: &str = r#"# Fields of a scene

Made from the JSON Schema (`grasp-lcp schema`). Vectors have two numbers in the plane and three in space. Units are SI. `grasp-lcp new gripper` writes a scene to begin with.

A scene with two contacts and two questions:

```json
{"format": "grasp-lcp/1", "planar": {
  "contacts": [
    {"name": "left", "point": [-0.04, 0], "normal": [1, 0], "stiffness": [2000, 1500], "friction": 0.5, "pressed_with": 8},
    {"name": "right", "point": [0.04, 0], "normal": [-1, 0], "stiffness": [2000, 1500], "friction": 0.5, "pressed_with": 8}],
  "questions": [
    {"hold": {"load": {"mass": 0.5}}},
    {"need": {"quantity": "squeeze", "load": {"force": [0, -9.81]}}}]}}
```

## Scene

"#;

fn page(schema: &Value) -> String {
    let mut page = HEAD.to_owned();
    fields(&mut page, schema);
    let definitions: &Map<String, Value> = schema["$defs"].as_object().expect("definitions");
    let mut told = BTreeSet::new();
    for (name, of) in definitions {
        let mut own = String::new();
        fields(&mut own, of);
        if own.is_empty() {
            values(&mut own, of);
        }
        // The spatial version has the same fields, or more.
        let is_first = definitions.contains_key(&format!("{name}2"));
        if is_first || !told.insert(own.clone()) {
            continue;
        }
        let about = of["description"].as_str().map(|about| format!("{about}\n\n")).unwrap_or_default();
        write!(page, "\n## {}\n\n{about}{own}", base(name)).expect("text");
    }
    page
}

#[test]
fn the_page_of_fields_is_that_of_the_schema() {
    let schema: Value = serde_json::from_slice(&run(&["schema"]).stdout).expect("JSON");
    let made = page(&schema);
    let place = format!("{ROOT}/examples/scenes/FIELDS.md");
    if std::env::var_os("WRITE_FIELDS").is_some() {
        std::fs::write(&place, &made).expect("is written");
    }
    let kept = std::fs::read_to_string(place).expect("is there");
    assert!(made == kept);
    // The example at the top of the page holds 8 N. The weight of 0.5 kg is 4.905 N.
    let example = HEAD.split("```json").nth(1).and_then(|rest| rest.split("```").next()).expect("a scene");
    let answers: Value =
        serde_json::from_slice(&run_on(example.as_bytes(), &["ask", "-", "--json"]).stdout).expect("JSON");
    assert_eq!(answers[0]["hold"]["holding"], "sticks");
    let squeeze = answers[1]["need"]["amount"]["bound"]["sufficient"].as_f64().expect("a bound");
    assert!((squeeze - 9.81 / 8.0).abs() < 1e-9, "{squeeze}");
    // The file has each section once.
    let heads: Vec<_> = kept.lines().filter(|line| line.starts_with("## ")).collect();
    assert_eq!(heads.iter().collect::<BTreeSet<_>>().len(), heads.len(), "{heads:?}");
    let help = text(&run(&["help", "scene"]).stdout);
    for field in [
        "* `stiffness` (Springs)",
        "* `kept_closed`: ",
        "* `gross`: ",
        "`pressed_with`",
        "`stiffness_matrix`",
        "`arms`",
        "`sides`",
    ] {
        assert!(kept.contains(field) && help.contains(field), "{field}");
    }
}
