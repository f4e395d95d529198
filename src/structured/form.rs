//! The kinematic form contact by contact: the matrix M is never formed.
//!
//! In energy coordinates x = K^{-1/2}F, with K^{1/2}Gᵀ = QR, jumps z on top of the elastic trial state x⁰ give
//!
//! ```text
//! x_i = u_i + B_i z_i,   u_i = x⁰_i - Q_i y,   Σ Q_iᵀ(x_i - x⁰_i) = 0,   0 <= z ⟂ w = L x + d z₀ >= 0
//! ```
//!
//! All that couples the contacts is y, the motion of the object, with as many entries as the object has degrees of freedom. Rows and columns are those
//! of `forms/kinematic`: columns of length one, rows of length one for the gaps, and for a facet, over its tangential length,
//! (κ, c) with the column (0, c).

use nalgebra::{SMatrix, SVector};

use crate::contact::{LocalLaw, tangential_norm};
use crate::numerics::Orthogonal;
use crate::numerics::generic;
use crate::object::Problem;

/// A value of the motion of the object and of the covering variable z₀; also a direction in which they change.
#[derive(Debug, Clone, Copy)]
pub(super) struct Point<const D: usize> {
    pub(super) y: SVector<f64, D>,
    pub(super) z0: f64,
}

impl<const D: usize> Default for Point<D> {
    fn default() -> Self {
        Self { y: SVector::zeros(), z0: 0.0 }
    }
}

impl<const D: usize> Point<D> {
    pub(super) fn scaled(&self, factor: f64) -> Self {
        Self { y: self.y * factor, z0: self.z0 * factor }
    }

    pub(super) fn size(&self) -> f64 {
        (self.y.norm_squared() + self.z0 * self.z0).sqrt()
    }
}

/// A facet of a friction cone: `w = κ x_n + c·x_t`, in units of the tangential length of its row.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Facet<const C: usize> {
    /// (κ, c), c of length one.
    pub(super) row: SVector<f64, C>,
    /// One over the length of the tangential part of the row of length one.
    pub(super) unit: f64,
}

impl<const C: usize> Facet<C> {
    /// (0, c).
    pub(super) fn column(&self) -> SVector<f64, C> {
        let mut column = self.row;
        column[0] = 0.0;
        column
    }
}

/// A contact in energy coordinates.
#[derive(Debug, Clone, Copy)]
pub(super) struct Local<const D: usize, const C: usize> {
    /// Q_i, scaled so that the mean of |Q_i|² over the contacts is one.
    pub(super) seen: SMatrix<f64, C, D>,
    /// x⁰_i.
    pub(super) trial: SVector<f64, C>,
    /// Where its facets start in the list of facets. Neighbours that are alike share theirs.
    facets: u32,
    facet_count: u16,
    /// Whether pair 0 is 0 <= gap ⟂ F_n >= 0.
    pub(super) gap: bool,
    /// The number of its first pair in the whole problem.
    pub(super) first: u32,
}

impl<const D: usize, const C: usize> Local<D, C> {
    pub(super) fn pairs(&self) -> usize {
        usize::from(self.gap) + usize::from(self.facet_count)
    }

    /// u = x⁰ - Q y.
    pub(super) fn stretch(&self, y: &SVector<f64, D>) -> SVector<f64, C> {
        self.trial - self.seen * y
    }
}

/// The covering vector d.
#[derive(Debug, Clone, Default)]
pub(super) struct Covering {
    /// Entry by entry, in the units of the rows; none for ones on all rows of length one.
    pub(super) listed: Vec<f64>,
}

/// The kinematic form.
#[derive(Debug, Clone)]
pub(crate) struct ContactForm<const D: usize, const C: usize> {
    pub(super) locals: Vec<Local<D, C>>,
    facets: Vec<Facet<C>>,
    /// Pairs of all contacts.
    pub(super) pairs: usize,
    /// What the scaled `QᵀQ` is multiplied with to give the identity.
    pub(super) weight: f64,
    /// Entries of y beyond this move nothing.
    pub(super) rank: usize,
    /// The largest |Q_i|.
    pub(super) widest: f64,
    pub(super) covering: Covering,
}

impl<const D: usize, const C: usize> Default for ContactForm<D, C> {
    fn default() -> Self {
        Self {
            locals: Vec::new(),
            facets: Vec::new(),
            pairs: 0,
            weight: 1.0,
            rank: 0,
            widest: 0.0,
            covering: Covering::default(),
        }
    }
}

impl<const D: usize, const C: usize> ContactForm<D, C> {
    /// Lays out the form on the trial state in which every contact sticks, with its factor Q and x⁰, spring by spring.
    pub(crate) fn assign(&mut self, problem: &Problem<D, C>, q: &Orthogonal<D>, x: &[f64]) {
        self.locals.clear();
        self.facets.clear();
        self.pairs = 0;
        self.covering.listed.clear();
        self.rank = q.rank();
        self.weight = self.rank.max(1) as f64 / problem.len().max(1) as f64;
        let scale = 1.0 / self.weight.sqrt();
        // Room for what only some scenes need, so that no later scene of this size has to allocate.
        let most = problem.len() * problem.polygon.normals.len();
        self.facets.reserve(most);
        self.covering.listed.reserve(most + problem.len());
        let mut widest = 0.0_f64;
        let mut spring = 0;
        for (contact, law) in problem.locals().enumerate() {
            let (mut seen, mut trial) = (SMatrix::<f64, C, D>::zeros(), SVector::<f64, C>::zeros());
            if !law.is_absent() {
                for axis in 0..law.springs.axes() {
                    let row = q.row(spring);
                    for k in 0..D {
                        seen[(axis, k)] = row[k] * scale;
                    }
                    trial[axis] = x[spring];
                    spring += 1;
                }
            }
            widest = widest.max(seen.norm_squared());
            let (facets, facet_count) = self.lay_facets(problem, contact, &law);
            let local =
                Local { seen, trial, facets, facet_count, gap: law.may_open(), first: number(self.pairs) };
            self.pairs += local.pairs();
            self.locals.push(local);
        }
        self.widest = widest.sqrt();
    }

    /// The facets of a contact: those of its neighbour if both are alike.
    fn lay_facets(&mut self, problem: &Problem<D, C>, contact: usize, law: &LocalLaw<'_, C>) -> (u32, u16) {
        if let (Some(before), Some(last)) = (contact.checked_sub(1), self.locals.last()) {
            // Contacts without polygons of their own have the same one.
            if problem.turned.is_empty() && law.has_the_facets_of(&problem.local(before)) {
                return (last.facets, last.facet_count);
            }
        }
        let start = number(self.facets.len());
        let mut count = 0;
        for h in law.facets() {
            let row = facet_row(law, h);
            self.facets.push(Facet { row, unit: row.norm() });
            count += 1;
        }
        (start, count)
    }

    /// Whether the first pair of a contact is its gap.
    pub(super) fn opens(&self, contact: usize) -> bool {
        self.locals[contact].gap
    }

    pub(super) fn len(&self) -> usize {
        self.locals.len()
    }

    /// A facet by the number of its pair within the contact; `None` for the gap.
    pub(super) fn facet(&self, local: &Local<D, C>, pair: usize) -> Option<&Facet<C>> {
        if local.gap && pair == 0 {
            return None;
        }
        Some(&self.facets[local.facets as usize + pair - usize::from(local.gap)])
    }

    /// All facets of a contact.
    pub(super) fn facets(&self, local: &Local<D, C>) -> &[Facet<C>] {
        let start = local.facets as usize;
        &self.facets[start..start + usize::from(local.facet_count)]
    }

    /// The row of a pair.
    pub(super) fn row(&self, local: &Local<D, C>, pair: usize) -> SVector<f64, C> {
        self.facet(local, pair).map_or_else(normal, |facet| facet.row)
    }

    /// The column of a pair.
    pub(super) fn column(&self, local: &Local<D, C>, pair: usize) -> SVector<f64, C> {
        self.facet(local, pair).map_or_else(normal, Facet::column)
    }

    /// The entry of the covering vector for a pair, in the unit of its row.
    pub(super) fn cover(&self, local: &Local<D, C>, pair: usize, unit: f64) -> f64 {
        self.covering.listed.get(local.first as usize + pair).copied().unwrap_or(unit)
    }

    /// A fixed covering vector without structure, another for every number: entries between 1/8 and 8. Number 0 is all ones.
    pub(super) fn scatter(&mut self, attempt: usize) {
        let mut listed = std::mem::take(&mut self.covering.listed);
        listed.clear();
        if attempt > 0 {
            for local in &self.locals {
                for pair in 0..local.pairs() {
                    let unit = self.facet(local, pair).map_or(1.0, |facet| facet.unit);
                    let number = attempt * 1_000_003 + local.first as usize + pair;
                    listed.push(unit * (6.0 * (generic(number) - 1.0)).exp2());
                }
            }
        }
        self.covering.listed = listed;
    }

    /// The entry of the vector by which ties are broken for a pair, in the unit of its row.
    pub(super) fn perturbation(&self, local: &Local<D, C>, pair: usize) -> f64 {
        let unit = self.facet(local, pair).map_or(1.0, |facet| facet.unit);
        unit * generic(local.first as usize + pair)
    }
}

/// (κ, c) of a facet, `μ F_n - h·F_t = 0` in energy coordinates: c of length one.
pub(crate) fn facet_row<const C: usize>(law: &LocalLaw<'_, C>, h: &SVector<f64, C>) -> SVector<f64, C> {
    let row = law.springs.root().component_mul(&law.cone().facet_row(h));
    row / tangential_norm(&row)
}

fn normal<const C: usize>() -> SVector<f64, C> {
    let mut normal = SVector::zeros();
    normal[0] = 1.0;
    normal
}

/// Counts of pairs stay below 2^32: each takes more memory than a byte.
pub(super) fn number(count: usize) -> u32 {
    u32::try_from(count).unwrap_or(u32::MAX)
}
