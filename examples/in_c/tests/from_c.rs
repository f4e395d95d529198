//! Compiles and runs a C program that uses the header.

use std::env;
use std::path::Path;
use std::process::Command;

#[test]
fn a_program_in_c_gets_the_answers_of_paper_and_pencil() {
    // Cargo puts the C library into the directory of this test's executable.
    let test = env::current_exe().expect("this test has a place");
    let built = test.parent().expect("it is a directory");
    let program = built.join("watch_from_c");
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    let compiled = Command::new("cc")
        .args(["-std=c11", "-Wall", "-Wextra", "-Werror", "-o"])
        .arg(&program)
        .arg(here.join("tests/watch.c"))
        .arg(built.join("libgrasp_lcp_c.a"))
        .args(["-lm", "-lpthread", "-ldl"])
        .status();
    assert!(compiled.expect("a C compiler").success());
    assert!(Command::new(&program).status().expect("it is there").success());
}
