//! Numbers, texts and lists as JSON in the script of an HTML page.

use std::fmt::Write;

use crate::numerics::tried;
use crate::picture::error::PictureError;

/// A text as a JSON string that is safe inside a `script` element: nothing in it can be read as a tag.
pub(super) fn json_string(text: &str) -> String {
    let mut out = String::from("\"");
    for c in text.chars() {
        match c {
            '"' => out.push_str("\\\""),
            '\\' => out.push_str("\\\\"),
            '<' | '>' | '&' | '\0'..='\u{1f}' | '\u{2028}' | '\u{2029}' => {
                let _ = write!(out, "\\u{:04x}", u32::from(c));
            }
            c => out.push(c),
        }
    }
    out.push('"');
    out
}

/// A JSON number that reads back to the same bits.
pub(super) fn json_number(x: f64) -> Result<String, PictureError> {
    if x.is_finite() { Ok(format!("{x:?}")) } else { Err(PictureError(format!("{x} cannot be drawn"))) }
}

pub(super) fn json_row(numbers: &[f64]) -> Result<String, PictureError> {
    let numbers = tried(numbers, &|x| json_number(*x))?;
    Ok(format!("[{}]", numbers.join(",")))
}

pub(super) fn json_list<T>(
    items: &[T],
    write: &dyn Fn(&T) -> Result<String, PictureError>,
) -> Result<String, PictureError> {
    Ok(format!("[{}]", tried(items, write)?.join(",")))
}
