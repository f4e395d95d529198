//! Forces of sticking contacts under loads and commands.

use super::block::{Block, Commanded};
use super::forces::Forces;
use super::lanes::Packed;
use super::method::Method;
use super::moved::ObjectMotion;
use crate::numerics::Vectors;

/// The commands of the fingers and the load that move the object.
pub(super) struct Cause<'a, const C: usize, X: Packed> {
    pub(super) commands: Commanded<'a, C, X>,
    /// The load on each scene: force in N, then moments about the origin in N m. In the plane the last three are zero.
    pub(super) load: [X; 6],
}

/// The sticking springs of scenes before any load acts, by one of three methods: a pair, a triangle, or the stiffness of the object.
pub(super) trait StickingSprings<const C: usize, X: Packed>: Copy {
    /// An empty value that [`Self::prepare`] fills.
    fn none() -> Self;
    /// The method that this type implements; a scene that needs another one is skipped.
    const METHOD: Method;
    /// The number of contacts, if the method serves exactly one. Such a method is short, and each question is compiled with it as one function.
    const CONTACTS: Option<usize>;

    fn prepare<V: Vectors>(&mut self, vectors: V, block: &Block<'_, C, X>);

    /// Forces of a load alone, with the fingers at rest, at the contacts of the block.
    fn load<V: Vectors>(
        &self,
        vectors: V,
        block: &Block<'_, C, X>,
        load: &[f64],
        forces: &mut Forces<C, X>,
    );

    /// Forces of commands alone, the object without load: the commands of the block less its clearances, or `others`.
    fn squeeze<V: Vectors>(
        &self,
        vectors: V,
        block: &Block<'_, C, X>,
        others: Option<&Commanded<'_, C, X>>,
        forces: &mut Forces<C, X>,
    );

    /// The motion of the object under commands and a load, given the `forces` that both bring about together.
    fn moved<V: Vectors>(
        &self,
        vectors: V,
        block: &Block<'_, C, X>,
        cause: &Cause<'_, C, X>,
        forces: &Forces<C, X>,
        moved: &mut ObjectMotion<C, X>,
    );
}
