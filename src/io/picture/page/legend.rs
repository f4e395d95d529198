//! The legend of a still picture (SVG): the meaning of its marks (arrows, cones, lines and dots), and its scales in words. A fingertip is a contact
//! with all its points.

use super::drawing::{Drawing, LoadArrow};
use super::frame::Frame;
use crate::grasp::ContactPoints;
use crate::numerics::{Each, IntoList, mapped, summed};
use crate::picture::contact_look::{STATES, ink, word};
use crate::picture::fingertip::Resultant;
use crate::picture::layout::{LEGEND, SPATIAL};
use crate::picture::painting::{Painting, flat};
use crate::picture::palette::{BLACK, BROWN, GREY, PINK, Rgb, SKY, VERMILION};
use crate::picture::round_numbers::round_down;
use crate::picture::sheet::{PaperPoint, Sheet};
use crate::picture::words::{lines, short};
use crate::spatial::Equilibrium;

enum LegendSample {
    None,
    Contact { ink: Rgb, open: bool, cone: bool },
    Point { ink: Rgb, open: bool },
    Arrow { ink: Rgb, width: f64, heads: usize, long: f64 },
    Dashes { ink: Rgb },
}

struct Entry {
    sample: LegendSample,
    words: String,
    size: f64,
    ink: Rgb,
}

pub(super) struct Legend(Vec<Entry>);

impl Legend {
    /// The legend of a picture with `pixels` pixels per metre.
    pub(super) fn new(drawing: &Drawing, frame: Option<&Frame>, pixels: f64) -> Self {
        let mut entries = Vec::new();
        let state = frame.and_then(Frame::state);
        if let Some(Frame { shown: Err(why), .. }) = frame {
            entries.push(Entry {
                sample: LegendSample::None,
                words: why.clone(),
                size: 13.0,
                ink: VERMILION,
            });
        }
        if let Some(state) = state {
            entries.push(entry(LegendSample::None, "Contact, force on the object, friction cone:"));
            entries.extend(of_contacts(drawing, state));
        }
        if let Some(frame) = frame {
            entries.extend(of_object(drawing, frame));
        }
        if let Some(state) = state {
            entries.extend(scale(drawing.force * pixels, 3.0, 1, "N"));
            let moment = drawing.load(&state.load).moment.norm() > 0.0;
            entries.extend(scale(drawing.moment * pixels, 2.0, 2, "N m").filter(|_| moment));
        }
        for words in drawing.scales() {
            entries.push(Entry { sample: LegendSample::None, words, size: 13.0, ink: GREY });
        }
        Self(entries)
    }

    /// Draws the legend from the height `top` downwards.
    pub(super) fn draw(&self, paper: &mut Sheet, top: f64) {
        let mut y = top;
        for entry in &self.0 {
            draw_sample(paper, &entry.sample, y);
            for line in entry.lines() {
                paper.text((entry.left(), y), &line, entry.size, 0.0, entry.ink);
                y += LEGEND.line;
            }
            y += LEGEND.between;
        }
    }

    /// Height of the legend, pixels.
    pub(super) fn high(&self) -> f64 {
        summed(&self.0, &|entry| LEGEND.line * entry.lines().len() as f64 + LEGEND.between)
    }
}

impl Entry {
    fn left(&self) -> f64 {
        match self.sample {
            LegendSample::None => LEGEND.left,
            LegendSample::Arrow { long, .. } => LEGEND.left + long + 10.0,
            _ => LEGEND.left + LEGEND.sample + 10.0,
        }
    }

    fn lines(&self) -> Vec<String> {
        // A text without a sample of a mark has smaller letters and the whole width of the legend.
        let letters = if matches!(self.sample, LegendSample::None) { 32 } else { 24 };
        lines(&self.words, letters)
    }
}

fn entry(sample: LegendSample, words: &str) -> Entry {
    Entry { sample, words: words.into(), size: 14.0, ink: BLACK }
}

/// The legend entry for a scale on which one `unit` is `pixels` pixels long: the arrow of a force or moment whose magnitude is a round number. `None`
/// if no arrow can be drawn at this scale.
fn scale(pixels: f64, width: f64, heads: usize, unit: &str) -> Option<Entry> {
    // The arrow that shows the scale is at most 100 pixels long.
    let shown = 100.0 / pixels;
    (pixels > 0.0 && shown > 0.0 && shown.is_finite()).then(|| {
        let round = round_down(shown);
        let sample = LegendSample::Arrow { ink: GREY, width, heads, long: round * pixels };
        entry(sample, &format!("{} {unit}", short(round)))
    })
}

/// Legend entries of the contact states of fingertips and their points, one for each state that occurs.
fn of_contacts(drawing: &Drawing, state: &Equilibrium) -> Vec<Entry> {
    let contacts = drawing.page.grasp.contacts();
    let resultant = |tip: &ContactPoints| tip.resultant(contacts, state);
    let tips: Vec<Resultant> = mapped(drawing.tips, &resultant);
    let mut points = Vec::new();
    for tip in drawing.tips.iter().filter(|tip| tip.is_soft()) {
        points.extend(state.contacts[tip.range.clone()].iter().map(word).filter(|what| tip.shows(what)));
    }
    let mut entries = Vec::new();
    for what in STATES {
        let open = what == "separated";
        let ink = ink(what);
        if let Some(pushes) =
            tips.iter().filter(|tip| tip.word == what).map(|tip| tip.normal_force > 0.0).max()
        {
            let cone = pushes && what != "frictionless";
            entries.push(entry(LegendSample::Contact { ink, open, cone }, what));
        }
        if points.contains(&what) {
            entries.push(entry(LegendSample::Point { ink, open }, &format!("point of a fingertip, {what}")));
        }
    }
    entries
}

/// Legend entries of the marks of object and load that occur in this answer.
fn of_object(drawing: &Drawing, frame: &Frame) -> Vec<Entry> {
    let state = frame.state();
    let load = frame.load().map(|load| drawing.load(load));
    let acts = |what: fn(&LoadArrow) -> f64| load.as_ref().is_some_and(|load| what(load) > 0.0);
    let (force, moment) = (acts(|load| load.force.norm()), acts(|load| load.moment.norm()));
    let is_moved = load.as_ref().is_some_and(|load| load.is_moved);
    let of_force = if is_moved { "load, from a line that passes by" } else { "load, on its line of action" };
    let of_moment = match (force, is_moved) {
        (false, _) => "moment of the load",
        (true, false) => "moment of the load about that line",
        (true, true) => "moment of the load, about that place",
    };
    let contacts = drawing.page.grasp.contacts();
    let slides =
        |state: &Equilibrium| drawing.tips.iter().any(|tip| tip.resultant(contacts, state).slides.is_some());
    let arrow = |ink, width, heads| LegendSample::Arrow { ink, width, heads, long: LEGEND.sample };
    let dashes = |ink| LegendSample::Dashes { ink };
    let displaced = |state: &Equilibrium| {
        drawing.displacement > 0.0 && state.contacts.iter().any(|answer| answer.body_core.norm() > 0.0)
    };
    let moves = |state: &Equilibrium| {
        drawing.displacement > 0.0 && state.twist.components().iter().any(|x| x.abs() > 0.0)
    };
    let is_free = |state: &Equilibrium| !state.free_motions.is_empty();
    let has_outlines = !drawing.page.outlines.is_empty();
    let all = [
        (state.is_some_and(slides), arrow(BROWN, 2.0, 1), "slip of the finger over the object"),
        (force, arrow(BLACK, 3.0, 1), of_force),
        (moment, arrow(BLACK, 2.0, 2), of_moment),
        (state.is_some_and(displaced), arrow(PINK, 2.0, 1), "displacement of the object at a contact"),
        (state.is_some_and(moves) && has_outlines, dashes(PINK), "where the object goes"),
        (state.is_some_and(is_free), dashes(SKY), "motion that no contact resists"),
        (
            frame.leaving.is_some(),
            dashes(VERMILION),
            "where it goes when it is lost, or in every cycle, not to scale",
        ),
    ];
    let there = all.into_iter().filter(|(there, ..)| *there);
    there.map(|(_, sample, words)| entry(sample, words)).list()
}

fn draw_sample(paper: &mut Sheet, sample: &LegendSample, y: f64) {
    let ends: [PaperPoint; 2] = [(LEGEND.left, y), (LEGEND.left + LEGEND.sample, y)];
    let from = (LEGEND.left + 6.0, y);
    let mut drawn = Painting::default();
    match *sample {
        LegendSample::None => {}
        LegendSample::Contact { ink, open, cone } => {
            if cone {
                let rim = [(ends[1].0, y - 9.0), (ends[1].0, y + 9.0)];
                drawn.area(vec![from, rim[0], rim[1]], ink.mix(0.24), -1.0);
            }
            if !open {
                drawn.arrow([from, ends[1]].each(flat), ink, 3.0, 1);
            }
            drawn.dot(flat(from), SPATIAL.contact, ink, open);
        }
        LegendSample::Point { ink, open } => {
            drawn.dot(flat((LEGEND.left + LEGEND.sample / 2.0, y)), SPATIAL.soft_point, ink, open);
        }
        LegendSample::Arrow { ink, width, heads, long } => {
            drawn.arrow([(LEGEND.left, y), (LEGEND.left + long, y)].each(flat), ink, width, heads);
        }
        LegendSample::Dashes { ink } => paper.dashes(&ends, ink, 1.5),
    }
    drawn.draw(paper);
}
