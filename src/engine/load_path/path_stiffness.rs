//! The tangent stiffness of the object at a point of a load path, i.e. the matrix that maps a small motion to the change of the generalised forces
//! that the contacts exert against it. Coordinates are the components of the object's twist, then the displacements of joints and of further bodies.
//! This file also has LU factors of the tangent stiffness with one more row and column (the bordered matrix). The matrices are full, or band matrices
//! if there are many coordinates.

use crate::numerics::{
    Band, Bordered, BorderedBand, Each, Size, Square, Vector, mapped, narrow_order, scale, solved_once,
    widest,
};
use alloc::sync::Arc;
use core::ops::Range;

use crate::grasp::Site;
use crate::numerics::tolerances::LINEARLY_DEPENDENT;
use crate::object::uses_band;
use crate::prelude::*;

/// An order of the coordinates in which the tangent stiffness is a narrow band: coordinates coupled by a contact are near each other.
#[derive(Debug)]
pub(super) struct NarrowOrder {
    /// The position of each coordinate in this order, from 0.
    numbers: Vec<usize>,
    /// The half bandwidth: the largest distance, in this order, of two coupled coordinates.
    half_bandwidth: usize,
}

impl NarrowOrder {
    /// The order of the coordinates in which the stiffness matrix is a narrow band. `None` with fewer than 36 coordinates, for which a full matrix is
    /// used.
    pub(super) fn of(size: Size, sites: &[Site]) -> Option<Arc<Self>> {
        if !uses_band(size) {
            return None;
        }
        let couplings: Vec<_> = mapped(sites, &|site| site.support.ranges());
        let numbers = narrow_order(size.count(), &couplings);
        let half_bandwidth = widest(&numbers, &couplings);
        Some(Arc::new(Self { numbers, half_bandwidth }))
    }
}

/// The tangent stiffness of the object at a point of a path: a full matrix, or a band matrix. The rows and columns of the band matrix are in the
/// order `order`, in which the band is narrow.
#[derive(Debug, Clone)]
pub(super) enum PathStiffness {
    Whole(Square),
    Narrow { order: Arc<NarrowOrder>, band: Band },
}

/// LU factors of the bordered matrix: the tangent stiffness with one column and one row added.
#[derive(Debug, Clone)]
pub(super) enum PathFactors {
    Whole(Bordered),
    Narrow { order: Arc<NarrowOrder>, bordered: Box<BorderedBand> },
}

impl PathStiffness {
    pub(super) fn zeros(size: Size, order: Option<Arc<NarrowOrder>>) -> Self {
        match order {
            None => Self::Whole(Square::zeros(size)),
            Some(order) => {
                let band = Band::zeros(size.count(), order.half_bandwidth);
                Self::Narrow { order, band }
            }
        }
    }

    /// Adds to the tangent stiffness a matrix with the entries `entry(row, column)`, nonzero only for coordinates in `ranges`, such as the term
    /// of one contact.
    #[inline(always)]
    pub(super) fn add(&mut self, ranges: &[Range<usize>; 2], entry: impl Fn(usize, usize) -> f64) {
        match self {
            Self::Whole(square) => {
                for j in ranges.iter().cloned().flatten() {
                    let column = square.column_slice_mut(j);
                    for rows in ranges {
                        for (i, x) in rows.clone().zip(&mut column[rows.clone()]) {
                            *x += entry(i, j);
                        }
                    }
                }
            }
            Self::Narrow { order, band } => {
                let numbers = &order.numbers;
                for j in ranges.iter().cloned().flatten() {
                    for i in ranges.iter().cloned().flatten() {
                        band.add(numbers[i], numbers[j], entry(i, j));
                    }
                }
            }
        }
    }

    pub(super) fn scale(&mut self, factor: f64) {
        let entries = match self {
            Self::Whole(square) => square.as_mut_slice(),
            Self::Narrow { band, .. } => band.entries_mut(),
        };
        scale(entries, factor);
    }

    pub(super) fn amax(&self) -> f64 {
        match self {
            Self::Whole(square) => square.amax(),
            Self::Narrow { band, .. } => band.amax(),
        }
    }

    /// Solves the bordered linear system once. Its matrix is the tangent stiffness with the column `cover`, the row `gradient` and the corner entry
    /// `corner` added. The unknowns are the twist q and the fraction λ of the leg (section of the load program) that is done. `cover`, the column of
    /// λ, is minus the rate of the load. The added row, `gradient · q + corner λ = last`, fixes how far the solution advances along the path. The
    /// right-hand side is zero, except for `last` in the added row. Returns q and λ; `None` if the matrix is nearly singular.
    pub(super) fn solved_once(
        self,
        size: Size,
        [cover, gradient]: [&Vector; 2],
        [corner, last]: [f64; 2],
    ) -> Option<(Vector, f64)> {
        fn in_place<const N: usize>(
            square: &Square,
            sides: [&Vector; 2],
            ends: [f64; 2],
        ) -> Option<(Vector, f64)> {
            let (x, pivots) = solved_once::<N>(square.as_slice(), sides, ends)?;
            (pivots > LINEARLY_DEPENDENT).then(|| (Vector::from_slice(&x[..N - 1]), x[N - 1]))
        }
        match (&self, size.count()) {
            (Self::Whole(square), 3) => in_place::<4>(square, [cover, gradient], [corner, last]),
            (Self::Whole(square), 6) => in_place::<7>(square, [cover, gradient], [corner, last]),
            _ => Some(self.bordered(size, cover, gradient, corner)?.solve(&Vector::zeros(), last)),
        }
    }

    /// LU factors of the bordered matrix: the tangent stiffness with the column `cover`, the row `gradient` and the corner entry `corner` added.
    /// `None` if this matrix is nearly singular, so that the path may continue in more than one direction.
    pub(super) fn bordered(
        self,
        size: Size,
        cover: &Vector,
        gradient: &Vector,
        corner: f64,
    ) -> Option<PathFactors> {
        let square = match self {
            Self::Whole(square) => square,
            Self::Narrow { order, band } => {
                let [column, row] = [cover, gradient].each(|v| order.in_order(v));
                if let Some(bordered) = BorderedBand::new(band.clone(), column, row, corner) {
                    return Some(PathFactors::Narrow { order, bordered: Box::new(bordered) });
                }
                // The factorisation of the bordered band matrix fails if the band matrix alone is singular, as at a maximum of the load. The bordered
                // matrix is then factorised as a full matrix.
                let mut square = Square::zeros(size);
                for (j, column) in order.numbers.iter().enumerate() {
                    for (i, row) in order.numbers.iter().enumerate() {
                        square[(i, j)] = band.entry(*row, *column);
                    }
                }
                square
            }
        };
        let bordered = Bordered::new(&square, cover, gradient, corner)?;
        // If the smallest pivot is below the fraction `LINEARLY_DEPENDENT` (1e-13) of the largest, the bordered matrix counts as singular: the path
        // may continue in more than one direction.
        (bordered.least_pivot() > LINEARLY_DEPENDENT).then_some(PathFactors::Whole(bordered))
    }
}

impl PathFactors {
    /// Solves the bordered system for the right-hand side `balance`, with `last` in the added row. Returns the twist and the unknown of the added
    /// column.
    pub(super) fn solve(&self, balance: &Vector, last: f64) -> (Vector, f64) {
        match self {
            Self::Whole(bordered) => bordered.solve(balance, last),
            Self::Narrow { order, bordered } => {
                let mut x = order.in_order(balance);
                let z = bordered.solve(&mut x, last);
                (Vector::from_fn(Size::of(x.len()), |k| x[order.numbers[k]]), z)
            }
        }
    }
}

impl NarrowOrder {
    fn in_order(&self, v: &Vector) -> Vec<f64> {
        let mut list = vec![0.0; self.numbers.len()];
        self.numbers.iter().enumerate().for_each(|(k, number)| list[*number] = v[k]);
        list
    }
}
