//! The verdict about a repeated load as a sentence. In a walk the object moves on by the same motion in every period.

use core::fmt;

use super::shakedown::{BindingContact, Shakedown};
use super::tolerances::CONSTANT_FORCES;
use super::verdict::{Repeats, Shaken};
use crate::equilibrium::{AIR_FLOWS_IN, TooFar};
use crate::grasp::{BodyMotion, PartLabel, WholeContact};
use crate::hold::{LossVerb, NO_MOMENTUM, left_out_caution, subject_and_verb, they_open};
use crate::numerics::tolerances::NEGLIGIBLE;
use crate::numerics::{IntoList, mapped};
use crate::prelude::*;
use crate::words::{Words, listed};

/// The caution added to sentences about a walk or about sliding to and fro, because load paths neglect the inertia of the object.
const SLOWLY: &str = "Good for slow shaking: inertia acts only as far as the loads contain it";

impl<const C: usize> fmt::Display for Shaken<C> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if !self.leaks.is_empty() {
            let cups = listed(&self.leaks);
            write!(f, "LEAKS: {AIR_FLOWS_IN}, at {cups}; with the vacuum kept, ")?;
        }
        let at_the_loss =
            || if let Repeats::Lost { lost, .. } = &self.repeats { lost.state.as_ref() } else { None };
        let state = self.state.as_ref().or_else(at_the_loss);
        // If the sentence begins with the cups that leak, the leak is not repeated in the caution about motions beyond the linear theory.
        let is_new = |far: &&TooFar| !matches!(far, TooFar::Leaks { .. });
        let far = state.and_then(|state| state.too_far.as_ref()).filter(is_new);
        if let Some(far) = far.or(self.too_far.as_ref().filter(is_new)) {
            write!(f, "{}: {}. Otherwise ", LossVerb::from(far), far.reason(Words::of(f)))?;
        }
        self.write_verdict(f)?;
        let is_told = match &self.repeats {
            Repeats::Alternates { slides, .. } => {
                slides.is_empty() && self.slides_and_yields(slides).is_empty()
            }
            repeats => matches!(repeats, Repeats::Lost { .. } | Repeats::NoRest { .. }),
        };
        if self.jumps && !is_told {
            write!(f, "; on the way it jumps and is caught, {NO_MOMENTUM}")?;
        }
        if matches!(self.repeats, Repeats::Walks { .. } | Repeats::Alternates { .. }) {
            write!(f, ". {SLOWLY}")?;
        }
        f.write_str(&left_out_caution(self.left_out))
    }
}

impl<const C: usize> Shaken<C> {
    fn write_verdict(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (words, digits) = (Words::of(f), Words::of(f).precision());
        match &self.repeats {
            Repeats::Rests { after: 0, .. } => {
                let yields = self.slides_and_yields(&[]);
                let (what, but) = if yields.is_empty() { ("nothing", "") } else { ("no contact", ", but ") };
                write!(f, "RESTS: {what} slides as the load repeats{but}{yields}")?;
                self.write_opens(f)
            }
            Repeats::Rests { after, slid } => {
                write!(f, "RESTS after {}", cycles(*after))?;
                let slides = self.slides_and_yields(slid);
                if slides.is_empty() { Ok(()) } else { write!(f, ": until then {slides}") }?;
                self.write_moved(f, words)?;
                self.write_opens(f)
            }
            Repeats::DiesOut { slid } => {
                let (mut slides, ratio) = (self.slides_and_yields(slid), words.number(self.ratio));
                if slides.is_empty() {
                    slides.push_str("it moves");
                }
                write!(f, "COMES TO REST: {slides} less and less, {ratio} of it left from cycle to cycle")?;
                self.write_moved(f, words)?;
                self.write_opens(f)
            }
            Repeats::Alternates { slides, way, dissipated, jumps } => {
                let what = self.slides_and_yields(slides);
                match (slides.is_empty(), what.is_empty()) {
                    // The sentence gives no energy: impacts dissipate an energy that depends on the inertia of the object, which is not known.
                    (_, true) => write!(
                        f,
                        "JUMPS TO AND FRO: {} in {} a contact stops it, and nothing slides",
                        times(*jumps),
                        self.in_every()
                    )?,
                    (true, _) => write!(f, "MOVES TO AND FRO: {what} in {}", self.in_every())?,
                    (false, _) => {
                        let way = words.length(*way);
                        write!(f, "SLIDES TO AND FRO: {what} by up to {way} in {}", self.in_every())?;
                    }
                }
                if !what.is_empty() {
                    write!(f, ", which takes {} J", words.number(*dissipated))?;
                }
                f.write_str("; the object stays")?;
                self.write_opens(f)
            }
            Repeats::Walks { by, slides, .. } => {
                let slide = self.slides_and_yields(slides);
                let moved = moves(words, by);
                if self.change <= CONSTANT_FORCES {
                    write!(f, "WALKS: {moved} in {}", self.in_every())?;
                } else {
                    write!(
                        f,
                        "WALKS: {moved} in cycle {}, and farther than it is large until then",
                        self.cycles
                    )?;
                }
                if slide.is_empty() { Ok(()) } else { write!(f, ", {slide}") }
            }
            Repeats::Lost { cycle, lost, load, .. } => {
                // At factor 0 the object still rests under `load`. It is lost as soon as the load departs from this value.
                let when =
                    if lost.factor <= NEGLIGIBLE { "as soon as the load departs from" } else { "under" };
                let load = words.load(load);
                write!(f, "{} in cycle {cycle} {when} {load}: {lost:.digits$}", lost.verb(words))
            }
            Repeats::NoRest { rest } => write!(f, "{rest:.digits$}"),
            Repeats::Undecided { doubt: Some(doubt) } => {
                write!(f, "UNDECIDED in cycle {}: {doubt}", self.cycles)
            }
            Repeats::Undecided { doubt: None } => {
                let change = words.number(self.change);
                write!(
                    f,
                    "UNDECIDED after {}: forces still change by {change} of the largest in each",
                    cycles(self.cycles)
                )
            }
        }
    }

    /// The period of the repeated motion as text: "every cycle", "every 3 cycles".
    fn in_every(&self) -> String {
        if self.every == 1 { "every cycle".to_owned() } else { format!("every {} cycles", self.every) }
    }

    /// The contacts that slide and the joints and tendons that yield, as text: "left and right slide, and elbow yields". Empty if there are none.
    fn slides_and_yields(&self, slides: &[WholeContact]) -> String {
        let mut clauses = Vec::new();
        if !slides.is_empty() {
            clauses.push(subject_and_verb(slides, "slides", "slide"));
        }
        if !self.yields.is_empty() {
            let verb = if self.yields.len() == 1 { "yields" } else { "yield" };
            clauses.push(format!("{} {verb}", listed(&mapped(&self.yields, &PartLabel::text))));
        }
        clauses.join(", and ")
    }

    /// The contacts that open in every period, as a clause; nothing if there are none, or if the sentence begins with cups that leak.
    fn write_opens(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.opens.is_empty() || !self.leaks.is_empty() {
            return Ok(());
        }
        write!(f, ", but {} in {}", they_open(&self.opens), self.in_every())
    }

    fn write_moved(&self, f: &mut fmt::Formatter<'_>, words: Words) -> fmt::Result {
        write!(f, "; in all {}", moves(words, &self.moved))
    }
}

fn times(many: usize) -> String {
    match many {
        1 => "once".to_owned(),
        2 => "twice".to_owned(),
        many => format!("{many} times"),
    }
}

fn cycles(many: usize) -> String {
    if many == 1 { "a cycle".to_owned() } else { format!("{many} cycles") }
}

/// The motions of all bodies as text: "the object moves 3 mm along +x".
fn moves<const C: usize>(words: Words, by: &[BodyMotion<C>]) -> String {
    listed(&mapped(by, &|body| words.body_motion(body)))
}

impl<const C: usize> fmt::Display for Shakedown<C> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(far) = &self.too_far {
            let with = if far.is_motion() { " with these slips" } else { "" };
            write!(f, "{}{with}: {}. Otherwise ", LossVerb::from(far), far.reason(Words::of(f)))?;
        }
        if self.factor.is_infinite() {
            return f.write_str(match self.rests(1.0) {
                Some(_) => "RESTS in whichever order they come, however large they are",
                None => "MAY COME TO REST, however large they are: their order decides",
            });
        }
        let times = Words::of(f).number(self.factor);
        match self.rests(1.0) {
            Some(true) => write!(f, "RESTS in whichever order they come, up to {times} times these loads")?,
            Some(false) => write!(
                f,
                "NEVER COMES TO REST in whichever order they come, unless a contact opens: {times} times these loads are the most that slips could keep still"
            )?,
            None => write!(
                f,
                "MAY COME TO REST: up to {times} times these loads slips could keep everything still; whether they become such, the order of the loads decides"
            )?,
        }
        let mut parts: [Vec<WholeContact>; 2] = Default::default();
        for BindingContact { contact, opens, .. } in &self.binding {
            let parts = &mut parts[usize::from(*opens)];
            if !parts.contains(contact) {
                let place = parts.partition_point(|part| part.contact <= contact.contact);
                parts.insert(place, contact.clone());
            }
        }
        let [slide, open] = parts;
        let slides = (!slide.is_empty()).then(|| subject_and_verb(&slide, "slides", "slide"));
        let opens = (!open.is_empty()).then(|| they_open(&open));
        let clauses = slides.into_iter().chain(opens).list();
        if clauses.is_empty() { Ok(()) } else { write!(f, ". With more, {}", clauses.join(", ")) }
    }
}
