//! What the commands answer is what the library answers, and what they draw is there.

use grasp_lcp::planar;
use serde_json::Value;

use crate::{folder, run, run_on, scene, text};

fn json(arguments: &[&str]) -> Value {
    let output = run(arguments);
    assert!(output.status.success(), "{arguments:?}: {}", text(&output.stderr));
    serde_json::from_slice(&output.stdout).expect("JSON")
}

#[test]
fn the_onset_of_the_papers_grasp_in_words_and_in_json() {
    let exact = 65f64.sqrt() / 66.0;
    let file = scene("paper_two_fingers.json");
    let answers = json(&["onset", &file, "--force", "0,-1", "--json"]);
    let factor = answers[0]["onset"]["factor"].as_f64().expect("slides");
    assert!((factor - exact).abs() < 1e-15, "{factor}");
    let words = text(&run(&["onset", &file, "--force", "0,-2", "--digits", "12"]).stdout);
    assert!(words.contains(&format!("at factor {:.13},", exact / 2.0)), "{words}");
}

#[test]
fn a_force_at_a_point_with_a_moment() {
    let file = scene("paper_two_fingers.json");
    let answers =
        json(&["solve", &file, "--force", "0.02,-0.05", "--at", "1,2", "--moment", "0.01", "--json"]);
    let load = planar::Wrench::force_at([0.02, -0.05], [1.0, 2.0]) + planar::Wrench::new([0.0, 0.0], 0.01);
    let grasp = support::paper::two_fingers().expect("the paper's");
    let state = grasp.solve(load).expect("a load");
    let expected = state.equilibrium().expect("holds");
    for (told, contact) in
        answers[0]["solve"]["contacts"].as_array().expect("two").iter().zip(&expected.contacts)
    {
        for axis in 0..2 {
            assert!((told["force"][axis].as_f64().expect("a number") - contact.force[axis]).abs() < 1e-14);
        }
    }
}

#[test]
fn the_scenes_questions_are_asked_by_kind() {
    let file = scene("cup.json");
    let (all, turns) = (json(&["ask", &file, "--json"]), json(&["turn", &file, "--json"]));
    let of_turns: Vec<_> = all
        .as_array()
        .expect("a list")
        .iter()
        .filter(|answer| answer.get("onset_of_turn").is_some())
        .collect();
    assert!(!of_turns.is_empty());
    assert_eq!(of_turns, turns.as_array().expect("a list").iter().collect::<Vec<_>>());
    let asked = json(&["follow", &scene("mug.json"), "--to", "0,0,-1", "--to", "0,0,0", "--json"]);
    assert_eq!(asked[0]["follow"]["outcome"], "completed");
    let tilted = json(&["turn", &scene("mug.json"), "--weight", "0,0,-2", "--axis", "0,1,0", "--json"]);
    assert!(tilted[0]["onset_of_turn"]["outcome"].is_string());
}

#[test]
fn standard_input_is_a_scene_too() {
    let input = std::fs::read(scene("book.json")).expect("is there");
    let (from_file, piped) = (run(&["ask", &scene("book.json")]), run_on(&input, &["ask", "-"]));
    assert!(piped.status.success());
    assert_eq!(text(&piped.stdout), text(&from_file.stdout));
}

#[test]
fn pictures_are_written_where_they_are_wanted() {
    let folder = folder("pictures");
    let output = folder.display().to_string();
    for (name, files) in [
        ("ladder", &["ladder.svg"][..]),
        ("cup", &["cup.html", "cup.svg", "cup_friction.svg"]),
        ("three_joint_pinch", &["three_joint_pinch.svg"]),
    ] {
        let drawn = run(&["draw", &scene(&format!("{name}.json")), "-o", &output]);
        assert!(drawn.status.success(), "{}", text(&drawn.stderr));
        for file in files {
            let picture = std::fs::read_to_string(folder.join(file)).expect("is there");
            assert!(picture.contains("</svg>") || picture.contains("</html>"), "{file}");
            assert!(text(&drawn.stdout).contains(file));
        }
    }
    let named = run(&["map", &scene("paper_two_fingers.json"), "-o", &output, "--name", "all"]);
    let words = text(&named.stdout);
    assert!(words.contains("weakest direction 299.736°: first slip at 0.10607 N"), "{words}");
    // The distance of the line of loads at which finger 1 slides.
    let map = json(&["map", &scene("paper_two_fingers.json"), "--json"]);
    let weakest = map["weakest"]["onset"].as_f64().expect("a force");
    assert!((weakest - 0.106_070_494_671_251).abs() < 1e-15, "{weakest}");
    let least = |of: &str, what: &str| {
        let all = map[of].as_array().into_iter().flatten();
        all.filter_map(|one| one[what].as_f64()).fold(f64::INFINITY, f64::min)
    };
    let (onset, held) = (least("onsets", "onset"), least("reserves", "held"));
    assert!(weakest <= onset && 0.0 < held && held < onset, "{held} {onset}");
    assert!(folder.join("all_map.svg").exists());
}

#[test]
fn help_teaches_and_completions_and_manual_are_there() {
    for (arguments, words) in [
        (&["--help"][..], &["Exit codes", "grasp-lcp onset mug.json", "stream"][..]),
        (&["onset", "--help"], &["--force", "--json", "N"]),
        (&["completions", "bash"], &["_grasp", "stream"]),
        (&["man"], &[".TH", "onset"]),
        (&["--version"], &["grasp-lcp 0"]),
    ] {
        let output = run(arguments);
        assert!(output.status.success());
        let told = text(&output.stdout);
        for word in words {
            assert!(told.contains(word), "{arguments:?}: {word}");
        }
    }
}

#[test]
fn a_start_that_is_not_known_is_undecided() {
    let gripper = run(&["new", "gripper"]).stdout;
    let followed = run_on(&gripper, &["follow", "-", "--from", "0,0,-30", "--to", "0,0,0"]);
    assert_eq!(followed.status.code(), Some(4));
    assert!(text(&followed.stdout).contains("UNDECIDED where the load begins"), "{}", text(&followed.stdout));
}

#[test]
fn a_mass_is_tilted_as_its_weight_is() {
    let scene = scene("box.json");
    let tilted = |what: [&str; 2]| run(&["turn", &scene, what[0], what[1]]);
    let (mass, weight) = (tilted(["--mass", "0.75"]), tilted(["--weight", "0,-7.3575"]));
    assert!(mass.status.success() && mass.stdout == weight.stdout, "{}", text(&mass.stdout));
    assert_eq!(run(&["turn", &scene, "--at", "0,0.1"]).status.code(), Some(2));
}
