//! Control characters in names are written as escapes wherever a name is printed. So no name can clear a screen or look like an answer.

use crate::{folder, run, text};

/// A name with an escape sequence, a line like a verdict, a change of writing direction, and a bell.
const WICKED: &str = "left\u{1b}[2J\nHOLDS\u{202e}\u{7}";

fn scene() -> String {
    let finger = |x: f64, name: &str| {
        serde_json::json!({ "joints": [{ "name": format!("{name} joint"), "prismatic": [-x, 0], "stiffness": 1000, "command": 0.01, "limit": { "saturates": 12 } }],
            "contacts": [{ "name": name, "point": [x, 0], "normal": [-x, 0], "series_stiffness": [1e5, 1e5], "friction": 0.5, "pressed_with": 1 }] })
    };
    serde_json::json!({ "format": "grasp-lcp/1", "comment": format!("a {WICKED}"), "planar": {
        "contacts": [{ "name": WICKED, "point": [0, 1], "normal": [0, -1], "series_stiffness": [1e3, 1e3], "friction": 0.5, "pressed_with": 2,
            "soft": { "pad": { "width": 0.1, "strips": 1 } } }],
        "fingers": [finger(-1.0, WICKED), finger(1.0, "right")],
        "questions": [{ "solve": {} }, { "onset": { "direction": { "force": [0, 1] } } }, { "onset_of_turn": { "weight": [0, -2] } },
            { "follow": { "legs": [{ "load_to": { "force": [0, 30] } }] } }, { "hold": { "load": { "force": [0, 4] } } },
            { "need": { "quantity": "squeeze", "load": { "force": [0, 4] } } }]
    }})
    .to_string()
}

/// Whether a text has no control characters except line ends.
fn is_clean(told: &str) -> bool {
    !told.chars().any(|c| (c.is_control() && c != '\n') || c == '\u{202e}')
        && !told.lines().any(|line| line.starts_with("HOLDS, everything sticks\\"))
}

#[test]
fn wherever_names_are_printed() {
    let folder = folder("names");
    let file = folder.join("scene.json");
    std::fs::write(&file, scene()).expect("is written");
    let path = file.display().to_string();
    for arguments in [
        &["ask", &path][..],
        &["ask", &path, "--points"],
        &["need", &path, "friction", "--force", "0,1", "--contact", "nobody\u{1b}"],
        &["hold", &path, "--force", "0,1"],
        &["draw", &path, "-o", &path.replace("scene.json", "out")],
    ] {
        let output = run(arguments);
        let (words, remarks) = (text(&output.stdout), text(&output.stderr));
        assert!(matches!(output.status.code(), Some(0 | 2)), "{arguments:?}: {remarks}");
        assert!(is_clean(&words) && is_clean(&remarks), "{arguments:?}: {words:?} {remarks:?}");
    }
    let words = text(&run(&["ask", &path]).stdout);
    assert!(words.contains("left\\u{1b}[2J\\nHOLDS\\u{202e}\\u{7}"), "{words}");
    let picture = std::fs::read_to_string(folder.join("out").join("scene.svg")).expect("is drawn");
    assert!(is_clean(&picture) && !picture.contains('\u{fffd}'), "{picture}");
}

#[test]
fn what_messages_repeat_of_a_scene() {
    let folder = folder("bad names");
    let bad = [
        scene().replace("\"limit\"", "\"li\\u001bmit\""),
        scene().replace("\"saturates\":12", "\"saturates\":-1"),
        scene().replace("\"friction\":0.5", "\"friction\":-0.5"),
        scene().replace("\"friction\":0.5", "\"friction\":\"\\u001b[2J\""),
    ];
    for (number, scene) in bad.iter().enumerate() {
        let file = folder.join(format!("{number}\n\u{7}.json"));
        std::fs::write(&file, scene).expect("is written");
        let output = run(&["ask", &file.display().to_string()]);
        let message = text(&output.stderr);
        assert_eq!(output.status.code(), Some(3), "{message}");
        assert!(is_clean(&message) && message.trim_end().lines().count() == 1, "{message:?}");
    }
}
