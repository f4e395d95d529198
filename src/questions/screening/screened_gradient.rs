//! Access to the derivatives of load factors of first slip, as screening computes them for many grasps at once. A gradient belongs to one grasp under
//! one load. It consists of the load factor at which the first contact ceases to stick, and its derivatives with respect to all data. At this factor
//! the margin of that contact, `μ F_n - |F_t|`, vanishes. The base load acts at load factor 0.

use super::first_slip::SlipCode;
use super::gradient_row::GradientRow;
use super::screened::Screened;
use crate::prelude::*;

/// Derivatives of many load factors of first slip, ordered as the load factors themselves: one row of numbers for each. The storage can be reused.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct ScreenedGradients<const C: usize> {
    pub(super) contacts: usize,
    pub(super) numbers: Vec<f64>,
}

impl<const C: usize> ScreenedGradients<C> {
    /// An empty list, without allocated storage.
    #[must_use]
    pub fn new() -> Self {
        Self { contacts: 0, numbers: Vec::new() }
    }

    /// The number of gradients, one for each load factor.
    #[must_use]
    pub fn len(&self) -> usize {
        self.numbers.len() / GradientRow::<C>::numbers(self.contacts)
    }

    /// The number of entries of a gradient for a grasp with `contacts` contacts.
    #[must_use]
    pub const fn width(contacts: usize) -> usize {
        GradientRow::<C>::numbers(contacts)
    }

    /// Whether there are no gradients.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.numbers.is_empty()
    }

    /// The gradient at an index; `None` for an index from [`Self::len`] on.
    #[must_use]
    pub fn get(&self, place: usize) -> Option<ScreenedGradient<'_, C>> {
        let numbers = GradientRow::<C>::numbers(self.contacts);
        let row = self.numbers.get(place.checked_mul(numbers)?..)?.get(..numbers)?;
        Some(ScreenedGradient { contacts: self.contacts, row })
    }

    /// All gradients, one for each grasp and load, in the order of the load factors from screening.
    pub fn iter(&self) -> impl Iterator<Item = ScreenedGradient<'_, C>> {
        let contacts = self.contacts;
        let rows = self.numbers.chunks_exact(GradientRow::<C>::numbers(contacts));
        rows.map(move |row| ScreenedGradient { contacts, row })
    }

    /// All numbers, row by row, [`Self::width`] in each row. A row for n contacts begins with 4 numbers. The first is the load factor of first slip,
    /// or a negative code if screening has no load factor. The second is the sum of 2^i over the contacts i that cease to stick. The third is the
    /// index, from 0, of the contact whose margin is differentiated. The fourth is positive if the load factor has a kink at these data, so that
    /// derivatives are one-sided, else zero. The derivatives follow: with respect to n points, n normals, n commands, n pairs of stiffnesses, n
    /// coefficients of friction, and the components of the base load. [`ScreenedGradient`] returns each of them.
    #[must_use]
    pub fn numbers(&self) -> &[f64] {
        &self.numbers
    }

    /// All numbers in the order of [`Self::numbers`], row by row, without a copy.
    #[must_use]
    pub fn into_numbers(self) -> Vec<f64> {
        self.numbers
    }
}

/// The derivatives of the load factor of first slip of one grasp with respect to each of its data, while all other data stay fixed. They are NaN if
/// screening has no load factor.
///
/// If [`Self::is_one_sided`] is true, several contacts cease to stick together, or a contact force leaves its cone through the apex. The least of the
/// contacts' load factors then has a kink. The derivatives given here are then derivatives of the load factor at which the margin of
/// [`Self::contact`] vanishes. [`Fingers::onset_gradients`](crate::screening::Fingers::onset_gradients) has the derivatives for each of these
/// contacts. For a given change of the data, the derivative of the load factor of first slip is the least of the derivatives that belong to these
/// contacts.
///
/// If no spring resists some motion of the object, derivatives with respect to points, normals and loads are NaN, because no equilibrium may exist
/// after a change of these data. Two hard fingers in space are such a grasp. [`OnsetMargins::by`](crate::load_path::OnsetMargins::by) has derivatives
/// for such grasps, too.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ScreenedGradient<'a, const C: usize> {
    contacts: usize,
    row: &'a [f64],
}

impl<const C: usize> ScreenedGradient<'_, C> {
    /// The answer of screening, equal bit for bit to the answer of [`Fingers::onset`](crate::screening::Fingers::onset): the load factor, and the
    /// contacts that leave their cones at this factor.
    #[must_use]
    pub fn screened(&self) -> Screened {
        Screened(SlipCode {
            code: self.row[GradientRow::<C>::CODE],
            leaving: self.row[GradientRow::<C>::LEAVING],
        })
    }

    /// The index, from 0, of the contact that ceases to stick first. If several contacts cease to stick together, it is the contact for whose margin
    /// the derivatives are given. `None` if screening has no load factor.
    #[must_use]
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // it is a small whole number
    pub fn contact(&self) -> Option<usize> {
        let contact = self.row[GradientRow::<C>::CONTACT];
        (contact >= 0.0).then_some(contact as usize)
    }

    /// Whether the load factor of first slip has a kink at these data, so that derivatives are one-sided.
    #[must_use]
    pub fn is_one_sided(&self) -> bool {
        self.row[GradientRow::<C>::KINK] > 0.0
    }

    /// Derivative with respect to the position of a contact along the coordinate axes, 1/m, while its normal stays the same.
    ///
    /// # Panics
    /// If there is no such contact; the same holds for all derivatives with respect to data of a contact.
    #[must_use]
    pub fn point(&self, contact: usize) -> [f64; C] {
        self.vector(GradientRow::<C>::POINTS, contact)
    }

    /// Derivative with respect to the unit normal of a contact, along the coordinate axes, 1/rad. This vector is perpendicular to the normal, whose
    /// length is fixed. The contact frame tilts with the normal, without a turn about it. Commands, clearance and springs stay along the axes of the
    /// frame.
    #[must_use]
    pub fn normal(&self, contact: usize) -> [f64; C] {
        self.vector(GradientRow::<C>::normal(self.contacts), contact)
    }

    /// Derivative of the load factor with respect to the command of a contact along the coordinate axes, 1/m.
    #[must_use]
    pub fn command(&self, contact: usize) -> [f64; C] {
        self.vector(GradientRow::<C>::command(self.contacts), contact)
    }

    /// Derivatives with respect to the series stiffness of a contact, normal and tangential, m/N; the tangential derivative is for a change along
    /// both tangents together. Commands stay the same, so that a stiffer finger presses more. Zero for a spring that does not exist.
    #[must_use]
    pub fn stiffness(&self, contact: usize) -> [f64; 2] {
        let of = GradientRow::<C>::stiffness(self.contacts)..GradientRow::<C>::friction(self.contacts);
        let pair = &self.row[of][2 * contact..][..2];
        [pair[0], pair[1]]
    }

    /// Derivative with respect to the coefficient of friction of a contact. It is zero for every contact but [`Self::contact`], and for that contact,
    /// too, if it only opens.
    #[must_use]
    pub fn friction(&self, contact: usize) -> f64 {
        self.row[GradientRow::<C>::friction(self.contacts)..GradientRow::<C>::load(self.contacts)][contact]
    }

    /// Derivatives of the load factor with respect to the components of the base load, 1/N and 1/(N m), moments about the origin. Multiplied by the
    /// load factor, they are the derivatives with respect to the load direction.
    #[must_use]
    pub fn base_load(&self) -> &[f64] {
        &self.row[GradientRow::<C>::load(self.contacts)..]
    }

    fn vector(&self, field: usize, contact: usize) -> [f64; C] {
        let mut vector = [0.0; C];
        vector.copy_from_slice(&self.row[field..field + C * self.contacts][C * contact..][..C]);
        vector
    }
}
