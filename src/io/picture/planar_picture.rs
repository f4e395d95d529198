//! The content of a picture of a planar grasp.

use std::borrow::Cow;

use crate::numerics::{IntoList, mapped};
use nalgebra::Vector2;

use super::error::PictureError;
use super::grasp_picture::Picture;
use crate::ask::Grasp;
use crate::equilibrium::Equilibrium;
use crate::grasp::{Face, Motion, Wrench, inside};
use crate::planar;

/// The outline of the object: corners (x, y) in order, m; the last corner is joined to the first. Outlines affect nothing but the drawing.
pub type Outline<'a> = &'a [[f64; 2]];

/// A picture of a planar grasp: add an answer to it, then call [`Self::to_svg`]. Without an equilibrium it shows the grasp alone, and the load if
/// given.
///
/// Arrows are forces on the object. They have one scale, short enough that no force passes through the object. Friction cones are 1.15 times as long
/// as the arrows of the normal forces in them. The load is drawn on its line of action, which is dashed. If that line does not pass near the grasp,
/// the force is drawn in the middle of the grasp, with its moment about that point as an arc. A load that is a moment alone is such an arc, too. If
/// the arrow of the load is too short to be visible, it is drawn longer, and its label says so. All points of a [soft
/// fingertip](crate::planar::SoftFingertip) have one force and one cone, at their centre of pressure. The points themselves are dots in the colours
/// of their states. Links of a [hand](crate::grasp::Hand) are drawn in the initial posture; joints and tendons whose torque or tension is at its
/// limit are marked. No name covers another name.
///
/// ```
/// use grasp_lcp::picture::PlanarPicture;
/// use grasp_lcp::planar::{Contact, Grasp, Wrench};
///
/// let finger = |x: f64| Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1000.0, 800.0).friction(0.5).command([0.01, 0.0]);
/// let grasp = Grasp::new([finger(-1.0), finger(1.0)])?;
/// let verdict = grasp.hold(Wrench::force([0.0, -20.0]))?;
///
/// let says = verdict.to_string();
/// let mut picture = PlanarPicture::new(&grasp, "A pinch").says(&says).outline(&[[-1.0, -0.5], [1.0, -0.5], [1.0, 0.5], [-1.0, 0.5]]);
/// if let Some(lost) = &verdict.lost {
///     picture = picture.maybe_state(lost.state.as_deref()).maybe_leaving(lost.motion.as_ref());
/// }
/// assert!(picture.to_svg()?.contains("SLIPS OUT at 10 N of 20 N"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone)]
#[must_use]
pub struct PlanarPicture<'a> {
    pub(super) grasp: Cow<'a, Grasp<3>>,
    pub(super) title: &'a str,
    pub(super) says: Vec<&'a str>,
    /// The outlines of the object, or of each of several bodies in order.
    pub(super) outlines: Vec<Vec<Vector2<f64>>>,
    pub(super) state: Option<Cow<'a, Equilibrium<3>>>,
    pub(super) load: Option<Wrench<3>>,
    pub(super) leaving: Option<Cow<'a, Motion<3>>>,
}

impl<'a> PlanarPicture<'a> {
    /// A picture of the grasp alone, with its title.
    pub fn new<const C: usize>(grasp: &'a Grasp<C>, title: &'a str) -> Self {
        let (grasp, says, outlines) = (inside(grasp), Vec::new(), Vec::new());
        Self { grasp, title, says, outlines, state: None, load: None, leaving: None }
    }

    /// Adds a sentence below the title, broken into lines.
    pub fn says(mut self, sentence: &'a str) -> Self {
        self.says.push(sentence);
        self
    }

    /// Draws the outline of the object.
    pub fn outline(self, corners: Outline) -> Self {
        self.outlines([corners])
    }

    /// Draws the outline of each of [several bodies](crate::grasp::Bodies), in order; an empty outline omits a body.
    pub fn outlines<'o>(mut self, outlines: impl IntoIterator<Item = Outline<'o>>) -> Self {
        let points = |corners: Outline| mapped(corners, &|corner| Vector2::from(*corner));
        self.outlines = outlines.into_iter().map(points).list();
        self
    }

    /// Draws the contact forces and the load of an equilibrium.
    pub fn state<const C: usize>(self, state: &'a Equilibrium<C>) -> Self {
        self.maybe_state(Some(state))
    }

    /// Draws the contact forces and the load of an equilibrium; draws neither if `state` is `None`.
    pub fn maybe_state<const C: usize>(mut self, state: Option<&'a Equilibrium<C>>) -> Self {
        self.state = state.map(inside);
        self
    }

    /// Sets the load that is drawn if there is no equilibrium.
    pub fn load<const C: usize>(mut self, load: Wrench<C>) -> Self {
        self.load = Some(load.into_inside());
        self
    }

    /// Draws a motion of the object, such as the motion with which it [leaves the grasp](crate::hold::Lost::motion); draws nothing for `None`. The
    /// outline, or else the contact points, are drawn displaced along the motion. The displacement is scaled until it is visible, so only the
    /// direction of the motion matters.
    pub fn maybe_leaving<const C: usize>(mut self, motion: Option<&'a Motion<C>>) -> Self {
        self.leaving = motion.map(inside);
        self
    }

    /// Draws the picture, 860 pixels wide.
    ///
    /// # Errors
    /// [`PictureError`] if equilibrium and grasp have different numbers of contacts, or if a corner of an outline is not finite. Also if a length or
    /// force is too large or too small to be drawn.
    pub fn to_svg(&self) -> Result<String, PictureError> {
        self.check()?;
        Picture::new(self).draw()
    }

    /// Checks that the equilibrium belongs to the grasp and all corners are finite.
    pub(super) fn check(&self) -> Result<(), PictureError> {
        let (expected, given) = (self.grasp.len(), self.state.as_ref().map(|state| state.contacts.len()));
        if let Some(given) = given.filter(|given| *given != expected) {
            return Err(PictureError(format!(
                "the equilibrium has {given} contacts, the grasp has {expected}"
            )));
        }
        if !self.outlines.concat().iter().all(|corner| corner.iter().all(|x| x.is_finite())) {
            return Err(PictureError("a corner of the outline is not finite".into()));
        }
        Ok(())
    }
}

/// Draws a grasp with its contact forces inside their friction cones: a [`PlanarPicture`] in one call.
///
/// ```
/// use grasp_lcp::picture::draw_grasp;
/// use grasp_lcp::planar::{Contact, Grasp, Wrench};
///
/// let finger = |x: f64| Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1000.0, 800.0).friction(0.5).command([0.01, 0.0]);
/// let grasp = Grasp::new([finger(-1.0), finger(1.0)])?;
/// let outcome = grasp.solve(Wrench::force([0.0, -6.0]))?;
/// let state = outcome.equilibrium().ok_or("it holds")?;
/// let svg = draw_grasp(&grasp, state, Some(&[[-1.0, -0.5], [1.0, -0.5], [1.0, 0.5], [-1.0, 0.5]]), "A pinch")?;
/// assert!(svg.starts_with("<svg"));
/// // The state of another grasp, or a corner that is nowhere, is no picture.
/// assert!(draw_grasp(&Grasp::new([finger(-1.0)])?, state, None, "A finger").is_err());
/// assert!(draw_grasp(&grasp, state, Some(&[[f64::INFINITY, 0.0]]), "A pinch").is_err());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`PictureError`] if equilibrium and grasp have different numbers of contacts, or if a corner of the outline is not finite. Also if a length or
/// force is too large or too small to be drawn.
pub fn draw_grasp(
    grasp: &planar::Grasp,
    state: &planar::Equilibrium,
    outline: Option<Outline>,
    title: &str,
) -> Result<String, PictureError> {
    PlanarPicture::new(grasp, title).state(state).outline(outline.unwrap_or_default()).to_svg()
}
