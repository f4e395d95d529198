//! The return map: computes force and state of one contact exactly from its stretch.
//!
//! Let `v = a - G_iᵀq` be the stretch, with the offset a (commanded displacement minus clearance and earlier slip), the contact's grasp map G_i and
//! the object's motion q. Let k_n be the normal stiffness, K_t the matrix of the tangential stiffnesses, and λ the slip per unit of friction force.
//! With the trial traction T = K_t v_t and the friction limit r = μ F_n, on the round cone
//!
//! ```text
//! open      k_n v_n <= 0                F = 0
//! sticking  |T| <= r                    F_t = T
//! sliding   |T| > r                     F_t = S v_t,  S = (K_t⁻¹ + λ)⁻¹,  λ > 0 from |S v_t| = r
//! ```
//!
//! A sliding contact has the slip `s = v_t - K_t⁻¹F_t = λ F_t`, along the friction force. With equal tangential stiffnesses this is the radial return
//! of plasticity. With two different tangential stiffnesses F_t is the point of the disc that is closest to T in the metric K_t⁻¹. On a polygon F_t
//! is the point of the polygon that is closest to T in this metric.

use crate::numerics::by_axis;
use nalgebra::SVector;

use super::compliance::Compliance;
use super::law::{Law, LocalLaw};
use super::polygon::corner;
use super::slide::Slide;
use super::state::{Mode, State};
use super::tangential::{cross, tangential_norm};
#[cfg(not(feature = "std"))]
use crate::prelude::*;

/// State and force of a contact at a given stretch.
#[derive(Debug, Clone, Copy)]
pub(crate) struct ContactResponse {
    pub(crate) state: State,
    /// Contact force in the contact frame, N.
    pub(crate) force: SVector<f64, 3>,
}

impl ContactResponse {
    pub(crate) fn open() -> Self {
        Self { state: Mode::Open, force: SVector::zeros() }
    }
}

impl LocalLaw<'_> {
    /// State and force of the contact at a stretch, m. The round cone limits the friction. Under [`Law::Edge`] a single facet limits it, the tangent
    /// plane of the cone. The iteration for λ, the slip per unit of friction force, starts at `near`: λ at a nearby stretch, or zero.
    pub(crate) fn answer(&self, stretch: &SVector<f64, 3>, near: f64) -> ContactResponse {
        let mut force = self.springs.force(stretch);
        let sticking = ContactResponse { state: Mode::Sticking, force };
        match self.law {
            Law::Absent => return ContactResponse::open(),
            Law::Bonded => return sticking,
            Law::Edge(facets) => {
                let excess = -self.friction.facet_margin(&force, &facets[0]);
                if excess <= 0.0 {
                    return sticking;
                }
                let pull = Slide { direction: facets[0], lambda: 0.0 }.edge(self.springs).pull;
                return ContactResponse { state: Mode::Facet(0), force: force - pull * excess };
            }
            Law::Cone { gap: true } if force[0] <= 0.0 => return ContactResponse::open(),
            Law::Cone { .. } if !self.friction.has_edges() => return sticking,
            Law::Cone { .. } => {}
        }
        let r = self.friction.limit(force[0].max(0.0));
        let traction = tangential_norm(&force);
        if traction <= r {
            return sticking;
        }
        let lambda = slip_per_force(self.springs, &force, traction, r, near);
        let slide = self.slide_onto_the_cone(&mut force, r, lambda);
        ContactResponse { state: Mode::Round(slide), force }
    }

    /// Replaces the tangential part of a trial force by friction of the magnitude r, the limit μ F_n in N, and returns the slide. The friction has
    /// the direction of `S v_t`. The matrix S = (K_t⁻¹ + λ)⁻¹ is the tangential stiffness, reduced by the slip λ per unit of friction force.
    fn slide_onto_the_cone(&self, force: &mut SVector<f64, 3>, r: f64, lambda: f64) -> Slide {
        let softened = by_axis(|a| if a == 0 { 0.0 } else { force[a] * self.springs.softening(a, lambda) });
        let slide = Slide::new(&softened, lambda);
        for a in 1..3 {
            force[a] = slide.direction[a] * r;
        }
        slide
    }

    /// State and force of the contact at a stretch, m, on the cone in use, round or polygonal. On the round cone the iteration for the slip per unit
    /// of friction force starts at `near`, m/N.
    #[inline]
    pub(crate) fn response(&self, stretch: &SVector<f64, 3>, near: f64) -> ContactResponse {
        if self.on_round_cone { self.answer(stretch, near) } else { self.answer_on_polygon(stretch) }
    }

    /// State and force of the contact at a stretch, m, on the polygonal cone. The force is the point of the cone that is closest to the trial force
    /// in the metric K⁻¹.
    #[inline]
    fn answer_on_polygon(&self, stretch: &SVector<f64, 3>) -> ContactResponse {
        if self.is_absent() {
            return ContactResponse::open();
        }
        let trial = self.springs.force(stretch);
        let facets = self.facets();
        let state = self.state_on_polygon(facets, &trial);
        let force = match state {
            Mode::Open => SVector::zeros(),
            Mode::Sticking | Mode::Round(_) => trial,
            Mode::Facet(j) => {
                let excess = -self.cone().facet_margin(&trial, &facets[usize::from(j)]);
                trial - self.edge(&state).pull * excess
            }
            Mode::Corner(_) => self.cone().generator(&self.edge(&state).pull) * trial[0],
        };
        ContactResponse { state, force }
    }

    /// The state at the trial force `K v`, the elastic force of a contact that is stretched by v and neither opens nor slips.
    #[inline]
    fn state_on_polygon(&self, facets: &[SVector<f64, 3>], trial: &SVector<f64, 3>) -> State {
        if trial[0] <= 0.0 && self.may_open() {
            return Mode::Open;
        }
        if facets.is_empty() {
            return Mode::Sticking;
        }
        let r = self.cone().limit(trial[0]);
        if !self.is_planar() {
            self.nearest_of_polygon(facets, trial, r)
        } else if trial[1].abs() <= r {
            Mode::Sticking
        } else {
            Mode::Facet(u16::from(trial[1] < 0.0))
        }
    }

    /// The state, sticking or sliding, at the point of the polygon `h·F_t <= r` that is closest to a trial force. The h are the normals `facets`, and
    /// r is the friction limit, N.
    fn nearest_of_polygon(&self, facets: &[SVector<f64, 3>], trial: &SVector<f64, 3>, r: f64) -> State {
        let after = |j: u16| if usize::from(j) + 1 == facets.len() { 0 } else { j + 1 };
        let (mut facet, mut last, mut most) = (0_u16, 0, f64::NEG_INFINITY);
        for (j, h) in (0_u16..).zip(facets) {
            let reached = h.dot(trial);
            if reached > most {
                (facet, most) = (j, reached);
            }
            last = j;
        }
        if most <= r {
            return Mode::Sticking;
        }
        // Moves from facet to facet. `on_it` is the trial force projected onto the current facet. The next facet is the neighbour whose condition
        // `h·F_t <= r` this projection violates. With equal tangential springs the first facet is final.
        for _ in facets {
            let h = &facets[usize::from(facet)];
            let softened = self.springs.force(h);
            let on_it = trial - softened * ((h.dot(trial) - r) / h.dot(&softened));
            let (next, before) = (after(facet), if facet == 0 { last } else { facet - 1 });
            let outside = |j: u16| facets[usize::from(j)].dot(&on_it) > r;
            let (after_next, before_it) = (outside(next), outside(before));
            let at = if after_next {
                facet
            } else if before_it {
                before
            } else {
                return Mode::Facet(facet);
            };
            // At a corner the slip must be a nonnegative combination of both facet normals.
            let (h1, h2) = (&facets[usize::from(at)], &facets[usize::from(after(at))]);
            let slip = self.springs.deflection(&(trial - corner(h1, h2) * r));
            let turn = cross(h1, h2);
            if cross(&slip, h2) / turn >= 0.0 && cross(h1, &slip) / turn >= 0.0 {
                return Mode::Corner(at);
            }
            facet = if after_next { next } else { before };
        }
        Mode::Facet(facet)
    }
}

/// The slip λ per unit of friction force, m/N, of a sliding contact with the friction limit r: `|S v_t| = r`, where S = (K_t⁻¹ + λ)⁻¹ and v_t is the
/// tangential stretch. `trial` is the trial traction K_t v_t and `traction` its length; λ is positive if `traction` exceeds r. Newton's method starts
/// at `near`.
///
/// The equation is solved in the form 1/|S v_t| = 1/r, known as the secular equation of trust-region methods. Its left side is concave in λ and
/// nearly linear. From any start the first Newton step therefore leads to a λ below the root. From there λ increases towards the root and never
/// passes it.
fn slip_per_force(springs: &Compliance, trial: &SVector<f64, 3>, traction: f64, r: f64, near: f64) -> f64 {
    // If r were 0, λ would be infinite. The friction limit r is therefore raised to at least 1e-200 of the traction. At this ratio S is already
    // negligible compared with K_t.
    let excess = traction / r.max(traction * 1e-200);
    if springs.is_isotropic() {
        return springs.deflection_along(1, excess - 1.0);
    }
    let unit = trial / traction;
    // A starting λ above 1e100 times the compliance of the stiffest spring is replaced by zero. With such a λ the squares of the softened stiffnesses
    // would underflow, and Newton's steps could not lead back to the root.
    let mut lambda = if near * springs.stiffest() < 1e100 { near } else { 0.0 };
    // λ is at least 0 if the traction is at least r. For a shorter traction λ is negative (slip against the friction force). Its lower bound is then
    // the λ at which the softer spring alone has the force r. The bound must also exceed -1/k of the stiffer spring, where 1 + λk vanishes.
    let [soft, stiff] = springs.tangential_range();
    // The iteration stops when λ changes by at most this fraction. The lower bound of λ keeps the same relative distance from the pole at -1/k of the
    // stiffer spring.
    let last = 1e-8;
    let least = if excess >= 1.0 { 0.0 } else { ((excess - 1.0) / soft).max(-(1.0 - last) / stiff) };
    // This is an upper bound of the number of Newton steps for λ; as a rule a few suffice. If λ is nearly zero, rounding may keep its relative change
    // above `last`, and the bound ends the loop.
    for _ in 0..60 {
        let softened = springs.softened(lambda);
        let (mut square, mut slope) = (0.0, 0.0);
        for a in 1..3 {
            let f = unit[a] * springs.softening(a, lambda);
            square += f * f;
            slope += f * f * softened[a];
        }
        let step = square / slope * (square.sqrt() * excess - 1.0);
        if step.is_nan() {
            break;
        }
        lambda = (lambda + step).max(least);
        // Newton's method converges quadratically: the remaining error is of the order of the squared step.
        if step.abs() <= last * lambda.abs() {
            break;
        }
    }
    lambda
}
