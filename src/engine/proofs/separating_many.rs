//! A separating motion in many coordinates: the part of the load that no admissible contact forces balance.
//!
//! Some sum of admissible contact forces f_i comes nearest to balancing the load W, and leaves the residual `v = Σ G_i f_i + W` with the grasp
//! maps G_i. An augmented Lagrangian with penalty ρ finds this sum. Each contact responds to the motion v with a force f_i in its cone. This
//! force depends on a multiplier λ_i, the force of the contact in the last round of the method:
//!
//! ```text
//! f_i = P_i(λ_i - ρ G_iᵀv),      v - Σ G_i f_i = W,      λ_i <- f_i,
//! ```
//!
//! with the projection P_i onto the cone. Each round is a convex problem without constraints. Newton's method solves it with a narrow band matrix,
//! since each contact couples few coordinates. The residual found is checked like a motion from any other source.
//!
//! Source: R. T. Rockafellar, Augmented Lagrangians and applications of the proximal point algorithm in convex programming, Math. Oper. Res. 1
//! (1976).

use nalgebra::{SMatrix, SVector};

use super::wrench_cone::{Generator, straight_generators};
use crate::contact::{tangential, tangential_norm};
use crate::numerics::tolerances::SUFFICIENT_DECREASE;
use crate::numerics::{
    IntoList, PositiveBand, Vector, by_axis, dot, mapped, narrow_order, paired, unit, widest,
};
use crate::object::Problem;
use crate::prelude::*;

/// The round friction cone of a contact, or one generator (ray) of a cone that is not round. In the augmented Lagrangian it responds to a motion with
/// a force.
struct PenalisedCone {
    /// The coordinates that move the contact. Each has its position in the order of elimination, and its row of the contact's grasp map. The grasp
    /// map is scaled so that a unit force along the first axis has a wrench of length one.
    coupled: Vec<(usize, SVector<f64, 3>)>,
    /// μ of a round cone; `None` for a cone that is a single ray, along the first axis.
    cone: Option<f64>,
    /// The multiplier λ_i of the augmented Lagrangian: the force of this cone or generator in the last round.
    multiplier: SVector<f64, 3>,
}

impl PenalisedCone {
    /// The projection of x onto the cone, and its derivative with respect to x.
    fn nearest(&self, x: &SVector<f64, 3>) -> (SVector<f64, 3>, SMatrix<f64, 3, 3>) {
        let Some(mu) = self.cone else {
            let normal = unit::<3>(0);
            let pushes = x[0] > 0.0;
            let derivative = if pushes { normal * normal.transpose() } else { SMatrix::zeros() };
            return (if pushes { normal * x[0] } else { SVector::zeros() }, derivative);
        };
        let size = tangential_norm(x);
        if size <= mu * x[0] {
            return (*x, SMatrix::identity());
        }
        if mu * size <= -x[0] {
            return (SVector::zeros(), SMatrix::zeros());
        }
        let (normal, along) = (unit::<3>(0), tangential(x) / size);
        let edge = normal + along * mu;
        let coefficient = edge.dot(x) / edge.norm_squared();
        let across = SMatrix::identity() - normal * normal.transpose() - along * along.transpose();
        let derivative = edge * edge.transpose() / edge.norm_squared() + across * (mu * coefficient / size);
        (edge * coefficient, derivative)
    }

    fn motion_at(&self, v: &[f64]) -> SVector<f64, 3> {
        self.coupled.iter().fold(SVector::zeros(), |sum, (k, g)| sum + g * v[*k])
    }
}

/// The problem of the augmented Lagrangian: cones and load, with the coordinates in an order (`numbers`) in which the Newton matrix is a narrow
/// band.
struct AugmentedLagrangian {
    contacts: Vec<PenalisedCone>,
    numbers: Vec<usize>,
    /// The load, scaled to length one.
    load: Vec<f64>,
    band: PositiveBand,
    /// The penalty ρ of the augmented Lagrangian.
    penalty: f64,
}

/// The part of a load of many coordinates that no admissible contact forces balance.
pub(super) enum Residual {
    /// The residual is a motion that separates the load from all admissible contact forces.
    Proof(Vector),
    /// There is a residual, but after all rounds of the method it still does not prove that the load is unbalanced.
    Unclear,
    /// There is no residual, since the load is balanced; or the method does not apply, since a contact law is not a cone.
    Nothing,
}

/// The residual after some rounds of the augmented Lagrangian: the part of the load that no admissible contact forces balance. The load is first
/// scaled to length one. `is_proof` decides whether a residual, taken as a motion, proves that no contact forces balance the load. If none does, the
/// result tells why nothing is proved.
pub(super) fn residual_of_many(problem: &Problem, is_proof: &dyn Fn(&Vector) -> bool) -> Residual {
    let Some(mut pushed) = AugmentedLagrangian::of(problem) else {
        return Residual::Nothing;
    };
    let mut v = pushed.load.clone();
    let (mut more, mut clearer, mut proof) = (0, 0, None);
    // The search ends after six rounds with the largest penalty ρ, or three rounds after a residual first proves that the load is unbalanced. These
    // three rounds remove rounding from the separating motion, which is shown to users.
    while more < 6 && clearer < 4 {
        // A round of the method ends once the imbalance, relative to the load, is at most `enough`. Before a residual proves that the load is
        // unbalanced, this is 1e-3 / ρ, with the penalty ρ, to save Newton steps. Afterwards it is 1e-14, to remove rounding.
        let least = 1e-14;
        let enough = if proof.is_some() { least } else { (1e-3 / pushed.penalty).max(least) };
        let Some(left) = pushed.round(&mut v, enough) else { break };
        // If admissible forces balance the load up to the fraction 1e-5, the load counts as balanced. A round may end with an imbalance of 1e-3 / ρ,
        // which is 1e-4 in the first round. As ρ grows, later rounds recognise a balanced load that the first did not.
        if left < 1e-5 {
            return Residual::Nothing;
        }
        let motion = Vector::from_fn(problem.size(), |k| v[pushed.numbers[k]]);
        if is_proof(&motion) {
            proof = Some(motion);
        }
        clearer += usize::from(proof.is_some());
        // The penalty ρ grows tenfold in each round, up to 1e8. With a larger ρ the Newton steps lose too many digits.
        if pushed.penalty < 1e8 {
            pushed.penalty *= 10.0;
        } else {
            more += 1;
        }
    }
    proof.map_or(Residual::Unclear, Residual::Proof)
}

impl AugmentedLagrangian {
    fn of(problem: &Problem) -> Option<Self> {
        let count = problem.size().count();
        let couplings: Vec<_> = mapped(problem.sites, &|site| site.support.ranges());
        let numbers = narrow_order(count, &couplings);
        let band = PositiveBand::zeros(count, widest(&numbers, &couplings));
        let coupled = |contact: usize| {
            let mut coupled = Vec::new();
            for range in &couplings[contact] {
                range.clone().map(|k| (k, numbers[k])).append_to(&mut coupled);
            }
            coupled
        };
        let ray = |Generator { contact, wrench, .. }: Generator| {
            let along = |(k, number): &(usize, usize)| (*number, unit::<3>(0) * wrench[*k]);
            PenalisedCone {
                coupled: mapped(&coupled(contact), &along),
                cone: None,
                multiplier: SVector::zeros(),
            }
        };
        let mut contacts: Vec<_> = straight_generators(problem)?.into_iter().map(ray).list();
        for (contact, (local, site)) in problem.locals().zip(problem.sites).enumerate() {
            if !local.is_round() {
                continue;
            }
            let size = site.map.column(0).norm();
            let entry = |(k, number): &(usize, usize)| (*number, by_axis(|a| site.map[(*k, a)] / size));
            let cone = Some(local.cone().limit(1.0));
            contacts.push(PenalisedCone {
                coupled: mapped(&coupled(contact), &entry),
                cone,
                multiplier: SVector::zeros(),
            });
        }
        let mut load = vec![0.0; count];
        let size = problem.wrench.norm();
        problem.wrench.iter().zip(&numbers).for_each(|(w, k)| load[*k] = w / size);
        // The penalty ρ of the first round.
        Some(Self { contacts, numbers, load, band, penalty: 1e1 })
    }

    /// One round: finds the residual v of `v - Σ G_i f_i = W` (contact forces f_i, grasp maps G_i, load W) up to an error `enough`, and updates
    /// the multipliers. Returns the norm of the load that contact forces do not balance; `None` if a factorisation fails.
    fn round(&mut self, v: &mut Vec<f64>, enough: f64) -> Option<f64> {
        let mut missing = self.missing(v);
        // Upper limit of the number of Newton steps in a round of the method.
        for _ in 0..12 {
            if norm(&missing) <= enough {
                break;
            }
            self.factor(v)?;
            let mut step = missing.clone();
            self.band.solve(&mut step);
            let falls = dot(&missing, &step);
            let mut part = 1.0;
            for shorter in 0.. {
                let next: Vec<f64> = paired(v, &step, &|(v, step)| v + step * part);
                missing = self.missing(&next);
                let rises = -dot(&missing, &step);
                // Line search: the step is shortened, at most twelve times, while the convex function that the round minimises still rises at
                // the end of the step. A rate of rise up to the fraction `SUFFICIENT_DECREASE` of the initial rate of descent is accepted.
                if rises <= SUFFICIENT_DECREASE * falls || shorter == 12 {
                    *v = next;
                    break;
                }
                part *= (falls / (falls + rises)).clamp(0.1, 0.9);
            }
        }
        let mut left = self.load.clone();
        for contact in &mut self.contacts {
            let asked = contact.multiplier - contact.motion_at(v) * self.penalty;
            contact.multiplier = contact.nearest(&asked).0;
            contact.coupled.iter().for_each(|(k, g)| left[*k] += g.dot(&contact.multiplier));
        }
        Some(norm(&left))
    }

    /// The imbalance `W + Σ G_i f_i - v` of the load W, the contact forces f_i with grasp maps G_i, and the residual v.
    fn missing(&self, v: &[f64]) -> Vec<f64> {
        let mut sum: Vec<f64> = self.load.iter().zip(v).map(|(w, v)| w - v).list();
        for contact in &self.contacts {
            let asked = contact.multiplier - contact.motion_at(v) * self.penalty;
            let force = contact.nearest(&asked).0;
            contact.coupled.iter().for_each(|(k, g)| sum[*k] += g.dot(&force));
        }
        sum
    }

    /// Factorises the Newton matrix `1 + ρ Σ G P' Gᵀ` at the residual v, with penalty ρ and grasp maps G. P' are the derivatives of the projections
    /// onto the cones. `None` if the matrix is not positive definite.
    fn factor(&mut self, v: &[f64]) -> Option<()> {
        let Self { contacts, band, penalty, .. } = self;
        band.clear();
        (0..v.len()).for_each(|k| band.add(k, k, 1.0));
        for contact in contacts {
            let asked = contact.multiplier - contact.motion_at(v) * *penalty;
            let derivative = contact.nearest(&asked).1 * *penalty;
            if derivative.amax() == 0.0 {
                continue;
            }
            for (j, h) in &contact.coupled {
                let pushed = derivative * h;
                for (i, g) in contact.coupled.iter().filter(|(i, _)| i >= j) {
                    band.add(*i, *j, g.dot(&pushed));
                }
            }
        }
        band.factor()
    }
}

fn norm(list: &[f64]) -> f64 {
    dot(list, list).sqrt()
}
