//! Contact forces while all contacts stick, under loads and commands, in one of three ways. Two contacts in the plane have a closed form ([`Pair`]).
//! Three contacts in space may have three unknown forces along the edges of their triangle, i.e. the lines between contacts ([`Triangle`], if
//! [`Method`] so decides). All other grasps have the motion of the object as the unknown ([`RigidBody`]). A command is the displacement that a finger
//! would make if there were no object. A clearance is the gap between finger and object before the command; it is negative if they overlap. A block
//! holds as many grasps as a SIMD vector has numbers (lanes).

use super::balance::RigidBody;
use super::block::{Block, Commanded, Layout};
use super::forces::AnyForces;
use super::lanes::Packed;
use super::method::Method;
use super::moved::ObjectMotion;
use super::pair::Pair;
use super::triangle::Triangle;
use crate::numerics::Vectors;

/// The causes of contact forces and of the object's motion: the commands of the fingers and the load.
pub(super) struct Cause<'a, const C: usize, X: Packed> {
    pub(super) commands: Commanded<'a, C, X>,
    /// The load on the grasp in each lane: force in N, then moments about the origin in N m. In the plane the last three are zero.
    pub(super) load: [X; 6],
}

/// The data that are computed once from the geometry and springs of a block, before a load is known. [`Self::Pair`] occurs only in the plane (C = 2
/// force components at a contact), [`Self::Triangle`] only in space (C = 3). Branches that test C as a constant keep the code for `Pair` out of
/// space, and that for `Triangle` out of the plane.
#[derive(Debug, Clone, Copy)]
#[allow(clippy::large_enum_variant)] // none is ever moved about alone
pub(super) enum StickingSprings<const C: usize, X: Packed> {
    /// Contact forces in closed form, for two contacts in the plane.
    Pair(Pair<X>),
    /// Contact forces from three unknown forces along the edges of a triangle of contacts in space, computed from compliances ([`Method::Edges`]).
    Triangle(Triangle<C, X>),
    /// Contact forces from the motion of the object, with its factorised stiffness matrix.
    RigidBody(RigidBody<C, X>),
}

impl<const C: usize, X: Packed> StickingSprings<C, X> {
    /// The variant for a method, with all numbers zero; [`Self::prepare`] computes them from the data of a block.
    pub(super) fn none(method: Method) -> Self {
        match method {
            Method::Edges if C == 2 => Self::Pair(Pair::none()),
            Method::Edges => Self::Triangle(Triangle::none()),
            Method::Motions => Self::RigidBody(RigidBody::none()),
        }
    }

    /// The method by which contact forces are found: from forces along the edges between contacts, or from the motion of the object. A block is
    /// computed with one method at a time; answers are stored only for those of its grasps that use this method.
    pub(super) fn method(&self) -> Method {
        match self {
            Self::Pair(_) | Self::Triangle(_) => Method::Edges,
            Self::RigidBody(_) => Method::Motions,
        }
    }

    pub(super) fn prepare<V: Vectors>(&mut self, v: V, block: &Block<'_, C, X>) {
        match self {
            Self::Pair(pair) if const { C == 2 } => pair.prepare(v, block),
            Self::Triangle(triangle) if const { C == 3 } => triangle.prepare(v, block),
            Self::RigidBody(body) => body.prepare(v, block),
            _ => {}
        }
    }

    /// Computes the contact forces that a load alone causes, with all commands zero.
    pub(super) fn load<V: Vectors>(
        &self,
        v: V,
        block: &Block<'_, C, X>,
        load: &[X; 6],
        forces: &mut AnyForces<C, X>,
    ) {
        match self {
            Self::Pair(pair) if const { C == 2 } => pair.load(v, load, forces),
            Self::Triangle(triangle) if const { C == 3 } => triangle.load(v, block, load, forces),
            Self::RigidBody(body) => body.sticking(v, block, None, load, forces),
            _ => {}
        }
    }

    /// Computes the contact forces due to commands alone, without a load. The commands are `others` or, if `None`, those of the grasps in this block,
    /// less clearances.
    pub(super) fn squeeze<V: Vectors>(
        &self,
        v: V,
        block: &Block<'_, C, X>,
        others: Option<&Commanded<'_, C, X>>,
        forces: &mut AnyForces<C, X>,
    ) {
        match self {
            Self::Pair(pair) if const { C == 2 } => pair.squeeze(v, block, others, forces),
            Self::Triangle(triangle) if const { C == 3 } => triangle.squeeze(v, block, others, forces),
            Self::RigidBody(body) => {
                let commands = others.copied().unwrap_or_else(|| block.commands());
                body.sticking(v, block, Some(&commands), &[X::all(0.0); 6], forces);
            }
            _ => {}
        }
    }

    /// Writes at least the rotation of the object under commands and a load into `moved`. With [`Method::Motions`] the motion of the object is the
    /// unknown, and its rotation is copied from `forces`. With [`Method::Edges`] the whole motion is computed from the forces and the compliances.
    #[inline(always)]
    pub(super) fn turned<V: Vectors>(
        &self,
        v: V,
        block: &Block<'_, C, X>,
        cause: &Cause<'_, C, X>,
        forces: &AnyForces<C, X>,
        moved: &mut ObjectMotion<C, X>,
    ) {
        let Self::RigidBody(body) = self else { return self.moved(v, block, cause, forces, moved) };
        let coordinates = Layout::<C>::COORDINATES;
        moved.turn[..coordinates - C].copy_from_slice(&forces.motion[C..coordinates]);
        // If some motion stretches no spring, the position of the object is not determined.
        moved.turn[0] = body.free().above(X::all(0.0), X::all(f64::NAN), moved.turn[0]);
    }

    /// Computes the motion of the object under commands and a load; `forces` are the contact forces of both together.
    pub(super) fn moved<V: Vectors>(
        &self,
        v: V,
        block: &Block<'_, C, X>,
        cause: &Cause<'_, C, X>,
        forces: &AnyForces<C, X>,
        moved: &mut ObjectMotion<C, X>,
    ) {
        match self {
            Self::Pair(_) if const { C == 2 } => moved.of_a_pair(v, block, cause, forces),
            Self::Triangle(triangle) if const { C == 3 } => {
                moved.of_a_triangle(v, triangle, block, cause, forces);
            }
            Self::RigidBody(body) => body.moved(v, block, cause, moved),
            _ => {}
        }
    }
}
