//! Reads scenes from files, and writes pictures into files.

use std::ffi::OsStr;
use std::fs;
use std::io::{self, Read, Write};
use std::path::{Path, PathBuf};

use grasp_lcp::scene::{FaultKind, Scene, Warning};
use grasp_lcp::words::printable;

use crate::arguments::Output;
use crate::failure::Failure;

/// A scene from a file, or from standard input for `-`.
pub(crate) fn read(path: &Path) -> Result<Scene, Failure> {
    let name = name(path);
    let text = if path == Path::new("-") {
        let mut text = Vec::new();
        let read = io::stdin().read_to_end(&mut text);
        read.map(|_| text).map_err(|error| Failure::Files(format!("{name}: {error}")))?
    } else {
        bytes(path, "a scene, a file in JSON")?
    };
    let scene = Scene::from_json(&text).map_err(|fault| {
        // The user may have passed a mesh or a table of slips in place of the scene. The message then names the command that takes such a file.
        let end = path.extension().map(|end| end.to_ascii_lowercase().to_string_lossy().into_owned());
        Failure::Scene(match end.as_deref().filter(|_| fault.kind == FaultKind::Syntax) {
            Some("stl" | "obj") => format!(
                "{name}: is a mesh, must be a scene: `grasp-lcp new grip {name} --jaws 20x30mm --force 40` writes one"
            ),
            Some("csv" | "tsv") => format!(
                "{name}: is a table, must be a scene: slips in a table are read by `grasp-lcp identify scene.json {name}`"
            ),
            _ => format!("{name}: {fault}"),
        })
    })?;
    if let Some(warning) = scene.far_load_in(&text) {
        eprintln!("warning: {name}: {warning}");
    }
    #[cfg(feature = "mesh")]
    let scene = scene
        .with_files_from(path.parent().unwrap_or(Path::new("")))
        .map_err(|error| refused(path, &error))?;
    Ok(scene)
}

/// The bytes of a file. If `path` is a folder, the error says that the path must be `wanted`.
pub(crate) fn bytes(path: &Path, wanted: &str) -> Result<Vec<u8>, Failure> {
    fs::read(path).map_err(|error| {
        let fault = if path.is_dir() { format!("is a folder, must be {wanted}") } else { error.to_string() };
        Failure::Files(format!("{}: {fault}", name(path)))
    })
}

/// The name of a file in messages.
pub(crate) fn name(path: &Path) -> String {
    if path == Path::new("-") {
        "standard input".to_owned()
    } else {
        printable(&path.display().to_string()).into_owned()
    }
}

/// Prints warnings about a scene and its questions on standard error.
pub(crate) fn warn(path: &Path, scene: &Scene) -> Result<(), Failure> {
    warn_at_once(path, scene, None)?;
    warn_of_stiffness(path, scene)
}

/// Prints the warnings that can be given before any question is answered. `given` is the scene before the command line has replaced its questions.
/// Warnings about the loads of the replaced questions are printed, too.
pub(crate) fn warn_at_once(path: &Path, scene: &Scene, given: Option<&Scene>) -> Result<(), Failure> {
    let mut warnings = scene.warnings_at_once().map_err(|error| refused(path, &error))?;
    let of_loads =
        |warning: &Warning| matches!(warning, Warning::ManyMetres { .. } | Warning::HeavyLoad { .. });
    let before = given.map(|given| given.warnings_at_once().unwrap_or_default());
    if let Some(before) = &before {
        // Where gravity turns, the command line has put a pretension in the place of a given tension.
        let link_of = |warning: &Warning| match warning {
            Warning::PullsOtherwise { link, .. } => Some(*link),
            _ => None,
        };
        warnings.retain(|warning| {
            link_of(warning).is_none() || before.iter().any(|other| link_of(other) == link_of(warning))
        });
    }
    for warning in before.into_iter().flatten().filter(of_loads) {
        if !warnings.contains(&warning) {
            warnings.push(warning);
        }
    }
    tell(path, &warnings);
    Ok(())
}

/// Prints the warnings about stiffnesses that the scene does not give. Each question is answered with several trial values of these stiffnesses, to
/// see whether its answer depends on them.
pub(crate) fn warn_of_stiffness(path: &Path, scene: &Scene) -> Result<(), Failure> {
    tell(path, &scene.stiffness_left_out().map_err(|error| refused(path, &error))?);
    Ok(())
}

fn tell(path: &Path, warnings: &[Warning]) {
    for warning in warnings {
        eprintln!("warning: {}: {warning}", name(path));
    }
}

/// The failure of the program for an error of the library about a scene or a question. Its message begins with the name of the scene's file.
pub(crate) fn refused(path: &Path, error: &grasp_lcp::Error) -> Failure {
    Failure::Scene(format!("{}: {error}", name(path)))
}

/// The folder and the file names of a scene's pictures.
pub(crate) struct Pictures {
    folder: PathBuf,
    /// The beginning of every file name, before the ending that `save` appends.
    stem: String,
}

impl Pictures {
    pub(crate) fn new(output: &Output, scene: &Path) -> Self {
        let stem = |path: &Path| path.file_stem().map(|stem| stem.to_string_lossy().into_owned());
        let is_picture = |end: &OsStr| end == "svg" || end == "html";
        let Output { output: place, name } = output;
        if name.is_none() && !place.is_dir() && place.extension().is_some_and(is_picture) {
            let folder = place.parent().filter(|folder| *folder != Path::new("")).unwrap_or(Path::new("."));
            return Self { folder: folder.to_owned(), stem: stem(place).unwrap_or_default() };
        }
        let of_scene = stem(scene).filter(|stem| stem != "-");
        let stem = name.clone().or(of_scene).unwrap_or_else(|| "scene".to_owned());
        Self { folder: place.clone(), stem }
    }

    pub(crate) fn title(&self) -> String {
        printable(&self.stem.replace('_', " ")).into_owned()
    }

    /// Writes a picture; its file name is the stem followed by `end`.
    pub(crate) fn save(&self, end: &str, text: &str) -> Result<(), Failure> {
        let path = self.folder.join(format!("{}{end}", self.stem));
        let written = fs::create_dir_all(&self.folder).and_then(|()| fs::write(&path, text));
        written.map_err(|error| {
            Failure::Files(format!("{}: {error}", printable(&path.display().to_string())))
        })?;
        writeln!(io::stdout(), "wrote {}", printable(&path.display().to_string()))?;
        Ok(())
    }
}
