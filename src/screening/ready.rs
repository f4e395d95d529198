//! What is known of a scene before any load acts.

use super::balance::Body;
use super::block::{Block, Parted};
use super::forces::{Forces, ON_THE_EDGE};
use super::lanes::Lanes;
use super::pair::Pair;
use super::rolling;
use crate::contact::ZERO_SLACK as ROUNDING;
use crate::grasp::Wrench;

/// How forces answer a load, and the forces without one.
#[derive(Debug, Clone, Copy)]
pub(super) struct Ready<const D: usize, const C: usize, const N: usize, const L: usize> {
    answers: Answers<D, C, N, L>,
    /// Forces that the commands of the fingers alone bring about, clearances included.
    pub(super) squeezed: Forces<C, N, L>,
}

#[derive(Debug, Clone, Copy)]
#[allow(clippy::large_enum_variant)] // neither is ever moved about alone
enum Answers<const D: usize, const C: usize, const N: usize, const L: usize> {
    /// In closed form.
    Pair(Pair<L>),
    /// By the factors of the stiffness of the object.
    Body(Body<D, C, N, L>),
}

impl<const D: usize, const C: usize, const N: usize, const L: usize> Ready<D, C, N, L> {
    /// Inlined, as all that follows, so that it is compiled for the vectors of the caller.
    #[inline(always)]
    pub(super) fn new(block: &Block<C, N, L>) -> Self {
        if C == 2 && N == 2 {
            let pair = Pair::new(block);
            return Self { squeezed: pair.squeeze(), answers: Answers::Pair(pair) };
        }
        let body = Body::new(block);
        Self {
            squeezed: rolling::squeeze(&body, &block.pressed, &block.sheared),
            answers: Answers::Body(body),
        }
    }

    /// Forces that a load alone brings about, the fingers at rest.
    #[inline(always)]
    pub(super) fn under(&self, load: &Wrench<D, C>) -> Forces<C, N, L> {
        let mut lanes = [Lanes::ZERO; D];
        for k in 0..D {
            lanes[k] = Lanes::all(load.as_vector()[k]);
        }
        match &self.answers {
            Answers::Pair(pair) => pair.load(&lanes),
            Answers::Body(body) => rolling::load(body, &lanes),
        }
    }

    /// The forces of the commands and a load together.
    #[inline(always)]
    pub(super) fn squeezed_under(&self, load: &Wrench<D, C>) -> Forces<C, N, L> {
        self.squeezed.with(&self.under(load), ON_THE_EDGE / ROUNDING)
    }

    /// Forces that the commands alone bring about, and those of the clearances.
    #[inline(always)]
    pub(super) fn apart(&self, block: &Block<C, N, L>, parted: &Parted<N, L>) -> [Forces<C, N, L>; 2] {
        let mut least = Lanes::ZERO;
        let mut overlaps = [Lanes::ZERO; N];
        for i in 0..N {
            least = least.max(parted.clearance[i].abs());
            overlaps[i] = -parted.clearance[i];
        }
        if least.0 == [0.0; L] {
            // The same to the last bit.
            return [self.squeezed, Forces::none()];
        }
        let at_rest = [[Lanes::ZERO; N]; C];
        match &self.answers {
            Answers::Pair(pair) => [
                pair.squeeze_by(block, (&parted.commanded, &block.sheared[0])),
                pair.squeeze_by(block, (&overlaps, &at_rest[0])),
            ],
            Answers::Body(body) => [
                rolling::squeeze(body, &parted.commanded, &block.sheared),
                rolling::squeeze(body, &overlaps, &at_rest),
            ],
        }
    }
}
