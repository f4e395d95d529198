//! Newton's method on the round cone: each contact answers with its return map (`contact/answer`), free to change its state.

use nalgebra::SVector;

use crate::contact::Answer;
use crate::numerics::Factors;
use crate::object::{self, Answers, Imbalance, Problem, Springs, tangent_stiffness};

/// What is left out of balance where Newton's method ends, as a part of the forces: steps on the pieces do the rest.
const SETTLED: f64 = 1e-9;

/// Where Newton's method has arrived.
#[derive(Debug, Clone)]
pub(super) struct Arrived<const D: usize, const C: usize> {
    pub(super) twist: SVector<f64, D>,
    /// What each contact answers there.
    pub(super) contacts: Vec<Answer<C>>,
}

struct OnTheRoundCone<'p, 'g, const D: usize, const C: usize> {
    problem: &'p Problem<'g, D, C>,
    contacts: Vec<Answer<C>>,
    tangents: Vec<Springs<C>>,
}

impl<const D: usize, const C: usize> Answers<D> for OnTheRoundCone<'_, '_, D, C> {
    fn answer(&mut self, twist: &SVector<f64, D>) -> Imbalance<D> {
        let problem = self.problem;
        let (mut left, mut size) = (problem.wrench, problem.wrench.norm());
        for (i, contact) in self.contacts.iter_mut().enumerate() {
            let near = contact.state.slide().map_or(0.0, |slide| slide.lambda);
            *contact = problem.local(i).answer(&problem.stretch(i, twist), near);
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

/// Newton's method from a twist until forces settle.
pub(super) fn newton<const D: usize, const C: usize>(
    problem: &Problem<D, C>,
    twist: SVector<f64, D>,
) -> Option<Arrived<D, C>> {
    let tangents = Vec::with_capacity(problem.len());
    let mut answers = OnTheRoundCone { problem, contacts: vec![Answer::open(); problem.len()], tangents };
    let (twist, ..) = object::newton(&mut answers, twist, SETTLED)?;
    Some(Arrived { twist, contacts: answers.contacts })
}
