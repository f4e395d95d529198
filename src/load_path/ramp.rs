//! A load, finger commands, or both, that change in proportion to one factor.

use nalgebra::SVector;

use crate::grasp::Wrench;

/// At factor τ >= 0 the load is `base + τ direction` and the finger commands are those of the grasp plus τ times their
/// change. τ has no unit; with a direction of 1 N it counts newtons.
///
/// ```
/// use grasp_lcp::planar::{Ramp, Wrench};
///
/// // The weight grows by 2 N while two fingers each press 1 mm further, for each unit of τ.
/// let ramp = Ramp::load(Wrench::force([1.0, 0.0]), Wrench::force([0.0, -2.0])).with_commands([[1e-3, 0.0]; 2]);
/// assert_eq!(ramp.load_at(3.0), Wrench::force([1.0, -6.0]));
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Ramp<const D: usize, const C: usize> {
    pub(crate) base: Wrench<D, C>,
    pub(crate) direction: Wrench<D, C>,
    pub(crate) command_change: Option<Vec<SVector<f64, C>>>,
}

impl<const D: usize, const C: usize> Ramp<D, C> {
    /// The load changes, the fingers stay as commanded. Base in N and N m, direction in the same for each unit of the factor.
    #[must_use]
    pub fn load(base: Wrench<D, C>, direction: Wrench<D, C>) -> Self {
        Self { base, direction, command_change: None }
    }

    /// The load stays, the finger commands change: one displacement a contact for each unit of the factor, each in its contact frame (m),
    /// the normal part positive into the object.
    #[must_use]
    pub fn commands(load: Wrench<D, C>, change: impl IntoIterator<Item = impl Into<[f64; C]>>) -> Self {
        Self { base: load, direction: Wrench::ZERO, command_change: Some(vectors(change)) }
    }

    /// Finger commands change along with the load, as for [`Self::commands`].
    #[must_use]
    pub fn with_commands(mut self, change: impl IntoIterator<Item = impl Into<[f64; C]>>) -> Self {
        self.command_change = Some(vectors(change));
        self
    }

    /// The load at a factor, `base + τ direction`.
    #[must_use]
    pub fn load_at(&self, factor: f64) -> Wrench<D, C> {
        self.base + self.direction * factor
    }
}

/// A list of vectors from whatever turns into arrays.
pub(super) fn vectors<const C: usize>(
    list: impl IntoIterator<Item = impl Into<[f64; C]>>,
) -> Vec<SVector<f64, C>> {
    list.into_iter().map(|vector| SVector::from(vector.into())).collect()
}
