//! One contact as the arithmetic sees it.

use nalgebra::{SMatrix, SVector};

use super::contact::{Contact, Hold};
use super::rotation::grasp_map_in_twice;
use crate::error::Error;

/// What the arithmetic needs of one contact, in inside coordinates.
#[derive(Debug, Clone)]
pub(crate) struct Site<const D: usize, const C: usize> {
    /// Grasp map G_i.
    pub(crate) map: SMatrix<f64, D, C>,
    /// What rounding took from G_i, given the points and the frame.
    pub(crate) map_rest: SMatrix<f64, D, C>,
    /// Contact frame, columns n, t….
    pub(crate) frame: SMatrix<f64, C, C>,
    /// Series stiffness; zero along the tangents of a frictionless contact, which has no spring
    /// there.
    pub(crate) k: SVector<f64, C>,
    pub(crate) mu: f64,
    pub(crate) hold: Hold,
    /// Number of axes with a spring: 1 without friction, else `C`.
    pub(crate) axes: usize,
}

impl<const D: usize, const C: usize> Site<D, C> {
    /// The contact with this index, about the centroid `origin` and in the inside unit of `length`.
    ///
    /// # Errors
    /// [`Error::Contact`] if the contact has no frame.
    pub(super) fn new(
        contact: &Contact<C>,
        index: usize,
        origin: &SVector<f64, C>,
        length: f64,
    ) -> Result<Self, Error> {
        let frame = contact.frame(index)?;
        let axes = contact.springs();
        let series = contact.stiffness.series();
        let (map, map_rest) = grasp_map_in_twice(&contact.point, origin, length, &frame);
        Ok(Self {
            map,
            map_rest,
            frame,
            k: SVector::from_fn(|a, _| if a < axes { series[a] } else { 0.0 }),
            mu: contact.friction,
            hold: contact.hold,
            axes,
        })
    }
}
