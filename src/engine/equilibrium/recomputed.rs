//! Residuals of an equilibrium, recomputed from the numbers given for grasp, commands and load, not from the solver's matrices. The offset of a
//! contact is its commanded displacement minus clearance and earlier slip. A drive, the spring of a joint or tendon of a hand, is treated like a
//! contact.

use nalgebra::SVector;

use super::cone::Cone;
use super::contact_answer::{ContactAnswer, ContactState};
use super::residuals::Residuals;
use crate::contact::{Coulomb, Polygon, SMALLEST};
use crate::grasp::{Engine, Hold, Site, Wrench};
use crate::numerics::{IntoList, Reals, Vector, numbered};
use crate::object::{NO_FORCE, Problem, least_spring_force};
use crate::prelude::*;
use crate::search::SearchSolution;

/// The force and displacements of one contact, or of one drive of a hand, from which its residuals are computed.
struct SiteAnswer<'a> {
    force: &'a SVector<f64, 3>,
    gap: f64,
    separated: bool,
    stretch: SVector<f64, 3>,
    /// Slip, m, without the slip accumulated earlier on a load path, which the offsets contain already. Only this part of the slip obeys the contact
    /// law.
    slip: SVector<f64, 3>,
}

/// The law of one contact or drive, and the force and displacement by which its residuals are divided.
struct ContactLaw<'c> {
    site: &'c Site,
    friction: Coulomb,
    polygon: &'c Polygon,
    cone: Cone,
    /// Divisor of residuals of force, N: the largest force of the grasp, with a lower bound.
    force_size: f64,
    /// Divisor of residuals of displacement, m: the sum of the magnitudes of the contact's displacements, with a lower bound.
    displacement_size: f64,
}

impl Residuals {
    /// Takes one contact or drive into account: each residual becomes the larger of its present value and the residual of this contact. The residual
    /// of equilibrium, which all contacts have together, stays unchanged.
    fn note(&mut self, law: &ContactLaw<'_>, site_answer: &SiteAnswer<'_>) {
        let ContactLaw { site, friction, polygon, cone, force_size, displacement_size } = *law;
        let SiteAnswer { force: f, gap: g, separated, stretch, slip: s } = *site_answer;
        let give = site.springs.deflection(f);
        for a in 0..site.springs.axes() {
            let jump = if a == 0 { g } else { -s[a] };
            self.springs = self.springs.max((give[a] - (stretch[a] + jump)).abs() / displacement_size);
        }
        if site.hold == Hold::Bonded {
            self.gap = self.gap.max(g.abs() / displacement_size);
            self.complementarity = self.complementarity.max(s.norm() / displacement_size);
            return;
        }
        if site.hold == Hold::Unilateral {
            self.cone = self.cone.max(-f[0] / force_size);
            self.gap = self.gap.max(-g / displacement_size);
            self.complementarity =
                self.complementarity.max((f[0] * g).abs() / (force_size * displacement_size));
        }
        if friction.is_infinite() {
            if separated {
                self.cone = self.cone.max(f.norm() / force_size);
            } else {
                self.complementarity = self.complementarity.max(s.norm() / displacement_size);
            }
        } else if site.springs.resists_tangentially() {
            let scale = force_size * friction.round_weight();
            let (used, support) = if cone == Cone::Round {
                (f.iter().skip(1).fold(0.0, |h: f64, f| h.hypot(*f)), s.norm())
            } else {
                let most = |list: &[SVector<f64, 3>], x: &SVector<f64, 3>| {
                    list.iter().fold(0.0_f64, |most, h| most.max(h.dot(x)))
                };
                (most(&polygon.normals, f), most(&polygon.corners, &s))
            };
            let limit = friction.limit(f[0]);
            self.cone = self.cone.max((used - limit) / scale);
            let missing = limit * support - f.dot(&s);
            self.complementarity = self.complementarity.max(missing.abs() / (scale * displacement_size));
        }
    }
}

impl Engine {
    /// Recomputes the residuals of an answer from points, normals, stiffnesses, commands and load; for joints from their Jacobians and drives.
    pub(crate) fn residuals(
        &self,
        problem: &Problem,
        load: &Wrench<3>,
        twist: &Vector,
        (answers, found): (&[ContactAnswer<3>], &SearchSolution),
        cone: Cone,
    ) -> Residuals {
        let [force_terms, displacement_terms] = found.sizes;
        // The comparisons below ignore NaN and find no violation in an answer with NaN. Its residuals are therefore set to infinity here.
        if !answers.iter().all(is_finite) || !twist.iter().all(|x| x.is_finite()) {
            return Residuals::NONE_HOLDS;
        }
        let load_force = load.force_part();
        let object = self.space().of_the_object();
        let turned: f64 = twist.iter().take(object).skip(self.space().axes()).map(|x| x.abs()).added();
        let translated = self.space().object_alone(twist);
        // The offsets of the contact springs already contain the slip `problem.slips` that was accumulated on a load path. The contact law holds
        // for the remaining slip.
        let slip = |i: usize| answers[i].slip - problem.slips[i];
        let of_drives = self.drive_site_answers(problem, twist, found);
        let mut displacement_sizes: Vec<f64> = numbered(self.len(), &|i| {
            let contact = &self.contacts()[i];
            let give = self.sites()[i].springs.deflection(&answers[i].force).norm();
            let own = problem.offsets[i].norm() + contact.clearance.abs() + give;
            let moved =
                translated.norm() + turned * contact.point.norm() + self.displacement_by_joints(i, twist).1;
            // Divisors of residuals (N or m) are at least `SMALLEST` (1e-250): products of subnormal numbers have no relative precision.
            (own + moved + answers[i].gap.abs() + slip(i).norm()).max(displacement_terms).max(SMALLEST)
        });
        for (k, site_answer) in of_drives.iter().enumerate() {
            let i = self.len() + k;
            let give = self.sites()[i].springs.deflection(site_answer.force).norm();
            let moved = self.sites()[i].map.norm() * found.twist.norm();
            displacement_sizes
                .push((problem.offsets[i].norm() + give + moved).max(displacement_terms).max(SMALLEST));
        }
        let largest =
            answers.iter().fold(load_force.norm().max(force_terms), |most, c| most.max(c.force.norm()));
        // The displacements of a contact that hardly moves may be rounding of larger displacements elsewhere. The divisor of its residuals is
        // therefore at least 1e-20 of the largest divisor of all contacts. It is also at least the stretch of the stiffest spring under the largest
        // force.
        let still = 1e-20 * displacement_sizes.iter().copied().most();
        let still = still.max(problem.least_stretch(largest));
        for displacement_size in &mut displacement_sizes {
            *displacement_size = displacement_size.max(still);
        }
        let spring_force = least_spring_force(self.sites(), displacement_sizes.iter().copied());
        let force_size = largest.max(NO_FORCE * spring_force).max(SMALLEST);
        let object_balance = self.out_of_balance(load, answers, spring_force.max(force_terms));
        let equilibrium = object_balance.max(self.joints_out_of_balance(load, answers, found, force_size));
        let mut r = Residuals { equilibrium, ..Residuals::default() };
        let law = |i: usize| ContactLaw {
            site: &self.sites()[i],
            friction: problem.cone(i),
            polygon: problem.polygon(i),
            cone,
            force_size,
            displacement_size: displacement_sizes[i],
        };
        for (i, answer) in answers.iter().enumerate() {
            let point = &self.contacts()[i].point;
            let moved = self.space().displacement_of(point, twist) * self.sign_on_object(i)
                - self.displacement_by_joints(i, twist).0;
            let stretch = problem.offsets[i] - self.sites()[i].frame.tr_mul(&moved);
            let separated = answer.state == ContactState::Separated;
            let site_answer =
                SiteAnswer { force: &answer.force, gap: answer.gap, separated, stretch, slip: slip(i) };
            r.note(&law(i), &site_answer);
        }
        for (k, site_answer) in of_drives.iter().enumerate() {
            r.note(&law(self.len() + k), site_answer);
        }
        r
    }

    /// The displacement of a contact due to joints and other bodies, along the coordinate axes, m. Also the sum of the magnitudes of its terms, m.
    /// Both are zero for contacts on a single object that no joint moves.
    fn displacement_by_joints(&self, contact: usize, twist: &Vector) -> (SVector<f64, 3>, f64) {
        let (mut sum, mut size) = (SVector::zeros(), 0.0);
        let Some(linkage) = self.linkage() else { return (sum, size) };
        for (k, motion) in &linkage.motions[contact] {
            let step = motion * twist[self.space().of_the_object() + k];
            sum += step;
            size += step.norm();
        }
        (sum, size)
    }

    /// The force and displacements of each drive of a hand, from which its residuals are computed: drives obey contact laws, too. Empty without a
    /// hand.
    fn drive_site_answers<'a>(
        &self,
        problem: &Problem,
        twist: &Vector,
        found: &'a SearchSolution,
    ) -> Vec<SiteAnswer<'a>> {
        if self.linkage().is_none() {
            return Vec::new();
        }
        let inside = self.inside_motion(twist);
        let site_answer = |(i, force): (usize, &'a SVector<f64, 3>)| {
            let (site, separated) = (&self.sites()[i], found.states[i].is_open());
            let stretch = site.stretch(&problem.offsets[i], &inside);
            let gap = if separated { (-stretch[0]).max(0.0) } else { 0.0 };
            let slips = found.states[i].slides();
            let slip = if slips { site.springs.slip(&stretch, force) } else { SVector::zeros() };
            SiteAnswer { force, gap, separated, stretch, slip }
        };
        found.forces.iter().enumerate().skip(self.len()).map(site_answer).list()
    }

    /// The largest relative imbalance of generalised forces at joints and at bodies other than the object. Each imbalance is divided by the sum of
    /// the absolute values of its terms, but at least by the force `force_size`. Zero if the grasp has neither joints nor other bodies.
    fn joints_out_of_balance(
        &self,
        load: &Wrench<3>,
        answers: &[ContactAnswer<3>],
        found: &SearchSolution,
        force_size: f64,
    ) -> f64 {
        let Some(linkage) = self.linkage() else { return 0.0 };
        let (object, count) = (self.space().of_the_object(), self.size().count());
        let mut from_outside = self.inside_unchecked(load) + &linkage.external_torques;
        if let Some(vacuum) = self.vacuum() {
            from_outside += &vacuum.inside;
        }
        if let Some(bodies) = self.bodies() {
            from_outside += self.combine_wrenches(bodies, &bodies.loads);
        }
        let mut sums = &linkage.held_forces + &from_outside;
        let mut sizes = linkage.held_forces.map(f64::abs) + from_outside.map(f64::abs);
        let mut add = |k: usize, term: f64| {
            sums[k] += term;
            sizes[k] += term.abs();
        };
        for (answer, motions) in answers.iter().zip(&linkage.motions) {
            for (k, motion) in motions {
                add(object + k, -motion.dot(&answer.force_world) / linkage.lengths[object + k]);
            }
        }
        for (site, force) in self.sites().iter().zip(&found.forces).skip(self.len()) {
            for k in site.support.ranges().into_iter().flatten() {
                add(k, site.map.row(k).dot(force));
            }
        }
        (object..count).map(|k| sums[k].abs() / sizes[k].max(force_size)).most()
    }

    /// Relative imbalance of the forces and moments on the object. The imbalance is divided by the sum of the absolute values of its terms, plus
    /// `spring_force`, the least force that the displacements could cause in a spring. Returns the larger of the two ratios, for forces and for
    /// moments.
    fn out_of_balance(&self, load: &Wrench<3>, answers: &[ContactAnswer<3>], spring_force: f64) -> f64 {
        let (space, axes) = (self.space(), self.space().axes());
        let mut sum = load.coordinates(space);
        if let Some(bodies) = self.bodies() {
            let on_object = bodies.shared(load)[bodies.object] + bodies.loads[bodies.object];
            sum = on_object.coordinates(space);
        }
        let (mut force_size, mut moment_size) = (0.0, 0.0);
        for k in 0..space.of_the_object() {
            *(if k < axes { &mut force_size } else { &mut moment_size }) += sum[k].abs();
        }
        for (i, (contact, answer)) in self.contacts().iter().zip(answers).enumerate() {
            sum += &space.wrench_of(&contact.point, &answer.force_world) * self.sign_on_object(i);
            force_size += answer.force_world.norm();
            moment_size += contact.point.norm() * answer.force_world.norm();
        }
        let sites = self.contacts().iter().zip(self.sites()).enumerate();
        for (i, (contact, site)) in sites.filter(|(_, (contact, _))| contact.suction != 0.0) {
            sum += &contact.suction_wrench(site) * self.sign_on_object(i);
            force_size += contact.suction;
            moment_size += contact.point.norm() * contact.suction;
        }
        // If no contact carries a force, the computed forces are rounding errors, proportional to the force that displacements could cause in a
        // spring.
        force_size += spring_force;
        // The resultant moment is divided by the sum of the absolute values of all moments, plus the divisor of forces times the root mean square
        // lever arm.
        moment_size += force_size * self.length();
        let force = space.linear_part::<3>(&sum).norm();
        let moment = sum.iter().take(space.of_the_object()).skip(axes).map(|m| m * m).added().sqrt();
        let relative = |residual: f64, size: f64| residual / size.max(SMALLEST);
        relative(force, force_size).max(relative(moment, moment_size))
    }
}

fn is_finite(answer: &ContactAnswer<3>) -> bool {
    let vectors = [&answer.force, &answer.force_world, &answer.slip];
    answer.gap.is_finite() && vectors.iter().all(|v| v.as_slice().iter().all(|x| x.is_finite()))
}

#[cfg(test)]
mod tests {
    use alloc::sync::Arc;

    use nalgebra::SVector;

    use crate::contact::{Polygon, PolygonCone};
    use crate::equilibrium::Residuals;
    use crate::grasp::{Contact, Engine, Face, Space, Wrench};
    use crate::object::Load;
    use crate::search::{SearchSolution, Settings};

    /// If any number of an answer is not finite, the largest residual of the answer is infinite. A comparison with a tolerance then fails.
    #[test]
    fn what_is_not_finite_holds_nowhere() -> Result<(), Box<dyn core::error::Error>> {
        let jaw = |side: f64| {
            let jaw = Contact::new([side, 0.0], [-side, 0.0]).series_stiffness(1e3, 8e2);
            jaw.friction(0.5).command([0.01, 0.0]).into_inside()
        };
        let grasp = Engine::new(vec![jaw(-1.0), jaw(1.0)])?;
        let load = Wrench::<2>::force([0.0, -1.0]).into_inside();
        let answer = grasp.solve(&load, &Settings::default())?.equilibrium().ok_or("the jaws hold")?.clone();
        let wrench = grasp.inside(&load, "load")?;
        let polygon = Arc::new(Polygon::new(Space::Planar, &PolygonCone::default()));
        let problem = grasp.problem(polygon, false, grasp.offsets(), &Load::from(&wrench));
        let states = answer.local.states.clone();
        let found = SearchSolution::new(states, answer.site_forces(), answer.local.twist.to());
        let moved = SVector::from([
            answer.twist.components()[0],
            answer.twist.components()[1],
            answer.twist.components()[5],
        ]);
        let worst = |twist: &SVector<f64, 3>, contacts: &[_]| {
            grasp.residuals(&problem, &load, &(*twist).into(), (contacts, &found), answer.cone).worst()
        };
        assert!(worst(&moved, &answer.contacts) < 1e-14);
        for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            let lost = SVector::from([0.0, bad, 0.0]);
            assert_eq!(worst(&lost, &answer.contacts), f64::INFINITY);
            for part in 0..4 {
                let mut contacts = answer.contacts.clone();
                match part {
                    0 => contacts[1].force[1] = bad,
                    1 => contacts[1].force_world[0] = bad,
                    2 => contacts[0].slip[1] = bad,
                    _ => contacts[0].gap = bad,
                }
                assert_eq!(worst(&moved, &contacts), f64::INFINITY, "{part} {bad}");
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
