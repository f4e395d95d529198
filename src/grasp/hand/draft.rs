//! A hand on its way to a grasp: what its parts are put into.

use nalgebra::SVector;

use super::drive::Drive;
use super::joint::Joint;
use super::positive::NotPositive;
use crate::error::Error;
use crate::grasp::contact::Contact;
use crate::grasp::rotation::of_the_object;
use crate::numerics::{Any, Vector};
use crate::prelude::*;
use crate::words::printable;

/// Motion of one contact with the coordinates beside those of the object, along the coordinate axes.
pub(in crate::grasp) type Columns<const C: usize> = Vec<(usize, SVector<f64, C>)>;

/// A hand on its way to a grasp.
pub(in crate::grasp) struct Assembly<const C: usize> {
    pub(in crate::grasp) contacts: Vec<Contact<C>>,
    pub(in crate::grasp) motions: Vec<Columns<C>>,
    /// Those of all fingers, then slides of contacts that are held by a force.
    pub(super) joints: Vec<Joint<C>>,
    /// Coordinates beside those of the object that are in use.
    pub(in crate::grasp) used: usize,
    pub(in crate::grasp) lengths: Vector<Any>,
    pub(super) drives: Vec<Drive<Any>>,
    pub(in crate::grasp) held: Vector<Any>,
    pub(super) bones: Vec<[SVector<f64, C>; 2]>,
    /// With which force each contact is told to press, along its normal and along the coordinate axes.
    pub(super) presses: Vec<(f64, SVector<f64, C>)>,
}

impl<const C: usize> Assembly<C> {
    /// Coordinates of the object.
    pub(super) const OBJECT: usize = of_the_object::<C>();

    pub(super) fn fault<T>(
        what: String,
        field: &'static str,
        value: f64,
        allowed: &'static str,
    ) -> Result<T, Error> {
        Err(Error::Hand { what, field, value, allowed })
    }

    pub(super) fn label(&self, joint: usize) -> String {
        self.joints[joint]
            .name
            .as_ref()
            .map_or_else(|| format!("joint {joint}"), |name| format!("joint {joint} ({})", printable(name)))
    }
}

/// The error for a matrix.
pub(super) fn refuse<T>(fault: NotPositive, what: String, field: &'static str) -> Result<T, Error> {
    Err(match fault {
        NotPositive::Shape { rows, columns, size } => Error::Shape {
            what: format!("{field} of {what}"),
            given: (rows, columns),
            expected: (size, size),
        },
        NotPositive::Entry(value) => Error::Hand { what, field, value, allowed: crate::error::MODERATE },
        NotPositive::Asymmetry(value) => {
            Error::Matrix { what, field, fault: "differs across its diagonal by", value }
        }
        NotPositive::Eigenvalue(value) => Error::Matrix { what, field, fault: "has the eigenvalue", value },
    })
}
