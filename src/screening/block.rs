//! Scenes side by side, and what pulls on them.

use std::ops::Range;

use super::lanes::Lanes;
use super::pair::Sizes;
use crate::error::{Error, is_moderate};
use crate::grasp::Wrench;

/// `L` scenes of `N` contacts each; arrays run over axes, then contacts.
#[derive(Debug, Clone, Copy)]
pub(super) struct Block<const C: usize, const N: usize, const L: usize> {
    pub(super) point: [[Lanes<L>; N]; C],
    /// Unit normals into the object.
    pub(super) normal: [[Lanes<L>; N]; C],
    /// Normal and tangential stiffness; in a planar pair the compliances, see [`super::pair`].
    pub(super) springs: [[Lanes<L>; N]; 2],
    /// Commanded displacements less the clearance: along the normal, and across it as in [`super::finger::Force`]. Kept apart, for a stiff tangential
    /// spring would make a force of what rounding turns of a long way along the normal.
    pub(super) pressed: [Lanes<L>; N],
    pub(super) sheared: [[Lanes<L>; N]; C],
    /// Friction coefficients, or codes; see [`super::exit`].
    pub(super) friction: [Lanes<L>; N],
    /// Of planar pairs only.
    pub(super) sizes: Sizes<L>,
}

/// What pulls on a grasp in screening: a load, and the direction in which it grows from there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pull<const D: usize> {
    pub(super) base: [f64; D],
    pub(super) direction: [f64; D],
    /// Whether the base load is any.
    pub(super) loaded: bool,
}

impl<const D: usize> Pull<D> {
    /// The load on the object `base + factor · direction`, factor >= 0: forces in N, moments in N m about the origin of the coordinates of each
    /// grasp. The factor has no unit, and no length is asked of the direction.
    ///
    /// # Errors
    /// [`Error::Wrench`] if a component of either is not finite or larger than 1e50.
    pub fn new(base: &Wrench<D>, direction: &Wrench<D>) -> Result<Self, Error> {
        for (what, wrench) in [("base load", base), ("load direction", direction)] {
            let w = wrench.as_vector();
            if let Some(component) = w.iter().position(|x| !is_moderate(*x)) {
                return Err(Error::Wrench { what, component, value: w[component] });
            }
        }
        let entries = |wrench: &Wrench<D>| std::array::from_fn(|k| wrench.as_vector()[k]);
        Ok(Self { base: entries(base), direction: entries(direction), loaded: *base != Wrench::ZERO })
    }
}

impl<const C: usize, const N: usize, const L: usize> Block<C, N, L> {
    /// Nothing yet.
    pub(super) const EMPTY: Self = {
        let none = Lanes([0.0; L]);
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

    /// Puts a scene into these lanes.
    pub(super) fn set(&mut self, lanes: Range<usize>, scene: &Block<C, N, 1>) {
        for lane in lanes.clone() {
            self.sizes.commands.0[lane] = scene.sizes.commands.0[0];
            self.sizes.moment.0[lane] = scene.sizes.moment.0[0];
            self.sizes.force.0[lane] = scene.sizes.force.0[0];
        }
        for contact in 0..N {
            for lane in lanes.clone() {
                for axis in 0..C {
                    self.point[axis][contact].0[lane] = scene.point[axis][contact].0[0];
                    self.normal[axis][contact].0[lane] = scene.normal[axis][contact].0[0];
                    self.sheared[axis][contact].0[lane] = scene.sheared[axis][contact].0[0];
                }
                for spring in 0..2 {
                    self.springs[spring][contact].0[lane] = scene.springs[spring][contact].0[0];
                }
                self.pressed[contact].0[lane] = scene.pressed[contact].0[0];
                self.friction[contact].0[lane] = scene.friction[contact].0[0];
            }
        }
    }
}
