//! Equilibrium with the second-order displacement of equation 4.1.

use nalgebra::SVector;

use super::stability::Stability;
use super::tolerances::{SETTLED_DISPLACEMENT, STUCK_DISPLACEMENT};
use crate::Settings;
use crate::contact::{LocalLaw, Mode, Polygon, State};
use crate::equilibrium::{ContactState, Equilibrium, Outcome};
use crate::error::Error;
use crate::grasp::{Engine, Site, Space, Twist, Wrench};
use crate::numerics::{Map, Size, Square, Vector};
use crate::object::{Lists, Load, Problem};
use crate::prelude::*;
use crate::search::{Settled, settle};

/// How the search for a second-order equilibrium ends.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub enum SecondOrderOutcome<const C: usize> {
    /// An equilibrium: the last iteration changed no displacement at a contact by more than 1e-14 of the largest (1e-11 where rounding allows no
    /// less).
    Equilibrium(Box<SecondOrder<C>>),
    /// There is no first-order equilibrium, or it was not found.
    NoFirstOrder(Box<Outcome<C>>),
    /// The outer iterations do not converge: the geometric stiffness is not small compared to the elastic one, or the displacements are too large for
    /// second order.
    NotSettled {
        /// Iterations made.
        iterations: usize,
        /// The last change of a displacement at a contact, relative to the largest of them.
        change: f64,
    },
    /// In some iteration no equilibrium of the linearised grasp was found: usually the grasp gives way in second order although it holds in first
    /// order.
    GivesWay {
        /// Iterations made.
        iterations: usize,
    },
}

impl<const C: usize> SecondOrderOutcome<C> {
    /// The equilibrium, if there is one.
    #[must_use]
    pub fn equilibrium(&self) -> Option<&SecondOrder<C>> {
        match self {
            Self::Equilibrium(found) => Some(found),
            _ => None,
        }
    }
}

/// An equilibrium with second-order displacements.
///
/// To second order the contact at r moves by `u = δ + θ × r + ½ θ × (θ × r)`; in the plane the last term is `-½ θ² r`. The moment of its force is
/// taken with the moved arm: the wrench is `Jᵀ F` with J = ∂u/∂q. In each outer iteration, at the twist q_k, u is replaced by its tangent,
///
/// ```text
/// u ≈ J_k q + (u(q_k) - J_k q_k)
/// ```
///
/// This is a first-order grasp with other maps and commands, solved as usual, with contacts that slide and open. Each iteration reduces the error to
/// about (geometric stiffness / elastic stiffness) of the one before. Where this ratio is not small the equilibrium is close to instability, and the
/// outcome is that the iterations do not converge.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct SecondOrder<const C: usize> {
    /// The first-order equilibrium at the start of the iterations.
    pub first_order: Equilibrium<C>,
    /// Motion of the object: translation of its point at the origin (m), rotation vector (rad).
    pub twist: Twist<C>,
    /// Force on the object at each contact, in the contact frame before the motion, N; F_n > 0 pushes.
    pub forces: Vec<SVector<f64, C>>,
    /// State of each contact, in the order of the grasp.
    pub states: Vec<ContactState<C>>,
    /// The largest `|½ θ × (θ × r)|` of a contact, m: the term of equation 4.1 that first order neglects.
    pub dropped_displacement: f64,
    /// The largest resulting change of a contact force, N.
    pub force_left_out: f64,
    /// The largest resulting change of the displacement of the object at a contact, m.
    pub displacement_left_out: f64,
    /// Outer iterations made.
    pub iterations: usize,
    /// Stability at this equilibrium, with the moved arms.
    pub stability: Stability<C>,
}

impl Engine {
    /// [`Energy::second_order`](crate::ask::Energy::second_order).
    pub(crate) fn second_order_equilibrium(
        &self,
        load: &Wrench<3>,
        settings: &Settings,
    ) -> Result<SecondOrderOutcome<3>, Error> {
        self.refuse_hands("second_order_equilibrium")?;
        let first_order = match self.solve(load, settings)? {
            Outcome::Equilibrium(equilibrium) => *equilibrium,
            other => return Ok(SecondOrderOutcome::NoFirstOrder(Box::new(other))),
        };
        let mut twist: Vector = first_order.twist.coordinates(self.space());
        let mut last = f64::INFINITY;
        // Each iteration gains a digit or more wherever first order is meaningful.
        let most_iterations = 100;
        for iterations in 1..=most_iterations {
            let Some(found) = self.iterate(&twist, load, settings) else {
                return Ok(SecondOrderOutcome::GivesWay { iterations });
            };
            let change = self.largest_displacement(&(&found.twist - &twist));
            let size = self.largest_displacement(&found.twist);
            twist.clone_from(&found.twist);
            let relative = if change == 0.0 { 0.0 } else { change / size };
            let stuck = relative >= last && relative <= STUCK_DISPLACEMENT;
            if relative <= SETTLED_DISPLACEMENT || stuck {
                let found = self.second_order(first_order, &twist, found, iterations);
                return Ok(SecondOrderOutcome::Equilibrium(Box::new(found)));
            }
            if !relative.is_finite() {
                return Ok(SecondOrderOutcome::NotSettled { iterations, change: relative });
            }
            last = relative;
        }
        Ok(SecondOrderOutcome::NotSettled { iterations: most_iterations, change: last })
    }

    /// Solves the first-order problem linearised about a twist.
    fn iterate(&self, twist: &Vector, load: &Wrench<3>, settings: &Settings) -> Option<Step> {
        let size = self.size();
        let in_units =
            Vector::from_fn(size, |k| if k < self.space().axes() { 1.0 } else { 1.0 / self.length() });
        let mut drives = self.drives();
        let sites: Vec<Site> = self
            .sites()
            .iter()
            .zip(self.contacts())
            .zip(&mut drives)
            .map(|((site, contact), drive)| {
                let tangent = tangent(self.space(), size, &contact.point, twist);
                let rest =
                    second_order_displacement(self.space(), &contact.point, twist) - tangent.tr_mul(twist);
                *drive -= site.frame.tr_mul(&rest);
                let in_units = Map::from_fn(size, |k, a| in_units[k] * tangent[(k, a)]);
                site.with_map(in_units.times(&site.frame))
            })
            .collect();
        let wrench: Vector = load.coordinates(self.space()).component_mul(&in_units);
        let polygon = Polygon::shared(self.space(), &settings.cone);
        let round = settings.is_round(self.space());
        let problem = Problem::at_rest(
            &sites,
            polygon,
            round,
            Lists { drives, ..Lists::default() },
            &Load::from(&wrench),
        );
        let (Settled::Found(found, _), _) = settle(&problem, settings) else { return None };
        Some(Step {
            twist: found.twist.component_mul(&in_units),
            forces: found.forces,
            states: problem.locals().zip(&sites).zip(&found.states).map(as_physics).collect(),
        })
    }

    fn second_order(
        &self,
        first_order: Equilibrium<3>,
        twist: &Vector,
        step: Step,
        iterations: usize,
    ) -> SecondOrder<3> {
        let (mut dropped, mut force, mut displacement) = (0.0_f64, 0.0_f64, 0.0_f64);
        let (mut arms, mut world) = (Vec::new(), Vec::new());
        for (i, (site, contact)) in self.sites().iter().zip(self.contacts()).enumerate() {
            let u = second_order_displacement(self.space(), &contact.point, twist);
            dropped = dropped
                .max(0.5 * turned(self.space(), &turned(self.space(), &contact.point, twist), twist).norm());
            displacement = displacement.max((u - first_order.contacts[i].body_core).norm());
            force = force.max((step.forces[i] - first_order.contacts[i].force).norm());
            arms.push(contact.point + u - self.space().linear_part(twist));
            world.push(site.frame * step.forces[i]);
        }
        SecondOrder {
            stability: self.stability_with(&arms, &world, &step.states, (Square::zeros(self.size()), false)),
            first_order,
            twist: Twist::among(self.space(), twist),
            forces: step.forces,
            states: step.states,
            dropped_displacement: dropped,
            force_left_out: force,
            displacement_left_out: displacement,
            iterations,
        }
    }

    fn largest_displacement(&self, twist: &Vector) -> f64 {
        let at = |point: &SVector<f64, 3>| self.space().displacement_of(point, twist).norm();
        self.contacts().iter().map(|contact| at(&contact.point)).fold(0.0, f64::max)
    }
}

/// The result of one outer iteration.
struct Step {
    twist: Vector,
    forces: Vec<SVector<f64, 3>>,
    states: Vec<ContactState<3>>,
}

/// The state of a contact, with directions along the coordinate axes.
fn as_physics(((local, site), state): ((LocalLaw<'_>, &Site), &State)) -> ContactState<3> {
    match state {
        Mode::Open => ContactState::Separated,
        Mode::Sticking if local.is_frictionless() => ContactState::Frictionless,
        Mode::Sticking => ContactState::Sticking,
        sliding => {
            let outward = local.outward(sliding).map_or_else(SVector::zeros, |out| out.normalize());
            ContactState::Sliding { direction: site.frame * outward }
        }
    }
}

/// `θ × v`.
fn turned(space: Space, v: &SVector<f64, 3>, twist: &Vector) -> SVector<f64, 3> {
    let mut rotation = twist.clone();
    rotation.iter_mut().take(space.axes()).for_each(|x| *x = 0.0);
    space.displacement_of(v, &rotation)
}

/// `δ + θ × r + ½ θ × (θ × r)`.
fn second_order_displacement(space: Space, point: &SVector<f64, 3>, twist: &Vector) -> SVector<f64, 3> {
    space.displacement_of(point, twist) + turned(space, &turned(space, point, twist), twist) * 0.5
}

/// Jᵀ: the columns are the derivatives of the components of the displacement.
fn tangent(space: Space, size: Size, point: &SVector<f64, 3>, twist: &Vector) -> Map {
    let once = turned(space, point, twist);
    let mut tangent = Map::zeros(size);
    for k in 0..size.count() {
        let unit = Vector::unit(size, k);
        let twice = turned(space, &once, &unit) + turned(space, &turned(space, point, &unit), twist);
        tangent.set_row(k, &(space.displacement_of(point, &unit) + twice * 0.5));
    }
    tangent
}
