//! The tangent stiffness T of the object. It follows from the tangent stiffness C_i of each contact: the derivative of the contact force F_i with
//! respect to the stretch, in the present contact state. With the grasp maps G_i and the load W, a Newton step dq of the twist for the imbalance R is
//!
//! ```text
//! R = Σ G_i F_i + W,     T = Σ G_i C_i G_iᵀ,     dq = T⁻¹R,     F_i -= C_i G_iᵀ dq
//! ```
//!
//! The forces are corrected, not recomputed from the twist: the force of a very stiff spring follows from equilibrium, not from its tiny stretch.
//! After a step R is mere rounding, so that a few steps give the last digits if T is regular. If T is singular, orthogonal factors of spring
//! stretches and push directions find the motions that springs do not resist ([`super::LinearProblem`]).

use crate::numerics::{Each, Factors, PartialPivoting, Square, Vector, add_times, in_halves};
use core::ops::Range;

use nalgebra::SMatrix;

use super::banded_tangent::{BandedTangent, uses_band};
use super::newton::Imbalance;
use super::problem::Problem;
use super::solution::ForcesAndTwist;
use crate::contact::State;
use crate::grasp::{Site, size_of};
use crate::prelude::*;

/// LU factors of the tangent stiffness T; with many coordinates ([`uses_band`]) T is factorised as a band matrix.
pub(crate) enum TangentFactors {
    Whole(Factors),
    Band(Box<BandedTangent>),
}

impl TangentFactors {
    /// A solution y of `T y = b` with the tangent stiffness T. If T is singular, a component of b outside the range of T is ignored.
    pub(crate) fn solve(&self, b: &Vector) -> Vector {
        match self {
            Self::Whole(factors) => factors.solve(b),
            Self::Band(band) => band.solve(b),
        }
    }

    /// Null vectors of the tangent stiffness, as motions of all coordinates. Empty if the tangent stiffness is regular. Always empty if it is
    /// factorised as a full matrix.
    pub(crate) fn loose_motions(&self) -> Vec<Vector> {
        match self {
            Self::Whole(_) => Vec::new(),
            Self::Band(band) => band.loose_motions(),
        }
    }

    /// Whether the tangent stiffness T is regular, that is, clearly not singular in spite of rounding.
    pub(crate) fn is_regular(&self) -> bool {
        match self {
            Self::Whole(factors) => matches!(factors, Factors::Regular(_)),
            Self::Band(band) => !band.is_singular(),
        }
    }
}

impl Problem<'_> {
    /// LU factors of the tangent stiffness T of this problem, with contact i in the state `state(i)`.
    pub(crate) fn tangent_factors(&self, state: &(dyn Fn(usize) -> State + Sync)) -> TangentFactors {
        self.tangent_in_a_band(state).unwrap_or_else(|| {
            let tangent = |i: usize| self.local(i).tangent(&state(i)).matrix();
            TangentFactors::Whole(Factors::new(&tangent_stiffness(self.sites, &tangent)))
        })
    }

    /// LU factors of the tangent stiffness T as a band matrix; `None` with too few coordinates for a band ([`uses_band`]), or if a pivot is not
    /// finite.
    pub(crate) fn tangent_in_a_band(&self, state: &dyn Fn(usize) -> State) -> Option<TangentFactors> {
        if !uses_band(self.size()) {
            return None;
        }
        let (mut springs, mut first) = (Vec::with_capacity(3 * self.len()), vec![0]);
        for contact in 0..self.len() {
            self.local(contact).for_each_spring(&state(contact), |spring| springs.push(spring));
            first.push(springs.len());
        }
        BandedTangent::new(self.sites, &springs, &first).map(|band| TangentFactors::Band(Box::new(band)))
    }
}

/// The tangent stiffness C_i of a contact, N/m: the derivative of its force with respect to its stretch, in its contact frame.
pub(crate) type SpringTangent = SMatrix<f64, 3, 3>;

/// The tangent stiffness `T = Σ G_i C_i G_iᵀ` of the object, summed over `sites`, the contacts and the drives of joints and tendons; `springs(i)`
/// returns C_i of contact i.
pub(crate) fn tangent_stiffness(sites: &[Site], springs: &(dyn Fn(usize) -> SpringTangent + Sync)) -> Square {
    let part = |contacts: Range<usize>| {
        let mut t = Square::zeros(size_of(sites));
        for i in contacts {
            add_tangent(&mut t, &sites[i], &springs(i));
        }
        t
    };
    in_halves(0..sites.len(), &part, &|a: Square, b| a + &b)
}

/// Adds the term `G_i C_i G_iᵀ` of one contact to the tangent stiffness of the object.
fn add_tangent(t: &mut Square, site: &Site, springs: &SpringTangent) {
    let pushed: [Vector; 3] = [0, 1, 2].each(|a| &site.map * springs.column(a).into_owned());
    // Only columns of coordinates with entries in the grasp map are visited. The grasp map of a contact has no entries for joints of other fingers,
    // that of a drive only entries for its own joints.
    for columns in site.support.ranges() {
        for j in columns {
            let column = t.column_slice_mut(j);
            for a in 0..3 {
                add_times(column, pushed[a].as_slice(), site.map[(j, a)]);
            }
        }
    }
}

/// Corrects the forces and twist of `state` by at most three Newton steps. They end when the norm of the imbalance is at most the fraction `part` of
/// the sum of the norms of contact forces and load. Returns the sum over the steps of the largest change of a contact force, N; `None` if the
/// imbalance is still larger after these steps.
pub(crate) fn balance(
    sites: &[Site],
    springs: &[SpringTangent],
    tangent: &PartialPivoting,
    wrench: &Vector,
    state: &mut ForcesAndTwist,
    part: f64,
) -> Option<f64> {
    let mut moved = 0.0_f64;
    // The imbalance is computed at most four times. One or two Newton steps are enough if T is well conditioned.
    for _ in 0..4 {
        let Imbalance { left, size } = Imbalance::of(sites, &state.forces, wrench, wrench.norm());
        if left.norm() <= part * size {
            return Some(moved);
        }
        let step = tangent.solve(&left);
        state.twist += &step;
        let mut longest = 0.0_f64;
        for ((site, springs), force) in sites.iter().zip(springs).zip(&mut state.forces) {
            let change = springs * site.map.tr_mul(&step);
            *force -= change;
            longest = longest.max(change.norm_squared());
        }
        moved += longest.sqrt();
    }
    None
}
