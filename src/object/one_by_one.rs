//! Contacts that answer a motion of the object one by one, each to its own stretch.

use crate::numerics::{Size, Vector};
use std::ops::Range;

use nalgebra::SVector;

use super::newton::{Imbalance, StretchAnswers};
use super::problem::Problem;
use super::tangent::tangent_stiffness;
use crate::contact::ContactResponse;
use crate::numerics::{Factors, in_halves};

/// The contacts of a problem with what they have answered last, for [`newton`](super::newton).
pub(crate) struct OneByOne<'p, 'g, F, D: Size, const C: usize> {
    problem: &'p Problem<'g, D, C>,
    /// The answer of a contact to a stretch, from its last one.
    answer: F,
    pub(crate) contacts: Vec<ContactResponse<C>>,
    /// Counts beside the sizes of load and forces, N.
    beside: f64,
}

impl<'p, 'g, F, D: Size, const C: usize> OneByOne<'p, 'g, F, D, C>
where
    F: Fn(usize, &SVector<f64, C>, &ContactResponse<C>) -> ContactResponse<C>,
{
    /// All open to begin with. `beside` is a size of forces in which Newton's method cannot see: of rounding, for instance.
    pub(crate) fn new(problem: &'p Problem<'g, D, C>, beside: f64, answer: F) -> Self {
        Self::in_memory(problem, (beside, Vec::new()), answer)
    }

    /// [`Self::new`] with a list that is there.
    pub(crate) fn in_memory(
        problem: &'p Problem<'g, D, C>,
        (beside, mut contacts): (f64, Vec<ContactResponse<C>>),
        answer: F,
    ) -> Self {
        contacts.clear();
        contacts.resize(problem.len(), ContactResponse::open());
        Self { problem, answer, contacts, beside }
    }
}

impl<F, D: Size, const C: usize> StretchAnswers<D> for OneByOne<'_, '_, F, D, C>
where
    F: Fn(usize, &SVector<f64, C>, &ContactResponse<C>) -> ContactResponse<C> + Sync,
{
    fn answer(&mut self, twist: &Vector<D>) -> Imbalance<D> {
        let (problem, answer) = (self.problem, &self.answer);
        let part = |(range, contacts): (Range<usize>, &mut [ContactResponse<C>])| {
            let (mut left, mut size) = (Vector::zeros(), 0.0);
            for (i, contact) in range.zip(contacts) {
                *contact = answer(i, &problem.stretch(i, twist), contact);
                if !contact.state.is_open() {
                    left += &problem.sites[i].map * contact.force;
                    size += contact.force.norm();
                }
            }
            Imbalance { left, size }
        };
        let contacts = (0..self.contacts.len(), self.contacts.as_mut_slice());
        in_halves(contacts, &part, &Imbalance::plus)
            .plus(Imbalance { left: problem.wrench.clone(), size: problem.wrench.norm() + self.beside })
    }

    fn tangent(&mut self) -> Option<Factors<D>> {
        let tangent = |i: usize| self.problem.local(i).tangent(&self.contacts[i].state).matrix();
        Some(Factors::new(&tangent_stiffness(self.problem.sites, tangent)))
    }
}
