//! Commands give the answers of the library, and write the requested pictures.

use std::io::{BufRead, BufReader, Write};
use std::process::{Command, Stdio};

use grasp_lcp::planar;
use serde_json::{Value, json};

use crate::{PROGRAM, folder, run, run_on, scene, text};

fn json(arguments: &[&str]) -> Value {
    let output = run(arguments);
    assert!(output.status.success(), "{arguments:?}: {}", text(&output.stderr));
    serde_json::from_slice(&output.stdout).expect("JSON")
}

/// A direction along x is not printed with an angle of some 1e-30 degrees.
#[test]
fn the_weakest_direction_is_rounded() {
    let scene = r#"{"format": "grasp-lcp/1", "planar": {"contacts": [
        {"name": "A", "point": [-0.01, 0.01], "normal": [0, -1], "friction": 0.5, "stiffness": [1e4, 1e5], "force": 10},
        {"name": "B", "point": [0.01, 0.01], "normal": [0, -1], "friction": 0.5, "stiffness": [1e4, 1e5], "force": 20},
        {"name": "floor", "point": [0, -0.01], "normal": [0, 1], "stiffness": 1e6, "soft": {"pair": {"width": 0.04}}}]}}"#;
    let output = folder("rounded").display().to_string();
    let map = text(&run_on(scene.as_bytes(), &["map", "-", "--at", "0,0.01", "-o", &output]).stdout);
    let weakest = map.lines().find(|line| line.contains("weakest direction")).expect("a line");
    assert!(["0°", "180°"].iter().any(|angle| weakest.contains(&format!("direction {angle}:"))), "{weakest}");
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
    assert!(words.contains("direction 299.736°: ") && words.contains(" at 0.10607 N"), "{words}");
    // The force of first slip in the weakest direction is the distance of the origin from the line of loads at which finger 1 slides.
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
        (&["--help"][..], &["Exit codes", "onset mug.json", "stream"][..]),
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
    assert!(text(&followed.stdout).contains("UNDECIDED where"), "{}", text(&followed.stdout));
}

#[test]
fn a_mass_is_tilted_as_its_weight_is() {
    let scene = scene("box.json");
    let tilted = |what: [&str; 2]| run(&["turn", &scene, what[0], what[1]]);
    let (mass, weight) = (tilted(["--mass", "0.75"]), tilted(["--weight", "0,-7.3575"]));
    assert!(mass.status.success() && mass.stdout == weight.stdout, "{}", text(&mass.stdout));
    assert_eq!(run(&["turn", &scene, "--at", "0,0.1"]).status.code(), Some(2));
}

/// A scene may come after or before its command. Without a load the question is about rest. `--at` applies to every force.
#[test]
fn what_is_typed_otherwise_means_the_same() {
    let gripper = scene("box.json");
    let slips = scene("box_slips.csv");
    let same = |one: &[&str], other: &[&str]| {
        let [one, other] = [one, other].map(|words| {
            let words: Vec<_> = words
                .iter()
                .map(|word| {
                    if *word == "box" {
                        &*gripper
                    } else if *word == "slips" {
                        &*slips
                    } else {
                        word
                    }
                })
                .collect();
            let output = run(&words);
            assert!(output.status.success(), "{words:?}: {}", text(&output.stderr));
            text(&output.stdout)
        });
        assert_eq!(one, other);
    };
    same(&["need", "squeeze", "box", "--mass", "0.5"], &["need", "box", "squeeze", "--mass", "0.5"]);
    same(&["box", "hold", "--mass", "0.5"], &["hold", "box", "--mass", "0.5"]);
    same(&["identify", "slips", "box"], &["identify", "box", "slips"]);
    same(&["hold", "box"], &["hold", "box", "--force", "0,0"]);
    // Without a load, the load of the scene's question `solve` is taken, which acts at (0, -0.01), also beside other forces.
    same(
        &["need", "box", "squeeze", "--base", "0,-5", "--at", "0,-0.01"],
        &["need", "box", "squeeze", "--base", "0,-5", "--at", "0,-0.01", "--force", "0,-4.905"],
    );
    same(
        &["hold", "box", "--mass", "0.5", "--acceleration", "0,9.81"],
        &["hold", "box", "--mass", "0.5", "--safety", "2"],
    );
    same(
        &["need", "box", "squeeze", "--any-force", "4.9", "--at", "0,-0.01"],
        &["need", "box", "squeeze", "--any-force", "4.9", "--at", "0,-0.01", "--force", "0,-4.905"],
    );
}

/// A picture is written to the named file. Errors in a table are reported with their line.
#[test]
fn files_that_are_named() {
    let folder = folder("named");
    let [picture, table] = ["only.svg", "slips.csv"].map(|name| folder.join(name).display().to_string());
    let output = run(&["draw", &scene("cup.json"), "--output", &picture]);
    assert!(output.status.success(), "{}", text(&output.stderr));
    assert!(std::fs::metadata(&picture).expect("is written").is_file());
    let rows: [(&[u8], &str); 2] =
        [(b"fx,fy\n0,-8\n\xff,1\n", "line 3, no UTF-8"), (b"fx,fy,fx\n0,-8,0\n", "line 1, column `fx`: ")];
    for (bytes, fault) in rows {
        std::fs::write(&table, bytes).expect("a folder");
        let output = run(&["identify", &scene("box.json"), &table]);
        assert_eq!(output.status.code(), Some(3));
        assert!(text(&output.stderr).contains(fault), "{}", text(&output.stderr));
    }
}

/// A table of 3000 equal slips of 8.2 N, for two contacts that press with 8 N each. The load of these slips is predicted only once.
#[test]
fn thousands_of_equal_slips() {
    let table = folder("equal").join("slips.csv").display().to_string();
    std::fs::write(&table, format!("fx,fy\n{}", "0,-8.2\n".repeat(3000))).expect("a folder");
    let told = text(&run(&["identify", &scene("box.json"), &table]).stdout);
    assert!(told.starts_with("friction 0.5125 from") && told.contains("from 3000 slips"), "{told}");
}

/// Tables of spreadsheets: semicolons or tabs, text between quotation marks, and a mark of the byte order in front.
#[test]
fn tables_of_spreadsheets() {
    let table = folder("separated").join("slips.csv").display().to_string();
    let tables =
        ["fx,fy\n0,-8\n0,-8.4\n", "\u{feff}fx;fy\r\n0;-8\r\n0;-8.4\r\n", "\"fx\"\t\"fy\"\n0\t-8\n0\t-8.4\n"];
    let told = tables.map(|rows| {
        std::fs::write(&table, rows).expect("a folder");
        text(&run(&["identify", &scene("box.json"), &table]).stdout)
    });
    // Two contacts with 8 N slip at 2 μ 8 N. The identified friction is the geometric mean over all slips.
    assert!(told[0].starts_with("friction 0.512") && told.iter().all(|each| *each == told[0]), "{told:?}");
}

/// A force that acts before the push may be given in columns of the table or as an option. In both cases it acts at the origin, wherever the push
/// acts.
#[test]
fn a_base_in_the_table_is_that_of_the_options() {
    let table = folder("based").join("slips.csv").display().to_string();
    let identified = |rows: String, more: &[&str]| {
        std::fs::write(&table, rows).expect("a folder");
        let output = run(&[&["identify", &scene("box.json"), &table], more].concat());
        assert!(output.status.success(), "{}", text(&output.stderr));
        text(&output.stdout)
    };
    let rows = |head: &str, more: &str| format!("fx,fy,at_x{head}\n0,-5.2,0.02{more}\n0,-5,0.02{more}\n");
    let columns = identified(rows(",base_x,base_y", ",0,-2.5"), &[]);
    assert_eq!(columns, identified(rows("", ""), &["--base", "0,-2.5"]));
    assert_ne!(columns, identified(rows("", ""), &[]));
}

/// Two jaws of 144 points each. The second question takes long. Before its answer, the first answer and a note on the running question are printed.
#[test]
fn each_answer_is_printed_when_it_is_ready() {
    let jaw = |side: f64| {
        json!({
            "point": [0.03 * side, 0, 0], "normal": [-side, 0, 0], "tangent": [0, 1, 0], "friction": 0.5, "stiffness": 1e5, "pressed_with": 20,
            "soft": { "rectangle": { "sides": [0.02, 0.03], "strips": [6, 6] } }
        })
    };
    let questions = json!([
        { "solve": { "load": { "force": [0, 0, -1] } } },
        { "need": { "quantity": "squeeze", "load": { "force": [0, 0, -5] }, "any_force": 3, "at": [0, 0.01, 0] } }
    ]);
    let scene = json!({ "format": "grasp-lcp/1", "spatial": { "contacts": [jaw(1.0), jaw(-1.0)], "questions": questions } });
    let mut program = Command::new(&*PROGRAM)
        .args(["ask", "-", "--progress"])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("starts");
    program.stdin.take().expect("piped").write_all(scene.to_string().as_bytes()).expect("is read");
    let lines = |from: Box<dyn std::io::Read>| BufReader::new(from).lines().map_while(Result::ok);
    // The pipe stays open until the end: the program stops when nothing reads the rest of its answer.
    let mut printed = lines(Box::new(program.stdout.take().expect("piped")));
    let first = printed.next();
    let told =
        lines(Box::new(program.stderr.take().expect("piped"))).find(|line| line.contains("question 2 of 2"));
    let is_at_work = program.try_wait().expect("can be asked").is_none();
    program.kill().expect("ends");
    program.wait().expect("ends");
    assert!(is_at_work, "the second question is answered before anything can be seen");
    assert!(first.as_deref().is_some_and(|line| line.starts_with("EQUILIBRIUM")), "{first:?}");
    assert!(told.as_deref().is_some_and(|line| line.ends_with(" s")), "{told:?}");
}
