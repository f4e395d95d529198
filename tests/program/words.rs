//! Output for people contains no names of types, no minus before zero and no "NaN", in any command and any figure.

use std::path::{Path, PathBuf};

use crate::{ROOT, folder, run, text};

/// The example scenes, and scenes kept here because their output was wrong once.
fn scenes() -> Vec<PathBuf> {
    let folders = ["examples/scenes", "tests/program/scenes"];
    let files = folders.into_iter().flat_map(|folder| {
        std::fs::read_dir(Path::new(ROOT).join(folder))
            .expect("is there")
            .map(|file| file.expect("is there").path())
    });
    let mut files: Vec<_> = files.filter(|file| file.extension().is_some_and(|end| end == "json")).collect();
    files.sort();
    files
}

/// Commands with their own loads, in the plane or in space.
fn commands(is_planar: bool) -> Vec<Vec<&'static str>> {
    let [down, aside, axis] =
        if is_planar { ["0,-1", "0.5,0.1", ""] } else { ["0,0,-1", "0.5,0.1,0", "0,1,0"] };
    let mut all = vec![
        vec!["ask"],
        vec!["ask", "--points"],
        vec!["ask", "--digits", "15"],
        vec!["hold", "--force", down],
        vec!["hold", "--mass", "40"],
        vec!["solve", "--force", aside],
        vec!["onset", "--force", aside],
        vec!["follow", "--to", down, "--to", aside],
        vec!["follow", "--to", down, "--points"],
        vec!["need", "squeeze", "--force", down],
        vec!["need", "load", "--force", down, "--may-slide"],
        vec!["need", "friction", "--force", down],
        vec!["need", "arm", "--force", down, "--along", aside],
    ];
    let tilts = [vec!["turn", "--weight", down], vec!["need", "angle", "--force", down]];
    all.extend(tilts.map(|tilt| if is_planar { tilt } else { [&tilt[..], &["--axis", axis]].concat() }));
    all
}

/// The first part of a text that shows program internals, such as debug output or the name of a type.
fn inside(told: &str) -> Option<String> {
    let debug = ["Some(", "None", " { ", "::", "NaN", "\u{1b}"].into_iter().find(|word| told.contains(word));
    let is_of_a_name = |c: char| c.is_alphanumeric() || c == '_';
    // A word with a capital letter inside is the name of a type or a variant.
    let variant = told.split(|c| !is_of_a_name(c)).find(|word| {
        let letters: Vec<_> = word.chars().collect();
        !matches!(*word, "kN" | "kPa")
            && letters.windows(2).any(|pair| pair[0].is_ascii_lowercase() && pair[1].is_ascii_uppercase())
    });
    let numbers = told.split(|c: char| !(c.is_ascii_alphanumeric() || matches!(c, '.' | '-' | '+' | '−')));
    let minus_zero = numbers.into_iter().find(|word| {
        let digits = word.strip_prefix('-').or_else(|| word.strip_prefix('−'));
        digits.is_some_and(|digits| digits.parse::<f64>().is_ok_and(|x| x == 0.0 || !x.is_finite()))
    });
    let words = told.split_whitespace().find(|word| matches!(*word, "inf" | "-inf" | "nan"));
    debug.or(variant).or(minus_zero).or(words).map(str::to_owned)
}

#[test]
fn the_test_sees_what_it_looks_for() {
    for bad in [
        "beyond: Undecided { doubt: x }",
        "RayWithoutProof",
        "by (0, -0.000000)",
        "−0 N",
        "margin inf",
        "Some(3)",
        "-0e0",
        "Doubt::Inaccurate",
    ] {
        assert!(inside(bad).is_some(), "{bad}");
    }
    for good in [
        "HOLDS, F_n (N), 6 N m at -0.5, 2 kN, 20 kPa",
        "SLIPS OUT at 1e-05",
        "within 5 mm and 7.3°",
        "|F_t| / μF_n = −3",
    ] {
        assert_eq!(inside(good), None, "{good}");
    }
}

#[test]
fn every_command_speaks_to_people() {
    let mut told = 0;
    for scene in scenes() {
        let content = std::fs::read_to_string(&scene).expect("is there");
        let path = scene.display().to_string();
        // Commands of `need` try many amounts, so most of them are skipped for soft contacts, for which the words are the same.
        let is_soft = content.contains("\"soft\"");
        let commands = commands(content.contains("\"planar\"")).into_iter();
        for command in
            commands.filter(|command| !(is_soft && command[0] == "need" && command[1] != "squeeze"))
        {
            let output = run(&[&command[..1], &[path.as_str()], &command[1..]].concat());
            let (words, remarks) = (text(&output.stdout), text(&output.stderr));
            let context = format!("{command:?} {path}: {words}");
            assert!(matches!(output.status.code(), Some(0 | 3 | 4)), "{context}");
            // File names are not checked.
            let remarks = remarks.replace(&path, "");
            for said in [&words, &remarks] {
                assert_eq!(inside(said), None, "{context}");
            }
            told += usize::from(!words.is_empty());
        }
    }
    assert!(told > 120, "{told}");
}

/// The text of a picture or a page, without markup, scripts and styles.
fn texts(picture: &str) -> String {
    let mut text = picture.to_owned();
    for (from, to) in [("<script", "</script>"), ("<style", "</style>")] {
        while let Some(start) = text.find(from) {
            let end = text[start..].find(to).map_or(text.len(), |end| start + end + to.len());
            text.replace_range(start..end, "");
        }
    }
    let parts = text.split('<').filter_map(|part| part.split_once('>'));
    parts.map(|(_, words)| words).collect::<Vec<_>>().join("\n")
}

#[test]
fn every_figure_speaks_to_people() {
    let folder = folder("words");
    let output = folder.display().to_string();
    for scene in scenes() {
        let drawn = run(&["draw", &scene.display().to_string(), "-o", &output]);
        assert!(matches!(drawn.status.code(), Some(0 | 2)), "{}", text(&drawn.stderr));
    }
    let mut figures = 0;
    for file in std::fs::read_dir(&folder).expect("is there") {
        let file = file.expect("is there").path();
        let texts = texts(&std::fs::read_to_string(&file).expect("text"));
        assert_eq!(inside(&texts), None, "{}: {texts}", file.display());
        figures += 1;
    }
    assert!(figures > 10, "{figures}");
}
