//! Typical mistakes: each is told with what to write, and with its exit code.

use crate::{run, run_on, scene, text};

/// A scene with one thing wrong.
fn told(from: &str, to: &str) -> (i32, String) {
    const GOOD: &str = r#"{"format": "grasp-lcp/1", "planar": {"outline": [[-1, -1], [1, -1], [1, 1], [-1, 1]], "contacts": [
        {"name": "index", "point": [1, 0], "normal": [-1, 0], "series_stiffness": [1000, 800], "friction": 0.5, "pressed_with": 3},
        {"name": "thumb", "point": [-1, 0], "normal": [1, 0], "series_stiffness": [1000, 800], "friction": 0.5, "pressed_with": 3}],
        "questions": [{"onset": {"direction": {"force": [0, -1]}}}]}}"#;
    assert!(GOOD.contains(from), "{from}");
    let output = run_on(GOOD.replacen(from, to, 1).as_bytes(), &["ask", "-"]);
    (output.status.code().expect("ends"), text(&output.stderr))
}

#[test]
fn scenes_that_are_refused() {
    let cases = [
        ("{\"format\"", "\u{feff}{\"format\"", "byte-order mark"),
        ("\"format\": \"grasp-lcp/1\", ", "", "write \"format\": \"grasp-lcp/1\""),
        ("grasp-lcp/1", "grasp-lcp/7", "must be \"grasp-lcp/1\""),
        (
            "{\"onset\": {\"direction\": {\"force\": [0, -1]}}}",
            "\"onset\"",
            "such as {\"onset\": {\"direction\"",
        ),
        (
            "{\"direction\": {\"force\": [0, -1]}}",
            "{}",
            "direction, command_change and joint_change are zero",
        ),
        ("[0, -1]", "[0, 0]", "one of them must change something"),
        ("[0, -1]", "[0, -1, 0]", "3 given, must be 2 in the plane"),
        ("[0, -1]", "[0, 1e99]", "1e99 must be finite"),
        ("\"force\"", "\"Force\"", "Force"),
        ("\"friction\": 0.5", "\"friction\": -0.5", "friction coefficient is -0.5"),
        ("\"friction\": 0.5", "\"friction\": \"high\"", "expected a number or \"infinite\""),
        ("\"friction\": 0.5", "\"frction\": 0.5", "unknown field `frction`"),
        ("\"normal\": [-1, 0]", "\"normal\": [0, 0]", "normal is 0"),
        ("\"normal\": [-1, 0], ", "", "missing field `normal`"),
        ("\"point\": [1, 0]", "\"point\": \"left\"", "planar.contacts[0].point"),
        (
            "\"series_stiffness\": [1000, 800]",
            "\"series_stiffness\": [1000]",
            "must be 2 (normal, tangential)",
        ),
        ("\"series_stiffness\": [1000, 800]", "\"series_stiffness\": [0, 800]", "series stiffness is 0"),
        ("\"series_stiffness\": [1000, 800], ", "", "no stiffness: give body_stiffness"),
        ("\"pressed_with\": 3", "\"pressed_with\": \"3\"", "planar.contacts[0].pressed_with"),
        ("\"planar\"", "\"spatial\"", "spatial."),
        ("\"planar\"", "\"plane\"", "unknown field `plane`"),
        ("\"contacts\"", "\"contact\"", "unknown field `contact`"),
        (
            "\"questions\"",
            "\"settings\": {\"cone\": \"square\"}, \"questions\"",
            "expected `round` or `polygon`",
        ),
        ("}}}]}}", "}}}]}", "EOF while parsing"),
        ("\"thumb\", ", "\"thumb\" ", "expected `,` or `}`"),
        ("{\"onset\": {\"direction\": {\"force\": [0, -1]}}}", "{\"follow\": {}}", "missing field `legs`"),
        ("{\"onset\"", "{\"slide\"", "unknown variant `slide`"),
    ];
    for (from, to, expected) in cases {
        let (code, message) = told(from, to);
        assert!(code == 3 && message.starts_with("standard input: "), "{code} {message}");
        assert!(message.contains(expected), "{to}: {message}");
    }
    assert_eq!(told("index", "index"), (0, String::new()));
}

#[test]
fn scenes_that_are_seldom_meant() {
    let cases = [
        ("[-1, 0]", "[1, 0]", "index: its normal points out of the outline"),
        (
            "\"pressed_with\": 3},\n        {\"name\": \"thumb\", \"point\": [-1, 0], \"normal\": [1, 0], \"series_stiffness\": [1000, 800], \"friction\": 0.5, \"pressed_with\": 3}",
            "\"command\": [0, 0]},\n        {\"name\": \"thumb\", \"point\": [-1, 0], \"normal\": [1, 0], \"series_stiffness\": [1000, 800], \"friction\": 0.5}",
            "no finger presses",
        ),
    ];
    for (from, to, expected) in cases {
        let (code, message) = told(from, to);
        assert!(code == 0 && message.starts_with("warning: standard input: "), "{code} {message}");
        assert!(message.contains(expected), "{message}");
    }
    // The scenes of the repository mean what they say: a ladder, a glass on a tray need no finger that presses.
    let files = ["", "everyday"].map(|folder| std::fs::read_dir(scene(folder)).expect("is there"));
    for file in files.into_iter().flatten() {
        let file = file.expect("is there").path();
        if file.extension().is_some_and(|end| end == "json") {
            assert_eq!(text(&run(&["ask", &file.display().to_string()]).stderr), "", "{}", file.display());
        }
    }
}

#[test]
fn command_lines_that_are_wrong() {
    let (mug, planar) = (scene("mug.json"), scene("ladder.json"));
    let cases: [(&[&str], i32, &str); 11] = [
        (&["onset", &mug, "--force", "0,-1"], 2, "--force: 2 given, must be three numbers in space"),
        (&["onset", &planar, "--force", "0,-1,0"], 2, "--force: 3 given, must be two numbers in the plane"),
        (&["onset", &mug, "--force", "0,0,down"], 2, "`down` is no finite number"),
        (&["onset", &mug, "--force", "0,0,0"], 3, "one of them must change something"),
        (&["solve", &mug, "--moment", "1"], 2, "--moment: 1 given, must be 3"),
        (&["solve", &mug, "--at", "0,0,0"], 2, "--at without --force"),
        (&["turn", &mug, "--weight", "0,0,-1"], 2, "--axis is missing"),
        (&["turn", &mug, "--weight", "0,0,-1", "--axis", "0,0,0"], 3, "axis"),
        (&["turn", &planar, "--weight", "0,-1", "--axis", "0,0,1"], 2, "there is none in the plane"),
        (&["stream", "--threads", "0"], 2, "threads"),
        (&["grasp"], 2, "unrecognized subcommand"),
    ];
    for (arguments, code, expected) in cases {
        let output = run(arguments);
        let message = text(&output.stderr);
        assert!(output.status.code() == Some(code) && message.contains(expected), "{arguments:?}: {message}");
    }
    let missing = run(&["ask", "no_such_scene.json"]);
    assert!(missing.status.code() == Some(1) && text(&missing.stderr).starts_with("no_such_scene.json: "));
}
