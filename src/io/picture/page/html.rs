//! A page as an HTML file.

use crate::numerics::Each;
use std::fmt::Write;

use super::content::Page;
use super::drawing::Drawing;
use super::frame::Frame;
use super::table;
use crate::ask::Grasp;
use crate::grasp::{ContactPoints, Space};
use crate::picture::contact_look::{STATES, ink};
use crate::picture::error::PictureError;
use crate::picture::palette::{PINK, SKY, hex};
use crate::picture::words::escaped;

/// JavaScript that lets the reader of a page choose an answer; planar and spatial pages share it. The script of a page is a concatenation of such
/// files, which use each other's functions and variables.
pub(super) const ANSWERS_SCRIPT: &str = include_str!("view/answers.js");
const VIEW_SCRIPTS: [&str; 5] = [
    ANSWERS_SCRIPT,
    include_str!("view/eye.js"),
    include_str!("view/strokes.js"),
    include_str!("view/grasp.js"),
    include_str!("view/hands.js"),
];

impl Page {
    /// The page as the text of an HTML file. Names and labels may contain any characters.
    ///
    /// # Errors
    /// [`PictureError`] if a corner of an outline or a number of an answer is not finite, or if an answer has another number of contacts than the
    /// grasp.
    pub fn to_html(&self) -> Result<String, PictureError> {
        if self.grasp.space() == Space::Planar {
            return self.planar_html();
        }
        let drawing = Drawing::new(self)?;
        let title = escaped(&self.title);
        let scales = drawing.scales().join(" ");
        let mut page = opened(&self.title);
        table::write_says(&mut page, &self.frames);
        page += "<main>\n<div id=\"picture\">\n";
        let _ = writeln!(
            page,
            "<canvas id=\"view\" tabindex=\"0\" role=\"img\" aria-label=\"{title}; the numbers are in the table\"></canvas>"
        );
        page += "<p class=\"hint\">Drag to turn, wheel or two fingers to enlarge, double click to reset.</p>\n</div>\n<aside>\n";
        write_choice(&mut page, &self.frames);
        page += include_str!("legend.html");
        write_points_choice(&mut page, &self.grasp);
        let _ = writeln!(page, "<p class=\"scale\">{}</p>\n</aside>\n</main>", escaped(&scales));
        table::write(&mut page, &self.grasp, &self.actuators, &self.frames)?;
        let _ = writeln!(page, "<script type=\"application/json\" id=\"grasp\">{}</script>", drawing.json()?);
        closed(&mut page, &VIEW_SCRIPTS.concat());
        Ok(page)
    }
}

/// Writes the checkbox that shows the points of soft fingertips, if there are any.
pub(super) fn write_points_choice(page: &mut String, grasp: &Grasp<3>) {
    if grasp.engine.wholes().iter().any(ContactPoints::is_soft) {
        page.push_str(
            "<p><label><input type=\"checkbox\" id=\"points\">points of soft fingertips in the table</label></p>\n",
        );
    }
}

/// The beginning of a page, including its title.
pub(super) fn opened(title: &str) -> String {
    let title = escaped(title);
    let mut page = String::new();
    page += "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n";
    page += "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n";
    // Writing into a string cannot fail.
    let style = include_str!("style.css");
    let colours = colours();
    let _ = write!(page, "<title>{title}</title>\n<style>\n{colours}{style}</style>\n</head>\n<body>\n");
    let _ = writeln!(page, "<h1>{title}</h1>");
    page
}

/// CSS variables with the colours of legend and table.
fn colours() -> String {
    let mut rule = String::from(":root {");
    let states = STATES.each(|state| (state, ink(state)));
    for (name, ink) in states.into_iter().chain([("displacement", PINK), ("free", SKY)]) {
        let _ = write!(rule, " --{}: {};", name.replace(' ', "-"), hex(ink));
    }
    rule + " }\n"
}

/// Ends a page with its script.
pub(super) fn closed(page: &mut String, script: &str) {
    let _ =
        write!(page, "<script>\n\"use strict\";\n(() => {{\n{script}}})();\n</script>\n</body>\n</html>\n");
}

/// Writes buttons for the answers, and a slider for more than two answers.
pub(super) fn write_choice(page: &mut String, frames: &[Frame]) {
    if frames.len() < 2 {
        return;
    }
    page.push_str("<div id=\"frames\">");
    if frames.len() > 2 {
        let last = frames.len() - 1;
        let _ = write!(
            page,
            "<input type=\"range\" id=\"step\" min=\"0\" max=\"{last}\" value=\"0\" aria-label=\"answer\">"
        );
    }
    for (k, frame) in frames.iter().enumerate() {
        let pressed = k == 0;
        let label = escaped(&frame.label);
        let _ = write!(
            page,
            "<button type=\"button\" data-frame=\"{k}\" aria-pressed=\"{pressed}\">{label}</button>"
        );
    }
    page.push_str("</div>\n");
}
