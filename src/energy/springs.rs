//! Springs that all hold, projected orthogonally: the accurate linear solve under every quadratic program here.
//!
//! A spring of a contact is a vector τ in its frame: it carries `x = τ·(a - G_iᵀq)` and pushes with the force `τ x`, so
//! that τ = √k e along an axis of stiffness k. With the rows τᵀG_iᵀ of A and α = τ·a
//!
//! ```text
//! x = α - A q,   Aᵀx = -W      ⟺      x = α - Q (Qᵀα + y),   A = Q R,   Rᵀ y = W
//! ```
//!
//! which keeps its digits whatever the stiffness ratios (see `numerics::orthogonal`).

use nalgebra::SVector;

use crate::grasp::Site;
use crate::numerics::{Orthogonal, without};
use crate::object::worked_on;

/// One spring.
#[derive(Debug, Clone, Copy)]
pub(super) struct Spring<const C: usize> {
    pub(super) contact: usize,
    pub(super) along: SVector<f64, C>,
}

/// Springs and their orthogonal factor.
#[derive(Debug, Clone)]
pub(super) struct Springs<const D: usize, const C: usize> {
    pub(super) list: Vec<Spring<C>>,
    pub(super) factor: Orthogonal<D>,
    /// Orthonormal motions that stretch none of them.
    pub(super) free: Vec<SVector<f64, D>>,
}

/// Their state under drives and a load.
#[derive(Debug, Clone)]
pub(super) struct Rest<const D: usize> {
    /// x of every spring.
    pub(super) x: Vec<f64>,
    /// R q: the twist in the coordinates of the factor.
    pub(super) travelled: SVector<f64, D>,
}

impl<const D: usize, const C: usize> Springs<D, C> {
    pub(super) fn new(sites: &[Site<D, C>], list: Vec<Spring<C>>) -> Self {
        let factor = Orthogonal::new(list.iter().map(|s| sites[s.contact].map * s.along).collect());
        let free = factor.null_space();
        Self { list, factor, free }
    }

    /// The springs along the axes that `holds(contact, axis)` says.
    pub(super) fn along_axes(sites: &[Site<D, C>], holds: impl Fn(usize, usize) -> bool) -> Self {
        let mut list = Vec::new();
        for (contact, site) in sites.iter().enumerate() {
            for axis in (0..site.springs.axes()).filter(|axis| holds(contact, *axis)) {
                let mut along = SVector::zeros();
                along[axis] = site.springs.root_along(axis);
                list.push(Spring { contact, along });
            }
        }
        Self::new(sites, list)
    }

    /// The unit motion on which the load works though no spring resists it.
    pub(super) fn worked_on(&self, wrench: &SVector<f64, D>) -> Option<SVector<f64, D>> {
        worked_on(&self.free, wrench)
    }

    /// The springs under these drives and this load, which must do no work on a free motion.
    pub(super) fn rest(&self, drives: &[SVector<f64, C>], wrench: &SVector<f64, D>) -> Rest<D> {
        let mut x: Vec<f64> = self.list.iter().map(|s| s.along.dot(&drives[s.contact])).collect();
        let travelled = self.factor.project(&mut x, wrench);
        Rest { x, travelled }
    }

    /// The twist of least norm.
    pub(super) fn twist(&self, travelled: &SVector<f64, D>) -> SVector<f64, D> {
        without(self.factor.preimage(travelled), &self.free)
    }

    /// The contact forces, each in its contact frame.
    pub(super) fn forces(&self, x: &[f64], contacts: usize) -> Vec<SVector<f64, C>> {
        let mut forces = vec![SVector::zeros(); contacts];
        for (spring, x) in self.list.iter().zip(x) {
            forces[spring.contact] += spring.along * *x;
        }
        forces
    }
}
