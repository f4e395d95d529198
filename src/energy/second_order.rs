//! Equilibrium with the second-order displacement of equation 4.1.

use nalgebra::{SMatrix, SVector};

use super::stability::Stability;
use crate::Settings;
use crate::contact::{LocalLaw, Mode, Polygon, State};
use crate::equilibrium::{ContactState, Equilibrium, Outcome};
use crate::error::Error;
use crate::grasp::{Grasp, Site, Twist, Wrench, displacement_of};
use crate::numerics::unit;
use crate::object::{Lists, Load, Problem};
use crate::search::{Settled, settle};
/// More outer iterations than this are not made: each gains a digit or more where first order makes sense at all.
const MOST_ITERATIONS: usize = 100;
/// Changes of the displacements below this part of them are rounding.
const SETTLED: f64 = 1e-14;
/// Where rounding keeps the changes from falling below that, this is good enough.
const GOOD_ENOUGH: f64 = 1e-11;

/// How the search for a second-order equilibrium ends.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub enum SecondOrderOutcome<const D: usize, const C: usize> {
    /// Found: the last iteration changed no displacement at a contact by more than 1e-14 of the largest (1e-11 where rounding allows no less).
    Equilibrium(Box<SecondOrder<D, C>>),
    /// First order has no equilibrium, or none was found.
    NoFirstOrder(Box<Outcome<D, C>>),
    /// The outer iterations do not settle: the geometric stiffness is not small beside the elastic one, or the displacements
    /// are too large for second order.
    NotSettled {
        /// Iterations made.
        iterations: usize,
        /// The last change of a displacement at a contact, relative to the largest of them.
        change: f64,
    },
    /// At some iteration no equilibrium of the linearised grasp was found: as a rule second order gives way where first order holds.
    GivesWay {
        /// Iterations made.
        iterations: usize,
    },
}

impl<const D: usize, const C: usize> SecondOrderOutcome<D, C> {
    /// The equilibrium, if there is one.
    #[must_use]
    pub fn equilibrium(&self) -> Option<&SecondOrder<D, C>> {
        match self {
            Self::Equilibrium(found) => Some(found),
            _ => None,
        }
    }
}

/// An equilibrium with second-order displacements.
///
/// To second order the contact at r moves by `u = δ + θ × r + ½ θ × (θ × r)`; in the plane the last term is `-½ θ² r`.
/// The moment of its force is taken with the moved arm: the wrench is `Jᵀ F` with J = ∂u/∂q. In each outer iteration, at
/// the twist q_k, u is replaced by its tangent,
///
/// ```text
/// u ≈ J_k q + (u(q_k) - J_k q_k)
/// ```
///
/// This is a first-order grasp with other maps and commands, solved as ever, with contacts that slide and open. Each
/// iteration leaves an error of the order of (geometric stiffness / elastic stiffness) of the one before. Where that
/// ratio is not small, the equilibrium is close to instability, and the outcome says that the iterations do not settle.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct SecondOrder<const D: usize, const C: usize> {
    /// The first-order equilibrium it started from.
    pub first_order: Equilibrium<D, C>,
    /// Motion of the object: translation of its point at the origin (m), rotation vector (rad).
    pub twist: Twist<D, C>,
    /// Force on the object at each contact, in the contact frame as it was at first, N; F_n > 0 pushes.
    pub forces: Vec<SVector<f64, C>>,
    /// What each contact does, in the order of the grasp.
    pub states: Vec<ContactState<C>>,
    /// The largest `|½ θ × (θ × r)|` of a contact, m: the term of equation 4.1 that first order drops.
    pub dropped_displacement: f64,
    /// The largest change of a contact force that comes of it, N.
    pub force_left_out: f64,
    /// The largest change of the displacement of the object at a contact, m.
    pub displacement_left_out: f64,
    /// Outer iterations made.
    pub iterations: usize,
    /// Stability there, with the moved arms.
    pub stability: Stability<D, C>,
}

impl<const D: usize, const C: usize> Grasp<D, C> {
    /// The equilibrium under a load with the second-order displacement of equation 4.1, about the origin of the coordinates: the
    /// load's force acts at the object's point there. At most 100 iterations, each an equilibrium of first order; contact frames, springs and
    /// commands stay as they are in space.
    ///
    /// ```
    /// use grasp_lcp::planar::{Contact, Grasp, Wrench};
    ///
    /// // Two fingers that each press with 1000 N/m · 0.01 m = 10 N; μ = 0.5, 800 N/m tangentially.
    /// let finger = |x: f64| Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1000.0, 800.0).friction(0.5).command([0.01, 0.0]);
    /// let grasp = Grasp::new([finger(-1.0), finger(1.0)])?;
    ///
    /// // A weight of 2 N at the end of an arm of 10 mm turns the body by M / (2 · 800 N/m · (1 m)²), to first order.
    /// let load = Wrench::force_at([0.0, -2.0], [0.01, 0.0]);
    /// let outcome = grasp.second_order_equilibrium(&load)?;
    /// let found = outcome.equilibrium().expect("it hardly turns");
    /// let angle = 0.02 / 1600.0;
    /// assert!((found.first_order.twist.rotation() + angle).abs() < 1e-18);
    /// // To second order the fingers' pressure turns with the body, a matter of 2 · 10 N · 1 m beside 1600 N m; ½ θ² r is what first order drops.
    /// let turned = found.twist.rotation().abs();
    /// assert!((turned / angle - 1.0).abs() < 0.02);
    /// assert!((found.dropped_displacement / (0.5 * turned * turned) - 1.0).abs() < 1e-12);
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Wrench`] if a component of the load is not finite or larger than 1e50.
    pub fn second_order_equilibrium(&self, load: &Wrench<D, C>) -> Result<SecondOrderOutcome<D, C>, Error> {
        self.second_order_equilibrium_with(load, &Settings::default())
    }

    /// [`Self::second_order_equilibrium`] with other [`Settings`].
    ///
    /// # Errors
    /// As for [`Self::second_order_equilibrium`].
    pub fn second_order_equilibrium_with(
        &self,
        load: &Wrench<D, C>,
        settings: &Settings,
    ) -> Result<SecondOrderOutcome<D, C>, Error> {
        self.refuse_hands("second_order_equilibrium")?;
        let first_order = match self.solve_with(load, settings)? {
            Outcome::Equilibrium(equilibrium) => *equilibrium,
            other => return Ok(SecondOrderOutcome::NoFirstOrder(Box::new(other))),
        };
        let mut twist = *first_order.twist.as_vector();
        let mut last = f64::INFINITY;
        for iterations in 1..=MOST_ITERATIONS {
            let Some(found) = self.iterate(&twist, load, settings) else {
                return Ok(SecondOrderOutcome::GivesWay { iterations });
            };
            let change = self.largest_displacement(&(found.twist - twist));
            let size = self.largest_displacement(&found.twist);
            twist = found.twist;
            let relative = if change == 0.0 { 0.0 } else { change / size };
            let stuck = relative >= last && relative <= GOOD_ENOUGH;
            if relative <= SETTLED || stuck {
                let found = self.second_order(first_order, &twist, found, iterations);
                return Ok(SecondOrderOutcome::Equilibrium(Box::new(found)));
            }
            if !relative.is_finite() {
                return Ok(SecondOrderOutcome::NotSettled { iterations, change: relative });
            }
            last = relative;
        }
        Ok(SecondOrderOutcome::NotSettled { iterations: MOST_ITERATIONS, change: last })
    }

    /// The first-order problem about a twist, solved.
    fn iterate(
        &self,
        twist: &SVector<f64, D>,
        load: &Wrench<D, C>,
        settings: &Settings,
    ) -> Option<Step<D, C>> {
        let in_units = SVector::<f64, D>::from_fn(|k, _| if k < C { 1.0 } else { 1.0 / self.length() });
        let mut drives = self.drives();
        let sites: Vec<Site<D, C>> = self
            .sites()
            .iter()
            .zip(self.contacts())
            .zip(&mut drives)
            .map(|((site, contact), drive)| {
                let tangent = tangent::<D, C>(&contact.point, twist);
                let rest = second_order_displacement(&contact.point, twist) - tangent.tr_mul(twist);
                *drive -= site.frame.tr_mul(&rest);
                let map = SMatrix::<f64, D, D>::from_diagonal(&in_units) * tangent * site.frame;
                site.with_map(map)
            })
            .collect();
        let wrench = load.as_vector().component_mul(&in_units);
        let polygon = Polygon::shared(&settings.cone);
        let round = settings.is_round::<C>();
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
        first_order: Equilibrium<D, C>,
        twist: &SVector<f64, D>,
        step: Step<D, C>,
        iterations: usize,
    ) -> SecondOrder<D, C> {
        let (mut dropped, mut force, mut displacement) = (0.0_f64, 0.0_f64, 0.0_f64);
        let (mut arms, mut world) = (Vec::new(), Vec::new());
        for (i, (site, contact)) in self.sites().iter().zip(self.contacts()).enumerate() {
            let u = second_order_displacement(&contact.point, twist);
            dropped = dropped.max(0.5 * turned(&turned(&contact.point, twist), twist).norm());
            displacement = displacement.max((u - first_order.contacts[i].body_core).norm());
            force = force.max((step.forces[i] - first_order.contacts[i].force).norm());
            arms.push(contact.point + u - twist.fixed_rows::<C>(0));
            world.push(site.frame * step.forces[i]);
        }
        SecondOrder {
            stability: self.stability_with(&arms, &world, &step.states, (SMatrix::zeros(), false)),
            first_order,
            twist: Twist::from_vector(*twist),
            forces: step.forces,
            states: step.states,
            dropped_displacement: dropped,
            force_left_out: force,
            displacement_left_out: displacement,
            iterations,
        }
    }

    fn largest_displacement(&self, twist: &SVector<f64, D>) -> f64 {
        let at = |point: &SVector<f64, C>| displacement_of::<D, C>(point, twist).norm();
        self.contacts().iter().map(|contact| at(&contact.point)).fold(0.0, f64::max)
    }
}

/// One outer iteration.
struct Step<const D: usize, const C: usize> {
    twist: SVector<f64, D>,
    forces: Vec<SVector<f64, C>>,
    states: Vec<ContactState<C>>,
}

/// What a contact does in a state, in coordinate axes.
fn as_physics<const D: usize, const C: usize>(
    ((local, site), state): ((LocalLaw<'_, C>, &Site<D, C>), &State<C>),
) -> ContactState<C> {
    match state {
        Mode::Open => ContactState::Separated,
        Mode::Rolling if local.is_frictionless() => ContactState::Frictionless,
        Mode::Rolling => ContactState::Rolling,
        sliding => {
            let outward = local.outward(sliding).map_or_else(SVector::zeros, |out| out.normalize());
            ContactState::Sliding { direction: site.frame * outward }
        }
    }
}

/// `θ × v`.
fn turned<const D: usize, const C: usize>(v: &SVector<f64, C>, twist: &SVector<f64, D>) -> SVector<f64, C> {
    let rotation = SVector::<f64, D>::from_fn(|k, _| if k < C { 0.0 } else { twist[k] });
    displacement_of::<D, C>(v, &rotation)
}

/// `δ + θ × r + ½ θ × (θ × r)`.
fn second_order_displacement<const D: usize, const C: usize>(
    point: &SVector<f64, C>,
    twist: &SVector<f64, D>,
) -> SVector<f64, C> {
    displacement_of::<D, C>(point, twist) + turned(&turned(point, twist), twist) * 0.5
}

/// Jᵀ: the columns are the derivatives of the components of the displacement.
fn tangent<const D: usize, const C: usize>(
    point: &SVector<f64, C>,
    twist: &SVector<f64, D>,
) -> SMatrix<f64, D, C> {
    let column = |k: usize| {
        let (unit, once) = (unit::<D>(k), turned(point, twist));
        let twice = turned(&once, &unit) + turned(&turned(point, &unit), twist);
        displacement_of::<D, C>(point, &unit) + twice * 0.5
    };
    let columns: [_; D] = std::array::from_fn(column);
    SMatrix::<f64, C, D>::from_columns(&columns).transpose()
}
