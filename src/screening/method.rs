//! Which grasps of three contacts in space go by the edges of their triangle.
//!
//! Along edges the forces that bear a load are split off before compliances share it out. Where the
//! triangle is slim these are larger than the forces at all; where compliances differ much, a soft
//! contact is left with a small difference of them. Such grasps go by motions, and so do those that
//! lack friction, for their compliance is infinite. It is decided once, when a grasp is made ready:
//! batches find it in their data, and its answer does not depend on its neighbours.

use super::block::{Block, Sizes};
use super::lanes::Lanes;
use super::triangle::{Triangle, others};

/// A way to the forces of a scene.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Method {
    /// Compliances, and forces along edges.
    Edges,
    /// Stiffnesses, and motions of the object.
    Motions,
}

impl Method {
    /// Which scenes go this way: all pairs in the plane by edges, all but triangles by motions else.
    #[inline(always)]
    pub(super) fn of<const C: usize, const N: usize, const L: usize>(
        self,
        block: &Block<C, N, L>,
    ) -> [bool; L] {
        let mut go = [self == if C == 2 && N == 2 { Self::Edges } else { Self::Motions }; L];
        if C == 3 && N == 3 {
            for lane in 0..L {
                go[lane] = (block.sizes.force.0[lane] > 0.0) == (self == Self::Edges);
            }
        }
        go
    }
}

/// Forces on the way to the answer are at most so many times the load, in sums of sizes; for an even
/// triangle of equal springs they are seven times as large. Their rounding is bounded by that: with a
/// larger number margins that close slowly would be called unclear, with a smaller one more grasps
/// would take twice the time.
const LARGEST: f64 = 1e3;
/// The largest compliance is at most so many times the least one. With a larger number what a soft
/// contact bears would lose more than three digits, with a smaller one more grasps would take twice
/// the time.
const UNEVEN: f64 = 1e3;

/// Turns stiffnesses into compliances, where forces go by edges, and says so by sizes that are not
/// zero.
pub(super) fn to_compliances<const C: usize, const N: usize>(scene: &mut Block<C, N, 1>) {
    let mut compliant = *scene;
    let (mut least, mut most) = (f64::INFINITY, 0.0_f64);
    for compliance in compliant.springs.as_flattened_mut() {
        *compliance = Lanes::all(1.0) / *compliance;
        least = least.min(compliance.0[0]);
        most = most.max(compliance.0[0]);
    }
    compliant.sizes = sizes(&compliant);
    let force = compliant.sizes.force.0[0];
    if most <= UNEVEN * least && force > 0.0 {
        *scene = compliant;
    }
}

/// What rounding is measured against, zero if that is too much.
fn sizes<const C: usize, const N: usize>(scene: &Block<C, N, 1>) -> Sizes<1> {
    let triangle = Triangle::new(scene);
    let length = triangle.edge.map(|edge| edge.iter().map(|x| x.0[0] * x.0[0]).sum::<f64>().sqrt());
    let [c_n, c_t] = &scene.springs;
    // What forces P bring about along edges: `|N| |A⁻¹| |Nᵀ| C P`, in sizes.
    let mut gives = 1.0;
    for k in 0..N {
        let mut unit = [Lanes::ZERO; N];
        unit[k] = Lanes::all(1.0);
        let lambda = triangle.factors.solve(&unit);
        let given = others::<N>(k).map(|i| c_t[i].0[0].max(c_n[i].0[0])).iter().sum::<f64>() * length[k];
        for i in 0..N {
            gives += length[i] * lambda[i].0[0].abs() * given;
        }
    }
    let longest = length.into_iter().fold(0.0, f64::max);
    let height = triangle.one_over_square.0[0].sqrt();
    let moment = longest * height * gives;
    let centre: f64 = triangle.centre.iter().map(|x| x.0[0].abs()).sum();
    let tame = triangle.factors.free.0[0] == 0.0 && moment * longest <= LARGEST;
    let tamed = |size: f64| Lanes::all(if tame { size } else { 0.0 });
    Sizes {
        commands: triangle.size_of(&scene.pressed, &scene.sheared),
        moment: tamed(moment),
        force: tamed(gives + moment * centre),
    }
}

#[cfg(test)]
mod tests {
    use super::super::balance::RigidBody;
    use super::super::forces::{Forces, ON_THE_EDGE};
    use super::super::sticking;
    use super::*;
    use crate::contact::ZERO_SLACK as ROUNDING;
    use crate::numerics::Draw;

    type Scene = Block<3, 3, 1>;

    /// Fingers around a triangle, so much narrower than even, with stiffnesses over so many decades.
    fn scene(draw: &mut Draw, narrow: f64, decades: f64) -> Scene {
        let mut scene = Scene::EMPTY;
        for i in 0..3 {
            let inward = [0, 1, 2].map(|_| draw.normal());
            let length = inward.iter().map(|x| x * x).sum::<f64>().sqrt();
            for axis in 0..3 {
                let width = if axis == 0 { 1.0 } else { narrow };
                scene.point[axis][i] = Lanes([width * (0.2 * draw.normal() - inward[axis] / length) + 0.5]);
                scene.normal[axis][i] = Lanes([inward[axis] / length]);
            }
            // Across the normal.
            let shear = Lanes([0.1 * draw.normal()]);
            scene.sheared[0][i] = shear * scene.normal[1][i];
            scene.sheared[1][i] = -(shear * scene.normal[0][i]);
            scene.pressed[i] = Lanes([draw.normal()]);
            for spring in &mut scene.springs {
                spring[i] = Lanes([10_f64.powf(0.3 * decades * draw.normal())]);
            }
        }
        scene
    }

    /// How far forces are from others, in parts of the bounds of both.
    fn off(forces: &Forces<3, 3, 1>, others: &Forces<3, 3, 1>, part: f64) -> f64 {
        let mut off = 0.0_f64;
        for i in 0..3 {
            let bound = part * (forces.rounding[i] + others.rounding[i]).0[0];
            let pairs = std::iter::once((forces.normal[i], others.normal[i]));
            let across = (0..3).map(|axis| (forces.tangential[axis][i], others.tangential[axis][i]));
            off = pairs.chain(across).map(|(a, b)| (a - b).0[0].abs() / bound).fold(off, f64::max);
        }
        off
    }

    /// How many scenes of a hundred go by edges; both ways lead to the same forces there.
    fn by_edges(narrow: f64, decades: f64) -> u32 {
        let mut draw = Draw::new([3, narrow.to_bits(), decades.to_bits()]);
        let (mut count, mut worst) = (0, 0.0_f64);
        for _ in 0..1000 {
            let stiff = scene(&mut draw, narrow, decades);
            let mut compliant = stiff;
            to_compliances(&mut compliant);
            let load = [0; 6].map(|_| Lanes([draw.normal()]));
            if Method::Edges.of(&compliant) == [false] {
                assert_eq!(compliant.springs, stiff.springs);
                continue;
            }
            count += 1;
            let (triangle, body) = (Triangle::new(&compliant), RigidBody::<6, 3, 3, 1>::new(&stiff));
            let loaded = off(&triangle.load(&compliant, &load), &sticking::load(&body, &load), 1.0);
            let squeezed = sticking::squeeze(&body, &stiff.pressed, &stiff.sheared);
            let commanded = off(&triangle.squeeze(&compliant), &squeezed, ROUNDING / ON_THE_EDGE);
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

    /// A tangential stiffness of zero is an infinite compliance.
    #[test]
    fn without_friction_by_motions() {
        let mut scene = scene(&mut Draw::new([0; 3]), 1.0, 0.0);
        for contacts in 1..=3 {
            scene.springs[1][contacts - 1] = Lanes::ZERO;
            let mut asked = scene;
            to_compliances(&mut asked);
            assert_eq!(Method::Motions.of(&asked), [true]);
            assert_eq!(asked.springs, scene.springs);
        }
    }
}
