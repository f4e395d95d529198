//! What several examples share: the paper's grasps and printed numbers, and a place for pictures.
#![allow(dead_code, unreachable_pub)] // shared by several examples, none of which needs all of it

pub mod paper;

use std::io;
use std::path::PathBuf;

/// Writes a picture into `output/` and says where.
pub fn save(name: &str, svg: &str) -> io::Result<()> {
    let folder = PathBuf::from("output");
    std::fs::create_dir_all(&folder)?;
    let path = folder.join(name);
    std::fs::write(&path, svg)?;
    println!("wrote {}", path.display());
    Ok(())
}
