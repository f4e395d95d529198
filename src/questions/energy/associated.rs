//! The associated friction law: the convex contact law of many simulators.

use nalgebra::SVector;

use super::energy_rows::{ForceCondition, axis_springs, by_pivots, dense, rows, values};
use super::tolerances::DEPENDENT_DIRECTION;
use crate::Settings;
use crate::contact::{LocalLaw, Spring, tangential};
use crate::error::Error;
use crate::grasp::{Engine, Twist, Wrench};
use crate::lcp::Outcome;
use crate::numerics::tolerances::SOLVED_ROUNDING;
use crate::numerics::{Vector, unit};
use crate::object::{Piece, PieceState, Problem};
use crate::prelude::*;
use crate::proofs::separating_motion;

/// The outcome of a load under the associated law.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub enum AssociatedOutcome<const C: usize> {
    /// A state of rest, with dilation where a contact slides. Each of its conditions holds to 1e-12 of the forces that it compares.
    Rest(Box<AssociatedState<C>>),
    /// No forces in the friction cones balance the load.
    NoBalance,
    /// No answer because of rounding or a limit on pivots or rows. The matrix is dense; more than 10 000 rows are not tried.
    Unsolved,
}

impl<const C: usize> AssociatedOutcome<C> {
    /// The state of rest, if there is one.
    #[must_use]
    pub fn rest(&self) -> Option<&AssociatedState<C>> {
        match self {
            Self::Rest(state) => Some(state),
            _ => None,
        }
    }
}

/// A state of rest under the associated law. Its forces are unique; its twist may not be.
///
/// Contact forces are the point of the friction cones, in equilibrium with the load, with the least complementary energy,
///
/// ```text
/// minimise Σ ½ F_iᵀK_i⁻¹F_i - a_i·F_i     subject to  F_i in its cone,  Σ G_i F_i + W = 0
/// ```
///
/// Equivalently, for the displacement q of the object, each contact force is the point of its cone nearest to the trial force K (a - Gᵀq) in the norm
/// of K⁻¹. The optimality conditions contain jumps along the normals of the **cone** instead of slips along the surface alone: with the rows L of the
/// cone (e_n; μ e_n - h_j)
///
/// ```text
/// F = K (a - Gᵀq + Lᵀz),   0 <= z  ⟂  L F >= 0:        gap = Σ μ z_j,  slip = Σ z_j h_j
/// ```
///
/// A contact that slides by s opens by μ|s| while it still presses. The matrix is symmetric and semidefinite, and there is one set of forces for
/// every load in the friction wrench cone: convenient, but not Coulomb's law. This is the law of complementary-energy contact models (MuJoCo's cone
/// constraints, Drake's SAP) without their regularisation.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct AssociatedState<const C: usize> {
    /// The load of the question.
    pub load: Wrench<C>,
    /// Motion of the object about the origin, m and rad.
    pub twist: Twist<C>,
    /// One entry per contact, in the order of the grasp.
    pub contacts: Vec<AssociatedContact<C>>,
    /// Energy stored in the springs, `Σ ½ F²/k`, J.
    pub stored_energy: f64,
}

/// One contact of an [`AssociatedState`].
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct AssociatedContact<const C: usize> {
    /// Force on the object in the contact frame, N; the first entry is F_n >= 0 unless the contact is bonded or kept closed.
    pub force: SVector<f64, C>,
    /// Distance of the surfaces, m, never negative. Where F_n > 0 it is the dilation μ|s| of this law, which Coulomb's law does not have.
    pub gap: f64,
    /// Slip of the finger over the body in the contact frame, m; its normal component is zero.
    pub slip: SVector<f64, C>,
}

impl<const C: usize> AssociatedContact<C> {
    /// The gap of a contact that presses, else 0, m: an artefact of the law.
    #[must_use]
    pub fn dilation(&self) -> f64 {
        if self.force[0] > 0.0 { self.gap } else { 0.0 }
    }
}

impl Engine {
    /// [`Energy::associated_friction`](crate::ask::Energy::associated_friction).
    pub(crate) fn associated_friction(
        &self,
        load: &Wrench<3>,
        settings: &Settings,
    ) -> Result<AssociatedOutcome<3>, Error> {
        self.refuse_hands("associated_friction")?;
        let law = AssociatedLaw::new(self.on_polygons(load, &settings.cone)?);
        if !law.stuck.resists(&law.problem.wrench) {
            return Ok(AssociatedOutcome::NoBalance);
        }
        let Some((first, binding, near)) = law.solve(settings) else {
            // Every load in the friction wrench cone has a state of rest; a separating motion proves that this load is outside.
            return Ok(match separating_motion(&law.problem) {
                Some(_) => AssociatedOutcome::NoBalance,
                None => AssociatedOutcome::Unsolved,
            });
        };
        // Rows on their edge may have stayed outside the basis. Counted as binding they leave the forces as they are and the twist more freedom.
        let most = law.problem.largest_force(&first.forces, &first.twist);
        let edge: Vec<_> = (0..law.rows.len()).filter(|r| law.rows[*r].binds(&first.forces, most)).collect();
        let more = Some(&edge).filter(|edge| **edge != binding);
        let roomier =
            more.and_then(|edge| law.on_faces(edge, &near)).filter(|state| law.jumps_outwards(state));
        let (state, binding) = roomier.map_or((first, binding), |state| (state, edge));
        Ok(AssociatedOutcome::Rest(Box::new(self.at_rest(load, &law, &state, &binding))))
    }

    fn at_rest(
        &self,
        load: &Wrench<3>,
        law: &AssociatedLaw,
        state: &PieceState,
        binding: &[usize],
    ) -> AssociatedState<3> {
        let contact = |(i, local): (usize, LocalLaw<'_>)| {
            let (force, jump) = (state.forces[i], law.jump(i, state));
            let binds = binding.iter().any(|r| law.rows[*r].contact == i);
            let slips = binds || local.is_frictionless();
            AssociatedContact {
                force,
                gap: if binds { jump[0].max(0.0) } else { 0.0 },
                slip: if slips { tangential(&-jump) } else { SVector::zeros() },
            }
        };
        let stored = self.sites().iter().zip(&state.forces).map(|(site, force)| site.springs.stored(force));
        AssociatedState {
            load: *load,
            twist: self.outside(&state.twist),
            contacts: law.problem.locals().enumerate().map(contact).collect(),
            stored_energy: stored.sum(),
        }
    }
}

/// The associated law for one grasp and load, in inside coordinates.
struct AssociatedLaw<'g> {
    problem: Problem<'g>,
    stuck: Piece,
    rows: Vec<ForceCondition>,
}

impl<'g> AssociatedLaw<'g> {
    fn new(problem: Problem<'g>) -> Self {
        let stuck = axis_springs(problem.sites, &|_, _| true);
        let rows = rows(&problem, &stuck, &|local| local.may_open() && local.facets().is_empty(), true);
        Self { problem, stuck, rows }
    }

    /// A state that satisfies the law, its binding rows, and the twist that the pivots give.
    ///
    /// Lemke's method on `0 <= z ⟂ N x⁰ + N (1 - Π) Nᵀ z >= 0` finds the binding rows. If everything sticks, no row binds.
    fn solve(&self, settings: &Settings) -> Option<(PieceState, Vec<usize>, Vector)> {
        let (rows, problem) = (&self.rows, &self.problem);
        let trial = self.stuck.solve(problem.sites, &problem.drives, problem.load()).ok()?;
        let vector = values(rows, &trial.forces);
        if vector.iter().all(|q| *q >= 0.0) {
            let twist = trial.twist.clone();
            return Some((trial, Vec::new(), twist));
        }
        let matrix = dense(rows.len(), |i, j| rows[i].past_the_object(&rows[j]))?;
        let Outcome::Solved(solution) = by_pivots(matrix, vector, settings)? else { return None };
        let travelled = rows.iter().zip(&solution.z).map(|(row, z)| &row.seen * *z).sum();
        let near = trial.twist + self.stuck.motion(&travelled);
        let binding: Vec<usize> = solution.basis.iter().collect();
        Some((self.on_faces(&binding, &near)?, binding, near))
    }

    /// The state on the faces of the cones where the rows `binding` are active; `None` if it does not satisfy the law. The twist is the least one. If
    /// that lets a contact slip against its force, the free part of `near` is added.
    fn on_faces(&self, binding: &[usize], near: &Vector) -> Option<PieceState> {
        let problem = &self.problem;
        let springs = Piece::of_springs(problem.sites, &|contact, list| {
            let own = binding.iter().map(|r| &self.rows[*r]).filter(|row| row.contact == contact);
            let springs = &problem.sites[contact].springs;
            let along = face(own.map(|row| &row.normal), springs.axes());
            list.extend(along.into_iter().map(|t| Spring::straight(t.component_mul(&springs.root()))));
        });
        let mut state = springs.solve(problem.sites, &problem.drives, problem.load()).ok()?;
        if !self.jumps_outwards(&state) {
            let free = springs.free_motions().iter();
            state.twist += free.fold(Vector::zeros(), |sum, v| sum + v * v.dot(near));
        }
        let most = problem.largest_force(&state.forces, &state.twist);
        self.rows.iter().all(|row| row.holds(&state.forces, most)).then_some(state)
    }

    /// The jump between the surfaces of a contact, m: (gap, -slip).
    fn jump(&self, contact: usize, state: &PieceState) -> SVector<f64, 3> {
        let give = self.problem.sites[contact].springs.give(&state.forces[contact]);
        give - self.problem.stretch(contact, &state.twist)
    }

    /// Whether every jump lies in the cone of outward normals, so that its work with every force of the friction cone is not negative.
    fn jumps_outwards(&self, state: &PieceState) -> bool {
        self.problem.locals().enumerate().filter(|(_, local)| !local.is_bonded()).all(|(i, local)| {
            let (jump, cone) = (self.jump(i, state), local.cone());
            let slack = -SOLVED_ROUNDING * self.problem.span(i, &state.twist);
            if local.facets().is_empty() {
                return !local.may_open() || jump[0] >= slack;
            }
            let corners = &local.polygon.corners;
            corners.iter().all(|d| cone.generator(d).dot(&jump) >= slack * cone.round_weight())
        })
    }
}

/// An orthonormal basis of the vectors in the first `axes` components that are orthogonal to `normals`.
fn face<'n>(normals: impl Iterator<Item = &'n SVector<f64, 3>>, axes: usize) -> Vec<SVector<f64, 3>> {
    let mut taken: Vec<SVector<f64, 3>> = Vec::new();
    let rest = |mut v: SVector<f64, 3>, taken: &[SVector<f64, 3>]| {
        // The second pass removes rounding left by the first.
        for t in taken.iter().chain(taken) {
            v -= t * t.dot(&v);
        }
        v
    };
    for normal in normals {
        let left = rest(*normal, &taken);
        if left.norm() > DEPENDENT_DIRECTION {
            taken.push(left.normalize());
        }
    }
    let bound = taken.len();
    while taken.len() < axes {
        // The axis with the largest part outside the vectors chosen so far.
        let units = (0..axes).map(|axis| rest(unit(axis), &taken));
        let Some(next) = units.max_by(|a, b| a.norm().total_cmp(&b.norm())) else { break };
        taken.push(next.normalize());
    }
    taken.split_off(bound)
}
