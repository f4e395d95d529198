//! Upper bound, in closed form, of the work of a contact along a virtual force and a virtual motion. A label restricts the states of the contact. The
//! hull of a label is the convex cone of the stretches v and forces F that the label allows; a few generators span it.
//!
//! Let φ be the virtual force and u the virtual motion, and let `w(v, F) = φ·v + u·F` be the work. K is the diagonal matrix of the stiffnesses, K_t
//! its tangential part, μ the coefficient of friction and c = K⁻¹φ. Indices n and t mark the normal and the tangential part of a vector. The work is
//! bounded by its largest value at the generators of the hull, over all directions p of friction that the label allows. The following values are
//! those of the generators before these are scaled. Both states, sticking and sliding, have the two values on the right.
//!
//! ```text
//! open       -c_n,  |c_t|                      sticks, slides    (c + u)_n + μ (c + u)_t·p,   (c + u)_n
//! slides     c_t·K_t p
//! ```
//!
//! The generators are scaled to length one in energy units (stretches times K^{1/2}, forces times K^{-1/2}). If none of these values is positive, the
//! contact does no positive work in any state that the label allows.
//!
//! In the law for rates as the load grows, one or two facets `μ F_n >= h·F_t` of the cone may be the only conditions. The generators are then forces
//! along these facets in both directions, forces into the cone, and slips along h. In code names an edge is the boundary of the cone.

use nalgebra::SVector;

use super::hull::{Label, Sector};
use super::law::{Law, LocalLaw};
use super::tangential::{cross, right_angle};
use crate::numerics::{highest, unit};
#[cfg(not(feature = "std"))]
use crate::prelude::*;

impl LocalLaw<'_> {
    /// Largest work `φ·v + u·F` over all pairs of stretch v and force F of length one, in energy units, that the label allows. The label restricts
    /// the states of the contact. φ (N) is the virtual force, and u (m) the virtual motion.
    pub(crate) fn most_work(&self, label: &Label, phi: &SVector<f64, 3>, u: &SVector<f64, 3>) -> f64 {
        let c = self.springs.deflection(phi);
        let mut most = f64::NEG_INFINITY;
        // Compares the work of one generator with the largest so far. The generator is given by the forces ξ = K v and F.
        let mut note = |xi: &SVector<f64, 3>, force: &SVector<f64, 3>| {
            let size = (2.0 * (self.springs.stored(xi) + self.springs.stored(force))).sqrt();
            most = most.max((c.dot(xi) + u.dot(force)) / size);
        };
        let (normal, none) = (unit::<3>(0), SVector::zeros());
        if let Law::Edge(facets) = self.law {
            self.for_each_force_at_an_edge(facets, |force| note(&force, &force));
            for h in facets {
                note(&self.springs.force(h), &none);
            }
            return most;
        }
        let tangents = 1..self.springs.axes();
        let may_be_open = matches!(label, Label::Anything | Label::Open);
        let may_be_closed = *label != Label::Open;
        if may_be_open {
            note(&-normal, &none);
            if self.is_absent() {
                note(&normal, &none);
            }
        }
        // If the label allows slip in any direction, the tangential stretch is free and has the generators ±e_t.
        let slips_anyhow = may_be_open || *label == Label::Closed && self.may_slide();
        if slips_anyhow {
            for axis in tangents.clone().map(unit::<3>) {
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
            for axis in tangents.map(unit::<3>) {
                note(&axis, &axis);
                note(&-axis, &-axis);
            }
        } else if may_be_closed {
            let sector = label.sector();
            let along = if slips_anyhow { *u } else { c + u };
            let force = self.friction.generator(&self.most_along(&sector, &along));
            note(if slips_anyhow { &normal } else { &force }, &force);
            if matches!(label, Label::Friction(_) | Label::Sliding(_)) {
                note(&self.springs.force(&self.most_along(&sector, &self.springs.force(&c))), &none);
            }
        }
        most
    }

    /// The friction force at μ F_n = 1 with the largest component along the vector `along`. On the round cone its direction lies in `sector`, the
    /// range of directions that the label allows. On a polygonal cone it is a corner of the polygon, whatever the sector.
    fn most_along(&self, sector: &Sector, along: &SVector<f64, 3>) -> SVector<f64, 3> {
        if self.on_round_cone {
            return sector.most_along(along);
        }
        let most = highest(&self.polygon.corners, &|corner| corner.dot(along));
        most.copied().unwrap_or_else(SVector::zeros)
    }

    /// Calls `visit` with generators of the forces that the facets `facets` allow, one or two in number. Generators point along the facet, or along
    /// the corner of both, in both directions, and into the cone.
    fn for_each_force_at_an_edge(&self, facets: &[SVector<f64, 3>], mut visit: impl FnMut(SVector<f64, 3>)) {
        let edge = self.edge(&self.yielding());
        let on_the_edge = self.cone().generator(&edge.pull);
        let mut both_ways = |force: SVector<f64, 3>| {
            visit(force);
            visit(-force);
        };
        both_ways(on_the_edge);
        if edge.stiffness > 0.0 {
            both_ways(edge.across);
        }
        match facets {
            // Generators that lead from the corner into the cone: each leaves one facet and stays on the other.
            [first, second] => {
                let turn = cross(first, second);
                visit(right_angle(second) / turn);
                visit(right_angle(first) / -turn);
            }
            _ => visit(-edge.pull),
        }
    }
}
