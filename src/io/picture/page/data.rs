//! JSON data in the HTML of a page: graphical marks of the grasp and of its answers, and the scales with which the page's JavaScript draws these
//! marks. A fingertip is a contact with all its points.

use super::drawing::Drawing;
use super::eye::View;
use super::json::{json_list, json_number, json_row};
use super::mark::Mark;
use super::marks::{marks_of_the_answer, marks_of_the_grasp};
use crate::numerics::mapped;
use crate::picture::error::PictureError;
use crate::picture::layout::MARKS;
use crate::picture::palette::{CONTOUR, FACE, GREY, hex};

impl Drawing<'_> {
    /// The data that the JavaScript of the page draws, as a JSON object with these keys.
    ///
    /// | key | meaning |
    /// |---|---|
    /// | `view` | yaw and pitch of the view before the user turns it |
    /// | `centre`, `reach` | the centre of the grasp, and its distance from the farthest mark of all answers, m |
    /// | `force`, `shortest` | scale of forces, m/N; the least length of the arrow of a load, pixels |
    /// | `grey`, `face`, `contour` | colours of axes and scale, and of the object |
    /// | `contacts` | the middle of each fingertip, m |
    /// | `grasp`, `frames` | [`Mark`]s of the grasp, and of each answer |
    pub(super) fn json(&self) -> Result<String, PictureError> {
        let grasp = marks_of_the_grasp(self);
        let mut frames: Vec<Vec<Mark>> =
            mapped(&self.page.frames, &|frame| marks_of_the_answer(self, Some(frame)));
        if frames.is_empty() {
            frames.push(marks_of_the_answer(self, None));
        }
        let mut reach = self.span / 2.0;
        for mark in frames.iter().flatten().chain(&grasp) {
            for point in mark.points() {
                reach = reach.max((point - self.centre).norm());
            }
        }
        let contacts = self.page.grasp.contacts();
        let View { yaw, pitch } = View::default();
        Ok(format!(
            "{{\"view\":{{\"yaw\":{},\"pitch\":{}}},\"centre\":{},\"reach\":{},\"force\":{},\"shortest\":{},\"grey\":\"{}\",\"face\":\"{}\",\"contour\":\"{}\",\n\"contacts\":{},\n\"grasp\":{},\n\"frames\":{}}}",
            json_number(yaw)?,
            json_number(pitch)?,
            json_row(self.centre.as_slice())?,
            json_number(reach)?,
            json_number(self.force)?,
            MARKS.shortest_load,
            hex(GREY),
            hex(FACE),
            hex(CONTOUR),
            json_list(self.tips, &|tip| json_row(tip.middle(contacts).as_slice()))?,
            json_list(&grasp, &Mark::json)?,
            json_list(&frames, &|marks| json_list(marks, &Mark::json))?,
        ))
    }
}
