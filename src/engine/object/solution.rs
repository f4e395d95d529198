//! Contact forces and twist that solve the linear problem of a [`LinearProblem`], accurate to the last digits.
//!
//! Spring r of contact i is stretched along a vector s_r and pushes along p_r; each vector contains the square root of the spring's stiffness. x_r is
//! the scaled spring force: the force divided by this root. The offset a_i of contact i is its commanded displacement minus clearance and slip. G_i
//! is the grasp map, q the twist and W the load. Each spring has a residual e_r, and equilibrium has a residual ρ. They are evaluated in twice the
//! working precision, and the linear problem is solved for them again (iterative refinement):
//!
//! ```text
//! e_r = s_r · (a_i - G_iᵀ q) - x_r,      ρ = Σ G_i p_r x_r + W
//! ```

use nalgebra::SVector;

use super::free_motions::motion_of_work;
use super::linear_problem::{LinearProblem, OrthogonalFactors};
use super::load::Load;
use super::precise::{PreciseBalance, PreciseTwist};
use super::problem::Problem;
use super::tolerances::{MOST_CORRECTIONS, NEARLY_CORRECTED, NO_WORK};
use crate::grasp::Site;
use crate::numerics::{DoubleDouble, IntoList, Vector, cleared_for, without};
use crate::prelude::*;

/// Contact forces and twist that solve the linear problem of a [`LinearProblem`] under given offsets and a given load. For the rate problem
/// (derivatives along a load path) they are rates.
#[derive(Debug, Clone)]
pub(crate) struct ForcesAndTwist {
    /// The contact force F_i of each contact in its contact frame, N.
    pub(crate) forces: Vec<SVector<f64, 3>>,
    /// The twist about the centroid of the contacts, with arms in the engine's unit of length; of least norm if some motions stretch no spring.
    pub(crate) twist: Vector,
}

impl Default for ForcesAndTwist {
    fn default() -> Self {
        Self { forces: Vec::new(), twist: Vector::zeros() }
    }
}

/// Scratch buffers that repeated solves use again: the scaled spring forces `x`, and their corrections `change` in a refinement step.
#[derive(Debug, Clone, Default)]
pub(crate) struct SolutionMemory {
    x: Vec<f64>,
    change: Vec<f64>,
}

/// The error if the linear problem of a [`LinearProblem`] has no solution under the given offsets and load.
#[derive(Debug, Clone)]
pub(crate) struct Unbalanced {
    /// A unit motion along which the load does work and no spring pushes. `None` if there is no such motion, but sliding contacts push in directions
    /// that cannot balance offsets and load.
    pub(crate) motion: Option<Vector>,
}

impl LinearProblem {
    /// Contact forces and the twist of least norm under these offsets and this load; [`Unbalanced`] if no forces balance the load. `sites` are the
    /// contacts, and the drives of joints and tendons, from which this [`LinearProblem`] was made.
    pub(crate) fn solve(
        &self,
        sites: &[Site],
        offsets: &[SVector<f64, 3>],
        load: impl Into<Load>,
    ) -> Result<ForcesAndTwist, Unbalanced> {
        let mut state = ForcesAndTwist::default();
        self.solve_into(sites, offsets, &load.into(), (&mut SolutionMemory::default(), &mut state))?;
        Ok(state)
    }

    /// Contact forces and the twist of least norm under these offsets and this load, written to `state`, with scratch buffers `memory`.
    /// [`Unbalanced`] if no forces balance the load.
    pub(crate) fn solve_into(
        &self,
        sites: &[Site],
        offsets: &[SVector<f64, 3>],
        load: &Load,
        (memory, state): (&mut SolutionMemory, &mut ForcesAndTwist),
    ) -> Result<(), Unbalanced> {
        if let Some(motion) = motion_of_work(&self.unbalanced, &load.wrench) {
            return Err(Unbalanced { motion: Some(motion) });
        }
        let SolutionMemory { x, change } = memory;
        if let Some((band, null)) = &self.band {
            self.stretched_into(x, &|contact| offsets[contact]);
            if null.are_out_of_reach(x, &load.wrench, &|| band.growth()) {
                return Err(Unbalanced { motion: None });
            }
            let mut twist = PreciseTwist::new(self.size(), band.respond(x, &load.wrench));
            let respond = |x: &mut [f64], rest: &Vector| band.respond(x, rest);
            // With band factors each correction is a constant part of the one before, and this part need not be small. Refinement therefore continues
            // until a correction is at most 1e-15 of the largest force.
            if self.refine(sites, (offsets, load), (x, change, &mut twist), (respond, 1e-15)) {
                state.twist = without(twist.value(), &self.free);
                self.forces_into(&mut state.forces, x, offsets.len());
                return Ok(());
            }
        }
        let factors = self.orthogonal();
        let balance = factors.balance();
        self.stretched_into(x, &|contact| offsets[contact]);
        let loaded = balance.load_coordinates(&load.wrench);
        let pushed = balance.coordinates(x);
        let step = match &factors.pushes {
            None => pushed + &loaded,
            Some((_, coupling)) => {
                let (step, unreached) = coupling.solve(&(&pushed + &loaded));
                // `unreached` is the part of the generalised forces of springs (`pushed`) and load (`loaded`) that the springs cannot take up. It is
                // taken as zero if rounding of the larger of `pushed` and `loaded` may cause it.
                let known = NO_WORK * pushed.amax().max(loaded.amax());
                if unreached > known && unreached > known * coupling.growth() {
                    return Err(Unbalanced { motion: None });
                }
                step
            }
        };
        factors.stretches.subtract(x, &step);
        let mut twist = PreciseTwist::new(self.size(), factors.stretches.preimage(&step));
        let respond = |x: &mut [f64], rest: &Vector| factors.respond(x, rest);
        self.refine(sites, (offsets, load), (x, change, &mut twist), (respond, NEARLY_CORRECTED));
        state.twist = without(twist.value(), &self.free);
        self.forces_into(&mut state.forces, x, offsets.len());
        Ok(())
    }

    /// Iterative refinement of `x` and `twist`, in at most [`MOST_CORRECTIONS`] steps. Returns true if a correction is small enough. The first
    /// correction must be at most the fraction [`NEARLY_CORRECTED`] of the largest force, a later one at most the fraction `sharp`.
    fn refine(
        &self,
        sites: &[Site],
        (offsets, load): (&[SVector<f64, 3>], &Load),
        (x, change, twist): (&mut [f64], &mut Vec<f64>, &mut PreciseTwist),
        (respond, sharp): (impl Fn(&mut [f64], &Vector) -> Vector, f64),
    ) -> bool {
        cleared_for(change, x.len());
        change.resize(x.len(), 0.0);
        for step in 0..MOST_CORRECTIONS {
            let rest = self.excess(sites, (offsets, load), (x, twist), change);
            twist.add(&respond(change, &rest));
            let (mut largest, mut changed) = (0.0_f64, 0.0_f64);
            for ((x, change), spring) in x.iter_mut().zip(change.iter()).zip(&self.springs) {
                *x += change;
                let push = spring.push_direction.amax();
                largest = largest.max(push * x.abs());
                changed = changed.max(push * change.abs());
            }
            if changed <= (if step == 0 { NEARLY_CORRECTED } else { sharp }) * largest {
                return true;
            }
        }
        false
    }

    /// Contact forces and twist without iterative refinement, if all contacts stick and springs resist every motion. The object is moved twice until
    /// forces balance: the second motion removes the rounding error of the first. Forces are then wrong by a few roundings of the largest force.
    pub(crate) fn solve_roughly(&self, offsets: &[SVector<f64, 3>], wrench: &Vector) -> ForcesAndTwist {
        let mut state = ForcesAndTwist::default();
        self.solve_roughly_into(offsets, wrench, (&mut SolutionMemory::default(), &mut state));
        state
    }

    /// Contact forces and twist without iterative refinement ([`Self::solve_roughly`]), written to `state`, with a scratch buffer.
    pub(crate) fn solve_roughly_into(
        &self,
        offsets: &[SVector<f64, 3>],
        wrench: &Vector,
        (SolutionMemory { x, .. }, state): (&mut SolutionMemory, &mut ForcesAndTwist),
    ) {
        self.stretched_into(x, &|contact| offsets[contact]);
        if let Some((band, _)) = &self.band {
            let travelled = band.respond(x, wrench);
            state.twist = travelled + band.respond(x, wrench);
            self.forces_into(&mut state.forces, x, offsets.len());
            return;
        }
        let stretches = self.factor();
        let load = stretches.load_coordinates(wrench);
        let mut travelled = Vector::zeros();
        for _ in 0..2 {
            let step = stretches.coordinates(x) + &load;
            stretches.subtract(x, &step);
            travelled += &step;
        }
        state.twist = stretches.preimage(&travelled);
        self.forces_into(&mut state.forces, x, offsets.len());
    }

    /// Moves the object until forces balance the load W. The scaled spring forces x become `x - A q` with the returned twist `q = (BᵀA)⁻¹ (Bᵀx + W)`.
    /// A has the spring stretches under a motion, and B the push directions.
    pub(super) fn respond(&self, x: &mut [f64], wrench: &Vector) -> Vector {
        match &self.band {
            Some((band, _)) => band.respond(x, wrench),
            None => self.orthogonal().respond(x, wrench),
        }
    }

    /// Contact forces after the object has moved until they balance the load. `stretches` are the stretches of the contacts before the object
    /// moves, m. A component of the load that springs cannot balance is ignored.
    pub(crate) fn forces_of(&self, stretches: &[SVector<f64, 3>], load: &Vector) -> Vec<SVector<f64, 3>> {
        let mut x = self.stretched(&|contact| stretches[contact]);
        self.respond(&mut x, load);
        self.forces(&x, stretches.len())
    }

    /// Change of the contact forces if the object moves by `motion` at constant offsets and contact states.
    pub(crate) fn forces_along(&self, problem: &Problem, motion: &Vector) -> Vec<SVector<f64, 3>> {
        let x = self.stretched(&|contact| -problem.sites[contact].map.tr_mul(motion));
        self.forces(&x, problem.len())
    }

    /// The scaled force `x_r = s_r · v` of each spring r, for given stretches v of the contacts; s_r is the vector along which the spring is
    /// stretched.
    pub(super) fn stretched(&self, stretch: &dyn Fn(usize) -> SVector<f64, 3>) -> Vec<f64> {
        let mut x = Vec::new();
        self.stretched_into(&mut x, stretch);
        x
    }

    fn stretched_into(&self, x: &mut Vec<f64>, stretch: &dyn Fn(usize) -> SVector<f64, 3>) {
        cleared_for(x, self.springs.len());
        for (contact, springs, _) in self.of_each_contact() {
            let stretch = stretch(contact);
            springs.iter().map(|spring| spring.stretch_direction.dot(&stretch)).append_to(x);
        }
    }

    fn forces(&self, x: &[f64], contacts: usize) -> Vec<SVector<f64, 3>> {
        let mut forces = Vec::new();
        self.forces_into(&mut forces, x, contacts);
        forces
    }

    fn forces_into(&self, forces: &mut Vec<SVector<f64, 3>>, x: &[f64], contacts: usize) {
        cleared_for(forces, contacts);
        forces.resize(contacts, SVector::zeros());
        for (contact, springs, range) in self.of_each_contact() {
            for (spring, x) in springs.iter().zip(&x[range]) {
                forces[contact] += spring.push_direction * *x;
            }
        }
    }

    /// Writes the residual of each spring r into `e`: `e_r = s_r · (a_i - G_iᵀ q) - x_r`. Here x_r is the scaled spring force, a_i the offset of
    /// its contact and q the twist. Returns the residual of equilibrium under the load W, `ρ = Σ G_i p_r x_r + W`.
    fn excess(
        &self,
        sites: &[Site],
        (offsets, load): (&[SVector<f64, 3>], &Load),
        (x, twist): (&[f64], &PreciseTwist),
        e: &mut [f64],
    ) -> Vector {
        let mut balance = PreciseBalance::new(self.size(), load);
        for (contact, springs, range) in self.of_each_contact() {
            let (site, x) = (&sites[contact], &x[range.clone()]);
            // The residuals of this contact's springs. It has at most three springs, one per axis.
            let mut left = [DoubleDouble::default(); 3];
            for (left, x) in left.iter_mut().zip(x) {
                left.add(-x);
            }
            for a in 0..3 {
                // Axes along which no spring of the contact is stretched are skipped; most springs lie along one axis.
                if springs.iter().any(|spring| spring.stretch_direction[a] != 0.0) {
                    let v = twist.stretch(site, a, offsets[contact][a]);
                    for (left, spring) in
                        left.iter_mut().zip(springs).filter(|(_, s)| s.stretch_direction[a] != 0.0)
                    {
                        left.add_product_of_twice(
                            (spring.stretch_direction[a], spring.stretch_direction_error[a]),
                            v,
                        );
                    }
                }
                let mut force = DoubleDouble::default();
                for (spring, &x) in springs.iter().zip(x).filter(|(s, _)| s.push_direction[a] != 0.0) {
                    force.add_product_of_twice(
                        (spring.push_direction[a], spring.push_direction_error[a]),
                        DoubleDouble::new(x),
                    );
                }
                if force.high != 0.0 {
                    balance.add(site, a, force);
                }
            }
            for (e, left) in e[range].iter_mut().zip(left) {
                *e = left.value();
            }
        }
        balance.value()
    }
}

impl OrthogonalFactors {
    /// Moves the object until forces balance. The scaled spring forces x become `x - Q_A (Q_BᵀQ_A)⁻¹ (Q_Bᵀx + R_B⁻ᵀW)` under the load W. The matrices
    /// of stretches and push directions are A = Q_A R_A and B = Q_B R_B. Returns the twist of this motion.
    fn respond(&self, x: &mut [f64], wrench: &Vector) -> Vector {
        let balance = self.balance();
        let excess = balance.coordinates(x) + balance.load_coordinates(wrench);
        let step = match &self.pushes {
            None => excess,
            Some((_, coupling)) => coupling.solve(&excess).0,
        };
        self.stretches.subtract(x, &step);
        self.stretches.preimage(&step)
    }
}
