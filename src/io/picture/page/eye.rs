//! The eye: the direction from which a grasp is seen, and the projection of its points onto paper.

use crate::numerics::Each;
use std::f64::consts::FRAC_PI_2;

use nalgebra::{Vector2, Vector3};

use crate::picture::error::PictureError;
use crate::picture::window::Window;

/// The direction from which a spatial grasp is seen. The eye is at infinity, so that parallel lines stay parallel, and the centre of the grasp is in
/// the middle of the picture. The z axis points upwards on paper unless it points to the eye.
///
/// With yaw and pitch zero the eye is on the side of −y: x points to the right, z upwards. `yaw` turns the eye around z, counterclockwise seen from
/// above. `pitch` then raises it. Both are in rad. The direction from the grasp to the eye is
///
/// ```text
/// (sin yaw cos pitch, −cos yaw cos pitch, sin pitch)
/// ```
///
/// The default is the initial view of the [page](super::Page::to_html): yaw −0.6, pitch 0.45.
///
/// ```
/// use grasp_lcp::picture::View;
///
/// // Ten degrees to the right of the front, a little from above.
/// let view = View::FRONT.with_yaw(10f64.to_radians()).with_pitch(0.2);
/// assert_eq!(view.pitch, 0.2);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
#[must_use]
pub struct View {
    /// Turn of the eye around z, from −y towards x, rad.
    pub yaw: f64,
    /// Angle of the eye above the plane of x and y, rad.
    pub pitch: f64,
}

impl View {
    /// Seen from −y: x to the right, z upwards.
    pub const FRONT: Self = Self { yaw: 0.0, pitch: 0.0 };
    /// Seen from x: y to the right, z upwards.
    pub const RIGHT: Self = Self { yaw: FRAC_PI_2, pitch: 0.0 };
    /// Seen from z: x to the right, y upwards.
    pub const ABOVE: Self = Self { yaw: 0.0, pitch: FRAC_PI_2 };

    setters! {
        /// Sets the turn of the eye around z, rad.
        pub fn with_yaw(mut self, yaw: f64) { self.yaw = yaw; }

        /// Sets the angle of the eye above the plane of x and y, rad.
        pub fn with_pitch(mut self, pitch: f64) { self.pitch = pitch; }
    }
}

impl Default for View {
    fn default() -> Self {
        Self { yaw: -0.6, pitch: 0.45 }
    }
}

/// A parallel projection of points in space onto paper, in pixels.
pub(super) struct Eye {
    /// Unit vector, in space, that points to the right on paper.
    right: Vector3<f64>,
    /// Unit vector, in space, that points up on paper.
    up: Vector3<f64>,
    /// Unit vector, in space, that points out of the paper towards the eye.
    towards: Vector3<f64>,
    /// The point of space, m, that is drawn in the middle of the window.
    target: Vector3<f64>,
    window: Window,
    /// Scale of the projection: pixels per metre.
    pub(super) scale: f64,
}

impl Eye {
    /// The projection with the largest scale that meets two conditions: all points lie inside the window, and a line of the length `span`, m, is not
    /// longer than the window.
    pub(super) fn new(
        view: View,
        window: Window,
        span: f64,
        points: impl IntoIterator<Item = Vector3<f64>>,
    ) -> Result<Self, PictureError> {
        let View { yaw, pitch } = view;
        if !(yaw.is_finite() && pitch.is_finite()) {
            return Err(PictureError(format!("a view of yaw {yaw} and pitch {pitch}: both must be finite")));
        }
        let ((sy, cy), (sp, cp)) = (yaw.sin_cos(), pitch.sin_cos());
        let (right, towards) = (Vector3::new(cy, sy, 0.0), Vector3::new(sy * cp, -cy * cp, sp));
        let axes = [right, towards.cross(&right), towards];
        let (mut low, mut high) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
        let mut drawable = true;
        for point in points {
            for (k, axis) in axes.iter().enumerate() {
                let along = axis.dot(&point);
                drawable &= along.is_finite();
                (low[k], high[k]) = (low[k].min(along), high[k].max(along));
            }
        }
        let [wide, tall] = [0, 1].each(|k| high[k] - low[k]);
        let metres = (wide / window.wide).max(tall / window.high).max(span / window.wide.max(window.high));
        let scale = 1.0 / metres;
        let middle = [0, 1, 2].each(|k| axes[k] * (low[k] / 2.0 + high[k] / 2.0));
        let target = middle[0] + middle[1] + middle[2];
        if !(drawable && scale.is_finite() && scale > 0.0 && target.iter().all(|x| x.is_finite())) {
            return Err(PictureError("a length is too large or too small to be drawn".into()));
        }
        let [right, up, towards] = axes;
        Ok(Self { right, up, towards, target, window, scale })
    }

    /// The projection of a point: pixels to the right and downwards on paper, and its depth towards the eye, pixels.
    pub(super) fn to_view(&self, point: &Vector3<f64>) -> Vector3<f64> {
        let (x, y) = self.window.middle();
        let away = point - self.target;
        let [right, up, towards] =
            [self.right, self.up, self.towards].each(|axis| self.scale * axis.dot(&away));
        Vector3::new(x + right, y - up, towards)
    }

    /// The unit vector along a coordinate axis, projected onto paper: its components to the right and downwards.
    pub(super) fn along(&self, axis: usize) -> Vector2<f64> {
        Vector2::new(self.right[axis], -self.up[axis])
    }
}
