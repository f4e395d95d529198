//! A contact in a known state is a few springs, each stretched along one direction and pushing along another.
//!
//! ```text
//! F_i = Σ_r left_r (right_r · v_i),     v_i = a_i - G_iᵀq
//! rolling          left = right = √k_a e_a on every axis with a spring
//! sliding          F_t = μ F_n p on a corner p:   right = √k_n e_n,  left = √k_n (e_n + μ p)
//!                  on a facet h (space):          p = K_t h / (h·K_t h) and the spring across h stays
//!                  on the round cone (space):     the same with S for K_t, see [`super::return_map`]
//! open             none
//! ```

use nalgebra::{SMatrix, SVector};

use super::problem::{Law, Problem, State};
use crate::numerics::rounding_of;

/// `F = left (right · v)`, v the stretch of a contact.
#[derive(Debug, Clone)]
pub(super) struct Spring<const C: usize> {
    pub(super) contact: usize,
    pub(super) right: SVector<f64, C>,
    pub(super) left: SVector<f64, C>,
    /// What rounding took from `right`, so that `left right` along the normal or an axis is the stiffness given.
    pub(super) right_rest: SVector<f64, C>,
    /// The same of `left`, so that friction is μ F_n.
    pub(super) left_rest: SVector<f64, C>,
}

impl<const C: usize> Spring<C> {
    /// Pushes the way it is stretched: `left = right`.
    fn straight(contact: usize, along: SVector<f64, C>) -> Self {
        let none = SVector::zeros();
        Self { contact, right: along, left: along, right_rest: none, left_rest: none }
    }

    /// A spring of this stiffness along an axis.
    fn along_axis(contact: usize, axis: usize, k: f64) -> Self {
        let mut along = SVector::zeros();
        along[axis] = k.sqrt();
        let mut spring = Self::straight(contact, along);
        spring.right_rest[axis] = rest_of_factor(k, along[axis], along[axis]);
        spring
    }

    /// The normal spring of a sliding contact, which drags friction `μ F_n pull` along.
    fn dragging(contact: usize, k: f64, mu: f64, pull: &SVector<f64, C>) -> Self {
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
        Self { contact, right, left, right_rest, left_rest }
    }
}

/// The r with `known (factor + r) = product`.
fn rest_of_factor(product: f64, known: f64, factor: f64) -> f64 {
    let rounded = known * factor;
    ((product - rounded) - rounding_of(rounded, known, factor)) / known
}

/// The springs of a contact in this state.
pub(super) fn push_springs<const D: usize, const C: usize>(
    problem: &Problem<D, C>,
    contact: usize,
    state: State,
    springs: &mut Vec<Spring<C>>,
) {
    let site = &problem.sites[contact];
    match state {
        State::Open => {}
        State::Rolling => {
            springs.extend((0..site.axes).map(|axis| Spring::along_axis(contact, axis, site.k[axis])));
        }
        State::Sliding { first, second } => {
            let h = problem.normals(contact)[first];
            let pull = edge_direction(problem, contact, first, second);
            springs.push(Spring::dragging(contact, site.k[0], problem.mu(contact), &pull));
            springs.extend(
                spring_across(problem, contact, &h, second).map(|spring| Spring::straight(contact, spring)),
            );
        }
    }
}

/// What of the tangential springs of a sliding contact still holds, across the slip.
fn spring_across<const D: usize, const C: usize>(
    problem: &Problem<D, C>,
    contact: usize,
    h: &SVector<f64, C>,
    second: Option<usize>,
) -> Option<SVector<f64, C>> {
    if let Law::Turning { slide, .. } = &problem.laws[contact] {
        let (across, stiffness) = slide.across();
        return (stiffness > 0.0).then(|| across * stiffness.sqrt());
    }
    if C == 2 || second.is_some() {
        return None;
    }
    // √K_t times the unit vector at right angles to √K_t h.
    let k = &problem.sites[contact].k;
    let (r1, r2) = (k[1].sqrt(), k[2].sqrt());
    let (y1, y2) = (r1 * h[1], r2 * h[2]);
    let length = y1.hypot(y2);
    let mut across = SVector::zeros();
    (across[1], across[2]) = (-r1 * y2 / length, r2 * y1 / length);
    Some(across)
}

/// `C_i = Σ left rightᵀ` of a contact in this state: how its force changes with its stretch.
pub(crate) fn contact_stiffness<const D: usize, const C: usize>(
    problem: &Problem<D, C>,
    contact: usize,
    state: State,
) -> SMatrix<f64, C, C> {
    let site = &problem.sites[contact];
    match state {
        State::Open => SMatrix::zeros(),
        State::Rolling => SMatrix::from_diagonal(&site.k),
        State::Sliding { first, second } => {
            let pull = edge_direction(problem, contact, first, second);
            let across = spring_across(problem, contact, &problem.normals(contact)[first], second);
            sliding_stiffness(
                site.k[0],
                problem.mu(contact),
                &pull,
                across.as_ref().map(|spring| (spring, 1.0)),
            )
        }
    }
}

/// `k_n (e_n + μ P) e_nᵀ + κ d dᵀ`: the normal spring drags friction along, that across the slip holds.
pub(super) fn sliding_stiffness<const C: usize>(
    normal: f64,
    mu: f64,
    pull: &SVector<f64, C>,
    across: Option<(&SVector<f64, C>, f64)>,
) -> SMatrix<f64, C, C> {
    let mut stiffness = across.map_or_else(SMatrix::zeros, |(d, held)| d * (d * held).transpose());
    stiffness[(0, 0)] = normal;
    for a in 1..C {
        stiffness[(a, 0)] = normal * mu * pull[a];
    }
    stiffness
}

/// The tangential force of a sliding contact for μ F_n = 1: the corner between two facets; on one facet the point
/// `K_t h / (h·K_t h)` from which the springs across the slip count.
pub(crate) fn edge_direction<const D: usize, const C: usize>(
    problem: &Problem<D, C>,
    contact: usize,
    first: usize,
    second: Option<usize>,
) -> SVector<f64, C> {
    let normals = problem.normals(contact);
    let h = normals[first];
    if let Some(second) = second {
        return corner(&h, &normals[second]);
    }
    if let Law::Turning { slide, .. } = &problem.laws[contact] {
        return slide.pull();
    }
    let stretched = problem.sites[contact].k.component_mul(&h);
    stretched / h.dot(&stretched)
}

/// The corner p between two facets: h₁·p = h₂·p = 1, no normal component.
pub(crate) fn corner<const C: usize>(h1: &SVector<f64, C>, h2: &SVector<f64, C>) -> SVector<f64, C> {
    let determinant = h1[1] * h2[2] - h1[2] * h2[1];
    let mut p = SVector::zeros();
    p[1] = (h2[2] - h1[2]) / determinant;
    p[2] = (h1[1] - h2[1]) / determinant;
    p
}
