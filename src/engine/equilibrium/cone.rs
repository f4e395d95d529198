//! The friction cone for which an answer is computed, and the limits up to which its motions count as small.

use nalgebra::SVector;

use crate::contact::{Polygon, PolygonCone};
use crate::grasp::{Engine, Space};
use crate::object::{Load, Problem};
use crate::prelude::*;
use crate::search::{Settings, SmallMotions};

#[derive(Debug, Clone, Copy)]
pub(crate) struct AnswerFor {
    pub(crate) cone: Cone,
    pub(crate) small: SmallMotions,
}

impl AnswerFor {
    /// The friction cone and the limits of small motions of equilibria that are computed with these settings.
    pub(crate) fn of(space: Space, settings: &Settings) -> Self {
        Self { cone: Cone::of(space, settings), small: settings.small_motions }
    }
}

/// The friction cone for which an answer was computed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "snake_case"))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub enum Cone {
    /// The friction cone in the plane. Two lines bound it (its facets), and it needs no approximation by a polygon.
    Planar,
    /// A polygonal cone that replaces the round cone in space.
    Polygon(PolygonCone),
    /// The round cone in space.
    Round,
}

impl Cone {
    /// The friction cone of equilibria that are computed with these settings: planar, round or polygonal.
    pub(crate) fn of(space: Space, settings: &Settings) -> Self {
        if settings.is_round(space) { Self::Round } else { Self::polygonal(space, settings) }
    }

    /// The polygonal cone of the settings; in the plane the exact cone.
    pub(crate) fn polygonal(space: Space, settings: &Settings) -> Self {
        if space == Space::Planar { Self::Planar } else { Self::Polygon(settings.cone) }
    }

    /// Number of facets of this cone in a complementarity problem: 2 in the plane. A round cone counts as one facet, the plane tangent to it at the
    /// friction force.
    pub(crate) fn facets(self) -> usize {
        match self {
            Self::Planar => 2,
            Self::Polygon(polygon) => polygon.facets(),
            Self::Round => 1,
        }
    }
}

impl Engine {
    /// The equilibrium problem of this grasp with this friction cone, load and finger offsets (commands minus clearances and slips).
    pub(crate) fn problem_on(&self, cone: Cone, offsets: Vec<SVector<f64, 3>>, load: &Load) -> Problem<'_> {
        let facets = if let Cone::Polygon(facets) = cone { facets } else { PolygonCone::default() };
        self.problem(Polygon::shared(self.space(), &facets), cone == Cone::Round, offsets, load)
    }
}
