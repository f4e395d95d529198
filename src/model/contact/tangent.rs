//! The tangent stiffness C of one contact, as a sum of a few dyads. The stretch v of a contact, m, is the displacement of its finger less clearance
//! and earlier slip, minus the displacement of the object at the contact. A change dv of the stretch changes the contact force by `dF = C dv`. K is
//! the diagonal matrix of the stiffnesses, k_n the normal stiffness, e_n the unit normal, and μ the coefficient of friction.
//!
//! ```text
//! sticking    C = K
//! sliding     C = k_n (e_n + μ P) e_nᵀ + κ d dᵀ
//! ```
//!
//! While the contact slides, the normal spring also changes the friction force, and a spring acts across the slip. P is the ratio of the friction
//! force to μ F_n, d the tangent across the slip, and κ the stiffness of that spring ([`Edge`] contains all three). A sum over many contacts adds the
//! dyads one by one. Each contact has at most as many dyads as C has columns, and each dyad costs one multiplication per entry.

use nalgebra::{SMatrix, SVector};

use super::law::LocalLaw;
use super::slide::Edge;
use super::state::{Mode, State};

/// The tangent stiffness C of a contact in a state, N/m.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Tangent {
    /// The contact is open: no stiffness, since the force is zero.
    Open,
    /// The contact sticks: the diagonal of K, N/m.
    Sticking(SVector<f64, 3>),
    /// The contact slides on the boundary of the cone.
    Sliding {
        /// Change of force per normal stretch, `k_n (e_n + μ P)`, N/m.
        drag: SVector<f64, 3>,
        /// d, the tangent vector across the slip direction.
        across: SVector<f64, 3>,
        /// κ, the stiffness of the contact across the slip direction, N/m.
        stiffness: f64,
    },
}

impl Tangent {
    /// The tangent stiffness C, the derivative of the force with respect to the stretch, as a full matrix, N/m.
    pub(crate) fn matrix(&self) -> SMatrix<f64, 3, 3> {
        match self {
            Self::Open => SMatrix::zeros(),
            Self::Sticking(k) => SMatrix::from_diagonal(k),
            Self::Sliding { drag, across, stiffness } => {
                let mut matrix = across * (across * *stiffness).transpose();
                matrix.set_column(0, drag);
                matrix
            }
        }
    }
}

impl Tangent {
    /// Change of force `C v` for a change v of the stretch, N.
    #[inline]
    pub(crate) fn force(&self, stretch: &SVector<f64, 3>) -> SVector<f64, 3> {
        match self {
            Self::Open => SVector::zeros(),
            Self::Sticking(k) => k.component_mul(stretch),
            Self::Sliding { drag, across, stiffness } => {
                drag * stretch[0] + across * (stiffness * across.dot(stretch))
            }
        }
    }
}

impl LocalLaw<'_> {
    /// The tangent stiffness of the contact in a state: the derivative of its force with respect to its stretch, N/m.
    #[inline]
    pub(crate) fn tangent(&self, state: &State) -> Tangent {
        match state {
            Mode::Open => Tangent::Open,
            Mode::Sticking => Tangent::Sticking(self.springs.diagonal()),
            Mode::Facet(_) | Mode::Corner(_) | Mode::Round(_) => {
                let Edge { pull, across, stiffness } = self.edge(state);
                let drag = self.cone().generator(&pull) * self.springs.force_along(0, 1.0);
                Tangent::Sliding { drag, across, stiffness }
            }
        }
    }
}
