//! What the marks of a still mean, and its scales in words.

use plotters::style::{Color, RGBColor, colors::BLACK};

use super::drawing::Drawing;
use super::frame::Frame;
use super::marks::{BROWN, PINK, SKY};
use super::paint::{Painting, dot};
use super::text::lines;
use crate::picture::contact_look::{ink, word};
use crate::picture::error::Drawn;
use crate::picture::palette::{GREY, VERMILION};
use crate::picture::sheet::{Place, Sheet};
use crate::spatial::{ContactAnswer, ContactState, Equilibrium};

/// Left edge, length of the samples, letters of a line of 14 and of 13 pixels.
pub(super) const LEFT: f64 = 624.0;
const SAMPLE: f64 = 40.0;
const LETTERS: usize = 24;
const SMALL: usize = 32;

enum Sample {
    None,
    Contact { ink: RGBColor, open: bool, cone: bool },
    Arrow { ink: RGBColor, width: f64, heads: usize },
    Dashes { ink: RGBColor },
}

struct Entry {
    sample: Sample,
    words: String,
    size: f64,
    ink: RGBColor,
}

pub(super) struct Legend(Vec<Entry>);

impl Legend {
    pub(super) fn new(drawing: &Drawing, frame: Option<&Frame>) -> Self {
        let mut entries = Vec::new();
        let state = frame.and_then(Frame::state);
        if let Some(Frame { shown: Err(why), .. }) = frame {
            entries.push(Entry { sample: Sample::None, words: why.clone(), size: 13.0, ink: VERMILION });
        }
        if let Some(state) = state {
            entries.push(entry(Sample::None, "Contact, force on the object, friction cone:"));
            entries.extend(of_contacts(state));
            entries.extend(of_object(drawing, state));
        }
        for words in drawing.scales(state) {
            entries.push(Entry { sample: Sample::None, words, size: 13.0, ink: GREY });
        }
        Self(entries)
    }

    /// Draws it from a height downwards.
    pub(super) fn draw(&self, paper: &Sheet, top: f64) -> Drawn {
        let mut y = top;
        for entry in &self.0 {
            draw_sample(paper, &entry.sample, y)?;
            for line in entry.lines() {
                paper.text((entry.left(), y), &line, entry.size, 0.0, entry.ink)?;
                y += LINE;
            }
            y += BETWEEN;
        }
        Ok(())
    }

    /// How much room it takes.
    pub(super) fn high(&self) -> f64 {
        self.0.iter().map(|entry| LINE * entry.lines().len() as f64 + BETWEEN).sum()
    }
}

const LINE: f64 = 18.0;
const BETWEEN: f64 = 7.0;

impl Entry {
    fn left(&self) -> f64 {
        if matches!(self.sample, Sample::None) { LEFT } else { LEFT + SAMPLE + 10.0 }
    }

    fn lines(&self) -> Vec<String> {
        let letters = if matches!(self.sample, Sample::None) { SMALL } else { LETTERS };
        lines(&self.words, letters)
    }
}

fn entry(sample: Sample, words: &str) -> Entry {
    Entry { sample, words: words.into(), size: 14.0, ink: BLACK }
}

/// What contacts do, each thing once.
fn of_contacts(state: &Equilibrium) -> impl Iterator<Item = Entry> {
    let all = ["rolling", "about to slide", "sliding", "separated", "frictionless"];
    all.into_iter().filter_map(|what| {
        let mut answers = state.contacts.iter().filter(|answer| word(answer) == what);
        let answer: &ContactAnswer = answers.next()?;
        let open = answer.state == ContactState::Separated;
        let pushes = answer.normal_force() > 0.0 || answers.any(|answer| answer.normal_force() > 0.0);
        let cone = pushes && what != "frictionless";
        let words = if what == "rolling" { "rolling (sticks)" } else { what };
        Some(entry(Sample::Contact { ink: ink(answer), open, cone }, words))
    })
}

/// What belongs to the object, as far as there is any of it.
fn of_object(drawing: &Drawing, state: &Equilibrium) -> Vec<Entry> {
    let load = drawing.load(state);
    let moment =
        if load.force.norm() > 0.0 { "moment of the load about that line" } else { "moment of the load" };
    let slides = |answer: &ContactAnswer| matches!(answer.state, ContactState::Sliding { .. });
    let arrow = |ink, width, heads| Sample::Arrow { ink, width, heads };
    let displaced = state.contacts.iter().any(|answer| answer.body_core.norm() > 0.0);
    let moves = state.twist.as_vector().norm() > 0.0 && drawing.displacement > 0.0;
    let all = [
        (state.contacts.iter().any(slides), arrow(BROWN, 2.0, 1), "slip of the finger over the object"),
        (load.force.norm() > 0.0, arrow(BLACK, 3.0, 1), "load, on its line of action"),
        (load.moment.norm() > 0.0, arrow(BLACK, 2.0, 2), moment),
        (displaced, arrow(PINK, 2.0, 1), "displacement of the object at a contact"),
        (moves && !drawing.page.outlines.is_empty(), Sample::Dashes { ink: PINK }, "where the object goes"),
        (!state.free_motions.is_empty(), Sample::Dashes { ink: SKY }, "motion that no contact resists"),
    ];
    let there = all.into_iter().filter(|(there, ..)| *there);
    there.map(|(_, sample, words)| entry(sample, words)).collect()
}

fn draw_sample(paper: &Sheet, sample: &Sample, y: f64) -> Drawn {
    let ends: [Place; 2] = [(LEFT, y), (LEFT + SAMPLE, y)];
    let from = (LEFT + 6.0, y);
    let mut drawn = Painting::default();
    match *sample {
        Sample::None => Ok(()),
        Sample::Contact { ink, open, cone } => {
            if cone {
                let rim = [(ends[1].0, y - 9.0), (ends[1].0, y + 9.0)];
                paper.area([from, rim[0], rim[1]], ink.mix(0.24))?;
            }
            if !open {
                drawn.flat_arrow([from, ends[1]], ink, 3.0, 1);
                drawn.draw(paper)?;
            }
            dot(paper, from, ink, open)
        }
        Sample::Arrow { ink, width, heads } => {
            drawn.flat_arrow(ends, ink, width, heads);
            drawn.draw(paper)
        }
        Sample::Dashes { ink } => paper.dashes(&ends, ink, 1.5),
    }
}
