//! The load factor at which a friction constraint of the quadratic program of minimum energy first binds, i.e. holds as an equality. On a ramp load
//! and commands change linearly with this factor. A command is the displacement that a finger would make if there were no object.

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
use crate::object::LinearProblem;
use crate::prelude::*;

/// The load factors from 0 for which the minimum of energy is an equilibrium.
///
/// Load and commands are affine functions of the factor τ. The vector of the complementarity problem of the [quadratic program](super::MinimumEnergy)
/// is therefore affine in τ, too, and its matrix is constant. Lemke's method with τ as the parameter follows the solution from τ = 0; each of its
/// pivots opens or closes a contact. The range ends at the pivot at which the multiplier of a friction constraint becomes positive. At larger load
/// factors this multiplier acts on the object like an external force, and Coulomb's law is violated. The paper on which the crate is based (cited in
/// [`energy`](crate::energy)) takes this load factor for the onset of sliding.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub enum Agreement<const C: usize> {
    /// The minimum is an equilibrium up to this load factor. At this factor the listed friction constraints begin to bind.
    UpTo {
        /// The largest load factor τ >= 0 at which the minimum is an equilibrium; it has no unit.
        factor: f64,
        /// Contact, counted from 0, and facet of every constraint that begins to bind. Facets are numbered as in [`PolygonCone`](crate::PolygonCone);
        /// `None` stands for the constraint F_n >= 0 at infinite friction.
        binding: Vec<(usize, Option<usize>)>,
    },
    /// The minimum is an equilibrium at every load factor from 0.
    Always,
    /// The minimum at load factor 0 is no equilibrium, or there is no such minimum. The variant holds the answer at load factor 0.
    Never(MinimumOutcome<C>),
    /// The load direction does work along a motion that no spring resists with all contacts closed: the quadratic program has no minimum for any τ >
    /// 0.
    Unbounded,
    /// The load factor was not found: because of rounding, the limit of pivots of Lemke's method, or more than 10 000 rows of its matrix.
    Unsolved,
}

impl<const C: usize> Agreement<C> {
    /// The load factor up to which the minimum is an equilibrium: infinite for [`Agreement::Always`]. For [`Agreement::Unbounded`] it is 0, because
    /// there is no minimum at any larger factor. `None` if the minimum at load factor 0 is not an equilibrium ([`Agreement::Never`]), or if Lemke's
    /// method failed ([`Agreement::Unsolved`]).
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

/// The quadratic program along a ramp. `program` is the program at load factor 0. Per unit of the load factor, `change` holds the changes of the
/// contacts' offsets (command less clearance, m), and `direction` the change of the load (N, N m).
struct Line<'g> {
    program: EnergyProgram<'g>,
    change: Vec<SVector<f64, 3>>,
    direction: Vector,
}

impl Line<'_> {
    /// The contact forces at load factor 0, and their derivatives with respect to the load factor, if only the springs in `springs` act. `None` if
    /// these springs do not resist the load.
    fn forces(&self, springs: &LinearProblem) -> Option<[Vec<SVector<f64, 3>>; 2]> {
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

    /// The answer if a friction constraint begins to bind at a pivot; `row` is its index in `program.friction`. `faces` says which constraints bind
    /// before this pivot, i.e. hold as equalities. `seen` is the load factor at this pivot, with the rounding errors of all pivots so far. The load
    /// factor of the answer is therefore computed anew, from the acting springs (all springs except the normal springs of contacts with open gaps).
    fn ends(&self, faces: &Faces, row: usize, seen: f64) -> Option<Agreement<3>> {
        let [forces, rates] = self.forces(&self.program.springs(faces))?;
        let friction = &self.program.friction;
        let (value, rate) = (friction[row].value(&forces), friction[row].value(&rates));
        // The margin of the constraint decreases with the load factor. If rounding hides this decrease, the load factor of the pivot is taken.
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
