//! The friction cone as a polygonal cone: `F_t` lies in μF_n times a polygon around the origin.
//!
//! In the plane the polygon is the interval [-1, 1], which is exact.

use alloc::sync::Arc;
use core::any::Any;
use core::f64::consts::TAU;

use nalgebra::SVector;

use super::tangential::cross;
use crate::error::Error;
use crate::numerics::{Each, Once, Space, mapped, numbered};
use crate::prelude::*;

/// Where the polygon of m facets lies relative to the unit circle, the section of the round cone at `μ F_n = 1`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "snake_case"))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub enum PolygonFit {
    /// Corners are on the circle: never more friction than on the round cone, and less by up to 1 - cos(π/m).
    #[default]
    Inscribed,
    /// Facets touch the circle: never less friction than on the round cone, and more by up to 1/cos(π/m) - 1.
    Circumscribed,
    /// Facets are as far inside the circle as corners outside: facets at the distance `cos(π/m)^(1/2)`, corners at its reciprocal.
    Balanced,
}

/// The polygonal cone that approximates the round friction cone in space. Planar grasps need no such polygon.
///
/// `F_t` lies in `μ F_n` times a regular polygon around the origin, with m facets normal to h_j and m corners d_j:
///
/// ```text
/// h_j·F_t <= μ F_n for all j      or      F_t = Σ β_j d_j,  β >= 0,  Σ β_j <= μ F_n
/// ```
///
/// Corner j lies at the angle `2πj/m` from the first tangent towards the second, facet normal j at `(2j - 1)π/m`, j from 0; h_j has the length that
/// puts the facet at `h_j·x = 1`. A contact with F_t on a facet slips along the normal of the facet. A contact with F_t at a corner slips between the
/// normals of the two facets (maximum dissipation over the polygon). Default: 8 facets, inscribed. See [choosing
/// facets](crate::guide::choosing_facets).
///
/// ```
/// use grasp_lcp::{Error, PolygonFit, PolygonCone};
///
/// let octagon = PolygonCone::new(8, PolygonFit::Inscribed)?;
/// assert_eq!(octagon, PolygonCone::default());
/// assert!(matches!(PolygonCone::new(2, PolygonFit::Inscribed), Err(Error::Facets { given: 2, .. })));
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct PolygonCone {
    facets: usize,
    fit: PolygonFit,
}

impl PolygonCone {
    /// Upper limit of the number of facets. With 4096 facets the polygon already differs from the circle by less than 3e-7 of its radius.
    pub const MOST_FACETS: usize = 4096;

    /// A polygonal cone with this number of facets.
    ///
    /// # Errors
    /// [`Error::Facets`] unless 3 <= facets <= [`Self::MOST_FACETS`].
    pub fn new(facets: usize, fit: PolygonFit) -> Result<Self, Error> {
        if (3..=Self::MOST_FACETS).contains(&facets) {
            Ok(Self { facets, fit })
        } else {
            Err(Error::Facets { given: facets, most: Self::MOST_FACETS })
        }
    }

    /// The square friction cone with corners on both tangents, at `|F_t| = μ F_n`.
    pub(crate) const fn square() -> Self {
        Self { facets: 4, fit: PolygonFit::Inscribed }
    }

    /// Number of facets of the cone, at least 3.
    #[must_use]
    pub fn facets(&self) -> usize {
        self.facets
    }

    /// Whether the polygon is inscribed in the circle of the round cone, circumscribed about it, or balanced between both.
    #[must_use]
    pub fn fit(&self) -> PolygonFit {
        self.fit
    }
}

impl Default for PolygonCone {
    fn default() -> Self {
        Self { facets: 8, fit: PolygonFit::Inscribed }
    }
}

/// The polygon in the frame of a contact: vectors with a zero normal component.
#[derive(Debug, Clone)]
pub(crate) struct Polygon {
    /// Facet normals h_j, scaled so that the facet is h_j·x = 1.
    pub(crate) normals: Vec<SVector<f64, 3>>,
    /// Corners d_j. In space corner j lies between facets j and j + 1; in the plane corner and facet j coincide.
    pub(crate) corners: Vec<SVector<f64, 3>>,
}

/// The polygons of the plane and of the default cone, computed once.
static SHARED: [Once<Arc<dyn Any + Send + Sync>>; 2] = [const { Once::new() }; 2];

impl Polygon {
    /// The polygon of a cone. The polygons of the plane and of the default cone are computed once and shared.
    pub(crate) fn shared(space: Space, cone: &PolygonCone) -> Arc<Self> {
        let made = || Arc::new(Self::new(space, cone));
        let position = match space {
            Space::Planar => 0,
            Space::Spatial if *cone == PolygonCone::default() => 1,
            Space::Spatial => return made(),
        };
        let shared = SHARED[position].get_or_init(|| made()).clone();
        shared.downcast().unwrap_or_else(|_| made())
    }

    pub(crate) fn new(space: Space, cone: &PolygonCone) -> Self {
        if space == Space::Planar {
            let sides = vec![in_the_tangent_plane(&[1.0]), in_the_tangent_plane(&[-1.0])];
            return Self { normals: sides.clone(), corners: sides };
        }
        let m = cone.facets;
        let half = TAU / (2.0 * m as f64);
        let facet_distance = match cone.fit {
            PolygonFit::Inscribed => half.cos(),
            PolygonFit::Circumscribed => 1.0,
            PolygonFit::Balanced => half.cos().sqrt(),
        };
        let corner_distance = facet_distance / half.cos();
        let ray = |half_turns: usize, length: f64| {
            let [cos, sin] = direction(half * half_turns as f64);
            in_the_tangent_plane(&[length * cos, length * sin])
        };
        Self {
            normals: numbered(m, &|j| ray((2 * j + 2 * m - 1) % (2 * m), 1.0 / facet_distance)),
            corners: numbered(m, &|j| ray(2 * j, corner_distance)),
        }
    }

    /// Whether this is the interval [-1, 1], the polygon of the plane.
    #[inline(always)]
    pub(crate) fn is_interval(&self) -> bool {
        self.normals.len() == 2
    }

    /// The polygon rotated so that its first corner points along a tangent direction of any nonzero length.
    pub(crate) fn turned_to(&self, to: &SVector<f64, 3>) -> Self {
        let (cos, sin) = (to[1] / to[1].hypot(to[2]), to[2] / to[1].hypot(to[2]));
        let turn =
            |v: &SVector<f64, 3>| in_the_tangent_plane(&[cos * v[1] - sin * v[2], sin * v[1] + cos * v[2]]);
        Self { normals: mapped(&self.normals, &turn), corners: mapped(&self.corners, &turn) }
    }
}

/// The corner p between two facets with normals h₁ and h₂: h₁·p = h₂·p = 1, without a normal component.
pub(crate) fn corner(h1: &SVector<f64, 3>, h2: &SVector<f64, 3>) -> SVector<f64, 3> {
    let turn = cross(h1, h2);
    let mut p = SVector::zeros();
    p[1] = (h2[2] - h1[2]) / turn;
    p[2] = (h1[1] - h2[1]) / turn;
    p
}

/// Cosine and sine of an angle, rad: the direction of a facet or corner in the tangent plane.
fn direction(angle: f64) -> [f64; 2] {
    let (sin, cos) = angle.sin_cos();
    // Cosines and sines below 1e-15 would be zero in exact arithmetic. If a cosine were 6e-17 instead of 0, facets that symmetric grasps reach
    // together would be reached one after the other.
    [cos, sin].each(|x| if x.abs() < 1e-15 { 0.0 } else { x })
}

fn in_the_tangent_plane(components: &[f64]) -> SVector<f64, 3> {
    let mut v = SVector::zeros();
    for (a, &x) in components.iter().enumerate() {
        v[a + 1] = x;
    }
    v
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn corners_lie_on_their_two_facets() {
        for fit in [PolygonFit::Inscribed, PolygonFit::Circumscribed, PolygonFit::Balanced] {
            for m in [3, 4, 7, 8, 64] {
                let polygon = Polygon::new(Space::Spatial, &PolygonCone { facets: m, fit });
                for j in 0..m {
                    for facet in [j, (j + 1) % m] {
                        assert!((polygon.normals[facet].dot(&polygon.corners[j]) - 1.0).abs() < 1e-14);
                    }
                    for normal in &polygon.normals {
                        assert!(normal.dot(&polygon.corners[j]) < 1.0 + 1e-14);
                    }
                }
                let (inner, outer) = (1.0 / polygon.normals[0].norm(), polygon.corners[0].norm());
                match fit {
                    PolygonFit::Inscribed => assert!((outer - 1.0).abs() < 1e-15),
                    PolygonFit::Circumscribed => assert!((inner - 1.0).abs() < 1e-15),
                    PolygonFit::Balanced => assert!((inner * outer - 1.0).abs() < 1e-14),
                }
            }
        }
    }
}
