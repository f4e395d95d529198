//! Without a load on the command line `need` and `hold` take the load of the scene's questions.

use crate::{run_on, text};

/// Two jaws that press with 10 N, μ = 0.5: they carry 10 N.
fn pinch(questions: &str) -> String {
    let jaw = |x: f64| {
        format!(
            r#"{{"point": [{x}, 0], "normal": [{}, 0], "friction": 0.5, "stiffness": 1e4, "pressed_with": 10}}"#,
            -x
        )
    };
    format!(
        r#"{{"format": "grasp-lcp/1", "planar": {{"contacts": [{}, {}], "questions": [{questions}]}}}}"#,
        jaw(-0.03),
        jaw(0.03)
    )
}

/// The answer (standard output), and warnings (standard error).
fn told(questions: &str, arguments: &[&str]) -> (String, String) {
    let output = run_on(pinch(questions).as_bytes(), arguments);
    (text(&output.stdout), text(&output.stderr))
}

const NEED: &str = r#"{"need": {"quantity": "friction", "demand": "sticks", "load": {"force": [0, -6]}, "friction_less": 0, "squeeze_less": 0}}"#;
const HOLD: &str = r#"{"hold": {"base": {"force": [0, -2]}, "load": {"force": [0, -4]}}}"#;

#[test]
fn the_scenes_own_question_is_asked_whole() {
    let questions = format!("{HOLD}, {NEED}");
    let (answer, warned) = told(&questions, &["need", "-", "friction"]);
    assert!(
        answer.starts_with("NEEDS a coefficient of friction of 0.3 so that nothing slides\n  with less: ")
            && warned.is_empty()
    );
    let (safe, _) = told(&questions, &["need", "-", "friction", "--safety", "1.5"]);
    assert!(safe.contains("; if the load is 1.5 times as large: 0.45"), "{safe}");
}

#[test]
fn loads_of_other_questions_are_taken() {
    // A load of 6 N needs 6 N / (2 · 0.5) on each side.
    let (answer, warned) = told(NEED, &["need", "-", "squeeze"]);
    assert!(answer.starts_with("NEEDS 6 N at ") && warned.contains("question 1 "), "{answer} {warned}");
    let (answer, _) = told(HOLD, &["need", "-", "squeeze"]);
    assert!(answer.starts_with("NEEDS 6 N at "), "{answer}");
    // Of two loads the larger load determines the answer. A load of 2 N at rest is added to each.
    let both = format!("{HOLD}, {}", HOLD.replace("-4", "-7"));
    let (answer, warned) = told(&both, &["need", "-", "squeeze"]);
    assert!(answer.starts_with("NEEDS 9 N at ") && warned.contains("one at a time"), "{answer} {warned}");
    let (answer, warned) = told(NEED, &["hold", "-"]);
    assert!(
        answer.contains("10 N (1.66666 times this load)") && warned.contains("question 1 "),
        "{answer} {warned}"
    );
}

/// Friction carries 10 N along the jaws, of which 2 N act at rest.
#[test]
fn a_map_is_on_top_of_the_load_at_rest_of_any_question() {
    let map_with = |questions: &str, base: &[&str]| {
        let (answer, warned) = told(questions, &[&["map", "-", "--json"], base].concat());
        let map: serde_json::Value = serde_json::from_str(&answer).expect("JSON");
        let down =
            map["onsets"].as_array().and_then(|all| all.iter().find(|one| one["direction"][1] == -1.0));
        (down.and_then(|one| one["onset"].as_f64()).expect("a force"), warned)
    };
    let map = |questions: &str| map_with(questions, &[]);
    let need = NEED.replace(r#""load""#, r#""base": {"force": [0, -2]}, "load""#);
    for questions in [HOLD, &need] {
        let (down, warned) = map(questions);
        assert!((down - 8.0).abs() < 1e-9 && warned.is_empty(), "{down} {warned}");
    }
    let (down, warned) = map(&format!("{NEED}, {HOLD}"));
    assert!((down - 8.0).abs() < 1e-9 && warned.contains("that of question 2, (0, -2) N"), "{down} {warned}");
    // The command line may have another one.
    let (down, warned) = map_with(HOLD, &["--base", "0,-3"]);
    assert!((down - 7.0).abs() < 1e-9 && warned.is_empty(), "{down} {warned}");
}

#[test]
fn a_load_at_rest_that_is_left_out_has_a_warning() {
    let (answer, warned) = told(HOLD, &["hold", "-", "--force", "0,-4"]);
    assert!(answer.contains("10 N (2.5 times this load)"), "{answer}");
    assert!(warned.contains("without that at rest of the scene's question 1, (0, -2) N"), "{warned}");
    let (answer, warned) = told(HOLD, &["hold", "-", "--force", "0,-4", "--base", "0,-2"]);
    assert!(answer.contains("8 N (2 times this load)") && warned.is_empty(), "{answer} {warned}");
}

#[test]
fn without_any_load_it_is_refused() {
    let (answer, warned) = told("", &["need", "-", "squeeze"]);
    assert!(answer.is_empty() && warned.starts_with("say for which load"), "{answer} {warned}");
}
