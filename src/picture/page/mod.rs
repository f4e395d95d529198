//! A spatial grasp as a page that one can turn with the mouse, and as a picture that stands still.

mod data;
mod drawing;
mod eye;
mod labels;
mod legend;
mod marks;
mod paint;
mod still;
mod table;
mod text;

use std::fmt::Write;

use self::drawing::Drawing;
pub use self::eye::View;
use self::text::html;
use super::PictureError;
use crate::spatial::{Equilibrium, Grasp, NoEquilibrium, Outcome};

/// A spatial grasp and one or more of its answers as a single HTML file that needs nothing else: no network, no installation
/// ([`Self::to_html`]); or one of the answers from one side as an SVG, for paper ([`Self::to_svg`]).
///
/// On the page the picture is turned by dragging, enlarged by the wheel and reset by a double click; buttons choose among the answers. Drawn are, in
/// the coordinates of the grasp (z upwards to begin with):
///
/// * contacts, coloured by what they do, with friction cones as long as the normal forces in them;
/// * the force F on the object at each contact and the force of the load on its line of action, at one scale for all answers;
/// * the moment of the load about that line (of a load without force: its whole moment), with two heads;
/// * displacements u_c of the object, magnified, the same for all answers; the factor is written beside;
/// * axes of the motions that no contact resists.
///
/// A table on the page has the numbers of the answer shown, in N, m and rad.
///
/// ```
/// use grasp_lcp::picture::SpatialPage;
/// use grasp_lcp::spatial::{Contact, Grasp, Wrench};
///
/// // Three fingers around a jar of 60 mm.
/// let finger = |name: &str, degrees: f64| {
///     let (sin, cos) = degrees.to_radians().sin_cos();
///     Contact::new([0.03 * cos, 0.03 * sin, 0.0], [-cos, -sin, 0.0])
///         .name(name)
///         .series_stiffness(1000.0, 600.0)
///         .friction(0.5)
///         .command([0.004, 0.0, 0.0])
/// };
/// let grasp = Grasp::new([finger("thumb", 180.0), finger("index", 60.0), finger("middle", -60.0)])?;
/// let onset = grasp.onset_of_sliding(Wrench::ZERO, Wrench::force([0.0, 0.0, -1.0]))?;
/// let event = onset.event().ok_or("slides at some load")?;
///
/// let page = SpatialPage::new(&grasp, "A jar in three fingers")
///     .frame("onset of sliding", &event.state)
///     .outcome("twice as much", &grasp.solve(&(event.load * 2.0))?)
///     .to_html()?;
/// assert!(page.starts_with("<!DOCTYPE html>"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone)]
pub struct SpatialPage {
    grasp: Grasp,
    title: String,
    outlines: Vec<Vec<[f64; 3]>>,
    fixtures: Vec<Vec<[f64; 3]>>,
    frames: Vec<Frame>,
}

/// One of the answers between which the buttons choose.
#[derive(Debug, Clone)]
struct Frame {
    label: String,
    shown: Shown,
}

#[derive(Debug, Clone)]
enum Shown {
    State(Box<Equilibrium>),
    /// Contacts without forces, and why.
    Nothing(String),
}

impl SpatialPage {
    /// A page without answers yet. The grasp alone can be drawn, too.
    #[must_use]
    pub fn new(grasp: &Grasp, title: impl Into<String>) -> Self {
        Self {
            grasp: grasp.clone(),
            title: title.into(),
            outlines: Vec::new(),
            fixtures: Vec::new(),
            frames: Vec::new(),
        }
    }

    /// A closed line on the object, corner by corner, m (of two corners: the line between them); call it for as many as it takes. They are only drawn, where the object was
    /// and where it moves.
    #[must_use]
    pub fn outline(mut self, corners: impl Into<Vec<[f64; 3]>>) -> Self {
        self.outlines.push(corners.into());
        self
    }

    /// A closed line on something that stays where it is, a fingertip or a table, corner by corner, m; otherwise as [`Self::outline`].
    #[must_use]
    pub fn fixture(mut self, corners: impl Into<Vec<[f64; 3]>>) -> Self {
        self.fixtures.push(corners.into());
        self
    }

    /// An equilibrium of the grasp, with what its button says; the first answer is shown to begin with.
    #[must_use]
    pub fn frame(mut self, label: impl Into<String>, state: &Equilibrium) -> Self {
        let shown = Shown::State(Box::new(state.clone()));
        self.frames.push(Frame { label: label.into(), shown });
        self
    }

    /// An answer of [`Grasp::solve`](crate::grasp::Grasp::solve), with what its button says. Where no equilibrium exists, or none was found, the page
    /// says so and draws no forces.
    #[must_use]
    pub fn outcome(mut self, label: impl Into<String>, outcome: &Outcome) -> Self {
        let shown = match outcome {
            Outcome::Equilibrium(state) => Shown::State(state.clone()),
            Outcome::NoEquilibrium(NoEquilibrium { proof }) => {
                Shown::Nothing(format!("No equilibrium exists. Proof: {}.", text::proof(proof)))
            }
            Outcome::Undecided(undecided) => Shown::Nothing(format!(
                "Undecided: no equilibrium was found and none was ruled out ({:?}).",
                undecided.doubt
            )),
        };
        self.frames.push(Frame { label: label.into(), shown });
        self
    }

    /// How many answers were given so far.
    #[must_use]
    pub fn answers(&self) -> usize {
        self.frames.len()
    }

    /// Writes the page. Names and labels may contain any characters.
    ///
    /// # Errors
    /// [`PictureError`] if a corner of the outline is not finite, a number of an answer that must be drawn is not, or an answer has not as many contacts as the
    /// grasp.
    pub fn to_html(&self) -> Result<String, PictureError> {
        let drawing = Drawing::new(self)?;
        let title = html(&self.title);
        let scales = drawing.scales(self.frames.iter().filter_map(Frame::state)).join(" ");
        let mut page = String::new();
        page += "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n";
        page += "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n";
        // Strings take whatever is written into them.
        let _ = write!(page, "<title>{title}</title>\n<style>\n{STYLE}</style>\n</head>\n<body>\n");
        let _ = writeln!(page, "<h1>{title}</h1>\n<main>\n<div id=\"picture\">");
        let _ = writeln!(
            page,
            "<canvas id=\"view\" tabindex=\"0\" role=\"img\" aria-label=\"{title}; the numbers are in the table\"></canvas>"
        );
        page +=
            "<p class=\"hint\">Drag to turn, wheel to enlarge, double click to reset.</p>\n</div>\n<aside>\n";
        self.write_buttons(&mut page);
        page += LEGEND;
        let _ = writeln!(page, "<p class=\"scale\">{}</p>\n</aside>\n</main>", html(&scales));
        table::write(&mut page, &self.grasp, &self.frames)?;
        let _ = writeln!(page, "<script type=\"application/json\" id=\"grasp\">{}</script>", drawing.json()?);
        let _ = write!(page, "<script>\n{VIEW}</script>\n</body>\n</html>\n");
        Ok(page)
    }

    /// Draws one of the answers as it is seen from one side, as the page shows it, with a legend: `answer` counts them from 0 in the order in which they
    /// were given, `None` is the grasp alone. Scales of forces, moments, displacements and lengths are the same for all answers of the
    /// page seen from the same side, so that their pictures can be compared; everything of every answer is inside.
    ///
    /// A cone that would fill the picture (μ far above 1) is drawn shorter than the normal force in it.
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
    /// [`PictureError`] if there is no such answer, an angle of the view is not finite, for the reasons of [`Self::to_html`], or if the back end fails.
    pub fn to_svg(&self, answer: Option<usize>, view: View) -> Result<String, PictureError> {
        still::draw(self, answer, view)
    }

    fn write_buttons(&self, page: &mut String) {
        if self.frames.len() < 2 {
            return;
        }
        page.push_str("<div id=\"frames\">");
        for (k, frame) in self.frames.iter().enumerate() {
            let pressed = k == 0;
            let label = html(&frame.label);
            let _ = write!(
                page,
                "<button type=\"button\" data-frame=\"{k}\" aria-pressed=\"{pressed}\">{label}</button>"
            );
        }
        page.push_str("</div>\n");
    }
}

const STYLE: &str = include_str!("style.css");
const VIEW: &str = include_str!("view.js");
const LEGEND: &str = include_str!("legend.html");
