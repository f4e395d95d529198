//! What turns the object far beyond small motions is labelled, by every command.
//!
//! Two jaws with k_t = 20 N/m at ±30 mm turn by θ = M / (2 k_t a²) under a moment M: 0.5 rad at 18 mN m, 15 rad where friction of 0.9 · 10 N ends at
//! 0.54 N m.

use serde_json::{Value, json};

use crate::{ROOT, run, run_on, text};

fn told(arguments: &[&str]) -> String {
    let scene = format!("{ROOT}/tests/program/scenes/far_beyond_small_motions.json");
    let output = run(&[&arguments[..1], &[scene.as_str()], &arguments[1..]].concat());
    text(&output.stdout)
}

#[test]
fn every_command_says_so() {
    let far = "far beyond the small motions that this is good for";
    let sentence = "The object turns too far for that: all this is good for small motions";
    for (arguments, label) in [
        (&["ask"][..], far),
        (&["onset", "--moment", "1"], far),
        (&["solve", "--moment", "0.02"], far),
        (&["hold", "--moment", "0.02"], sentence),
        (&["shake", "--base", "0,0.2", "--at", "0.1,0", "--force", "0,0.01"], sentence),
        (&["hold", "--moment", "0.6"], sentence),
        (&["need", "load", "--moment", "0.1"], sentence),
        (&["need", "friction", "--moment", "0.1"], sentence),
        // 0.3 N m by a force of 1 N at 0.3 m.
        (&["follow", "--to", "0,1", "--at", "0.3,0"], far),
        (&["follow", "--to", "0,3", "--at", "0.3,0"], far),
    ] {
        let words = told(arguments);
        assert!(words.contains(label), "{arguments:?}: {words}");
    }
    // 15 rad, and 0.017 / 0.036 rad.
    assert!(told(&["onset", "--moment", "1"]).contains("turns 859.437° anticlockwise about (0, 0) m"));
    for near in [
        &["solve", "--moment", "0.017"][..],
        &["hold", "--moment", "0.017"],
        &["follow", "--to", "0,0.05", "--at", "0.3,0"],
    ] {
        let words = told(near);
        assert!(!words.contains("small motions"), "{words}");
    }
    assert!(told(&["solve", "--moment", "0.018"]).contains("turns 28.6479° anticlockwise"));
}

#[test]
fn answers_in_brief_say_so() {
    let scene = std::fs::read_to_string(format!("{ROOT}/tests/program/scenes/far_beyond_small_motions.json"));
    let mut scene: Value = serde_json::from_str(&scene.expect("is there")).expect("JSON");
    let load = |moment: f64| json!({ "load": { "moment": moment } });
    scene["planar"]["questions"] = json!([{ "onset": { "direction": { "moment": 1 } } }, { "solve": load(0.02) }, { "hold": load(0.6) },
        { "follow": { "legs": [{ "load_to": { "moment": 0.3 } }] } }, { "solve": load(0.017) }, { "hold": load(0.017) }]);
    let output = run_on(scene.to_string().as_bytes(), &["stream", "--brief"]);
    let reply: Value = serde_json::from_str(text(&output.stdout).trim()).expect("JSON");
    let told = reply["brief"].as_array().expect("answers");
    let far: Vec<_> = told.iter().map(|brief| brief.get("beyond_small_motions").is_some()).collect();
    assert_eq!(far, [true, true, true, true, false, false], "{reply}");
}
