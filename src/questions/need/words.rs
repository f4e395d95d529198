//! The answer to a [`Need`](super::Need) in words. The first line is the sentence that one would say to a colleague; each further line is one clause
//! about other amounts. An amount (of squeeze, friction, load, arm or angle) is sufficient if the grasp meets the demand with it, e.g. holds the
//! object; the bound is the least or greatest sufficient amount. Easier amounts are larger if the least amount is sought, smaller if the greatest is
//! sought. The far end is the last sufficient amount on the easier side of the bound. A safe amount is sufficient also with less friction and
//! squeeze, or with larger loads. The verdict on an amount says in words whether the object is held and whether contacts slide. A command is a
//! prescribed displacement of a finger or joint. A drive is the spring of a joint or tendon of a hand, with its force limit.

use core::fmt;

use super::amount_words::roughly;
use super::answer::{Amount, AmountWindow, FarEnd, Needed, Quantity, TriedAmounts};
use super::press::{self, ContactPress};
use super::question::Demand;
use crate::hold::{NO_MOMENTUM, taken_by_forces};
use crate::numerics::{mapped, picked};
use crate::prelude::*;
use crate::words::{ALIKE_IN_WORDS, Words, listed, printable};

impl fmt::Display for Needed {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.amount(f)?;
        if self.jumps {
            write!(f, "{LINE}on the way it jumps and is caught; its momentum might carry it farther")?;
        }
        if let Some(part) = self.left_out {
            write!(f, "{LINE}CAUTION, left out: {}", taken_by_forces(part))?;
        }
        if matches!(self.amount, Amount::None { .. }) && !self.without_friction.is_empty() {
            let stay = if self.without_friction.len() == 1 { "stays" } else { "stay" };
            write!(f, "{LINE}{} {stay} without friction", listed(&self.without_friction))?;
        }
        match &self.of {
            _ if !self.in_place_of_squeeze => Ok(()),
            None => write!(
                f,
                "{LINE}nothing presses by command; ask for what presses by its name: `need … force --of NAME`"
            ),
            Some(of) => {
                let place =
                    of.part.as_ref().map_or("at rest".to_owned(), |part| format!("on {}", printable(part)));
                write!(
                    f,
                    "{LINE}nothing presses by command, so that there is no squeeze to seek; the load {place} presses"
                )
            }
        }
    }
}

impl Needed {
    fn amount(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.amount {
            Amount::Bound { .. } => self.bound(f),
            Amount::Any { to, .. } if self.has_no_squeeze() => {
                write!(f, "NEEDS no squeeze: {}", self.aim())?;
                self.safe_amount(f, (*to, &[]), self.before_safe())
            }
            Amount::Any { to, until, tried } => self.any(f, *to, until.as_ref(), *tried),
            Amount::None { otherwise, .. } if self.has_no_squeeze() => {
                write!(f, "NO squeeze does: {otherwise}")
            }
            Amount::None { otherwise, .. } if self.quantity == Quantity::Angle => {
                write!(f, "NO angle does, since it does not hold before it turns: {otherwise}")
            }
            Amount::None { otherwise, best, .. } => {
                self.none(f)?;
                if otherwise.is_empty() {
                    return Ok(());
                }
                let best = self.amount_text(Words::of(f), *best, &[]);
                write!(f, "{LINE}with {}: {otherwise}", best.trim_end_matches(','))
            }
            Amount::Undecided { at, doubt } => {
                let at = self.amount_text(Words::of(f), *at, &[]);
                write!(f, "UNDECIDED at {}: {doubt}", at.trim_end_matches(','))
            }
        }
    }

    /// The demand that the amount meets, as words. For a greatest amount "it holds" is shortened to "holds", because the sentence is "TAKES 5 N and
    /// holds".
    fn aim(&self) -> &'static str {
        match self.demand {
            Demand::Sticks => "nothing slides",
            Demand::Held if self.quantity.is_least() => "it holds",
            Demand::Held => "holds",
            Demand::Rests => "it comes to rest however often the load is put on",
            Demand::Stays => "it does not walk however often the load is put on",
        }
    }

    /// "only " before a greatest load that is less than the load of the question.
    fn only_if_less(&self, sufficient: f64) -> &'static str {
        if self.quantity == Quantity::Load && sufficient < 1.0 { "only " } else { "" }
    }

    /// Writes the bound, the amount with which nothing slides, the safe amount, the verdicts beyond the bound, and the number of amounts tried.
    fn bound(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Amount::Bound {
            sufficient,
            otherwise,
            unknown,
            changes,
            until,
            is_too_far,
            elsewhere,
            presses,
            at_their_limit,
            tried,
            ..
        } = &self.amount
        else {
            return Ok(());
        };
        let (words, is_least, aim) = (Words::of(f), self.quantity.is_least(), self.aim());
        // This condition recognises a single sufficient amount, all others being excluded by proofs: no amounts were tried next to it, and the
        // interval of sufficient amounts begins and ends with it.
        if tried.is_none() && until.as_ref().is_some_and(|end| end.sufficient == *sufficient) {
            return self.only(f, *sufficient, otherwise);
        }
        let beside = match (self.scales_kinetic, self.scales_any_force) {
            (true, _) => " (kinetic friction in proportion)",
            (_, true) => " (the force in any direction in proportion)",
            _ => "",
        };
        let much = self.amount_text(self.of_bound(words), *sufficient, presses) + beside;
        let ends_small_motions = self.ends_small_motions(self.demand, *is_too_far);
        match until {
            Some(end) if ends_small_motions => {
                write!(f, "HOLDS {}", self.in_small_motions(words, end, *sufficient))?;
            }
            None if ends_small_motions => {
                write!(f, "TAKES {much}, up to which motions are small, and holds")?;
            }
            Some(end) if is_least => {
                write!(f, "NEEDS {much}, at most {}, so that {aim}", self.at_most(words, end))?;
            }
            None if is_least => write!(f, "NEEDS {much} so that {aim}")?,
            Some(end) => {
                write!(f, "TAKES {} and {aim}", self.between_ends(words, end.sufficient, *sufficient))?;
            }
            None => write!(f, "TAKES {}{much} and {aim}", self.only_if_less(*sufficient))?,
        }
        if self.jumps {
            write!(f, ", {NO_MOMENTUM}")?;
        }
        self.beside(f, *sufficient, until.as_ref())?;
        self.safe_amount(f, (*sufficient, presses), self.before_safe())?;
        write!(f, "{LINE}with {}: {otherwise}", if is_least { "less" } else { "more" })?;
        if let Some(unknown) = unknown {
            write!(f, "{LINE}with {}: not known", self.short(words, *unknown, &[]))?;
        }
        if let Some(limit) = at_limit(at_their_limit) {
            write!(f, "{LINE}at rest {limit}")?;
        }
        self.far_end(f, until.as_ref())?;
        let mentioned = 1 + usize::from(until.is_some()) + self.windows(f, elsewhere)?;
        if *changes > mentioned {
            write!(f, "{LINE}the verdict changes {changes} times among the amounts that were tried")?;
        }
        self.amounts_tried(f, *tried)
    }

    /// Writes that all amounts tried on the harder side (less squeeze, more load) are sufficient, `to` being the last. `until` is the far end, the
    /// last sufficient amount on the easier side; it is `None` if all amounts tried on that side are sufficient.
    fn any(
        &self,
        f: &mut fmt::Formatter<'_>,
        to: f64,
        until: Option<&FarEnd>,
        tried: Option<TriedAmounts>,
    ) -> fmt::Result {
        let (words, aim) = (Words::of(f), self.aim());
        if self.quantity.is_least() {
            let most = until.map(|end| format!(", at most {}", self.at_most(words, end)));
            let least = self.amount_text(words, roughly(to, true), &[]);
            write!(f, "NEEDS none{}: {aim} down to {least}", most.unwrap_or_default())?;
        } else if let Some(end) = until {
            let [much, to] = [
                self.amount_text(words.upwards(), end.sufficient, &[]),
                self.short(words, roughly(to, false), &[]),
            ];
            write!(f, "TAKES {much} and more: it holds up to {to}")?;
        } else {
            let amount = if self.quantity == Quantity::Angle { to } else { roughly(to, false) };
            let aim = if self.demand == Demand::Held { "it holds" } else { aim };
            write!(
                f,
                "TAKES any: {aim} up to {}",
                self.amount_text(words, amount, &[]).trim_end_matches(',')
            )?;
        }
        self.beside(f, to, until)?;
        self.safe_amount(f, (to, &[]), self.before_safe())?;
        self.far_end(f, until)?;
        self.amounts_tried(f, tried)
    }

    /// Writes that one amount is sufficient, and no other.
    fn only(&self, f: &mut fmt::Formatter<'_>, sufficient: f64, otherwise: &str) -> fmt::Result {
        let much = self.amount_text(Words::of(f), sufficient, &[]);
        write!(f, "ONLY {} does", much.trim_end_matches(','))?;
        if sufficient == 1.0 && self.quantity != Quantity::Friction {
            f.write_str(", as given")?;
        }
        if let Some(Amount::Bound { .. }) = self.sticks {
            f.write_str(", and nothing slides")?;
        }
        write!(f, "{LINE}with more or less: {otherwise}")?;
        self.safe_amount(f, (sufficient, &[]), LINE)
    }

    /// Writes that no amount is sufficient, and either that contact forces are proved not to balance the loads, or the range of amounts tried.
    fn none(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (words, what) = (Words::of(f), self.quantity);
        let Amount::None { from, to, tried, is_proved, at_rest, .. } = &self.amount else {
            return Ok(());
        };
        let range = self.range(words, roughly(*from, true), roughly(*to, false));
        if *at_rest {
            let why = "no forces of the contacts balance the load at rest alone, before the rest is put on";
            write!(f, "NO {what} does: {why}")
        } else if *is_proved {
            write!(f, "NO {what} does, from {range}: no forces of the contacts balance the load with any")
        } else {
            write!(f, "NO {what} that was tried does, of {tried} from {range}")
        }
    }

    /// Whether a squeeze is sought in a grasp in which no command presses.
    fn has_no_squeeze(&self) -> bool {
        self.in_place_of_squeeze && self.quantity == Quantity::Squeeze
    }

    /// Writes the sentences about further intervals of sufficient amounts. Returns how many ends of these intervals are known; at each of them the
    /// verdict changes.
    fn windows(&self, f: &mut fmt::Formatter<'_>, elsewhere: &[AmountWindow]) -> Result<usize, fmt::Error> {
        let (words, mut mentioned) = (Words::of(f), 0);
        for window in elsewhere {
            mentioned += [window.from, window.to].iter().flatten().count();
            let much = |words: Words, amount: f64| self.amount_text(words, amount, &[]);
            let range = match (window.from, window.to) {
                (Some(from), Some(to)) => self.range(words, from, to),
                (Some(one), None) => format!("{} and more", much(words.upwards(), one)),
                (None, one) => format!("{} and less", much(words.downwards(), one.unwrap_or(0.0))),
            };
            write!(f, "{LINE}{range} would do, too")?;
        }
        Ok(mentioned)
    }

    /// Writes the number of amounts tried for the answer, and their range.
    fn amounts_tried(&self, f: &mut fmt::Formatter<'_>, tried: Option<TriedAmounts>) -> fmt::Result {
        let Some(TriedAmounts { count, from, to }) = tried.filter(|tried| tried.count > 1) else {
            return Ok(());
        };
        let range = self.range(Words::of(f), roughly(from, true), roughly(to, false));
        write!(f, "{LINE}tried were {count} amounts from {range}")
    }

    /// Writes the far end of the sufficient amounts: amounts beyond it are too large, or too small.
    fn far_end(&self, f: &mut fmt::Formatter<'_>, end: Option<&FarEnd>) -> fmt::Result {
        let Some(end) = end else { return Ok(()) };
        let more = if self.quantity.is_least() { "more" } else { "less" };
        let much = self.amount_text(self.of_far_end(Words::of(f)), end.sufficient, &end.presses);
        write!(f, "{LINE}with {more} than {}: {}", much.trim_end_matches(','), end.otherwise)?;
        let limit = at_limit(&end.at_their_limit);
        limit.map_or(Ok(()), |limit| write!(f, "{LINE}there, at rest, {limit}"))
    }

    /// Writes the amount with which nothing slides. Before it, the sentence names the amounts with which the object is held: from `sufficient` to
    /// `held_until`.
    fn beside(
        &self,
        f: &mut fmt::Formatter<'_>,
        sufficient: f64,
        held_until: Option<&FarEnd>,
    ) -> fmt::Result {
        let words = Words::of(f);
        let is_least = self.quantity.is_least();
        match &self.sticks {
            None => Ok(()),
            Some(Amount::Bound { sufficient: sticks, until, .. })
                if (sticks - sufficient).abs() <= ALIKE_IN_WORDS * sufficient.abs() =>
            {
                f.write_str(if is_least { " and nothing slides" } else { ", and nothing slides" })?;
                self.sticks_until(f, until.as_ref(), held_until)
            }
            Some(Amount::Bound { sufficient: sticks, presses, until, .. }) => {
                let much = self.interval_text(words, (*sticks, presses), until.as_ref());
                let is_apart = !self.amount.takes(*sticks, is_least);
                let apart = if is_apart { " (not held in between)" } else { "" };
                write!(
                    f,
                    ", {much} {}{apart}",
                    if is_least { "so that nothing slides" } else { "and nothing slides" }
                )
            }
            Some(Amount::Any { until, .. }) => {
                f.write_str(", and nothing slides")?;
                self.sticks_until(f, until.as_ref(), held_until)
            }
            Some(Amount::None { .. }) => {
                f.write_str(", and something slides, opens or gives way with every amount that was tried")
            }
            Some(Amount::Undecided { .. }) => f.write_str("; with how much nothing slides is not known"),
        }
    }

    /// The interval of sufficient amounts from the bound `near` to its other end, or the bound alone, without names of contacts or bodies: "3 N to 5
    /// N".
    fn interval_text(&self, words: Words, near: (f64, &[ContactPress]), until: Option<&FarEnd>) -> String {
        match until {
            None => self.short(self.of_bound(words), near.0, near.1),
            Some(end) if self.quantity.is_least() => {
                let from = self.short(words.upwards(), near.0, near.1);
                format!("{from} to {}", self.short(words.downwards(), end.sufficient, &end.presses))
            }
            Some(end) => self.range(words, end.sufficient, near.0),
        }
    }

    /// The text for the largest sufficient amount, with a remark if it is less than the given amount: "8.3 N, less than is given".
    fn at_most(&self, words: Words, end: &FarEnd) -> String {
        let is_multiple = matches!(self.quantity, Quantity::Squeeze | Quantity::Force);
        let beside = if is_multiple && end.sufficient < 1.0 { ", less than is given" } else { "" };
        self.short(words.downwards(), end.sufficient, &end.presses) + beside
    }

    /// Writes the far end of the amounts with which nothing slides, unless the amounts with which the object is held end before it.
    fn sticks_until(
        &self,
        f: &mut fmt::Formatter<'_>,
        end: Option<&FarEnd>,
        held_until: Option<&FarEnd>,
    ) -> fmt::Result {
        let is_least = self.quantity.is_least();
        let is_beyond = |end: &&FarEnd| {
            let held = held_until.map_or(f64::NAN, |held| held.sufficient);
            // A far end is known only up to a bracket, whose width may be this fraction of the amount.
            let width = 1e-4 * held.abs();
            if is_least { end.sufficient >= held - width } else { end.sufficient <= held + width }
        };
        let Some(end) = end.filter(|end| !is_beyond(end)) else { return Ok(()) };
        let to = if is_least { "up to" } else { "from" };
        write!(f, " {to} {}", self.short(self.of_far_end(Words::of(f)), end.sufficient, &end.presses))
    }

    /// Whether an arm is bounded only by the limit of small motions, so that with a longer arm the object is held, too, but moves too far.
    fn ends_small_motions(&self, demand: Demand, is_too_far: bool) -> bool {
        is_too_far && self.quantity == Quantity::Arm && demand == Demand::Held
    }

    /// The interval from `until` to `sufficient` as text: "from an arm of 0.25 m to 54 m, where motions cease to be small".
    fn in_small_motions(&self, words: Words, until: &FarEnd, sufficient: f64) -> String {
        let [from, to] = [
            self.amount_text(words.upwards(), until.sufficient, &[]),
            self.short(words.rounded_to(2).downwards(), sufficient, &[]),
        ];
        format!("from {from} to {to}, where motions cease to be small")
    }

    /// The text between the amount and the safe amount: a line break, or "; " if the safe amount is for larger loads. A factor of safety on loads is
    /// given by the user, so that the safe amount belongs to the first line.
    fn before_safe(&self) -> &'static str {
        if self.safety == 1.0 { LINE } else { "; " }
    }

    /// Writes the safe amount, which takes into account reduced friction and squeeze or larger loads.
    fn safe_amount(
        &self,
        f: &mut fmt::Formatter<'_>,
        (sufficient, presses): (f64, &[ContactPress]),
        before: &str,
    ) -> fmt::Result {
        let words = Words::of(f);
        let less = [("friction", self.lower[0]), ("the squeeze", self.lower[1])];
        let text = |what: &str, part: f64| format!("{what} is {} % less", words.number(100.0 * part));
        let mut less = picked(&less, &|(what, part)| (*part > 0.0).then(|| text(what, *part)));
        if self.safety != 1.0 {
            let what = if self.is_loaded_at_rest { "the load beyond that at rest" } else { "the load" };
            less.push(format!("{what} is {} times as large", words.number(self.safety)));
        }
        let much = match &self.safe {
            Some(Amount::Bound { sufficient: safe, until: Some(end), is_too_far, .. })
                if self.ends_small_motions(self.demand, *is_too_far) =>
            {
                self.in_small_motions(words, end, *safe)
            }
            Some(Amount::Bound { sufficient: safe, presses: safe_presses, until, .. }) => {
                let much = match (press::alike(presses), press::alike(safe_presses)) {
                    // The amount and the safe amount lead to the same normal forces, because drives at their limit press no harder under a larger
                    // command. The text therefore gives the safe amount as a multiple of the command, not as a normal force.
                    (Some(one), Some(other))
                        if (one - other).abs() <= ALIKE_IN_WORDS * one.abs() && *safe != sufficient =>
                    {
                        format!("{} times that command", self.of_bound(words).number(safe / sufficient))
                    }
                    (None, _) if !presses.is_empty() => {
                        format!("{} times as much", self.of_bound(words).number(safe / sufficient))
                    }
                    _ => self.interval_text(words, (*safe, safe_presses), until.as_ref()),
                };
                // The safe amount is sufficient with lower friction and squeeze or larger loads. With friction, squeeze and loads as given, the same
                // amount may be too large or too small; the text then says so.
                let beside = if self.amount.takes(*safe, self.quantity.is_least()) {
                    ""
                } else {
                    " (which does not do as given)"
                };
                much + beside
            }
            Some(Amount::None { .. }) => "no amount does".to_owned(),
            Some(Amount::Undecided { .. }) => "not known".to_owned(),
            Some(Amount::Any { .. }) | None => return Ok(()),
        };
        write!(f, "{before}if {}: {much}", listed(&less))
    }
}

/// Text at the beginning of each further line of the answer.
const LINE: &str = "\n  ";

/// The clause about drives at their limit, if there are any: "motor is at its limit and presses no harder".
fn at_limit(drives: &[String]) -> Option<String> {
    let names: Vec<_> = mapped(drives, &|name| printable(name));
    let are = match names.len() {
        0 => return None,
        1 => "is at its limit and presses",
        _ => "are at their limit and press",
    };
    Some(format!("{} {are} no harder", listed(&names)))
}

impl Amount {
    /// Whether the number `amount` lies in an interval of sufficient amounts, or outside it by so little ([`ALIKE_IN_WORDS`]) that words show no
    /// difference. `true` if the answer has no bound.
    fn takes(&self, amount: f64, is_least: bool) -> bool {
        let Self::Bound { sufficient, until, elsewhere, .. } = self else { return true };
        let (near, far) = (Some(*sufficient), until.as_ref().map(|end| end.sufficient));
        let own = if is_least {
            AmountWindow { from: near, to: far }
        } else {
            AmountWindow { from: far, to: near }
        };
        let [least, most] = [amount * (1.0 - ALIKE_IN_WORDS), amount * (1.0 + ALIKE_IN_WORDS)];
        let is_in = |window: &AmountWindow| {
            window.from.is_none_or(|from| from <= most) && window.to.is_none_or(|to| least <= to)
        };
        is_in(&own) || elsewhere.iter().any(is_in)
    }
}
