//! Reasons why no page was written.

use std::{fmt, io};

/// Reasons why no page was written.
#[derive(Debug)]
pub(crate) enum Failure {
    /// The toolchain cannot compile to WebAssembly; the text is the command that installs the target.
    NoTarget(String),
    /// The module was not built; cargo has printed the reason.
    NotBuilt,
    /// A file or a program failed.
    Io(io::Error),
}

impl Failure {
    /// 2 where a target must be installed first, otherwise 1.
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
