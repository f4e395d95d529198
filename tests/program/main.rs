//! The program `grasp-lcp` as a user calls it: answers, messages and exit codes.

mod answers;
mod drawings;
mod everyday;
mod far;
mod fields;
mod full_disk;
mod grip;
mod mistakes;
mod names;
mod new;
mod of_the_scene;
mod own_masses;
mod pads;
mod readme;
mod schema;
mod stream;
mod values;
mod words;

use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use std::sync::LazyLock;

const ROOT: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/..");

/// The program: the path in the variable `GRASP_LCP`, or a program that cargo builds here, because it belongs to another package.
static PROGRAM: LazyLock<PathBuf> = LazyLock::new(|| {
    if let Some(program) = std::env::var_os("GRASP_LCP") {
        return PathBuf::from(program);
    }
    let target = Path::new(env!("CARGO_TARGET_TMPDIR")).with_file_name("");
    let built = Command::new(env!("CARGO"))
        .args(["build", "--locked", "--quiet", "--release", "--features", "cli-full", "--bin", "grasp-lcp"])
        .arg("--target-dir")
        .arg(&target)
        .current_dir(ROOT)
        .status()
        .expect("starts");
    assert!(built.success());
    target.join("release").join("grasp-lcp").with_extension(std::env::consts::EXE_EXTENSION)
});

fn scene(name: &str) -> String {
    Path::new(ROOT).join("examples/scenes").join(name).display().to_string()
}

/// A separate folder for the files of a test.
fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("program").join(name);
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(&folder).expect("a folder");
    folder
}

fn run_on(input: &[u8], arguments: &[&str]) -> Output {
    let mut program = Command::new(&*PROGRAM)
        .args(arguments)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("starts");
    let mut stdin = program.stdin.take().expect("piped");
    // A program that refuses its arguments does not read its input.
    let _ = stdin.write_all(input);
    drop(stdin);
    program.wait_with_output().expect("ends")
}

fn run(arguments: &[&str]) -> Output {
    run_on(b"", arguments)
}

/// Whether a word of a command is the name of a scene, a table or a mesh.
fn is_a_scene(word: &str) -> bool {
    Path::new(word).extension().is_some_and(|end| end == "json" || end == "csv" || end == "stl")
}

/// Commands of a dialogue and their expected output. Scenes are in a folder below the example scenes.
fn dialogues<'t>(block: &'t str, folder: &str) -> Vec<(Vec<String>, &'t str)> {
    let in_folder = |word: &str| {
        let name = word.strip_prefix(folder).unwrap_or(word);
        if is_a_scene(word) {
            Path::new(ROOT).join(folder).join(name).display().to_string()
        } else {
            word.to_owned()
        }
    };
    let parts = block.split("$ grasp-lcp ").skip(1).map(|part| part.split_once('\n').unwrap());
    parts.map(|(command, told)| (command.split_whitespace().map(in_folder).collect(), told)).collect()
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).expect("UTF-8")
}
