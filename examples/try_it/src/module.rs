//! Builds the crate as a module of WebAssembly, by cargo.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fs};

use crate::failure::Failure;

const TARGET: &str = "wasm32-unknown-unknown";

/// Builds the module, and returns its bytes.
pub(crate) fn build(root: &Path) -> Result<Vec<u8>, Failure> {
    if !has_target()? {
        return Err(Failure::NoTarget(format!("rustup target add {TARGET}")));
    }
    // A separate target directory, because cargo may hold the lock of the usual one while this command runs.
    let target =
        env::var_os("CARGO_TARGET_DIR").map_or_else(|| root.join("target"), PathBuf::from).join("page");
    let cargo = env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let built = Command::new(cargo)
        .args(["build", "--locked", "--profile", "page", "--package", "try-it", "--lib", "--target", TARGET])
        .arg("--manifest-path")
        .arg(root.join("Cargo.toml"))
        .arg("--target-dir")
        .arg(&target)
        .status()?;
    if !built.success() {
        return Err(Failure::NotBuilt);
    }
    Ok(fs::read(target.join(TARGET).join("page").join("try_it.wasm"))?)
}

/// Whether the toolchain has the standard library of the target WebAssembly.
fn has_target() -> Result<bool, Failure> {
    let rustc = env::var_os("RUSTC").unwrap_or_else(|| "rustc".into());
    let told = Command::new(rustc).args(["--print", "target-libdir", "--target", TARGET]).output()?;
    Ok(told.status.success() && Path::new(String::from_utf8_lossy(&told.stdout).trim()).is_dir())
}
