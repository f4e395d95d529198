//! The error of given contact forces and twist: the exact solution with the same contact states, minus the given values.
//!
//! Contact i has the offset a_i (commanded displacement minus clearance and earlier slips), the grasp map G_i, the stiffness matrix K_i and the given
//! force F_i. The given twist is q, and the load W. Spring r of a contact is stretched along s_r, a vector that contains the square root of its
//! stiffness. Three residuals are evaluated in twice the working precision: the residual displacement w_i of each contact, the scaled residual e_r of
//! each spring, and the imbalance ρ.
//!
//! ```text
//! w_i = a_i - G_iᵀ q - K_i⁻¹ F_i,      e_r = s_r · w_i,      ρ = Σ G_i F_i + W      with F_i on its cone
//! ```
//!
//! The linear problem is then solved with e_r and ρ as right-hand side. This gives the error itself, not only a bound. On the round cone it is the
//! error to first order, which is enough if Newton's method has converged. At the solution the component of w_i along a spring that resists is zero.
//! The other components of w_i are the gap and the slip of the contact.

use nalgebra::SVector;

use super::linear_problem::LinearProblem;
use super::precise::{PreciseBalance, PreciseTwist};
use super::problem::Problem;
use super::tolerances::{MOST_CORRECTIONS, NEARLY_CORRECTED};
use crate::contact::{LocalLaw, Mode, Spring, State};
use crate::numerics::{DoubleDouble, Each, IntoList, Reals, Vector, by_axis, mapped, without};
use crate::prelude::*;

/// The exact solution in given contact states minus a given approximate solution: differences of the contact forces (N, in the contact frames) and of
/// the twist.
#[derive(Debug, Clone)]
pub(crate) struct Correction {
    pub(crate) forces: Vec<SVector<f64, 3>>,
    /// The exact twist minus the given twist, without components along motions that no spring resists.
    pub(crate) twist: Vector,
    /// Uncertainty of the corrected forces, N. The residual e_r of each spring amounts to a force along this spring; the uncertainty is machine
    /// precision times the largest of these forces. If refinement did not converge, the largest force of the last correction is added. The
    /// uncertainty is large if the linear problem is nearly singular.
    pub(crate) doubt: f64,
}

impl LinearProblem {
    /// The exact solution in the contact states `states`, from which this [`LinearProblem`] was made, minus the given forces and twist. `size` is the
    /// largest force of the problem, N.
    pub(crate) fn correction(
        &self,
        problem: &Problem,
        states: &[State],
        (at, from): (&[SVector<f64, 3>], &PreciseTwist),
        size: f64,
    ) -> Correction {
        let mut forces: Vec<[DoubleDouble; 3]> = mapped(at, &|f| [0, 1, 2].each(|a| DoubleDouble::new(f[a])));
        let mut twist = from.clone();
        let mut change = vec![0.0; self.springs.len()];
        let mut doubt = 0.0;
        for _ in 0..MOST_CORRECTIONS {
            let left = self.residual_of(problem, states, &mut forces, &twist, &mut change);
            let push = |(spring, x): (&Spring, &f64)| spring.push_direction.amax() * x.abs();
            let largest = |x: &[f64]| self.springs.iter().zip(x).map(push).most();
            // Uncertainty of this correction, N. The correction follows from residual forces as large as `largest(&change)`, with a relative error of
            // machine precision.
            let noise = f64::EPSILON * largest(&change);
            twist.add(&self.respond(&mut change, &left));
            for (contact, springs, range) in self.of_each_contact() {
                for (spring, change) in springs.iter().zip(&change[range]) {
                    for (force, push) in forces[contact].iter_mut().zip(&spring.push_direction) {
                        force.add(push * change);
                    }
                }
            }
            let changed = largest(&change);
            let settled = changed <= NEARLY_CORRECTED * size;
            doubt = noise + if settled { 0.0 } else { changed };
            if settled && noise <= 0.1 * changed.max(f64::EPSILON * size) {
                break;
            }
        }
        let missing = |(forces, f): (&[DoubleDouble; 3], &SVector<f64, 3>)| {
            by_axis(|a| {
                let mut exact = forces[a];
                exact.add(-f[a]);
                exact.value()
            })
        };
        let way = without(twist.less(from), self.free_motions());
        Correction { forces: forces.iter().zip(at).map(missing).list(), twist: way, doubt }
    }

    /// Moves the friction forces of sliding contacts onto their cones. Writes the scaled residual `e_r = s_r · w_i` of each spring r to `e`, with the
    /// residual displacement w_i of its contact. Returns the imbalance `ρ = Σ G_i F_i + W` of the contact forces F_i and the load W.
    fn residual_of(
        &self,
        problem: &Problem,
        states: &[State],
        forces: &mut [[DoubleDouble; 3]],
        twist: &PreciseTwist,
        e: &mut [f64],
    ) -> Vector {
        let mut balance = PreciseBalance::new(problem.size(), &problem.load());
        for (contact, springs, range) in self.of_each_contact() {
            let (site, force) = (&problem.sites[contact], &mut forces[contact]);
            put_on_cone(&problem.local(contact), &states[contact], force);
            let mut across = TransverseResidual::of(&states[contact], force);
            let mut along = [DoubleDouble::default(); 3];
            for (a, force) in force.iter().enumerate().take(site.springs.axes()) {
                if across.is_some() || springs.iter().any(|s| s.stretch_direction[a] != 0.0) {
                    let mut w = twist.stretch(site, a, problem.offsets[contact][a]);
                    w.subtract(site.springs.precise_deflection_along(a, *force));
                    for (along, spring) in along.iter_mut().zip(springs) {
                        along.add_product_of_twice(
                            (spring.stretch_direction[a], spring.stretch_direction_error[a]),
                            w,
                        );
                    }
                    if let Some(across) = &mut across {
                        across.add(a, w);
                    }
                }
                balance.add(site, a, *force);
            }
            if let Some(across) = across {
                along[1] = across.times(springs.get(1));
            }
            for (e, along) in e[range].iter_mut().zip(along) {
                *e = along.value();
            }
        }
        balance.value()
    }
}

/// The component `c·w` of the residual displacement w of a contact that slides on the round cone. Here `c = (-F_2, F_1) / |F_t|` is the tangential
/// direction perpendicular to the friction force F_t. The direction is not taken from w itself, since w may have any direction before convergence.
struct TransverseResidual {
    along: [DoubleDouble; 3],
    length: f64,
    sum: DoubleDouble,
}

impl TransverseResidual {
    fn of(state: &State, force: &[DoubleDouble; 3]) -> Option<Self> {
        let Mode::Round(_) = state else { return None };
        let mut along = [DoubleDouble::default(); 3];
        let minus = |f: DoubleDouble| DoubleDouble { high: -f.high, low: -f.low };
        (along[1], along[2]) = (minus(force[2]), force[1]);
        Some(Self { along, length: force[1].high.hypot(force[2].high), sum: DoubleDouble::default() })
    }

    fn add(&mut self, axis: usize, w: DoubleDouble) {
        let along = self.along[axis];
        self.sum.add_product_of_twice((along.high, along.low), w);
    }

    /// `c·w` times the square root of the stiffness of the spring in the direction c: the residual of this spring. Zero without a spring or without
    /// friction force.
    fn times(&self, spring: Option<&Spring>) -> DoubleDouble {
        let root = spring.map_or(0.0, |spring| spring.stretch_direction.norm());
        let part = if self.length > 0.0 { root / self.length } else { 0.0 };
        DoubleDouble::new(self.sum.value() * part)
    }
}

/// Moves the friction force of a sliding contact, which is off the boundary of its cone by rounding, onto this boundary. The normal force stays. The
/// boundary (`edge` in code names) is the round cone `|F_t| = μ F_n`, or a facet or corner of the polygonal cone.
fn put_on_cone(local: &LocalLaw<'_>, state: &State, force: &mut [DoubleDouble; 3]) {
    let mut limit = DoubleDouble::default();
    limit.add_product_of_twice((local.cone().limit(1.0), 0.0), force[0]);
    let facets = local.facets();
    match state {
        Mode::Open | Mode::Sticking => {}
        Mode::Round(_) => {
            // The distance of the friction |F_t| from its limit follows from `limit² - |F_t|²`, which is computed in twice the working
            // precision, so that no digits cancel.
            let length = force[1].high.hypot(force[2].high);
            let mut squares = DoubleDouble::default();
            squares.add_product_of_twice((limit.high, limit.low), limit);
            for f in &force[1..] {
                squares.add_product_of_twice((-f.high, -f.low), *f);
            }
            let size = length * (limit.high + length);
            let stretch = if size > 0.0 { squares.value() / size } else { 0.0 };
            for force in &mut force[1..] {
                force.add(force.high * stretch);
            }
        }
        Mode::Facet(j) => {
            let h = &facets[usize::from(*j)];
            let mut inside = limit;
            for a in 1..3 {
                inside.add_product_of_twice((-h[a], 0.0), force[a]);
            }
            let pull = local.edge(state).pull * inside.value();
            for a in 1..3 {
                force[a].add(pull[a]);
            }
        }
        Mode::Corner(_) => {
            let p = local.edge(state).pull;
            for (a, force) in force.iter_mut().enumerate().skip(1) {
                *force = DoubleDouble::default();
                force.add_product_of_twice((p[a], 0.0), limit);
            }
        }
    }
}
