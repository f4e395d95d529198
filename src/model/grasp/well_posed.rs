//! Validation of a contact: its numbers one by one, and the frame from its normal and tangent.

use nalgebra::{SMatrix, SVector};

use super::contact::Contact;
use super::stiffness::Stiffness;
use crate::error::{Error, Field, LARGEST, MODERATE, is_moderate};
use crate::numerics::tolerances::SOLVED_ROUNDING;
use crate::numerics::{Space, dot};

impl<const C: usize> Contact<C> {
    /// The contact frame: orthonormal columns n, t in the plane or n, t₁, t₂ in space. Returns an error if normal or tangent has no direction, or if
    /// both are parallel.
    pub(crate) fn frame(&self, index: usize) -> Result<SMatrix<f64, C, C>, Error> {
        let fault =
            |field, value, allowed| Error::Contact { contact: self.label(index), field, value, allowed };
        let n = unit(&self.normal).ok_or_else(|| {
            fault(Field::Normal, length_or_culprit(&self.normal), "of positive, finite length")
        })?;
        let mut frame: SMatrix<f64, C, C> = SMatrix::zeros();
        frame.set_column(0, &n);
        if self.space == Space::Planar {
            let mut t: SVector<f64, C> = SVector::zeros();
            t[0] = n[1];
            t[1] = -n[0];
            if let Some(hint) = &self.tangent {
                let side = dot(hint.as_slice(), t.as_slice());
                // A given tangent counts as parallel to the normal if its component across the normal is below the fraction `SOLVED_ROUNDING` of its
                // length. Rounding turns a tangent by some 1e-16, and must not choose the sign of t. If the bound were much larger, tangents with a
                // clear direction would be rejected.
                if !side.is_finite() || side.abs() <= SOLVED_ROUNDING * hint.norm() {
                    return Err(fault(
                        Field::Tangent,
                        length_or_culprit(hint),
                        "finite and not along the normal",
                    ));
                }
                t *= side.signum();
            }
            frame.set_column(1, &t);
            return Ok(frame);
        }
        let given = self.tangent.as_ref().map_or(1.0, SVector::norm);
        let hint = if let Some(hint) = &self.tangent {
            unit(hint)
                .ok_or_else(|| fault(Field::Tangent, length_or_culprit(hint), "of positive, finite length"))?
        } else {
            let mut axis = SVector::zeros();
            axis[n.iamin()] = 1.0;
            axis
        };
        // The projection is repeated, so that t₁ is orthogonal to n to the last bit even if the given tangent is nearly parallel to n.
        let across = |v: SVector<f64, C>| v - n * dot(n.as_slice(), v.as_slice());
        let flat = across(across(hint));
        if flat.norm() <= SOLVED_ROUNDING {
            return Err(fault(Field::Tangent, given, "not along the normal"));
        }
        let t1 = flat.normalize();
        let mut t2 = SVector::zeros();
        for a in 0..C {
            let (b, c) = ((a + 1) % C, (a + 2) % C);
            t2[a] = n[b] * t1[c] - n[c] * t1[b];
        }
        frame.set_column(1, &t1);
        frame.set_column(2, &t2);
        Ok(frame)
    }

    /// Returns an error for the first number out of range, except in the normal and the tangent, which [`Self::frame`] validates.
    pub(crate) fn check(&self, index: usize) -> Result<(), Error> {
        let fault =
            |field, value, allowed| Err(Error::Contact { contact: self.label(index), field, value, allowed });
        let bad = |v: &SVector<f64, C>| v.as_slice().iter().find(|x| !is_moderate(**x)).copied();
        if let Some(value) = bad(&self.point) {
            return fault(Field::Point, value, MODERATE);
        }
        let side = "positive (infinite for a rigid side)";
        let springs = match &self.stiffness {
            Stiffness::BodyAndFinger { body, finger } => {
                [(Field::BodyStiffness, body, side), (Field::FingerStiffness, finger, side)]
            }
            Stiffness::Series(k) => [(Field::SeriesStiffness, k, "positive and finite"); 2],
        };
        for (field, k, allowed) in springs {
            if let Some(&value) = k.as_slice().iter().find(|k| k.is_nan() || **k <= 0.0) {
                return fault(field, value, allowed);
            }
        }
        let series = self.stiffness.series();
        let usable = |k: &&f64| (1.0 / LARGEST..=LARGEST).contains(*k);
        if let Some(&value) = series.as_slice()[..self.springs()].iter().find(|k| !usable(k)) {
            return fault(
                Field::SeriesStiffness,
                value,
                "from 1e-50 to 1e50 (give a stiffness, and leave at most one side rigid)",
            );
        }
        if self.friction != f64::INFINITY && !(is_moderate(self.friction) && self.friction >= 0.0) {
            return fault(Field::Friction, self.friction, "from 0 to 1e50, or infinite");
        }
        // If kinetic friction is below a millionth of static friction, rounding dominates the direction of the friction force of a sliding contact.
        // Such data are refused.
        if let Some(kinetic) = self.kinetic
            && !(kinetic > 0.0 && kinetic >= self.friction * 1e-6 && kinetic <= self.friction)
        {
            let allowed = "from a millionth of the friction coefficient at rest to all of it";
            return fault(Field::KineticFriction, kinetic, allowed);
        }
        if let Some(value) = bad(&self.command) {
            return fault(Field::Command, value, MODERATE);
        }
        if let Some(press) = self.press
            && !(is_moderate(press) && press >= 0.0)
        {
            return fault(Field::Press, press, "from 0 to 1e50");
        }
        if let Some(force) = self.force
            && !(is_moderate(force) && force >= 0.0)
        {
            return fault(Field::Force, force, "from 0 to 1e50");
        }
        if !(is_moderate(self.suction) && self.suction >= 0.0) {
            return fault(Field::Suction, self.suction, "from 0 to 1e50");
        }
        if !is_moderate(self.clearance) {
            return fault(Field::Clearance, self.clearance, MODERATE);
        }
        Ok(())
    }
}

/// The unit vector along `v`, without overflow; `None` for a zero or non-finite vector.
pub(super) fn unit<const C: usize>(v: &SVector<f64, C>) -> Option<SVector<f64, C>> {
    let largest = v.amax();
    if !(largest > 0.0 && v.iter().all(|x| x.is_finite())) {
        return None;
    }
    let scaled = v / largest;
    Some(scaled / scaled.norm())
}

/// The number that a message shows for an invalid vector: its non-finite component, or else its length.
pub(super) fn length_or_culprit<const C: usize>(v: &SVector<f64, C>) -> f64 {
    v.as_slice().iter().find(|x| !x.is_finite()).copied().unwrap_or_else(|| v.norm())
}
