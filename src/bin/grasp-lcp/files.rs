//! Scenes from files, pictures into files.

use std::fs;
use std::io::{self, Read, Write};
use std::path::Path;

use grasp_lcp::scene::{Scene, Warning};
use grasp_lcp::words::printable;

use crate::arguments::Output;
use crate::failure::Failure;

/// A scene from a file, or from standard input for `-`; warnings about it go to standard error.
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
    let warnings = scene.warnings().map_err(|error| refused(path, &error))?;
    // Of a stiffness that is left out it is told once it is known what is asked.
    for warning in warnings.iter().filter(|warning| !matches!(warning, Warning::StiffnessLeftOut { .. })) {
        warn(path, warning);
    }
    Ok(scene)
}

/// What messages call a scene.
fn name(path: &Path) -> String {
    if path == Path::new("-") {
        "standard input".to_owned()
    } else {
        printable(&path.display().to_string()).into_owned()
    }
}

/// A word of warning about a scene.
pub(crate) fn warn(path: &Path, warning: &Warning) {
    eprintln!("warning: {}: {warning}", name(path));
}

/// A scene that is refused as it is asked.
pub(crate) fn refused(path: &Path, error: &grasp_lcp::Error) -> Failure {
    Failure::Scene(format!("{}: {error}", name(path)))
}

/// Where pictures of a scene go.
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

    /// What pictures call the scene.
    pub(crate) fn title(&self) -> String {
        printable(&self.stem().replace('_', " ")).into_owned()
    }

    /// Writes one, whose name ends like this.
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
