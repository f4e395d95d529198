//! The linear complementarity problem in which a polygon replaces each friction cone.
//!
//! A contact has the normal force r_N, the normal velocity u_N, the tangential velocity u_T, the friction coefficient μ and the slip speed λ. Its
//! tangential force is r_T = Σ β_j d_j, with a unit vector d_j for each of the k facets (facet directions) and forces β_j along these vectors.
//! Coulomb's law on the polygon is
//!
//! ```text
//! 0 ≤ u_N             ⟂ r_N ≥ 0
//! 0 ≤ d_jᵀu_T + λ     ⟂ β_j ≥ 0
//! 0 ≤ μ r_N − Σ β_j   ⟂ λ ≥ 0
//! ```
//!
//! (D. E. Stewart and J. C. Trinkle, Int. J. Numer. Methods Eng. 39, 1996). The matrix of this complementarity problem is copositive if W, the matrix
//! from contact forces to velocities, is positive semidefinite. There are n contacts with C components each (2 in the plane, 3 in space).

use super::problem::FrictionProblem;
use super::settings::MOST_CONE_FACETS;
use crate::lcp::{Lcp, LcpError};
use crate::numerics::{mapped, numbered, vector_of};
use crate::prelude::*;
use core::f64::consts::TAU;
use nalgebra::{DMatrix, DVector, SVector};

/// The facet directions of each contact: unit vectors without a normal component.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Facets<const C: usize>(pub(super) Vec<Vec<SVector<f64, C>>>);

impl<const C: usize> Facets<C> {
    /// Facet directions at equal angles. In the plane they are the two opposite tangential directions of each contact, whatever `count` is. In space
    /// there are `count` directions, and `angles` has the angle of each contact's first direction, in rad from the first tangential axis.
    pub(super) fn regular(count: usize, angles: &[f64]) -> Self {
        let direction = |angle: f64| {
            let mut d = SVector::zeros();
            (d[1], d[C - 1]) = (angle.cos(), angle.sin());
            d
        };
        let either = |sign: f64| {
            let mut d = SVector::zeros();
            d[1] = sign;
            d
        };
        let of = |angle: &f64| -> Vec<SVector<f64, C>> {
            if C == 2 {
                return vec![either(1.0), either(-1.0)];
            }
            numbered(count, &|k| direction(angle + TAU * k as f64 / count as f64))
        };
        Self(mapped(angles, &of))
    }

    /// Number of unknowns of each contact: the normal force, a friction force along each facet direction, and the slip speed.
    fn width(&self) -> usize {
        self.0.first().map_or(0, |facets| facets.len() + 2)
    }
}

/// A frictional contact problem in which a polygon replaces each cone; see [`FrictionProblem::facets`].
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct FacetedProblem<const C: usize> {
    /// The complementarity problem. Its unknowns for each contact are the normal force, one friction force along each facet direction, and the slip
    /// speed.
    pub lcp: Lcp,
    facets: Facets<C>,
}

impl<const C: usize> FacetedProblem<C> {
    /// The normal forces of the contacts, selected from a vector z that has an entry for each unknown of the complementarity problem. If z is a
    /// vector of slacks instead, the result has the normal velocities.
    pub(super) fn normals(&self, z: &DVector<f64>) -> DVector<f64> {
        vector_of(self.facets.0.len(), &|i| z[self.facets.width() * i])
    }

    /// The forces r (C n entries) of a solution z of the complementarity problem.
    ///
    /// # Errors
    ///
    /// [`LcpError::Length`] and [`LcpError::VectorEntry`] for a z of another length, or with an entry that is not finite.
    pub fn forces(&self, z: &DVector<f64>) -> Result<DVector<f64>, LcpError> {
        LcpError::check_vector("z", z, self.lcp.len())?;
        let width = self.facets.width();
        let mut r = DVector::zeros(C * self.facets.0.len());
        for (i, facets) in self.facets.0.iter().enumerate() {
            let mut force = SVector::<f64, C>::zeros();
            force[0] = z[width * i];
            for (j, d) in facets.iter().enumerate() {
                force += d * z[width * i + 1 + j];
            }
            r.fixed_rows_mut::<C>(C * i).copy_from(&force);
        }
        Ok(r)
    }
}

impl<const C: usize> FrictionProblem<C> {
    /// The problem with a polygon of `facets` facets in place of each cone. A number below 3 counts as 3, a number above 128 as 128. In the plane
    /// `facets` is ignored: two facets are the cone itself. In space the polygon lies inside the cone.
    ///
    /// # Errors
    ///
    /// [`LcpError::MatrixEntry`] if a sum of entries of the matrix W leaves the range of double precision.
    pub fn facets(&self, facets: usize) -> Result<FacetedProblem<C>, LcpError> {
        self.polygon(Facets::regular(facets.clamp(3, MOST_CONE_FACETS), &vec![0.0; self.len()]))
    }

    pub(super) fn polygon(&self, facets: Facets<C>) -> Result<FacetedProblem<C>, LcpError> {
        let (n, width) = (self.len(), facets.width());
        // Each column of `span` is the contact force due to one unit of one unknown: a normal force, or friction along one facet direction. The
        // transpose of `span` maps velocities to slacks.
        let mut span = DMatrix::zeros(C * n, width * n);
        for (i, facets) in facets.0.iter().enumerate() {
            span[(C * i, width * i)] = 1.0;
            for (j, d) in facets.iter().enumerate() {
                span.view_mut((C * i, width * i + 1 + j), (C, 1)).copy_from(d);
            }
        }
        let mut m = span.tr_mul(&(&self.w * &span));
        let q = span.tr_mul(&self.q);
        for i in 0..n {
            let slip = width * i + width - 1;
            m[(slip, width * i)] = self.mu[i];
            for force in width * i + 1..slip {
                m[(force, slip)] = 1.0;
                m[(slip, force)] = -1.0;
            }
        }
        Ok(FacetedProblem { lcp: Lcp::new(m, q)?, facets })
    }
}
