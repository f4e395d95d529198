//! The data of a grasp outside the library, and the conditions of an equilibrium recomputed from them.
//!
//! From the library this module uses only the answer: the twist of the object and, contact by contact, force, gap
//! and slip. It computes frames, grasp map and polygon from the definitions
//!
//! ```text
//! u = displacement of the contact point in the contact frame
//! F_n = k_n (a_n - u_n + g)      0 <= g  ⟂  F_n >= 0        a_n: command less clearance
//! F_t = k_t (a_t - u_t - s)      F_t in μ F_n P,  F_t·s = max of x·s over x in μ F_n P
//! Σ F + W = 0, forces and moments
//! ```
//!
//! where P is [-1, 1] in the plane. In space P is the disc or a regular polygon with corners on the unit circle, according to the answer.

use std::f64::consts::TAU;

use grasp_lcp::ask::Grasp;
use grasp_lcp::equilibrium::{Cone, Equilibrium};
use grasp_lcp::grasp::{Contact, Wrench};
use nalgebra::{SMatrix, SVector};

/// One contact.
#[derive(Debug, Clone, Copy)]
pub struct Datum<const C: usize> {
    /// Contact point.
    pub point: SVector<f64, C>,
    /// Normal into the object, of any length.
    pub normal: SVector<f64, C>,
    /// Direction of the first tangent in space; unused in the plane.
    pub tangent: SVector<f64, C>,
    /// Series stiffness of each axis.
    pub stiffness: SVector<f64, C>,
    /// Coefficient of friction.
    pub friction: f64,
    /// Command of the finger, in the contact frame.
    pub command: SVector<f64, C>,
    /// Gap before the command.
    pub clearance: f64,
}

/// A grasp under a load.
#[derive(Debug, Clone)]
pub struct Scene<const D: usize, const C: usize> {
    /// Contacts, in order.
    pub contacts: Vec<Datum<C>>,
    /// Load on the object: force, and moment about the origin.
    pub load: SVector<f64, D>,
}

/// The sizes that errors are measured against.
#[derive(Debug, Clone, Copy)]
pub struct Sizes {
    /// The largest of load, contact forces, and the force of the softest spring under the largest command or clearance.
    pub force: f64,
    /// The largest of commands, clearances, displacements of the body at the contacts, gaps and slips.
    pub motion: f64,
    /// The largest distance of a contact from the origin.
    pub length: f64,
}

impl<const C: usize> Datum<C> {
    /// The contact frame, with columns n, t (and t₂).
    pub fn frame(&self) -> SMatrix<f64, C, C> {
        let n = self.normal.normalize();
        let mut frame = SMatrix::<f64, C, C>::zeros();
        frame.set_column(0, &n);
        if C == 2 {
            (frame[(0, 1)], frame[(1, 1)]) = (n[1], -n[0]);
            return frame;
        }
        let t = (self.tangent - n * n.dot(&self.tangent)).normalize();
        frame.set_column(1, &t);
        for a in 0..C {
            let (b, c) = ((a + 1) % C, (a + 2) % C);
            frame[(a, 2)] = n[b] * t[c] - n[c] * t[b];
        }
        frame
    }

    /// Command less clearance.
    pub fn drive(&self) -> SVector<f64, C> {
        let mut drive = self.command;
        drive[0] -= self.clearance;
        drive
    }

    /// The contact for the library.
    pub fn contact(&self) -> Contact<C> {
        let contact = Contact::new(self.point, self.normal)
            .series_stiffness_axes(self.stiffness)
            .friction(self.friction)
            .command(self.command)
            .clearance(self.clearance);
        if C == 2 { contact } else { contact.tangent(self.tangent) }
    }

    /// The smallest stiffness of the axes with a spring.
    pub fn softest(&self) -> f64 {
        (0..self.axes()).map(|a| self.stiffness[a]).fold(f64::INFINITY, f64::min)
    }

    /// Number of axes with a spring: a frictionless contact has only a normal one.
    pub fn axes(&self) -> usize {
        if self.friction == 0.0 { 1 } else { C }
    }
}

/// Displacement of a point under a twist.
pub fn displacement<const D: usize, const C: usize>(
    point: &SVector<f64, C>,
    twist: &SVector<f64, D>,
) -> SVector<f64, C> {
    let mut u = SVector::<f64, C>::from_fn(|a, _| twist[a]);
    if C == 2 {
        u[0] -= twist[2] * point[1];
        u[1] += twist[2] * point[0];
    } else {
        for a in 0..C {
            let (b, c) = ((a + 1) % 3, (a + 2) % 3);
            u[a] += twist[3 + b] * point[c] - twist[3 + c] * point[b];
        }
    }
    u
}

/// Force and moment about the origin of a force at a point.
pub fn wrench<const D: usize, const C: usize>(
    point: &SVector<f64, C>,
    force: &SVector<f64, C>,
) -> SVector<f64, D> {
    let mut w = SVector::<f64, D>::zeros();
    for a in 0..C {
        w[a] = force[a];
    }
    if C == 2 {
        w[2] = point[0] * force[1] - point[1] * force[0];
    } else {
        for a in 0..C {
            let (b, c) = ((a + 1) % 3, (a + 2) % 3);
            w[3 + a] = point[b] * force[c] - point[c] * force[b];
        }
    }
    w
}

impl<const D: usize, const C: usize> Scene<D, C> {
    /// The grasp for the library.
    pub fn grasp(&self) -> Grasp<C> {
        Grasp::new(self.contacts.iter().map(Datum::contact)).unwrap()
    }

    /// The load for the library.
    pub fn wrench(&self) -> Wrench<C> {
        Wrench::from_components(self.load.as_slice())
    }

    /// The sizes of the scene in this equilibrium.
    pub fn sizes(&self, answer: &Equilibrium<C>) -> Sizes {
        let load = SVector::<f64, C>::from_fn(|a, _| self.load[a]).norm();
        let mut sizes = Sizes { force: load, motion: 0.0, length: 0.0 };
        let (mut softest, mut command) = (f64::INFINITY, 0.0_f64);
        for (datum, c) in self.contacts.iter().zip(&answer.contacts) {
            let u =
                displacement(&datum.point, &SVector::<f64, D>::from_column_slice(answer.twist.components()));
            sizes.force = sizes.force.max(c.force.norm());
            command = command.max(datum.command.norm()).max(datum.clearance);
            sizes.motion = [command, u.norm(), c.gap, c.slip.norm()].into_iter().fold(sizes.motion, f64::max);
            sizes.length = sizes.length.max(datum.point.norm());
            softest = softest.min(datum.softest());
        }
        sizes.force = sizes.force.max(softest * command).max(f64::MIN_POSITIVE);
        sizes.motion = sizes.motion.max(f64::MIN_POSITIVE);
        sizes
    }

    /// The worst violation of the conditions at the top of this file, relative to the sizes of the scene. `facets` is the number of corners of the
    /// polygon in space.
    pub fn violation(&self, answer: &Equilibrium<C>, facets: usize) -> f64 {
        let sizes = self.sizes(answer);
        let mut worst = 0.0_f64;
        let mut check = |violation: f64, size: f64| {
            worst = if violation.is_nan() { f64::INFINITY } else { worst.max(violation / size) };
        };
        let mut sum = self.load;
        for (datum, c) in self.contacts.iter().zip(&answer.contacts) {
            let frame = datum.frame();
            let u = frame.tr_mul(&displacement(
                &datum.point,
                &SVector::<f64, D>::from_column_slice(answer.twist.components()),
            ));
            let mut give = datum.drive() - u - c.slip;
            give[0] = datum.drive()[0] - u[0] + c.gap;
            for a in 0..datum.axes() {
                check((c.force[a] / datum.stiffness[a] - give[a]).abs(), sizes.motion);
            }
            for a in datum.axes()..C {
                check(c.force[a].abs(), sizes.force);
            }
            check((frame * c.force - c.force_world).norm(), sizes.force);
            check(-c.gap, sizes.motion);
            check(-c.force[0], sizes.force);
            check(c.gap.min(c.force[0] / sizes.force * sizes.motion), sizes.motion);
            if datum.friction == f64::INFINITY {
                // With infinite friction a closed contact has no slip, and an open one no force.
                let closed = c.gap == 0.0 && c.force[0] > 0.0;
                check(if closed { c.slip.norm() } else { 0.0 }, sizes.motion);
                check(if c.gap > 0.0 { c.force.norm() } else { 0.0 }, sizes.force);
            } else if datum.friction > 0.0 {
                let limit = datum.friction * c.force[0];
                let size = sizes.force * (1.0 + datum.friction);
                let along = |d: &SVector<f64, C>, x: &SVector<f64, C>| d.dot(x);
                let most = |list: &[SVector<f64, C>], x: &SVector<f64, C>| {
                    list.iter().map(|d| along(d, x)).fold(0.0, f64::max)
                };
                let tangential = |x: &SVector<f64, C>| x.rows_range(1..).norm();
                let (used, support) = if answer.cone == Cone::Round {
                    (tangential(&c.force), tangential(&c.slip))
                } else {
                    (most(&facet_normals(facets), &c.force), most(&corners(facets), &c.slip))
                };
                check(used - limit, size);
                let missing = limit * support - along(&c.force, &c.slip);
                check(missing, size * sizes.motion);
            }
            sum += wrench::<D, C>(&datum.point, &c.force_world);
        }
        for k in 0..D {
            check(sum[k].abs(), if k < C { sizes.force } else { sizes.force * (1.0 + sizes.length) });
        }
        worst
    }
}

/// Corners of P, the set of friction forces divided by `μ F_n`, as vectors in the contact frame without normal component.
fn corners<const C: usize>(facets: usize) -> Vec<SVector<f64, C>> {
    ring(if C == 2 { 2 } else { facets }, 0.0, 1.0)
}

/// The facet normals h of P, the set of friction forces divided by `μ F_n`: P = {x : h·x <= 1}.
fn facet_normals<const C: usize>(facets: usize) -> Vec<SVector<f64, C>> {
    if C == 2 { corners(2) } else { ring(facets, 0.5, 1.0 / (TAU / (2.0 * facets as f64)).cos()) }
}

fn ring<const C: usize>(count: usize, first: f64, length: f64) -> Vec<SVector<f64, C>> {
    let at = |j: usize| {
        let angle = TAU * (j as f64 + first) / count as f64;
        let mut v = SVector::zeros();
        v[1] = length * angle.cos();
        if C == 3 {
            v[2] = length * angle.sin();
        }
        v
    };
    (0..count).map(at).collect()
}
