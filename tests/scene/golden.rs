//! First lines of answers, faults and warnings agree word by word with the files of `tests/golden`. Other tests check their content.
//!
//! `GRASP_LCP_UPDATE=1 cargo test -p grasp-lcp-tests --test scene golden` writes the files anew.

use std::path::{Path, PathBuf};

use grasp_lcp::scene::{Scene, Setup};
use grasp_lcp::words::Words;
use serde_json::{Value, json};

/// The largest number of sentences in these files.
const MOST: usize = 60;
/// The beginning of a line that contains an answer, and not a scene or a question.
const ANSWER: &str = "    ";

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("golden")
}

/// A scene from the name of an example file, or from the fields of its setup.
fn scene_of(text: &str) -> Value {
    let text = text.trim();
    if Path::new(text).extension().is_some_and(|end| end == "json") {
        let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../examples/scenes").join(text);
        return serde_json::from_slice(&std::fs::read(file).expect("is there")).expect("JSON");
    }
    let (space, fields) = text.split_once(':').expect("planar or spatial");
    json!({ "format": "grasp-lcp/1", space: serde_json::from_str::<Value>(fields).expect("JSON") })
}

fn first_lines<const C: usize>(setup: &Setup<C>, answers: &[grasp_lcp::scene::Answer<C>]) -> Vec<String> {
    let pairs = setup.questions.iter().zip(answers);
    pairs.map(|(question, answer)| question.first_line(answer, Words::default())).collect()
}

/// The first line of each answer; the fault of a refused scene; the warnings of a scene without questions.
fn told(scene: &Value) -> Vec<String> {
    let scene = match Scene::from_json(scene.to_string().as_bytes()) {
        Ok(scene) => scene,
        Err(fault) => {
            let field = fault.field.map_or(String::new(), |field| format!("{field}: "));
            return vec![format!("{field}{}", fault.message)];
        }
    };
    let lines = scene.answers().map(|answers| match (scene.planar(), answers.clone().planar()) {
        (Some(setup), Some(answers)) => first_lines(&setup, &answers),
        _ => first_lines(&scene.setup, answers.list()),
    });
    match lines {
        Ok(lines) if lines.is_empty() => {
            scene.warnings().expect("well posed").iter().map(ToString::to_string).collect()
        }
        Ok(lines) => lines,
        Err(error) => vec![error.to_string()],
    }
}

/// The text of a file with current answers, and the number of answers. In a file, a scene ends at the next empty line. Below this line, `? question`
/// asks about the scene, and `! from => to` changes the scene's text.
fn renewed(text: &str) -> (String, usize) {
    let (mut new, mut scene) = (Vec::new(), String::new());
    for line in text.lines().filter(|line| !line.starts_with(ANSWER)) {
        new.push(line.to_owned());
        let mut answer = |scene: &Value| new.extend(told(scene).iter().map(|told| format!("{ANSWER}{told}")));
        if line.is_empty() {
            scene.clear();
        } else if let Some(question) = line.strip_prefix("? ") {
            let mut asked = scene_of(&scene);
            let space = if asked["planar"].is_object() { "planar" } else { "spatial" };
            asked[space]["questions"] = json!([serde_json::from_str::<Value>(question).expect("JSON")]);
            answer(&asked);
        } else if let Some((from, to)) = line.strip_prefix("! ").and_then(|change| change.split_once(" =>")) {
            assert!(scene.contains(from), "{from}");
            answer(&scene_of(&scene.replace(from, to.trim_start())));
        } else if !line.starts_with('#') {
            scene += line;
        }
    }
    let count = new.iter().filter(|line| line.starts_with(ANSWER)).count();
    (new.join("\n") + "\n", count)
}

#[test]
fn first_lines_faults_and_warnings_are_those_of_the_files() {
    let update = std::env::var_os("GRASP_LCP_UPDATE").is_some();
    let (mut sentences, mut wrong) = (0, Vec::new());
    let mut files: Vec<_> =
        std::fs::read_dir(folder()).expect("is there").map(|file| file.expect("a file").path()).collect();
    files.sort();
    for file in files {
        let text = std::fs::read_to_string(&file).expect("a text");
        let (new, count) = renewed(&text);
        sentences += count;
        if update {
            std::fs::write(&file, &new).expect("is written");
        }
        wrong.extend(
            new.lines()
                .zip(text.lines())
                .filter(|(new, old)| new != old)
                .map(|(new, old)| format!("{}:\n- {old}\n+ {new}", file.display())),
        );
        assert!(update || new.lines().count() == text.lines().count(), "{}", file.display());
    }
    assert!(update || wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(sentences <= MOST, "{sentences}");
}
