//! Texts and numbers for pictures and pages.

use crate::equilibrium::Equilibrium;
use crate::numerics::IntoList;
use crate::words::Words;

/// A text escaped for HTML or XML, as content and as attributes in quotes.
pub(super) fn escaped(text: &str) -> String {
    text.chars().fold(String::with_capacity(text.len()), |mut out, c| {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            '\'' => out.push_str("&#39;"),
            // XML does not allow these characters; the replacement character U+FFFD takes their place.
            c if (c.is_control() && !c.is_whitespace()) || matches!(c, '\u{fffe}' | '\u{ffff}') => {
                out.push('\u{fffd}');
            }
            c => out.push(c),
        }
        out
    })
}

/// A number with five significant digits, without trailing zeros.
pub(super) fn short(x: f64) -> String {
    let size = x.abs();
    let written = if size == 0.0 {
        "0".to_owned()
    } else if size.is_infinite() {
        "∞".to_owned()
    } else if !(1e-3..1e5).contains(&size) {
        let written = format!("{size:.4e}");
        let (digits, power) = written.split_once('e').unwrap_or((&written, "0"));
        let digits = digits.trim_end_matches('0').trim_end_matches('.');
        format!("{digits}e{}", power.replace('-', "−"))
    } else {
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "from 0 to 7")]
        // Number of digits after the point, so that five digits are significant; 1e4 is the least number with five digits before the point.
        let digits = (1e4 / size).log10().ceil().clamp(0.0, 7.0) as usize;
        let all = format!("{size:.digits$}");
        if digits > 0 { all.trim_end_matches('0').trim_end_matches('.').to_owned() } else { all }
    };
    if x < 0.0 { format!("−{written}") } else { written }
}

/// Breaks a text into lines of at most `letters` letters, between words; only a word longer than a line is broken itself.
pub(super) fn lines(text: &str, letters: usize) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in text.split_whitespace() {
        let mut word: Vec<char> = word.chars().list();
        while word.len() > letters {
            lines.push(word.drain(..letters).collect());
        }
        match lines.last_mut() {
            Some(line) if line.chars().count() + 1 + word.len() <= letters => {
                line.push(' ');
                line.extend(word);
            }
            _ => lines.push(word.into_iter().collect()),
        }
    }
    lines
}

/// The caution about an equilibrium whose motion is not small, i.e. exceeds the limits up to which the linear theory is trusted, or that buckles.
/// `None` for any other equilibrium, or if one of the sentences in `said` contains the caution.
pub(super) fn caution<'w, const C: usize>(
    state: Option<&Equilibrium<C>>,
    mut said: impl Iterator<Item = &'w str>,
) -> Option<String> {
    let (far, words) = (state?.too_far.as_ref()?, Words::default());
    let reason = far.reason(words);
    (!said.any(|sentence| sentence.contains(&reason))).then(|| format!("CAUTION: {}", far.caution(words)))
}

/// A name shortened to at most `letters` letters.
pub(super) fn shortened(name: &str, letters: usize) -> String {
    if name.chars().count() <= letters {
        return name.to_owned();
    }
    let start: String = name.chars().take(letters.saturating_sub(1)).collect();
    format!("{}…", start.trim_end())
}
