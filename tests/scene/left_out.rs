//! Where the squeeze of a pinch turns with the part, every question says how much resistance it takes: the closed form `−N / (k_t a)`, as `hold` does.

use grasp_lcp::scene::Scene;
use grasp_lcp::words::Words;

/// Two jaws that press with 20 N at ±0.04 m, with a tangential stiffness of 2000 N/m: they resist a turn with 6.4 N m/rad.
const PINCH: &str = r#"{"format": "grasp-lcp/1", "planar": {"contacts": [
    {"name": "left", "point": [-0.04, 0], "normal": [1, 0], "series_stiffness": [5000, 2000], "friction": 0.9, "pressed_with": 20},
    {"name": "right", "point": [0.04, 0], "normal": [-1, 0], "series_stiffness": [5000, 2000], "friction": 0.9, "pressed_with": 20}],
    "questions": [
        {"hold": {"load": {"moment": 0.1}}},
        {"follow": {"legs": [{"load_to": {"moment": 0.1}}, {"load_to": {"moment": 0}}]}},
        {"shake": {"loads": [{"moment": 0.1}]}},
        {"onset_of_turn": {"weight": [0, -0.2], "at": [0.5, 0], "angle_deg": 90}}]}}"#;

#[test]
fn every_question_says_what_the_squeeze_takes() {
    let scene = Scene::from_json(PINCH.as_bytes()).expect("a scene");
    let answers = serde_json::to_value(scene.answers().expect("well posed")).expect("written");
    let (setup, told) =
        (scene.planar().expect("planar"), scene.answers().expect("well posed").planar().expect("planar"));
    for (question, answer) in setup.questions.iter().zip(&told) {
        let line = question.first_line(answer, Words::default());
        assert!(line.contains(" they take 25 % of what resists"), "{line}");
    }
    let taken = 20.0 / (2000.0 * 0.04);
    // The weight of 0.2 N at 0.5 m turns out of its moment of 0.1 N m, and moves the part by a few hundredths of a millimetre, too.
    let (turn, moved) = (0.1_f64.powi(2) / 6.4, 0.04 / 1e4 + 0.04 / 4e3);
    let expected = [taken, taken, taken, taken * turn / (turn + moved)];
    for (k, (question, taken)) in
        ["hold", "follow", "shake", "onset_of_turn"].into_iter().zip(expected).enumerate()
    {
        let part = answers[k][question]["left_out"].as_f64().unwrap_or_else(|| panic!("{}", answers[k]));
        assert!((part + taken).abs() < 1e-9, "{question}: {part} {taken}");
    }
}
