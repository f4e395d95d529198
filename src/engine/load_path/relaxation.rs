//! The derivative J of the rates along an arc ([`Flow`](super::flow::Flow)) with respect to the friction forces of sliding contacts. An arc is a
//! piece of the load path on which directions of sliding turn. Implicit steps need J, because friction forces often turn fast towards the directions
//! of slip.
//!
//! T and b are the tangent stiffness and right-hand side of the arc, q is the twist and λ the fraction of the leg that is done. Contact i has the
//! grasp map G_i, the tangent stiffness C_i, the rate s_i of its stretch and the friction force F_t,i. The rate of its offset (commanded displacement
//! minus clearance and slip) is a_i' per unit of λ. The unit tangent d_i is perpendicular to F_t,i. The quantities s_i', T' and b' are defined by the
//! formulas below.
//!
//! A change Δ_i of the friction force turns it by the angle φ_i = d_i·Δ_i / |F_t,i| towards d_i. This changes C_i, and thus the rate C_i s_i of the
//! contact's own force. To keep forces in balance, the rates of q and λ change as well, by δq and δλ, which affects all contacts. J is given by
//!
//! ```text
//! (J Δ)_i = v_i φ_i + C_i s_i',     v_i = (∂C_i/∂φ_i) s_i,     s_i' = a_i' δλ - G_iᵀ δq
//! T δq - b δλ = Σ G_i v_i φ_i,      (δq, δλ) across the path
//! ```
//!
//! For D coordinates of the twist, J is a diagonal matrix plus a matrix of rank D + 1. The inverse of 1 - hJ for a step of arclength h has the same
//! form. With the right-hand side g and c_i = C_iᵀ d_i, the system for Δ is solved by
//!
//! ```text
//! (1 - hJ) Δ = g:     φ_i = (d_i·g_i + h c_i·s_i') / e_i,     e_i = |F_t,i| - h d_i·v_i
//! T' δq - b' δλ = Σ G_i v_i (d_i·g_i) / e_i,     T' = T + h Σ G_i v_i (G_i c_i)ᵀ / e_i,     b' = b + h Σ G_i v_i (c_i·a_i') / e_i
//! ```

use nalgebra::SVector;

use super::arc::{Arc, Direction};
use super::path_stiffness::{PathFactors, PathStiffness};
use crate::contact::{Tangent, tangential_norm};
use crate::numerics::{Each, IntoList, Reals, Vector};
use crate::prelude::*;

/// A sliding contact at the start of a step, with derivatives with respect to the angle of its friction force in the tangent plane.
struct SlidingContact {
    contact: usize,
    tangent: Tangent,
    /// Magnitude of the friction force, |F_t|, N.
    size: f64,
    /// The unit tangent d perpendicular to the friction force, towards which it can turn; zero for a contact without friction force.
    across: SVector<f64, 3>,
    /// The derivative v of the rate of the contact force with respect to the angle φ of the friction force. Its unit is N per radian and unit of
    /// arclength.
    change: SVector<f64, 3>,
    /// The wrench `G v` on the object for the contact force v = `change`, with the grasp map G.
    push: Vector,
    /// The derivative c = Cᵀd of the force component along d = `across` with respect to the stretch of the contact along each axis, N/m. C is
    /// the tangent stiffness of the contact.
    gradient: SVector<f64, 3>,
    /// The wrench `G c` on the object, with the grasp map G, for the vector c = `gradient` in place of a contact force.
    pull: Vector,
}

/// The matrix J at the start of a step: the derivative of the rates along an arc with respect to the friction forces of sliding contacts. The head of
/// this file explains it.
pub(super) struct Relaxation<'f, 's, 'g> {
    arc: &'f Arc<'s, 'g>,
    contacts: Vec<SlidingContact>,
    /// The tangent stiffness T of the object, with all contacts in their present states and directions of sliding.
    stiffness: PathStiffness,
    /// The right-hand side b of `T q' = b λ'` at the start of the step, with the twist q and the fraction λ.
    load: Vector,
    direction: Direction,
}

/// The factors of the matrix 1 - hJ of an implicit step. Here h = `length` is the arclength of the step, and J is the matrix of [`Relaxation`].
pub(super) struct ImplicitFactors {
    length: f64,
    /// LU factors of the matrix `[T' | -b']` with one more row, transverse to the path. T' and b' are the tangent stiffness and the rate of the load,
    /// each with the terms of the implicit step from the head of this file.
    bordered: PathFactors,
    /// For each sliding contact the divisor `e_i = |F_t,i| - h d_i·v_i` of the formulas at the head of this file, N: the magnitude of its friction
    /// force minus a term of the implicit step. Here d_i is `SlidingContact::across`, v_i is `SlidingContact::change`, and h is `length`.
    sizes: Vec<f64>,
}

impl<'f, 's, 'g> Relaxation<'f, 's, 'g> {
    /// The derivative J of the rates with respect to friction forces, at the friction forces `frictions` of the sliding contacts. `direction` is the
    /// direction of the path (the rates of the twist and of λ) at the fraction `factor` of the leg.
    pub(super) fn new(
        arc: &'f Arc<'s, 'g>,
        frictions: &[SVector<f64, 3>],
        factor: f64,
        direction: Direction,
    ) -> Self {
        let tangents = arc.tangents(frictions.iter().copied());
        let (stiffness, load) = arc.balance(&tangents, factor);
        let turning = |((&contact, friction), tangent): ((&usize, &SVector<f64, 3>), Tangent)| {
            let size = tangential_norm(friction);
            let across = match tangent {
                Tangent::Sliding { across, .. } if size > 0.0 => across,
                _ => SVector::zeros(),
            };
            let turned = |angle: f64| arc.tangent(contact, &(friction + across * (size * angle)));
            // Angle, rad, by which the friction force is turned to both sides. A central difference then gives the derivative of the contact force's
            // rate with respect to this angle. Two thirds of its digits are correct.
            let small = 6e-6;
            let [[_, less], [_, more]] =
                [-small, small].each(|angle| arc.rates(contact, &turned(angle), &direction));
            let change = (more - less) / (2.0 * small);
            let gradient = tangent.matrix().tr_mul(&across);
            let map = &arc.sites()[contact].map;
            SlidingContact {
                contact,
                tangent,
                size,
                across,
                change,
                push: map * change,
                gradient,
                pull: map * gradient,
            }
        };
        let contacts = arc.sliding.iter().zip(frictions).zip(tangents).map(turning).list();
        Self { arc, contacts, stiffness, load, direction }
    }

    /// The factors of the matrix 1 - hJ of an implicit step of arclength h = `length`, with the matrix J of [`Relaxation`]. `None` if the bordered
    /// matrix is singular.
    pub(super) fn damped(&self, length: f64) -> Option<ImplicitFactors> {
        let (mut stiffness, mut load) = (self.stiffness.clone(), self.load.clone());
        let mut sizes = Vec::with_capacity(self.contacts.len());
        for turning in &self.contacts {
            let size = turning.size - length * turning.across.dot(&turning.change);
            sizes.push(size);
            if turning.size > 0.0 {
                let push = &turning.push * (length / size);
                let ranges = self.arc.sites()[turning.contact].support.ranges();
                stiffness.add(&ranges, |i, j| push[i] * turning.pull[j]);
                load += push * turning.gradient.dot(&self.arc.segment.change[turning.contact]);
            }
        }
        let (bordered, _) = self.arc.factored(stiffness, &load, &self.direction)?;
        Some(ImplicitFactors { length, bordered, sizes })
    }

    /// Solves `(1 - hJ) Δ = g` in place, with the factors in `damped`: `side` holds the right-hand side g before, and Δ after. Its entries are
    /// changes of friction forces, two for each sliding contact, then of the twist and of λ. The last entries are the energies (work and friction
    /// heat) that are integrated along with the path. They stay unchanged, because no rate depends on them.
    pub(super) fn solve(&self, damped: &ImplicitFactors, side: &mut [f64]) {
        let length = damped.length;
        let mut left = Vector::zeros();
        let mut angles = Vec::with_capacity(self.contacts.len());
        let entries = side.chunks_exact(2).zip(&self.contacts).zip(&damped.sizes);
        for ((given, turning), size) in entries {
            let along = (1..3).map(|a| turning.across[a] * given[a - 1]).added();
            let angle = if turning.size > 0.0 { along / size } else { 0.0 };
            left += &turning.push * angle;
            angles.push(angle);
        }
        let direction = self.arc.unscaled(damped.bordered.solve(&left, 0.0));
        let (frictions, others) = side.split_at_mut(2 * self.contacts.len());
        let entries = frictions.chunks_exact_mut(2).zip(&self.contacts).zip(&damped.sizes);
        for (((entry, turning), size), angle) in entries.zip(angles) {
            let [stretch, force] = self.arc.rates(turning.contact, &turning.tangent, &direction);
            let more = if turning.size > 0.0 { length * turning.gradient.dot(&stretch) / size } else { 0.0 };
            let change = (turning.change * (angle + more) + force) * length;
            (1..3).for_each(|a| entry[a - 1] += change[a]);
        }
        let count = self.arc.segment.grasp.size().count();
        (0..count).for_each(|k| others[k] += length * direction.twist[k]);
        others[count] += length * direction.factor;
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::DMatrix;

    use super::super::arc::SharedTerms;
    use super::super::segment::Segment;
    use super::super::trajectory::Trajectory;
    use super::*;
    use crate::PolygonCone;
    use crate::contact::{Polygon, Slide, State};
    use crate::equilibrium::AnswerFor;
    use crate::grasp::Engine;
    use crate::object::Load;
    use crate::spatial::Contact;

    /// Five fingers round a ball. `ratio` is the stiffness along the second tangent divided by the stiffness along the first.
    fn fingers(ratio: f64) -> Engine {
        let finger = |i: u8| {
            let (sin, cos) = (1.3 * f64::from(i)).sin_cos();
            let stiffness = [1.0, 0.8, 0.8 * ratio];
            Contact::new([cos, sin, 0.2 * f64::from(i) - 0.3], [-cos, -sin, 0.1])
                .series_stiffness_axes(stiffness)
                .friction(0.5)
        };
        Engine::new((0..5).map(finger).collect()).expect("a grasp")
    }

    #[test]
    fn what_is_solved_for_obeys_difference_quotients() {
        for ratio in [1.0, 1.7] {
            let grasp = fingers(ratio);
            let polygon = Polygon::shared(grasp.space(), &PolygonCone::default());
            let load = Load::from(&Vector::zeros());
            let problem = grasp.problem(polygon, true, grasp.offsets(), &load);
            let change = (0..5).map(|i| SVector::from([0.1, 0.02 * f64::from(i), -0.03])).collect();
            let rate = SVector::from([0.3, -0.2, 0.9, 0.1, -0.2, 0.15]).into();
            let trajectory = Trajectory::Straight { from: Vector::zeros(), rate };
            let segment = Segment {
                grasp: &grasp,
                answer_for: AnswerFor::of(grasp.space(), &crate::search::Settings::default()),
                problem,
                change,
                trajectory,
                largest: 0.0,
            };
            let angle = |i: u8| 0.7 * f64::from(i) + 0.4;
            let frictions: Vec<_> = (1..5)
                .map(|i| SVector::from([0.0, angle(i).cos(), angle(i).sin()]) * (0.2 + 0.1 * f64::from(i)))
                .collect();
            let sliding = frictions.iter().map(|friction| State::Round(Slide::new(friction, 0.0)));
            let states: Vec<_> = core::iter::once(State::Sticking).chain(sliding).collect();
            let arc = Arc::new(&segment, &states, [], (0.5, SharedTerms::default()));
            let direction =
                arc.direction(&arc.tangents(frictions.iter().copied()), 0.0, &Direction::forward());
            let direction = direction.expect("one direction");

            // Rates of friction forces, twist and λ after a change of the friction forces.
            let rates = |y: &[f64]| {
                let moved = frictions.iter().zip(y.chunks_exact(2));
                let moved = moved.map(|(f, more)| f + SVector::from([0.0, more[0], more[1]]));
                let tangents = arc.tangents(moved);
                let direction = arc.direction(&tangents, 0.0, &direction).expect("one direction");
                let own = arc
                    .sliding
                    .iter()
                    .zip(&tangents)
                    .map(|(&i, tangent)| arc.rates(i, tangent, &direction)[1]);
                let own = own.flat_map(|force| [force[1], force[2]]);
                own.chain(direction.twist.iter().copied()).chain([direction.factor]).collect::<Vec<_>>()
            };
            let n = 2 * frictions.len() + 7;
            let mut jacobian = DMatrix::zeros(n, n);
            for k in 0..2 * frictions.len() {
                let [less, more] = [-1e-6, 1e-6].map(|step| {
                    let mut y = vec![0.0; n];
                    y[k] = step;
                    rates(&y)
                });
                for row in 0..n {
                    jacobian[(row, k)] = (more[row] - less[row]) / 2e-6;
                }
            }
            let relaxation = Relaxation::new(&arc, &frictions, 0.0, direction);
            for length in [1e-3, 0.1, 10.0, 1e4] {
                let given: Vec<f64> = (0..n).map(|k| (k as f64).sin()).collect();
                let mut solved = given.clone();
                relaxation.solve(&relaxation.damped(length).expect("regular"), &mut solved);
                let matrix = DMatrix::identity(n, n) - &jacobian * length;
                let size = matrix.abs() * DMatrix::from_column_slice(n, 1, &solved).abs();
                let left = matrix * DMatrix::from_column_slice(n, 1, &solved)
                    - DMatrix::from_column_slice(n, 1, &given);
                let worst = left.component_div(&size).amax();
                assert!(worst < 1e-7, "{ratio} {length:e}: {worst:e}");
            }
        }
    }
}
