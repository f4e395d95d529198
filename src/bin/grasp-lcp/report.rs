//! Answers in words and tables.

use std::borrow::Cow;
use std::collections::BTreeMap;
use std::io::{self, Write};

use grasp_lcp::equilibrium::{ContactState, Equilibrium, Outcome, Undecided, WholeAnswer};
use grasp_lcp::grasp::Wrench;
use grasp_lcp::hold::Verdict;
use grasp_lcp::improve::Improved;
use grasp_lcp::load_path::{Beyond, Departure, EdgeOf, Leaving, PartChange};
use grasp_lcp::scene::{Answer, OnsetAnswer, OnsetAt, Question, Setup, TurnAnswer};
use grasp_lcp::words::printable;

use crate::table::{compared, table};
use crate::words::{NO_WORDS, Style};

/// Prints the answers to the questions of a scene.
pub(crate) fn print<const C: usize>(
    out: &mut dyn Write,
    style: Style,
    comment: Option<&str>,
    setup: &Setup<C>,
    answers: &[Answer<C>],
) -> io::Result<()> {
    let is_a_sentence = |answer: &Answer<C>| {
        matches!(
            answer,
            Answer::Hold(_)
                | Answer::Need(_)
                | Answer::Improve(_)
                | Answer::Compare(_)
                | Answer::Shake(_)
                | Answer::Shakedown(_)
                | Answer::Identify(_)
        )
    };
    // An answer that is a sentence comes first; only tables need this head.
    if !answers.iter().all(is_a_sentence) {
        // The comment is put on one line, so that none of its lines looks like an answer.
        if let Some(comment) = comment {
            writeln!(out, "{}", printable(&comment.lines().collect::<Vec<_>>().join(" ")))?;
        }
        let (contacts, points) = (setup.entries().count(), setup.points().unwrap_or_default());
        let links = match setup.links.len() {
            0 => String::new(),
            1 => ", 1 link".to_owned(),
            more => format!(", {more} links"),
        };
        let of = if points > contacts && setup.links.is_empty() {
            format!(", {points} points of contact")
        } else {
            String::new()
        };
        writeln!(out, "{contacts} {}{of}{links}", if contacts == 1 { "contact" } else { "contacts" })?;
    }
    let mut report = Report { out, style };
    for (question, answer) in setup.questions.iter().zip(answers) {
        let question = &*setup.meant(question).unwrap_or(Cow::Borrowed(question));
        report.answer(question, answer)?;
    }
    Ok(())
}

/// Loads by the name of their body.
fn named<const C: usize>(loads: &BTreeMap<String, Wrench<C>>) -> impl Iterator<Item = (&str, &Wrench<C>)> {
    loads.iter().map(|(body, load)| (body.as_str(), load))
}

/// The output, and the form of the answers.
pub(crate) struct Report<'o> {
    out: &'o mut dyn Write,
    pub(crate) style: Style,
}

impl Report<'_> {
    pub(crate) fn line(&mut self, words: &str) -> io::Result<()> {
        writeln!(self.out, "  {words}")
    }

    pub(crate) fn load<const C: usize>(&self, load: &Wrench<C>) -> String {
        self.style.words.load(load)
    }

    /// The loads of other bodies that act together with a load, in words.
    pub(crate) fn and_on_bodies<'l, const C: usize>(
        &self,
        loads: impl IntoIterator<Item = (&'l str, &'l Wrench<C>)>,
    ) -> String {
        let told = |(body, load)| format!(", {} on {}", self.load(load), printable(body));
        loads.into_iter().map(told).collect::<Vec<_>>().concat()
    }

    pub(crate) fn number(&self, x: f64) -> String {
        self.style.words.number(x)
    }

    pub(crate) fn table<const C: usize>(&mut self, state: &Equilibrium<C>) -> io::Result<()> {
        table(self.out, self.style, state, true)
    }

    /// The table of a state whose caution stands above it already.
    pub(crate) fn table_after_caution<const C: usize>(&mut self, state: &Equilibrium<C>) -> io::Result<()> {
        table(self.out, self.style, state, false)
    }

    /// The sentence, and the new place of each contact that may move.
    fn improved<const C: usize>(&mut self, improved: &Improved<C>) -> io::Result<()> {
        let (digits, words) = (self.style.digits(), self.style.words);
        writeln!(self.out, "{improved:.digits$}")?;
        let largest = improved.contacts.iter().fold(0.0, |most: f64, placed| most.max(placed.normal_force));
        for placed in &improved.contacts {
            let at = words.numbers(placed.point.as_slice());
            let normal = words.numbers(placed.normal.as_slice());
            let force = words.number(words.beside(placed.normal_force, largest));
            self.line(&format!("{} at {at} m, normal {normal}, presses with {force} N", placed.contact))?;
        }
        Ok(())
    }

    fn answer<const C: usize>(&mut self, question: &Question<C>, answer: &Answer<C>) -> io::Result<()> {
        let digits = self.style.digits();
        match (question, answer) {
            (_, Answer::Hold(answer)) => {
                writeln!(self.out, "{:.digits$}", answer.verdict)?;
                answer.verdict.state.as_ref().map_or(Ok(()), |state| self.table(state))
            }
            (_, Answer::Shake(answer)) => {
                writeln!(self.out, "{:.digits$}", answer.shaken)?;
                answer.shaken.state.as_ref().map_or(Ok(()), |state| self.table_after_caution(state))
            }
            (_, Answer::Compare(answer)) => {
                writeln!(self.out, "{}", answer.says)?;
                compared(self.out, self.style, &answer.comparison)
            }
            (_, Answer::Shakedown(answer)) => writeln!(self.out, "{}", answer.says),
            (_, Answer::Identify(answer)) => writeln!(self.out, "{}", answer.says),
            (_, Answer::Need(answer)) => writeln!(self.out, "{:.digits$}", answer.needed),
            (_, Answer::Improve(answer)) => self.improved(&answer.improved),
            (Question::Solve { load, together_with }, Answer::Solve(answer)) => {
                writeln!(
                    self.out,
                    "\nUnder {}{}",
                    self.load(load),
                    self.and_on_bodies(named(together_with))
                )?;
                // If the search found nothing, the path from rest may still decide.
                match (&answer.from_rest, &answer.outcome) {
                    (Some(told), Outcome::Undecided(undecided)) if told.verdict.holds() == Some(false) => {
                        self.lost_from_rest(&told.verdict, undecided)
                    }
                    (told, outcome) => {
                        self.solved(outcome)?;
                        let told = told.as_ref().map(|told| format!("put on from rest: {}", told.says));
                        told.map_or(Ok(()), |told| self.line(&told))
                    }
                }
            }
            (
                Question::Onset { base, direction, command_change, joint_change, together_with },
                Answer::Onset(onset),
            ) => {
                let commands = command_change.is_some() || joint_change.is_some();
                let changes = *direction != Wrench::ZERO;
                let base = self.load(base);
                let direction = self.load(direction) + &self.and_on_bodies(named(together_with));
                let way = match (changes, commands) {
                    (false, _) => format!("under {base} while commands change"),
                    (true, true) => format!("from {base} along {direction}, commands changing along"),
                    (true, false) => format!("from {base} along {direction}"),
                };
                writeln!(self.out, "\nOnset of sliding {way}")?;
                self.onset(onset, ("factor", changes), |report, at| report.number(at.factor))
            }
            (Question::OnsetOfTurn(turn), Answer::OnsetOfTurn(onset)) => {
                let (from, most) = (self.load(&turn.load_at(0.0)), self.style.words.angle(turn.angle()));
                writeln!(self.out, "\nOnset of sliding from {from} while the load turns by {most}")?;
                self.onset(&onset.onset, ("an angle of", true), |report, at| {
                    report.style.words.angle(at.angle)
                })?;
                self.touches(onset)
            }
            (Question::Follow { start, legs, .. }, Answer::Follow(path)) => {
                let legs = if legs.len() == 1 { "1 leg".to_owned() } else { format!("{} legs", legs.len()) };
                writeln!(self.out, "\nLoad program of {legs} from {}", self.load(start))?;
                self.followed(path)
            }
            _ => writeln!(self.out, "{NO_WORDS}"),
        }
    }

    pub(crate) fn solved<const C: usize>(&mut self, outcome: &Outcome<C>) -> io::Result<()> {
        let digits = self.style.digits();
        match outcome {
            Outcome::Equilibrium(state) => self.table(state),
            Outcome::NoEquilibrium(none) => self.line(&format!("no equilibrium exists: {none:.digits$}")),
            Outcome::Undecided(why) => self.line(&format!("undecided: {}", why.doubt)),
            _ => self.line(NO_WORDS),
        }
    }

    /// The load is lost from rest, which counts. The search has found no other equilibrium, and has not excluded one.
    fn lost_from_rest<const C: usize>(&mut self, verdict: &Verdict<C>, doubt: &Undecided) -> io::Result<()> {
        let digits = self.style.digits();
        self.line(&format!("put on from rest: {verdict:.digits$}"))?;
        self.line(&format!("whether another equilibrium exists elsewhere is undecided: {doubt}"))
    }

    /// An onset at `called`, such as a factor; `changes` is false if only commands change, not the load.
    fn onset<const C: usize, At>(
        &mut self,
        onset: &OnsetAnswer<C, At>,
        (called, changes): (&str, bool),
        place: impl Fn(&Self, &At) -> String,
    ) -> io::Result<()> {
        let digits = self.style.digits();
        match onset {
            OnsetAnswer::At(event) => {
                let (at, load) = (place(self, &event.at), self.load(&event.load));
                // A constant load does not help to locate the onset.
                let load = if changes { format!(", that is {load}") } else { String::new() };
                self.line(&format!("at {called} {at}{load}"))?;
                self.leaving(event)?;
                self.table(&event.state)?;
                self.beyond_onset(&event.beyond, &event.state)
            }
            OnsetAnswer::Never => self.line("never: everything keeps sticking however far the load goes"),
            OnsetAnswer::AlreadySliding { state } => {
                self.line("something slides already where the load begins:")?;
                self.table(state)
            }
            OnsetAnswer::NoBase(none) => {
                self.line(&format!("no equilibrium exists where the load begins: {none:.digits$}"))
            }
            OnsetAnswer::Undecided(why) => {
                self.line(&format!("undecided where the load begins: {}", why.doubt))
            }
            OnsetAnswer::GivesWay { at, reason } => {
                let at = place(self, at);
                self.line(&format!("nothing slides, but from {called} {at} on: {reason:.digits$}"))
            }
            _ => self.line(NO_WORDS),
        }
    }

    /// Contacts and drives that reach their edge while a load turns and do not leave, each once.
    fn touches<const C: usize>(&mut self, answer: &TurnAnswer<C>) -> io::Result<()> {
        let mut told = Vec::new();
        for touch in &answer.touches {
            let who = match &touch.of {
                EdgeOf::Contact(contact) if self.style.points => contact.text(),
                EdgeOf::Contact(contact) => contact.whole().text(),
                EdgeOf::Drive(part) => part.text(),
                _ => NO_WORDS.to_owned(),
            };
            if !told.contains(&who) {
                let angle = self.style.words.angle(touch.angle);
                self.line(&format!("{who} touches its edge at {angle}"))?;
                told.push(who);
            }
        }
        Ok(())
    }

    /// The contacts that stop sticking, and their motion.
    fn leaving<const C: usize, At>(&mut self, event: &OnsetAt<C, At>) -> io::Result<()> {
        let digits = self.style.digits();
        if self.style.points {
            for leaving @ Leaving { contact, how, .. } in &event.leaving {
                let along = match how {
                    Departure::Slides { direction } => {
                        format!(" over the object along {}", self.style.words.along(direction))
                    }
                    _ => String::new(),
                };
                self.line(&format!("{} {}{along}", contact.text(), leaving.verb()))?;
            }
        } else {
            for change in event.whole_changes() {
                self.line(&format!("{change:.digits$}"))?;
            }
        }
        for PartChange { part, what, .. } in &event.drives {
            self.line(&format!("{} {what}", part.text()))?;
        }
        Ok(())
    }

    /// The behaviour beyond an onset.
    fn beyond_onset<const C: usize>(&mut self, next: &Beyond<C>, state: &Equilibrium<C>) -> io::Result<()> {
        let Beyond::Continues(next) = next else { return self.beyond(next) };
        let slides = |i: &usize| matches!(next.states.get(*i), Some(ContactState::Sliding { .. }));
        let mut site = 0;
        let mut sliding = Vec::new();
        for told in state.whole_contacts() {
            let points = if let WholeAnswer::Pad(pad) = told { pad.points } else { 1 };
            let those = (site..site + points).filter(slides).count();
            site += points;
            match (those, points) {
                (0, _) => {}
                (_, 1) => sliding.push(told.text()),
                (those, points) => sliding.push(format!("{} ({those} of {points} points)", told.text())),
            }
        }
        let who = if sliding.is_empty() {
            "nothing slides".to_owned()
        } else {
            format!("sliding: {}", sliding.join(", "))
        };
        self.line(&format!("beyond: the grasp holds on; {who}"))
    }

    /// The behaviour beyond an onset where the equilibrium ends, or beyond the end of a path.
    pub(crate) fn beyond<const C: usize>(&mut self, beyond: &Beyond<C>) -> io::Result<()> {
        let digits = self.style.digits();
        self.line(&format!("beyond: {beyond:.digits$}"))
    }
}
