//! Names of fingertips, bodies and joints on a picture of a grasp, placed so that they hide as little as possible. A fingertip is a contact with all
//! its points.

use nalgebra::Vector2;

use super::{DrawnFingertip, Picture};
use crate::picture::axes::EqualScales;
use crate::picture::labels::Labels;
use crate::picture::layout::{MARKS, PLANAR};
use crate::picture::painting::Painting;
use crate::picture::palette::GREY;
use crate::picture::planar_load::LoadOnPaper;
use crate::picture::sheet::{PaperPoint, Sheet};
use crate::picture::window::Window;
use crate::picture::words::short;
use crate::words::printable;

impl Picture<'_> {
    /// Writes all names, including the names of the load and of the motion with which the object leaves the grasp. A name is left out if no free
    /// position remains. With more than 30 fingertips (`most_named`) all their names are left out. The number of missing names is stated below the
    /// picture.
    pub(super) fn write_names(
        &self,
        axes: &EqualScales,
        (paper, window, painting): (&mut Sheet, Window, &Painting),
        (load, leaves): (Option<&LoadOnPaper<'_>>, Option<PaperPoint>),
    ) {
        let mut labels = Labels::new(window.within(4.0), painting.ink());
        let (mut placed, mut names) = (Vec::new(), Vec::new());
        if let Some(state) = self.state() {
            for (name, at) in self.actuators.that_yield(state) {
                match at {
                    Some(at) => placed.push((name, at.xy())),
                    None => names.push(name),
                }
            }
        }
        if !names.is_empty() {
            labels.write_in_the_corner(
                paper,
                &format!("At their limit: {}", names.join(", ")),
                PLANAR.letters,
            );
        }
        let named = if self.tips.len() <= MARKS.most_named { &self.tips[..] } else { &[] };
        for tip in named {
            self.write_tip(tip, axes, paper, &mut labels);
        }
        if let Some(load) = load {
            load.write(paper, &mut labels, PLANAR.letters);
        }
        for (name, at) in placed {
            labels.write(paper, axes.place(at), &[&format!("{name} yields")], PLANAR.letters);
        }
        if let Some(at) = leaves {
            labels.write(paper, at, &["where it goes, not to scale"], PLANAR.letters);
        }
        // The name of a body is written last and inside the body, so that all other names have found their places before.
        for (motion, outline) in self.state().iter().flat_map(|state| &state.bodies).zip(&self.of.outlines) {
            if outline.len() > 2 {
                let middle = outline.iter().sum::<Vector2<f64>>() / outline.len() as f64;
                labels.write(paper, axes.place(middle), &[&printable(&motion.body)], PLANAR.letters);
            }
        }
        let unnamed = labels.left_out + self.tips.len() - named.len();
        if unnamed > 0 {
            let words = format!("{unnamed} names have no room here");
            paper.text((window.left, window.top + window.high + 36.0), &words, PLANAR.letters, 0.0, GREY);
        }
    }

    /// Writes name, state and force of a fingertip at the outer end of the finger; between two bodies, where no finger is drawn, at the contact.
    fn write_tip(&self, tip: &DrawnFingertip, axes: &EqualScales, paper: &mut Sheet, labels: &mut Labels) {
        let is_between = self.of.grasp.contacts()[tip.of.range.start].against.is_some();
        let behind = if is_between { 0.0 } else { PLANAR.finger * self.span };
        let at = axes.place(tip.middle.xy() - tip.normal() * behind);
        let name = tip.of.text();
        match &tip.resultant {
            // If there are more fingertips than `most_labelled`, names are written without state and force.
            Some(resultant) if self.tips.len() <= PLANAR.most_labelled && tip.link.is_some() => {
                let force = format!("{} N", short(resultant.force.norm()));
                labels.write(paper, at, &[&name, &force], PLANAR.letters);
            }
            Some(resultant) if self.tips.len() <= PLANAR.most_labelled => {
                let force = format!("|F| = {} N", short(resultant.force.norm()));
                labels.write(paper, at, &[&name, resultant.word, &force], PLANAR.letters);
            }
            _ => labels.write(paper, at, &[&name], PLANAR.letters),
        }
    }
}
