//! Texts of pages alone: JSON, vectors, proofs.

use std::fmt::Write;

use crate::numerics::tolerances::SOLVED_ROUNDING;
use crate::numerics::{mapped, tried};
use crate::picture::error::PictureError;
use crate::picture::words::short;
use crate::spatial::Proof;

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

/// A JSON array of numbers.
pub(super) fn json_row(numbers: &[f64]) -> Result<String, PictureError> {
    let numbers = tried(numbers, &|x| json_number(*x))?;
    Ok(format!("[{}]", numbers.join(",")))
}

/// A JSON array.
pub(super) fn json_list<T>(
    items: &[T],
    write: &dyn Fn(&T) -> Result<String, PictureError>,
) -> Result<String, PictureError> {
    Ok(format!("[{}]", tried(items, write)?.join(",")))
}

/// Components in parentheses; those that are rounding beside the largest are zero.
pub(super) fn vector(components: &[f64]) -> String {
    let size = components.iter().fold(0.0, |size: f64, x| size.max(x.abs()));
    let clean = |x: &f64| if x.abs() <= SOLVED_ROUNDING * size { 0.0 } else { *x };
    if let [one] = components {
        return short(*one);
    }
    format!("({})", mapped(components, &|x| short(clean(x))).join(", "))
}

/// The proof that no equilibrium exists, in words.
pub(super) fn proof_in_words(proof: &Proof) -> String {
    match proof {
        Proof::FreeMotion { motion, .. } => {
            format!("the load works on a motion that nothing resists, {}", vector(motion.object.components()))
        }
        Proof::SeparatingMotion { motion, .. } => {
            format!(
                "the load drives a motion that no friction opposes, {}",
                vector(motion.object.components())
            )
        }
        Proof::EveryStateTried { combinations } => {
            format!("all {combinations} combinations of contact states fail")
        }
        Proof::EveryCaseContradicted { cases, .. } => {
            format!("all {cases} cases of contact states and directions of friction contradict themselves")
        }
    }
}
