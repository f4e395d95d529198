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

    /// The facets among the active pairs, of a contact whose first pair is its gap or not.
    pub(crate) fn facets(&self, gap: bool) -> impl Iterator<Item = u16> + '_ {
        let first = u16::from(gap);
        self.pairs[..self.len()].iter().filter_map(move |pair| pair.checked_sub(first))
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
    /// ζ and k for the perturbation by which ties are broken.
    pub(super) tie_jumps: [f64; C],
    pub(super) tie: SVector<f64, C>,
}

impl<const C: usize> Reaction<C> {
    /// That of a contact without jumps.
    pub(super) fn rolling() -> Self {
        let zero = SVector::zeros();
        Self {
            hold: SMatrix::identity(),
            multipliers: [zero; C],
            cover_jumps: [0.0; C],
            cover: zero,
            tie_jumps: [0.0; C],
            tie: zero,
        }
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
        let mut r = Reaction::rolling();
        let (mut gap, mut facets, mut count) = (None, [0; C], 0);
        let (mut d, mut p) = ([0.0; C], [0.0; C]);
        let mut rows = [SVector::<f64, C>::zeros(); C];
        let mut columns = rows;
        let mut inverse = [[0.0; C]; C];
        for (a, pair) in active.iter().enumerate() {
            p[a] = self.perturbation(local, pair);
            if let Some(facet) = self.facet(local, pair) {
                rows[a] = facet.row;
                columns[a] = facet.column();
                d[a] = self.cover(local, pair, facet.unit);
                facets[count] = a;
                count += 1;
            } else {
                rows[a][0] = 1.0;
                columns[a][0] = 1.0;
                d[a] = self.cover(local, pair, 1.0);
                gap = Some(a);
            }
        }
        // The tangential block of D⁻¹.
        match count {
            0 => {}
            1 => inverse[facets[0]][facets[0]] = 1.0,
            2 if C == 3 => {
                let (a, b) = (facets[0], facets[1]);
                let cosine = columns[a].dot(&columns[b]);
                let determinant = 1.0 - cosine * cosine;
                if determinant < PARALLEL {
                    return None;
                }
                (inverse[a][a], inverse[b][b]) = (1.0 / determinant, 1.0 / determinant);
                (inverse[a][b], inverse[b][a]) = (-cosine / determinant, -cosine / determinant);
            }
            _ => return None,
        }
        // Z, tangential part, and what the normal force does to it.
        for &a in &facets[..count] {
            let mut slope = 0.0;
            for &b in &facets[..count] {
                r.multipliers[a] += columns[b] * inverse[a][b];
                slope += inverse[a][b] * rows[b][0];
            }
            if let Some(gap) = gap {
                inverse[a][gap] = -slope;
            } else {
                r.multipliers[a][0] = slope;
            }
        }
        if let Some(gap) = gap {
            inverse[gap][gap] = 1.0;
            r.multipliers[gap][0] = 1.0;
        }
        if count + 1 == C {
            // Every tangential direction slips: exactly nothing is left of u_t.
            r.hold = SMatrix::zeros();
            r.hold[(0, 0)] = 1.0;
            for &a in &facets[..count] {
                for axis in 1..C {
                    r.hold[(axis, 0)] -= columns[a][axis] * r.multipliers[a][0];
                }
            }
        } else {
            for &a in &facets[..count] {
                r.hold -= columns[a] * r.multipliers[a].transpose();
            }
        }
        if gap.is_some() {
            r.hold[(0, 0)] = 0.0;
        }
        for a in 0..active.len() {
            for b in 0..active.len() {
                r.cover_jumps[a] += inverse[a][b] * d[b];
                r.tie_jumps[a] += inverse[a][b] * p[b];
            }
            r.cover += columns[a] * r.cover_jumps[a];
            r.tie += columns[a] * r.tie_jumps[a];
        }
        Some(r)
    }

    /// Adds the terms of a contact, `sign` times.
    pub(super) fn accumulate(
        &self,
        sums: &mut Sums<D>,
        contact: usize,
        jumped: Option<&Reaction<C>>,
        sign: f64,
    ) {
        let local = &self.locals[contact];
        let weight = sign * self.weight;
        let Some(reaction) = jumped else {
            sums.stiffness += local.seen.tr_mul(&(local.seen * weight));
            return;
        };
        sums.stiffness += local.seen.tr_mul(&(reaction.hold * local.seen * weight));
        sums.cover += local.seen.tr_mul(&(reaction.cover * weight));
        sums.trial += local.seen.tr_mul(&((reaction.hold * local.trial - local.trial) * weight));
        sums.tie += local.seen.tr_mul(&(reaction.tie * weight));
    }
}

/// A list of contact states.
#[derive(Debug, Clone)]
pub(super) struct Basis<const C: usize> {
    pub(super) active: Vec<Active<C>>,
    /// Only those of contacts that jump mean anything.
    reactions: Vec<Reaction<C>>,
    rolling: Reaction<C>,
}

impl<const C: usize> Default for Basis<C> {
    fn default() -> Self {
        Self { active: Vec::new(), reactions: Vec::new(), rolling: Reaction::rolling() }
    }
}

impl<const C: usize> Basis<C> {
    /// Every contact as in the trial state.
    pub(super) fn unjump(&mut self, contacts: usize) {
        self.active.clear();
        self.active.resize(contacts, Active::NONE);
        if self.reactions.len() < contacts {
            self.reactions.resize(contacts, self.rolling);
        }
    }

    pub(super) fn reaction(&self, contact: usize) -> &Reaction<C> {
        if self.active[contact].len() == 0 { &self.rolling } else { &self.reactions[contact] }
    }

    /// The reaction of a contact that jumps.
    pub(super) fn jumped(&self, contact: usize) -> Option<&Reaction<C>> {
        (self.active[contact].len() > 0).then(|| &self.reactions[contact])
    }

    /// Puts a contact into a state. `None` for one that no exact basis has.
    pub(super) fn set<const D: usize>(
        &mut self,
        form: &ContactForm<D, C>,
        contact: usize,
        active: Active<C>,
    ) -> Option<()> {
        if active.len() > 0 {
            self.reactions[contact] = form.reaction(&form.locals[contact], &active)?;
        }
        self.active[contact] = active;
        Some(())
    }

    /// All sums afresh.
    pub(super) fn sums<const D: usize>(&self, form: &ContactForm<D, C>) -> Sums<D> {
        let mut sums = Sums::zero();
        for contact in 0..form.len() {
            form.accumulate(&mut sums, contact, self.jumped(contact), 1.0);
        }
        for k in form.rank..D {
            sums.stiffness[(k, k)] = 1.0;
        }
        sums
    }
}
