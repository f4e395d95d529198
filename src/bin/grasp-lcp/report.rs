//! Answers in words and tables. First slip is the event at which the first contact ceases to stick; the onset is its load factor. A drive is the
//! spring of a joint or tendon of a hand, with its force limit. A finger command is the displacement that a finger would make without the object.

use std::borrow::Cow;
use std::collections::BTreeMap;
use std::io::{self, Write};

use grasp_lcp::equilibrium::{ContactState, Equilibrium, WholeAnswer};
use grasp_lcp::grasp::Wrench;
use grasp_lcp::hold::Verdict;
use grasp_lcp::improve::Improved;
use grasp_lcp::load_path::{Beyond, DepartingContact, Departure, EdgeOf, PartChange};
use grasp_lcp::scene::{Angle, Answer, Factor, OnsetAnswer, OnsetAt, Question, Setup, TurnAnswer};
use grasp_lcp::words::printable;

use crate::table::{compared, table};
use crate::words::{NO_WORDS, Style};

/// Prints the answer to a question of a scene: its first line, then its tables and details.
pub(crate) fn print(
    out: &mut dyn Write,
    style: Style,
    setup: &Setup<3>,
    (question, answer): (&Question<3>, &Answer<3>),
) -> io::Result<()> {
    let question = &*setup.meant(question).unwrap_or(Cow::Borrowed(question));
    let sentence = question.first_line(answer, style.words);
    writeln!(out, "{sentence}")?;
    Report { out, style, sentence }.details(question, answer)
}

/// Each load with the name of the body on which the load acts.
fn named(loads: &BTreeMap<String, Wrench<3>>) -> impl Iterator<Item = (&str, &Wrench<3>)> {
    loads.iter().map(|(body, load)| (body.as_str(), load))
}

/// Prints answers to `out`. All answers have the same number of digits and the same unit of lengths, as `style` says.
pub(crate) struct Report<'o> {
    out: &'o mut dyn Write,
    pub(crate) style: Style,
    /// The first line of the answer that is printed now.
    sentence: String,
}

impl Report<'_> {
    pub(crate) fn line(&mut self, words: &str) -> io::Result<()> {
        writeln!(self.out, "  {words}")
    }

    pub(crate) fn load(&self, load: &Wrench<3>) -> String {
        self.style.words.load(load)
    }

    /// Loads on other bodies in words, to be appended to the words of a load.
    pub(crate) fn and_on_bodies<'l>(
        &self,
        loads: impl IntoIterator<Item = (&'l str, &'l Wrench<3>)>,
    ) -> String {
        let named = |(body, load)| format!(", {} more on {}", self.load(load), printable(body));
        loads.into_iter().map(named).collect::<Vec<_>>().concat()
    }

    pub(crate) fn number(&self, x: f64) -> String {
        self.style.words.number(x)
    }

    pub(crate) fn table(&mut self, state: &Equilibrium<3>) -> io::Result<()> {
        table(self.out, self.style, state, &self.sentence)
    }

    /// For the answer to `improve`, prints the position of each contact, and the value of `pressed_with` that it needs.
    fn improved(&mut self, improved: &Improved<3>) -> io::Result<()> {
        let words = self.style.words;
        let largest = improved.contacts.iter().fold(0.0, |most: f64, placed| most.max(placed.normal_force));
        for placed in &improved.contacts {
            let at = words.place(&placed.point);
            let normal = words.numbers(&placed.normal.as_slice()[..self.style.axes]);
            let at_rest = words.number(words.beside(placed.normal_force, largest));
            let press = match placed.pressed_with.map(|force| words.number(words.beside(force, largest))) {
                Some(given) if given == at_rest => format!("`pressed_with` {given} N"),
                Some(given) => format!("`pressed_with` {given} N (at rest {at_rest} N)"),
                None => format!("presses with {at_rest} N at rest"),
            };
            self.line(&format!("{} at {at}, normal {normal}, {press}", placed.contact))?;
        }
        Ok(())
    }

    /// Prints the tables and details below the first line of an answer.
    fn details(&mut self, question: &Question<3>, answer: &Answer<3>) -> io::Result<()> {
        match (question, answer) {
            (_, Answer::Hold(answer)) => {
                self.proved(&answer.verdict)?;
                self.state(answer.verdict.state.as_deref())
            }
            (_, Answer::Need(answer)) => {
                let (text, digits) = (&answer.needed, self.style.precision());
                format!("{text:.digits$}").lines().skip(1).try_for_each(|line| self.line(line.trim_start()))
            }
            (_, Answer::Shake(answer)) => self.state(answer.shaken.state.as_deref()),
            (_, Answer::Compare(answer)) => compared(self.out, self.style, &answer.comparison),
            (_, Answer::Improve(answer)) => self.improved(&answer.improved),
            (_, Answer::Solve(answer)) => {
                answer.from_rest.iter().try_for_each(|held| self.proved(&held.verdict))?;
                self.state(answer.outcome.equilibrium())
            }
            (
                Question::Onset { base, direction, command_change, joint_change, together_with },
                Answer::Onset(onset),
            ) => {
                let commands = command_change.is_some() || joint_change.is_some();
                let base = self.load(base);
                let along = self.load(direction) + &self.and_on_bodies(named(together_with));
                let way = match (*direction != Wrench::ZERO, commands) {
                    (false, _) => format!("under {base} while commands change"),
                    (true, true) => format!("from {base} along {along}, commands changing along"),
                    (true, false) => format!("from {base} along {along}"),
                };
                // If only finger commands change, the load is constant, and does not locate the onset.
                let place = |report: &Self, event: &OnsetAt<3, Factor>| {
                    let at = report.number(event.at.factor);
                    let there = if *direction == Wrench::ZERO {
                        String::new()
                    } else {
                        format!(", that is {}", report.load(&event.load))
                    };
                    format!("{way}: at factor {at}{there}")
                };
                self.onset(onset, &place)
            }
            (Question::OnsetOfTurn(turn), Answer::OnsetOfTurn(answer)) => {
                let (from, most) = (self.load(&turn.load_at(0.0)), self.style.words.angle(turn.angle()));
                let place = |report: &Self, event: &OnsetAt<3, Angle>| {
                    let (at, load) = (report.style.words.angle(event.at.angle), report.load(&event.load));
                    format!("from {from} while the load turns by {most}: at {at}, that is {load}")
                };
                self.onset(&answer.onset, &place)?;
                self.touches(answer)
            }
            (_, Answer::Follow(path)) => self.followed(path),
            _ => Ok(()),
        }
    }

    /// Prints how far around the lost equilibrium a proof excludes any other equilibrium, if there is such a proof.
    fn proved(&mut self, verdict: &Verdict<3>) -> io::Result<()> {
        let near = verdict.lost.as_ref().and_then(|lost| lost.nothing_near);
        let digits = self.style.precision();
        // A radius of the size of an atom or less says nothing useful.
        match near.filter(|near| near.translation > 1e-10) {
            Some(near) => self.line(&format!("proved: {near:.digits$}")),
            None => Ok(()),
        }
    }

    /// Prints the table of an equilibrium, if there is one.
    pub(crate) fn state(&mut self, state: Option<&Equilibrium<3>>) -> io::Result<()> {
        state.map_or(Ok(()), |state| self.table(state))
    }

    /// Prints the load factor or angle at first slip, the contacts that stop sticking there, and the equilibrium at first slip.
    fn onset<At>(
        &mut self,
        onset: &OnsetAnswer<3, At>,
        place: &dyn Fn(&Self, &OnsetAt<3, At>) -> String,
    ) -> io::Result<()> {
        match onset {
            OnsetAnswer::At(event) => {
                self.line(&place(self, event))?;
                self.leaving(event)?;
                self.table(&event.state)?;
                self.sliding_beyond(&event.beyond, &event.state)
            }
            OnsetAnswer::AlreadySliding { state } => self.table(state),
            _ => Ok(()),
        }
    }

    /// Prints each contact whose force touches the boundary of its friction cone while a load turns, but does not leave the cone. Also prints each
    /// drive whose force or torque touches its limit, but does not exceed it.
    fn touches(&mut self, answer: &TurnAnswer<3>) -> io::Result<()> {
        let mut named = Vec::new();
        for touch in &answer.touches {
            let contact = match &touch.of {
                EdgeOf::Contact(contact) if self.style.points => contact.text(),
                EdgeOf::Contact(contact) => contact.whole().text(),
                EdgeOf::Drive(part) => part.text(),
                _ => NO_WORDS.to_owned(),
            };
            if !named.contains(&contact) {
                let angle = self.style.words.angle(touch.angle);
                self.line(&format!("{contact} touches its edge at {angle}"))?;
                named.push(contact);
            }
        }
        Ok(())
    }

    /// Prints the contacts that change their state at first slip, the joints and tendons that reach their limit there, and the directions in which
    /// contacts then slide.
    fn leaving<At>(&mut self, event: &OnsetAt<3, At>) -> io::Result<()> {
        let digits = self.style.precision();
        if self.style.points {
            for leaving @ DepartingContact { contact, how, .. } in &event.leaving {
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

    /// Prints which contacts slide just beyond the load at which the first contact stops sticking, if the grasp has an equilibrium just beyond this
    /// load.
    fn sliding_beyond(&mut self, next: &Beyond<3>, state: &Equilibrium<3>) -> io::Result<()> {
        let Beyond::Continues(next) = next else { return Ok(()) };
        let slides = |i: &usize| matches!(next.states.get(*i), Some(ContactState::Sliding { .. }));
        let mut site = 0;
        let mut sliding = Vec::new();
        for named in state.whole_contacts() {
            let points = if let WholeAnswer::Pad(pad) = named { pad.points } else { 1 };
            let those = (site..site + points).filter(slides).count();
            site += points;
            match (those, points) {
                (0, _) => {}
                (_, 1) => sliding.push(named.text()),
                (those, points) => sliding.push(format!("{} ({those} of {points} points)", named.text())),
            }
        }
        let contact = if sliding.is_empty() { "nothing".to_owned() } else { sliding.join(", ") };
        self.line(&format!("sliding beyond: {contact}"))
    }
}
