//! The guide's twelve everyday questions are answered as it says, each on a scene of at most twelve lines. So are its questions about several bodies.

use std::collections::HashSet;

use crate::{ROOT, dialogues, run, text};

const SCENES: &str = "examples/scenes/everyday/";

/// Checks that the questions of a page are answered as quoted. Returns their number and the number of their scenes.
fn answered(page: &str, folder: &str) -> (usize, usize) {
    let page = std::fs::read_to_string(format!("{ROOT}/src/guide/{page}.rs")).expect("is there");
    let lines: Vec<_> = page.lines().map(|line| line.trim_start_matches("//!").trim_start()).collect();
    let page = lines.join("\n");
    let (mut scenes, mut wrong) = (HashSet::new(), Vec::new());
    let dialogues = dialogues(&page, folder);
    for (arguments, told) in &dialogues {
        let output = run(&arguments.iter().map(String::as_str).collect::<Vec<_>>());
        assert!(
            output.status.success() && output.stderr.is_empty(),
            "{arguments:?}: {}",
            text(&output.stderr)
        );
        let printed = text(&output.stdout);
        let (printed, told) =
            (printed.lines().next().expect("an answer"), told.lines().next().expect("a line"));
        if printed != told {
            wrong.push(format!("{arguments:?}\n- {told}\n+ {printed}"));
        }
        scenes.insert(arguments[1].clone());
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    (dialogues.len(), scenes.len())
}

#[test]
fn the_first_line_is_the_one_quoted() {
    assert_eq!(answered("everyday", SCENES), (12, 12));
    assert_eq!(answered("loads_that_repeat", "examples/scenes/repeat/"), (7, 4));
    assert_eq!(answered("several_bodies", "examples/scenes/bodies/"), (8, 7));
    assert_eq!(answered("choosing_fingers", "examples/scenes/improve/"), (4, 3));
    assert_eq!(answered("kinetic_friction", "examples/scenes/"), (2, 1));
    assert_eq!(answered("slips_that_were_seen", "examples/scenes/slips/"), (3, 1));
}

#[test]
fn no_scene_has_more_than_twelve_lines() {
    for file in std::fs::read_dir(format!("{ROOT}/{SCENES}")).expect("is there") {
        let file = file.expect("is there").path();
        let lines = std::fs::read_to_string(&file).expect("a scene").lines().count();
        assert!(lines <= 12, "{}: {lines}", file.display());
    }
}
