//! If the reader of the output is gone, the program ends quietly. If a disk is full, it ends with one line and an exit code. It never panics.

use std::fs::File;
use std::io::{Read, Write};
use std::process::{Child, Command, Stdio};

use crate::{PROGRAM, folder, scene, text};

fn commands() -> Vec<Vec<String>> {
    let output = folder("full").display().to_string();
    let (box_in_hand, cup) = (scene("box.json"), scene("cup.json"));
    let all: [&[&str]; 13] = [
        &["ask", &cup],
        &["ask", &cup, "--json"],
        &["hold", &box_in_hand, "--mass", "0.5"],
        &["need", &box_in_hand, "squeeze", "--mass", "0.5"],
        &["follow", &box_in_hand, "--to", "0,-5"],
        &["map", &box_in_hand, "-o", &output],
        &["draw", &cup, "-o", &output],
        &["--help"],
        &["hold", "--help"],
        &["--version"],
        &["schema"],
        &["completions", "bash"],
        &["man"],
    ];
    all.into_iter().map(|words| words.iter().map(|word| (*word).to_owned()).collect()).collect()
}

fn started(arguments: &[String], stdout: Stdio) -> Child {
    let mut program = Command::new(&*PROGRAM);
    program.args(arguments).stdin(Stdio::piped()).stdout(stdout).stderr(Stdio::piped());
    program.spawn().expect("starts")
}

/// The exit code and the messages on standard error.
fn ended(program: Child) -> (Option<i32>, String) {
    let output = program.wait_with_output().expect("ends");
    (output.status.code(), text(&output.stderr))
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_is_told_in_one_line() {
    let full = || Stdio::from(File::options().write(true).open("/dev/full").expect("is there"));
    for arguments in commands() {
        let (code, message) = ended(started(&arguments, full()));
        assert_eq!(code, Some(1), "{arguments:?}: {message}");
        let lines: Vec<_> = message.lines().collect();
        assert!(
            matches!(lines[..], [line] if line.starts_with("standard output: ")),
            "{arguments:?}: {message}"
        );
    }
    let mut stream = started(&["stream".to_owned()], full());
    let input = std::fs::read(scene("stream.jsonl")).expect("is there");
    stream.stdin.take().expect("piped").write_all(&input).expect("is read");
    let (code, message) = ended(stream);
    assert!(code == Some(1) && message.starts_with("standard output: "), "{code:?} {message}");
}

/// If messages cannot be written, the exit code is the same.
#[cfg(target_os = "linux")]
#[test]
fn a_full_place_for_messages() {
    for (arguments, expected) in [(["ask", "no_such_scene.json"], 1), (["ask", "/dev/null"], 3)] {
        let full = File::options().write(true).open("/dev/full").expect("is there");
        let status = Command::new(&*PROGRAM).args(arguments).stderr(full).status().expect("starts");
        assert_eq!(status.code(), Some(expected), "{arguments:?}");
    }
}

#[test]
fn nobody_reads_on() {
    for arguments in commands() {
        let mut program = started(&arguments, Stdio::piped());
        let mut first = [0; 1];
        let mut reader = program.stdout.take().expect("piped");
        reader.read_exact(&mut first).expect("begins");
        drop(reader);
        let (code, message) = ended(program);
        assert!(code == Some(0) && message.is_empty(), "{arguments:?}: {code:?} {message}");
    }
}
