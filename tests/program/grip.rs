//! One or two commands lead from the mesh of a part to a verdict.

use std::fmt::Write;
use std::path::PathBuf;

use crate::{folder, run, run_on, text};

/// A block of 40 x 60 x 30 mm with a corner at the origin, as an STL.
fn block(name: &str) -> PathBuf {
    let corner = |i: usize| [40 * (i & 1), 60 * (i >> 1 & 1), 30 * (i >> 2)];
    let sides = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    let mut stl = "solid block\n".to_owned();
    for [a, b, c, d] in sides {
        for i in [a, b, c, a, c, d] {
            let [x, y, z] = corner(i);
            writeln!(stl, "vertex {x} {y} {z}").expect("a text");
        }
    }
    let path = folder(name).join("block.stl");
    std::fs::write(&path, stl).expect("a file");
    path
}

/// Two jaws that press with 8 N hold 8 N with a friction of 0.5. If the mass is not given, it is that of the part's volume in steel.
#[test]
fn one_command_leads_from_a_mesh_to_a_verdict() {
    let mesh = block("grip_asked").display().to_string();
    let grip = |force: &str, mass: &str| {
        let to = ["new", "grip", &mesh, "--jaws", "20x30mm", "--force", force, "--mass", mass, "--ask"];
        text(&run(&to).stdout).lines().next().unwrap_or_default().to_owned()
    };
    assert!(grip("8", "0.8").starts_with("HOLDS, everything sticks: 8 N"), "{}", grip("8", "0.8"));
    assert!(grip("8", "0.9").contains(" 8 N of 8.829 N"), "{}", grip("8", "0.9"));
    let beyond =
        run(&["new", "grip", &mesh, "--jaws", "20x30mm", "--force", "8", "--at", "20,60,15mm", "--ask"]);
    assert!(text(&beyond.stderr).contains("part with 50 %"), "{}", text(&beyond.stderr));
}

#[test]
fn two_commands_lead_from_a_mesh_to_a_verdict() {
    let mesh = block("grip").display().to_string();
    let scene = run(&["new", "grip", &mesh, "--jaws", "20x30mm", "--closing", "1,0,0", "--force", "40"]);
    assert!(scene.status.success(), "{}", text(&scene.stderr));
    let asked = run_on(&scene.stdout, &["ask", "-"]);
    assert!(asked.stderr.is_empty(), "{}", text(&asked.stderr));
    assert!(text(&asked.stdout).starts_with("HOLDS, everything sticks"), "{}", text(&asked.stdout));
    // The weight of the given mass acts at the centre of the part. The jaws hold 2 μ N = 40 N.
    let answer = text(&run_on(&scene.stdout, &["hold", "-", "--mass", "4"]).stdout);
    assert!(answer.starts_with("HOLDS"), "{answer}");
    let answer = text(&run_on(&scene.stdout, &["hold", "-", "--mass", "4.2"]).stdout);
    assert!(answer.starts_with("SLIPS OUT at 40 N"), "{answer}");
}

#[test]
fn a_jaw_beyond_the_part_is_a_warning_or_an_error() {
    let mesh = block("grip_beyond").display().to_string();
    let grip = |at: &str| run(&["new", "grip", &mesh, "--jaws", "20x30mm", "--force", "40", "--at", at]);
    let half = run_on(&grip("20,60,15mm").stdout, &["ask", "-"]);
    assert!(
        text(&half.stderr).contains("first misses") && text(&half.stderr).contains(" 50 % "),
        "{}",
        text(&half.stderr)
    );
    let beyond = grip("20,80,15mm");
    assert_eq!(beyond.status.code(), Some(3));
    assert!(text(&beyond.stderr).contains("contact 0 (first): misses"), "{}", text(&beyond.stderr));
}

#[test]
fn what_is_missing_is_said() {
    let mesh = block("grip_missing").display().to_string();
    for (arguments, said) in [
        (vec!["new", "grip"], "say the mesh"),
        (vec!["new", "grip", &mesh], "say the jaws"),
        (vec!["new", "grip", &mesh, "--jaws", "20x30mm"], "say the force"),
        (vec!["new", "grip", &mesh, "--jaws", "20x30furlong", "--force", "4"], "is no length"),
        (vec!["new", "grip", &mesh, "--jaws", "20mm", "--force", "4"], "--jaws: 1 given"),
        (vec!["new", "grip", &mesh, "--jaws", "20x30mm", "--force", "4", "--unit", "ft"], "--unit: ft given"),
    ] {
        let output = run(&arguments);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}");
        assert!(text(&output.stderr).contains(said), "{}", text(&output.stderr));
    }
    let output = run(&["new", "grip", "nowhere.stl", "--jaws", "20x30mm", "--force", "40"]);
    assert!(
        !output.status.success() && text(&output.stderr).contains("mesh: nowhere.stl"),
        "{}",
        text(&output.stderr)
    );
}
