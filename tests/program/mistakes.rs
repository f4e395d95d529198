//! Typical mistakes have the messages of a table (`mistakes/table.txt`), and doubtful scenes are answered with a warning.

use crate::{folder, is_a_scene, run, run_on, scene, text};

/// Exit code and message for the valid scene with one change.
fn told(from: &str, to: &str) -> (i32, String) {
    const GOOD: &str = r#"{"format": "grasp-lcp/1", "planar": {"outline": [[-1, -1], [1, -1], [1, 1], [-1, 1]], "contacts": [
        {"name": "index", "point": [1, 0], "normal": [-1, 0], "series_stiffness": [1000, 800], "friction": 0.5, "pressed_with": 3},
        {"name": "thumb", "point": [-1, 0], "normal": [1, 0], "series_stiffness": [1000, 800], "friction": 0.5, "pressed_with": 3}],
        "questions": [{"onset": {"direction": {"force": [0, -1]}}}]}}"#;
    assert!(GOOD.contains(from), "{from}");
    let output = run_on(GOOD.replace(from, to).as_bytes(), &["ask", "-"]);
    (output.status.code().expect("ends"), text(&output.stderr))
}

/// A row of the table: the arguments, the scene if the mistake is in one, and the expected message.
struct Mistake<'t> {
    arguments: Vec<String>,
    scene: String,
    is: &'t str,
    told: &'t str,
}

/// The rows of the table: a scene with changed text, or a command, and the parts of its message with the facts, in order.
fn table() -> Vec<Mistake<'static>> {
    const SCENES: [(&str, &str); 3] = [
        ("box", include_str!("mistakes/box.json")),
        ("pads", include_str!("mistakes/pads.json")),
        ("hand", include_str!("mistakes/hand.json")),
    ];
    let blocks = include_str!("mistakes/table.txt").split("\n\n").map(|block| block.trim_start_matches('\n'));
    let mistake = |block: &'static str| {
        let lines: Vec<_> = block.lines().collect();
        if let Some(command) = lines[0].strip_prefix("$ ") {
            let in_folder = |word: &str| {
                if is_a_scene(word) { scene(&format!("everyday/{word}")) } else { word.to_owned() }
            };
            let arguments = command.split(' ').map(in_folder).collect();
            return Mistake { arguments, scene: String::new(), is: lines[0], told: lines[1].trim_start() };
        }
        let (name, from) = lines[0].split_once(": ").unwrap();
        let to = lines[1].strip_prefix("  as ").unwrap();
        let (_, good) = SCENES.iter().find(|(known, _)| *known == name).expect(name);
        assert!(good.contains(from), "{from}");
        let arguments = ["ask", "-"].map(str::to_owned).to_vec();
        Mistake { arguments, scene: good.replacen(from, to, 1), is: lines[1], told: lines[2].trim_start() }
    };
    blocks.filter(|block| !block.starts_with('#')).map(mistake).collect()
}

/// Each message states the place, the given value and what is allowed.
#[test]
fn each_has_its_message() {
    let mistakes = table();
    let mut wrong = Vec::new();
    for Mistake { arguments, scene, is, told } in &mistakes {
        let output = run_on(scene.as_bytes(), &arguments.iter().map(String::as_str).collect::<Vec<_>>());
        let folder = crate::scene("everyday/");
        let message = text(&output.stderr).replace("standard input: ", "").replace(&folder, "");
        // The hint after a wrong command line is always the same.
        let message = message.split("\n\n").next().expect("a message").replace("\n  ", " ");
        let begins = told.split(" … ").next().is_some_and(|first| message.starts_with(first));
        if !begins
            || told.split(" … ").try_fold(&*message, |rest, part| Some(rest.split_once(part)?.1)).is_none()
        {
            wrong.push(format!("{is}\n  {message}\n- {told}"));
        }
        let code = if told.starts_with("warning") {
            0
        } else if !scene.is_empty() {
            3
        } else {
            output.status.code().expect("ends")
        };
        assert_eq!(output.status.code(), Some(code), "{is}: {message}");
        assert!(told.starts_with("warning") || code != 0, "{is}");
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(mistakes.len() >= 60, "{}", mistakes.len());
}

#[test]
fn the_scenes_of_the_table_are_good() {
    for good in [
        include_str!("mistakes/box.json"),
        include_str!("mistakes/pads.json"),
        include_str!("mistakes/hand.json"),
    ] {
        let output = run_on(good.as_bytes(), &["ask", "-"]);
        assert!(output.status.success() && output.stderr.is_empty(), "{}", text(&output.stderr));
    }
}

#[test]
fn scenes_that_are_seldom_meant() {
    let cases = [
        ("\"normal\": [-1, 0]", "\"normal\": [1, 0]", "index: its normal"),
        ("\"pressed_with\": 3", "\"command\": [0, 0]", "no finger presses"),
    ];
    for (from, to, expected) in cases {
        let (code, message) = told(from, to);
        assert!(code == 0 && message.starts_with("warning: standard input: "), "{code} {message}");
        assert!(message.contains(expected), "{message}");
    }
    // The example scenes give no warnings. For example, a ladder or a glass on a tray needs no pressing finger.
    let files = ["", "everyday", "repeat"].map(|folder| std::fs::read_dir(scene(folder)).expect("is there"));
    for file in files.into_iter().flatten() {
        let file = file.expect("is there").path();
        if file.extension().is_some_and(|end| end == "json") {
            assert_eq!(text(&run(&["ask", &file.display().to_string()]).stderr), "", "{}", file.display());
        }
    }
}

/// A flag of another subcommand is not taken for a value, and a mesh or a table in the place of a scene is recognised.
#[test]
fn what_belongs_elsewhere() {
    let mug = scene("mug.json");
    let tip = |arguments: &[&str]| {
        let told = text(&run(arguments).stderr);
        told.lines().find_map(|line| line.trim().strip_prefix("tip: ").map(str::to_owned))
    };
    assert_eq!(
        tip(&["hold", &mug, "--any-force", "5"]).as_deref(),
        Some("`--any-force` belongs to `need`, `improve`")
    );
    assert_eq!(tip(&["map", &mug, "--nothing", "5"]), None);
    let folder = folder("elsewhere");
    for (name, of, said) in
        [("part.stl", "solid a\n", "new grip "), ("slips.csv", "fx,fy\n1,2\n", "identify scene.json ")]
    {
        let file = folder.join(name);
        std::fs::write(&file, of).expect("is written");
        let output = run(&["ask", &file.display().to_string()]);
        assert_eq!(output.status.code(), Some(3));
        assert!(text(&output.stderr).contains(said), "{}", text(&output.stderr));
    }
}

/// Exit codes: 2 for a wrong command line, 3 for a refused scene, 1 for a missing file.
#[test]
fn each_kind_has_its_exit_code() {
    let mug = scene("mug.json");
    let cases: [(&[&str], i32); 5] = [
        (&["onset", &mug, "--force", "0,-1"], 2),
        (&["onset", &mug, "--force", "0,0,down"], 2),
        (&["grasp"], 2),
        (&["onset", &mug, "--force", "0,0,0"], 3),
        (&["ask", "no_such_scene.json"], 1),
    ];
    for (arguments, code) in cases {
        assert_eq!(run(arguments).status.code(), Some(code), "{arguments:?}");
    }
}
