//! How well an answer satisfies the conditions, recomputed from the question alone.

use nalgebra::SVector;

use super::answer::{Cone, ContactAnswer, ContactState};
use super::slack::{NO_FORCE, least_spring_force};
use crate::formulation::Problem;
use crate::grasp::{Grasp, Hold, Twist, Wrench, displacement_of, wrench_of};

/// Sizes below this are taken for this: products of subnormal numbers have no relative precision.
const SMALLEST: f64 = 1e-250;

/// Relative residuals of an equilibrium; all are zero in exact arithmetic.
///
/// Forces are measured against the largest contact force or load of the scene (where there is none at all, against 1e-25 of
/// the least force that a spring could have), displacements of a contact against the
/// sum of the sizes of its own displacements, products against the product of both.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[non_exhaustive]
pub struct Residuals {
    /// `|Σ F_i + W|` over the sum of the sizes of its terms and the least force that a spring could have from the
    /// displacements of its contact; the same for moments; the larger of both.
    pub equilibrium: f64,
    /// `|F/k - (a - u_c + g - s)|` axis by axis: the contact springs.
    pub springs: f64,
    /// `max(0, -F_n)` and `max(0, |F_t| - μ F_n)` over 1 + μ: the friction cone. For a polygon its own size of `F_t`.
    pub cone: f64,
    /// `max(0, -g)`: penetration.
    pub gap: f64,
    /// `|F_n g|`, and `μ F_n |s| - F_t·s` over 1 + μ, which is zero iff the slip follows the friction force.
    pub complementarity: f64,
}

impl Residuals {
    /// The largest of them.
    #[must_use]
    pub fn worst(&self) -> f64 {
        [self.equilibrium, self.springs, self.cone, self.gap, self.complementarity]
            .into_iter()
            .fold(0.0, f64::max)
    }
}

impl<const D: usize, const C: usize> Grasp<D, C> {
    /// Recomputes the residuals of an answer from points, normals, stiffnesses, commands and load. `sizes` are those of the
    /// forces and displacements that the answer is a sum of, if it is one.
    pub(crate) fn residuals(
        &self,
        problem: &Problem<D, C>,
        load: &Wrench<D>,
        twist: &Twist<D>,
        answers: &[ContactAnswer<C>],
        cone: Cone,
        [force_terms, travel_terms]: [f64; 2],
    ) -> Residuals {
        let load_force = SVector::<f64, C>::from_fn(|a, _| load.as_vector()[a]);
        let drives = &problem.drives;
        let turned: f64 = twist.as_vector().iter().skip(C).map(|x| x.abs()).sum();
        let compression = |i: usize| {
            let (f, site) = (&answers[i].force, &self.sites()[i]);
            SVector::<f64, C>::from_fn(|a, _| if a < site.axes { f[a] / site.k[a] } else { 0.0 })
        };
        // The law is about the slip since the state that the drives count from.
        let slip = |i: usize| answers[i].slip - problem.slips[i];
        let sizes: Vec<f64> = (0..self.len())
            .map(|i| {
                let contact = &self.contacts()[i];
                let own = drives[i].norm() + contact.clearance + compression(i).norm();
                let moved = twist.as_vector().norm() + turned * contact.point.norm();
                (own + moved + answers[i].gap.abs() + slip(i).norm()).max(travel_terms).max(SMALLEST)
            })
            .collect();
        let largest =
            answers.iter().fold(load_force.norm().max(force_terms), |most, c| most.max(c.force.norm()));
        let spring_force = least_spring_force(self.sites(), sizes.iter().copied());
        let force_size = largest.max(NO_FORCE * spring_force).max(SMALLEST);
        let equilibrium = self.out_of_balance(load, answers, spring_force.max(force_terms));
        let mut r = Residuals { equilibrium, ..Residuals::default() };
        for (i, (answer, site)) in answers.iter().zip(self.sites()).enumerate() {
            let (f, s, g, size) = (&answer.force, slip(i), answer.gap, sizes[i]);
            let moved = site.frame.tr_mul(&displacement_of(&self.contacts()[i].point, twist.as_vector()));
            let compression = compression(i);
            for a in 0..site.axes {
                let jump = if a == 0 { g } else { -s[a] };
                r.springs = r.springs.max((compression[a] - (drives[i][a] - moved[a] + jump)).abs() / size);
            }
            if site.hold == Hold::Bonded {
                r.gap = r.gap.max(g.abs() / size);
                r.complementarity = r.complementarity.max(s.norm() / size);
                continue;
            }
            if site.hold == Hold::Unilateral {
                r.cone = r.cone.max(-f[0] / force_size);
                r.gap = r.gap.max(-g / size);
                r.complementarity = r.complementarity.max((f[0] * g).abs() / (force_size * size));
            }
            if site.mu.is_infinite() {
                if answer.state == ContactState::Separated {
                    r.cone = r.cone.max(f.norm() / force_size);
                } else {
                    r.complementarity = r.complementarity.max(s.norm() / size);
                }
            } else if site.axes == C {
                let scale = force_size * (1.0 + site.mu);
                let (used, support) = if cone == Cone::Round {
                    (answer.friction_force(), s.norm())
                } else {
                    let most = |list: &[SVector<f64, C>], x: &SVector<f64, C>| {
                        list.iter().fold(0.0_f64, |most, h| most.max(h.dot(x)))
                    };
                    (most(&problem.polygon(i).normals, f), most(&problem.polygon(i).corners, &s))
                };
                r.cone = r.cone.max((used - site.mu * f[0]) / scale);
                let missing = site.mu * f[0] * support - f.dot(&s);
                r.complementarity = r.complementarity.max(missing.abs() / (scale * size));
            }
        }
        r
    }

    /// `spring_force` is the least force that a spring could have from the displacements of its contact, or what the forces
    /// are sums of.
    fn out_of_balance(&self, load: &Wrench<D>, answers: &[ContactAnswer<C>], spring_force: f64) -> f64 {
        let mut sum = *load.as_vector();
        let (mut force_size, mut moment_size) = (0.0, 0.0);
        for k in 0..D {
            *(if k < C { &mut force_size } else { &mut moment_size }) += sum[k].abs();
        }
        for (contact, answer) in self.contacts().iter().zip(answers) {
            sum += wrench_of::<D, C>(&contact.point, &answer.force_world);
            force_size += answer.force_world.norm();
            moment_size += contact.point.norm() * answer.force_world.norm();
        }
        // Where nothing carries anything, forces are the rounding of what the springs could do.
        force_size += spring_force;
        // A moment counts against the moments, and against the forces at the distance of the contacts.
        moment_size += force_size * self.length();
        let force = SVector::<f64, C>::from_fn(|a, _| sum[a]).norm();
        let moment = sum.iter().skip(C).map(|m| m * m).sum::<f64>().sqrt();
        let relative = |residual: f64, size: f64| residual / size.max(SMALLEST);
        relative(force, force_size).max(relative(moment, moment_size))
    }
}
