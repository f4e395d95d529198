//! What is needed in a sentence, as one would say it to a colleague.

use core::fmt;

use super::answer::{Amount, AmountWindow, Needed, Press, Quantity};
use super::question::Demand;
use crate::prelude::*;
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
            Demand::Rests => "it comes to rest however often the load is put on",
            Demand::Stays => "it does not walk however often the load is put on",
        };
        match &self.amount {
            Amount::Bound { does, otherwise, changes, until, elsewhere, presses, at_their_limit, .. } => {
                let mut much = self.quantity.much(words, *does, presses);
                if let Some(force) = self.force {
                    much = format!("{much}, {} N,", words.number(does * force));
                }
                if self.quantity.is_least() {
                    write!(f, "NEEDS {much} so that {aim}")?;
                } else {
                    write!(f, "TAKES {much} and {aim}")?;
                }
                self.safe_amount(f, *does, presses)?;
                write!(f, ". With {} {otherwise}", if self.quantity.is_least() { "less:" } else { "more:" })?;
                if let Some(limit) = at_limit(at_their_limit) {
                    write!(f, ". At rest {limit}")?;
                }
                let mut told = 1;
                if let Some(end) = until {
                    told += 1;
                    let [more, too] =
                        if self.quantity.is_least() { ["More", "much"] } else { ["Less", "little"] };
                    let much = self.quantity.much(words, end.does, &end.presses);
                    write!(f, ". {more} than {much} is too {too}: {}", end.otherwise)?;
                    if let Some(limit) = at_limit(&end.at_their_limit) {
                        write!(f, ". There, at rest, {limit}")?;
                    }
                }
                for window in elsewhere {
                    told += [window.from, window.to].iter().flatten().count();
                    let much = |amount: f64| self.quantity.much(words, amount, &[]);
                    let range = match (window.from, window.to) {
                        (Some(from), Some(to)) => self.quantity.range(words, from, to),
                        (Some(one), None) => format!("{} and more", much(one)),
                        (None, one) => format!("{} and less", much(one.unwrap_or(0.0))),
                    };
                    write!(f, ". Apart from that {range} would do")?;
                }
                if *changes > told {
                    write!(f, ". The verdict changes {changes} times among the amounts that were looked at")?;
                }
                Ok(())
            }
            Amount::Any { to } if self.quantity.is_least() => {
                write!(f, "NEEDS none: {aim} down to {}", self.quantity.much(words, roughly(*to, true), &[]))
            }
            Amount::Any { to } => {
                let to = if self.quantity == Quantity::Angle { *to } else { roughly(*to, false) };
                write!(f, "TAKES any: {aim} up to {}", self.quantity.much(words, to, &[]))
            }
            Amount::None { from, to, best, otherwise } => {
                let range = match self.quantity {
                    Quantity::Angle => self.quantity.range(words, *from, *to),
                    quantity => quantity.range(words, roughly(*from, true), roughly(*to, false)),
                };
                let best = self.quantity.much(words, *best, &[]);
                write!(f, "NO {} does, from {range}. With {best}: {otherwise}", self.quantity)
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
                // What is safe against less may be too much, or too little, for what was given.
                let beside = if self.amount.takes(*safe, self.quantity.is_least()) {
                    ""
                } else {
                    " (which does not do as given)"
                };
                write!(f, ", {much} if {}{beside}", listed(&less))
            }
            Some(Amount::None { .. }) => write!(f, ", and no amount does if {}", listed(&less)),
            Some(Amount::Undecided { .. }) => write!(f, ", and it is not known if {}", listed(&less)),
            Some(Amount::Any { .. }) | None => Ok(()),
        }
    }
}

/// One digit of how far was looked in doublings, within what was.
fn roughly(amount: f64, up: bool) -> f64 {
    if amount <= 0.0 {
        return amount;
    }
    let digit = 10.0_f64.powf(amount.log10().floor());
    let digits = amount / digit;
    digit * if up { digits.ceil() } else { digits.floor() }
}

/// "motor is at its limit and presses no harder".
fn at_limit(drives: &[String]) -> Option<String> {
    let names: Vec<_> = drives.iter().map(|name| printable(name)).collect();
    let are = match names.len() {
        0 => return None,
        1 => "is at its limit and presses",
        _ => "are at their limit and press",
    };
    Some(format!("{} {are} no harder", listed(&names)))
}

impl Amount {
    /// Whether it is known that this amount does, or rounding apart from one that does.
    fn takes(&self, amount: f64, is_least: bool) -> bool {
        let Self::Bound { does, until, elsewhere, .. } = self else { return true };
        let (near, far) = (Some(*does), until.as_ref().map(|end| end.does));
        let own = if is_least {
            AmountWindow { from: near, to: far }
        } else {
            AmountWindow { from: far, to: near }
        };
        let is_in =
            |amount: f64| own.contains(amount) || elsewhere.iter().any(|window| window.contains(amount));
        [amount, amount * (1.0 + ALIKE), amount * (1.0 - ALIKE)].into_iter().any(is_in)
    }
}

/// The force that all contacts press with, if it is one.
fn alike(presses: &[Press]) -> Option<f64> {
    let first = presses.first()?.force;
    presses.iter().all(|press| (press.force - first).abs() <= ALIKE * first.abs()).then_some(first)
}

impl Quantity {
    /// "0.1 to 3 times the load".
    fn range(self, words: Words, from: f64, to: f64) -> String {
        let [low, high] = [from, to].map(|amount| words.number(amount));
        match self {
            Self::Squeeze => format!("{low} to {high} times the squeeze given"),
            Self::Friction => format!("{low} to {high}"),
            Self::Load => format!("{low} to {high} times the load"),
            Self::Arm => format!("{low} m to {high} m"),
            Self::Angle => format!("{} to {}", words.angle(from), words.angle(to)),
        }
    }

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
