//! Names given by users, and lists of them.

use alloc::borrow::Cow;
use core::fmt;

use super::tolerances::MOST_NAMES;
use crate::numerics::mapped;
use crate::prelude::*;

/// A user's text, safe to print. Control characters, marks of writing direction and line separators are escaped as in Rust. Thus a name can neither
/// clear a screen nor imitate an answer.
#[must_use]
pub fn printable(text: &str) -> Cow<'_, str> {
    if !text.contains(is_control) {
        return Cow::Borrowed(text);
    }
    let written = |c: char| if is_control(c) { c.escape_default().to_string() } else { c.to_string() };
    Cow::Owned(text.chars().map(written).collect())
}

/// Whether a character is escaped. This is so for control characters, marks of writing direction, line separators, and characters that XML forbids.
fn is_control(c: char) -> bool {
    let directs =
        matches!(c, '\u{61c}' | '\u{200e}' | '\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}');
    c.is_control() || directs || matches!(c, '\u{2028}' | '\u{2029}' | '\u{feff}' | '\u{fffe}' | '\u{ffff}')
}

/// Names in a list: "left, right and thumb"; in a list of more than eight, "a, b, c, d, e, f and 7 more".
pub(crate) fn listed<T: fmt::Display>(names: &[T]) -> String {
    in_a_list(&mapped(names, &ToString::to_string))
}

fn in_a_list(names: &[String]) -> String {
    match names {
        [] => "nothing".to_owned(),
        [one] => one.clone(),
        many if many.len() > MOST_NAMES => format!("{} and {} more", many[..6].join(", "), many.len() - 6),
        [first @ .., last] => format!("{} and {last}", first.join(", ")),
    }
}
