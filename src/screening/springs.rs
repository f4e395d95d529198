//! How forces answer loads and commands while every contact sticks.

use super::block::{Block, Commanded};
use super::forces::Forces;
use super::lanes::Packed;
use super::method::Method;
use super::moved::ObjectMotion;
use crate::numerics::Vectors;

/// What moves the object.
pub(super) struct Cause<'a, const C: usize, X: Packed> {
    pub(super) commands: Commanded<'a, C, X>,
    /// The load on each, moments about the origin; zeros behind in the plane.
    pub(super) load: [X; 6],
}

/// What is known of scenes before any load acts: a pair, a triangle, or the stiffness of the object.
pub(super) trait StickingSprings<const C: usize, const M: usize, X: Packed>: Copy {
    /// Nothing yet.
    fn none() -> Self;
    /// Which scenes go this way.
    const METHOD: Method;
    /// So many contacts exactly, if it is for no others: it is short then, and all that is asked is compiled as one function.
    const CONTACTS: Option<usize>;

    fn prepare<V: Vectors>(&mut self, vectors: V, block: &Block<'_, C, X>);

    /// Forces that a load alone brings about, the fingers at rest: to those of the block's contacts.
    fn load<V: Vectors>(
        &self,
        vectors: V,
        block: &Block<'_, C, X>,
        load: &[f64],
        forces: &mut Forces<C, M, X>,
    );

    /// Forces that the commands of the fingers alone bring about, those of the block with its clearances, or
    /// others.
    fn squeeze<V: Vectors>(
        &self,
        vectors: V,
        block: &Block<'_, C, X>,
        others: Option<&Commanded<'_, C, X>>,
        forces: &mut Forces<C, M, X>,
    );

    /// How commands and a load move the object, with the forces that they bring about together.
    fn moved<V: Vectors>(
        &self,
        vectors: V,
        block: &Block<'_, C, X>,
        cause: &Cause<'_, C, X>,
        forces: &Forces<C, M, X>,
        moved: &mut ObjectMotion<C, M, X>,
    );
}
