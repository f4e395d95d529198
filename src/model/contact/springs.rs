//! A contact in a known state is equivalent to a few springs. Let v_i be the stretch of contact i, a_i its offset (commanded displacement minus
//! clearance and earlier slip), G_i its grasp map and q the motion of the object. Spring r is stretched along the vector stretch_r
//! (`stretch_direction`) and pushes along push_r (`push_direction`).
//!
//! Let k_a be the stiffness along axis a of the contact frame and e_a the unit vector of this axis; n marks the normal. K_t is the diagonal matrix of
//! the tangential stiffnesses, and μ the coefficient of friction. A sliding contact has a normal spring whose force F_n is accompanied by the
//! friction force μ F_n p. The vector p is a corner of the polygonal cone, or follows from the normal h of a facet. On the round cone h is the slip
//! direction, and `S = (K_t⁻¹ + λ)⁻¹` is K_t softened by λ, the slip per unit of friction force.
//!
//! ```text
//! F_i = Σ_r push_r (stretch_r · v_i),     v_i = a_i - G_iᵀq
//! sticking         push = stretch = √k_a e_a on every axis with a spring
//! sliding          F_t = μ F_n p on a corner p:   stretch = √k_n e_n,  push = √k_n (e_n + μ p)
//!                  on a facet h (space):          p = K_t h / (h·K_t h) and the spring across h stays
//!                  on the round cone:             p = S h / (h·S h) with S softened by the slip, see `slide`
//! open             none
//! ```

use nalgebra::SVector;

use super::law::LocalLaw;
use super::polygon::corner;
use super::slide::{Edge, Slide};
use super::state::{Mode, State};
use crate::numerics::rounding_of;
#[cfg(not(feature = "std"))]
use crate::prelude::*;

/// A spring of a contact: the force `F = push_direction (stretch_direction · v)` for the stretch v of the contact.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Spring {
    pub(crate) stretch_direction: SVector<f64, 3>,
    pub(crate) push_direction: SVector<f64, 3>,
    /// Rounding error of `stretch_direction`. With this correction the product of `push_direction` and `stretch_direction` along an axis equals the
    /// stiffness along this axis to the last digit.
    pub(crate) stretch_direction_error: SVector<f64, 3>,
    /// Rounding error of `push_direction`. With this correction the friction force of a sliding contact equals μ F_n to the last digit.
    pub(crate) push_direction_error: SVector<f64, 3>,
}

impl Spring {
    /// A spring whose force points along its own stretch: `push_direction = stretch_direction`.
    pub(crate) fn straight(along: SVector<f64, 3>) -> Self {
        let none = SVector::zeros();
        Self {
            stretch_direction: along,
            push_direction: along,
            stretch_direction_error: none,
            push_direction_error: none,
        }
    }

    /// A spring of stiffness k along an axis.
    pub(crate) fn along_axis(axis: usize, k: f64) -> Self {
        let mut along = SVector::zeros();
        along[axis] = k.sqrt();
        let mut spring = Self::straight(along);
        spring.stretch_direction_error[axis] = rest_of_factor(k, along[axis], along[axis]);
        spring
    }

    /// The normal spring of a sliding contact, of stiffness k. Its force consists of F_n along the normal and the friction force `μ F_n pull`.
    fn dragging(k: f64, mu: f64, pull: &SVector<f64, 3>) -> Self {
        let root = k.sqrt();
        // `stretch_direction` is multiplied by the number `balance`, and `push_direction` is divided by it. If μ is large, `push_direction` would
        // otherwise be far longer than `stretch_direction`.
        let balance = (1.0 + mu * pull.norm()).sqrt();
        let (mut stretch_direction, mut push_direction) = (SVector::zeros(), SVector::zeros());
        (stretch_direction[0], push_direction[0]) = (root * balance, root / balance);
        let (mut stretch_direction_error, mut push_direction_error) = (SVector::zeros(), SVector::zeros());
        stretch_direction_error[0] = rest_of_factor(k, push_direction[0], stretch_direction[0]);
        for axis in 1..3 {
            let drag = mu * pull[axis];
            push_direction[axis] = drag * push_direction[0];
            push_direction_error[axis] = rounding_of(push_direction[axis], drag, push_direction[0])
                + rounding_of(drag, mu, pull[axis]) * push_direction[0];
        }
        Self { stretch_direction, push_direction, stretch_direction_error, push_direction_error }
    }
}

/// The rounding error r of `factor`, one of the two factors of a product: `known (factor + r) = product` holds exactly.
fn rest_of_factor(product: f64, known: f64, factor: f64) -> f64 {
    let rounded = known * factor;
    ((product - rounded) - rounding_of(rounded, known, factor)) / known
}

impl LocalLaw<'_> {
    /// Calls `visit` with each of the springs that are equivalent to the contact in a state, at most one per axis.
    pub(crate) fn for_each_spring(&self, state: &State, mut visit: impl FnMut(Spring)) {
        match state {
            Mode::Open => {}
            Mode::Sticking => {
                (0..self.springs.axes())
                    .for_each(|axis| visit(Spring::along_axis(axis, self.springs.force_along(axis, 1.0))));
            }
            Mode::Facet(_) | Mode::Corner(_) | Mode::Round(_) => {
                let edge = self.edge(state);
                visit(Spring::dragging(self.springs.force_along(0, 1.0), self.cone().limit(1.0), &edge.pull));
                if edge.stiffness > 0.0 {
                    visit(Spring::straight(edge.across * edge.stiffness.sqrt()));
                }
            }
        }
    }

    /// The linearised boundary of the cone on which a contact in this state slides. On a facet with normal h, `pull` is `K_t h / (h·K_t h)`, and a
    /// spring acts across the slip. At a corner, `pull` is the vector of the corner, and no spring acts across the slip.
    #[inline]
    pub(crate) fn edge(&self, state: &State) -> Edge {
        if let Mode::Round(slide) = state {
            return slide.edge(self.springs);
        }
        let facets = self.facets();
        match state.own_facets(facets.len()) {
            [Some(a), Some(b)] => Edge::without_spring(corner(&facets[a], &facets[b])),
            [Some(a), None] => Slide { direction: facets[a], lambda: 0.0 }.edge(self.springs),
            [None, _] => Edge::without_spring(SVector::zeros()),
        }
    }
}
