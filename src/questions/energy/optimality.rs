//! The optimality conditions of the quadratic program of minimum energy on orthogonal factors, and their solution. A constraint binds at a point if
//! it holds there as an equality. All springs act, except the normal springs of contacts whose gap is open.
//!
//! Let K be the stiffness, a the offsets of the contacts, G the grasp map and q the motion of the object. The offset is the command (displacement
//! that the finger would make if there were no object) less the clearance. A = K^{1/2}Gᵀ has an orthogonal factor Q and a triangular factor R, A =
//! QR, and Π = QQᵀ. Energy coordinates x = K^{-1/2} F replace the contact forces F. If everything sticks, the motion is q⁰ and the forces are, in
//! these coordinates, x⁰ = K^{1/2}(a - Gᵀq⁰). Scaled gaps ĝ = √k_n g, with the gaps g and normal stiffnesses k_n, act along the columns of E. The
//! friction constraints are N x >= 0 with a matrix N whose rows have unit length; in this file newtons are never written as N. The quadratic program
//! is
//!
//! ```text
//! minimise ½|p|² - pᵀQᵀE ĝ + ½|ĝ|² + x⁰ᵀE ĝ      x = x⁰ - Q p + E ĝ,   p = R (q - q⁰)
//! subject to ĝ >= 0, N x >= 0
//! ```
//!
//! Its optimality conditions, without p, are a linear complementarity problem with the multipliers λ of the friction constraints, and with a positive
//! semidefinite matrix:
//!
//! ```text
//! 0 <= ĝ  ⟂  Eᵀx⁰ + Eᵀ(1 - Π)E ĝ - Eᵀ(1 - Π)Nᵀλ >= 0
//! 0 <= λ  ⟂   N x⁰ +  N(1 - Π)E ĝ +       N Π Nᵀλ >= 0
//! x = x⁰ + (1 - Π) E ĝ + Π Nᵀλ
//! ```
//!
//! Multipliers enter the forces through Π: they act on the **object** like an external force. They leave the imbalance `Aᵀx + W = AᵀNᵀλ` of forces,
//! with the load W; the minimum is an equilibrium exactly if this imbalance is zero. Under Coulomb's law slips enter through 1 - Π instead, and
//! preserve the balance.
//!
//! Lemke's method finds the open gaps and the binding friction constraints. The answer is then computed from the remaining springs, so that it does
//! not depend on the rounding of the pivots. Every condition of the minimum is checked.

use nalgebra::{DMatrix, DVector, SVector};

use super::energy_rows::{ForceCondition, axis_springs, by_pivots, dense, rows, values};
use crate::Settings;
use crate::lcp::{Basis, Outcome};
use crate::numerics::tolerances::SOLVED_ROUNDING;
use crate::numerics::{IntoList, Reals, Singular, Vector, mapped, numbered};
use crate::object::{ForcesAndTwist, LinearProblem, Problem};
use crate::prelude::*;

/// The quadratic program in energy coordinates. `gaps` are the conditions F_n >= 0 of contacts whose gap may open, `friction` the friction
/// constraints that may bind. `stuck` are the springs while everything sticks.
pub(super) struct EnergyProgram<'g> {
    pub(super) problem: Problem<'g>,
    pub(super) stuck: LinearProblem,
    pub(super) gaps: Vec<ForceCondition>,
    pub(super) friction: Vec<ForceCondition>,
}

/// Which constraints bind at a point of the quadratic program. For each contact, `open` is true if its gap is open, so that ĝ >= 0 does not bind.
/// `binding` has the index in [`EnergyProgram::friction`] of each friction constraint that binds.
#[derive(Debug, Clone)]
pub(super) struct Faces {
    pub(super) open: Vec<bool>,
    pub(super) binding: Vec<usize>,
}

/// A candidate for the minimum of energy: contact forces, motion of the object, gaps, multipliers, and motions that stretch no acting spring.
#[derive(Debug, Clone)]
pub(super) struct ProgramPoint {
    pub(super) forces: Vec<SVector<f64, 3>>,
    pub(super) twist: Vector,
    pub(super) gaps: Vec<f64>,
    /// Multipliers of all friction constraints, each constraint scaled to a normal of unit length.
    pub(super) multipliers: Vec<f64>,
    pub(super) free: Vec<Vector>,
}

pub(super) enum NotOptimal {
    NoMinimum,
    Unsolved,
}

impl<'g> EnergyProgram<'g> {
    pub(super) fn new(problem: Problem<'g>) -> Self {
        let stuck = axis_springs(problem.sites, &|_, _| true);
        Self {
            gaps: rows(&problem, &stuck, &|local| local.may_open() && !local.never_slides(), false),
            friction: rows(&problem, &stuck, &|local| local.may_open() && local.never_slides(), true),
            problem,
            stuck,
        }
    }

    fn rows(&self) -> impl Iterator<Item = &ForceCondition> {
        self.gaps.iter().chain(&self.friction)
    }

    /// The vector of the linear complementarity problem: Eᵀx⁰ for the gaps, then N x⁰ for the friction constraints, with the symbols of the head of
    /// this file. `stuck` are the contact forces if everything sticks, in newtons.
    pub(super) fn vector(&self, stuck: &[SVector<f64, 3>]) -> DVector<f64> {
        values(self.rows(), stuck)
    }

    /// The matrix of the linear complementarity problem; `None` for more than 10 000 rows.
    pub(super) fn matrix(&self) -> Option<DMatrix<f64>> {
        let rows: Vec<_> = self.rows().list();
        let gaps = self.gaps.len();
        dense(rows.len(), |i, j| match (i < gaps, j < gaps) {
            (_, true) => rows[i].past_the_object(rows[j]),
            (true, false) => -rows[i].past_the_object(rows[j]),
            (false, false) => rows[i].through_the_object(rows[j]),
        })
    }

    /// The open gaps and binding friction constraints that Lemke's method finds, the number of pivots, and the motion of the object in this solution.
    pub(super) fn faces(
        &self,
        stuck: &ForcesAndTwist,
        settings: &Settings,
    ) -> Result<(Faces, usize, Vector), NotOptimal> {
        let matrix = self.matrix().ok_or(NotOptimal::Unsolved)?;
        match by_pivots(matrix, self.vector(&stuck.forces), settings) {
            Some(Outcome::Solved(solution)) => {
                let mut travelled = Vector::zeros();
                for (i, (row, z)) in self.rows().zip(solution.z.iter()).enumerate() {
                    travelled.add_times(&row.rows_of_factor, if i < self.gaps.len() { *z } else { -z });
                }
                let near = &stuck.twist + self.stuck.motion(&travelled);
                Ok((self.faces_of(&solution.basis), solution.pivots, near))
            }
            Some(outcome) if outcome.is_infeasible() => Err(NotOptimal::NoMinimum),
            _ => Err(NotOptimal::Unsolved),
        }
    }

    pub(super) fn faces_of(&self, basis: &Basis) -> Faces {
        let mut faces = Faces { open: vec![false; self.problem.len()], binding: Vec::new() };
        for row in basis.iter() {
            match self.gaps.get(row) {
                Some(gap) => faces.open[gap.contact] = true,
                None => faces.binding.push(row - self.gaps.len()),
            }
        }
        faces
    }

    /// The acting springs: all but the normal springs of contacts whose gap is open.
    pub(super) fn springs(&self, faces: &Faces) -> LinearProblem {
        axis_springs(self.problem.sites, &|contact, axis| axis > 0 || !faces.open[contact])
    }

    /// The candidate for the minimum with all contacts sticking; `stuck` has its forces and motion.
    pub(super) fn sticking(&self, stuck: &ForcesAndTwist) -> ProgramPoint {
        ProgramPoint {
            forces: stuck.forces.clone(),
            twist: stuck.twist.clone(),
            gaps: vec![0.0; self.problem.len()],
            multipliers: vec![0.0; self.friction.len()],
            free: self.stuck.free_motions().to_vec(),
        }
    }

    /// The candidate for the minimum with these open gaps and binding friction constraints. `None` if binding constraints are linearly dependent, or
    /// the acting springs do not resist the load. The acting springs may leave motions free; then the motion of least norm is taken. If this motion
    /// makes a gap negative, a free motion is added: the part of `near`, the motion in Lemke's solution, that stretches no acting spring.
    pub(super) fn on_faces(
        &self,
        faces: &Faces,
        stuck: &ForcesAndTwist,
        near: &Vector,
    ) -> Option<ProgramPoint> {
        let problem = &self.problem;
        let opened = faces.open.contains(&true).then(|| self.springs(faces));
        let (springs, ForcesAndTwist { mut forces, mut twist }) = match &opened {
            Some(springs) => (springs, springs.solve(problem.sites, &problem.offsets, problem.load()).ok()?),
            None => (&self.stuck, stuck.clone()),
        };
        let mut multipliers = vec![0.0; self.friction.len()];
        if !faces.binding.is_empty() {
            twist += springs.motion(&self.bind(faces, springs, &mut forces, &mut multipliers)?);
        }
        let gaps_at = |twist: &Vector| -> Vec<f64> {
            let gap = |i: usize| {
                let give = problem.sites[i].springs.deflection_along(0, forces[i][0]);
                if faces.open[i] { give - problem.stretch(i, twist)[0] } else { 0.0 }
            };
            numbered(forces.len(), &gap)
        };
        let mut gaps = gaps_at(&twist);
        let free = springs.free_motions().to_vec();
        if gaps.iter().any(|gap| *gap < 0.0) {
            // Some motions stretch no acting spring, but change open gaps. The motion of Lemke's solution makes no gap negative, so its part along
            // these motions is added.
            twist += free.iter().fold(Vector::zeros(), |sum, v| sum + v * v.dot(near));
            gaps = gaps_at(&twist);
        }
        let finite = forces.iter().flatten().all(|x| x.is_finite());
        finite.then_some(ProgramPoint { forces, twist, gaps, multipliers, free })
    }

    /// Makes the binding friction constraints hold as equalities: N x = 0, with the rows N of these constraints and the forces x in energy
    /// coordinates. On entry `forces` balance the load without regard to the constraints (then x is x'); on return `forces` satisfy them.
    /// `multipliers` receive the multipliers λ of the constraints. Returns the change of the motion q as p = R q, with the triangular factor R of the
    /// acting springs. `None` if constraints are linearly dependent.
    ///
    /// The normal springs of open gaps are removed. The normal component x_n at such a contact is determined by the multipliers λ alone,
    /// `x_n = (Nᵀλ)_n`. Let Q be the orthogonal factor of the acting springs, N_n the columns of N for these normal components, and `M = [N Q, N_n]`.
    /// Then
    ///
    /// ```text
    /// N x' + M Mᵀλ = 0,     x = x' + Q (first part of Mᵀλ)
    /// ```
    ///
    /// These equations are solved on the orthogonal factor of Mᵀ.
    fn bind(
        &self,
        faces: &Faces,
        springs: &LinearProblem,
        forces: &mut [SVector<f64, 3>],
        multipliers: &mut [f64],
    ) -> Option<Vector> {
        let problem = &self.problem;
        let rows: Vec<_> = mapped(&faces.binding, &|&r| &self.friction[r]);
        let rows_of_factor: Vec<_> = numbered(forces.len(), &|i| springs.factor_rows(i));
        let size = problem.size();
        let mut places = size.count()..;
        let place: Vec<_> = faces.open.iter().map(|open| if *open { places.next() } else { None }).list();
        let mut columns = DMatrix::zeros(places.start, rows.len());
        if columns.nrows() < columns.ncols() {
            return None;
        }
        for (mut column, row) in columns.column_iter_mut().zip(&rows) {
            let on_object = &rows_of_factor[row.contact] * row.normal;
            for k in 0..size.count() {
                column[k] = on_object[k];
            }
            if let Some(place) = place[row.contact] {
                column[place] = row.normal[0];
            }
        }
        let parts = Singular::new(&columns);
        if !parts.values.iter().all(|value| *value > 0.0) {
            return None;
        }
        let mut travelled = Vector::zeros();
        // The first pass leaves rounding errors in the equations N x = 0. The second pass solves the same equations for these errors and removes
        // them.
        for _ in 0..2 {
            let (change, lambda) = parts.of_transpose(&-values(rows.iter().copied(), forces));
            let moved = Vector::from_fn(size, |k| change[k]);
            travelled -= &moved;
            for (i, force) in forces.iter_mut().enumerate() {
                let mut x = rows_of_factor[i].tr_mul(&moved);
                if let Some(place) = place[i] {
                    x[0] = change[place];
                }
                *force += x.component_mul(&problem.sites[i].springs.root());
            }
            for (&row, value) in faces.binding.iter().zip(lambda.iter()) {
                multipliers[row] += value;
            }
        }
        Some(travelled)
    }

    /// The forces that the multipliers of the friction constraints exert on the object at each contact, in the contact frames, in newtons.
    pub(super) fn held_from_outside(&self, multipliers: &[f64]) -> Vec<SVector<f64, 3>> {
        let mut held = vec![SVector::zeros(); self.problem.len()];
        for (row, multiplier) in self.friction.iter().zip(multipliers) {
            let root = self.problem.sites[row.contact].springs.root();
            held[row.contact] += row.normal.component_mul(&root) * *multiplier;
        }
        held
    }

    /// Whether a candidate satisfies every condition of the minimum up to rounding: friction constraints, multipliers, gaps and their multipliers.
    pub(super) fn holds(&self, point: &ProgramPoint, faces: &Faces) -> bool {
        let problem = &self.problem;
        let most = problem.largest_force(&point.forces, &point.twist);
        // The multipliers are those of constraints with normals of unit length, so they have the unit of the energy coordinates x = K^{-1/2} F. Their
        // rounding is relative to the largest component of x or the largest multiplier.
        let x = |i: usize| {
            let springs = &problem.sites[i].springs;
            springs.deflection(&point.forces[i]).component_mul(&springs.root()).amax()
        };
        let x_size = (0..problem.len()).map(x).most();
        let largest = point.multipliers.iter().fold(x_size, |most, l| most.max(l.abs()));
        // `push - held`, in newtons, is the multiplier of the condition that a gap is not negative. `push` is the normal force, `held` the normal
        // component of the force that the friction multipliers λ exert. In energy coordinates x the difference is `√k_n (x - Nᵀλ)_n`, with the matrix
        // N of the friction constraints and the normal stiffness k_n.
        let held = self.held_from_outside(&point.multipliers);
        let gap_holds = |row: &ForceCondition| {
            let i = row.contact;
            let (push, held) = (point.forces[i][0], held[i][0]);
            let span = problem.span(i, &point.twist) + problem.sites[i].springs.deflection_along(0, push);
            point.gaps[i] >= -SOLVED_ROUNDING * span
                && (faces.open[i] || push - held >= -SOLVED_ROUNDING * most.max(held.abs()))
        };
        self.friction.iter().all(|row| row.holds(&point.forces, most))
            && point.multipliers.iter().all(|l| *l >= -SOLVED_ROUNDING * largest)
            && self.gaps.iter().all(gap_holds)
    }
}
