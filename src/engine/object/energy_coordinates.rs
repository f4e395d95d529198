//! Contacts in energy coordinates: maps from the motion of the object to the stretch of each contact, and slips across facets of friction cones.
//!
//! ```text
//! x = K^{-1/2}F,   K^{1/2}Gᵀ = QR,   u = x⁰ - Q y,   x = P u
//! ```
//!
//! F are the contact forces, K the stiffnesses, G the grasp maps, and QR an orthogonal factorisation. The elastic trial, in which every contact
//! sticks, has the forces x⁰ in energy coordinates. Under the further motion y of the object the stretches are u. For each contact state a projection
//! P leaves the part of u that becomes force. A facet of a cone is `κ x_n + c·x_t >= 0` with c of length one and a number κ for the normal part. Slip
//! across it moves x along (0, c). Consecutive equal contacts share their facets.

use nalgebra::{SMatrix, SVector};

use super::problem::Problem;
use crate::contact::{LocalLaw, cross, tangential, tangential_norm};
use crate::numerics::{Each, Orthogonal, ScaledMap, by_axis};
use crate::prelude::*;

/// A facet of a friction cone, the condition `row·x >= 0` on the contact force x in energy coordinates. It is scaled so that the tangential part of
/// `row` has length one. The condition `x_n >= 0` of a contact that may open is the facet with the row (1, 0, 0).
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Facet {
    /// The inward normal of the facet in energy coordinates: `row·x >= 0` inside the cone. Its tangential part has length one, or is zero for
    /// `x_n >= 0`.
    pub(crate) row: SVector<f64, 3>,
    /// Length of `row`. The entries of covering and perturbation vectors of the complementarity problem are given for normals of length one; this
    /// factor converts them to `row`.
    pub(crate) unit: f64,
}

impl Facet {
    /// The facet `μ F_n - h·F_t = 0` of a contact, with the facet normal h; `root` holds the square roots of the contact's stiffnesses.
    fn new(law: &LocalLaw<'_>, root: &SVector<f64, 3>, h: &SVector<f64, 3>) -> Self {
        let row = root.component_mul(&law.cone().facet_row(h));
        let row = row / tangential_norm(&row);
        Self { row, unit: row.norm() }
    }

    /// The change of the contact force in energy coordinates by a unit slip across this facet: the tangential part of `row`.
    pub(crate) fn column(&self) -> SVector<f64, 3> {
        tangential(&self.row)
    }
}

/// The map and the conditions of a contact in energy coordinates, in which forces are divided by the square roots of stiffnesses.
#[derive(Debug, Clone)]
pub(crate) struct EnergyContact {
    /// The map from the motion y of the object to the contact's stretch in energy coordinates. All maps have one scale: the mean over the contacts of
    /// their squared norms is one.
    pub(crate) seen: ScaledMap,
    /// Index of the contact's first condition in the common list of facets: `x_n >= 0` if the contact may open, then its facets.
    first: u32,
    pub(crate) facet_count: u16,
    /// Whether the contact may open, so that its first condition is `x_n >= 0`.
    pub(crate) gap: bool,
}

impl EnergyContact {
    /// Number of conditions of the contact: one for its gap if it may open, and one for each facet of its cone.
    pub(crate) fn pairs(&self) -> usize {
        usize::from(self.gap) + usize::from(self.facet_count)
    }
}

/// Data that all contacts of a problem share in energy coordinates: the list of all facets, and the scale and rank of the maps.
#[derive(Debug, Clone, Default)]
pub(crate) struct EnergyCoordinates {
    facets: Vec<Facet>,
    /// The factor w for which `w Σ QᵀQ` is the identity, with the scaled map Q of each contact: the rank divided by the number of contacts.
    pub(crate) weight: f64,
    /// Rank of the maps of all contacts together: components of the motion y from this index on stretch no contact.
    pub(crate) rank: usize,
}

impl EnergyCoordinates {
    /// Computes facets, scale and rank of all contacts from `factor`, the orthogonal factor of `K^{1/2}Gᵀ` while everything sticks. Calls `visit`
    /// with each contact's law and energy coordinates, in order.
    pub(crate) fn lay_out(
        &mut self,
        problem: &Problem<'_>,
        factor: &Orthogonal,
        mut visit: impl FnMut(&LocalLaw<'_>, EnergyContact),
    ) {
        self.rank = factor.rank();
        self.weight = self.rank.max(1) as f64 / problem.len().max(1) as f64;
        let scale = 1.0 / self.weight.sqrt();
        self.facets.clear();
        // Reserves room for the most facets that this number of contacts can have, so that later problems of this size need no allocation.
        self.facets.reserve(problem.len() * (problem.polygon.normals.len() + 1));
        let mut spring = 0;
        let mut before: Option<(LocalLaw<'_>, (u32, u16))> = None;
        for law in problem.locals() {
            let mut seen = ScaledMap::zeros(factor.size());
            if !law.is_absent() {
                for axis in 0..law.springs.axes() {
                    for (k, entry) in factor.row(spring).iter().enumerate() {
                        seen[(axis, k)] = entry * scale;
                    }
                    spring += 1;
                }
            }
            // A contact with the same conditions as the one before it shares its facets, unless polygons are turned contact by contact.
            let alike = before.filter(|(neighbour, _)| {
                problem.turned.is_empty()
                    && law.may_open() == neighbour.may_open()
                    && law.has_the_facets_of(neighbour)
            });
            let facets = alike.map_or_else(|| self.add_facets(&law), |(_, facets)| facets);
            let ((first, facet_count), gap) = (facets, law.may_open());
            let contact = EnergyContact { seen, first, facet_count, gap };
            visit(&law, contact);
            before = Some((law, facets));
        }
    }

    fn add_facets(&mut self, law: &LocalLaw<'_>) -> (u32, u16) {
        // No machine has memory for more than `u32::MAX` facets.
        let first = u32::try_from(self.facets.len()).unwrap_or(u32::MAX);
        if law.may_open() {
            self.facets.push(Facet { row: normal(), unit: 1.0 });
        }
        let root = law.springs.root();
        let mut count = 0;
        for h in law.facets() {
            self.facets.push(Facet::new(law, &root, h));
            count += 1;
        }
        (first, count)
    }

    /// The conditions of a contact: `x_n >= 0` for its normal force x_n if it may open, then its facets.
    #[inline]
    pub(crate) fn pairs(&self, contact: &EnergyContact) -> &[Facet] {
        let first = contact.first as usize;
        &self.facets[first..first + contact.pairs()]
    }
}

/// A closed contact that slips across none, one or two of its facets (at most one in the plane), with their rows in energy coordinates.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Slipping {
    rows: [SVector<f64, 3>; 2],
    /// For each of the `count` facets a a tangential vector z_a, the dual basis of the tangential parts c_b of their rows: `z_a·c_b` is 1 for a = b,
    /// else 0.
    pub(crate) across: [SVector<f64, 3>; 2],
    pub(crate) count: usize,
}

impl Slipping {
    /// A contact that slips across one facet, two neighbouring facets, or none.
    pub(crate) fn new(facets: [Option<&Facet>; 2]) -> Self {
        let zero = SVector::zeros();
        let rows = facets.each(|facet| facet.map_or(zero, |facet| facet.row));
        let mut slipping = Self { rows, across: [zero; 2], count: facets.iter().flatten().count() };
        slipping.across[0] = tangential(&rows[0]);
        if slipping.count == 2 {
            let ([a, b], turn) = (rows, cross(&rows[0], &rows[1]));
            let [of_a, of_b] = &mut slipping.across;
            (of_a[1], of_a[2]) = (b[2] / turn, -b[1] / turn);
            (of_b[1], of_b[2]) = (-a[2] / turn, a[1] / turn);
        }
        slipping
    }

    /// A contact that slips across the given facets; `None` for more than two facets, or for two that are nearly parallel.
    pub(crate) fn independent<'f>(mut facets: impl Iterator<Item = &'f Facet>) -> Option<Self> {
        let pair = [facets.next(), facets.next()];
        match pair {
            _ if facets.next().is_some() => None,
            // The sine of the angle between nearly parallel facets; slips across both are not independent.
            [Some(a), Some(b)] if cross(&a.row, &b.row).abs() < 1e-6 => None,
            pair => Some(Self::new(pair)),
        }
    }

    /// The vector z with the normal component n and `row_a·z = d_a` for each facet a across which the contact slips. Without slip its tangential
    /// components are zero. For d = 0, z is the point x on the edge of the cone with `x_n = n`.
    pub(crate) fn reaching(&self, n: f64, d: [f64; 2]) -> SVector<f64, 3> {
        let mut z = SVector::zeros();
        for a in 0..self.count {
            z += self.across[a] * (d[a] - self.rows[a][0] * n);
        }
        z[0] = n;
        z
    }

    /// The vector Z that gives the slip across facet `a`, in energy coordinates, from the stretch u of the contact: the slip is `-Z·u`.
    pub(crate) fn slip(&self, a: usize) -> SVector<f64, 3> {
        if self.count == 1 {
            return self.rows[0];
        }
        let mut z = self.across[a];
        z[0] = -z.dot(&self.reaching(1.0, [0.0; 2]));
        z
    }

    /// The projection P that gives the contact force `x = P u` from the stretch u: it removes the part of the stretch that slip takes up.
    pub(crate) fn hold(&self) -> SMatrix<f64, 3, 3> {
        if self.count + 1 == 3 {
            // With two slips the whole tangential part is free, so the projection must remove the tangential stretch without rounding.
            let mut hold = SMatrix::<f64, 3, 3>::zeros();
            hold.set_column(0, &self.reaching(1.0, [0.0; 2]));
            return hold;
        }
        // With one slip or none, the projection removes at most one direction.
        SMatrix::identity() - tangential(&self.rows[0]) * self.rows[0].transpose()
    }
}

/// The normal axis, `(1, 0, 0)`.
pub(crate) fn normal() -> SVector<f64, 3> {
    by_axis(|axis| if axis == 0 { 1.0 } else { 0.0 })
}
