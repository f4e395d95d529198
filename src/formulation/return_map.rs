//! The return map of the round friction cone: from the stretch of one contact to its force, exactly.
//!
//! With the stretch `v = a - G_iᵀq` of a contact in space, T = K_t v_t its trial traction and r = μ F_n:
//!
//! ```text
//! open      k_n v_n <= 0                F = 0
//! rolling   |T| <= r                    F_t = T
//! sliding   |T| > r                     F_t = S v_t,  S = (K_t⁻¹ + λ)⁻¹,  λ > 0 from |S v_t| = r
//! ```
//!
//! In the last case the slip is `s = v_t - K_t⁻¹F_t = λ F_t`: along the force. For one tangential stiffness this is the radial
//! return, for two of them the closest point of the disc in the metric K_t⁻¹ (not the radial one).
//!
//! Its derivative is that of two springs. With p = F_t / r, P = S p / (p·S p) and a unit tangent d at right angles to p
//!
//! ```text
//! dF_t = μ dF_n P + κ d (d·dv),     κ = det S / (p·S p)
//! ```
//!
//! a facet of the cone with normal p, in which the spring across the slip is softened by the slip: the direction turns.

use nalgebra::{SMatrix, SVector};

use super::problem::{Law, Problem};
use super::spring::sliding_stiffness;
use crate::grasp::{Hold, Site};

/// Newton's steps on the secular equation: from its lower bound it gains digits from the first step on.
const STEPS: usize = 60;
/// A step shorter than this part of λ is the last.
const LAST: f64 = 1e-8;
/// No start is a λ larger than this by the compliance of the springs.
const FAR: f64 = 1e100;
/// Squares above this have lost no digits, nor have those below its reciprocal.
const SAFE_SQUARE: f64 = 1e-280;

/// What a contact answers to a stretch.
#[derive(Debug, Clone)]
pub(crate) enum Returned<const C: usize> {
    Open,
    Rolling(SVector<f64, C>),
    Sliding(SVector<f64, C>, Slide<C>),
}

impl<const C: usize> Returned<C> {
    pub(crate) fn force(&self) -> SVector<f64, C> {
        match self {
            Self::Open => SVector::zeros(),
            Self::Rolling(force) | Self::Sliding(force, _) => *force,
        }
    }

    /// The derivative of the force by the stretch.
    pub(crate) fn stiffness<const D: usize>(&self, site: &Site<D, C>) -> SMatrix<f64, C, C> {
        match self {
            Self::Open => SMatrix::zeros(),
            Self::Rolling(_) => SMatrix::from_diagonal(&site.k),
            Self::Sliding(_, slide) => slide.stiffness(site),
        }
    }
}

/// A contact that slides on the round cone, to first order.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Slide<const C: usize> {
    /// Unit direction p of the friction force and of the slip; no normal component.
    pub(crate) direction: SVector<f64, C>,
    /// The diagonal of S; zero on the normal axis.
    pub(crate) held: SVector<f64, C>,
    /// Slip per force λ.
    pub(crate) lambda: f64,
}

impl<const C: usize> Slide<C> {
    /// The slide of a contact with a friction force along this direction and this slip per force λ.
    pub(crate) fn new<const D: usize>(site: &Site<D, C>, friction: &SVector<f64, C>, lambda: f64) -> Self {
        let mut direction = *friction;
        direction[0] = 0.0;
        direction /= tangential_norm(&direction);
        // S, a diagonal.
        let held = SVector::from_fn(|a, _| if a == 0 { 0.0 } else { site.k[a] / (1.0 + lambda * site.k[a]) });
        Self { direction, held, lambda }
    }

    /// P, the friction force for μ F_n = 1 from which the spring across counts, and the stiffness κ of that.
    fn pull_and_stiffness(&self) -> (SVector<f64, C>, f64) {
        let pulled = self.held.component_mul(&self.direction);
        let along = 1.0 / self.direction.dot(&pulled);
        (pulled * along, self.held[1] * (self.held[2] * along))
    }

    /// P: the friction force for μ F_n = 1 from which the spring across counts.
    pub(crate) fn pull(&self) -> SVector<f64, C> {
        self.pull_and_stiffness().0
    }

    /// The unit tangent across the slip.
    fn tangent(&self) -> SVector<f64, C> {
        let mut across = SVector::<f64, C>::zeros();
        (across[1], across[2]) = (-self.direction[2], self.direction[1]);
        across
    }

    /// The unit tangent across the slip, and the stiffness κ left along it.
    pub(crate) fn across(&self) -> (SVector<f64, C>, f64) {
        (self.tangent(), self.pull_and_stiffness().1)
    }

    /// The derivative of the force by the stretch.
    pub(crate) fn stiffness<const D: usize>(&self, site: &Site<D, C>) -> SMatrix<f64, C, C> {
        let (pull, held) = self.pull_and_stiffness();
        sliding_stiffness(site.k[0], site.mu, &pull, Some((&self.tangent(), held)))
    }

    /// The stretch across the slip at which the softened spring carries nothing, for a stretch and the force there, with r = μ F_n.
    pub(crate) fn rest(&self, stretch: &SVector<f64, C>, force: &SVector<f64, C>, r: f64) -> SVector<f64, C> {
        let (across, stiffness) = self.across();
        if stiffness == 0.0 {
            return SVector::zeros();
        }
        let rest = r * self.pull().dot(&across) - self.across_part(force);
        across * (across.dot(stretch) + rest / stiffness)
    }

    /// The part of a force across the slip: none on the cone itself.
    fn across_part(&self, force: &SVector<f64, C>) -> f64 {
        self.tangent().dot(force)
    }
}

/// The force of a contact with friction coefficient `mu` at a stretch. `near` is the λ of a stretch close by, or zero.
fn return_map<const D: usize, const C: usize>(
    site: &Site<D, C>,
    mu: f64,
    stretch: &SVector<f64, C>,
    near: f64,
) -> Returned<C> {
    let mut force = site.k.component_mul(stretch);
    if site.hold == Hold::Unilateral && force[0] <= 0.0 {
        return Returned::Open;
    }
    if site.hold == Hold::Bonded || site.axes == 1 || mu.is_infinite() {
        return Returned::Rolling(force);
    }
    let r = mu * force[0].max(0.0);
    let traction = tangential_norm(&force);
    if traction <= r {
        return Returned::Rolling(force);
    }
    let lambda = slip_per_force(site, &force, traction, r, near);
    let (mut direction, mut held) = (SVector::zeros(), SVector::zeros());
    for a in 1..C {
        let softened = 1.0 / (1.0 + lambda * site.k[a]);
        direction[a] = force[a] * softened;
        held[a] = site.k[a] * softened;
    }
    direction /= tangential_norm(&direction);
    for a in 1..C {
        force[a] = direction[a] * r;
    }
    Returned::Sliding(force, Slide { direction, held, lambda })
}

/// The force of a contact of a problem at a stretch, as its law has it. `near` is the λ of a stretch close by, or zero.
pub(crate) fn respond<const D: usize, const C: usize>(
    problem: &Problem<D, C>,
    contact: usize,
    stretch: &SVector<f64, C>,
    near: f64,
) -> Returned<C> {
    let site = &problem.sites[contact];
    match &problem.laws[contact] {
        Law::Absent => Returned::Open,
        Law::Edge(facets) => {
            let mut force = site.k.component_mul(stretch);
            let slide = Slide::new(site, &facets[0], 0.0);
            let excess = slide.direction.dot(&force) - site.mu * force[0];
            if excess <= 0.0 {
                return Returned::Rolling(force);
            }
            force -= slide.pull() * excess;
            Returned::Sliding(force, slide)
        }
        Law::Bonded => Returned::Rolling(site.k.component_mul(stretch)),
        _ => return_map(site, site.mu, stretch, near),
    }
}

/// The force of a contact that slides whichever way it has to: with |T| < r the slip is against the friction force, λ < 0.
/// `None` where nothing presses.
///
/// This branch of the law goes on smoothly through the load at which sliding ends, which is found as the root of λ.
pub(crate) fn slide_on<const D: usize, const C: usize>(
    site: &Site<D, C>,
    mu: f64,
    stretch: &SVector<f64, C>,
) -> Option<(SVector<f64, C>, Slide<C>)> {
    let mut force = site.k.component_mul(stretch);
    let (r, traction) = (mu * force[0], tangential_norm(&force));
    if !(r > 0.0 && traction > 0.0 && traction.is_finite()) {
        return None;
    }
    let lambda = slip_per_force(site, &force, traction, r, 0.0);
    let softened = SVector::from_fn(|a, _| if a == 0 { 0.0 } else { force[a] / (1.0 + lambda * site.k[a]) });
    let slide = Slide::new(site, &softened, lambda);
    for a in 1..C {
        force[a] = slide.direction[a] * r;
    }
    Some((force, slide))
}

/// λ with `|S(λ) v_t| = r`, from the trial traction T = K_t v_t; positive if |T| > r.
///
/// The secular equation 1/|S v| = 1/r of trust regions, nearly linear in λ and concave: from wherever they start Newton's steps
/// lead left of the root, and from there they grow towards it and never pass it.
fn slip_per_force<const D: usize, const C: usize>(
    site: &Site<D, C>,
    trial: &SVector<f64, C>,
    traction: f64,
    r: f64,
    near: f64,
) -> f64 {
    // With r = 0 every λ is too small: one so large that S is nothing beside K⁻¹.
    let excess = traction / r.max(traction * 1e-200);
    if site.k[1] == site.k[2] {
        return (excess - 1.0) / site.k[1];
    }
    let unit = trial / traction;
    // From where squares underflow no step leads back.
    let mut lambda = if near * site.k.amax() < FAR { near } else { 0.0 };
    // What slips backwards, λ < 0, is bounded by the softer axis and by where the stiffer one has no stiffness left to lose.
    let (soft, stiff) = (site.k[1].min(site.k[2]), site.k[1].max(site.k[2]));
    let least = if excess >= 1.0 { 0.0 } else { ((excess - 1.0) / soft).max(-(1.0 - LAST) / stiff) };
    for _ in 0..STEPS {
        let (mut square, mut slope) = (0.0, 0.0);
        for a in 1..C {
            let softened = 1.0 / (1.0 + lambda * site.k[a]);
            let f = unit[a] * softened;
            square += f * f;
            slope += f * f * (site.k[a] * softened);
        }
        let step = square / slope * (square.sqrt() * excess - 1.0);
        if step.is_nan() {
            break;
        }
        lambda = (lambda + step).max(least);
        // What is left is the square of this.
        if step.abs() <= LAST * lambda.abs() {
            break;
        }
    }
    lambda
}

/// The size of a tangential force; that of a contact that hardly presses has a square that underflows.
fn tangential_norm<const C: usize>(force: &SVector<f64, C>) -> f64 {
    let square: f64 = force.iter().skip(1).map(|x| x * x).sum();
    if (SAFE_SQUARE..1.0 / SAFE_SQUARE).contains(&square) {
        square.sqrt()
    } else {
        force.iter().skip(1).fold(0.0, |h: f64, x| h.hypot(*x))
    }
}
