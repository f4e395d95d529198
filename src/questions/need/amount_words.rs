//! An amount of a sought quantity as text, in the unit of the quantity: "12 N at left and right", "an arm of 0.25 m", "60°". An amount (of squeeze,
//! friction, load, arm, angle or force) is sufficient if the grasp meets the demand with it, e.g. holds the object. The squeeze is everything by
//! which contacts press at rest without a load.

use super::answer::{Needed, PressedBy, Quantity};
use super::press::{self, ContactPress};
use crate::prelude::*;
use crate::words::{Words, listed, printable};

impl Needed {
    /// The format of the bound sought, i.e. the least or greatest sufficient amount. The format rounds to the sufficient side: a least amount up, a
    /// greatest amount down.
    pub(super) fn of_bound(&self, words: Words) -> Words {
        if self.quantity.is_least() { words.upwards() } else { words.downwards() }
    }

    /// The format of the far end, i.e. the end of the interval of sufficient amounts that is not the bound sought. The format rounds to the
    /// sufficient side.
    pub(super) fn of_far_end(&self, words: Words) -> Words {
        if self.quantity.is_least() { words.downwards() } else { words.upwards() }
    }

    /// An interval of amounts as text: "0.1 to 3 times the load". Both ends are rounded inwards.
    pub(super) fn range(&self, words: Words, from: f64, to: f64) -> String {
        let (above, below) = (words.upwards(), words.downwards());
        let [low, high] = [above.number(from), below.number(to)];
        match self.quantity {
            Quantity::Squeeze => format!("{low} to {}", self.times_squeeze(below, to)),
            Quantity::Friction => format!("{low} to {high}"),
            Quantity::Load => format!("{low} to {high} times the load"),
            Quantity::Arm => format!("{} to {}", above.reach(from), below.reach(to)),
            Quantity::Angle => format!("{} to {}", above.angle(from), below.angle(to)),
            Quantity::Force => match self.of.as_ref().and_then(PressedBy::unit_size) {
                Some((size, unit)) => format!(
                    "{} to {} {unit}{}",
                    above.number(size * from),
                    below.number(size * to),
                    self.at()
                ),
                None => format!("{low} to {high} times the load given{}", self.at()),
            },
        }
    }

    /// The interval of sufficient amounts as text, from one end to the other: "an arm of 0.25 m to 10.8 m".
    pub(super) fn between_ends(&self, words: Words, from: f64, to: f64) -> String {
        let range = self.range(words, from, to);
        if self.quantity == Quantity::Arm { format!("an arm of {range}") } else { range }
    }

    /// An amount as text, with the contacts or the body where it acts: "12 N at left and right".
    pub(super) fn amount_text(&self, words: Words, amount: f64, presses: &[ContactPress]) -> String {
        match self.quantity {
            Quantity::Squeeze => press::in_words(words, presses, self.times_squeeze(words, amount)),
            Quantity::Friction if self.contacts.is_empty() => {
                format!("a coefficient of friction of {}", words.number(amount))
            }
            Quantity::Friction => {
                format!("a coefficient of friction of {} at {}", words.number(amount), listed(&self.contacts))
            }
            Quantity::Load => match self.force {
                Some(force) => {
                    format!("{}, {} N,", self.short(words, amount, &[]), words.number(amount * force))
                }
                None => self.short(words, amount, &[]),
            },
            Quantity::Arm => format!("an arm of {}", words.reach(amount)),
            Quantity::Angle | Quantity::Force => format!("{}{}", self.short(words, amount, &[]), self.at()),
        }
    }

    /// An amount as text, without the contacts or the body where it acts, which the sentence has named before: "12 N".
    pub(super) fn short(&self, words: Words, amount: f64, presses: &[ContactPress]) -> String {
        match self.quantity {
            Quantity::Squeeze => press::in_short(words, presses, self.times_squeeze(words, amount)),
            Quantity::Friction => words.number(amount),
            Quantity::Load => format!("{} times the load", words.number(amount)),
            Quantity::Arm => words.reach(amount),
            Quantity::Angle => format!("{}°", words.number(amount.to_degrees())),
            Quantity::Force => match self.of.as_ref().and_then(PressedBy::unit_size) {
                Some((size, unit)) => format!("{} {unit}", words.number(amount * size)),
                None => format!("{} times what is given", words.number(amount)),
            },
        }
    }

    /// A multiple of the squeeze as text: "1.2 times the squeeze given".
    fn times_squeeze(&self, words: Words, amount: f64) -> String {
        let given = if self.by_overlaps { "overlaps" } else { "squeeze" };
        format!("{} times the {given} given", words.number(amount))
    }

    /// The words that follow an amount in a sentence: the part on which the sought force acts, " on jaw", or the sense of an angle in the plane, "
    /// anticlockwise".
    pub(super) fn at(&self) -> String {
        match &self.of {
            None => match self.anticlockwise {
                Some(true) => " anticlockwise".to_owned(),
                Some(false) => " clockwise".to_owned(),
                None => String::new(),
            },
            Some(PressedBy { part: Some(part), is_body: true, .. }) => format!(" on {}", printable(part)),
            Some(PressedBy { part: Some(part), is_command: true, .. }) => {
                format!(" of `pressed_with` at {}", printable(part))
            }
            Some(PressedBy { part: Some(part), .. }) => format!(" at {}", printable(part)),
            Some(_) => " at rest".to_owned(),
        }
    }
}

impl PressedBy {
    pub(super) fn unit_size(&self) -> Option<(f64, &str)> {
        Some((self.size?, self.unit.as_deref()?))
    }
}

/// Rounds the end of a searched interval to one digit, up if `up`, else down, so that the rounded number stays inside the interval.
pub(super) fn roughly(amount: f64, up: bool) -> f64 {
    if amount <= 0.0 {
        return amount;
    }
    let digit = 10.0_f64.powf(amount.log10().floor());
    let digits = amount / digit;
    digit * if up { digits.ceil() } else { digits.floor() }
}
