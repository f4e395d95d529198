//! Contacts that answer a motion of the object one by one, each to its own stretch.

use nalgebra::SVector;

use super::newton::{Answers, Imbalance};
use super::problem::Problem;
use super::tangent::{Springs, tangent_stiffness};
use crate::contact::Answer;
use crate::numerics::Factors;

/// The contacts of a problem with what they have answered last, for [`newton`](super::newton).
pub(crate) struct OneByOne<'p, 'g, F, const D: usize, const C: usize> {
    problem: &'p Problem<'g, D, C>,
    /// The answer of a contact to a stretch, from its last one.
    answer: F,
    pub(crate) contacts: Vec<Answer<C>>,
    tangents: Vec<Springs<C>>,
    /// Counts beside the sizes of load and forces, N.
    beside: f64,
}

impl<'p, 'g, F, const D: usize, const C: usize> OneByOne<'p, 'g, F, D, C>
where
    F: Fn(usize, &SVector<f64, C>, &Answer<C>) -> Answer<C>,
{
    /// All open to begin with. `beside` is a size of forces in which Newton's method cannot see: of rounding, for instance.
    pub(crate) fn new(problem: &'p Problem<'g, D, C>, beside: f64, answer: F) -> Self {
        let contacts = vec![Answer::open(); problem.len()];
        Self { problem, answer, contacts, tangents: Vec::with_capacity(problem.len()), beside }
    }
}

impl<F, const D: usize, const C: usize> Answers<D> for OneByOne<'_, '_, F, D, C>
where
    F: Fn(usize, &SVector<f64, C>, &Answer<C>) -> Answer<C>,
{
    fn answer(&mut self, twist: &SVector<f64, D>) -> Imbalance<D> {
        let problem = self.problem;
        let (mut left, mut size) = (problem.wrench, problem.wrench.norm() + self.beside);
        for (i, contact) in self.contacts.iter_mut().enumerate() {
            *contact = (self.answer)(i, &problem.stretch(i, twist), contact);
            if !contact.state.is_open() {
                left += problem.sites[i].map * contact.force;
                size += contact.force.norm();
            }
        }
        Imbalance { left, size }
    }

    fn tangent(&mut self) -> Option<Factors<D>> {
        let tangents = self.contacts.iter().zip(self.problem.locals());
        self.tangents.clear();
        self.tangents.extend(tangents.map(|(at, local)| local.tangent(&at.state).matrix()));
        Some(Factors::new(&tangent_stiffness(self.problem.sites, &self.tangents)))
    }
}
