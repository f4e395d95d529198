//! The path of solutions of 0 ≤ z ⟂ w = M z + q(τ) ≥ 0 as the parameter τ of q(τ) = q₀ + τ dq changes. The path consists of pieces, on each of which
//! the basis does not change.

use super::basis::{Basis, Variable};
use super::dictionary::{LemkeVariable, largest};
use super::error::LcpError;
use super::outcome::{BreakdownCause, Outcome};
use super::problem::Lcp;
use super::ratio::Covering;
use super::settings::Settings;
use super::tolerances::ZERO_VALUE;
use super::workspace::Workspace;
use crate::prelude::*;
use nalgebra::DVector;

/// Direction in which the parameter τ changes along a piece of the path of solutions.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Trend {
    /// τ increases.
    Forward,
    /// τ decreases: the path has turned back. Near the turning point the problem has no solutions for larger τ.
    Backward,
    /// τ is constant while the solution moves: all points of the piece are solutions at this τ.
    Still,
}

/// A point at which the basis of the path of solutions changes: one piece of the path ends and the next begins.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Breakpoint {
    /// The parameter τ at the breakpoint; it may be negative on a path that has turned back.
    pub tau: f64,
    /// Solution z at the breakpoint (n entries, none negative).
    pub z: DVector<f64>,
    /// The variable that has reached zero and leaves the basis.
    pub leaving: Variable,
    /// The complement of `leaving`, which increases from zero on the next piece of the path of solutions.
    pub entering: Variable,
    /// The complementary basis of the next piece of the path of solutions.
    pub basis: Basis,
    /// Direction of the parameter τ on the next piece of the path of solutions.
    pub trend: Trend,
    /// The rate dz/dτ of the solution on the next piece of the path (n entries). It is dz/dτ also where τ decreases along that piece, and zero if τ
    /// is constant.
    pub rate: DVector<f64>,
}

/// The reason why the path of solutions has no further breakpoints.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum PathEnd {
    /// The last piece of the path of solutions is unbounded: τ → ∞ (forward), τ → −∞ (backward), or τ is constant (still).
    Unbounded(Trend),
    /// The path has returned to an earlier piece, usually the first, and thus is a closed loop. The last breakpoint leads to that piece.
    ///
    /// The loop has solutions up to the largest τ of its breakpoints. For larger τ other paths may have solutions.
    Loop,
    /// The number of breakpoints has reached the pivot limit of the settings.
    PivotLimit,
    /// The path of solutions could not be followed further in double precision.
    Breakdown(BreakdownCause),
    /// No solution is known at τ = 0, where the path has to start.
    NoStart,
}

/// An iterator over the breakpoints of the solution of 0 ≤ z ⟂ w = M z + q₀ + τ dq ≥ 0. The path starts at τ = 0 with increasing τ.
///
/// On a complementary basis z is an affine function of τ. When a basic variable reaches zero, it leaves the basis and its complement enters. The
/// method is Lemke's with dq in place of the covering vector d (Cottle, Pang & Stone, section 4.5).
///
/// Each call of `next` follows one piece, at the cost of one pivot. When the iterator is exhausted, [`Parametric::end`] returns the reason.
///
/// If several variables reach zero together, several breakpoints have the same τ; the pieces between them have zero length. The settings' pivot
/// limit also bounds the number of breakpoints.
///
/// ```
/// use grasp_lcp::lcp::{Lcp, Parametric, PathEnd, Settings, Trend, Variable};
/// use nalgebra::{DMatrix, DVector};
///
/// // w = z + 1 − 2τ: z = 0 up to τ = 1/2, then z = 2τ − 1.
/// let problem = Lcp::new(DMatrix::from_element(1, 1, 1.0), DVector::from_element(1, 1.0))?;
/// let mut path = Parametric::new(&problem, &DVector::from_element(1, -2.0), Settings::default())?;
/// let first = path.next().expect("w reaches zero");
/// assert_eq!((first.tau, first.leaving, first.trend), (0.5, Variable::W(0), Trend::Forward));
/// assert!(path.next().is_none());
/// assert_eq!(path.end(), Some(&PathEnd::Unbounded(Trend::Forward)));
/// # Ok::<(), grasp_lcp::lcp::LcpError>(())
/// ```
#[derive(Debug, Clone)]
pub struct Parametric<'a> {
    lcp: &'a Lcp,
    settings: Settings,
    workspace: Workspace,
    start: Outcome,
    basis: Basis,
    entering: LemkeVariable,
    trend: Trend,
    breakpoints: usize,
    /// The basis of an earlier piece of the path of solutions, replaced after 1, 2, 4, 8, … breakpoints. A path that has entered a loop returns
    /// to this basis eventually (R. P. Brent, BIT 20, 1980).
    remembered: Basis,
    /// Whether the path of solutions has returned to an earlier piece of itself.
    closed: bool,
    end: Option<PathEnd>,
}

impl<'a> Parametric<'a> {
    /// The path for q₀ of `lcp` and the direction dq (n entries), from the solution that [`Lcp::solve_with`] finds.
    ///
    /// # Errors
    ///
    /// [`LcpError::Length`] if dq has another length than the problem, [`LcpError::VectorEntry`]
    /// for an entry that is not finite.
    pub fn new(lcp: &'a Lcp, dq: &DVector<f64>, settings: Settings) -> Result<Self, LcpError> {
        Self::from_basis(lcp, &Basis::slack(lcp.len()), dq, settings)
    }

    /// The path for q₀ of `lcp` and the direction dq (n entries), from the solution that [`Lcp::solve_from`] finds from `basis`. If the problem at
    /// τ = 0 has several solutions, `basis` selects one of them.
    ///
    /// # Errors
    ///
    /// [`LcpError::Length`] if dq has another length than the problem, [`LcpError::VectorEntry`] for an entry that is not finite.
    pub fn from_basis(
        lcp: &'a Lcp,
        basis: &Basis,
        dq: &DVector<f64>,
        settings: Settings,
    ) -> Result<Self, LcpError> {
        LcpError::check_vector("dq", dq, lcp.len())?;
        let mut workspace = Workspace::new();
        let start = if basis.count() == 0 {
            let failure = workspace.solve_first(lcp, &settings);
            workspace.answer(failure).into_outcome()
        } else {
            workspace.solve_from(lcp, basis, &settings).into_outcome()
        };
        let mut path = Self {
            lcp,
            settings,
            workspace,
            start,
            basis: Basis::slack(lcp.len()),
            entering: LemkeVariable::Covering,
            trend: Trend::Forward,
            breakpoints: 0,
            remembered: Basis::slack(lcp.len()),
            closed: false,
            end: None,
        };
        path.end = path.begin(dq).err();
        Ok(path)
    }

    /// Prepares the dictionary (condensed tableau) of the solution at τ = 0, with the parameter τ as the entering variable. The error is the reason
    /// why no path starts at this solution.
    fn begin(&mut self, dq: &DVector<f64>) -> Result<(), PathEnd> {
        self.basis = self.start.solution().ok_or(PathEnd::NoStart)?.basis.clone();
        self.remembered.clone_from(&self.basis);
        let (m, basis) = (self.lcp.m.as_slice(), &self.basis);
        if !self.workspace.holds(basis) {
            let installed = self.workspace.path.install_basis(m, &|i| basis.contains(i));
            installed.map_err(PathEnd::Breakdown)?;
            self.workspace.path.cover_violations(m, ZERO_VALUE);
        }
        self.workspace.path.start_parameter(dq.as_slice(), m);
        Ok(())
    }

    /// The solution at τ = 0, or the outcome of the failed solve.
    #[must_use]
    pub fn start(&self) -> &Outcome {
        &self.start
    }

    /// Direction of the parameter τ on the current piece of the path, which follows the last breakpoint; forward before the first breakpoint.
    #[must_use]
    pub fn trend(&self) -> Trend {
        self.trend
    }

    /// The reason why the path has no further breakpoints; `None` until the iterator is exhausted.
    #[must_use]
    pub fn end(&self) -> Option<&PathEnd> {
        self.end.as_ref()
    }

    /// Rates of the unknowns z and of the parameter τ per unit increase of the entering variable, in the caller's units.
    fn rates(&self) -> (DVector<f64>, f64) {
        let path = &self.workspace.path;
        let mut rate = Vec::new();
        let covering = path.unknowns(&path.dictionary.u, &mut rate);
        if let LemkeVariable::Z(e) = self.entering {
            rate[e] = path.scaling.column[e];
        }
        let tau = if self.entering == LemkeVariable::Covering { 1.0 } else { covering.unwrap_or(0.0) };
        let noise = self.settings.pivot_tolerance * largest(&path.dictionary.u).max(1.0);
        (DVector::from_vec(rate), if tau.abs() <= noise { 0.0 } else { tau })
    }

    /// Follows one piece of the path of solutions, on which the basis does not change, up to the breakpoint at its end. The error is the reason
    /// why there is no further breakpoint.
    fn step(&mut self) -> Result<Breakpoint, PathEnd> {
        if self.closed {
            return Err(PathEnd::Loop);
        }
        if self.breakpoints >= self.settings.pivot_limit(self.lcp.len()) {
            return Err(PathEnd::PivotLimit);
        }
        let m = self.lcp.m.as_slice();
        let path = &mut self.workspace.path;
        let row = path
            .blocking_row(self.entering, Covering::Parameter, m, &self.settings)
            .map_err(PathEnd::Breakdown)?
            .ok_or(PathEnd::Unbounded(self.trend))?;
        self.breakpoints += 1;
        let leaving = path.pivot(self.entering, row, m);
        self.entering = leaving.complement();
        match leaving {
            LemkeVariable::W(i) => Ok(self.breakpoint(Variable::W(i))),
            LemkeVariable::Z(i) => Ok(self.breakpoint(Variable::Z(i))),
            // Here `Covering` stands for the parameter τ. The ratio test does not consider τ, so τ cannot leave the basis.
            LemkeVariable::Covering => Err(PathEnd::Breakdown(BreakdownCause::SingularBasis)),
        }
    }

    fn breakpoint(&mut self, leaving: Variable) -> Breakpoint {
        let (mut rate, tau_rate) = self.rates();
        self.trend = match tau_rate {
            t if t > 0.0 => Trend::Forward,
            t if t < 0.0 => Trend::Backward,
            _ => Trend::Still,
        };
        if tau_rate == 0.0 {
            rate.fill(0.0);
        } else {
            rate /= tau_rate;
        }
        self.basis.toggle(leaving.index());
        // In exact arithmetic each basis has one piece of the path of solutions, so a path that closes returns to its start. Rounding, or a
        // start at which basic variables are zero, may lead into a loop that does not contain the start.
        let begun = self.start.solution().is_some_and(|start| start.basis == self.basis);
        self.closed = begun || self.remembered == self.basis;
        if self.breakpoints.is_power_of_two() {
            self.remembered.clone_from(&self.basis);
        }
        let mut z = Vec::new();
        let tau = self.workspace.path.read_point(&mut z).unwrap_or(0.0);
        Breakpoint {
            tau,
            z: DVector::from_vec(z),
            leaving,
            entering: leaving.complement(),
            basis: self.basis.clone(),
            trend: self.trend,
            rate,
        }
    }
}

impl Iterator for Parametric<'_> {
    type Item = Breakpoint;

    fn next(&mut self) -> Option<Breakpoint> {
        if self.end.is_some() {
            return None;
        }
        self.step().map_err(|end| self.end = Some(end)).ok()
    }
}
