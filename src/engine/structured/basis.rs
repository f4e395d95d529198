//! A complementary basis as a list of contact states.
//!
//! Symbols are those of `contact_form`. A is the set of a contact's complementary pairs (w, z) whose z is basic. Their w = 0 determines z from the
//! contact's stretch u and the covering variable z₀, contact by contact. L_A and B_A are their rows of L and columns of B, and d_A their covering
//! entries:
//!
//! ```text
//! z_A = -(Z u + ζ z₀),   Z = D⁻¹ L_A,  ζ = D⁻¹ d_A,  D = L_A B_A
//! x   = P u - k z₀,      P = 1 - B_A Z,  k = B_A ζ
//! ```
//!
//! What remains is equilibrium of the object, `T y + c₀ z₀ = b` for its motion y. The sums `T = Σ QᵀP Q`, `c₀ = Σ Qᵀk` and `b = Σ Qᵀ(P - 1) x⁰` are
//! over all contacts.

use nalgebra::{SMatrix, SVector};

use super::contact_form::{ContactForm, PairedContact};
use crate::object::{Slipping, Sums, normal};
use crate::prelude::*;

/// Indices of the right-hand sides of the object's equilibrium that stem from the elastic trial state, the covering vector, and the perturbation that
/// breaks ties.
pub(super) const TRIAL: usize = 0;
pub(super) const COVER: usize = 1;
pub(super) const PERTURBED: usize = 2;

/// The active pairs of one contact, by their numbers within the contact: those of its complementary pairs (w, z) whose z is basic.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Active {
    pairs: [u16; 3],
    len: u8,
}

impl Active {
    pub(super) const EMPTY: Self = Self { pairs: [0; 3], len: 0 };

    pub(crate) fn len(self) -> usize {
        usize::from(self.len)
    }

    pub(crate) fn iter(&self) -> impl Iterator<Item = usize> + '_ {
        self.pairs[..self.len()].iter().map(|&pair| usize::from(pair))
    }

    /// The facets among the active pairs; `gap` is whether the contact's first pair is its gap.
    pub(crate) fn facets(&self, gap: bool) -> impl Iterator<Item = u16> + '_ {
        let first = u16::from(gap);
        self.pairs[..self.len()].iter().filter_map(move |pair| pair.checked_sub(first))
    }

    #[inline]
    pub(super) fn has(self, pair: usize) -> bool {
        self.len > 0 && self.position(pair).is_some()
    }

    pub(super) fn position(self, pair: usize) -> Option<usize> {
        self.iter().position(|p| p == pair)
    }

    /// Makes another pair of the contact active. `None` if the contact already has as many active pairs as axes.
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

/// The linear response of a contact with a given set of active pairs to its stretch u and the covering variable z₀.
#[derive(Debug, Clone, Copy)]
pub(super) struct Reaction {
    /// The projection P of the force `x = P u - k z₀` of the contact in energy coordinates; u is its stretch.
    pub(super) hold: SMatrix<f64, 3, 3>,
    /// The rows of the matrix Z, one for each active pair. The gaps and slips of the active pairs are `z_A = -(Z u + ζ z₀)`.
    pub(super) multipliers: [SVector<f64, 3>; 3],
    /// The vectors ζ and k: rates at which `z_A` and `x` decrease with the covering variable z₀.
    pub(super) cover: Jumps,
    /// The same rates ζ and k for the perturbation that breaks ties.
    pub(super) tie: Jumps,
}

/// The rates at which a contact's variables decrease with the covering variable z₀, or with the perturbation that breaks ties. ζ is the rate of the
/// gaps and slips z of its active pairs, k that of its force x.
#[derive(Debug, Clone, Copy)]
pub(super) struct Jumps {
    pub(super) of_pairs: [f64; 3],
    pub(super) of_x: SVector<f64, 3>,
}

impl Reaction {
    /// The response of a contact that sticks: it has no gap and no slip.
    pub(super) fn sticking() -> Self {
        let (zero, none) = (SVector::zeros(), Jumps { of_pairs: [0.0; 3], of_x: SVector::zeros() });
        Self { hold: SMatrix::identity(), multipliers: [zero; 3], cover: none, tie: none }
    }

    /// The slack of a pair is `row·x + d z₀`, with the contact force x. Returns its coefficients for the contact's stretch u and the covering
    /// variable z₀.
    pub(super) fn feels(&self, row: &SVector<f64, 3>, d: f64) -> (SVector<f64, 3>, f64) {
        (self.hold.tr_mul(row), d - row.dot(&self.cover.of_x))
    }
}

impl ContactForm {
    /// The response of a contact with these active pairs. `None` if their slips are linearly dependent, which is only possible by rounding.
    pub(super) fn reaction(&self, local: &PairedContact, active: Active) -> Option<Reaction> {
        let (gap, facets) = (active.position(0).filter(|_| local.contact.gap), self.pairs_of(local));
        let slipping = active.iter().enumerate().filter(|(a, _)| gap != Some(*a));
        let slipping = Slipping::independent(slipping.map(|(_, pair)| &facets[pair]))?;
        let mut hold = slipping.hold();
        if gap.is_some() {
            hold.fill_column(0, 0.0);
        }
        // Position of an active pair among the active facets; `None` for the gap.
        let facet = |a: usize| match gap {
            Some(gap) if a == gap => None,
            Some(gap) if a > gap => Some(a - 1),
            _ => Some(a),
        };
        let mut multipliers = [SVector::zeros(); 3];
        for a in 0..active.len() {
            multipliers[a] = match facet(a) {
                Some(facet) if gap.is_some() => slipping.across[facet],
                Some(facet) => slipping.slip(facet),
                None => normal(),
            };
        }
        let jumps = |d: &dyn Fn(usize, f64) -> f64| {
            let (mut of_gap, mut of_facets) = (0.0, [0.0; 2]);
            for (a, pair) in active.iter().enumerate() {
                let entry = facet(a).map_or(&mut of_gap, |facet| &mut of_facets[facet]);
                *entry = d(pair, facets[pair].unit);
            }
            let of_x = slipping.reaching(of_gap, of_facets);
            let mut of_pairs = [0.0; 3];
            for a in 0..active.len() {
                of_pairs[a] = facet(a).map_or(of_gap, |facet| slipping.across[facet].dot(&of_x));
            }
            Jumps { of_pairs, of_x }
        };
        let cover = jumps(&|pair, unit| self.cover(local, pair, unit));
        let tie = jumps(&|pair, unit| local.perturbation(pair, unit));
        Some(Reaction { hold, multipliers, cover, tie })
    }

    /// Adds the terms of a contact, times `sign`, to the sums over contacts in the equilibrium of the object.
    pub(super) fn accumulate(
        &self,
        sums: &mut Sums<3>,
        contact: usize,
        jumped: Option<&Reaction>,
        sign: f64,
    ) {
        let PairedContact { contact, trial, .. } = &self.locals[contact];
        let pushed =
            jumped.map(|reaction| [reaction.hold * trial - trial, reaction.cover.of_x, reaction.tie.of_x]);
        let hold = jumped.map(|reaction| &reaction.hold);
        sums.add(&contact.seen, hold, pushed, sign * self.coordinates.weight);
    }
}

/// A complementary basis: the active pairs of every contact, and its linear response.
#[derive(Debug, Clone)]
pub(super) struct StateBasis {
    pub(super) active: Vec<Active>,
    /// Linear responses of all contacts; entries of contacts without active pairs are not valid.
    reactions: Vec<Reaction>,
    sticking: Reaction,
}

impl Default for StateBasis {
    fn default() -> Self {
        Self { active: Vec::new(), reactions: Vec::new(), sticking: Reaction::sticking() }
    }
}

impl StateBasis {
    /// Sets every contact to its elastic trial state, without active pairs.
    pub(super) fn unjump(&mut self, contacts: usize) {
        self.active.clear();
        self.active.resize(contacts, Active::EMPTY);
        if self.reactions.len() < contacts {
            self.reactions.resize(contacts, self.sticking);
        }
    }

    pub(super) fn reaction(&self, contact: usize) -> &Reaction {
        self.jumped(contact).unwrap_or(&self.sticking)
    }

    /// The linear response of a contact, if some of its pairs are active (z is basic).
    pub(super) fn jumped(&self, contact: usize) -> Option<&Reaction> {
        (self.active[contact].len() > 0).then(|| &self.reactions[contact])
    }

    /// Sets the active pairs of a contact. `None` if their slips are linearly dependent, which is only possible by rounding.
    pub(super) fn set(&mut self, form: &ContactForm, contact: usize, active: Active) -> Option<()> {
        if active.len() > 0 {
            self.reactions[contact] = form.reaction(&form.locals[contact], active)?;
        }
        self.active[contact] = active;
        Some(())
    }

    /// The sums in the equilibrium of the object, computed anew from all contacts.
    pub(super) fn sums(&self, form: &ContactForm) -> Sums<3> {
        Sums::over(form.size, form.len(), form.coordinates.rank, &|sums, contact| {
            form.accumulate(sums, contact, self.jumped(contact), 1.0);
        })
    }
}
