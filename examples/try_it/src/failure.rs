//! Why there is no page.

use std::{fmt, io};

/// Why there is no page.
#[derive(Debug)]
pub(crate) enum Failure {
    /// The toolchain cannot build for a page; the command that helps.
    NoTarget(String),
    /// cargo has said why.
    NotBuilt,
    /// A file or a program.
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
