//! The data of scenes side by side.

use std::ops::Range;
use std::slice;

use super::lanes::Lanes;

/// `L` scenes of `N` contacts each. Arrays run over axes, then contacts: kept as fingers and
/// forces, contacts would be easier to read, and batches of four and five in space a tenth slower.
#[derive(Debug, Clone, Copy)]
pub(super) struct Block<const C: usize, const N: usize, const L: usize> {
    pub(super) point: [[Lanes<L>; N]; C],
    /// Unit normals into the object.
    pub(super) normal: [[Lanes<L>; N]; C],
    /// Normal and tangential stiffness; compliances where forces go along edges, see [`super::way`].
    pub(super) springs: [[Lanes<L>; N]; 2],
    /// Commanded displacements less the clearance: along the normal, and across it as in
    /// [`super::finger::Force`]. Kept apart, for a stiff tangential spring would make a force of
    /// what rounding turns of a long way along the normal.
    pub(super) pressed: [Lanes<L>; N],
    pub(super) sheared: [[Lanes<L>; N]; C],
    /// Friction coefficients, or codes; see [`super::cone`].
    pub(super) friction: [Lanes<L>; N],
    /// Zero where forces are found by motions.
    pub(super) sizes: Sizes<L>,
}

/// Commands along the normals and clearances apart, of which blocks have the difference: only who
/// changes the commands asks for them.
#[derive(Debug, Clone, Copy)]
pub(super) struct Parted<const N: usize, const L: usize> {
    pub(super) commanded: [Lanes<L>; N],
    pub(super) clearance: [Lanes<L>; N],
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
    pub(super) const EMPTY: Self = {
        let none = Lanes::ZERO;
        let zero = [none; N];
        let sizes = Sizes { commands: none, moment: none, force: none };
        Self {
            point: [zero; C],
            normal: [zero; C],
            springs: [zero; 2],
            pressed: zero,
            sheared: [zero; C],
            friction: zero,
            sizes,
        }
    };

    /// The normal of a contact.
    #[inline(always)]
    pub(super) fn normal_of(&self, contact: usize) -> [Lanes<L>; C] {
        let mut normal = [Lanes::ZERO; C];
        for axis in 0..C {
            normal[axis] = self.normal[axis][contact];
        }
        normal
    }

    /// Puts a scene into these lanes.
    pub(super) fn set(&mut self, lanes: &Range<usize>, scene: &Block<C, N, 1>) {
        let put = |to: &mut [Lanes<L>], from: &[Lanes<1>]| put(lanes, to, from);
        put(self.point.as_flattened_mut(), scene.point.as_flattened());
        put(self.normal.as_flattened_mut(), scene.normal.as_flattened());
        put(self.springs.as_flattened_mut(), scene.springs.as_flattened());
        put(&mut self.pressed, &scene.pressed);
        put(self.sheared.as_flattened_mut(), scene.sheared.as_flattened());
        put(&mut self.friction, &scene.friction);
        let Sizes { commands, moment, force } = &mut self.sizes;
        put(slice::from_mut(commands), &[scene.sizes.commands]);
        put(slice::from_mut(moment), &[scene.sizes.moment]);
        put(slice::from_mut(force), &[scene.sizes.force]);
    }
}

impl<const N: usize, const L: usize> Parted<N, L> {
    /// Nothing yet.
    pub(super) const EMPTY: Self = Self { commanded: [Lanes::ZERO; N], clearance: [Lanes::ZERO; N] };

    /// Puts a scene into these lanes.
    pub(super) fn set(&mut self, lanes: &Range<usize>, scene: &Parted<N, 1>) {
        put(lanes, &mut self.commanded, &scene.commanded);
        put(lanes, &mut self.clearance, &scene.clearance);
    }
}

fn put<const L: usize>(lanes: &Range<usize>, to: &mut [Lanes<L>], from: &[Lanes<1>]) {
    for (to, from) in to.iter_mut().zip(from) {
        to.0[lanes.clone()].fill(from.0[0]);
    }
}
