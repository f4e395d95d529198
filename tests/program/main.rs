//! The program `grasp-lcp` as a user calls it: answers, messages and exit codes.

mod answers;
mod mistakes;
mod schema;
mod stream;

use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

fn scene(name: &str) -> String {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/scenes").join(name).display().to_string()
}

/// A folder of its own for what a test writes.
fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("program").join(name);
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(&folder).expect("a folder");
    folder
}

fn run_on(input: &[u8], arguments: &[&str]) -> Output {
    let mut program = Command::new(env!("CARGO_BIN_EXE_grasp-lcp"))
        .args(arguments)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("starts");
    let mut stdin = program.stdin.take().expect("piped");
    // Whoever refuses its arguments reads nothing.
    let _ = stdin.write_all(input);
    drop(stdin);
    program.wait_with_output().expect("ends")
}

fn run(arguments: &[&str]) -> Output {
    run_on(b"", arguments)
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).expect("UTF-8")
}
