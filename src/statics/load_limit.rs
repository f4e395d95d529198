//! How far a load can grow until no contact forces within a budget balance it, and how much of a budget a load needs.
//!
//! Limit analysis: the largest λ with `Σ G_i F_i + W₀ + λ W = 0` for some forces in their cones. A plane that all wrenches lie on one side of says how far
//! λ can be at most. A ray from inside the set to the load there either ends in the set, or leaves it through a plane that says less.

use nalgebra::SVector;

use super::budget::{Budget, WrenchScale};
use super::wrench_set::WrenchSet;
use crate::error::Error;
use crate::grasp::{Engine, Twist, Wrench};
use crate::numerics::{Fixed, RayExit, Vertex, shoot, simplex};
use crate::prelude::*;
use crate::search::Settings;

/// A target this part beyond where the ray leaves the set lies on its boundary, as far as rounding can tell.
const ON_THE_BOUNDARY: f64 = 1e-12;
/// Planes, unless rounding keeps them from coming closer: on round cones each doubles the digits.
const MOST_PLANES: usize = 100;
/// Where rounding leaves the last load outside the set, loads that are smaller by these parts are tried.
const SHORTER: [f64; 7] = [1e-13, 1e-12, 1e-11, 1e-10, 1e-9, 1e-6, 1e-3];

/// How far a load can grow.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum LoadLimit<const C: usize> {
    /// Up to a factor.
    #[non_exhaustive]
    Factor {
        /// It can be at least this.
        at_least: f64,
        /// And at most this. Both differ by some 1e-9 of it at most, unless rounding ended the search before.
        at_most: f64,
        /// Forces on the object in the contact frames, N, that balance the load at `at_least`.
        forces: Vec<SVector<f64, C>>,
        /// The motion that the load makes beyond `at_most`: no forces within the budget work as much against it.
        motion: Twist<C>,
    },
    /// Not even the base load can be balanced.
    #[non_exhaustive]
    NoBase {
        /// The motion that it makes: no forces within the budget work as much against it.
        motion: Twist<C>,
    },
    /// Rounding was in the way.
    Undecided,
}

impl<const D: usize, const C: usize> Engine<Fixed<D>, C> {
    /// [`Statics::load_limit`](crate::ask::Statics::load_limit).
    pub(crate) fn load_limit(
        &self,
        base: &Wrench<C>,
        direction: &Wrench<C>,
        budget: Budget,
        settings: &Settings,
    ) -> Result<LoadLimit<C>, Error> {
        base.check("base load")?;
        direction.check("load direction")?;
        let set = self.wrench_set(budget, &WrenchScale::of(self.contacts()), settings, "load_limit")?;
        let [base, rate] = [base, direction].map(|load| -set.inside(load));
        let size = rate.norm();
        if size == 0.0 {
            let allowed = "more than 0";
            return Err(Error::Argument { what: "size of the load direction", value: size, allowed });
        }
        Ok(limit(set, &base, &(rate / size)).over(size))
    }
}

impl<const C: usize> LoadLimit<C> {
    /// For a load so many times as large.
    fn over(self, size: f64) -> Self {
        match self {
            Self::Factor { at_least, at_most, forces, motion } => {
                Self::Factor { at_least: at_least / size, at_most: at_most / size, forces, motion }
            }
            other => other,
        }
    }
}

/// How far the unit vector `rate` leads from `base` until it leaves the set.
fn limit<const D: usize, const C: usize>(
    mut set: WrenchSet<D, C>,
    base: &SVector<f64, D>,
    rate: &SVector<f64, D>,
) -> LoadLimit<C> {
    set.flat = simplex(&|v: &_| set.support(v)).err().unwrap_or_default();
    // Along what no force acts the set has some thickness now, and a load no part of it.
    let unheld = |load: &SVector<f64, D>| {
        let part = set.flat.iter().fold(SVector::zeros(), |sum: SVector<f64, D>, v| sum + v * v.dot(load));
        (part.norm() > ON_THE_BOUNDARY * load.norm()).then(|| part.normalize())
    };
    if let Some(motion) = unheld(base) {
        return LoadLimit::NoBase { motion: set.motion(-motion) };
    }
    let support = |v: &SVector<f64, D>| set.support(v);
    let Ok(simplex) = simplex(&support) else { return LoadLimit::Undecided };
    let shoot = |target: &SVector<f64, D>| shoot(&support, &simplex, target);
    let Some(begin) = shoot(base) else { return LoadLimit::Undecided };
    if begin.stretch > begin.reach * (1.0 + ON_THE_BOUNDARY) {
        return LoadLimit::NoBase { motion: set.motion(-begin.normal.normalize()) };
    }
    let here = forces(&set, &simplex, &begin);
    if let Some(motion) = unheld(rate) {
        let motion = set.motion(-motion);
        return LoadLimit::Factor { at_least: 0.0, at_most: 0.0, forces: here, motion };
    }
    let plane = |normal: &SVector<f64, D>| normal.dot(&(support(normal) - base)) / normal.dot(rate);
    let (mut at_most, mut normal) = (plane(rate), *rate);
    let mut last: Option<(f64, RayExit<D>)> = None;
    for _ in 0..MOST_PLANES {
        let Some(there) = shoot(&(base + rate * at_most)) else { break };
        let (inside, nearer) = (there.stretch <= 1.0 + ON_THE_BOUNDARY, plane(&there.normal));
        let comes_nearer = !inside && nearer < at_most;
        let next = there.normal;
        last = Some((at_most, there));
        if !comes_nearer {
            break;
        }
        (at_most, normal) = (nearer.max(0.0), next);
    }
    let motion = set.motion(-normal.normalize());
    if at_most <= ON_THE_BOUNDARY * base.norm().max(support(rate).norm()) {
        return LoadLimit::Factor { at_least: 0.0, at_most: 0.0, forces: here, motion };
    }
    // The last load that a ray reaches inside the set, nearer by as little as rounding allows.
    let reached = |(factor, crossing): &(f64, RayExit<D>)| crossing.stretch <= 1.0 && *factor <= at_most;
    let nearer = SHORTER.iter().filter_map(|part| {
        let factor = at_most * (1.0 - part);
        Some((factor, shoot(&(base + rate * factor))?))
    });
    match last.into_iter().chain(nearer).find(reached) {
        Some((at_least, crossing)) => {
            LoadLimit::Factor { at_least, at_most, forces: forces(&set, &simplex, &crossing), motion }
        }
        None => LoadLimit::Factor { at_least: 0.0, at_most, forces: here, motion },
    }
}

/// The forces of a target, from those of the points that its ray crosses between and of the middle.
fn forces<const D: usize, const C: usize>(
    set: &WrenchSet<D, C>,
    simplex: &[Vertex<D>],
    crossing: &RayExit<D>,
) -> Vec<SVector<f64, C>> {
    let rest = (1.0 - crossing.shares.iter().sum::<f64>()) / simplex.len() as f64;
    let points = crossing.vertices.iter().zip(crossing.shares.iter().copied());
    let all = points.chain(simplex.iter().map(|vertex| (vertex, rest)));
    let mut sum: Vec<SVector<f64, C>> = Vec::new();
    for (vertex, share) in all {
        let forces = set.forces(&vertex.towards);
        sum.resize(forces.len(), SVector::zeros());
        sum.iter_mut().zip(forces).for_each(|(sum, force)| *sum += force * share);
    }
    sum
}
