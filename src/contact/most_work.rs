//! How much a contact can do along a virtual stretch and a virtual force under a label, in closed form.
//!
//! With `w(v, F) = φ·v + u·F`, c = K⁻¹φ and ξ = K v, and with the largest value over the directions p of friction that the label
//! leaves, no more than
//!
//! ```text
//! open       -c_n,  |c_t|                      rolls, slides    (c + u)_n + μ (c + u)_t·p,   (c + u)_n
//! slides     c_t·K_t p
//! ```
//!
//! each for a generator of length one in energy units. Where none is positive the contact does nothing, whatever the law allows.

use nalgebra::SVector;

use super::hull::Label;
use super::law::LocalLaw;
use crate::numerics::unit;

impl<const C: usize> LocalLaw<'_, C> {
    /// The most that a stretch and a force of length one in energy units, allowed under the label, do along φ (N) and u (m).
    pub(crate) fn most_work(&self, label: &Label, phi: &SVector<f64, C>, u: &SVector<f64, C>) -> f64 {
        let c = self.springs.give(phi);
        let mut most = f64::NEG_INFINITY;
        // Of a generator (ξ, F) in force units.
        let mut note = |xi: &SVector<f64, C>, force: &SVector<f64, C>| {
            let size = (2.0 * (self.springs.stored(xi) + self.springs.stored(force))).sqrt();
            most = most.max((c.dot(xi) + u.dot(force)) / size);
        };
        let (normal, none) = (unit::<C>(0), SVector::zeros());
        let tangents = 1..self.springs.axes();
        let may_be_open = matches!(label, Label::Anything | Label::Open);
        let may_be_closed = *label != Label::Open;
        if may_be_open {
            note(&-normal, &none);
            if self.is_absent() {
                note(&normal, &none);
            }
        }
        // Where slips may point anywhere the tangential stretch is free, and only the force counts.
        let slips_anyhow = may_be_open || *label == Label::Closed && self.may_slide();
        if slips_anyhow {
            for axis in tangents.clone().map(unit::<C>) {
                note(&axis, &none);
                note(&-axis, &none);
            }
        }
        if may_be_closed && !matches!(label, Label::Sliding(_)) {
            note(&normal, &normal);
        }
        if may_be_closed && !self.may_slide() {
            if self.may_pull() {
                note(&-normal, &-normal);
            }
            for axis in tangents.map(unit::<C>) {
                note(&axis, &axis);
                note(&-axis, &-axis);
            }
        } else if may_be_closed {
            let sector = label.sector();
            let along = if slips_anyhow { *u } else { c + u };
            let force = self.friction.generator(&sector.most_along(&along));
            note(if slips_anyhow { &normal } else { &force }, &force);
            if matches!(label, Label::Friction(_) | Label::Sliding(_)) {
                note(&self.springs.force(&sector.most_along(&self.springs.force(&c))), &none);
            }
        }
        most
    }
}
