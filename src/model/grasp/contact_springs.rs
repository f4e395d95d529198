//! The springs of a contact: the stiffnesses of object and finger.

use nalgebra::SVector;

use super::contact::Contact;
use super::stiffness::Stiffness;

impl<const C: usize> Contact<C> {
    /// Springs of the object at this contact: normal and tangential stiffness, N/m, positive; `f64::INFINITY` for a rigid object (the default). These
    /// springs replace a series stiffness given before.
    pub fn body_stiffness(self, normal: f64, tangential: f64) -> Self {
        self.body_stiffness_axes(normal_and_tangential(normal, tangential))
    }

    /// Springs of the object, one for each axis of the contact frame, the normal first, N/m.
    pub fn body_stiffness_axes(mut self, axes: impl Into<[f64; C]>) -> Self {
        let [_, finger] = self.stiffness.sides();
        self.stiffness = Stiffness::BodyAndFinger { body: SVector::from(axes.into()), finger };
        self
    }

    /// Springs of the finger: normal and tangential stiffness, N/m, positive; `f64::INFINITY` for a rigid finger (the default). These springs replace
    /// a series stiffness given before.
    pub fn finger_stiffness(self, normal: f64, tangential: f64) -> Self {
        self.finger_stiffness_axes(normal_and_tangential(normal, tangential))
    }

    /// Springs of the finger, one for each axis of the contact frame, the normal first, N/m.
    pub fn finger_stiffness_axes(mut self, axes: impl Into<[f64; C]>) -> Self {
        let [body, _] = self.stiffness.sides();
        self.stiffness = Stiffness::BodyAndFinger { body, finger: SVector::from(axes.into()) };
        self
    }

    /// Series stiffness of body and finger, `1/k = 1/k_body + 1/k_finger`: normal and tangential, N/m, positive and finite. It replaces the
    /// stiffnesses of body and finger. How the elastic displacement divides between the two surfaces is then unknown.
    pub fn series_stiffness(self, normal: f64, tangential: f64) -> Self {
        self.series_stiffness_axes(normal_and_tangential(normal, tangential))
    }

    /// Series stiffness, one for each axis of the contact frame, the normal first, N/m.
    pub fn series_stiffness_axes(mut self, axes: impl Into<[f64; C]>) -> Self {
        self.stiffness = Stiffness::Series(SVector::from(axes.into()));
        self
    }

    /// Series stiffness along the axes of the contact frame, N/m.
    #[must_use]
    pub fn series_stiffness_of_axes(&self) -> SVector<f64, C> {
        self.stiffness.series()
    }
}

fn normal_and_tangential<const C: usize>(normal: f64, tangential: f64) -> SVector<f64, C> {
    let mut axes = SVector::repeat(tangential);
    axes[0] = normal;
    axes
}
