//! From piece to piece of the contact law on the round cone: Newton's method in forces and twist together.
//!
//! The force of a spring 1e10 times as stiff as the others is 1e10 times as sensitive to the twist: told from the twist alone
//! ([`super::newton`]), its rounding would pass for a contact state. Here forces are unknowns, too. Each contact keeps its state while the
//! piece is solved, in twice the working precision (`formulation/correction`), and leaves it where the solution breaks an inequality.

use nalgebra::SVector;

use super::candidate::{Found, Verdict, admit, admit_sliding, imbalance};
use super::newton::Arrived;
use super::slack::{scene_force, span};
use crate::formulation::{Law, Piece, PieceState, PreciseTwist, Problem, Returned, Slide, State, respond};

/// Steps at most.
const STEPS: usize = 20;
/// A step by less than this part of a force, or of the twist, is the last.
const SHARP: f64 = 1e-14;
/// This part of the largest force is below the last digit of any.
const NO_DIGIT: f64 = 1e-20;
/// Where nothing but rounding holds the direction of a small force no step is the last. One that changes forces by less than this part of
/// them, or by rounding of the largest, leaves the square of it.
const SETTLED: f64 = 1e-8;
/// Rounding of the largest force.
const ROUNDING: f64 = 1e-15;
/// A force that still turns is off its cone by the square of the angle. This part of the largest force is rounding.
const ON_THE_CONE: f64 = 1e-14;
/// An answer may be out of balance by this part of its forces: a load that was computed has rounding.
const BALANCED: f64 = 1e-13;
/// A state is left where its inequality fails by more than this part of its terms.
const FAILS: f64 = 1e-14;
/// A motion that moves a contact by less than this part of its reach does not move it.
const FELT: f64 = 1e-10;
/// How a contact slides on the round cone, whichever way.
const SLIDING: State = State::Sliding { first: 0, second: None };

/// A state for every contact, with forces and a twist that need not solve their piece yet.
#[derive(Debug, Clone)]
pub(super) struct Pieces<const D: usize, const C: usize> {
    states: Vec<State>,
    /// How contacts on their cones slide, to first order.
    slides: Vec<Option<Slide<C>>>,
    forces: Vec<SVector<f64, C>>,
    /// In twice the working precision: the slip of a stiff contact may be less than its rounding.
    twist: PreciseTwist<D>,
}

/// A state, with force and slide where a contact slides on the round cone.
type Next<const C: usize> = (State, Option<(SVector<f64, C>, Slide<C>)>);

impl<const D: usize, const C: usize> Pieces<D, C> {
    /// Where Newton's method on the twist has arrived.
    pub(super) fn arrived(problem: &Problem<D, C>, arrived: &Arrived<D, C>) -> Self {
        let state = |(i, returned): (usize, &Returned<C>)| match returned {
            Returned::Open => (State::Open, None),
            Returned::Rolling(_) => (State::Rolling, None),
            Returned::Sliding(_, slide) => (SLIDING, problem.may_slide(i).then_some(*slide)),
        };
        let (states, slides) = arrived.contacts.iter().enumerate().map(state).unzip();
        let forces = arrived.contacts.iter().map(Returned::force).collect();
        Self { states, slides, forces, twist: PreciseTwist::new(arrived.twist) }
    }

    /// The solution of the polygons' piece with these states.
    pub(super) fn on_polygons(problem: &Problem<D, C>, states: &[State], near: &PieceState<D, C>) -> Self {
        let state = |(i, &state): (usize, &State)| {
            let friction = &near.forces[i];
            match state {
                State::Sliding { .. } if matches!(problem.laws[i], Law::Edge(_)) => (state, None),
                State::Sliding { .. }
                    if problem.may_slide(i) && friction.iter().skip(1).any(|f| *f != 0.0) =>
                {
                    (SLIDING, Some(Slide::new(&problem.sites[i], friction, 0.0)))
                }
                // Without friction force nothing says which way. At the apex of its cone a polygon calls open what is kept closed.
                State::Sliding { .. } => (State::Rolling, None),
                State::Open if problem.laws[i] != Law::Absent && !problem.may_open(i) => {
                    (State::Rolling, None)
                }
                _ => (state, None),
            }
        };
        let (states, slides) = states.iter().enumerate().map(state).unzip();
        Self { states, slides, forces: near.forces.clone(), twist: PreciseTwist::new(near.twist) }
    }

    /// Newton's method until the last digit of every contact stands. `None` if it does not settle or where the states do not hold.
    pub(super) fn solve(mut self, problem: &Problem<D, C>) -> Option<Found<D, C>> {
        for step in 1..=STEPS {
            let linear = self.linear(problem);
            let piece = Piece::new(&linear, &self.states);
            let [sharp, settled] = self.step(&linear, &piece);
            let last = (sharp || step == STEPS && settled) && self.on_cones(problem);
            if last && let Some(found) = self.admitted(problem, &linear, &piece) {
                return Some(found);
            }
            // While a motion is free the gaps along it are anything.
            let closing = sharp || piece.free_motions().is_empty();
            let left = self.leave_states(problem, closing);
            if sharp && !left {
                return None;
            }
        }
        None
    }

    /// The problem with contacts on their cones to first order. Facets play no part in it.
    fn linear<'g>(&self, problem: &Problem<'g, D, C>) -> Problem<'g, D, C> {
        let law = |(i, slide): (usize, &Option<Slide<C>>)| {
            slide.map_or_else(|| problem.laws[i].clone(), |slide| problem.turning(i, slide))
        };
        problem.with_laws(self.slides.iter().enumerate().map(law).collect())
    }

    /// Whether friction forces are as large as they can be wherever contacts slide; not so where a contact that is kept closed pulls.
    fn on_cones(&self, problem: &Problem<D, C>) -> bool {
        let largest = scene_force(problem, &self.forces, &self.twist.value());
        (0..problem.len()).filter(|&i| self.slides[i].is_some()).all(|i| {
            let (force, limit) = (&self.forces[i], problem.sites[i].mu * self.forces[i][0]);
            (force[1].hypot(force[2]) - limit).abs() <= ON_THE_CONE * largest.max(limit)
        })
    }

    /// Solves the piece; whether every force has settled to its last digit, and whether it has but for rounding of the largest.
    fn step(&mut self, linear: &Problem<D, C>, piece: &Piece<D, C>) -> [bool; 2] {
        let twist = self.twist.value();
        let largest = scene_force(linear, &self.forces, &twist);
        let missing = piece.correction(linear, &self.states, (&self.forces, &self.twist), largest);
        self.twist.add(&missing.twist);
        let mut sharp = missing.twist.norm() <= SHARP * twist.norm();
        let mut settled = true;
        for (force, missing) in self.forces.iter_mut().zip(&missing.forces) {
            *force += missing;
            // Each contact by itself: a small force may still turn while the large ones have settled.
            sharp &= missing.norm() <= SHARP * force.norm() + NO_DIGIT * largest;
            settled &= missing.norm() <= SETTLED * force.norm() + ROUNDING * largest;
        }
        [sharp, settled]
    }

    /// As an answer, if every inequality holds.
    fn admitted(
        &self,
        problem: &Problem<D, C>,
        linear: &Problem<D, C>,
        piece: &Piece<D, C>,
    ) -> Option<Found<D, C>> {
        let Self { states, slides, forces, twist } = self.clone();
        let at = PieceState { forces, twist: twist.value() };
        // Steps leave only what no spring of the piece resists.
        if !piece.resists(&problem.wrench) || !balanced(problem, &at) {
            return None;
        }
        if piece.free_motions().iter().any(|motion| self.turns(problem, motion)) {
            return None;
        }
        let whole = piece.free_motions().is_empty() && piece.neutral_motions().is_empty();
        if whole && slides.iter().any(Option::is_some) {
            let largest = scene_force(problem, &at.forces, &at.twist);
            return admit_sliding(problem, states, slides, at, largest);
        }
        match admit(linear, states, piece, at) {
            Verdict::Holds(found) => Some(Found { slides, ..found }),
            _ => None,
        }
    }

    /// Whether a motion turns the friction of a sliding contact: it is not free then, only resisted by less than rounding of the stiffest
    /// spring, and where it leads to is not known.
    fn turns(&self, problem: &Problem<D, C>, motion: &SVector<f64, D>) -> bool {
        problem.sites.iter().zip(&self.slides).any(|(site, slide)| {
            slide.is_some_and(|slide| {
                slide.across().0.dot(&site.map.tr_mul(motion)).abs() > FELT * site.map.norm()
            })
        })
    }

    /// Leaves states that do not hold, and lets contacts slide on in the direction that belongs to their stretch; whether a state was left.
    /// Open contacts close only if `closing`.
    fn leave_states(&mut self, problem: &Problem<D, C>, closing: bool) -> bool {
        let twist = self.twist.value();
        let largest = scene_force(problem, &self.forces, &twist);
        let mut any = false;
        for i in 0..problem.len() {
            let before = self.states[i];
            let (state, slide) = self.next_state(problem, i, largest, closing);
            match &slide {
                _ if state == State::Open => self.forces[i].fill(0.0),
                Some((force, _)) => self.forces[i] = *force,
                None => {}
            }
            (self.states[i], self.slides[i]) = (state, slide.map(|(_, slide)| slide));
            any |= state != before;
        }
        any
    }

    /// The state of a contact from here on, and its force where that slides on the round cone.
    fn next_state(&self, problem: &Problem<D, C>, contact: usize, largest: f64, closing: bool) -> Next<C> {
        let (site, drive) = (&problem.sites[contact], &problem.drives[contact]);
        let (force, state) = (&self.forces[contact], self.states[contact]);
        let stretch = |axis: usize| self.twist.stretch(site, axis, drive[axis]).value();
        let may_open = problem.may_open(contact);
        match state {
            State::Open => {
                let closes =
                    closing && may_open && stretch(0) > FAILS * span(site, drive, &self.twist.value());
                (if closes { State::Rolling } else { State::Open }, None)
            }
            _ if may_open && force[0] < -FAILS * largest => (State::Open, None),
            State::Sliding { .. } if !problem.may_slide(contact) => (state, None),
            State::Rolling | State::Sliding { .. } if problem.may_slide(contact) => {
                // The stretch of a stiff spring is known from its force, not from displacements.
                let known = |axis: usize| {
                    if axis == 0 || state == State::Rolling {
                        force[axis] / site.k[axis]
                    } else {
                        stretch(axis)
                    }
                };
                let near = self.slides[contact].map_or(0.0, |slide| slide.lambda);
                match respond(problem, contact, &SVector::from_fn(|axis, _| known(axis)), near) {
                    Returned::Sliding(force, slide) => (SLIDING, Some((force, slide))),
                    _ => (State::Rolling, None),
                }
            }
            _ => (state, None),
        }
    }
}

/// Whether forces balance the load. Without a load they may be noise, which is not measured against itself; with one a wild twist must not
/// count as a force.
fn balanced<const D: usize, const C: usize>(problem: &Problem<D, C>, at: &PieceState<D, C>) -> bool {
    let (left, carried) = imbalance(problem, &at.forces);
    let load = problem.wrench.norm();
    let scale = if load > 0.0 { load } else { scene_force(problem, &at.forces, &at.twist) };
    left <= BALANCED * (scale + carried)
}
