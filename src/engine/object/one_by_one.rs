//! Contacts that respond to a motion of the object one by one, each to its own stretch.

use crate::numerics::Vector;
use core::ops::Range;

use nalgebra::SVector;

use super::newton::{Imbalance, StretchAnswers, newton};
use super::problem::Problem;
use super::tangent::{TangentFactors, tangent_stiffness};
use crate::contact::ContactResponse;
use crate::numerics::{Factors, in_halves};
use crate::prelude::*;

/// Newton's method for contacts that respond one by one, each from its last response; all are open at first. The last responses are left in
/// `contacts`, a reused list. `beside` is a size of forces below which the method cannot resolve, such as rounding.
pub(crate) fn newton_one_by_one(
    problem: &Problem,
    (twist, settled, beside): (Vector, f64, f64),
    contacts: &mut Vec<ContactResponse>,
    answer: impl Fn(usize, &SVector<f64, 3>, &ContactResponse) -> ContactResponse + Sync,
) -> Option<(Vector, usize, Imbalance)> {
    contacts.clear();
    contacts.resize(problem.len(), ContactResponse::open());
    newton(&mut OneByOne { problem, answer, contacts, beside }, twist, settled)
}

/// [`newton_one_by_one`] on the round cone: each contact responds with its return map (`contact/answer`), free to change its state.
pub(crate) fn newton_on_cones(
    problem: &Problem,
    (twist, settled): (Vector, f64),
    contacts: &mut Vec<ContactResponse>,
) -> Option<(Vector, usize, Imbalance)> {
    newton_one_by_one(problem, (twist, settled, 0.0), contacts, |i, stretch, last| {
        let near = last.state.slide().map_or(0.0, |slide| slide.lambda);
        problem.local(i).answer(stretch, near)
    })
}

/// The contacts of a problem with their last responses.
struct OneByOne<'p, 'g, F> {
    problem: &'p Problem<'g>,
    /// The response of a contact to a stretch, from its last one.
    answer: F,
    contacts: &'p mut [ContactResponse],
    /// Added to the sizes of load and forces, N.
    beside: f64,
}

impl<F> StretchAnswers for OneByOne<'_, '_, F>
where
    F: Fn(usize, &SVector<f64, 3>, &ContactResponse) -> ContactResponse + Sync,
{
    fn answer(&mut self, twist: &Vector) -> Imbalance {
        let (problem, answer) = (self.problem, &self.answer);
        let part = |(range, contacts): (Range<usize>, &mut [ContactResponse])| {
            let mut sum = Imbalance::default();
            for (i, contact) in range.zip(contacts) {
                *contact = answer(i, &problem.stretch(i, twist), contact);
                if !contact.state.is_open() {
                    sum.add(&problem.sites[i], &contact.force);
                }
            }
            sum
        };
        let contacts = (0..self.contacts.len(), &mut *self.contacts);
        in_halves(contacts, &part, &Imbalance::plus)
            .plus(Imbalance { left: problem.wrench.clone(), size: problem.wrench.norm() + self.beside })
    }

    fn tangent(&mut self) -> Option<TangentFactors> {
        if let Some(band) = self.problem.tangent_in_a_band(&|i| self.contacts[i].state) {
            return Some(band);
        }
        let tangent = |i: usize| self.problem.local(i).tangent(&self.contacts[i].state).matrix();
        Some(TangentFactors::Whole(Factors::new(&tangent_stiffness(self.problem.sites, tangent))))
    }
}
