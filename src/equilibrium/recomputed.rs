//! How well an answer satisfies the conditions, recomputed from the question alone.

use nalgebra::SVector;

use super::answer::{Cone, ContactAnswer, ContactState};
use super::residuals::Residuals;
use crate::contact::Polygon;
use crate::grasp::{Grasp, Hold, Site, Twist, Wrench, displacement_of, wrench_of};
use crate::object::{NO_FORCE, Problem, least_spring_force};

/// Sizes below this are taken for this: products of subnormal numbers have no relative precision.
const SMALLEST: f64 = 1e-250;
/// Displacements below this part of the largest of the scene are none.
const STILL: f64 = 1e-20;

/// What a contact has to satisfy, and what its residuals are measured against, N and m.
struct ContactLaw<'c, const D: usize, const C: usize> {
    site: &'c Site<D, C>,
    polygon: &'c Polygon<C>,
    cone: Cone,
    force_size: f64,
    travel: f64,
}

impl Residuals {
    /// Takes in those of one contact, with its stretch and its slip since the state was decided.
    fn note<const D: usize, const C: usize>(
        &mut self,
        law: &ContactLaw<'_, D, C>,
        answer: &ContactAnswer<C>,
        stretch: &SVector<f64, C>,
        s: &SVector<f64, C>,
    ) {
        let ContactLaw { site, polygon, cone, force_size, travel } = *law;
        let (f, g, friction) = (&answer.force, answer.gap, site.friction);
        let give = site.springs.give(f);
        for a in 0..site.springs.axes() {
            let jump = if a == 0 { g } else { -s[a] };
            self.springs = self.springs.max((give[a] - (stretch[a] + jump)).abs() / travel);
        }
        if site.hold == Hold::Bonded {
            self.gap = self.gap.max(g.abs() / travel);
            self.complementarity = self.complementarity.max(s.norm() / travel);
            return;
        }
        if site.hold == Hold::Unilateral {
            self.cone = self.cone.max(-f[0] / force_size);
            self.gap = self.gap.max(-g / travel);
            self.complementarity = self.complementarity.max((f[0] * g).abs() / (force_size * travel));
        }
        if friction.is_infinite() {
            if answer.state == ContactState::Separated {
                self.cone = self.cone.max(f.norm() / force_size);
            } else {
                self.complementarity = self.complementarity.max(s.norm() / travel);
            }
        } else if site.springs.resists_tangentially() {
            let scale = force_size * friction.round_weight();
            let (used, support) = if cone == Cone::Round {
                (answer.friction_force(), s.norm())
            } else {
                let most = |list: &[SVector<f64, C>], x: &SVector<f64, C>| {
                    list.iter().fold(0.0_f64, |most, h| most.max(h.dot(x)))
                };
                (most(&polygon.normals, f), most(&polygon.corners, s))
            };
            let limit = friction.limit(f[0]);
            self.cone = self.cone.max((used - limit) / scale);
            let missing = limit * support - f.dot(s);
            self.complementarity = self.complementarity.max(missing.abs() / (scale * travel));
        }
    }
}

impl<const D: usize, const C: usize> Grasp<D, C> {
    /// Recomputes the residuals of an answer from points, normals, stiffnesses, commands and load. `sizes` are those of the
    /// forces and displacements that the answer is a sum of, if it is one.
    pub(crate) fn residuals(
        &self,
        problem: &Problem<D, C>,
        load: &Wrench<D, C>,
        twist: &Twist<D, C>,
        answers: &[ContactAnswer<C>],
        cone: Cone,
        [force_terms, travel_terms]: [f64; 2],
    ) -> Residuals {
        // Comparisons below pass over what is not a number.
        let finite = |c: &ContactAnswer<C>| {
            c.gap.is_finite() && c.force.iter().chain(&c.force_world).chain(&c.slip).all(|x| x.is_finite())
        };
        if !answers.iter().all(finite) || !twist.as_vector().iter().all(|x| x.is_finite()) {
            return Residuals::NONE_HOLDS;
        }
        let load_force = SVector::<f64, C>::from_fn(|a, _| load.as_vector()[a]);
        let turned: f64 = twist.as_vector().iter().skip(C).map(|x| x.abs()).sum();
        // The law is about the slip since the state that the drives count from.
        let slip = |i: usize| answers[i].slip - problem.slips[i];
        let mut travels: Vec<f64> = (0..self.len())
            .map(|i| {
                let contact = &self.contacts()[i];
                let give = self.sites()[i].springs.give(&answers[i].force).norm();
                let own = problem.drives[i].norm() + contact.clearance.abs() + give;
                let moved = twist.as_vector().norm() + turned * contact.point.norm();
                (own + moved + answers[i].gap.abs() + slip(i).norm()).max(travel_terms).max(SMALLEST)
            })
            .collect();
        // Where nothing is driven and the object stays, what is left is the rounding of the rounding elsewhere.
        let still = STILL * travels.iter().copied().fold(0.0, f64::max);
        for travel in &mut travels {
            *travel = travel.max(still);
        }
        let largest =
            answers.iter().fold(load_force.norm().max(force_terms), |most, c| most.max(c.force.norm()));
        let spring_force = least_spring_force(self.sites(), travels.iter().copied());
        let force_size = largest.max(NO_FORCE * spring_force).max(SMALLEST);
        let equilibrium = self.out_of_balance(load, answers, spring_force.max(force_terms));
        let mut r = Residuals { equilibrium, ..Residuals::default() };
        for (i, answer) in answers.iter().enumerate() {
            let site = &self.sites()[i];
            let point = &self.contacts()[i].point;
            let moved = site.frame.tr_mul(&displacement_of(point, twist.as_vector()));
            let stretch = problem.drives[i] - moved;
            let law = ContactLaw { site, polygon: problem.polygon(i), cone, force_size, travel: travels[i] };
            r.note(&law, answer, &stretch, &slip(i));
        }
        r
    }

    /// `spring_force` is the least force that a spring could have from the displacements of its contact, or what the forces
    /// are sums of.
    fn out_of_balance(&self, load: &Wrench<D, C>, answers: &[ContactAnswer<C>], spring_force: f64) -> f64 {
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

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use crate::contact::{Polygon, PolygonCone};
    use crate::equilibrium::Residuals;
    use crate::grasp::{Contact, Grasp, Twist, Wrench};
    use crate::object::{Load, Problem};

    /// A comparison with a bound must fail wherever anything is not finite.
    #[test]
    fn what_is_not_finite_holds_nowhere() -> Result<(), Box<dyn std::error::Error>> {
        let jaw = |side: f64| {
            Contact::new([side, 0.0], [-side, 0.0])
                .series_stiffness(1e3, 8e2)
                .friction(0.5)
                .command([0.01, 0.0])
        };
        let grasp = Grasp::<3, 2>::new([jaw(-1.0), jaw(1.0)])?;
        let load = Wrench::<3, 2>::force([0.0, -1.0]);
        let answer = grasp.solve(&load)?.equilibrium().ok_or("the jaws hold")?.clone();
        let wrench = grasp.inside(&load, "load")?;
        let polygon = Arc::new(Polygon::new(&PolygonCone::default()));
        let problem = Problem::at_rest(grasp.sites(), polygon, false, grasp.drives(), &Load::from(&wrench));
        let worst = |twist: &Twist<3, 2>, contacts: &[_]| {
            grasp.residuals(&problem, &load, twist, contacts, answer.cone, [0.0; 2]).worst()
        };
        assert!(worst(&answer.twist, &answer.contacts) < 1e-14);
        for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            let lost = Twist::from_vector([0.0, bad, 0.0]);
            assert_eq!(worst(&lost, &answer.contacts), f64::INFINITY);
            for part in 0..4 {
                let mut contacts = answer.contacts.clone();
                match part {
                    0 => contacts[1].force[1] = bad,
                    1 => contacts[1].force_world[0] = bad,
                    2 => contacts[0].slip[1] = bad,
                    _ => contacts[0].gap = bad,
                }
                assert_eq!(worst(&answer.twist, &contacts), f64::INFINITY, "{part} {bad}");
            }
        }
        for k in 0..5 {
            let mut r = [0.0; 5];
            r[k] = f64::NAN;
            let [equilibrium, springs, cone, gap, complementarity] = r;
            let residuals = Residuals { equilibrium, springs, cone, gap, complementarity };
            assert_eq!(residuals.worst(), f64::INFINITY, "{k}");
        }
        Ok(())
    }
}
