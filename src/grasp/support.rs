//! Which coordinates a site feels.

use std::ops::Range;

use nalgebra::SMatrix;

use super::rotation::of_the_object;

/// The coordinates in which a map has entries: those of the object, or none of them, and some joints next to each other. A contact
/// feels the joints of one finger, a drive its own.
#[derive(Debug, Clone)]
pub(crate) struct Support<const D: usize> {
    object: usize,
    joints: Range<usize>,
}

impl<const D: usize> Support<D> {
    pub(super) fn of<const C: usize>(map: &SMatrix<f64, D, C>, rest: &SMatrix<f64, D, C>) -> Self {
        let felt = |k: &usize| map.row(*k).iter().chain(rest.row(*k).iter()).any(|x| *x != 0.0);
        let object = of_the_object::<C>().min(D);
        let first = (object..D).find(felt).unwrap_or(D);
        let end = (first..D).rev().find(felt).map_or(first, |last| last + 1);
        Self { object: if (0..object).any(|k| felt(&k)) { object } else { 0 }, joints: first..end }
    }

    /// Its coordinates, as two ranges. Of a grasp without joints the first is all there is, and of a length known to the compiler.
    #[inline(always)]
    pub(crate) fn ranges<const C: usize>(&self) -> [Range<usize>; 2] {
        if D == of_the_object::<C>() { [0..D, D..D] } else { [0..self.object, self.joints.clone()] }
    }
}
