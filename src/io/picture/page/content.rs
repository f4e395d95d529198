//! The content of a page: a grasp, outlines of the object and of fixtures, and answers. A fixture is something that does not move, such as a table.

use super::frame::Frame;
use crate::ask::Grasp;
use crate::equilibrium::{Equilibrium, Outcome};
use crate::grasp::{Face, Motion, Wrench, inside};
use crate::numerics::{Each, IntoList, mapped};
use crate::picture::actuators::Actuators;

/// A grasp and one or more of its answers as a single self-contained HTML file without network or installation ([`Self::to_html`]). Buttons select an
/// answer, and so does a slider if there are more than two answers. [`Self::to_svg`] draws one of the answers as an SVG, for paper.
///
/// In the plane each picture is a [`PlanarPicture`](crate::picture::PlanarPicture), and all pictures have one scale, so that growing forces are
/// visible. In space the picture is turned by dragging, enlarged by the wheel or two fingers and reset by a double click. It then shows, in the
/// coordinates of the grasp (z upwards at first):
///
/// * contacts, coloured by their states, with friction cones 1.15 times as high as the arrows of the normal forces in them;
/// * the force F on the object at each contact and the force of the load on its line of action. All answers have one scale, short enough that contact
///   forces do not pass through the object. If the arrow of a load is too short to be visible, it is drawn longer, and its label says so;
/// * for all points of a [soft fingertip](crate::spatial::SoftFingertip) one force and one cone, at their centre of pressure, and dots in the colours
///   of the states of the points;
/// * the moment of the load about its line of action (the whole moment of a load without force), with two heads. If the line is far from the grasp,
///   the force is drawn in the middle of the grasp, with the moment about this point;
/// * displacements of the object at the contacts, with one magnification for all answers, which is written beside the picture;
/// * axes of the motions that no contact resists, and the object displaced along the motion with which it leaves the grasp;
/// * links of a [hand](crate::grasp::Hand) in the initial posture, and its joints whose torque is at its limit.
///
/// A table on the page has the numbers of the answer shown, in N, m and rad. For a soft fingertip it has sums, and the points on request. On narrow
/// screens picture, legend and table are below each other.
///
/// ```
/// use grasp_lcp::picture::Page;
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
/// let page = Page::new(&grasp, "A jar in three fingers")
///     .frame("onset of sliding", &state)
///     .outcome("twice as much", &grasp.solve(event.load * 2.0)?)
///     .to_html()?;
/// assert!(page.starts_with("<!DOCTYPE html>"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone)]
#[must_use]
pub struct Page {
    pub(super) grasp: Grasp<3>,
    pub(super) title: String,
    pub(super) outlines: Vec<MovingLine>,
    pub(super) fixtures: Vec<Vec<[f64; 3]>>,
    pub(super) frames: Vec<Frame>,
    pub(super) actuators: Actuators,
}

/// A closed line that moves with the object, or with one of several bodies.
#[derive(Debug, Clone)]
pub(super) struct MovingLine {
    /// The index of the body; 0 if there is a single object.
    pub(super) body: usize,
    pub(super) corners: Vec<[f64; 3]>,
}

impl Page {
    /// A page without answers, which draws the grasp alone. Links of a hand are drawn in the initial posture.
    pub fn new<const C: usize>(grasp: &Grasp<C>, title: impl Into<String>) -> Self {
        let grasp = inside(grasp);
        Self {
            title: title.into(),
            outlines: Vec::new(),
            fixtures: mapped(grasp.links(), &|bone| bone.each(<[f64; 3]>::from).to_vec()),
            frames: Vec::new(),
            actuators: Actuators::of(&grasp),
            grasp: grasp.into_owned(),
        }
    }

    /// Adds a closed line on the object, corner by corner, m. Two corners give the line between them; in the plane z is zero. Several calls add
    /// several lines. Lines affect nothing but the drawing, which shows them before and after the displacement of the object. The object is shaded
    /// between two consecutive lines of eight corners or more.
    pub fn outline(self, corners: impl IntoIterator<Item = impl Into<[f64; 3]>>) -> Self {
        self.body_outline(0, corners)
    }

    /// Adds a closed line that moves with one of [several bodies](crate::grasp::Bodies), corner by corner, m; `body` is the index of this body, from
    /// 0. In the plane z is zero. As with [`Self::outline`], two corners give the line between them, and several calls add several lines.
    pub fn body_outline(
        mut self,
        body: usize,
        corners: impl IntoIterator<Item = impl Into<[f64; 3]>>,
    ) -> Self {
        self.outlines.push(MovingLine { body, corners: corners.into_iter().map(Into::into).list() });
        self
    }

    /// Adds a closed line on something that does not move, such as a fingertip or a table, corner by corner, m. In the plane z is zero. Two corners
    /// give the line between them, and several calls add several lines.
    pub fn fixture(mut self, corners: impl IntoIterator<Item = impl Into<[f64; 3]>>) -> Self {
        self.fixtures.push(corners.into_iter().map(Into::into).list());
        self
    }

    /// Adds an equilibrium of the grasp as an answer; `label` is written on the button that selects this answer. The first answer is shown initially.
    pub fn frame<const C: usize>(self, label: impl Into<String>, state: &Equilibrium<C>) -> Self {
        self.with(Frame::new(label.into(), Ok(state.to_inside())))
    }

    /// Adds an equilibrium of the same grasp with other coefficients of friction or other commands, such as the grasp with the [needed
    /// amount](crate::ask::Grasp::with_amount).
    pub fn frame_of<const C: usize>(
        self,
        label: impl Into<String>,
        grasp: &Grasp<C>,
        state: &Equilibrium<C>,
    ) -> Self {
        let frame = Frame::new(label.into(), Ok(state.to_inside()));
        self.with(Frame { grasp: Some(grasp.to_inside()), ..frame })
    }

    /// Adds an answer without an equilibrium. The page shows the sentence `why` in its place.
    pub fn nothing(self, label: impl Into<String>, why: impl Into<String>) -> Self {
        self.with(Frame::new(label.into(), Err(why.into())))
    }

    /// Adds a sentence that is shown with the answer that was added last.
    pub fn says(self, sentence: impl Into<String>) -> Self {
        self.with_last(|frame| frame.says.push(sentence.into()))
    }

    /// Draws a motion of the object in the answer that was added last, such as the motion with which it [leaves the
    /// grasp](crate::hold::Lost::motion); draws nothing for `None`. The displacement is scaled until it is visible, so only the direction of the
    /// motion matters.
    pub fn maybe_leaving<const C: usize>(self, motion: Option<&Motion<C>>) -> Self {
        self.with_last(|frame| frame.leaving = motion.map(Face::to_inside))
    }

    /// Sets the load of the answer that was added last. This load is drawn if the answer has no equilibrium.
    pub fn under<const C: usize>(self, load: Wrench<C>) -> Self {
        self.with_last(|frame| frame.load = Some(load.into_inside()))
    }

    /// Adds an answer of [`Grasp::solve`](crate::ask::Grasp::solve); `label` is written on the button that selects the answer. If no equilibrium
    /// exists, or none was found, the page says so and draws no forces.
    pub fn outcome<const C: usize>(self, label: impl Into<String>, outcome: &Outcome<C>) -> Self {
        let shown = match outcome {
            Outcome::Equilibrium(state) => Ok(state.as_ref().to_inside()),
            other => Err(other.to_string()),
        };
        self.with(Frame::new(label.into(), shown))
    }

    fn with(mut self, frame: Frame) -> Self {
        self.frames.push(frame);
        self
    }

    /// Applies `change` to the answer that was added last; a page without answers stays as it is.
    fn with_last(mut self, change: impl FnOnce(&mut Frame)) -> Self {
        if let Some(frame) = self.frames.last_mut() {
            change(frame);
        }
        self
    }

    /// The number of answers so far.
    #[must_use]
    pub fn answers(&self) -> usize {
        self.frames.len()
    }
}
