//! The content of a page: a spatial grasp, outlines of the object and of fixtures, and answers.

use super::frame::{Frame, change_last};
use crate::grasp::Motion;
use crate::numerics::{Each, IntoList, mapped};
use crate::picture::actuators::Actuators;
use crate::spatial::{Equilibrium, Grasp, Outcome, Wrench};

/// A spatial grasp and one or more of its answers as a single self-contained HTML file without network or installation ([`Self::to_html`]).
/// [`Self::to_svg`] draws one of the answers from one side as an SVG, for paper.
///
/// On the page the picture is turned by dragging, enlarged by the wheel or two fingers and reset by a double click; buttons select an answer. It
/// shows, in the coordinates of the grasp (z upwards at first):
///
/// * contacts, coloured by their states, with friction cones as long as the normal forces in them;
/// * the force F on the object at each contact and the force of the load on its line of action. All answers have one scale, short enough that contact
///   forces do not pass through the object. A load that would be too short to be visible is drawn longer, and its label says so;
/// * for all points of a [soft fingertip](crate::spatial::SoftFingertip) one force and one cone, at their centre of pressure, and dots in the colours
///   of the states of the points;
/// * the moment of the load about that line (the whole moment of a load without force), with two heads. If the line is far from the grasp, the force
///   is drawn in the middle of the grasp, with the moment about that point;
/// * displacements u_c of the object with one magnification for all answers, which is written beside the picture;
/// * axes of the motions that no contact resists, and the object displaced along the motion by which it is lost;
/// * links of a [hand](crate::grasp::Hand) at their initial places, and its joints that yield at their limit.
///
/// A table on the page has the numbers of the answer shown, in N, m and rad; for a soft fingertip sums, and its points on request. On narrow screens
/// picture, legend and table are below each other.
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
/// let onset = grasp.onset(Wrench::force([0.0, 0.0, -1.0]))?;
/// let event = onset.event().ok_or("slides at some load")?;
///
/// let state = grasp.state_at_onset(event).ok_or("its own event")?;
/// let page = SpatialPage::new(&grasp, "A jar in three fingers")
///     .frame("onset of sliding", &state)
///     .outcome("twice as much", &grasp.solve(event.load * 2.0)?)
///     .to_html()?;
/// assert!(page.starts_with("<!DOCTYPE html>"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone)]
pub struct SpatialPage {
    pub(super) grasp: Grasp,
    pub(super) title: String,
    pub(super) outlines: Vec<MovingLine>,
    pub(super) fixtures: Vec<Vec<[f64; 3]>>,
    pub(super) frames: Vec<Frame<3>>,
    pub(super) actuators: Actuators,
}

/// A closed line on the object, or on one of several bodies, which moves with that body.
#[derive(Debug, Clone)]
pub(super) struct MovingLine {
    /// The index of the body; 0 if there is a single object.
    pub(super) body: usize,
    pub(super) corners: Vec<[f64; 3]>,
}

impl SpatialPage {
    /// A page without answers, which draws the grasp alone. Links of a hand are drawn at their initial places.
    #[must_use]
    pub fn new(grasp: &Grasp, title: impl Into<String>) -> Self {
        Self {
            grasp: grasp.clone(),
            title: title.into(),
            outlines: Vec::new(),
            fixtures: mapped(grasp.links(), &|bone| bone.each(<[f64; 3]>::from).to_vec()),
            frames: Vec::new(),
            actuators: Actuators::of(grasp),
        }
    }

    /// Adds a closed line on the object, corner by corner, m (two corners give the line between them). Several calls add several lines. They affect
    /// nothing but the drawing, which shows their original and moved places. The object is shaded between two consecutive lines of eight corners or
    /// more.
    #[must_use]
    pub fn outline(self, corners: impl IntoIterator<Item = impl Into<[f64; 3]>>) -> Self {
        self.body_outline(0, corners)
    }

    /// Adds a closed line on one of [several bodies](crate::grasp::Bodies), by its index from 0, which moves with that body. Otherwise as
    /// [`Self::outline`].
    #[must_use]
    pub fn body_outline(
        mut self,
        body: usize,
        corners: impl IntoIterator<Item = impl Into<[f64; 3]>>,
    ) -> Self {
        self.outlines.push(MovingLine { body, corners: corners.into_iter().map(Into::into).list() });
        self
    }

    /// Adds a closed line on something at rest, such as a fingertip or a table, corner by corner, m; otherwise as [`Self::outline`].
    #[must_use]
    pub fn fixture(mut self, corners: impl IntoIterator<Item = impl Into<[f64; 3]>>) -> Self {
        self.fixtures.push(corners.into_iter().map(Into::into).list());
        self
    }

    /// Adds an equilibrium of the grasp; `label` is written on its button. The first answer is shown initially.
    #[must_use]
    pub fn frame(mut self, label: impl Into<String>, state: &Equilibrium) -> Self {
        self.frames.push(Frame::new(label.into(), Ok(Box::new(state.clone()))));
        self
    }

    /// Adds an equilibrium of the same grasp with other coefficients of friction or other commands, such as those with the [needed
    /// amount](crate::ask::Grasp::with_amount).
    #[must_use]
    pub fn frame_of(mut self, label: impl Into<String>, grasp: &Grasp, state: &Equilibrium) -> Self {
        self.frames.push(Frame::of(label.into(), grasp, state));
        self
    }

    /// Adds an answer without an equilibrium, with the reason.
    #[must_use]
    pub fn nothing(mut self, label: impl Into<String>, why: impl Into<String>) -> Self {
        self.frames.push(Frame::new(label.into(), Err(why.into())));
        self
    }

    /// Adds a sentence beside the last answer.
    #[must_use]
    pub fn says(mut self, sentence: impl Into<String>) -> Self {
        change_last(&mut self.frames, |frame| frame.says.push(sentence.into()));
        self
    }

    /// Draws a motion of the object in the last answer, if there is one, such as that of a [loss](crate::hold::Lost::motion). Only the direction of the
    /// motion matters.
    #[must_use]
    pub fn maybe_leaving(mut self, motion: Option<&Motion<3>>) -> Self {
        change_last(&mut self.frames, |frame| frame.leaving = motion.cloned());
        self
    }

    /// Sets the load of the last answer. It is drawn if the answer has no equilibrium.
    #[must_use]
    pub fn under(mut self, load: Wrench) -> Self {
        change_last(&mut self.frames, |frame| frame.load = Some(load));
        self
    }

    /// Adds an answer of [`Grasp::solve`](crate::ask::Grasp::solve); `label` is written on its button. If no equilibrium exists, or none was found,
    /// the page says so and draws no forces.
    #[must_use]
    pub fn outcome(mut self, label: impl Into<String>, outcome: &Outcome) -> Self {
        let shown = match outcome {
            Outcome::Equilibrium(state) => Ok(state.clone()),
            other => Err(other.to_string()),
        };
        self.frames.push(Frame::new(label.into(), shown));
        self
    }

    /// The number of answers so far.
    #[must_use]
    pub fn answers(&self) -> usize {
        self.frames.len()
    }
}
