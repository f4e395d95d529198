//! Sliding on the round cone while every contact keeps its state: the direction of sliding turns as the load goes on.
//!
//! What a sliding contact has slipped, s, is its memory. It grows along the friction force,
//!
//! ```text
//! ds = γ F_t,   γ >= 0,     |F_t| = μ F_n,     F = K (a - G_iᵀq - s),     Σ G_i F_i + W = 0
//! ```
//!
//! a differential equation on a manifold, whatever the number of contacts. A small step of it is made with the return map: with
//! `s₁ = s₀ + λ F_t(s₁)` the contact is a spring again, softened by λ, and equilibrium is Newton's method on d equations. Two
//! rules are made of it, and their error is taken away by extrapolation (see [`super::extrapolation`]):
//!
//! ```text
//! return        s ← s₁ at the end of the step                        error in powers of h,  damps however stiff
//! reflection    s ← 2 s₁ - s with s₁ in the middle of the step       error in powers of h², two of them are symmetric
//! ```
//!
//! Source: the closest-point return of elastoplasticity (Simo and Hughes, Computational Inelasticity, chapter 3).

use nalgebra::{Matrix, SVector};

use super::segment::Segment;
use crate::contact::{Mode, State, tangential, tangential_norm};
use crate::grasp::Site;
use crate::numerics::PartialPivoting;
use crate::object::{Piece, PieceState, Springs, balance, largest_force, tangent_stiffness};

/// Newton's steps: near the last state three do.
const STEPS: usize = 12;
/// A step that changes forces by less than this part of them is the last: what it leaves is the square of this.
const SETTLED: f64 = 1e-9;
/// What is left out of balance is the rounding of its terms.
const BALANCED: f64 = 4e-16;
/// A tiny friction force may still turn when all others have settled: it is then off its cone by the square of the angle.
const ON_THE_CONE: f64 = 1e-14;

/// A slip against the friction force by this part of the displacements of the contact is rounding.
const BACKWARDS: f64 = 1e-13;

/// How a small step uses the return map.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Rule {
    Return,
    Reflection,
}

impl Rule {
    pub(super) fn other(self) -> Self {
        if self == Self::Return { Self::Reflection } else { Self::Return }
    }
}

/// An equilibrium on the way, with what has slipped since the arc began.
#[derive(Debug, Clone)]
pub(super) struct Poised<const D: usize, const C: usize> {
    pub(super) at: PieceState<D, C>,
    pub(super) slipped: Vec<SVector<f64, C>>,
}

/// What a sweep of small steps adds up.
#[derive(Debug, Clone)]
pub(super) struct Swept<const D: usize, const C: usize> {
    /// Where the last small step was made.
    pub(super) twist: SVector<f64, D>,
    pub(super) slipped: Vec<SVector<f64, C>>,
    /// `∫ F·da`, `∫ F_t·ds` and `∫ (q - q₀)·dW`.
    pub(super) works: [f64; 3],
    /// The sum of their sizes, contact by contact.
    pub(super) turnover: f64,
    /// Some contact slipped against its friction force on the way.
    pub(super) backwards: bool,
}

/// States that stay, from one factor on.
pub(super) struct Arc<'s, 'g, const D: usize, const C: usize> {
    segment: &'s Segment<'g, D, C>,
    pub(super) states: &'s [State<C>],
    pub(super) from: f64,
    pub(super) start: PieceState<D, C>,
    /// Of the twist, at the start: where Newton's method looks first.
    rate: SVector<f64, D>,
}

impl<'s, 'g, const D: usize, const C: usize> Arc<'s, 'g, D, C> {
    pub(super) fn new(
        segment: &'s Segment<'g, D, C>,
        states: &'s [State<C>],
        from: f64,
        start: PieceState<D, C>,
        rate: SVector<f64, D>,
    ) -> Self {
        Self { segment, states, from, start, rate }
    }

    pub(super) fn sites(&self) -> &'g [Site<D, C>] {
        self.segment.grasp.sites()
    }

    /// The load at a factor.
    pub(super) fn load(&self, factor: f64) -> SVector<f64, D> {
        self.segment.problem.wrench + self.segment.direction * factor
    }

    pub(super) fn slides(&self, contact: usize) -> bool {
        self.states[contact].slides()
    }

    /// The equilibrium at a factor in which what slides has slipped from this memory on along its friction force, forwards or
    /// backwards. `None` if Newton's method does not arrive.
    pub(super) fn poise(
        &self,
        factor: f64,
        memory: &[SVector<f64, C>],
        near: &SVector<f64, D>,
    ) -> Option<Poised<D, C>> {
        let sites = self.sites();
        let wrench = self.load(factor);
        let mut drives = self.segment.drives(factor);
        for (a, s) in drives.iter_mut().zip(memory) {
            *a -= s;
        }
        let mut twist = *near;
        let mut forces = vec![SVector::<f64, C>::zeros(); sites.len()];
        let mut stretches = drives.clone();
        let mut states = self.states.to_vec();
        let mut springs = vec![Springs::<C>::zeros(); sites.len()];
        for _ in 0..STEPS {
            for (i, site) in sites.iter().enumerate() {
                let v = site.stretch(&drives[i], &twist);
                let local = self.segment.problem.local(i);
                stretches[i] = v;
                if states[i].slides() {
                    let (force, slide) = local.slide_on(&v)?;
                    stretches[i] -= slide.rest(&site.springs, &v, &force, site.friction.limit(force[0]));
                    (states[i], forces[i]) = (Mode::Round(slide), force);
                } else if states[i].is_rolling() {
                    forces[i] = site.springs.force(&v);
                }
                springs[i] = local.tangent(&states[i]).matrix();
            }
            let solved = if let Some(solved) = balanced(sites, &springs, &wrench, &forces, twist) {
                solved
            } else {
                let step =
                    Piece::new(&self.segment.problem, &states).solve(sites, &stretches, &wrench).ok()?;
                PieceState { forces: step.forces, twist: twist + step.twist }
            };
            twist = solved.twist;
            let change = solved.forces.iter().zip(&forces).map(|(new, old)| (new - old).norm());
            let change = change.fold(0.0, f64::max);
            let sizes = solved.forces.iter().map(Matrix::norm);
            let largest = largest_force(sites, &drives, &twist, wrench.norm(), sizes);
            let on_its_cone = |i: usize| {
                let (f, r) = (&solved.forces[i], sites[i].friction.limit(solved.forces[i][0]));
                !self.slides(i) || (tangential_norm(f) - r).abs() <= ON_THE_CONE * largest.max(r)
            };
            if change <= SETTLED * largest && (0..sites.len()).all(on_its_cone) {
                let at = PieceState { forces: solved.forces, twist };
                let slipped = self.slipped(&drives, memory, &at);
                return Some(Poised { at, slipped });
            }
        }
        None
    }

    /// The memory and what has slipped on top of it, along the friction force.
    fn slipped(
        &self,
        drives: &[SVector<f64, C>],
        memory: &[SVector<f64, C>],
        at: &PieceState<D, C>,
    ) -> Vec<SVector<f64, C>> {
        let mut slipped = memory.to_vec();
        for (i, site) in self.sites().iter().enumerate().filter(|(i, _)| self.slides(*i)) {
            let p = tangential(&at.forces[i]).normalize();
            let slip = site.springs.slip(&site.stretch(&drives[i], &at.twist), &at.forces[i]);
            slipped[i] += p * p.dot(&slip);
        }
        slipped
    }

    /// So many equal small steps up to a factor.
    pub(super) fn sweep(&self, rule: Rule, count: usize, to: f64) -> Option<Swept<D, C>> {
        let n = self.states.len();
        let step = (to - self.from) / count as f64;
        let (mut at_factor, mut twist, mut rate) = (self.from, self.start.twist, self.rate);
        let slipped = vec![SVector::zeros(); n];
        let mut swept = Swept { twist, slipped, works: [0.0; 3], turnover: 0.0, backwards: false };
        for k in 1..=count {
            let part = if rule == Rule::Return { k as f64 } else { k as f64 - 0.5 };
            let next = self.from + step * part;
            let near = twist + rate * (next - at_factor);
            let Poised { at, mut slipped } = self.poise(next, &swept.slipped, &near)?;
            if rule == Rule::Reflection {
                for (s, before) in slipped.iter_mut().zip(&swept.slipped) {
                    *s += *s - before;
                }
            }
            let drives = self.segment.drives(next);
            for (i, force) in at.forces.iter().enumerate() {
                let finger = force.dot(&self.segment.change[i]) * step;
                let dissipated = tangential(force).dot(&(slipped[i] - swept.slipped[i]));
                swept.works[0] += finger;
                swept.works[1] += dissipated;
                swept.turnover += finger.abs() + dissipated.abs();
                if dissipated < 0.0 {
                    let least = tangential(force).norm() * self.sites()[i].span(&drives[i], &at.twist);
                    swept.backwards |= dissipated < -BACKWARDS * least;
                }
            }
            let load = (at.twist - self.start.twist).component_mul(&self.segment.direction) * step;
            swept.works[2] += load.sum();
            swept.turnover += load.abs().sum();
            // A step may be shorter than its factors can tell apart.
            if next > at_factor {
                rate = (at.twist - twist) / (next - at_factor);
            }
            (at_factor, twist, swept.slipped) = (next, at.twist, slipped);
        }
        swept.twist = twist;
        Some(swept)
    }

    /// What it would matter if what slides had slipped by this much more: the change of forces over the largest force, or
    /// the slip over the largest displacement.
    pub(super) fn effect(&self, stuck: &Piece<D, C>, slipped: &[SVector<f64, C>]) -> f64 {
        let back: Vec<_> = slipped.iter().map(|s| -s).collect();
        let Ok(change) = stuck.solve(self.sites(), &back, &SVector::zeros()) else {
            return f64::INFINITY;
        };
        let largest = |list: &[SVector<f64, C>]| list.iter().map(Matrix::norm).fold(0.0, f64::max);
        let (drives, load) = (self.segment.drives(self.from), self.load(self.from).norm());
        let twist = &self.start.twist;
        let sizes = self.start.forces.iter().map(Matrix::norm);
        let force = largest_force(self.sites(), &drives, twist, load, sizes);
        let spans = self.sites().iter().zip(&drives).map(|(site, a)| site.span(a, twist));
        let travel = spans.fold(0.0, f64::max);
        (largest(&change.forces) / force).max(largest(slipped) / travel)
    }

    /// The rounding of the slips: that of the displacements at each contact, memory included.
    pub(super) fn rounding(&self) -> Vec<SVector<f64, C>> {
        let drives = self.segment.drives(self.from);
        let one = |i: usize| {
            let span = self.sites()[i].span(&drives[i], &self.start.twist);
            let (at_rest, memory) = (&self.segment.problem.drives[i], &self.segment.problem.slips[i]);
            let size = f64::EPSILON * (span + at_rest.norm() + memory.norm());
            let slides = self.slides(i);
            SVector::from_fn(|a, _| if slides && a > 0 { size } else { 0.0 })
        };
        (0..self.states.len()).map(one).collect()
    }

    /// The piece in which everything closed sticks.
    pub(super) fn stuck(&self) -> Piece<D, C> {
        let stick = |state: &State<C>| if state.is_open() { Mode::Open } else { Mode::Rolling };
        Piece::new(&self.segment.problem, &self.states.iter().map(stick).collect::<Vec<_>>())
    }
}

/// One step of Newton's method, balanced to rounding, where the tangent stiffness is regular.
fn balanced<const D: usize, const C: usize>(
    sites: &[Site<D, C>],
    springs: &[Springs<C>],
    wrench: &SVector<f64, D>,
    forces: &[SVector<f64, C>],
    twist: SVector<f64, D>,
) -> Option<PieceState<D, C>> {
    let tangent = PartialPivoting::new(&tangent_stiffness(sites, springs))?;
    let mut state = PieceState { forces: forces.to_vec(), twist };
    balance(sites, springs, &tangent, wrench, &mut state, BALANCED).map(|_| state)
}
