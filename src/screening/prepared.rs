//! What is known of a scene before any load acts.

use super::balance::RigidBody;
use super::block::Block;
use super::forces::Forces;
use super::lanes::Lanes;
use super::method::Method;
use super::pair::Pair;
use super::sticking;
use super::triangle::Triangle;
use crate::grasp::Wrench;

/// How forces answer loads and commands while every contact sticks.
#[derive(Debug, Clone, Copy)]
#[allow(clippy::large_enum_variant)] // none is ever moved about alone
pub(super) enum Prepared<const D: usize, const C: usize, const N: usize, const L: usize> {
    /// In closed form.
    Pair(Pair<L>),
    /// Along the edges of a triangle.
    Triangle(Triangle<C, N, L>),
    /// By the factors of the stiffness of the object.
    RigidBody(RigidBody<D, C, N, L>),
}

impl<const D: usize, const C: usize, const N: usize, const L: usize> Prepared<D, C, N, L> {
    /// Inlined, as all that follows, so that it is compiled for the vectors of the caller. Scenes that
    /// go the other way get numbers without meaning.
    #[inline(always)]
    pub(super) fn new(block: &Block<C, N, L>, way: Method) -> Self {
        match way {
            Method::Edges if C == 2 && N == 2 => Self::Pair(Pair::new(block)),
            Method::Edges if C == 3 && N == 3 => Self::Triangle(Triangle::new(block)),
            _ => Self::RigidBody(RigidBody::new(block)),
        }
    }

    /// Forces that the commands of the fingers alone bring about, clearances included.
    #[inline(always)]
    pub(super) fn squeezed(&self, block: &Block<C, N, L>) -> Forces<C, N, L> {
        match self {
            Self::Pair(pair) => pair.squeeze(),
            Self::Triangle(triangle) => triangle.squeeze(block),
            Self::RigidBody(body) => sticking::squeeze(body, &block.pressed, &block.sheared),
        }
    }

    /// Forces that other commands than those of the block bring about.
    #[inline(always)]
    pub(super) fn squeezed_by(
        &self,
        block: &Block<C, N, L>,
        (pressed, sheared): (&[Lanes<L>; N], &[[Lanes<L>; N]; C]),
    ) -> Forces<C, N, L> {
        match self {
            Self::Pair(pair) => pair.squeeze_by(block, (pressed, &sheared[0])),
            Self::Triangle(triangle) => triangle.squeeze_by(block, (pressed, sheared)),
            Self::RigidBody(body) => sticking::squeeze(body, pressed, sheared),
        }
    }

    /// Forces that a load alone brings about, the fingers at rest.
    #[inline(always)]
    pub(super) fn under(&self, block: &Block<C, N, L>, load: &Wrench<C>) -> Forces<C, N, L> {
        let mut lanes = [Lanes::ZERO; D];
        for k in 0..D {
            lanes[k] = Lanes::all(load.components()[k]);
        }
        match self {
            Self::Pair(pair) => pair.load(&lanes),
            Self::Triangle(triangle) => triangle.load(block, &lanes),
            Self::RigidBody(body) => sticking::load(body, &lanes),
        }
    }
}
