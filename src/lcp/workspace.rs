//! Memory for solving many problems, and the steps from the end of a path to a checked point.

use super::Lcp;
use super::basis::Basis;
use super::certificate;
use super::dictionary::Unknown;
use super::enumerate;
use super::lemke::{End, Path, generic};
use super::outcome::{BreakdownCause, Outcome, Proof, Ray, Solution};
use super::principal;
use super::residuals::{Residuals, ignores_q, residuals_from, rounded, slack_and_terms};
use super::settings::Settings;
use nalgebra::DVector;

/// Values below this fraction of the largest term they were computed from are zero.
pub(crate) const ZERO: f64 = 1e-13;

/// Memory that is kept between problems: once it has held a problem of some size, solving further problems of at most
/// that size allocates nothing, as long as they are solved by the first path.
///
/// ```
/// use grasp_lcp::lcp::{Answer, Lcp, Settings, Workspace};
/// use nalgebra::{DMatrix, DVector};
///
/// let mut workspace = Workspace::new();
/// for load in 1..4 {
///     let problem = Lcp::new(DMatrix::from_element(1, 1, 2.0), DVector::from_element(1, -f64::from(load)))?;
///     let Answer::Solved(solution) = workspace.solve(&problem, &Settings::default()) else { panic!("2 > 0") };
///     assert_eq!(solution.z, [f64::from(load) / 2.0]);
/// }
/// # Ok::<(), grasp_lcp::lcp::LcpError>(())
/// ```
#[derive(Debug, Clone, Default)]
pub struct Workspace {
    pub(crate) path: Path,
    point: Point,
    spare: Point,
    vanishing: Vec<bool>,
    correction: Vec<f64>,
    defect: Vec<f64>,
    basis: Basis,
    residuals: Option<Residuals>,
    degenerate: bool,
}

/// z, w = M z + q, and the sizes of the terms of w.
#[derive(Debug, Clone, Default)]
struct Point {
    z: Vec<f64>,
    w: Vec<f64>,
    terms: Vec<f64>,
}

/// What a [`Workspace`] answers: a view of the solution it holds, or the [`Outcome`] that is not one.
#[derive(Debug, Clone, PartialEq)]
pub enum Answer<'a> {
    /// The problem is solved.
    Solved(SolutionView<'a>),
    /// It is not; the outcome is never [`Outcome::Solved`].
    Unsolved(Box<Outcome>),
}

/// A [`Solution`] that still lies in the memory of its [`Workspace`]; the fields mean the same.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SolutionView<'a> {
    /// z (n entries, none negative).
    pub z: &'a [f64],
    /// w = M z + q (n entries, none negative; exactly zero where z_i is basic).
    pub w: &'a [f64],
    /// Which z_i are basic.
    pub basis: &'a Basis,
    /// The violations at z.
    pub residuals: Residuals,
    /// Pivots made.
    pub pivots: usize,
    /// Whether a basic variable is zero.
    pub degenerate: bool,
}

impl SolutionView<'_> {
    /// A copy that outlives the workspace.
    #[must_use]
    pub fn to_solution(&self) -> Solution {
        Solution {
            z: DVector::from_column_slice(self.z),
            w: DVector::from_column_slice(self.w),
            basis: self.basis.clone(),
            residuals: self.residuals,
            pivots: self.pivots,
            degenerate: self.degenerate,
        }
    }
}

impl Answer<'_> {
    /// A copy that outlives the workspace.
    #[must_use]
    pub fn into_outcome(self) -> Outcome {
        match self {
            Self::Solved(view) => Outcome::Solved(view.to_solution()),
            Self::Unsolved(outcome) => *outcome,
        }
    }
}

impl Workspace {
    /// A workspace without memory yet.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Solves a problem like [`Lcp::solve_with`].
    pub fn solve(&mut self, lcp: &Lcp, settings: &Settings) -> Answer<'_> {
        let outcome = self.solve_cold(lcp, settings);
        self.answer(outcome)
    }

    /// Solves a problem like [`Lcp::solve_from`].
    pub fn solve_from(&mut self, lcp: &Lcp, basis: &Basis, settings: &Settings) -> Answer<'_> {
        let outcome = self.solve_warm(lcp, basis, settings);
        self.answer(outcome)
    }

    pub(crate) fn answer(&self, failure: Option<Outcome>) -> Answer<'_> {
        match (failure, self.residuals) {
            (None, Some(residuals)) => Answer::Solved(SolutionView {
                z: &self.point.z,
                w: &self.point.w,
                basis: &self.basis,
                residuals,
                pivots: self.path.pivots,
                degenerate: self.degenerate,
            }),
            (failure, _) => Answer::Unsolved(Box::new(failure.unwrap_or(Outcome::Breakdown {
                pivots: self.path.pivots,
                cause: BreakdownCause::SingularBasis,
            }))),
        }
    }

    fn solve_cold(&mut self, lcp: &Lcp, settings: &Settings) -> Option<Outcome> {
        self.residuals = None;
        if lcp.q.iter().all(|q| *q >= 0.0) {
            self.path.pivots = 0;
            return self.accept_slack_basis(lcp, settings);
        }
        self.path.prepare(lcp.m.as_slice(), lcp.q.as_slice());
        self.solve_prepared(lcp, settings)
    }

    /// The ladder: Lemke's path; a proof from its ray; other paths; a proof by linear programming; all bases.
    fn solve_prepared(&mut self, lcp: &Lcp, settings: &Settings) -> Option<Outcome> {
        let first = self.first_path(lcp, settings)?;
        match &first {
            Outcome::Ray(ray) if ray.proof != Proof::None => return Some(first),
            Outcome::PivotLimit { .. } if settings.max_pivots.is_some() => return Some(first),
            Outcome::Breakdown {
                cause: BreakdownCause::CoveringEntry { .. } | BreakdownCause::CoveringLength { .. },
                ..
            } => return Some(first),
            _ => {}
        }
        self.climb(lcp, settings, first)
    }

    fn first_path(&mut self, lcp: &Lcp, settings: &Settings) -> Option<Outcome> {
        if let Err(cause) = self.cover(lcp, settings) {
            return Some(Outcome::Breakdown { pivots: self.path.pivots, cause });
        }
        self.follow(lcp, settings, settings.pivot_limit(lcp.len()))
    }

    /// After a first path without solution and without proof.
    fn climb(&mut self, lcp: &Lcp, settings: &Settings, mut first: Outcome) -> Option<Outcome> {
        if let Some(proof) = certificate::by_linear_programming(lcp, &self.path.scaling, settings) {
            let ray = if let Outcome::Ray(ray) = first { Some(ray) } else { None };
            let ray = ray.unwrap_or_else(|| Ray::without_direction(lcp.len(), self.path.pivots));
            return Some(Outcome::Ray(Ray { proof: Proof::Infeasible(proof), ..ray }));
        }
        for attempt in 1..=settings.retries {
            // An exponential path is not followed again to its end.
            let limit = self.short_limit(lcp, settings);
            let units = self.path.scaling.row_unit.iter().enumerate();
            self.path.d.clear();
            // Entries between 1/8 and 8.
            self.path.d.extend(
                units.map(|(i, unit)| unit * (6.0 * (generic(attempt * 1_000_003 + i) - 1.0)).exp2()),
            );
            self.follow(lcp, settings, limit)?;
            if let Some([i, j]) = small_basis(lcp, attempt) {
                let m = lcp.m.as_slice();
                let sound = self.path.install_basis(m, |k| k == i || k == j).is_ok();
                if sound && self.path.cover_violations(m) {
                    let limit = self.short_limit(lcp, settings);
                    if self.path.cover_and_run(m, settings, limit) == End::Complementary {
                        self.finish_or_go_on(lcp, settings, limit)?;
                    }
                }
            }
        }
        if lcp.len() <= settings.enumerate_up_to.min(enumerate::LARGEST) {
            let all = enumerate::all_solutions(lcp, settings);
            if let Some(solution) = all.solutions.into_iter().next() {
                self.point.z = solution.z.as_slice().to_vec();
                self.point.w = solution.w.as_slice().to_vec();
                self.basis = solution.basis;
                self.residuals = Some(solution.residuals);
                self.degenerate = solution.degenerate;
                return None;
            }
            let ray = if let Outcome::Ray(ray) = first { Some(ray) } else { None };
            let ray = ray.unwrap_or_else(|| Ray::without_direction(lcp.len(), self.path.pivots));
            first = Outcome::Ray(Ray { proof: Proof::NoComplementaryBasis, ..ray });
        }
        match &mut first {
            Outcome::Ray(Ray { pivots, .. }) | Outcome::Breakdown { pivots, .. } => {
                *pivots = self.path.pivots;
            }
            _ => {}
        }
        Some(first)
    }

    /// A limit for one more path.
    fn short_limit(&self, lcp: &Lcp, settings: &Settings) -> usize {
        settings.max_pivots.unwrap_or_else(|| self.path.pivots.saturating_add(100 + 10 * lcp.len()))
    }

    fn solve_warm(&mut self, lcp: &Lcp, basis: &Basis, settings: &Settings) -> Option<Outcome> {
        self.residuals = None;
        self.path.prepare(lcp.m.as_slice(), lcp.q.as_slice());
        self.path.d.clear();
        self.path.d.resize(lcp.len(), 0.0);
        if basis.len() == lcp.len()
            && self.path.install_basis(lcp.m.as_slice(), |i| basis.contains(i)).is_ok()
        {
            self.resume(lcp, settings)
        } else {
            self.solve_prepared(lcp, settings)
        }
    }

    /// Solves a problem and leaves the dictionary of its basis, even if that is the slack basis.
    pub(crate) fn solve_first(&mut self, lcp: &Lcp, settings: &Settings) -> Option<Outcome> {
        self.residuals = None;
        self.path.prepare(lcp.m.as_slice(), lcp.q.as_slice());
        self.solve_prepared(lcp, settings)
    }

    /// One path without the rest of the ladder.
    pub(crate) fn follow_once(&mut self, lcp: &Lcp, settings: &Settings) -> Outcome {
        self.residuals = None;
        self.path.prepare(lcp.m.as_slice(), lcp.q.as_slice());
        let failure = self.first_path(lcp, settings);
        self.answer(failure).into_outcome()
    }

    /// Whether the dictionary is that of a complementary basis.
    pub(crate) fn is_complementary(&self) -> bool {
        let dictionary = &self.path.dictionary;
        dictionary.basic.iter().all(|basic| match *basic {
            Unknown::W(i) => !dictionary.is_active(i),
            Unknown::Z(i) => dictionary.is_active(i),
            Unknown::Covering => false,
        })
    }

    /// Whether the dictionary is that of this complementary basis.
    pub(crate) fn holds(&self, basis: &Basis) -> bool {
        self.is_complementary()
            && (0..basis.len()).all(|i| self.path.dictionary.is_active(i) == basis.contains(i))
    }

    /// Solves for a right-hand side that belongs to the matrix whose dictionary the path holds.
    pub(crate) fn solve_next(&mut self, lcp: &Lcp, settings: &Settings) -> Option<Outcome> {
        self.residuals = None;
        self.path.pivots = 0;
        self.path.set_right_hand_side(lcp.q.as_slice());
        self.path.recompute_values();
        self.resume(lcp, settings)
    }

    /// Follows the path from the present complementary basis; a failure starts again from the slacks.
    fn resume(&mut self, lcp: &Lcp, settings: &Settings) -> Option<Outcome> {
        let limit = settings.pivot_limit(lcp.len());
        let m = lcp.m.as_slice();
        let feasible = !self.path.cover_violations(m);
        if (feasible || self.path.cover_and_run(m, settings, limit) == End::Complementary)
            && self.finish(lcp, settings).is_none()
        {
            return None;
        }
        self.solve_prepared(lcp, settings)
    }

    /// Puts the covering vector, in balanced rows, into the path.
    fn cover(&mut self, lcp: &Lcp, settings: &Settings) -> Result<(), BreakdownCause> {
        self.path.d.clear();
        let Some(d) = &settings.covering else {
            self.path.d.extend_from_slice(&self.path.scaling.row_unit);
            return Ok(());
        };
        if d.len() != lcp.len() {
            return Err(BreakdownCause::CoveringLength { given: d.len(), needed: lcp.len() });
        }
        for (row, (d, q)) in d.iter().zip(&lcp.q).enumerate() {
            if !(d.is_finite() && *d >= 0.0) || (*q < 0.0 && *d == 0.0) {
                return Err(BreakdownCause::CoveringEntry { row, value: *d });
            }
        }
        self.path.d.extend(d.iter().zip(&self.path.scaling.row).map(|(d, row)| d * row));
        Ok(())
    }

    /// Follows Lemke's path from the slack basis and checks where it ends.
    fn follow(&mut self, lcp: &Lcp, settings: &Settings, limit: usize) -> Option<Outcome> {
        let m = lcp.m.as_slice();
        self.path.start_from_slacks();
        self.path.dictionary.enter(Unknown::Covering, m, &self.path.scaling);
        match self.path.cover_and_run(m, settings, limit) {
            End::Complementary => self.finish_or_go_on(lcp, settings, limit),
            End::Ray(entering) => Some(match certificate::ray(lcp, &self.path, entering) {
                Some(ray) => Outcome::Ray(ray),
                None => Outcome::Breakdown { pivots: self.path.pivots, cause: BreakdownCause::Overflow },
            }),
            End::PivotLimit => Some(Outcome::PivotLimit { pivots: self.path.pivots }),
            End::Breakdown(cause) => Some(Outcome::Breakdown { pivots: self.path.pivots, cause }),
        }
    }

    /// Where rounding has led the path to a basis that is not feasible, it is taken up again from there.
    fn finish_or_go_on(&mut self, lcp: &Lcp, settings: &Settings, limit: usize) -> Option<Outcome> {
        let m = lcp.m.as_slice();
        for _ in 0..3 {
            let failure = self.finish(lcp, settings)?;
            let active: Vec<bool> = (0..lcp.len()).map(|i| self.path.dictionary.is_active(i)).collect();
            let sound = self.path.install_basis(m, |i| active[i]).is_ok() && self.path.cover_violations(m);
            if !sound || self.path.cover_and_run(m, settings, limit) != End::Complementary {
                return Some(failure);
            }
        }
        self.finish(lcp, settings)
    }

    fn accept_slack_basis(&mut self, lcp: &Lcp, settings: &Settings) -> Option<Outcome> {
        self.basis.clear(lcp.len());
        self.vanishing.clear();
        self.vanishing.resize(lcp.len(), false);
        self.point.z.clear();
        self.point.z.resize(lcp.len(), 0.0);
        let residuals = self.point.evaluate(lcp);
        self.conclude(lcp, residuals, settings)
    }

    /// The point of the complementary basis in the dictionary, refined against the M and q given. `None` if it solves
    /// the problem.
    fn finish(&mut self, lcp: &Lcp, settings: &Settings) -> Option<Outcome> {
        let n = lcp.len();
        self.basis.clear(n);
        self.mark_vanishing(lcp);
        // A z_j which is zero in exact arithmetic comes out as noise that spoils the rows it enters. If w_j can take its place, the
        // point is that of a smaller block. By index, since the order of rows depends on rounding.
        let Path { dictionary, scaling, .. } = &mut self.path;
        for j in (0..n).filter(|j| self.vanishing[*j]) {
            if let Some(row) = dictionary.basic.iter().position(|basic| *basic == Unknown::Z(j)) {
                dictionary.retire(j, row, scaling, lcp.m.as_slice());
            }
        }
        for basic in &dictionary.basic {
            if let Unknown::Z(j) = *basic {
                self.basis.insert(j);
            }
        }
        self.read_point(n);
        let mut residuals = self.point.evaluate(lcp);
        for _ in 0..3 {
            if residuals.within(rounded(n)) || residuals == Residuals::UNUSABLE {
                break;
            }
            std::mem::swap(&mut self.point, &mut self.spare);
            self.refine();
            self.read_point(n);
            let refined = self.point.evaluate(lcp);
            let gain = refined.max() < 0.5 * residuals.max();
            if refined.max().is_nan() || refined.max() >= residuals.max() {
                std::mem::swap(&mut self.point, &mut self.spare);
            } else {
                residuals = refined;
            }
            if !gain {
                break;
            }
        }
        // A basic variable which is zero in exact arithmetic comes out as noise; it is left out if that costs nothing.
        if (0..n).any(|j| self.vanishing[j] && self.point.z[j] > 0.0) {
            self.spare.z.clear();
            self.spare
                .z
                .extend(self.point.z.iter().zip(&self.vanishing).map(|(z, out)| if *out { 0.0 } else { *z }));
            let cut = self.spare.evaluate(lcp);
            if cut.max() <= residuals.max().max(rounded(n)) {
                std::mem::swap(&mut self.point, &mut self.spare);
                residuals = cut;
            }
        }
        if !residuals.within(ZERO) {
            residuals = self.finish_by_factorisation(lcp, residuals);
        }
        if self.settle_pairs(settings) {
            residuals = self.point.evaluate(lcp);
        }
        self.conclude(lcp, residuals, settings)
    }

    /// Which basic z's are zero but for rounding: those that are small against the terms they were computed from, and
    /// those that are small against the largest z, if the point without them is as good. The terms alone do not show the noise
    /// of a z whose terms all vanish.
    fn mark_vanishing(&mut self, lcp: &Lcp) {
        let n = lcp.len();
        self.vanishing.clear();
        self.vanishing.resize(n, false);
        let dictionary = &self.path.dictionary;
        let values = || dictionary.basic.iter().zip(&dictionary.x).zip(&dictionary.level);
        let faint = ZERO
            * values().fold(
                0.0_f64,
                |most, ((basic, x), _)| {
                    if matches!(basic, Unknown::Z(_)) { most.max(*x) } else { most }
                },
            );
        let mut doubtful = false;
        self.spare.z.clear();
        self.spare.z.resize(n, 0.0);
        for ((basic, x), level) in values() {
            if let Unknown::Z(j) = *basic {
                self.vanishing[j] = *x <= ZERO * level;
                doubtful |= !self.vanishing[j] && *x <= faint;
                if *x > faint {
                    self.spare.z[j] = x * self.path.scaling.column[j];
                }
            }
        }
        if doubtful && self.spare.evaluate(lcp).within(rounded(n)) {
            for basic in &self.path.dictionary.basic {
                if let Unknown::Z(j) = *basic {
                    self.vanishing[j] |= self.spare.z[j] == 0.0;
                }
            }
        }
    }

    /// Where z_i is basic but w_i is not zero although the residuals are small, z_i has no share in any row that
    /// could be seen: it is the one to vanish. Returns whether there was such a pair.
    fn settle_pairs(&mut self, settings: &Settings) -> bool {
        let mut changed = false;
        for (i, z) in self.point.z.iter_mut().enumerate() {
            if self.basis.contains(i) && self.point.w[i] > settings.residual_tolerance * self.point.terms[i] {
                *z = 0.0;
                self.basis.toggle(i);
                changed = true;
            }
        }
        changed
    }

    /// z from the values in the dictionary; noise below zero is cut off.
    fn read_point(&mut self, n: usize) {
        self.point.z.clear();
        self.point.z.resize(n, 0.0);
        let dictionary = &self.path.dictionary;
        for (basic, x) in dictionary.basic.iter().zip(&dictionary.x) {
            if let Unknown::Z(j) = *basic {
                self.point.z[j] = x.max(0.0) * self.path.scaling.column[j];
            }
        }
    }

    /// Adds to the values the effect of the defect that the point in `spare` leaves in the rows that should vanish.
    fn refine(&mut self) {
        let path = &mut self.path;
        self.defect.clear();
        self.defect.extend(self.spare.w.iter().zip(&path.scaling.row).map(|(w, row)| w * row));
        for (i, defect) in self.defect.iter_mut().enumerate() {
            if !path.dictionary.is_active(i) {
                *defect = 0.0;
            }
        }
        self.correction.clear();
        self.correction.resize(self.defect.len(), 0.0);
        path.dictionary.effect(&self.defect, &mut self.correction);
        for (x, c) in path.dictionary.x.iter_mut().zip(&self.correction) {
            *x += c;
        }
    }

    /// The point of the basis by a fresh factorisation, without and with its vanishing variables; the best one is kept.
    fn finish_by_factorisation(&mut self, lcp: &Lcp, mut best: Residuals) -> Residuals {
        let alpha: Vec<usize> = self.basis.iter().collect();
        let support: Vec<usize> = alpha.iter().copied().filter(|i| !self.vanishing[*i]).collect();
        for indices in [&support, &alpha] {
            if best.within(ZERO) {
                break;
            }
            if let Some(basic) = principal::solve(&lcp.m, &lcp.q, indices) {
                self.spare.z.clear();
                self.spare.z.resize(lcp.len(), 0.0);
                for (j, value) in indices.iter().zip(&basic) {
                    self.spare.z[*j] = value.max(0.0);
                }
                let residuals = self.spare.evaluate(lcp);
                if best.max().is_nan() || residuals.max() < best.max() {
                    best = residuals;
                    std::mem::swap(&mut self.point, &mut self.spare);
                }
            }
        }
        best
    }

    /// Says "solved" only if the residuals do.
    fn conclude(&mut self, lcp: &Lcp, residuals: Residuals, settings: &Settings) -> Option<Outcome> {
        let pivots = self.path.pivots;
        if residuals == Residuals::UNUSABLE {
            return Some(Outcome::Breakdown { pivots, cause: BreakdownCause::Overflow });
        }
        if !residuals.within(settings.residual_tolerance) {
            return Some(Outcome::Breakdown { pivots, cause: BreakdownCause::Residual(residuals) });
        }
        if ignores_q(residuals, lcp.q.as_slice(), &self.point.terms, &self.path.scaling.row) {
            return Some(Outcome::Breakdown { pivots, cause: BreakdownCause::SingularBasis });
        }
        self.degenerate = false;
        for (i, w) in self.point.w.iter_mut().enumerate() {
            if self.basis.contains(i) {
                *w = 0.0;
                self.degenerate |= self.vanishing[i] || self.point.z[i] == 0.0;
            } else {
                self.degenerate |= self.vanishing[i] || *w <= ZERO * self.point.terms[i];
                *w = w.max(0.0);
            }
        }
        self.residuals = Some(residuals);
        None
    }
}

/// A basis of one or two z's to start a path from where the slack basis leads to rays, as in bimatrix games, whose matrix
/// [0, A; Bᵀ, 0] has no other regular bases with few z's. Each attempt takes another first index.
fn small_basis(lcp: &Lcp, attempt: usize) -> Option<[usize; 2]> {
    let n = lcp.len();
    let i = attempt.wrapping_mul(7).wrapping_add(attempt / n) % n;
    if lcp.m[(i, i)] != 0.0 {
        return Some([i, i]);
    }
    let coupled = |j: &usize| lcp.m[(i, *j)] != 0.0 && lcp.m[(*j, i)] != 0.0;
    (0..n).map(|k| (i + attempt + k) % n).find(coupled).map(|j| [i, j])
}

impl Point {
    fn evaluate(&mut self, lcp: &Lcp) -> Residuals {
        let n = lcp.len();
        self.w.resize(n, 0.0);
        self.terms.resize(n, 0.0);
        slack_and_terms(&lcp.m, lcp.q.as_slice(), &self.z, &mut self.w, &mut self.terms);
        residuals_from(&lcp.m, &self.z, &self.w, &self.terms)
    }
}
