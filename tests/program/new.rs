//! The scenes of `new` are answered immediately, and every field is explained.

use std::collections::BTreeSet;

use serde_json::Value;

use crate::{run, run_on, text};

const NAMES: [&str; 6] = ["gripper", "three-fingers", "suction", "fixture", "hand", "wedge"];

/// First lines of `hold` and `need` for the workshop scenes, with values computed by hand.
const IN_A_SHOP: [(&str, &[&str], &[&str]); 8] = [
    // Independent computations, with load steps of Coulomb springs and with limit analysis, give 1.461 times the load and 5457 N.
    ("vise", &["lost at 2359.98 N (1.46079 times"], &["NEEDS 5457.4 N at", "at moving jaw so"]),
    // The largest torque of three jaws is 3 μ N R = 3 * 0.2 * 2 kN * 25 mm.
    (
        "chuck",
        &["30 N m (1.5 times this load)", "the first slip"],
        &["1333.34 N at jaw 1, jaw 2", "and jaw 3"],
    ),
    // The bolts hold a shear force of μ times the force of both bolts.
    (
        "bolts",
        &["4000 N (1.33333 times this load)", "first slip (seat 1", "and seat 2), held"],
        &["NEEDS 7500 N at", "at bolt 1 and bolt 2"],
    ),
    // The straps hold μ (m g + 2 T sin 60°) = 4069.6 N. The needed tension is T = (0.8/0.3 - 1) m g / 2 sin 60°.
    ("tie-down", &["lost at 4069.57 N"], &["4719.84 N at strap left"]),
    // The ropes pull each arm with 100 N sideways, 150 mm above the pin, and with 100 N down, 200 mm beside the pin. The jaws are 300 mm below the
    // pin. So they press with 166.7 N, and need friction 0.6.
    ("tongs", &["HOLDS, everything sticks"], &["NEEDS a coefficient", "friction of 0.6 "]),
    // The largest torque is μ R N (1 + √2), because each flank of the V presses with N/√2.
    ("v-jaws", &["lost at 7.72548 N m"], &["517.767 N at flat jaw"]),
    // Four cups carry 4 * 60 kPa * π (40 mm)² = 1206.4 N.
    ("cups", &["HOLDS, everything sticks: 1206.37 N"], &["NEEDS 22.1686 kPa", "(111.432 N) at cup 1"]),
    // Moments about the front support balance: 19.62 N act 50 mm behind it, and 49.05 N 20 mm in front of it.
    ("shelf", &["HOLDS, everything sticks"], &["TAKES an arm", "of 0.17 m"]),
];

#[test]
fn scenes_from_a_shop_have_their_values_by_hand() {
    for (name, holds, needs) in IN_A_SHOP {
        let scene = run(&["new", name]).stdout;
        let asked = run_on(&scene, &["ask", "-"]);
        assert!(asked.status.success() && asked.stderr.is_empty(), "{name}: {}", text(&asked.stderr));
        let answers = text(&asked.stdout);
        for said in holds.iter().chain(needs) {
            assert!(answers.contains(said), "{name}, {said}: {answers}");
        }
    }
}

#[test]
fn every_scene_answers_at_once() {
    for name in NAMES {
        let scene = run(&["new", name]).stdout;
        let asked = run_on(&scene, &["ask", "-"]);
        assert!(asked.status.success() && asked.stderr.is_empty(), "{name}: {}", text(&asked.stderr));
        for command in ["hold", "need"] {
            let answer = text(&run_on(&scene, &[command, "-"]).stdout);
            let says = ["HOLDS, ", "NEEDS ", "TAKES "];
            assert!(says.iter().any(|begin| answer.starts_with(begin)), "{name} {command}: {answer}");
        }
    }
}

/// JSON has no comments, so the help has a line for every field name.
#[test]
fn every_field_is_explained() {
    let help = text(&run(&["new", "--help"]).stdout);
    let mut fields = BTreeSet::new();
    for name in NAMES.into_iter().chain(IN_A_SHOP.map(|(name, ..)| name)) {
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
fn options_of_grip_are_refused_for_other_kinds() {
    let output = run(&["new", "gripper", "--force", "40", "--friction", "0.3"]);
    assert_eq!(output.status.code(), Some(2));
    assert!(output.stdout.is_empty() && text(&output.stderr).starts_with("--force: of `new grip` alone"));
    let mesh = run(&["new", "gripper", "part.stl"]);
    assert!(text(&mesh.stderr).starts_with("mesh: of `new grip`"), "{}", text(&mesh.stderr));
}

#[test]
fn an_unknown_name_lists_those_there_are() {
    let output = run(&["new", "grippr"]);
    let message = text(&output.stderr);
    assert_eq!(output.status.code(), Some(2));
    assert!(NAMES.iter().all(|name| message.contains(name)), "{message}");
    assert!(IN_A_SHOP.iter().all(|(name, ..)| message.contains(name)), "{message}");
}
