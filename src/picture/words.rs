//! Texts and numbers as pictures and pages need them.

/// Numbers that are written without an exponent.
const PLAIN: std::ops::Range<f64> = 1e-3..1e5;
/// The least number with five digits before the point.
const FIVE_DIGITS: f64 = 1e4;

/// A text as HTML or XML, for content and for attributes in quotes.
pub(super) fn escaped(text: &str) -> String {
    text.chars().fold(String::with_capacity(text.len()), |mut out, c| {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            '\'' => out.push_str("&#39;"),
            // XML has no place for these.
            c if (c.is_control() && !c.is_whitespace()) || matches!(c, '\u{fffe}' | '\u{ffff}') => {
                out.push('\u{fffd}');
            }
            c => out.push(c),
        }
        out
    })
}

/// Five digits, without zeros at the end.
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
