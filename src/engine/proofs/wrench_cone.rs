//! A proof that no contact forces at all balance the load: the load lies outside the friction wrench cone.
//!
//! With the generators γ of all friction cones (wrenches), the load is balanced by admissible forces iff `Σ γ β + W = 0` for some nonnegative
//! coefficients β. Otherwise the residual of the nearest sum,
//!
//! ```text
//! min |Σ γ β + W|,  β >= 0,       v = Σ γ β + W
//! ```
//!
//! is a **separating motion**: γ·v >= 0 for all generators (no admissible contact force does negative work along v) and W·v = |v|² > 0 (the load does
//! positive work along v). Stiffness, commands and history play no part in this. A separation is **clear**, beyond rounding, under two conditions.
//! |v| exceeds 1e-9 of the load, and rounding can hide from the proof only an equilibrium with forces of at least 1e4 times load and commands.
//!
//! A round cone has infinitely many generators. But the generator that does the most negative work along a motion v is known. With the grasp map G_i
//! of its contact, the contact point moves by u = G_iᵀv, along the tangents by u_t. The generator then lies along `e_n - μ u_t/|u_t|`, with the unit
//! normal e_n and the friction coefficient μ. This generator is added to the generators of the sum. The sum is then minimised again, until no
//! generator does negative work along the residual. In the engine's coordinates moments and rotations refer to the centroid of the contacts.

use nalgebra::SVector;

use super::escape::counts_from_here_on;
use super::separating_many::{Residual, residual_of_many};
use super::tolerances::{CLEAR_RESIDUAL, ESCAPE, LEAST_WORK, MOST_COORDINATES};
use crate::contact::{Law, tangential, tangential_norm};
use crate::grasp::Site;
use crate::numerics::{IntoList, NearestPoint, Reals, Size, Vector, unit};
use crate::object::{Problem, uses_band};
use crate::prelude::*;

/// A force on the boundary of one contact's cone (a generator), scaled so that its wrench has length one.
#[derive(Debug, Clone)]
pub(crate) struct Generator {
    pub(crate) contact: usize,
    pub(crate) force: SVector<f64, 3>,
    pub(crate) wrench: Vector,
}

impl Generator {
    /// The generator along the force `force` of a contact. The length of `force` does not matter.
    pub(crate) fn along(contact: usize, site: &Site, force: SVector<f64, 3>) -> Self {
        let wrench = &site.map * force;
        let size = wrench.norm();
        Self { contact, force: force / size, wrench: wrench / size }
    }

    /// Negative work of the generator, a unit wrench, along a motion, divided by the share of the normal component in its contact force. With large
    /// friction this share is small. A contact can then exert a large multiple of the generator with a small normal force. Even little negative work
    /// of the generator therefore weakens the proof that the load is unbalanced.
    fn works_against(&self, motion: &Vector) -> f64 {
        let normal = self.force[0] / self.force.norm();
        -self.wrench.dot(motion) / if normal > 0.0 { normal } else { 1.0 }
    }
}

/// The sum of admissible forces whose wrench is nearest to a target wrench.
pub(crate) struct NearestForces {
    /// The wrench of these forces minus the target wrench, taken as a motion: no generator does negative work along it, except for rounding.
    pub(crate) motion: Vector,
    /// The largest magnitude of negative work that any generator, a unit wrench, does along the motion.
    pub(crate) negative_work: f64,
    /// The generators whose weighted sum these forces are, each with its coefficient β > 0.
    pub(crate) coefficients: Vec<(Generator, f64)>,
}

/// Finds the sum of generators, with coefficients β >= 0, that is nearest to the wrench `target`. `straight` lists the generators of polygonal or
/// one-dimensional cones. `round(v)` returns, for each round cone, the generator that does the most negative work along the motion v.
pub(crate) fn nearest_forces(
    size: Size,
    straight: &[Generator],
    round: &dyn Fn(&Vector) -> Vec<Generator>,
    target: &Vector,
) -> NearestForces {
    let mut target = target.clone();
    target.grow(size);
    let mut nearest = NearestPoint::new(target.as_slice());
    // Generators of round cones that have been added to the sum. `nearest` identifies each generator by a number, its tag; their tags follow those of
    // `straight`.
    let mut joined: Vec<Generator> = Vec::new();
    // Upper limit of the number of generators that are added: two hundred, and four more for each coordinate of a motion. Above `MOST_COORDINATES`
    // coordinates it is two hundred. The limit is reached only if the target is near the boundary of the sum of all round cones. Each new generator
    // then reduces the distance from the target only by a constant factor.
    let each = if size.count() <= MOST_COORDINATES { 4 } else { 0 };
    let mut joins_left = 200 + each * size.count();
    let (motion, negative_work) = loop {
        let residual = nearest.residual();
        let v = Vector::from_fn(size, |k| -residual[k]);
        let (round, next) = (round(&v), straight.len() + joined.len());
        let mut worst: Option<(usize, &Generator, f64)> = None;
        for (k, generator) in straight.iter().chain(&round).enumerate() {
            let work = generator.wrench.dot(&v);
            if worst.is_none_or(|(.., least)| work.total_cmp(&least).is_lt()) {
                worst = Some((if k < straight.len() { k } else { next }, generator, work));
            }
        }
        let Some((tag, generator, work)) = worst else { break (v, 0.0) };
        // A generator is added only if its negative work along the residual exceeds 1e-13 of the norm of the residual; smaller work is rounding.
        let joins = work < -1e-13 * v.norm() && v.norm() > CLEAR_RESIDUAL && !nearest.has(tag);
        if !joins
            || joins_left == 0
            || !nearest.add_generator(tag, generator.wrench.as_slice(), target.as_slice())
        {
            break (v, -work);
        }
        joins_left -= 1;
        if tag == next {
            joined.push(generator.clone());
        }
        nearest.move_to_closest(target.as_slice());
    };
    let of_tag = |tag: usize| straight.get(tag).unwrap_or_else(|| &joined[tag - straight.len()]).clone();
    let coefficients = nearest.coefficients().map(|(tag, coefficient)| (of_tag(tag), coefficient)).list();
    NearestForces { motion, negative_work, coefficients }
}

/// A load, and the friction cones of all contacts, whose forces might balance it.
struct LoadAndCones<'p, 'g> {
    problem: &'p Problem<'g>,
    straight: Vec<Generator>,
    load: f64,
    /// The magnitude of load and commands, N: the norm of the load, plus the norms of the springs' wrenches while the commands act and the object
    /// does not move. Rounding may hide an equilibrium from a proof that the load is unbalanced. The proof is accepted if all such equilibria have
    /// forces of at least [`ESCAPE`] (1e4) times this magnitude.
    data: f64,
}

impl<'p, 'g> LoadAndCones<'p, 'g> {
    /// The load and the friction cones of this problem; `None` without a load, or if a contact law is not a cone.
    fn of(problem: &'p Problem<'g>) -> Option<Self> {
        let load = problem.wrench.norm();
        let straight = (load > 0.0).then(|| straight_generators(problem)).flatten()?;
        Some(Self { problem, straight, load, data: load + squeeze(problem) })
    }

    /// The part of the load that the nearest admissible contact forces leave unbalanced, as a unit motion. `None` unless this motion separates the
    /// load from all admissible forces, clearly beyond rounding ([`Self::is_proof`]).
    fn separating_motion(&self) -> Option<Vector> {
        let target = -&self.problem.wrench / self.load;
        let round = |v: &Vector| round_generators(self.problem, v);
        let NearestForces { motion: v, .. } =
            nearest_forces(self.problem.size(), &self.straight, &round, &target);
        self.is_proof(&v).then(|| v.normalize())
    }

    /// True if the motion v separates the load from all admissible contact forces, clearly beyond rounding, whichever method found v. v is the
    /// residual for the load scaled to length one, and its norm must exceed [`CLEAR_RESIDUAL`]. An equilibrium that rounding hides must have forces
    /// of at least [`ESCAPE`] times load and commands.
    fn is_proof(&self, v: &Vector) -> bool {
        let mut negative_work = 0.0_f64;
        for generator in self.straight.iter().chain(&round_generators(self.problem, v)) {
            negative_work = negative_work.max(generator.works_against(v));
        }
        let (distance, works) = (v.norm(), self.problem.wrench.dot(v) / self.load);
        let escape = works * self.load / negative_work.max(LEAST_WORK * distance);
        distance > CLEAR_RESIDUAL && escape >= ESCAPE * self.data
    }
}

/// A unit motion that clearly separates the load from all admissible contact forces, in the engine's coordinates. It is computed from the admissible
/// forces nearest to the load. `None` if no motion separates them clearly.
pub(crate) fn separating_motion_of_few(problem: &Problem) -> Option<Vector> {
    LoadAndCones::of(problem)?.separating_motion()
}

/// A unit motion that clearly separates the load from all admissible contact forces, in the engine's coordinates; `None` if no motion separates them
/// clearly.
///
/// With many coordinates the augmented Lagrangian searches for this motion. If the residual of this method proves nothing, the residual of the
/// nearest forces is tried, for at most [`MOST_COORDINATES`] coordinates.
pub(crate) fn separating_motion(problem: &Problem) -> Option<Vector> {
    let all = LoadAndCones::of(problem)?;
    if !uses_band(problem.size()) {
        return all.separating_motion();
    }
    match residual_of_many(problem, &|v| all.is_proof(v)) {
        Residual::Proof(v) => Some(v.normalize()),
        Residual::Unclear if problem.size().count() <= MOST_COORDINATES => all.separating_motion(),
        Residual::Unclear | Residual::Nothing => None,
    }
}

/// A measure of the squeeze, N: the sum of the norms of the springs' wrenches while the commands act and the object does not move.
fn squeeze(problem: &Problem) -> f64 {
    let pushed =
        |(site, offset): (&Site, &SVector<f64, 3>)| site.map.pushed_norm(&site.springs.force(offset));
    problem.sites.iter().zip(&problem.offsets).map(pushed).added()
}

/// For every contact with a round cone, the generator (a unit wrench) that does the most negative work along a motion.
pub(crate) fn round_generators(problem: &Problem, v: &Vector) -> Vec<Generator> {
    let mut generators = Vec::new();
    for (contact, (local, site)) in problem.locals().zip(problem.sites).enumerate() {
        if local.is_round() {
            let u = site.map.tr_mul(v);
            let length = tangential_norm(&u);
            let along = if length > 0.0 { -tangential(&u) / length } else { unit(1) };
            generators.push(Generator::along(contact, site, local.cone().generator(&along)));
        }
    }
    generators
}

/// Whether a unit motion proves that no contact forces balance the load of `problem` once it grows in the direction `rate`.
///
/// Three conditions make it a proof for any forces in any contact states. Along the motion, no admissible contact force does negative work, the load
/// does no negative work, and the load's rate does positive work.
pub(crate) fn separates_from_here_on(problem: &Problem, motion: &Vector, rate: &Vector) -> bool {
    let Some(straight) = straight_generators(problem) else { return false };
    let all = straight.into_iter().chain(round_generators(problem, motion));
    let negative_work = all.map(|g| g.works_against(motion)).most();
    // `counts_from_here_on` compares the work of two loads: the present load, and a load that has grown by `data` along the rate.
    let data = problem.wrench.norm() + squeeze(problem);
    let (here, gained) = (problem.wrench.dot(motion), rate.dot(motion) / rate.norm());
    gained > CLEAR_RESIDUAL && counts_from_here_on(here, here + data * gained, negative_work, data)
}

/// The unit wrenches that generate the cones that are not round. `None` if a contact law is not a cone of forces, as in a rate problem (for
/// derivatives along a load path).
pub(crate) fn straight_generators(problem: &Problem) -> Option<Vec<Generator>> {
    let mut list = Vec::new();
    for (contact, (local, site)) in problem.locals().zip(problem.sites).enumerate() {
        if local.is_round() {
            continue;
        }
        let mut push = |force: SVector<f64, 3>| list.push(Generator::along(contact, site, force));
        match local.law {
            Law::Absent => continue,
            Law::Edge(_) => return None,
            Law::Bonded | Law::Cone { .. } => {}
        }
        let cone = problem.cone(contact);
        if !local.is_bonded() && cone.has_edges() {
            local.polygon.corners.iter().for_each(|corner| push(cone.generator(corner)));
            continue;
        }
        push(unit(0));
        if local.may_pull() {
            push(-unit::<3>(0));
        }
        for a in 1..local.springs.axes() {
            push(unit(a));
            push(-unit::<3>(a));
        }
    }
    Some(list)
}
