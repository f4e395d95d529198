//! Force and tangent stiffness of a contact with Tresca friction, as functions of the stretch (deformation plus slip) of its springs. The limit of
//! Tresca friction, N, is independent of the normal force.

use nalgebra::{SMatrix, SVector};

use crate::contact::{Coulomb, Law, LocalLaw, Mode, tangential, tangential_norm};
use crate::numerics::unit;
use crate::prelude::*;

/// A contact with Tresca friction: the friction limit is a number, given to [`Self::answer`], independent of the normal force.
pub(super) struct Limited {
    pub(super) stiffness: SVector<f64, 3>,
    pub(super) offset: SVector<f64, 3>,
    opens: bool,
    slides: SlideDirections,
    cone: Coulomb,
    /// True for a contact on the boundary of its cone in a rate problem, whose unknowns are rates along a load path. The friction limit is then the
    /// rate of the actual limit, and may be negative.
    is_rate: bool,
}

/// The directions in which a contact may slide, according to the shape of its friction cone.
enum SlideDirections {
    Never,
    /// In the plane: two facets of the friction cone, by index. The first limits friction along -t, the second along +t, with the tangent t of the
    /// contact frame. `None` if there is no such facet, so that friction in this direction has no limit.
    Along([Option<u16>; 2]),
    /// In space: the contact may slide on the facets `h·F_t = r` of a polygonal friction cone, with outward normals h and the friction limit r.
    /// `corners` are the corners of the polygon for r = 1.
    OnPolygon {
        normals: Vec<SVector<f64, 3>>,
        corners: Vec<SVector<f64, 3>>,
    },
    /// In space: the contact may slide in any tangential direction, on the round friction cone.
    Round,
}

/// Friction force, tangent stiffness and contact state of a contact whose friction is at its limit.
struct AtLimit {
    friction: SVector<f64, 3>,
    /// Stiffness in the tangential directions in which friction still changes with the stretch, N/m.
    tangent: SMatrix<f64, 3, 3>,
    state: Mode<u16>,
}

/// Response of a contact to a stretch of its springs, for a given friction limit: contact force, tangent stiffness and contact state.
pub(super) struct LimitedAnswer {
    pub(super) force: SVector<f64, 3>,
    /// Tangent stiffness, the derivative of `force` with respect to the stretch, N/m.
    pub(super) tangent: SMatrix<f64, 3, 3>,
    /// The spring stiffness minus the tangent stiffness, N/m: the part that is lost because the contact slides or opens.
    pub(super) lost_stiffness: SMatrix<f64, 3, 3>,
    pub(super) state: Mode<u16>,
}

impl Limited {
    /// The contact with its polygonal friction cone if `on_polygons` is true, otherwise with its round cone. `None` in two cases that Tresca friction
    /// does not cover. The first is a contact that may open but never slides. The second, in space, is a contact on the boundary of its cone in a
    /// rate problem (for derivatives along a load path).
    pub(super) fn of(local: &LocalLaw<'_>, offset: &SVector<f64, 3>, on_polygons: bool) -> Option<Self> {
        let (offset, cone) = (*offset, local.cone());
        if local.is_absent() {
            let (stiffness, slides) = (SVector::zeros(), SlideDirections::Never);
            return Some(Self { stiffness, offset, opens: false, slides, cone, is_rate: false });
        }
        let facet =
            |sign: f64| (0_u16..).zip(local.facets()).find(|(_, h)| sign * h[1] > 0.0).map(|(j, _)| j);
        let (stiffness, opens) = (local.springs.diagonal(), local.may_open());
        let slides = match [facet(-1.0), facet(1.0)] {
            _ if local.is_round() && !on_polygons => SlideDirections::Round,
            _ if !local.is_planar() && !local.facets().is_empty() => SlideDirections::OnPolygon {
                normals: local.facets().to_vec(),
                corners: local.polygon.corners.clone(),
            },
            [None, None] => SlideDirections::Never,
            facets => SlideDirections::Along(facets),
        };
        let keeps = opens && stiffness[1] > 0.0 && matches!(slides, SlideDirections::Never);
        let is_rate = matches!(local.law, Law::Edge(_));
        // In a rate problem single facets limit the force of a contact on the boundary of its cone. In space they form neither a complete polygon nor
        // a round cone, one of which is necessary here.
        (!keeps && (local.is_planar() || !is_rate)).then_some(Self {
            stiffness,
            offset,
            opens,
            slides,
            cone,
            is_rate,
        })
    }

    pub(super) fn answer(&self, stretch: &SVector<f64, 3>, limit: f64) -> LimitedAnswer {
        let springs = SMatrix::from_diagonal(&self.stiffness);
        let mut answer = LimitedAnswer {
            force: springs * stretch,
            tangent: springs,
            lost_stiffness: SMatrix::zeros(),
            state: Mode::Sticking,
        };
        if let Some(AtLimit { friction, tangent, state }) = self.at_limit(&answer.force, limit) {
            let normal = answer.force[0];
            answer.force = friction;
            answer.force[0] = normal;
            answer.tangent = tangent;
            answer.tangent[(0, 0)] = self.stiffness[0];
            answer.lost_stiffness = springs - answer.tangent;
            answer.state = state;
        }
        if self.opens && stretch[0] <= 0.0 {
            answer.force[0] = 0.0;
            answer.tangent[(0, 0)] = 0.0;
            answer.lost_stiffness[(0, 0)] = self.stiffness[0];
            answer.state = Mode::Open;
        }
        if self.stiffness == SVector::<f64, 3>::zeros() {
            answer.state = Mode::Open;
        }
        answer
    }

    /// The response at the friction limit `limit`, if the tangential part of `force` exceeds it, otherwise `None`. `force` is the force that the
    /// springs would have if the contact stuck.
    fn at_limit(&self, force: &SVector<f64, 3>, limit: f64) -> Option<AtLimit> {
        // The stiffness that is left at the friction limit. It acts in the tangential directions perpendicular to `normal`, the outward normal of the
        // curve that limits friction; in these directions friction still changes with the stretch.
        let along = |normal: &SVector<f64, 3>| {
            let mut across = SMatrix::<f64, 3, 3>::identity() - normal * normal.transpose();
            across[(0, 0)] = 0.0;
            across * SMatrix::from_diagonal(&self.stiffness) * across
        };
        let on_axis = |facet: u16, friction: f64| AtLimit {
            friction: unit::<3>(1) * friction,
            tangent: SMatrix::zeros(),
            state: Mode::Facet(facet),
        };
        match &self.slides {
            SlideDirections::Along([_, Some(facet)]) if force[1] > limit => Some(on_axis(*facet, limit)),
            SlideDirections::Along([Some(facet), _]) if force[1] < -limit => Some(on_axis(*facet, -limit)),
            SlideDirections::Never | SlideDirections::Along(_) => None,
            SlideDirections::Round => {
                let (tangential, size) = (tangential(force), tangential_norm(force));
                (size > limit).then(|| AtLimit {
                    friction: tangential * (limit / size),
                    tangent: along(&(tangential / size)) * (limit / size),
                    state: Mode::Facet(0),
                })
            }
            SlideDirections::OnPolygon { normals, corners } => {
                let friction = tangential(force);
                let beyond = |j: usize, at: &SVector<f64, 3>| normals[j].dot(at) - limit;
                let all = 0..normals.len();
                let j = all.max_by(|i, j| beyond(*i, &friction).total_cmp(&beyond(*j, &friction)))?;
                let violation = beyond(j, &friction);
                if violation <= 0.0 {
                    return None;
                }
                let (count, size) = (normals.len(), normals[j].norm());
                let nearest = friction - normals[j] * (violation / (size * size));
                // Facets are numbered around the polygon; corner j lies between facets j and j + 1.
                let [before, behind] = [(j + count - 1) % count, (j + 1) % count];
                let corner = if beyond(behind, &nearest) > 0.0 {
                    Some(j)
                } else {
                    (beyond(before, &nearest) > 0.0).then_some(before)
                };
                Some(match corner {
                    Some(corner) => AtLimit {
                        friction: corners[corner] * limit,
                        tangent: SMatrix::zeros(),
                        state: Mode::Corner(u16::try_from(corner).ok()?),
                    },
                    None => AtLimit {
                        friction: nearest,
                        tangent: along(&(normals[j] / size)),
                        state: Mode::Facet(u16::try_from(j).ok()?),
                    },
                })
            }
        }
    }

    /// The friction limit μ F_n, N, at least zero, for the normal force F_n = `normal`. In a rate problem (for derivatives along a load path)
    /// the rate of the limit, of either sign.
    pub(super) fn limit(&self, normal: f64) -> f64 {
        let limit = self.cone.limit(normal);
        if self.is_rate { limit } else { limit.max(0.0) }
    }
}
