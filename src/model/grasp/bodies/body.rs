//! One of several bodies: its mass, its own load, and its motion in an answer.

use alloc::sync::Arc;

use nalgebra::SVector;

use crate::grasp::wrench::{Twist, Wrench};
use crate::prelude::*;
#[cfg(feature = "serde")]
use crate::serial::AsComputed;

/// A body with its name, its mass, and a constant load of its own. This load acts in addition to the load passed to a question such as
/// [`hold`](crate::ask::Grasp::hold).
///
/// ```
/// use grasp_lcp::planar::{Body, Wrench};
///
/// // A block of 12 kg, its centre of mass 0.1 m above the origin, that a cable pulls sideways with 5 N.
/// let block = Body::new("block").mass(12.0, [0.0, 0.1]).load(Wrench::force([5.0, 0.0]));
/// # let _ = block;
/// ```
#[derive(Debug, Clone, PartialEq)]
#[must_use]
pub struct Body<const C: usize> {
    pub(super) name: Arc<str>,
    pub(super) mass: f64,
    pub(super) centre: SVector<f64, C>,
    pub(super) load: Wrench<C>,
}

impl<const C: usize> Body<C> {
    /// A body with this name, without mass and load.
    pub fn new(name: impl Into<String>) -> Self {
        Self { name: name.into().into(), mass: 0.0, centre: SVector::zeros(), load: Wrench::ZERO }
    }

    setters! {
        /// Sets the mass, kg, and the centre of mass, m. [Gravity](super::Bodies::gravity) acts at the centre of mass, and so does the body's share
        /// of a load that is [shared by mass](super::Bodies::shared_by_mass).
        pub fn mass(mut self, mass: f64, centre: impl Into<[f64; C]>) {
            (self.mass, self.centre) = (mass, SVector::from(centre.into()));
        }

        /// Sets a constant load of the body: N, and N m about the origin of the scene. It acts in addition to the load passed to a question such as
        /// [`hold`](crate::ask::Grasp::hold).
        pub fn load(mut self, load: Wrench<C>) { self.load = load; }
    }
}

/// A load on one of several bodies.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct BodyLoad<const C: usize> {
    /// Name of the body.
    pub body: Arc<str>,
    /// The load: force in N, moment in N m about the origin of the scene.
    pub load: Wrench<C>,
}

/// Motion of a body, to first order.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct BodyMotion<const C: usize> {
    /// Name of the body.
    pub body: Arc<str>,
    /// Translation of the body's point at the origin of the scene (m), and rotation (rad).
    pub twist: Twist<C>,
    /// Centroid of the body's contact points, m.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<SVector<f64, C>>"))]
    pub centre: SVector<f64, C>,
    /// Root mean square distance of the body's contact points from their centroid, m; one metre if all of them lie at the same point.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
    pub reach: f64,
}

impl BodyMotion<3> {
    /// Displacement of the centroid of the body's contact points, m.
    pub(crate) fn middle_moves(&self) -> SVector<f64, 3> {
        self.twist.moves(&self.centre)
    }

    /// Displacement of the contact points due to the rotation about their centroid, m: the angle of rotation times `reach`.
    pub(crate) fn turning_moves(&self) -> f64 {
        self.twist.parts().1.size() * self.reach
    }

    /// Estimate of the largest displacement of a contact point of the body, m: the larger of the displacement of the centroid and the displacement
    /// due to rotation.
    pub(crate) fn speed(&self) -> f64 {
        self.middle_moves().norm().max(self.turning_moves())
    }
}
