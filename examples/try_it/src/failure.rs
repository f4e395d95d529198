//! Errors of the command that writes the page.

use std::{fmt, io};

/// An error because of which the page is not written.
#[derive(Debug)]
pub(crate) enum Failure {
    /// The toolchain lacks the target WebAssembly; the text is the command that installs it.
    NoTarget(String),
    /// The build failed; cargo has printed the reason.
    NotBuilt,
    /// An error of a file or a program.
    Io(io::Error),
}

impl Failure {
    /// Exit code: 2 if the target must be installed first, else 1.
    pub(crate) fn exit_code(&self) -> u8 {
        if matches!(self, Self::NoTarget(_)) { 2 } else { 1 }
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoTarget(command) => {
                write!(f, "this toolchain has no WebAssembly; install it by: {command}")
            }
            Self::NotBuilt => f.write_str("the module was not built"),
            Self::Io(error) => error.fmt(f),
        }
    }
}

impl From<io::Error> for Failure {
    fn from(error: io::Error) -> Self {
        Self::Io(error)
    }
}
