//! A contact in a known state is a few springs, each stretched along one direction and pushing along another.
//!
//! ```text
//! F_i = Σ_r left_r (right_r · v_i),     v_i = a_i - G_iᵀq
//! rolling          left = right = √k_a e_a on every axis with a spring
//! sliding          F_t = μ F_n p on a corner p:   right = √k_n e_n,  left = √k_n (e_n + μ p)
//!                  on a facet h (space):          p = K_t h / (h·K_t h) and the spring across h stays
//!                  on the round cone:             p = S h / (h·S h) with S softened by the slip, see `slide`
//! open             none
//! ```

use nalgebra::{SMatrix, SVector};

use super::law::LocalLaw;
use super::polygon::corner;
use super::state::{Mode, State};
use crate::numerics::rounding_of;

/// `F = left (right · v)`, v the stretch of a contact.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Spring<const C: usize> {
    pub(crate) right: SVector<f64, C>,
    pub(crate) left: SVector<f64, C>,
    /// What rounding took from `right`, so that `left right` along the normal or an axis is the stiffness given.
    pub(crate) right_rest: SVector<f64, C>,
    /// What rounding took from `left`, so that friction is μ F_n.
    pub(crate) left_rest: SVector<f64, C>,
}

impl<const C: usize> Spring<C> {
    /// Pushes the way it is stretched: `left = right`.
    pub(crate) fn straight(along: SVector<f64, C>) -> Self {
        let none = SVector::zeros();
        Self { right: along, left: along, right_rest: none, left_rest: none }
    }

    /// A spring of this stiffness along an axis.
    pub(crate) fn along_axis(axis: usize, k: f64) -> Self {
        let mut along = SVector::zeros();
        along[axis] = k.sqrt();
        let mut spring = Self::straight(along);
        spring.right_rest[axis] = rest_of_factor(k, along[axis], along[axis]);
        spring
    }

    /// The normal spring of a sliding contact, which drags friction `μ F_n pull` along.
    fn dragging(k: f64, mu: f64, pull: &SVector<f64, C>) -> Self {
        let root = k.sqrt();
        // The same spring read as (right c, left / c): with a large μ the left side would otherwise dwarf its row.
        let balance = (1.0 + mu * pull.norm()).sqrt();
        let (mut right, mut left) = (SVector::zeros(), SVector::zeros());
        (right[0], left[0]) = (root * balance, root / balance);
        let (mut right_rest, mut left_rest) = (SVector::zeros(), SVector::zeros());
        right_rest[0] = rest_of_factor(k, left[0], right[0]);
        for axis in 1..C {
            let drag = mu * pull[axis];
            left[axis] = drag * left[0];
            left_rest[axis] =
                rounding_of(left[axis], drag, left[0]) + rounding_of(drag, mu, pull[axis]) * left[0];
        }
        Self { right, left, right_rest, left_rest }
    }
}

/// The r with `known (factor + r) = product`.
fn rest_of_factor(product: f64, known: f64, factor: f64) -> f64 {
    let rounded = known * factor;
    ((product - rounded) - rounding_of(rounded, known, factor)) / known
}

impl<const C: usize> LocalLaw<'_, C> {
    /// Visits the springs of the contact in a state, at most C of them.
    pub(crate) fn for_each_spring(&self, state: &State<C>, mut visit: impl FnMut(Spring<C>)) {
        match state {
            Mode::Open => {}
            Mode::Rolling => {
                (0..self.springs.axes())
                    .for_each(|axis| visit(Spring::along_axis(axis, self.springs.force_along(axis, 1.0))));
            }
            Mode::Facet(_) | Mode::Corner(_) | Mode::Round(_) => {
                let pull = self.edge_direction(state);
                visit(Spring::dragging(self.springs.force_along(0, 1.0), self.cone().limit(1.0), &pull));
                if let Some(spring) = self.spring_across(state) {
                    visit(Spring::straight(spring));
                }
            }
        }
    }

    /// What of the tangential springs of a sliding contact still holds, across the slip.
    fn spring_across(&self, state: &State<C>) -> Option<SVector<f64, C>> {
        match state {
            Mode::Round(slide) => {
                let stiffness = slide.pull_and_stiffness(self.springs).1;
                (stiffness > 0.0).then(|| slide.across() * stiffness.sqrt())
            }
            Mode::Facet(j) if C == 3 => {
                // √K_t times the unit vector at right angles to √K_t h.
                let root = self.springs.root();
                let stretched = root.component_mul(&self.facets()[usize::from(*j)]);
                let length = stretched[1].hypot(stretched[2]);
                let mut across = SVector::zeros();
                (across[1], across[2]) = (-root[1] * stretched[2] / length, root[2] * stretched[1] / length);
                Some(across)
            }
            _ => None,
        }
    }

    /// `C_i = Σ left rightᵀ` of the contact in a state: how its force changes with its stretch.
    ///
    /// Of a sliding contact it is `k_n (e_n + μ P) e_nᵀ + κ d dᵀ`: the normal spring drags friction along, the spring across holds.
    #[inline]
    pub(crate) fn tangent(&self, state: &State<C>) -> SMatrix<f64, C, C> {
        let (pull, mut stiffness) = match state {
            Mode::Open => return SMatrix::zeros(),
            Mode::Rolling => return self.springs.stiffness(),
            Mode::Round(slide) => {
                let (pull, held) = slide.pull_and_stiffness(self.springs);
                let across = slide.across();
                (pull, across * (across * held).transpose())
            }
            Mode::Facet(_) | Mode::Corner(_) => {
                let held = self.spring_across(state).map_or_else(SMatrix::zeros, |d| d * d.transpose());
                (self.edge_direction(state), held)
            }
        };
        let drag = self.springs.force_along(0, 1.0);
        stiffness[(0, 0)] = drag;
        for a in 1..C {
            stiffness[(a, 0)] = drag * self.cone().limit(pull[a]);
        }
        stiffness
    }

    /// The tangential force of a sliding contact for μ F_n = 1: the corner between two facets, or on one facet the point
    /// `K_t h / (h·K_t h)` from which the springs across the slip count.
    pub(crate) fn edge_direction(&self, state: &State<C>) -> SVector<f64, C> {
        if let Mode::Round(slide) = state {
            return slide.pull(self.springs);
        }
        let facets = self.facets();
        let [first, second] = state.own_facets(facets.len());
        let Some(h) = first.map(|first| &facets[first]) else { return SVector::zeros() };
        if let Some(second) = second {
            return corner(h, &facets[second]);
        }
        let stretched = self.springs.force(h);
        stretched / h.dot(&stretched)
    }
}
