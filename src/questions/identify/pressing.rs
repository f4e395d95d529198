//! The wrenches that contacts exert on the object as it leaves at gross slip (the loss of the object): those of normal forces and of friction, and
//! their derivatives with respect to the motion.

use nalgebra::{DMatrix, DVector, SVector};

use super::model::SlipToPredict;
use super::tolerances::INDISTINCT;
use crate::grasp::{Contact, Hold, Space, Wrench};
use crate::numerics::{IntoList, Vector, chosen, largest, mapped, vector_of};
use crate::prelude::*;

/// A contact that presses on the object while the object leaves at gross slip, or that cannot open.
pub(super) struct Pressing {
    pub(super) contact: usize,
    /// The wrench on the object of 1 N along the normal.
    pub(super) normal: DVector<f64>,
    /// The wrenches on the object of 1 N along each tangent, as columns.
    pub(super) tangents: DMatrix<f64>,
    /// Stiffness of the normal spring of the contact, N/m.
    pub(super) stiffness: f64,
    pub(super) friction: f64,
    pub(super) normal_force: f64,
    /// The tangential force of a sticking contact, N, as components along its tangents.
    pub(super) held: DVector<f64>,
    pub(super) sticks: bool,
    /// Whether the normal force may pull, as at a bonded contact or at a contact that is kept closed.
    pub(super) may_pull: bool,
}

impl Pressing {
    pub(super) fn slides(&self) -> bool {
        !self.sticks && self.friction > 0.0
    }

    pub(super) fn velocity(&self, motion: &DVector<f64>) -> DVector<f64> {
        self.tangents.tr_mul(motion)
    }

    /// The wrench on the object for 1 N of normal force. For a sliding contact it includes the friction force due to this normal force.
    pub(super) fn by_newton(&self, motion: &DVector<f64>) -> DVector<f64> {
        if self.slides() { &self.normal + self.friction_wrench(motion) } else { self.normal.clone() }
    }

    /// The wrench of the friction force due to 1 N of normal force, against the sliding velocity in this motion of the object.
    pub(super) fn friction_wrench(&self, motion: &DVector<f64>) -> DVector<f64> {
        &self.tangents * self.velocity(motion).normalize() * -self.friction
    }

    /// The derivative of a sliding contact's friction wrench if the motion of the object changes at the rate `by`. The friction force keeps its
    /// magnitude and rotates with the sliding velocity.
    pub(super) fn turning(&self, motion: &DVector<f64>, by: &DVector<f64>) -> DVector<f64> {
        let (v, change) = (self.velocity(motion), self.velocity(by));
        let aside = &change - &v * (v.dot(&change) / v.norm_squared());
        &self.tangents * aside * (-self.friction * self.normal_force / v.norm())
    }
}

/// The contacts whose normal force in `forces` presses, and all contacts that cannot open. Moments in their wrenches are divided by `length`.
pub(super) fn pressing(target: &SlipToPredict<'_>, forces: &[SVector<f64, 3>], length: f64) -> Vec<Pressing> {
    let (space, contacts) = (target.grasp.engine.space(), target.grasp.contacts());
    let largest = largest(forces, &|force| force[0].abs());
    let may_pull = |contact: &Contact<3>| contact.hold != Hold::Unilateral;
    let frames = target.grasp.frames().list();
    let of = |&contact: &usize| {
        let (data, frame) = (&contacts[contact], frames[contact]);
        let along = |axis: usize| {
            let unit = Wrench::force_through(&data.point, &frame.column(axis).into_owned());
            at_length(space, &unit.coordinates(space), length.recip())
        };
        let tangents: Vec<_> = (1..space.axes()).map(along).list();
        Pressing {
            contact,
            normal: along(0),
            tangents: DMatrix::from_columns(&tangents),
            stiffness: data.stiffness.series()[0],
            friction: data.friction,
            normal_force: forces[contact][0],
            held: DVector::from_column_slice(&forces[contact].as_slice()[1..space.axes()]),
            sticks: data.hold == Hold::Bonded,
            may_pull: may_pull(data),
        }
    };
    let presses = |i: &usize| may_pull(&contacts[*i]) || forces[*i][0] > INDISTINCT * largest;
    mapped(&chosen(contacts.len(), &presses), &of)
}

/// The coordinates of a load or a motion of the object. Moments or rotations are multiplied by `factor`, so that they are comparable with forces or
/// displacements.
pub(super) fn at_length(space: Space, coordinates: &Vector, factor: f64) -> DVector<f64> {
    let scaled = |k: usize, x: f64| if k < space.axes() { x } else { x * factor };
    vector_of(space.of_the_object(), &|k| scaled(k, coordinates[k]))
}
