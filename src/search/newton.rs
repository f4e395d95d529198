//! Newton's method on the round cone: each contact answers with its return map (`contact/answer`), free to change its state.

use crate::contact::ContactResponse;
use crate::numerics::{Size, Vector};
use crate::object::{self, OneByOne, Problem};

/// What is left out of balance where Newton's method ends, as a part of the forces: steps on the pieces do the rest.
const SETTLED: f64 = 1e-9;

/// Where Newton's method has arrived.
#[derive(Debug, Clone)]
pub(super) struct Arrived<D: Size, const C: usize> {
    pub(super) twist: Vector<D>,
    /// What each contact answers there.
    pub(super) contacts: Vec<ContactResponse<C>>,
}

/// Newton's method from a twist until forces settle.
pub(super) fn newton<D: Size, const C: usize>(
    problem: &Problem<D, C>,
    twist: Vector<D>,
) -> Option<Arrived<D, C>> {
    let mut answers = OneByOne::new(problem, 0.0, |i, stretch, last| {
        let near = last.state.slide().map_or(0.0, |slide| slide.lambda);
        problem.local(i).answer(stretch, near)
    });
    let (twist, ..) = object::newton(&mut answers, twist, SETTLED)?;
    Some(Arrived { twist, contacts: answers.contacts })
}
