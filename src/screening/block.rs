//! The data of scenes side by side.

use std::ops::Range;

use super::finger::{Finger, Force};
use super::lanes::Lanes;

/// `L` scenes of `N` contacts each.
#[derive(Debug, Clone, Copy)]
pub(super) struct Block<const C: usize, const N: usize, const L: usize> {
    pub(super) points: [[Lanes<L>; C]; N],
    /// In a planar pair with compliances in place of the stiffnesses, see [`super::pair`].
    pub(super) fingers: [Finger<C, L>; N],
    /// Commanded displacements less the clearance, along the normal and across it. They are kept
    /// apart: a stiff tangential spring would make a force of the rounding of a long way along the
    /// normal.
    pub(super) commands: [Force<C, L>; N],
    /// Friction coefficients, or codes; see [`super::exit`].
    pub(super) friction: [Lanes<L>; N],
    /// Of planar pairs only.
    pub(super) sizes: Sizes<L>,
}

/// What the rounding of forces is measured against, for the commands, for a unit moment, and for a
/// unit force: the sum of the sizes of all terms.
#[derive(Debug, Clone, Copy)]
pub(super) struct Sizes<const L: usize> {
    pub(super) commands: Lanes<L>,
    pub(super) moment: Lanes<L>,
    pub(super) force: Lanes<L>,
}

impl<const C: usize, const N: usize, const L: usize> Block<C, N, L> {
    /// Nothing yet.
    pub(super) const EMPTY: Self = Self {
        points: [[Lanes::ZERO; C]; N],
        fingers: [Finger::NONE; N],
        commands: [Force::NONE; N],
        friction: [Lanes::ZERO; N],
        sizes: Sizes { commands: Lanes::ZERO, moment: Lanes::ZERO, force: Lanes::ZERO },
    };

    /// Puts a scene into these lanes.
    pub(super) fn set(&mut self, lanes: Range<usize>, scene: &Block<C, N, 1>) {
        let one = |to: &mut Lanes<L>, from: Lanes<1>| to.0[lanes.clone()].fill(from.0[0]);
        let all = |to: &mut [Lanes<L>], from: &[Lanes<1>]| {
            to.iter_mut().zip(from).for_each(|(to, from)| one(to, *from));
        };
        for i in 0..N {
            all(&mut self.points[i], &scene.points[i]);
            all(&mut self.fingers[i].normal, &scene.fingers[i].normal);
            all(&mut self.fingers[i].springs, &scene.fingers[i].springs);
            one(&mut self.commands[i].normal, scene.commands[i].normal);
            all(&mut self.commands[i].tangential, &scene.commands[i].tangential);
        }
        all(&mut self.friction, &scene.friction);
        one(&mut self.sizes.commands, scene.sizes.commands);
        one(&mut self.sizes.moment, scene.sizes.moment);
        one(&mut self.sizes.force, scene.sizes.force);
    }
}
