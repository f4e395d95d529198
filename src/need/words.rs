//! What is needed in a sentence, as one would say it to a colleague.

use std::fmt;

use super::answer::{Amount, Needed, Press, Quantity};
use super::question::Demand;
use crate::words::{TOO_FAR, Words, listed, printable};

/// Forces and amounts this close are called one.
const ALIKE: f64 = 1e-6;
/// More contacts are not told one by one.
const MANY: usize = 9;

impl fmt::Display for Needed {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.amount(f)?;
        if self.beyond_small_motions { write!(f, ". {TOO_FAR}") } else { Ok(()) }
    }
}

impl Needed {
    fn amount(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let words = Words::of(f);
        let aim = match self.demand {
            Demand::Sticks => "nothing slides",
            Demand::Held => "it is not lost",
        };
        match &self.amount {
            Amount::Bound { does, otherwise, changes, presses, at_their_limit, .. } => {
                let much = self.quantity.much(words, *does, presses);
                if self.quantity.is_least() {
                    write!(f, "NEEDS {much} so that {aim}")?;
                } else {
                    write!(f, "TAKES {much} and {aim}")?;
                }
                self.safe_amount(f, *does, presses)?;
                write!(f, ". With {} {otherwise}", if self.quantity.is_least() { "less:" } else { "more:" })?;
                if !at_their_limit.is_empty() {
                    let names: Vec<_> = at_their_limit.iter().map(|name| printable(name)).collect();
                    let are = if names.len() == 1 {
                        "is at its limit and presses"
                    } else {
                        "are at their limit and press"
                    };
                    write!(f, ". At rest {} {are} no harder", listed(&names))?;
                }
                if *changes > 1 {
                    write!(f, ". The verdict changes {changes} times among the amounts that were looked at")?;
                }
                Ok(())
            }
            Amount::Any { to } if self.quantity.is_least() => {
                write!(f, "NEEDS none: down to {} {aim}", self.quantity.much(words, *to, &[]))
            }
            Amount::Any { to } => write!(f, "TAKES any: up to {} {aim}", self.quantity.much(words, *to, &[])),
            Amount::None { to, otherwise } => {
                let way = if self.quantity.is_least() { "up" } else { "down" };
                write!(
                    f,
                    "NO {} does, {way} to {}: {otherwise}",
                    self.quantity,
                    self.quantity.much(words, *to, &[])
                )
            }
            Amount::Undecided { at, doubt } => {
                write!(f, "UNDECIDED at {}: {doubt}", self.quantity.much(words, *at, &[]))
            }
        }
    }

    /// What is safe where friction and squeeze are less than said.
    fn safe_amount(&self, f: &mut fmt::Formatter<'_>, does: f64, presses: &[Press]) -> fmt::Result {
        let words = Words::of(f);
        let less = [("friction", self.lower[0]), ("the squeeze", self.lower[1])];
        let less = less.into_iter().filter(|(_, part)| *part > 0.0);
        let less: Vec<_> =
            less.map(|(what, part)| format!("{what} is {} % less", words.number(100.0 * part))).collect();
        match &self.safe {
            Some(Amount::Bound { does: safe, presses: safe_presses, .. }) => {
                let much = match (alike(presses), alike(safe_presses)) {
                    // Drives at their limit press no harder, however far they are told to go.
                    (Some(one), Some(other)) if (one - other).abs() <= ALIKE * one.abs() && *safe != does => {
                        format!("{} times that command", words.number(safe / does))
                    }
                    (Some(_), Some(force)) => format!("{} N", words.number(force)),
                    _ if presses.is_empty() => self.quantity.much(words, *safe, &[]),
                    _ => format!("{} times as much", words.number(safe / does)),
                };
                // What does need not be all that lies above or below: less may do where more does not.
                let past = if self.quantity.is_least() { does - safe } else { safe - does };
                let beside = if past > ALIKE * does.abs() {
                    " (by itself: not every amount beyond it does)"
                } else {
                    ""
                };
                write!(f, ", {much} if {}{beside}", listed(&less))
            }
            Some(Amount::None { .. }) => write!(f, ", and no amount does if {}", listed(&less)),
            Some(Amount::Undecided { .. }) => write!(f, ", and it is not known if {}", listed(&less)),
            Some(Amount::Any { .. }) | None => Ok(()),
        }
    }
}

/// The force that all contacts press with, if it is one.
fn alike(presses: &[Press]) -> Option<f64> {
    let first = presses.first()?.force;
    presses.iter().all(|press| (press.force - first).abs() <= ALIKE * first.abs()).then_some(first)
}

impl Quantity {
    fn much(self, words: Words, amount: f64, presses: &[Press]) -> String {
        match self {
            Self::Squeeze => {
                let times = format!("{} times the squeeze given", words.number(amount));
                if presses.is_empty() {
                    return times;
                }
                if let Some(force) = alike(presses) {
                    let names: Vec<_> = presses.iter().map(|press| press.part.text()).collect();
                    let at = if names.len() > MANY { "every contact".to_owned() } else { listed(&names) };
                    return format!("{} N at {at}", words.number(force));
                }
                let each = presses
                    .iter()
                    .map(|press| format!("{} N at {}", words.number(press.force), press.part.text()));
                if presses.len() > MANY {
                    times
                } else {
                    format!("{} ({times})", listed(&each.collect::<Vec<_>>()))
                }
            }
            Self::Friction => format!("a coefficient of friction of {}", words.number(amount)),
            Self::Load => format!("{} times the load", words.number(amount)),
            Self::Arm => format!("an arm of {} m", words.number(amount)),
            Self::Angle => format!("{}°", words.number(amount.to_degrees())),
        }
    }
}

impl fmt::Display for Quantity {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Squeeze => "squeeze",
            Self::Friction => "coefficient of friction",
            Self::Load => "multiple of the load",
            Self::Arm => "arm",
            Self::Angle => "angle",
        })
    }
}
