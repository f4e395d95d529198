//! The states of a contact: open, sticking, or sliding on a facet, at a corner or on the round cone.
//!
//! F is the contact force with the normal part F_n and the tangential part F_t, and μ the coefficient of friction. K is the stiffness matrix of the
//! contact's springs and v their stretch. h_j is the outward normal of facet j of a polygonal cone, and p a unit tangent.

use nalgebra::SVector;

use super::slide::Slide;

/// A state of a contact. R is the type that describes a slide on a round cone, for example by its direction.
///
/// | state | force | condition |
/// |---|---|---|
/// | open | `F = 0` | gap >= 0 |
/// | sticking | `F = K v` | force in the cone, no slip |
/// | facet j | `h_j·F_t = μ F_n` | slip along h_j; across it the spring still acts |
/// | corner j | F_t at the corner of facets j and j + 1 | slip direction between the normals of both facets |
/// | round | `F_t = μ F_n p` | slip along p |
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Mode<R> {
    Open,
    Sticking,
    /// The contact slides on one facet, given by its index among [`LocalLaw::facets`](super::LocalLaw::facets), counted from 0.
    Facet(u16),
    /// The contact slides at the corner between the facet with this index and the next facet; in space only.
    Corner(u16),
    Round(R),
}

/// A state on a polygonal or on the round cone.
pub(crate) type State = Mode<Slide>;

impl<R> Mode<R> {
    pub(crate) fn slides(&self) -> bool {
        matches!(self, Self::Facet(_) | Self::Corner(_) | Self::Round(_))
    }

    pub(crate) fn is_open(&self) -> bool {
        matches!(self, Self::Open)
    }

    pub(crate) fn is_sticking(&self) -> bool {
        matches!(self, Self::Sticking)
    }

    /// Whether both states are equal if the direction of a slide on the round cone is ignored.
    pub(crate) fn is_kind_of<Q>(&self, other: &Mode<Q>) -> bool {
        match (self, other) {
            (Self::Open, Mode::Open)
            | (Self::Sticking, Mode::Sticking)
            | (Self::Round(_), Mode::Round(_)) => true,
            (Self::Facet(a), Mode::Facet(b)) | (Self::Corner(a), Mode::Corner(b)) => a == b,
            _ => false,
        }
    }

    /// Indices (from 0) of the facets on which the contact slides, among `count` facets of the cone. There is one on a facet, two at a corner, and
    /// none in any other state.
    pub(crate) fn own_facets(&self, count: usize) -> [Option<usize>; 2] {
        match self {
            Self::Facet(j) => [Some(usize::from(*j)), None],
            Self::Corner(j) => [Some(usize::from(*j)), Some((usize::from(*j) + 1) % count)],
            Self::Open | Self::Sticking | Self::Round(_) => [None, None],
        }
    }
}

impl State {
    /// For a slide on the round cone its direction, and its slip per unit of friction force; `None` in any other state.
    pub(crate) fn slide(&self) -> Option<&Slide> {
        if let Self::Round(slide) = self { Some(slide) } else { None }
    }

    /// A slide on the round cone with friction along a tangent. Any earlier slip is already subtracted in the contact's offset (commanded
    /// displacement minus clearance and slip), so λ, the slip per unit of friction force, is 0.
    pub(crate) fn sliding_along(friction: &SVector<f64, 3>) -> Self {
        Self::Round(Slide::new(friction, 0.0))
    }
}
