//! Names given by users, and lists of them.

use alloc::borrow::Cow;
use core::fmt;

use crate::numerics::mapped;
use crate::prelude::*;

/// A user's text in a form that is safe to print. Control characters, marks of writing direction and line separators are escaped as in Rust, so that
/// a name can neither clear a screen nor look like an answer.
#[must_use]
pub fn printable(text: &str) -> Cow<'_, str> {
    if !text.contains(is_control) {
        return Cow::Borrowed(text);
    }
    let written = |c: char| if is_control(c) { c.escape_default().to_string() } else { c.to_string() };
    Cow::Owned(text.chars().map(written).collect())
}

/// Control characters, marks of writing direction, line separators, and characters that XML forbids.
fn is_control(c: char) -> bool {
    let directs =
        matches!(c, '\u{61c}' | '\u{200e}' | '\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}');
    c.is_control() || directs || matches!(c, '\u{2028}' | '\u{2029}' | '\u{feff}' | '\u{fffe}' | '\u{ffff}')
}

/// Longest list that is written in full; of a longer one, the first names and the number of the others are written.
const MOST_NAMES: usize = 8;
const FIRST_NAMES: usize = 6;

/// Names in a list: "left, right and thumb"; of a long one, "a, b, c, d, e, f and 7 more".
pub(crate) fn listed<T: fmt::Display>(names: &[T]) -> String {
    match names {
        [] => "nothing".to_owned(),
        [one] => one.to_string(),
        many if many.len() > MOST_NAMES => {
            let first: Vec<_> = mapped(&many[..FIRST_NAMES], &ToString::to_string);
            format!("{} and {} more", first.join(", "), many.len() - FIRST_NAMES)
        }
        [first @ .., last] => {
            let first: Vec<_> = mapped(first, &ToString::to_string);
            format!("{} and {last}", first.join(", "))
        }
    }
}
