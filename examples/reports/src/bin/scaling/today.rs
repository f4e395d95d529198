//! The usual method today: the reduced quadratic program by an interior-point method (Clarabel), solved repeatedly.

use grasp_lcp::PolygonCone;
use grasp_lcp::ask::Grasp;
use grasp_lcp::grasp::Wrench;

use support::interior_point::{Oracle, interior_point};
use support::reduced_program::ReducedProgram;

/// A friction row counts as active if its slack, relative to the largest slack, is below this; at the onset the method leaves slacks of this size.
const ACTIVE: f64 = 1e-6;
/// Number of bisections of the interval.
const HALVINGS: usize = 20;

/// Solves the program once under a load; returns whether no friction row is active.
pub fn sticks<const C: usize>(grasp: &Grasp<C>, load: &Wrench<C>) -> bool {
    let reduced = ReducedProgram::new(grasp, load, &PolygonCone::default());
    let Oracle::Minimum(x, _) = interior_point(&reduced.program) else { return false };
    let slack = &reduced.program.b * x - &reduced.program.d;
    let friction = || reduced.friction.iter().zip(&slack).filter(|(contact, _)| contact.is_some());
    let largest = friction().map(|(_, slack)| slack.abs()).fold(0.0, f64::max);
    friction().all(|(_, slack)| *slack > ACTIVE * largest)
}

/// The factor of the load at which a friction row of the program becomes active, by doubling and halving.
pub fn bisected_onset<const C: usize>(grasp: &Grasp<C>, direction: &Wrench<C>) -> f64 {
    let (mut below, mut above) = (0.0, 1.0);
    while sticks(grasp, &(*direction * above)) && above < 1e12 {
        (below, above) = (above, 2.0 * above);
    }
    for _ in 0..HALVINGS {
        let middle = 0.5 * (below + above);
        *(if sticks(grasp, &(*direction * middle)) { &mut below } else { &mut above }) = middle;
    }
    below
}
