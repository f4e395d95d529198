//! A load that turns, in screening.

use std::f64::consts::TAU;

use super::first_slip::SlipCode;
use super::question::{Scenes, ScreeningQuestion};
use super::screened::ScreenedTurn;
use super::turning::judge;
use crate::error::Error;
use crate::grasp::Wrench;
use crate::load_path::Turn;
use crate::numerics::Harmonic;

/// A load on a grasp in screening that turns: a [`Turn`], checked once.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TurningPull<const C: usize> {
    /// Its three parts.
    pub(super) load: Harmonic<Wrench<C>>,
    /// How far it turns, rad; infinite for a full turn and more.
    pub(super) most: f64,
}

impl<const C: usize> TurningPull<C> {
    /// The load on the object at angle θ is `constant + cosine cos θ + sine sin θ`. Forces are in N, moments in N m.
    /// Moments are about the origin of the coordinates of each grasp.
    ///
    /// # Errors
    /// [`Error::Wrench`] if a component of a part is not finite or larger than 1e50.
    /// [`Error::Argument`] unless the angle is more than zero, and at most 1e6.
    pub fn new(turn: &Turn<C>) -> Result<Self, Error> {
        turn.check()?;
        let [constant, cosine, sine] = turn.parts();
        let most = if turn.angle() < TAU { turn.angle() } else { f64::INFINITY };
        Ok(Self { load: Harmonic::new([constant, cosine, sine]), most })
    }
}

impl<const D: usize, const C: usize> ScreeningQuestion<D, C> for TurningPull<C> {
    type Answer = ScreenedTurn;
    const UNKNOWN: ScreenedTurn = ScreenedTurn { first: SlipCode::UNKNOWN, most: 0.0 };

    #[inline(always)]
    fn ask<const N: usize, const L: usize>(&self, scenes: Scenes<'_, D, C, N, L>) -> [ScreenedTurn; L] {
        let forces = Harmonic {
            constant: scenes.squeezed_under(&self.load.constant),
            cosine: scenes.under(&self.load.cosine),
            sine: scenes.under(&self.load.sine),
        };
        judge(&scenes.block.friction, &forces, self.most)
    }
}
