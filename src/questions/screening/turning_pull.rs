//! A load that turns through an angle, as a question of screening.

use core::f64::consts::TAU;

use super::answer_slots::AnswerSlots;
use super::first_slip::SlipCode;
use super::lanes::Packed;
use super::question::{Room, Scenes, ScreeningQuestion};
use super::screened::ScreenedTurn;
use super::turning::judge;
use crate::error::Error;
use crate::grasp::Wrench;
use crate::load_path::Turn;
use crate::numerics::{Harmonic, Vectors};

/// A load in screening that turns: a [`Turn`] whose components and angle have been checked.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TurningPull<const C: usize> {
    /// The constant, cosine and sine terms of the load, N and N m.
    pub(super) load: Harmonic<Wrench<C>>,
    /// The angle up to which the load turns, rad; infinite for a full turn or more.
    pub(super) most: f64,
}

impl<const C: usize> TurningPull<C> {
    /// The load on the object that at angle θ is `constant + cosine cos θ + sine sin θ`, with the three terms of `turn`. Forces are in N, moments in
    /// N m. Moments are about the origin of the coordinates of each grasp.
    ///
    /// # Errors
    /// [`Error::Wrench`] if a component of a term is not finite or larger than 1e50. [`Error::Argument`] unless the angle is more than zero, and at
    /// most 1e6.
    pub fn new(turn: &Turn<C>) -> Result<Self, Error> {
        turn.check()?;
        let [constant, cosine, sine] = turn.parts();
        let most = if turn.angle() < TAU { turn.angle() } else { f64::INFINITY };
        Ok(Self { load: Harmonic::new([constant, cosine, sine]), most })
    }
}

impl<const C: usize> ScreeningQuestion<C> for TurningPull<C> {
    type Answer = ScreenedTurn;
    const UNKNOWN: ScreenedTurn = ScreenedTurn { first: SlipCode::UNKNOWN, most: 0.0 };

    #[inline(always)]
    fn ask<V: Vectors, X: Packed>(
        &self,
        scenes: &Scenes<'_, V, C, X>,
        [constant, cosine, sine]: Room<'_, C, X>,
        told: &mut AnswerSlots<'_, ScreenedTurn, X>,
    ) {
        scenes.squeezed_under(&self.load.constant, constant);
        scenes.under(&self.load.cosine, cosine);
        scenes.under(&self.load.sine, sine);
        let forces = Harmonic { constant: &*constant, cosine: &*cosine, sine: &*sine };
        told.each(judge(scenes.vectors, scenes.block.friction(), &forces, self.most));
    }
}
