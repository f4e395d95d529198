//! The load factor along a ramp at which a friction constraint of the quadratic program first binds.

use nalgebra::SVector;

use super::energy_rows::{ForceCondition, most_pivots};
use super::minimum::{MinimumEnergy, MinimumOutcome};
use super::optimality::{EnergyProgram, Faces};
use crate::Settings;
use crate::error::Error;
use crate::grasp::Engine;
use crate::lcp::{self, Basis, Lcp, Parametric, Variable};
use crate::load_path::Ramp;
use crate::numerics::tolerances::SOLVED_ROUNDING;
use crate::numerics::{IntoList, Vector, largest};
use crate::object::Piece;
use crate::prelude::*;

/// The load factors for which the minimum of energy is an equilibrium.
///
/// Load and commands are affine in the factor τ. So is the vector of the [program's](super::MinimumEnergy) complementarity problem, while its matrix
/// is constant. Lemke's method with τ as the parameter passes from one set of open gaps to the next. It ends once the multiplier of a friction
/// constraint enters the basis: from there on this multiplier pushes the object, and Coulomb's law is violated. The paper (see
/// [`energy`](crate::energy)) predicts sliding in this way.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub enum Agreement<const C: usize> {
    /// The minimum is an equilibrium up to this load factor, at which the listed friction constraints begin to bind.
    UpTo {
        /// The load factor τ >= 0, no unit.
        factor: f64,
        /// Contact and facet of every constraint that begins to bind, numbered as in [`PolygonCone`](crate::PolygonCone). The facet
        /// is `None` for F_n = 0 at infinite friction.
        binding: Vec<(usize, Option<usize>)>,
    },
    /// The minimum is an equilibrium at every load factor.
    Always,
    /// The minimum is no equilibrium even at load factor 0, or there is no minimum.
    Never(MinimumOutcome<C>),
    /// From the start the load direction works on a motion that no spring resists: the program has no minimum for any τ > 0.
    Unbounded,
    /// Lemke's method could not follow the path to its end.
    Unsolved,
}

impl<const C: usize> Agreement<C> {
    /// The load factor up to which the minimum is an equilibrium: infinite for [`Agreement::Always`], 0 for [`Agreement::Unbounded`]. `None` if the
    /// minimum at load factor 0 is not an equilibrium ([`Agreement::Never`]), or if the path is not known ([`Agreement::Unsolved`]).
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

impl Engine {
    /// Implements [`Energy::agreement`](crate::ask::Energy::agreement).
    pub(crate) fn agreement_with_minimum_energy(
        &self,
        ramp: &Ramp<3>,
        settings: &Settings,
    ) -> Result<Agreement<3>, Error> {
        ramp.base.check_in(self.space(), "base load")?;
        let direction = self.inside(&ramp.direction, "load direction")?;
        let change = ramp.offset_changes(self)?;
        let start = self.minimum_energy(&ramp.base, settings)?;
        if !start.minimum().is_some_and(MinimumEnergy::is_equilibrium) {
            return Ok(Agreement::Never(start));
        }
        let program = EnergyProgram::new(self.on_polygons(&ramp.base, &settings.cone)?);
        if !program.stuck.resists(&direction) {
            return Ok(Agreement::Unbounded);
        }
        Ok(Line { program, change, direction }.follow(settings).unwrap_or(Agreement::Unsolved))
    }
}

/// The quadratic program along a ramp: at load factor 0, and its change with the factor.
struct Line<'g> {
    program: EnergyProgram<'g>,
    change: Vec<SVector<f64, 3>>,
    direction: Vector,
}

impl Line<'_> {
    /// The contact forces at load factor 0, and their rates by the load factor, if only `springs` are active.
    fn forces(&self, springs: &Piece) -> Option<[Vec<SVector<f64, 3>>; 2]> {
        let problem = &self.program.problem;
        let start = springs.solve(problem.sites, &problem.offsets, problem.load()).ok()?;
        let rates = springs.solve(problem.sites, &self.change, &self.direction).ok()?;
        Some([start.forces, rates.forces])
    }

    fn follow(&self, settings: &Settings) -> Option<Agreement<3>> {
        let program = &self.program;
        let [forces, rates] = self.forces(&program.stuck)?;
        let lcp = Lcp::new(program.matrix()?, program.vector(&forces)).ok()?;
        let max_pivots = most_pivots(lcp.len(), settings);
        let settings = lcp::Settings { max_pivots, ..lcp::Settings::default() };
        let mut path = Parametric::new(&lcp, &program.vector(&rates), settings).ok()?;
        let mut basis: Basis = path.start().solution()?.basis.clone();
        for next in path.by_ref() {
            if let Variable::Z(i) = next.entering
                && let Some(row) = i.checked_sub(program.gaps.len())
            {
                return self.ends(&program.faces_of(&basis), row, next.tau);
            }
            basis = next.basis;
        }
        matches!(path.end(), Some(lcp::PathEnd::Unbounded(_))).then_some(Agreement::Always)
    }

    /// The answer if the multiplier of friction constraint `row` enters the basis. Its load factor is computed anew from the springs that are active
    /// below this factor. `seen` is the load factor from the pivots.
    fn ends(&self, faces: &Faces, row: usize, seen: f64) -> Option<Agreement<3>> {
        let [forces, rates] = self.forces(&self.program.springs(faces))?;
        let friction = &self.program.friction;
        let (value, rate) = (friction[row].value(&forces), friction[row].value(&rates));
        // If the constraint does not approach its bound, the load factor from the pivots is taken.
        let factor = if rate < 0.0 { (value / -rate).max(0.0) } else { seen };
        let most = |list: &[SVector<f64, 3>]| largest(list, &SVector::norm);
        let size = most(&forces) + factor * most(&rates);
        let binds = |(r, other): &(usize, &ForceCondition)| {
            let (value, rate) = (other.value(&forces), other.value(&rates));
            *r == row
                || (rate < 0.0 && (value + factor * rate).abs() <= SOLVED_ROUNDING * size * other.weight)
        };
        let binding = friction.iter().enumerate().filter(binds).map(|(_, r)| (r.contact, r.facet)).list();
        Some(Agreement::UpTo { factor, binding })
    }
}
