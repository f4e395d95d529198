//! Two contacts in the plane: contact forces in closed form, from compliances.
//!
//! The vector from contact 1 to contact 2 is p, with `p_1 = p` and `p_2 = -p`. `p_i⊥` is p_i turned counterclockwise by a quarter turn, and m the
//! midpoint. The compliance of contact i is `C_i = K_i⁻¹`, the inverse of its stiffness, in coordinate axes. Balance with a load (force W_f, moment
//! W_m) leaves one unknown λ, the force along the line through both contacts:
//!
//! ```text
//! F_i = λ p_i + s p_i⊥ - W_f / 2,   s = (W_m - m × W_f) / |p|²
//! ```
//!
//! The distance of the contact points on the object stays constant, which fixes λ for the commands a_i (displacements that the fingers would make if
//! there were no object):
//!
//! ```text
//! Σ p_i·(a_i - C_i F_i) = 0
//! ```
//!
//! The coefficient of λ in this condition, `Σ p_i·C_i p_i`, is a sum of positive terms. Therefore no digits are lost, however different the
//! stiffnesses are.

use super::block::{AnyGraspData, Block, Commanded, Layout, TermSizes};
use super::forces::AnyForces;
use super::lanes::Packed;
use super::tolerances::ON_THE_EDGE;
use crate::contact::ZERO_SLACK;
use crate::numerics::tolerances::LINEARLY_DEPENDENT;
use crate::numerics::{Each, Vectors};

/// Replaces the stiffnesses of a pair by compliances.
///
/// A contact without friction has an infinite tangential compliance. The condition that fixes the force λ along the line through both contacts then
/// becomes `F_t = 0` at this contact; all other terms vanish. Two such contacts hold no load. A pair also holds no load if the normal of a contact
/// without friction is along the line through both. The object then turns about the other contact. In these two cases the compliances are NaN.
pub(super) fn to_compliances<const C: usize>(grasp: &mut AnyGraspData<C>) {
    let block = grasp.block();
    let (points, normals, [k_n, k_t]) = (block.points(), block.normals(), block.springs());
    let slippery = [k_t[0], k_t[1]].each(|k| k == 0.0);
    let [x, y] = [0, 1].each(|axis| points[axis][1] - points[axis][0]);
    let along = |i: usize| {
        let t = normals[1][i] * x - normals[0][i] * y;
        t * t <= LINEARLY_DEPENDENT * (x * x + y * y)
    };
    let count = (0..2).map(|i| if slippery[i] { 1 + usize::from(along(i)) } else { 0 }).sum();
    let compliances = [0, 1].each(|i| match count {
        0 => [1.0 / k_n[i], 1.0 / k_t[i]],
        1 => [0.0, f64::from(u8::from(slippery[i]))],
        _ => [f64::NAN; 2],
    });
    for (i, compliances) in compliances.into_iter().enumerate() {
        for (axis, compliance) in compliances.into_iter().enumerate() {
            *grasp.at(Layout::<C>::SPRINGS + axis, i) = compliance;
        }
        if count > 0 {
            *grasp.at(Layout::<C>::PRESSED, i) = 0.0;
            *grasp.at(Layout::<C>::SHEARED, i) = 0.0;
            grasp.set_command_and_clearance(i, [0.0; 2]);
        }
    }
    let sizes = sizes(&grasp.block());
    grasp.measure(&sizes);
}

/// Bounds on the sums of the magnitudes of the terms that add up to a contact force, for a pair whose springs are stored as compliances. The rounding
/// error of a contact force is proportional to these sums.
fn sizes<const C: usize>(grasp: &Block<'_, C, f64>) -> TermSizes<f64> {
    let pair = Pair::new(grasp);
    let [x, y] = [0, 1].each(|axis| grasp.points()[axis][1] - grasp.points()[axis][0]);
    let length = x.abs() + y.abs();
    let mut gives = 0.0;
    for i in 0..2 {
        gives += pair.u[i].abs() + pair.v[i].abs();
    }
    let commands = pair.size_of(length, &grasp.commands());
    let scale = length * pair.one_over_give;
    let gives = 1.0 + scale * gives;
    let moment = length * pair.one_over_square * gives;
    let [x, y] = pair.midpoint;
    TermSizes { commands, moment, force: moment * (x.abs() + y.abs()) + gives }
}

/// Two contacts in the plane and the line through both, for several grasps, one in each lane of a vector. Inner arrays of two have an entry for each
/// contact.
#[derive(Debug, Clone, Copy)]
pub(super) struct Pair<X: Packed> {
    normal: [[X; 2]; 2],
    midpoint: [X; 2],
    /// Components of the vector `p_i` from contact i to the other contact, along the normal of contact i.
    n: [X; 2],
    /// Components of the vector `p_i` from contact i to the other contact, along the tangent of contact i.
    t: [X; 2],
    /// Components of `C_i p_i` along the normal of contact i, with the compliance C_i of contact i and the vector p_i to the other contact.
    u: [X; 2],
    /// Components of `C_i p_i` along the tangent of contact i, with the compliance C_i of contact i and the vector p_i to the other contact.
    v: [X; 2],
    one_over_give: X,
    one_over_square: X,
    /// The increase of the distance |p| between the contacts due to the forces `p_i⊥` (p_i turned counterclockwise by a quarter turn), times |p|:
    /// `Σ p_i·C_i p_i⊥`.
    sheared: X,
    /// The decrease of the distance |p| that the commands a_i would cause if there were no object, times |p|: `Σ p_i·a_i`, m².
    commanded: X,
    sizes: TermSizes<X>,
}

impl<X: Packed> Pair<X> {
    #[inline(always)]
    pub(super) fn new<const C: usize>(block: &Block<'_, C, X>) -> Self {
        let zero = [X::all(0.0); 2];
        let (points, normals, springs) = (block.points(), block.normals(), block.springs());
        let ([px, py], commands) = ([points[0], points[1]], block.commands());
        let x = [px[1] - px[0], px[0] - px[1]];
        let y = [py[1] - py[0], py[0] - py[1]];
        let half = X::all(0.5);
        let midpoint = [half * (px[0] + px[1]), half * (py[0] + py[1])];
        let (mut normal, mut n, mut t, mut u, mut v) = ([zero; 2], zero, zero, zero, zero);
        let (mut give, mut sheared, mut commanded) = (zero, zero, zero);
        for i in 0..2 {
            normal[0][i] = normals[0][i];
            normal[1][i] = normals[1][i];
            n[i] = normal[0][i] * x[i] + normal[1][i] * y[i];
            t[i] = normal[1][i] * x[i] - normal[0][i] * y[i];
            u[i] = springs[0][i] * n[i];
            v[i] = springs[1][i] * t[i];
            give[i] = u[i] * n[i] + v[i] * t[i];
            sheared[i] = u[i] * t[i] - v[i] * n[i];
            commanded[i] = taken(i, &commands, (n[i], t[i]));
        }
        let one_over_give = X::all(1.0) / (give[0] + give[1]);
        let one_over_square = X::all(1.0) / (x[0] * x[0] + y[0] * y[0]);
        Self {
            normal,
            midpoint,
            n,
            t,
            u,
            v,
            one_over_give,
            one_over_square,
            sheared: sheared[0] + sheared[1],
            commanded: commanded[0] + commanded[1],
            sizes: block.sizes(),
        }
    }

    /// A bound, N, on the sum of the magnitudes of the terms that add up to a contact force due to the commands `asked`. `length` is the distance
    /// between the contacts, m, or a bound of it. The rounding error of the force is proportional to this sum.
    #[inline(always)]
    fn size_of<const C: usize>(&self, length: X, asked: &Commanded<'_, C, X>) -> X {
        let mut commands = X::all(0.0);
        for i in 0..2 {
            commands += asked.pressed[i].abs() + asked.sheared[0][i].abs();
        }
        length * (length * self.one_over_give) * commands
    }
}

impl<X: Packed> Pair<X> {
    /// A pair with all numbers zero; [`Self::prepare`] computes them from the data of a block.
    pub(super) fn none() -> Self {
        let (zero, zeros) = (X::all(0.0), [X::all(0.0); 2]);
        Self {
            normal: [zeros; 2],
            midpoint: zeros,
            n: zeros,
            t: zeros,
            u: zeros,
            v: zeros,
            one_over_give: zero,
            one_over_square: zero,
            sheared: zero,
            commanded: zero,
            sizes: TermSizes { commands: zero, moment: zero, force: zero },
        }
    }

    #[inline(never)]
    pub(super) fn prepare<V: Vectors, const C: usize>(&mut self, v: V, block: &Block<'_, C, X>) {
        v.run(
            #[inline(always)]
            || *self = Self::new(block),
        );
    }

    #[inline(never)]
    pub(super) fn load<V: Vectors, const C: usize>(&self, v: V, load: &[X; 6], forces: &mut AnyForces<C, X>) {
        v.run(
            #[inline(always)]
            || self.loaded(load, forces),
        );
    }

    #[inline(never)]
    pub(super) fn squeeze<V: Vectors, const C: usize>(
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

    /// Writes the contact forces that a load alone causes.
    #[inline(always)]
    fn loaded<const C: usize>(&self, load: &[X; 6], forces: &mut AnyForces<C, X>) {
        let zero = [X::all(0.0); 2];
        let s = (load[2] - (self.midpoint[0] * load[1] - self.midpoint[1] * load[0])) * self.one_over_square;
        // Each contact carries half of the force of the load; its force on the object is the opposite of this half.
        let (x, y) = (X::all(-0.5) * load[0], X::all(-0.5) * load[1]);
        let (mut halves, mut given) = ([zero; 2], zero);
        for i in 0..2 {
            halves[0][i] = self.normal[0][i] * x + self.normal[1][i] * y;
            halves[1][i] = self.normal[1][i] * x - self.normal[0][i] * y;
            given[i] = self.u[i] * halves[0][i] + self.v[i] * halves[1][i];
        }
        let lambda = -((s * self.sheared + (given[0] + given[1])) * self.one_over_give);
        let size = self.sizes.moment * load[2].abs() + self.sizes.force * (load[0].abs() + load[1].abs());
        for i in 0..2 {
            forces.of[i].normal = lambda * self.n[i] + (s * self.t[i] + halves[0][i]);
            forces.of[i].tangential[0] = lambda * self.t[i] + (halves[1][i] - s * self.n[i]);
            forces.of[i].rounding = X::all(ZERO_SLACK) * size;
        }
        (forces.unbalanced, forces.free) = (X::all(0.0), X::all(0.0));
    }

    /// Writes the contact forces due to commands alone, without a load; they act along the line through both contacts. The commands are `others` or,
    /// if `None`, those of the grasps in this block, less clearances.
    #[inline(always)]
    fn squeezed<const C: usize>(
        &self,
        block: &Block<'_, C, X>,
        others: Option<&Commanded<'_, C, X>>,
        forces: &mut AnyForces<C, X>,
    ) {
        let (commanded, size) = others.map_or((self.commanded, self.sizes.commands), |others| {
            let points = block.points();
            let [x, y] = [0, 1].each(|axis| points[axis][1] - points[axis][0]);
            let taken = |i: usize| taken(i, others, (self.n[i], self.t[i]));
            (taken(0) + taken(1), self.size_of(x.abs() + y.abs(), others))
        });
        let lambda = commanded * self.one_over_give;
        for i in 0..2 {
            forces.of[i].normal = lambda * self.n[i];
            forces.of[i].tangential[0] = lambda * self.t[i];
            forces.of[i].rounding = X::all(ON_THE_EDGE) * size;
        }
        (forces.unbalanced, forces.free) = (X::all(0.0), X::all(0.0));
    }
}

/// `p_i·a_i`, m²: the component of the command of finger i along the line through both contacts, times the distance |p| between them.
#[inline(always)]
fn taken<const C: usize, X: Packed>(i: usize, commands: &Commanded<'_, C, X>, (n, t): (X, X)) -> X {
    commands.pressed[i] * n + commands.sheared[0][i] * t
}
