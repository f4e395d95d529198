//! The derivative of one contact's force by its stretch, `dF = C dv`, as the few dyads whose sum is C.
//!
//! ```text
//! sticking    C = K
//! sliding     C = k_n (e_n + μ P) e_nᵀ + κ d dᵀ
//! ```
//!
//! The normal spring drags friction along, and the spring across the slip resists. A sum over many contacts adds dyad by dyad:
//! a contact has at most as many dyads as C has columns, and each costs one multiplication an entry.

use nalgebra::{SMatrix, SVector};

use super::law::LocalLaw;
use super::slide::Edge;
use super::state::{Mode, State};

/// C of a contact in a state, N/m.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Tangent {
    /// Zero force at any stretch.
    Open,
    /// The diagonal of K.
    Sticking(SVector<f64, 3>),
    /// On an edge of the cone.
    Sliding {
        /// `k_n (e_n + μ P)`.
        drag: SVector<f64, 3>,
        /// d.
        across: SVector<f64, 3>,
        /// κ.
        stiffness: f64,
    },
}

impl Tangent {
    /// C with all its entries.
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
    /// `C v`.
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
    /// C of the contact in a state.
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
