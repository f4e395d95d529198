//! The exact force of one contact by Coulomb's law, with the forces of all others fixed.
//!
//! The force r of the contact gives it the velocity u = A r + b. A is the contact's diagonal block of the matrix W, which maps contact forces to
//! velocities, and b its velocity without its own force. N and T mark normal and tangential parts. The contact is open if b_N ≥ 0. Otherwise u_N = 0
//! gives r_N = −(b_N + A_NTᵀ r_T) / A_NN and u_T = S r_T + c, with
//!
//! ```text
//! S = A_TT − A_TN A_NTᵀ / A_NN,     c = b_T − A_TN b_N / A_NN.
//! ```
//!
//! Slip opposes friction, u_T = −κ r_T with κ ≥ 0, so r_T(κ) = −(S + κ 1)⁻¹ c. The contact sticks if ‖r_T‖ ≤ μ r_N at κ = 0. Otherwise the force is
//! outside the cone at κ = 0. As κ increases to infinity, r_T vanishes and r_N tends to −b_N / A_NN > 0, a force inside the cone. For some κ between,
//! the force is on the boundary of the cone.

use super::blocks::ContactBlock;
use super::law::tangent;
use crate::numerics::regula_falsi;
use nalgebra::SVector;

/// The force of a contact whose diagonal block of the matrix W is `a`, with the coefficient of friction `mu`; `b` is the velocity of the contact
/// without its own force. `None` if the block is not definite enough for a force to stop the approach, or if numbers overflow.
pub(super) fn answer<const C: usize>(
    a: &ContactBlock<C>,
    b: &SVector<f64, C>,
    mu: f64,
) -> Option<SVector<f64, C>> {
    if b[0] >= 0.0 {
        return Some(SVector::zeros());
    }
    if a[(0, 0)] <= 0.0 {
        return None;
    }
    let mut pressed = SVector::zeros();
    pressed[0] = -b[0] / a[(0, 0)];
    if mu == 0.0 {
        return Some(pressed);
    }
    let slide = Slide::new(a, b);
    let miss = |r: &SVector<f64, C>| tangent(r).norm() - mu * r[0];
    let stuck = slide.at(0.0);
    if let Some(stuck) = stuck.filter(|r| miss(r) <= 0.0) {
        return Some(stuck);
    }
    // First an interval is sought that contains the root κ, the ratio of slip speed to friction force. At κ = `least` the force is outside the cone,
    // at κ = `most` inside.
    let (mut least, mut most) = (0.0, slide.size);
    while slide.at(most).is_none_or(|r| miss(&r) > 0.0) {
        least = most;
        most *= 16.0;
        if !most.is_finite() {
            return None;
        }
    }
    // If the force at a trial κ overflows, it counts as infinitely far outside the cone.
    let mut left = |kappa: f64| slide.at(kappa).map_or(f64::INFINITY, |r| miss(&r));
    let bracket = [(least, left(least)), (most, left(most))];
    let mut r = slide.at(regula_falsi(bracket, 0.0, &mut left)?)?;
    // The rounding error of κ leaves the force slightly off the boundary of the cone. It is moved exactly onto the boundary.
    let size = tangent(&r).norm();
    if size > 0.0 {
        for k in 1..C {
            r[k] *= mu * r[0] / size;
        }
    }
    r.iter().all(|x| x.is_finite()).then_some(r)
}

/// The forces of a sliding contact with normal velocity zero, as functions of κ, the slip speed per unit of friction force.
struct Slide<const C: usize> {
    /// The matrix S of the slip velocity u_T = S r_T + c, as a function of the friction force r_T. Its normal row and column are those of the
    /// identity matrix, so that S can be inverted as a C × C matrix.
    s: ContactBlock<C>,
    c: SVector<f64, C>,
    /// −b_N / A_NN: the normal force without friction. A is the contact's diagonal block of the matrix W, b its velocity without its own force.
    /// The normal force is `normal` minus `coupling` times the friction force.
    normal: f64,
    /// A_NT / A_NN: the decrease of the normal force per unit of friction force, at normal velocity zero.
    coupling: SVector<f64, C>,
    /// The largest entry of the matrix S in u_T = S r_T + c, or A_NN if S is zero. A_NN is the normal velocity per unit of normal force.
    size: f64,
}

impl<const C: usize> Slide<C> {
    fn new(a: &ContactBlock<C>, b: &SVector<f64, C>) -> Self {
        let own = a[(0, 0)];
        let mut s = *a - a.column(0) * a.row(0) / own;
        let size = s.amax();
        s.row_mut(0).fill(0.0);
        s.column_mut(0).fill(0.0);
        s[(0, 0)] = 1.0;
        let c = tangent(&(b - a.column(0) * (b[0] / own)));
        let coupling = tangent(&(a.row(0).transpose() / own));
        Self { s, c, normal: -b[0] / own, coupling, size: if size > 0.0 { size } else { own } }
    }

    /// The contact force for a given κ, the ratio of slip speed to friction force; `None` if this force is not finite.
    fn at(&self, kappa: f64) -> Option<SVector<f64, C>> {
        let mut shifted = self.s;
        for k in 1..C {
            shifted[(k, k)] += kappa;
        }
        let slip = solved(&shifted, &-self.c)?;
        let mut r = slip;
        r[0] = self.normal - self.coupling.dot(&slip);
        r.iter().all(|x| x.is_finite()).then_some(r)
    }
}

/// The tangential components of the solution of A x = b, by Cramer's rule. `None` if they are not finite.
fn solved<const C: usize>(a: &ContactBlock<C>, b: &SVector<f64, C>) -> Option<SVector<f64, C>> {
    let mut x = SVector::<f64, C>::zeros();
    if C == 2 {
        x[1] = b[1] / a[(1, 1)];
    } else {
        let (p, q, r, s) = (a[(1, 1)], a[(1, C - 1)], a[(C - 1, 1)], a[(C - 1, C - 1)]);
        let determinant = p * s - q * r;
        x[1] = (s * b[1] - q * b[C - 1]) / determinant;
        x[C - 1] = (p * b[C - 1] - r * b[1]) / determinant;
    }
    x.iter().all(|x| x.is_finite()).then_some(x)
}
