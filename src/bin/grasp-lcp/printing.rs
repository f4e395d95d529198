//! Output of the program. A closed output ends it quietly, a full disk with one line; nothing panics.
//!
//! The macros shadow those of the standard library, which panic on such errors.

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

/// A line beside the answers, on standard error; failing to write it is no error.
pub(crate) fn remark(words: fmt::Arguments<'_>) {
    let _ = writeln!(io::stderr(), "{words}");
}
