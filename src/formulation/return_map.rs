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

use nalgebra::SVector;

use super::problem::{Law, Problem};
use crate::grasp::{Hold, Site};

/// Newton's steps on the secular equation: from its lower bound it gains digits from the first step on.
const STEPS: usize = 60;

/// What a contact answers to a stretch.
#[derive(Debug, Clone)]
pub(crate) enum Returned<const C: usize> {
    Open,
    Rolling(SVector<f64, C>),
    Sliding(SVector<f64, C>, Slide<C>),
}

/// A contact that slides on the round cone, to first order.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Slide<const C: usize> {
    /// Unit direction p of the friction force and of the slip; no normal component.
    pub(crate) direction: SVector<f64, C>,
    /// The diagonal of S; zero on the normal axis.
    pub(crate) held: SVector<f64, C>,
}

impl<const C: usize> Slide<C> {
    /// The slide of a contact with this friction force and this slip per force λ.
    pub(crate) fn new<const D: usize>(site: &Site<D, C>, friction: &SVector<f64, C>, lambda: f64) -> Self {
        let mut direction = *friction;
        direction[0] = 0.0;
        // A contact that hardly presses has a force whose square underflows.
        direction /= direction.amax();
        Self { direction: direction.normalize(), held: held(site, lambda) }
    }

    /// P: the friction force for μ F_n = 1 from which the spring across counts.
    pub(crate) fn pull(&self) -> SVector<f64, C> {
        let pulled = self.held.component_mul(&self.direction);
        pulled / self.direction.dot(&pulled)
    }

    /// The unit tangent across the slip, and the stiffness κ left along it.
    pub(crate) fn across(&self) -> (SVector<f64, C>, f64) {
        let (p, s) = (&self.direction, &self.held);
        let mut across = SVector::<f64, C>::zeros();
        (across[1], across[2]) = (-p[2], p[1]);
        (across, s[1] * (s[2] / p.dot(&s.component_mul(p))))
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
        self.across().0.dot(force)
    }
}

/// S, a diagonal.
fn held<const D: usize, const C: usize>(site: &Site<D, C>, lambda: f64) -> SVector<f64, C> {
    SVector::from_fn(|a, _| if a == 0 { 0.0 } else { site.k[a] / (1.0 + lambda * site.k[a]) })
}

/// The force of a contact with friction coefficient `mu` at a stretch.
pub(crate) fn return_map<const D: usize, const C: usize>(
    site: &Site<D, C>,
    mu: f64,
    stretch: &SVector<f64, C>,
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
    let lambda = slip_per_force(site, &force, traction, r);
    let slide = Slide::new(site, &held(site, lambda).component_mul(stretch), lambda);
    let friction = slide.direction * r;
    for a in 1..C {
        force[a] = friction[a];
    }
    Returned::Sliding(force, slide)
}

/// The force of a contact of a problem at a stretch, as its law has it.
pub(crate) fn respond<const D: usize, const C: usize>(
    problem: &Problem<D, C>,
    contact: usize,
    stretch: &SVector<f64, C>,
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
        _ => return_map(site, site.mu, stretch),
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
    let lambda = slip_per_force(site, &force, traction, r);
    let slide = Slide::new(site, &held(site, lambda).component_mul(stretch), lambda);
    let friction = slide.direction * r;
    for a in 1..C {
        force[a] = friction[a];
    }
    Some((force, slide))
}

/// λ with `|S(λ) v_t| = r`, from the trial traction T = K_t v_t; positive if |T| > r.
///
/// The secular equation 1/|S v| = 1/r of trust regions, nearly linear in λ. The start, that of the stiffer axis alone,
/// lies left of a positive root, and Newton's first step leads there from the right of a negative one; from there its steps
/// grow towards the root and never pass it.
fn slip_per_force<const D: usize, const C: usize>(
    site: &Site<D, C>,
    trial: &SVector<f64, C>,
    traction: f64,
    r: f64,
) -> f64 {
    let stiffest = site.k[1].max(site.k[2]);
    // With r = 0 every λ is too small: one so large that S is nothing beside K⁻¹.
    let mut lambda = (traction / r.max(traction * 1e-200) - 1.0) / stiffest;
    if site.k[1] == site.k[2] {
        return lambda;
    }
    for _ in 0..STEPS {
        let (mut square, mut slope) = (0.0, 0.0);
        for a in 1..C {
            let softened = 1.0 + lambda * site.k[a];
            let f = trial[a] / softened;
            square += f * f;
            slope += f * f * (site.k[a] / softened);
        }
        let norm = square.sqrt();
        let step = square / slope * ((norm - r) / r);
        if step.is_nan() || step.abs() <= 1e-16 * lambda.abs() {
            break;
        }
        lambda += step;
    }
    lambda
}

fn tangential_norm<const C: usize>(force: &SVector<f64, C>) -> f64 {
    force.iter().skip(1).fold(0.0, |h: f64, x| h.hypot(*x))
}
