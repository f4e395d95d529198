//! What is known of a scene before any load acts.

use super::balance::Body;
use super::block::Block;
use super::exit::{Forces, ON_THE_EDGE, judge};
use super::lanes::Lanes;
use super::pair::Pair;
use super::pull::Pull;
use super::rolling;
use super::screened::Screened;
use crate::contact::ZERO_SLACK as ROUNDING;
use crate::grasp::Wrench;

/// How forces answer a load, and the forces without one.
#[derive(Debug, Clone, Copy)]
pub(super) struct Ready<const D: usize, const C: usize, const N: usize, const L: usize> {
    answers: Answers<D, C, N, L>,
    squeezed: Forces<C, N, L>,
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
        Self { squeezed: rolling::squeeze(&body, block), answers: Answers::Body(body) }
    }

    #[inline(always)]
    fn under(&self, load: &Wrench<D, C>) -> Forces<C, N, L> {
        let mut lanes = [Lanes::ZERO; D];
        for k in 0..D {
            lanes[k] = Lanes::all(load.as_vector()[k]);
        }
        match &self.answers {
            Answers::Pair(pair) => pair.load(&lanes),
            Answers::Body(body) => rolling::load(body, &lanes),
        }
    }

    /// The onsets of all scenes.
    #[inline(always)]
    pub(super) fn screen(&self, friction: &[Lanes<L>; N], pull: &Pull<D, C>) -> [Screened; L] {
        let rates = self.under(&pull.direction);
        if !pull.loaded {
            return judge(friction, &self.squeezed, &rates);
        }
        let mut base = self.squeezed;
        let more = self.under(&pull.base);
        for i in 0..N {
            base.normal[i] += more.normal[i];
            base.rounding[i] += Lanes::all(ON_THE_EDGE / ROUNDING) * more.rounding[i];
            for axis in 0..C {
                base.tangential[axis][i] += more.tangential[axis][i];
            }
        }
        base.unbalanced += more.unbalanced;
        base.free += more.free;
        judge(friction, &base, &rates)
    }
}
