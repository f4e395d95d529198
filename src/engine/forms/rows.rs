//! The meaning of each complementary pair (each row) of a linear complementarity problem, and the pairs that a contact does not need. In the
//! kinematic form the unknowns are gaps and slips, in the force form contact forces, magnitudes of slips and the twist.
//!
//! The contact force F has the normal part `F_n` and the tangential part `F_t`, limited by the friction coefficient μ. The friction cone is a polygon
//! for `μ F_n = 1`: its facets `h·F_t <= 1` have the normals h, its corners are the tangential vectors d_j.

use crate::lcp::Lcp;
use crate::prelude::*;

/// The meaning of one complementary pair `0 <= z ⟂ w >= 0`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Row {
    /// Kinematic form: z = gap g (m), w = normal force `F_n` (N).
    Gap {
        /// Index of the contact, from 0.
        contact: usize,
    },
    /// Kinematic form: z = coefficient σ >= 0 of one facet normal h in the slip `Σ σ h` (m), w = friction margin of that facet, `μ F_n - h·F_t` (N).
    Slip {
        /// Index of the contact, from 0.
        contact: usize,
        /// Index of the facet, from 0, in the order of [`PolygonCone`](crate::PolygonCone). In the plane 0 is slip along the tangent t, and 1 slip
        /// along -t.
        facet: usize,
    },
    /// Force form: z = normal force `F_n` (N), w = gap g (m).
    NormalForce {
        /// Index of the contact, from 0.
        contact: usize,
    },
    /// Force form: z = coefficient β of one corner d_j in the tangential force `F_t = Σ β_j d_j` (N), w = `λ - d_j·s` (m). Here s is the slip, and λ
    /// its magnitude, another unknown.
    TangentialForce {
        /// Index of the contact, from 0.
        contact: usize,
        /// Index of the corner, from 0, in the order of [`PolygonCone`](crate::PolygonCone). In the plane 0 is the tangent t, and 1 is -t.
        corner: usize,
    },
    /// Force form: z = magnitude λ of the slip (m), w = unused friction, `μ F_n - Σ_j β_j` (N), with the coefficients β_j of the corners.
    SlipSize {
        /// Index of the contact, from 0.
        contact: usize,
    },
    /// Force form: one half of an equilibrium equation.
    ///
    /// The unknown z is the positive or negative part of a component of the object's twist about the centroid of the contact points, m. The slack w
    /// is the same component, N, of the sum of the wrenches of all contact forces and the load. Its sign is reversed for the positive part.
    /// Rotations are multiplied by the root mean square distance of the points from the centroid, moments divided by it.
    Balance {
        /// Index, from 0, of the component of the twist and of the equilibrium equation: translations first, then rotations.
        axis: usize,
        /// True if the unknown z is the positive part of the component, false if it is the negative part.
        positive: bool,
    },
}

/// Complementary pairs of a contact that the linear complementarity problem does not contain because they are not needed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub struct OmittedPairs {
    /// Index of the contact, from 0.
    pub contact: usize,
    /// The number of complementary pairs that a kinematic form saves at this contact: 1 for the gap, 1 for each facet.
    pub rows: usize,
    /// The reason why the pairs are not needed.
    pub why: OmissionReason,
}

/// The reason why a contact needs fewer complementary pairs than a gap and its facets.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum OmissionReason {
    /// Everything sticks: the elastic trial, the solution in which every contact sticks, is the equilibrium.
    EverythingSticks,
    /// μ = 0: the contact has no tangential force, and needs no pairs for facets.
    Frictionless,
    /// μ = ∞: the contact never slides while it is closed, and needs no pairs for facets.
    InfiniteFriction,
    /// The caller keeps the contact closed: it needs no pair for a gap.
    KeptClosed,
    /// The caller has bonded the contact: it needs pairs neither for a gap nor for facets.
    Bonded,
}

/// A linear complementarity problem of a grasp, with the meaning of its rows.
///
/// The problem is stated in scaled variables (square roots of energy), so that large ratios of stiffnesses do not spoil the scale of its matrix. With
/// the units below, physical `z_i = z_unit[i] · ẑ_i`, physical `w_i = w_unit[i] · ŵ_i`. Made by
/// [`Grasp::kinematic_form`](crate::ask::Grasp::kinematic_form) and [`Grasp::force_form`](crate::ask::Grasp::force_form).
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct Form {
    /// The problem in the scaled variables ẑ and ŵ, with a matrix M and a vector q: `0 <= ẑ ⟂ ŵ = M ẑ + q >= 0`.
    pub lcp: Lcp,
    /// The meaning of each complementary pair (row) of the problem.
    pub rows: Vec<Row>,
    /// For each unknown z, the physical value that corresponds to ẑ = 1, N or m according to its [`Row`].
    pub z_unit: Vec<f64>,
    /// For each slack w, the physical value that corresponds to ŵ = 1, N or m according to its [`Row`].
    pub w_unit: Vec<f64>,
}

impl Form {
    /// The index, from 0, of the row with the meaning `row`; `None` if the form has no such row.
    #[must_use]
    pub fn position(&self, row: Row) -> Option<usize> {
        self.rows.iter().position(|r| *r == row)
    }
}
