//! Two methods for the contact forces of a grasp. [`Method::Edges`] has forces along the lines between contacts as unknowns, [`Method::Motions`] the
//! motion of the object. For three contacts in space this file chooses between the two. The lines are then the sides of the triangle of contacts; in
//! the code they are edges.
//!
//! `Edges` starts from some contact forces that balance the load. It adds forces along the lines so that displacements agree with the compliances. In
//! a slim triangle the starting forces are larger than the resulting contact forces, which costs digits. If compliances differ much, the force of a
//! soft contact is a small difference of large forces. For such triangles `Motions` is chosen, and also for contacts without friction, whose
//! tangential compliance is infinite.
//!
//! The choice is made once, when a grasp is prepared. A block holds the data of several grasps, which are computed together, one grasp in each lane
//! of a vector. The choice is read from these data lane by lane, so that an answer does not depend on the grasps in other lanes.

use super::block::{AnyGraspData, Block, Layout, TermSizes};
use super::lanes::Packed;
use super::triangle::{self, N, Triangle, others};
use crate::numerics::{Each, Reals};

/// The method by which the contact forces of a grasp are found.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Method {
    /// Forces along the lines between contacts are the unknowns, computed from compliances. This method is used for two contacts in the plane and for
    /// some triangles in space.
    Edges,
    /// The motion of the object is the unknown, computed from stiffnesses. This method is used for all other grasps.
    Motions,
}

impl Method {
    /// For each lane, whether the grasp in this lane uses the method `self`. Two contacts in the plane use `Edges`, three contacts in space the
    /// method that [`to_compliances`] chose for each grasp, and all other grasps `Motions`.
    #[inline(always)]
    pub(super) fn of<const C: usize, X: Packed>(self, block: &Block<'_, C, X>) -> X::Each<bool> {
        let edges = self == Self::Edges;
        if is_a_triangle(block) {
            let force = block.sizes().force;
            return X::each(|lane| (force.lane(lane) > 0.0) == edges);
        }
        X::each(|_| is_a_pair(block) == edges)
    }
}

/// Whether the grasps of this block have two contacts in the plane, whose forces follow from the force along the line through both contacts.
#[inline(always)]
pub(super) fn is_a_pair<const C: usize, X: Packed>(block: &Block<'_, C, X>) -> bool {
    C == 2 && block.contacts == 2
}

/// Whether the grasps of this block have three contacts in space, whose forces may be found along the edges of the triangle.
#[inline(always)]
pub(super) fn is_a_triangle<const C: usize, X: Packed>(block: &Block<'_, C, X>) -> bool {
    C == 3 && block.contacts == triangle::N
}

/// Chooses the method for three contacts in space. If it is [`Method::Edges`], this function replaces the stiffnesses in `grasp` by compliances. It
/// also writes the [`TermSizes`]: bounds on the terms that add up to contact forces, to which the rounding errors of these forces are proportional.
/// [`TermSizes::force`] is above zero if and only if `Edges` is chosen.
pub(super) fn to_compliances<const C: usize>(grasp: &mut AnyGraspData<C>) {
    let stiff = grasp.block().springs().each(|row| [row[0], row[1], row[2]]);
    let (mut least, mut most) = (f64::INFINITY, 0.0_f64);
    for (axis, row) in stiff.iter().enumerate() {
        for (i, stiffness) in row.iter().enumerate() {
            let compliance = 1.0 / stiffness;
            *grasp.at(Layout::<C>::SPRINGS + axis, i) = compliance;
            least = least.min(compliance);
            most = most.max(compliance);
        }
    }
    let sizes = sizes(&grasp.block());
    // For `Edges` the compliances of the three contacts may differ by at most a factor of 1000. If this limit were larger, the force of a soft
    // contact might lose more than three digits. If it were smaller, more grasps would use `Motions`, which takes twice the time.
    if most <= 1e3 * least && sizes.force > 0.0 {
        grasp.measure(&sizes);
        return;
    }
    for (axis, row) in stiff.into_iter().enumerate() {
        for (i, stiffness) in row.into_iter().enumerate() {
            *grasp.at(Layout::<C>::SPRINGS + axis, i) = stiffness;
        }
    }
}

/// Bounds on the terms that add up to a contact force in [`Method::Edges`]; the rounding error of the force is proportional to them. The bounds for a
/// unit moment and a unit force are zero if rounding errors would be too large, so that `Edges` must not be used.
fn sizes<const C: usize>(grasp: &Block<'_, C, f64>) -> TermSizes<f64> {
    let mut triangle = Triangle::none();
    triangle.ready(grasp);
    let length = triangle.edge.each(|edge| edge.iter().map(|x| x * x).added().sqrt());
    let [c_n, c_t] = grasp.springs();
    // Let P be the starting contact forces, which balance the load without forces along the lines, scaled to magnitude one. The resulting contact
    // forces are `P - N A⁻¹ Nᵀ C P`. Here N maps forces along the lines to contact forces, C are the compliances, and `A = Nᵀ C N`. The magnitudes of
    // the terms of a contact force add up to at most `gives`, `1 + |N| |A⁻¹| |Nᵀ| C`.
    let mut gives = 1.0;
    for k in 0..N {
        let mut unit = [0.0; N];
        unit[k] = 1.0;
        let lambda = triangle.factors.solve(N, &unit);
        let given = others(k).each(|i| c_t[i].max(c_n[i])).iter().sum::<f64>() * length[k];
        for i in 0..N {
            gives += length[i] * lambda[i].abs() * given;
        }
    }
    let longest = length.into_iter().most();
    let height = triangle.one_over_square.sqrt();
    let moment = longest * height * gives;
    let centre: f64 = triangle.centre.iter().map(|x| x.abs()).added();
    // For `Edges` the bound on contact forces due to a unit moment, times the longest edge, may be at most 1000. For an equilateral triangle of equal
    // springs this product is seven. If the limit were larger, rounding would leave open when a friction margin that decreases slowly becomes zero.
    // If it were smaller, more grasps would use `Motions`, which takes twice the time.
    let tame = triangle.factors.free == 0.0 && moment * longest <= 1e3;
    let tamed = |size: f64| if tame { size } else { 0.0 };
    TermSizes {
        commands: triangle.size_of(&grasp.commands()),
        moment: tamed(moment),
        force: tamed(gives + moment * centre),
    }
}

#[cfg(test)]
mod tests {
    use super::super::forces::Forces;
    use super::super::springs::StickingSprings;
    use super::super::tolerances::ON_THE_EDGE;
    use super::*;
    use crate::contact::ZERO_SLACK;
    use crate::numerics::{Compiled, Draw};

    type GraspData = super::super::block::GraspData<3>;
    type Row = Layout<3>;

    /// A grasp of three contacts at random positions, which are multiplied by `narrow` along two axes, and with stiffnesses spread over `decades`
    /// decades.
    fn grasp(draw: &mut Draw, narrow: f64, decades: f64) -> GraspData {
        let mut made = GraspData::new(3);
        let grasp: &mut AnyGraspData<3> = &mut made;
        for i in 0..3 {
            let inward = [0, 1, 2].map(|_| draw.normal());
            let length = inward.iter().map(|x| x * x).sum::<f64>().sqrt();
            for axis in 0..3 {
                let width = if axis == 0 { 1.0 } else { narrow };
                *grasp.at(Row::POINT + axis, i) = width * (0.2 * draw.normal() - inward[axis] / length) + 0.5;
                *grasp.at(Row::NORMAL + axis, i) = inward[axis] / length;
            }
            // The component of the command across the normal.
            let shear = 0.1 * draw.normal();
            *grasp.at(Row::SHEARED, i) = shear * *grasp.at(Row::NORMAL + 1, i);
            *grasp.at(Row::SHEARED + 1, i) = -(shear * *grasp.at(Row::NORMAL, i));
            *grasp.at(Row::PRESSED, i) = draw.normal();
            for axis in 0..2 {
                *grasp.at(Row::SPRINGS + axis, i) = 10_f64.powf(0.3 * decades * draw.normal());
            }
        }
        made
    }

    /// The largest difference between a contact force in `forces` and the force of the same contact in `others`, divided by `part` times the sum of
    /// their rounding bounds.
    fn off(forces: &Forces<3, f64>, others: &Forces<3, f64>, part: f64) -> f64 {
        let mut off = 0.0_f64;
        for i in 0..3 {
            let bound = part * (forces.of[i].rounding + others.of[i].rounding);
            let (force, other) = (&forces.of[i], &others.of[i]);
            let pairs = core::iter::once((force.normal, other.normal));
            let across = (0..3).map(|axis| (force.tangential[axis], other.tangential[axis]));
            off = pairs.chain(across).map(|(a, b)| (a - b).abs() / bound).fold(off, f64::max);
        }
        off
    }

    /// The contact forces that a load causes, and the contact forces that the commands cause, both computed by the given method.
    fn forces(method: Method, grasp: &Block<'_, 3, f64>, load: &[f64; 6]) -> [Forces<3, f64>; 2] {
        let (mut ready, [mut loaded, mut squeezed]) =
            (StickingSprings::none(method), [Forces::<3, f64>::none(); 2]);
        ready.prepare(Compiled, grasp);
        ready.load(Compiled, grasp, load, &mut loaded);
        ready.squeeze(Compiled, grasp, None, &mut squeezed);
        [loaded, squeezed]
    }

    /// The percentage of a thousand random grasps for which [`Method::Edges`] is chosen. For these grasps it asserts that both methods find the same
    /// forces.
    fn by_edges(narrow: f64, decades: f64) -> u32 {
        let mut draw = Draw::new([3, narrow.to_bits(), decades.to_bits()]);
        let (mut count, mut worst) = (0, 0.0_f64);
        for _ in 0..1000 {
            let stiff = grasp(&mut draw, narrow, decades);
            let mut compliant = stiff;
            to_compliances(&mut compliant);
            let load = [0; 6].map(|_| draw.normal());
            let (stiff, compliant) = (AnyGraspData::block(&stiff), AnyGraspData::block(&compliant));
            if Method::Edges.of(&compliant) == [false] {
                assert_eq!(compliant.springs(), stiff.springs());
                continue;
            }
            count += 1;
            let along = forces(Method::Edges, &compliant, &load);
            let moved = forces(Method::Motions, &stiff, &load);
            let loaded = off(&along[0], &moved[0], 1.0);
            let commanded = off(&along[1], &moved[1], ZERO_SLACK / ON_THE_EDGE);
            worst = [loaded, commanded].into_iter().fold(worst, f64::max);
        }
        assert!(worst < 0.2, "{worst}");
        count / 10
    }

    #[test]
    fn both_ways_lead_to_the_same_forces() {
        let shares = [(1.0, 0.0), (1.0, 1.0), (0.1, 0.0), (1.0, 2.0)].map(|(n, d)| by_edges(n, d));
        assert!(shares.iter().all(|&share| share > 10) && shares[0] > 90, "{shares:?}");
        assert!(by_edges(1e-4, 0.0) == 0 && by_edges(1.0, 12.0) < 5);
    }

    /// Without friction at one contact its tangential stiffness is zero and its compliance infinite, so the motion of the object is used.
    #[test]
    fn without_friction_by_motions() {
        let mut grasp = grasp(&mut Draw::new([0; 3]), 1.0, 0.0);
        for contacts in 1..=3 {
            *AnyGraspData::at(&mut grasp, Row::SPRINGS + 1, contacts - 1) = 0.0;
            let mut asked = grasp;
            to_compliances(&mut asked);
            assert_eq!(Method::Motions.of(&AnyGraspData::block(&asked)), [true]);
            assert_eq!(AnyGraspData::block(&asked).springs(), AnyGraspData::block(&grasp).springs());
        }
    }
}
