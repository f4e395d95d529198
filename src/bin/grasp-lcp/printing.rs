//! Output of the program. The program ends silently if standard output is closed, and with a one-line message if the disk is full; it never panics.
//!
//! The macros shadow those of the standard library, which panic on such errors.

use std::io::{self, Write};
use std::{fmt, process};

use crate::failure::Failure;

macro_rules! println {
    ($($words:tt)*) => { $crate::printing::line(format_args!($($words)*)) };
}

macro_rules! eprintln {
    ($($words:tt)*) => { $crate::printing::remark(format_args!($($words)*)) };
}

/// Prints a line of an answer on standard output.
pub(crate) fn line(words: fmt::Arguments<'_>) {
    if let Err(error) = writeln!(io::stdout(), "{words}") {
        let failure = Failure::from(error);
        failure.tell();
        process::exit(failure.code().into());
    }
}

/// Prints a line on standard error, such as a warning, which is no part of an answer. A failure to write this line is ignored.
pub(crate) fn remark(words: fmt::Arguments<'_>) {
    let _ = writeln!(io::stderr(), "{words}");
}
