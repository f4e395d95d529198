//! Along a load path: the load at which a friction constraint of the quadratic program first binds.

use nalgebra::{DVector, SVector};

use super::conditions::{Faces, Program};
use super::minimum::MinimumOutcome;
use super::springs::Springs;
use crate::Settings;
use crate::error::{Error, Field};
use crate::grasp::Grasp;
use crate::lcp::{self, Basis, Lcp, Parametric, Variable};
use crate::load_path::Ramp;

/// Rows whose value at the end is below this part of its terms bind together: they tie in exact arithmetic.
const TIED: f64 = 1e-12;

/// How far along a ramp the minimum of energy is an equilibrium.
///
/// Load and commands are affine in the factor τ, and so is the vector of the [program's](super::MinimumEnergy) complementarity
/// problem, while its matrix stays. Lemke's method with τ as the parameter goes from one set of open gaps to the next; the first
/// friction row that enters ends the agreement with Coulomb's law, for its multiplier pushes the object from then on. That
/// is how the paper predicts sliding.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub enum Agreement<const D: usize, const C: usize> {
    /// Up to this factor; there the friction constraints named begin to bind.
    UpTo {
        /// The load factor τ >= 0, no unit.
        factor: f64,
        /// Contact and facet of every constraint that begins to bind, numbered as in [`ReducedRow::Friction`](super::ReducedRow::Friction); no
        /// facet for F_n = 0 at infinite friction.
        binding: Vec<(usize, Option<usize>)>,
    },
    /// However far the load goes.
    Always,
    /// Not even at factor 0: the minimum there, or why there is none.
    Never(MinimumOutcome<D, C>),
    /// From the start the load direction works on a motion that no spring resists: the program has no minimum for any τ > 0.
    Unbounded,
    /// The path could not be followed to its end.
    Unsolved,
}

impl<const D: usize, const C: usize> Agreement<D, C> {
    /// The factor up to which the minimum is an equilibrium: infinite for [`Agreement::Always`], 0 for [`Agreement::Unbounded`]. `None` where it
    /// is none at any factor known ([`Agreement::Never`]), or nothing can be said ([`Agreement::Unsolved`]).
    #[must_use]
    pub fn factor(&self) -> Option<f64> {
        match self {
            Self::UpTo { factor, .. } => Some(*factor),
            Self::Always => Some(f64::INFINITY),
            Self::Unbounded => Some(0.0),
            Self::Never(_) | Self::Unsolved => None,
        }
    }
}

impl<const D: usize, const C: usize> Grasp<D, C> {
    /// How far along a ramp the minimum of the paper's program is an equilibrium. In space on the polygonal cone of the settings.
    ///
    /// Where every contact has friction and touches at factor 0 this is the
    /// [onset of sliding](Self::onset_on_polygon), found another way. Frictionless contacts may open and close before.
    ///
    /// ```
    /// use grasp_lcp::planar::{Contact, Grasp, Ramp, Wrench};
    /// use grasp_lcp::Settings;
    ///
    /// // Two fingers that each press with 1000 N/m · 0.01 m = 10 N; μ = 0.5.
    /// let finger = |x: f64| Contact::new([x, 0.0], [-x, 0.0]).series_stiffness(1000.0, 800.0).friction(0.5).command([0.01, 0.0]);
    /// let grasp = Grasp::new([finger(-1.0), finger(1.0)])?;
    ///
    /// let ramp = Ramp::load(Wrench::ZERO, Wrench::force([0.0, -1.0]));
    /// let factor = grasp.agreement_with_minimum_energy(&ramp, &Settings::default())?.factor().expect("agrees at first");
    /// assert!((factor - 10.0).abs() < 1e-12); // the onset of sliding
    /// # Ok::<(), grasp_lcp::Error>(())
    /// ```
    ///
    /// # Errors
    /// As for [`Self::onset`].
    pub fn agreement_with_minimum_energy(
        &self,
        ramp: &Ramp<D, C>,
        settings: &Settings,
    ) -> Result<Agreement<D, C>, Error> {
        let base = self.inside(&ramp.base, "base load")?;
        let direction = self.inside(&ramp.direction, "load direction")?;
        let change = match &ramp.command_change {
            Some(change) => {
                self.check_commands(change, "command changes", Field::CommandChange)?;
                change.clone()
            }
            None => vec![SVector::zeros(); self.len()],
        };
        let start = self.minimum_energy(&ramp.base, settings)?;
        if !start.minimum().is_some_and(super::MinimumEnergy::is_equilibrium) {
            return Ok(Agreement::Never(start));
        }
        let program = Program::new(self.sites(), &settings.cone);
        if program.stuck.worked_on(&direction).is_some() {
            return Ok(Agreement::Unbounded);
        }
        let line = Line { program, drives: self.drives(), base, change, direction };
        Ok(line.follow(settings))
    }
}

/// The program along a ramp.
struct Line<'g, const D: usize, const C: usize> {
    program: Program<'g, D, C>,
    drives: Vec<SVector<f64, C>>,
    base: SVector<f64, D>,
    change: Vec<SVector<f64, C>>,
    direction: SVector<f64, D>,
}

impl<const D: usize, const C: usize> Line<'_, D, C> {
    fn follow(&self, settings: &Settings) -> Agreement<D, C> {
        let program = &self.program;
        let q = program.vector(&program.stuck.rest(&self.drives, &self.base));
        let dq: DVector<f64> = program.vector(&program.stuck.rest(&self.change, &self.direction));
        let lcp_settings = lcp::Settings { max_pivots: settings.max_pivots, ..lcp::Settings::default() };
        let Ok(lcp) = Lcp::new(program.matrix(), q) else { return Agreement::Unsolved };
        let Ok(mut path) = Parametric::new(&lcp, &dq, lcp_settings) else { return Agreement::Unsolved };
        let Some(solution) = path.start().solution() else { return Agreement::Unsolved };
        let gaps = program.gaps.len();
        let mut basis: Basis = solution.basis.clone();
        for next in path.by_ref() {
            if let Variable::Z(i) = next.entering
                && i >= gaps
            {
                return self.ends(&program.faces_of(&basis), i - gaps, next.tau);
            }
            basis = next.basis;
        }
        match path.end() {
            Some(lcp::PathEnd::Unbounded(_)) => Agreement::Always,
            _ => Agreement::Unsolved,
        }
    }

    /// The factor at which a row binds, from the springs that hold until then.
    fn ends(&self, faces: &Faces, row: usize, seen: f64) -> Agreement<D, C> {
        let sites = self.program.sites;
        let springs = Springs::along_axes(sites, |i, axis| axis > 0 || !faces.open[i]);
        let at = |drives: &[SVector<f64, C>], wrench: &SVector<f64, D>| {
            springs.forces(&springs.rest(drives, wrench).x, sites.len())
        };
        let (forces, rates) = (at(&self.drives, &self.base), at(&self.change, &self.direction));
        let line = |r: usize| {
            let row = &self.program.rows[r];
            let site = &sites[row.contact];
            (row.value(site, &forces[row.contact]), row.value(site, &rates[row.contact]), row.weight)
        };
        let (value, rate, _) = line(row);
        // The pivots' own factor where the row stands still.
        let factor = if rate < 0.0 { (value / -rate).max(0.0) } else { seen };
        let most = |list: &[SVector<f64, C>]| list.iter().map(SVector::norm).fold(0.0, f64::max);
        let size = most(&forces) + factor * most(&rates);
        let binds = |r: &usize| {
            let (value, rate, weight) = line(*r);
            *r == row || (rate < 0.0 && (value + factor * rate).abs() <= TIED * size * weight)
        };
        let binding = (0..self.program.rows.len())
            .filter(binds)
            .map(|r| (self.program.rows[r].contact, self.program.rows[r].facet))
            .collect();
        Agreement::UpTo { factor, binding }
    }
}
