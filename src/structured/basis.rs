//! A complementary basis as a list of contact states.
//!
//! The pairs A of a contact whose z is basic have w = 0, which determines their z from u and z₀ locally:
//!
//! ```text
//! z_A = -(Z u + ζ z₀),   Z = D⁻¹ L_A,  ζ = D⁻¹ d_A,  D = L_A B_A
//! x   = P u - k z₀,      P = 1 - B_A Z,  k = B_A ζ
//! ```
//!
//! and leaves d equations for the motion of the object, sums over the contacts of which a pivot changes one or two terms:
//!
//! ```text
//! T y + c₀ z₀ = b,   T = Σ QᵀP Q,  c₀ = Σ Qᵀk,  b = Σ Qᵀ(P - 1) x⁰
//! ```

use nalgebra::{SMatrix, SVector};

use super::form::{ContactForm, Local};

/// Facets whose normals are parallel to this leave no independent slips.
const PARALLEL: f64 = 1e-12;

/// The pairs of one contact whose z is basic, by their numbers within the contact.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Active<const C: usize> {
    pairs: [u16; C],
    len: u8,
}

impl<const C: usize> Active<C> {
    pub(super) const NONE: Self = Self { pairs: [0; C], len: 0 };

    pub(crate) fn len(&self) -> usize {
        usize::from(self.len)
    }

    pub(crate) fn iter(&self) -> impl Iterator<Item = usize> + '_ {
        self.pairs[..self.len()].iter().map(|&pair| usize::from(pair))
    }

    pub(super) fn position(&self, pair: usize) -> Option<usize> {
        self.iter().position(|p| p == pair)
    }

    /// `None` if the contact has as many already as it has axes.
    pub(super) fn with(mut self, pair: usize) -> Option<Self> {
        let at = self.len();
        *self.pairs.get_mut(at)? = u16::try_from(pair).ok()?;
        self.len += 1;
        Some(self)
    }

    pub(super) fn without(mut self, pair: usize) -> Self {
        if let Some(at) = self.position(pair) {
            let last = self.len() - 1;
            self.pairs[at] = self.pairs[last];
            self.len -= 1;
        }
        self
    }
}

/// How a contact in a given state answers u and z₀.
#[derive(Debug, Clone, Copy)]
pub(super) struct Reaction<const C: usize> {
    /// P.
    pub(super) hold: SMatrix<f64, C, C>,
    /// Rows of Z.
    pub(super) multipliers: [SVector<f64, C>; C],
    /// ζ.
    pub(super) cover_jumps: [f64; C],
    /// k.
    pub(super) cover: SVector<f64, C>,
    /// D⁻¹.
    inverse: [[f64; C]; C],
    columns: [SVector<f64, C>; C],
    len: usize,
}

impl<const C: usize> Reaction<C> {
    /// D⁻¹ d for a vector over the active pairs, and B_A of it.
    pub(super) fn to(&self, d: &[f64; C]) -> ([f64; C], SVector<f64, C>) {
        let (mut jumps, mut total) = ([0.0; C], SVector::zeros());
        for a in 0..self.len {
            jumps[a] = (0..self.len).map(|b| self.inverse[a][b] * d[b]).sum();
            total += self.columns[a] * jumps[a];
        }
        (jumps, total)
    }
}

/// The sums over the contacts.
#[derive(Debug, Clone, Copy)]
pub(super) struct Sums<const D: usize> {
    pub(super) stiffness: SMatrix<f64, D, D>,
    pub(super) cover: SVector<f64, D>,
    pub(super) trial: SVector<f64, D>,
    /// The same as `cover` for the perturbation by which ties are broken.
    pub(super) tie: SVector<f64, D>,
}

impl<const D: usize> Sums<D> {
    pub(super) fn zero() -> Self {
        let zero = SVector::zeros();
        Self { stiffness: SMatrix::zeros(), cover: zero, trial: zero, tie: zero }
    }
}

impl<const D: usize, const C: usize> ContactForm<D, C> {
    /// `None` where the slips of the active pairs are not independent: no exact basis has such a state.
    pub(super) fn reaction(&self, local: &Local<D, C>, active: &Active<C>) -> Option<Reaction<C>> {
        let mut r = Reaction {
            hold: SMatrix::identity(),
            multipliers: [SVector::zeros(); C],
            cover_jumps: [0.0; C],
            cover: SVector::zeros(),
            inverse: [[0.0; C]; C],
            columns: [SVector::zeros(); C],
            len: active.len(),
        };
        if active.len() == 0 {
            return Some(r);
        }
        let (mut gap, mut facets, mut count) = (None, [0; C], 0);
        let mut d = [0.0; C];
        let mut rows = [SVector::<f64, C>::zeros(); C];
        for (a, pair) in active.iter().enumerate() {
            if let Some(facet) = self.facet(local, pair) {
                rows[a] = facet.row;
                r.columns[a] = facet.column();
                d[a] = self.cover(local, pair, facet.unit);
                facets[count] = a;
                count += 1;
            } else {
                rows[a][0] = 1.0;
                r.columns[a][0] = 1.0;
                d[a] = self.cover(local, pair, 1.0);
                gap = Some(a);
            }
        }
        // The tangential block of D⁻¹.
        match count {
            0 => {}
            1 => r.inverse[facets[0]][facets[0]] = 1.0,
            2 if C == 3 => {
                let (a, b) = (facets[0], facets[1]);
                let cosine = r.columns[a].dot(&r.columns[b]);
                let determinant = 1.0 - cosine * cosine;
                if determinant < PARALLEL {
                    return None;
                }
                (r.inverse[a][a], r.inverse[b][b]) = (1.0 / determinant, 1.0 / determinant);
                (r.inverse[a][b], r.inverse[b][a]) = (-cosine / determinant, -cosine / determinant);
            }
            _ => return None,
        }
        // Z, tangential part, and what the normal force does to it.
        for &a in &facets[..count] {
            let mut slope = 0.0;
            for &b in &facets[..count] {
                r.multipliers[a] += r.columns[b] * r.inverse[a][b];
                slope += r.inverse[a][b] * rows[b][0];
            }
            if let Some(gap) = gap {
                r.inverse[a][gap] = -slope;
            } else {
                r.multipliers[a][0] = slope;
            }
        }
        if let Some(gap) = gap {
            r.inverse[gap][gap] = 1.0;
            r.multipliers[gap][0] = 1.0;
        }
        if count + 1 == C {
            // Every tangential direction slips: exactly nothing is left of u_t.
            r.hold = SMatrix::zeros();
            r.hold[(0, 0)] = 1.0;
            for &a in &facets[..count] {
                for axis in 1..C {
                    r.hold[(axis, 0)] -= r.columns[a][axis] * r.multipliers[a][0];
                }
            }
        } else {
            for &a in &facets[..count] {
                r.hold -= r.columns[a] * r.multipliers[a].transpose();
            }
        }
        if gap.is_some() {
            r.hold[(0, 0)] = 0.0;
        }
        (r.cover_jumps, r.cover) = r.to(&d);
        Some(r)
    }

    /// What the perturbation by which ties are broken adds to z_A and takes from x: D⁻¹p and B_A D⁻¹p.
    pub(super) fn tie(
        &self,
        local: &Local<D, C>,
        active: &Active<C>,
        reaction: &Reaction<C>,
    ) -> ([f64; C], SVector<f64, C>) {
        let mut p = [0.0; C];
        for (a, pair) in active.iter().enumerate() {
            p[a] = self.perturbation(local, pair);
        }
        reaction.to(&p)
    }

    /// Adds the terms of a contact, `sign` times. `None` for a state without reaction.
    pub(super) fn accumulate(
        &self,
        sums: &mut Sums<D>,
        contact: usize,
        active: &Active<C>,
        sign: f64,
    ) -> Option<()> {
        let local = &self.locals[contact];
        let weight = sign * self.weight;
        if active.len() == 0 {
            sums.stiffness += local.seen.tr_mul(&(local.seen * weight));
            return Some(());
        }
        let reaction = self.reaction(local, active)?;
        let (_, tie) = self.tie(local, active, &reaction);
        sums.stiffness += local.seen.tr_mul(&(reaction.hold * local.seen * weight));
        sums.cover += local.seen.tr_mul(&(reaction.cover * weight));
        sums.trial += local.seen.tr_mul(&((reaction.hold * local.trial - local.trial) * weight));
        sums.tie += local.seen.tr_mul(&(tie * weight));
        Some(())
    }

    /// All sums afresh.
    pub(super) fn sums(&self, active: &[Active<C>]) -> Option<Sums<D>> {
        let mut sums = Sums::zero();
        for (contact, active) in active.iter().enumerate() {
            self.accumulate(&mut sums, contact, active, 1.0)?;
        }
        for k in self.rank..D {
            sums.stiffness[(k, k)] = 1.0;
        }
        Some(sums)
    }
}
