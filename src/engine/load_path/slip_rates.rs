//! Forces, motions and rates in the coordinates of slips.

use nalgebra::SVector;

use crate::contact::{Mode, State, tangential, tangential_norm};
use crate::equilibrium::{CountedMotion, Standing, farthest};
use crate::grasp::Engine;
use crate::numerics::{PartialPivoting, Size, Square, Vector, mapped};
use crate::object::{Piece, PieceState, Problem};
use crate::prelude::*;
use crate::search::SmallMotions;

/// Sliding contacts with the responses to their slips. A state is a list of weights of the parts: 1, λ, and the slips.
pub(super) struct Slips<'g> {
    pub(super) grasp: &'g Engine,
    pub(super) problem: Problem<'g>,
    pub(super) piece: alloc::sync::Arc<Piece>,
    /// State at load factor 0, its rate, and the responses to a unit slip of each sliding contact along both tangents.
    pub(super) parts: Vec<PieceState>,
    pub(super) sliding: Vec<usize>,
    /// A zero for each contact.
    pub(super) none: Vec<SVector<f64, 3>>,
    /// The largest force at the first slip, N.
    pub(super) largest: f64,
    /// The largest load factor asked about.
    pub(super) most: f64,
    /// The slip that counts in arclength as much as a change of the load factor by one, m.
    pub(super) unit: f64,
    pub(super) small: SmallMotions,
}

impl Slips<'_> {
    /// The contacts that stick.
    pub(super) fn sticking(&self) -> impl Iterator<Item = usize> {
        (0..self.none.len()).filter(|i| !self.sliding.contains(i))
    }

    /// The rates of a state for one unit of arclength, oriented along given ones.
    pub(super) fn flow(&self, at: &[f64], along: &[f64], rates: &mut [f64]) -> Option<()> {
        let directions = self.directions(at);
        let (mut matrix, count) = (self.margin_rates(&directions), directions.len());
        let scale = matrix.amax();
        matrix[(count, 0)] = along[1] * scale;
        for (j, (p, slip)) in directions.iter().zip(along[2..].chunks_exact(2)).enumerate() {
            matrix[(count, j + 1)] = (p[1] * slip[0] + p[2] * slip[1]) * (scale / self.unit);
        }
        let x = PartialPivoting::new(&matrix)?.solve(&Vector::unit(matrix.size(), count));
        let inverse = 1.0 / x.norm();
        (rates[0], rates[1]) = (0.0, x[0] * inverse);
        for ((p, slip), x) in directions.iter().zip(rates[2..].chunks_exact_mut(2)).zip(x.iter().skip(1)) {
            let slips = x * inverse * self.unit;
            (slip[0], slip[1]) = (p[1] * slips, p[2] * slips);
        }
        Some(())
    }

    /// The directions of the friction forces of sliding contacts.
    pub(super) fn directions(&self, at: &[f64]) -> Vec<SVector<f64, 3>> {
        let direction = |i: &usize| {
            let friction = tangential(&self.force(*i, at));
            friction / tangential_norm(&friction)
        };
        mapped(&self.sliding, &direction)
    }

    /// The rates of the margin of each sliding contact: with the load factor, and with the slip of each sliding contact in units of `unit`. The last
    /// row is zero.
    pub(super) fn margin_rates(&self, directions: &[SVector<f64, 3>]) -> Square {
        let mut rates = Square::zeros(Size::of(directions.len() + 1));
        for (row, (i, p)) in self.sliding.iter().zip(directions).enumerate() {
            let margin = self.problem.cone(*i).facet_row(p);
            rates[(row, 0)] = margin.dot(&self.parts[1].forces[*i]);
            for (j, (p, parts)) in directions.iter().zip(self.parts[2..].chunks_exact(2)).enumerate() {
                let moved = parts[0].forces[*i] * p[1] + parts[1].forces[*i] * p[2];
                rates[(row, j + 1)] = margin.dot(&moved) * self.unit;
            }
        }
        rates
    }

    /// The force of a contact in a state, or its rate.
    pub(super) fn force(&self, contact: usize, at: &[f64]) -> SVector<f64, 3> {
        let mut force = SVector::zeros();
        self.parts.iter().zip(at).for_each(|(part, weight)| force += part.forces[contact] * *weight);
        force
    }

    /// The motion of the object in a state, or its rate.
    pub(super) fn twist(&self, at: &[f64]) -> Vector {
        let mut twist = Vector::zeros();
        self.parts.iter().zip(at).for_each(|(part, weight)| twist.add_times(&part.twist, *weight));
        twist
    }

    /// The motions of a state that are compared with their limits.
    pub(super) fn motions(&self, at: &[f64]) -> Vec<CountedMotion> {
        let (offsets, forces, twist) = (&self.none[..], &self.none[..], &self.twist(at));
        let mut slips = self.none.clone();
        for (i, slip) in self.sliding.iter().zip(at[2..].chunks_exact(2)) {
            (slips[*i][1], slips[*i][2]) = (slip[0], slip[1]);
        }
        // The slips are known, so that every contact counts as sticking: no further slip is computed from its springs.
        let states: Vec<State> = vec![Mode::Sticking; slips.len()];
        let standing = Standing { offsets, slips: &slips, states: &states, forces, twist };
        self.grasp.counted_motions(&self.small, &standing)
    }

    /// The largest ratio of a motion to its limit.
    pub(super) fn far(&self, at: &[f64]) -> f64 {
        farthest(&self.motions(at)).map_or(0.0, CountedMotion::over_the_limit)
    }
}
