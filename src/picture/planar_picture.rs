//! What a picture of a planar grasp shows.

use nalgebra::Vector2;

use super::error::PictureError;
use super::grasp_picture::Picture;
use crate::grasp::Motion;
use crate::planar::{Equilibrium, Grasp, Wrench};

/// The outline of the object: corners (x, y) in order, m; the last is joined to the first. It is
/// only drawn.
pub type Outline<'a> = &'a [[f64; 2]];

/// A planar grasp on paper; build it up, then [`Self::to_svg`]. Without an equilibrium the grasp alone is drawn, and the load if it is given.
///
/// Arrows are forces on the object, at one scale, so short that they do not go through it; friction cones are a little longer than the
/// normal forces in them. The load is drawn on its line of action, which is dashed. Where that line passes the grasp by, or the load is a
/// moment alone, its force is drawn in the middle of the grasp and its moment about that point as an arc. A force of the load that would be
/// too short to be seen is drawn longer, and that is said beside it. All points of a [soft fingertip](crate::planar::SoftFingertip) have one
/// force and one cone, at their centre of pressure; dots are the points, in the colours of what they do. Links of a
/// [hand](crate::grasp::Hand) are drawn where they were before anything moved; joints and tendons that yield at their limit are marked. No
/// name covers another.
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
pub struct PlanarPicture<'a> {
    pub(super) grasp: &'a Grasp,
    pub(super) title: &'a str,
    pub(super) says: Vec<&'a str>,
    /// Of the object, or of each of several bodies in their order.
    pub(super) outlines: Vec<Vec<Vector2<f64>>>,
    pub(super) state: Option<&'a Equilibrium>,
    pub(super) load: Option<Wrench>,
    pub(super) leaving: Option<&'a Motion<2>>,
}

impl<'a> PlanarPicture<'a> {
    /// A picture of the grasp alone, with its title.
    #[must_use]
    pub fn new(grasp: &'a Grasp, title: &'a str) -> Self {
        Self { grasp, title, says: Vec::new(), outlines: Vec::new(), state: None, load: None, leaving: None }
    }

    /// Adds a sentence below the title, in as many lines as it takes.
    #[must_use]
    pub fn says(mut self, sentence: &'a str) -> Self {
        self.says.push(sentence);
        self
    }

    /// Draws the object.
    #[must_use]
    pub fn outline(self, corners: Outline) -> Self {
        self.outlines([corners])
    }

    /// Draws each of [several bodies](crate::grasp::Bodies), in their order; an empty list for one that is not drawn.
    #[must_use]
    pub fn outlines<'o>(mut self, outlines: impl IntoIterator<Item = Outline<'o>>) -> Self {
        let points = |corners: Outline| corners.iter().map(|corner| Vector2::from(*corner)).collect();
        self.outlines = outlines.into_iter().map(points).collect();
        self
    }

    /// Draws the forces of an equilibrium and its load.
    #[must_use]
    pub fn state(self, state: &'a Equilibrium) -> Self {
        self.maybe_state(Some(state))
    }

    /// Draws the forces of an equilibrium if there is one.
    #[must_use]
    pub fn maybe_state(mut self, state: Option<&'a Equilibrium>) -> Self {
        self.state = state;
        self
    }

    /// The load to be drawn where there is no equilibrium.
    #[must_use]
    pub fn load(mut self, load: Wrench) -> Self {
        self.load = Some(load);
        self
    }

    /// Draws the way the object takes with a motion, if there is one, such as that of a [loss](crate::hold::Lost::motion): where the outline,
    /// or the contact points, would be next. Of the motion only its direction counts.
    #[must_use]
    pub fn maybe_leaving(mut self, motion: Option<&'a Motion<2>>) -> Self {
        self.leaving = motion;
        self
    }

    /// Draws it, 860 pixels wide.
    ///
    /// # Errors
    /// [`PictureError`] if the equilibrium has not as many contacts as the grasp, or if a corner of the
    /// outline is not finite. Also if a length or force is too large or too small to be drawn.
    pub fn to_svg(&self) -> Result<String, PictureError> {
        self.check()?;
        Picture::new(self).draw()
    }

    /// Whether it can be drawn.
    pub(super) fn check(&self) -> Result<(), PictureError> {
        let (expected, given) = (self.grasp.len(), self.state.map(|state| state.contacts.len()));
        if let Some(given) = given.filter(|given| *given != expected) {
            return Err(PictureError(format!(
                "the equilibrium has {given} contacts, the grasp has {expected}"
            )));
        }
        if !self.outlines.iter().flatten().flatten().all(|x| x.is_finite()) {
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
/// let outcome = grasp.solve(&Wrench::force([0.0, -6.0]))?;
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
/// As for [`PlanarPicture::to_svg`].
pub fn draw_grasp(
    grasp: &Grasp,
    state: &Equilibrium,
    outline: Option<Outline>,
    title: &str,
) -> Result<String, PictureError> {
    PlanarPicture::new(grasp, title).state(state).outline(outline.unwrap_or_default()).to_svg()
}
