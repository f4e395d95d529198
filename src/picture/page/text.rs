//! Texts and numbers as a page needs them.

use std::fmt::Write;

use crate::picture::error::PictureError;
use crate::spatial::Proof;

/// Numbers that are written without an exponent.
const PLAIN: std::ops::Range<f64> = 1e-3..1e5;
/// The least number with five digits before the point.
const FIVE_DIGITS: f64 = 1e4;
/// A component up to this part of the largest one is rounding. With 0 a page would show 1e-17 where
/// a zero is meant.
const ROUNDING: f64 = 1e-12;

/// A text as HTML, for content and for attributes in quotes.
pub(super) fn html(text: &str) -> String {
    text.chars().fold(String::with_capacity(text.len()), |mut out, c| {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            '\'' => out.push_str("&#39;"),
            c => out.push(c),
        }
        out
    })
}

/// A text as a JSON string that may stand inside a `script` element: nothing in it looks like a
/// tag.
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

/// A number of JSON that reads back to the same bits.
pub(super) fn json_number(x: f64) -> Result<String, PictureError> {
    if x.is_finite() { Ok(format!("{x:?}")) } else { Err(PictureError(format!("{x} cannot be drawn"))) }
}

/// Numbers of JSON in brackets.
pub(super) fn json_row(numbers: &[f64]) -> Result<String, PictureError> {
    let numbers: Vec<_> = numbers.iter().map(|x| json_number(*x)).collect::<Result<_, _>>()?;
    Ok(format!("[{}]", numbers.join(",")))
}

/// Five digits for a table, without zeros at the end.
pub(super) fn short(x: f64) -> String {
    let size = x.abs();
    let written = if size == 0.0 {
        "0".to_owned()
    } else if size.is_infinite() {
        "∞".to_owned()
    } else if !PLAIN.contains(&size) {
        format!("{size:.4e}").replace('-', "−")
    } else {
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "from 0 to 7")]
        let digits = (FIVE_DIGITS / size).log10().ceil().clamp(0.0, 7.0) as usize;
        let all = format!("{size:.digits$}");
        if digits > 0 { all.trim_end_matches('0').trim_end_matches('.').to_owned() } else { all }
    };
    if x < 0.0 { format!("−{written}") } else { written }
}

/// Components in brackets; what is rounding beside the largest is zero.
pub(super) fn vector(components: &[f64]) -> String {
    let size = components.iter().fold(0.0, |size: f64, x| size.max(x.abs()));
    let clean = |x: &f64| if x.abs() <= ROUNDING * size { 0.0 } else { *x };
    format!("({})", components.iter().map(|x| short(clean(x))).collect::<Vec<_>>().join(", "))
}

/// A text in lines of so many letters; a longer word has a line of its own.
pub(super) fn lines(text: &str, letters: usize) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in text.split_whitespace() {
        match lines.last_mut() {
            Some(line) if line.chars().count() + 1 + word.chars().count() <= letters => {
                line.push(' ');
                line.push_str(word);
            }
            _ => lines.push(word.to_owned()),
        }
    }
    lines
}

/// How it is known that no equilibrium exists.
pub(super) fn proof_in_words<const D: usize>(proof: &Proof<D>) -> String {
    match proof {
        Proof::FreeMotion { motion, .. } => {
            format!(
                "the load works on a motion that nothing resists, {}",
                vector(motion.as_vector().as_slice())
            )
        }
        Proof::SeparatingMotion { motion, .. } => {
            format!(
                "the load drives a motion that no friction opposes, {}",
                vector(motion.as_vector().as_slice())
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
