//! Scenes from files, pictures into files.

use std::fs;
use std::io::{self, Read, Write};
use std::path::Path;

use grasp_lcp::scene::Scene;
use grasp_lcp::words::printable;

use crate::arguments::Output;
use crate::failure::Failure;

/// A scene from a file, or from standard input for `-`.
pub(crate) fn read(path: &Path) -> Result<Scene, Failure> {
    let name = name(path);
    let text = if path == Path::new("-") {
        let mut text = Vec::new();
        io::stdin().read_to_end(&mut text).map(|_| text)
    } else {
        fs::read(path)
    };
    let text = text.map_err(|error| Failure::Files(format!("{name}: {error}")))?;
    let scene = Scene::from_json(&text).map_err(|fault| Failure::Scene(format!("{name}: {fault}")))?;
    #[cfg(feature = "mesh")]
    let scene = scene
        .with_part_from(path.parent().unwrap_or(Path::new("")))
        .map_err(|error| refused(path, &error))?;
    Ok(scene)
}

/// The name of a scene in messages.
fn name(path: &Path) -> String {
    if path == Path::new("-") {
        "standard input".to_owned()
    } else {
        printable(&path.display().to_string()).into_owned()
    }
}

/// Prints warnings about a scene and its questions on standard error.
pub(crate) fn warn(path: &Path, scene: &Scene) -> Result<(), Failure> {
    let warnings = scene.warnings().map_err(|error| refused(path, &error))?;
    for warning in &warnings {
        eprintln!("warning: {}: {warning}", name(path));
    }
    Ok(())
}

/// The error of a scene whose question is refused.
pub(crate) fn refused(path: &Path, error: &grasp_lcp::Error) -> Failure {
    Failure::Scene(format!("{}: {error}", name(path)))
}

/// The place and the names of a scene's pictures.
pub(crate) struct Pictures<'a> {
    output: &'a Output,
    scene: &'a Path,
}

impl<'a> Pictures<'a> {
    pub(crate) fn new(output: &'a Output, scene: &'a Path) -> Self {
        Self { output, scene }
    }

    fn stem(&self) -> String {
        let stem = || {
            self.scene.file_stem().filter(|stem| *stem != "-").map(|stem| stem.to_string_lossy().into_owned())
        };
        self.output.name.clone().or_else(stem).unwrap_or_else(|| "scene".to_owned())
    }

    /// The title of the scene's pictures.
    pub(crate) fn title(&self) -> String {
        printable(&self.stem().replace('_', " ")).into_owned()
    }

    /// Writes the picture whose name has this end.
    pub(crate) fn save(&self, end: &str, text: &str) -> Result<(), Failure> {
        let path = self.output.output.join(format!("{}{end}", self.stem()));
        let written = fs::create_dir_all(&self.output.output).and_then(|()| fs::write(&path, text));
        written.map_err(|error| {
            Failure::Files(format!("{}: {error}", printable(&path.display().to_string())))
        })?;
        writeln!(io::stdout(), "wrote {}", printable(&path.display().to_string()))?;
        Ok(())
    }
}
