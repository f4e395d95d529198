//! Names that users give, and lists of them.

use alloc::borrow::Cow;
use core::fmt;

use crate::prelude::*;

/// A text of somebody else as it may be printed: control characters, and those that turn the direction of writing or break lines, are written
/// as Rust writes them. A name cannot clear a screen, or pass for an answer.
#[must_use]
pub fn printable(text: &str) -> Cow<'_, str> {
    if !text.contains(is_control) {
        return Cow::Borrowed(text);
    }
    let written = |c: char| if is_control(c) { c.escape_default().to_string() } else { c.to_string() };
    Cow::Owned(text.chars().map(written).collect())
}

/// Control characters, marks of direction, separators of lines, and what XML has no place for.
fn is_control(c: char) -> bool {
    let directs =
        matches!(c, '\u{61c}' | '\u{200e}' | '\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}');
    c.is_control() || directs || matches!(c, '\u{2028}' | '\u{2029}' | '\u{feff}' | '\u{fffe}' | '\u{ffff}')
}

/// So many names are read; of more, the first ones and how many there are besides.
const MOST_NAMES: usize = 8;
const FIRST_NAMES: usize = 6;

/// Names in a row: "left, right and thumb"; of many, "a, b, c, d, e, f and 7 more".
pub(crate) fn listed<T: fmt::Display>(names: &[T]) -> String {
    match names {
        [] => "nothing".to_owned(),
        [one] => one.to_string(),
        many if many.len() > MOST_NAMES => {
            let first: Vec<_> = many[..FIRST_NAMES].iter().map(ToString::to_string).collect();
            format!("{} and {} more", first.join(", "), many.len() - FIRST_NAMES)
        }
        [first @ .., last] => {
            let first: Vec<_> = first.iter().map(ToString::to_string).collect();
            format!("{} and {last}", first.join(", "))
        }
    }
}
