//! The sentence of a verdict on a load. The load factor is the multiple of the growing load that acts; 1 is the whole load. The base load acts before
//! the load grows. The loss is the loss of equilibrium, or the end of small motions (motions for which the linear theory is trusted). At first slip
//! the first contact ceases to stick, at gross slip every contact that presses slides. A drive is the spring of a joint or tendon of a hand, with its
//! force limit.

use alloc::borrow::Cow;
use core::fmt;

use super::caught_jump::CaughtJump;
use super::verdict::{FirstSlip, Holding, Lost, NoEquilibriumNear, Verdict};
use super::way_out::WayOut;
use crate::equilibrium::TooFar;
use crate::grasp::{Motion, WholeContact, Wrench};
use crate::numerics::tolerances::NEGLIGIBLE;
use crate::numerics::{IntoList, mapped, picked};
use crate::prelude::*;
use crate::words::{LinkKind, MOST_NAMES, Words, listed, open, opens, printable};

/// Appended to the sentence if motions pass the limit of small motions.
const NO_LONGER_SMALL: &str = "; beyond this, results for small motions no longer apply";

/// An object that turns over under this fraction of the load turns over at once: under smaller loads, rounding of the forces at rest decides.
const TURNS_AT_ONCE: f64 = 1e-6;

/// The clause about contact forces that turn with the parts they act on. By turning they add to the resistance of the springs or take from it. `part`
/// is the change as a fraction of this resistance ([`Verdict::left_out`]). If the fraction f is taken away, motions are up to 1/(1 - f) times as
/// large.
pub(crate) fn taken_by_forces(part: f64) -> String {
    let words = Words::with_digits(2);
    let (verb, times, so) = if part > 0.0 {
        ("add", format!("{} % to", words.number(100.0 * part)), String::new())
    } else if part > -1.0 {
        let larger = words.upwards().number(1.0 / (1.0 + part));
        let so = format!(", and motions are up to {larger} times as large");
        ("take", format!("{} % of", words.number(-100.0 * part)), so)
    } else {
        let times = words.number(-part);
        ("take", if times == "1" { "all of".to_owned() } else { format!("{times} times") }, String::new())
    };
    format!("as the forces turn with the parts they act on, they {verb} {times} what resists{so}")
}

/// The caution behind a sentence about the geometric stiffness, which the theory of small motions neglects; empty for `None`.
pub(crate) fn left_out_caution(left_out: Option<f64>) -> String {
    let Some(part) = left_out else { return String::new() };
    let nothing_stays = if part <= -1.0 { ", so that nothing stays" } else { "" };
    format!(". CAUTION, left out: {}{nothing_stays}", taken_by_forces(part))
}

/// Writes the sentence about an object that swings until it hangs.
fn write_swing<const C: usize>(f: &mut fmt::Formatter<'_>, swing: &Motion<C>) -> fmt::Result {
    let words = Words::of(f);
    let ways = match &swing.bodies[..] {
        [] => format!("it {}", words.motion(&swing.object, &[])),
        bodies => listed(&mapped(bodies, &|body| words.body_motion(body))),
    };
    write!(
        f,
        "SWINGS until the load hangs: {ways}; nothing resists this, and the forces there are not computed"
    )
}

impl<const C: usize> fmt::Display for Verdict<C> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (words, digits) = (Words::of(f), Words::of(f).precision());
        if let Some(swing) = &self.swing {
            return write_swing(f, swing);
        }
        if self.leaves_buckling_open() {
            write!(
                f,
                "BUCKLES unless the load acts where it steadies the object, which is not known without its point of action: {}. Otherwise ",
                taken_by_forces(self.left_out.unwrap_or_default())
            )?;
        }
        match &self.holding {
            Holding::Sticks => {
                f.write_str("HOLDS, everything sticks")?;
                match (self.has_no_load(), self.base == Wrench::ZERO) {
                    (true, true) => f.write_str(", with no load put on"),
                    (true, false) => f.write_str(", under the load at rest alone"),
                    (false, _) => self.margins(f),
                }?;
                self.cables(f)
            }
            Holding::Slides { contacts } => {
                f.write_str("HOLDS")?;
                match &self.first_slip {
                    Some(first) if first.factor <= NEGLIGIBLE => write!(f, ", but {first} from the start")?,
                    Some(first) if first.factor <= 1.0 => {
                        write!(f, ", but {first} from {} of it on", words.number(first.factor))?;
                    }
                    _ if contacts.is_empty() => {}
                    // No contact ceases to stick up to the whole load, but contacts have closed and slid.
                    _ => write!(f, ", but {}", subject_and_verb(contacts, "slides", "slide"))?,
                }
                self.catches(f)?;
                let all = self.everything_slides.filter(|all| *all <= 1.0 && self.continues_beyond(*all));
                if let Some(all) = all.filter(|_| !self.has_no_load()) {
                    let amount = amount_of(self.load.measure(), all, words);
                    write!(f, "; everything slides from {amount} on")?;
                }
                match &self.lost {
                    _ if self.has_no_load() => Ok(()),
                    Some(lost) => write!(
                        f,
                        "; {} at {}",
                        lost.until().trim_start_matches("it is "),
                        self.times(lost.factor, " this load", words)
                    ),
                    None if all.is_some() => {
                        let most = amount_of(self.load.measure(), self.held_to.max(1.0), words);
                        write!(f, "; wedged, it holds up to {most}")
                    }
                    None if self.held_to > 1.0 => {
                        write!(f, "; held at least up to {}", self.times(self.held_to, " this load", words))
                    }
                    None => Ok(()),
                }?;
                self.cables(f)
            }
            Holding::TurnsOver { motion } => {
                let motion = words.direction_of(motion);
                let from = self.lost.as_ref().map(|lost| lost.factor).filter(|from| *from > TURNS_AT_ONCE);
                let at = from.map_or_else(String::new, |from| format!(" at {}", self.part(from, words)));
                write!(
                    f,
                    "TURNS OVER{at}: every contact holds, but nothing resists {motion}, and the load drives this on unless round surfaces roll there"
                )
            }
            Holding::Loose => {
                f.write_str("DOES NOT HOLD: no contact presses, the object lies loose between the fingers")
            }
            Holding::Lost => self.write_loss(f),
            Holding::NoRest { none, at_rest: Some(lost) } => {
                f.write_str("DOES NOT HOLD even at rest: ")?;
                lost.write_at_rest(f)?;
                write!(f, "; proved, since {none:.digits$}")
            }
            Holding::NoRest { none, at_rest: None } => {
                write!(f, "DOES NOT HOLD even at rest: {none:.digits$}")
            }
            Holding::LostAtRest { at_rest: lost } => {
                f.write_str("DOES NOT HOLD even at rest, before any load: ")?;
                lost.write_at_rest(f)
            }
            Holding::Undecided { doubt } => {
                write!(f, "UNDECIDED beyond {}: {doubt}", self.part(self.held_to, words))
            }
        }?;
        self.write_caution(f)
    }
}

impl<const C: usize> Verdict<C> {
    /// Whether the grasp seems to buckle: the contact forces take away all resistance of the springs. Buckling remains undecided, because the point
    /// of action of the load is unknown: the load steadies the object at some points of action.
    pub(super) fn leaves_buckling_open(&self) -> bool {
        let is_held = matches!(self.holding, Holding::Sticks | Holding::Slides { .. });
        is_held && self.left_out.is_some_and(|part| part <= -1.0)
    }

    /// Writes the caution about the geometric stiffness (the change of contact forces as the parts turn), which the theory of small motions neglects.
    /// Writes nothing if [`Verdict::left_out`] is `None`, or if another sentence says that buckling remains open ([`Self::leaves_buckling_open`]).
    fn write_caution(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&left_out_caution(self.left_out.filter(|_| !self.leaves_buckling_open())))
    }

    /// The sentence about a lost load: the verb, the load at the loss, the jumps before the loss, and the motion of the object.
    fn write_loss(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (words, digits) = (Words::of(f), Words::of(f).precision());
        let Some(lost) = &self.lost else { return f.write_str("LOST") };
        if let Some(far) = &lost.too_far {
            return self.write_small_motion_limit(lost, far, f);
        }
        if lost.factor <= NEGLIGIBLE {
            let whole = self.whole(words);
            return write!(f, "{} at once, under any part of {whole}: {lost:.digits$}", lost.verb(words));
        }
        write!(f, "{} at {}", lost.verb(words), self.part(lost.factor, words))?;
        if lost.falls_at_once {
            f.write_str(", falls at the first slip")?;
        }
        self.catches(f)?;
        if let Some(then) = lost.then_takes {
            write!(f, ", after which it takes {}", amount_of(self.load.measure(), then, words))?;
        }
        write!(f, ": {lost:.digits$}")
    }

    /// The sentence about motions that cease to be small. If the loss counts as gross slip, the sentence begins with the load from which all contacts
    /// slide. Then it names the motion that exceeds its limit. If the reason is no motion, such as buckling, the sentence says only this reason.
    fn write_small_motion_limit(
        &self,
        lost: &Lost<C>,
        far: &TooFar,
        f: &mut fmt::Formatter<'_>,
    ) -> fmt::Result {
        let (words, digits) = (Words::of(f), Words::of(f).precision());
        let amount = |factor: f64| amount_of(self.load.measure(), factor, words);
        let is_at_rest = lost.factor <= NEGLIGIBLE;
        let at = if is_at_rest { "rest already".to_owned() } else { self.part(lost.factor, words) };
        if !far.is_motion() {
            return write!(f, "{} at {at}: {}", lost.verb(words), far.reason(words));
        }
        if is_at_rest {
            return write!(f, "GOES TOO FAR at {at}: {far:.digits$}{NO_LONGER_SMALL}");
        }
        match self.everything_slides {
            Some(all) if lost.is_gross_slip => {
                let (part, from) = (self.part(all, words), amount(lost.factor));
                write!(f, "SLIPS OUT at {part}: everything slides, {far:.digits$} from {from} on")
            }
            all => {
                write!(f, "GOES TOO FAR at {at}: ")?;
                if let Some(all) = all {
                    write!(f, "everything slides from {} on, and then ", amount(all))?;
                }
                write!(f, "{far:.digits$}{NO_LONGER_SMALL}")
            }
        }
    }

    /// Whether the load is held to a larger factor than this one, and first slip, if it occurs, comes at a smaller factor.
    fn continues_beyond(&self, factor: f64) -> bool {
        self.held_to > factor * (1.0 + NEGLIGIBLE)
            && self.first_slip.as_ref().is_none_or(|first| factor > first.factor * (1.0 + NEGLIGIBLE))
    }

    /// Writes the multiples of the load at first slip and at the loss. If there is no loss, writes the multiple up to which the path was followed.
    fn margins(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (words, lost) = (Words::of(f), self.lost.as_ref().map(|lost| lost.factor));
        let until = self.lost.as_ref().map_or(Cow::Borrowed(""), Lost::until);
        let times = |factor: f64, of: &str| self.times(factor, of, words);
        match (&self.first_slip, lost) {
            (Some(first), Some(lost)) if lost <= first.factor * (1.0 + NEGLIGIBLE) => {
                write!(f, ": {} until {until}, as {first}", times(lost, " this load"))
            }
            (Some(first), lost) => {
                write!(
                    f,
                    ": {} until the first slip ({})",
                    times(first.factor, " this load"),
                    first.leaving_parts()
                )?;
                match lost {
                    Some(lost) => write!(f, ", {} until {until}", times(lost, "")),
                    None if self.held_to > first.factor => {
                        write!(f, ", held at least up to {}", times(self.held_to, ""))
                    }
                    None => Ok(()),
                }
            }
            (None, Some(lost)) => write!(f, ": {} until {until}", times(lost, " this load")),
            (None, None) => write!(f, " at least up to {}", times(self.held_to, " this load")),
        }
    }

    /// Writes the pull of each strap or rope under the whole load: "; strap pulls with 2668 N". Writes nothing if there are more than eight straps
    /// and ropes ([`MOST_NAMES`]).
    fn cables(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (Some(state), words) = (&self.state, Words::of(f)) else { return Ok(()) };
        let cables =
            picked(&state.contacts, &|one| (one.contact.link == Some(LinkKind::Cable)).then_some(one));
        cables.iter().filter(|_| cables.len() <= MOST_NAMES).try_for_each(|cable| {
            let (name, pull) = (cable.contact.text(), words.beside(cable.force[0], state.largest_force()));
            write!(f, "; {name} {}", LinkKind::Cable.carries(words, pull, pull, None))
        })
    }

    /// Writes the clause about jumps in which the object slips and is caught; writes nothing if there are no jumps.
    fn catches(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        CaughtJump::write_clause(
            &self.caught,
            self.load.measure(),
            matches!(self.holding, Holding::Slides { .. }),
            f,
        )
    }

    fn has_no_load(&self) -> bool {
        self.load == Wrench::ZERO
    }

    /// A multiple of the load, such as "8 N (1.6 times this load)". The magnitude in N or N m is written only if the load is a single force or
    /// moment.
    fn times(&self, factor: f64, of: &str, words: Words) -> String {
        let words = words.downwards();
        let times = format!("{} times{of}", words.number(factor));
        match self.load.measure() {
            Some((size, unit)) => format!("{} {unit} ({times})", words.number(size * factor)),
            None => times,
        }
    }

    /// The magnitude of the whole load: "950 N", or "the load" if no single number describes it.
    fn whole(&self, words: Words) -> String {
        let size = self.load.measure().map(|(size, unit)| format!("{} {unit}", words.number(size)));
        let beside = if self.base == Wrench::ZERO { "" } else { " beside the load at rest" };
        format!("{}{beside}", size.as_deref().unwrap_or("the load"))
    }

    /// A fraction of the whole load: "8 N of 10 N" if it is a force, in N m if it is a moment, else "0.8 of it".
    fn part(&self, factor: f64, words: Words) -> String {
        match self.load.measure() {
            Some(_) => format!("{} of {}", amount_of(self.load.measure(), factor, words), self.whole(words)),
            None => amount_of(None, factor, words),
        }
    }
}

/// The load factor times the magnitude of a load, with its unit: "7.5 N", or "0.5 of it" for a load that no single number describes.
pub(super) fn amount_of(size: Option<(f64, &str)>, factor: f64, words: Words) -> String {
    let words = words.downwards();
    match size {
        Some((size, unit)) => format!("{} {unit}", words.number(size * factor)),
        None => format!("{} of it", words.number(factor)),
    }
}

impl FirstSlip {
    /// The contacts, joints and tendons that cease to stick or give way: "left", "thumb opens". Contacts that slide are named without a verb.
    fn leaving_parts(&self) -> String {
        let mut names = mapped(&self.slide, &|part| part.text().into_owned());
        names.extend(mapped(&self.open, &|part| format!("{} {}", part.text(), opens(part.link))));
        names.extend(mapped(&self.would_pull, &|part| format!("{} would have to pull", part.text())));
        names.extend(mapped(&self.give_way, &|name| format!("{} gives way", printable(name))));
        listed(&names)
    }
}

/// Writes the contacts and drives of first slip with their verbs: "left and right slide, thumb opens".
impl fmt::Display for FirstSlip {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let give_way: Vec<_> = mapped(&self.give_way, &|name| printable(name));
        let gives = if give_way.len() == 1 { "gives way" } else { "give way" };
        let mut all = Vec::new();
        if !self.slide.is_empty() {
            all.push(subject_and_verb(&self.slide, "slides", "slide"));
        }
        if !self.open.is_empty() {
            all.push(they_open(&self.open));
        }
        if !self.would_pull.is_empty() {
            all.push(subject_and_verb(&self.would_pull, "would have to pull", "would have to pull"));
        }
        if !give_way.is_empty() {
            all.push(format!("{} {gives}", listed(&give_way)));
        }
        f.write_str(&all.join(", "))
    }
}

impl<const C: usize> Lost<C> {
    /// Writes how the base load (the load at rest) is lost as it grows from zero, and which fraction of it is carried.
    fn write_at_rest(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (words, digits) = (Words::of(f), Words::of(f).precision());
        if self.factor > NEGLIGIBLE {
            // A fraction that is rounded to 1 is not written as a number.
            let factor = match words.number(self.factor) {
                one if one == "1" => "not quite all".to_owned(),
                part => format!("only {part}"),
            };
            write!(f, "{factor} of the load at rest is carried, then ")?;
        }
        write!(f, "{self:.digits$}")
    }

    /// The end of the range of load factors held: "it is lost", or at the end of small motions without gross slip "it turns by more than 5.7°".
    fn until(&self) -> Cow<'static, str> {
        match &self.too_far {
            Some(far) if !self.is_gross_slip => far.to_string().into(),
            _ => "it is lost".into(),
        }
    }
}

/// Writes the motion with which the object leaves, the contacts that slide, and whether the loss is gross slip.
impl<const C: usize> fmt::Display for Lost<C> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let digits = Words::of(f).precision();
        write!(f, "{:.digits$}", self.way_out)?;
        if self.takes_the_hand_along() {
            f.write_str(", the hand with it")?;
        }
        if !self.slide.is_empty() {
            let apart = if matches!(self.way_out, WayOut::Apart { .. }) { ";" } else { "," };
            write!(f, "{apart} {}", subject_and_verb(&self.slide, "slides", "slide"))?;
        }
        if self.is_gross_slip {
            f.write_str(" (gross slip)")?;
        }
        Ok(())
    }
}

/// Writes the proof: "no equilibrium under the whole load within 12 mm and 22.9° of this position", the object's position at the loss.
impl fmt::Display for NoEquilibriumNear {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("no equilibrium under the whole load")?;
        // Beyond a kilometre or half a turn the proof covers every motion of the model, which describes small motions alone.
        if self.translation > 1e3 || self.rotation >= core::f64::consts::PI {
            return f.write_str(", as far as motions are small");
        }
        let words = Words::of(f);
        let (length, angle) = (words.length(self.translation), words.angle(self.rotation));
        write!(f, " within {length} and {angle} of this position")
    }
}

/// Names of contacts and links with the verb for opening: "left opens", "left and right open, rope goes slack".
pub(crate) fn they_open(parts: &[WholeContact]) -> String {
    let (ropes, contacts): (Vec<_>, Vec<_>) = parts.iter().cloned().partition(|part| part.link.is_some());
    let clauses = [contacts, ropes].into_iter().filter_map(|list| {
        let link = list.first()?.link;
        Some(subject_and_verb(&list, opens(link), open(link)))
    });
    clauses.list().join(", ")
}

/// Names with a verb in singular or plural: "left slides", "left and right slide".
pub(crate) fn subject_and_verb(parts: &[WholeContact], one: &str, many: &str) -> String {
    format!("{} {}", listed(parts), if parts.len() == 1 { one } else { many })
}
