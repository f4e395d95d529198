//! An arc: a piece of the load path (part of a leg with fixed contact states) on which directions of sliding turn. This file has the linear
//! algebra at one point of an arc.
//!
//! Let a contact slide along p = F_t / |F_t| with `|F_t| = μ F_n`. Its tangent stiffness ([`Tangent`]) is `C = k_n (e_n + μ P) e_nᵀ + κ d dᵀ`, which
//! depends on p alone. Here k_n is the normal stiffness, e_n the unit normal, `P = K_t p / (p·K_t p)` with the tangential stiffnesses K_t, and κ the
//! stiffness along the tangent d across the slip. λ is the fraction of the leg that is done. The offsets a of the contact springs (commanded
//! displacements minus clearances and slips) are affine in λ. The load W is affine in λ or turns with it. Twist q and λ change together, with grasp
//! maps G_i and a unit u of displacement. Here q' and λ' are rates per unit of arclength, a_i' and W' rates per unit of λ:
//!
//! ```text
//! T q' = b λ',     T = Σ G_i C_i G_iᵀ,     b = Σ G_i C_i a_i' + W',     |q'|²/u² + λ'² = 1
//! ```
//!
//! The null vector of `[T | -b]` is the direction of the path. It stays smooth where the load has a maximum and T is singular. One more row below
//! this matrix, transverse to the path, makes it regular even at such a maximum. A free motion is a motion that no spring resists.

use crate::numerics::{Each, IntoList, Once, Reals, Vector, add_times, by_axis, chosen, mapped};
use nalgebra::{Matrix, SVector};

use super::path_stiffness::{NarrowOrder, PathFactors, PathStiffness};
use super::segment::{PathPoint, Segment};
use super::tolerances::SLACK_ON_AN_ARC;
use crate::contact::{Slide, State, Tangent, tangential, tangential_norm};
use crate::equilibrium::NoEquilibrium;
use crate::grasp::Site;
use crate::object::{ForcesAndTwist, Imbalance, LinearProblem};
use crate::prelude::*;

/// An arc of a load path: contacts keep the states `states`, and directions of sliding turn. λ is the fraction of the leg (section of the load
/// program) that is done.
pub(super) struct Arc<'s, 'g> {
    pub(super) segment: &'s Segment<'g>,
    pub(super) states: &'s [State],
    /// Indices of the contacts that slide.
    pub(super) sliding: Vec<usize>,
    /// The unit u of displacement in arclength, m. Arclength is measured along the curve (q/u, λ) of the twist q and the fraction λ.
    unit: f64,
    /// Unit motions that no spring resists, each with the prescribed velocity of the object along it per unit of λ.
    free_motions: Vec<(Vector, f64)>,
    /// The terms of `T q' = b λ'` that do not come from sliding contacts; all points of one arc share them.
    pub(super) fixed: SharedTerms,
    /// Whether a finger command, and so the offset of a contact, changes along the leg.
    pub(super) driven: bool,
}

/// The terms of `T q' = b λ'` that are constant along an arc: terms of the tangent stiffness T and of the right-hand side b. Here q is the twist and
/// λ the fraction of the leg.
#[derive(Debug)]
pub(super) struct ConstantTerms {
    /// The tangent stiffness of the contacts that do not slide. If no spring resists some motion, T is singular; therefore an artificial stiffness is
    /// added along each such motion. The right-hand side b is chosen so that the object moves along this motion with the velocity in
    /// `Arc::free_motions`, which may be zero.
    stiffness: PathStiffness,
    /// The terms of the right-hand side b of `T q' = b λ'` from commands of contacts that do not slide.
    push: Vector,
    /// The artificial stiffness against motions that no spring resists, N/m: the stiffness of the stiffest spring.
    stiffest: f64,
}

/// The [`ConstantTerms`] of an arc, computed on first use, because the rates at which friction forces turn can be computed without them.
pub(super) type SharedTerms = alloc::sync::Arc<Once<ConstantTerms>>;

/// A direction (q', λ') of the path in the space of twist q and fraction λ of the leg; a change of both is stored in this form, too.
#[derive(Debug, Clone)]
pub(super) struct Direction {
    /// Rate q' of the twist, per unit of arclength.
    pub(super) twist: Vector,
    /// Rate of the fraction λ of the leg, per unit of arclength.
    pub(super) factor: f64,
}

impl Direction {
    /// The direction in which only λ grows, while the twist stays constant. Corrections transverse to it change the twist and leave λ fixed.
    pub(super) fn forward() -> Self {
        Self { twist: Vector::zeros(), factor: 1.0 }
    }

    /// Whether the twist stays constant in this direction, so that only λ changes. Corrections transverse to this direction leave λ fixed.
    fn keeps_the_factor(&self) -> bool {
        self.twist.norm_squared() == 0.0
    }
}

impl<'s, 'g> Arc<'s, 'g> {
    /// The arc on which contacts keep these states. Each of `free_motions` is a motion that no spring resists, with the object's velocity along it
    /// per unit of λ. `unit` is the displacement, m, that counts as much in the arclength as a change of λ by 1.
    pub(super) fn new<'m>(
        segment: &'s Segment<'g>,
        states: &'s [State],
        free_motions: impl IntoIterator<Item = (&'m Vector, f64)>,
        (unit, fixed): (f64, SharedTerms),
    ) -> Self {
        let sliding = chosen(states.len(), &|i| states[*i].slides());
        let driven = segment.change.iter().any(|a| a.norm() > 0.0);
        let free_motions = free_motions.into_iter().map(|(v, rate)| (v.clone(), rate)).list();
        Self { segment, states, sliding, unit, free_motions, fixed, driven }
    }

    fn fixed(&self) -> &ConstantTerms {
        self.fixed.get_or_init(|| self.fixed_anew())
    }

    fn fixed_anew(&self) -> ConstantTerms {
        let Self { segment, states, free_motions, .. } = self;
        let (sites, size) = (self.sites(), segment.grasp.size());
        // The artificial stiffness against a free motion couples all coordinates that move in this motion. No order of coordinates then gives a
        // narrow band matrix.
        let order = if free_motions.is_empty() { NarrowOrder::of(size, sites) } else { None };
        let (mut stiffness, mut push, mut stiffest) =
            (PathStiffness::zeros(size, order), Vector::zeros(), 0.0_f64);
        for (i, site) in sites.iter().enumerate() {
            stiffest = stiffest.max(site.springs.stiffest());
            if !states[i].slides() {
                let pushed = site.map.times(&segment.problem.local(i).tangent(&states[i]).matrix());
                let (a, b, ranges) = (&pushed, &site.map, site.support.ranges());
                if let (Some(a), Some(b)) = (a.whole_columns(), b.whole_columns()) {
                    stiffness.add(&ranges, |i, j| a[0][i] * b[0][j] + a[1][i] * b[1][j] + a[2][i] * b[2][j]);
                } else {
                    // With several bodies a grasp map stores only its nonzero rows, and a search is needed to read an entry. The entries of each map
                    // are therefore copied once before they are multiplied.
                    let rows = [a, b].each(|map| {
                        ranges.clone().each(|range| range.map(|i| by_axis(|k| map[(i, k)])).list())
                    });
                    let [a, b] = &rows;
                    let row = |of: &[Vec<SVector<f64, 3>>; 2], i: usize| {
                        let which = usize::from(!ranges[0].contains(&i));
                        of[which][i - ranges[which].start]
                    };
                    stiffness.add(&ranges, |i, j| {
                        let (a, b) = (row(a, i), row(b, j));
                        a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
                    });
                }
                push += &pushed * segment.change[i];
            }
        }
        for (v, _) in free_motions {
            let held = v * stiffest;
            stiffness.add(&[0..size.count(), 0..0], |i, j| v[i] * held[j]);
        }
        ConstantTerms { stiffness, push, stiffest }
    }

    pub(super) fn sites(&self) -> &'g [Site] {
        self.segment.grasp.sites()
    }

    /// The right-hand side b of `T q' = b λ'` at the fraction `factor` of the leg, without the terms of sliding contacts: the rate of the load,
    /// `ConstantTerms::push` and terms of the velocities of free motions.
    fn push_at(&self, factor: f64) -> Vector {
        let ConstantTerms { push, stiffest, .. } = self.fixed();
        let along = |push: Vector, (v, rate): &(Vector, f64)| push + v * (stiffest * rate);
        self.segment.trajectory.rate_at(factor) + self.free_motions.iter().fold(push.clone(), along)
    }

    /// The norm of the sum of two rates: the rate of the load, and the rate of the forces by which commands push contacts that do not slide. The unit
    /// is N per unit of λ.
    pub(super) fn load_rate(&self, factor: f64) -> f64 {
        self.push_at(factor).norm()
    }

    /// Tangent stiffness of the sliding contact with the index `contact`, if it slides along the friction force `friction`. Without friction force it
    /// slides in the direction stored in its state.
    pub(super) fn tangent(&self, contact: usize, friction: &SVector<f64, 3>) -> Tangent {
        let local = self.segment.problem.local(contact);
        if tangential_norm(friction) == 0.0 {
            return local.tangent(&self.states[contact]);
        }
        local.tangent(&State::Round(Slide::new(friction, 0.0)))
    }

    pub(super) fn tangents(&self, frictions: impl Iterator<Item = SVector<f64, 3>>) -> Vec<Tangent> {
        self.sliding.iter().zip(frictions).map(|(&i, friction)| self.tangent(i, &friction)).list()
    }

    /// LU factors of the bordered matrix at the fraction `factor` of the leg. Its columns are the tangent stiffness T times the unit u of
    /// displacement, then the right-hand side -b. Its last row is `across`, a direction of the path: corrections of twist and λ are transverse to it.
    /// Also returns the largest entry of T u and b. `None` if the matrix is singular, so that the path may continue in more than one direction.
    fn bordered(&self, tangents: &[Tangent], factor: f64, across: &Direction) -> Option<(PathFactors, f64)> {
        let (stiffness, push) = self.balance(tangents, factor);
        self.factored(stiffness, &push, across)
    }

    /// The tangent stiffness T and the right-hand side b of `T q' = b λ'` at the fraction `factor` of the leg; `tangents` are the tangent stiffnesses
    /// of the sliding contacts.
    pub(super) fn balance(&self, tangents: &[Tangent], factor: f64) -> (PathStiffness, Vector) {
        let (mut t, mut push) = (self.fixed().stiffness.clone(), self.push_at(factor));
        for (&i, tangent) in self.sliding.iter().zip(tangents) {
            let map = &self.sites()[i].map;
            if let Tangent::Sliding { drag, across, stiffness } = tangent {
                let (dragged, held) = (map * drag, map * across);
                let (normal, pulled) = (map.column(0), &held * *stiffness);
                let [a, b, c, d] = [&dragged, &normal, &held, &pulled].each(Vector::as_slice);
                t.add(&self.sites()[i].support.ranges(), |i, j| a[i] * b[j] + c[i] * d[j]);
                if self.driven {
                    let change = &self.segment.change[i];
                    push += dragged * change[0] + held * (stiffness * across.dot(change));
                }
            }
        }
        (t, push)
    }

    /// LU factors of the bordered matrix `[T u | -b]` with the last row `across`, from the tangent stiffness T = `t` and the right-hand side b =
    /// `push`. Also returns the largest entry of `T u` and b, with the unit u of displacement. `None` if the matrix is singular.
    pub(super) fn factored(
        &self,
        mut t: PathStiffness,
        push: &Vector,
        across: &Direction,
    ) -> Option<(PathFactors, f64)> {
        let (scale, row) = self.border(&mut t, push, across);
        let bordered = t.bordered(self.segment.grasp.size(), &-push, &row, across.factor * scale)?;
        Some((bordered, scale))
    }

    /// Multiplies the tangent stiffness `t` by the unit u of displacement. Returns the largest entry of the scaled `t` and of `push`. Also returns
    /// the entries of `across` for the twist, multiplied by this largest entry: the last row of the bordered matrix then has entries of the same
    /// magnitude as the others.
    fn border(&self, t: &mut PathStiffness, push: &Vector, across: &Direction) -> (f64, Vector) {
        t.scale(self.unit);
        let scale = t.amax().max(push.amax());
        (scale, &across.twist * (scale / self.unit))
    }

    /// The change of twist and λ from a solution of the bordered linear system. In this system the twist is divided by the unit u of displacement.
    pub(super) fn unscaled(&self, (x, factor): (Vector, f64)) -> Direction {
        Direction { twist: x * self.unit, factor }
    }

    /// The direction of the path per unit of arclength, at the fraction `factor` of the leg, for the tangent stiffnesses `tangents` of sliding
    /// contacts. Its component along `along` is positive. `None` if the path may continue in more than one direction, or if its direction differs
    /// from `along` by more than sixty degrees.
    pub(super) fn direction(
        &self,
        tangents: &[Tangent],
        factor: f64,
        along: &Direction,
    ) -> Option<Direction> {
        let (mut t, push) = self.balance(tangents, factor);
        let (scale, row) = self.border(&mut t, &push, along);
        let ends = [along.factor * scale, scale];
        let (x, factor) = t.solved_once(self.segment.grasp.size(), [&-&push, &row], ends)?;
        let length = (x.norm_squared() + factor * factor).sqrt();
        // `1 / length` is the cosine of the angle between the direction and `along`. Between two evaluations the direction may turn by sixty degrees
        // at most, because after a larger turn its sign might be wrong.
        let turned = 1.0 / length >= 0.5;
        turned.then(|| Direction { twist: x * (self.unit / length), factor: factor / length })
    }

    /// The rates of stretch and of force of a contact, per unit of arclength, as the path continues in the direction `direction`. The contact has the
    /// tangent stiffness `tangent`.
    pub(super) fn rates(
        &self,
        contact: usize,
        tangent: &Tangent,
        direction: &Direction,
    ) -> [SVector<f64, 3>; 2] {
        let site = &self.sites()[contact];
        let stretch = site.stretch(&(self.segment.change[contact] * direction.factor), &direction.twist);
        [stretch, tangent.force(&stretch)]
    }

    /// The rates of all contact forces in the `direction` of the path. `slid` are the tangent stiffnesses of the sliding contacts, in the order of
    /// the indices `sliding`.
    pub(super) fn force_rates(&self, slid: &[Tangent], direction: &Direction) -> Vec<SVector<f64, 3>> {
        let mut slid = slid.iter();
        let rate = |(i, state): (usize, &State)| {
            let sliding = state.slides().then(|| slid.next()).flatten();
            let tangent = sliding.copied().unwrap_or_else(|| self.segment.problem.local(i).tangent(state));
            self.rates(i, &tangent, direction)[1]
        };
        self.states.iter().enumerate().map(rate).list()
    }

    /// Corrects twist and fraction λ of the leg, transverse to the direction `across` of the path, until forces balance. Friction forces of sliding
    /// contacts lie on their cones, at first in the directions of `frictions`. Returns forces, twist and λ; `None` if the iteration does not
    /// converge.
    pub(super) fn balanced(
        &self,
        mut twist: Vector,
        mut factor: f64,
        across: &Direction,
        frictions: &[SVector<f64, 3>],
    ) -> Option<(ForcesAndTwist, f64)> {
        // An imbalance of forces is taken as rounding if it is below this fraction of the sum of the magnitudes of load and contact forces. Rounding
        // errors grow with the square root of the number of these terms.
        let rounding = 2e-16 * ((self.sites().len() + 2) as f64).sqrt();
        // Near the end of a leg that unloads, the load is a small difference of larger terms and has their rounding errors. The imbalance is
        // therefore compared with the load at the start of the leg, if that load is larger.
        let from = self.segment.trajectory.at(0.0).norm();
        let (mut frictions, mut balanced, mut last) = (frictions.to_vec(), None, f64::INFINITY);
        for round in 0..20 {
            let tangents = self.tangents(frictions.iter().copied());
            let (bordered, _) = self.bordered(&tangents, factor, across)?;
            let mut forces = self.forces_at(&twist, factor, &frictions);
            let initial_force: f64 = forces.iter().map(Matrix::norm).added();
            let mut ended = None;
            // At most six Newton corrections. After a step along the path, friction forces are off their cones by the error of the step. `forces_at`
            // puts them back on their cones, so that forces are out of balance. The first correction restores the balance, and leaves friction forces
            // off their cones only by the square of the error of the step. Further corrections remove this distance up to rounding.
            for _ in 0..6 {
                let load = self.segment.trajectory.at(factor);
                let Imbalance { left, size: carried } = Imbalance::of(self.sites(), &forces, &load, 0.0);
                if left.norm() <= rounding * (load.norm().max(from) + carried) {
                    ended = Some(carried);
                    break;
                }
                let mut change = self.unscaled(bordered.solve(&left, 0.0));
                if across.keeps_the_factor() {
                    // `across` is the direction in which only λ grows. A correction transverse to it leaves λ fixed, so a computed change of λ is
                    // only rounding.
                    change.factor = 0.0;
                }
                twist += &change.twist;
                factor += change.factor;
                add_times(&mut forces, &self.force_rates(&tangents, &change), 1.0);
            }
            let carried = ended?;
            let off = self.off_the_cones(&forces);
            // Each round of corrections reduces `off`, the distance of friction forces from their cones. Next to a fold (a maximum of the load) a
            // round reduces it to a quarter. After four rounds the corrections end if a round has left more than 0.3 of the `off` before it.
            if round > 3 && off > 0.3 * last {
                break;
            }
            last = off;
            // If springs resist a motion only weakly, a correction along this motion may be so large that friction forces turn and leave their cones.
            // The correction is then repeated with the new directions of friction.
            let is_on_them = off <= SLACK_ON_AN_ARC * carried;
            if !is_on_them {
                frictions = mapped(&self.sliding, &|i| tangential(&forces[*i]));
            }
            // If the correction has reduced the sum of contact forces to less than a quarter, the result still has the rounding errors of the larger
            // forces. It is not accepted but corrected again.
            if initial_force <= 4.0 * carried {
                balanced = Some((ForcesAndTwist { forces, twist: twist.clone() }, factor));
                if is_on_them {
                    break;
                }
            }
        }
        balanced
    }

    /// The largest difference, N, between the magnitude of the friction force of a sliding contact and its limit μ F_n. Contacts without friction
    /// force are left out.
    fn off_the_cones(&self, forces: &[SVector<f64, 3>]) -> f64 {
        let mut most = 0.0_f64;
        for &i in &self.sliding {
            let friction = tangential_norm(&forces[i]);
            if friction > 0.0 {
                most = most.max((friction - self.segment.problem.cone(i).limit(forces[i][0])).abs());
            }
        }
        most
    }

    /// Contact forces at a twist and the fraction `factor` of the leg. A sticking contact has the force of its springs, an open contact none. The
    /// friction force of each sliding contact is on its cone, in the direction given in `frictions`.
    fn forces_at(&self, twist: &Vector, factor: f64, frictions: &[SVector<f64, 3>]) -> Vec<SVector<f64, 3>> {
        let offsets = self.segment.offsets(factor);
        let mut slid = frictions.iter();
        let force = |i: usize| {
            let (state, site) = (&self.states[i], &self.sites()[i]);
            let force = site.springs.force(&site.stretch(&offsets[i], twist));
            match (state.slides().then(|| slid.next()).flatten(), state.is_sticking()) {
                (Some(friction), _) => {
                    let size = tangential_norm(friction);
                    let part =
                        if size > 0.0 { self.segment.problem.cone(i).limit(force[0]) / size } else { 0.0 };
                    let mut friction = friction * part;
                    friction[0] = force[0];
                    friction
                }
                (None, true) => force,
                (None, false) => SVector::zeros(),
            }
        };
        (0..self.states.len()).map(force).list()
    }
}

impl Segment<'_> {
    /// Forces and twist at the fraction `factor` of the leg, with their rates per unit of this fraction. Contacts keep the states `states` and slide
    /// on the round cone. The forces are those of the equilibrium near the forces and twist `at`, with friction forces on their cones. If no such
    /// equilibrium is found, they are the forces of `at`. Along motions that no spring resists, the object moves at the twist rate `pushed`, if it is
    /// given.
    pub(super) fn tangent(
        &self,
        states: &[State],
        factor: f64,
        at: &ForcesAndTwist,
        pushed: Option<&Vector>,
    ) -> Result<PathPoint, NoEquilibrium<3>> {
        let linear_problem = alloc::sync::Arc::new(LinearProblem::new(&self.problem, states));
        let rate = linear_problem
            .solve(self.problem.sites, &self.change, &self.trajectory.rate_at(factor))
            .map_err(|u| self.unbalanced(factor, u.motion))?;
        let rate = self.pushed_along(&linear_problem, rate, pushed);
        let frictions: Vec<_> = states.iter().filter_map(State::slide).map(|slide| slide.direction).list();
        let free_motions = linear_problem.free_motions().iter().map(|v| (v, 0.0));
        let arc = Arc::new(self, states, free_motions, (1.0, SharedTerms::default()));
        let largest = self.problem.largest_force(&at.forces, &at.twist).max(self.largest);
        let is_near = |(there, _): &(ForcesAndTwist, f64)| {
            // After an event the correction should change forces only by rounding errors. If a force changes by more than this fraction of the
            // largest force, the correction has led to another equilibrium, which is not used.
            there.forces.iter().zip(&at.forces).all(|(f, g)| (f - g).norm() <= 1e-6 * largest)
        };
        let balanced =
            arc.balanced(at.twist.clone(), factor, &Direction::forward(), &frictions).filter(is_near);
        let (at, fixed) = (balanced.map_or_else(|| at.clone(), |(at, _)| at), arc.fixed);
        let point = self.point_with_rates(linear_problem, factor, at.clone(), (&rate, 1.0), (factor, &at));
        Ok(PathPoint { fixed, ..point })
    }
}
