//! A planar grasp and its answers as a page: pictures at one scale, selected by a slider.

use crate::numerics::IntoList;
use std::fmt::Write;

use super::frame::{Frame, change_last};
use super::html::{ANSWERS_SCRIPT, closed, opened, write_choice};
use super::table;
use crate::grasp::{ContactPoints, Motion, inside};
use crate::numerics::mapped;
use crate::picture::actuators::Actuators;
use crate::picture::error::PictureError;
use crate::picture::grasp_picture::stills_of_a_page;
use crate::picture::planar_picture::{Outline, PlanarPicture};
use crate::planar::{Equilibrium, Grasp, Wrench};

/// A planar grasp and one or more of its answers as a single self-contained HTML file. Its first line states the answer in a sentence. Buttons select an
/// answer, and a slider if there are more than two. All pictures have one scale, so that growing forces are visible. Each picture is that of a
/// [`PlanarPicture`], and a table has the numbers of the answer shown.
///
/// ```
/// use grasp_lcp::picture::PlanarPage;
/// use grasp_lcp::planar::{Contact, Grasp, Wrench};
///
/// let finger = |x: f64| Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1000.0, 800.0).friction(0.5).command([0.01, 0.0]);
/// let grasp = Grasp::new([finger(-1.0), finger(1.0)])?;
/// let verdict = grasp.hold(Wrench::force([0.0, -6.0]))?;
/// let state = verdict.state.as_deref().ok_or("it holds")?;
/// let page = PlanarPage::new(&grasp, "A pinch").frame_of("under the load", &grasp, state).says(verdict.to_string()).to_html()?;
/// assert!(page.starts_with("<!DOCTYPE html>") && page.contains("<p class=\"says\">HOLDS, everything sticks"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone)]
pub struct PlanarPage {
    grasp: Grasp,
    title: String,
    outlines: Vec<Vec<[f64; 2]>>,
    frames: Vec<Frame<2>>,
    /// The grasp of each answer, whose friction may differ.
    grasps: Vec<Grasp>,
}

impl PlanarPage {
    /// A page without answers.
    #[must_use]
    pub fn new(grasp: &Grasp, title: impl Into<String>) -> Self {
        Self {
            grasp: grasp.clone(),
            title: title.into(),
            outlines: Vec::new(),
            frames: Vec::new(),
            grasps: Vec::new(),
        }
    }

    /// Draws the outline of the object, or of each of [several bodies](crate::grasp::Bodies) in order; an empty outline omits a body.
    #[must_use]
    pub fn outlines<'o>(mut self, outlines: impl IntoIterator<Item = Outline<'o>>) -> Self {
        self.outlines = outlines.into_iter().map(<[_]>::to_vec).list();
        self
    }

    /// Adds an equilibrium of this grasp, or of one with other coefficients of friction or commands; `label` is written on its button. The first
    /// answer is shown initially.
    #[must_use]
    pub fn frame_of(mut self, label: impl Into<String>, grasp: &Grasp, state: &Equilibrium) -> Self {
        self.frames.push(Frame::of(label.into(), grasp, state));
        self.grasps.push(grasp.clone());
        self
    }

    /// Adds an answer without an equilibrium, with the reason.
    #[must_use]
    pub fn nothing(mut self, label: impl Into<String>, why: impl Into<String>) -> Self {
        self.frames.push(Frame::new(label.into(), Err(why.into())));
        self.grasps.push(self.grasp.clone());
        self
    }

    /// Adds a sentence above the last answer.
    #[must_use]
    pub fn says(mut self, sentence: impl Into<String>) -> Self {
        change_last(&mut self.frames, |frame| frame.says.push(sentence.into()));
        self
    }

    /// Draws a motion of the object in the last answer, if there is one, such as that of a loss. Only the direction of the motion matters.
    #[must_use]
    pub fn maybe_leaving(mut self, motion: Option<&Motion<2>>) -> Self {
        change_last(&mut self.frames, |frame| frame.leaving = motion.cloned());
        self
    }

    /// Sets the load of the last answer. It is drawn if the answer has no equilibrium.
    #[must_use]
    pub fn under(mut self, load: Wrench) -> Self {
        change_last(&mut self.frames, |frame| frame.load = Some(load));
        self
    }

    /// Writes the page. Names and labels may contain any characters.
    ///
    /// # Errors
    /// As for [`PlanarPicture::to_svg`], or if a number of an answer is NaN.
    pub fn to_html(&self) -> Result<String, PictureError> {
        let mut page = opened(&self.title);
        let (grasp, frames) = (inside(&self.grasp), mapped(&self.frames, &Frame::widened));
        table::write_says(&mut page, &frames);
        write_choice(&mut page, &frames);
        if grasp.engine.wholes().iter().any(ContactPoints::is_soft) {
            page.push_str(super::html::POINTS_CHOICE);
        }
        let pictures: Vec<_> =
            self.frames.iter().zip(&self.grasps).map(|(frame, grasp)| self.picture(frame, grasp)).list();
        for (k, picture) in stills_of_a_page(&pictures)?.iter().enumerate() {
            // Within HTML an SVG element needs no namespace.
            let picture = picture.replacen(" xmlns=\"http://www.w3.org/2000/svg\"", "", 1);
            let hidden = if k == 0 { "" } else { " hidden" };
            let _ =
                writeln!(page, "<section class=\"still\" data-frame=\"{k}\"{hidden}>\n{picture}</section>");
        }
        table::write(&mut page, &grasp, &Actuators::of(&grasp), &frames)?;
        closed(&mut page, &format!("{ANSWERS_SCRIPT}onChoice(choose);\n"));
        Ok(page)
    }

    fn picture<'p>(&'p self, frame: &'p Frame<2>, grasp: &'p Grasp) -> PlanarPicture<'p> {
        let mut picture = PlanarPicture::new(grasp, "").outlines(self.outlines.iter().map(Vec::as_slice));
        picture = picture.maybe_state(frame.state()).maybe_leaving(frame.leaving.as_ref());
        match frame.load {
            Some(load) => picture.load(load),
            None => picture,
        }
    }
}
