//! One answer of a page as a picture that stands still.

use nalgebra::Vector2;
use plotters::style::colors::BLACK;

use super::drawing::Drawing;
use super::eye::{Eye, View};
use super::frame::Frame;
use super::legend::{self, Legend};
use super::marks::{Mark, marks};
use super::paint::painting;
use super::spatial_page::SpatialPage;
use crate::picture::error::PictureError;
use crate::picture::labels::Labels;
use crate::picture::palette::GREY;
use crate::picture::sheet::{Place, Sheet, sheet};
use crate::picture::window::Window;
use crate::picture::words::lines;

const WIDE: f64 = 860.0;
const MARGIN: f64 = 12.0;
/// Room for the grasp; a border of it is for what has a size in pixels.
const ROOM: (f64, f64) = (600.0, 520.0);
const BORDER: f64 = 18.0;
/// Letters of a line of the title and of the label.
const LETTERS: (usize, usize) = (70, 96);
/// Size of names.
const NAMES: f64 = 15.0;
/// Length of the coordinate axes, a letter beyond their ends, and room for both.
const AXES: f64 = 32.0;
const LETTER: f64 = 11.0;
const AXES_ROOM: f64 = 110.0;

impl SpatialPage {
    /// Draws one of the answers as it is seen from one side, as the page shows it, with a legend:
    /// `answer` counts them from 0 in the order in which they were given, `None` is the grasp
    /// alone. Scales of forces, moments, displacements and lengths are the same for all answers of
    /// the page seen from the same side, so that their pictures can be compared; everything of
    /// every answer is inside.
    ///
    /// A cone that would fill the picture (μ far above 1) is drawn shorter than the normal force in
    /// it.
    ///
    /// ```
    /// use grasp_lcp::picture::{SpatialPage, View};
    /// use grasp_lcp::spatial::{Contact, Grasp, Wrench};
    ///
    /// let finger = |x: f64| Contact::new([x, 0.0, 0.0], [-x, 0.0, 0.0]).series_stiffness(1000.0, 600.0).friction(0.5).command([0.004, 0.0, 0.0]);
    /// let grasp = Grasp::new([finger(-0.03), finger(0.03)])?;
    /// let page = SpatialPage::new(&grasp, "A pinch").outcome("0.5 N", &grasp.solve(&Wrench::force([0.0, 0.0, -0.5]))?);
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
    /// [`PictureError`] if there is no such answer, an angle of the view is not finite, or for the
    /// reasons of [`Self::to_html`].
    pub fn to_svg(&self, answer: Option<usize>, view: View) -> Result<String, PictureError> {
        let given = self.frames.len();
        let chosen = |k: usize| {
            let none =
                || PictureError(format!("there is no answer {k}: the page has {given}, counted from 0"));
            self.frames.get(k).ok_or_else(none)
        };
        let frame = answer.map(chosen).transpose()?;
        let drawing = Drawing::new(self)?;
        let title = lines(&self.title, LETTERS.0);
        let label = frame.map_or_else(Vec::new, |frame| lines(&frame.label, LETTERS.1));
        let top = 20.0 + 24.0 * title.len() as f64 + 20.0 * label.len() as f64;
        let window = Window { left: MARGIN, top, wide: ROOM.0, high: ROOM.1 };
        // Everything of every answer has room, so that stills can be compared.
        let states = self.frames.iter().map(Frame::state).chain([None]);
        let points = states.flat_map(|state| marks(&drawing, state)).flat_map(|mark| mark.points());
        let eye = Eye::new(view, window.within(BORDER), drawing.span, points)?;
        let marks = marks(&drawing, frame.and_then(Frame::state));
        let legend = Legend::new(&drawing, frame, eye.scale);
        let foot = top + ROOM.1.max(legend.high() + AXES_ROOM);
        Ok(sheet((WIDE, foot + MARGIN), |paper| {
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
                if let Mark::Name { at, words } = mark {
                    let seen = eye.see(at);
                    labels.write(paper, (seen.x, seen.y), &[words], NAMES);
                }
            }
            legend.draw(paper, top + 12.0);
            draw_axes(paper, &eye, (legend::LEFT + AXES_ROOM / 2.0, foot - AXES_ROOM / 2.0));
        }))
    }
}

/// The coordinate axes, in a corner where nothing else is drawn.
fn draw_axes(paper: &mut Sheet, eye: &Eye, (x, y): Place) {
    let axes = [0, 1, 2].map(|axis| eye.along(axis));
    let mut named: Vec<Vector2<f64>> = Vec::new();
    for (axis, name) in axes.iter().zip(["x", "y", "z"]) {
        let end = axis * AXES;
        paper.line([(x, y), (x + end.x, y + end.y)], GREY, 1.5);
        // An axis towards the eye is a point: its name goes where the others are not.
        let way = if axis.norm() > 0.2 { *axis } else { axis - axes.iter().sum::<Vector2<f64>>() };
        let way = way.normalize() * LETTER;
        let mut place = end + way;
        while named.iter().any(|other| (other - place).norm() < LETTER) {
            place += way;
        }
        named.push(place);
        paper.text((x + place.x, y + place.y), name, NAMES, 0.5, BLACK);
    }
}
