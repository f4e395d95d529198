//! The motion with which the object leaves at gross slip (the loss of the object). From it follow the derivatives of the load factor at gross slip
//! with respect to the parameters that are sought, such as coefficients of friction. The load factor is a multiple of the observed load.
//!
//! Let W₀ be the constant load and W the growing load. At contact i, nᵢ is the wrench of a unit force along the normal; the columns of Tᵢ are the
//! wrenches of unit forces along the tangents. The contact has the coefficient of friction μᵢ, the normal force Nᵢ and the normal stiffness kᵢ. If
//! the last motion m of the object opens no contact, normal forces stay constant while the object leaves, and friction opposes the sliding velocity
//! vᵢ. The load factor λ at gross slip is then a root of
//!
//! ```text
//! W₀ + λ W + Σ (nᵢ − μᵢ Tᵢ vᵢ/|vᵢ|) Nᵢ + Σ Tⱼ fⱼ = 0,   vᵢ = Tᵢᵀ m,   nᵢᵀ m = 0,   Tⱼᵀ m = 0
//! ```
//!
//! The first sum is over the contacts i that press. The second sum is over the contacts j that stick, whose velocity is zero. The unknowns of the
//! equations are λ, the direction of m, the tangential forces fⱼ, and the displacement y that has changed the normal forces: dNᵢ = −kᵢ nᵢᵀ dy. There
//! are as many equations as unknowns. Newton's method starts from the equilibrium at the end of the load path. The root and its exact derivatives do
//! not depend on the path, and hence not on tangential springs and tangential commands.

use nalgebra::{DMatrix, DVector, SVector};

use super::model::SlipToPredict;
use super::pressing::{Pressing, at_length, pressing};
use super::tolerances::INDISTINCT;
use super::unknown::{UnknownKind, carried_by};
use crate::grasp::{Space, Twist, Wrench};
use crate::numerics::tolerances::{NEGLIGIBLE, SOLVED_ROUNDING};
use crate::numerics::{Singular, largest, mapped, matrix_of, summed};
use crate::prelude::*;

/// The equilibrium of the object and its pressing contacts at gross slip, as a root of the equations at the top of this file. Moments are divided by
/// `length`, rotations multiplied by it.
pub(super) struct GrossSlip<'a, 's> {
    target: &'a SlipToPredict<'s>,
    /// The length that makes moments and rotations comparable with forces and displacements, m: the distance of the farthest contact from the origin.
    length: f64,
    /// The load factor at gross slip; for a turning load the angle, rad.
    at: f64,
    motion: DVector<f64>,
    pressing: Vec<Pressing>,
}

impl<'a, 's> GrossSlip<'a, 's> {
    /// The equilibrium at gross slip, from the load factor, motion and forces at the end of a load path. `None` if a pressing contact opens as the
    /// object leaves. Also `None` if the equations at the top of this file do not describe the grasp or have no root near the end of the path.
    pub(super) fn from_end(
        target: &'a SlipToPredict<'s>,
        at: f64,
        motion: &Twist<3>,
        forces: &[SVector<f64, 3>],
    ) -> Option<Self> {
        let contacts = target.grasp.contacts();
        let space = target.grasp.engine.space();
        let is_round = space == Space::Planar || target.grasp.settings().round;
        if !is_round || !target.is_pressed_by_commands() || forces.len() != contacts.len() {
            return None;
        }
        let farthest = largest(contacts, &|contact| contact.point.norm());
        let length = if farthest > 0.0 { farthest } else { 1.0 };
        let motion = at_length(space, &motion.coordinates(space), length);
        let mut pressing = pressing(target, forces, length);
        let fastest = largest(&pressing, &|contact| contact.velocity(&motion).norm());
        for contact in &mut pressing {
            let opens = contact.normal.dot(&motion).abs() > INDISTINCT * fastest;
            if opens {
                return None;
            }
            contact.sticks |=
                contact.friction > 0.0 && contact.velocity(&motion).norm() <= INDISTINCT * fastest;
        }
        Self { target, length, at, motion, pressing }.at_root()
    }

    /// Solves the equilibrium equations at the top of this file by Newton's method. `None` unless it converges to a root in which all contacts press,
    /// and whose load factor equals, up to rounding, that at the end of the load path.
    fn at_root(mut self) -> Option<Self> {
        let began_at = self.at;
        let (_, free) = spaces(&self.fixed_directions(), self.motion.len());
        self.motion = (&free * free.tr_mul(&self.motion)).try_normalize(0.0)?;
        // The start is near the root and convergence is quadratic, so that five steps are enough.
        for _ in 0..5 {
            if self.is_root() {
                break;
            }
            let equations = Equations::of(&self)?;
            let step = equations.solved(&-self.residual());
            self.take_step(&equations, &step);
        }
        let presses =
            |contact: &Pressing| contact.normal_force > 0.0 || (contact.may_pull && !contact.slides());
        let is_here =
            (self.at - began_at).abs() <= INDISTINCT * began_at && self.pressing.iter().all(presses);
        (self.is_root() && is_here).then_some(self)
    }

    fn is_root(&self) -> bool {
        let forces: f64 = summed(&self.pressing, &|contact| contact.normal_force.abs());
        self.residual().norm() <= SOLVED_ROUNDING * forces
    }

    /// Directions in which the object does not move as it leaves: along the normals of pressing contacts, and along the tangents of contacts that
    /// stick.
    fn fixed_directions(&self) -> Vec<DVector<f64>> {
        let mut fixed_directions = Vec::new();
        for contact in &self.pressing {
            fixed_directions.push(contact.normal.clone());
            if contact.sticks {
                fixed_directions.extend(contact.tangents.column_iter().map(nalgebra::Matrix::into_owned));
            }
        }
        fixed_directions
    }

    fn stuck(&mut self) -> impl Iterator<Item = &mut Pressing> {
        self.pressing.iter_mut().filter(|contact| contact.sticks)
    }

    /// The sum of the wrenches that loads and pressing contacts exert on the object; zero in equilibrium.
    fn residual(&self) -> DVector<f64> {
        let mut sum = self.one_length(&self.target.load_at(self.at));
        for contact in &self.pressing {
            sum += contact.by_newton(&self.motion) * contact.normal_force;
            if contact.sticks {
                sum += &contact.tangents * &contact.held;
            }
        }
        sum
    }

    fn one_length(&self, load: &Wrench<3>) -> DVector<f64> {
        let space = self.target.grasp.engine.space();
        at_length(space, &load.coordinates(space), self.length.recip())
    }

    /// Adds a Newton step to the unknowns of the equations: normal forces, motion, tangential forces of sticking contacts and load factor.
    fn take_step(&mut self, equations: &Equations, step: &DVector<f64>) {
        let (springs, turns) = (equations.springs.ncols(), equations.turns.ncols());
        let y = &equations.springs * step.rows(0, springs).into_owned();
        for contact in &mut self.pressing {
            contact.normal_force -= contact.stiffness * contact.normal.dot(&y);
        }
        self.motion += &equations.turns * step.rows(springs, turns).into_owned();
        self.motion.normalize_mut();
        let mut row = springs + turns;
        for contact in self.stuck() {
            let tangents = contact.held.len();
            contact.held += step.rows(row, tangents);
            row += tangents;
        }
        self.at += step[step.len() - 1];
    }

    /// Derivatives of the logarithm of the load factor (or angle) at gross slip with respect to the logarithms of the parameters. `None` if the load
    /// factor has a kink here, as a function of the parameters. The linearised equations then have no solution for a change of some parameter.
    pub(super) fn derivatives(&self) -> Option<Vec<f64>> {
        let equations = Equations::of(self)?;
        self.target.by_unknowns(&|kind, unknown, value| {
            let change = self.change(kind, unknown, value);
            let step = equations.solved(&-&change);
            let misses = (&equations.matrix * equations.scaled(&step) + &change).norm();
            (misses <= INDISTINCT * change.norm()).then(|| step[step.len() - 1] / self.at)
        })
    }

    /// The derivative of the sum of wrenches, [`Self::residual`], with respect to the logarithm of a parameter with this kind, index and value.
    fn change(&self, kind: UnknownKind, unknown: usize, value: f64) -> DVector<f64> {
        let mut sum = DVector::zeros(self.motion.len());
        let contacts = self.target.grasp.contacts();
        let carried = self.target.contacts_of(unknown).filter(|_| kind == UnknownKind::Carried);
        for i in carried {
            sum += self.one_length(&carried_by(&contacts[i], value));
        }
        let is_meant = |i: usize| self.target.contacts_of(unknown).any(|j| j == i);
        for pressing in self.pressing.iter().filter(|pressing| is_meant(pressing.contact)) {
            let pressed = match kind {
                UnknownKind::Carried => value,
                UnknownKind::Squeeze => pressing.stiffness * contacts[pressing.contact].command[0],
                UnknownKind::Friction | UnknownKind::Stiffness => 0.0,
            };
            sum += pressing.by_newton(&self.motion) * pressed;
            if kind == UnknownKind::Friction && pressing.slides() {
                sum += pressing.friction_wrench(&self.motion) * pressing.normal_force;
            }
        }
        sum
    }
}

/// The linearised equations of equilibrium at gross slip. Their unknowns are small changes of the displacement y, of the direction of the motion m,
/// of the tangential forces of sticking contacts, and of the load factor.
struct Equations {
    /// Orthonormal basis of the displacements y that change normal forces, as columns.
    springs: DMatrix<f64>,
    /// Orthonormal basis of the possible changes of the direction of the motion m, as columns.
    turns: DMatrix<f64>,
    /// The matrix of the linearised equations with columns scaled to length one.
    matrix: DMatrix<f64>,
    /// The factors by which the columns of `matrix` were multiplied.
    scales: DVector<f64>,
    /// The singular value decomposition of `matrix`.
    parts: Singular,
}

impl Equations {
    /// Linearises the equations at the equilibrium `leaving`. `None` if they do not determine the load factor, or a number overflows.
    fn of(leaving: &GrossSlip<'_, '_>) -> Option<Self> {
        let (size, motion, pressing) = (leaving.motion.len(), &leaving.motion, &leaving.pressing);
        let normals: Vec<_> = mapped(pressing, &|contact| contact.normal.clone());
        let (springs, _) = spaces(&normals, size);
        let mut fixed_directions = leaving.fixed_directions();
        fixed_directions.push(motion.clone());
        let (_, turns) = spaces(&fixed_directions, size);
        let mut columns: Vec<DVector<f64>> = Vec::new();
        for y in springs.column_iter() {
            let y = y.into_owned();
            let mut sum = DVector::zeros(size);
            for contact in pressing {
                sum += contact.by_newton(motion) * (-contact.stiffness * contact.normal.dot(&y));
            }
            columns.push(sum);
        }
        for by in turns.column_iter() {
            let (by, mut sum) = (by.into_owned(), DVector::zeros(size));
            for contact in pressing {
                if contact.slides() {
                    sum += contact.turning(motion, &by);
                }
            }
            columns.push(sum);
        }
        for contact in pressing {
            if contact.sticks {
                columns.extend(contact.tangents.column_iter().map(nalgebra::Matrix::into_owned));
            }
        }
        columns.push(leaving.one_length(&leaving.target.load_rate(leaving.at)));
        let mut scales = DVector::zeros(columns.len());
        for (column, scale) in columns.iter_mut().zip(scales.iter_mut()) {
            *scale = if column.norm() > 0.0 { column.norm().recip() } else { 0.0 };
            *column *= *scale;
        }
        let matrix = DMatrix::from_columns(&columns);
        // Extreme data may overflow; a matrix with infinite entries has no decomposition.
        if !matrix.iter().all(|x| x.is_finite()) {
            return None;
        }
        let parts = Singular::new(&matrix);
        let last = columns.len() - 1;
        let component = parts.solve(&columns[last], NEGLIGIBLE)[last];
        ((component - 1.0).abs() <= INDISTINCT).then_some(Self { springs, turns, matrix, scales, parts })
    }

    /// The solution of the linearised equations for the right-hand side `change`. Among least-squares solutions it has the least norm, each unknown
    /// of the equations measured in the unit in which its column of `matrix` has length one.
    fn solved(&self, change: &DVector<f64>) -> DVector<f64> {
        self.parts.solve(change, NEGLIGIBLE).component_mul(&self.scales)
    }

    /// Converts a Newton step of the unknowns of the equations (y, m, fⱼ and λ) to the units in which the columns of `matrix` have length one.
    fn scaled(&self, step: &DVector<f64>) -> DVector<f64> {
        step.zip_map(&self.scales, |x, scale| if scale > 0.0 { x / scale } else { 0.0 })
    }
}

/// Orthonormal bases, as columns, of the span of the given directions and of its orthogonal complement.
fn spaces(directions: &[DVector<f64>], size: usize) -> (DMatrix<f64>, DMatrix<f64>) {
    let matrix = matrix_of(directions.len(), size, &|i, j| directions[i][j]);
    let parts = Singular::new(&matrix);
    let mut spanned = 0;
    while spanned < size && parts.values[spanned] > NEGLIGIBLE * parts.values[0] {
        spanned += 1;
    }
    let all = parts.right;
    (all.columns(0, spanned).into_owned(), all.columns(spanned, size - spanned).into_owned())
}
