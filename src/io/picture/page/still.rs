//! One answer of a page as a still picture: an SVG, for paper.

use super::content::Page;
use super::drawing::Drawing;
use super::eye::{Eye, View};
use super::legend::Legend;
use super::mark::{Mark, MarkLayer, MarkShape};
use super::marks::{marks_of_the_answer, marks_of_the_grasp};
use super::paint::{load_ends, painting};
use crate::numerics::{Each, Space, mapped};
use crate::picture::error::PictureError;
use crate::picture::labels::Labels;
use crate::picture::layout::{LEGEND, MARKS, STILL};
use crate::picture::palette::{BLACK, GREY};
use crate::picture::sheet::{PaperPoint, Sheet, sheet};
use crate::picture::window::Window;
use crate::picture::words::{caution, lines};
use nalgebra::Vector2;

impl Page {
    /// Draws one of the answers: in space as the page shows it, seen from one side, with a legend; in the plane as a
    /// [`PlanarPicture`](crate::picture::PlanarPicture). `answer` is the index of the answer, from 0 in the order in which answers were added; `None`
    /// draws the grasp alone. In space all answers of a page, seen from the same side, have the same scales of forces, moments, displacements and
    /// lengths. Their pictures can thus be compared. The marks of all answers lie inside the picture.
    ///
    /// A friction cone is normally a little higher than the arrow of its normal force. If the radius of such a cone exceeds half the size of the
    /// grasp (μ far above 1), the whole cone is drawn smaller.
    ///
    /// ```
    /// use grasp_lcp::picture::{Page, View};
    /// use grasp_lcp::spatial::{Contact, Grasp, Wrench};
    ///
    /// let finger = |x: f64| Contact::new([x, 0.0, 0.0], [-x, 0.0, 0.0]).series_stiffness(1000.0, 600.0).friction(0.5).command([0.004, 0.0, 0.0]);
    /// let grasp = Grasp::new([finger(-0.03), finger(0.03)])?;
    /// let page = Page::new(&grasp, "A pinch").outcome("0.5 N", &grasp.solve(Wrench::force([0.0, 0.0, -0.5]))?);
    ///
    /// let svg = page.to_svg(Some(0), View::default())?;
    /// assert!(svg.starts_with("<svg") && svg.contains("turns freely"));
    /// // The fingers alone, from the front; of answers there is only one.
    /// assert!(page.to_svg(None, View::FRONT).is_ok());
    /// assert!(page.to_svg(Some(1), View::FRONT).is_err());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`PictureError`] if there is no such answer, or an angle of the view is not finite. Also if a corner of an outline or a number of an answer is
    /// not finite, or if an answer has another number of contacts than the grasp.
    pub fn to_svg(&self, answer: Option<usize>, view: View) -> Result<String, PictureError> {
        let given = self.frames.len();
        let chosen = |k: usize| {
            let none =
                || PictureError(format!("there is no answer {k}: the page has {given}, counted from 0"));
            self.frames.get(k).ok_or_else(none)
        };
        let frame = answer.map(chosen).transpose()?;
        if self.grasp.space() == Space::Planar {
            return self.planar_svg(frame);
        }
        let drawing = Drawing::new(self)?;
        // Largest number of letters in a line of the title and of the label.
        let letters = (70, 96);
        let title = lines(&self.title, letters.0);
        let label = frame.map_or_else(Vec::new, |frame| {
            let caution = caution(frame.state(), frame.says.iter().map(String::as_str));
            let mut label = lines(&frame.label, letters.1);
            for words in frame.says.iter().chain(&caution) {
                label.extend(lines(words, letters.1));
            }
            label
        });
        let top = 20.0 + 24.0 * title.len() as f64 + 20.0 * label.len() as f64;
        let window = Window { left: STILL.margin, top, wide: STILL.room.0, high: STILL.room.1 };
        // The view contains the marks of all answers, so that the still pictures of all answers have one scale and can be compared.
        let mut marks = marks_of_the_grasp(&drawing);
        let mut everything = mapped(&marks, &Mark::points).concat();
        for frame in [None].into_iter().chain(self.frames.iter().map(Some)) {
            for mark in marks_of_the_answer(&drawing, frame) {
                everything.extend(mark.points());
            }
        }
        // Some marks, such as dots, have a size in pixels and extend beyond their points. A border keeps them inside the picture.
        let eye = Eye::new(view, window.within(18.0), drawing.span, everything)?;
        marks.extend(marks_of_the_answer(&drawing, frame));
        let legend = Legend::new(&drawing, frame, eye.scale);
        let foot = top + STILL.room.1.max(legend.high() + STILL.axes_room);
        Ok(sheet((860.0, foot + STILL.margin), &mut |paper| {
            for (k, line) in title.iter().enumerate() {
                paper.text((18.0, 26.0 + 24.0 * k as f64), line, 20.0, 0.0, BLACK);
            }
            for (k, line) in label.iter().rev().enumerate() {
                paper.text((18.0, top - 14.0 - 20.0 * k as f64), line, 15.0, 0.0, GREY);
            }
            let mut painting = painting(&eye, &marks);
            painting.draw(paper);
            let mut labels = Labels::new(window, painting.ink());
            for mark in &marks {
                let (seen, words) = match &mark.shape {
                    MarkShape::Name { at, words } if mark.layer != Some(MarkLayer::Pointed) => {
                        (eye.to_view(at), words.as_str())
                    }
                    MarkShape::Load { from, along, name, otherwise, .. } => {
                        let ([_, tip], is_to_scale) = load_ends(&eye, from, along);
                        (tip, if is_to_scale { name.as_str() } else { otherwise.as_str() })
                    }
                    _ => continue,
                };
                if words.is_empty() {
                    continue;
                }
                labels.write(paper, (seen.x, seen.y), &[words], STILL.names);
            }
            let unnamed =
                if drawing.tips.len() > MARKS.most_named { drawing.tips.len() } else { labels.left_out };
            if unnamed > 0 {
                let words = format!("{unnamed} names have no room here");
                paper.text((window.left + 6.0, foot - 4.0), &words, 13.0, 0.0, GREY);
            }
            legend.draw(paper, top + 12.0);
            draw_axes(paper, &eye, (LEGEND.left + STILL.axes_room / 2.0, foot - STILL.axes_room / 2.0));
        }))
    }
}

/// Draws the coordinate axes in a corner without other marks.
fn draw_axes(paper: &mut Sheet, eye: &Eye, (x, y): PaperPoint) {
    let axes = [0, 1, 2].each(|axis| eye.along(axis));
    let mut named: Vec<Vector2<f64>> = Vec::new();
    for (axis, name) in axes.iter().zip(["x", "y", "z"]) {
        let end = axis * 32.0;
        paper.line(&[(x, y), (x + end.x, y + end.y)], GREY, 1.5);
        // An axis along the line of sight is a point; its name is written opposite to the other axes.
        let way = if axis.norm() > 0.2 { *axis } else { axis - axes.iter().sum::<Vector2<f64>>() };
        // The distance of the letters x, y and z from the ends of the axes, pixels.
        let off = 11.0;
        let way = way.normalize() * off;
        let mut place = end + way;
        while named.iter().any(|other| (other - place).norm() < off) {
            place += way;
        }
        named.push(place);
        paper.text((x + place.x, y + place.y), name, STILL.names, 0.5, BLACK);
    }
}
