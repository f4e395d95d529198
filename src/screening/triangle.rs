//! Three contacts in space: forces along the edges of their triangle, in compliances.
//!
//! The edges run round it, `e_0 = p_2 - p_1` and so on: edge i lies opposite to contact i, edge
//! j = i + 1 ends at it and edge k = i + 2 begins there. All of them are normal to `m = e_1 × e_2`.
//! Forces and moments (M of the load about the centroid) balance with three unknowns λ, forces that
//! stretch the edges:
//!
//! ```text
//! F_i = P_i + λ_j e_j - λ_k e_k,   P_i = -W_f / 3 - (e_i·M) m / |m|² + (m·M) e_i / 2 |m|²
//! ```
//!
//! The object does not change the lengths of its edges, which fixes λ. With the compliances
//! `C_i = c_t I + (c_n - c_t) n nᵀ`, each edge from its tail to its head:
//!
//! ```text
//! e·[(a - C F)_head - (a - C F)_tail] = 0,   A λ = Nᵀ (a - C P),   A = Nᵀ C N,   (N λ)_i = λ_j e_j - λ_k e_k
//! ```
//!
//! These are half the operations of [`super::balance`], and forces balance whatever λ is. What is
//! small among large forces comes out better there: [`super::way`] says which way a grasp takes.

use super::block::Block;
use super::factors::LaneFactors;
use super::forces::{Forces, ON_THE_EDGE};
use super::lanes::{Lanes, dot};
use crate::contact::ZERO_SLACK as ROUNDING;

/// The two others of three contacts or edges: of an edge its tail and its head, of a contact the
/// edge that ends there and the one that begins.
#[inline(always)]
pub(super) fn others<const N: usize>(i: usize) -> [usize; 2] {
    [(i + 1) % N, (i + 2) % N]
}

/// Three contacts and the edges between them: C and N are three.
#[derive(Debug, Clone, Copy)]
pub(super) struct Triangle<const C: usize, const N: usize, const L: usize> {
    pub(super) edge: [[Lanes<L>; C]; N],
    pub(super) centre: [Lanes<L>; C],
    /// m and `|m|⁻²`.
    across: [Lanes<L>; C],
    pub(super) one_over_square: Lanes<L>,
    /// Entries along the normal of a contact of the edge that ends there and of the one that begins.
    ends: [Lanes<L>; N],
    begins: [Lanes<L>; N],
    /// How much the edges would have to give by the tangential compliances, under equal forces of
    /// one along an edge and under forces `P_i = e_i`.
    pushed: [Lanes<L>; N],
    turned: [Lanes<L>; N],
    pub(super) factors: LaneFactors<N, L>,
}

impl<const C: usize, const N: usize, const L: usize> Triangle<C, N, L> {
    #[inline(always)]
    pub(super) fn new(block: &Block<C, N, L>) -> Self {
        let none = [Lanes::ZERO; N];
        let (mut edge, mut centre) = ([[Lanes::ZERO; C]; N], [Lanes::ZERO; C]);
        for axis in 0..C {
            let p = &block.point[axis];
            for i in 0..N {
                let [tail, head] = others::<N>(i);
                edge[i][axis] = p[head] - p[tail];
                centre[axis] += p[i];
            }
            centre[axis] = Lanes::all(1.0 / N as f64) * centre[axis];
        }
        let across = cross(&edge[1], &edge[2 % N]);
        let [c_n, c_t] = &block.springs;
        let (mut ends, mut begins, mut corner) = (none, none, none);
        for i in 0..N {
            let [j, k] = others::<N>(i);
            let normal = block.normal_of(i);
            ends[i] = dot(&normal, &edge[j]);
            begins[i] = dot(&normal, &edge[k]);
            corner[i] = dot(&edge[j], &edge[k]);
        }
        let (mut gives, mut pushed, mut turned) = ([none; N], none, none);
        for k in 0..N {
            let [tail, head] = others::<N>(k);
            // All three edges together lead nowhere.
            let square = -(corner[tail] + corner[head]);
            let [end, begin] =
                [(head, &ends), (tail, &begins)].map(|(i, along)| (c_n[i] - c_t[i]) * along[i]);
            gives[k][k] = (c_t[head] + c_t[tail]) * square + (end * ends[head] + begin * begins[tail]);
            let (row, column) = (tail.max(head), tail.min(head));
            gives[row][column] = -(c_t[k] * corner[k] + (c_n[k] - c_t[k]) * ends[k] * begins[k]);
            pushed[k] = c_t[head] - c_t[tail];
            turned[k] = c_t[head] * corner[tail] - c_t[tail] * corner[head];
        }
        Self {
            edge,
            centre,
            across,
            one_over_square: Lanes::all(1.0) / dot(&across, &across),
            ends,
            begins,
            pushed,
            turned,
            factors: LaneFactors::new(gives),
        }
    }

    /// Forces that a load alone brings about.
    #[inline(always)]
    pub(super) fn load<const D: usize>(
        &self,
        block: &Block<C, N, L>,
        load: &[Lanes<L>; D],
    ) -> Forces<C, N, L> {
        let mut force = [Lanes::ZERO; C];
        let (mut moment, mut share) = (force, force);
        let (mut force_size, mut moment_size) = (Lanes::ZERO, Lanes::ZERO);
        for axis in 0..C {
            force[axis] = load[axis];
            share[axis] = Lanes::all(-1.0 / N as f64) * force[axis];
            moment[axis] = load[(C + axis) % D];
            force_size += force[axis].abs();
            moment_size += moment[axis].abs();
        }
        let about_origin = cross(&self.centre, &force);
        for axis in 0..C {
            moment[axis] = self.one_over_square * (moment[axis] - about_origin[axis]);
        }
        let twist = Lanes::all(0.5) * dot(&self.across, &moment);
        let mut borne = [share; N];
        let (mut pressed, mut shrunk) = ([Lanes::ZERO; N], [Lanes::ZERO; N]);
        for i in 0..N {
            let lift = dot(&self.edge[i], &moment);
            for axis in 0..C {
                borne[i][axis] += twist * self.edge[i][axis] - lift * self.across[axis];
            }
            pressed[i] = dot(&block.normal_of(i), &borne[i]);
            shrunk[i] = (block.springs[0][i] - block.springs[1][i]) * pressed[i];
        }
        let mut taken = self.along_normals(&shrunk);
        for k in 0..N {
            let across = self.pushed[k] * dot(&self.edge[k], &share) + self.turned[k] * twist;
            taken[k] = -(taken[k] + across);
        }
        let lambda = self.factors.solve(&taken);
        let size = block.sizes.moment * moment_size + block.sizes.force * force_size;
        self.forces(block, &lambda, Some((&borne, &pressed)), Lanes::all(ROUNDING) * size)
    }

    /// Forces that the commands of the fingers alone bring about.
    #[inline(always)]
    pub(super) fn squeeze(&self, block: &Block<C, N, L>) -> Forces<C, N, L> {
        self.squeezed(block, (&block.pressed, &block.sheared), block.sizes.commands)
    }

    /// The same of other commands than those of the block.
    #[inline(always)]
    pub(super) fn squeeze_by(
        &self,
        block: &Block<C, N, L>,
        (pressed, sheared): (&[Lanes<L>; N], &[[Lanes<L>; N]; C]),
    ) -> Forces<C, N, L> {
        self.squeezed(block, (pressed, sheared), self.size_of(pressed, sheared))
    }

    /// What the rounding of forces by commands is measured against.
    #[inline(always)]
    pub(super) fn size_of(&self, pressed: &[Lanes<L>; N], sheared: &[[Lanes<L>; N]; C]) -> Lanes<L> {
        let (mut stiffness, mut commands) = (Lanes::ZERO, Lanes::ZERO);
        for i in 0..N {
            stiffness += dot(&self.edge[i], &self.edge[i]) * self.factors.one_over_pivot(i);
            commands += pressed[i].abs();
            for axis in 0..C {
                commands += sheared[axis][i].abs();
            }
        }
        stiffness * commands
    }

    #[inline(always)]
    fn squeezed(
        &self,
        block: &Block<C, N, L>,
        (pressed, sheared): (&[Lanes<L>; N], &[[Lanes<L>; N]; C]),
        size: Lanes<L>,
    ) -> Forces<C, N, L> {
        let mut taken = self.along_normals(pressed);
        for k in 0..N {
            let [tail, head] = others::<N>(k);
            for axis in 0..C {
                taken[k] += self.edge[k][axis] * (sheared[axis][head] - sheared[axis][tail]);
            }
        }
        let lambda = self.factors.solve(&taken);
        self.forces(block, &lambda, None, Lanes::all(ON_THE_EDGE) * size)
    }

    /// What the edges would have to give if contacts went so far along their normals.
    #[inline(always)]
    fn along_normals(&self, way: &[Lanes<L>; N]) -> [Lanes<L>; N] {
        let mut given = [Lanes::ZERO; N];
        for k in 0..N {
            let [tail, head] = others::<N>(k);
            given[k] = way[head] * self.ends[head] - way[tail] * self.begins[tail];
        }
        given
    }

    /// Forces that the contacts bear, with their normal parts, and those along the edges.
    #[inline(always)]
    fn forces(
        &self,
        block: &Block<C, N, L>,
        lambda: &[Lanes<L>; N],
        borne: Option<(&[[Lanes<L>; C]; N], &[Lanes<L>; N])>,
        rounding: Lanes<L>,
    ) -> Forces<C, N, L> {
        let mut forces = Forces::none();
        let mut stretched = self.edge;
        for k in 0..N {
            for axis in 0..C {
                stretched[k][axis] = lambda[k] * self.edge[k][axis];
            }
        }
        for i in 0..N {
            let [j, k] = others::<N>(i);
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
                forces.tangential[axis][i] = force[axis] - block.normal[axis][i] * normal;
            }
            forces.normal[i] = normal;
            forces.rounding[i] = rounding;
            // Comparisons pass over what is not a number.
            forces.unbalanced += Lanes::ZERO * normal;
        }
        forces
    }
}

#[inline(always)]
fn cross<const C: usize, const L: usize>(a: &[Lanes<L>; C], b: &[Lanes<L>; C]) -> [Lanes<L>; C] {
    let mut product = *a;
    for axis in 0..C {
        let [next, last] = others::<C>(axis);
        product[axis] = a[next] * b[last] - a[last] * b[next];
    }
    product
}
