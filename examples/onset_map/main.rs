//! At which load does a grasp start to slide, and how much can it hold, for a force in every direction?
//!
//! `cargo run --release --example onset_map` draws polar pictures of the paper's two planar grasps and maps of a bottle in space.
//!
//! `cargo run --release --example onset_map -- --scene examples/scenes/mug.json --at 0.006,0,-0.02` does it for a grasp in a file. The force acts at
//! the point after `--at` (m), the origin without it. It comes on top of the base load of the first onset that the scene asks for, if it asks for one.
//!
//! The onset is found directly, and so is the weakest direction. Beside the onset stands what is left of it with three standard deviations in reserve,
//! where friction, stiffness and squeeze are not known exactly. The limit is where the load path in that direction, followed from event to event with slip memory, is lost; how it is lost
//! is told: a limit load has no equilibrium beyond, at a snap there are others, to which a grasp may or may not come.

#[path = "../support/scene_file.rs"]
mod scene_file;

mod ask;
mod limit;
mod plane;
mod space;
mod watch;

use std::path::Path;
use std::process::ExitCode;

use grasp_lcp::scene::{Scene, Space};

type Failure = Box<dyn std::error::Error>;

/// Scenes drawn without arguments: title, name of the picture, text.
const SCENES: [(&str, &str, &str); 3] = [
    ("The paper's two fingers", "two_fingers", include_str!("../scenes/paper_two_fingers.json")),
    ("The paper's disk in three fingers", "disk", include_str!("../scenes/paper_disk.json")),
    ("A bottle in a thumb and three fingers", "bottle", include_str!("../scenes/bottle.json")),
];

const USAGE: &str = "usage: onset_map [--scene FILE [--at X,Y[,Z]]]";

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let done = match arguments.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        [] => of_every_scene(),
        ["--scene", file] => of_file(Path::new(file), None),
        ["--scene", file, "--at", point] => of_file(Path::new(file), Some(point)),
        _ => Err(USAGE.into()),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("{message}");
            ExitCode::FAILURE
        }
    }
}

fn of_every_scene() -> Result<(), Failure> {
    for (title, name, text) in SCENES {
        let scene = scene_file::parse(text.as_bytes())?;
        of_scene(&scene, title, name, None)?;
        println!();
    }
    Ok(())
}

fn of_file(file: &Path, point: Option<&str>) -> Result<(), Failure> {
    let scene = scene_file::read(file)?;
    let stem = file.file_stem().unwrap_or_default().to_string_lossy();
    let name = format!("scene_{stem}");
    of_scene(&scene, &stem.replace('_', " "), &name, point)
        .map_err(|error| format!("{}: {error}", file.display()).into())
}

fn of_scene(scene: &Scene, title: &str, name: &str, point: Option<&str>) -> Result<(), Failure> {
    match &scene.space {
        Space::Planar(setup) => plane::map(setup, title, name, ask::point(point)?),
        Space::Spatial(setup) => space::map(setup, title, name, ask::point(point)?),
    }
}
