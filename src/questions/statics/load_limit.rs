//! Limit analysis: the largest multiple of a load that contact forces within a budget balance and, as its inverse, the budget that a load needs. The
//! budget is an upper limit of the normal force of each contact, or of the sum of all normal forces.
//!
//! Let G_i be the grasp map of contact i, W₀ the constant base load and W the load. The result is the largest λ, called the largest load factor, with
//! `Σ G_i F_i + W₀ + λ W = 0` for some forces F_i in their cones and within the budget. The wrenches that such contact forces can exert form a convex
//! set. A plane that touches this set, with the set on one side, gives an upper bound of λ. Consider a ray from inside the set towards the wrench
//! that balances the load at this bound. The ray ends in the set, or leaves the set through a plane with a smaller bound.

use nalgebra::SVector;

use super::budget::{Budget, WrenchScale};
use super::wrench_set::WrenchSet;
use crate::error::Error;
use crate::grasp::{Engine, Twist, Wrench};
use crate::numerics::tolerances::SOLVED_ROUNDING;
use crate::numerics::{Each, RayExit, Size, Vector, Vertex, add_times, shoot, simplex};
use crate::prelude::*;
use crate::search::Settings;

/// Largest multiple of a load, added to a base load, that some contact forces within a budget balance.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum LoadLimit<const C: usize> {
    /// The base load plus the load times a factor can be balanced, for factors from zero up to a largest factor. Two bounds of the largest factor are
    /// given.
    #[non_exhaustive]
    Factor {
        /// Lower bound of the largest load factor: with it the load can be balanced.
        at_least: f64,
        /// Upper bound of the largest load factor. The two bounds differ by at most about 1e-9 of the factor, unless rounding ended the search
        /// before.
        at_most: f64,
        /// Forces on the object in the contact frames, N, within the budget, that balance the base load and `at_least` times the load.
        forces: Vec<SVector<f64, C>>,
        /// A motion of the object that proves `at_most`: along it a larger multiple of the load does more work than contact forces within the budget
        /// can do against it.
        motion: Twist<C>,
    },
    /// Contact forces within the budget cannot balance even the base load.
    #[non_exhaustive]
    NoBase {
        /// A motion of the object that proves this: along it the base load does more work than contact forces within the budget can do against it.
        motion: Twist<C>,
    },
    /// No bounds of the load factor were found, because of rounding.
    Undecided,
}

impl Engine {
    pub(crate) fn load_limit(
        &self,
        base: &Wrench<3>,
        direction: &Wrench<3>,
        budget: Budget,
        settings: &Settings,
    ) -> Result<LoadLimit<3>, Error> {
        base.check_in(self.space(), "base load")?;
        direction.check_in(self.space(), "load direction")?;
        let scale = WrenchScale::of(self.contacts());
        let set = self.wrench_set(budget, &scale, settings, "load_limit")?;
        let [base, rate] = [base, direction].each(|load| -set.inside(load));
        let size = rate.norm();
        if size == 0.0 {
            let allowed = "more than 0";
            return Err(Error::Argument { what: "size of the load direction", value: size, allowed });
        }
        Ok(limit(self.size(), set, &base, &(rate / size)).over(size))
    }
}

impl<const C: usize> LoadLimit<C> {
    /// This answer for a load that is `size` times as large as the load for which `self` was computed. The factors are therefore divided by `size`.
    fn over(self, size: f64) -> Self {
        match self {
            Self::Factor { at_least, at_most, forces, motion } => {
                Self::Factor { at_least: at_least / size, at_most: at_most / size, forces, motion }
            }
            other => other,
        }
    }
}

/// Bounds of the largest factor λ for which the load `base + λ rate`, with the unit load `rate`, lies in the set of wrenches that can be balanced.
fn limit(size: Size, mut set: WrenchSet, base: &Vector, rate: &Vector) -> LoadLimit<3> {
    set.flat = simplex(size, &|v: &Vector| set.support(v)).err().unwrap_or_default();
    // `set.flat` holds unit wrenches along which no contact force has a component. The set is widened along these directions so that it has an
    // interior. A load with a component along one of them cannot be balanced.
    let unheld = |load: &Vector| {
        let mut part = Vector::zeros();
        for v in &set.flat {
            part.add_times(v, v.dot(load));
        }
        (part.norm() > SOLVED_ROUNDING * load.norm()).then(|| part.normalize())
    };
    if let Some(motion) = unheld(base) {
        return LoadLimit::NoBase { motion: set.motion(-motion) };
    }
    let support = |v: &Vector| set.support(v);
    let Ok(simplex) = simplex(size, &support) else { return LoadLimit::Undecided };
    let shoot = |target: &Vector| shoot(&support, &simplex, target);
    let Some(begin) = shoot(base) else { return LoadLimit::Undecided };
    if begin.stretch > begin.upper_bound * (1.0 + SOLVED_ROUNDING) {
        return LoadLimit::NoBase { motion: set.motion(-begin.normal.normalize()) };
    }
    let at_begin = forces(&set, &simplex, &begin);
    if let Some(motion) = unheld(rate) {
        let motion = set.motion(-motion);
        return LoadLimit::Factor { at_least: 0.0, at_most: 0.0, forces: at_begin, motion };
    }
    let plane = |normal: &Vector| normal.dot(&(support(normal) - base)) / normal.dot(rate);
    let (mut at_most, mut normal) = (plane(rate), rate.clone());
    let mut last: Option<(f64, RayExit)> = None;
    // With round cones each further supporting plane of the set doubles the number of correct digits. Without rounding the search ends long before a
    // hundred planes.
    for _ in 0..100 {
        let Some(there) = shoot(&(base + rate * at_most)) else { break };
        let (inside, nearer) = (there.stretch <= 1.0 + SOLVED_ROUNDING, plane(&there.normal));
        let comes_nearer = !inside && nearer < at_most;
        let next = there.normal.clone();
        last = Some((at_most, there));
        if !comes_nearer {
            break;
        }
        (at_most, normal) = (nearer.max(0.0), next);
    }
    let motion = set.motion(-normal.normalize());
    if at_most <= SOLVED_ROUNDING * base.norm().max(support(rate).norm()) {
        return LoadLimit::Factor { at_least: 0.0, at_most: 0.0, forces: at_begin, motion };
    }
    // The lower bound is a factor whose load was found to be balanced. It is the last factor tried, or else the upper bound reduced by ever larger
    // fractions.
    let reached = |(factor, crossing): &(f64, RayExit)| crossing.stretch <= 1.0 && *factor <= at_most;
    let nearer = [1e-13, 1e-12, 1e-11, 1e-10, 1e-9, 1e-6, 1e-3].iter().filter_map(|part| {
        let factor = at_most * (1.0 - part);
        Some((factor, shoot(&(base + rate * factor))?))
    });
    match last.into_iter().chain(nearer).find(reached) {
        Some((at_least, crossing)) => {
            LoadLimit::Factor { at_least, at_most, forces: forces(&set, &simplex, &crossing), motion }
        }
        None => LoadLimit::Factor { at_least: 0.0, at_most, forces: at_begin, motion },
    }
}

/// Contact forces that balance the load at the end of the ray `crossing`. That load is a weighted mean of vertices of the set, each the wrench of
/// known contact forces; the same mean of these forces is returned. The weights are [`RayExit::coefficients`] for [`RayExit::vertices`]; the
/// remaining weight is distributed evenly over the vertices of `simplex`.
fn forces(set: &WrenchSet, simplex: &[Vertex], crossing: &RayExit) -> Vec<SVector<f64, 3>> {
    let rest = (1.0 - crossing.coefficients.iter().sum::<f64>()) / simplex.len() as f64;
    let points = crossing.vertices.iter().zip(crossing.coefficients.iter().copied());
    let all = points.chain(simplex.iter().map(|vertex| (vertex, rest)));
    let mut sum: Vec<SVector<f64, 3>> = Vec::new();
    for (vertex, coefficient) in all {
        let forces = set.forces(&vertex.towards);
        sum.resize(forces.len(), SVector::zeros());
        add_times(&mut sum, &forces, coefficient);
    }
    sum
}
