//! Distinction between the plane and space.

/// Plane or space as a run-time value, so that code for both is compiled once.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Space {
    /// Two axes and one rotation.
    Planar,
    /// Three axes and three rotations.
    Spatial,
}

impl Space {
    /// The space in which points have `C` coordinates.
    pub(crate) const fn of<const C: usize>() -> Self {
        if C == 2 { Self::Planar } else { Self::Spatial }
    }

    /// Name of the space in JSON: "planar" or "spatial".
    #[cfg(feature = "json")]
    pub(crate) const fn name(self) -> &'static str {
        match self {
            Self::Planar => "planar",
            Self::Spatial => "spatial",
        }
    }

    /// Number of axes of a contact frame, which is the number of coordinates of a point: 2 or 3.
    pub(crate) const fn axes(self) -> usize {
        match self {
            Self::Planar => 2,
            Self::Spatial => 3,
        }
    }

    /// Number of coordinates of the object: translations, then rotations. The coordinates of joints follow.
    pub(crate) const fn of_the_object(self) -> usize {
        self.axes() + self.planes().len()
    }

    /// The coordinate planes in which rotations take place, as pairs of axis indices from 0. A positive rotation turns the first axis towards the
    /// second.
    pub(crate) const fn planes(self) -> &'static [(usize, usize)] {
        match self {
            Self::Planar => &[(0, 1)],
            Self::Spatial => &[(1, 2), (2, 0), (0, 1)],
        }
    }

    /// For each coordinate of the object, its index (from 0) among the components of a `Wrench<C>` or a `Twist<C>`.
    pub(crate) const fn components<const C: usize>(self) -> &'static [usize] {
        match self {
            Self::Planar if C == 3 => &[0, 1, 5],
            Self::Planar => &[0, 1, 2],
            Self::Spatial => &[0, 1, 2, 3, 4, 5],
        }
    }
}
