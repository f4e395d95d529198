//! Contacts in energy coordinates: the maps from the motion of the object to each contact, and the slips across their facets.
//!
//! ```text
//! x = K^{-1/2}F,   K^{1/2}Gᵀ = QR,   u = x⁰ - Q y,   x = P u
//! ```
//!
//! x⁰ is the elastic trial state in which every contact sticks, and y the further motion of the object. P is the projection by the contact's state. A
//! facet is `κ x_n + c·x_t >= 0` with c of length one; slip across it moves x along (0, c). Consecutive equal contacts share their facets.

use nalgebra::{SMatrix, SVector};

use super::problem::Problem;
use crate::contact::{LocalLaw, cross, tangential, tangential_norm};
use crate::numerics::{Each, Orthogonal, ScaledMap, by_axis};
use crate::prelude::*;

/// A facet of a friction cone, scaled so that the tangential part c of its row has length one. The condition `x_n >= 0` of a contact that may open is
/// the facet (1, 0).
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Facet {
    /// The row (κ, c), with c of length one.
    pub(crate) row: SVector<f64, 3>,
    /// Length of `row`. Entries of covering or perturbation vectors for the row scaled to length one, times this length, are those for `row`.
    pub(crate) unit: f64,
}

impl Facet {
    /// The facet `μ F_n - h·F_t = 0`; `root` holds the square roots of the stiffnesses.
    fn new(law: &LocalLaw<'_>, root: &SVector<f64, 3>, h: &SVector<f64, 3>) -> Self {
        let row = root.component_mul(&law.cone().facet_row(h));
        let row = row / tangential_norm(&row);
        Self { row, unit: row.norm() }
    }

    /// The column (0, c): the change of x by slip across this facet.
    pub(crate) fn column(&self) -> SVector<f64, 3> {
        tangential(&self.row)
    }
}

/// A contact in energy coordinates, in which forces are divided by the square roots of stiffnesses.
#[derive(Debug, Clone)]
pub(crate) struct EnergyContact {
    /// Q_i, the map from the motion y of the object to x of the contact, scaled so that the mean of |Q_i|² over the contacts is one.
    pub(crate) seen: ScaledMap,
    /// Index in the common list of facets: `x_n >= 0` of a contact that may open, then its facets.
    first: u32,
    pub(crate) facet_count: u16,
    /// Whether the contact may open.
    pub(crate) gap: bool,
}

impl EnergyContact {
    /// Number of conditions of the contact: one for its gap, and one for each facet.
    pub(crate) fn pairs(&self) -> usize {
        usize::from(self.gap) + usize::from(self.facet_count)
    }
}

/// Data that all contacts of a problem share in energy coordinates: the list of facets, and the scale of the maps.
#[derive(Debug, Clone, Default)]
pub(crate) struct EnergyCoordinates {
    facets: Vec<Facet>,
    /// The factor by which the sum of `Q_iᵀQ_i` with the scaled maps must be multiplied to be the identity.
    pub(crate) weight: f64,
    /// Rank of Q: components of y from this index on move no contact.
    pub(crate) rank: usize,
}

impl EnergyCoordinates {
    /// Computes the energy coordinates of all contacts from the orthogonal factor of their springs, and calls `visit` for each contact in order.
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

    /// The conditions of a contact: `x_n >= 0` if it may open, then its facets.
    #[inline]
    pub(crate) fn pairs(&self, contact: &EnergyContact) -> &[Facet] {
        let first = contact.first as usize;
        &self.facets[first..first + contact.pairs()]
    }
}

/// A closed contact that slips across none, one or two of its facets, at most one in the plane.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Slipping {
    rows: [SVector<f64, 3>; 2],
    /// Dual basis of the facets' tangents c: `z_a·c_b` is 1 for a = b, else 0.
    pub(crate) across: [SVector<f64, 3>; 2],
    pub(crate) count: usize,
}

impl Slipping {
    /// Slips across one facet or two neighbouring ones, or none.
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

    /// Slips across given facets; `None` for more than two, or for nearly parallel ones.
    pub(crate) fn independent<'f>(mut facets: impl Iterator<Item = &'f Facet>) -> Option<Self> {
        let pair = [facets.next(), facets.next()];
        match pair {
            _ if facets.next().is_some() => None,
            // The sine of the angle between nearly parallel facets; slips across both are not independent.
            [Some(a), Some(b)] if cross(&a.row, &b.row).abs() < 1e-6 => None,
            pair => Some(Self::new(pair)),
        }
    }

    /// The vector z with `z_n = n` and `row_a·z = d_a` on the facets across which the contact slips. For d = 0, z is the point x on the edge of the
    /// cone with `x_n = n`.
    pub(crate) fn reaching(&self, n: f64, d: [f64; 2]) -> SVector<f64, 3> {
        let mut z = SVector::zeros();
        for a in 0..self.count {
            z += self.across[a] * (d[a] - self.rows[a][0] * n);
        }
        z[0] = n;
        z
    }

    /// The row Z_a that gives the slip across facet a, `-Z_a·u`, from the stretch u.
    pub(crate) fn slip(&self, a: usize) -> SVector<f64, 3> {
        if self.count == 1 {
            return self.rows[0];
        }
        let mut z = self.across[a];
        z[0] = -z.dot(&self.reaching(1.0, [0.0; 2]));
        z
    }

    /// The projection P of this state, with `x = P u`: it removes the stretch that slip takes up.
    pub(crate) fn hold(&self) -> SMatrix<f64, 3, 3> {
        if self.count + 1 == 3 {
            // With two slips the whole tangential part is free, so the projection must remove u_t without rounding.
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
