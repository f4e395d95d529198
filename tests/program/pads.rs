//! A soft fingertip is reported as one contact: one row in tables, and one event each for its first and its last point that slides.
//!
//! A disc of R = 10 mm presses with N = 10 N on an object that a bonded foot holds. Tip and foot resist rotation about their line with 0.5 N m/rad
//! each. Under a moment M the tip carries M/2 until, at even pressure, its rim slides at μ N R/2 = 0.025 N m. Its inner points, at R/2, slide at
//! twice the angle. Then the tip carries 2/3 μ N R and the foot 0.05 N m. At the first slip |F_t| grows with the distance from the middle: Σ |F_t| =
//! 2/3 μ N.

use serde_json::Value;

use crate::{ROOT, run, text};

const TIP: &str = "tests/program/scenes/soft_tip_turned.json";

fn told(command: &str, options: &[&str]) -> String {
    let scene = format!("{ROOT}/{TIP}");
    let output = run(&[&[command, &scene], options].concat());
    assert!(output.status.success(), "{}", text(&output.stderr));
    text(&output.stdout)
}

/// Lines that begin with a name, with single spaces.
fn lines_of(words: &str, name: &str) -> Vec<String> {
    let lines = words.lines().filter(|line| line.trim_start().starts_with(name));
    lines.map(|line| line.split_whitespace().collect::<Vec<_>>().join(" ")).collect()
}

#[test]
fn a_row_a_pad() {
    let words = told("onset", &[]);
    assert!(words.contains("factor 0.05, that is (0, 0, 0.05) N m"), "{words}");
    // The row of the tip: normal force, friction force, torsion, tilting moment, and a friction reserve of 5 - 10/3 N.
    assert_eq!(lines_of(&words, "tip")[1..], ["tip 10 0 0.025 0 1.66667 sticks"]);
    assert!(lines_of(&words, "tip")[0].starts_with("tip begins"), "{words}");
    let [foot] = &lines_of(&words, "foot")[..] else { panic!("{words}") };
    assert!(foot.starts_with("foot 10 0 -0.025 0 no limit"), "{foot}");
    assert!(words.contains("M_n (N m)") && words.contains("|M_t| (N m)"), "{words}");
    assert!(
        words.starts_with("FIRST SLIP at 0.05 N m: ") && words.contains("tip (4 of 8 points)"),
        "{words}"
    );
}

#[test]
fn points_are_told_on_request() {
    let words = told("onset", &["--points"]);
    assert_eq!(
        lines_of(&words, "tip, point ").iter().filter(|line| line.ends_with("sticks")).count(),
        8,
        "{words}"
    );
    assert_eq!(lines_of(&words, "tip, point ").iter().filter(|line| line.contains("slides over")).count(), 4);
    assert!(!words.contains("M_n"), "{words}");
}

#[test]
fn a_pad_begins_to_slide_and_slides_everywhere() {
    let words = told("follow", &[]);
    let events: Vec<_> =
        words.lines().filter(|line| line.starts_with("  leg ") && line.contains(": ")).collect();
    let expected = [
        ("leg 1 at 0.555556, (0, 0, 0.05) N m: ", "tip begins"),
        ("leg 1 at 0.925926, (0, 0, 0.0833333) N m: ", "tip slides everywhere"),
        ("leg 1 at 0.925926: ", "CAUTION"),
        ("leg 2 at 0, (0, 0, 0.09) N m: ", "tip sticks again"),
    ];
    assert_eq!(events.len(), expected.len(), "{words}");
    for (event, (place, told)) in events.iter().zip(expected) {
        let behind = event.trim_start().strip_prefix(place);
        assert!(behind.is_some_and(|behind| behind.starts_with(told)), "{event}");
    }
    // While it slides, the tip carries 2/3 μ N R = 1/30 N m. Unloading removes 0.09 N m, half of it at the tip.
    assert_eq!(lines_of(&words, "tip"), ["tip 10 0 -0.0116667 0 3.33333 sticks"]);
    let points = told("follow", &["--points"]);
    assert_eq!(points.lines().filter(|line| line.contains(": tip, point ")).count(), 16, "{points}");
}

#[test]
fn json_has_points_and_pads() {
    let answers: Value = serde_json::from_str(&told("solve", &["--json"])).expect("JSON");
    let state = &answers[0]["solve"];
    assert_eq!(state["contacts"].as_array().map(Vec::len), Some(12));
    let pad = &state["pads"][1];
    assert_eq!((&pad["contact"], &pad["name"], &pad["first"]), (&1.into(), &"foot".into(), &8.into()));
    let moment = pad["wrench"]["moment"][0].as_f64().expect("a number");
    assert!((moment + 0.025).abs() < 1e-15, "{moment}");
}

/// Of a load of 20 N two pads hold only 15 N. The search for an equilibrium ends undecided, but the load path and a proof show that the load is not
/// held.
#[test]
fn an_undecided_search_says_what_is_known() {
    for (scene, held) in
        [("soft_jaws_overloaded_planar", " 15 N of 20 N"), ("soft_jaws_overloaded_rings", " 10 N of 20 N")]
    {
        let output = run(&["ask", &format!("{ROOT}/tests/program/scenes/{scene}.json")]);
        let words = text(&output.stdout);
        assert_eq!(output.status.code(), Some(4));
        let known = words.lines().find(|line| line.contains("from rest")).expect("told");
        assert!(known.contains(held), "{known}");
        assert!(words.contains("\n  proved: no equilibrium under the whole load within "), "{words}");
        assert!(words.contains("elsewhere is undecided"), "{words}");
    }
}
