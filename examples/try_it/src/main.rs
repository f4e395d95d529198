//! Writes a web page on which the crate can be tried.
//!
//! `cargo run --release --package try-it [file]` writes the page, by default to `output/try_it.html`. Exit code 2 means that the toolchain
//! lacks WebAssembly.

mod base64;
mod failure;
mod module;
mod page;

use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::{env, fs};

use failure::Failure;

fn main() -> ExitCode {
    match write_page() {
        Ok((path, bytes)) => {
            println!("{} ({:.1} MB)", path.display(), bytes as f64 / 1e6);
            ExitCode::SUCCESS
        }
        Err(failure) => {
            eprintln!("try-it: {failure}");
            ExitCode::from(failure.exit_code())
        }
    }
}

/// Writes the page. Returns its path and its size in bytes.
fn write_page() -> Result<(PathBuf, usize), Failure> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let path = env::args_os().nth(1).map_or_else(|| PathBuf::from("output/try_it.html"), PathBuf::from);
    let text = page::page(&module::build(&root)?)?;
    if let Some(directory) = path.parent() {
        fs::create_dir_all(directory)?;
    }
    fs::write(&path, &text)?;
    Ok((path, text.len()))
}
