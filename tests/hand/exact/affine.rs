//! Affine functions of the unknowns in rationals, and the elimination that solves systems of them.

use num_rational::BigRational;
use num_traits::{FromPrimitive, Zero};
use support::elimination::Eliminated;

pub(super) type Q = BigRational;

pub(super) fn exact(x: f64) -> Q {
    Q::from_f64(x).expect("finite")
}

/// The affine function `row · (q, φ) + constant` of the object's twist q and the joint displacements φ.
#[derive(Clone)]
pub(super) struct Affine {
    pub(super) row: Vec<Q>,
    pub(super) constant: Q,
}

impl Affine {
    pub(super) fn zero(n: usize) -> Self {
        Self { row: vec![Q::zero(); n], constant: Q::zero() }
    }

    pub(super) fn constant(n: usize, constant: Q) -> Self {
        Self { constant, ..Self::zero(n) }
    }

    pub(super) fn plus(mut self, other: &Self, factor: &Q) -> Self {
        for (a, b) in self.row.iter_mut().zip(&other.row) {
            *a += b * factor;
        }
        self.constant += &other.constant * factor;
        self
    }

    pub(super) fn times(&self, factor: &Q) -> Self {
        Self::zero(self.row.len()).plus(self, factor)
    }

    pub(super) fn at(&self, x: &[Q]) -> Q {
        self.row.iter().zip(x).fold(self.constant.clone(), |sum, (a, x)| sum + a * x)
    }
}

/// The solutions of a system of equations `row · x + constant = 0`.
pub(super) enum Solved {
    Point(Vec<Q>),
    Nothing,
    Family,
}

pub(super) fn solved(rows: &[Affine], n: usize) -> Solved {
    let row = |of: &Affine| of.row.iter().cloned().chain([-of.constant.clone()]).collect();
    let eliminated = Eliminated::of(rows.iter().map(row), n);
    match eliminated.solution() {
        Some(point) => Solved::Point(point),
        None if eliminated.is_free() => Solved::Family,
        None => Solved::Nothing,
    }
}

pub(super) fn float(x: &Q) -> f64 {
    num_traits::ToPrimitive::to_f64(x).unwrap_or(f64::NAN)
}
