//! Failures of the program, and their exit codes.

use std::{fmt, io};

/// The reason why the program fails.
#[derive(Debug)]
pub(crate) enum Failure {
    /// A file could not be read or written, or a picture not drawn.
    Files(String),
    /// The command line is wrong, or asks for something that the scene does not have.
    Usage(String),
    /// The library refuses the scene, for the reason given.
    Scene(String),
    /// Standard output is closed, since its reader has ended.
    Closed,
}

impl Failure {
    pub(crate) fn code(&self) -> u8 {
        match self {
            Self::Closed => 0,
            Self::Files(_) => 1,
            Self::Usage(_) => 2,
            Self::Scene(_) => 3,
        }
    }

    /// Prints the reason in one line; nothing if standard output was closed.
    pub(crate) fn tell(&self) {
        if !matches!(self, Self::Closed) {
            eprintln!("{self}");
        }
    }
}

/// Exit code if all questions are answered, but at least one answer is undecided, i.e. the search ended with neither a result nor a proof.
pub(crate) const EXIT_UNDECIDED: u8 = 4;

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Files(message) | Self::Usage(message) | Self::Scene(message) => f.write_str(message),
            Self::Closed => f.write_str("nobody reads the output"),
        }
    }
}

/// The failure for an error of standard output. Errors of files are converted elsewhere, where the file's name is known.
impl From<io::Error> for Failure {
    fn from(error: io::Error) -> Self {
        if error.kind() == io::ErrorKind::BrokenPipe {
            Self::Closed
        } else {
            Self::Files(format!("standard output: {error}"))
        }
    }
}

impl From<grasp_lcp::Error> for Failure {
    fn from(error: grasp_lcp::Error) -> Self {
        Self::Scene(error.to_string())
    }
}

impl From<grasp_lcp::picture::PictureError> for Failure {
    fn from(error: grasp_lcp::picture::PictureError) -> Self {
        Self::Files(error.to_string())
    }
}
