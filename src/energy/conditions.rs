//! The optimality conditions of the paper's program on orthogonal factors, and their solution.
//!
//! Let everything stick: x⁰ = K^{1/2}(a - Gᵀq⁰) with equilibrium, K^{1/2}Gᵀ = QR. In these coordinates, with Π = QQᵀ, the
//! scaled gaps ĝ = √k_n g (columns E) and the friction rows N x >= 0 (unit length), the program is
//!
//! ```text
//! minimise ½|p|² - pᵀQᵀE ĝ + ½|ĝ|² + x⁰ᵀE ĝ      x = x⁰ - Q p + E ĝ,   p = R (q - q⁰)
//! subject to ĝ >= 0, N x >= 0
//! ```
//!
//! and its optimality conditions, p eliminated, are a linear complementarity problem with a positive semidefinite matrix:
//!
//! ```text
//! 0 <= ĝ  ⟂  Eᵀx⁰ + Eᵀ(1 - Π)E ĝ - Eᵀ(1 - Π)Nᵀλ >= 0
//! 0 <= λ  ⟂   N x⁰ +  N(1 - Π)E ĝ +       N Π Nᵀλ >= 0
//! x = x⁰ + (1 - Π) E ĝ + Π Nᵀλ
//! ```
//!
//! Multipliers enter the forces through Π: they push the **object**, as if a hand from outside helped. What they add to the
//! balance of forces is `Aᵀx + W = AᵀNᵀλ`; the minimum is an equilibrium exactly if that is zero. Slips of Coulomb's law enter
//! through 1 - Π and keep the balance.
//!
//! Lemke's method says which gaps open and which rows bind. The answer is then computed from the springs that hold,
//! which does not depend on the rounding of the pivots, and every condition is checked.

use nalgebra::{DMatrix, DVector, SVector};

use super::cone_rows::{FrictionRow, cone_rows};
use super::springs::{Rest, Springs};
use crate::Settings;
use crate::contact::PolygonCone;
use crate::grasp::{Hold, Site};
use crate::lcp::{self, Basis, Lcp, Outcome};
use crate::object::largest_force;

/// A friction row is on its edge, and a condition is satisfied, up to this part of the forces it compares: a hundred times
/// what rounding leaves in scenes with stiffness ratios of 1e14.
pub(super) const ROUNDING: f64 = 1e-12;

/// Gaps that may open, rows that may bind, and the factor of the springs when all of them hold.
pub(super) struct Program<'g, const D: usize, const C: usize> {
    pub(super) sites: &'g [Site<D, C>],
    pub(super) gaps: Vec<usize>,
    pub(super) rows: Vec<FrictionRow<C>>,
    pub(super) stuck: Springs<D, C>,
    /// Place of the first spring of each contact.
    first: Vec<usize>,
}

/// Which gaps are open and which rows bind.
#[derive(Debug, Clone)]
pub(super) struct Faces {
    pub(super) open: Vec<bool>,
    pub(super) binding: Vec<usize>,
}

/// A point of the program.
#[derive(Debug, Clone)]
pub(super) struct Point<const D: usize, const C: usize> {
    pub(super) forces: Vec<SVector<f64, C>>,
    pub(super) twist: SVector<f64, D>,
    pub(super) gaps: Vec<f64>,
    /// Of every row, for rows of unit length.
    pub(super) multipliers: Vec<f64>,
    pub(super) free: Vec<SVector<f64, D>>,
}

impl<const D: usize, const C: usize> Point<D, C> {
    /// Size of the largest force of the scene, never below the noise of no force at all.
    pub(super) fn largest_force(
        &self,
        sites: &[Site<D, C>],
        drives: &[SVector<f64, C>],
        wrench: &SVector<f64, D>,
    ) -> f64 {
        largest_force(sites, drives, &self.twist, wrench.norm(), self.forces.iter().map(SVector::norm))
    }
}

pub(super) enum Failure {
    NoMinimum,
    Unsolved,
}

impl<'g, const D: usize, const C: usize> Program<'g, D, C> {
    pub(super) fn new(sites: &'g [Site<D, C>], cone: &PolygonCone) -> Self {
        let may_open = |site: &Site<D, C>| site.hold == Hold::Unilateral && !site.friction.is_infinite();
        let mut first = Vec::new();
        let mut count = 0;
        for site in sites {
            first.push(count);
            count += site.springs.axes();
        }
        Self {
            sites,
            gaps: (0..sites.len()).filter(|i| may_open(&sites[*i])).collect(),
            rows: cone_rows(sites, cone, |site| site.friction.is_infinite()),
            stuck: Springs::along_axes(sites, |_, _| true),
            first,
        }
    }

    /// The vector of the complementarity problem for a state of the springs when everything sticks.
    pub(super) fn vector(&self, stuck: &Rest<D>) -> DVector<f64> {
        let gaps = self.gaps.iter().map(|&i| stuck.x[self.first[i]]);
        let rows = self.rows.iter().map(|row| {
            let start = self.first[row.contact];
            (0..self.sites[row.contact].springs.axes())
                .map(|a| row.normal[a] * stuck.x[start + a])
                .sum::<f64>()
        });
        DVector::from_vec(gaps.chain(rows).collect())
    }

    /// Its matrix.
    pub(super) fn matrix(&self) -> DMatrix<f64> {
        let e = self.gaps.len();
        let seen = self.seen();
        DMatrix::from_fn(e + self.rows.len(), e + self.rows.len(), |i, j| {
            let together = seen[i].dot(&seen[j]);
            let same = |gap: usize, row: usize| {
                let row = &self.rows[row - e];
                if row.contact == self.gaps[gap] { row.normal[0] } else { 0.0 }
            };
            match (i < e, j < e) {
                (true, true) => f64::from(u8::from(i == j)) - together,
                (true, false) => together - same(i, j),
                (false, true) => same(j, i) - together,
                (false, false) => together,
            }
        })
    }

    /// Qᵀ times the columns of E and Nᵀ.
    fn seen(&self) -> Vec<SVector<f64, D>> {
        let factor = &self.stuck.factor;
        let gaps = self.gaps.iter().map(|&i| *factor.row(self.first[i]));
        let rows = self.rows.iter().map(|row| {
            let start = self.first[row.contact];
            (0..self.sites[row.contact].springs.axes())
                .fold(SVector::zeros(), |sum, a| sum + factor.row(start + a) * row.normal[a])
        });
        gaps.chain(rows).collect()
    }

    /// Which gaps open and which rows bind, by Lemke's method; and the twist as it follows from the pivots.
    pub(super) fn faces(
        &self,
        stuck: &Rest<D>,
        settings: &Settings,
    ) -> Result<(Faces, usize, SVector<f64, D>), Failure> {
        let q = self.vector(stuck);
        let lcp = Lcp::new(self.matrix(), q).map_err(|_| Failure::Unsolved)?;
        let lcp_settings =
            lcp::Settings { max_pivots: settings.max_pivots, enumerate_up_to: 0, ..lcp::Settings::default() };
        match lcp.solve_with(&lcp_settings) {
            Outcome::Solved(solution) => {
                let e = self.gaps.len();
                let travelled = self.seen().iter().zip(solution.z.iter()).enumerate().fold(
                    stuck.travelled,
                    |sum, (i, (seen, z))| if i < e { sum + seen * *z } else { sum - seen * *z },
                );
                Ok((self.faces_of(&solution.basis), solution.pivots, self.stuck.twist(&travelled)))
            }
            Outcome::Ray(ray) if matches!(ray.proof, lcp::Proof::Infeasible(_)) => Err(Failure::NoMinimum),
            _ => Err(Failure::Unsolved),
        }
    }

    pub(super) fn faces_of(&self, basis: &Basis) -> Faces {
        let e = self.gaps.len();
        let mut open = vec![false; self.sites.len()];
        for (place, &contact) in self.gaps.iter().enumerate() {
            open[contact] = basis.contains(place);
        }
        Faces { open, binding: (0..self.rows.len()).filter(|row| basis.contains(e + row)).collect() }
    }

    /// The minimum on these faces. Springs of open gaps are taken out: there x_n is free, and the binding rows alone give
    /// it a value, `x_n = (Nᵀλ)_n`. With M = [N Q, N_n of the open] on the binding rows,
    ///
    /// ```text
    /// N x' + M Mᵀλ = 0,     x = x' + Q (first part of Mᵀλ)
    /// ```
    ///
    /// solved on the orthogonal factor of Mᵀ. `None` if the binding rows depend on each other.
    pub(super) fn on_faces(
        &self,
        faces: &Faces,
        drives: &[SVector<f64, C>],
        wrench: &SVector<f64, D>,
        near: &SVector<f64, D>,
    ) -> Option<Point<D, C>> {
        let springs = Springs::along_axes(self.sites, |i, axis| axis > 0 || !faces.open[i]);
        let opened: Vec<usize> = (0..self.sites.len()).filter(|i| faces.open[*i]).collect();
        let Rest { mut x, mut travelled } = springs.rest(drives, wrench);
        let mut pulled = vec![0.0; opened.len()];
        let mut multipliers = vec![0.0; self.rows.len()];
        let list = &springs.list;
        let axis_of = |s: usize| list[s].along.iamax();
        let springs_of = |row: &FrictionRow<C>| {
            let contact = row.contact;
            (0..list.len()).filter(move |s| list[*s].contact == contact)
        };
        if !faces.binding.is_empty() {
            let columns = faces.binding.iter().map(|&r| {
                let row = &self.rows[r];
                let mut column = DVector::zeros(D + opened.len());
                for s in springs_of(row) {
                    for k in 0..D {
                        column[k] += springs.factor.row(s)[k] * row.normal[axis_of(s)];
                    }
                }
                if let Some(place) = opened.iter().position(|i| *i == row.contact) {
                    column[D + place] = row.normal[0];
                }
                column
            });
            let columns: Vec<DVector<f64>> = columns.collect();
            if columns.len() > D + opened.len() {
                return None;
            }
            let factor = DMatrix::from_columns(&columns).qr();
            let (q, r) = (factor.q(), factor.r());
            // DoubleDouble: the second time removes what rounding left of the rows.
            for _ in 0..2 {
                let left = faces.binding.iter().map(|&index| {
                    let row = &self.rows[index];
                    let closed: f64 = springs_of(row).map(|s| row.normal[axis_of(s)] * x[s]).sum();
                    let free = opened.iter().position(|i| *i == row.contact);
                    -(closed + free.map_or(0.0, |place| row.normal[0] * pulled[place]))
                });
                let y = r.tr_solve_upper_triangular(&DVector::from_vec(left.collect()))?;
                let lambda = r.solve_upper_triangular(&y)?;
                let change = &q * y;
                let moved = SVector::<f64, D>::from_fn(|k, _| change[k]);
                springs.factor.subtract(&mut x, &-moved);
                travelled -= moved;
                for (place, x) in pulled.iter_mut().enumerate() {
                    *x += change[D + place];
                }
                for (&row, value) in faces.binding.iter().zip(lambda.iter()) {
                    multipliers[row] += value;
                }
            }
        }
        let mut forces = springs.forces(&x, self.sites.len());
        for (&i, x) in opened.iter().zip(&pulled) {
            forces[i][0] = self.sites[i].springs.root_along(0) * x;
        }
        let mut twist = springs.twist(&travelled);
        let gaps_at = |twist: &SVector<f64, D>| -> Vec<f64> {
            let mut gaps = vec![0.0; self.sites.len()];
            for &i in &opened {
                let site = &self.sites[i];
                gaps[i] = site.springs.give_along(0, forces[i][0]) - site.stretch(&drives[i], twist)[0];
            }
            gaps
        };
        let mut gaps = gaps_at(&twist);
        if gaps.iter().any(|gap| *gap < 0.0) {
            // Motions that stretch no spring still open and close gaps; the pivots found some that close none.
            for v in &springs.free {
                twist += v * v.dot(near);
            }
            gaps = gaps_at(&twist);
        }
        if forces.iter().any(|f| f.iter().any(|x| !x.is_finite())) {
            return None;
        }
        Some(Point { forces, twist, gaps, multipliers, free: springs.free })
    }

    /// Whether a point satisfies every condition of the minimum up to rounding.
    pub(super) fn holds(
        &self,
        point: &Point<D, C>,
        faces: &Faces,
        drives: &[SVector<f64, C>],
        wrench: &SVector<f64, D>,
    ) -> bool {
        let most = point.largest_force(self.sites, drives, wrench);
        let rows = self.rows.iter().all(|row| {
            let site = &self.sites[row.contact];
            row.value(site, &point.forces[row.contact]) >= -ROUNDING * most * row.weight
        });
        // Multipliers of rows of unit length have the unit of x = K^{-1/2} F.
        let scaled = |(site, f): (&Site<D, C>, &SVector<f64, C>)| {
            let part = |a: usize| f[a].abs() / site.springs.root_along(a);
            (0..site.springs.axes()).map(part).fold(0.0, f64::max)
        };
        let x_size = self.sites.iter().zip(&point.forces).map(scaled).fold(0.0, f64::max);
        let largest = point.multipliers.iter().fold(x_size, |most, l| most.max(l.abs()));
        let multipliers = point.multipliers.iter().all(|l| *l >= -ROUNDING * largest);
        let gaps = self.gaps.iter().all(|&i| {
            let site = &self.sites[i];
            let give = site.springs.give_along(0, point.forces[i][0]);
            let span = site.span(&drives[i], &point.twist) + give;
            // The multiplier of the gap, √k_n (x - Nᵀλ)_n.
            let pressed: f64 = self
                .rows
                .iter()
                .zip(&point.multipliers)
                .filter(|(row, _)| row.contact == i)
                .map(|(row, l)| row.in_springs(site)[0] * l)
                .sum();
            let size = most.max(pressed.abs());
            point.gaps[i] >= -ROUNDING * span
                && (faces.open[i] || point.forces[i][0] - pressed >= -ROUNDING * size)
        });
        rows && multipliers && gaps
    }
}
