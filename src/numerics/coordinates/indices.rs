//! One index per coordinate.

use super::size::WHOLE;
use crate::numerics::IntoList;
use crate::prelude::*;

/// One index per coordinate, for example a permutation; up to six are stored in place.
#[derive(Debug, Clone)]
pub(crate) enum Indices {
    Few(usize, [usize; WHOLE]),
    More(Vec<usize>),
}

impl Indices {
    pub(super) fn in_order(count: usize) -> Self {
        if count <= WHOLE {
            Self::Few(count, core::array::from_fn(|k| k))
        } else {
            Self::More((0..count).list())
        }
    }
}

impl AsRef<[usize]> for Indices {
    #[inline]
    fn as_ref(&self) -> &[usize] {
        match self {
            Self::Few(count, few) => &few[..(*count).min(WHOLE)],
            Self::More(more) => more,
        }
    }
}

impl AsMut<[usize]> for Indices {
    #[inline]
    fn as_mut(&mut self) -> &mut [usize] {
        match self {
            Self::Few(count, few) => &mut few[..(*count).min(WHOLE)],
            Self::More(more) => more,
        }
    }
}
