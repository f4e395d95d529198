//! Contact forces and twist of a load path under a load that turns. Three linear solves give them, one each for the constant, cosine and sine terms
//! of the load. As long as contacts keep their states (open, sticking or sliding), the solutions also give forces, stretches and twist as harmonic
//! functions of the load's angle. A leg is a section of the load program. The load factor is here the fraction of the leg that is done or, for a turn
//! without a leg, the angle.

use alloc::sync::Arc;

use nalgebra::SVector;

use super::segment::{PathPoint, Segment};
use super::trajectory::Trajectory;
use super::turning_state::TurningState;
use crate::contact::Wave;
use crate::equilibrium::NoEquilibrium;
use crate::numerics::tolerances::SOLVED_ROUNDING;
use crate::numerics::{Harmonic, Vector, mapped, numbered, paired};
use crate::object::{ForcesAndTwist, LinearProblem};

impl Segment<'_> {
    /// Whether the load turns along this leg, and its rate vanishes at the load factor `factor`. There a load that moves to and fro along a line
    /// reverses.
    pub(super) fn load_turns_back(&self, factor: f64) -> bool {
        let Trajectory::Turn { load, angle } = &self.trajectory else { return false };
        // The rate of the load is taken as zero below this fraction of the largest rate that the load has while it turns. Rounding of the angle
        // causes a rate of about this magnitude.
        load.rate_at(angle * factor).norm() <= SOLVED_ROUNDING * (load.cosine.norm() + load.sine.norm())
    }

    /// Forces, twist, gaps and their rates at the load factor `factor`. From this load factor on, forces, stretches and twist are also given as
    /// harmonic functions of the load's angle. Returns an error if forces cannot balance the load. If no spring resists some motion, the twist
    /// is the solution nearest to `near`.
    pub(super) fn point_on_turn(
        &self,
        linear_problem: &Arc<LinearProblem>,
        (load, angle): (&Harmonic<Vector>, f64),
        factor: f64,
        near: Option<&Vector>,
    ) -> Result<PathPoint, NoEquilibrium<3>> {
        let turned_load = load.from(angle * factor);
        let at_rest = vec![SVector::zeros(); self.problem.len()];
        let solved = |offsets: &[SVector<f64, 3>], load: &Vector| {
            linear_problem
                .solve(self.problem.sites, offsets, load)
                .map_err(|u| self.unbalanced(factor, u.motion))
        };
        let parts = Harmonic {
            constant: solved(&self.problem.offsets, &turned_load.constant)?,
            cosine: solved(&at_rest, &turned_load.cosine)?,
            sine: solved(&at_rest, &turned_load.sine)?,
        };
        let rate = ForcesAndTwist {
            forces: mapped(&parts.sine.forces, &|force| force * angle),
            twist: &parts.sine.twist * angle,
        };
        let at = self.state(linear_problem, factor, near).unwrap_or_else(|| at_start(&parts));
        let mut point =
            self.point_with_rates(linear_problem.clone(), factor, at.clone(), (&rate, 1.0), (factor, &at));
        let turned = self.harmonics(&turned_load, angle, &parts);
        // The rounding error of a force or gap is proportional to its largest magnitude over all angles of the load. It does not vanish at an angle
        // at which the force or gap vanishes.
        for ((line, gap), [force, stretch]) in point.lines.iter_mut().zip(&mut point.gaps).zip(&turned.waves)
        {
            line.force_size = line.force_size.max(force.size);
            line.rate_size = line.rate_size.max(force.turning_size * angle);
            gap.size = gap.size.max(stretch.size);
            gap.rate_size = gap.rate_size.max(stretch.turning_size * angle);
        }
        let most = |k: usize| {
            let of = |waves: &[Wave; 2]| [waves[k].size, waves[k].turning_size * angle];
            turned.waves.iter().map(of).fold([0.0_f64; 2], |a, b| [a[0].max(b[0]), a[1].max(b[1])])
        };
        for k in 0..2 {
            let [size, rate_size] = most(k);
            point.sizes[k] = point.sizes[k].max(size);
            point.rate_sizes[k] = point.rate_sizes[k].max(rate_size);
        }
        point.turned = Some(Arc::new(turned));
        Ok(point)
    }

    /// Forces, spring stretches and twist as harmonic functions of the load's angle, from the solutions `parts` under the three terms of the load.
    /// The solution for the constant term includes the forces due to spring offsets (command minus clearance and slip). `angle` is the angle per unit
    /// of the load factor, rad.
    pub(super) fn harmonics(
        &self,
        load: &Harmonic<Vector>,
        angle: f64,
        parts: &Harmonic<ForcesAndTwist>,
    ) -> TurningState {
        let (sites, problem) = (self.problem.sites, &self.problem);
        let at_rest = vec![SVector::zeros(); sites.len()];
        let states = Harmonic {
            constant: (&problem.offsets, &load.constant, &parts.constant),
            cosine: (&at_rest, &load.cosine, &parts.cosine),
            sine: (&at_rest, &load.sine, &parts.sine),
        };
        let sizes = states.map(|(offsets, load, part)| problem.force_sizes(offsets, load.norm(), part));
        let wave = |i: usize| {
            let turning_size = sizes.cosine[i] + sizes.sine[i];
            let force = Wave {
                of: parts.map(|part| part.forces[i]),
                size: sizes.constant[i] + turning_size,
                turning_size,
            };
            let of = states.map(|(offsets, _, part)| sites[i].stretch(&offsets[i], &part.twist));
            let spans = states.map(|(offsets, _, part)| sites[i].span(&offsets[i], &part.twist));
            let turning_size = spans.cosine + spans.sine;
            // The magnitude to which the rounding error of a stretch is proportional includes the accumulated slip, which is subtracted from the
            // command. If slip and command cancel, their rounding errors do not.
            let size = problem.slips[i].norm() + spans.constant + turning_size;
            [force, Wave { of, size, turning_size }]
        };
        let waves = numbered(sites.len(), &wave);
        TurningState { waves, twist: parts.map(|part| part.twist.clone()), load: load.clone(), angle }
    }
}

/// Forces and twist at the load's angle zero: the sum of the solutions in `parts` under the constant and the cosine term of the load.
pub(super) fn at_start(parts: &Harmonic<ForcesAndTwist>) -> ForcesAndTwist {
    let Harmonic { constant, cosine, .. } = parts;
    let forces = paired(&constant.forces, &cosine.forces, &|(f, more)| f + more);
    ForcesAndTwist { forces, twist: &constant.twist + &cosine.twist }
}
