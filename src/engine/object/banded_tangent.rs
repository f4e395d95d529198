//! Solves the linear problem of a grasp with known contact states (open, sticking or sliding) and at least 36 coordinates in its twist q. Every
//! contact couples only a few of them. Contact i has the grasp map G_i and the tangent stiffness C_i. Row r of the matrix A has the stretches of
//! spring r per unit of each coordinate, times the square root of the spring's stiffness (scaled stretches). Row r of B is the direction in which
//! this spring pushes, with the same factor. x are the scaled spring forces, i.e. forces divided by the root of the stiffness, while the object does
//! not move. Under the load W the object moves by q, and they become x - A q, with the tangent stiffness T:
//!
//! ```text
//! T = BᵀA = Σ G_i C_i G_iᵀ,      T q = Bᵀx + W,      x - A q
//! ```
//!
//! T has an entry for every two coordinates that a contact couples; a suitable order puts these entries near its diagonal. LU factors of T take a few
//! thousandths of the time of orthogonal factors of A and B. But they lose twice as many digits if stiffnesses differ widely. Iterative refinement in
//! twice the working precision restores the digits, or shows that it cannot.

use crate::numerics::{
    Band, BandFactors, IntoList, Reals, Size, Vector, dot, generic, mapped, moved, narrow_order, numbered,
    scale_each, summed, widest,
};

use core::ops::Range;

use nalgebra::SVector;

use crate::contact::Spring;
use crate::grasp::{Site, size_of};
use crate::prelude::*;

/// Whether the tangent stiffness is factorised as a band matrix, which is done from 36 coordinates on.
pub(crate) fn uses_band(coordinates: Size) -> bool {
    // With fewer coordinates orthogonal factors take less time (for four bodies in space a third less), and they determine the rank.
    coordinates.count() >= 36
}

/// The tangent stiffness `T = BᵀA` as a band matrix, with its LU factors. A has the stretches of springs per unit of each coordinate, B the
/// directions in which springs push.
#[derive(Debug, Clone)]
pub(crate) struct BandedTangent {
    /// Position of each coordinate in an order in which T is a narrow band.
    pub(super) numbers: Vec<usize>,
    pub(super) springs: SpringLists,
    /// The matrix A of the tangent stiffness `BᵀA`: the scaled stretch of each spring per unit of each coordinate.
    pub(super) stretches: SpringRows,
    /// The matrix B of the tangent stiffness `BᵀA`: the directions in which springs push. `None` if no contact slides, since then B = A.
    pub(super) pushes: Option<SpringRows>,
    pub(super) factors: BandFactors,
}

/// For each contact: its springs, and the coordinates of the twist that stretch them, i.e. those with nonzero entries in its grasp map.
#[derive(Debug, Clone)]
pub(super) struct SpringLists {
    /// For each contact in turn, the coordinates with entries in its grasp map. Each is given by its position in the order in which the stiffness
    /// matrix is a narrow band.
    coordinates: Vec<usize>,
    /// For each contact the index of its first entry in `coordinates`; the last number is the length of `coordinates`.
    first: Vec<usize>,
    /// For each contact the number of its springs. It depends on the contact's state: an open contact has none.
    pub(super) counts: Vec<usize>,
    /// For each contact the index of its first number in [`SpringRows::rows`]; the last entry is the length of that list.
    first_rows: Vec<usize>,
}

/// One factor of the tangent stiffness `BᵀA`: the matrix A or B, with a row for each spring.
#[derive(Debug, Clone)]
pub(super) struct SpringRows {
    /// The entries of each row of the matrix, spring after spring, in the order of [`SpringLists`]: one for each coordinate in the contact's grasp
    /// map.
    rows: Vec<f64>,
    /// For each coordinate, in the order in which the stiffness matrix is a narrow band, the factor that scales its column to length one. The
    /// factor of a zero column is one.
    units: Vec<f64>,
    /// Euclidean length of the longest row: the largest scaled stretch of a spring under a unit motion.
    pub(super) longest: f64,
}

impl BandedTangent {
    /// The factorised tangent stiffness of these contacts and their springs. `first_springs` holds the index of the first spring of each contact and,
    /// last, the number of springs. `None` with fewer than 36 coordinates ([`uses_band`]), or if a pivot is not finite.
    pub(super) fn new(sites: &[Site], springs: &[Spring], first_springs: &[usize]) -> Option<Self> {
        let count = size_of(sites).count();
        if !uses_band(size_of(sites)) {
            return None;
        }
        let couplings: Vec<_> = mapped(sites, &|site| site.support.ranges());
        let numbers = narrow_order(count, &couplings);
        let half_bandwidth = widest(&numbers, &couplings);
        let mut lists =
            SpringLists { coordinates: Vec::new(), first: vec![0], counts: Vec::new(), first_rows: vec![0] };
        let mut rows = 0;
        for (ranges, ends) in couplings.iter().zip(first_springs.windows(2)) {
            let (coordinates, count) = (lists.coordinates.len(), ends[1] - ends[0]);
            for range in ranges {
                lists.coordinates.extend_from_slice(&numbers[range.clone()]);
            }
            lists.first.push(lists.coordinates.len());
            lists.counts.push(count);
            rows += count * (lists.coordinates.len() - coordinates);
            lists.first_rows.push(rows);
        }
        let side = |of: fn(&Spring) -> &SVector<f64, 3>| {
            let mut rows = Vec::new();
            for ((site, ranges), ends) in sites.iter().zip(&couplings).zip(first_springs.windows(2)) {
                for spring in &springs[ends[0]..ends[1]] {
                    for range in ranges {
                        range.clone().map(|k| site.map.row(k).dot(of(spring))).append_to(&mut rows);
                    }
                }
            }
            lists.side(rows, count)
        };
        let stretches = side(|spring| &spring.stretch_direction);
        let straight = springs.iter().all(|spring| spring.push_direction == spring.stretch_direction);
        let pushes = (!straight).then(|| side(|spring| &spring.push_direction));
        let (mut band, push_rows) =
            (Band::zeros(count, half_bandwidth), pushes.as_ref().unwrap_or(&stretches));
        lists.for_each(|_, coordinates, range| {
            for (j, a) in coordinates.iter().zip(&stretches.rows[range.clone()]).filter(|(_, a)| **a != 0.0) {
                let a = a * stretches.units[*j];
                let pushed = coordinates.iter().zip(&push_rows.rows[range.clone()]);
                pushed.for_each(|(i, b)| band.add(*i, *j, a * b * push_rows.units[*i]));
            }
        });
        let factors = band.factors()?;
        Some(Self { numbers, springs: lists, stretches, pushes, factors })
    }

    /// Moves the object until forces balance the load W = `wrench`. The spring forces x become `x - A q`, with the returned twist
    /// `q = T⁻¹ (Bᵀx + W)`, the tangent stiffness T and its factors A and B.
    pub(super) fn respond(&self, x: &mut [f64], wrench: &Vector) -> Vector {
        let mut q = vec![0.0; self.numbers.len()];
        wrench.iter().zip(&self.numbers).for_each(|(w, k)| q[*k] = *w);
        self.springs.add(self.pushes.as_ref().unwrap_or(&self.stretches), x, &mut q);
        self.factors.solve(&mut q);
        self.springs.stretch(&self.stretches, &mut q, &mut |spring, stretch| x[spring] -= stretch);
        Vector::from_fn(Size::of(q.len()), |k| q[self.numbers[k]])
    }

    /// Whether the tangent stiffness is singular up to rounding, so that [`Self::loose_motions`] is not empty.
    pub(super) fn is_singular(&self) -> bool {
        self.factors.is_singular()
    }

    /// Null vectors of the tangent stiffness, as motions of all coordinates in their usual order; not orthonormal.
    pub(super) fn loose_motions(&self) -> Vec<Vector> {
        let motion = |q: Vec<f64>| {
            let entry = |k: usize| q[self.numbers[k]] * self.stretches.units[self.numbers[k]];
            Vector::from_fn(Size::of(q.len()), entry)
        };
        moved(self.factors.null_vectors(), &motion)
    }

    /// The twist `q = T⁻¹W` under the load W at zero offsets (commands minus clearances and slips) of all contacts, with the tangent stiffness T.
    pub(super) fn solve(&self, load: &Vector) -> Vector {
        self.respond(&mut vec![0.0; self.springs.counts.iter().sum()], load)
    }

    /// Displacements of the coordinates if the springs of a contact push with the scaled `forces` and no other load acts. The displacements are in
    /// the order of the coordinates in which the stiffness matrix is a narrow band.
    pub(super) fn displacements_under(&self, contact: usize, forces: &[f64]) -> Vec<f64> {
        let pushes = self.pushes.as_ref().unwrap_or(&self.stretches);
        let mut q = vec![0.0; self.numbers.len()];
        self.springs.of(contact, |k, coordinates, range| {
            add_row(&mut q, coordinates, &pushes.rows[range], forces[k]);
        });
        scale_each(&mut q, &pushes.units);
        self.factors.solve(&mut q);
        scale_each(&mut q, &self.stretches.units);
        q
    }

    /// The sum of the scaled stretches of a contact's springs, each times its entry of `times`. The stretches are those under the displacements
    /// `displacements` of the coordinates, which are in the order in which the stiffness matrix is a narrow band.
    pub(super) fn weighted_stretch(&self, contact: usize, times: &[f64], displacements: &[f64]) -> f64 {
        let mut sum = 0.0;
        self.springs.of(contact, |k, coordinates, range| {
            sum += times[k] * row_times(coordinates, &self.stretches.rows[range], displacements);
        });
        sum
    }

    /// Factor by which relative rounding errors grow in a solution. It is the norm of the oblique projection `A T⁻¹ Bᵀ` of spring forces. A is the
    /// matrix of stretches, B that of push directions, and T = BᵀA the tangent stiffness. Four steps of the power method estimate the norm, and the
    /// estimate is doubled. The result is exactly 1 if no contact slides.
    pub(super) fn growth(&self) -> f64 {
        let Some(pushes) = &self.pushes else { return 1.0 };
        let springs: usize = self.springs.counts.iter().sum();
        let mut x: Vec<f64> = numbered(springs, &generic);
        let length = |x: &[f64]| summed(x, &|x| x * x).sqrt();
        let mut growth = 1.0_f64;
        let mut q = vec![0.0; self.numbers.len()];
        // Each step of the power method estimates the norm of the oblique projection A T⁻¹Bᵀ from below.
        for _ in 0..4 {
            let before = length(&x);
            q.fill(0.0);
            self.springs.add(pushes, &x, &mut q);
            self.factors.solve(&mut q);
            self.springs.stretch(&self.stretches, &mut q, &mut |spring, stretch| x[spring] = stretch);
            let after = length(&x);
            growth = growth.max(after / before);
            q.fill(0.0);
            self.springs.add(&self.stretches, &x, &mut q);
            self.factors.solve_transposed(&mut q);
            self.springs.stretch(pushes, &mut q, &mut |spring, stretch| x[spring] = stretch / after);
        }
        // Twice the estimate, since the power method gives a lower bound.
        2.0 * growth
    }

    /// The rows of the matrix A and, if a contact slides, of the matrix B. Each row has an entry for each coordinate in its usual order.
    pub(super) fn rows(&self) -> [Option<Vec<Vector>>; 2] {
        let whole = |side: &SpringRows| {
            let mut list = Vec::new();
            self.springs.for_each(|_, coordinates, range| {
                let mut whole = vec![0.0; self.numbers.len()];
                coordinates.iter().zip(&side.rows[range]).for_each(|(k, x)| whole[*k] = *x);
                list.push(Vector::from_fn(Size::of(whole.len()), |k| whole[self.numbers[k]]));
            });
            list
        };
        [Some(whole(&self.stretches)), self.pushes.as_ref().map(whole)]
    }
}

impl SpringLists {
    /// Calls `visit(spring, coordinates, range)` for every spring. `range` is the index range of the spring's row in [`SpringRows::rows`].
    /// `coordinates` has the position of each entry of this row in the order in which the stiffness matrix is a narrow band.
    fn for_each(&self, mut visit: impl FnMut(usize, &[usize], Range<usize>)) {
        let (mut spring, mut from) = (0, 0);
        for (ends, count) in self.first.windows(2).zip(&self.counts) {
            let coordinates = &self.coordinates[ends[0]..ends[1]];
            for _ in 0..*count {
                visit(spring, coordinates, from..from + coordinates.len());
                (spring, from) = (spring + 1, from + coordinates.len());
            }
        }
    }

    /// Calls `visit(k, coordinates, range)` for the springs k = 0, 1, … of one contact. `range` is the index range of the spring's row in
    /// [`SpringRows::rows`]. `coordinates` has the position of each entry of this row in the order in which the stiffness matrix is a narrow band.
    fn of(&self, contact: usize, mut visit: impl FnMut(usize, &[usize], Range<usize>)) {
        let coordinates = &self.coordinates[self.first[contact]..self.first[contact + 1]];
        for k in 0..self.counts[contact] {
            let from = self.first_rows[contact] + k * coordinates.len();
            visit(k, coordinates, from..from + coordinates.len());
        }
    }

    /// Stores the matrix A (spring stretches per unit motion) or B (push directions), given the entries of its rows, spring after spring. `count` is
    /// the number of coordinates.
    fn side(&self, rows: Vec<f64>, count: usize) -> SpringRows {
        let (mut squares, mut longest) = (vec![0.0; count], 0.0_f64);
        self.for_each(|_, coordinates, range| {
            let row = &rows[range];
            coordinates.iter().zip(row).for_each(|(k, x)| squares[*k] += x * x);
            longest = longest.max(dot(row, row));
        });
        let unit = |square: f64| if square > 0.0 { 1.0 / square.sqrt() } else { 1.0 };
        SpringRows { rows, units: moved(squares, &unit), longest: longest.sqrt() }
    }

    /// Adds to q the wrench of the scaled spring forces x: Aᵀx or Bᵀx, with the matrix A or B in `side`. Then multiplies each entry of q by the
    /// factor that scales its column of the matrix to length one.
    pub(super) fn add(&self, side: &SpringRows, x: &[f64], q: &mut [f64]) {
        self.for_each(|spring, coordinates, range| {
            add_row(q, coordinates, &side.rows[range], x[spring]);
        });
        scale_each(q, &side.units);
    }

    /// Multiplies each entry of the motion q by the factor that scales its column of the matrix A or B in `side` to length one. Then calls
    /// `visit(spring, stretch)` for every spring with its scaled stretch, an entry of A q or B q.
    pub(super) fn stretch(&self, side: &SpringRows, q: &mut [f64], visit: &mut dyn FnMut(usize, f64)) {
        scale_each(q, &side.units);
        self.for_each(|spring, coordinates, range| {
            visit(spring, row_times(coordinates, &side.rows[range], q));
        });
    }
}

/// The product of a row of the matrix A or B with q. `coordinates` has the position in q of each entry of the row.
fn row_times(coordinates: &[usize], row: &[f64], q: &[f64]) -> f64 {
    coordinates.iter().zip(row).map(|(k, a)| a * q[*k]).added()
}

/// Adds a row of the matrix A or B, multiplied by `times`, to q. `coordinates` has the position in q of each entry of the row.
fn add_row(q: &mut [f64], coordinates: &[usize], row: &[f64], times: f64) {
    for (k, a) in coordinates.iter().zip(row) {
        q[*k] += a * times;
    }
}
