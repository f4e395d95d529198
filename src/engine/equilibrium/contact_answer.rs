//! State and forces of one contact in an equilibrium. A command is a prescribed displacement of a finger.

use nalgebra::SVector;

use crate::error::ContactLabel;
#[cfg(not(feature = "std"))]
use crate::prelude::*;
#[cfg(feature = "serde")]
use crate::serial::AsComputed;

/// State, force and displacements of one contact in an equilibrium.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct ContactAnswer<const C: usize> {
    /// Label of the contact.
    #[cfg_attr(feature = "serde", serde(flatten))]
    pub contact: ContactLabel,
    /// State of the contact.
    #[cfg_attr(feature = "serde", serde(flatten))]
    pub state: ContactState<C>,
    /// Force of the finger on the object in the contact frame, N: (`F_n`, `F_t`…); `F_n` > 0 pushes. Without friction `F_t` is zero.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<SVector<f64, C>>"))]
    pub force: SVector<f64, C>,
    /// The contact force along the coordinate axes, N.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<SVector<f64, C>>"))]
    pub force_world: SVector<f64, C>,
    /// Gap between the surfaces, m: `n·u_c - a_n` along the normal n if that is positive, otherwise zero. Here u_c is the body's displacement, and
    /// a_n the finger's offset (command minus clearance) along n.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
    pub gap: f64,
    /// Slip of the finger over the body in the contact frame, `s = a_t - t·u_c - F_t/k_t`, m. Here a_t is the finger's commanded displacement along
    /// the tangents t, u_c the body's displacement and k_t the stiffness along t. The normal component of the slip is zero. The slip is along F_t if
    /// the contact slides, and zero if it sticks. On a load path it is the whole slip so far, which a sticking contact keeps. For a separated or
    /// frictionless contact it is the displacement of the surfaces past each other.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<SVector<f64, C>>"))]
    pub slip: SVector<f64, C>,
    /// Margin of a sticking contact, N: `μ F_n - |F_t|` in the plane and on the round cone, on a polygonal cone the least of `μ F_n - h·F_t` over its
    /// facet normals h. Infinite if the contact is bonded or has infinite friction. Zero for a sliding, separated or frictionless contact.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
    pub margin: f64,
    /// True if the contact state is certain in spite of rounding ([`Grasp::distinct`](crate::ask::Grasp::distinct)). False if the last digits of the
    /// given numbers decide between it and a neighbouring contact state, such as sticking and sliding. `None` if this was not computed; it is
    /// computed in answers to the question `solve` of a scene.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub distinct: Option<bool>,
    /// Displacement u_c of the contact point as a point of the rigid body, without the deformation of its surface, along the coordinate axes, m.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<SVector<f64, C>>"))]
    pub body_core: SVector<f64, C>,
    /// Displacement u_d of the body's surface along the coordinate axes, m: u_c plus the deformation of the body. `None`, and omitted, if only the
    /// stiffness of body and finger in series is known.
    #[cfg_attr(
        feature = "serde",
        serde(
            default,
            with = "AsComputed::<Option<SVector<f64, C>>>",
            skip_serializing_if = "Option::is_none"
        )
    )]
    #[cfg_attr(feature = "schema", schemars(!default))]
    pub body_surface: Option<SVector<f64, C>>,
    /// Displacement u_e of the finger's surface along the coordinate axes, m: the displacement of the finger plus its deformation. `None`, and
    /// omitted, if only the stiffness of body and finger in series is known.
    #[cfg_attr(
        feature = "serde",
        serde(
            default,
            with = "AsComputed::<Option<SVector<f64, C>>>",
            skip_serializing_if = "Option::is_none"
        )
    )]
    #[cfg_attr(feature = "schema", schemars(!default))]
    pub finger_surface: Option<SVector<f64, C>>,
}

impl<const C: usize> ContactAnswer<C> {
    /// Normal force `F_n`, N.
    #[must_use]
    pub fn normal_force(&self) -> f64 {
        self.force[0]
    }

    /// Magnitude of the tangential force, `|F_t|`, N.
    #[must_use]
    pub fn friction_force(&self) -> f64 {
        self.force.iter().skip(1).fold(0.0, |h: f64, f| h.hypot(*f))
    }

    /// Friction used: the ratio `|F_t| / F_n`, to be compared with the coefficient μ. Zero without tangential force, or if F_n is not positive. The
    /// number has no meaning for a bonded contact, whose normal force may pull.
    #[must_use]
    pub fn friction_used(&self) -> f64 {
        let friction = self.friction_force();
        if friction == 0.0 || self.force[0] <= 0.0 { 0.0 } else { friction / self.force[0] }
    }
}

impl ContactAnswer<2> {
    /// Tangential force `F_t` along the tangent t, N, with its sign.
    #[must_use]
    pub fn tangential_force(&self) -> f64 {
        self.force[1]
    }

    /// The ratio `F_t / F_n` with the sign of `F_t`, as the paper "Position Control for Multifingered Robot Hand" tabulates it. Zero without
    /// tangential force, or if F_n is not positive.
    #[must_use]
    pub fn ratio(&self) -> f64 {
        self.friction_used().copysign(self.force[1])
    }
}

/// State of a contact.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(tag = "state", rename_all = "snake_case")
)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub enum ContactState<const C: usize> {
    /// Open, or touching without force: F = 0, gap >= 0.
    Separated,
    /// Closed and stuck: gap = 0, no slip (on a load path no further slip), `|F_t| <= μ F_n`. The paper "Position Control for Multifingered Robot
    /// Hand" calls this state rolling; today that word is used for a fingertip that rolls. A bonded contact is always in this state, whatever its
    /// force.
    #[doc(alias = "rolling")]
    Sticking,
    /// Closed and sliding, with the force on the boundary of its cone: gap = 0, `|F_t| = μ F_n`, F_t along the slip.
    Sliding {
        /// Unit direction, along the coordinate axes, in which the finger slips over the body; friction pulls the body in this direction.
        #[cfg_attr(feature = "serde", serde(with = "AsComputed::<SVector<f64, C>>"))]
        direction: SVector<f64, C>,
    },
    /// Closed without friction: F_t = 0, and the surfaces move freely past each other.
    Frictionless,
}
