//! The minimum of potential energy under friction constraints, computed such that large ratios of stiffnesses do not enlarge rounding errors.
//!
//! The quadratic program is solved through its optimality conditions (`optimality`). Lemke's method finds the open gaps and the binding friction
//! constraints. The minimum is then computed anew from the acting springs: all springs except the normal springs of contacts with open gaps. The
//! multipliers of the constraints are forces on the **object** that no contact exerts. The minimum is an equilibrium exactly if these forces have no
//! resultant force and moment. A command is the displacement that a finger would make if there were no object.

use nalgebra::{Matrix, SVector};

use super::optimality::{EnergyProgram, Faces, NotOptimal, ProgramPoint};
use crate::Settings;
use crate::error::Error;
use crate::grasp::{Coordinates, Engine, Motion, Twist, Wrench};
use crate::numerics::tolerances::SOLVED_ROUNDING;
use crate::numerics::{IntoList, Reals, Vector, mapped, numbered, summed};
use crate::object::Unbalanced;
use crate::prelude::*;
#[cfg(feature = "serde")]
use crate::serial::AsComputed;

/// The result of the search for the minimum of potential energy under friction constraints.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(tag = "outcome", rename_all = "snake_case")
)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub enum MinimumOutcome<const C: usize> {
    /// The quadratic program has a minimum, given here.
    Minimum(Box<MinimumEnergy<C>>),
    /// The friction constraints contradict each other, or the energy has no lower bound because contacts open.
    NoMinimum,
    /// The load does positive work along a motion that no spring resists with all contacts closed: the energy has no lower bound.
    Unbounded {
        /// A motion without resistance, in the sense in which the load does positive work. It has unit length, in which a rotation is measured in
        /// radians times the root mean square distance of the contacts from their centroid.
        motion: Twist<C>,
        /// Work of the load along the motion, positive, J.
        #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
        work: f64,
    },
    /// The minimum was not found, because of rounding or of a limit on pivots or on rows of the matrix. The matrix is dense; more than 10 000 rows (a
    /// thousand contacts in space on eight facets) are not tried.
    Unsolved,
}

impl<const C: usize> MinimumOutcome<C> {
    /// The minimum, if the quadratic program has a minimum that was found; else `None`.
    #[must_use]
    pub fn minimum(&self) -> Option<&MinimumEnergy<C>> {
        match self {
            Self::Minimum(minimum) => Some(minimum),
            _ => None,
        }
    }
}

/// The minimum of potential energy under the friction constraints, with all contacts that have friction sticking: the result of the quadratic
/// program. **It is an equilibrium only if [`Self::imbalance`] is zero.**
///
/// With K_i, a_i, G_i and g_i the stiffness, offset (command less clearance), grasp map and gap of contact i, e_n its normal axis, W the load and q
/// the twist:
///
/// ```text
/// minimise  Σ ½ F_iᵀK_i⁻¹F_i - W·q,      F_i = K_i (a_i - G_iᵀq + e_n g_i)      over q and g
/// subject to  g_i >= 0,   μ F_n - h·F_t >= 0 for every facet h of the cone
/// ```
///
/// The multiplier λ of the friction constraint of contact i at facet h acts on the object like a force that no contact exerts:
/// `Σ G_i F_i + W = Σ λ G_i K_i (μ e_n - h)`. A contact with infinite friction has no friction constraint. If it had a gap g_i, it could therefore
/// transmit a tangential force F_t across the open gap. Here it has no gap; instead it has the constraint F_n >= 0. (In the quadratic program of the
/// paper that [`energy`](crate::energy) cites, such a contact has a gap.)
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct MinimumEnergy<const C: usize> {
    /// The load of the question, N and N m, without the permanent loads of bodies, which are part of the grasp and act in every question.
    pub load: Wrench<C>,
    /// Motion of the object about the origin at the minimum, m and rad. The acting springs are all springs except the normal springs of contacts with
    /// open gaps. If some motions stretch no acting spring, the twist is usually the solution of least norm.
    pub twist: Twist<C>,
    /// Forces, displacement and gap of each contact, in the order of the grasp.
    pub contacts: Vec<MinimumContact<C>>,
    /// Friction constraints of contacts that bind, with their multipliers.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Vec::is_empty"))]
    pub binding: Vec<Binding>,
    /// The resultant of contact forces and load about the origin, `Σ G_i F_i + W`, N and N m: the opposite of the wrench that is missing for
    /// equilibrium. It is computed from the multipliers, so that it is exactly zero if all multipliers are zero.
    pub imbalance: Wrench<C>,
    /// Energy stored in the springs of all contacts, joints and tendons, `Σ ½ F²/k`, J.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
    pub stored_energy: f64,
    /// The minimum of the potential energy, J: stored energy less the work `W·q` along the motion q. Here W is the load, together with the permanent
    /// loads of bodies and the pull of vacuums.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
    pub potential_energy: f64,
    /// Motions that stretch no acting spring (all springs act except the normal springs of contacts with open gaps): the twist is determined up to
    /// them. They are orthogonal to each other and have unit length, in which a rotation is measured in radians times the root mean square distance
    /// of the contacts from their centroid.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Vec::is_empty"))]
    pub free_motions: Vec<Motion<C>>,
    /// Number of pivots of Lemke's method; 0 if everything sticks at the minimum.
    pub pivots: usize,
    /// Whether the resultant of the multipliers on the object is zero up to rounding: the object is then in equilibrium at the minimum.
    #[cfg_attr(feature = "serde", serde(rename = "is_equilibrium"))]
    pub(super) balanced: bool,
    #[cfg_attr(feature = "serde", serde(skip))]
    pub(super) inside: Inside,
}

/// The motion of the object at a minimum of energy, and the motions that no acting spring resists, both in the engine's coordinates. In these
/// coordinates the motions without resistance are orthonormal.
#[derive(Debug, Clone, PartialEq, Default)]
pub(super) struct Inside {
    pub(super) twist: Coordinates,
    pub(super) free_motions: Vec<Coordinates>,
}

/// One contact of a [`MinimumEnergy`]: its force, displacement and gap.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct MinimumContact<const C: usize> {
    /// Force on the object in the contact frame, N. Its first entry, the normal force, is not negative unless the contact is bonded (neither opens
    /// nor slips) or kept closed (may slip, but not open).
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<SVector<f64, C>>"))]
    pub force: SVector<f64, C>,
    /// The same force on the object along the coordinate axes, N.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<SVector<f64, C>>"))]
    pub force_world: SVector<f64, C>,
    /// Displacement u_c of the body's core at the contact, along the coordinate axes, m. The core is the rigid body without the deformation at its
    /// contacts.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<SVector<f64, C>>"))]
    pub body_core: SVector<f64, C>,
    /// Gap between the two surfaces of the contact, m; never negative.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
    pub gap: f64,
}

/// A friction constraint that binds: the contact force is on this facet of the friction cone.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct Binding {
    /// The contact whose force is on the facet, counted from 0.
    pub contact: usize,
    /// The facet of the cone, in the plane 0 for F_t = μ F_n and 1 for F_t = -μ F_n, in space as in
    /// [`PolygonCone`](crate::PolygonCone); `None` for F_n = 0 at infinite friction.
    #[cfg_attr(feature = "serde", serde(default, skip_serializing_if = "Option::is_none"))]
    pub facet: Option<usize>,
    /// Multiplier λ >= 0 of the constraint on the friction margin `μ F_n - h·F_t` at the facet h, m: the energy per unit of the margin. Zero if the
    /// force lies on the facet even without this constraint.
    #[cfg_attr(feature = "serde", serde(with = "AsComputed::<f64>"))]
    pub multiplier: f64,
}

impl Engine {
    pub(crate) fn minimum_energy(
        &self,
        load: &Wrench<3>,
        settings: &Settings,
    ) -> Result<MinimumOutcome<3>, Error> {
        let program = EnergyProgram::new(self.on_polygons(load, &settings.cone)?);
        let problem = &program.problem;
        let stuck = match program.stuck.solve(problem.sites, &problem.offsets, problem.load()) {
            Ok(stuck) => stuck,
            Err(Unbalanced { motion: Some(v) }) => {
                return Ok(MinimumOutcome::Unbounded {
                    motion: self.outside(&v),
                    work: v.dot(&problem.wrench),
                });
            }
            Err(Unbalanced { motion: None }) => return Ok(MinimumOutcome::Unsolved),
        };
        // If forces and motion with everything sticking satisfy all conditions up to rounding, they are the minimum and no pivot is needed. This also
        // avoids ties in the choice of pivots, which are common in symmetric grasps.
        let sticking = Faces { open: vec![false; self.sites().len()], binding: Vec::new() };
        let mut pivots = 0;
        let mut point = Some(program.sticking(&stuck)).filter(|point| program.holds(point, &sticking));
        if point.is_none() {
            let (faces, made, near) = match program.faces(&stuck, settings) {
                Ok(found) => found,
                Err(NotOptimal::NoMinimum) => return Ok(MinimumOutcome::NoMinimum),
                Err(NotOptimal::Unsolved) => return Ok(MinimumOutcome::Unsolved),
            };
            pivots = made;
            point = program.on_faces(&faces, &stuck, &near).filter(|point| program.holds(point, &faces));
        }
        let Some(point) = point else { return Ok(MinimumOutcome::Unsolved) };
        Ok(MinimumOutcome::Minimum(Box::new(self.write_out(load, &program, &point, pivots))))
    }

    fn write_out(
        &self,
        load: &Wrench<3>,
        program: &EnergyProgram,
        point: &ProgramPoint,
        pivots: usize,
    ) -> MinimumEnergy<3> {
        let most = program.problem.largest_force(&point.forces, &point.twist);
        let rows = program.friction.iter().zip(&point.multipliers);
        let binding = rows
            .filter(|(row, l)| row.contact < self.len() && (**l != 0.0 || row.binds(&point.forces, most)))
            .map(|(row, l)| Binding { contact: row.contact, facet: row.facet, multiplier: l / row.length });
        let held = program.held_from_outside(&point.multipliers);
        let mut pushed: Vector = self.sites().iter().zip(&held).map(|(site, f)| &site.map * f).sum();
        let balanced = pushed.norm() <= SOLVED_ROUNDING * most;
        let rounding = SOLVED_ROUNDING * summed(&held, &Matrix::norm);
        pushed.iter_mut().filter(|x| x.abs() <= rounding).for_each(|x| *x = 0.0);
        let object = self.space().object_alone(&point.twist);
        let contact = |i: usize| {
            let site = &self.sites()[i];
            MinimumContact {
                force: point.forces[i],
                force_world: site.frame * point.forces[i],
                body_core: site.frame * site.map.tr_mul(&object),
                gap: point.gaps[i],
            }
        };
        let stored = self.sites().iter().zip(&point.forces).take(self.len());
        let mut stored_energy = stored.map(|(site, f)| site.springs.stored(f)).added();
        if let Some(linkage) = self.linkage() {
            let drives = linkage.drives.iter().zip(&point.forces[self.len()..]);
            stored_energy += drives.map(|(drive, force)| drive.stored(force)).added();
        }
        let own_work = match self.bodies() {
            None => {
                self.with_vacuum(load).coordinates(self.space()).dot(&self.outside_coordinates(&point.twist))
            }
            Some(_) => self.load_unchecked(load).dot(&point.twist),
        };
        MinimumEnergy {
            load: *load,
            twist: self.outside(&point.twist),
            contacts: numbered(self.len(), &contact),
            binding: binding.list(),
            imbalance: self.wrench_outside(&pushed),
            stored_energy,
            potential_energy: stored_energy - own_work,
            free_motions: mapped(&point.free, &|v| self.motion_outside(v)),
            inside: Inside {
                twist: Coordinates::of(&point.twist),
                free_motions: mapped(&point.free, &Coordinates::of),
            },
            pivots,
            balanced,
        }
    }
}
