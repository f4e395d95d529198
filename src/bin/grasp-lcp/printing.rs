//! What the program prints. Where nobody reads on it ends quietly, where a disk is full in one line; nothing panics.
//!
//! The macros take the names of those in the standard library, which panic: nobody can print past them by mistake.

use std::fmt;
use std::io::{self, Write};
use std::process;

use crate::failure::Failure;

macro_rules! println {
    ($($words:tt)*) => { $crate::printing::line(format_args!($($words)*)) };
}

macro_rules! eprintln {
    ($($words:tt)*) => { $crate::printing::remark(format_args!($($words)*)) };
}

/// A line of an answer.
pub(crate) fn line(words: fmt::Arguments<'_>) {
    if let Err(error) = writeln!(io::stdout(), "{words}") {
        let failure = Failure::from(error);
        failure.tell();
        process::exit(failure.code().into());
    }
}

/// A line beside the answers; nobody need read it.
pub(crate) fn remark(words: fmt::Arguments<'_>) {
    let _ = writeln!(io::stderr(), "{words}");
}
