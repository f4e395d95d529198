//! Every command labels an answer in which the object turns far beyond small motions.
//!
//! Two jaws with the stiffnesses k_n = 1 kN/m and k_t = 20 N/m at a = ±30 mm press with P = 0.55 N. In the linear theory they turn by
//! θ = M / (2 k_t a²) under a moment M, by 0.825 rad at 29.7 mN m, where friction of 0.9 · 0.55 N is exhausted. With finite rotations they turn by
//! 0.1 rad at `M = 2 a sin θ (a k_t cos θ + a k_n (1 - cos θ) - P)`, which is 1.1793 mN m. If they press with 10 N each, these forces drive a turn
//! with 0.6 N m per radian. The springs resist it with only 2 k_t a² = 0.036 N m per radian.

use serde_json::{Value, json};

use crate::{ROOT, run, run_on, text};

fn told(arguments: &[&str]) -> String {
    let scene = format!("{ROOT}/tests/program/scenes/far_beyond_small_motions.json");
    let output = run(&[&arguments[..1], &[scene.as_str()], &arguments[1..]].concat());
    text(&output.stdout)
}

#[test]
fn every_command_says_so() {
    for arguments in [
        &["ask"][..],
        &["onset", "--moment", "1"],
        &["solve", "--moment", "0.0037"],
        &["hold", "--moment", "0.0037"],
        &["shake", "--base", "0,0.2", "--at", "0.1,0", "--force", "0,0.01"],
        &["hold", "--moment", "0.6"],
        // A force of 1 N at 0.3 m has a moment of 0.3 N m.
        &["follow", "--to", "0,1", "--at", "0.3,0"],
        &["follow", "--to", "0,3", "--at", "0.3,0"],
    ] {
        let words = told(arguments);
        let says = ["by more than 5.7°", "results for small motions no longer apply"];
        assert!(says.iter().all(|says| words.contains(says)), "{arguments:?}: {words}");
    }
    // The jaws turn by 0.825 rad before they slide. The force of 1 N at 0.3 m has the moment of 1.1793 mN m, with an arm of 0.3 m cos θ, at the
    // fraction 0.00395073.
    assert!(told(&["onset", "--moment", "1"]).contains("turns 47.269° anticlockwise about (0, 0) m"));
    assert!(told(&["follow", "--to", "0,1", "--at", "0.3,0"]).contains("leg 1 at 0.00395073: CAUTION"));
    for near in [&["solve", "--moment", "0.00117"][..], &["follow", "--to", "0,0.0039", "--at", "0.3,0"]] {
        let words = told(near);
        assert!(!words.contains("small motions"), "{words}");
    }
    assert!(told(&["solve", "--moment", "0.0036"]).contains("turns 5.72958° anticlockwise"));
}

#[test]
fn answers_in_brief_say_so() {
    let scene = std::fs::read_to_string(format!("{ROOT}/tests/program/scenes/far_beyond_small_motions.json"));
    let mut scene: Value = serde_json::from_str(&scene.expect("is there")).expect("JSON");
    let load = |moment: f64| json!({ "load": { "moment": moment } });
    scene["planar"]["questions"] = json!([{ "onset": { "direction": { "moment": 1 } } }, { "solve": load(0.004) }, { "hold": load(0.6) },
        { "follow": { "legs": [{ "load_to": { "moment": 0.3 } }] } }, { "solve": load(0.00117) }, { "hold": load(0.00117) }]);
    for (pressed_with, is_far) in [(0.55, [true, true, true, true, false, false]), (10.0, [true; 6])] {
        for contact in scene["planar"]["contacts"].as_array_mut().expect("a list") {
            contact["pressed_with"] = json!(pressed_with);
        }
        let output = run_on(scene.to_string().as_bytes(), &["stream", "--brief"]);
        let reply: Value = serde_json::from_str(text(&output.stdout).trim()).expect("JSON");
        let told = reply["brief"].as_array().expect("answers");
        let far: Vec<_> = told.iter().map(|brief| brief.get("beyond_small_motions").is_some()).collect();
        // With 10 N the forces of the jaws buckle the object at rest, before any load.
        assert_eq!(far, is_far, "{reply}");
    }
}

/// Springs of 1.5 kN/m in series with 30 kN/m resist turning with 4.5714 N m, of which the jaws of 8 N take 0.64 N m. A weight of 5 N on top takes the
/// rest at a height of 0.786286 m.
#[test]
fn a_weight_high_above_its_jaws() {
    let jaws = crate::scene("box.json");
    let answer = text(&run(&["need", &jaws, "arm", "--force", "0,-5", "--along", "0,1"]).stdout);
    assert!(
        answer.starts_with("TAKES an arm of 0.78628") && answer.contains("with more: BUCKLES"),
        "{answer}"
    );
}
