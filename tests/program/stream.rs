//! Answers of the stream can be assigned to their lines, even if pipes split the stream between several programs.

use std::collections::BTreeMap;

use serde_json::{Value, json};

use crate::{run_on, scene, text};

/// A line with a pinch that slides at 2 μ times its squeeze. Every second line has no id.
fn line(number: usize) -> String {
    let jaw = |x: f64| {
        json!({ "name": if x < 0.0 { "left" } else { "right" }, "point": [x, 0], "normal": [-x, 0],
            "series_stiffness": [1000, 800], "friction": 0.5, "pressed_with": 1 + number })
    };
    let mut scene = json!({ "format": "grasp-lcp/1", "planar": {
        "contacts": [jaw(-1.0), jaw(1.0)], "questions": [{ "onset": { "direction": { "force": [0, -1] } } }] } });
    if number.is_multiple_of(2) {
        scene["id"] = json!(format!("scene {number}"));
    }
    scene.to_string()
}

fn replies(input: &str, arguments: &[&str]) -> Vec<Value> {
    let output = run_on(input.as_bytes(), &[&["stream"], arguments].concat());
    assert!(output.status.success(), "{}", text(&output.stderr));
    text(&output.stdout).lines().map(|line| serde_json::from_str(line).expect("JSON")).collect()
}

/// The hash of a line, FNV-1a.
fn hash(line: &str) -> String {
    let mut hash = 0xcbf2_9ce4_8422_2325_u64;
    for byte in line.bytes() {
        hash ^= u64::from(byte);
        hash = hash.wrapping_mul(0x0100_0000_01b3);
    }
    format!("{hash:016x}")
}

#[test]
fn parts_answer_as_the_whole_and_name_their_lines() {
    let lines: Vec<String> = (0..300).map(line).collect();
    let whole = replies(&lines.join("\n"), &["--brief"]);
    assert_eq!(whole.len(), lines.len());
    let name = |reply: &Value| match (&reply["id"], &reply["hash"]) {
        (Value::String(id), Value::Null) => id.clone(),
        (Value::Null, Value::String(hash)) => hash.clone(),
        other => panic!("{other:?}"),
    };
    let mut by_name = BTreeMap::new();
    for part in lines.chunks(37) {
        for reply in replies(&part.join("\n"), &["--brief", "--threads", "1"]) {
            by_name.insert(name(&reply), reply["brief"].clone());
        }
    }
    assert_eq!(by_name.len(), lines.len());
    for (number, (line, reply)) in lines.iter().zip(&whole).enumerate() {
        assert_eq!(reply["line"], json!(number + 1));
        assert_eq!(
            name(reply),
            if number.is_multiple_of(2) { format!("scene {number}") } else { hash(line) }
        );
        assert_eq!(by_name[&name(reply)], reply["brief"]);
        let brief = &reply["brief"][0];
        assert!(
            (brief["factor"].as_f64().expect("slides") - (1 + number) as f64).abs()
                < 1e-11 * (1 + number) as f64
        );
        assert_eq!(
            (&brief["outcome"], &brief["first"], &brief["state"]),
            (&json!("at"), &json!("left"), &json!("slides"))
        );
        assert!(reply.to_string().len() < 160, "{reply}");
    }
}

#[test]
fn brief_answers_agree_with_full_ones() {
    let input = std::fs::read_to_string(scene("stream.jsonl")).expect("is there");
    let (full, brief) = (replies(&input, &[]), replies(&input, &["--brief"]));
    assert_eq!((full.len(), brief.len()), (input.lines().count(), input.lines().count()));
    let mut compared = 0;
    for (full, brief) in full.iter().zip(&brief) {
        assert_eq!(full["id"], brief["id"]);
        assert_eq!(full["error"], brief["error"]);
        for (full, brief) in full["answers"]
            .as_array()
            .into_iter()
            .flatten()
            .zip(brief["brief"].as_array().into_iter().flatten())
        {
            let full = &full[brief["question"].as_str().expect("a name")];
            for field in ["outcome", "factor", "angle_rad", "leg", "fraction"] {
                if let Some(value) = brief.get(field) {
                    assert_eq!(&full[field], value, "{field}");
                    compared += 1;
                }
            }
        }
    }
    assert!(compared > 5, "{compared}");
}

#[test]
fn a_line_says_what_is_wrong_and_which_it_was() {
    let soft = r#"{"format": "grasp-lcp/1", "id": 5, "spatial": {"contacts": [{"point": [0, 0, 0], "normal": [0, 0, 1], "series_stiffness": [1, 1],
        "soft": {"disc": {"radius": 1, "annuli": 20, "points": 60}}}], "questions": [{"solve": {}}]}}"#.replace('\n', "");
    let input = format!("no scene\n\n{soft}\n{}\n", line(1).replace("\"pressed_with\":2", "\"clearance\":0"));
    let told = replies(&input, &[]);
    assert_eq!(told[0]["begins"], "no scene");
    assert_eq!(told[0]["hash"], hash("no scene"));
    assert_eq!(told[1], json!({ "line": 2, "blank": true }));
    let message = told[2]["error"]["message"].as_str().expect("a message");
    assert!(message.starts_with("2400 points") && message.contains(" 2000 "), "{message}");
    assert_eq!(told[2]["id"], 5);
    assert!(told[3]["warnings"][0].as_str().expect("a warning").starts_with("no finger presses"));
    let allowed = replies(&soft, &["--most-points", "2400", "--brief"]);
    assert!(allowed[0]["brief"].is_array());
}
