//! Lemke's method.
//!
//! The augmented problem w = q + M z + d z₀ is followed along the path of points with w_i z_i = 0 for all i, from
//! z = 0 with large z₀ to z₀ = 0 (Cottle, Pang & Stone, algorithm 4.4.5): the variable driven next is always
//! the complement of the one that left last.

use super::dictionary::{Dictionary, Unknown, largest};
use super::outcome::BreakdownCause;
use super::ratio::{Covering, blocking_row, doubtful_row_breaks, most_violated_row};
use super::scaling::Scaling;
use super::settings::Settings;

/// How a path ends.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum End {
    /// z₀ left: the basis is a complementary one.
    Complementary,
    /// This variable grows for ever; its column is in the dictionary.
    Ray(Unknown),
    PivotLimit,
    Breakdown(BreakdownCause),
}

/// A pivot smaller than this fraction of its column, or a drift larger than this, asks for a fresh dictionary.
const DOUBTFUL: f64 = 1e-7;
/// A coefficient below this fraction of its column is noise in any case; between that and the pivot tolerance it is worth
/// a second look.
const GREY: f64 = 4.0 * f64::EPSILON;
/// The values are compared with the data after so many pivots.
const CHECK_EVERY: usize = 32;
/// A dictionary whose values miss the data by more than this fraction of their terms is computed anew.
const DRIFT: f64 = 1e-10;

/// A path through the dictionaries of one balanced problem.
#[derive(Debug, Clone, Default)]
pub(crate) struct Path {
    pub(crate) scaling: Scaling,
    pub(crate) dictionary: Dictionary,
    /// The balanced right-hand side, perturbation and covering vector.
    pub(crate) q: Vec<f64>,
    pub(crate) p: Vec<f64>,
    pub(crate) d: Vec<f64>,
    pub(crate) pivots: usize,
    /// Pivots since the dictionary was last computed from the data.
    age: usize,
    /// The perturbation of each basic variable while the dictionary is computed anew.
    saved: Vec<f64>,
    members: Vec<Unknown>,
    active: Vec<bool>,
    defect: Vec<f64>,
    terms: Vec<f64>,
}

impl Path {
    /// Balances M, and q and p with it. The dictionary still has to be started.
    pub(crate) fn prepare(&mut self, m: &[f64], q: &[f64]) {
        self.scaling.balance(q.len(), m, q);
        self.p.clear();
        self.p.extend(self.scaling.row_unit.iter().enumerate().map(|(i, unit)| unit * generic(i)));
        self.set_right_hand_side(q);
        self.pivots = 0;
    }

    pub(crate) fn set_right_hand_side(&mut self, q: &[f64]) {
        self.q.clear();
        self.q.extend(q.iter().zip(&self.scaling.row).map(|(q, row)| q * row));
    }

    /// Starts from the slack basis with the present q, p and d.
    pub(crate) fn start_from_slacks(&mut self) {
        self.dictionary.reset(&self.q, &self.p, &self.d);
        self.age = 0;
    }

    /// Lets z₀ enter an infeasible basis and follows the path until z₀ has left again. The column of z₀ is in the dictionary.
    pub(crate) fn cover_and_run(&mut self, m: &[f64], settings: &Settings, limit: usize) -> End {
        let row = match most_violated_row(&self.dictionary, settings) {
            Ok(Some(row)) => row,
            Ok(None) => return End::Complementary,
            Err(row) => {
                let value = settings.covering.as_ref().and_then(|d| d.get(row)).copied().unwrap_or(0.0);
                return End::Breakdown(BreakdownCause::CoveringEntry { row, value });
            }
        };
        if self.pivots >= limit {
            return End::PivotLimit;
        }
        let leaving = self.pivot(Unknown::Covering, row, m);
        self.run(leaving.complement(), m, settings, limit)
    }

    /// Follows the path from the entering variable on, whose column is in the dictionary.
    fn run(&mut self, mut entering: Unknown, m: &[f64], settings: &Settings, limit: usize) -> End {
        loop {
            if self.pivots >= limit {
                return End::PivotLimit;
            }
            let row = match self.blocking_row(entering, Covering::Artificial, m, settings) {
                Ok(Some(row)) => row,
                Ok(None) => return End::Ray(entering),
                Err(cause) => return End::Breakdown(cause),
            };
            let leaving = self.pivot(entering, row, m);
            if leaving == Unknown::Covering {
                return End::Complementary;
            }
            entering = leaving.complement();
        }
    }

    /// One exchange; afterwards the column of the leaving variable's complement is in the dictionary.
    pub(crate) fn pivot(&mut self, entering: Unknown, row: usize, m: &[f64]) -> Unknown {
        self.pivots += 1;
        self.age += 1;
        self.dictionary.pivot(entering, row, m, &self.scaling)
    }

    /// The blocking row for the entering variable, from a dictionary that can be trusted: one that has drifted from
    /// the data, or that offers only a doubtful pivot or none, is computed anew first.
    pub(crate) fn blocking_row(
        &mut self,
        entering: Unknown,
        role: Covering,
        m: &[f64],
        settings: &Settings,
    ) -> Result<Option<usize>, BreakdownCause> {
        if self.age > 0 && self.pivots.is_multiple_of(CHECK_EVERY) {
            if self.drift(m) > DRIFT {
                self.refactor(entering, m)?;
            } else {
                self.correct();
            }
        }
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
            let row = blocking_row(&self.dictionary, GREY * size, certain, role, settings);
            let pivot = row.map_or(0.0, |row| self.dictionary.u[row].abs());
            if pivot < DOUBTFUL * size && self.age > 0 {
                self.refactor(entering, m)?;
                continue;
            }
            if row.is_some() && pivot <= certain {
                // Small against the column, but perhaps not against the terms of its own row.
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

    /// How far the values of the basic variables are from solving w = q + M z + d z₀, as a fraction of the terms of a
    /// row. A thousandth of the largest q_i is counted with the terms, or rows of nothing but noise would drift.
    fn drift(&mut self, m: &[f64]) -> f64 {
        self.compute_defect(m);
        let floor = 1e-3 * largest(&self.q);
        self.defect
            .iter()
            .zip(&self.terms)
            .fold(0.0, |drift, (r, a)| r.abs().max(drift * (a + floor)) / (a + floor))
    }

    /// r = q + M z + d z₀ − w at the present values, and the size of its terms, row by row.
    fn compute_defect(&mut self, m: &[f64]) {
        let n = self.q.len();
        self.defect.clear();
        self.defect.extend_from_slice(&self.q);
        self.terms.clear();
        self.terms.extend(self.q.iter().map(|q| q.abs()));
        for (basic, x) in self.dictionary.basic.iter().zip(&self.dictionary.x) {
            match *basic {
                Unknown::W(i) => {
                    self.defect[i] -= x;
                    self.terms[i] += x.abs();
                }
                Unknown::Covering => {
                    add_with_terms(&mut self.defect, &mut self.terms, self.d.iter().map(|d| d * x));
                }
                Unknown::Z(j) => {
                    let factor = self.scaling.column[j] * x;
                    let column =
                        m[j * n..(j + 1) * n].iter().zip(&self.scaling.row).map(|(m, row)| m * row * factor);
                    add_with_terms(&mut self.defect, &mut self.terms, column);
                }
            }
        }
    }

    /// Computes the dictionary of the present basis anew from the data, by elimination with row pivoting, and puts
    /// the column of the entering variable back.
    pub(crate) fn refactor(&mut self, entering: Unknown, m: &[f64]) -> Result<(), BreakdownCause> {
        self.members.clear();
        self.saved.clear();
        self.saved.resize(2 * self.q.len() + 1, 0.0);
        for (row, basic) in self.dictionary.basic.iter().enumerate() {
            self.saved[index(*basic, self.q.len())] = self.dictionary.p[row];
            if !matches!(basic, Unknown::W(_)) {
                self.members.push(*basic);
            }
        }
        self.active.clear();
        self.active.extend((0..self.q.len()).map(|i| self.dictionary.is_active(i)));
        self.install(m)?;
        for row in 0..self.q.len() {
            self.dictionary.p[row] = self.saved[index(self.dictionary.basic[row], self.q.len())];
        }
        self.dictionary.enter(entering, m, &self.scaling);
        Ok(())
    }

    /// The dictionary in which `members` are basic and the w_i with `active[i]` are not.
    fn install(&mut self, m: &[f64]) -> Result<(), BreakdownCause> {
        self.start_from_slacks();
        for member in 0..self.members.len() {
            let member = self.members[member];
            self.dictionary.enter(member, m, &self.scaling);
            let mut best = (0, 0.0);
            for (row, (basic, u)) in self.dictionary.basic.iter().zip(&self.dictionary.u).enumerate() {
                if let Unknown::W(i) = *basic
                    && self.active[i]
                    && u.abs() > best.1
                {
                    best = (row, u.abs());
                }
            }
            if best.1.is_nan() || best.1 <= SINGULAR * self.dictionary.entering_size() {
                return Err(BreakdownCause::SingularBasis);
            }
            self.dictionary.exchange(member, best.0);
        }
        self.compute_defect(m);
        self.correct();
        Ok(())
    }

    /// Adds to the values the effect of the defect computed last, and measures anew what rounding they may carry.
    fn correct(&mut self) {
        self.dictionary.sum_terms(&self.terms);
        let mut effect = std::mem::take(&mut self.terms);
        self.dictionary.effect(&self.defect, &mut effect);
        for (x, e) in self.dictionary.x.iter_mut().zip(&effect) {
            *x += e;
        }
        self.terms = effect;
    }

    /// The values for a new right-hand side in the present dictionary.
    pub(crate) fn recompute_values(&mut self) {
        let mut x = std::mem::take(&mut self.dictionary.x);
        self.dictionary.effect(&self.q, &mut x);
        self.dictionary.x = x;
        self.dictionary.sum_terms(&self.q);
    }

    /// Prepares z₀ to enter the present complementary basis, covering only what is infeasible there: with c = 1 unit in these
    /// rows of the dictionary and 0 in the others, d is the vector for which c is the column of z₀. Returns whether
    /// anything is infeasible.
    pub(crate) fn cover_violations(&mut self, m: &[f64]) -> bool {
        let n = self.q.len();
        let dictionary = &mut self.dictionary;
        self.d.clear();
        self.d.resize(n, 0.0);
        let mut violated = false;
        for row in 0..n {
            // One unit of the exactly balanced problem, as everywhere.
            let unit = match dictionary.basic[row] {
                Unknown::W(i) => self.scaling.row_unit[i],
                Unknown::Z(j) => self.scaling.column_unit(j),
                Unknown::Covering => 1.0,
            };
            // By the variable, since the order of rows depends on rounding.
            dictionary.p[row] = unit * generic(index(dictionary.basic[row], n));
            dictionary.u[row] = 0.0;
            if dictionary.x[row] >= -NOISE * dictionary.level[row] {
                dictionary.x[row] = dictionary.x[row].max(0.0);
                continue;
            }
            violated = true;
            dictionary.u[row] = unit;
            match dictionary.basic[row] {
                Unknown::W(i) => self.d[i] += unit,
                Unknown::Z(j) => {
                    let column = m[j * n..(j + 1) * n].iter().zip(&self.scaling.row);
                    for (d, (m, row)) in self.d.iter_mut().zip(column) {
                        *d -= m * row * self.scaling.column[j] * unit;
                    }
                }
                Unknown::Covering => {}
            }
        }
        dictionary.d.clear();
        dictionary.d.extend_from_slice(&self.d);
        violated
    }

    /// Lets z₀ be the parameter of q + z₀ d from here on, d given in the caller's rows, and puts its column into the
    /// dictionary.
    pub(crate) fn start_parameter(&mut self, d: &[f64], m: &[f64]) {
        self.d.clear();
        self.d.extend(d.iter().zip(&self.scaling.row).map(|(d, row)| d * row));
        self.dictionary.d.clear();
        self.dictionary.d.extend_from_slice(&self.d);
        self.dictionary.enter(Unknown::Covering, m, &self.scaling);
    }

    /// Installs the complementary basis in which z_i is basic where `active(i)`.
    pub(crate) fn install_basis(
        &mut self,
        m: &[f64],
        active: impl Fn(usize) -> bool,
    ) -> Result<(), BreakdownCause> {
        self.active.clear();
        self.active.extend((0..self.q.len()).map(&active));
        self.members.clear();
        self.members.extend((0..self.q.len()).filter(|i| active(*i)).map(Unknown::Z));
        self.install(m)
    }
}

/// An elimination pivot below this fraction of its column before elimination makes the basis singular.
const SINGULAR: f64 = 1e-14;
/// Values above minus this fraction of their terms are not infeasible.
const NOISE: f64 = 1e-13;

fn index(variable: Unknown, n: usize) -> usize {
    match variable {
        Unknown::W(i) => i,
        Unknown::Z(i) => n + i,
        Unknown::Covering => 2 * n,
    }
}

fn add_with_terms(sum: &mut [f64], terms: &mut [f64], column: impl Iterator<Item = f64>) {
    for ((s, a), c) in sum.iter_mut().zip(terms).zip(column) {
        *s += c;
        *a += c.abs();
    }
}

/// Entry i of a fixed vector without structure, between 1/2 and 3/2 (the mixing function of splitmix64).
pub(crate) fn generic(i: usize) -> f64 {
    let mut x = (i as u64).wrapping_add(1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    x = (x ^ (x >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    x = (x ^ (x >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    x ^= x >> 31;
    0.5 + (x >> 11) as f64 / (1_u64 << 53) as f64
}
