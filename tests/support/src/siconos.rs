//! Reading the files of Siconos: dimension, number of contacts, matrices in one of three forms, vectors and μ.

use crate::siconos_matrix::{Tokens, matrix};
use grasp_lcp::friction::{self, FrictionProblem, PlanarContacts, SpatialContacts};
use nalgebra::{DMatrix, DVector};

/// Why a file could not be read.
#[derive(Debug, Clone, PartialEq)]
pub enum Error {
    /// A word of a file is not of the required kind.
    Word {
        /// The position of the word in the file, counted from 1.
        at: usize,
        /// The word; `None` at the end of the file.
        word: Option<String>,
        /// The required kind of word.
        allowed: &'static str,
    },
    /// The mass matrix of a file has no inverse.
    Masses,
    /// The numbers do not describe a frictional contact problem.
    Numbers(friction::Error),
}

impl From<friction::Error> for Error {
    fn from(error: friction::Error) -> Self {
        Self::Numbers(error)
    }
}

impl std::error::Error for Error {}

impl std::fmt::Display for Error {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Word { at, word, allowed } => {
                let named =
                    word.as_ref().map_or("missing".to_owned(), |word| format!("`{}`", word.escape_default()));
                write!(f, "word {at} of the file is {named}, but must be {allowed}")
            }
            Self::Masses => write!(f, "M is not square or singular, but must have an inverse"),
            Self::Numbers(error) => error.fmt(f),
        }
    }
}

/// A problem read from a file, which determines the number of components of its contacts.
#[derive(Debug, Clone, PartialEq)]
pub enum ReadProblem {
    /// Contacts in the plane.
    Planar(PlanarContacts),
    /// Contacts in space.
    Spatial(SpatialContacts),
}

impl ReadProblem {
    /// Reads a problem from a file of Siconos (`FrictionContactProblem`), one of its tests or written by it. Text after μ is ignored.
    ///
    /// # Errors
    ///
    /// [`Error::Word`] for a word that is not of the required kind, and the errors of [`FrictionProblem::new`].
    pub fn from_siconos(text: &str) -> Result<Self, Error> {
        Self::read(text, local, local)
    }

    /// Reads a problem from a file of Siconos that contains the bodies (`GlobalFrictionContactProblem`): M v = H r + f and u = Hᵀ v + b. Hence
    /// W = Hᵀ M⁻¹ H and q = Hᵀ M⁻¹ f + b.
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
    Ok(FrictionProblem::new(w, q, words.entries(n, "the friction of a contact")?)?)
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
    Ok(FrictionProblem::new(h.tr_mul(&moved), h.tr_mul(&free) + b, mu)?)
}

/// M⁻¹ H and M⁻¹ f. The mass matrix of rigid bodies is usually diagonal, for which no factorisation is needed.
fn moved_by(
    masses: DMatrix<f64>,
    h: &DMatrix<f64>,
    f: &DVector<f64>,
) -> Option<(DMatrix<f64>, DVector<f64>)> {
    let inverse = masses.diagonal().map(|mass| 1.0 / mass);
    let count = |m: &DMatrix<f64>| m.iter().filter(|x| **x != 0.0).count();
    if count(&masses) == inverse.len() && inverse.iter().all(|x| x.is_finite()) {
        let moved = DMatrix::from_fn(h.nrows(), h.ncols(), |i, j| inverse[i] * h[(i, j)]);
        return Some((moved, f.component_mul(&inverse)));
    }
    let factors = masses.lu();
    Some((factors.solve(h)?, factors.solve(f)?))
}
