//! The springs of a contact: body and finger in series, axis by axis.

use crate::numerics::by_axis;
use nalgebra::SVector;

/// Stiffness of a contact along the axes of its frame (normal first), N/m.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Stiffness<const C: usize> {
    /// Springs of body and finger, given separately; `f64::INFINITY` means rigid.
    BodyAndFinger {
        /// Springs between the core of the body (displacement u_c) and its surface (u_d), N/m. The core is the body without the deformation at its
        /// contacts.
        body: SVector<f64, C>,
        /// Springs between the core of the finger (displacement u_f) and its surface (u_e), N/m. The core is the finger without the deformation at
        /// its contact.
        finger: SVector<f64, C>,
    },
    /// The series stiffness of body and finger, N/m. How the deflection divides between body and finger is unknown, and so are the displacements of
    /// the surfaces.
    Series(SVector<f64, C>),
}

impl<const C: usize> Stiffness<C> {
    /// Series stiffness of every axis, N/m: `1/k = 1/k_body + 1/k_finger`.
    pub(crate) fn series(&self) -> SVector<f64, C> {
        match self {
            Self::BodyAndFinger { body, finger } => body.zip_map(finger, in_series),
            Self::Series(k) => *k,
        }
    }

    /// Stiffnesses of body and finger, N/m; both infinite if only their series stiffness is known.
    pub(super) fn sides(&self) -> [SVector<f64, C>; 2] {
        match self {
            Self::BodyAndFinger { body, finger } => [*body, *finger],
            Self::Series(_) => [SVector::repeat(f64::INFINITY); 2],
        }
    }

    /// The springs of the contact in series with an additional compliance of the finger, given axis by axis, m/N.
    pub(super) fn softened(&self, compliance: &SVector<f64, C>) -> Self {
        let soften = |k: &SVector<f64, C>| k.zip_map(compliance, |k, more| in_series(k, 1.0 / more));
        match self {
            Self::BodyAndFinger { body, finger } => {
                Self::BodyAndFinger { body: *body, finger: soften(finger) }
            }
            Self::Series(k) => Self::Series(soften(k)),
        }
    }

    /// All stiffnesses multiplied by `factor`; a rigid side stays rigid.
    pub(crate) fn scaled(&self, factor: f64) -> Self {
        self.each(|k| k * factor)
    }

    /// These springs with the tangential stiffnesses multiplied by `factor`.
    pub(crate) fn scaled_tangentially(&self, factor: f64) -> Self {
        self.each(|k| by_axis(|axis| if axis == 0 { k[0] } else { k[axis] * factor }))
    }

    fn each(&self, other: impl Fn(&SVector<f64, C>) -> SVector<f64, C>) -> Self {
        match self {
            Self::BodyAndFinger { body, finger } => {
                Self::BodyAndFinger { body: other(body), finger: other(finger) }
            }
            Self::Series(k) => Self::Series(other(k)),
        }
    }
}

impl<const C: usize> Default for Stiffness<C> {
    /// Rigid body and rigid finger. `Grasp::new` returns an error for this default, since forces between rigid bodies are not determined.
    fn default() -> Self {
        let rigid = SVector::repeat(f64::INFINITY);
        Self::BodyAndFinger { body: rigid, finger: rigid }
    }
}

/// Series stiffness `a b / (a + b)`, without overflow; either side may be infinite.
fn in_series(a: f64, b: f64) -> f64 {
    let (soft, stiff) = if a < b { (a, b) } else { (b, a) };
    if stiff.is_infinite() { soft } else { soft * (stiff / (soft + stiff)) }
}
