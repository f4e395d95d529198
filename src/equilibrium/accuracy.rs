//! How far an answer is from the exact one, and how strongly it depends on the last digits of the question.

use nalgebra::SVector;

use crate::contact::State;
use crate::grasp::{Grasp, Wrench, wrench_of};
use crate::numerics::Draw;
use crate::object::{Piece, PieceState, PreciseTwist, Problem};
use crate::search::Found;

/// Patterns of signs with which the data are varied.
const PATTERNS: u64 = 3;

/// How far an equilibrium is from the exact one for its contact states.
///
/// Errors are found by evaluating the conditions in twice the working precision and solving for what is left of them; the
/// condition by varying all data in a few patterns of signs at once (small-sample estimates, C. S. Kenney and A. J. Laub,
/// SIAM J. Sci. Comput. 15, 1994).
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Accuracy {
    /// Estimated error of the contact forces, N: that of the contact with the largest. The data – points, contact frames, stiffnesses, friction,
    /// commands, load – are taken as exact.
    pub force: f64,
    /// Estimated error of the displacements of the body at the contacts, m: that of the contact with the largest. Free motions do not count.
    pub displacement: f64,
    /// Condition of the contact forces: if all data are known to a relative error ε, the forces are known to about this times ε, relative
    /// to the largest. A normal that was rounded to double precision alone makes it `condition · 1.1e-16`.
    pub condition: f64,
}

impl Accuracy {
    /// Of a solution of the local problem under this load.
    pub(super) fn of<const D: usize, const C: usize>(
        grasp: &Grasp<D, C>,
        load: &Wrench<D>,
        problem: &Problem<D, C>,
        found: &Found<D, C>,
    ) -> Self {
        let twist = PreciseTwist::new(found.twist);
        // Slides on the round cone belong to forces and slips as they are now.
        let slides = found.states.iter().any(|state| state.slide().is_some());
        let states = problem.slid_on(&found.states, &found.forces, &twist);
        let made;
        let piece = match &found.piece {
            Some(piece) if !slides => piece.as_ref(),
            _ => {
                made = Piece::new(problem, &states);
                &made
            }
        };
        let at = PieceState { forces: found.forces.clone(), twist: found.twist };
        let largest = problem.largest_force(&found.forces, &found.twist);
        let missing = piece.correction(problem, &states, (&found.forces, &twist), largest);
        let size = |forces: &[SVector<f64, C>]| forces.iter().map(nalgebra::Matrix::norm).fold(0.0, f64::max);
        let mut accuracy =
            Self { force: size(&missing.forces) + missing.doubt, displacement: 0.0, condition: 0.0 };
        for (site, drive) in problem.sites.iter().zip(&problem.drives) {
            let moved = site.map.tr_mul(&missing.twist).norm();
            let spans = site.span(drive, &found.twist);
            // Displacements are sums of this size, rounded.
            accuracy.displacement = accuracy.displacement.max(moved + 0.5 * f64::EPSILON * spans);
        }
        if largest > 0.0 {
            let varied = |pattern| {
                let variation = Variation::new(grasp, load, problem, &found.states, &at, pattern);
                let mut forces = piece.forces_of(&variation.stretches, &variation.load);
                for (force, dragged) in forces.iter_mut().zip(&variation.dragged) {
                    *force += dragged;
                }
                size(&forces)
            };
            accuracy.condition = (0..PATTERNS).map(varied).fold(0.0, f64::max) / largest;
        }
        accuracy
    }
}

/// What the conditions miss, to first order, if every number of the question changes by its own size, up or down as the pattern says.
struct Variation<const D: usize, const C: usize> {
    stretches: Vec<SVector<f64, C>>,
    load: SVector<f64, D>,
    /// Change of the forces by friction.
    dragged: Vec<SVector<f64, C>>,
}

impl<const D: usize, const C: usize> Variation<D, C> {
    fn new(
        grasp: &Grasp<D, C>,
        load: &Wrench<D>,
        problem: &Problem<D, C>,
        states: &[State<C>],
        at: &PieceState<D, C>,
        pattern: u64,
    ) -> Self {
        let mut signs = Draw::new([pattern, 0, 0]);
        let load = load.as_vector().map(|w| w * signs.sign());
        let n = problem.len();
        let mut variation = Self {
            stretches: vec![SVector::zeros(); n],
            load: grasp.inside_unchecked(&Wrench::from_vector(load)),
            dragged: vec![SVector::zeros(); n],
        };
        for (i, (site, contact)) in problem.sites.iter().zip(grasp.contacts()).enumerate() {
            let (force, drive) = (&at.forces[i], &problem.drives[i]);
            if states[i].slides() {
                let sign = signs.sign();
                for a in 1..C {
                    variation.dragged[i][a] = force[a] * sign;
                }
            }
            variation.load += site.map * variation.dragged[i];
            // The digits of a point count from the origin it is given in, not from its neighbours.
            let point = contact.point.map(|x| x * signs.sign()) / grasp.length();
            let give = site.springs.give(force);
            for a in 0..site.springs.axes() {
                let axis = site.frame.column(a).into_owned();
                let moved = wrench_of::<D, C>(&point, &axis);
                let stretch = &mut variation.stretches[i][a];
                *stretch = drive[a] * signs.sign() + give[a] * signs.sign();
                for k in 0..D {
                    let turned = site.map[(k, a)] * signs.sign();
                    let entry = if k < C { turned } else { turned + moved[k] };
                    *stretch += entry * at.twist[k];
                    variation.load[k] += entry * force[a];
                }
            }
        }
        variation
    }
}
