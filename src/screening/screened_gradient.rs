//! The derivatives of onsets, as they are read.

use super::first_slip::SlipCode;
use super::gradient_row::GradientRow;
use super::screened::Screened;
use crate::prelude::*;

/// The derivatives of many factors, in the order of the answers that they belong to: rows of numbers, whose memory is used again.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct ScreenedGradients<const C: usize> {
    pub(super) contacts: usize,
    pub(super) numbers: Vec<f64>,
}

impl<const C: usize> ScreenedGradients<C> {
    /// None yet, without memory.
    #[must_use]
    pub fn new() -> Self {
        Self { contacts: 0, numbers: Vec::new() }
    }

    /// How many there are.
    #[must_use]
    pub fn len(&self) -> usize {
        self.numbers.len() / GradientRow::<C>::numbers(self.contacts)
    }

    /// How many numbers a gradient of so many contacts has.
    #[must_use]
    pub const fn width(contacts: usize) -> usize {
        GradientRow::<C>::numbers(contacts)
    }

    /// Whether there are none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.numbers.is_empty()
    }

    /// Those in a place; `None` from [`Self::len`] on.
    #[must_use]
    pub fn get(&self, place: usize) -> Option<ScreenedGradient<'_, C>> {
        let numbers = GradientRow::<C>::numbers(self.contacts);
        let row = self.numbers.get(place.checked_mul(numbers)?..)?.get(..numbers)?;
        Some(ScreenedGradient { contacts: self.contacts, row })
    }

    /// All of them.
    pub fn iter(&self) -> impl Iterator<Item = ScreenedGradient<'_, C>> {
        let contacts = self.contacts;
        let rows = self.numbers.chunks_exact(GradientRow::<C>::numbers(contacts));
        rows.map(move |row| ScreenedGradient { contacts, row })
    }

    /// All numbers, row by row, [`Self::width`] each. Of n contacts a row has 4 numbers of its own, then n points, n normals, n commands, n pairs of
    /// stiffnesses, n coefficients of friction, and the components of the base load, as [`ScreenedGradient`] has them.
    #[must_use]
    pub fn numbers(&self) -> &[f64] {
        &self.numbers
    }

    /// The same numbers, to be kept.
    #[must_use]
    pub fn into_numbers(self) -> Vec<f64> {
        self.numbers
    }
}

/// The derivatives of the factor (without unit) at which one grasp begins to slide, all at once: by a datum they say how the factor
/// changes where nothing else does. Not numbers where screening has no factor.
///
/// Where [`Self::is_one_sided`] says so, several contacts leave together, or one leaves through the apex of its cone: the least of
/// their factors has a kink. Derivatives are then those of [`Self::contact`]; [`Fingers::onset_gradients`](crate::screening::Fingers::onset_gradients)
/// has those of each, and along a change of the data the derivative is the least of theirs.
///
/// Where a motion of the object is free those by points, normals and loads are no numbers, for with other data there may be no equilibrium: so of two
/// hard fingers in space. [`Sensitivity::onset_gradients_by_geometry`](crate::ask::Sensitivity::onset_gradients_by_geometry) tells them apart.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ScreenedGradient<'a, const C: usize> {
    contacts: usize,
    row: &'a [f64],
}

impl<const C: usize> ScreenedGradient<'_, C> {
    /// The answer itself, with the bits of [`Fingers::onset`](crate::screening::Fingers::onset): the factor, and who leaves there.
    #[must_use]
    pub fn screened(&self) -> Screened {
        Screened(SlipCode {
            code: self.row[GradientRow::<C>::CODE],
            leaving: self.row[GradientRow::<C>::LEAVING],
        })
    }

    /// The contact whose margin vanishes, from 0: the event that is active. `None` without a factor.
    #[must_use]
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // it is a small whole number
    pub fn contact(&self) -> Option<usize> {
        let contact = self.row[GradientRow::<C>::CONTACT];
        (contact >= 0.0).then_some(contact as usize)
    }

    /// Whether the factor has a kink here: several events are active.
    #[must_use]
    pub fn is_one_sided(&self) -> bool {
        self.row[GradientRow::<C>::KINK] > 0.0
    }

    /// By the position of a contact along the coordinate axes, 1/m; its normal stays.
    ///
    /// # Panics
    /// As for all of a contact, if there is no such contact.
    #[must_use]
    pub fn point(&self, contact: usize) -> [f64; C] {
        self.vector(GradientRow::<C>::POINT, contact)
    }

    /// By the normal of a contact along the coordinate axes, 1/rad: across the normal, for it stays as long as it is. The contact frame tilts with
    /// it, without a turn about it, and commands, clearance and springs stay along its axes.
    #[must_use]
    pub fn normal(&self, contact: usize) -> [f64; C] {
        self.vector(GradientRow::<C>::normal(self.contacts), contact)
    }

    /// By the command of a contact along the coordinate axes, 1/m.
    #[must_use]
    pub fn command(&self, contact: usize) -> [f64; C] {
        self.vector(GradientRow::<C>::command(self.contacts), contact)
    }

    /// By the series stiffness of a contact, normal and tangential, m/N: both tangents together. Commands stay, and with them a stiffer finger
    /// presses more. Zero for a spring that is not there.
    #[must_use]
    pub fn stiffness(&self, contact: usize) -> [f64; 2] {
        let of = GradientRow::<C>::stiffness(self.contacts)..GradientRow::<C>::friction(self.contacts);
        let pair = &self.row[of][2 * contact..][..2];
        [pair[0], pair[1]]
    }

    /// By the coefficient of friction of a contact: zero for all but the one that slides.
    #[must_use]
    pub fn friction(&self, contact: usize) -> f64 {
        self.row[GradientRow::<C>::friction(self.contacts)..GradientRow::<C>::load(self.contacts)][contact]
    }

    /// By the components of the base load, 1/N and 1/(N m), moments about the origin. Those by the direction are the factor times these.
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
