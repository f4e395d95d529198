//! A rectangle of the paper in which something is drawn.

use super::sheet::PaperPoint;

/// A rectangle on the paper: distances from its upper left corner, and size, pixels.
#[derive(Debug, Clone, Copy)]
pub(super) struct Window {
    pub(super) left: f64,
    pub(super) top: f64,
    pub(super) wide: f64,
    pub(super) high: f64,
}

impl Window {
    /// The window less a border on all sides.
    pub(super) fn within(&self, border: f64) -> Self {
        let Self { left, top, wide, high } = *self;
        Self { left: left + border, top: top + border, wide: wide - 2.0 * border, high: high - 2.0 * border }
    }

    pub(super) fn middle(&self) -> PaperPoint {
        (self.left + self.wide / 2.0, self.top + self.high / 2.0)
    }
}
