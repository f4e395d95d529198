//! Three contacts in space: contact forces from forces along the edges of their triangle, i.e. the lines between contacts. The data are the
//! compliances of the contacts.
//!
//! The edges run around the triangle of the contact points p_0, p_1 and p_2: `e_0 = p_2 - p_1` and so on. Edge i lies opposite to contact i. Modulo
//! 3, edge j = i + 1 ends at contact i, and edge k = i + 2 begins at contact i. All edges are normal to `m = e_1 × e_2`. Balance with a load (force
//! W_f, moment M about the centroid) leaves three unknowns λ, forces that stretch the edges:
//!
//! ```text
//! F_i = P_i + λ_j e_j - λ_k e_k,   P_i = -W_f / 3 - (e_i·M) m / |m|² + (m·M) e_i / 2 |m|²
//! ```
//!
//! The lengths of the edges on the object stay constant, which fixes λ for the commands a (displacements that the fingers would make if there were no
//! object). A clearance is the gap between finger and object before the command; the clearances of a grasp are subtracted from its commands. A
//! contact with unit normal n, normal compliance c_n and tangential compliance c_t has the compliance `C_i = c_t I + (c_n - c_t) n nᵀ`. For each
//! edge, from its tail to its head:
//!
//! ```text
//! e·[(a - C F)_head - (a - C F)_tail] = 0,   A λ = Nᵀ (a - C P),   A = Nᵀ C N,   (N λ)_i = λ_j e_j - λ_k e_k
//! ```
//!
//! This takes half the operations of computing the motion of the object from stiffnesses ([`super::balance`]), and forces balance for any λ. But
//! `balance` is more accurate for a small force among large forces; [`super::method`] chooses between the two.

use super::block::{Block, Commanded, entries};
use super::factors::LaneFactors;
use super::forces::AnyForces;
use super::lanes::{Packed, cross, dot};
use super::tolerances::ON_THE_EDGE;
use crate::contact::ZERO_SLACK;
use crate::numerics::Vectors;

/// The two other indices of 0, 1 and 2, in cyclic order after i. For edge i they are the contacts at its tail and its head. For contact i they are
/// the edge that ends and the edge that begins at the contact.
#[inline(always)]
pub(super) fn others(i: usize) -> [usize; 2] {
    [(i + 1) % N, (i + 2) % N]
}

/// The number of contacts of a triangle, and of its edges.
pub(super) const N: usize = 3;

/// Three contacts in space and the edges between them, for several grasps, one in each lane of a vector; `C` must be 3.
#[derive(Debug, Clone, Copy)]
pub(super) struct Triangle<const C: usize, X: Packed> {
    pub(super) edge: [[X; C]; N],
    pub(super) centre: [X; C],
    /// The normal vector `m = e_1 × e_2` of the triangle; its length, in square metres, is twice the area.
    pub(super) across: [X; C],
    /// `1 / |m|²` with the normal vector `m = e_1 × e_2` of the triangle, in 1/metre⁴.
    pub(super) one_over_square: X,
    /// The products `n_i·e_j` of the normal of contact i with the edge that ends at the contact.
    ends: [X; N],
    /// The products `n_i·e_k` of the normal of contact i with the edge that begins at the contact.
    begins: [X; N],
    /// For edge k, the compliance c_t at its head less the compliance c_t at its tail. If all contacts have the same force F, the isotropic parts
    /// `c_t I` of the compliances contribute this difference times `e_k·F` to `e_k·[(C F)_head - (C F)_tail]`.
    pushed: [X; N],
    /// For edge k, the contribution of the isotropic parts `c_t I` of the compliances to `e_k·[(C F)_head - (C F)_tail]` if each contact i has the
    /// force `F_i = e_i`.
    turned: [X; N],
    pub(super) factors: LaneFactors<N, X>,
}

impl<const C: usize, X: Packed> Triangle<C, X> {
    #[inline(always)]
    pub(super) fn ready(&mut self, block: &Block<'_, C, X>) {
        let (points, normals) = (block.points(), block.normals());
        let none = [X::all(0.0); N];
        let (mut edge, mut centre) = ([[X::all(0.0); C]; N], [X::all(0.0); C]);
        for axis in 0..C {
            let p = points[axis];
            for i in 0..N {
                let [tail, head] = others(i);
                edge[i][axis] = p[head] - p[tail];
                centre[axis] += p[i];
            }
            centre[axis] = X::all(1.0 / N as f64) * centre[axis];
        }
        let across = cross(&edge[1], &edge[2 % N]);
        let [c_n, c_t] = block.springs();
        let (mut ends, mut begins, mut corner) = (none, none, none);
        for i in 0..N {
            let [j, k] = others(i);
            let normal = entries(&normals, i);
            ends[i] = dot(&normal, &edge[j]);
            begins[i] = dot(&normal, &edge[k]);
            corner[i] = dot(&edge[j], &edge[k]);
        }
        let mut factors = LaneFactors::none();
        let gives = &mut factors.entries;
        let (mut pushed, mut turned) = (none, none);
        for k in 0..N {
            let [tail, head] = others(k);
            // The three edges add up to zero, so that `|e_k|² = -(e_k·e_i + e_k·e_j)`.
            let square = -(corner[tail] + corner[head]);
            let (end, begin) = ((c_n[head] - c_t[head]) * ends[head], (c_n[tail] - c_t[tail]) * begins[tail]);
            gives[k][k] = (c_t[head] + c_t[tail]) * square + (end * ends[head] + begin * begins[tail]);
            let (row, column) = (tail.max(head), tail.min(head));
            gives[row][column] = -(c_t[k] * corner[k] + (c_n[k] - c_t[k]) * ends[k] * begins[k]);
            pushed[k] = c_t[head] - c_t[tail];
            turned[k] = c_t[head] * corner[tail] - c_t[tail] * corner[head];
        }
        factors.factorize(N, false);
        let one_over_square = X::all(1.0) / dot(&across, &across);
        *self = Self { edge, centre, across, one_over_square, ends, begins, pushed, turned, factors };
    }

    /// Writes the contact forces that a load alone causes.
    #[inline(always)]
    fn loaded(&self, block: &Block<'_, C, X>, load: &[X; 6], forces: &mut AnyForces<C, X>) {
        let (normals, springs) = (block.normals(), block.springs());
        let mut force = [X::all(0.0); C];
        let (mut moment, mut share) = (force, force);
        let (mut force_size, mut moment_size) = (X::all(0.0), X::all(0.0));
        for axis in 0..C {
            force[axis] = load[axis];
            share[axis] = X::all(-1.0 / N as f64) * force[axis];
            moment[axis] = load[C + axis];
            force_size += force[axis].abs();
            moment_size += moment[axis].abs();
        }
        let about_origin = cross(&self.centre, &force);
        for axis in 0..C {
            moment[axis] = self.one_over_square * (moment[axis] - about_origin[axis]);
        }
        let twist = X::all(0.5) * dot(&self.across, &moment);
        let mut borne = [share; N];
        let (mut pressed, mut shrunk) = ([X::all(0.0); N], [X::all(0.0); N]);
        for i in 0..N {
            let lift = dot(&self.edge[i], &moment);
            for axis in 0..C {
                borne[i][axis] += twist * self.edge[i][axis] - lift * self.across[axis];
            }
            pressed[i] = dot(&entries(&normals, i), &borne[i]);
            shrunk[i] = (springs[0][i] - springs[1][i]) * pressed[i];
        }
        let mut taken = self.along_normals(&shrunk);
        for k in 0..N {
            let across = self.pushed[k] * dot(&self.edge[k], &share) + self.turned[k] * twist;
            taken[k] = -(taken[k] + across);
        }
        let lambda = self.factors.solve(N, &taken);
        let sizes = block.sizes();
        let size = sizes.moment * moment_size + sizes.force * force_size;
        self.forces(block, &lambda, Some((&borne, &pressed)), X::all(ZERO_SLACK) * size, forces);
    }

    /// A bound, N, on the sum of the magnitudes of the terms that add up to a contact force due to these commands. The rounding error of the force is
    /// proportional to this sum.
    #[inline(always)]
    pub(super) fn size_of(&self, asked: &Commanded<'_, C, X>) -> X {
        let (mut stiffness, mut commands) = (X::all(0.0), X::all(0.0));
        for i in 0..N {
            stiffness += dot(&self.edge[i], &self.edge[i]) * self.factors.one_over_pivot(i);
            commands += asked.pressed[i].abs();
            for axis in 0..C {
                commands += asked.sheared[axis][i].abs();
            }
        }
        stiffness * commands
    }

    /// Writes the contact forces due to commands alone, without a load. The commands are `others` or, if `None`, those of the grasps in this block,
    /// less clearances.
    #[inline(always)]
    fn squeezed(
        &self,
        block: &Block<'_, C, X>,
        others: Option<&Commanded<'_, C, X>>,
        forces: &mut AnyForces<C, X>,
    ) {
        let size = others.map_or_else(|| block.sizes().commands, |others| self.size_of(others));
        let Commanded { pressed, sheared } = others.copied().unwrap_or_else(|| block.commands());
        let mut taken = self.along_normals(pressed);
        for k in 0..N {
            let [tail, head] = self::others(k);
            for axis in 0..C {
                taken[k] += self.edge[k][axis] * (sheared[axis][head] - sheared[axis][tail]);
            }
        }
        let lambda = self.factors.solve(N, &taken);
        self.forces(block, &lambda, None, X::all(ON_THE_EDGE) * size, forces);
    }

    /// For each edge, the increase of its length times this length, m², if each contact i moves by `way[i]`, m, along its normal.
    #[inline(always)]
    fn along_normals(&self, way: &[X]) -> [X; N] {
        let mut given = [X::all(0.0); N];
        for k in 0..N {
            let [tail, head] = others(k);
            given[k] = way[head] * self.ends[head] - way[tail] * self.begins[tail];
        }
        given
    }

    /// Stores the force on the object at each contact, N. It is the sum of the forces along the two edges that meet at the contact (`lambda` times
    /// the edges) and of the contact's entry of `borne`. The forces `borne` balance the load.
    #[inline(always)]
    fn forces(
        &self,
        block: &Block<'_, C, X>,
        lambda: &[X; N],
        borne: Option<(&[[X; C]; N], &[X; N])>,
        rounding: X,
        forces: &mut AnyForces<C, X>,
    ) {
        let normals = block.normals();
        (forces.unbalanced, forces.free) = (X::all(0.0), X::all(0.0));
        let mut stretched = self.edge;
        for k in 0..N {
            for axis in 0..C {
                stretched[k][axis] = lambda[k] * self.edge[k][axis];
            }
        }
        for i in 0..N {
            let [j, k] = others(i);
            let mut normal = lambda[j] * self.ends[i] - lambda[k] * self.begins[i];
            let mut force = stretched[j];
            for axis in 0..C {
                force[axis] -= stretched[k][axis];
            }
            if let Some((borne, pressed)) = borne {
                normal += pressed[i];
                for axis in 0..C {
                    force[axis] += borne[i][axis];
                }
            }
            for axis in 0..C {
                forces.of[i].tangential[axis] = force[axis] - normals[axis][i] * normal;
            }
            forces.of[i].normal = normal;
            forces.of[i].rounding = rounding;
            // Comparisons ignore NaN. Adding zero times the normal force makes `unbalanced` NaN if this force is NaN.
            forces.unbalanced += X::all(0.0) * normal;
        }
    }
}

impl<const C: usize, X: Packed> Triangle<C, X> {
    /// A triangle with all numbers zero, before [`Self::prepare`].
    pub(super) fn none() -> Self {
        let (none, zero) = ([X::all(0.0); N], X::all(0.0));
        Self {
            edge: [[zero; C]; N],
            centre: [zero; C],
            across: [zero; C],
            one_over_square: zero,
            ends: none,
            begins: none,
            pushed: none,
            turned: none,
            factors: LaneFactors::none(),
        }
    }

    #[inline(never)]
    pub(super) fn prepare<V: Vectors>(&mut self, v: V, block: &Block<'_, C, X>) {
        v.run(
            #[inline(always)]
            || self.ready(block),
        );
    }

    #[inline(never)]
    pub(super) fn load<V: Vectors>(
        &self,
        v: V,
        block: &Block<'_, C, X>,
        load: &[X; 6],
        forces: &mut AnyForces<C, X>,
    ) {
        v.run(
            #[inline(always)]
            || self.loaded(block, load, forces),
        );
    }

    #[inline(never)]
    pub(super) fn squeeze<V: Vectors>(
        &self,
        v: V,
        block: &Block<'_, C, X>,
        others: Option<&Commanded<'_, C, X>>,
        forces: &mut AnyForces<C, X>,
    ) {
        v.run(
            #[inline(always)]
            || self.squeezed(block, others, forces),
        );
    }
}
