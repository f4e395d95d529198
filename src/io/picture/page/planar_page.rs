//! A planar grasp and its answers as a page: pictures at one scale, selected by a slider.

use std::fmt::Write;

use nalgebra::Vector2;

use super::content::Page;
use super::frame::Frame;
use super::html::{ANSWERS_SCRIPT, closed, opened, write_choice, write_points_choice};
use super::table;
use crate::numerics::mapped;
use crate::picture::error::PictureError;
use crate::picture::grasp_picture::stills_of_a_page;
use crate::picture::planar_picture::PlanarPicture;

impl Page {
    pub(super) fn planar_html(&self) -> Result<String, PictureError> {
        let mut page = opened(&self.title);
        table::write_says(&mut page, &self.frames);
        write_choice(&mut page, &self.frames);
        write_points_choice(&mut page, &self.grasp);
        let pictures: Vec<_> = mapped(&self.frames, &|frame| self.planar_picture(Some(frame)));
        for (k, picture) in stills_of_a_page(&pictures)?.iter().enumerate() {
            // Within HTML an SVG element needs no namespace.
            let picture = picture.replacen(" xmlns=\"http://www.w3.org/2000/svg\"", "", 1);
            let hidden = if k == 0 { "" } else { " hidden" };
            let _ =
                writeln!(page, "<section class=\"still\" data-frame=\"{k}\"{hidden}>\n{picture}</section>");
        }
        table::write(&mut page, &self.grasp, &self.actuators, &self.frames)?;
        closed(&mut page, &format!("{ANSWERS_SCRIPT}onChoice(choose);\n"));
        Ok(page)
    }

    /// The picture of an answer with its sentences below the title, as an SVG for paper.
    pub(super) fn planar_svg(&self, frame: Option<&Frame>) -> Result<String, PictureError> {
        let picture = PlanarPicture { title: &self.title, ..self.planar_picture(frame) };
        let Some(frame) = frame else { return picture.to_svg() };
        let sentences = [&frame.label].into_iter().chain(frame.shown.as_ref().err()).chain(&frame.says);
        sentences.fold(picture, |picture, sentence| picture.says(sentence)).to_svg()
    }

    fn planar_picture<'p>(&'p self, frame: Option<&'p Frame>) -> PlanarPicture<'p> {
        let grasp = frame.and_then(|frame| frame.grasp.as_ref()).unwrap_or(&self.grasp);
        let bodies = self.outlines.iter().map(|line| line.body + 1).max().unwrap_or(0);
        let mut outlines = vec![Vec::new(); bodies];
        for line in &self.outlines {
            outlines[line.body].extend(mapped(&line.corners, &|[x, y, _]| Vector2::new(*x, *y)));
        }
        let picture = PlanarPicture { outlines, ..PlanarPicture::new(grasp, "") };
        let Some(frame) = frame else { return picture };
        let picture = picture.maybe_state(frame.state()).maybe_leaving(frame.leaving.as_ref());
        PlanarPicture { load: frame.load, ..picture }
    }
}
