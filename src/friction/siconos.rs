//! Reading the files of Siconos: dimension, number of contacts, matrices in [one of three forms](super::siconos_matrix), vectors and μ.

use super::error::Error;
use super::problem::{FrictionProblem, PlanarContacts, SpatialContacts};
use super::siconos_matrix::{Tokens, matrix};
use crate::numerics::matrix_of;
use crate::prelude::*;
use nalgebra::{DMatrix, DVector};

/// A problem read from a file, which states the number of components of its contacts.
#[derive(Debug, Clone, PartialEq)]
pub enum ReadProblem {
    /// Contacts in the plane.
    Planar(PlanarContacts),
    /// Contacts in space.
    Spatial(SpatialContacts),
}

impl ReadProblem {
    /// The problem in a file of Siconos (`FrictionContactProblem`), from its own tests or written by it. Text after μ is not read.
    ///
    /// ```
    /// use grasp_lcp::friction::ReadProblem;
    ///
    /// // One contact in space, W dense.
    /// let text = "3 1  0 3 3 3 3  2 0 0  0 2 0  0 0 2  -1 0.3 0  0.5";
    /// let ReadProblem::Spatial(problem) = ReadProblem::from_siconos(text)? else { panic!("three components") };
    /// let outcome = problem.solve();
    /// assert_eq!(outcome.solution().expect("it sticks").r.as_slice(), [0.5, -0.15, 0.0]);
    /// # Ok::<(), grasp_lcp::friction::Error>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`Error::Word`] for a word of another kind than must be there, and the errors of [`FrictionProblem::new`].
    pub fn from_siconos(text: &str) -> Result<Self, Error> {
        Self::read(text, local, local)
    }

    /// The problem in a file of Siconos that includes the bodies (`GlobalFrictionContactProblem`): M v = H r + f and u = Hᵀ v + b, so that
    /// W = Hᵀ M⁻¹ H and q = Hᵀ M⁻¹ f + b.
    ///
    /// ```
    /// use grasp_lcp::friction::ReadProblem;
    ///
    /// // A body of half a kilogram at one contact.
    /// let body = "3 1  0 3 3 3 3  .5 0 0  0 .5 0  0 0 .5   0 3 3 3 3  1 0 0  0 1 0  0 0 1";
    /// let read = ReadProblem::from_siconos_global(&format!("{body}  -0.5 0.15 0  0 0 0  0.5"))?;
    /// assert_eq!(read, ReadProblem::from_siconos("3 1  0 3 3 3 3  2 0 0  0 2 0  0 0 2  -1 0.3 0  0.5")?);
    /// # Ok::<(), grasp_lcp::friction::Error>(())
    /// ```
    ///
    /// # Errors
    ///
    /// The errors of [`Self::from_siconos`], and [`Error::Masses`] if M has no inverse.
    pub fn from_siconos_global(text: &str) -> Result<Self, Error> {
        Self::read(text, global, global)
    }

    fn read(
        text: &str,
        planar: impl FnOnce(&mut Tokens<'_>) -> Result<PlanarContacts, Error>,
        spatial: impl FnOnce(&mut Tokens<'_>) -> Result<SpatialContacts, Error>,
    ) -> Result<Self, Error> {
        let words = &mut Tokens::of(text);
        let allowed = "a number of components, 2 or 3";
        let components: usize = words.number(allowed)?;
        match components {
            2 => planar(words).map(Self::Planar),
            3 => spatial(words).map(Self::Spatial),
            _ => Err(words.wrong(components.to_string(), allowed)),
        }
    }
}

fn local<const C: usize>(words: &mut Tokens<'_>) -> Result<FrictionProblem<C>, Error> {
    let n: usize = words.number("a number of contacts")?;
    let size = n.saturating_mul(C);
    let w = matrix(words, Some(size), Some(size))?;
    let q = DVector::from_vec(words.entries(size, "an entry of q")?);
    FrictionProblem::new(w, q, words.entries(n, "the friction of a contact")?)
}

fn global<const C: usize>(words: &mut Tokens<'_>) -> Result<FrictionProblem<C>, Error> {
    let n: usize = words.number("a number of contacts")?;
    let size = n.saturating_mul(C);
    let masses = matrix(words, None, None)?;
    let h = matrix(words, Some(masses.nrows()), Some(size))?;
    let f = DVector::from_vec(words.entries(masses.nrows(), "an entry of f")?);
    let b = DVector::from_vec(words.entries(size, "an entry of b")?);
    let mu = words.entries(n, "the friction of a contact")?;
    if masses.nrows() != masses.ncols() {
        return Err(Error::Masses);
    }
    let (moved, free) = moved_by(masses, &h, &f).ok_or(Error::Masses)?;
    FrictionProblem::new(h.tr_mul(&moved), h.tr_mul(&free) + b, mu)
}

/// M⁻¹ H and M⁻¹ f. The mass matrix of rigid bodies is usually diagonal, which is fast.
fn moved_by(
    masses: DMatrix<f64>,
    h: &DMatrix<f64>,
    f: &DVector<f64>,
) -> Option<(DMatrix<f64>, DVector<f64>)> {
    let inverse = masses.diagonal().map(|mass| 1.0 / mass);
    let count = |m: &DMatrix<f64>| m.iter().filter(|x| **x != 0.0).count();
    if count(&masses) == inverse.len() && inverse.iter().all(|x| x.is_finite()) {
        let moved = matrix_of(h.nrows(), h.ncols(), &|i, j| inverse[i] * h[(i, j)]);
        return Some((moved, f.component_mul(&inverse)));
    }
    let factors = masses.lu();
    Some((factors.solve(h)?, factors.solve(f)?))
}
