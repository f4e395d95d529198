//! The contacts in known states, and the motion of the object in which they balance the load.
//!
//! With every contact in a known state, balance is d equations for the motion y on top of the elastic trial motion. They are affine in the fraction τ
//! of the leg, and an event changes one or two of their terms:
//!
//! ```text
//! T y = b + τ b',   T = Σ QᵀP Q,   b = Σ Qᵀ((P - 1) x⁰ - P m),   b' = Σ Qᵀ(P - 1) x⁰'
//! ```

use nalgebra::SVector;

use super::active_set::FacetsReached;
use super::moving_contact::{MovingContact, for_each_slip, size};
use super::trial_leg::TrialLeg;
use crate::contact::{PolygonState, WEIGHTLESS, tangential};
use crate::grasp::Site;
use crate::numerics::{Factors, Vector, orthonormalise_against};
use crate::object::{CORRECTIONS, EnergyCoordinates, Facet, MARGIN, Point, Problem, Sums, are_stale, slack};
use crate::prelude::*;

/// Up to this many contacts the sums are made afresh for every solve, which costs no more than the solve.
const FEW: usize = 64;

/// The contacts in their states, and the present place of the path.
#[derive(Debug)]
pub(super) struct Balance<const C: usize> {
    pub(super) contacts: Vec<MovingContact<C>>,
    coordinates: EnergyCoordinates<C>,
    /// T, b and b'.
    sums: Sums<2>,
    /// Number of changes since the sums were made.
    age: usize,
    factors: Factors,
    /// The present fraction of the leg.
    pub(super) tau: f64,
    /// Motion on top of the trial state at τ, scaled like Q, and its rate.
    pub(super) y: Vector,
    pub(super) y_rate: Vector,
    /// Unit of time along the leg that weighs as much as a unit of y.
    pub(super) pace: f64,
    /// Number of evaluations of single contacts.
    pub(super) looked_at: usize,
}

impl<const C: usize> Balance<C> {
    /// The balance with every contact sticking.
    pub(super) fn new(problem: &Problem<'_, C>, trial: &TrialLeg<C>) -> Self {
        let (mut contacts, mut coordinates) =
            (Vec::with_capacity(problem.len()), EnergyCoordinates::default());
        coordinates.lay_out(problem, &trial.factor, |_, contact| contacts.push(MovingContact::new(contact)));
        let sums = Sums::sticking(problem.size());
        Self {
            contacts,
            coordinates,
            age: 0,
            factors: Factors::new(&sums.stiffness),
            sums,
            tau: 0.0,
            y: Vector::zeros(),
            y_rate: Vector::zeros(),
            pace: 1.0,
            looked_at: 0,
        }
    }

    pub(super) fn contact(&self, contact: u32) -> &MovingContact<C> {
        &self.contacts[contact as usize]
    }

    pub(super) fn facets(&self, contact: &MovingContact<C>) -> &[Facet<C>] {
        self.coordinates.facets(&contact.fixed)
    }

    /// √ of the weight of the scaled Q: R q is y over this.
    pub(super) fn scale(&self) -> f64 {
        self.coordinates.weight.sqrt()
    }

    /// u of a contact at the present place.
    pub(super) fn stretch(&self, contact: &MovingContact<C>) -> SVector<f64, C> {
        contact.stretch(&self.y, self.tau)
    }

    /// u' of a contact.
    pub(super) fn stretch_rate(&self, contact: &MovingContact<C>) -> SVector<f64, C> {
        contact.stretch_rate(&self.y_rate)
    }

    /// x' of a contact.
    pub(super) fn force_rate(&self, contact: &MovingContact<C>) -> SVector<f64, C> {
        contact.force(&self.stretch_rate(contact), self.facets(contact))
    }

    /// Size of the terms that u' of a contact is the sum of.
    pub(super) fn rate_level(&self, contact: &MovingContact<C>) -> f64 {
        contact.rate_level(self.y_rate.norm())
    }

    /// Growth of relative rounding errors in a rate of the motion, at least 1.
    pub(super) fn growth(&self) -> f64 {
        self.factors.growth()
    }

    /// The direction of the path in motion and time.
    pub(super) fn course(&self) -> Point {
        Point { y: self.y_rate.clone(), s: self.pace }
    }

    /// Puts a contact into a state.
    pub(super) fn put(&mut self, contact: u32, state: PolygonState) {
        let Self { contacts, coordinates, sums, .. } = self;
        let contact = &mut contacts[contact as usize];
        if contact.state != state {
            let facets = coordinates.facets(&contact.fixed);
            contact.add_to(sums, facets, -coordinates.weight);
            contact.state = state;
            contact.add_to(sums, facets, coordinates.weight);
            self.age += 1;
        }
    }

    /// Adds the slip of a contact up to here to memory.
    pub(super) fn remember(&mut self, contact: u32) {
        let contact = &mut self.contacts[contact as usize];
        let u = contact.stretch(&self.y, self.tau);
        contact.remember(&u, self.coordinates.facets(&contact.fixed));
    }

    /// Adds the slip of all sliding contacts up to here to memory.
    pub(super) fn remember_all(&mut self) {
        for contact in (0..).take(self.contacts.len()) {
            if self.contact(contact).state.slides() {
                self.remember(contact);
            }
        }
    }

    /// Makes the sums afresh.
    pub(super) fn renew(&mut self) {
        let (rank, weight) = (self.coordinates.rank, self.coordinates.weight);
        self.sums = Sums::over(self.sums.stiffness.size(), self.contacts.len(), rank, &|sums, contact| {
            let contact = &self.contacts[contact];
            contact.add_to(sums, self.facets(contact), weight);
        });
        self.refactor();
        self.age = 0;
        self.looked_at += self.contacts.len();
    }

    /// Factorises the present sums.
    pub(super) fn refactor(&mut self) {
        self.factors = Factors::new(&self.sums.stiffness);
    }

    /// Begins a leg, with x⁰ and its change along the leg, spring by spring.
    pub(super) fn begin_leg(&mut self, sites: &[Site<C>], [trial, rate]: &[Vec<f64>; 2]) {
        let mut springs = trial.iter().zip(rate);
        for (contact, site) in self.contacts.iter_mut().zip(sites) {
            for (axis, (x, change)) in springs.by_ref().take(site.springs.axes()).enumerate() {
                (contact.trial[axis], contact.rate[axis]) = (*x, *change);
            }
        }
        // With a constant trial state nothing changes.
        let mean = (rate.iter().map(|x| x * x).sum::<f64>() / sites.len() as f64).sqrt();
        self.pace = if mean > 0.0 { mean } else { 1.0 };
        self.tau = 0.0;
    }

    /// Removes the rounding imbalance at a fraction of the leg.
    pub(super) fn settle_at(&mut self, tau: f64) {
        self.tau = tau;
        let [base, rate] = &self.sums.sides;
        let left = base + rate * tau - &self.sums.stiffness * &self.y;
        self.y += self.factors.solve(&left);
    }

    /// Advances along the present piece up to a fraction of the leg.
    pub(super) fn go_to(&mut self, tau: f64) {
        self.y += &self.y_rate * (tau - self.tau);
        self.settle_at(tau);
    }

    /// Solves for the rate of the motion in the present states. `false` if nothing balances the load in them.
    pub(super) fn solve_rates(&mut self, trial: &TrialLeg<C>) -> bool {
        if self.contacts.len() <= FEW || are_stale(self.age, self.contacts.len()) {
            self.renew();
        } else {
            self.refactor();
        }
        let [_, side] = &self.sums.sides;
        let terms = 1.0 + side.amax().max(self.pace);
        let Some(rate) = self.factors.solve_exactly(side, terms) else { return false };
        self.y_rate = rate;
        self.rest_along_free_motions(trial);
        self.y_rate.iter().all(|x| x.is_finite())
    }

    /// Removes the rates along free motions: no force drives the object along them.
    fn rest_along_free_motions(&mut self, trial: &TrialLeg<C>) {
        let kernel = self.factors.kernel();
        if kernel.is_empty() {
            return;
        }
        let scale = self.scale();
        let preimage = |y: &Vector| trial.factor.preimage(&(y / scale));
        // Pairs of a motion and its image in the coordinates of y; the motions are orthonormal.
        let mut known: Vec<(Vector, Vector)> =
            trial.free.iter().map(|v| (v.clone(), Vector::zeros())).collect();
        for mut y in kernel {
            let mut v = preimage(&y);
            for _ in 0..2 {
                for (w, z) in &known {
                    let along = w.dot(&v);
                    v -= w * along;
                    y -= z * along;
                }
            }
            let size = v.norm();
            known.push((v / size, y / size));
        }
        let rate = trial.factor.preimage(&trial.rate) + preimage(&self.y_rate);
        for (v, y) in known {
            self.y_rate -= y * v.dot(&rate);
        }
    }

    /// y with the rounding imbalance removed, from sums made afresh.
    pub(super) fn balanced(&self) -> Vector {
        let mut y = self.y.clone();
        for _ in 0..CORRECTIONS {
            let mut left = Vector::zeros();
            for contact in &self.contacts {
                let x = contact.force(&contact.stretch(&y, self.tau), self.facets(contact));
                left += contact.fixed.seen.tr_mul(&(x - contact.trial - contact.rate * self.tau));
            }
            y += self.factors.solve(&(left * self.coordinates.weight));
        }
        y
    }

    /// The twist of least norm at which y is the motion on top of the trial state.
    pub(super) fn twist(&self, trial: &TrialLeg<C>, y: &Vector) -> Vector {
        trial.twist(&(&trial.travelled + &trial.rate * self.tau + y / self.scale()))
    }

    /// The rate of the twist.
    pub(super) fn twist_rate(&self, trial: &TrialLeg<C>) -> Vector {
        trial.twist(&(&trial.rate + &self.y_rate / self.scale()))
    }

    /// Unit motions that nothing resists here.
    pub(super) fn free_motions(&self, trial: &TrialLeg<C>) -> Vec<Vector> {
        let mut motions = trial.free.clone();
        for v in self.factors.kernel() {
            let mut v = trial.factor.preimage(&v);
            orthonormalise_against(&mut v, &motions);
            motions.push(v);
        }
        motions
    }

    /// The time in which no bound of a contact can be reached, on the clock of the direction e.
    pub(super) fn slack(&self, contact: &MovingContact<C>, e: &Point) -> f64 {
        let u = self.stretch(contact);
        let margin = MARGIN * contact.level(&u, self.y.norm());
        let change = contact.change_along(e, self.pace);
        let mut least = f64::INFINITY;
        contact.for_each_bound(self.facets(contact), |_, felt| {
            let value = felt.dot(&u) - margin * size(felt);
            least = least.min(slack(value, felt.dot(&change), contact.steepest(felt, self.pace)));
        });
        least
    }

    /// The least slip rate of a sliding contact, and the change of the path direction below which it cannot vanish.
    pub(super) fn slip_margin(&self, contact: &MovingContact<C>) -> (f64, f64) {
        let du = self.stretch_rate(contact);
        let size = self.course().size();
        let (mut least, mut slack) = (f64::INFINITY, f64::INFINITY);
        for_each_slip(contact.state, self.facets(contact), |felt| {
            let rate = felt.dot(&du);
            let steepest = contact.steepest(felt, self.pace);
            least = least.min(rate / felt.amax());
            if steepest > 0.0 && size > 0.0 {
                slack = slack.min((rate / size).max(0.0) / steepest);
            }
        });
        (least, slack)
    }

    /// The active set of a contact.
    pub(super) fn stand_of(&self, number: u32) -> FacetsReached<C> {
        let contact = self.contact(number);
        let u = self.stretch(contact);
        contact.stand(number, &u, contact.level(&u, self.y.norm()), self.facets(contact))
    }

    /// Whether a contact holds a tangential force.
    pub(super) fn holds_along(&self, number: u32) -> bool {
        let contact = self.contact(number);
        let u = self.stretch(contact);
        let x = tangential(&contact.force(&u, self.facets(contact)));
        x.norm() > WEIGHTLESS * contact.level(&u, self.y.norm())
    }
}
