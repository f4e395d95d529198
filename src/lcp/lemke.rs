//! Lemke's method. The augmented problem w = q + M z + d z₀, with a covering vector d and a covering variable z₀, has a path of points with w_i z_i =
//! 0 for all i. The path is followed from z = 0 with large z₀ until z₀ = 0. The next entering variable is always the complement of the variable that
//! left last (Cottle, Pang & Stone, algorithm 4.4.5).
//!
//! A dictionary is the condensed tableau of one basis. A basis is infeasible if some basic variable is negative. Noise is a value that rounding alone
//! may have produced.

use super::dictionary::{LemkeVariable, largest};
use super::outcome::BreakdownCause;
use super::path::LemkePath;
use super::ratio::{Covering, blocking_row, doubtful_row_breaks, most_violated_row};
use super::settings::Settings;
use super::tolerances::{DOUBTFUL_PIVOT, DRIFTED, ZERO_VALUE};
use crate::numerics::tolerances::FEW_ROUNDINGS;

/// The ways in which a path of Lemke's method ends.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum LemkeEnd {
    /// The covering variable z₀ has left the basis, which is thus complementary.
    Complementary,
    /// The entering variable, given here, grows without bound; `u` of the dictionary holds its column.
    Ray(LemkeVariable),
    PivotLimit,
    Breakdown(BreakdownCause),
}

impl LemkePath {
    /// Lets the covering variable z₀, whose column is in the dictionary, enter an infeasible basis. Then follows Lemke's path until z₀ leaves
    /// again or the path ends otherwise, and returns its end. A basis without negative values is `Complementary` at once.
    pub(super) fn cover_and_run(&mut self, m: &[f64], settings: &Settings, limit: usize) -> LemkeEnd {
        let row = match most_violated_row(&self.dictionary, settings) {
            Ok(Some(row)) => row,
            Ok(None) => return LemkeEnd::Complementary,
            Err(row) => {
                let value = settings.covering.as_ref().and_then(|d| d.get(row)).copied().unwrap_or(0.0);
                return LemkeEnd::Breakdown(BreakdownCause::CoveringEntry { row, value });
            }
        };
        if self.pivots >= limit {
            return LemkeEnd::PivotLimit;
        }
        let leaving = self.pivot(LemkeVariable::Covering, row, m);
        self.run(leaving.complement(), m, settings, limit)
    }

    /// Follows Lemke's path from the complementary basis in which z_i is basic if `active(i)`.
    ///
    /// Returns whether the path ended in another complementary basis. From a singular or feasible start no path is followed, and the result is false.
    pub(super) fn run_from(
        &mut self,
        m: &[f64],
        active: &dyn Fn(usize) -> bool,
        settings: &Settings,
        limit: usize,
    ) -> bool {
        self.install_basis(m, active).is_ok()
            && self.cover_violations(m, ZERO_VALUE)
            && self.cover_and_run(m, settings, limit) == LemkeEnd::Complementary
    }

    /// Follows the path on which the variable `entering` increases next, and returns the end of the path. The dictionary must hold the column of
    /// `entering`.
    fn run(&mut self, mut entering: LemkeVariable, m: &[f64], settings: &Settings, limit: usize) -> LemkeEnd {
        loop {
            if self.pivots >= limit {
                return LemkeEnd::PivotLimit;
            }
            let row = match self.blocking_row(entering, Covering::Artificial, m, settings) {
                Ok(Some(row)) => row,
                Ok(None) => return LemkeEnd::Ray(entering),
                Err(cause) => return LemkeEnd::Breakdown(cause),
            };
            let leaving = self.pivot(entering, row, m);
            if leaving == LemkeVariable::Covering {
                return LemkeEnd::Complementary;
            }
            entering = leaving.complement();
        }
    }

    /// Exchanges the entering variable with the basic variable of the given row of the dictionary, and returns the leaving variable. Afterwards
    /// the dictionary holds the column of the complement of the leaving variable, unless z₀ has left.
    pub(super) fn pivot(&mut self, entering: LemkeVariable, row: usize, m: &[f64]) -> LemkeVariable {
        self.pivots += 1;
        self.age += 1;
        self.dictionary.pivot(entering, row, m, &self.scaling)
    }

    /// The row whose basic variable first reaches zero as `entering` increases; `None` if no basic variable reaches zero.
    ///
    /// The dictionary is first recomputed in three cases: rounding has made it drift from M, q and d; the column of `entering` has overflowed; or no
    /// row offers a pivot. It is also recomputed for a pivot below [`DOUBTFUL_PIVOT`] times the largest entry of its column. One step of refinement
    /// takes the place of this recomputation if it changes the column by at most the fraction [`DRIFTED`].
    pub(super) fn blocking_row(
        &mut self,
        entering: LemkeVariable,
        role: Covering,
        m: &[f64],
        settings: &Settings,
    ) -> Result<Option<usize>, BreakdownCause> {
        // The dictionary is compared with M, q and d once in 32 pivots. The comparison costs as much as one or two pivots. If it were made less
        // often, drift would be found late.
        if self.age > 0 && self.pivots.is_multiple_of(32) {
            if self.drift(m) > DRIFTED {
                self.refactor(entering, m)?;
            } else {
                self.correct();
            }
        }
        let mut is_refined = false;
        loop {
            let size = largest(&self.dictionary.u).max(1.0);
            if size == f64::INFINITY {
                if self.age == 0 {
                    return Err(BreakdownCause::Overflow);
                }
                self.refactor(entering, m)?;
                continue;
            }
            let certain = settings.pivot_tolerance * size;
            let row = blocking_row(&self.dictionary, FEW_ROUNDINGS * size, certain, role, settings);
            let pivot = row.map_or(0.0, |row| self.dictionary.u[row].abs());
            if pivot < DOUBTFUL_PIVOT * size && self.age > 0 && !is_refined {
                is_refined = row.is_some_and(|row| self.refine_column(entering, row, m) <= DRIFTED);
                if !is_refined {
                    self.refactor(entering, m)?;
                }
                continue;
            }
            if row.is_some() && pivot <= certain {
                // A pivot of at most `certain` is small relative to its column, but may be accurate relative to the terms from which its own entry
                // was computed. Each entry of the column is therefore compared with its own terms, and set to zero if it is noise.
                self.dictionary.clear_noise(entering, settings.pivot_tolerance);
                let firm = blocking_row(&self.dictionary, certain, certain, role, settings);
                if firm.is_some_and(|firm| !doubtful_row_breaks(&self.dictionary, certain, firm, role)) {
                    return Ok(firm);
                }
                return Ok(blocking_row(&self.dictionary, 0.0, 0.0, role, settings));
            }
            return Ok(row);
        }
    }
}
