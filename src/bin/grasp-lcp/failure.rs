//! Why the program ends without an answer, and with which exit code.

use std::fmt;
use std::io;

/// What went wrong.
#[derive(Debug)]
pub(crate) enum Failure {
    /// A file could not be read or written, or a picture not drawn.
    Files(String),
    /// The command line asks what the scene does not have.
    Usage(String),
    /// The scene is refused.
    Scene(String),
    /// Nobody reads on.
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

    /// In one line, unless nobody reads at all.
    pub(crate) fn tell(&self) {
        if !matches!(self, Self::Closed) {
            eprintln!("{self}");
        }
    }
}

/// The answers are all there, and one of them is "undecided".
pub(crate) const UNDECIDED: u8 = 4;

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Files(message) | Self::Usage(message) | Self::Scene(message) => f.write_str(message),
            Self::Closed => f.write_str("nobody reads the output"),
        }
    }
}

/// Of standard output: whoever opens another file says which.
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
