//! Cost of each cargo feature: its dependencies, and on request its compile time.

use std::collections::BTreeSet;
use std::fmt::Write;
use std::process::Command;
use std::time::Instant;

use crate::scene::Failure;

const FEATURES: [&str; 7] = ["", "parallel", "plot", "serde", "json", "simd", "cli"];

/// The command `cargo` in the folder of the crate.
fn cargo() -> Command {
    let mut command = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
    command.current_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/../.."));
    command
}

/// The crates that are compiled for a single feature, with procedural macros.
fn dependencies(feature: &str) -> Result<BTreeSet<String>, Failure> {
    let arguments =
        ["tree", "--offline", "-e", "normal", "--prefix", "none", "--no-default-features", "--features"];
    let output = cargo().args(arguments).arg(feature).output()?;
    if !output.status.success() {
        return Err(String::from_utf8_lossy(&output.stderr).into());
    }
    let text = String::from_utf8(output.stdout)?;
    let name = |line: &str| line.split_whitespace().take(2).collect::<Vec<_>>().join(" ");
    Ok(text.lines().skip(1).map(name).filter(|name| !name.is_empty()).collect())
}

/// Time of a release build of the library from scratch, s.
fn compile_time(feature: &str) -> Result<f64, Failure> {
    let folder = std::env::temp_dir().join(format!("grasp-lcp-left-out-{}-{feature}", std::process::id()));
    let arguments =
        ["build", "--offline", "--release", "--lib", "--quiet", "--no-default-features", "--features"];
    let begin = Instant::now();
    let status = cargo().args(arguments).arg(feature).arg("--target-dir").arg(&folder).status()?;
    let time = begin.elapsed().as_secs_f64();
    if folder.exists() {
        std::fs::remove_dir_all(&folder)?;
    }
    if status.success() { Ok(time) } else { Err(format!("cargo build: {status}").into()) }
}

pub fn report(compile: bool) -> Result<(), Failure> {
    println!("\nWhat each feature adds, asked for alone\n");
    println!("  {:9} {:>6} {:>6} {:>12}  added crates", "feature", "crates", "added", "compile (s)");
    let mut table = String::from("feature,crates,added,compile_s\n");
    let without = dependencies("")?;
    for feature in FEATURES {
        let with = dependencies(feature)?;
        let added: Vec<&str> = with.difference(&without).map(String::as_str).collect();
        let time = if compile { format!("{:.1}", compile_time(feature)?) } else { "not asked".into() };
        let name = if feature.is_empty() { "none" } else { feature };
        println!("  {name:9} {:>6} {:>6} {time:>12}  {}", with.len(), added.len(), added.join(", "));
        writeln!(table, "{name},{},{},{}", with.len(), added.len(), if compile { &time } else { "" })?;
    }
    println!();
    support::save("left_out_features.csv", &table)?;
    Ok(())
}
