//! The answer to [`Improve`](super::Improve) as a sentence. A design point is one choice of the places (positions on their surfaces) and commanded
//! normal forces of all contacts. At rest means before the loads grow. The reserve is the least margin, N, of a contact force to the boundary of its
//! friction cone.

use core::fmt;

use super::answer::{ActiveConstraintKind, Improved, Placed, SearchEnd};
use super::goal::ImproveGoal;
use crate::grasp::inside;
use crate::hold::LossVerb;
use crate::numerics::tolerances::NEGLIGIBLE;
use crate::numerics::{largest, mapped, numbered};
use crate::prelude::*;
use crate::words::{ALIKE_IN_WORDS, MOST_NAMES, Words, listed};

/// Two contacts nearer to each other than this fraction of the size of the grasp, a length, have no room for two fingers. If the fraction were
/// smaller, fingers that touch would not be mentioned. If it were larger, neighbouring fingers of a hand would be.
const IN_ONE_PLACE: f64 = 1e-3;

impl<const C: usize> fmt::Display for Improved<C> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        inside(self).write(f)
    }
}

impl Improved<3> {
    /// Writes the answer: first slip or reserve, before and after, the changes, and the reason why the search ended.
    fn write(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let words = Words::of(f);
        let is_reserve = self.goal == ImproveGoal::Reserve;
        let Some(after) = self.after else {
            let does =
                if is_reserve { "sticks under the loads" } else { "sticks at rest and resists the loads" };
            return write!(f, "NO GRASP on these surfaces was found that {does}");
        };
        if let Some(far) = &self.too_far {
            let when = if is_reserve {
                "at rest or under these loads"
            } else {
                "at rest, under these loads or before the first slip"
            };
            write!(f, "{} {when}: {}. Otherwise ", LossVerb::from(far), far.reason(words))?;
        }
        let (what, one) = if is_reserve { ("RESERVE of", None) } else { ("FIRST SLIP at", self.force) };
        let unit = if is_reserve || one.is_some() { "N" } else { "times the loads" };
        let much = |value: f64| words.number(value * one.unwrap_or(1.0));
        // If first slip comes before the whole load acts (at a factor `after` below 1), the magnitude of the whole load follows: "8 N of 10 N".
        let of_whole = match one.filter(|_| after < 1.0) {
            Some(whole) => format!(" of {} N", words.number(whole)),
            None => String::new(),
        };
        match self.before {
            _ if after.is_infinite() => write!(f, "NEVER SLIPS, however large the loads are")?,
            Some(before) if after <= before * (1.0 + ALIKE_IN_WORDS) => {
                write!(f, "{what} {} {unit}{of_whole}, and nothing better was found", much(after))?;
            }
            Some(before) => {
                write!(f, "{what} {} {unit}{of_whole} instead of {} {unit}", much(after), much(before))?;
            }
            None if is_reserve => write!(f, "{what} {} {unit} instead of sliding", much(after))?,
            None => write!(f, "{what} {} {unit}{of_whole} instead of sliding at rest", much(after))?,
        }
        let changes = self.changes_text(words);
        if !changes.is_empty() {
            write!(f, ": {changes}")?;
        }
        write!(f, ". {}", self.proof(words))?;
        if !self.at_their_limit.is_empty() {
            let are = if self.at_their_limit.len() == 1 { "is" } else { "are" };
            write!(
                f,
                ". CAUTION: at rest {} {are} at the limit of friction; with any less friction, or with places rounded as here, it slips or is lost before any load",
                listed(&self.at_their_limit)
            )?;
        }
        if let Some([one, other]) = self.in_one_place() {
            write!(f, ". CAUTION: {one} and {other} are in one place; give each a surface of its own")?;
        }
        Ok(())
    }

    /// The first two contacts that the search has placed so near each other that two fingers have no room, if there are any.
    fn in_one_place(&self) -> Option<[String; 2]> {
        let size = largest(&self.contacts, &|placed| (placed.point - self.contacts[0].point).norm());
        for (k, one) in self.contacts.iter().enumerate() {
            let is_near = |other: &&Placed<3>| (one.point - other.point).norm() <= IN_ONE_PLACE * size;
            if let Some(other) =
                self.contacts[k + 1..].iter().find(is_near).filter(|other| one.moved + other.moved > 0.0)
            {
                return Some([one.contact.text().into_owned(), other.contact.text().into_owned()]);
            }
        }
        None
    }

    /// The clause about the changes of places and commanded normal forces: "left moves 3.1 mm along its edge, right 2 mm along its circle; both
    /// `pressed_with` 10 N". Empty if nothing changed.
    fn changes_text(&self, words: Words) -> String {
        let size = largest(&self.contacts, &|placed| placed.point.amax());
        let far = largest(&self.contacts, &|placed| placed.moved);
        let (mut moves, mut pressed): (Vec<&Placed<3>>, Vec<&Placed<3>>) = (Vec::new(), Vec::new());
        for placed in &self.contacts {
            if placed.moved > ALIKE_IN_WORDS * far && placed.moved > NEGLIGIBLE * size {
                moves.push(placed);
            }
            if placed.pressed_with.is_some() {
                pressed.push(placed);
            }
        }
        let mut clauses = Vec::new();
        if moves.len() > MOST_NAMES {
            clauses.push(format!("{} contacts move", moves.len()));
        } else if !moves.is_empty() {
            let one = |k: usize| {
                let (placed, verb) = (moves[k], if k == 0 { "moves " } else { "" });
                let surface = placed.surface.as_deref().unwrap_or("surface");
                format!("{} {verb}{} along its {surface}", placed.contact, words.length(placed.moved))
            };
            clauses.push(listed(&numbered(moves.len(), &one)));
        }
        clauses.extend(self.pressed_text(&pressed, words));
        clauses.join("; ")
    }

    /// The clause about the commands of the contacts in `pressed`: "both `pressed_with` 10 N (at rest 9.6 N)". Its numbers are the value to enter in
    /// the field `pressed_with` of the scene, and the normal force at rest. The two differ if the object gives way. `None` without such contacts, or
    /// for more than [`MOST_NAMES`] contacts whose values differ.
    fn pressed_text(&self, pressed: &[&Placed<3>], words: Words) -> Option<String> {
        let largest = largest(&self.contacts, &|placed| placed.normal_force);
        let values = mapped(pressed, &|placed| placed.press_text(largest, words));
        let names = mapped(pressed, &|placed| placed.contact.text());
        let first = values.first()?;
        if values.iter().all(|value| value == first) {
            let who = match names.len() {
                1 => names[0].to_string(),
                2 if self.contacts.len() == 2 => "both".to_owned(),
                few if few < self.contacts.len() && few <= MOST_NAMES => listed(&names),
                few if few < self.contacts.len() => format!("{few} contacts"),
                _ => "all".to_owned(),
            };
            return Some(format!("{who} `pressed_with` {first}"));
        }
        let each = numbered(pressed.len(), &|k| {
            let field = if k == 0 { "`pressed_with` " } else { "" };
            format!("{} {field}{}", names[k], values[k])
        });
        (pressed.len() <= MOST_NAMES).then(|| listed(&each))
    }

    /// The sentence about the end of the search: which contacts and limits make the design point an optimum, or why the search ended without an
    /// optimum.
    fn proof(&self, words: Words) -> String {
        match self.search {
            SearchEnd::Optimum => {
                let mut slides: Vec<String> = Vec::new();
                let mut bounds: Vec<String> = Vec::new();
                for way in &self.in_the_way {
                    let name = way.contact.text();
                    let comes_first = matches!(
                        way.binds,
                        ActiveConstraintKind::FirstSlip { .. } | ActiveConstraintKind::Reserve { .. }
                    );
                    let list = if comes_first { &mut slides } else { &mut bounds };
                    let one = match way.binds {
                        ActiveConstraintKind::FirstSlip { .. } | ActiveConstraintKind::Reserve { .. } => {
                            name.into_owned()
                        }
                        ActiveConstraintKind::Force { .. } => format!("the greatest force of {name}"),
                        ActiveConstraintKind::Pressed { .. } => format!("the greatest command of {name}"),
                        ActiveConstraintKind::NotPressed { .. } => format!("{name}, which cannot pull"),
                        ActiveConstraintKind::End { .. } => format!("the end of the surface of {name}"),
                        ActiveConstraintKind::Rest { .. } => format!("the friction of {name} at rest"),
                    };
                    if !list.contains(&one) {
                        list.push(one);
                    }
                }
                let first = match (self.goal, slides.len()) {
                    (ImproveGoal::FirstSlip, 1) => "leaves first",
                    (ImproveGoal::FirstSlip, _) => "leave first",
                    (ImproveGoal::Reserve, 1) => "has least",
                    (ImproveGoal::Reserve, _) => "have least",
                };
                let within = match &bounds[..] {
                    [] => String::new(),
                    bounds => format!(", within {}", listed(bounds)),
                };
                format!("Nothing nearby is better to first order, as {} {first}{within}", listed(&slides))
            }
            SearchEnd::Stalled => {
                let residual = self
                    .residual
                    .map_or(String::new(), |r| format!(" (gradients leave {})", words.number(r)));
                format!("No step gains more, without proof that nothing nearby is better{residual}")
            }
            SearchEnd::OutOfSteps => "The search ended when it had made as many steps as it may".to_owned(),
            SearchEnd::Unbalanced => "At other places nothing would balance the loads".to_owned(),
            SearchEnd::NothingSlides => "Nothing slides there".to_owned(),
            SearchEnd::NoStart => "No start sticks at rest and resists the loads".to_owned(),
        }
    }
}

impl Placed<3> {
    /// The value of `pressed_with`, and the normal force at rest where it reads differently: "10 N (at rest 9.6 N)". `largest` is the largest force
    /// of all contacts, N; a force as small as the rounding error of `largest` is written as zero.
    fn press_text(&self, largest: f64, words: Words) -> String {
        let given = words.number(words.beside(self.pressed_with.unwrap_or(0.0), largest));
        let at_rest = words.number(words.beside(self.normal_force, largest));
        if given == at_rest { format!("{given} N") } else { format!("{given} N (at rest {at_rest} N)") }
    }
}
